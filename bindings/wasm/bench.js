// Time of the module beside the native library on one thread, and sizes, as JSON. SPDX-License-Identifier: Apache-2.0
//
//   node bench.js BINDIR [PACKAGE] [--triangles N] [--rounds N]
//
// BINDIR: native ts-segment and make-arch. Both read the same file and make the same clicks, by turns; times are the library's
// own, the best of all rounds for each step. Ratios are to the native time, of a process a round: `first` of the round after
// loading, when the engine has compiled the module quickly and not yet well, as a page has it for its first scan.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';

const { values, positionals } = parseArgs({
  options: { triangles: { type: 'string', default: '300000' }, rounds: { type: 'string', default: '5' } },
  allowPositionals: true,
});
if (positionals.length < 1) {
  console.error('usage: bench.js BINDIR [PACKAGE] [--triangles N] [--rounds N]');
  process.exit(2);
}
const programs = resolve(positionals[0]);
const packageFolder = resolve(positionals[1] ?? fileURLToPath(new URL('../../build/wasm/package', import.meta.url)));
const { Context, Features, Model, Segmentation, load } = await import(pathToFileURL(join(packageFolder, 'index.node.js')).href);

const STEPS = ['intake', 'features', 'weights', 'factorise'];

function native(folder, scan) {
  const report = join(folder, 'report.json');
  execFileSync(join(programs, 'ts-segment'), [scan, '--threads', '1', '--report', report], { stdio: ['ignore', 'ignore', 'inherit'] });
  const { ms, clicks } = JSON.parse(readFileSync(report, 'utf8'));
  return { ...Object.fromEntries(STEPS.map((step) => [step, ms[step]])), clicks: clicks.map((click) => click.ms.total) };
}

function wasm(scan) {
  const context = new Context();
  const model = Model.readSync(context, readFileSync(scan));
  const features = Features.detectSync(model);
  const segmentation = Segmentation.createSync(features);
  const clicks = segmentation.proposeClicks().map((position) => segmentation.clickInfo(segmentation.clickSync(position)).ms.total);
  const times = segmentation.prepareTimes();
  for (const object of [segmentation, features, model, context]) object.dispose();
  return { ...Object.fromEntries(STEPS.map((step) => [step, times[step]])), clicks };
}

// The best time of each step and click; clicks as their mean.
function best(rounds) {
  const least = (of) => Math.min(...rounds.map(of));
  const steps = Object.fromEntries(STEPS.map((step) => [step, least((round) => round[step])]));
  const clicks = rounds[0].clicks.map((_, i) => least((round) => round.clicks[i]));
  const sum = (all) => all.reduce((a, b) => a + b, 0);
  return { ...steps, preparation: sum(Object.values(steps)), click: sum(clicks) / clicks.length };
}

const folder = mkdtempSync(join(tmpdir(), 'toothseg-wasm-'));
try {
  const scan = join(folder, 'arch.ply');
  execFileSync(join(programs, 'make-arch'), [scan, '--triangles', values.triangles], { stdio: 'ignore' });
  const begin = performance.now();
  await load();
  const loading = performance.now() - begin;
  const rounds = { native: [], wasm: [] };
  for (let i = 0; i < Number(values.rounds); ++i) {
    rounds.native.push(native(folder, scan));
    rounds.wasm.push(wasm(scan));
  }
  const times = { native: best(rounds.native), first: best(rounds.wasm.slice(0, 1)), wasm: best(rounds.wasm) };
  const round = (x) => Math.round(100 * x) / 100;
  const rounded = (record) => Object.fromEntries(Object.entries(record).map(([name, x]) => [name, round(x)]));
  const ratios = (of, to) => rounded(Object.fromEntries(Object.keys(of).map((name) => [name, of[name] / to[name]])));
  const bytes = readFileSync(join(packageFolder, 'lib/toothseg.wasm'));
  console.log(JSON.stringify({
    triangles: Number(values.triangles),
    rounds: Number(values.rounds),
    bytes: { raw: bytes.length, gzip: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length },
    load_ms: round(loading),
    native_ms: rounded(times.native),
    first_ms: rounded(times.first),
    wasm_ms: rounded(times.wasm),
    first_ratios: ratios(times.first, times.native),
    ratios: ratios(times.wasm, times.native),
  }, null, 2));
} finally {
  rmSync(folder, { recursive: true });
}
