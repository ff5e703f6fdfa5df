// The worker: the library, and what it is asked. SPDX-License-Identifier: Apache-2.0
import * as toothseg from 'toothseg-wasm';
import type { Message, Request } from '../protocol';
import { Engine, buffersOf } from './engine';

const post = (message: Message) => postMessage(message, { transfer: [...buffersOf(message)] });
toothseg.load().then(
  () => {
    const engine = new Engine(toothseg);
    addEventListener('message', (event: MessageEvent<Request>) => engine.answer(event.data, post));
    post({ id: 0, kind: 'ready' });
  },
  (error: unknown) => post({ id: 0, kind: 'broken', message: String(error) }),
);
