// What callers give, checked and made into what the library takes; what it returns, made into what callers like.
// SPDX-License-Identifier: Apache-2.0
import { structs } from './abi.js';
import { invalid } from './errors.js';

/** A whole number from 0 to 2^32 - 1. koffi would wrap others round. */
export function index(value, what) {
  if (!Number.isInteger(value) || value < 0 || value > 0xffffffff)
    throw invalid(`${what} is ${String(value)}, not a whole number from 0 to 2^32 - 1`);
  return value;
}

export function number(value, what) {
  if (typeof value !== 'number') throw invalid(`${what} is ${String(value)}, not a number`);
  return value;
}

export function bytes64(value, what) {
  const whole = typeof value === 'bigint' ? value >= 0n && value < 1n << 64n : Number.isSafeInteger(value) && value >= 0;
  if (!whole) throw invalid(`${what} is ${String(value)}, not a whole number from 0 to 2^64 - 1`);
  return value;
}

/** x, y, z in any array. */
export function point(value, what) {
  if (value?.length !== 3) throw invalid(`${what} is not three numbers`);
  return Float64Array.from(value, (x) => number(x, what));
}

/** Points as [[x, y, z], ...], or flat in an array of numbers; a Float64Array is taken as it is. */
export function points(value, what) {
  if (value instanceof Float64Array) {
    if (value.length % 3 !== 0) throw invalid(`${what} has ${value.length} numbers, not three a point`);
    return value;
  }
  if (value?.length === undefined) throw invalid(`${what} are not points`);
  if (value.length && typeof value[0] === 'number') return points(Float64Array.from(value), what);
  const out = new Float64Array(3 * value.length);
  for (let i = 0; i < value.length; ++i) out.set(point(value[i], `${what}[${i}]`), 3 * i);
  return out;
}

/** Text for the library, which ends it at the first 0. */
export function text(value, what) {
  if (typeof value !== 'string' || value.includes('\0')) throw invalid(`${what} is not a text without zeros`);
  return value;
}

function toField(struct, name, value) {
  const { fields, flags } = structs[struct];
  const type = fields[name];
  if (flags.includes(name)) return value ? 1 : 0;
  if (Array.isArray(type)) return Array.from(point(value, name));
  if (type === 'double') return number(value, name);
  return type === 'uint64_t' ? bytes64(value, name) : index(value, name);
}

/** Options over their defaults. `others`: names that are not of the struct, and not looked at. */
export function withDefaults(struct, defaults, options, others) {
  for (const [name, value] of Object.entries(options)) {
    if (others.includes(name) || value === undefined) continue;
    if (!(name in structs[struct].fields) || name === 'structSize') throw invalid(`there is no option ${name}`);
    defaults[name] = toField(struct, name, value);
  }
  return defaults;
}

/** A struct without what keeps house, and with flags that are true or false. */
export function tidy(struct, record) {
  for (const flag of structs[struct].flags) record[flag] = record[flag] !== 0;
  delete record.structSize;
  delete record.reserved;
  return record;
}
