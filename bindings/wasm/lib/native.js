// The C library in its module, as abi.js and layout.js describe it: functions, structs, callbacks. Has the names that the
// Node binding's module of this name has for the library that it calls, so that all above it is the same for both.
// SPDX-License-Identifier: Apache-2.0
import { Status, callbacks as callbackTable, structs } from './abi.js';
import { ResourceError } from './errors.js';
import { layouts, rules } from './layout.js';
import { loaded } from './module.js';

const encoder = new TextEncoder();
const decoder = new TextDecoder();

const view = () => new DataView(loaded().HEAPU8.buffer);

function outOfMemory(bytes) {
  return new ResourceError(Status.E_OUT_OF_MEMORY, `the module has no ${bytes} bytes more for what a call takes or gives`);
}

// ----------------------------------------------------------------------------------------------------- memory of a call

const ON_STACK = 4096; // what is larger goes to the heap

/** What one call has in the module's memory; given back at its end. */
class Frame {
  #module = loaded();
  #stack = this.#module.stackSave();
  #blocks = [];

  take(bytes) {
    if (bytes <= ON_STACK) return this.#module.stackAlloc(bytes || 1);
    const address = this.#module._malloc(bytes);
    if (address === 0) throw outOfMemory(bytes);
    this.#blocks.push(address);
    return address >>> 0;
  }
  put(bytes) {
    const address = this.take(bytes.length);
    this.#module.HEAPU8.set(bytes, address);
    return address;
  }
  end() {
    this.#blocks.forEach((address) => this.#module._free(address));
    this.#module.stackRestore(this.#stack);
  }
}

const bytesOf = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
const heapBytes = (address, count) => loaded().HEAPU8.subarray(address, address + count);

function textAt(address) {
  const heap = loaded().HEAPU8;
  return decoder.decode(heap.subarray(address, heap.indexOf(0, address)));
}

// ------------------------------------------------------------------------------------------------------------- structs

const wide = (x) => (x <= Number.MAX_SAFE_INTEGER ? Number(x) : x);
const readers = {
  double: (data, at) => data.getFloat64(at, true),
  uint64_t: (data, at) => wide(data.getBigUint64(at, true)),
  uint32_t: (data, at) => data.getUint32(at, true),
  int: (data, at) => data.getInt32(at, true),
  char: (data, at) => data.getUint8(at),
};
const writers = {
  double: (data, at, x) => data.setFloat64(at, x, true),
  uint64_t: (data, at, x) => data.setBigUint64(at, BigInt(x), true),
  uint32_t: (data, at, x) => data.setUint32(at, x, true),
  int: (data, at, x) => data.setInt32(at, x, true),
  char: (data, at, x) => data.setUint8(at, x),
};
const widths = { double: 8, uint64_t: 8, uint32_t: 4, int: 4, char: 1 };
const isAddress = (type) => typeof type === 'string' && type.endsWith('*');

function readField(data, at, type) {
  if (type in structs) return readStruct(data, at, type);
  if (isAddress(type)) return data.getUint32(at, true) || null;
  if (!Array.isArray(type)) return readers[type](data, at);
  const [base, count] = type;
  const all = Array.from({ length: count }, (_, i) => readers[base](data, at + i * widths[base]));
  if (base !== 'char') return all;
  return decoder.decode(Uint8Array.from(all.slice(0, [...all, 0].indexOf(0))));
}

function readStruct(data, at, name, into = {}) {
  for (const [field, type] of Object.entries(structs[name].fields))
    into[field] = readField(data, at + layouts[name].offsets[field], type);
  return into;
}

// Fields that are not given are 0. Arrays that are pointed to go into the memory of the call. The library fills structs in
// structs, and is given none.
function writeStruct(frame, name, record) {
  const { size, offsets } = layouts[name];
  const address = frame.put(new Uint8Array(size));
  for (const [field, type] of Object.entries(structs[name].fields)) {
    const value = record[field];
    const at = address + offsets[field];
    if (value === undefined || value === null || type in structs) continue;
    if (isAddress(type)) view().setUint32(at, ArrayBuffer.isView(value) ? frame.put(bytesOf(value)) : value, true);
    else if (Array.isArray(type)) value.forEach((x, i) => writers[type[0]](view(), at + i * widths[type[0]], x));
    else writers[type](view(), at, value);
  }
  return address;
}

// ----------------------------------------------------------------------------------------------------------- functions

// What goes in for an argument; what is to be done with it after the call is added to `after`.
function argument(frame, rule, value, after) {
  if (rule === 'bigint') return BigInt(value);
  if (rule === 'value') return value ?? 0;
  if (value === null || value === undefined) return 0;
  if (rule === 'text') return frame.put(encoder.encode(`${value}\0`));
  if (rule === 'array in') return frame.put(bytesOf(value));
  if (rule === 'handle out') {
    const address = frame.put(new Uint8Array(4));
    after.push(() => (value[0] = view().getUint32(address, true)));
    return address;
  }
  if (rule === 'array out') {
    const address = frame.take(value.byteLength);
    after.push(() => bytesOf(value).set(heapBytes(address, value.byteLength)));
    return address;
  }
  const [how, struct, count] = rule;
  if (how === 'filled') {
    const address = frame.take(value.byteLength);
    // So many of `capacity` elements were written.
    after.push((args) => {
      const bytes = args[struct] ? (value.byteLength / args[struct]) * args[count][0] : 0;
      bytesOf(value).set(heapBytes(address, bytes));
    });
    return address;
  }
  const address = writeStruct(frame, struct, how === 'out' ? {} : value);
  if (how !== 'in') after.push(() => readStruct(view(), address, struct, value));
  return address;
}

function call(name, [result, ...how], args) {
  const module = loaded();
  const frame = new Frame();
  try {
    const after = [];
    const given = how.map((rule, i) => argument(frame, rule, args[i], after));
    const out = module[`_${name}`](...given);
    // An array is as long as a count says that comes after it.
    if (result !== 'status' || out === Status.OK) after.reverse().forEach((take) => take(args));
    return result === 'text' ? textAt(out) : out;
  } finally {
    frame.end();
  }
}

/** All functions of the library by their C names, once the module is loaded. */
export const functions = {};
for (const [name, rule] of Object.entries(rules)) functions[name] = (...args) => call(name, rule, args);

// ----------------------------------------------------------------------------------------------------------- callbacks

const letters = { void: 'v', double: 'd' };
const unsigned = (type) => type === 'uint32_t' || type === 'size_t' || type.endsWith('*');

function toScript(type, value) {
  if (type === 'const char *') return textAt(value >>> 0);
  return unsigned(type) ? value >>> 0 : value;
}

/** Makes a JavaScript function into one of the module's, until unregister(). */
export function register(callback, type) {
  const [result, parameters] = callbackTable[type];
  const signature = [result, ...parameters].map((t) => letters[t] ?? 'i').join('');
  return loaded().addFunction((...args) => callback(...args.map((x, i) => toScript(parameters[i], x))) ?? 0, signature);
}
export const unregister = (callback) => loaded().removeFunction(callback);

/** Hooks come on this thread: there is no other. */
export const answersHooks = () => true;

export const sizeOf = (struct) => layouts[struct].size;
/** `count` structs out of a buffer. */
export function decodeAll(bytes, struct, count) {
  const data = new DataView(bytes.buffer, bytes.byteOffset);
  return Array.from({ length: count }, (_, i) => readStruct(data, i * sizeOf(struct), struct));
}
/** `count` indices out of the module's memory. */
export const decodeIndices = (address, count) => new Uint32Array(loaded().HEAPU8.buffer, address, count).slice();

// Memory for allocator hooks, aligned to 16 bytes; null: there is none.
export const allocate = (bytes) => loaded()._aligned_alloc(16, (bytes + 15) & ~15) >>> 0 || null;
export const free = (memory) => loaded()._free(memory);
export const addressOf = (pointer) => pointer;
