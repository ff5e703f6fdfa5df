// Answers the page's requests by calls of the library. SPDX-License-Identifier: Apache-2.0
//
// Knows nothing of the browser, nor of the worker that it runs in.
import type { Context, Features, Model, Segmentation } from 'toothseg-wasm';
import type { Calls, Changed, Message, Op, Opened, Points, Reopened, Request, Vec3 } from '../protocol';
import { fieldOf } from './field';
import { ply, stl, zip } from './files';
import { Scan, fdiOf, stateOf, type Api } from './scene';
import { Steps } from './steps';

type Tell = (fraction: number, stage: string) => void;

/** The stages of opening and their shares of the time. */
const STAGES = { read: [0, 0.15], features: [0.15, 0.4], prepare: [0.4, 0.9], draw: [0.9, 1] } as const;
const STAGE_TEXT = { read: 'Reading the scan', features: 'Looking for teeth', prepare: 'Preparing', draw: 'Drawing' };

export class Engine {
  private context: Context;
  private scan: Scan | null = null;
  private features: Features | null = null;
  private segmentation: Segmentation | null = null;
  private steps: Steps | null = null;
  private edited = false;

  constructor(private readonly api: Api) {
    this.context = new api.Context({ threads: 1 });
  }

  /** Answers one request. What is to be transferred is found by `buffersOf`. */
  answer(request: Request, post: (message: Message) => void): void {
    const { id } = request;
    let last = 0;
    const tell: Tell = (fraction, stage) => {
      const now = performance.now();
      if (fraction < 1 && now - last < 30) return;
      last = now;
      post({ id, kind: 'progress', fraction, stage });
    };
    try {
      const handlers = this.handlers as { [K in Op]: (input: Calls[K]['in'], tell: Tell) => Calls[K]['out'] };
      const handler = handlers[request.op] as (input: unknown, tell: Tell) => unknown;
      post({ id, kind: 'reply', out: handler(request.in, tell) });
    } catch (error) {
      const status = error instanceof this.api.ToothsegError ? error.status : 0;
      post({ id, kind: 'failure', status, message: error instanceof Error ? error.message : String(error) });
    }
  }

  private readonly handlers: { [K in Op]: (input: Calls[K]['in'], tell: Tell) => Calls[K]['out'] } = {
    open: ({ name, bytes }, tell) =>
      this.open(name, (onProgress) => this.api.Model.readSync(this.context, new Uint8Array(bytes), { onProgress }), tell),
    openArch: ({ triangles }, tell) =>
      this.open('arch', (onProgress) => {
        const arch = this.api.makeArch({ jaw: 2, triangles, seed: 1 });
        return this.api.Model.createSync(this.context, arch, { onProgress });
      }, tell),
    openSession: ({ text }, tell) => this.openSession(text, tell),
    pick: ({ origin, direction }) => this.pick(origin, direction),
    click: ({ position }) => this.click(position),
    segmentAll: (_, tell) =>
      this.change((s) => s.segmentAllSync({ onProgress: (fraction) => tell(fraction, 'Separating all teeth') })),
    include: ({ tooth, position }) => this.change((s) => s.includePointSync(tooth, position), tooth),
    exclude: ({ tooth, position }) => this.change((s) => s.excludePointSync(tooth, position), tooth),
    split: ({ tooth, keep, part }) => this.change((s) => void s.splitToothSync(tooth, keep, part), tooth),
    merge: ({ tooth, other }) => this.change((s) => s.mergeTeethSync(tooth, other), tooth),
    remove: ({ tooth }) => this.change((s) => s.removeTooth(tooth)),
    lock: ({ tooth, locked }) => this.change((s) => s.setLocked(tooth, locked), tooth),
    number: ({ tooth, fdi }) => this.change((s) => s.setNumber(tooth, fdi), tooth),
    dragCut: ({ tooth, loop, point, to }) => this.change((s) => s.dragCutSync(tooth, loop, point, to), tooth),
    offsetCut: ({ tooth, mm }) => this.change((s) => s.offsetCutSync(tooth, mm), tooth),
    smoothCut: ({ tooth, strength }) => this.change((s) => s.smoothCutSync(tooth, strength), tooth),
    resetCut: ({ tooth }) => this.change((s) => s.resetCut(tooth), tooth),
    undo: () => this.state(this.open_.steps.undo()),
    redo: () => this.state(this.open_.steps.redo()),
    field: ({ click }) => {
      const { scan, segmentation } = this.open_;
      return fieldOf(segmentation, click, scan.triangles, scan.centre, this.api.NONE);
    },
    addPoint: ({ position, group }) => this.edit((f) => void f.addPoint(position, group ?? undefined)),
    movePoint: ({ point, position }) => this.edit((f) => f.movePoint(point, position)),
    removePoint: ({ point }) => this.edit((f) => f.removePoint(point)),
    removeGroup: ({ group }) => this.edit((f) => f.removeGroup(group)),
    setGroup: ({ point, group }) => this.edit((f) => void f.setGroup(point, group ?? undefined)),
    prepare: (_, tell) => this.prepare(tell),
    exportTeeth: ({ closed }, tell) => this.exportTeeth(closed, tell),
    exportPly: ({ colours }) => {
      const { scan, segmentation } = this.open_;
      const bytes = ply(scan.model.positions(), scan.triangles, scan.labels(segmentation), colours);
      return { name: `${this.stem}_teeth.ply`, type: 'application/octet-stream', bytes: bytes.buffer };
    },
    exportSession: () => {
      const bytes = new TextEncoder().encode(this.open_.segmentation.writeSession());
      return { name: `${this.stem}.toothseg.json`, type: 'application/json', bytes: bytes.buffer as ArrayBuffer };
    },
  };

  /** What is open; asked for only when something is. */
  private get open_() {
    const { scan, features, segmentation, steps } = this;
    if (!scan || !features || !segmentation || !steps) throw new Error('No scan is open.');
    return { scan, features, segmentation, steps };
  }

  private get stem(): string {
    return this.open_.scan.name.replace(/\.[^.]*$/, '') || 'scan';
  }

  private open(name: string, take: (onProgress: (fraction: number) => void) => Model, tell: Tell): Opened {
    const stage = (which: keyof typeof STAGES) => (fraction: number) => {
      const [from, to] = STAGES[which];
      tell(from + fraction * (to - from), STAGE_TEXT[which]);
    };
    const { Features, Segmentation } = this.api;
    stage('read')(0);
    const model = take(stage('read'));
    let features: Features | null = null, segmentation: Segmentation | null = null;
    let scan: Scan;
    try {
      features = Features.detectSync(model, { onProgress: stage('features') });
      segmentation = Segmentation.createSync(features, { onProgress: stage('prepare') });
      stage('draw')(0);
      scan = new Scan(name, model, features.info().insideOut);
    } catch (error) {
      for (const made of [segmentation, features, model]) made?.dispose();
      throw error; // what was open before stays
    }
    this.dispose();
    this.scan = scan;
    this.take(features, segmentation);
    const occlusal = features.occlusal();
    return {
      ...this.reopened(0),
      name,
      geometry: scan.giveGeometry(),
      occlusal,
      front: this.front(occlusal),
      warning: this.warning(features.info().warnings),
    };
  }

  /** From the middle between the ends of the arch curve to its middle, at right angles to `occlusal`. */
  private front(occlusal: Vec3): Vec3 {
    const arch = this.open_.features.arch();
    const at = (i: number) => [0, 1, 2].map((k) => arch[3 * i + k]);
    const last = arch.length / 3 - 1;
    if (last < 2) return Math.abs(occlusal[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
    const [a, b, m] = [at(0), at(last), at(Math.round(last / 2))];
    const v = [0, 1, 2].map((k) => m[k] - (a[k] + b[k]) / 2);
    const up = v.reduce((sum, x, k) => sum + x * occlusal[k], 0);
    const flat = v.map((x, k) => x - up * occlusal[k]);
    const length = Math.hypot(...flat) || 1;
    return flat.map((x) => x / length) as Vec3;
  }

  private warning(warnings: number): string | null {
    const { FeaturesWarning } = this.api;
    if (warnings & FeaturesWarning.OPPOSED) return 'Teeth look both ways: this seems to be two jaws in one file. Open one jaw at a time.';
    if (warnings & FeaturesWarning.SEVERAL_ARCHES)
      return 'There seems to be more than one arch in this file. Open one jaw at a time.';
    return null;
  }

  private take(features: Features, segmentation: Segmentation): void {
    if (this.features !== features) this.features?.dispose();
    this.segmentation?.dispose();
    this.features = features;
    this.segmentation = segmentation;
    if (segmentation.history().undo === 0) this.assignNumbers(segmentation);
    this.steps = new Steps(segmentation);
    this.edited = false;
  }

  private dispose(): void {
    for (const object of [this.segmentation, this.features, this.scan?.model]) object?.dispose();
    this.segmentation = this.features = this.scan = this.steps = null;
  }

  private pick(origin: Vec3, direction: Vec3) {
    const { scan, features } = this.open_;
    try {
      const { position, face } = scan.model.raycast(origin, direction);
      return { position, face, ...this.preview(features, face, position) };
    } catch (error) {
      if (error instanceof this.api.ToothsegError && error.status === this.api.Status.E_NOT_FOUND) return null;
      throw error;
    }
  }

  private points_: Points | null = null;

  private preview(features: Features, face: number, position: Vec3): { group: number; neighbour: number } {
    const place = this.points_?.territory[face] ?? 0;
    if (place === 0) return { group: 0, neighbour: 0 };
    const groups = features.groups();
    const own = groups[place - 1];
    // The tooth beside it that is nearer to the place clicked; one that is separated is passed over where the other is not.
    return { group: place, neighbour: neighbourOf(groups, own, this.open_.segmentation.teeth(), position, this.api.NONE) };
  }

  private click(position: Vec3): Changed {
    const { segmentation } = this.open_;
    let click = 0;
    const changed = this.change((s) => void (click = s.clickSync(position)));
    const { target, neighbour } = segmentation.clickInfo(click);
    return { ...changed, focus: target, neighbour: neighbour === this.api.NONE ? null : neighbour };
  }

  /** A step, with the numbers that follow from it. */
  private change(work: (segmentation: Segmentation) => void, focus: number | null = null): Changed {
    const { segmentation, steps } = this.open_;
    let changed: number[] = [], ms = 0;
    steps.run(() => {
      const start = performance.now();
      work(segmentation);
      ms = performance.now() - start;
      changed = segmentation.changes();
      this.assignNumbers(segmentation);
    });
    return { ...this.state(changed), focus, ms };
  }

  private assignNumbers(segmentation: Segmentation): void {
    try {
      segmentation.assignNumbers();
    } catch (error) {
      // More teeth than a jaw has, or numbers set by hand that fit none: the teeth stand all the same, numbered as before.
      if (!(error instanceof this.api.NumberError)) throw error;
    }
  }

  private state(changed: number[]): Changed {
    const { scan, features, segmentation, steps } = this.open_;
    const state = stateOf(scan, segmentation, features.groups().map((g) => g.id), changed);
    return { ...state, undo: steps.canUndo, redo: steps.canRedo };
  }

  private points(): Points {
    const { scan, features, segmentation } = this.open_;
    const points = scan.points(features, this.edited, (group) => fdiOf(segmentation, group));
    this.points_ = { ...points, territory: points.territory.slice() }; // the other one is transferred
    return points;
  }

  private reopened(failed: number): Reopened {
    const { segmentation } = this.open_;
    return { ...this.state(segmentation.teeth()), points: this.points(), failed };
  }

  private edit(work: (features: Features) => void): Points {
    work(this.open_.features);
    this.edited = true;
    return this.points();
  }

  private prepare(tell: Tell): Reopened {
    const { features, segmentation } = this.open_;
    const clicks = Array.from({ length: segmentation.clickCount() }, (_, i) => segmentation.clickInfo(i).position);
    const onProgress = (fraction: number) => tell(fraction, STAGE_TEXT.prepare);
    const made = this.api.Segmentation.createSync(features, { onProgress });
    this.take(features, made);
    let failed = 0;
    for (const position of clicks) {
      try {
        this.change((s) => void s.clickSync(position));
      } catch (error) {
        if (!(error instanceof this.api.SegmentationError)) throw error;
        ++failed; // a point that was taken away may leave nothing to click
      }
    }
    return this.reopened(failed);
  }

  private openSession(text: string, tell: Tell): Reopened {
    const onProgress = (fraction: number) => tell(fraction, 'Repeating the session');
    const { features, segmentation } = this.api.Segmentation.readSessionSync(this.open_.scan.model, text, { onProgress });
    this.take(features, segmentation);
    return this.reopened(0);
  }

  private exportTeeth(closed: boolean, tell: Tell) {
    const { segmentation } = this.open_;
    const teeth = segmentation.teeth();
    const files = teeth.map((id, i) => {
      tell(i / teeth.length, 'Making the teeth');
      const mesh = segmentation.toothMeshSync(id, { closed });
      const fdi = fdiOf(segmentation, id);
      const name = fdi ? `tooth_${fdi}` : `tooth_label_${segmentation.tooth(id).label}`;
      const bytes = stl(mesh.positions(), mesh.triangles(), name);
      mesh.dispose();
      return { name: `${name}.stl`, bytes };
    });
    return { name: `${this.stem}_teeth.zip`, type: 'application/zip', bytes: zip(files).buffer };
  }
}

/** Place, from 1, of the tooth that a click would separate beside its own; 0: none. */
function neighbourOf(
  groups: { id: number; previous: number; next: number; centre: Vec3 }[],
  own: { id: number; previous: number; next: number },
  teeth: number[],
  position: Vec3,
  none: number,
): number {
  const place = (id: number) => (id === none ? 0 : groups.findIndex((g) => g.id === id) + 1);
  const far = (p: number) => Math.hypot(...groups[p - 1].centre.map((x, k) => x - position[k]));
  const done = new Set(teeth);
  return [place(own.previous), place(own.next)]
    .filter((p) => p > 0)
    .sort((a, b) => Number(done.has(groups[a - 1].id)) - Number(done.has(groups[b - 1].id)) || far(a) - far(b))[0] ?? 0;
}

/** The buffers in a message, which are transferred to the other side. */
export function buffersOf(value: unknown, found: Set<ArrayBuffer> = new Set()): Set<ArrayBuffer> {
  if (value instanceof ArrayBuffer) found.add(value);
  else if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (value && typeof value === 'object') for (const part of Object.values(value)) buffersOf(part, found);
  return found;
}
