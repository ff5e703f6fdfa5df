// The model as the page draws it. SPDX-License-Identifier: Apache-2.0
import type { Geometry, Vec3 } from '../protocol';

/** Unit normals of the vertices, of the triangles around each by area. */
function vertexNormals(positions: Float64Array, triangles: Uint32Array): Float64Array {
  const normals = new Float64Array(positions.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 3 * triangles[i], b = 3 * triangles[i + 1], c = 3 * triangles[i + 2];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1], uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1], vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const v of [a, b, c]) {
      normals[v] += x;
      normals[v + 1] += y;
      normals[v + 2] += z;
    }
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    normals[v] /= length;
    normals[v + 1] /= length;
    normals[v + 2] /= length;
  }
  return normals;
}

function boxOf(positions: Float64Array): { centre: Vec3; radius: number } {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    if (positions[i] < low[i % 3]) low[i % 3] = positions[i];
    if (positions[i] > high[i % 3]) high[i % 3] = positions[i];
  }
  const centre = low.map((l, i) => (l + high[i]) / 2) as Vec3;
  return { centre, radius: Math.hypot(...low.map((l, i) => high[i] - l)) / 2 };
}

/** Corners of their own for each face. Coordinates are relative to the centre, since floats are coarse far from the origin.
 *  `inwards`: the faces look inwards, so that their normals are to be turned round. */
export function geometryOf(positions: Float64Array, triangles: Uint32Array, inwards: boolean): Geometry {
  const { centre, radius } = boxOf(positions);
  const normals = vertexNormals(positions, triangles);
  const scale = inwards ? -32767 : 32767;
  const xyz = new Float32Array(3 * triangles.length);
  const out = new Int16Array(4 * triangles.length);
  for (let corner = 0; corner < triangles.length; ++corner) {
    const v = 3 * triangles[corner];
    for (let k = 0; k < 3; ++k) {
      xyz[3 * corner + k] = positions[v + k] - centre[k];
      out[4 * corner + k] = Math.round(scale * normals[v + k]);
    }
  }
  return { faces: triangles.length / 3, positions: xyz, normals: out, centre, radius };
}
