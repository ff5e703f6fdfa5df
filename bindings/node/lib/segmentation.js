// A prepared scan, its clicks and teeth, corrections, numbers, session. SPDX-License-Identifier: Apache-2.0
import { Preset } from './abi.js';
import { invalid } from './errors.js';
import { Features } from './features.js';
import { later } from './later.js';
import { meshRequest } from './mesh.js';
import { decodeIndices, register, unregister } from './native.js';
import {
  JOB_OPTIONS, Owner, Resource, SETTLED, blank, call, elements, info, now, optionsOf, ownerOf, records, value,
} from './resource.js';
import { bytes64, index, number, point, points, text, tidy } from './values.js';

function create(features, options) {
  const { preset = Preset.DEFAULT } = options;
  const out = [null];
  const o = optionsOf('ts_segment_options', options, [...JOB_OPTIONS, 'preset'], index(preset, 'preset'));
  return {
    name: 'ts_segmentation_create',
    args: [features, o, null, out],
    result: (root) => new Segmentation(new Owner('ts_segmentation', out[0], root)),
  };
}

// A call on a tooth that gives nothing.
const onTooth = (name, segmentation, tooth, ...args) => ({ name, args: [segmentation, index(tooth, 'tooth'), ...args, null] });

function clickRequest(segmentation, position) {
  const click = new Uint32Array(1);
  return {
    name: 'ts_segment_click',
    args: [segmentation, point(position, 'position'), null, click],
    result: () => click[0],
  };
}

function clicksRequest(segmentation, positions) {
  const xyz = points(positions, 'positions');
  const statuses = new Int32Array(xyz.length / 3);
  return {
    name: 'ts_segment_clicks',
    args: [segmentation, xyz.length ? xyz : new Float64Array(3), statuses.length, null, statuses],
    result: () => [...statuses],
  };
}

function splitRequest(segmentation, tooth, keep, part) {
  const second = new Uint32Array(1);
  return {
    name: 'ts_tooth_split',
    args: [segmentation, index(tooth, 'tooth'), point(keep, 'keep'), point(part, 'part'), null, second],
    result: () => second[0],
  };
}

function drawRequest(segmentation, tooth, stroke) {
  const xyz = points(stroke, 'stroke');
  return onTooth('ts_cut_draw', segmentation, tooth, xyz.length ? xyz : new Float64Array(3), xyz.length / 3);
}

const dragRequest = (segmentation, tooth, loop, at, to, { reach = 0 }) =>
  onTooth('ts_cut_drag', segmentation, tooth, index(loop, 'loop'), index(at, 'point'), point(to, 'to'), number(reach, 'reach'));

const saveRequest = (segmentation, path, format, options) => ({
  name: 'ts_segmentation_save',
  args: [segmentation, text(path, 'path'), index(format, 'format'), optionsOf('ts_save_options', options), null],
});

function sessionRequest(name, args) {
  const [features, segmentation] = [[null], [null]];
  return {
    name,
    args: [...args, null, features, segmentation],
    result: (root) => ({
      features: new Features(new Owner('ts_features', features[0], root)),
      segmentation: new Segmentation(new Owner('ts_segmentation', segmentation[0], root)),
    }),
  };
}

function readSessionRequest(model, session) {
  if (typeof session !== 'string') throw invalid('the session is no text');
  const bytes = new TextEncoder().encode(session);
  return sessionRequest('ts_session_read', [model, bytes, bytes.length]);
}

const loadSessionRequest = (model, path) => sessionRequest('ts_session_load', [model, text(path, 'path')]);

export class Segmentation extends Resource {
  #listener = null;
  #labelCount;
  #changes = []; // told by the library, and not yet to the listener

  constructor(owner) {
    super(owner, 'Segmentation.create, loadSession or readSession');
  }

  static async create(features, options = {}) {
    return later(create(features, options), options);
  }
  static createSync(features, options = {}) {
    return now(create(features, options), options);
  }

  // -------------------------------------------------------------------------------------------------------- clicks

  async click(position, options = {}) {
    return later(clickRequest(this, position), options);
  }
  clickSync(position, options = {}) {
    return now(clickRequest(this, position), options);
  }
  async clicks(positions, options = {}) {
    return later(clicksRequest(this, positions), options);
  }
  clicksSync(positions, options = {}) {
    return now(clicksRequest(this, positions), options);
  }
  async segmentAll(options = {}) {
    return later({ name: 'ts_segment_all', args: [this, null] }, options);
  }
  segmentAllSync(options = {}) {
    return now({ name: 'ts_segment_all', args: [this, null] }, options);
  }
  proposeClicks() {
    const xyz = elements(Float64Array, 3, 'ts_propose_clicks', [this]);
    return Array.from({ length: xyz.length / 3 }, (_, i) => [...xyz.subarray(3 * i, 3 * i + 3)]);
  }

  clickCount() {
    return value('ts_get_click_count', this);
  }
  clickInfo(click) {
    return info('ts_get_click', 'ts_click_info', this, index(click, 'click'));
  }
  field(click, into) {
    return elements(Float64Array, 1, 'ts_get_field', [this, index(click, 'click')], into);
  }
  histogram(click) {
    return elements(Uint32Array, 1, 'ts_get_histogram', [this, index(click, 'click')]);
  }
  contours(click) {
    return records('ts_contour_info', 'ts_get_contours', [this, index(click, 'click')]);
  }
  contourPoints(click, contour) {
    const polylines = this.contours(click)[index(contour, 'contour')]?.polylines ?? 0;
    const starts = new Uint32Array(polylines);
    const closed = new Uint8Array(polylines);
    // The library is asked also where there is no such contour, and says so.
    const all = records('ts_edge_point', 'ts_get_contour_points', [this, click, contour], [starts, closed]);
    const line = (start, i) => ({ points: all.slice(start, starts[i + 1] ?? all.length), closed: closed[i] !== 0 });
    return Array.from(starts, line);
  }

  // --------------------------------------------------------------------------------------------------------- teeth

  teeth() {
    return [...elements(Uint32Array, 1, 'ts_get_teeth', [this])];
  }
  tooth(tooth) {
    return info('ts_get_tooth', 'ts_tooth_info', this, index(tooth, 'tooth'));
  }
  toothFaces(tooth, into) {
    return elements(Uint32Array, 1, 'ts_get_tooth_faces', [this, index(tooth, 'tooth')], into);
  }
  toothVertices(tooth, into) {
    return elements(Uint32Array, 1, 'ts_get_tooth_vertices', [this, index(tooth, 'tooth')], into);
  }
  toothSeeds(tooth) {
    return elements(Uint32Array, 1, 'ts_get_tooth_seeds', [this, index(tooth, 'tooth')]);
  }
  toothFrame(tooth) {
    return info('ts_get_tooth_frame', 'ts_tooth_frame', this, index(tooth, 'tooth'));
  }
  cut(tooth, loop = 0) {
    const record = blank('ts_cut_info');
    const points = records('ts_edge_point', 'ts_get_cut', [this, index(tooth, 'tooth'), index(loop, 'loop'), record]);
    return { info: tidy('ts_cut_info', record), points };
  }
  labels(into) {
    // Their number never changes, and the library works all of them out to tell it.
    if (into === undefined) into = new Uint32Array((this.#labelCount ??= value('ts_get_labels', this, null, 0)));
    return elements(Uint32Array, 1, 'ts_get_labels', [this], into);
  }
  review() {
    return records('ts_review_item', 'ts_get_review', [this]);
  }
  overlaps() {
    return records('ts_overlap', 'ts_get_overlaps', [this]);
  }
  prepareTimes() {
    return info('ts_get_prepare_times', 'ts_prepare_times', this);
  }
  memory() {
    return info('ts_get_memory', 'ts_memory_info', this);
  }

  // --------------------------------------------------------------------------------------------------- corrections

  async includePoint(tooth, position, options = {}) {
    return later(onTooth('ts_tooth_include', this, tooth, point(position, 'position')), options);
  }
  includePointSync(tooth, position, options = {}) {
    return now(onTooth('ts_tooth_include', this, tooth, point(position, 'position')), options);
  }
  async excludePoint(tooth, position, options = {}) {
    return later(onTooth('ts_tooth_exclude', this, tooth, point(position, 'position')), options);
  }
  excludePointSync(tooth, position, options = {}) {
    return now(onTooth('ts_tooth_exclude', this, tooth, point(position, 'position')), options);
  }
  async splitTooth(tooth, keep, part, options = {}) {
    return later(splitRequest(this, tooth, keep, part), options);
  }
  splitToothSync(tooth, keep, part, options = {}) {
    return now(splitRequest(this, tooth, keep, part), options);
  }
  async movePoint(tooth, from, to, options = {}) {
    return later(onTooth('ts_tooth_move_point', this, tooth, point(from, 'from'), point(to, 'to')), options);
  }
  movePointSync(tooth, from, to, options = {}) {
    return now(onTooth('ts_tooth_move_point', this, tooth, point(from, 'from'), point(to, 'to')), options);
  }
  async mergeTeeth(tooth, other, options = {}) {
    return later(onTooth('ts_tooth_merge', this, tooth, index(other, 'other')), options);
  }
  mergeTeethSync(tooth, other, options = {}) {
    return now(onTooth('ts_tooth_merge', this, tooth, index(other, 'other')), options);
  }
  removeTooth(tooth) {
    call('ts_tooth_remove', this, index(tooth, 'tooth'));
  }
  setLocked(tooth, locked) {
    call('ts_tooth_set_locked', this, index(tooth, 'tooth'), locked ? 1 : 0);
  }
  isLocked(tooth) {
    return value('ts_tooth_get_locked', this, index(tooth, 'tooth')) !== 0;
  }

  // ------------------------------------------------------------------------------------------------ edits of a cut

  async dragCut(tooth, loop, at, to, options = {}) {
    return later(dragRequest(this, tooth, loop, at, to, options), options);
  }
  dragCutSync(tooth, loop, at, to, options = {}) {
    return now(dragRequest(this, tooth, loop, at, to, options), options);
  }
  async drawCut(tooth, stroke, options = {}) {
    return later(drawRequest(this, tooth, stroke), options);
  }
  drawCutSync(tooth, stroke, options = {}) {
    return now(drawRequest(this, tooth, stroke), options);
  }
  async offsetCut(tooth, mm, options = {}) {
    return later(onTooth('ts_cut_offset', this, tooth, number(mm, 'mm')), options);
  }
  offsetCutSync(tooth, mm, options = {}) {
    return now(onTooth('ts_cut_offset', this, tooth, number(mm, 'mm')), options);
  }
  async smoothCut(tooth, strength, options = {}) {
    return later(onTooth('ts_cut_smooth', this, tooth, number(strength, 'strength')), options);
  }
  smoothCutSync(tooth, strength, options = {}) {
    return now(onTooth('ts_cut_smooth', this, tooth, number(strength, 'strength')), options);
  }
  resetCut(tooth) {
    call('ts_cut_reset', this, index(tooth, 'tooth'));
  }
  cutEdits(tooth) {
    return records('ts_cut_edit', 'ts_get_cut_edits', [this, index(tooth, 'tooth')]);
  }

  // ------------------------------------------------------------------------------------------------------- numbers

  assignNumbers(options = {}) {
    call('ts_assign_numbers', this, optionsOf('ts_number_options', options, []));
  }
  setNumber(tooth, fdi) {
    call('ts_set_number', this, index(tooth, 'tooth'), index(fdi, 'fdi'));
  }
  number(tooth) {
    return info('ts_get_number', 'ts_number_info', this, index(tooth, 'tooth'));
  }
  jaw() {
    return info('ts_get_jaw', 'ts_jaw_info', this);
  }

  // ------------------------------------------------------------------------------------------------ meshes and files

  async toothMesh(tooth, options = {}) {
    return later(meshRequest('ts_tooth_mesh_create', [this, index(tooth, 'tooth')], options), options);
  }
  toothMeshSync(tooth, options = {}) {
    return now(meshRequest('ts_tooth_mesh_create', [this, index(tooth, 'tooth')], options), options);
  }
  async gingivaMesh(options = {}) {
    return later(meshRequest('ts_gingiva_mesh_create', [this], options), options);
  }
  gingivaMeshSync(options = {}) {
    return now(meshRequest('ts_gingiva_mesh_create', [this], options), options);
  }
  async save(path, format, options = {}) {
    return later(saveRequest(this, path, format, options), options);
  }
  saveSync(path, format, options = {}) {
    return now(saveRequest(this, path, format, options), options);
  }

  // ------------------------------------------------------------------------------------------------------- session

  undo() {
    call('ts_undo', this);
  }
  redo() {
    call('ts_redo', this);
  }
  history() {
    return info('ts_get_history', 'ts_history_info', this);
  }
  setHistoryLimit(bytes) {
    call('ts_set_history_limit', this, bytes64(bytes, 'bytes'));
  }
  changes() {
    return [...elements(Uint32Array, 1, 'ts_get_changes', [this])];
  }

  /** Calls `listener` after each change, with the ids of the teeth; null: nobody. */
  onChange(listener) {
    const owner = ownerOf(this);
    const changes = this.#changes;
    // The native callback only notes what it is told. It may come while JavaScript goes on, and must not keep this alive.
    const callback = listener
      ? register((_, teeth, count) => void changes.push([...decodeIndices(teeth, count)]), 'ts_change_fn')
      : null;
    try {
      call('ts_set_change_callback', this, callback, null);
    } catch (error) {
      if (callback) unregister(callback);
      throw error;
    }
    if (owner.callback) unregister(owner.callback);
    owner.callback = callback;
    this.#listener = listener ?? null;
  }

  [SETTLED]() {
    for (const teeth of this.#changes.splice(0)) this.#listener?.(teeth);
  }

  /** The session as text, for readSession(). */
  writeSession() {
    return new TextDecoder().decode(elements(Uint8Array, 1, 'ts_session_write', [this]));
  }
  saveSession(path) {
    call('ts_session_save', this, text(path, 'path'));
  }

  static async loadSession(model, path, options = {}) {
    return later(loadSessionRequest(model, path), options);
  }
  static loadSessionSync(model, path, options = {}) {
    return now(loadSessionRequest(model, path), options);
  }
  static async readSession(model, session, options = {}) {
    return later(readSessionRequest(model, session), options);
  }
  static readSessionSync(model, session, options = {}) {
    return now(readSessionRequest(model, session), options);
  }
}
