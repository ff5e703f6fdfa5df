// What the tests share. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { Context, Features, Model, Segmentation } from 'toothseg';

/** Set by test.sh: a folder with the scan arch.ply, its labels by ts-segment (labels.txt), a scan small.ply, one
 *  whose teeth cannot be closed (noisy.ply), and room for more. */
export const folder = process.env.TOOTHSEG_TEST_FOLDER;
export const scan = join(folder, 'arch.ply');
export const smallScan = join(folder, 'small.ply');
export const inFolder = (name) => join(folder, name);
export const wantedLabels = readFileSync(inFolder('labels.txt'), 'utf8');

export const asText = (labels) => `${labels.join('\n')}\n`;

/** All from context to segmentation, at once. */
export function prepared(options, segmentOptions) {
  const context = new Context(options);
  const model = Model.loadSync(context, scan);
  const features = Features.detectSync(model);
  return { context, model, features, segmentation: Segmentation.createSync(features, segmentOptions) };
}

/** That a call fails with an error of just this class and status. */
export function failsWith(type, code, call) {
  const looks = (error) => {
    assert.equal(error.constructor, type, `${error.stack}`);
    assert.equal(error.code, code);
    assert.equal(error.name, type.name);
    assert.notEqual(error.message, '');
    return true;
  };
  const result = call instanceof Promise ? call : null;
  return result ? assert.rejects(result, looks) : assert.throws(call, looks);
}
