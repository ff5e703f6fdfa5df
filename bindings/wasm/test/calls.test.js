// Progress, cancelling, hooks, memory, workers. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { test } from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { Worker } from 'node:worker_threads';

import { asText, bytesOf, drop, entry, failsWith, inFolder, prepared, textOf, toothseg } from './common.js';

const { Context, Features, LogLevel, Model, ResourceError, Segmentation, UsageError, makeArch, memoryUse } = toothseg;

const { model, features } = prepared('arch.ply');

const rises = (fractions) => fractions.every((f, i) => f >= 0 && f <= 1 && (i === 0 || f >= fractions[i - 1]));

test('progress, in both forms', async () => {
  for (const create of [Segmentation.create, Segmentation.createSync]) {
    const seen = [];
    const stages = new Set();
    const onProgress = (fraction, stage) => void (seen.push(fraction), stages.add(stage));
    const segmentation = await create(features, { onProgress });
    assert.ok(seen.length > 3 && rises(seen) && stages.size > 1);
    segmentation.dispose();
  }
});

test('cancelling leaves everything as it was', async () => {
  const segmentation = await Segmentation.create(features);
  const was = segmentation.writeSession();
  await failsWith(ResourceError, 'TS_E_CANCELLED', segmentation.segmentAll({ onProgress: () => false }));
  await assert.rejects(segmentation.segmentAll({ onProgress: () => { throw new RangeError('mine'); } }), { message: 'mine' });
  const cancel = new AbortController();
  const onProgress = (fraction) => fraction > 0.3 && cancel.abort(new Error('enough'));
  await assert.rejects(segmentation.segmentAll({ signal: cancel.signal, onProgress: (f) => void onProgress(f) }), { message: 'enough' });
  const both = new AbortController();
  const fails = () => {
    both.abort();
    throw new RangeError('mine');
  };
  await assert.rejects(segmentation.segmentAll({ signal: both.signal, onProgress: fails }), { message: 'mine' });
  await assert.rejects(segmentation.segmentAll({ signal: AbortSignal.abort(new Error('why')) }), { message: 'why' });
  assert.equal(segmentation.writeSession(), was);
  await segmentation.segmentAll({ signal: new AbortController().signal, onProgress: () => {} });
  assert.equal(asText(segmentation.labels()), textOf('arch.txt'));
  segmentation.dispose();
});

test('the change listener and the log', async () => {
  const lines = [];
  const context = new Context({ log: (level, text) => lines.push([level, text]) });
  const own = await Model.read(context, bytesOf('arch.ply'));
  assert.ok(lines.some(([level, text]) => level === LogLevel.INFO && text.startsWith(`intake: ${own.report().vertices} vertices`)));
  const loud = new Context({ log: (level, text) => { throw new RangeError(text); } });
  assert.throws(() => Model.readSync(loud, bytesOf('arch.ply')), { name: 'RangeError', message: /^intake/ });
  const segmentation = Segmentation.createSync(features);
  const heard = [];
  segmentation.onChange((teeth) => heard.push([...teeth, segmentation.labels().length]));
  const click = await segmentation.click(segmentation.proposeClicks()[0]);
  const { target, neighbour } = segmentation.clickInfo(click);
  assert.deepEqual(heard[0].slice(0, -1).sort(), [target, neighbour].sort());
  segmentation.onChange(() => { throw new RangeError('mine'); });
  assert.throws(() => segmentation.setLocked(target, true), { message: 'mine' });
  assert.equal(segmentation.isLocked(target), true); // the change stands
  segmentation.onChange(null);
  segmentation.setLocked(target, false);
  drop(segmentation, own, context, loud);
});

// A context that counts what the library holds.
function counting() {
  const held = { buffers: 0, bytes: 0 };
  const allocate = (bytes) => void (++held.buffers, (held.bytes += bytes));
  const free = (bytes) => void (--held.buffers, (held.bytes -= bytes));
  return { held, context: new Context({ memory: { allocate, free } }) };
}

test('nothing leaks: of the allocator, and of the module', async () => {
  const { held, context } = counting();
  const first = Model.readSync(context, bytesOf('small.ply'));
  const resting = { ...held };
  assert.ok(resting.buffers > 0 && resting.bytes > 1e5);
  const round = async (i) => {
    const found = Features.detectSync(first);
    const segmentation = await Segmentation.create(found);
    segmentation.onChange(() => {});
    const click = segmentation.clickSync(segmentation.proposeClicks()[0]);
    segmentation.contourPoints(click, 0);
    assert.throws(() => segmentation.clickSync([0, 0, 500]));
    assert.throws(() => Segmentation.createSync(found, { onProgress: (f) => f < 0.5 }));
    assert.throws(() => Model.readSync(context, new Uint8Array(10000)));
    const session = Segmentation.readSessionSync(first, segmentation.writeSession());
    const mesh = segmentation.toothMeshSync(segmentation.teeth()[0]);
    await toothseg.saved((path) => mesh.save(path, toothseg.OutputFormat.PLY));
    makeArch({ triangles: 5000 });
    const objects = [found, segmentation, mesh, session.features, session.segmentation];
    for (let k = 0; k < 5; ++k) objects[(i + k) % 5].dispose();
    assert.deepEqual(held, resting);
  };
  await round(0);
  const { inUse } = memoryUse();
  for (let i = 1; i < 4; ++i) await round(i);
  assert.equal(memoryUse().inUse, inUse);
  drop(context, first);
  assert.deepEqual(held, { buffers: 0, bytes: 0 });
});

test('callbacks are given back', () => {
  const before = memoryUse().inUse;
  for (let i = 0; i < 2000; ++i) counting().context.dispose();
  assert.equal(memoryUse().inUse, before);
});

test('what is forgotten is given back in the end', async () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const { held } = (() => {
    const own = counting();
    const segmentation = Segmentation.createSync(Features.detectSync(Model.readSync(own.context, bytesOf('small.ply'))));
    segmentation.onChange(() => segmentation.labels());
    segmentation.clickSync(segmentation.proposeClicks()[0]);
    return own;
  })();
  assert.ok(held.buffers > 0);
  for (let i = 0; i < 50 && held.buffers > 0; ++i) {
    await new Promise((resolve) => setTimeout(resolve, 10));
    collect();
  }
  assert.equal(held.buffers, 0);
});

test('arrays stay what they are when the memory grows', async () => {
  const before = memoryUse().size;
  const positions = model.positions();
  const copy = [...positions];
  const made = [];
  while (memoryUse().size === before && made.length < 200) made.push(Segmentation.createSync(features));
  assert.ok(memoryUse().size > before);
  assert.deepEqual([...positions], copy);
  assert.deepEqual([...model.positions()], copy);
  made[0].segmentAllSync();
  assert.equal(asText(made[0].labels()), textOf('arch.txt'));
  drop(...made);
});

test('a worker has a module of its own, and is cancelled through shared memory', async () => {
  const text = `
    const { parentPort, workerData } = require('node:worker_threads');
    const { readFileSync } = require('node:fs');
    import(workerData.entry).then(async ({ load, Context, Features, Model, Segmentation }) => {
      await load();
      const context = new Context();
      const features = await Features.detect(await Model.read(context, readFileSync(workerData.scan)));
      const segmentation = await Segmentation.create(features);
      const flag = new Int32Array(workerData.flag);
      parentPort.postMessage('ready');
      Atomics.wait(flag, 0, 0);
      const cancelled = await segmentation.segmentAll({ onProgress: () => Atomics.load(flag, 0) === 0 }).catch((e) => e.code);
      await segmentation.segmentAll();
      const labels = segmentation.labels();
      parentPort.postMessage({ cancelled, labels }, [labels.buffer]);
    });`;
  const flag = new SharedArrayBuffer(4);
  const worker = new Worker(text, { eval: true, workerData: { entry, scan: inFolder('arch.ply'), flag } });
  await once(worker, 'message');
  Atomics.store(new Int32Array(flag), 0, 1);
  Atomics.notify(new Int32Array(flag), 0);
  const [{ cancelled, labels }] = await once(worker, 'message');
  assert.equal(cancelled, 'TS_E_CANCELLED');
  assert.equal(asText(labels), textOf('arch.txt'));
  await worker.terminate();
});

test('a segmentation that is being changed refuses to be changed from its hooks', () => {
  const segmentation = Segmentation.createSync(features);
  let refused;
  const onProgress = () => {
    try {
      segmentation.undo();
    } catch (error) {
      refused = error;
    }
  };
  segmentation.segmentAllSync({ onProgress });
  assert.equal(refused.constructor, UsageError);
  assert.equal(segmentation.teeth().length, 14);
  segmentation.dispose();
});
