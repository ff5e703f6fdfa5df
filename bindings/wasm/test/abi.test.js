// The low-level layer against the C API's description; the API against the Node binding's; the types.
// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { brotliCompressSync } from 'node:zlib';

import { inFolder, inPackage, packageFolder, toothseg } from './common.js';

const root = new URL('..', import.meta.url).pathname;
const description = JSON.parse(readFileSync(join(root, '../../abi/toothseg.json'), 'utf8'));
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const generate = (folder, ...args) => spawnSync(process.execPath, [join(folder, 'generate.mjs'), ...args], { encoding: 'utf8' });

test('the generated files are what the description says', () => {
  const { status, stderr } = generate(root, '--check');
  assert.equal(status, 0, stderr);
});

test('--check sees what is added to the description', () => {
  const folder = inFolder('generator/bindings/wasm');
  for (const path of ['generator/bindings/wasm/lib', 'generator/abi', 'generator/synth/include']) mkdirSync(inFolder(path), { recursive: true });
  for (const file of ['generate.mjs', 'lib/layout.js', 'exports.txt']) cpSync(join(root, file), join(folder, file));
  cpSync(join(root, '../../synth/include/toothseg_arch.h'), inFolder('generator/synth/include/toothseg_arch.h'));
  const more = structuredClone(description);
  const status = { base: 'ts_status', kind: 'enum', spelling: 'ts_status' };
  const bytes = { base: 'uint64_t', kind: 'scalar', spelling: 'uint64_t' };
  more.functions.push({ name: 'ts_new', doc: '', returns: status, arguments: [{ name: 'bytes', type: bytes, direction: 'in' }] });
  writeFileSync(inFolder('generator/abi/toothseg.json'), JSON.stringify(more));
  assert.equal(generate(folder, '--check').status, 1);
  assert.equal(generate(folder).status, 0);
  assert.match(readFileSync(join(folder, 'lib/layout.js'), 'utf8'), /ts_new: \['status', 'bigint'\]/);
  assert.match(readFileSync(join(folder, 'exports.txt'), 'utf8'), /^_ts_new$/m);
});

test('every function is in the module, with its arguments', async () => {
  const { functions } = await inPackage('lib/native.js');
  const { loaded } = await inPackage('lib/module.js');
  const { rules, layouts } = await inPackage('lib/layout.js');
  assert.deepEqual(Object.keys(functions), description.functions.map((f) => f.name));
  for (const { name, arguments: all } of description.functions) {
    assert.equal(typeof loaded()[`_${name}`], 'function', name);
    assert.equal(rules[name].length, 1 + all.length, name);
  }
  for (const { name, layout: { wasm32 }, fields } of description.structs) {
    assert.equal(layouts[name].size, wasm32.size, name);
    for (const f of fields) assert.equal(layouts[name].offsets[camel(f.name)], wasm32.offsets[f.name]);
  }
});

test('the library and JavaScript agree about every struct with defaults', async () => {
  const { functions, sizeOf } = await inPackage('lib/native.js');
  for (const { name, init } of description.structs.filter((s) => s.init)) {
    const record = {};
    assert.equal(functions[init](record, sizeOf(name), ...(init === 'ts_segment_options_init' ? [0] : [])), 0, name);
    assert.equal(record.structSize, sizeOf(name));
    assert.equal(functions[init]({}, sizeOf(name) + 4, ...(init === 'ts_segment_options_init' ? [0] : [])), 102, name);
  }
});

test('what the Node binding has is here, and what is declared is there', () => {
  const here = new Set(Object.keys(toothseg));
  const node = readFileSync(join(root, '../node/index.js'), 'utf8').replace(/^\/\/.*$/gm, '');
  const names = [...node.matchAll(/\{([^}]*)\}/g)].flatMap((match) => match[1].match(/\w+/g));
  assert.ok(names.length > 30);
  for (const name of names) assert.ok(here.delete(name), name);
  const declared = readFileSync(join(packageFolder, 'index.d.ts'), 'utf8');
  const own = [...declared.matchAll(/^export declare (?:function|const) (\w+)/gm)].map((match) => match[1]);
  assert.deepEqual([...here].sort(), own.sort());
});

test('types: the Node binding’s program and one of its own compile', () => {
  const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
  const base = JSON.parse(readFileSync(join(root, '../node/test/tsconfig.json'), 'utf8'));
  const types = join(packageFolder, 'index.d.ts');
  base.compilerOptions.paths = { toothseg: [types], 'toothseg-wasm': [types] };
  base.files = [join(root, '../node/test/types.ts'), join(root, 'test/types.ts')];
  writeFileSync(inFolder('tsconfig.json'), JSON.stringify(base));
  const { status, stdout } = spawnSync(process.execPath, [tsc, '-p', inFolder('tsconfig.json')], { encoding: 'utf8' });
  assert.equal(status, 0, stdout);
});

test('the module is small enough for a page', () => {
  const path = join(packageFolder, 'lib/toothseg.wasm');
  assert.ok(statSync(path).size < 6e6);
  assert.ok(brotliCompressSync(readFileSync(path)).length < 3e6);
});
