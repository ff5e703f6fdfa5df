// SPDX-License-Identifier: Apache-2.0
/** Of a call that gives a promise. */
export interface LaterOptions {
  /** Called during the call with the share that is done, 0 to 1, and the stage's name. False cancels; what it throws comes
   *  out of the call. */
  onProgress?: (fraction: number, stage: string) => boolean | void;
  /** Looked at before the call, and whenever `onProgress` has been called. */
  signal?: AbortSignal;
}
