// The stage: camera, light, what is drawn when. SPDX-License-Identifier: Apache-2.0
import { Group, Matrix4, PerspectiveCamera, Quaternion, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Opened, Vec3 } from './protocol';
import { Overlay } from './overlay';
import { Surface } from './surface';

/** Where the camera stands at first: above the front of the arch, this far from straight above, degrees. */
const TILT = 38;

export class View {
  readonly controls: OrbitControls;
  readonly overlay: Overlay;
  surface: Surface | null = null;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(28, 1, 1, 2000);
  /** From the scan's axes to ours: the biting surface looks up, the front of the arch to the viewer. */
  private readonly root = new Group();
  private centre: Vec3 = [0, 0, 0];
  private radius = 40;
  private drawing = false;
  private warm = false;

  constructor(
    readonly canvas: HTMLCanvasElement,
    labels: HTMLElement,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor(0, 0);
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV; // to ask waits for the compiler
    this.scene.add(this.root);
    this.overlay = new Overlay(this.root, labels);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.rotateSpeed = 0.9;
    this.controls.addEventListener('change', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    this.resize();
    void this.warmUp();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.overlay.resize(width, height);
    this.invalidate();
  }

  get ready(): boolean {
    return this.warm;
  }

  /** What was asked for is drawn: what tests wait for. */
  get drawn(): boolean {
    return this.warm && !this.drawing;
  }

  /** Draws anew with the next frame. */
  invalidate(): void {
    if (this.drawing || !this.warm) return;
    this.drawing = true;
    requestAnimationFrame(() => {
      this.drawing = false;
      this.renderer.render(this.scene, this.camera);
      this.overlay.placeLabels((p) => this.toScreen(p));
      if (this.surface?.grow()) this.invalidate();
    });
  }

  /** Has the shaders of all that is ever drawn compiled before there is a scan: later the compiler would hold up a frame. */
  private async warmUp(): Promise<void> {
    const [positions, normals] = [new Float32Array(9), new Int16Array(12)];
    const surface = new Surface({ faces: 1, positions, normals, centre: [0, 0, 0], radius: 1 });
    surface.setField(new Float32Array(3));
    surface.grow();
    const samples = new Group().add(surface.group, ...this.overlay.samples());
    this.scene.add(samples);
    // Some drivers never say that they are done, or only when they are asked for a picture.
    await Promise.race([this.renderer.compileAsync(this.scene, this.camera), new Promise((resolve) => setTimeout(resolve, 1500))]);
    this.renderer.render(this.scene, this.camera);
    // Kept, since a program goes with its last material; and out of sight.
    samples.visible = false;
    this.warm = true;
    this.invalidate();
  }

  show(opened: Opened): void {
    if (this.surface) {
      this.root.remove(this.surface.group);
      this.surface.dispose();
    }
    this.overlay.clear();
    this.surface = new Surface(opened.geometry);
    this.root.add(this.surface.group);
    this.surface.grow();
    this.centre = opened.geometry.centre;
    this.radius = opened.geometry.radius;
    const up = new Vector3(...opened.occlusal), front = new Vector3(...opened.front);
    const right = new Vector3().crossVectors(up, front).normalize();
    const axes = new Matrix4().makeBasis(right, up, new Vector3().crossVectors(right, up));
    this.root.quaternion.copy(new Quaternion().setFromRotationMatrix(axes).invert());
    this.root.updateMatrixWorld(true);
    this.home();
  }

  home(): void {
    const distance = (this.radius * 0.78) / Math.sin((this.camera.fov * Math.PI) / 360);
    const angle = (TILT * Math.PI) / 180;
    this.camera.position.set(0, Math.cos(angle) * distance, Math.sin(angle) * distance);
    this.camera.near = distance / 50;
    this.camera.far = distance * 4;
    this.camera.updateProjectionMatrix();
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.invalidate();
  }

  /** Turns the camera about the middle, degrees. */
  turn(sideways: number, upwards: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const polar = Math.acos(offset.y / offset.length());
    const to = Math.min(Math.PI - 0.05, Math.max(0.05, polar + (upwards * Math.PI) / 180));
    const around = Math.atan2(offset.x, offset.z) + (sideways * Math.PI) / 180;
    const length = offset.length();
    offset.set(Math.sin(to) * Math.sin(around), Math.cos(to), Math.sin(to) * Math.cos(around)).multiplyScalar(length);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.invalidate();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.controls.update();
    this.invalidate();
  }

  /** Relative to the centre, as what is drawn is. */
  local(place: Vec3): Vec3 {
    return place.map((x, k) => x - this.centre[k]) as Vec3;
  }

  /** A place relative to the centre, in pixels of the canvas, and how far behind the camera's plane it lies, mm. */
  toScreen(local: Vec3): { x: number; y: number; depth: number } {
    const world = this.root.localToWorld(new Vector3(...local));
    const depth = this.camera.position.distanceTo(world);
    const at = world.project(this.camera);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return { x: ((at.x + 1) / 2) * width, y: ((1 - at.y) / 2) * height, depth };
  }

  /** The ray through a pixel of the canvas, in the scan's axes. */
  ray(x: number, y: number): { origin: Vec3; direction: Vec3 } {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const at = new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2);
    const far = new Vector3(at.x, at.y, 0.5).unproject(this.camera);
    const origin = this.root.worldToLocal(this.camera.position.clone());
    const direction = this.root.worldToLocal(far).sub(origin).normalize();
    return { origin: origin.toArray().map((c, k) => c + this.centre[k]) as Vec3, direction: direction.toArray() as Vec3 };
  }
}
