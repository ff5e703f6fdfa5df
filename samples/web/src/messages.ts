// What went wrong and what looks wrong, as sentences. SPDX-License-Identifier: Apache-2.0
import { Failure } from './client';

const SENTENCES: Record<number, string> = {
  104: 'There is nothing here that this could be done to.',
  105: 'This session belongs to another scan. Open that scan first, then the session.',
  200: 'There is not enough memory for this scan. Close other tabs, or reduce the scan to fewer triangles.',
  201: 'Stopped. Nothing has changed.',
  202: 'The library has met a fault of its own. Your work so far stands; please report this message.',
  300: 'The file could not be read.',
  301: 'This is no scan that can be read: it has to be an STL, PLY, OBJ or OFF file of triangles.',
  302: 'The file ends too early: it was probably cut off while it was copied or sent. Try to get it again.',
  303: 'The file goes on after its end: it is probably damaged.',
  304: 'The file says that it holds more or less than it does: it is probably damaged.',
  305: 'There is something in the file that does not belong there.',
  307: 'This session was written by a later version. Reload the page to get the present one.',
  400: 'There is no surface in this file.',
  401: 'The file holds coordinates that are no numbers: it is damaged.',
  402: 'A triangle in the file names a corner that is not there: the file is damaged.',
  403: 'The scan is too small or too large to be in millimetres. Export it in millimetres and open it again.',
  404: 'The scan is too large to be worked on.',
  500: 'Nothing on this surface looks like a tooth.',
  501: 'There is no feature point, so there is nothing to separate. Add one on each tooth.',
  600: 'That is not on the surface.',
  601: 'That is gum, not a tooth. Click on the crown.',
  602: 'No line was found that parts this tooth from the rest. Try another place on its crown.',
  603: 'The scan could not be prepared: its triangles are too odd.',
  604: 'The tooth is locked. Unlock it first.',
  605: 'It is so already.',
  606: 'There is nothing more to take back or bring again.',
  650: 'The line would stay as it is.',
  651: 'The line would run over another tooth.',
  652: 'The line would cross itself, or leave part of the tooth out.',
  653: 'That is too far from the line of this tooth.',
  654: 'The line would vanish or fall into several.',
  700: 'There are more teeth than a jaw has, so they cannot be numbered.',
  701: 'That number belongs to the other jaw.',
  702: 'Another tooth has that number.',
  703: 'With that number the teeth would not be in order along the arch.',
  750: 'A tooth cannot be closed without running through itself. Export the teeth open instead.',
};

/** Statuses whose own message has something to add: the place in the file. */
const WITH_DETAIL = new Set([202, 305]);

export function sentence(error: unknown): string {
  if (!(error instanceof Failure)) return error instanceof Error ? error.message : String(error);
  const known = SENTENCES[error.status];
  if (!known) return `That did not work: ${error.message}`;
  return WITH_DETAIL.has(error.status) ? `${known} (${error.message})` : known;
}

const WARNINGS: [number, string][] = [
  [1, 'small for a tooth'],
  [2, 'large for a tooth'],
  [4, 'runs into the border of the scan'],
  [8, 'its line is not one closed loop'],
  [16, 'no neighbour was there to part it from'],
  [32, 'a feature point was not used'],
  [64, 'of unusual width'],
  [128, 'may hold two teeth'],
  [256, 'flat on top: a post or a scan body?'],
  [512, 'found by the click alone'],
];

export const warningsOf = (sum: number): string[] => WARNINGS.filter(([bit]) => sum & bit).map(([, text]) => text);
