// What toothseg for Node has. SPDX-License-Identifier: Apache-2.0
//
// The C header, toothseg.h, is the manual: what is said there of a function holds for the method of the same name here.
// Lengths are mm, indices count from 0, NONE is "no index".
/// <reference lib="esnext.disposable" />
import type {
  ClickInfo, ContourInfo, CutEdit, CutInfo, EdgePoint, FeatureGroup, FeatureOptions, FeaturePoint, FeaturesInfo,
  HistoryInfo, IntakeOptions, IntakeReport, JawInfo, MemoryInfo, MeshInfo, NumberInfo, NumberOptions, OutputFormat,
  Overlap, Palmer, PrepareTimes, ReviewItem, SaveOptions, SegmentOptions, SurfacePoint, ToothFrame, ToothInfo,
  ToothMeshOptions,
} from './lib/abi.js';
import { FileFormat, LogLevel, Status } from './lib/abi.js';
import type { LaterOptions } from './lib/later.js';

export {
  Background, ClickInfo, ClickTimes, ContourInfo, CutEdit, CutInfo, CutRule, EdgePoint, EditKind, FeatureGroup,
  FeatureOptions, FeaturePoint, FeaturesInfo, FeaturesWarning, FileFormat, HistoryInfo, IntakeOptions, IntakeReport, Jaw,
  JawInfo, LogLevel, MemoryInfo, MeshInfo, MeshVertexFlag, NONE, NumberInfo, NumberOptions, OutputFormat, Overlap, Palmer,
  PrepareTimes, Preset, ReviewItem, SaveOptions, SegmentOptions, Status, SurfacePoint, ToothFrame, ToothInfo,
  ToothMeshOptions, ToothWarning, Unit, Weights,
} from './lib/abi.js';

export { LaterOptions } from './lib/later.js';

/** x, y, z, in mm where it is a place. */
export type Point = ArrayLike<number>;
/** Many points: one array each, or flat, three numbers a point. A Float64Array is taken as it is, without a copy. */
export type Points = readonly Point[] | ArrayLike<number>;

/** Of a call that JavaScript waits for. */
export interface NowOptions {
  /** Called with the share that is done, 0 to 1, and the stage's name. False cancels; what it throws comes out of the
   *  call. Wants a context with `threads: 1`. */
  onProgress?: (fraction: number, stage: string) => boolean | void;
  /** Looked at before the call. */
  signal?: AbortSignal;
}

// ------------------------------------------------------------------------------------------------------------- errors

/** Base of what the library's statuses become. */
export declare class ToothsegError extends Error {
  readonly status: Status;
  /** The status's name: 'TS_E_NO_TEETH'. */
  readonly code: string;
}
/** 100: the call itself is wrong. Also: used after dispose(), or while another call is running on the object. */
export declare class UsageError extends ToothsegError {}
/** 200: out of memory, cancelled, or a fault in the library. */
export declare class ResourceError extends ToothsegError {}
/** 300: files. */
export declare class FileError extends ToothsegError {}
/** 400: the mesh. */
export declare class MeshError extends ToothsegError {}
/** 500: features. */
export declare class FeatureError extends ToothsegError {}
/** 600: segmentation. */
export declare class SegmentationError extends ToothsegError {}
/** 650: edits of a cut. */
export declare class EditError extends ToothsegError {}
/** 700: numbers of teeth. */
export declare class NumberError extends ToothsegError {}
/** 750: the meshes of teeth. */
export declare class ToothMeshError extends ToothsegError {}

// ------------------------------------------------------------------------------------------------------------ objects

/** What the library makes. Objects may be disposed of in any order; one that is forgotten is given back some time. */
export declare abstract class Resource {
  readonly disposed: boolean;
  /** Gives the native object back; where a call is running on it, when that ends. Again is fine. */
  dispose(): void;
  [Symbol.dispose](): void;
}

export interface ContextOptions {
  /** Worker threads: 0 = one a core (default), 1 = only the calling thread, at most 1024. */
  threads?: number;
  /** Called with each line of the log. With more than one thread, long calls then have to be asynchronous. */
  log?: (level: LogLevel, text: string) => void;
  /** Told of each large buffer that the library takes and gives back. Wants `threads: 1`. */
  memory?: {
    /** False: there is none. */
    allocate?: (bytes: number) => boolean | void;
    free?: (bytes: number) => void;
  };
}

/** The hooks that all objects made from it share. */
export declare class Context extends Resource {
  constructor(options?: ContextOptions);
}

export interface Mesh {
  /** x, y, z of each vertex; not to be changed while an asynchronous call reads it. */
  positions: Float32Array | Float64Array;
  /** Three indices a triangle; none: vertices 3i, 3i + 1, 3i + 2 are triangle i. A Uint32Array is not copied. */
  triangles?: ArrayLike<number> | null;
  /** Numbers from one vertex to the next, at least 3. Default: packed. */
  stride?: number;
}

export interface ReadOptions extends IntakeOptions {
  /** Default: told from the content. */
  format?: FileFormat;
}

/** A mesh after intake: welded, clean, manifold, consistently wound. Never changes. */
export declare class Model extends Resource {
  private constructor();
  /** From a file: STL, PLY, OBJ, OFF. */
  static load(context: Context, path: string, options?: IntakeOptions & LaterOptions): Promise<Model>;
  static loadSync(context: Context, path: string, options?: IntakeOptions & NowOptions): Model;
  /** From a file in memory. */
  static read(context: Context, bytes: Uint8Array | ArrayBuffer, options?: ReadOptions & LaterOptions): Promise<Model>;
  static readSync(context: Context, bytes: Uint8Array | ArrayBuffer, options?: ReadOptions & NowOptions): Model;
  /** From arrays. */
  static create(context: Context, mesh: Mesh, options?: IntakeOptions & LaterOptions): Promise<Model>;
  static createSync(context: Context, mesh: Mesh, options?: IntakeOptions & NowOptions): Model;

  report(): IntakeReport;
  /** Three numbers a vertex. `into`, here and below: an array to fill, for one that is asked for often. */
  positions(into?: Float64Array): Float64Array;
  /** Three indices a face. */
  triangles(into?: Uint32Array): Uint32Array;
  /** For each face the caller's face that it came from. */
  faceSources(into?: Uint32Array): Uint32Array;
  /** For each of the caller's vertices the model's that stands for it, or NONE. */
  vertexMap(into?: Uint32Array): Uint32Array;
  nearest(position: Point): SurfacePoint;
  raycast(origin: Point, direction: Point): SurfacePoint;
}

/** Feature points of the teeth, a group a tooth. A segmentation takes a copy. */
export declare class Features extends Resource {
  /** An empty set, to be filled by hand. */
  constructor(model: Model);
  static detect(model: Model, options?: FeatureOptions & LaterOptions): Promise<Features>;
  static detectSync(model: Model, options?: FeatureOptions & NowOptions): Features;
  clone(): Features;

  info(): FeaturesInfo;
  /** The unit vector from the gums to the biting surface. */
  occlusal(): [number, number, number];
  setOcclusal(direction: Point): void;
  /** The arch curve: three numbers a point. */
  arch(): Float64Array;
  points(): FeaturePoint[];
  /** In the order of the arch. */
  groups(): FeatureGroup[];
  /** To a group, or, without one, to a new one; says which. */
  addPoint(position: Point, group?: number): { point: number; group: number };
  movePoint(point: number, position: Point): void;
  /** Into another group, or, without one, a new one; says which. */
  setGroup(point: number, group?: number): number;
  removePoint(point: number): void;
  removeGroup(group: number): void;
}

/** A prepared scan and the teeth separated so far. Each change is a step that undo() takes back. */
export declare class Segmentation extends Resource {
  private constructor();
  static create(features: Features, options?: SegmentOptions & LaterOptions): Promise<Segmentation>;
  static createSync(features: Features, options?: SegmentOptions & NowOptions): Segmentation;

  /** Separates the tooth under a point and its neighbour. Gives the click's number. */
  click(position: Point, options?: LaterOptions): Promise<number>;
  clickSync(position: Point, options?: NowOptions): number;
  /** Several clicks: a status each. Those that fail leave no trace, the others stand. */
  clicks(positions: Points, options?: LaterOptions): Promise<Status[]>;
  clicksSync(positions: Points, options?: NowOptions): Status[];
  /** Every tooth without a click of the caller's. */
  segmentAll(options?: LaterOptions): Promise<void>;
  segmentAllSync(options?: NowOptions): void;
  /** The fewest clicks that cover what is not separated yet. */
  proposeClicks(): [number, number, number][];
  clickCount(): number;
  clickInfo(click: number): ClickInfo;
  /** The field of a click, a value a vertex of the model. */
  field(click: number, into?: Float64Array): Float64Array;
  histogram(click: number): Uint32Array;
  contours(click: number): ContourInfo[];
  contourPoints(click: number, contour: number): { points: EdgePoint[]; closed: boolean }[];

  /** Ids along the arch. */
  teeth(): number[];
  tooth(tooth: number): ToothInfo;
  toothFaces(tooth: number, into?: Uint32Array): Uint32Array;
  toothVertices(tooth: number, into?: Uint32Array): Uint32Array;
  toothSeeds(tooth: number): Uint32Array;
  toothFrame(tooth: number): ToothFrame;
  /** A loop of a tooth's cut; 0: the longest. */
  cut(tooth: number, loop?: number): { info: CutInfo; points: EdgePoint[] };
  /** A label for each of the caller's faces, in the caller's order; 0: no tooth. */
  labels(into?: Uint32Array): Uint32Array;
  /** Teeth that want a look, those that need it most first. */
  review(): ReviewItem[];
  overlaps(): Overlap[];
  prepareTimes(): PrepareTimes;
  memory(): MemoryInfo;

  /** "This too." */
  includePoint(tooth: number, position: Point, options?: LaterOptions): Promise<void>;
  includePointSync(tooth: number, position: Point, options?: NowOptions): void;
  /** "Not this." */
  excludePoint(tooth: number, position: Point, options?: LaterOptions): Promise<void>;
  excludePointSync(tooth: number, position: Point, options?: NowOptions): void;
  /** Two teeth of one. Gives the id of the new one. */
  splitTooth(tooth: number, keep: Point, part: Point, options?: LaterOptions): Promise<number>;
  splitToothSync(tooth: number, keep: Point, part: Point, options?: NowOptions): number;
  /** Moves a feature point of the tooth. */
  movePoint(tooth: number, from: Point, to: Point, options?: LaterOptions): Promise<void>;
  movePointSync(tooth: number, from: Point, to: Point, options?: NowOptions): void;
  /** One tooth of two. */
  mergeTeeth(tooth: number, other: number, options?: LaterOptions): Promise<void>;
  mergeTeethSync(tooth: number, other: number, options?: NowOptions): void;
  removeTooth(tooth: number): void;
  setLocked(tooth: number, locked: boolean): void;
  isLocked(tooth: number): boolean;

  /** Takes a point of the cut to another place. `reach`: half the length of the stretch that follows, mm. */
  dragCut(tooth: number, loop: number, point: number, to: Point, options?: LaterOptions & { reach?: number }): Promise<void>;
  dragCutSync(tooth: number, loop: number, point: number, to: Point, options?: NowOptions & { reach?: number }): void;
  /** Draws a stretch of the cut. */
  drawCut(tooth: number, stroke: Points, options?: LaterOptions): Promise<void>;
  drawCutSync(tooth: number, stroke: Points, options?: NowOptions): void;
  /** Moves the whole cut, outwards where positive. */
  offsetCut(tooth: number, mm: number, options?: LaterOptions): Promise<void>;
  offsetCutSync(tooth: number, mm: number, options?: NowOptions): void;
  /** Straightens what bends within less than `strength`, mm, over 0 to 2. */
  smoothCut(tooth: number, strength: number, options?: LaterOptions): Promise<void>;
  smoothCutSync(tooth: number, strength: number, options?: NowOptions): void;
  /** The cut of its click again. */
  resetCut(tooth: number): void;
  cutEdits(tooth: number): CutEdit[];

  /** Gives the teeth their FDI numbers. */
  assignNumbers(options?: NumberOptions): void;
  /** Sets a number by hand; 0 forgets it. */
  setNumber(tooth: number, fdi: number): void;
  number(tooth: number): NumberInfo;
  jaw(): JawInfo;

  /** A tooth as a mesh of its own. */
  toothMesh(tooth: number, options?: ToothMeshOptions & LaterOptions): Promise<ToothMesh>;
  toothMeshSync(tooth: number, options?: ToothMeshOptions & NowOptions): ToothMesh;
  /** What belongs to no tooth. */
  gingivaMesh(options?: ToothMeshOptions & LaterOptions): Promise<ToothMesh>;
  gingivaMeshSync(options?: ToothMeshOptions & NowOptions): ToothMesh;
  /** The whole scan with its teeth. */
  save(path: string, format: OutputFormat, options?: SaveOptions & LaterOptions): Promise<void>;
  saveSync(path: string, format: OutputFormat, options?: SaveOptions & NowOptions): void;

  undo(): void;
  redo(): void;
  history(): HistoryInfo;
  setHistoryLimit(bytes: number | bigint): void;
  /** Ids of the teeth that the last step, undo() or redo() changed. */
  changes(): number[];
  /** Calls `listener` after each change; null: nobody. What it throws comes out of the call that made the change. */
  onChange(listener: ((teeth: number[]) => void) | null): void;

  /** The session as text, for readSession(). */
  writeSession(): string;
  saveSession(path: string): void;
  /** Goes through the steps of a session again. */
  static loadSession(model: Model, path: string, options?: LaterOptions): Promise<Session>;
  static loadSessionSync(model: Model, path: string, options?: NowOptions): Session;
  static readSession(model: Model, session: string, options?: LaterOptions): Promise<Session>;
  static readSessionSync(model: Model, session: string, options?: NowOptions): Session;
}

/** What a session gives: the features as they were, and the segmentation to go on with. */
export interface Session {
  features: Features;
  segmentation: Segmentation;
}

/** A tooth, or the gingiva, as a mesh of its own, cut exactly along the cuts. */
export declare class ToothMesh extends Resource {
  private constructor();
  info(): MeshInfo;
  positions(into?: Float64Array): Float64Array;
  normals(into?: Float64Array): Float64Array;
  triangles(into?: Uint32Array): Uint32Array;
  /** For each triangle the face of the model that it is of; NONE for those that close the mesh. */
  faces(into?: Uint32Array): Uint32Array;
  /** Sums of MeshVertexFlag. */
  vertexFlags(into?: Uint8Array): Uint8Array;
  save(path: string, format: OutputFormat, options?: LaterOptions): Promise<void>;
  saveSync(path: string, format: OutputFormat, options?: NowOptions): void;
}

// ------------------------------------------------------------------------------------------------------------ numbers

/** The library's version. */
export declare function version(): string;
export declare function fdiToUniversal(fdi: number): number;
export declare function universalToFdi(universal: number): number;
export declare function fdiToPalmer(fdi: number): Palmer;
