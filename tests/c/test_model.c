/* Models from the caller's arrays: what is refused, what is repaired, what is found on the surface.
 * SPDX-License-Identifier: Apache-2.0 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static ts_context *context;
static char mark;
static ts_model *const sentinel = (ts_model *)(void *)&mark;

static void refuse(const ts_mesh_input *input, ts_status expected) {
  ts_model *out = sentinel;
  CHECK_STATUS(ts_model_create(context, input, NULL, NULL, &out), expected);
  CHECK(out == sentinel);
}

static ts_intake_report report_of(const ts_model *model) {
  ts_intake_report r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  CHECK_STATUS(ts_model_get_report(model, &r), TS_OK);
  return r;
}

/* -------------------------------------------------------------------------------------------------------- refused */

static void bad_arrays_are_refused(void) {
  static const double line[] = {0, 0, 0, 20, 0, 0, 40, 0, 0};
  mesh plane = make_plane(20, 10);
  ts_mesh_input input = input_of(&plane);
  uint32_t kept;
  double value;

  harness_case("index out of range");
  kept = plane.triangles[7];
  plane.triangles[7] = plane.vertices;
  refuse(&input, TS_E_MESH_INDEX_RANGE);
  plane.triangles[7] = TS_NONE;
  refuse(&input, TS_E_MESH_INDEX_RANGE);
  plane.triangles[7] = kept;

  harness_case("not finite");
  value = plane.xyz[31];
  plane.xyz[31] = (double)NAN;
  refuse(&input, TS_E_MESH_NON_FINITE);
  plane.xyz[31] = (double)INFINITY;
  refuse(&input, TS_E_MESH_NON_FINITE);
  plane.xyz[31] = -(double)INFINITY;
  refuse(&input, TS_E_MESH_NON_FINITE);
  plane.xyz[31] = value;

  harness_case("no faces");
  input.triangle_count = 0;
  refuse(&input, TS_E_MESH_EMPTY);
  input = input_of(&plane);
  harness_case("no vertices");
  input.vertex_count = 0;
  refuse(&input, TS_E_MESH_EMPTY);

  harness_case("scalar");
  input = input_of(&plane);
  CHECK(input.scalar == TS_FLOAT64); /* as initialised */
  input.scalar = (ts_scalar)2;
  refuse(&input, TS_E_INVALID_ARGUMENT);
  harness_case("stride too small");
  input = input_of(&plane);
  input.stride = 16;
  refuse(&input, TS_E_INVALID_ARGUMENT);

  harness_case("soup of vertices that do not make triangles");
  input = input_of(&plane);
  input.triangles = NULL;
  input.vertex_count = 100;
  input.triangle_count = 0;
  refuse(&input, TS_E_INVALID_ARGUMENT);
  harness_case("soup whose count is wrong");
  input.vertex_count = 99;
  input.triangle_count = 34;
  refuse(&input, TS_E_INVALID_ARGUMENT);

  harness_case("all faces degenerate");
  input = input_of(&plane);
  input.positions = line;
  input.vertex_count = 3;
  {
    static const uint32_t flat[] = {0, 1, 2, 0, 2, 2};
    input.triangles = flat;
    input.triangle_count = 2;
  }
  refuse(&input, TS_E_MESH_EMPTY);
  free_mesh(&plane);
}

static void too_large_is_refused(void) {
  mesh plane = make_plane(20, 10);
  const ts_mesh_input input = input_of(&plane);
  plane.xyz[0] = 1e12;
  refuse(&input, TS_E_MESH_TOO_LARGE);
  free_mesh(&plane);
}

/* ---------------------------------------------------------------------------------------------------------- units */

static void units(void) {
  /* An object 60 mm wide in each unit, and whether its size is taken for mm. */
  static const struct {
    ts_unit unit;
    double scale;
    int plausible_as_mm;
  } cases[] = {{TS_UNIT_MM, 1, 1}, {TS_UNIT_CM, 10, 0}, {TS_UNIT_M, 1000, 0}, {TS_UNIT_INCH, 25.4, 0}};
  size_t i;
  for (i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
    mesh plane = make_plane(60 / cases[i].scale, 12);
    const ts_mesh_input input = input_of(&plane);
    ts_intake_options options;
    ts_model *model = NULL;
    harness_case("1 / %g", cases[i].scale);
    REQUIRE_STATUS(ts_intake_options_init(&options, sizeof options), TS_OK);
    CHECK(options.unit == TS_UNIT_CHECKED_MM && options.weld_tolerance == 0);
    if (cases[i].plausible_as_mm) {
      CHECK_STATUS(ts_model_create(context, &input, &options, NULL, &model), TS_OK);
      ts_model_destroy(model);
    } else {
      refuse(&input, TS_E_MESH_UNITS);
      CHECK(strstr(ts_last_error_message(), "mm") != NULL);
    }
    options.unit = cases[i].unit;
    model = NULL;
    REQUIRE_STATUS(ts_model_create(context, &input, &options, NULL, &model), TS_OK);
    CHECK_NEAR(report_of(model).diagonal, 60 * sqrt(2.0), 1e-9);
    CHECK_NEAR(report_of(model).area, 3600, 1e-6);
    ts_model_destroy(model);
    free_mesh(&plane);
  }
  {
    mesh plane = make_plane(1e4, 12);
    const ts_mesh_input input = input_of(&plane);
    ts_intake_options options;
    ts_model *model = sentinel;
    harness_case("options");
    refuse(&input, TS_E_MESH_UNITS);
    REQUIRE_STATUS(ts_intake_options_init(&options, sizeof options), TS_OK);
    options.unit = (ts_unit)5;
    CHECK_STATUS(ts_model_create(context, &input, &options, NULL, &model), TS_E_INVALID_ARGUMENT);
    options.unit = TS_UNIT_MM;
    options.weld_tolerance = -1;
    CHECK_STATUS(ts_model_create(context, &input, &options, NULL, &model), TS_E_INVALID_ARGUMENT);
    options.weld_tolerance = (double)NAN;
    CHECK_STATUS(ts_model_create(context, &input, &options, NULL, &model), TS_E_INVALID_ARGUMENT);
    CHECK(model == sentinel);
    free_mesh(&plane);
  }
}

/* ------------------------------------------------------------------------------------------------------ repaired */

/* One mesh given as indices, as a soup, in floats, and with a stride: the same model. */
static void ways_to_give_a_mesh(void) {
  const double side = 16; /* cells of 2: floats hold the coordinates exactly */
  mesh plane = make_plane(side, 8);
  ts_mesh_input input = input_of(&plane);
  ts_model *indexed = make_model(context, &plane), *other = NULL;
  const ts_intake_report r = report_of(indexed);
  float *floats = must_have(sizeof *floats * 5 * plane.vertices);
  double *soup = must_have(sizeof *soup * 9 * plane.faces);
  uint32_t i, k;
  CHECK(r.input_vertices == 81 && r.input_faces == 128 && r.vertices == 81 && r.faces == 128);
  CHECK(r.components == 1 && r.boundary_loops == 1 && r.polygons == 0 && r.welded_vertices == 0);
  CHECK_NEAR(r.area, side * side, 1e-9);

  for (i = 0; i < plane.vertices; ++i)
    for (k = 0; k < 5; ++k) floats[5 * i + k] = k < 3 ? (float)plane.xyz[3 * i + k] : -1e30f;
  harness_case("floats with a stride");
  input.scalar = TS_FLOAT32;
  input.positions = floats;
  input.stride = 5 * sizeof *floats;
  REQUIRE_STATUS(ts_model_create(context, &input, NULL, NULL, &other), TS_OK);
  CHECK(report_of(other).vertices == r.vertices && report_of(other).faces == r.faces);
  CHECK_NEAR(report_of(other).area, r.area, 1e-9);
  ts_model_destroy(other);

  harness_case("soup");
  for (i = 0; i < 3 * plane.faces; ++i)
    for (k = 0; k < 3; ++k) soup[3 * (size_t)i + k] = plane.xyz[3 * (size_t)plane.triangles[i] + k];
  input = input_of(&plane);
  input.positions = soup;
  input.triangles = NULL;
  input.vertex_count = 3 * plane.faces;
  for (i = 0; i < 2; ++i) {
    input.triangle_count = i == 0 ? 0 : plane.faces;
    other = NULL;
    REQUIRE_STATUS(ts_model_create(context, &input, NULL, NULL, &other), TS_OK);
    CHECK(report_of(other).input_vertices == 384 && report_of(other).welded_vertices == 384 - 81);
    CHECK(report_of(other).vertices == 81 && report_of(other).faces == 128);
    CHECK(report_of(other).boundary_loops == 1 && report_of(other).components == 1);
    ts_model_destroy(other);
  }
  free(soup);
  free(floats);
  ts_model_destroy(indexed);
  free_mesh(&plane);
}

/* The library copies: the caller's arrays may go as soon as the call returns. */
static void arrays_are_copied(void) {
  mesh plane = make_plane(16, 8);
  ts_model *model = make_model(context, &plane);
  double xyz[3 * 81];
  uint32_t n = 0;
  memset(plane.xyz, 0xff, sizeof *plane.xyz * 3 * plane.vertices);
  memset(plane.triangles, 0xff, sizeof *plane.triangles * 3 * plane.faces);
  CHECK_STATUS(ts_model_get_positions(model, xyz, 81, &n), TS_OK);
  CHECK(n == 81 && xyz[3] >= 0 && xyz[3] <= 16);
  ts_model_destroy(model);
  free_mesh(&plane);
}

static void defects_are_counted(void) {
  /* A square of two triangles; its second triangle the wrong way round, one face doubled, one without area, one that
   * names a vertex twice, a vertex that no face uses, a third wing on the diagonal, and a triangle of its own. */
  static const double xyz[] = {0,  0,  0, 20, 0, 0, 20, 20, 0, 0,  20, 0, 9,  9, 9,
                               10, 10, 8, 50, 0, 0, 60, 0,  0, 50, 10, 0, 30, 0, 0};
  static const uint32_t triangles[] = {0, 1, 2, 0, 3, 2, 1, 2, 0, 0, 1, 9, 1, 1, 2, 0, 2, 5, 6, 7, 8};
  mesh m;
  ts_model *model;
  ts_intake_report r;
  uint32_t sources[8], map[16], n = 0;
  memset(&m, 0, sizeof m);
  m.xyz = must_have(sizeof xyz);
  m.triangles = must_have(sizeof triangles);
  memcpy(m.xyz, xyz, sizeof xyz);
  memcpy(m.triangles, triangles, sizeof triangles);
  m.vertices = 10;
  m.faces = 7;
  model = make_model(context, &m);
  r = report_of(model);
  CHECK(r.input_faces == 7 && r.input_vertices == 10);
  CHECK(r.duplicate_faces == 1);
  CHECK(r.degenerate_faces == 2);
  CHECK(r.unreferenced_vertices == 2); /* 4, and 9, which only a dropped face uses */
  CHECK(r.non_manifold_edges == 1);
  CHECK(r.faces == 4);
  REQUIRE_STATUS(ts_model_get_face_sources(model, sources, 8, &n), TS_OK);
  CHECK(n == 4 && sources[0] == 0 && sources[1] == 1 && sources[2] == 5 && sources[3] == 6);
  REQUIRE_STATUS(ts_model_get_vertex_map(model, map, 16, &n), TS_OK);
  CHECK(n == 10 && map[4] == TS_NONE && map[9] == TS_NONE && map[0] != TS_NONE);
  ts_model_destroy(model);
  free_mesh(&m);
}

/* Vertices, faces and maps say the same as the caller's mesh did. */
static void model_is_the_callers_mesh(void) {
  mesh arch = make_arch(10000);
  ts_model *model = make_model(context, &arch);
  const ts_intake_report r = report_of(model);
  double *xyz = must_have(sizeof *xyz * 3 * r.vertices);
  uint32_t *faces = must_have(sizeof *faces * 3 * r.faces), *source = must_have(sizeof *source * r.faces);
  uint32_t *map = must_have(sizeof *map * arch.vertices);
  uint32_t n = 0, f, k, c, wrong = 0;
  REQUIRE_STATUS(ts_model_get_positions(model, xyz, r.vertices, &n), TS_OK);
  CHECK(n == r.vertices);
  REQUIRE_STATUS(ts_model_get_triangles(model, faces, r.faces, &n), TS_OK);
  CHECK(n == r.faces);
  REQUIRE_STATUS(ts_model_get_face_sources(model, source, r.faces, &n), TS_OK);
  REQUIRE_STATUS(ts_model_get_vertex_map(model, map, arch.vertices, &n), TS_OK);
  CHECK(n == arch.vertices);
  for (f = 0; f < r.faces; ++f)
    for (k = 0; k < 3; ++k) {
      const double *p = xyz + 3 * (size_t)faces[3 * (size_t)f + k];
      int found = 0;
      for (c = 0; c < 3; ++c)
        found =
            found || memcmp(p, arch.xyz + 3 * (size_t)arch.triangles[3 * (size_t)source[f] + c], sizeof *p * 3) == 0;
      wrong += !found;
    }
  for (k = 0; k < arch.vertices; ++k)
    wrong += map[k] != TS_NONE && memcmp(xyz + 3 * (size_t)map[k], arch.xyz + 3 * (size_t)k, sizeof *xyz * 3) != 0;
  CHECK(wrong == 0);
  CHECK(r.components >= 1 && r.boundary_loops >= 1 && r.mean_edge > 0);
  free(map);
  free(source);
  free(faces);
  free(xyz);
  ts_model_destroy(model);
  free_mesh(&arch);
}

/* -------------------------------------------------------------------------------------------------------- getters */

static void buffers_too_small(void) {
  mesh plane = make_plane(16, 8);
  ts_model *model = make_model(context, &plane);
  double xyz[3 * 81];
  uint32_t index[3 * 128], n = 77;
  xyz[0] = 5;
  index[0] = 5;
  CHECK_STATUS(ts_model_get_positions(model, xyz, 80, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK_STATUS(ts_model_get_triangles(model, index, 127, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK_STATUS(ts_model_get_face_sources(model, index, 127, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK_STATUS(ts_model_get_vertex_map(model, index, 80, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK_STATUS(ts_model_get_vertex_map(model, index, 0, &n), TS_E_BUFFER_TOO_SMALL);
  CHECK(n == 77 && xyz[0] == 5 && index[0] == 5);
  CHECK_STATUS(ts_model_get_positions(model, NULL, 0, &n), TS_OK);
  CHECK(n == 81);
  CHECK_STATUS(ts_model_get_triangles(model, NULL, 0, &n), TS_OK);
  CHECK(n == 128);
  CHECK_STATUS(ts_model_get_positions(model, xyz, 81, &n), TS_OK);
  ts_model_destroy(model);
  free_mesh(&plane);
}

/* -------------------------------------------------------------------------------------------------------- surface */

static void nearest_and_raycast_on_a_sphere(void) {
  mesh sphere = make_sphere(20, 40);
  ts_model *model = make_model(context, &sphere);
  static const double outside[3] = {0, 0, 30}, through[3] = {0.1, 0.2, -1}, sideways[3] = {1, 0, 0};
  static const double inside[3] = {1, 2, 3}, zero[3] = {0, 0, 0};
  double bad[3] = {0, 0, 0};
  ts_surface_point p;
  REQUIRE_STATUS(ts_model_nearest(model, outside, &p), TS_OK);
  CHECK_NEAR(p.distance, 10, 1e-9);
  CHECK_NEAR(p.position[2], 20, 1e-9);
  CHECK_NEAR(p.barycentric[0] + p.barycentric[1] + p.barycentric[2], 1, 1e-12);
  REQUIRE_STATUS(ts_model_raycast(model, outside, through, &p), TS_OK);
  {
    /* |30 ez + t d| = 20 for the direction d of length 1; the facets lie up to 0.1 inside the sphere. */
    const double length = sqrt(0.05 + 1), b = -30 / length;
    CHECK_NEAR(p.distance, -b - sqrt(b * b - 500), 0.1);
    CHECK_NEAR(sqrt(p.position[0] * p.position[0] + p.position[1] * p.position[1] + p.position[2] * p.position[2]), 20,
               0.1);
  }
  REQUIRE_STATUS(ts_model_raycast(model, inside, sideways, &p), TS_OK); /* the back of a face counts */
  p.distance = 5;
  CHECK_STATUS(ts_model_raycast(model, outside, sideways, &p), TS_E_NOT_FOUND);
  CHECK_STATUS(ts_model_raycast(model, outside, zero, &p), TS_E_INVALID_ARGUMENT);
  bad[1] = (double)NAN;
  CHECK_STATUS(ts_model_nearest(model, bad, &p), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_model_raycast(model, bad, sideways, &p), TS_E_INVALID_ARGUMENT);
  CHECK_STATUS(ts_model_raycast(model, outside, bad, &p), TS_E_INVALID_ARGUMENT);
  CHECK(p.distance == 5);
  ts_model_destroy(model);
  free_mesh(&sphere);
}

int main(void) {
  context = make_context(1);
  RUN(bad_arrays_are_refused);
  RUN(too_large_is_refused);
  RUN(units);
  RUN(ways_to_give_a_mesh);
  RUN(arrays_are_copied);
  RUN(defects_are_counted);
  RUN(model_is_the_callers_mesh);
  RUN(buffers_too_small);
  RUN(nearest_and_raycast_on_a_sphere);
  ts_context_destroy(context);
  return harness_finish();
}
