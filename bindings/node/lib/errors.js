// One class for each block of statuses, below ToothsegError. SPDX-License-Identifier: Apache-2.0
import { Status, statusText } from './abi.js';

const names = new Map(Object.entries(Status).map(([name, value]) => [value, `TS_${name}`]));

/** The name of a status: 'TS_E_NO_TEETH'. */
export const statusName = (status) => names.get(status) ?? 'TS_E_?';

export class ToothsegError extends Error {
  constructor(status, message) {
    super(message);
    this.name = this.constructor.name;
    this.status = status;
    this.code = statusName(status);
  }
}

/** 100: the call itself is wrong. */
export class UsageError extends ToothsegError {}
/** 200: out of memory, cancelled, or a fault in the library. */
export class ResourceError extends ToothsegError {}
/** 300: files. */
export class FileError extends ToothsegError {}
/** 400: the mesh. */
export class MeshError extends ToothsegError {}
/** 500: features. */
export class FeatureError extends ToothsegError {}
/** 600: segmentation. */
export class SegmentationError extends ToothsegError {}
/** 650: edits of a cut. */
export class EditError extends ToothsegError {}
/** 700: numbers of teeth. */
export class NumberError extends ToothsegError {}
/** 750: the meshes of teeth. */
export class ToothMeshError extends ToothsegError {}

const blocks = [
  [750, 800, ToothMeshError],
  [700, 750, NumberError],
  [650, 700, EditError],
  [600, 650, SegmentationError],
  [500, 600, FeatureError],
  [400, 500, MeshError],
  [300, 400, FileError],
  [200, 300, ResourceError],
  [100, 200, UsageError],
];

export function errorOf(status, message) {
  const block = blocks.find(([from, to]) => status >= from && status < to);
  return new (block ? block[2] : ToothsegError)(status, message);
}

/** What is known of a failure where the library's own message cannot be had: what the status means, and of which file. */
export function meaning(name, status, args) {
  const path = args.find((arg) => typeof arg === 'string');
  return `${name}: ${statusText[status] ?? statusName(status)}${path === undefined ? '' : ` ('${path}')`}`;
}

export const invalid = (message) => new UsageError(Status.E_INVALID_ARGUMENT, message);
