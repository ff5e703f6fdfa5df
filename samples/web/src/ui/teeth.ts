// The list of teeth, along the arch. SPDX-License-Identifier: Apache-2.0
import type { App } from '../app';
import { warningsOf } from '../messages';
import type { Tooth } from '../protocol';
import { colourOf, nameOf } from '../state';
import { h } from './dom';

/** FDI numbers that a tooth may be given: both jaws, since the one that was estimated may be wrong. */
const FDI = [1, 2, 3, 4].flatMap((quadrant) => Array.from({ length: 8 }, (_, i) => 10 * quadrant + i + 1));

export function buildTeeth(box: HTMLElement, app: App): () => void {
  const title = h('h2', {}, 'Teeth');
  const jaw = h('p', { class: 'quiet' });
  const list = h('ul', { 'aria-label': 'Teeth along the arch' });
  box.append(title, jaw, list);
  let shown: unknown[] = [];
  return () => {
    const { state } = app;
    const { now, points } = state;
    // Hovering changes nothing here: what is the same stays, with its focus.
    const key = [now, points, state.selected, state.hidden.size, state.colours.size, [...state.colours.values()].join()];
    if (key.every((k, i) => k === shown[i])) return;
    shown = key;
    const groups = points?.groups ?? [];
    const teeth = now?.teeth ?? [];
    title.textContent = state.opened ? `Teeth: ${teeth.length} of ${Math.max(groups.length, teeth.length)}` : 'Teeth';
    jaw.textContent = now?.jaw && teeth.length ? `${now.jaw === 'upper' ? 'Upper' : 'Lower'} jaw (estimated), FDI numbers` : '';
    const focused = (document.activeElement as HTMLElement | null)?.dataset.key;
    const ids = [...new Set([...groups.map((g) => g.id), ...teeth.map((t) => t.id)])];
    list.replaceChildren(...ids.map((id) => {
      const tooth = teeth.find((t) => t.id === id);
      return tooth ? row(app, tooth) : pending(app, id);
    }));
    if (focused) list.querySelector<HTMLElement>(`[data-key="${focused}"]`)?.focus();
  };
}

/** A tooth that has not been separated so far. */
function pending(app: App, id: number): HTMLElement {
  const { state } = app;
  const group = state.points!.groups.find((g) => g.id === id)!;
  return h('li', { class: 'pending' },
    h('button', { type: 'button', class: 'name', title: 'Separate it', 'data-key': `name${id}`, onclick: () => void app.click(group.at) },
      nameOf(state, id).replace(/^tooth /, '')),
    h('span', { class: 'quiet' }, 'not separated'));
}

function row(app: App, tooth: Tooth): HTMLElement {
  const { state } = app;
  const { id, label } = tooth;
  const name = nameOf(state, id);
  const visible = !state.hidden.has(id);
  const warnings = warningsOf(tooth.warnings);
  const percent = Math.round(100 * tooth.confidence);
  const select = h('select', {
    'aria-label': `FDI number of ${name}`, 'data-key': `fdi${id}`,
    title: tooth.fdiByHand ? 'Number set by hand' : tooth.fdiUncertain ? 'This number is uncertain: choose the right one' : 'FDI number',
    onchange: (e) => void app.onTooth('number', { fdi: Number((e.target as HTMLSelectElement).value) }, 'Numbered', id),
  }, ...[...(tooth.fdi ? [] : [0]), ...FDI].map((n) =>
    h('option', { value: n, selected: n === tooth.fdi }, n ? `${n}${n === tooth.fdi && tooth.fdiUncertain ? ' ?' : ''}` : '–')));
  return h('li', { class: id === state.selected ? 'selected' : '', 'aria-current': String(id === state.selected) },
    h('input', { type: 'color', value: colourOf(state, label), 'aria-label': `Colour of ${name}`, 'data-key': `colour${id}`,
      onchange: (e) => app.setColour(label, (e.target as HTMLInputElement).value) }),
    select,
    h('button', { type: 'button', class: 'name', 'data-key': `name${id}`, title: warnings.length ? `Wants a look: ${warnings.join(', ')}` : 'Select it',
      'aria-label': `Select ${name}, confidence ${percent} percent${warnings.length ? `, ${warnings.join(', ')}` : ''}`,
      onclick: () => app.select(id) },
      h('span', { class: percent < 90 ? 'bar low' : 'bar' }, h('i', { style: `width:${percent}%` })), `${percent}%`,
      tooth.locked ? ' 🔒' : '', warnings.length ? ' ⚠' : ''),
    h('input', { type: 'checkbox', checked: visible, 'aria-label': `Show ${name}`, title: 'Visible', 'data-key': `eye${id}`,
      onchange: (e) => app.setVisible(id, (e.target as HTMLInputElement).checked) }));
}
