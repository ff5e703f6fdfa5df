// Which group a click would take: what the page shows before there is a click. SPDX-License-Identifier: Apache-2.0
//
// A preview only: the nearest feature point along the surface, in a metric in which ways through valleys are long, as the
// library's own is. The click itself decides, and may find otherwise.

/** As click_concavity of the library's options. */
const CONCAVITY = 60;
/** Beyond this, in the metric, no tooth is near, mm. Higher, and the gum takes the colour of the tooth above it. */
const REACH = 15;

/** Vertices of the mesh's edges with what each edge costs: `first[v]` to `first[v + 1]` are those of v. */
export interface Ways {
  first: Uint32Array;
  to: Uint32Array;
  cost: Float32Array;
}

function normalOf(p: Float64Array, t: Uint32Array, face: number): [number, number, number] {
  const [a, b, c] = [3 * t[3 * face], 3 * t[3 * face + 1], 3 * t[3 * face + 2]];
  const u = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
  const v = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
  const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const l = Math.hypot(n[0], n[1], n[2]) || 1;
  return [n[0] / l, n[1] / l, n[2] / l];
}

/** How concave the surface is around each vertex, 1/mm: the bend towards the inside over the distance in which it bends. */
function concavities(p: Float64Array, t: Uint32Array, inwards: boolean): Float32Array {
  const count = p.length / 3;
  const sum = new Float32Array(count), n = new Float32Array(count);
  const normals = new Float32Array(p.length);
  for (let f = 0; f < t.length / 3; ++f) {
    const m = normalOf(p, t, f);
    for (let k = 0; k < 3; ++k) for (let d = 0; d < 3; ++d) normals[3 * t[3 * f + k] + d] += m[d];
  }
  for (let v = 0; v < normals.length; v += 3) {
    const l = (Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1) * (inwards ? -1 : 1);
    for (let d = 0; d < 3; ++d) normals[v + d] /= l;
  }
  for (let i = 0; i < t.length; ++i) {
    const a = 3 * t[i], b = 3 * t[i % 3 === 2 ? i - 2 : i + 1];
    let bend = 0, square = 0;
    for (let d = 0; d < 3; ++d) {
      const e = p[b + d] - p[a + d];
      bend += (normals[b + d] - normals[a + d]) * e;
      square += e * e;
    }
    // The normal curvature along the edge: under 0 in a valley.
    const c = square > 0 ? Math.max(0, -bend / square) : 0;
    for (const v of [t[i], b / 3]) {
      sum[v] += c;
      n[v] += 1;
    }
  }
  return sum.map((s, v) => (n[v] ? s / n[v] : 0));
}

export function waysOf(p: Float64Array, t: Uint32Array, inwards: boolean): Ways {
  const count = p.length / 3;
  const concave = concavities(p, t, inwards);
  const first = new Uint32Array(count + 1);
  for (const v of t) first[v + 1] += 2;
  for (let v = 0; v < count; ++v) first[v + 1] += first[v];
  const to = new Uint32Array(2 * t.length), cost = new Float32Array(2 * t.length);
  const next = first.slice();
  for (let i = 0; i < t.length; ++i) {
    const a = t[i];
    for (const b of [t[i % 3 === 2 ? i - 2 : i + 1], t[i % 3 === 0 ? i + 2 : i - 1]]) {
      const length = Math.hypot(p[3 * b] - p[3 * a], p[3 * b + 1] - p[3 * a + 1], p[3 * b + 2] - p[3 * a + 2]);
      to[next[a]] = b;
      cost[next[a]++] = length * (1 + CONCAVITY * 0.5 * Math.min(1, (concave[a] + concave[b]) / 2));
    }
  }
  return { first, to, cost };
}

/** Vertices by rising distance: a binary heap of numbers in flat arrays. */
class Queue {
  private readonly keys: number[] = [];
  private readonly vertices: number[] = [];

  get size(): number {
    return this.keys.length;
  }

  push(key: number, vertex: number): void {
    const { keys, vertices } = this;
    let i = keys.length;
    for (; i > 0; i = (i - 1) >> 1) {
      const up = (i - 1) >> 1;
      if (keys[up] <= key) break;
      keys[i] = keys[up];
      vertices[i] = vertices[up];
    }
    keys[i] = key;
    vertices[i] = vertex;
  }

  pop(): [number, number] {
    const { keys, vertices } = this;
    const top: [number, number] = [keys[0], vertices[0]];
    const key = keys.pop()!, vertex = vertices.pop()!;
    const n = keys.length;
    if (n > 0) {
      let i = 0;
      for (let child = 1; child < n; child = 2 * i + 1) {
        if (child + 1 < n && keys[child + 1] < keys[child]) ++child;
        if (keys[child] >= key) break;
        keys[i] = keys[child];
        vertices[i] = vertices[child];
        i = child;
      }
      keys[i] = key;
      vertices[i] = vertex;
    }
    return top;
  }
}

/** For each vertex the place of the group nearest along `ways`, from 1; 0 where none is within reach.
 *  `sources`: vertex and place of each feature point. */
export function territoryOf(ways: Ways, sources: { vertex: number; place: number }[]): Uint8Array {
  const count = ways.first.length - 1;
  const distance = new Float64Array(count).fill(Infinity);
  const owner = new Uint8Array(count);
  const queue = new Queue();
  for (const { vertex, place } of sources) {
    distance[vertex] = 0;
    owner[vertex] = place;
    queue.push(0, vertex);
  }
  while (queue.size > 0) {
    const [d, v] = queue.pop();
    if (d > distance[v]) continue;
    for (let i = ways.first[v]; i < ways.first[v + 1]; ++i) {
      const w = ways.to[i], further = d + ways.cost[i];
      if (further >= distance[w] || further > REACH) continue;
      distance[w] = further;
      owner[w] = owner[v];
      queue.push(further, w);
    }
  }
  return owner;
}

/** The same a face: what most of its corners say. */
export function facesOf(territory: Uint8Array, triangles: Uint32Array): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array(triangles.length / 3);
  for (let f = 0; f < out.length; ++f) {
    const a = territory[triangles[3 * f]], b = territory[triangles[3 * f + 1]], c = territory[triangles[3 * f + 2]];
    out[f] = b === c ? b : a;
  }
  return out;
}
