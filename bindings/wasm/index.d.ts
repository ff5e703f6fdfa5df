// toothseg in WebAssembly: the API of the Node binding, and what there is here only. SPDX-License-Identifier: Apache-2.0
export * from './lib/public.js';

/** Where toothseg.wasm comes from, if it is not beside the package's code. */
export interface LoadOptions {
  wasm?: string | URL | Response | PromiseLike<Response> | BufferSource | WebAssembly.Module;
}

/** Loads the module; to be awaited before anything else. Again is fine, and waits for the same. */
export declare function load(options?: LoadOptions): Promise<unknown>;

/** Bytes of the module's memory that are in use, and that it has (it never gets smaller). */
export declare function memoryUse(): { inUse: number; size: number };

/** Files of the module, which are in memory: what Model.load, save and saveSession read and write. */
export declare const files: {
  write(path: string, bytes: Uint8Array | string): void;
  read(path: string): Uint8Array;
  remove(path: string): void;
  exists(path: string): boolean;
};

/** The bytes that `save(path)` writes: `await saved((path) => mesh.save(path, OutputFormat.STL))`. */
export declare function saved(save: (path: string) => void | Promise<void>): Promise<Uint8Array>;

/** What arch to make; all may be left out. */
export interface ArchOptions {
  /** 1 upper (default), 2 lower */
  jaw?: 1 | 2;
  /** wanted, 5000 to 4000000; the result is within 5 %. Default 100000 */
  triangles?: number;
  /** false: an open shell with a rim as a scan has (default), true: closed by a flat plaster base */
  closed?: boolean;
  /** shapes, positions and noise vary with it. Default 1 */
  seed?: number | bigint;
  /** 0 none (default), 0.35 mild, 0.65 moderate, 1 severe */
  crowding?: number;
  /** standard deviation of the vertex noise, in mean edge lengths, 0 (default) to 1 */
  noise?: number;
  /** the noise moves each coordinate, rather than along the normals */
  isotropic?: boolean;
  /** FDI numbers of missing teeth, of this jaw and 1 to 7 in the quadrant */
  missing?: number[];
}

export interface Arch {
  /** three coordinates a vertex, mm; with `triangles` what Model.create takes */
  positions: Float64Array;
  triangles: Uint32Array;
  /** a label a triangle: 0 gingiva, k: tooth `teeth[k - 1]` */
  labels: Uint32Array;
  /** FDI numbers, along the arch from the patient's right to the left */
  teeth: number[];
  /** cusp tips and corners of incisal edges */
  features: { label: number; incisal: boolean; position: [number, number, number] }[];
}

/** A synthetic dental arch. */
export declare function makeArch(options?: ArchOptions): Arch;
