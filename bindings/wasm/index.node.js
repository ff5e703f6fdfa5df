// The same in Node, where toothseg.wasm is read as a file. SPDX-License-Identifier: Apache-2.0
import { readFile } from 'node:fs/promises';

import { setBinary } from './lib/module.js';

setBinary(() => readFile(new URL('./lib/toothseg.wasm', import.meta.url)));

export * from './index.js';
