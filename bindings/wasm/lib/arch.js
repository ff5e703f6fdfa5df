// The synthetic arch: a mesh with the look of a scan, and its exact labels. SPDX-License-Identifier: Apache-2.0
import { errorOf, invalid } from './errors.js';
import { loaded } from './module.js';
import { bytes64, index, number } from './values.js';

// tsa_options and tsa_feature; module.c holds the compiler to these.
const OPTIONS = 56;
const FEATURE = 32;

const DEFAULTS = {
  jaw: 1, triangles: 100000, closed: false, seed: 1, crowding: 0, noise: 0, isotropic: false, missing: [],
};

const textAt = (module, address) => new TextDecoder().decode(module.HEAPU8.subarray(address, module.HEAPU8.indexOf(0, address)));

function check(module, status) {
  if (status !== 0) throw errorOf(status, textAt(module, module._tsa_last_error_message()));
}

function written(module, address, o, missing) {
  check(module, module._tsa_options_init(address, OPTIONS));
  new Uint32Array(module.HEAPU8.buffer, missing, o.missing.length).set(o.missing.map((fdi) => index(fdi, 'missing')));
  const data = new DataView(module.HEAPU8.buffer, address, OPTIONS);
  data.setUint32(4, index(o.jaw, 'jaw'), true);
  data.setUint32(8, index(o.triangles, 'triangles'), true);
  data.setUint32(12, o.closed ? 1 : 0, true);
  data.setBigUint64(16, BigInt(bytes64(o.seed, 'seed')), true);
  data.setFloat64(24, number(o.crowding, 'crowding'), true);
  data.setFloat64(32, number(o.noise, 'noise'), true);
  data.setUint32(40, o.isotropic ? 1 : 0, true);
  data.setUint32(44, o.missing.length, true);
  data.setUint32(48, o.missing.length ? missing : 0, true);
}

// What a getter fills: `bytes` an element, of which there are as many as it says.
function filled(module, name, arch, bytes, number) {
  check(module, module[name](arch, 0, 0, number));
  const count = new DataView(module.HEAPU8.buffer).getUint32(number, true);
  const room = module._malloc(count * bytes || 1) >>> 0;
  if (room === 0) throw errorOf(200, `${name}: no memory for ${count} elements`);
  try {
    check(module, module[name](arch, room, count, number));
    return module.HEAPU8.slice(room, room + count * bytes).buffer;
  } finally {
    module._free(room);
  }
}

function features(buffer) {
  const data = new DataView(buffer);
  return Array.from({ length: buffer.byteLength / FEATURE }, (_, i) => ({
    label: data.getUint32(i * FEATURE, true),
    incisal: data.getUint32(i * FEATURE + 4, true) !== 0,
    position: [0, 1, 2].map((k) => data.getFloat64(i * FEATURE + 8 + 8 * k, true)),
  }));
}

/** Makes an arch: typed arrays for Model.create, a label a triangle (0 gingiva, k: tooth `teeth[k - 1]`). */
export function makeArch(options = {}) {
  for (const name of Object.keys(options)) if (!(name in DEFAULTS)) throw invalid(`there is no option ${name}`);
  const o = { ...DEFAULTS, ...Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) };
  if (!Array.isArray(o.missing) || o.missing.length > 16) throw invalid('missing is no list of up to 16 FDI numbers');
  const module = loaded();
  const stack = module.stackSave();
  let arch = 0;
  try {
    const [request, missing, out] = [OPTIONS, 4 * 16, 4].map((bytes) => module.stackAlloc(bytes));
    written(module, request, o, missing);
    check(module, module._tsa_create(request, out));
    arch = new DataView(module.HEAPU8.buffer).getUint32(out, true);
    const get = (name, bytes) => filled(module, `_tsa_get_${name}`, arch, bytes, out);
    return {
      positions: new Float64Array(get('positions', 24)),
      triangles: new Uint32Array(get('triangles', 12)),
      labels: new Uint32Array(get('labels', 4)),
      teeth: [...new Uint32Array(get('teeth', 4))],
      features: features(get('features', FEATURE)),
    };
  } finally {
    if (arch) module._tsa_destroy(arch);
    module.stackRestore(stack);
  }
}
