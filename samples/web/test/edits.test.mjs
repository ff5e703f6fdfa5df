// Corrections, the line, feature points, colours, numbers. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { clickAt, hoverAt, labels, onScreen, openArch, openPage, settled, state, status } from './page.mjs';
import { keep } from './pictures.mjs';

let page, faults, close;
before(async () => {
  ({ page, faults, close } = await openPage());
  await openArch(page, 20000);
  await page.keyboard.press('a');
  await settled(page);
});
after(() => close?.());

const toothOf = (fdi) => state(page, `s.now.teeth.find((t) => t.fdi === ${fdi})`);
const facesOf = async (label) => (await labels(page)).filter((l) => l === label).length;

async function select(fdi) {
  await page.click(`#list button[aria-label^="Select tooth ${fdi}"]`);
  await settled(page);
}

async function undo(before) {
  await page.click('#tools >> text=Undo');
  await settled(page);
  assert.deepEqual(await labels(page), before);
}

/** A point of the cut of a tooth that is seen: not hidden by the crown. Towards the viewer, so the lowest on the screen. */
async function lowestOfCut(id) {
  const points = await page.evaluate((tooth) => {
    const { points } = window.viewer.cuts().get(tooth).loops[0];
    const { centre } = window.viewer.state.opened;
    return Array.from({ length: points.length / 3 }, (_, i) => [0, 1, 2].map((k) => points[3 * i + k] + centre[k]));
  }, id);
  const screen = await Promise.all(points.map((p) => onScreen(page, p)));
  const low = screen.reduce((best, s, i) => (s.y > screen[best].y ? i : best), 0);
  return { place: points[low], ...screen[low] };
}

test('Shift-click on the tooth: not this; beside it: this too', async () => {
  const tooth = await toothOf(33);
  await select(33);
  const before = await labels(page);
  const { x, y } = await lowestOfCut(tooth.id);
  const at = async (dy) => {
    await page.keyboard.down('Shift');
    await page.mouse.click(x, y + dy);
    await page.waitForTimeout(300);
    await page.keyboard.up('Shift');
    await settled(page);
  };
  await at(14); // on the gum below the cut
  assert.match(await status(page), /Added to tooth 33/);
  assert.ok((await facesOf(tooth.label)) > before.filter((l) => l === tooth.label).length);
  await keep(page, 'included');
  await undo(before);
  await at(-16); // on the crown above it
  assert.match(await status(page), /Taken off tooth 33/);
  assert.ok((await facesOf(tooth.label)) < before.filter((l) => l === tooth.label).length);
  await keep(page, 'excluded');
  await undo(before);
});

test('a point of the line is dragged, and the line goes through the new place', async () => {
  const tooth = await toothOf(43);
  await select(43);
  await page.keyboard.press('4');
  await settled(page);
  const before = await labels(page);
  const { x, y } = await lowestOfCut(tooth.id);
  await page.mouse.move(x, y);
  await settled(page);
  assert.equal(await page.getAttribute('#canvas', 'data-grip'), 'yes');
  const camera = await onScreen(page, tooth.centre);
  await page.mouse.down();
  await page.mouse.move(x, y - 8, { steps: 3 });
  await page.mouse.move(x, y - 15, { steps: 3 });
  await page.waitForTimeout(300);
  const to = (await state(page, 's.hover')).position;
  await keep(page, 'dragging');
  await page.mouse.up();
  await page.waitForTimeout(300);
  await settled(page);
  assert.match(await status(page), /Moved the line of tooth 43/);
  assert.deepEqual(await onScreen(page, tooth.centre), camera, 'the camera stays');
  const off = await page.evaluate(([id, p]) => {
    const { points } = window.viewer.cuts().get(id).loops[0];
    const { centre } = window.viewer.state.opened;
    let least = Infinity;
    for (let i = 0; i < points.length; i += 3) least = Math.min(least, Math.hypot(...p.map((c, k) => points[i + k] + centre[k] - c)));
    return least;
  }, [tooth.id, to]);
  assert.ok(off < 0.5, `the line is ${off} mm off`);
  assert.ok((await facesOf(tooth.label)) < before.filter((l) => l === tooth.label).length);
  await keep(page, 'dragged');
  await undo(before);
  await page.keyboard.press('1');
});

test('narrower, smoother, as it was, lock, remove', async () => {
  const tooth = await toothOf(36);
  await select(36);
  const before = await labels(page);
  const run = async (text) => {
    await page.click(`#tools button:text-is("${text}")`);
    await settled(page);
  };
  await run('Narrower');
  assert.ok((await facesOf(tooth.label)) < before.filter((l) => l === tooth.label).length);
  await run('Smoother');
  await run('Reset');
  assert.deepEqual(await labels(page), before);
  await run('Lock');
  await clickAt(page, tooth.centre);
  assert.equal(await page.getAttribute('#status', 'class'), 'bad');
  assert.match(await status(page), /locked\. Unlock it first/);
  await run('Unlock');
  await run('Remove');
  assert.equal(await facesOf(tooth.label), 0);
  assert.match(await page.textContent('#teeth h2'), /13 of 14/);
  await undo(before);
});

test('two teeth are joined to one, and one is split in two', async () => {
  const before = await labels(page);
  const place = async (fdi) => (await state(page, `s.points.groups[s.now.fdi.indexOf(${fdi})]`)).at;
  await select(41);
  await page.click('#tools >> text=Join…');
  assert.match(await page.textContent('#hint'), /one with tooth 41/);
  await clickAt(page, await place(31));
  assert.equal(await state(page, 's.now.teeth.length'), 13);
  await undo(before);
  await select(46);
  const points = await state(page, `s.points.points.filter((p) => p.group === s.selected).map((p) => p.position)`);
  await page.click('#tools >> text=Split…');
  await clickAt(page, points[0]);
  assert.match(await status(page), /^Split/);
  assert.equal(await state(page, 's.now.teeth.length'), 15);
  await undo(before);
});

test('a number set by hand stays, and one that breaks the order is refused in a sentence', async () => {
  const set = async (fdi, to) => {
    await page.selectOption(`#list select[aria-label="FDI number of tooth ${fdi}"]`, String(to));
    await settled(page);
  };
  await set(47, 48);
  assert.ok((await toothOf(48)).fdiByHand);
  await set(46, 38);
  assert.match(await status(page), /in order along the arch|Another tooth/);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.ok(await toothOf(47));
});

test('visibility and colour of a tooth', async () => {
  const tooth = await toothOf(35);
  const pixel = async () => {
    const { x, y } = await onScreen(page, (await state(page, `s.points.groups.find((g) => g.id === ${tooth.id})`)).at);
    const shot = await page.screenshot({ clip: { x: x - 1, y: y + 10, width: 3, height: 3 } });
    return shot.toString('base64');
  };
  const before = await pixel();
  await page.uncheck('#list input[aria-label="Show tooth 35"]');
  await settled(page);
  assert.notEqual(await pixel(), before);
  await page.check('#list input[aria-label="Show tooth 35"]');
  await settled(page);
  await page.fill('#list input[aria-label="Colour of tooth 35"]', '#ff0000');
  await page.dispatchEvent('#list input[aria-label="Colour of tooth 35"]', 'change');
  await settled(page);
  assert.notEqual(await pixel(), before);
});

test('feature points: added, moved, removed, and used', async () => {
  await openArch(page, 20000);
  await page.keyboard.press('5');
  await settled(page);
  const points = () => state(page, 's.points.points');
  const before = await points();
  const group = (await state(page, 's.points.groups'))[0];
  const [a, b] = before.filter((p) => p.group === group.id).map((p) => p.position);
  await clickAt(page, a.map((c, k) => (c + b[k]) / 2));
  const added = (await points()).find((p) => !before.some((q) => q.id === p.id));
  assert.ok(added?.byHand);
  assert.equal(added.group, group.id);
  assert.match(await status(page), /Added a point to tooth 47/);
  const from = await onScreen(page, added.position);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 16, from.y + 6, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(300);
  await settled(page);
  const moved = (await points()).find((p) => p.id === added.id);
  assert.ok(Math.hypot(...moved.position.map((c, k) => c - added.position[k])) > 0.5);
  await keep(page, 'points');
  const to = await onScreen(page, moved.position);
  await page.mouse.click(to.x, to.y);
  await page.waitForTimeout(300);
  await settled(page);
  assert.equal(await state(page, 's.point'), added.id);
  await page.selectOption('select[aria-label="Tooth of the point"]', { label: 'a tooth of its own' });
  await settled(page);
  assert.equal(await state(page, 's.points.groups.length'), 15);
  await page.mouse.click(to.x, to.y);
  await page.waitForTimeout(300);
  await settled(page);
  await page.keyboard.press('Delete');
  await settled(page);
  assert.deepEqual((await points()).map((p) => p.id), before.map((p) => p.id));
  // All points of a tooth away: what is left is separated without it.
  const first = await onScreen(page, before[0].position);
  await page.mouse.click(first.x, first.y);
  await page.waitForTimeout(300);
  await page.keyboard.press('Shift+Delete');
  await settled(page);
  assert.equal(await state(page, 's.points.groups.length'), 13);
  await page.click('#tools >> text=Use these points');
  await settled(page);
  assert.equal(await state(page, 's.points.edited'), false);
  await page.keyboard.press('a');
  await settled(page);
  assert.equal(await state(page, 's.now.teeth.length'), 13);
});

test('what is hovered on a separated tooth is named', async () => {
  await page.keyboard.press('1');
  await hoverAt(page, await state(page, 's.points.groups[3].at'));
  assert.match(await page.textContent('#hint'), /^Click: tooth \d\d again/);
});

test('no error in the console', () => assert.deepEqual(faults, []));
