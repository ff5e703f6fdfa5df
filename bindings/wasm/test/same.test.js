// What the module makes, beside what the native library made of the same. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { asText, bytesOf, drop, inFolder, prepared, programs, textOf, toothseg } from './common.js';

const { Features, FileFormat, Jaw, Model, OutputFormat, Segmentation, files, makeArch, saved } = toothseg;

for (const scan of ['arch', 'crowded', 'noisy'])
  test(`labels of ${scan} are those of ts-segment, byte for byte`, async () => {
    const { context, model, features, segmentation } = prepared(`${scan}.ply`);
    await segmentation.segmentAll();
    assert.ok(segmentation.teeth().length > 10);
    assert.equal(asText(segmentation.labels()), textOf(`${scan}.txt`));
    const clicked = Segmentation.createSync(features);
    for (const position of clicked.proposeClicks()) await clicked.click(position);
    assert.equal(clicked.teeth().length, segmentation.teeth().length);
    assert.equal(asText(clicked.labels()), textOf(`${scan}.txt`));
    drop(clicked, segmentation, features, model, context);
  });

test('the arch is that of make-arch', () => {
  const arch = makeArch({ triangles: 20000, seed: 1 });
  const { context, model, features, segmentation } = prepared('arch.ply');
  assert.deepEqual(model.triangles(), arch.triangles);
  assert.deepEqual(Float32Array.from(model.positions()), Float32Array.from(arch.positions)); // the file has floats
  assert.equal(arch.labels.length, arch.triangles.length / 3);
  assert.deepEqual([...new Set(arch.labels)].sort((a, b) => a - b), [...Array(15).keys()]);
  assert.deepEqual(arch.teeth, [17, 16, 15, 14, 13, 12, 11, 21, 22, 23, 24, 25, 26, 27]);
  assert.ok(arch.features.length > 28 && arch.features.every((f) => model.nearest(f.position).distance < 1));
  // The separation finds the teeth that the arch was made of.
  segmentation.segmentAllSync();
  const labels = segmentation.labels();
  const right = arch.labels.reduce((n, label, face) => n + ((label === 0) === (labels[face] === 0)), 0);
  assert.ok(right / labels.length > 0.9, `${right} of ${labels.length}`);
  drop(segmentation, features, model, context);
  assert.deepEqual(makeArch({ triangles: 6000, jaw: 2, missing: [36], closed: true }).teeth.includes(36), false);
  assert.throws(() => makeArch({ triangles: 10 }), { code: 'TS_E_INVALID_ARGUMENT', message: /triangles/ });
  assert.throws(() => makeArch({ triangle: 6000 }), { code: 'TS_E_INVALID_ARGUMENT' });
});

test('sessions go to the native library and back', async () => {
  const { context, model, features, segmentation } = prepared('arch.ply');
  const native = textOf('arch.session.json');
  const { features: itsFeatures, segmentation: its } = await Segmentation.readSession(model, native);
  assert.equal(asText(its.labels()), textOf('arch.txt'));
  assert.equal(its.writeSession(), native); // numbers as text too
  its.offsetCutSync(its.teeth()[4], -0.3);
  its.smoothCutSync(its.teeth()[7], 0.5);
  its.setLocked(its.teeth()[2], true);
  its.undo();
  const labels = its.labels();
  assert.notEqual(asText(labels), textOf('arch.txt'));
  files.write('/session.json', its.writeSession());
  const again = Segmentation.loadSessionSync(model, '/session.json');
  assert.deepEqual(again.segmentation.labels(), labels);
  its.saveSession('/saved.json');
  assert.deepEqual(files.read('/saved.json'), files.read('/session.json'));

  writeFileSync(inFolder('wasm.session.json'), its.writeSession());
  const [out, session] = [inFolder('wasm.txt'), inFolder('wasm.session.json')];
  execFileSync(join(programs, 'ts-segment'), [inFolder('arch.ply'), '--session', session, '--labels', out]);
  assert.equal(readFileSync(out, 'utf8'), asText(labels));

  segmentation.segmentAllSync();
  const limited = Segmentation.readSessionSync(model, native.replace(/"memory_limit": \d+/, '"memory_limit": 99999999999'));
  assert.equal(asText(limited.segmentation.labels()), textOf('arch.txt')); // more than there are addresses for
  const all = [limited.segmentation, limited.features, again.segmentation, again.features];
  drop(...all, its, itsFeatures, segmentation, features, model, context);
});

test('meshes of teeth are those of ts-segment, byte for byte', async () => {
  const { context, model, features, segmentation } = prepared('arch.ply');
  segmentation.segmentAllSync();
  for (const tooth of segmentation.teeth()) {
    const mesh = await segmentation.toothMesh(tooth, { closed: true });
    assert.equal(mesh.info().openRims, 0);
    const stl = await saved((path) => mesh.save(path, OutputFormat.STL));
    assert.deepEqual(stl, bytesOf(`teeth/tooth_${segmentation.tooth(tooth).label}.stl`));
    mesh.dispose();
  }
  for (const format of [OutputFormat.PLY, OutputFormat.GLB, OutputFormat.OBJ])
    assert.ok((await saved((path) => segmentation.saveSync(path, format))).length > 1e5);
  drop(segmentation, features, model, context);
});

test('text is read and written to the last digit', async () => {
  const { context, model, features, segmentation } = prepared('arch.ply');
  const positions = model.positions().map((x, i) => x * (1 + 1e-9 * (i % 7)));
  positions.set([1e-320, -2.5e-7, 123456.78901234567], 0); // and one below the normal doubles
  const triples = (array, f) => Array.from({ length: array.length / 3 }, (_, i) => f(array.subarray(3 * i, 3 * i + 3)));
  const lines = [
    ...triples(positions, (p) => `v ${[...p].join(' ')}`),
    ...triples(model.triangles(), (t) => `f ${[...t].map((v) => v + 1).join(' ')}`),
  ];
  const read = await Model.read(context, new TextEncoder().encode(lines.join('\n')), { format: FileFormat.OBJ, unit: 1 });
  const made = await Model.create(context, { positions, triangles: model.triangles() }, { unit: 1 });
  assert.deepEqual(read.positions(), made.positions());
  drop(read, made, segmentation, features, model, context);
});

test('numbers, picking, fields and contours', async () => {
  const { context, model, features, segmentation } = prepared('arch.ply');
  const click = await segmentation.click(segmentation.proposeClicks()[0]);
  const { target, neighbour, ms, vMed } = segmentation.clickInfo(click);
  assert.ok(segmentation.teeth().includes(target) && segmentation.teeth().includes(neighbour));
  assert.ok(ms.total > 0 && vMed >= 0); // a struct within a struct
  assert.equal(segmentation.field(click).length, model.report().vertices);
  assert.equal(segmentation.histogram(click).length, 50);
  const contours = segmentation.contours(click);
  const most = contours.findIndex((c) => c.points > 0);
  const polylines = segmentation.contourPoints(click, most);
  assert.equal(polylines.length, contours[most].polylines);
  assert.equal(polylines.reduce((n, line) => n + line.points.length, 0), contours[most].points);
  segmentation.segmentAllSync();
  segmentation.assignNumbers({ jaw: Jaw.UPPER });
  const numbers = segmentation.teeth().map((tooth) => segmentation.number(tooth).fdi);
  assert.deepEqual([...numbers].sort(), [11, 12, 13, 14, 15, 16, 17, 21, 22, 23, 24, 25, 26, 27]);
  assert.equal(toothseg.fdiToPalmer(16).letters, 'UR6');
  assert.match(toothseg.fdiToPalmer(16).symbol, /^6.$/u);
  assert.equal(toothseg.universalToFdi(19), 36);
  const { position } = model.nearest([...segmentation.toothFrame(target).centre]);
  assert.ok(model.raycast(position.map((x, k) => x + 40 * (k === 2)), [0, 0, -1]).distance < 41);
  segmentation.setHistoryLimit(2n ** 40n); // a number of 64 bits
  assert.ok(segmentation.history().undo > 0);
  const own = new Features(model);
  own.setOcclusal([0, 0, 2]);
  assert.deepEqual(own.occlusal(), [0, 0, 1]);
  drop(own, segmentation, features, model, context);
});

test('arrays of the caller are filled as far as there is something', () => {
  const { context, model, features, segmentation } = prepared('arch.ply');
  segmentation.segmentAllSync();
  const labels = segmentation.labels();
  const room = new Uint32Array(labels.length + 5).fill(77);
  const filled = segmentation.labels(room);
  assert.equal(filled.buffer, room.buffer);
  assert.deepEqual(filled, labels);
  assert.deepEqual([...room.subarray(labels.length)], Array(5).fill(77));
  const wide = new Float64Array(3 * model.report().vertices + 2).fill(7);
  assert.equal(model.positions(wide).length, wide.length - 2);
  assert.deepEqual([...wide.subarray(-2)], [7, 7]);
  drop(segmentation, features, model, context);
});
