// What the tests share. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** Set by test.sh: the package that was built, the folder of ts-segment, and a folder with scans and what ts-segment made of them. */
export const packageFolder = process.env.TOOTHSEG_TEST_PACKAGE;
export const programs = process.env.TOOTHSEG_TEST_PROGRAMS;
export const inFolder = (name) => join(process.env.TOOTHSEG_TEST_FOLDER, name);

export const entry = pathToFileURL(join(packageFolder, 'index.node.js')).href;
export const toothseg = await import(entry);
export const inPackage = (name) => import(pathToFileURL(join(packageFolder, name)).href);
await toothseg.load();

const { Context, Features, Model, Segmentation } = toothseg;

export const bytesOf = (name) => new Uint8Array(readFileSync(inFolder(name)));
export const textOf = (name) => readFileSync(inFolder(name), 'utf8');
export const asText = (labels) => `${labels.join('\n')}\n`;

/** All from context to segmentation. */
export function prepared(scan, options) {
  const context = new Context(options);
  const model = Model.readSync(context, bytesOf(scan));
  const features = Features.detectSync(model);
  return { context, model, features, segmentation: Segmentation.createSync(features) };
}
export const drop = (...objects) => objects.forEach((object) => object.dispose());

/** That a call fails with an error of just this class and status. */
export function failsWith(type, code, call) {
  const looks = (error) => {
    assert.equal(error.constructor, type, `${error.stack}`);
    assert.equal(error.code, code);
    assert.equal(error.name, type.name);
    assert.notEqual(error.message, '');
    return true;
  };
  return call instanceof Promise ? assert.rejects(call, looks) : assert.throws(call, looks);
}
