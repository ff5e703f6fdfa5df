// Everything without a mouse. SPDX-License-Identifier: Apache-2.0
import type { App } from './app';
import { nameOf, type Tool } from './state';

const TOOLS: Tool[] = ['click', 'include', 'exclude', 'line', 'points'];

export function listenToKeys(app: App, actions: { help(): void; open(): void; theme(): void }): void {
  const { canvas } = app.view;
  window.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (target.closest('select, dialog')) return; // letters choose there
    if (handle(app, actions, event, target === canvas)) event.preventDefault();
  });
  canvas.addEventListener('blur', () => {
    app.state.walk = null;
    app.notify();
  });
}

/** True: the key meant something. */
function handle(app: App, actions: { help(): void; open(): void; theme(): void }, event: KeyboardEvent, onStage: boolean): boolean {
  const { key, shiftKey: shift } = event;
  const command = event.ctrlKey || event.metaKey;
  const lower = key.toLowerCase();
  if (command && lower === 'z') return done(shift ? app.redo() : app.undo());
  if (command && lower === 'y') return done(app.redo());
  if (command && lower === 'o') return done(actions.open());
  if (command && lower === 's') return done(app.exportFile('exportSession'));
  if (command || event.altKey) return false;
  if (onStage) {
    if (key === 'Tab') return walk(app, shift ? -1 : 1, false);
    if (key === 'ArrowRight' || key === 'ArrowLeft') {
      const by = key === 'ArrowRight' ? 1 : -1;
      return shift ? done(app.view.turn(15 * by, 0)) : walk(app, by, true);
    }
    if (key === 'ArrowUp' || key === 'ArrowDown') return done(app.view.turn(0, key === 'ArrowUp' ? -10 : 10));
    if (key === 'Enter') return press(app);
  }
  if (key === '?' || lower === 'h') return done(actions.help());
  if (key === '+' || key === '=') return done(app.view.zoom(1.2));
  if (key === '-') return done(app.view.zoom(1 / 1.2));
  if (key === '0' || key === 'Home') return done(app.view.home());
  if (lower === 'a') return done(app.segmentAll());
  if (lower === 'f') return done(app.toggleField());
  if (lower === 'g') return done(app.togglePoints());
  if (lower === 't') return done(actions.theme());
  if (key >= '1' && key <= '5') return done(app.setTool(TOOLS[Number(key) - 1]));
  if (key === 'Delete' || key === 'Backspace') return remove(app, shift);
  if (key === 'Escape') {
    app.setTool('click');
    app.select(null);
    return true;
  }
  return false;
}

function done(_: unknown): true {
  return true;
}

/** To the next tooth along the arch. Past the ends Tab goes on to the next control, and arrows go round. */
function walk(app: App, by: number, round: boolean): boolean {
  const { state } = app;
  const count = state.points?.groups.length ?? 0;
  if (count === 0) return false;
  let to = state.walk === null ? (by > 0 ? 0 : count - 1) : state.walk + by;
  if (to < 0 || to >= count) {
    if (!round) {
      state.walk = null;
      return false;
    }
    to = (to + count) % count;
  }
  state.walk = to;
  const { id } = state.points!.groups[to];
  const stands = state.now!.teeth.some((t) => t.id === id);
  if (stands) state.selected = id;
  app.say(`${nameOf(state, id)}, ${stands ? 'separated' : 'not separated; Enter separates it'}.`.replace(/^t/, 'T'));
  app.select(state.selected);
  return true;
}

/** A click on the tooth that the walk is at. */
function press(app: App): boolean {
  const { walk: at, points, tool } = app.state;
  if (at === null || !points) return false;
  const position = points.groups[at].at;
  void (tool === 'include' || tool === 'exclude' ? app.correct(tool, position) : app.click(position));
  return true;
}

function remove(app: App, whole: boolean): boolean {
  const { state } = app;
  const point = state.points?.points.find((p) => p.id === state.point);
  if (state.tool === 'points' && point) {
    if (whole) void app.removeGroupOfPoint();
    else void app.editPoints('removePoint', { point: point.id }, 'Removed the point.');
    return true;
  }
  if (state.selected === null) return false;
  void app.onTooth('remove', {}, 'Joined to the gum again:');
  return true;
}
