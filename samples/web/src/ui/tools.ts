// The column of tools. SPDX-License-Identifier: Apache-2.0
import type { App } from '../app';
import type { Tool } from '../state';
import { nameOf } from '../state';
import { h } from './dom';

const TOOLS: { tool: Tool; text: string; title: string }[] = [
  { tool: 'click', text: 'Separate', title: 'Click a tooth: it and its neighbour are separated (1)' },
  { tool: 'include', text: 'This too', title: 'Click what belongs to the selected tooth (2)' },
  { tool: 'exclude', text: 'Not this', title: 'Click what does not belong to the selected tooth (3)' },
  { tool: 'line', text: 'Move line', title: 'Drag a point of the line of the selected tooth (4)' },
  { tool: 'points', text: 'Points', title: 'Add, move and remove feature points (5)' },
];

export interface Actions {
  open(): void;
  arch(): void;
  help(): void;
  theme(): void;
}

/** Builds the column; the function that comes back brings it into line with the state. */
export function buildTools(box: HTMLElement, app: App, actions: Actions): () => void {
  const button = (text: string, title: string, run: () => unknown, kind = '') =>
    h('button', { type: 'button', title, class: kind, onclick: () => void run() }, text);
  const radio = TOOLS.map(({ tool, text, title }, i) =>
    h('button', { type: 'button', title, class: 'tool', 'data-tool': tool, onclick: () => app.setTool(tool) },
      h('span', {}, text), h('kbd', {}, String(i + 1))));
  const undo = button('Undo', 'Take back the last step (Ctrl+Z)', () => app.undo());
  const redo = button('Redo', 'Bring it again (Ctrl+Y)', () => app.redo());
  const all = button('All teeth', 'Separate every tooth that is left (A)', () => app.segmentAll(), 'wide');
  const name = h('h3', {});
  const cut = [
    button('Wider', 'Move the line outwards by 0.2 mm', () => app.onTooth('offsetCut', { mm: 0.2 }, 'Wider:')),
    button('Narrower', 'Move the line inwards by 0.2 mm', () => app.onTooth('offsetCut', { mm: -0.2 }, 'Narrower:')),
    button('Smoother', 'Smooth the line', () => app.onTooth('smoothCut', { strength: 0.5 }, 'Smoother:')),
    button('Reset', 'The line of the click again', () => app.onTooth('resetCut', {}, 'The line of its click again:')),
  ];
  const lock = button('Lock', 'Nothing changes a locked tooth', () => {
    const tooth = app.state.now?.teeth.find((t) => t.id === app.state.selected);
    return app.onTooth('lock', { locked: !tooth?.locked }, tooth?.locked ? 'Unlocked' : 'Locked');
  });
  const remove = button('Remove', 'As if it had not been separated (Delete)', () => app.onTooth('remove', {}, 'Joined to the gum again:'));
  const split = button('Split…', 'Two teeth came out as one: click the other part', () => app.startTask('split'));
  const merge = button('Join…', 'One tooth came out as two: click the other one', () => app.startTask('merge'));
  const tooth = h('section', { 'aria-label': 'The selected tooth' }, name, h('div', { class: 'row' }, ...cut, split, merge, lock, remove));
  const field = h('input', { type: 'checkbox', onchange: () => void app.toggleField() });
  const points = h('input', { type: 'checkbox', onchange: () => app.togglePoints() });
  const prepare = button('Use these points', 'Prepare the scan with the points as they are, and repeat the clicks', () => app.prepare(), 'wide');
  const group = h('select', { 'aria-label': 'Tooth of the point', onchange: () => {
    const { value } = group;
    void app.editPoints('setGroup', { point: app.state.point!, group: value === '' ? null : Number(value) }, 'The point is of another tooth now.');
  } });
  const point = h('section', { 'aria-label': 'The selected point' }, h('h3', {}, 'Point of'), group, h('div', { class: 'row' },
    button('Remove', 'Without this point (Delete)', () => app.editPoints('removePoint', { point: app.state.point! }, 'Removed the point.')),
    button('All of its tooth', 'Without the points of its tooth (Shift+Delete)', () => app.removeGroupOfPoint())));
  const closed = h('input', { type: 'checkbox', checked: true, onchange: (e) => (app.state.closed = (e.target as HTMLInputElement).checked) });
  const exports = [
    button('Teeth (STL, zip)', 'Each tooth as an STL file, in one zip', () => app.exportFile('exportTeeth'), 'wide'),
    button('Labelled scan (PLY)', 'The scan with a colour and a label a triangle', () => app.exportFile('exportPly'), 'wide'),
    button('Session', 'What was done, to go on with later (Ctrl+S)', () => app.exportFile('exportSession'), 'wide'),
  ];
  const label = (input: HTMLInputElement, text: string, key = '') =>
    h('label', {}, input, h('span', {}, text), ...(key ? [h('kbd', {}, key)] : []));
  box.append(
    h('header', {}, h('h1', {}, 'toothseg'), h('div', { class: 'row' },
      button('?', 'Help (?)', actions.help, 'icon'), button('◐', 'Light or dark (T)', actions.theme, 'icon'))),
    h('section', { 'aria-label': 'Scan' }, h('div', { class: 'row' },
      button('Open…', 'A scan (STL, PLY, OBJ, OFF) or a session (Ctrl+O)', actions.open, 'main'),
      button('Built-in arch', 'A synthetic arch to try it on', actions.arch))),
    h('section', { role: 'radiogroup', 'aria-label': 'Tool' }, ...radio),
    h('section', { 'aria-label': 'Steps' }, h('div', { class: 'row' }, undo, redo), all),
    tooth,
    h('section', { 'aria-label': 'Show' }, label(field, 'Field and contours', 'F'), label(points, 'Feature points', 'G'), prepare),
    point,
    h('section', { 'aria-label': 'Save' }, h('h3', {}, 'Save'), label(closed, 'Closed teeth'), ...exports),
    h('footer', {}, 'The scan never leaves this browser: all the work is done on this computer. ',
      h('a', { href: './THIRD_PARTY.md', target: '_blank' }, 'Licences')),
  );
  for (const element of radio) element.setAttribute('role', 'radio');
  return () => {
    const { state } = app;
    const { now } = state;
    const chosen = now?.teeth.find((t) => t.id === state.selected);
    radio.forEach((element, i) => {
      element.setAttribute('aria-checked', String(TOOLS[i].tool === state.tool));
      element.disabled = !state.opened;
    });
    undo.disabled = !now?.undo;
    redo.disabled = !now?.redo;
    all.disabled = !state.opened;
    tooth.hidden = !chosen || state.tool === 'points';
    if (chosen) {
      name.textContent = nameOf(state, chosen.id).replace(/^t/, 'T');
      lock.textContent = chosen.locked ? 'Unlock' : 'Lock';
    }
    field.checked = state.showField;
    points.checked = state.showPoints;
    field.disabled = points.disabled = !state.opened;
    const at = state.points?.points.find((p) => p.id === state.point);
    point.hidden = !at;
    if (at)
      group.replaceChildren(...state.points!.groups.map(({ id }) => h('option', { value: id, selected: id === at.group }, nameOf(state, id))),
        h('option', { value: '' }, 'a tooth of its own'));
    prepare.hidden = !state.points?.edited;
    exports[0].disabled = exports[1].disabled = !now?.teeth.length;
    exports[2].disabled = !state.opened;
  };
}
