/* Teeth and gingiva as meshes of their own, and as files. SPDX-License-Identifier: Apache-2.0 */
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200112L /* setrlimit, to fill up the disk */
#endif
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if !defined(_WIN32)
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "fixture.h"
#include "harness.h"

static scan s;
static uint32_t *ids, teeth;
static double model_area;

static ts_mesh_info info_of(const ts_mesh *part) {
  ts_mesh_info info;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  CHECK_STATUS(ts_mesh_get_info(part, &info), TS_OK);
  return info;
}

static ts_mesh *make(uint32_t tooth, uint32_t closed) {
  ts_mesh *part = NULL;
  ts_tooth_mesh_options o;
  CHECK_STATUS(ts_tooth_mesh_options_init(&o, sizeof o), TS_OK);
  CHECK(o.closed == 0);
  o.closed = closed;
  if (tooth == TS_NONE)
    CHECK_STATUS(ts_gingiva_mesh_create(s.segmentation, &o, NULL, &part), TS_OK);
  else
    CHECK_STATUS(ts_tooth_mesh_create(s.segmentation, tooth, &o, NULL, &part), TS_OK);
  return part;
}

static int set_up(void) {
  uint32_t clicks = 0;
  double *proposed;
  ts_intake_report report;
  s = make_scan(16000, 0);
  proposed = proposed_clicks(s.segmentation, &clicks);
  if (ts_segment_clicks(s.segmentation, proposed, clicks, NULL, NULL) != TS_OK) return 0;
  free(proposed);
  if (ts_get_teeth(s.segmentation, NULL, 0, &teeth) != TS_OK || teeth < 2) return 0;
  ids = must_have(sizeof *ids * teeth);
  memset(&report, 0, sizeof report);
  report.struct_size = sizeof report;
  if (ts_model_get_report(s.model, &report) != TS_OK) return 0;
  model_area = report.area;
  return ts_get_teeth(s.segmentation, ids, teeth, &teeth) == TS_OK;
}

/* ------------------------------------------------------------------------------------------------------------ meshes
 */

static void open_parts_add_up(void) {
  double area = 0, lost = 0;
  uint32_t i;
  for (i = 0; i <= teeth; ++i) {
    ts_mesh *part = make(i < teeth ? ids[i] : TS_NONE, 0);
    const ts_mesh_info info = info_of(part);
    area += info.area;
    lost += info.lost;
    CHECK(info.label == (i < teeth ? i + 1 : 0));
    CHECK(info.open_rims > 0 && info.closed_rims == 0 && info.fill_triangles == 0 && info.volume == 0);
    CHECK(info.cut_vertices > 10 && info.cut_vertices < info.vertices);
    ts_mesh_destroy(part);
  }
  CHECK_NEAR(area / model_area, 1, 1e-6);
  CHECK(lost >= 0 && lost < 0.05 * model_area);
}

static void a_mesh_is_as_its_getters_say(void) {
  ts_mesh *part = make(ids[1], 1), *scans = make(ids[1], 0);
  const ts_mesh_info info = info_of(part), before = info_of(scans);
  double *xyz = must_have(3 * sizeof *xyz * info.vertices), *normals = must_have(3 * sizeof *normals * info.vertices);
  uint32_t *triangles = must_have(3 * sizeof *triangles * info.triangles);
  uint32_t *faces = must_have(sizeof *faces * info.triangles), n = 0, i, cut = 0, fill = 0, model_faces = 0;
  uint8_t *flags = must_have(info.vertices);
  const uint32_t own = info.triangles - info.fill_triangles;
  double volume = 0, outwards = 0;
  CHECK(info.open_rims == 0 && info.closed_rims >= before.open_rims && info.components == 1);
  CHECK(info.fill_triangles > 0 && own + info.trimmed == before.triangles && before.trimmed == 0);
  CHECK_NEAR(info.area - info.fill_area, before.area, (info.trimmed ? 0.03 : 1e-9) * before.area);
  CHECK_STATUS(ts_mesh_get_positions(part, xyz, info.vertices, &n), TS_OK);
  CHECK(n == info.vertices);
  CHECK_STATUS(ts_mesh_get_normals(part, normals, info.vertices, &n), TS_OK);
  CHECK(n == info.vertices);
  CHECK_STATUS(ts_mesh_get_vertex_flags(part, flags, info.vertices, &n), TS_OK);
  CHECK(n == info.vertices);
  CHECK_STATUS(ts_mesh_get_triangles(part, triangles, info.triangles, &n), TS_OK);
  CHECK(n == info.triangles);
  CHECK_STATUS(ts_mesh_get_faces(part, faces, info.triangles, &n), TS_OK);
  CHECK(n == info.triangles);
  CHECK_STATUS(ts_model_get_triangles(s.model, NULL, 0, &model_faces), TS_OK);
  for (i = 0; i < info.vertices; ++i) {
    cut += (flags[i] & TS_VERTEX_ON_CUT) != 0;
    CHECK(flags[i] <= 7);
  }
  CHECK(cut == info.cut_vertices);
  for (i = 0; i < info.triangles; ++i) {
    const uint32_t *t = triangles + 3 * (size_t)i;
    const double *a = xyz + 3 * (size_t)t[0], *b = xyz + 3 * (size_t)t[1], *c = xyz + 3 * (size_t)t[2];
    const double *normal = normals + 3 * (size_t)t[0];
    double u[3], v[3], w[3];
    int k;
    CHECK(t[0] < info.vertices && t[1] < info.vertices && t[2] < info.vertices);
    CHECK(i < own ? faces[i] < model_faces : faces[i] == TS_NONE);
    fill += faces[i] == TS_NONE;
    for (k = 0; k < 3; ++k) {
      u[k] = a[k] - xyz[k];
      v[k] = b[k] - xyz[k];
      w[k] = c[k] - xyz[k];
    }
    volume +=
        (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0])) /
        6;
    for (k = 0; k < 3; ++k) {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
    }
    outwards += normal[0] * (u[1] * v[2] - u[2] * v[1]) + normal[1] * (u[2] * v[0] - u[0] * v[2]) +
                normal[2] * (u[0] * v[1] - u[1] * v[0]);
  }
  CHECK(fill == info.fill_triangles);
  CHECK_NEAR(volume, info.volume, 1e-6 * info.volume);
  CHECK(info.volume > 20 && info.volume < 2000);
  CHECK(outwards > info.area); /* twice the area, but for bends */
  CHECK_STATUS(ts_mesh_get_positions(part, xyz, info.vertices - 1, &n), TS_E_BUFFER_TOO_SMALL);
  free(xyz);
  free(normals);
  free(triangles);
  free(faces);
  free(flags);
  ts_mesh_destroy(part);
  ts_mesh_destroy(scans);
}

static void bad_calls_are_refused(void) {
  ts_mesh *part = NULL;
  ts_tooth_mesh_options o;
  ts_save_options save;
  ts_tooth_frame frame;
  ts_job *job = NULL;
  CHECK_STATUS(ts_tooth_mesh_options_init(&o, sizeof o), TS_OK);
  CHECK_STATUS(ts_save_options_init(&save, sizeof save), TS_OK);
  CHECK_STATUS(ts_tooth_mesh_create(s.segmentation, 4711, NULL, NULL, &part), TS_E_NOT_FOUND);
  o.closed = 2;
  CHECK_STATUS(ts_tooth_mesh_create(s.segmentation, ids[0], &o, NULL, &part), TS_E_INVALID_ARGUMENT);
  save.whole_faces = 2;
  CHECK_STATUS(ts_segmentation_save(s.segmentation, "x.ply", TS_OUTPUT_PLY, &save, NULL), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_segmentation_save(s.segmentation, "x.ply", (ts_output_format)4, NULL, NULL), TS_E_INVALID_ARGUMENT);
  frame.struct_size = sizeof frame;
  CHECK_STATUS(ts_get_tooth_frame(s.segmentation, 4711, &frame), TS_E_NOT_FOUND);
  REQUIRE_STATUS(ts_job_create(s.context, NULL, NULL, &job), TS_OK);
  ts_job_cancel(job);
  o.closed = 1;
  CHECK_STATUS(ts_tooth_mesh_create(s.segmentation, ids[0], &o, job, &part), TS_E_CANCELLED);
  CHECK_STATUS(ts_gingiva_mesh_create(s.segmentation, &o, job, &part), TS_E_CANCELLED);
  CHECK(part == NULL);
  CHECK_STATUS(ts_segmentation_save(s.segmentation, "cancelled.ply", TS_OUTPUT_PLY, NULL, job), TS_E_CANCELLED);
  CHECK(fopen("cancelled.ply", "rb") == NULL);
  ts_job_destroy(job);
}

static double dot(const double *a, const double *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void teeth_look_where_they_should(void) {
  double occlusal[3];
  uint32_t i;
  REQUIRE_STATUS(ts_features_get_occlusal(s.features, occlusal), TS_OK);
  for (i = 0; i < teeth; ++i) {
    ts_tooth_frame f, next;
    memset(&f, 0, sizeof f);
    f.struct_size = sizeof f;
    next = f;
    CHECK_STATUS(ts_get_tooth_frame(s.segmentation, ids[i], &f), TS_OK);
    CHECK(f.from_arch == 1);
    CHECK_NEAR(dot(f.occlusal, occlusal), 1, 1e-12);
    CHECK_NEAR(dot(f.mesial, f.mesial), 1, 1e-12);
    CHECK_NEAR(dot(f.buccal, f.buccal), 1, 1e-12);
    CHECK_NEAR(dot(f.mesial, f.buccal), 0, 1e-12);
    CHECK_NEAR(dot(f.mesial, f.occlusal), 0, 1e-12);
    CHECK(f.width > 4 && f.width < 14 && f.depth > 4 && f.depth < 14 && f.height > 2 && f.height < 12);
    if (i + 1 < teeth) { /* both look along the arch, to its middle */
      double to[3];
      int k;
      CHECK_STATUS(ts_get_tooth_frame(s.segmentation, ids[i + 1], &next), TS_OK);
      for (k = 0; k < 3; ++k) to[k] = next.centre[k] - f.centre[k];
      if (2 * (i + 1) < teeth) CHECK(dot(to, f.mesial) > 0);
      if (2 * i > teeth) CHECK(dot(to, f.mesial) < 0);
    }
  }
}

/* ------------------------------------------------------------------------------------------------------------- files
 */

static long size_of_file(const char *path) {
  FILE *file = fopen(path, "rb");
  long size = -1;
  if (file == NULL) return -1;
  if (fseek(file, 0, SEEK_END) == 0) size = ftell(file);
  fclose(file);
  return size;
}

/* The faces and the area of a file read back; 0, 0 if it cannot be. */
static ts_intake_report read_back(const char *path) {
  ts_intake_options o;
  ts_intake_report report;
  ts_model *model = NULL;
  memset(&report, 0, sizeof report);
  report.struct_size = sizeof report;
  CHECK_STATUS(ts_intake_options_init(&o, sizeof o), TS_OK);
  o.unit = TS_UNIT_MM; /* a tooth alone is small */
  CHECK_STATUS(ts_model_load(s.context, path, &o, NULL, &model), TS_OK);
  if (model != NULL) CHECK_STATUS(ts_model_get_report(model, &report), TS_OK);
  ts_model_destroy(model);
  return report;
}

static void every_format_is_read_back(void) {
  static const struct {
    ts_output_format format;
    const char *path;
  } files[] = {{TS_OUTPUT_STL, "tooth.stl"}, {TS_OUTPUT_PLY, "tooth.ply"}, {TS_OUTPUT_OBJ, "tooth.obj"}};
  ts_mesh *part = make(ids[0], 1);
  const ts_mesh_info info = info_of(part);
  size_t i;
  for (i = 0; i < sizeof files / sizeof files[0]; ++i) {
    ts_intake_report report;
    harness_case("%s", files[i].path);
    CHECK_STATUS(ts_mesh_save(part, files[i].path, files[i].format, NULL), TS_OK);
    CHECK_STATUS(ts_mesh_save(part, files[i].path, files[i].format, NULL), TS_OK); /* over what is there */
    report = read_back(files[i].path);
    CHECK(report.faces == info.triangles && report.vertices == info.vertices);
    CHECK(report.boundary_loops == 0 && report.degenerate_faces == 0 && report.non_manifold_edges == 0);
    CHECK_NEAR(report.area, info.area, 1e-4 * info.area);
    remove(files[i].path);
  }
  harness_case(NULL);
  ts_mesh_destroy(part);
}

static unsigned long little(const unsigned char *p) {
  return p[0] | (unsigned long)p[1] << 8 | (unsigned long)p[2] << 16 | (unsigned long)p[3] << 24;
}

static void glb_holds_a_node_a_tooth(void) {
  FILE *file;
  unsigned char *raw;
  long size;
  unsigned long json;
  uint32_t i;
  char name[32];
  REQUIRE_STATUS(ts_segmentation_save(s.segmentation, "scan.glb", TS_OUTPUT_GLB, NULL, NULL), TS_OK);
  size = size_of_file("scan.glb");
  REQUIRE(size > 1000);
  raw = must_have((size_t)size + 1);
  file = fopen("scan.glb", "rb");
  REQUIRE(file != NULL);
  CHECK(fread(raw, 1, (size_t)size, file) == (size_t)size);
  fclose(file);
  raw[size] = 0;
  CHECK(memcmp(raw, "glTF", 4) == 0 && little(raw + 4) == 2 && little(raw + 8) == (unsigned long)size);
  json = little(raw + 12);
  CHECK(memcmp(raw + 16, "JSON", 4) == 0 && json % 4 == 0);
  CHECK(memcmp(raw + 20 + json + 4, "BIN\0", 4) == 0);
  CHECK(little(raw + 20 + json) + 28 + json == (unsigned long)size);
  raw[20 + json] = 0;
  CHECK(strstr((char *)raw + 20, "\"name\":\"gingiva\"") != NULL);
  for (i = 1; i <= teeth; ++i) {
    sprintf(name, "\"name\":\"tooth_%lu\"", (unsigned long)i);
    CHECK(strstr((char *)raw + 20, name) != NULL);
  }
  free(raw);
  remove("scan.glb");
}

static void the_whole_scan_is_read_back(void) {
  ts_save_options o;
  ts_intake_report report;
  uint32_t faces = 0, whole;
  CHECK_STATUS(ts_model_get_triangles(s.model, NULL, 0, &faces), TS_OK);
  CHECK_STATUS(ts_save_options_init(&o, sizeof o), TS_OK);
  for (whole = 0; whole < 2; ++whole) {
    o.whole_faces = whole;
    CHECK_STATUS(ts_segmentation_save(s.segmentation, "scan.ply", TS_OUTPUT_PLY, &o, NULL), TS_OK);
    report = read_back("scan.ply");
    CHECK(whole ? report.faces == faces : report.faces > faces);
    CHECK_NEAR(report.area / model_area, 1, 1e-5);
    CHECK_STATUS(ts_segmentation_save(s.segmentation, "scan.obj", TS_OUTPUT_OBJ, &o, NULL), TS_OK);
    CHECK(read_back("scan.obj").faces == report.faces);
  }
  remove("scan.ply");
  remove("scan.obj");
}

static void places_that_cannot_be_written(void) {
  ts_mesh *part = make(ids[0], 0);
  CHECK_STATUS(ts_mesh_save(part, "none/such/tooth.stl", TS_OUTPUT_STL, NULL), TS_E_FILE_WRITE);
  CHECK(strstr(ts_last_error_message(), "none/such/tooth.stl") != NULL);
  CHECK_STATUS(ts_mesh_save(part, "", TS_OUTPUT_STL, NULL), TS_E_FILE_WRITE);
  CHECK_STATUS(ts_mesh_save(part, ".", TS_OUTPUT_STL, NULL), TS_E_FILE_WRITE);
#if !defined(_WIN32)
  if (size_of_file("/dev/full") >= 0) {
    CHECK_STATUS(ts_mesh_save(part, "/dev/full", TS_OUTPUT_STL, NULL), TS_E_FILE_WRITE);
    CHECK(strstr(ts_last_error_message(), "not a regular file") != NULL);
  }
  if (geteuid() != 0) { /* root may write anywhere */
    CHECK(mkdir("readonly", 0555) == 0);
    CHECK_STATUS(ts_mesh_save(part, "readonly/tooth.stl", TS_OUTPUT_STL, NULL), TS_E_FILE_WRITE);
    rmdir("readonly");
  }
#endif
  ts_mesh_destroy(part);
}

#if !defined(_WIN32)
static void old_file(const char *path) {
  FILE *file = fopen(path, "wb");
  if (!CHECK(file != NULL)) return;
  fputs("old", file);
  fclose(file);
}
#endif

/* A limit on the size of files stands in for the full disk. */
static void a_disk_that_fills_up(void) {
#if !defined(_WIN32)
  static const ts_output_format formats[] = {TS_OUTPUT_STL, TS_OUTPUT_PLY, TS_OUTPUT_OBJ, TS_OUTPUT_GLB};
  struct rlimit before, limit;
  size_t i;
  mkdir("full", 0755);
  old_file("full/scan");
  signal(SIGXFSZ, SIG_IGN);
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  limit = before;
  limit.rlim_cur = 20000;
  for (i = 0; i < sizeof formats / sizeof formats[0]; ++i) {
    ts_status status;
    REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
    status = ts_segmentation_save(s.segmentation, "full/scan", formats[i], NULL, NULL);
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    CHECK_STATUS(status, TS_E_FILE_WRITE);
    CHECK(size_of_file("full/scan") == 3); /* the old one */
  }
  remove("full/scan");
  CHECK(rmdir("full") == 0); /* nothing is left in it */
#endif
}

int main(void) {
  if (!set_up()) return 3;
  RUN(open_parts_add_up);
  RUN(a_mesh_is_as_its_getters_say);
  RUN(bad_calls_are_refused);
  RUN(teeth_look_where_they_should);
  RUN(every_format_is_read_back);
  RUN(glb_holds_a_node_a_tooth);
  RUN(the_whole_scan_is_read_back);
  RUN(places_that_cannot_be_written);
  RUN(a_disk_that_fills_up);
  free(ids);
  free_scan(&s);
  return harness_finish();
}
