/* SPDX-License-Identifier: Apache-2.0 */
#include "fixture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <toothseg_arch.h>

static const double pi = 3.14159265358979323846;

void *must_have(size_t size) {
  void *memory = malloc(size ? size : 1);
  if (memory == NULL) {
    fprintf(stderr, "fixture: out of memory\n");
    exit(3);
  }
  return memory;
}

static void need_arch(int status) {
  if (status == TSA_OK) return;
  fprintf(stderr, "fixture: no arch: %s\n", tsa_last_error_message());
  exit(3);
}

static void need(ts_status status, const char *what) {
  if (status == TS_OK) return;
  fprintf(stderr, "fixture: no %s: %s: %s\n", what, ts_status_name(status), ts_last_error_message());
  exit(3);
}

/* -------------------------------------------------------------------------------------------------------- meshes */

mesh make_arch(uint32_t triangles) {
  return make_crowded_arch(triangles, 0, 1);
}

static mesh generated_arch(uint32_t triangles, double crowding, uint32_t seed) {
  tsa_options options;
  tsa_arch *arch = NULL;
  mesh m;
  need_arch(tsa_options_init(&options, sizeof options));
  options.triangles = triangles;
  options.crowding = crowding;
  options.seed = seed;
  need_arch(tsa_create(&options, &arch));
  need_arch(tsa_get_positions(arch, NULL, 0, &m.vertices));
  need_arch(tsa_get_triangles(arch, NULL, 0, &m.faces));
  m.xyz = must_have(3 * sizeof *m.xyz * m.vertices);
  m.triangles = must_have(3 * sizeof *m.triangles * m.faces);
  m.labels = must_have(sizeof *m.labels * m.faces);
  need_arch(tsa_get_positions(arch, m.xyz, m.vertices, &m.vertices));
  need_arch(tsa_get_triangles(arch, m.triangles, m.faces, &m.faces));
  need_arch(tsa_get_labels(arch, m.labels, m.faces, &m.faces));
  need_arch(tsa_get_teeth(arch, NULL, 0, &m.teeth));
  tsa_destroy(arch);
  return m;
}

/* A kept arch: three counts, then the arrays as they are. One that is not whole is not taken. */
static int read_arch(const char *path, mesh *m) {
  FILE *file = fopen(path, "rb");
  uint32_t counts[3];
  int whole;
  if (file == NULL) return 0;
  if (fread(counts, sizeof counts, 1, file) != 1) {
    fclose(file);
    return 0;
  }
  m->vertices = counts[0];
  m->faces = counts[1];
  m->teeth = counts[2];
  m->xyz = must_have(3 * sizeof *m->xyz * m->vertices);
  m->triangles = must_have(3 * sizeof *m->triangles * m->faces);
  m->labels = must_have(sizeof *m->labels * m->faces);
  whole = fread(m->xyz, 3 * sizeof *m->xyz, m->vertices, file) == m->vertices &&
          fread(m->triangles, 3 * sizeof *m->triangles, m->faces, file) == m->faces &&
          fread(m->labels, sizeof *m->labels, m->faces, file) == m->faces && fgetc(file) == EOF;
  fclose(file);
  if (!whole) free_mesh(m);
  return whole;
}

/* Written beside its place, and put there when it is whole: others may read it at any moment. */
static void keep_arch(const char *path, const mesh *m) {
  char beside[1100];
  const uint32_t counts[3] = {m->vertices, m->faces, m->teeth};
  FILE *file;
  int whole;
  snprintf(beside, sizeof beside, "%s.%p.%lx.%lx", path, (void *)beside, (unsigned long)time(NULL),
           (unsigned long)clock());
  file = fopen(beside, "wb");
  if (file == NULL) return;
  whole = fwrite(counts, sizeof counts, 1, file) == 1 &&
          fwrite(m->xyz, 3 * sizeof *m->xyz, m->vertices, file) == m->vertices &&
          fwrite(m->triangles, 3 * sizeof *m->triangles, m->faces, file) == m->faces &&
          fwrite(m->labels, sizeof *m->labels, m->faces, file) == m->faces;
  whole = fclose(file) == 0 && whole;
  if (!whole || rename(beside, path) != 0) remove(beside);
}

mesh make_crowded_arch(uint32_t triangles, double crowding, uint32_t seed) {
  const char *folder = getenv("TOOTHSEG_TEST_ARCHES");
  char path[1000];
  mesh m;
  if (folder == NULL) return generated_arch(triangles, crowding, seed);
  snprintf(path, sizeof path, "%s/%lu_%.0f_%lu", folder, (unsigned long)triangles, 1e6 * crowding, (unsigned long)seed);
  if (!read_arch(path, &m)) {
    m = generated_arch(triangles, crowding, seed);
    keep_arch(path, &m);
  }
  return m;
}

static void put_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
  uint32_t *t = m->triangles + 3 * (size_t)m->faces++;
  t[0] = a;
  t[1] = b;
  t[2] = c;
}

static void put_vertex(mesh *m, double x, double y, double z) {
  double *p = m->xyz + 3 * (size_t)m->vertices++;
  p[0] = x;
  p[1] = y;
  p[2] = z;
}

mesh make_sphere(double radius, uint32_t rings) {
  const uint32_t around = 2 * rings;
  mesh m;
  uint32_t i, k;
  memset(&m, 0, sizeof m);
  m.xyz = must_have(3 * sizeof *m.xyz * (2 + (size_t)around * (rings - 1)));
  m.triangles = must_have(3 * sizeof *m.triangles * 2 * (size_t)around * (rings - 1));
  put_vertex(&m, 0, 0, radius);
  for (i = 1; i < rings; ++i)
    for (k = 0; k < around; ++k) {
      const double theta = pi * i / rings, phi = 2 * pi * k / around;
      put_vertex(&m, radius * sin(theta) * cos(phi), radius * sin(theta) * sin(phi), radius * cos(theta));
    }
  put_vertex(&m, 0, 0, -radius);
  for (k = 0; k < around; ++k) {
    const uint32_t next = (k + 1) % around, last = 1 + around * (rings - 2);
    put_triangle(&m, 0, 1 + k, 1 + next);
    put_triangle(&m, m.vertices - 1, last + next, last + k);
    for (i = 1; i + 1 < rings; ++i) {
      const uint32_t a = 1 + around * (i - 1), b = a + around;
      put_triangle(&m, a + k, b + k, b + next);
      put_triangle(&m, a + k, b + next, a + next);
    }
  }
  return m;
}

mesh make_plane(double side, uint32_t cells) {
  mesh m;
  uint32_t i, k;
  memset(&m, 0, sizeof m);
  m.xyz = must_have(3 * sizeof *m.xyz * (cells + 1) * (size_t)(cells + 1));
  m.triangles = must_have(6 * sizeof *m.triangles * cells * (size_t)cells);
  for (i = 0; i <= cells; ++i)
    for (k = 0; k <= cells; ++k) put_vertex(&m, side * k / cells, side * i / cells, 0);
  for (i = 0; i < cells; ++i)
    for (k = 0; k < cells; ++k) {
      const uint32_t a = i * (cells + 1) + k, b = a + cells + 1;
      put_triangle(&m, a, a + 1, b + 1);
      put_triangle(&m, a, b + 1, b);
    }
  return m;
}

void free_mesh(mesh *m) {
  free(m->xyz);
  free(m->triangles);
  free(m->labels);
  memset(m, 0, sizeof *m);
}

ts_mesh_input input_of(const mesh *m) {
  ts_mesh_input input;
  need(ts_mesh_input_init(&input, sizeof input), "input");
  input.positions = m->xyz;
  input.vertex_count = m->vertices;
  input.triangles = m->triangles;
  input.triangle_count = m->faces;
  return input;
}

void label_centre(const mesh *m, uint32_t label, double xyz[3]) {
  double count = 0;
  uint32_t f, k, c;
  xyz[0] = xyz[1] = xyz[2] = 0;
  for (f = 0; f < m->faces; ++f) {
    if (m->labels[f] != label) continue;
    for (k = 0; k < 3; ++k)
      for (c = 0; c < 3; ++c) xyz[c] += m->xyz[3 * (size_t)m->triangles[3 * (size_t)f + k] + c];
    count += 3;
  }
  for (c = 0; c < 3; ++c) xyz[c] /= count;
}

/* --------------------------------------------------------------------------------------------------------- scans */

ts_context *make_context(uint32_t threads) {
  ts_context_options options;
  ts_context *context = NULL;
  need(ts_context_options_init(&options, sizeof options), "options");
  options.threads = threads;
  need(ts_context_create(&options, &context), "context");
  return context;
}

ts_model *make_model(ts_context *context, const mesh *m) {
  const ts_mesh_input input = input_of(m);
  ts_model *model = NULL;
  need(ts_model_create(context, &input, NULL, NULL, &model), "model");
  return model;
}

scan make_scan(uint32_t triangles, uint32_t threads) {
  return scan_of(make_arch(triangles), threads);
}

scan scan_of(mesh arch, uint32_t threads) {
  scan s;
  memset(&s, 0, sizeof s);
  s.arch = arch;
  s.context = make_context(threads);
  s.model = make_model(s.context, &s.arch);
  need(ts_detect_features(s.model, NULL, NULL, &s.features), "features");
  need(ts_segmentation_create(s.features, NULL, NULL, &s.segmentation), "segmentation");
  return s;
}

void free_scan(scan *s) {
  ts_segmentation_destroy(s->segmentation);
  ts_features_destroy(s->features);
  ts_model_destroy(s->model);
  ts_context_destroy(s->context);
  free_mesh(&s->arch);
}

double *proposed_clicks(const ts_segmentation *segmentation, uint32_t *count) {
  double *xyz;
  need(ts_propose_clicks(segmentation, NULL, 0, count), "clicks");
  xyz = must_have(3 * sizeof *xyz * *count);
  need(ts_propose_clicks(segmentation, xyz, *count, count), "clicks");
  return xyz;
}

/* --------------------------------------------------------------------------------------------------------- bytes */

void put_bytes(bytes *b, const void *data, size_t size) {
  if (size > b->capacity - b->size) {
    unsigned char *more = must_have(2 * (b->size + size));
    if (b->size) memcpy(more, b->data, b->size);
    free(b->data);
    b->data = more;
    b->capacity = 2 * (b->size + size);
  }
  if (size) memcpy(b->data + b->size, data, size);
  b->size += size;
}

int same_bytes(const bytes *a, const bytes *b) {
  return a->size == b->size && (a->size == 0 || memcmp(a->data, b->data, a->size) == 0);
}

void free_bytes(bytes *b) {
  free(b->data);
  memset(b, 0, sizeof *b);
}

/* All elements of a getter, called through a macro since the getters differ in what they take first. */
#define PUT_ALL(type, width, getter_of)                      \
  do {                                                       \
    uint32_t n_ = 0;                                         \
    type *all_ = NULL;                                       \
    need(getter_of(NULL, 0, &n_), "size");                   \
    all_ = must_have(sizeof *all_ * (width) * (size_t)n_);   \
    memset(all_, 0, sizeof *all_ *(width) * (size_t)n_);     \
    need(getter_of(all_, n_, &n_), "elements");              \
    put_bytes(&b, &n_, sizeof n_);                           \
    put_bytes(&b, all_, sizeof *all_ *(width) * (size_t)n_); \
    free(all_);                                              \
  } while (0)

bytes dump_features(const ts_features *features) {
  bytes b = {NULL, 0, 0};
  double occlusal[3];
  need(ts_features_get_occlusal(features, occlusal), "direction");
  put_bytes(&b, occlusal, sizeof occlusal);
#define ARCH(p, capacity, count) ts_features_get_arch(features, p, capacity, count)
#define POINTS(p, capacity, count) ts_features_get_points(features, p, capacity, count)
#define GROUPS(p, capacity, count) ts_features_get_groups(features, p, capacity, count)
  PUT_ALL(double, 3, ARCH);
  PUT_ALL(ts_feature_point, 1, POINTS);
  PUT_ALL(ts_feature_group, 1, GROUPS);
  return b;
}

/* Members one by one where a struct has padding, whose bytes mean nothing. */
#define PUT(member) put_bytes(&b, &(member), sizeof(member))

static void dump_click(bytes *out, const ts_segmentation *s, uint32_t click) {
  bytes b = *out;
  ts_click_info info;
  ts_contour_info *contours;
  uint32_t count = 0, i;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  need(ts_get_click(s, click, &info), "click");
  PUT(info.target);
  PUT(info.neighbour);
  PUT(info.position);
  PUT(info.target_distance);
  PUT(info.neighbour_distance);
  PUT(info.v_med);
  PUT(info.target_iso);
  PUT(info.neighbour_iso);
#define FIELD(p, capacity, count) ts_get_field(s, click, p, capacity, count)
#define HISTOGRAM(p, capacity, count) ts_get_histogram(s, click, p, capacity, count)
  PUT_ALL(double, 1, FIELD);
  PUT_ALL(uint32_t, 1, HISTOGRAM);
  need(ts_get_contours(s, click, NULL, 0, &count), "contours");
  contours = must_have(sizeof *contours * count);
  need(ts_get_contours(s, click, contours, count, &count), "contours");
  for (i = 0; i < count; ++i) {
    PUT(contours[i].iso);
    PUT(contours[i].gradient);
    PUT(contours[i].concavity);
    PUT(contours[i].length);
    PUT(contours[i].points);
    PUT(contours[i].polylines);
    PUT(contours[i].chosen);
  }
  free(contours);
  *out = b;
}

static void dump_tooth(bytes *out, const ts_segmentation *s, uint32_t tooth) {
  bytes b = *out;
  ts_tooth_info info;
  uint32_t loop;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  need(ts_get_tooth(s, tooth, &info), "tooth");
  put_bytes(&b, &info, offsetof(ts_tooth_info, warnings) + sizeof info.warnings);
#define FACES(p, capacity, count) ts_get_tooth_faces(s, tooth, p, capacity, count)
#define VERTICES(p, capacity, count) ts_get_tooth_vertices(s, tooth, p, capacity, count)
#define SEEDS(p, capacity, count) ts_get_tooth_seeds(s, tooth, p, capacity, count)
  PUT_ALL(uint32_t, 1, FACES);
  PUT_ALL(uint32_t, 1, VERTICES);
  PUT_ALL(uint32_t, 1, SEEDS);
  for (loop = 0; loop < info.loops; ++loop) {
#define CUT(p, capacity, count) ts_get_cut(s, tooth, loop, NULL, p, capacity, count)
    PUT_ALL(ts_edge_point, 1, CUT);
  }
  *out = b;
}

static void put_teeth(bytes *out, const ts_segmentation *segmentation) {
  bytes b = *out;
  uint32_t teeth = 0, i, locked;
  uint32_t *ids;
  need(ts_get_teeth(segmentation, NULL, 0, &teeth), "teeth");
  ids = must_have(sizeof *ids * teeth);
  need(ts_get_teeth(segmentation, ids, teeth, &teeth), "teeth");
  for (i = 0; i < teeth; ++i) {
    dump_tooth(&b, segmentation, ids[i]);
    need(ts_tooth_get_locked(segmentation, ids[i], &locked), "locked");
    PUT(locked);
  }
  free(ids);
#define LABELS(p, capacity, count) ts_get_labels(segmentation, p, capacity, count)
  PUT_ALL(uint32_t, 1, LABELS);
  *out = b;
}

bytes dump_teeth(const ts_segmentation *segmentation) {
  bytes b = {NULL, 0, 0};
  put_teeth(&b, segmentation);
  return b;
}

bytes dump_segmentation(const ts_segmentation *segmentation) {
  bytes b = {NULL, 0, 0};
  uint32_t clicks = 0, i;
  need(ts_get_click_count(segmentation, &clicks), "count");
  for (i = 0; i < clicks; ++i) dump_click(&b, segmentation, i);
  put_teeth(&b, segmentation);
  return b;
}
