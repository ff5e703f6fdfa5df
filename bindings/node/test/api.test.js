// The public layer at work on a synthetic arch. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';

import {
  Background, EditKind, Features, FileFormat, Jaw, MeshVertexFlag, Model, NONE, OutputFormat, Preset, Segmentation, Status,
  UsageError, fdiToPalmer, fdiToUniversal, universalToFdi,
} from 'toothseg';

import { asText, failsWith, inFolder, prepared, scan, wantedLabels } from './common.js';

const sample = (name, ...args) =>
  execFileSync(process.execPath, [new URL(`../samples/${name}`, import.meta.url).pathname, ...args], { encoding: 'utf8', stdio: 'pipe' });

const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

let context, model, features, segmentation;
before(() => {
  ({ context, model, features, segmentation } = prepared());
  segmentation.segmentAllSync();
});

test('labels are those of ts-segment, byte for byte', async () => {
  assert.equal(asText(segmentation.labels()), wantedLabels);
  const clicked = await Segmentation.create(features);
  assert.deepEqual(await clicked.clicks(clicked.proposeClicks()), Array(7).fill(Status.OK));
  assert.equal(asText(clicked.labels()), wantedLabels);
  const paper = await Segmentation.create(features, { preset: Preset.PAPER });
  await paper.segmentAll();
  assert.notEqual(asText(paper.labels()), wantedLabels);
  clicked.dispose();
  paper.dispose();
});

test('segment_arch writes what ts-segment writes, by clicks and at once, and teeth', () => {
  const labels = inFolder('sample.txt');
  const teeth = inFolder('teeth');
  sample('segment_arch.js', scan, '--labels', labels, '--teeth', teeth);
  assert.equal(readFileSync(labels, 'utf8'), wantedLabels);
  const label = segmentation.tooth(segmentation.teeth()[3]).label;
  const triangles = segmentation.toothMeshSync(segmentation.teeth()[3]).info().triangles;
  assert.equal(statSync(join(teeth, `tooth_${label}.stl`)).size, 84 + 50 * triangles);
  sample('segment_arch.js', scan, '--all', '--labels', labels);
  assert.equal(readFileSync(labels, 'utf8'), wantedLabels);
});

test('hello_tooth prints a cut', () => {
  const lines = sample('hello_tooth.js', scan).trim().split('\n').map((line) => line.split(' ').map(Number));
  assert.ok(lines.length > 50 && lines.every((xyz) => xyz.length === 3 && xyz.every(Number.isFinite)));
  for (const xyz of lines) assert.ok(model.nearest(xyz).distance < 1e-3);
});

test('a model of arrays, of bytes and of a file are one', async () => {
  const positions = model.positions();
  const triangles = model.triangles();
  const report = model.report();
  assert.equal(positions.length, 3 * report.vertices);
  assert.equal(triangles.length, 3 * report.faces);
  assert.equal('structSize' in report, false);
  const strided = new Float32Array(4 * report.vertices - 1).fill(NaN);
  const soup = new Float64Array(3 * triangles.length);
  positions.forEach((x, i) => (strided[4 * Math.floor(i / 3) + (i % 3)] = x));
  triangles.forEach((v, i) => soup.set(positions.subarray(3 * v, 3 * v + 3), 3 * i));
  const made = [
    Model.createSync(context, { positions, triangles }),
    await Model.create(context, { positions: Float32Array.from(positions), triangles: [...triangles] }),
    Model.createSync(context, { positions: strided, triangles, stride: 4 }),
    await Model.create(context, { positions: soup }),
    Model.readSync(context, readFileSync(scan), { format: FileFormat.PLY }),
    await Model.read(context, new Uint8Array(readFileSync(scan)).buffer),
    await Model.load(context, scan),
  ];
  for (const other of made) {
    assert.equal(other.report().faces, report.faces);
    assert.deepEqual(other.triangles().length, triangles.length);
    const into = new Float64Array(positions.length + 3);
    const filled = other.positions(into);
    assert.equal(filled.buffer, into.buffer);
    assert.equal(filled.length, positions.length);
    assert.ok(Math.abs(other.report().area - report.area) < 1e-3);
    other.dispose();
  }
  assert.equal(model.faceSources().length, report.faces);
  assert.equal(model.vertexMap().length, report.inputVertices);
});

test('picking', () => {
  const [x, y, z] = segmentation.proposeClicks()[0] ?? features.points()[0].position;
  const at = model.nearest([x, y, z]);
  assert.ok(at.distance < 0.5);
  assert.ok(Math.abs(at.barycentric.reduce((a, b) => a + b) - 1) < 1e-9);
  const hit = model.raycast([x, y, z + 50], Float32Array.of(0, 0, -2));
  assert.ok(Math.abs(hit.position[0] - x) < 1e-9 && hit.distance > 0);
  failsWith(UsageError, 'TS_E_NOT_FOUND', () => model.raycast([x, y, z + 50], [0, 0, 1]));
});

test('features, by hand and found', () => {
  const { groups, points, archLength, insideOut } = features.info();
  assert.equal(groups, 14);
  assert.equal(insideOut, false);
  assert.ok(archLength > 60 && features.arch().length % 3 === 0 && features.arch().length > 30);
  assert.equal(features.points().length, points);
  const [first, second] = features.groups();
  assert.equal(first.previous, NONE);
  assert.equal(first.next, second.id);
  const copy = features.clone();
  const added = copy.addPoint(second.centre, second.id);
  assert.equal(added.group, second.id);
  assert.equal(copy.points().find((p) => p.id === added.point).byHand, true);
  copy.movePoint(added.point, first.centre);
  const fresh = copy.setGroup(added.point);
  assert.equal(copy.info().groups, 15);
  assert.equal(copy.setGroup(added.point, first.id), first.id);
  assert.equal(copy.groups().some((g) => g.id === fresh), false);
  copy.removePoint(added.point);
  copy.removeGroup(first.id);
  assert.equal(copy.info().groups, 13);
  assert.equal(features.info().groups, 14);
  copy.dispose();

  const own = new Features(model);
  own.setOcclusal([0, 0, 2]);
  assert.deepEqual(own.occlusal(), [0, 0, 1]);
  for (const group of features.groups().slice(0, 2)) own.addPoint(group.centre);
  assert.equal(own.info().groups, 2);
  own.dispose();
});

test('what a click did', () => {
  const one = Segmentation.createSync(features, { contours: 60, background: Background.ALL, rejectOutliers: false });
  const number = one.clickSync(one.proposeClicks()[0]);
  assert.equal(one.clickCount(), 1);
  const click = one.clickInfo(number);
  assert.deepEqual(one.teeth().length, 2);
  assert.ok(one.teeth().includes(click.target) && one.teeth().includes(click.neighbour));
  assert.ok(click.ms.total > 0 && click.vMed >= 0);
  assert.equal(one.field(number).length, model.report().vertices);
  assert.equal(one.histogram(number).length, 50);
  const contours = one.contours(number);
  assert.equal(contours.length, 60);
  const chosen = contours.findIndex((c) => c.points > 0);
  const lines = one.contourPoints(number, chosen);
  assert.equal(lines.length, contours[chosen].polylines);
  assert.equal(lines.reduce((n, line) => n + line.points.length, 0), contours[chosen].points);
  failsWith(UsageError, 'TS_E_NOT_FOUND', () => one.contourPoints(number, 60));
  assert.ok(one.prepareTimes().factorise > 0);
  assert.ok(one.memory().factor > 0);
  one.dispose();
});

test('teeth', () => {
  const teeth = segmentation.teeth();
  assert.equal(teeth.length, 14);
  const tooth = segmentation.tooth(teeth[4]);
  assert.equal(tooth.id, teeth[4]);
  assert.equal(segmentation.toothFaces(tooth.id).length, tooth.faces);
  assert.equal(segmentation.toothVertices(tooth.id).length, tooth.vertices);
  assert.ok(segmentation.toothSeeds(tooth.id).length > 0);
  const { info, points } = segmentation.cut(tooth.id);
  assert.equal(points.length, info.points);
  assert.equal(info.closed, true);
  const [a, b] = [points[0].position, points[1].position];
  assert.ok(distance(a, b) < info.length);
  const frame = segmentation.toothFrame(tooth.id);
  assert.equal(frame.fromArch, true);
  assert.ok(frame.width > 2 && frame.occlusal.length === 3);
  for (const item of segmentation.review()) assert.equal(typeof item.separated, 'boolean');
  for (const overlap of segmentation.overlaps()) assert.ok(overlap.faces > 0);
  const room = new Uint32Array(segmentation.labels().length);
  assert.equal(segmentation.labels(room), room);
});

test('numbers', () => {
  const one = Segmentation.createSync(features);
  one.segmentAllSync();
  failsWith(UsageError, 'TS_E_NOT_FOUND', () => one.jaw());
  one.assignNumbers({ jaw: Jaw.UPPER });
  assert.deepEqual(one.jaw(), { jaw: Jaw.UPPER, given: true, uncertain: false, confidence: 1 });
  const numbers = one.teeth().map((tooth) => one.number(tooth).fdi);
  assert.deepEqual([...numbers].sort(), [11, 12, 13, 14, 15, 16, 17, 21, 22, 23, 24, 25, 26, 27]);
  one.setNumber(one.teeth()[0], numbers[0]);
  assert.equal(one.number(one.teeth()[0]).setByHand, true);
  assert.equal(fdiToUniversal(36), 19);
  assert.equal(universalToFdi(19), 36);
  assert.deepEqual(fdiToPalmer(16), { quadrant: 1, position: 6, letters: 'UR6', symbol: fdiToPalmer(16).symbol });
  assert.match(fdiToPalmer(16).symbol, /^6.$/u);
  one.dispose();
});

test('corrections, history, changes, session', async () => {
  const one = Segmentation.createSync(features);
  one.segmentAllSync();
  const heard = [];
  one.onChange((teeth) => heard.push(teeth));
  const [tooth, other] = one.teeth();
  const centre = one.toothFrame(tooth).centre;

  one.setLocked(tooth, true);
  assert.equal(one.isLocked(tooth), true);
  assert.deepEqual(heard.at(-1), [tooth]);
  one.setLocked(tooth, false);
  const before = one.labels();
  await one.mergeTeeth(tooth, other);
  assert.equal(one.teeth().includes(other), false);
  assert.deepEqual(one.changes(), heard.at(-1));
  one.undo();
  assert.deepEqual(one.labels(), before);
  one.redo();
  assert.equal(one.teeth().includes(other), false);
  one.undo();
  assert.ok(one.history().undo > 0 && one.history().complete === true);

  const points = features.points().filter((p) => p.group === tooth).map((p) => p.position);
  const far = points.reduce((best, p) => (distance(p, points[0]) > distance(best, points[0]) ? p : best));
  const second = one.splitToothSync(tooth, points[0], far);
  assert.ok(one.teeth().includes(second));
  one.undo();
  one.excludePointSync(tooth, far);
  await one.includePoint(tooth, far);
  one.undo();
  one.undo();
  const nearby = model.nearest(points[0].map((x, k) => x + (centre[k] - x) / 3)).position;
  await one.movePoint(tooth, points[0], nearby);
  one.removeTooth(other);
  assert.equal(one.teeth().length, 13);

  one.onChange(null);
  const count = heard.length;
  one.undo();
  assert.equal(heard.length, count);

  const path = inFolder('arch.session.json');
  one.saveSession(path);
  const text = one.writeSession();
  assert.equal(readFileSync(path, 'utf8'), text);
  for (const again of [
    await Segmentation.loadSession(model, path),
    Segmentation.loadSessionSync(model, path),
    await Segmentation.readSession(model, text),
    Segmentation.readSessionSync(model, text),
  ]) {
    assert.deepEqual(again.segmentation.labels(), one.labels());
    assert.equal(again.features.info().points, features.info().points);
    again.segmentation.dispose();
    again.features.dispose();
  }
  one.setHistoryLimit(0n);
  assert.equal(one.history().undo, 0);
  one.dispose();
});

test('edits of a cut', async () => {
  const one = Segmentation.createSync(features);
  one.segmentAllSync();
  const tooth = one.teeth()[6];
  const points = one.cut(tooth).points;
  const length = one.cut(tooth).info.length;
  const { centre, buccal } = one.toothFrame(tooth);
  // The point that is furthest out to the cheek, away from the neighbours, and a way from there towards the crown.
  const out = ({ position }) => position.reduce((sum, x, k) => sum + (x - centre[k]) * buccal[k], 0);
  const at = points.reduce((best, p, i) => (out(p) > out(points[best]) ? i : best), 0);
  const inward = (p, mm) => model.nearest(p.map((x, k) => x + ((centre[k] - x) * mm) / distance(p, centre))).position;
  const near = (i) => points.at((at + i) % points.length).position;
  await one.offsetCut(tooth, -0.2);
  assert.ok(one.cut(tooth).info.length < length);
  one.smoothCutSync(tooth, 0.5);
  assert.deepEqual(one.cutEdits(tooth).map((e) => [e.kind, e.status, e.amount]),
    [[EditKind.OFFSET, Status.OK, -0.2], [EditKind.SMOOTH, Status.OK, 0.5]]);
  one.resetCut(tooth);
  assert.deepEqual(one.cut(tooth).points, points);
  await one.dragCut(tooth, 0, at, inward(near(0), 0.4), { reach: 2 });
  assert.equal(one.cutEdits(tooth)[0].kind, EditKind.DRAG);
  assert.equal(one.cutEdits(tooth)[0].amount, 2);
  one.undo();
  one.drawCutSync(tooth, [near(-8), inward(near(-4), 0.5), inward(near(4), 0.5), near(8)]);
  assert.equal(one.cutEdits(tooth)[0].kind, EditKind.DRAW);
  assert.equal(one.cutEdits(tooth)[0].points, 4);
  one.dispose();
});

test('meshes and files', async () => {
  const tooth = segmentation.teeth()[5];
  const open = segmentation.toothMeshSync(tooth);
  const closed = await segmentation.toothMesh(tooth, { closed: true });
  const gingiva = await segmentation.gingivaMesh();
  assert.equal(closed.info().openRims, 0);
  assert.ok(closed.info().volume > 10);
  assert.ok(open.info().openRims > 0);
  const { vertices, triangles } = closed.info();
  assert.equal(closed.positions().length, 3 * vertices);
  assert.equal(closed.normals().length, 3 * vertices);
  assert.equal(closed.triangles().length, 3 * triangles);
  assert.equal(closed.faces().at(-1), NONE);
  assert.ok(closed.vertexFlags().some((f) => f & MeshVertexFlag.ON_CUT));
  const path = inFolder('tooth.stl');
  await closed.save(path, OutputFormat.STL);
  assert.equal(statSync(path).size, 84 + 50 * triangles);
  gingiva.saveSync(inFolder('gingiva.obj'), OutputFormat.OBJ);
  await segmentation.save(inFolder('all.ply'), OutputFormat.PLY, { wholeFaces: true });
  segmentation.saveSync(inFolder('all.glb'), OutputFormat.GLB);
  for (const name of ['gingiva.obj', 'all.ply', 'all.glb']) assert.ok(existsSync(inFolder(name)));
  const back = await Model.load(context, inFolder('all.ply'));
  assert.equal(back.report().faces, model.report().faces);
  for (const object of [open, closed, gingiva, back]) object.dispose();
});
