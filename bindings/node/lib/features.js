// Feature points of the teeth. SPDX-License-Identifier: Apache-2.0
import { NONE } from './abi.js';
import { later } from './later.js';
import { Owner, Resource, call, elements, info, now, optionsOf, records, value } from './resource.js';
import { index, point } from './values.js';

function made(name, args, out = [null]) {
  return { name, args: [...args, out], result: (root) => new Owner('ts_features', out[0], root) };
}

const detect = (model, options) => {
  const request = made('ts_detect_features', [model, optionsOf('ts_feature_options', options), null]);
  return { ...request, result: (root) => new Features(request.result(root)) };
};

export class Features extends Resource {
  /** An empty set on a model, to be filled by hand. */
  constructor(model) {
    super(model instanceof Owner ? model : now(made('ts_features_create', [model])), 'Features.detect or new Features(model)');
  }

  static async detect(model, options = {}) {
    return later(detect(model, options), options);
  }
  static detectSync(model, options = {}) {
    return now(detect(model, options), options);
  }

  clone() {
    return new Features(now(made('ts_features_clone', [this])));
  }

  info() {
    return info('ts_features_get_info', 'ts_features_info', this);
  }
  occlusal() {
    const direction = new Float64Array(3);
    call('ts_features_get_occlusal', this, direction);
    return [...direction];
  }
  setOcclusal(direction) {
    call('ts_features_set_occlusal', this, point(direction, 'direction'));
  }
  arch() {
    return elements(Float64Array, 3, 'ts_features_get_arch', [this]);
  }
  points() {
    return records('ts_feature_point', 'ts_features_get_points', [this]);
  }
  groups() {
    return records('ts_feature_group', 'ts_features_get_groups', [this]);
  }

  addPoint(position, group = NONE) {
    const added = new Uint32Array(1);
    const to = value('ts_features_add_point', this, point(position, 'position'), index(group, 'group'), added);
    return { point: added[0], group: to };
  }
  movePoint(id, position) {
    call('ts_features_move_point', this, index(id, 'point'), point(position, 'position'));
  }
  setGroup(id, group = NONE) {
    return value('ts_features_set_group', this, index(id, 'point'), index(group, 'group'));
  }
  removePoint(id) {
    call('ts_features_remove_point', this, index(id, 'point'));
  }
  removeGroup(group) {
    call('ts_features_remove_group', this, index(group, 'group'));
  }
}
