// The scan's surface: a colour a face from its label, looked up in the shader, so that a click changes one byte a face.
// SPDX-License-Identifier: Apache-2.0
import {
  BufferAttribute, BufferGeometry, DataTexture, DoubleSide, GLSL3, Group, Mesh, NearestFilter, RGBAFormat, RedIntegerFormat, ShaderMaterial,
  UnsignedByteType,
} from 'three';
import type { Geometry } from './protocol';

/** Faces a row of the textures. A power of two, as the shader has it. */
const ROW = 1024;

const vertexShader = /* glsl */ `
uniform highp usampler2D labels, territory;
uniform uint target, neighbour, shine;
uniform int first;
in float u;
flat out uint label;
flat out float hint;
out vec3 facing;
out float value;
void main() {
  int face = first + gl_VertexID / 3;
  ivec2 at = ivec2(face & ${ROW - 1}, face >> 10);
  label = texelFetch(labels, at, 0).r;
  uint place = texelFetch(territory, at, 0).r;
  hint = 0.0;
  if (label == 0u && place != 0u) hint = place == target ? 1.0 : place == neighbour ? 0.45 : 0.0;
  if (label != 0u && label == shine) hint = 0.5;
  facing = normalMatrix * normal;
  value = u;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = /* glsl */ `
uniform sampler2D palette;
uniform vec3 accent;
uniform bool field;
flat in uint label;
flat in float hint;
in vec3 facing;
in float value;
out vec4 colour;
// Red at the tooth clicked (0), blue at its neighbour (1), as in the paper's figures.
vec3 ramp(float u) {
  vec3 red = vec3(0.80, 0.12, 0.12), pale = vec3(0.93, 0.91, 0.80), blue = vec3(0.13, 0.29, 0.80);
  return u < 0.5 ? mix(red, pale, u * 2.0) : mix(pale, blue, u * 2.0 - 1.0);
}
void main() {
  vec4 own = texelFetch(palette, ivec2(int(label), 0), 0);
  if (own.a < 0.5) discard;
  vec3 base = own.rgb;
  if (field) base = value < 0.0 ? vec3(0.6) : ramp(clamp(value, 0.0, 1.0));
  else if (hint > 0.0) base = mix(base, label == 0u ? accent : vec3(1.0), hint * 0.55);
  vec3 n = normalize(facing);
  if (n.z < 0.0) n = -n;
  float light = 0.36 + 0.5 * max(dot(n, normalize(vec3(-0.35, 0.55, 0.75))), 0.0) + 0.2 * max(n.z, 0.0);
  float gloss = pow(max(dot(n, normalize(vec3(-0.2, 0.35, 1.0))), 0.0), 40.0) * 0.10;
  colour = vec4(base * light + gloss, 1.0);
}`;

export type Colour = [number, number, number];

/** Faces a piece: pieces come to the graphics card one a frame, so that no frame takes long. A multiple of `ROW`. */
const PIECE = 48 * ROW;

export class Surface {
  readonly group = new Group();
  private readonly pieces: Mesh<BufferGeometry, ShaderMaterial>[] = [];
  private readonly uniforms: Record<string, { value: unknown }>;

  constructor(geometry: Geometry) {
    const rows = Math.max(1, Math.ceil(geometry.faces / ROW));
    this.uniforms = {
      labels: { value: faceTexture(rows) },
      territory: { value: faceTexture(rows) },
      palette: { value: paletteTexture() },
      target: { value: 0 },
      neighbour: { value: 0 },
      shine: { value: 0 },
      accent: { value: [0.2, 0.55, 0.9] },
      field: { value: false },
    };
    for (let first = 0; first < geometry.faces; first += PIECE) {
      const last = Math.min(geometry.faces, first + PIECE);
      const buffer = new BufferGeometry();
      buffer.setAttribute('position', new BufferAttribute(geometry.positions.subarray(9 * first, 9 * last), 3));
      buffer.setAttribute('normal', new BufferAttribute(geometry.normals.subarray(12 * first, 12 * last), 4, true));
      const material = new ShaderMaterial({
        glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: { ...this.uniforms, first: { value: first } }, side: DoubleSide,
        // Lines lie on the surface: it steps back a little.
        polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 2,
      });
      const mesh = new Mesh(buffer, material);
      mesh.frustumCulled = false;
      this.pieces.push(mesh);
    }
  }

  /** Adds the next piece to what is drawn; false: all of them are there. */
  grow(): boolean {
    const next = this.pieces[this.group.children.length];
    if (next) this.group.add(next);
    return next !== undefined;
  }

  setLabels(labels: Uint8Array<ArrayBuffer>): void {
    fill(this.uniforms.labels.value as DataTexture, labels);
  }

  setTerritory(territory: Uint8Array<ArrayBuffer>): void {
    fill(this.uniforms.territory.value as DataTexture, territory);
  }

  /** Colours by label; those without are hidden. */
  setPalette(colours: (Colour | null)[]): void {
    const texture = this.uniforms.palette.value as DataTexture;
    const data = texture.image.data as Uint8Array;
    for (let i = 0; i < 256; ++i) {
      const colour = colours[i];
      data.set(colour ? [...colour, 255] : [0, 0, 0, i < colours.length ? 0 : 255], 4 * i);
    }
    texture.needsUpdate = true;
  }

  /** Shows what a click would take: places of groups, or the label of a tooth that stands; 0: nothing. */
  hint(target: number, neighbour: number, label: number): void {
    this.uniforms.target.value = target;
    this.uniforms.neighbour.value = neighbour;
    this.uniforms.shine.value = label;
  }

  /** u at each corner; null: colours of teeth again. */
  setField(values: Float32Array<ArrayBuffer> | null): void {
    this.pieces.forEach(({ geometry }, i) => {
      const corners = geometry.getAttribute('position').count;
      if (values) geometry.setAttribute('u', new BufferAttribute(values.subarray(3 * PIECE * i, 3 * PIECE * i + corners), 1));
      else geometry.deleteAttribute('u');
    });
    this.uniforms.field.value = values !== null;
  }

  dispose(): void {
    for (const { geometry, material } of this.pieces) {
      geometry.dispose();
      material.dispose();
    }
    for (const name of ['labels', 'territory', 'palette']) (this.uniforms[name].value as DataTexture).dispose();
  }
}

function faceTexture(rows: number): DataTexture {
  const texture = new DataTexture(new Uint8Array(ROW * rows), ROW, rows, RedIntegerFormat, UnsignedByteType);
  texture.internalFormat = 'R8UI';
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

function paletteTexture(): DataTexture {
  const texture = new DataTexture(new Uint8Array(4 * 256), 256, 1, RGBAFormat, UnsignedByteType);
  texture.minFilter = texture.magFilter = NearestFilter;
  return texture;
}

function fill(texture: DataTexture, values: Uint8Array): void {
  (texture.image.data as Uint8Array).set(values);
  texture.needsUpdate = true;
}
