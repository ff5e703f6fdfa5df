// Screenshots of the stage, kept in build/web, and compared with those in test/reference. SPDX-License-Identifier: Apache-2.0
//   TS_WEB_STORE=1 stores what is seen as the reference: look at it before you commit it.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

const SEEN = new URL('../../../build/web/pictures/', import.meta.url).pathname;
const REFERENCE = new URL('reference/', import.meta.url).pathname;
/** Share of pixels that may differ: edges of lines and of the surface, which another rasteriser draws otherwise. */
const TOLERANCE = 0.01;

/** A picture of the whole page, to look at. */
export async function keep(page, name) {
  mkdirSync(SEEN, { recursive: true });
  await page.screenshot({ path: `${SEEN}${name}.png` });
}

/** The share of the stage's pixels that are not as in the reference; texts are left out, since fonts differ. */
export async function differing(page, name) {
  await keep(page, name);
  const texts = await page.addStyleTag({ content: '#tags, #hint, #status { visibility: hidden } #canvas { outline: none !important }' });
  const bytes = await page.locator('#stage').screenshot();
  await texts.evaluate((element) => element.remove());
  const file = `${REFERENCE}${name}.png`;
  if (process.env.TS_WEB_STORE) writeFileSync(file, bytes);
  if (!existsSync(file)) throw new Error(`no ${file}: TS_WEB_STORE=1 stores it`);
  const [seen, reference] = [PNG.sync.read(bytes), PNG.sync.read(readFileSync(file))];
  if (seen.width !== reference.width || seen.height !== reference.height) return 1;
  const difference = new PNG({ width: seen.width, height: seen.height });
  const count = pixelmatch(seen.data, reference.data, difference.data, seen.width, seen.height, { threshold: 0.15 });
  const share = count / (seen.width * seen.height);
  if (share > TOLERANCE) writeFileSync(`${SEEN}${name}-difference.png`, PNG.sync.write(difference));
  return share;
}

export { TOLERANCE };
