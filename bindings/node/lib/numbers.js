// Notations of tooth numbers. SPDX-License-Identifier: Apache-2.0
import { functions } from './native.js';
import { info, value } from './resource.js';
import { index } from './values.js';

/** The library's version. */
export const version = () => functions.ts_version();

export const fdiToUniversal = (fdi) => value('ts_fdi_to_universal', index(fdi, 'fdi'));
export const universalToFdi = (universal) => value('ts_universal_to_fdi', index(universal, 'universal'));
export const fdiToPalmer = (fdi) => info('ts_fdi_to_palmer', 'ts_palmer', index(fdi, 'fdi'));
