// The page's side of the protocol. SPDX-License-Identifier: Apache-2.0
import type { Calls, Message, Op, Request } from './protocol';

/** What the worker says of a call that failed. */
export class Failure extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

export type Progress = (fraction: number, stage: string) => void;

interface Waiting {
  resolve(out: never): void;
  reject(error: Error): void;
  progress?: Progress;
}

export class Client {
  private readonly worker = new Worker(new URL('./worker/main.ts', import.meta.url), { type: 'module', name: 'toothseg' });
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;
  readonly ready: Promise<void>;

  constructor() {
    this.ready = new Promise((resolve, reject) => {
      this.worker.addEventListener('message', (event: MessageEvent<Message>) => {
        if (event.data.kind === 'ready') resolve();
        else if (event.data.kind === 'broken') reject(new Failure(0, event.data.message));
        else this.take(event.data);
      });
      this.worker.addEventListener('error', (event) => {
        const error = new Failure(0, event.message || 'The worker could not be started.');
        reject(error);
        for (const { reject } of this.waiting.values()) reject(error);
        this.waiting.clear();
      });
    });
  }

  call<K extends Op>(op: K, input: Calls[K]['in'], progress?: Progress, transfer: Transferable[] = []): Promise<Calls[K]['out']> {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, progress });
      const request: Request<K> = { id, op, in: input };
      this.worker.postMessage(request, transfer);
    });
  }

  private take(message: Exclude<Message, { id: 0 }>): void {
    const waiting = this.waiting.get(message.id);
    if (!waiting) return;
    if (message.kind === 'progress') {
      waiting.progress?.(message.fraction, message.stage);
      return;
    }
    this.waiting.delete(message.id);
    if (message.kind === 'reply') waiting.resolve(message.out as never);
    else waiting.reject(new Failure(message.status, message.message));
  }
}
