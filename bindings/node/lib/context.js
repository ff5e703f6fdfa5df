// The hooks that all objects share. SPDX-License-Identifier: Apache-2.0
import { Status } from './abi.js';
import { errorOf, invalid } from './errors.js';
import { addressOf, allocate, answersHooks, free, functions, register, unregister } from './native.js';
import { Owner, Resource, Root, optionsOf } from './resource.js';

// What a hook throws is kept for the call that it was called in.
const guarded = (hooks, hook) => {
  try {
    return hook();
  } catch (error) {
    hooks.thrown ??= { error };
    return undefined;
  }
};

function logHook(hooks) {
  return register((level, text) => guarded(hooks, () => hooks.log(level, text)), 'ts_log_fn');
}

// The library's memory cannot be JavaScript's own: the hook is asked and told, the memory is taken here.
function memoryHooks(hooks, memory) {
  const taken = new Map(); // by address
  const take = (bytes) => {
    if (guarded(hooks, () => memory.allocate?.(bytes)) === false || hooks.thrown) return null;
    const block = allocate(bytes);
    taken.set(addressOf(block), { block, bytes });
    return block;
  };
  const give = (pointer) => {
    const address = addressOf(pointer);
    const { block, bytes } = taken.get(address);
    taken.delete(address);
    free(block);
    guarded(hooks, () => memory.free?.(bytes));
  };
  return [register(take, 'ts_alloc_fn'), register(give, 'ts_free_fn')];
}

export class Context extends Resource {
  constructor(options = {}) {
    const { log, memory } = options;
    const native = optionsOf('ts_context_options', options, ['log', 'memory']);
    const hooks = { threads: native.threads, log, thrown: null };
    if (memory && !answersHooks(native.threads))
      throw invalid('memory hooks want threads: 1, as JavaScript cannot answer other threads while it waits for them');
    const callbacks = [];
    if (log) callbacks.push((native.log = logHook(hooks)));
    if (memory) callbacks.push(...([native.alloc, native.free] = memoryHooks(hooks, memory)));
    const out = [null];
    const status = functions.ts_context_create(native, out);
    if (status !== Status.OK) {
      callbacks.forEach(unregister);
      throw errorOf(status, functions.ts_last_error_message());
    }
    super(new Owner('ts_context', out[0], new Root(out[0], hooks, callbacks)), 'new Context()');
  }
}
