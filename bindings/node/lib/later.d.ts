// SPDX-License-Identifier: Apache-2.0
/** Of a call on another thread. */
export interface LaterOptions {
  /** Called some 30 times a second with the share that is done, 0 to 1. False cancels; what it throws comes out of the call. */
  onProgress?: (fraction: number) => boolean | void;
  /** Cancels the call, which is then rejected with the signal's reason. */
  signal?: AbortSignal;
}
