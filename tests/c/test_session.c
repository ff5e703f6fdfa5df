/* A segmentation as a session: corrections, division, union, locks, undo and redo. SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static scan s;
static uint32_t teeth[64], count;

static void start(void) {
  ts_history_info h;
  memset(&h, 0, sizeof h);
  h.struct_size = sizeof h;
  while (ts_undo(s.segmentation) == TS_OK) continue;
  CHECK_STATUS(ts_set_history_limit(s.segmentation, (uint64_t)1 << 30), TS_OK);
  CHECK_STATUS(ts_get_history(s.segmentation, &h), TS_OK);
  CHECK(h.undo == 0 && h.complete == 1);
}

static void all(void) {
  start();
  CHECK_STATUS(ts_segment_all(s.segmentation, NULL), TS_OK);
  CHECK_STATUS(ts_get_teeth(s.segmentation, teeth, 64, &count), TS_OK);
}

static ts_tooth_info info_of(uint32_t tooth) {
  ts_tooth_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_get_tooth(s.segmentation, tooth, &info), TS_OK);
  return info;
}

static uint32_t *labels_now(void) {
  uint32_t n = s.arch.faces, *labels = must_have(sizeof *labels * n);
  CHECK_STATUS(ts_get_labels(s.segmentation, labels, n, &n), TS_OK);
  return labels;
}

static void middle_of(uint32_t face, double xyz[3]) {
  uint32_t k, c;
  for (k = 0; k < 3; ++k)
    for (xyz[k] = 0, c = 0; c < 3; ++c) xyz[k] += s.arch.xyz[3 * s.arch.triangles[3 * face + c] + k] / 3;
}

/* Of the arch's tooth `label`, and the separated one that most of it is in. */
static double overlap_with(uint32_t label, uint32_t tooth) {
  uint32_t *labels = labels_now(), f, common = 0, either = 0, own = info_of(tooth).label;
  for (f = 0; f < s.arch.faces; ++f) {
    common += s.arch.labels[f] == label && labels[f] == own;
    either += s.arch.labels[f] == label || labels[f] == own;
  }
  free(labels);
  return (double)common / either;
}

/* The arch's tooth that most faces of a separated one are of. */
static uint32_t truth_of(uint32_t tooth) {
  uint32_t votes[64] = {0}, *labels = labels_now(), f, best = 0, own = info_of(tooth).label;
  for (f = 0; f < s.arch.faces; ++f)
    if (labels[f] == own && s.arch.labels[f] < 64) ++votes[s.arch.labels[f]];
  for (f = 1; f < 64; ++f)
    if (votes[f] > votes[best]) best = f;
  free(labels);
  return best;
}

/* The face of `tooth`, or of no tooth (TS_NONE), nearest to a position. */
static uint32_t face_near(const double xyz[3], uint32_t tooth) {
  uint32_t *labels = labels_now(), f, best = 0, own = tooth == TS_NONE ? 0 : info_of(tooth).label;
  double least = 1e30;
  for (f = 0; f < s.arch.faces; ++f) {
    double m[3], d;
    if (labels[f] != own) continue;
    middle_of(f, m);
    d = pow(m[0] - xyz[0], 2) + pow(m[1] - xyz[1], 2) + pow(m[2] - xyz[2], 2);
    if (d < least) least = d, best = f;
  }
  free(labels);
  return best;
}

static void all_teeth_in_one_step(void) {
  ts_review_item items[64];
  ts_history_info h;
  uint32_t i, n = 0, groups = 0;
  all();
  memset(&h, 0, sizeof h);
  h.struct_size = sizeof h;
  CHECK_STATUS(ts_features_get_groups(s.features, NULL, 0, &groups), TS_OK);
  CHECK(count == groups && count == s.arch.teeth);
  for (i = 0; i < count; ++i) CHECK(overlap_with(truth_of(teeth[i]), teeth[i]) > 0.75);
  CHECK_STATUS(ts_get_history(s.segmentation, &h), TS_OK);
  CHECK(h.undo == 1 && h.redo == 0 && h.bytes > 0 && h.bytes <= h.limit);
  CHECK_STATUS(ts_get_changes(s.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == count);
  CHECK_STATUS(ts_get_review(s.segmentation, items, 64, &n), TS_OK);
  for (i = 0; i < n; ++i) {
    CHECK(items[i].separated == 1);
    CHECK(items[i].confidence < 0.9 || items[i].warnings != 0);
    CHECK(items[i].confidence == info_of(items[i].tooth).confidence);
    if (i) CHECK(items[i - 1].confidence <= items[i].confidence);
  }
  /* What is not there comes first. */
  CHECK_STATUS(ts_tooth_remove(s.segmentation, teeth[3]), TS_OK);
  CHECK_STATUS(ts_get_review(s.segmentation, items, 64, &n), TS_OK);
  REQUIRE(n > 0);
  CHECK(items[0].tooth == teeth[3] && items[0].separated == 0 && items[0].confidence == 0);
  /* Again: only what is missing is separated. */
  CHECK_STATUS(ts_segment_all(s.segmentation, NULL), TS_OK);
  CHECK_STATUS(ts_get_teeth(s.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == count);
}

static void undo_and_redo_give_the_same_bytes(void) {
  bytes state[5], now;
  uint32_t i, n = 0;
  double *clicks;
  start();
  clicks = proposed_clicks(s.segmentation, &n);
  REQUIRE(n >= 4);
  CHECK_STATUS(ts_undo(s.segmentation), TS_E_NO_HISTORY);
  for (i = 0; i < 5; ++i) {
    if (i) CHECK_STATUS(ts_segment_click(s.segmentation, clicks + 3 * (i - 1), NULL, NULL), TS_OK);
    state[i] = dump_segmentation(s.segmentation);
  }
  CHECK_STATUS(ts_redo(s.segmentation), TS_E_NO_HISTORY);
  for (i = 4; i-- > 0;) {
    CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
    now = dump_segmentation(s.segmentation);
    CHECK(same_bytes(&now, &state[i]));
    free_bytes(&now);
  }
  for (i = 1; i < 5; ++i) {
    CHECK_STATUS(ts_redo(s.segmentation), TS_OK);
    now = dump_segmentation(s.segmentation);
    CHECK(same_bytes(&now, &state[i]));
    free_bytes(&now);
  }
  /* A new step forgets what was taken back; what was known of the click that had its number is forgotten too. */
  CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  CHECK_STATUS(ts_segment_click(s.segmentation, clicks + 9, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_redo(s.segmentation), TS_E_NO_HISTORY);
  CHECK_STATUS(ts_segment_click(s.segmentation, clicks + 6, NULL, NULL), TS_OK);
  now = dump_teeth(s.segmentation);
  CHECK(now.size > 0);
  free_bytes(&now);
  for (i = 0; i < 5; ++i) free_bytes(&state[i]);
  free(clicks);
}

static void a_limit_drops_the_oldest(void) {
  ts_history_info h;
  bytes before, after;
  memset(&h, 0, sizeof h);
  h.struct_size = sizeof h;
  all();
  CHECK_STATUS(ts_tooth_set_locked(s.segmentation, teeth[0], 1), TS_OK);
  before = dump_segmentation(s.segmentation);
  CHECK_STATUS(ts_get_history(s.segmentation, &h), TS_OK);
  CHECK(h.undo == 2);
  CHECK_STATUS(ts_set_history_limit(s.segmentation, h.bytes - 1), TS_OK);
  CHECK_STATUS(ts_get_history(s.segmentation, &h), TS_OK);
  CHECK(h.undo == 1 && h.complete == 0);
  CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  CHECK_STATUS(ts_undo(s.segmentation), TS_E_NO_HISTORY);
  CHECK_STATUS(ts_redo(s.segmentation), TS_OK);
  after = dump_segmentation(s.segmentation);
  CHECK(same_bytes(&before, &after));
  free_bytes(&before);
  free_bytes(&after);
  /* A scan of its own again: this one cannot go back to its beginning any more. */
  ts_segmentation_destroy(s.segmentation);
  s.segmentation = NULL;
  CHECK_STATUS(ts_segmentation_create(s.features, NULL, NULL, &s.segmentation), TS_OK);
}

/* A point just outside the cut is taken in; then the same point is left out again. */
static void this_too_and_not_this(void) {
  uint32_t tooth, face, *labels, seeds;
  double centre[3], at[3];
  bytes before, after;
  all();
  tooth = teeth[2];
  label_centre(&s.arch, truth_of(tooth), centre);
  centre[2] -= 8; /* towards the gums */
  face = face_near(centre, TS_NONE);
  middle_of(face, at);
  seeds = info_of(tooth).seeds;
  if (CHECK_STATUS(ts_tooth_include(s.segmentation, tooth, at, NULL), TS_OK)) {
    labels = labels_now();
    CHECK(labels[face] == info_of(tooth).label);
    free(labels);
    CHECK(info_of(tooth).seeds > seeds);
    CHECK_STATUS(ts_tooth_include(s.segmentation, tooth, at, NULL), TS_E_NO_CHANGE);
    CHECK_STATUS(ts_tooth_exclude(s.segmentation, tooth, at, NULL), TS_OK);
    CHECK(info_of(tooth).seeds == seeds);
    CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
    CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  }
  /* A face of the neighbour at the contact goes over, and out of the neighbour. */
  label_centre(&s.arch, truth_of(teeth[3]), centre);
  {
    double own[3];
    int k;
    label_centre(&s.arch, truth_of(tooth), own);
    for (k = 0; k < 3; ++k) centre[k] = 0.7 * centre[k] + 0.3 * own[k];
  }
  face = face_near(centre, teeth[3]);
  middle_of(face, at);
  before = dump_teeth(s.segmentation);
  if (CHECK_STATUS(ts_tooth_include(s.segmentation, tooth, at, NULL), TS_OK)) {
    uint32_t changed[8], n = 0;
    labels = labels_now();
    CHECK(labels[face] == info_of(tooth).label);
    free(labels);
    CHECK_STATUS(ts_get_changes(s.segmentation, changed, 8, &n), TS_OK);
    CHECK(n == 2);
    CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  }
  after = dump_teeth(s.segmentation);
  CHECK(same_bytes(&before, &after));
  /* Refusals change nothing. */
  at[0] = at[1] = 0, at[2] = 500;
  CHECK_STATUS(ts_tooth_include(s.segmentation, tooth, at, NULL), TS_E_CLICK_OFF_SURFACE);
  CHECK_STATUS(ts_tooth_exclude(s.segmentation, tooth, at, NULL), TS_E_CLICK_OFF_SURFACE);
  at[2] = NAN;
  CHECK_STATUS(ts_tooth_include(s.segmentation, tooth, at, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_tooth_include(s.segmentation, 12345, centre, NULL), TS_E_NOT_FOUND);
  free_bytes(&after);
  after = dump_teeth(s.segmentation);
  CHECK(same_bytes(&before, &after));
  free_bytes(&before);
  free_bytes(&after);
}

static void split_and_merge(void) {
  uint32_t tooth, other, second = TS_NONE, n = 0, index = 77;
  double keep[3], part[3];
  all();
  tooth = teeth[0], other = teeth[1];
  label_centre(&s.arch, truth_of(tooth), keep);
  label_centre(&s.arch, truth_of(other), part);
  CHECK_STATUS(ts_tooth_merge(s.segmentation, tooth, tooth, NULL), TS_E_NO_CHANGE);
  CHECK_STATUS(ts_tooth_merge(s.segmentation, tooth, other, NULL), TS_OK);
  CHECK_STATUS(ts_get_teeth(s.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == count - 1);
  CHECK_STATUS(ts_tooth_merge(s.segmentation, tooth, other, NULL), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_propose_clicks(s.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == 0); /* the one that went up in the other is not missing */
  /* Apart again, by a point on each. */
  CHECK_STATUS(ts_tooth_split(s.segmentation, tooth, keep, keep, NULL, &index), TS_E_NO_CHANGE);
  CHECK(index == 77);
  CHECK_STATUS(ts_tooth_split(s.segmentation, tooth, keep, part, NULL, &second), TS_OK);
  CHECK(overlap_with(truth_of(tooth), tooth) > 0.75);
  CHECK(overlap_with(truth_of(second), second) > 0.75);
  CHECK(truth_of(second) != truth_of(tooth));
  CHECK_STATUS(ts_get_teeth(s.segmentation, NULL, 0, &n), TS_OK);
  CHECK(n == count);
}

static int is_seed(uint32_t tooth, uint32_t vertex) {
  uint32_t n = 0, i, found = 0, *seeds;
  CHECK_STATUS(ts_get_tooth_seeds(s.segmentation, tooth, NULL, 0, &n), TS_OK);
  seeds = must_have(sizeof *seeds * n);
  CHECK_STATUS(ts_get_tooth_seeds(s.segmentation, tooth, seeds, n, &n), TS_OK);
  for (i = 0; i < n; ++i) found |= seeds[i] == vertex;
  free(seeds);
  return (int)found;
}

static void a_point_is_moved(void) {
  uint32_t n = 0, i, tooth, beside = 0, vertex;
  ts_feature_point *points, point, other;
  ts_surface_point goal;
  double centre[3], to[3];
  bytes before, after;
  int k;
  all();
  memset(&point, 0, sizeof point);
  memset(&other, 0, sizeof other);
  tooth = teeth[2], beside = teeth[3];
  CHECK_STATUS(ts_features_get_points(s.features, NULL, 0, &n), TS_OK);
  points = must_have(sizeof *points * n);
  CHECK_STATUS(ts_features_get_points(s.features, points, n, &n), TS_OK);
  for (i = 0; i < n; ++i) {
    if (points[i].group == tooth) point = points[i];
    if (points[i].group == beside) other = points[i];
  }
  free(points);
  CHECK(is_seed(tooth, point.vertex));
  label_centre(&s.arch, truth_of(tooth), centre);
  for (k = 0; k < 3; ++k) to[k] = 0.6 * point.position[k] + 0.4 * centre[k];
  CHECK_STATUS(ts_model_nearest(s.model, to, &goal), TS_OK);
  before = dump_segmentation(s.segmentation);
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, goal.position, point.position, NULL), TS_E_NO_CHANGE);
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, point.position, point.position, NULL), TS_E_NO_CHANGE);
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, point.position, other.position, NULL), TS_E_NO_CUT);
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, beside, point.position, goal.position, NULL), TS_E_NO_CHANGE);
  to[2] += 500;
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, point.position, to, NULL), TS_E_CLICK_OFF_SURFACE);
  after = dump_segmentation(s.segmentation);
  CHECK(same_bytes(&before, &after));
  free_bytes(&after);

  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, point.position, goal.position, NULL), TS_OK);
  vertex = goal.nearest_vertex;
  CHECK(!is_seed(tooth, point.vertex) && is_seed(tooth, vertex));
  CHECK(overlap_with(truth_of(tooth), tooth) > 0.75);
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, point.position, goal.position, NULL), TS_E_NO_CHANGE);
  /* And back, which is where it was freed: it is taken in again there. */
  CHECK_STATUS(ts_tooth_include(s.segmentation, tooth, point.position, NULL), TS_OK);
  CHECK(is_seed(tooth, point.vertex));
  CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  after = dump_segmentation(s.segmentation);
  CHECK(same_bytes(&before, &after));
  free_bytes(&before);
  free_bytes(&after);
}

static void locked_teeth_stay(void) {
  uint32_t tooth, locked = 5, n = 0;
  double at[3], *clicks;
  ts_tooth_info before, after;
  all();
  tooth = teeth[4];
  before = info_of(tooth);
  CHECK_STATUS(ts_tooth_get_locked(s.segmentation, tooth, &locked), TS_OK);
  CHECK(locked == 0);
  CHECK_STATUS(ts_tooth_set_locked(s.segmentation, tooth, 2), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_tooth_set_locked(s.segmentation, tooth, 0), TS_E_NO_CHANGE);
  CHECK_STATUS(ts_tooth_set_locked(s.segmentation, tooth, 1), TS_OK);
  CHECK_STATUS(ts_tooth_get_locked(s.segmentation, tooth, &locked), TS_OK);
  CHECK(locked == 1);
  label_centre(&s.arch, truth_of(tooth), at);
  middle_of(face_near(at, tooth), at);
  CHECK_STATUS(ts_segment_click(s.segmentation, at, NULL, NULL), TS_E_LOCKED);
  CHECK_STATUS(ts_tooth_remove(s.segmentation, tooth), TS_E_LOCKED);
  CHECK_STATUS(ts_tooth_exclude(s.segmentation, tooth, at, NULL), TS_E_LOCKED);
  CHECK_STATUS(ts_tooth_merge(s.segmentation, teeth[3], tooth, NULL), TS_E_LOCKED);
  CHECK_STATUS(ts_tooth_split(s.segmentation, tooth, at, at, NULL, NULL), TS_E_LOCKED);
  CHECK_STATUS(ts_tooth_move_point(s.segmentation, tooth, at, at, NULL), TS_E_LOCKED);
  label_centre(&s.arch, truth_of(teeth[3]), at);
  CHECK_STATUS(ts_segment_click(s.segmentation, at, NULL, NULL), TS_OK); /* as the neighbour it is left as it is */
  after = info_of(tooth);
  CHECK(after.click == before.click && after.faces == before.faces);
  clicks = proposed_clicks(s.segmentation, &n);
  free(clicks);
  CHECK(n == 0);
}

static uint32_t told_count, told[64];
static void listen(void *user, const uint32_t *changed, uint32_t n) {
  uint32_t clicks = 0;
  ++*(int *)user;
  told_count = n;
  if (n <= 64) memcpy(told, changed, n * sizeof *told);
  CHECK_STATUS(ts_get_click_count(s.segmentation, &clicks), TS_OK); /* it may read */
  CHECK_STATUS(ts_undo(s.segmentation), TS_E_INVALID_ARGUMENT);     /* and nothing else */
  CHECK_STATUS(ts_segment_all(s.segmentation, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_segment_clicks(s.segmentation, NULL, 0, NULL, NULL), TS_E_INVALID_ARGUMENT);
}

static void a_listener_is_told_what_changed(void) {
  int calls = 0;
  uint32_t now[64], n = 0;
  double off[3] = {0, 0, 500};
  start();
  CHECK_STATUS(ts_set_change_callback(s.segmentation, listen, &calls), TS_OK);
  CHECK_STATUS(ts_segment_all(s.segmentation, NULL), TS_OK);
  CHECK(calls == 1 && told_count == s.arch.teeth);
  CHECK_STATUS(ts_get_teeth(s.segmentation, teeth, 64, &count), TS_OK);
  CHECK_STATUS(ts_tooth_remove(s.segmentation, teeth[5]), TS_OK);
  CHECK(calls == 2 && told_count == 1 && told[0] == teeth[5]);
  CHECK_STATUS(ts_segment_click(s.segmentation, off, NULL, NULL), TS_E_CLICK_OFF_SURFACE);
  CHECK(calls == 2);
  CHECK_STATUS(ts_undo(s.segmentation), TS_OK);
  CHECK(calls == 3 && told_count == 1 && told[0] == teeth[5]);
  CHECK_STATUS(ts_get_changes(s.segmentation, now, 64, &n), TS_OK);
  CHECK(n == 1 && now[0] == teeth[5]);
  CHECK_STATUS(ts_set_change_callback(s.segmentation, NULL, NULL), TS_OK);
  CHECK_STATUS(ts_redo(s.segmentation), TS_OK);
  CHECK(calls == 3);
}

static void overlaps_are_told(void) {
  ts_overlap found[64];
  uint32_t n = 0, i, k, faces[2], *labels, *list[2];
  all();
  CHECK_STATUS(ts_get_overlaps(s.segmentation, found, 64, &n), TS_OK);
  labels = labels_now();
  for (i = 0; i < n; ++i) {
    uint32_t common = 0, lost = 0, a, b;
    for (k = 0; k < 2; ++k) {
      const uint32_t tooth = k ? found[i].loser : found[i].winner;
      CHECK_STATUS(ts_get_tooth_faces(s.segmentation, tooth, NULL, 0, &faces[k]), TS_OK);
      list[k] = must_have(sizeof **list * faces[k]);
      CHECK_STATUS(ts_get_tooth_faces(s.segmentation, tooth, list[k], faces[k], &faces[k]), TS_OK);
    }
    for (a = 0, b = 0; a < faces[0] && b < faces[1];) {
      if (list[0][a] == list[1][b])
        ++common, lost += labels[list[0][a]] != info_of(found[i].loser).label, ++a, ++b;
      else if (list[0][a] < list[1][b])
        ++a;
      else
        ++b;
    }
    CHECK(found[i].faces > 0 && found[i].faces <= common && found[i].area > 0);
    CHECK(lost >= found[i].faces);
    for (k = 0; k < 2; ++k) free(list[k]);
  }
  free(labels);
}

static uint32_t random_state = 12345;
static uint32_t any(uint32_t below) {
  random_state = random_state * 1664525u + 1013904223u;
  return (random_state >> 8) % below;
}

/* Of a tooth: where its last feature point lies, or one of the arch for a tooth that has none. */
static const double *point_of(uint32_t tooth) {
  static ts_feature_point points[512];
  uint32_t n = 0, i, found = 0;
  CHECK_STATUS(ts_features_get_points(s.features, points, 512, &n), TS_OK);
  for (i = 0; i < n; ++i)
    if (points[i].group == tooth) found = i;
  return points[found].position;
}

/* One random step, which may be refused. */
static ts_status random_step(void) {
  double at[3], other[3];
  uint32_t tooth;
  CHECK_STATUS(ts_get_teeth(s.segmentation, teeth, 64, &count), TS_OK);
  middle_of(any(s.arch.faces), at);
  middle_of(any(s.arch.faces), other);
  if (count == 0) return ts_segment_click(s.segmentation, at, NULL, NULL);
  tooth = teeth[any(count)];
  switch (any(11)) {
    case 0: return ts_tooth_include(s.segmentation, tooth, at, NULL);
    case 1: return ts_tooth_exclude(s.segmentation, tooth, at, NULL);
    case 2: return ts_tooth_split(s.segmentation, tooth, at, other, NULL, NULL);
    case 3: return ts_tooth_merge(s.segmentation, tooth, teeth[any(count)], NULL);
    case 4: return ts_tooth_remove(s.segmentation, tooth);
    case 5: return ts_tooth_set_locked(s.segmentation, tooth, any(2));
    case 6: return ts_undo(s.segmentation);
    case 7: return ts_tooth_move_point(s.segmentation, tooth, point_of(tooth), at, NULL);
    default: return ts_segment_click(s.segmentation, at, NULL, NULL);
  }
}

#ifdef TS_SANITIZED
enum { SEQUENCES = 100 }; /* ten times as slow */
#else
enum { SEQUENCES = 1000 };
#endif

static void random_sequences_there_and_back(void) {
  int sequence, step;
  bytes empty, end, now;
  start();
  empty = dump_teeth(s.segmentation);
  for (sequence = 0; sequence < SEQUENCES; ++sequence) {
    harness_case("sequence %d", sequence);
    for (step = 0; step < 5; ++step) {
      const ts_status status = random_step();
      CHECK(status == TS_OK || (status >= 600 && status < 700) || status == TS_E_NOT_FOUND);
    }
    while (ts_redo(s.segmentation) == TS_OK) continue; /* what the last steps took back */
    end = dump_teeth(s.segmentation);
    while (ts_undo(s.segmentation) == TS_OK) continue;
    now = dump_teeth(s.segmentation);
    CHECK(same_bytes(&now, &empty));
    free_bytes(&now);
    while (ts_redo(s.segmentation) == TS_OK) continue;
    now = dump_teeth(s.segmentation);
    CHECK(same_bytes(&now, &end));
    free_bytes(&now);
    free_bytes(&end);
    while (ts_undo(s.segmentation) == TS_OK) continue;
  }
  harness_case(NULL);
  free_bytes(&empty);
}

int main(void) {
  s = make_scan(LARGE, 2);
  RUN(all_teeth_in_one_step);
  RUN(undo_and_redo_give_the_same_bytes);
  RUN(a_limit_drops_the_oldest);
  RUN(this_too_and_not_this);
  RUN(split_and_merge);
  RUN(a_point_is_moved);
  RUN(locked_teeth_stay);
  RUN(a_listener_is_told_what_changed);
  RUN(overlaps_are_told);
  free_scan(&s);
  s = make_scan(10000, 2);
  RUN(random_sequences_there_and_back);
  free_scan(&s);
  return harness_finish();
}
