// What can be done on the page: each action is a request to the worker, and what comes of it. SPDX-License-Identifier: Apache-2.0
import { Client } from './client';
import { sentence } from './messages';
import type { Calls, Changed, File as OutFile, Op, Opened, Points, Reopened, Vec3 } from './protocol';
import { colourOf, nameOf, rgb, start, type State, type Tool } from './state';
import type { View } from './view';

export class App {
  readonly state: State = start();
  readonly client = new Client();
  private readonly listeners: (() => void)[] = [];
  /** Steps are worked off in their order. */
  private queue: Promise<unknown> = Promise.resolve();
  private waiting = 0;

  constructor(readonly view: View) {}

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  notify(): void {
    this.listeners.forEach((listener) => listener());
    this.view.invalidate();
  }

  say(text: string, bad = false): void {
    this.state.status = { text, bad };
  }

  /** Nothing runs, and nothing waits. */
  get idle(): boolean {
    return this.waiting === 0;
  }

  private run(work: () => Promise<void>): Promise<void> {
    ++this.waiting;
    const done = this.queue.then(work).catch((error) => this.say(sentence(error), true)).finally(() => {
      --this.waiting;
      this.state.progress = null;
      this.notify();
    });
    this.queue = done;
    return done;
  }

  private call<K extends Op>(op: K, input: Calls[K]['in'], transfer: Transferable[] = []): Promise<Calls[K]['out']> {
    const progress = (fraction: number, stage: string) => {
      this.state.progress = { fraction, stage };
      this.notify();
    };
    return this.client.call(op, input, progress, transfer);
  }

  // ----------------------------------------------------------------------------------------------------------- open

  /** The built-in arch. */
  openArch(triangles = 60000): Promise<void> {
    return this.open(() => this.call('openArch', { triangles }));
  }

  private open(take: () => Promise<Opened>): Promise<void> {
    return this.run(async () => {
      this.state.progress = { fraction: 0, stage: 'Reading the scan' };
      this.notify();
      await this.client.ready;
      const opened = await take();
      const { name, occlusal, front, warning, geometry } = opened;
      Object.assign(this.state, start(), { tool: this.state.tool });
      this.state.opened = { name, occlusal, front, warning, faces: geometry.faces, centre: geometry.centre, radius: geometry.radius };
      this.view.show(opened);
      this.reopened(opened);
      const { groups } = opened.points;
      this.say(warning ?? `${name}: ${groups.length} teeth found. Click one of them.`, warning !== null);
    });
  }

  openFile(file: File): Promise<void> {
    if (/\.json$/i.test(file.name)) return this.openSession(file);
    return this.open(async () => {
      const bytes = await file.arrayBuffer();
      return this.call('open', { name: file.name, bytes }, [bytes]);
    });
  }

  private openSession(file: File): Promise<void> {
    return this.run(async () => {
      if (!this.state.opened) throw new Error('Open the scan first, then its session: a session holds what was done, not the scan.');
      this.reopened(await this.call('openSession', { text: await file.text() }));
      this.say(`Session opened: ${this.state.now!.teeth.length} teeth.`);
    });
  }

  // ---------------------------------------------------------------------------------------------------------- steps

  private step<K extends Op>(op: K, input: Calls[K]['in'], said: (state: State, changed: Changed) => string): Promise<void> {
    return this.run(async () => {
      if (!this.state.opened) return;
      if (this.state.points?.edited && op !== 'undo' && op !== 'redo') this.reopened(await this.call('prepare', {}));
      const changed = (await this.call(op, input)) as Changed;
      if (changed.focus !== null) this.state.selected = changed.focus;
      this.changed(changed);
      this.say(said(this.state, changed));
      if (this.state.showField) await this.loadField();
    });
  }

  click(position: Vec3): Promise<void> {
    return this.step('click', { position }, (state, { focus, neighbour, ms }) => {
      const alone = neighbour === null || !state.now!.teeth.some((t) => t.id === neighbour);
      const what = alone ? nameOf(state, focus!) : `${nameOf(state, focus!)} and ${nameOf(state, neighbour!)}`;
      return `Separated ${what} in ${ms < 10 ? ms.toFixed(1) : Math.round(ms)} ms. ${this.left()}`;
    });
  }

  private left(): string {
    const { points, now } = this.state;
    const done = new Set(now!.teeth.map((t) => t.id));
    const left = points!.groups.filter((g) => !done.has(g.id)).length;
    return left === 0 ? 'All teeth are separated.' : `${left} left.`;
  }

  segmentAll(): Promise<void> {
    return this.step('segmentAll', {}, (state) => `${state.now!.teeth.length} teeth. ${this.left()}`);
  }

  /** "This too", or "not this": on the tooth that is selected. */
  correct(kind: 'include' | 'exclude', position: Vec3): Promise<void> {
    const tooth = this.needTooth();
    if (tooth === null) return Promise.resolve();
    return this.step(kind, { tooth, position }, (state) =>
      kind === 'include' ? `Added to ${nameOf(state, tooth)}.` : `Taken off ${nameOf(state, tooth)}.`);
  }

  dragCut(tooth: number, loop: number, point: number, to: Vec3): Promise<void> {
    return this.step('dragCut', { tooth, loop, point, to }, (state) => `Moved the line of ${nameOf(state, tooth)}.`);
  }

  /** A call on the tooth that is selected. */
  onTooth<K extends 'remove' | 'lock' | 'number' | 'offsetCut' | 'smoothCut' | 'resetCut'>(
    op: K,
    input: Omit<Calls[K]['in'], 'tooth'>,
    said: string,
    tooth = this.needTooth(),
  ): Promise<void> {
    if (tooth === null) return Promise.resolve();
    const name = nameOf(this.state, tooth);
    return this.step(op, { ...input, tooth } as Calls[K]['in'], () => `${said} ${name}.`);
  }

  /** The next click tells the rest. */
  startTask(task: 'split' | 'merge'): void {
    const tooth = this.needTooth();
    if (tooth === null) return;
    this.state.task = task;
    const name = nameOf(this.state, tooth);
    this.say(task === 'split' ? `Click the part of ${name} that is a tooth of its own.` : `Click the tooth that is one with ${name}.`);
    this.notify();
  }

  /** Does what `startTask` began. `other`: the tooth clicked. */
  finishTask(position: Vec3, other: number | null): Promise<void> {
    const { task, selected, now, points } = this.state;
    this.state.task = null;
    if (task === 'split') {
      // What stays is held by the feature point that is furthest from the part.
      const own = points!.points.filter((p) => p.group === selected).map((p) => p.position);
      const keep = own.length ? own.reduce((a, b) => (apart(b, position) > apart(a, position) ? b : a)) : now!.teeth.find((t) => t.id === selected)!.centre;
      return this.step('split', { tooth: selected!, keep, part: position }, (state) => `Split ${nameOf(state, selected!)}.`);
    }
    if (other === null || other === selected) {
      this.say('That is no other separated tooth.', true);
      this.notify();
      return Promise.resolve();
    }
    return this.step('merge', { tooth: selected!, other }, (state) => `One tooth now: ${nameOf(state, selected!)}.`);
  }

  undo(): Promise<void> {
    return this.step('undo', {}, () => 'Taken back.');
  }

  redo(): Promise<void> {
    return this.step('redo', {}, () => 'Brought again.');
  }

  private needTooth(): number | null {
    const { selected, now } = this.state;
    if (selected !== null && now?.teeth.some((t) => t.id === selected)) return selected;
    this.say('Select a separated tooth first: click it in the list.', true);
    this.notify();
    return null;
  }

  // --------------------------------------------------------------------------------------------------------- points

  editPoints<K extends 'addPoint' | 'movePoint' | 'removePoint' | 'removeGroup' | 'setGroup'>(
    op: K,
    input: Calls[K]['in'],
    said: string,
  ): Promise<void> {
    return this.run(async () => {
      this.takePoints((await this.call(op, input)) as Points);
      this.state.point = null;
      this.say(`${said} The next click uses it.`);
    });
  }

  removeGroupOfPoint(): Promise<void> {
    const { group } = this.state.points!.points.find((p) => p.id === this.state.point)!;
    return this.editPoints('removeGroup', { group }, 'Removed the points of the tooth.');
  }

  choosePoint(point: number): void {
    this.state.point = point;
    this.refresh();
    this.notify();
  }

  prepare(): Promise<void> {
    return this.run(async () => {
      const reopened = await this.call('prepare', {});
      this.reopened(reopened);
      this.say(reopened.failed ? `Prepared anew; ${reopened.failed} of the clicks could not be repeated.` : 'Prepared anew; clicks are repeated.');
    });
  }

  // ---------------------------------------------------------------------------------------------------------- looks

  select(tooth: number | null): void {
    this.state.selected = tooth;
    this.state.task = null;
    this.refresh();
    if (this.state.showField) void this.run(() => this.loadField());
    this.notify();
  }

  setTool(tool: Tool): void {
    this.state.tool = tool;
    this.state.task = null;
    this.state.point = null;
    if (tool === 'points') this.state.showPoints = true;
    this.refresh();
    this.notify();
  }

  setVisible(tooth: number, visible: boolean): void {
    if (visible) this.state.hidden.delete(tooth);
    else this.state.hidden.add(tooth);
    this.refresh();
    this.notify();
  }

  setColour(label: number, colour: string): void {
    this.state.colours.set(label, colour);
    this.refresh();
    this.notify();
  }

  toggleField(): Promise<void> {
    this.state.showField = !this.state.showField;
    return this.run(() => this.loadField());
  }

  togglePoints(): void {
    this.state.showPoints = !this.state.showPoints;
    this.refresh();
    this.notify();
  }

  /** The field of the click that separated the tooth selected, or of the last one. */
  private async loadField(): Promise<void> {
    const { showField, now, selected } = this.state;
    this.state.field = null;
    if (showField && now && now.clicks > 0) {
      const click = now.teeth.find((t) => t.id === selected)?.click ?? now.clicks - 1;
      this.state.field = await this.call('field', { click: Math.min(click, now.clicks - 1) });
    }
    const { field } = this.state;
    this.view.surface?.setField(field ? field.values : null);
    this.view.overlay.setContours(field ? field.lines : null, field ? field.chosen : null);
    this.refresh();
  }

  // -------------------------------------------------------------------------------------------------------- exports

  exportFile(op: 'exportTeeth' | 'exportPly' | 'exportSession'): Promise<void> {
    return this.run(async () => {
      const { closed, now } = this.state;
      if (op !== 'exportSession' && !now?.teeth.length) throw new Error('Separate a tooth first: there is nothing to export.');
      const colours = Array.from({ length: 256 }, (_, label) => rgb(colourOf(this.state, label)));
      const file: OutFile = op === 'exportTeeth' ? await this.call(op, { closed })
        : op === 'exportPly' ? await this.call(op, { colours }) : await this.call(op, {});
      const link = document.createElement('a');
      link.href = URL.createObjectURL(new Blob([file.bytes], { type: file.type }));
      link.download = file.name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
      this.say(`Saved ${file.name}.`);
    });
  }

  // ---------------------------------------------------------------------------------------------- what came of them

  private reopened(reopened: Reopened): void {
    this.takePoints(reopened.points);
    this.changed(reopened, true);
  }

  private takePoints(points: Points): void {
    this.state.points = points;
    this.view.surface?.setTerritory(points.territory);
    this.refresh();
  }

  private changed(changed: Changed, all = false): void {
    const { state, view } = this;
    const before = all ? (state.now?.teeth ?? []) : (state.now?.teeth ?? []).filter((t) => !changed.teeth.some((u) => u.id === t.id));
    before.forEach((t) => view.overlay.removeCut(t.id));
    state.now = changed;
    this.cuts = new Map([...this.cuts].filter(([id]) => !all && changed.teeth.some((t) => t.id === id)));
    for (const cut of changed.cuts) {
      this.cuts.set(cut.tooth, cut);
      view.overlay.setCut(cut);
    }
    if (state.selected !== null && !changed.teeth.some((t) => t.id === state.selected)) state.selected = null;
    view.surface?.setLabels(changed.labels);
    this.refresh();
  }

  /** The cuts of the teeth that stand, by tooth. */
  cuts = new Map<number, Changed['cuts'][number]>();

  /** Brings what is drawn into line with the state. */
  private refresh(): void {
    const { state, view } = this;
    const { now, points } = state;
    if (!now || !points || !state.opened) return;
    const colours: ([number, number, number] | null)[] = Array.from({ length: 256 }, (_, label) => rgb(colourOf(state, label)));
    for (const tooth of now.teeth) if (state.hidden.has(tooth.id)) colours[tooth.label] = null;
    view.surface?.setPalette(colours);
    view.overlay.showCuts((tooth) => !state.hidden.has(tooth) && !state.field, state.selected);
    const up = state.opened.occlusal;
    view.overlay.setLabels(state.field ? [] : now.teeth.filter((t) => !state.hidden.has(t.id)).map((t) => ({
      id: t.id,
      text: t.fdi ? String(t.fdi) : `no. ${t.label}`,
      at: view.local(t.centre.map((x, k) => x + 5 * up[k]) as Vec3),
      strong: t.id === state.selected,
    })));
    const place = new Map(points.groups.map((g, i) => [g.id, i + 1]));
    view.overlay.setDots(!state.showPoints ? [] : points.points.map((p) => ({
      at: view.local(p.position),
      colour: p.id === state.point ? '#ffffff' : colourOf(state, place.get(p.group)!),
    })));
    view.overlay.setHandles(state.tool === 'line' && state.selected !== null ? this.handles(state.selected) : []);
  }

  /** Points of a cut about 1.2 mm apart, relative to the centre. */
  private handles(tooth: number): Vec3[] {
    const out: Vec3[] = [];
    for (const { points } of this.cuts.get(tooth)?.loops ?? []) {
      let last: Vec3 | null = null;
      for (let i = 0; i < points.length; i += 3) {
        const at: Vec3 = [points[i], points[i + 1], points[i + 2]];
        if (last && apart(at, last) < 1.2) continue;
        out.push(at);
        last = at;
      }
    }
    return out;
  }
}

const apart = (a: Vec3, b: Vec3): number => Math.hypot(...a.map((x, k) => x - b[k]));
