// A scan after intake. SPDX-License-Identifier: Apache-2.0
import { FileFormat, Scalar } from './abi.js';
import { invalid } from './errors.js';
import { later } from './later.js';
import { JOB_OPTIONS, Owner, Resource, blank, call, elements, info, now, optionsOf } from './resource.js';
import { index, point, text, tidy } from './values.js';

const intake = (options, ...others) => optionsOf('ts_intake_options', options, [...JOB_OPTIONS, ...others]);

function request(name, args) {
  const out = [null];
  return { name, args: [...args, null, out], result: (root) => new Model(new Owner('ts_model', out[0], root)) };
}

const load = (context, path, options) => request('ts_model_load', [context, text(path, 'path'), intake(options)]);

function read(context, bytes, options) {
  const { format = FileFormat.AUTO } = options;
  const view = bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes;
  if (!(view instanceof Uint8Array)) throw invalid('bytes are no Uint8Array or ArrayBuffer');
  return request('ts_model_read', [context, view, view.length, index(format, 'format'), intake(options, 'format')]);
}

function triangleIndices(triangles) {
  if (triangles === undefined || triangles === null || triangles instanceof Uint32Array) return triangles ?? null;
  return Uint32Array.from(triangles, (i) => index(i, 'an index of triangles'));
}

function create(context, { positions, triangles, stride = 0 }, options) {
  const scalar = positions instanceof Float32Array ? Scalar.FLOAT32 : Scalar.FLOAT64;
  if (scalar === Scalar.FLOAT64 && !(positions instanceof Float64Array))
    throw invalid('positions are no Float32Array or Float64Array');
  const indices = triangleIndices(triangles);
  // `stride` counts numbers from one vertex to the next; the last vertex need not be followed by a gap.
  const step = index(stride, 'stride') || 3;
  if (step < 3) throw invalid(`stride is ${step}, at least 3`);
  const vertices = Math.floor((positions.length + step - 3) / step);
  if (stride === 0 && positions.length % 3 !== 0)
    throw invalid(`positions have ${positions.length} numbers, not three a vertex`);
  if (indices && indices.length % 3 !== 0)
    throw invalid(`triangles have ${indices.length} indices, not three a triangle`);
  const input = {
    ...blank('ts_mesh_input'),
    scalar,
    positions,
    vertexCount: vertices,
    stride: stride * positions.BYTES_PER_ELEMENT,
    triangles: indices,
    triangleCount: indices ? indices.length / 3 : 0,
  };
  return request('ts_model_create', [context, input, intake(options)]);
}

export class Model extends Resource {
  constructor(owner) {
    super(owner, 'Model.load, Model.read or Model.create');
  }

  static async load(context, path, options = {}) {
    return later(load(context, path, options), options);
  }
  static loadSync(context, path, options = {}) {
    return now(load(context, path, options), options);
  }

  static async read(context, bytes, options = {}) {
    return later(read(context, bytes, options), options);
  }
  static readSync(context, bytes, options = {}) {
    return now(read(context, bytes, options), options);
  }

  static async create(context, mesh, options = {}) {
    return later(create(context, mesh, options), options);
  }
  static createSync(context, mesh, options = {}) {
    return now(create(context, mesh, options), options);
  }

  report() {
    return info('ts_model_get_report', 'ts_intake_report', this);
  }
  positions(into) {
    return elements(Float64Array, 3, 'ts_model_get_positions', [this], into);
  }
  triangles(into) {
    return elements(Uint32Array, 3, 'ts_model_get_triangles', [this], into);
  }
  faceSources(into) {
    return elements(Uint32Array, 1, 'ts_model_get_face_sources', [this], into);
  }
  vertexMap(into) {
    return elements(Uint32Array, 1, 'ts_model_get_vertex_map', [this], into);
  }

  nearest(position) {
    const out = {};
    call('ts_model_nearest', this, point(position, 'position'), out);
    return tidy('ts_surface_point', out);
  }
  raycast(origin, direction) {
    const out = {};
    call('ts_model_raycast', this, point(origin, 'origin'), point(direction, 'direction'), out);
    return tidy('ts_surface_point', out);
  }
}
