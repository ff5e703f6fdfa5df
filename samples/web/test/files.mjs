// Readers of what the page saves, apart from the code that wrote it. SPDX-License-Identifier: Apache-2.0
import { crc32 } from 'node:zlib';

/** Name -> bytes of a ZIP of stored files, by its central directory. */
export function readZip(bytes) {
  const end = bytes.lastIndexOf(Buffer.from([0x50, 0x4b, 5, 6]));
  const files = new Map();
  let at = bytes.readUInt32LE(end + 16);
  for (let i = 0; i < bytes.readUInt16LE(end + 10); ++i) {
    const [crc, size, name] = [bytes.readUInt32LE(at + 16), bytes.readUInt32LE(at + 24), bytes.readUInt16LE(at + 28)];
    const head = bytes.readUInt32LE(at + 42);
    const text = bytes.toString('utf8', at + 46, at + 46 + name);
    if (bytes.readUInt32LE(head) !== 0x04034b50) throw new Error(`${text}: no local header at ${head}`);
    const start = head + 30 + bytes.readUInt16LE(head + 26) + bytes.readUInt16LE(head + 28);
    const content = bytes.subarray(start, start + size);
    if (crcOf(content) !== crc) throw new Error(`${text}: checksum`);
    files.set(text, content);
    at += 46 + name + bytes.readUInt16LE(at + 30) + bytes.readUInt16LE(at + 32);
  }
  return files;
}

/** Bit by bit, where this Node's zlib has none. */
function crcOf(bytes) {
  if (crc32) return crc32(bytes);
  let c = 0xffffffff;
  for (const b of bytes) {
    c ^= b;
    for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  }
  return ~c >>> 0;
}

/** Triangles of a binary STL, the corners as text, which makes equal ones equal. */
export function readStl(bytes) {
  const count = bytes.readUInt32LE(80);
  if (bytes.length !== 84 + 50 * count) throw new Error(`STL of ${bytes.length} bytes, with ${count} triangles`);
  return Array.from({ length: count }, (_, f) =>
    [0, 1, 2].map((k) => bytes.toString('hex', 84 + 50 * f + 12 + 12 * k, 84 + 50 * f + 24 + 12 * k)));
}

/** How many edges are not of two triangles that pass them in opposite directions: 0, and the mesh is closed. */
export function openEdges(triangles) {
  const edges = new Map();
  for (const t of triangles)
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [t[k], t[(k + 1) % 3]];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      edges.set(key, (edges.get(key) ?? 0) + (a < b ? 1 : -1));
    }
  return [...edges.values()].filter((n) => n !== 0).length;
}

/** Labels and colours of the faces of a labelled PLY. */
export function readPly(bytes) {
  const head = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const text = bytes.toString('latin1', 0, head);
  const [vertices, faces] = ['vertex', 'face'].map((e) => Number(text.match(new RegExp(`element ${e} (\\d+)`))[1]));
  const start = head + 12 * vertices;
  if (bytes.length !== start + 20 * faces) throw new Error(`PLY of ${bytes.length} bytes, not ${start + 20 * faces}`);
  const face = Array.from({ length: faces }, (_, f) => start + 20 * f);
  return {
    vertices,
    labels: face.map((at) => bytes.readInt32LE(at + 16)),
    colours: face.map((at) => [...bytes.subarray(at + 13, at + 16)]),
  };
}
