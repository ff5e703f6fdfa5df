// What the page knows. SPDX-License-Identifier: Apache-2.0
import type { Changed, Field, Opened, Pick, Points, Vec3 } from './protocol';

export type Tool = 'click' | 'include' | 'exclude' | 'line' | 'points';

export interface State {
  opened: Of<Opened, 'name' | 'occlusal' | 'front' | 'warning'> & { faces: number; centre: Vec3; radius: number } | null;
  now: Changed | null;
  points: Points | null;
  tool: Tool;
  /** What the next click says about the tooth that is worked on: its other part, or the tooth that it is one with. */
  task: 'split' | 'merge' | null;
  /** Id of the tooth that is worked on. */
  selected: number | null;
  /** Id of the feature point that is worked on. */
  point: number | null;
  hover: Pick | null;
  /** Place of the group that the keyboard is at, from 0. */
  walk: number | null;
  hidden: Set<number>;
  /** Colours that were chosen by hand, by label. */
  colours: Map<number, string>;
  field: Field | null;
  showField: boolean;
  showPoints: boolean;
  closed: boolean;
  /** A sentence of what is going on, with the share that is done. */
  progress: { fraction: number; stage: string } | null;
  status: { text: string; bad: boolean };
}

type Of<T, K extends keyof T> = { [P in K]: T[P] };

export const start = (): State => ({
  opened: null, now: null, points: null, tool: 'click', task: null, selected: null, point: null, hover: null, walk: null, hidden: new Set(),
  colours: new Map(), field: null, showField: false, showPoints: false, closed: true, progress: null,
  status: { text: '', bad: false },
});

/** Colours of teeth by label: neighbours differ in hue and in lightness, and gum's own colour is left out. */
const COLOURS = [
  '#5aa9e6', '#f2c14e', '#7bc47f', '#c792ea', '#f28482', '#6dd3ce', '#e0a458', '#8d99f0', '#a3c644', '#e58fc0', '#4fb3a5', '#f6a04d',
  '#78b7f0', '#cfb53b', '#66b36a', '#b07be0',
];
/** What belongs to no tooth so far. */
export const PLAIN = '#d9d0c5';

export const colourOf = (state: State, label: number): string =>
  label === 0 ? PLAIN : (state.colours.get(label) ?? COLOURS[(label - 1) % COLOURS.length]);

export const rgb = (hex: string): [number, number, number] =>
  [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as [number, number, number];

/** How a tooth is called: by its FDI number, or, where it has none, by its place along the arch. */
export function nameOf(state: State, id: number): string {
  const tooth = state.now?.teeth.find((t) => t.id === id);
  if (tooth?.fdi) return `tooth ${tooth.fdi}`;
  if (tooth) return `tooth no. ${tooth.label}`;
  const place = state.points?.groups.findIndex((g) => g.id === id) ?? -1;
  return place < 0 ? 'the tooth' : placeName(state, place + 1);
}

/** The same of a group, by its place from 1. */
export function placeName(state: State, place: number): string {
  const fdi = state.now?.fdi[place - 1];
  return fdi ? `tooth ${fdi}` : `tooth no. ${place}`;
}
