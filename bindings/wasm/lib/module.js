// The one WebAssembly module of a page, a worker or a process, loaded once. SPDX-License-Identifier: Apache-2.0
import { VERSION_MAJOR, VERSION_MINOR, VERSION_PATCH } from './abi.js';
import create from './toothseg.mjs';

let module = null;
let loading = null;
let binary = () => fetch(new URL('./toothseg.wasm', import.meta.url));

/** Where toothseg.wasm is if load() is not told: a function that gives what load() takes. */
export function setBinary(from) {
  binary = from;
}

export function loaded() {
  if (!module) throw new Error('toothseg is not loaded yet: await load() first');
  return module;
}

async function instantiated(source, imports) {
  const given = await (typeof source === 'string' || source instanceof URL ? fetch(source) : source);
  if (given instanceof WebAssembly.Module)
    return { module: given, instance: await WebAssembly.instantiate(given, imports) };
  if (typeof Response !== 'function' || !(given instanceof Response)) return WebAssembly.instantiate(given, imports);
  if (!given.ok) throw new Error(`${given.url}: ${given.status} ${given.statusText}`);
  // A server that calls it anything but application/wasm gets it read as a whole.
  const streams = given.headers.get('content-type')?.startsWith('application/wasm');
  return streams ? WebAssembly.instantiateStreaming(given, imports) : WebAssembly.instantiate(await given.arrayBuffer(), imports);
}

async function start(source) {
  const made = await new Promise((resolve, reject) => {
    const instantiateWasm = (imports, done) => {
      instantiated(source, imports).then((result) => done(result.instance, result.module), reject);
      return {};
    };
    create({ instantiateWasm }).then(resolve, reject);
  });
  const version = new TextDecoder().decode(made.HEAPU8.subarray(made._ts_version(), made.HEAPU8.indexOf(0, made._ts_version())));
  const wanted = `${VERSION_MAJOR}.${VERSION_MINOR}.${VERSION_PATCH}`;
  if (version !== wanted) throw new Error(`toothseg.wasm is ${version}, and not the ${wanted} that this package was made for`);
  module = made;
}

/**
 * Loads the module; to be awaited before anything else. Again is fine, and waits for the same. `wasm`: a URL, bytes, a
 * Response or a WebAssembly.Module, where it is not beside the package's code.
 */
export function load({ wasm } = {}) {
  loading ??= start(wasm ?? binary()).catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

/** Bytes of the module's memory that are in use, and that it has. It never gets smaller. */
export const memoryUse = () => ({ inUse: loaded()._tsw_bytes_in_use() >>> 0, size: loaded().HEAPU8.length });
