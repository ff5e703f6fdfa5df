// The files that the page gives out: STL, PLY, ZIP. SPDX-License-Identifier: Apache-2.0

const text = new TextEncoder();

/** Binary STL. */
export function stl(positions: Float64Array, triangles: Uint32Array, name: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(84 + (triangles.length / 3) * 50);
  const view = new DataView(bytes.buffer);
  bytes.set(text.encode(name).subarray(0, 80));
  view.setUint32(80, triangles.length / 3, true);
  for (let f = 0, at = 84; f < triangles.length; f += 3, at += 50) {
    const [a, b, c] = [3 * triangles[f], 3 * triangles[f + 1], 3 * triangles[f + 2]];
    const u = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const v = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n) || 1;
    for (let k = 0; k < 3; ++k) {
      view.setFloat32(at + 4 * k, n[k] / length, true);
      view.setFloat32(at + 12 + 4 * k, positions[a + k], true);
      view.setFloat32(at + 24 + 4 * k, positions[b + k], true);
      view.setFloat32(at + 36 + 4 * k, positions[c + k], true);
    }
  }
  return bytes;
}

/** Binary PLY with a colour and a label a triangle, as ts_segmentation_save writes it. */
export function ply(
  positions: Float64Array,
  triangles: Uint32Array,
  labels: Uint8Array,
  colours: [number, number, number][],
): Uint8Array<ArrayBuffer> {
  const vertices = positions.length / 3, faces = triangles.length / 3;
  const header = text.encode(
    `ply\nformat binary_little_endian 1.0\ncomment millimetres; label 0: no tooth\nelement vertex ${vertices}\n` +
      'property float x\nproperty float y\nproperty float z\n' +
      `element face ${faces}\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n` +
      'property uchar blue\nproperty int label\nend_header\n',
  );
  const bytes = new Uint8Array(header.length + 12 * vertices + 20 * faces);
  const view = new DataView(bytes.buffer);
  bytes.set(header);
  let at = header.length;
  for (const x of positions) {
    view.setFloat32(at, x, true);
    at += 4;
  }
  for (let f = 0; f < faces; ++f) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; ++k) view.setInt32(at + 1 + 4 * k, triangles[3 * f + k], true);
    bytes.set(colours[labels[f]] ?? colours[0], at + 13);
    view.setInt32(at + 16, labels[f], true);
    at += 20;
  }
  return bytes;
}

const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc32(bytes: Uint8Array): number {
  let c = 0xffffffff;
  for (const b of bytes) c = CRC[(c ^ b) & 255] ^ (c >>> 8);
  return ~c >>> 0;
}

/** A ZIP of files stored as they are: meshes of floats hardly shrink. Dated 1980-01-01, so that the same teeth give the same
 *  bytes. */
export function zip(files: { name: string; bytes: Uint8Array }[]): Uint8Array<ArrayBuffer> {
  const names = files.map((f) => text.encode(f.name));
  const total = files.reduce((sum, f, i) => sum + 30 + 46 + 2 * names[i].length + f.bytes.length, 22);
  const bytes = new Uint8Array(total);
  const view = new DataView(bytes.buffer);
  const heads: number[] = [];
  const crcs = files.map((f) => crc32(f.bytes));
  let at = 0;
  // What both kinds of header have in common, from the version on.
  const common = (i: number) => {
    view.setUint16(at, 20, true); // version 2.0
    view.setUint16(at + 2, 0x0800, true); // the name is UTF-8
    view.setUint16(at + 4, 0, true); // stored
    view.setUint32(at + 6, 0x00210000, true); // 1980-01-01
    view.setUint32(at + 10, crcs[i], true);
    view.setUint32(at + 14, files[i].bytes.length, true);
    view.setUint32(at + 18, files[i].bytes.length, true);
    view.setUint16(at + 22, names[i].length, true);
    at += 24;
  };
  files.forEach((file, i) => {
    heads.push(at);
    view.setUint32(at, 0x04034b50, true);
    at += 4;
    common(i);
    at += 2; // no extra field
    bytes.set(names[i], at);
    bytes.set(file.bytes, at + names[i].length);
    at += names[i].length + file.bytes.length;
  });
  const directory = at;
  files.forEach((_, i) => {
    view.setUint32(at, 0x02014b50, true);
    view.setUint16(at + 4, 20, true);
    at += 6;
    common(i);
    view.setUint32(at + 12, heads[i], true);
    at += 16;
    bytes.set(names[i], at);
    at += names[i].length;
  });
  view.setUint32(at, 0x06054b50, true);
  view.setUint16(at + 8, files.length, true);
  view.setUint16(at + 10, files.length, true);
  view.setUint32(at + 12, at - directory, true);
  view.setUint32(at + 16, directory, true);
  return bytes;
}
