// The histogram of a click's field with its chosen cuts (paper, Fig. 4C), and the gradient along the contours that they were
// chosen by. SPDX-License-Identifier: Apache-2.0
import type { App } from '../app';
import type { Field } from '../protocol';
import { nameOf } from '../state';

const WIDTH = 226, HEIGHT = 130, FOOT = 16, TOP = 18;

const mix = (a: number[], b: number[], t: number) => `rgb(${a.map((x, i) => Math.round(x + t * (b[i] - x))).join(',')})`;

/** The colours of the surface's shader. */
function ramp(u: number): string {
  const [red, pale, blue] = [[204, 31, 31], [237, 232, 204], [33, 74, 204]];
  return u < 0.5 ? mix(red, pale, 2 * u) : mix(pale, blue, 2 * u - 1);
}

export function buildField(box: HTMLElement, app: App): () => void {
  let shown: Field | null = null;
  return () => {
    const { field, showField, now } = app.state;
    box.hidden = !showField;
    if (box.hidden) shown = null;
    if (box.hidden || (field && field === shown)) return;
    shown = field;
    if (!field) {
      box.textContent = now?.clicks ? '' : 'The field is shown of a click: separate a tooth first.';
      return;
    }
    const target = nameOf(app.state, field.target);
    const neighbour = field.neighbour === null ? 'no neighbour' : nameOf(app.state, field.neighbour);
    box.innerHTML = svg(field);
    box.querySelector('svg')!.setAttribute('aria-label', `Vertices by field value, from ${target} at 0 to ${neighbour} at 1. ` +
      `Cut of ${target} at ${field.targetIso.toFixed(3)}${cutOf(field)}`);
    const text = document.createElement('p');
    text.innerHTML = '<b class="red"></b><b class="blue"></b><span></span>';
    text.querySelector('.red')!.textContent = `0 · ${target}`;
    text.querySelector('span')!.textContent = 'Bars: vertices by value of the field. Grey line: mean gradient along the contours. Circle: the fullest bin.';
    text.querySelector('.blue')!.textContent = `${neighbour} · 1`;
    box.append(text);
  };
}

const cutOf = ({ neighbourIso }: Field) => (Number.isNaN(neighbourIso) ? '.' : `, of its neighbour at ${neighbourIso.toFixed(3)}.`);

function svg(field: Field): string {
  const x = (u: number) => u * WIDTH;
  const base = HEIGHT - FOOT;
  // Square roots: the bins at the ends hold nearly all of the vertices.
  const most = Math.sqrt(Math.max(1, ...field.histogram));
  const bins = field.histogram.length;
  const bars = [...field.histogram].map((n, i) => {
    const height = (Math.sqrt(n) / most) * (base - TOP);
    return `<rect x="${x(i / bins).toFixed(1)}" y="${(base - height).toFixed(1)}" width="${(WIDTH / bins - 0.6).toFixed(1)}" height="${height.toFixed(1)}" fill="${ramp((i + 0.5) / bins)}"/>`;
  });
  const steepest = Math.max(1e-12, ...field.gradient.map((g) => g.gradient));
  const curve = field.gradient.map((g) => `${x(g.iso).toFixed(1)},${(base - (g.gradient / steepest) * (base - TOP)).toFixed(1)}`);
  const cut = (iso: number, text: string, anchor: string) =>
    Number.isNaN(iso) ? '' : `<line class="cut" x1="${x(iso)}" x2="${x(iso)}" y1="${TOP - 4}" y2="${base}"/>` +
      `<text x="${x(iso)}" y="${TOP - 7}" text-anchor="${anchor}">${text} ${iso.toFixed(3)}</text>`;
  return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img"><g>${bars.join('')}</g>` +
    `<polyline class="gradient" points="${curve.join(' ')}"/>` +
    `<circle class="median" cx="${x(field.vMed)}" cy="${base}" r="4"><title>V med ${field.vMed.toFixed(2)}: the fullest bin</title></circle>` +
    cut(field.targetIso, 'cut', 'start') + cut(field.neighbourIso, 'cut', 'end') +
    [0, 0.25, 0.5, 0.75, 1].map((u) => `<text class="axis" x="${x(u)}" y="${HEIGHT - 3}" text-anchor="${u === 0 ? 'start' : u === 1 ? 'end' : 'middle'}">${u}</text>`).join('') +
    '</svg>';
}
