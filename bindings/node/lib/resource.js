// Lifetime of what the library makes, and the calls on it. SPDX-License-Identifier: Apache-2.0
//
// JavaScript runs on one thread, but an asynchronous call works on its objects while JavaScript goes on. So each call
// holds its objects as the library wants it: many at a time where it takes them as const, one where it does not.
import { Status, functions as signatures, handles, structs } from './abi.js';
import { UsageError, errorOf, invalid } from './errors.js';
import { answersHooks, decodeAll, functions, register, sizeOf, unregister } from './native.js';
import { tidy, withDefaults } from './values.js';

const OWNER = Symbol('owner');
/** A method of resources, called after each call on them that succeeded. */
export const SETTLED = Symbol('settled');

const HANDLE = new RegExp(`^(const )?(${Object.keys(handles).join('|')}) \\*$`);

// Which arguments of a function are handles.
const plans = new Map();
export function planOf(name) {
  let plan = plans.get(name);
  if (plan) return plan;
  plan = { handles: [], job: -1 };
  signatures[name][1].forEach((type, i) => {
    const match = HANDLE.exec(type);
    if (match?.[2] === 'ts_job') plan.job = i;
    else if (match) plan.handles.push({ at: i, kind: match[2], exclusive: !match[1] });
  });
  plans.set(name, plan);
  return plan;
}

/** The context that objects share, with its hooks: lives until the last of them is gone. */
export class Root {
  #count = 0;

  constructor(pointer, hooks, callbacks) {
    this.pointer = pointer;
    this.hooks = hooks; // { threads, log, thrown }
    this.callbacks = callbacks;
  }

  retain() {
    ++this.#count;
  }
  release() {
    if (--this.#count > 0) return;
    functions.ts_context_destroy(this.pointer);
    this.callbacks.forEach(unregister);
  }
}

/** A native object. Does not know the public object that it belongs to, so that this can be forgotten. */
export class Owner {
  readers = 0;
  writing = false;
  disposed = false;
  callback = null;

  constructor(kind, pointer, root) {
    this.kind = kind;
    this.pointer = pointer;
    this.root = root;
    root.retain();
  }

  get busy() {
    return this.writing || this.readers > 0;
  }

  destroy() {
    if (this.kind !== 'ts_context') functions[handles[this.kind]](this.pointer);
    if (this.callback) unregister(this.callback);
    this.pointer = null;
    this.root.release();
  }
}

const forgotten = new FinalizationRegistry((owner) => owner.destroy());

/** Base of the public classes. */
export class Resource {
  constructor(owner, how) {
    if (!(owner instanceof Owner)) throw invalid(`a ${new.target.name} is made by ${how}`);
    this[OWNER] = owner;
    forgotten.register(this, owner, owner);
  }

  get disposed() {
    return this[OWNER].disposed;
  }

  /** Gives the native object back; where a call is running on it, when that ends. Again is fine. */
  dispose() {
    const owner = this[OWNER];
    if (owner.disposed) return;
    owner.disposed = true;
    forgotten.unregister(owner);
    if (!owner.busy) owner.destroy();
  }

  [SETTLED]() {}
}
if (Symbol.dispose) Resource.prototype[Symbol.dispose] = Resource.prototype.dispose;

export const ownerOf = (resource) => resource[OWNER];

// --------------------------------------------------------------------------------------------------------------- calls

// Takes the objects of a call; what it returns gives them free again.
export function hold(name, args, plan) {
  const held = plan.handles.map(({ at, kind, exclusive }) => {
    const owner = args[at]?.[OWNER];
    if (owner?.kind !== kind) throw new UsageError(Status.E_NULL, `${name}: wants a ${kind}`);
    if (owner.disposed) throw new UsageError(Status.E_NULL, `${name}: the ${kind} has been disposed of`);
    // A context does not change once made: objects that share it are independent.
    return { owner, exclusive: exclusive && kind !== 'ts_context' };
  });
  for (const { owner, exclusive } of held)
    if (owner.writing || (exclusive && owner.busy))
      throw invalid(`${name}: another call is running on this ${owner.kind}: await it first`);
  for (const { owner, exclusive } of held) exclusive ? (owner.writing = true) : ++owner.readers;
  const root = held[0]?.owner.root;
  root?.retain(); // for what the call makes: its objects may be disposed of meanwhile
  return {
    root,
    pointers: held.map(({ owner }) => owner.pointer),
    free() {
      for (const { owner, exclusive } of held) {
        exclusive ? (owner.writing = false) : --owner.readers;
        if (owner.disposed && !owner.busy) owner.destroy();
      }
    },
    end() {
      root?.release();
    },
  };
}

export function raw(args, plan, held, job) {
  const out = [...args];
  plan.handles.forEach(({ at }, i) => (out[at] = held.pointers[i]));
  if (plan.job >= 0) out[plan.job] = job;
  return out;
}

export function makeJob(root, callback) {
  const out = [null];
  const status = functions.ts_job_create(root.pointer, callback, null, out);
  if (status !== Status.OK) throw errorOf(status, functions.ts_last_error_message());
  return out[0];
}

// What a log hook threw comes out of the call that was under way.
function thrownByHook(root) {
  const thrown = root?.hooks.thrown;
  if (thrown) root.hooks.thrown = null;
  return thrown;
}

// The end of a call that the library has returned from. `result` makes what the call gives.
export function settle({ name, args, result }, plan, root, status, message, thrown) {
  const byHook = thrownByHook(root);
  const made = status === Status.OK ? result?.(root) : undefined;
  const failure = thrown ?? (status === Status.OK ? null : { error: errorOf(status, message(name, status, args)) }) ?? byHook;
  try {
    if (failure) throw failure.error;
    for (const { at } of plan.handles) args[at][SETTLED]();
  } catch (error) {
    dropAll(made);
    throw error;
  }
  return made;
}

// A native object, a resource or an object of resources, that nobody will get.
function dropAll(made) {
  if (made instanceof Owner) made.destroy();
  else if (made instanceof Resource) made.dispose();
  else if (made?.constructor === Object) Object.values(made).forEach(dropAll);
}

const ownMessage = () => functions.ts_last_error_message();

/** A short call, at once: `args` as of now(). */
function shortCall(name, args, result) {
  if (planOf(name).handles.length > 0) return now({ name, args, result });
  const status = functions[name](...args); // on no object: nothing to hold
  if (status !== Status.OK) throw errorOf(status, ownMessage());
  return result?.();
}

export const call = (name, ...args) => shortCall(name, args);

/**
 * A call, at once. `request`: `name`, `args` (public objects for handles, anything for the job), `result(root)`.
 * `options`: `onProgress`, `signal` (looked at before the call only: nothing can abort while JavaScript waits).
 */
export function now(request, options = {}) {
  const { name, args } = request;
  const plan = planOf(name);
  options.signal?.throwIfAborted();
  const held = hold(name, args, plan);
  let callback = null;
  let job = null;
  let thrown;
  try {
    const status = run();
    return settle(request, plan, held.root, status, ownMessage, thrown);
  } finally {
    held.end();
  }

  function run() {
    try {
      refuseCallbacks();
      if (plan.job >= 0 && options.onProgress) {
        callback = register(report, 'ts_progress_fn');
        job = makeJob(held.root, callback);
      }
      return functions[name](...raw(args, plan, held, job));
    } finally {
      if (job) functions.ts_job_destroy(job);
      if (callback) unregister(callback);
      held.free();
    }
  }

  function report(fraction, stage) {
    try {
      return options.onProgress(fraction, stage) === false ? 1 : 0;
    } catch (error) {
      thrown = { error };
      return 1;
    }
  }

  function refuseCallbacks() {
    if (plan.job >= 0 && (options.onProgress || held.root.hooks.log) && !answersHooks(held.root.hooks.threads))
      throw invalid(
        `${name}: onProgress and log hooks are called from worker threads, which JavaScript cannot answer while it ` +
          'waits: use the asynchronous form, or a context with threads: 1',
      );
  }
}

// ------------------------------------------------------------------------------------------------- arguments, results

/** Names of what goes with every long call. */
export const JOB_OPTIONS = ['signal', 'onProgress'];

/** An options struct: the library's defaults, and `options` over them. */
export function optionsOf(struct, options = {}, others = JOB_OPTIONS, ...init) {
  const defaults = {};
  const status = functions[structs[struct].init](defaults, sizeOf(struct), ...init);
  if (status !== Status.OK) throw errorOf(status, ownMessage());
  return withDefaults(struct, defaults, options, others);
}

/** A struct for the library to fill. */
export const blank = (struct) => ({ structSize: sizeOf(struct) });

/** A struct that a getter fills: its last argument. */
export function info(name, struct, ...args) {
  const record = blank(struct);
  call(name, ...args, record);
  return tidy(struct, record);
}

// For the one number of a short call, which is read before anything else can run.
const ONE = new Uint32Array(1);
const readOne = () => ONE[0];

/** A number that a getter gives: its last argument. */
export const value = (name, ...args) => shortCall(name, [...args, ONE], readOne);

/**
 * The elements of a getter, `per` numbers each, written by the library into a new array, or into `into`, of which the
 * part that was filled is returned.
 */
export function elements(Type, per, name, args, into) {
  if (into === undefined) {
    into = new Type(per * value(name, ...args, null, 0));
    if (into.length === 0) return into;
  } else if (!(into instanceof Type)) {
    throw invalid(`${name}: wants a ${Type.name} to fill`);
  }
  const room = Math.floor(into.length / per);
  const filled = per * value(name, ...args, into.length === per * room ? into : into.subarray(0, per * room), room);
  return into.length === filled ? into : into.subarray(0, filled);
}

/** The elements of a getter that are structs. `after`: arrays for the arguments after the count. */
export function records(struct, name, args, after = []) {
  const count = fill(null, 0, after.map(() => null));
  if (count === 0) return [];
  const bytes = new Uint8Array(count * sizeOf(struct));
  fill(bytes, count, after);
  return decodeAll(bytes, struct, count).map((record) => tidy(struct, record));

  function fill(buffer, capacity, more) {
    return shortCall(name, [...args, buffer, capacity, ONE, ...more], readOne);
  }
}
