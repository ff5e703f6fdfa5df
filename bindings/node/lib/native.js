// The C library by koffi, as lib/abi.js describes it: functions, structs, callbacks. The one module that knows Node.
// SPDX-License-Identifier: Apache-2.0
import koffi from 'koffi';

import { callbacks as callbackTable, functions as functionTable, handles, structs, version } from './abi.js';

// Native code runs on stacks of koffi's making, whose default of 128 KiB for asynchronous calls is short.
const STACKS = { sync_stack_size: 8 << 20, async_stack_size: 4 << 20 };
try {
  koffi.config(STACKS);
} catch (cause) {
  if (koffi.config().async_stack_size < 1 << 20)
    throw new Error('koffi is in use already, with stacks too small for toothseg: import toothseg first', { cause });
}

function libraryName() {
  const { platform, env } = process;
  const major = version.split('.')[0];
  if (env.TOOTHSEG_LIBRARY) return env.TOOTHSEG_LIBRARY;
  if (platform === 'win32') return 'toothseg.dll';
  return platform === 'darwin' ? `libtoothseg.${major}.dylib` : `libtoothseg.so.${major}`;
}

function load() {
  const name = libraryName();
  try {
    return koffi.load(name);
  } catch (cause) {
    throw new Error(`the toothseg library, ${name}, cannot be loaded; TOOTHSEG_LIBRARY says where it is`, { cause });
  }
}

const library = load();

for (const name of Object.keys(handles)) koffi.opaque(name);

/** Types of the callbacks, for koffi.register. */
export const callbackTypes = {};
for (const [name, [result, parameters]] of Object.entries(callbackTable))
  callbackTypes[name] = koffi.pointer(koffi.proto(name, result, parameters));

// Plain arrays and text, not typed arrays, so that results print, spread and serialise as one expects.
const fieldType = (type) => (Array.isArray(type) ? koffi.array(...type, type[0] === 'char' ? 'String' : 'Array') : type);

/** The structs by name; members are in camelCase. */
export const structTypes = {};
for (const [name, { fields }] of Object.entries(structs))
  structTypes[name] = koffi.struct(name, Object.fromEntries(Object.entries(fields).map(([f, type]) => [f, fieldType(type)])));

/** All functions of the library by their C names; each has an `async` form (koffi's). */
export const functions = {};
for (const [name, [result, parameters]] of Object.entries(functionTable))
  functions[name] = library.func(name, result, parameters);

{
  const numbers = (text) => text.split('.').map(Number);
  const [major, minor] = numbers(functions.ts_version());
  const [wantedMajor, wantedMinor] = numbers(version);
  if (major !== wantedMajor || minor < wantedMinor)
    throw new Error(`toothseg ${functions.ts_version()} is not the ${version} that this package was made for`);
}

/** Makes a JavaScript function into a native one, until unregister(). */
export const register = (callback, type) => koffi.register(callback, callbackTypes[type]);
export const unregister = (callback) => koffi.unregister(callback);

/** Whether hooks of a context with so many threads are called on the thread that waits for the call. */
export const answersHooks = (threads) => threads === 1;

export const sizeOf = (struct) => koffi.sizeof(structTypes[struct]);
/** `count` structs out of a buffer. */
export const decodeAll = (bytes, struct, count) => koffi.decode(bytes, koffi.array(structTypes[struct], count, 'Array'));
/** `count` indices out of native memory. */
export const decodeIndices = (pointer, count) => Uint32Array.from(count ? koffi.decode(pointer, 'uint32_t', count) : []);

// Memory for allocator hooks, aligned to 16 bytes.
export const allocate = (bytes) => koffi.alloc('uint8_t', bytes);
export const free = (memory) => koffi.free(memory);
export const addressOf = (pointer) => koffi.address(pointer);

export const atExit = (action) => process.on('exit', action);
