// The field of a click, its contours and histogram (paper, Figs. 2 to 4). SPDX-License-Identifier: Apache-2.0
import type { Segmentation } from 'toothseg-wasm';
import type { Field, Vec3 } from '../protocol';

/** So many contours are drawn of those that the library samples: more run into each other on the screen. */
const DRAWN = 25;

type Line = { points: { position: Vec3 }[]; closed: boolean };

/** Pairs of points, relative to the centre. */
function pairs(lines: Line[], centre: Vec3): Float32Array<ArrayBuffer> {
  const count = lines.reduce((sum, { points, closed }) => sum + Math.max(0, points.length - (closed ? 0 : 1)), 0);
  const out = new Float32Array(6 * count);
  let at = 0;
  for (const { points, closed } of lines)
    for (let i = 0; i + (closed ? 0 : 1) < points.length; ++i)
      for (const { position } of [points[i], points[(i + 1) % points.length]])
        for (let k = 0; k < 3; ++k) out[at++] = position[k] - centre[k];
  return out;
}

export function fieldOf(segmentation: Segmentation, click: number, triangles: Uint32Array, centre: Vec3, none: number): Field {
  const info = segmentation.clickInfo(click);
  const u = segmentation.field(click);
  const contours = segmentation.contours(click);
  const every = Math.max(1, Math.floor(contours.length / DRAWN));
  const lines: Line[] = [], chosen: Line[] = [];
  contours.forEach((contour, i) => {
    if (contour.chosen) chosen.push(...segmentation.contourPoints(click, i));
    else if (i % every === 0) lines.push(...segmentation.contourPoints(click, i));
  });
  return {
    click,
    target: info.target,
    neighbour: info.neighbour === none ? null : info.neighbour,
    values: Float32Array.from(triangles, (v) => (Number.isNaN(u[v]) ? -1 : u[v])),
    lines: pairs(lines, centre),
    chosen: pairs(chosen, centre),
    histogram: segmentation.histogram(click),
    gradient: contours.map(({ iso, gradient, chosen }) => ({ iso, gradient, chosen })),
    vMed: info.vMed,
    targetIso: info.targetIso,
    neighbourIso: info.neighbourIso,
  };
}
