// What the page and its worker say to each other. SPDX-License-Identifier: Apache-2.0
//
// A request has an id; the worker answers it with a reply or a failure of the same id, and may tell of progress before. Requests
// are worked off one after the other. Arrays are transferred, not copied. Places are in mm, in the axes of the scan.

export type Vec3 = [number, number, number];

/** What the page asks for, by name: what goes in, what comes out. */
export interface Calls {
  /** Takes a file (a scan, as bytes) in and prepares it. */
  open: { in: { name: string; bytes: ArrayBuffer }; out: Opened };
  /** The same with a synthetic arch. */
  openArch: { in: { triangles: number }; out: Opened };
  /** A session of the scan that is open. */
  openSession: { in: { text: string }; out: Reopened };
  pick: { in: { origin: Vec3; direction: Vec3 }; out: Pick | null };
  click: { in: { position: Vec3 }; out: Changed };
  segmentAll: { in: object; out: Changed };
  include: { in: { tooth: number; position: Vec3 }; out: Changed };
  exclude: { in: { tooth: number; position: Vec3 }; out: Changed };
  split: { in: { tooth: number; keep: Vec3; part: Vec3 }; out: Changed };
  merge: { in: { tooth: number; other: number }; out: Changed };
  remove: { in: { tooth: number }; out: Changed };
  lock: { in: { tooth: number; locked: boolean }; out: Changed };
  number: { in: { tooth: number; fdi: number }; out: Changed };
  dragCut: { in: { tooth: number; loop: number; point: number; to: Vec3 }; out: Changed };
  offsetCut: { in: { tooth: number; mm: number }; out: Changed };
  smoothCut: { in: { tooth: number; strength: number }; out: Changed };
  resetCut: { in: { tooth: number }; out: Changed };
  undo: { in: object; out: Changed };
  redo: { in: object; out: Changed };
  field: { in: { click: number }; out: Field };
  /** Edits of the feature points; they count from the next `prepare` on. */
  addPoint: { in: { position: Vec3; group: number | null }; out: Points };
  movePoint: { in: { point: number; position: Vec3 }; out: Points };
  removePoint: { in: { point: number }; out: Points };
  removeGroup: { in: { group: number }; out: Points };
  /** Another group for a point; null: a new one. */
  setGroup: { in: { point: number; group: number | null }; out: Points };
  /** Prepares the scan anew with the points as they are, and repeats the clicks. */
  prepare: { in: object; out: Reopened };
  exportTeeth: { in: { closed: boolean }; out: File };
  exportPly: { in: { colours: [number, number, number][] }; out: File };
  exportSession: { in: object; out: File };
}

export type Op = keyof Calls;
export type Request<K extends Op = Op> = { id: number; op: K; in: Calls[K]['in'] };
export type Message =
  | { id: number; kind: 'reply'; out: unknown }
  | { id: number; kind: 'failure'; status: number; message: string }
  | { id: number; kind: 'progress'; fraction: number; stage: string }
  | { id: 0; kind: 'ready' }
  /** The library could not be loaded. */
  | { id: 0; kind: 'broken'; message: string };

export interface Pick {
  position: Vec3;
  face: number;
  /** Place of the group in `Points.groups` that a click here would take, counted from 1; 0: none is near. */
  group: number;
  /** Its neighbour likewise. */
  neighbour: number;
}

/** What is drawn: three corners a face, none shared, so that a face can have a colour of its own. */
export interface Geometry {
  faces: number;
  /** Relative to `centre`. */
  positions: Float32Array<ArrayBuffer>;
  /** Four 16 bit numbers a corner: the normal, and one for alignment. */
  normals: Int16Array<ArrayBuffer>;
  centre: Vec3;
  radius: number;
}

export interface Group {
  id: number;
  centre: Vec3;
  /** A feature point of it: where the keyboard clicks. */
  at: Vec3;
  confidence: number;
  /** 0: no number so far. */
  fdi: number;
}

export interface Point {
  id: number;
  group: number;
  position: Vec3;
  byHand: boolean;
}

export interface Points {
  groups: Group[];
  points: Point[];
  /** For each face the place of the group that a click on it would take, counted from 1; 0: none. */
  territory: Uint8Array<ArrayBuffer>;
  /** Points were edited since the scan was prepared. */
  edited: boolean;
}

export interface Tooth {
  id: number;
  label: number;
  click: number;
  fdi: number;
  fdiByHand: boolean;
  fdiUncertain: boolean;
  confidence: number;
  warnings: number;
  locked: boolean;
  faces: number;
  area: number;
  centre: Vec3;
}

/** The loops of a tooth's cut, relative to the geometry's centre. */
export interface Cut {
  tooth: number;
  loops: { points: Float32Array<ArrayBuffer>; closed: boolean }[];
}

/** How things stand after a step. */
export interface Changed {
  teeth: Tooth[];
  /** A label a face of the geometry. */
  labels: Uint8Array<ArrayBuffer>;
  /** Cuts of the teeth that the step changed. */
  cuts: Cut[];
  /** Of them all, what to select: the tooth clicked, or changed. */
  focus: number | null;
  neighbour: number | null;
  clicks: number;
  undo: number;
  redo: number;
  /** Numbers of the groups, as `Points.groups` has them. */
  fdi: number[];
  /** Places of the fewest clicks that cover what is left. */
  proposals: Vec3[];
  jaw: 'upper' | 'lower' | null;
  /** Milliseconds that the library took. */
  ms: number;
}

export interface Reopened extends Changed {
  points: Points;
  /** Clicks that could not be repeated. */
  failed: number;
}

export interface Opened extends Reopened {
  name: string;
  geometry: Geometry;
  /** Unit vector from the gums to the biting surface. */
  occlusal: Vec3;
  /** Unit vector to the front of the arch. */
  front: Vec3;
  /** A sentence on what is odd about the scan; null: nothing. */
  warning: string | null;
}

export interface Field {
  click: number;
  target: number;
  neighbour: number | null;
  /** u at each corner of the geometry; -1 where it is left open. */
  values: Float32Array<ArrayBuffer>;
  /** Pairs of points, relative to the centre. */
  lines: Float32Array<ArrayBuffer>;
  /** The chosen ones likewise. */
  chosen: Float32Array<ArrayBuffer>;
  histogram: Uint32Array;
  /** Mean gradient of each contour sampled, by iso-value. */
  gradient: { iso: number; gradient: number; chosen: number }[];
  vMed: number;
  targetIso: number;
  /** NaN: there is none. */
  neighbourIso: number;
}

export interface File {
  name: string;
  type: string;
  bytes: ArrayBuffer;
}
