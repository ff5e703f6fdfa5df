// Long calls on another thread, while JavaScript goes on. SPDX-License-Identifier: Apache-2.0
import { Status } from './abi.js';
import { ToothsegError, meaning } from './errors.js';
import { atExit, functions } from './native.js';
import { hold, makeJob, planOf, raw, settle } from './resource.js';

const POLL_MS = 30;

// Node waits for calls that are running when the process exits, and answers no hook of theirs any more.
const running = new Set();
atExit(() => running.forEach((job) => functions.ts_job_cancel(job)));

// Looks after a running call's job. A native progress callback would make the library's threads wait for JavaScript, and
// for ever where JavaScript in its turn waits for them.
function watch(job, { onProgress, signal }) {
  const cancel = () => functions.ts_job_cancel(job);
  let thrown;
  let last = -1;
  const report = () => {
    const fraction = functions.ts_job_progress(job);
    if (thrown || fraction === last) return;
    last = fraction;
    try {
      if (onProgress(fraction) === false) cancel();
    } catch (error) {
      thrown = { error };
      cancel();
    }
  };
  running.add(job);
  if (onProgress) report();
  const timer = onProgress && setInterval(report, POLL_MS);
  signal?.addEventListener('abort', cancel);
  return {
    end(status) {
      clearInterval(timer);
      signal?.removeEventListener('abort', cancel);
      if (onProgress && status === Status.OK) report();
      running.delete(job);
      functions.ts_job_destroy(job);
      if (status === Status.E_CANCELLED && signal?.aborted) thrown ??= { error: signal.reason };
      return thrown;
    },
  };
}

/** A long call, on another thread. As now(), but `onProgress` gets the fraction alone, and `signal` cancels. */
export function later(request, options = {}) {
  const { name, args } = request;
  const plan = planOf(name);
  options.signal?.throwIfAborted();
  const held = hold(name, args, plan);
  const caller = {};
  Error.captureStackTrace?.(caller, later);
  let watcher;
  return new Promise((resolve, reject) => {
    const done = (error, status) => {
      const thrown = watcher?.end(status);
      held.free();
      try {
        if (error) throw error;
        // The library's message belongs to the thread of the call, which cannot be asked any more.
        resolve(settle(request, plan, held.root, status, meaning, thrown));
      } catch (failure) {
        if (failure instanceof ToothsegError && caller.stack)
          failure.stack = `${failure}${caller.stack.replace(/^[^\n]*/, '')}`;
        reject(failure);
      } finally {
        held.end();
      }
    };
    try {
      const job = makeJob(held.root, null);
      watcher = watch(job, options);
      functions[name].async(...raw(args, plan, held, job), done);
    } catch (error) {
      done(error);
    }
  });
}
