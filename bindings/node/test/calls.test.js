// Progress, cancelling, callbacks, threads, memory. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { before, test } from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { Worker } from 'node:worker_threads';

import { Context, Features, LogLevel, Model, ResourceError, Segmentation, UsageError } from 'toothseg';

import { asText, failsWith, inFolder, prepared, scan, smallScan, wantedLabels } from './common.js';

let context, model, features;
before(() => ({ context, model, features } = prepared()));

const rises = (fractions) => fractions.every((f, i) => f >= 0 && f <= 1 && (i === 0 || f >= fractions[i - 1]));

test('progress of asynchronous calls', async () => {
  const seen = [];
  const segmentation = await Segmentation.create(features, { onProgress: (fraction) => void seen.push(fraction) });
  assert.ok(rises(seen));
  assert.equal(seen[0], 0);
  assert.equal(seen.at(-1), 1);
  segmentation.dispose();
});

test('progress of calls that are waited for: with stages, on one thread only', () => {
  const alone = new Context({ threads: 1 });
  const seen = [];
  const stages = new Set();
  const onProgress = (fraction, stage) => {
    seen.push(fraction);
    stages.add(stage);
  };
  const own = Model.loadSync(alone, scan, { onProgress });
  assert.ok(seen.length > 3 && rises(seen) && stages.size > 1);
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Segmentation.createSync(features, { onProgress }));
  failsWith(ResourceError, 'TS_E_CANCELLED', () => Features.detectSync(own, { onProgress: () => false }));
  assert.throws(() => Features.detectSync(own, { onProgress: () => { throw new RangeError('mine'); } }), { name: 'RangeError', message: 'mine' });
  const found = Features.detectSync(own, { onProgress: (fraction) => fraction <= 1 });
  assert.equal(found.info().groups, 14);
  for (const object of [found, own, alone]) object.dispose();
});

test('cancelling asynchronous calls leaves everything as it was', async () => {
  const segmentation = await Segmentation.create(features);
  const was = segmentation.writeSession();
  await failsWith(ResourceError, 'TS_E_CANCELLED', segmentation.segmentAll({ onProgress: () => false }));
  await assert.rejects(segmentation.segmentAll({ onProgress: () => { throw new RangeError('mine'); } }), { message: 'mine' });
  const cancel = new AbortController();
  const running = segmentation.segmentAll({ signal: cancel.signal });
  cancel.abort();
  await assert.rejects(running, { name: 'AbortError' });
  assert.equal(segmentation.writeSession(), was);
  await assert.rejects(segmentation.segmentAll({ signal: AbortSignal.abort(new Error('why')) }), { message: 'why' });
  assert.throws(() => segmentation.segmentAllSync({ signal: AbortSignal.abort() }), { name: 'AbortError' });
  const unused = new AbortController();
  await segmentation.segmentAll({ signal: unused.signal });
  unused.abort();
  assert.equal(asText(segmentation.labels()), wantedLabels);
  segmentation.dispose();
});

const run = (text) => spawn(process.execPath, ['--input-type=module', '-e', text], { cwd: new URL('..', import.meta.url).pathname });

test('a process that exits meanwhile cancels its calls and ends', async () => {
  const child = run(`import { Context, Model } from 'toothseg';
    const context = new Context({ log() {} });
    for (let i = 0; i < 8; ++i) Model.load(context, ${JSON.stringify(scan)});
    process.exit(3);`);
  const timer = setTimeout(() => child.kill('SIGKILL'), 20000);
  const [code] = await once(child, 'exit');
  clearTimeout(timer);
  assert.equal(code, 3);
});

test('Ctrl-C cancels segment_arch, and nothing is written', async () => {
  const program = new URL('../samples/segment_arch.js', import.meta.url).pathname;
  const child = spawn(process.execPath, [program, scan, '--labels', inFolder('cancelled.txt')]);
  child.stderr.once('data', () => child.kill('SIGINT'));
  const [code] = await once(child, 'exit');
  assert.equal(code, 130);
  assert.equal(existsSync(inFolder('cancelled.txt')), false);
});

test('Worker threads have the library to themselves, hooks included', async () => {
  const entry = JSON.stringify(new URL('../index.js', import.meta.url).href);
  const text = `import(${entry}).then(async ({ Context, Features, Model, Segmentation }) => {
    const lines = [];
    const context = new Context({ threads: 1, log: (level, text) => lines.push(text) });
    const features = await Features.detect(Model.loadSync(context, ${JSON.stringify(scan)}));
    const segmentation = Segmentation.createSync(features);
    await segmentation.segmentAll();
    require('node:worker_threads').parentPort.postMessage({ lines: lines.length, labels: segmentation.labels() });
  });`;
  const workers = [1, 2].map(() => new Worker(text, { eval: true }));
  for (const [{ lines, labels }] of await Promise.all(workers.map((worker) => once(worker, 'message')))) {
    assert.ok(lines >= 2);
    assert.equal(asText(labels), wantedLabels);
  }
  await Promise.all(workers.map((worker) => worker.terminate()));
});

test('JavaScript goes on while a call runs', async () => {
  let ticks = 0;
  const timer = setInterval(() => ++ticks, 1);
  const segmentation = await Segmentation.create(features);
  clearInterval(timer);
  assert.ok(ticks > 3, `${ticks} ticks`);
  segmentation.dispose();
});

test('the change listener: reads, throws, in both kinds of calls', async () => {
  const segmentation = Segmentation.createSync(features);
  const heard = [];
  segmentation.onChange((teeth) => heard.push([...teeth, segmentation.labels().length]));
  const click = await segmentation.click(segmentation.proposeClicks()[0]);
  const { target, neighbour } = segmentation.clickInfo(click);
  assert.deepEqual(heard[0].slice(0, -1).sort(), [target, neighbour].sort());
  segmentation.setLocked(target, true);
  assert.equal(heard.length, 2);
  segmentation.onChange(() => { throw new RangeError('mine'); });
  assert.throws(() => segmentation.setLocked(target, false), { message: 'mine' });
  assert.equal(segmentation.isLocked(target), false); // the change stands
  await assert.rejects(segmentation.segmentAll(), { message: 'mine' });
  assert.equal(segmentation.teeth().length, 14);
  segmentation.dispose();
});

test('the log: in asynchronous calls, and in others on one thread', async () => {
  const lines = [];
  const log = (level, text) => lines.push([level, text]);
  const many = new Context({ log });
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => Model.loadSync(many, scan));
  const own = await Model.load(many, scan);
  assert.ok(lines.some(([level, text]) => level === LogLevel.INFO && text.startsWith(`intake: ${model.report().vertices} vertices`)));
  const alone = new Context({ threads: 1, log: (level, text) => { throw new RangeError(text); } });
  assert.throws(() => Model.loadSync(alone, scan), { name: 'RangeError', message: /^intake/ });
  await assert.rejects(Model.load(alone, scan), { name: 'RangeError' });
  for (const object of [own, many, alone]) object.dispose();
});

test('calls side by side on one model', async () => {
  const found = await Promise.all([1, 2, 3].map(() => Features.detect(model)));
  const [wanted] = found;
  for (const other of found) assert.deepEqual(other.points(), wanted.points());
  const segmentations = await Promise.all(found.map((f) => Segmentation.create(f)));
  await Promise.all(segmentations.map((s) => s.segmentAll()));
  for (const s of segmentations) assert.equal(asText(s.labels()), wantedLabels);
  for (const object of [...found, ...segmentations]) object.dispose();
});

// A context that counts what the library holds.
function counting(options) {
  const held = { buffers: 0, bytes: 0 };
  const allocate = (bytes) => void (++held.buffers, (held.bytes += bytes));
  const free = (bytes) => void (--held.buffers, (held.bytes -= bytes));
  return { held, context: new Context({ threads: 1, memory: { allocate, free }, ...options }) };
}

test('memory hooks want one thread', () => {
  failsWith(UsageError, 'TS_E_INVALID_ARGUMENT', () => new Context({ memory: {} }));
});

test('nothing leaks: dozens of times, whatever the order, after errors and cancelling', async () => {
  const { held, context: own } = counting();
  const first = Model.loadSync(own, smallScan);
  const resting = { ...held };
  assert.ok(resting.buffers > 0 && resting.bytes > 1e5);
  for (let i = 0; i < 24; ++i) {
    const found = Features.detectSync(first);
    const segmentation = Segmentation.createSync(found);
    segmentation.onChange(() => {});
    segmentation.clickSync(segmentation.proposeClicks()[0]);
    assert.throws(() => segmentation.clickSync([0, 0, 500]));
    assert.throws(() => Segmentation.createSync(found, { onProgress: (f) => f < 0.5 }));
    const mesh = segmentation.toothMeshSync(segmentation.teeth()[0]);
    const objects = [found, segmentation, mesh];
    for (let k = 0; k < 3; ++k) objects[(i + k) % 3].dispose();
    assert.deepEqual(held, resting);
  }
  const found = await Features.detect(first); // hooks are answered while the call runs elsewhere
  found.dispose();
  assert.deepEqual(held, resting);
  own.dispose();
  first.dispose();
  assert.deepEqual(held, { buffers: 0, bytes: 0 });
});

test('callbacks are given back', () => {
  for (let i = 0; i < 9000; ++i) counting().context.dispose(); // koffi has room for 8192
});

test('what is forgotten is given back in the end', async () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const { held } = (() => {
    const own = counting();
    const segmentation = Segmentation.createSync(Features.detectSync(Model.loadSync(own.context, smallScan)));
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

test('one buffer for labels serves many reads', () => {
  const segmentation = Segmentation.createSync(features);
  const labels = new Uint32Array(segmentation.labels().length);
  segmentation.labels(labels);
  assert.ok(labels.every((label) => label === 0));
  segmentation.segmentAllSync();
  segmentation.labels(labels);
  assert.equal(asText(labels), wantedLabels);
  segmentation.dispose();
});
