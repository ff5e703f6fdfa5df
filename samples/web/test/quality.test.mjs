// What holds all the time: nothing freezes, nothing is asked of the network, everything has a name. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { clickAt, hoverAt, openArch, openPage, settled, state, status } from './page.mjs';
import { keep } from './pictures.mjs';

/** Opens, hovers, turns, clicks, looks at the field; gives the longest task of the main thread meanwhile. */
async function longest(page, triangles) {
  await page.evaluate(() => {
    window.longTasks.length = 0;
    const bar = document.getElementById('progress');
    window.shares = [];
    new MutationObserver(() => window.shares.push(Number(bar.getAttribute('aria-valuenow')))).observe(bar, { attributeFilter: ['aria-valuenow'] });
  });
  await page.evaluate((n) => window.viewer.openArch(n), triangles);
  await page.waitForFunction((n) => window.viewer.state.opened?.faces > 0.9 * n && window.viewer.idle(), triangles);
  await settled(page);
  const shares = await page.evaluate(() => window.shares);
  assert.ok(new Set(shares).size > 5, `the share that is done: ${shares}`);
  assert.ok(shares.every((share, i) => i === 0 || share >= shares[i - 1]), `the share that is done falls: ${shares}`);
  const places = await state(page, 's.now.proposals');
  for (const place of places) await hoverAt(page, place);
  await page.mouse.move(640, 500);
  await page.mouse.down({ button: 'left' });
  await page.mouse.move(660, 470, { steps: 5 });
  await page.mouse.up();
  await page.keyboard.press('0');
  await settled(page);
  await clickAt(page, places[0]);
  await page.keyboard.press('f');
  await settled(page);
  await page.keyboard.press('f');
  await page.keyboard.press('a');
  await settled(page);
  return { longest: await page.evaluate(() => Math.max(0, ...window.longTasks)), teeth: await state(page, 's.now.teeth.length') };
}

test('a scan of 300,000 triangles: no task of the main thread over 100 ms', async () => {
  const { page, faults, close } = await openPage();
  try {
    // What else runs on the machine can hold up any task: a page that blocks does so every time.
    let best = Infinity;
    for (let attempt = 0; attempt < 3 && best > 100; ++attempt) {
      const { longest: ms, teeth } = await longest(page, 300000);
      assert.equal(teeth, 14);
      best = Math.min(best, ms);
    }
    console.log(`longest task of the main thread, ${await state(page, 's.opened.faces')} triangles: ${best || 'under 50'} ms`);
    assert.ok(best <= 100, `${best} ms`);
    assert.deepEqual(faults, []);
    await keep(page, 'arch-300k');
  } finally {
    await close();
  }
});

test('with the network cut after loading everything works', async () => {
  const { page, browser, faults, close } = await openPage();
  try {
    await browser.setOffline(true);
    await openArch(page);
    await clickAt(page, (await state(page, 's.now.proposals'))[1]);
    assert.match(await status(page), /^Separated/);
    await page.keyboard.press('?');
    assert.ok(await page.isVisible('#help'));
    await keep(page, 'help');
    await page.click('#help >> text=Got it');
    assert.deepEqual(faults, []);
  } finally {
    await close();
  }
});

test('the page says that the scan stays here, and all of it fits at 1280 x 800, light and dark', async () => {
  const { page, faults, close } = await openPage({ smooth: true, colorScheme: 'dark' });
  try {
    assert.match(await page.textContent('#start'), /never leaves this browser/);
    assert.match(await page.textContent('#tools footer'), /never leaves this browser/);
    const notices = await page.evaluate(() => fetch(document.querySelector('#tools footer a').href).then((r) => r.text()));
    assert.match(notices, /three\.js authors/);
    const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const dark = await paper();
    await openArch(page, 20000);
    await page.keyboard.press('a');
    await settled(page);
    await page.click('#list button[aria-label^="Select tooth 41"]');
    await settled(page);
    await keep(page, 'dark');
    for (const box of ['#tools', '#teeth'])
      assert.ok(await page.$eval(box, (e) => e.scrollHeight <= e.clientHeight + 1), `${box} does not fit`);
    await page.click('button[title^="Light or dark"]');
    assert.notEqual(await paper(), dark);
    await page.reload();
    await page.waitForFunction(() => window.viewer?.ready());
    assert.notEqual(await paper(), dark, 'the choice is kept');
    assert.deepEqual(faults, []);
  } finally {
    await close();
  }
});

test('every control has a name, the focus is seen, and what happens is announced', async () => {
  const { page, close } = await openPage();
  try {
    await openArch(page, 20000);
    await page.keyboard.press('a');
    await settled(page);
    const nameless = await page.$$eval('button, input:not([hidden]), select, canvas, [role]', (all) =>
      all.filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.closest('label')?.textContent.trim() || e.id === 'status'))
        .map((e) => e.outerHTML));
    assert.deepEqual(nameless, []);
    assert.equal(await page.getAttribute('#status', 'aria-live'), 'polite');
    assert.equal(await page.getAttribute('[data-tool=click]', 'aria-checked'), 'true');
    await page.focus('#canvas');
    await page.keyboard.press('ArrowRight');
    const outline = await page.$eval('#canvas', (e) => getComputedStyle(e).outlineStyle);
    assert.notEqual(outline, 'none');
    assert.match(await status(page), /^Tooth 47, separated\.$/);
  } finally {
    await close();
  }
});
