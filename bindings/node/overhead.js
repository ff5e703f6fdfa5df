// What the way through this layer costs: node overhead.js SCAN, in JSON. SPDX-License-Identifier: Apache-2.0
// overhead.c is the same in C.
import { Context, Features, Model, Segmentation, fdiToUniversal } from 'toothseg';

const CALLS = 300000;
const READS = 50;

function nanosecondsACall() {
  for (let i = 0; i < CALLS; ++i) fdiToUniversal(36); // until it is compiled
  const begin = performance.now();
  for (let i = 0; i < CALLS; ++i) fdiToUniversal(36);
  return ((performance.now() - begin) * 1e6) / CALLS;
}

function median(read) {
  const times = Array.from({ length: READS }, () => {
    const begin = performance.now();
    read();
    return performance.now() - begin;
  }).sort((a, b) => a - b);
  return (times[READS / 2 - 1] + times[READS / 2]) / 2;
}

const context = new Context();
const model = Model.loadSync(context, process.argv[2]);
const features = Features.detectSync(model);
const segmentation = Segmentation.createSync(features);
segmentation.segmentAllSync();
const room = segmentation.labels();

console.log(
  JSON.stringify({
    node: process.version,
    faces: room.length,
    call_ns: Math.round(nanosecondsACall()),
    labels_ms: Number(median(() => segmentation.labels()).toFixed(3)),
    labels_into_ms: Number(median(() => segmentation.labels(room)).toFixed(3)),
  }),
);
for (const object of [segmentation, features, model, context]) object.dispose();
