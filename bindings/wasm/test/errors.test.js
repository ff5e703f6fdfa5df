// Every block of statuses, objects disposed of, and what can go wrong in loading. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';

import { asText, bytesOf, drop, entry, failsWith, prepared, textOf, toothseg } from './common.js';

const {
  Context, EditError, FeatureError, Features, FileError, Jaw, MeshError, Model, NumberError, OutputFormat, ResourceError,
  Segmentation, SegmentationError, ToothMeshError, Unit, UsageError, files, load, saved, universalToFdi,
} = toothseg;

const { context, model, features, segmentation } = prepared('arch.ply');
segmentation.segmentAllSync();

test('100: usage', async () => {
  failsWith(UsageError, 'TS_E_NOT_FOUND', () => segmentation.tooth(4711));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => universalToFdi(33));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => new Context({ threads: 1025 }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.clickSync([0, NaN, 0]));
  failsWith(UsageError, 'TS_E_BUFFER_TOO_SMALL', () => segmentation.labels(new Uint32Array(3)));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => segmentation.tooth(-1));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Features.detectSync(model, { maxPoint: 4 }));
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => new Model());
  failsWith(UsageError, 'TS_E_NULL', () => Features.detectSync(features));
  failsWith(UsageError, 'TS_E_NULL', () => Model.readSync(null, new Uint8Array(3)));
  await failsWith(UsageError, 'TS_E_NOT_FOUND', segmentation.toothMesh(4711));
});

test('200: surroundings', async () => {
  const limited = (() => {
    let full = false;
    const own = new Context({ memory: { allocate: () => !full } });
    return { own, fill: (is) => (full = is) };
  })();
  const own = Model.readSync(limited.own, bytesOf('arch.ply'));
  const found = Features.detectSync(own);
  limited.fill(true);
  failsWith(ResourceError, 'TS_E_OUT_OF_MEMORY', () => Segmentation.createSync(found));
  limited.fill(false);
  const enough = Segmentation.createSync(found);
  limited.fill(true);
  await failsWith(ResourceError, 'TS_E_OUT_OF_MEMORY', enough.segmentAll());
  limited.fill(false);
  enough.segmentAllSync();
  assert.equal(asText(enough.labels()), textOf('arch.txt'));
  drop(enough, found, own, limited.own);
  failsWith(ResourceError, 'TS_E_CANCELLED', () => Features.detectSync(model, { onProgress: () => false }));
  failsWith(ResourceError, 'TS_E_OUT_OF_MEMORY', () => Segmentation.createSync(features, { memoryLimit: 10 }));
});

test('300: files', async () => {
  const bytes = bytesOf('arch.ply');
  failsWith(FileError, 'TS_E_FILE_OPEN', () => Model.loadSync(context, '/nothing.stl'));
  failsWith(FileError, 'TS_E_FILE_OPEN', () => files.read('/nothing.stl'));
  failsWith(FileError, 'TS_E_FILE_FORMAT', () => Model.readSync(context, new TextEncoder().encode('no mesh at all')));
  files.write('/short.ply', bytes.subarray(0, -7));
  failsWith(FileError, 'TS_E_FILE_TRUNCATED', () => Model.loadSync(context, '/short.ply'));
  failsWith(FileError, 'TS_E_FILE_TRAILING', () => Model.readSync(context, new Uint8Array([...bytes, 1, 2, 3])));
  files.write('/bad.obj', 'v 0 0 0\nv 1 0 x\nf 1 2 3\n');
  failsWith(FileError, 'TS_E_FILE_SYNTAX', () => Model.loadSync(context, '/bad.obj'));
  const error = await Model.load(context, '/bad.obj').catch((e) => e);
  assert.match(error.message, /line 2|:2/); // the library's own words, of asynchronous calls too
  failsWith(FileError, 'TS_E_FILE_WRITE', () => segmentation.saveSync('/no/such/folder.stl', OutputFormat.STL));
  await failsWith(FileError, 'TS_E_FILE_WRITE', saved(() => segmentation.save('/no/such/folder.stl', OutputFormat.STL)));
  failsWith(FileError, 'TS_E_FILE_FORMAT', () => Segmentation.readSessionSync(model, '[1, 2]'));
  files.remove('/bad.obj');
  assert.equal(files.exists('/bad.obj'), false);
});

test('400: meshes', () => {
  const positions = Float64Array.of(0, 0, 0, 20, 0, 0, 0, 20, 0);
  const make = (changes, options) => () => Model.createSync(context, { positions, triangles: [0, 1, 2], ...changes }, options);
  failsWith(MeshError, 'TS_E_MESH_EMPTY', make({ triangles: [0, 1, 1] }));
  failsWith(MeshError, 'TS_E_MESH_INDEX_RANGE', make({ triangles: [0, 1, 3] }));
  failsWith(MeshError, 'TS_E_MESH_NON_FINITE', make({ positions: positions.map(() => NaN) }));
  failsWith(MeshError, 'TS_E_MESH_UNITS', make({ positions: positions.map((x) => x / 1000) }));
  failsWith(MeshError, 'TS_E_MESH_TOO_LARGE', make({ positions: positions.map((x) => x * 1e9) }, { unit: Unit.MM }));
  make({ positions: positions.map((x) => x / 1000) }, { unit: Unit.M })().dispose();
});

test('500: features', () => {
  const square = Float64Array.of(0, 0, 0, 30, 0, 0, 30, 30, 0, 0, 30, 0);
  const flat = Model.createSync(context, { positions: square, triangles: [0, 1, 2, 0, 2, 3] }, { unit: Unit.MM });
  failsWith(FeatureError, 'TS_E_NO_TEETH', () => Features.detectSync(flat));
  const none = new Features(model);
  failsWith(FeatureError, 'TS_E_NO_CONSTRAINT', () => Segmentation.createSync(none));
  drop(none, flat);
});

test('600, 650, 700: clicks, edits, numbers; and nothing is changed by what fails', async () => {
  const was = segmentation.writeSession();
  await failsWith(SegmentationError, 'TS_E_CLICK_OFF_SURFACE', segmentation.click([0, 0, 500]));
  const fresh = Segmentation.createSync(features);
  failsWith(SegmentationError, 'TS_E_NO_HISTORY', () => fresh.undo());
  const [tooth] = segmentation.teeth();
  failsWith(EditError, 'TS_E_EDIT_NOTHING', () => segmentation.offsetCutSync(tooth, 0));
  await failsWith(EditError, 'TS_E_EDIT_NO_LOOP', segmentation.offsetCut(tooth, -5));
  assert.equal(segmentation.writeSession(), was);
  const [a, b] = features.groups().map((group) => group.id);
  fresh.setNumber(a, 17);
  failsWith(NumberError, 'TS_E_NUMBER_JAW', () => fresh.setNumber(b, 36));
  failsWith(NumberError, 'TS_E_NUMBER_TAKEN', () => fresh.setNumber(b, 17));
  failsWith(NumberError, 'TS_E_NUMBER_JAW', () => fresh.assignNumbers({ jaw: Jaw.LOWER }));
  fresh.dispose();
});

test('750: meshes of teeth', () => {
  const own = prepared('isotropic.ply');
  own.segmentation.segmentAllSync();
  failsWith(ToothMeshError, 'TS_E_NOT_CLOSED', () => own.segmentation.gingivaMeshSync({ closed: true }));
  drop(...Object.values(own));
});

test('disposed objects refuse, in whatever order they went', async () => {
  const all = prepared('arch.ply');
  all.context.dispose();
  failsWith(UsageError, 'TS_E_NULL', () => Model.readSync(all.context, bytesOf('arch.ply')));
  drop(all.model, all.model);
  assert.equal(all.model.disposed, true);
  failsWith(UsageError, 'TS_E_NULL', () => all.model.report());
  await all.segmentation.segmentAll({ onProgress: () => true }); // wants the context that was disposed of
  assert.equal(asText(all.segmentation.labels()), textOf('arch.txt'));
  const mesh = all.segmentation.toothMeshSync(all.segmentation.teeth()[0]);
  all.segmentation.dispose();
  failsWith(UsageError, 'TS_E_NULL', () => all.segmentation.labels());
  await failsWith(UsageError, 'TS_E_NULL', all.segmentation.click([0, 0, 0]));
  assert.ok(mesh.info().triangles > 0);
  drop(mesh, all.features);
  failsWith(UsageError, 'TS_E_NULL', () => mesh.info());
});

test('loading: before it, with what is no module, and again', async () => {
  const run = (text) => {
    const code = `import * as t from ${JSON.stringify(entry)};\n${text}`;
    const { status, stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', code], { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    return stdout.trim();
  };
  const tried = run(`
    const say = (e) => console.log(e.message);
    try { new t.Context(); } catch (e) { say(e); }
    await t.load({ wasm: new Uint8Array([1, 2, 3]) }).catch((e) => console.log(e.name));
    const [a, b] = await Promise.all([t.load(), t.load()]);
    console.log(a === b, t.version());`);
  assert.equal(tried, `toothseg is not loaded yet: await load() first\nCompileError\ntrue ${toothseg.version()}`);
  const bytes = JSON.stringify(entry.replace('index.node.js', 'lib/toothseg.wasm'));
  const other = run(`
    import { readFile } from 'node:fs/promises';
    const binary = await readFile(new URL(${bytes}));
    await t.load({ wasm: new Response(binary, { headers: { 'content-type': 'application/wasm' } }) });
    console.log(t.version());`);
  assert.equal(other, toothseg.version());
  assert.equal(await load(), await load());
});
