// The scan that is open and how things stand with it. SPDX-License-Identifier: Apache-2.0
import type { Features, Model, Segmentation } from 'toothseg-wasm';
import type { Changed, Cut, Geometry, Points, Tooth, Vec3 } from '../protocol';
import { geometryOf } from './geometry';
import { facesOf, territoryOf, waysOf, type Ways } from './territory';

export type Api = typeof import('toothseg-wasm');

/** A model with what is worked out from it once. */
export class Scan {
  readonly triangles: Uint32Array;
  readonly sources: Uint32Array;
  readonly centre: Vec3;
  private readonly ways: Ways;
  private geometry: Geometry | null;

  constructor(
    readonly name: string,
    readonly model: Model,
    inwards: boolean,
  ) {
    const positions = model.positions();
    this.triangles = model.triangles();
    this.sources = model.faceSources();
    this.geometry = geometryOf(positions, this.triangles, inwards);
    this.centre = this.geometry.centre;
    this.ways = waysOf(positions, this.triangles, inwards);
  }

  /** What the page draws, once: its arrays go over to the page. */
  giveGeometry(): Geometry {
    const geometry = this.geometry;
    if (!geometry) throw new Error('the geometry has been given away');
    this.geometry = null;
    return geometry;
  }

  /** A label a face of the model, from those that are a label a face of the caller's. */
  labels(segmentation: Segmentation): Uint8Array<ArrayBuffer> {
    const given = segmentation.labels();
    return Uint8Array.from(this.sources, (face) => Math.min(255, given[face]));
  }

  points(features: Features, edited: boolean, fdi: (group: number) => number): Points {
    const groups = features.groups();
    const points = features.points();
    const place = new Map(groups.map(({ id }, i) => [id, i + 1]));
    const territory = territoryOf(this.ways, points.map((p) => ({ vertex: p.vertex, place: Math.min(255, place.get(p.group)!) })));
    return {
      groups: groups.map((g) => {
        // The point nearest to the middle: furthest from the neighbours.
        const own = points.filter((p) => p.group === g.id);
        const far = (p: { position: Vec3 }) => Math.hypot(...p.position.map((x, k) => x - g.centre[k]));
        const at = own.reduce((best, p) => (far(p) < far(best) ? p : best)).position;
        return { id: g.id, centre: g.centre, at, confidence: g.confidence, fdi: fdi(g.id) };
      }),
      points: points.map(({ id, group, position, byHand }) => ({ id, group, position, byHand })),
      territory: facesOf(territory, this.triangles),
      edited,
    };
  }
}

export function cutOf(segmentation: Segmentation, tooth: number, centre: Vec3): Cut {
  const { loops } = segmentation.tooth(tooth);
  return {
    tooth,
    loops: Array.from({ length: loops }, (_, loop) => {
      const { info, points } = segmentation.cut(tooth, loop);
      const xyz = new Float32Array(3 * points.length);
      points.forEach(({ position }, i) => position.forEach((x, k) => (xyz[3 * i + k] = x - centre[k])));
      return { points: xyz, closed: info.closed };
    }),
  };
}

/** The FDI number of a group, 0 where it has none. */
export function fdiOf(segmentation: Segmentation, group: number): number {
  try {
    return segmentation.number(group).fdi;
  } catch {
    return 0; // not numbered so far
  }
}

function toothOf(segmentation: Segmentation, id: number): Tooth {
  const { label, click, confidence, warnings, faces, area } = segmentation.tooth(id);
  let [fdi, fdiByHand, fdiUncertain] = [0, false, true];
  let centre: Vec3 = [0, 0, 0];
  try {
    const number = segmentation.number(id);
    [fdi, fdiByHand, fdiUncertain] = [number.fdi, number.setByHand, number.uncertain];
  } catch {
    // no number: shown without
  }
  centre = segmentation.toothFrame(id).centre;
  return { id, label, click, fdi, fdiByHand, fdiUncertain, confidence, warnings, locked: segmentation.isLocked(id), faces, area, centre };
}

function jawOf(segmentation: Segmentation): Changed['jaw'] {
  try {
    return ([null, 'upper', 'lower'] as const)[segmentation.jaw().jaw];
  } catch {
    return null; // nothing is numbered so far
  }
}

/** How things stand. `changed`: the teeth whose cuts the page has to draw anew. */
export function stateOf(scan: Scan, segmentation: Segmentation, groups: number[], changed: number[]): Changed {
  const teeth = segmentation.teeth();
  const history = segmentation.history();
  return {
    teeth: teeth.map((id) => toothOf(segmentation, id)),
    labels: scan.labels(segmentation),
    cuts: changed.filter((id) => teeth.includes(id)).map((id) => cutOf(segmentation, id, scan.centre)),
    focus: null,
    neighbour: null,
    clicks: segmentation.clickCount(),
    undo: history.undo,
    redo: history.redo,
    fdi: groups.map((id) => fdiOf(segmentation, id)),
    proposals: segmentation.proposeClicks(),
    jaw: jawOf(segmentation),
    ms: 0,
  };
}
