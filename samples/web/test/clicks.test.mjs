// From opening to a separated arch, by mouse and by keyboard. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { load, makeArch } from 'toothseg-wasm';
import { clickAt, hoverAt, labels, openArch, openPage, settled, state, status } from './page.mjs';
import { TOLERANCE, differing, keep } from './pictures.mjs';

let page, faults, close, arch;
before(async () => {
  await load();
  arch = makeArch({ jaw: 2, triangles: 60000, seed: 1 });
  ({ page, faults, close } = await openPage({ smooth: true }));
  await keep(page, 'start');
  await openArch(page);
});
after(() => close?.());

/** For each true tooth the IoU, over faces, with the faces of the page's tooth of the same FDI number. */
async function agreement() {
  const found = await labels(page);
  const teeth = await state(page, 's.now.teeth.map(({ label, fdi }) => ({ label, fdi }))');
  return arch.teeth.map((fdi, i) => {
    const label = teeth.find((t) => t.fdi === fdi)?.label ?? -1;
    let [both, either] = [0, 0];
    arch.labels.forEach((truth, face) => {
      const [a, b] = [truth === i + 1, found[face] === label];
      if (a && b) ++both;
      if (a || b) ++either;
    });
    return { fdi, iou: both / either };
  });
}

test('the arch opens, numbered, with nothing separated', async () => {
  assert.equal(await state(page, 's.points.groups.length'), arch.teeth.length);
  assert.deepEqual(await state(page, 's.now.fdi'), arch.teeth);
  assert.equal(await page.isDisabled('text=Undo'), true);
  assert.ok((await differing(page, 'opened')) <= TOLERANCE);
});

test('the preview knows nearly every face of every tooth', async () => {
  const territory = await state(page, '[...s.points.territory]');
  const teeth = arch.labels.reduce((n, label) => n + (label > 0 ? 1 : 0), 0);
  const right = territory.filter((place, face) => place > 0 && place === arch.labels[face]).length;
  const gum = territory.filter((place, face) => place > 0 && arch.labels[face] === 0).length;
  console.log(`preview: ${((100 * right) / teeth).toFixed(1)} % of the teeth's faces, ${((100 * gum) / (territory.length - teeth)).toFixed(1)} % of the gum's`);
  assert.ok(right > 0.93 * teeth);
  assert.ok(gum < 0.1 * (territory.length - teeth));
});

test('what is tinted under the cursor is what the click takes', async () => {
  for (const [, place] of (await state(page, 's.now.proposals')).entries()) {
    const hover = await hoverAt(page, place);
    const { fdi } = await state(page, 's.now');
    const [target, neighbour] = [fdi[hover.group - 1], fdi[hover.neighbour - 1]];
    assert.ok((await page.textContent('#hint')).startsWith(`Click: tooth ${target} and tooth ${neighbour}`));
    await clickAt(page, place);
    assert.ok((await status(page)).startsWith(`Separated tooth ${target} and tooth ${neighbour} in `), await status(page));
    await page.keyboard.press('Control+z');
    await settled(page);
  }
  assert.equal(await state(page, 's.now.teeth.length'), 0);
});

test('N / 2 clicks separate the arch, two teeth a click', async () => {
  const wanted = Math.ceil(arch.teeth.length / 2);
  for (let click = 1; click <= wanted; ++click) {
    const [place] = await state(page, 's.now.proposals');
    await clickAt(page, place);
    assert.equal(await state(page, 's.now.teeth.length'), Math.min(2 * click, arch.teeth.length));
    if (click === 1) assert.ok((await differing(page, 'click-1')) <= TOLERANCE);
    else await keep(page, `click-${click}`);
  }
  assert.match(await status(page), /All teeth are separated\./);
  await page.mouse.move(640, 20); // off the scan: nothing is tinted
  await settled(page);
  assert.ok((await differing(page, 'separated')) <= TOLERANCE);
  for (const { fdi, iou } of await agreement()) assert.ok(iou > 0.9, `tooth ${fdi}: IoU ${iou.toFixed(3)}`);
});

test('undo goes back to the beginning, and redo brings all of it again, byte for byte', async () => {
  const all = await labels(page);
  const steps = await state(page, 's.now.undo');
  assert.equal(steps, Math.ceil(arch.teeth.length / 2));
  for (let i = 0; i < steps; ++i) await page.keyboard.press('Control+z');
  await settled(page);
  assert.ok((await labels(page)).every((l) => l === 0));
  assert.equal(await page.isDisabled('text=Undo'), true);
  for (let i = 0; i < steps; ++i) await page.keyboard.press('Control+y');
  await settled(page);
  assert.deepEqual(await labels(page), all);
  assert.equal(await page.isDisabled('text=Redo'), true);
});

test('without a mouse: Tab walks, Enter separates, letters do the rest', async () => {
  await page.click('#tools >> text=Built-in arch');
  await page.waitForFunction(() => window.viewer.state.now?.teeth.length === 0 && window.viewer.idle());
  await page.focus('#canvas');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await page.keyboard.press('ArrowRight');
  assert.equal(await state(page, 's.walk'), 2);
  assert.match(await status(page), new RegExp(`Tooth ${arch.teeth[2]}, not separated`));
  await page.keyboard.press('Enter');
  await settled(page);
  const fdi = await state(page, 's.now.teeth.map((t) => t.fdi)');
  assert.ok(fdi.includes(arch.teeth[2]) && fdi.length === 2, fdi.join());
  await page.keyboard.press('a');
  await settled(page);
  assert.equal(await state(page, 's.now.teeth.length'), arch.teeth.length);
  for (const { fdi: n, iou } of await agreement()) assert.ok(iou > 0.9, `tooth ${n}: IoU ${iou.toFixed(3)}`);
  // Past the last tooth Tab leaves the scan: no trap.
  for (let i = 2; i < arch.teeth.length; ++i) await page.keyboard.press('Tab');
  assert.notEqual(await page.evaluate(() => document.activeElement?.id), 'canvas');
});

test('the field, its contours, and the histogram with the chosen cuts', async () => {
  await page.mouse.move(640, 20);
  await page.keyboard.press('f');
  await settled(page);
  const field = await state(page, '({ ...s.field, values: undefined, lines: s.field.lines.length, chosen: s.field.chosen.length, least: s.field.values.reduce((a, b) => Math.min(a, b)), most: s.field.values.reduce((a, b) => Math.max(a, b)) })');
  assert.ok(field.least < 0.01 && field.most > 0.99 && field.most < 1.01, `${field.least} to ${field.most}`);
  assert.ok(field.lines > 1000 && field.chosen > 100);
  assert.ok(field.targetIso < field.vMed && field.vMed < field.neighbourIso);
  assert.equal(await page.locator('#field svg rect').count(), 50);
  const marked = await page.locator('#field svg line.cut').evaluateAll((lines) => lines.map((l) => Number(l.getAttribute('x1'))));
  const width = await page.locator('#field svg').evaluate((svg) => svg.viewBox.baseVal.width);
  [field.targetIso, field.neighbourIso].forEach((iso, i) => assert.ok(Math.abs(marked[i] / width - iso) < 1e-6));
  assert.ok((await differing(page, 'field')) <= TOLERANCE);
  await page.keyboard.press('f');
  await settled(page);
});

test('no error in the console, and no request to elsewhere', () => assert.deepEqual(faults, []));
