// Puts the page together. SPDX-License-Identifier: Apache-2.0
import { App } from './app';
import { listenToKeys } from './keys';
import { Pointer, hintOf, labelAt } from './pointer';
import type { Vec3 } from './protocol';
import { h } from './ui/dom';
import { buildField } from './ui/field';
import { buildHelp } from './ui/help';
import { applyTheme, switchTheme } from './ui/theme';
import { buildTeeth } from './ui/teeth';
import { buildTools } from './ui/tools';
import { View } from './view';

const get = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;

applyTheme();
const canvas = get<HTMLCanvasElement>('canvas');
const app = new App(new View(canvas, get('tags')));
new Pointer(app);

// ---------------------------------------------------------------------------------------------------------- what to open
const file = get<HTMLInputElement>('file');
const open = () => file.click();
file.addEventListener('change', () => {
  if (file.files?.[0]) void app.openFile(file.files[0]);
  file.value = '';
});
const openArch = () => app.openArch();
window.addEventListener('dragover', (event) => {
  event.preventDefault();
  document.body.classList.add('dropping');
});
window.addEventListener('dragleave', (event) => {
  if (!event.relatedTarget) document.body.classList.remove('dropping');
});
window.addEventListener('drop', (event) => {
  event.preventDefault();
  document.body.classList.remove('dropping');
  const dropped = event.dataTransfer?.files[0];
  if (dropped) void app.openFile(dropped);
});

// ------------------------------------------------------------------------------------------------------------- the page
const help = buildHelp(get<HTMLDialogElement>('help'));
const actions = { open, arch: openArch, help: help.show, theme: switchTheme };
const updates = [
  buildTools(get('tools'), app, actions), buildTeeth(get('teeth'), app), buildField(get('field'), app), update(),
];
get('start').append(
  h('h2', {}, 'Drop a scan here'),
  h('p', {}, 'One jaw, in millimetres: STL, PLY, OBJ or OFF.'),
  h('div', { class: 'row' },
    h('button', { type: 'button', class: 'main', onclick: open }, 'Choose a file…'),
    h('button', { type: 'button', onclick: () => void openArch() }, 'Try the built-in arch')),
  h('p', { class: 'quiet' }, 'The scan never leaves this browser. Nothing is uploaded.'));
app.onChange(() => updates.forEach((run) => run()));
listenToKeys(app, actions);
let libraryReady = false;
app.client.ready.then(() => (libraryReady = true)).catch(() => {
  app.say('This browser cannot run the viewer: it needs WebAssembly and Web Workers.', true);
  app.notify();
});
app.notify();

/** The stage's own texts, and what the surface shows under the cursor. */
function update(): () => void {
  const [start, progress, hint, status] = [get('start'), get('progress'), get('hint'), get('status')];
  return () => {
    const { state } = app;
    start.hidden = state.opened !== null || state.progress !== null;
    progress.hidden = state.progress === null;
    if (state.progress) {
      const percent = Math.round(100 * state.progress.fraction);
      progress.setAttribute('aria-valuenow', String(percent));
      progress.querySelector('span')!.textContent = `${state.progress.stage}: ${percent} %`;
      progress.querySelector('i')!.style.width = `${percent}%`;
    }
    hint.textContent = hintOf(app);
    if (status.textContent !== state.status.text) status.textContent = state.status.text;
    status.className = state.status.bad ? 'bad' : '';
    const { hover, walk, now, tool } = state;
    const group = walk !== null ? state.points?.groups[walk] : undefined;
    const tooth = group && now?.teeth.find((t) => t.id === group.id);
    if (group) app.view.surface?.hint(walk! + 1, 0, tooth?.label ?? 0);
    else if (hover && now && tool !== 'points') {
      const label = labelAt(app, hover);
      app.view.surface?.hint(label ? 0 : hover.group, label ? 0 : hover.neighbour, label);
    }
    else app.view.surface?.hint(0, 0, 0);
  };
}

// What scripts and tests need to know of the page: where a place of the scan is on the screen, and how things stand.
declare global {
  interface Window {
    viewer: unknown;
  }
}
window.viewer = {
  state: app.state,
  openArch: (triangles: number) => app.openArch(triangles),
  cuts: () => app.cuts,
  idle: () => app.idle,
  ready: () => app.view.ready && libraryReady,
  drawn: () => app.view.drawn,
  toScreen: (place: Vec3) => {
    const { x, y } = app.view.toScreen(app.view.local(place));
    const box = canvas.getBoundingClientRect();
    return { x: x + box.left, y: y + box.top };
  },
};
