// The low-level layer against the C API's description; the types. SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';

import koffi from 'koffi';
import * as toothseg from 'toothseg';
import * as native from 'toothseg/native';

import * as abi from '../lib/abi.js';
import { inFolder } from './common.js';

const root = new URL('..', import.meta.url).pathname;
const description = JSON.parse(readFileSync(join(root, '../../abi/toothseg.json'), 'utf8'));
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const generate = (folder, ...args) => spawnSync(process.execPath, [join(folder, 'generate.mjs'), ...args], { encoding: 'utf8' });

test('the generated files are what the description says', () => {
  const { status, stderr } = generate(root, '--check');
  assert.equal(status, 0, stderr);
});

test('the generator takes what is added to the description, and --check sees it', () => {
  const folder = inFolder('generator/bindings/node');
  mkdirSync(join(folder, 'lib'), { recursive: true });
  mkdirSync(inFolder('generator/abi'));
  for (const file of ['generate.mjs', 'lib/abi.js', 'lib/abi.d.ts']) cpSync(join(root, file), join(folder, file));
  const more = structuredClone(description);
  const colour = { base: 'ts_colour', kind: 'enum', spelling: 'ts_colour' };
  const shade = { base: 'ts_shade', kind: 'struct', spelling: 'ts_shade *', pointer: 1 };
  const status = { base: 'ts_status', kind: 'enum', spelling: 'ts_status' };
  more.enums.push({
    name: 'ts_colour',
    doc: '',
    values: [{ name: 'TS_COLOUR_A1', value: 1, doc: 'light' }, { name: 'TS_COLOUR_FORCE_INT', value: 0x7fffffff, doc: '' }],
  });
  more.structs.push({ name: 'ts_shade', doc: '', versioned: false, fields: [{ name: 'main_colour', type: colour, doc: '' }] });
  more.functions.push({ name: 'ts_get_shade', doc: '', returns: status, arguments: [{ name: 'shade', type: shade, direction: 'out' }] });
  writeFileSync(inFolder('generator/abi/toothseg.json'), JSON.stringify(more));

  assert.equal(generate(folder, '--check').status, 1);
  assert.equal(generate(folder).status, 0);
  assert.equal(generate(folder, '--check').status, 0);
  const written = readFileSync(join(folder, 'lib/abi.js'), 'utf8');
  assert.match(written, /export const Colour = Object.freeze\(\{\n {2}A1: 1,\n\}\);/);
  assert.match(written, /mainColour: 'int'/);
  assert.match(written, /ts_get_shade: \['int', \['_Out_ ts_shade \*'\]\]/);
  assert.match(readFileSync(join(folder, 'lib/abi.d.ts'), 'utf8'), /export interface Shade \{\n {2}mainColour: Colour;/);
});

test('structs have the layout that C has', () => {
  for (const { name, layout, fields } of description.structs) {
    const { size, align, offsets } = process.platform === 'win32' ? layout.llp64 : layout.lp64;
    const type = native.structTypes[name];
    assert.equal(koffi.sizeof(type), size, name);
    assert.equal(koffi.alignof(type), align, name);
    for (const field of fields) assert.equal(koffi.offsetof(type, camel(field.name)), offsets[field.name], `${name}.${field.name}`);
  }
});

test('all functions, handles, callbacks, constants and statuses are there', () => {
  assert.deepEqual(Object.keys(native.functions), description.functions.map((f) => f.name));
  for (const f of description.functions) {
    assert.equal(native.functions[f.name].info.arguments.length, f.arguments.length, f.name);
    assert.equal(typeof native.functions[f.name].async, 'function');
  }
  assert.deepEqual(Object.keys(abi.handles), description.handles.map((h) => h.name));
  assert.deepEqual(Object.keys(native.callbackTypes), description.callbacks.map((c) => c.name));
  for (const { name, value } of description.constants) assert.equal(abi[name.slice(3)], value);
  const values = description.enums.flatMap((e) => e.values).filter((v) => !v.name.endsWith('_FORCE_INT'));
  const kept = Object.values(abi).filter((x) => Object.isFrozen(x) && typeof x === 'object').flatMap((x) => Object.values(x));
  assert.equal(kept.length, values.length);
  for (const [name, value] of Object.entries(abi.Status)) assert.equal(native.functions.ts_status_name(value), `TS_${name}`);
  assert.equal(toothseg.version(), native.functions.ts_version());
});

test('the public layer leads to every function', () => {
  const sources = ['context', 'features', 'later', 'mesh', 'model', 'numbers', 'resource', 'segmentation'];
  const text = sources.map((name) => readFileSync(join(root, `lib/${name}.js`), 'utf8')).join('');
  // By their names, or by the description: ..._init and ..._destroy. A status's name is in the table of statuses; one
  // job serves one call, and has nothing to be reset for.
  const indirect = new Set(['ts_status_name', 'ts_job_reset']);
  for (const { init } of description.structs) indirect.add(init);
  for (const { destroy } of description.handles) indirect.add(destroy);
  indirect.delete(undefined);
  indirect.add('ts_mesh_input_init'); // struct_size, and a scalar that is always given
  const missing = description.functions.map((f) => f.name).filter((name) => !indirect.has(name) && !text.includes(name));
  assert.deepEqual(missing, []);
});

test('types: what is declared is there, and the other way round', () => {
  const text = readFileSync(join(root, 'index.d.ts'), 'utf8');
  for (const [, name, body = ''] of text.matchAll(/declare (?:abstract )?class (\w+)[^{]*\{(?:\}|(.*?)\n\})/gs)) {
    const type = toothseg[name];
    assert.equal(typeof type, 'function', name);
    if (name === 'Resource') continue; // has a property and a symbol as well
    const declared = [...body.matchAll(/^ {2}(?:static )?(\w+)\(/gm)].map((m) => m[1]).filter((m) => m !== 'constructor');
    const here = Object.getOwnPropertyNames(type.prototype).concat(Object.getOwnPropertyNames(type));
    const real = here.filter((m) => !['constructor', 'prototype', 'name', 'length'].includes(m));
    assert.deepEqual([...new Set(declared)].sort(), real.sort(), name);
  }
  for (const [, name] of text.matchAll(/declare function (\w+)/g)) assert.equal(typeof toothseg[name], 'function', name);
  for (const name of Object.keys(toothseg)) assert.match(text, new RegExp(`\\b${name}\\b`));
});

test('types: a program in TypeScript compiles', () => {
  const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
  const { status, stdout } = spawnSync(process.execPath, [tsc, '-p', join(root, 'test')], { encoding: 'utf8' });
  assert.equal(status, 0, stdout);
});

test('CommonJS programs can use it', () => {
  const run = (text) => execFileSync(process.execPath, ['--input-type=commonjs', '-e', text], { cwd: root, encoding: 'utf8', stdio: 'pipe' });
  assert.equal(run("import('toothseg').then((t) => console.log(t.fdiToUniversal(36)))").trim(), '19');
  if (process.features.require_module) assert.equal(run("console.log(require('toothseg').fdiToUniversal(36))").trim(), '19');
});
