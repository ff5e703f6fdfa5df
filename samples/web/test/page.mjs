// A browser with the page, and what a person does on it. SPDX-License-Identifier: Apache-2.0
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { serve } from './serve.mjs';

export const DIST = new URL('../dist', import.meta.url).pathname;
const ARGS = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
];
/** Preparing takes a while on a machine that does other things as well. */
export const PATIENCE = 240000;

/**
 * The page in a browser of its own. `faults`: what should not have been in the console, and requests to elsewhere. Edges are smooth
 * where a picture is compared: where a processor draws, that is half of what a frame costs.
 */
export async function openPage({ smooth = false, ...options } = {}) {
  const { server, address } = await serve(DIST);
  const profile = mkdtempSync(join(tmpdir(), 'toothseg-web-'));
  const browser = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.TS_CHROMIUM ?? '/usr/bin/chromium', headless: true, acceptDownloads: true,
    args: smooth ? ARGS : [...ARGS, '--webgl-antialiasing-mode=none'],
    viewport: { width: 1280, height: 800 }, deviceScaleFactor: 1, colorScheme: 'light', ...options,
  });
  const page = browser.pages()[0] ?? (await browser.newPage());
  page.setDefaultTimeout(PATIENCE);
  const faults = [];
  page.on('console', (m) => m.type() === 'error' && faults.push(m.text()));
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('request', (r) => !r.url().startsWith(address) && !/^(blob|data):/.test(r.url()) && faults.push(`request to ${r.url()}`));
  // Tasks of the main thread over 50 ms: that is what the browser calls long.
  await page.addInitScript(() => {
    window.longTasks = [];
    new PerformanceObserver((list) => window.longTasks.push(...list.getEntries().map((e) => e.duration))).observe({ type: 'longtask' });
  });
  const close = async () => {
    await browser.close();
    server.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 3 });
  };
  try {
    await page.goto(address);
    await page.waitForFunction(() => window.viewer?.ready());
  } catch (error) {
    await close(); // else the browser would keep the process alive
    throw error;
  }
  return { page, browser, faults, close };
}

/** Until nothing runs, and what came of it is drawn. */
export async function settled(page) {
  await page.waitForFunction(() => window.viewer.idle() && window.viewer.drawn());
  await page.waitForTimeout(100);
}

/**
 * Opens the built-in arch: that of the button, or one of `triangles` where what is asked does not hang on how fine it is. A
 * processor draws it, and so a third of the triangles is a third of what each frame costs.
 */
export async function openArch(page, triangles = null) {
  if (triangles === null) await page.click('#tools >> text=Built-in arch');
  else await page.evaluate((n) => void window.viewer.openArch(n), triangles);
  await page.waitForFunction(() => window.viewer.state.now !== null && window.viewer.idle());
  await settled(page);
}

export const state = (page, what) => page.evaluate(`(() => { const s = window.viewer.state; return ${what}; })()`);
export const status = (page) => page.textContent('#status');
export const labels = (page) => page.evaluate(() => [...window.viewer.state.now.labels]);

/** Where a place of the scan, in mm, is on the screen. */
export const onScreen = (page, place) => page.evaluate((p) => window.viewer.toScreen(p), place);

/** A click of the mouse at a place of the scan. */
export async function clickAt(page, place, modifiers = []) {
  const { x, y } = await onScreen(page, place);
  for (const key of modifiers) await page.keyboard.down(key);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.up();
  // What lies under the cursor is asked of the worker before the step begins.
  await page.waitForTimeout(250);
  for (const key of modifiers) await page.keyboard.up(key);
  await settled(page);
}

/** Drops a file on the page. */
export async function drop(page, name, bytes) {
  const data = await page.evaluateHandle(([file, base64]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], file));
    return transfer;
  }, [name, Buffer.from(bytes).toString('base64')]);
  await page.dispatchEvent('body', 'drop', { dataTransfer: data });
  await settled(page);
}

/** The bytes that a button gives to save. */
export async function download(page, button) {
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(`text=${button}`)]);
  const chunks = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk);
  await settled(page);
  return { name: file.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

/** Brings the pointer to a place of the scan and waits until the page knows what lies there; gives that. */
export async function hoverAt(page, place) {
  const { x, y } = await onScreen(page, place);
  await page.mouse.move(x, y);
  const near = (p) => {
    const hover = window.viewer.state.hover;
    return hover && Math.hypot(...hover.position.map((c, k) => c - p[k])) < 1.5;
  };
  await page.waitForFunction(near, place, { timeout: 10000 });
  return state(page, 's.hover');
}
