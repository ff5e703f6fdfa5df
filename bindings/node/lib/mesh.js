// A tooth, or the gingiva, as a mesh of its own. SPDX-License-Identifier: Apache-2.0
import { later } from './later.js';
import { Owner, Resource, elements, info, now, optionsOf } from './resource.js';
import { index, text } from './values.js';

function saved(mesh, path, format) {
  return { name: 'ts_mesh_save', args: [mesh, text(path, 'path'), index(format, 'format'), null] };
}

export class ToothMesh extends Resource {
  constructor(owner) {
    super(owner, 'segmentation.toothMesh or segmentation.gingivaMesh');
  }

  info() {
    return info('ts_mesh_get_info', 'ts_mesh_info', this);
  }
  positions(into) {
    return elements(Float64Array, 3, 'ts_mesh_get_positions', [this], into);
  }
  normals(into) {
    return elements(Float64Array, 3, 'ts_mesh_get_normals', [this], into);
  }
  triangles(into) {
    return elements(Uint32Array, 3, 'ts_mesh_get_triangles', [this], into);
  }
  faces(into) {
    return elements(Uint32Array, 1, 'ts_mesh_get_faces', [this], into);
  }
  vertexFlags(into) {
    return elements(Uint8Array, 1, 'ts_mesh_get_vertex_flags', [this], into);
  }

  async save(path, format, options = {}) {
    return later(saved(this, path, format), options);
  }
  saveSync(path, format, options = {}) {
    return now(saved(this, path, format), options);
  }
}

/** The request for a mesh: `name` makes it of `args`. */
export function meshRequest(name, args, options) {
  const out = [null];
  return {
    name,
    args: [...args, optionsOf('ts_tooth_mesh_options', options), null, out],
    result: (root) => new ToothMesh(new Owner('ts_mesh', out[0], root)),
  };
}
