// Every block of statuses; what is left after an error; objects disposed of and busy. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { before, test } from 'node:test';

import {
  Context, EditError, FeatureError, Features, FileError, Jaw, MeshError, Model, NumberError, OutputFormat, ResourceError,
  Segmentation, SegmentationError, Status, ToothMeshError, ToothsegError, Unit, UsageError, universalToFdi,
} from 'toothseg';

import { errorOf } from '../lib/errors.js';
import { asText, failsWith, inFolder, prepared, scan, wantedLabels } from './common.js';

let context, model, features, segmentation;
before(() => {
  ({ context, model, features, segmentation } = prepared());
  segmentation.segmentAllSync();
});

const plane = (size, n) => {
  const positions = new Float64Array(3 * n * n);
  const triangles = [];
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      positions.set([(size * x) / (n - 1), (size * y) / (n - 1), 0], 3 * (n * y + x));
      const a = n * y + x;
      if (x < n - 1 && y < n - 1) triangles.push(a, a + 1, a + n, a + 1, a + n + 1, a + n);
    }
  return { positions, triangles };
};

test('100: usage', () => {
  failsWith(UsageError, 'TS_E_NOT_FOUND', () => segmentation.tooth(4711));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Model.loadSync(context, scan, { weldTolerance: -1 }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => universalToFdi(33));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => new Context({ threads: 1025 }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.clickSync([0, NaN, 0]));
  failsWith(UsageError, 'TS_E_BUFFER_TOO_SMALL', () => segmentation.labels(new Uint32Array(3)));
});

test('100: what this layer refuses before the library sees it', () => {
  for (const tooth of [-1, 1.5, NaN, '1', undefined, 2 ** 32])
    failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.tooth(tooth));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.clickSync([1, 2]));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.clicksSync([[1, 2, 3], 'abc']));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.labels(new Float64Array(1e6)));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Model.loadSync(context, `${scan}\0`));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Model.createSync(context, { positions: [0, 0, 0] }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Model.createSync(context, { positions: new Float32Array(4) }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Features.detectSync(model, { maxPoint: 4 }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Features.detectSync(model, { maxPoints: 4.5 }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Segmentation.createSync(features, { memoryLimit: -1n }));
  for (const bytes of [-1, 1.5, -1n, '1']) failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.setHistoryLimit(bytes));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => new Model());
  failsWith(UsageError, 'TS_E_NULL', () => Features.detectSync(features));
  failsWith(UsageError, 'TS_E_NULL', () => Model.loadSync(null, scan));
});

test('asynchronous calls reject with the same errors', async () => {
  await failsWith(UsageError, 'TS_E_NOT_FOUND', segmentation.toothMesh(4711));
  await failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', segmentation.click('here'));
  await failsWith(FileError, 'TS_E_FILE_OPEN', Model.load(context, inFolder('nothing.stl')));
  await failsWith(SegmentationError, 'TS_E_CLICK_OFF_SURFACE', segmentation.click([0, 0, 500]));
  const error = await Model.load(context, inFolder('nothing.stl')).catch((e) => e);
  assert.match(error.message, /ts_model_load: .*nothing\.stl/);
  assert.match(error.stack, /errors\.test\.js/);
});

test('200: surroundings', () => {
  const small = new Context({ threads: 1, memory: { allocate: () => false } });
  failsWith(ResourceError, 'TS_E_OUT_OF_MEMORY', () => Model.loadSync(small, scan));
  small.dispose();
  let full = false;
  const limited = new Context({ threads: 1, memory: { allocate: () => !full } });
  const own = Model.loadSync(limited, scan);
  const found = Features.detectSync(own);
  full = true;
  failsWith(ResourceError, 'TS_E_OUT_OF_MEMORY', () => Segmentation.createSync(found));
  full = false;
  const enough = Segmentation.createSync(found);
  full = true;
  failsWith(ResourceError, 'TS_E_OUT_OF_MEMORY', () => enough.segmentAllSync());
  assert.deepEqual(enough.teeth(), []);
  full = false;
  enough.segmentAllSync();
  assert.equal(asText(enough.labels()), wantedLabels);
  for (const object of [enough, found, own, limited]) object.dispose();

  const one = new Context({ threads: 1 });
  failsWith(ResourceError, 'TS_E_CANCELLED', () => Model.loadSync(one, scan, { onProgress: () => false }));
  one.dispose();
});

test('300: files', () => {
  const bytes = readFileSync(scan);
  const file = (name, content) => (writeFileSync(inFolder(name), content), inFolder(name));
  failsWith(FileError, 'TS_E_FILE_OPEN', () => Model.loadSync(context, inFolder('nothing.stl')));
  failsWith(FileError, 'TS_E_FILE_FORMAT', () => Model.readSync(context, new TextEncoder().encode('no mesh at all')));
  failsWith(FileError, 'TS_E_FILE_TRUNCATED', () => Model.loadSync(context, file('short.ply', bytes.subarray(0, -7))));
  failsWith(FileError, 'TS_E_FILE_TRAILING', () => Model.readSync(context, new Uint8Array([...bytes, 1, 2, 3])));
  failsWith(FileError, 'TS_E_FILE_SYNTAX', () => Model.loadSync(context, file('bad.obj', 'v 0 0 0\nv 1 0 x\nf 1 2 3\n')));
  failsWith(FileError, 'TS_E_FILE_WRITE', () => segmentation.saveSync(inFolder('no/such/folder.stl'), OutputFormat.STL));
  failsWith(FileError, 'TS_E_FILE_WRITE', () => segmentation.saveSession(inFolder('no/such/folder.json')));
  failsWith(FileError, 'TS_E_FILE_FORMAT', () => Segmentation.readSessionSync(model, '[1, 2]'));
  try {
    Model.loadSync(context, inFolder('bad.obj'));
    assert.fail();
  } catch (error) {
    assert.match(error.message, /line 2|:2/); // the library's own words
  }
});

test('400: meshes', () => {
  const positions = Float64Array.of(0, 0, 0, 20, 0, 0, 0, 20, 0);
  const make = (changes, options) => () => Model.createSync(context, { positions, triangles: [0, 1, 2], ...changes }, options);
  failsWith(MeshError, 'TS_E_MESH_EMPTY', make({ triangles: [0, 1, 1] }));
  failsWith(MeshError, 'TS_E_MESH_NON_FINITE', make({ positions: positions.map((x) => x / 0) }));
  failsWith(MeshError, 'TS_E_MESH_INDEX_RANGE', make({ triangles: [0, 1, 3] }));
  failsWith(MeshError, 'TS_E_MESH_UNITS', make({ positions: positions.map((x) => x / 1000) }));
  failsWith(MeshError, 'TS_E_MESH_TOO_LARGE', make({ positions: positions.map((x) => x * 1e9) }, { unit: Unit.MM }));
  make({ positions: positions.map((x) => x / 1000) }, { unit: Unit.M })().dispose();
});

test('500: features', () => {
  const flat = Model.createSync(context, plane(50, 40));
  failsWith(FeatureError, 'TS_E_NO_TEETH', () => Features.detectSync(flat));
  const none = new Features(model);
  failsWith(FeatureError, 'TS_E_NO_CONSTRAINT', () => Segmentation.createSync(none));
  none.dispose();
  flat.dispose();
});

test('600: segmentation, and nothing is changed by what fails', async () => {
  const one = Segmentation.createSync(features);
  const first = one.clickInfo(one.clickSync(one.proposeClicks()[0])).target;
  const heard = [];
  one.onChange((teeth) => heard.push(teeth));
  const state = () => [asText(one.labels()), one.writeSession(), one.teeth().join()].join('|');
  one.setLocked(first, true);
  const was = state();
  const told = heard.length;
  const low = features.occlusal().map((x, k) => features.groups()[6].centre[k] - 30 * x);
  const { position } = model.nearest(low);
  failsWith(SegmentationError, 'TS_E_CLICK_OFF_SURFACE', () => one.clickSync([0, 0, 500]));
  failsWith(SegmentationError, 'TS_E_CLICK_ON_GINGIVA', () => one.clickSync(position));
  failsWith(SegmentationError, 'TS_E_LOCKED', () => one.removeTooth(first));
  failsWith(SegmentationError, 'TS_E_NO_CHANGE', () => one.setLocked(first, true));
  failsWith(SegmentationError, 'TS_E_NO_HISTORY', () => one.redo());
  await failsWith(SegmentationError, 'TS_E_CLICK_ON_GINGIVA', one.click(position));
  assert.equal(state(), was);
  assert.equal(heard.length, told);
  assert.deepEqual(one.clicksSync([position, [0, 0, 500]]), [Status.E_CLICK_ON_GINGIVA, Status.E_CLICK_OFF_SURFACE]);
  assert.deepEqual(one.clicksSync([]), []);
  one.dispose();
});

test('650: edits', async () => {
  const tooth = segmentation.teeth()[6];
  const at = segmentation.cut(tooth).points[3].position;
  const was = asText(segmentation.labels());
  failsWith(EditError, 'TS_E_EDIT_NOTHING', () => segmentation.offsetCutSync(tooth, 0));
  await failsWith(EditError, 'TS_E_EDIT_NOTHING', segmentation.dragCut(tooth, 0, 3, at));
  failsWith(EditError, 'TS_E_EDIT_NO_LOOP', () => segmentation.offsetCutSync(tooth, -5));
  assert.equal(asText(segmentation.labels()), was);
});

test('700: numbers', () => {
  const one = Segmentation.createSync(features);
  const [a, b] = features.groups().map((group) => group.id);
  one.setNumber(a, 17);
  failsWith(NumberError, 'TS_E_NUMBER_JAW', () => one.setNumber(b, 36));
  failsWith(NumberError, 'TS_E_NUMBER_TAKEN', () => one.setNumber(b, 17));
  failsWith(NumberError, 'TS_E_NUMBER_JAW', () => one.assignNumbers({ jaw: Jaw.LOWER }));
  assert.equal(one.number(a).fdi, 17);
  one.dispose();
});

test('750: meshes of teeth', async () => {
  const noisy = Model.loadSync(context, inFolder('noisy.ply'));
  const found = Features.detectSync(noisy);
  const one = Segmentation.createSync(found);
  one.segmentAllSync();
  failsWith(ToothMeshError, 'TS_E_NOT_CLOSED', () => one.gingivaMeshSync({ closed: true }));
  await failsWith(ToothMeshError, 'TS_E_NOT_CLOSED', one.gingivaMesh({ closed: true }));
  one.gingivaMeshSync().dispose();
  for (const object of [one, found, noisy]) object.dispose();
});

test('a class for each status, known or not', () => {
  for (const [name, status] of Object.entries(Status)) {
    if (status === Status.OK) continue;
    const error = errorOf(status, 'text');
    assert.ok(error instanceof ToothsegError && error instanceof Error && error.constructor !== ToothsegError, name);
    assert.equal(error.code, `TS_${name}`);
  }
  assert.equal(errorOf(699, '').constructor, EditError);
  assert.equal(errorOf(699, '').code, 'TS_E_?');
  assert.equal(errorOf(9999, '').constructor, ToothsegError);
});

test('disposed objects refuse, in whatever order they went', async () => {
  const all = prepared();
  all.context.dispose();
  failsWith(UsageError, 'TS_E_NULL', () => Model.loadSync(all.context, scan));
  all.model.dispose();
  all.model.dispose();
  assert.equal(all.model.disposed, true);
  failsWith(UsageError, 'TS_E_NULL', () => all.model.report());
  failsWith(UsageError, 'TS_E_NULL', () => Features.detectSync(all.model));
  all.features.dispose();
  await all.segmentation.segmentAll({ onProgress: () => true }); // wants the context that was disposed of
  assert.equal(asText(all.segmentation.labels()), wantedLabels);
  const mesh = all.segmentation.toothMeshSync(all.segmentation.teeth()[0]);
  all.segmentation.dispose();
  failsWith(UsageError, 'TS_E_NULL', () => all.segmentation.labels());
  await failsWith(UsageError, 'TS_E_NULL', all.segmentation.click([0, 0, 0]));
  assert.ok(mesh.info().triangles > 0);
  if (Symbol.dispose) mesh[Symbol.dispose]();
  else mesh.dispose();
  failsWith(UsageError, 'TS_E_NULL', () => mesh.info());
});

test('an object that a call is running on refuses others, but for readers beside readers', async () => {
  const one = Segmentation.createSync(features);
  const running = one.segmentAll();
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => one.labels());
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => one.undo());
  await failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', one.click([0, 0, 0]));
  assert.equal(Features.detectSync(model).info().groups, 14); // another object
  await running;
  const mesh = one.toothMesh(one.teeth()[0]);
  assert.equal(asText(one.labels()), wantedLabels);
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => one.undo());
  one.dispose(); // in the middle of it
  failsWith(UsageError, 'TS_E_NULL', () => one.labels());
  assert.ok((await mesh).info().triangles > 0);
});
