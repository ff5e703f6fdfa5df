// From a scan to labels: as few clicks as cover all teeth, or all teeth as one step. SPDX-License-Identifier: Apache-2.0
//
//   node segment_arch.js SCAN [--all] [--labels OUT.txt] [--teeth DIR]
//
// Progress goes to stderr; Ctrl-C cancels. Exit status: 0 done, 1 a click failed, 2 nothing is written, 130 cancelled.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

import { Context, Features, LogLevel, Model, OutputFormat, Segmentation, SegmentationError } from 'toothseg';

const USAGE = 'usage: segment_arch.js SCAN [--all] [--labels OUT.txt] [--teeth DIR]';

const cancel = new AbortController();
process.once('SIGINT', () => cancel.abort());

function job(stage) {
  const onProgress = (fraction) => void process.stderr.write(`\r${stage} ${Math.round(100 * fraction)} %   `);
  return { signal: cancel.signal, onProgress };
}

// Clicks until nothing is left, or until a round separates nothing more; gives how many failed.
async function click(segmentation) {
  let failed = 0;
  for (let before = -1; segmentation.teeth().length > before; ) {
    before = segmentation.teeth().length;
    for (const position of segmentation.proposeClicks()) {
      try {
        await segmentation.click(position, job('click'));
      } catch (error) {
        if (!(error instanceof SegmentationError)) throw error;
        ++failed;
        console.error(`\n(${position.join(' ')}): ${error.message}`);
      }
    }
  }
  return failed;
}

async function writeTeeth(segmentation, directory) {
  mkdirSync(directory, { recursive: true });
  for (const tooth of segmentation.teeth()) {
    const mesh = await segmentation.toothMesh(tooth, job('meshes'));
    await mesh.save(join(directory, `tooth_${segmentation.tooth(tooth).label}.stl`), OutputFormat.STL);
    mesh.dispose();
  }
}

async function segment(scan, { all, labels, teeth }) {
  const log = (level, text) => level === LogLevel.WARNING && console.error(`\n${scan}: ${text}`);
  const context = new Context({ log });
  const model = await Model.load(context, scan, job('load'));
  const features = await Features.detect(model, job('features'));
  const segmentation = await Segmentation.create(features, job('prepare'));
  let failed = 0;
  if (all) await segmentation.segmentAll(job('all teeth'));
  else failed = await click(segmentation);
  if (labels) writeFileSync(labels, `${segmentation.labels().join('\n')}\n`);
  if (teeth) await writeTeeth(segmentation, teeth);
  console.error();
  console.log(`${scan}: ${segmentation.teeth().length} teeth from ${segmentation.clickCount()} clicks, ${failed} failed`);
  for (const object of [segmentation, features, model, context]) object.dispose();
  return failed ? 1 : 0;
}

function fail(message, status) {
  console.error(`\nsegment_arch: ${message}`);
  return status;
}

try {
  const text = { type: 'string' };
  const { values, positionals } = parseArgs({
    options: { all: { type: 'boolean' }, labels: text, teeth: text },
    allowPositionals: true,
  });
  process.exitCode = positionals.length === 1 ? await segment(positionals[0], values) : fail(USAGE, 2);
} catch (error) {
  process.exitCode = cancel.signal.aborted ? fail('cancelled', 130) : fail(error.message, 2);
}
