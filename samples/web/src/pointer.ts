// Mouse and pen on the stage: what lies under the cursor, clicks, drags of a cut's or a feature's point.
// SPDX-License-Identifier: Apache-2.0
import type { App } from './app';
import { sentence } from './messages';
import type { Pick, Vec3 } from './protocol';
import { nameOf, placeName } from './state';

/** A press that moved less than this, in pixels, is a click. */
const STILL = 4;
/** So near, in pixels, a point is taken hold of. */
const GRAB = 11;

type Grip =
  | { kind: 'cut'; tooth: number; loop: number; point: number; from: Vec3 }
  | { kind: 'feature'; point: number; from: Vec3 };

export class Pointer {
  private pressed: { x: number; y: number; grip: Grip | null; moved: boolean } | null = null;
  private asked: { x: number; y: number } | null = null;
  private asking = false;

  constructor(private readonly app: App) {
    const { canvas } = app.view;
    // Before the camera's own listeners, which come later in the same phase: a grip keeps the camera still.
    canvas.addEventListener('pointerdown', (event) => this.down(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => void this.up(event).catch((error) => this.fail(error)), { capture: true });
    canvas.addEventListener('pointercancel', () => this.release());
    canvas.addEventListener('pointerleave', () => this.setHover(null));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  private at(event: PointerEvent): { x: number; y: number } {
    const box = this.app.view.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || !this.app.state.opened) return;
    const at = this.at(event);
    const grip = event.shiftKey ? null : this.gripAt(at.x, at.y);
    this.pressed = { ...at, grip, moved: false };
    if (!grip) return;
    this.app.view.controls.enabled = false;
    this.app.view.canvas.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const at = this.at(event);
    const { pressed } = this;
    if (pressed && Math.hypot(at.x - pressed.x, at.y - pressed.y) > STILL) pressed.moved = true;
    if (pressed?.moved && !pressed.grip) return; // the camera turns
    this.app.view.canvas.dataset.grip = pressed?.grip || (!pressed && this.gripAt(at.x, at.y)) ? 'yes' : 'no';
    this.ask(at.x, at.y);
  }

  private async up(event: PointerEvent): Promise<void> {
    const { pressed } = this;
    if (event.button !== 0 || !pressed) return;
    this.release();
    const at = this.at(event);
    if (pressed.grip && pressed.moved) return this.drop(pressed.grip, await this.pick(at.x, at.y));
    if (!pressed.moved) await this.click(await this.pick(at.x, at.y), event, pressed.grip);
  }

  private fail(error: unknown): void {
    this.app.say(sentence(error), true);
    this.app.notify();
  }

  private release(): void {
    this.pressed = null;
    this.app.view.controls.enabled = true;
    this.app.view.overlay.setDrag(null, null);
    this.app.view.invalidate();
  }

  private pick(x: number, y: number): Promise<Pick | null> {
    return this.app.client.call('pick', this.app.view.ray(x, y));
  }

  /** Asks what lies under the cursor, one question at a time; of those that come meanwhile the last one counts. */
  private ask(x: number, y: number): void {
    this.asked = { x, y };
    if (this.asking || !this.app.state.opened) return;
    this.asking = true;
    const next = async () => {
      while (this.asked) {
        const at = this.asked;
        this.asked = null;
        this.setHover(await this.pick(at.x, at.y));
      }
    };
    next().catch(() => this.setHover(null)).finally(() => (this.asking = false));
  }

  private setHover(pick: Pick | null): void {
    const { app, pressed } = this;
    app.state.hover = pick;
    if (pressed?.grip && pressed.moved && pick) app.view.overlay.setDrag(app.view.local(pressed.grip.from), app.view.local(pick.position));
    app.notify();
  }

  private async click(pick: Pick | null, event: PointerEvent, grip: Grip | null): Promise<void> {
    const { app } = this;
    const { state } = app;
    if (grip?.kind === 'feature') {
      return app.choosePoint(grip.point);
    }
    if (!pick) return;
    if (state.tool === 'points') return this.addPoint(pick, event.altKey);
    const label = labelAt(app, pick);
    const own = state.now!.teeth.find((t) => t.label === label && label !== 0);
    if (state.task) return app.finishTask(pick.position, own?.id ?? null);
    if (state.tool === 'include' || state.tool === 'exclude') return app.correct(state.tool, pick.position);
    // On the tooth itself it means "not this", beside it "this too".
    if (event.shiftKey) return app.correct(own && own.id === state.selected ? 'exclude' : 'include', pick.position);
    if (state.tool === 'line' && own) return app.select(own.id);
    await app.click(pick.position);
  }

  private addPoint(pick: Pick, alone: boolean): Promise<void> {
    const { app } = this;
    const group = alone || pick.group === 0 ? null : app.state.points!.groups[pick.group - 1].id;
    const to = group === null ? 'a tooth of its own' : nameOf(app.state, group);
    return app.editPoints('addPoint', { position: pick.position, group }, `Added a point to ${to}.`);
  }

  private async drop(grip: Grip, pick: Pick | null): Promise<void> {
    if (!pick) return;
    if (grip.kind === 'cut') return this.app.dragCut(grip.tooth, grip.loop, grip.point, pick.position);
    await this.app.editPoints('movePoint', { point: grip.point, position: pick.position }, 'Moved the point.');
  }

  /** What lies within reach of the cursor: of what is so near on the screen, the one nearest to the camera decides how deep to
   *  look, so that nothing behind the tooth is taken hold of. */
  private gripAt(x: number, y: number): Grip | null {
    const { state, view, cuts } = this.app;
    let found: { grip: () => Grip; far: number; depth: number }[] = [];
    const look = (local: Vec3, grip: () => Grip) => {
      const at = view.toScreen(local);
      const far = Math.hypot(at.x - x, at.y - y);
      if (far <= GRAB) found.push({ grip, far, depth: at.depth });
    };
    const scan = (p: Vec3): Vec3 => p.map((c, k) => c + state.opened!.centre[k]) as Vec3;
    if (state.tool === 'line' && state.selected !== null)
      cuts.get(state.selected)?.loops.forEach(({ points }, loop) => {
        for (let i = 0; i < points.length; i += 3) {
          const p: Vec3 = [points[i], points[i + 1], points[i + 2]];
          look(p, () => ({ kind: 'cut', tooth: state.selected!, loop, point: i / 3, from: scan(p) }));
        }
      });
    if (state.tool === 'points')
      for (const p of state.points?.points ?? []) look(view.local(p.position), () => ({ kind: 'feature', point: p.id, from: p.position }));
    if (found.length === 0) return null;
    const front = Math.min(...found.map((f) => f.depth));
    found = found.filter((f) => f.depth < front + 3);
    return found.reduce((a, b) => (b.far < a.far ? b : a)).grip();
  }
}

/** Label of the face under the cursor. */
export const labelAt = (app: App, pick: Pick): number => app.state.now!.labels[pick.face];

/** What a click here would do, as a sentence. */
export function hintOf(app: App): string {
  const { state } = app;
  const { hover, tool, selected } = state;
  if (!state.opened) return '';
  const own = selected === null ? null : nameOf(state, selected);
  if (state.task === 'split') return `Click the part of ${own} that is a tooth of its own. Esc: leave it.`;
  if (state.task === 'merge') return `Click the tooth that is one with ${own}. Esc: leave it.`;
  if (tool === 'points') return 'Click: a point for this tooth. Alt-click: for a tooth of its own. Drag a point to move it, Delete removes it.';
  if (tool === 'line')
    return own ? `Drag a white point of the line of ${own}. Click another tooth to select it.` : 'Click a separated tooth to work on its line.';
  if (tool === 'include') return own ? `Click what belongs to ${own} too.` : 'Select a tooth first.';
  if (tool === 'exclude') return own ? `Click what does not belong to ${own}.` : 'Select a tooth first.';
  if (!hover) return '';
  const label = labelAt(app, hover);
  const tooth = state.now!.teeth.find((t) => t.label === label && label !== 0);
  const shift = own ? `. Shift-click: ${tooth?.id === selected ? 'not part of' : 'this belongs to'} ${own}` : '';
  if (tooth) return `Click: ${nameOf(state, tooth.id)} again${shift}`;
  if (hover.group === 0) return `Gum${shift}`;
  const beside = hover.neighbour ? ` and ${placeName(state, hover.neighbour)}` : '';
  return `Click: ${placeName(state, hover.group)}${beside}${shift}`;
}
