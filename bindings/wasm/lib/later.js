// Long calls where there is but one thread: they are done when the promise is returned. SPDX-License-Identifier: Apache-2.0
import { Status } from './abi.js';
import { now } from './resource.js';

/** As now(), but a failure rejects, and a `signal` that is aborted in `onProgress` cancels. */
export async function later(request, options = {}) {
  const { onProgress, signal } = options;
  if (!onProgress) return now(request, options);
  const report = (fraction, stage) => onProgress(fraction, stage) !== false && !signal?.aborted;
  try {
    return now(request, { ...options, onProgress: report });
  } catch (error) {
    if (error?.status === Status.E_CANCELLED && signal?.aborted) throw signal.reason;
    throw error;
  }
}
