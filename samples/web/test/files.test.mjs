// Files in and out. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Context, Model, Features, Segmentation, load, makeArch } from 'toothseg-wasm';
import { openEdges, readPly, readStl, readZip } from './files.mjs';
import { clickAt, download, drop, labels, openArch, openPage, settled, state, status } from './page.mjs';

let page, faults, close, session, ply;
before(async () => {
  await load();
  ({ page, faults, close } = await openPage());
});
after(() => close?.());

test('a session without its scan is told what is missing', async () => {
  await drop(page, 'arch.toothseg.json', Buffer.from('{}'));
  assert.match(await status(page), /Open the scan first/);
});

test('teeth as STL in one zip: a file a tooth, each closed', async () => {
  await openArch(page, 20000);
  await clickAt(page, (await state(page, 's.now.proposals'))[2]);
  const fdi = await state(page, 's.now.teeth.map((t) => t.fdi)');
  const { name, bytes } = await download(page, 'Teeth (STL, zip)');
  assert.equal(name, 'arch_teeth.zip');
  const files = readZip(bytes);
  assert.deepEqual([...files.keys()].sort(), fdi.map((n) => `tooth_${n}.stl`).sort());
  for (const [file, stl] of files) {
    const triangles = readStl(stl);
    assert.ok(triangles.length > 500, `${file}: ${triangles.length} triangles`);
    assert.equal(openEdges(triangles), 0, file);
  }
});

test('open teeth, where that is chosen, have a rim', async () => {
  await page.uncheck('text=Closed teeth');
  const files = readZip((await download(page, 'Teeth (STL, zip)')).bytes);
  for (const stl of files.values()) assert.ok(openEdges(readStl(stl)) > 20);
  await page.check('text=Closed teeth');
});

test('the labelled PLY has the labels that are seen, and is a scan that opens again', async () => {
  const file = await download(page, 'Labelled scan (PLY)');
  ply = file.bytes;
  assert.equal(file.name, 'arch_teeth.ply');
  const seen = await labels(page);
  const read = readPly(ply);
  assert.deepEqual(read.labels, seen);
  const colours = new Set(read.colours.map((c) => c.join()));
  assert.equal(colours.size, 3);
  const model = await Model.read(new Context({ threads: 1 }), new Uint8Array(ply));
  assert.equal(model.report().faces, seen.length);
  model.dispose();
});

test('the session opens again, byte for byte, and goes on', async () => {
  await clickAt(page, (await state(page, 's.now.proposals'))[0]);
  const before = await labels(page);
  session = (await download(page, 'Session')).bytes;
  await page.reload();
  await page.waitForFunction(() => window.viewer?.ready());
  await openArch(page, 20000);
  await drop(page, 'arch.toothseg.json', session);
  assert.match(await status(page), /Session opened: 4 teeth/);
  assert.deepEqual(await labels(page), before);
  assert.equal(await state(page, 's.now.undo'), 2);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal(await state(page, 's.now.teeth.length'), 0);
  await page.keyboard.press('Control+y');
  await settled(page);
  assert.equal(await state(page, 's.now.teeth.length'), 2);
});

test('broken files are answered with a sentence, and what is open stays', async () => {
  const before = await labels(page);
  const cases = [
    ['cut.ply', ply.subarray(0, ply.length / 2), /ends too early/],
    ['letter.stl', Buffer.from('Dear colleague, here is the scan.'), /no scan that can be read/],
    ['empty.obj', Buffer.from('# nothing\nv 0 0 0\n'), /no surface|no scan/],
    ['cube.off', Buffer.from('OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n'), /millimetres/],
    ['broken.toothseg.json', session.subarray(0, session.length / 2), /\.$/],
  ];
  for (const [name, bytes, sentence] of cases) {
    await drop(page, name, bytes);
    assert.match(await status(page), sentence, name);
    assert.equal(await page.getAttribute('#status', 'class'), 'bad', name);
    assert.doesNotMatch(await status(page), /TS_E_|undefined|\[object/, name);
    assert.deepEqual(await labels(page), before, name);
  }
});

test('a scan that is chosen as a file opens, and gives the labels of the library itself', async () => {
  await page.setInputFiles('#file', { name: 'mine.ply', mimeType: 'application/octet-stream', buffer: ply });
  await page.waitForFunction(() => window.viewer.state.opened?.name === 'mine.ply' && window.viewer.idle());
  const [place] = await state(page, 's.now.proposals');
  await page.keyboard.press('a');
  await settled(page);
  const model = await Model.read(new Context({ threads: 1 }), new Uint8Array(ply));
  const segmentation = await Segmentation.create(await Features.detect(model));
  assert.deepEqual(segmentation.proposeClicks()[0], place);
  await segmentation.segmentAll();
  assert.deepEqual(await labels(page), [...segmentation.labels()]);
});

/** The mesh as text or bytes of each format that is read. */
const WRITERS = {
  stl: ({ positions, triangles }) => {
    const bytes = Buffer.alloc(84 + (50 * triangles.length) / 3);
    bytes.writeUInt32LE(triangles.length / 3, 80);
    triangles.forEach((v, i) => {
      for (let k = 0; k < 3; ++k) bytes.writeFloatLE(positions[3 * v + k], 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3) + 4 * k);
    });
    return bytes;
  },
  obj: (mesh) => Buffer.from([...rows(mesh.positions).map((p) => `v ${p.join(' ')}`),
    ...rows(mesh.triangles).map((t) => `f ${t.map((v) => v + 1).join(' ')}`)].join('\n')),
  off: (mesh) => Buffer.from(['OFF', `${mesh.positions.length / 3} ${mesh.triangles.length / 3} 0`,
    ...rows(mesh.positions).map((p) => p.join(' ')), ...rows(mesh.triangles).map((t) => `3 ${t.join(' ')}`), ''].join('\n')),
};
const rows = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.subarray(3 * i, 3 * i + 3)]);

test('STL, OBJ and OFF open when they are dropped', async () => {
  const small = makeArch({ jaw: 2, triangles: 12000, seed: 2 });
  for (const [ending, write] of Object.entries(WRITERS)) {
    await drop(page, `small.${ending}`, write(small));
    assert.equal(await state(page, 's.opened.name'), `small.${ending}`, await status(page));
    assert.equal(await state(page, 's.opened.faces'), small.triangles.length / 3);
    assert.equal(await state(page, 's.points.groups.length'), small.teeth.length);
  }
});

test('the session of another scan is refused in a sentence', async () => {
  await drop(page, 'arch.toothseg.json', session);
  assert.match(await status(page), /belongs to another scan/);
});

test('no error in the console', () => assert.deepEqual(faults, []));
