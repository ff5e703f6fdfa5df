// toothseg in WebAssembly. What there is, is said in index.d.ts. SPDX-License-Identifier: Apache-2.0
export * from './lib/public.js';
export { makeArch } from './lib/arch.js';
export { files, saved } from './lib/files.js';
export { load, memoryUse } from './lib/module.js';
