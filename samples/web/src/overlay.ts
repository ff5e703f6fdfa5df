// What lies on the surface: cuts, points, contours, numbers. SPDX-License-Identifier: Apache-2.0
import {
  BufferAttribute, BufferGeometry, CanvasTexture, Color, Group, type Object3D, Points as PointCloud, PointsMaterial,
} from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import type { Cut, Vec3 } from './protocol';

/** Ends of the pieces of a line, in pairs. */
export function pairsOf(points: Float32Array, closed: boolean): Float32Array {
  const count = points.length / 3;
  const pieces = Math.max(0, count - (closed ? 0 : 1));
  const out = new Float32Array(6 * pieces);
  for (let i = 0; i < pieces; ++i) {
    const next = (i + 1) % count;
    out.set(points.subarray(3 * i, 3 * i + 3), 6 * i);
    out.set(points.subarray(3 * next, 3 * next + 3), 6 * i + 3);
  }
  return out;
}

export interface Label {
  id: number;
  text: string;
  at: Vec3;
  strong: boolean;
}

export interface Dot {
  at: Vec3;
  colour: string;
}

export class Overlay {
  private readonly cuts = new Map<number, LineSegments2>();
  private readonly materials: Record<'cut' | 'selected' | 'contour' | 'chosen' | 'drag', LineMaterial>;
  private readonly group = new Group();
  private contours: LineSegments2[] = [];
  private drag: LineSegments2 | null = null;
  private dots: PointCloud | null = null;
  private handles: PointCloud | null = null;
  private readonly disc = discTexture();
  private labels: { element: HTMLElement; at: Vec3 }[] = [];

  constructor(
    root: Object3D,
    private readonly box: HTMLElement,
  ) {
    root.add(this.group);
    const line = (color: string, linewidth: number, opacity = 1) =>
      new LineMaterial({ color, linewidth, transparent: opacity < 1, opacity });
    this.materials = {
      cut: line('#23303d', 1.8),
      selected: line('#0b63c4', 3.2),
      contour: line('#1b1b1b', 1, 0.55),
      chosen: line('#0a0a0a', 3),
      drag: line('#0b63c4', 2),
    };
  }

  resize(width: number, height: number): void {
    for (const material of Object.values(this.materials)) material.resolution.set(width, height);
  }

  private lines(pairs: Float32Array, material: LineMaterial): LineSegments2 {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(pairs);
    const lines = new LineSegments2(geometry, material);
    lines.frustumCulled = false;
    this.group.add(lines);
    return lines;
  }

  private drop(object: LineSegments2 | PointCloud | null): void {
    if (!object) return;
    this.group.remove(object);
    object.geometry.dispose();
  }

  /** One of each kind that is drawn, apart from what is shown. */
  samples(): Object3D[] {
    const piece = new Float32Array(6);
    const kinds = [this.materials.cut, this.materials.contour].map((material) => {
      const lines = this.lines(piece, material);
      this.group.remove(lines);
      return lines;
    });
    const cloud = this.cloud([{ at: [0, 0, 0], colour: '#000000' }], 1);
    this.group.remove(cloud);
    return [...kinds, cloud];
  }

  setCut(cut: Cut): void {
    this.removeCut(cut.tooth);
    const pieces = cut.loops.map(({ points, closed }) => pairsOf(points, closed));
    const all = new Float32Array(pieces.reduce((n, p) => n + p.length, 0));
    let at = 0;
    for (const piece of pieces) {
      all.set(piece, at);
      at += piece.length;
    }
    if (all.length) this.cuts.set(cut.tooth, this.lines(all, this.materials.cut));
  }

  removeCut(tooth: number): void {
    this.drop(this.cuts.get(tooth) ?? null);
    this.cuts.delete(tooth);
  }

  /** Which cuts are seen, and which is the one worked on. */
  showCuts(visible: (tooth: number) => boolean, selected: number | null): void {
    for (const [tooth, lines] of this.cuts) {
      lines.visible = visible(tooth);
      lines.material = tooth === selected ? this.materials.selected : this.materials.cut;
    }
  }

  setContours(lines: Float32Array | null, chosen: Float32Array | null): void {
    this.contours.forEach((c) => this.drop(c));
    this.contours = [];
    if (lines?.length) this.contours.push(this.lines(lines, this.materials.contour));
    if (chosen?.length) this.contours.push(this.lines(chosen, this.materials.chosen));
  }

  /** Feature points; places relative to the centre. */
  setDots(dots: Dot[]): void {
    this.drop(this.dots);
    this.dots = dots.length ? this.cloud(dots, 11) : null;
  }

  /** Points of a cut that can be taken hold of. */
  setHandles(handles: Vec3[]): void {
    this.drop(this.handles);
    this.handles = handles.length ? this.cloud(handles.map((at) => ({ at, colour: '#ffffff' })), 9) : null;
  }

  /** From where a point was to where it is being taken; null: nothing is being dragged. */
  setDrag(from: Vec3 | null, to: Vec3 | null): void {
    this.drop(this.drag);
    this.drag = from && to ? this.lines(new Float32Array([...from, ...to]), this.materials.drag) : null;
    if (this.drag) this.drag.renderOrder = 10;
    this.materials.drag.depthTest = false;
  }

  private cloud(dots: Dot[], size: number): PointCloud {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(dots.flatMap((d) => d.at)), 3));
    const colours = dots.flatMap((d) => new Color(d.colour).toArray());
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
    const material = new PointsMaterial({
      size: size * Math.min(devicePixelRatio, 2), sizeAttenuation: false, vertexColors: true, map: this.disc, alphaTest: 0.4,
      // Half of a point would sink into the surface that it lies on.
      polygonOffset: true, depthFunc: 3,
    });
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace('#include <logdepthbuf_vertex>', 'gl_Position.z -= 0.002 * gl_Position.w;');
    };
    const cloud = new PointCloud(geometry, material);
    cloud.frustumCulled = false;
    this.group.add(cloud);
    return cloud;
  }

  setLabels(labels: Label[]): void {
    this.box.replaceChildren();
    this.labels = labels.map(({ text, at, strong }) => {
      const element = document.createElement('span');
      element.textContent = text;
      element.className = strong ? 'tag strong' : 'tag';
      this.box.append(element);
      return { element, at };
    });
  }

  placeLabels(toScreen: (p: Vec3) => { x: number; y: number }): void {
    for (const { element, at } of this.labels) {
      const { x, y } = toScreen(at);
      element.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }

  clear(): void {
    for (const tooth of [...this.cuts.keys()]) this.removeCut(tooth);
    this.setContours(null, null);
    this.setDots([]);
    this.setHandles([]);
    this.setDrag(null, null);
    this.setLabels([]);
  }
}

/** A disc with a dark rim, for points. */
function discTexture(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext('2d')!;
  pen.beginPath();
  pen.arc(32, 32, 27, 0, 2 * Math.PI);
  pen.fillStyle = '#fff';
  pen.fill();
  pen.lineWidth = 9;
  pen.strokeStyle = '#222';
  pen.stroke();
  return new CanvasTexture(canvas);
}
