/* Files: every format read, every way to be broken told apart. SPDX-License-Identifier: Apache-2.0 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fixture.h"
#include "harness.h"

static ts_context *context;

/* ------------------------------------------------------------------------------------------------- writing files */

static void put_text(bytes *b, const char *text) {
  put_bytes(b, text, strlen(text));
}

static bytes text_file(const char *text) {
  bytes b = {NULL, 0, 0};
  put_text(&b, text);
  return b;
}

/* An unsigned number of `size` bytes, in either byte order. */
static void put_integer(bytes *b, uint32_t value, int size, int big) {
  unsigned char raw[4];
  int i;
  for (i = 0; i < size; ++i) raw[i] = (unsigned char)(value >> 8 * (big ? size - 1 - i : i));
  put_bytes(b, raw, (size_t)size);
}

static void put_real(bytes *b, double value, int big) {
  const float f = (float)value;
  uint32_t bits;
  memcpy(&bits, &f, sizeof bits);
  put_integer(b, bits, 4, big);
}

static const double *corner(const mesh *m, uint32_t face, int k) {
  return m->xyz + 3 * (size_t)m->triangles[3 * (size_t)face + (size_t)k];
}

static bytes binary_stl(const mesh *m, const char *header, uint32_t promised) {
  bytes b = {NULL, 0, 0};
  char first[80];
  uint32_t f;
  int k, c;
  memset(first, 0, sizeof first);
  strncpy(first, header, sizeof first - 1);
  put_bytes(&b, first, sizeof first);
  put_integer(&b, promised, 4, 0);
  for (f = 0; f < m->faces; ++f) {
    for (k = 0; k < 3; ++k) put_real(&b, k == 2, 0);
    for (k = 0; k < 3; ++k)
      for (c = 0; c < 3; ++c) put_real(&b, corner(m, f, k)[c], 0);
    put_integer(&b, 0, 2, 0);
  }
  return b;
}

static bytes ascii_stl(const mesh *m) {
  bytes b = text_file("solid plane\n");
  char line[256];
  uint32_t f;
  int k;
  for (f = 0; f < m->faces; ++f) {
    put_text(&b, "facet normal 0 0 1\nouter loop\n");
    for (k = 0; k < 3; ++k) {
      const double *p = corner(m, f, k);
      snprintf(line, sizeof line, "vertex %.9g %.9g %.9g\n", p[0], p[1], p[2]);
      put_text(&b, line);
    }
    put_text(&b, "endloop\nendfacet\n");
  }
  put_text(&b, "endsolid plane\n");
  return b;
}

static bytes ply(const mesh *m, const char *coding, uint32_t vertices, uint32_t faces) {
  const int big = strcmp(coding, "binary_big_endian") == 0, ascii = strcmp(coding, "ascii") == 0;
  bytes b = {NULL, 0, 0};
  char text[512];
  uint32_t i;
  int k;
  snprintf(
      text, sizeof text,
      "ply\nformat %s 1.0\ncomment a plane\nelement vertex %lu\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face %lu\nproperty list uchar int vertex_indices\nend_header\n",
      coding, (unsigned long)vertices, (unsigned long)faces);
  put_text(&b, text);
  for (i = 0; i < m->vertices; ++i) {
    const double *p = m->xyz + 3 * (size_t)i;
    if (ascii) {
      snprintf(text, sizeof text, "%.9g %.9g %.9g 7\n", p[0], p[1], p[2]);
      put_text(&b, text);
      continue;
    }
    for (k = 0; k < 3; ++k) put_real(&b, p[k], big);
    put_integer(&b, 7, 1, big);
  }
  for (i = 0; i < m->faces; ++i) {
    const uint32_t *t = m->triangles + 3 * (size_t)i;
    if (ascii) {
      snprintf(text, sizeof text, "3 %lu %lu %lu\n", (unsigned long)t[0], (unsigned long)t[1], (unsigned long)t[2]);
      put_text(&b, text);
      continue;
    }
    put_integer(&b, 3, 1, big);
    for (k = 0; k < 3; ++k) put_integer(&b, t[k], 4, big);
  }
  return b;
}

/* The lines that OBJ and OFF share. */
static void put_vertices(bytes *b, const mesh *m, const char *before) {
  char line[256];
  uint32_t i;
  for (i = 0; i < m->vertices; ++i) {
    const double *p = m->xyz + 3 * (size_t)i;
    snprintf(line, sizeof line, "%s%.9g %.9g %.9g\n", before, p[0], p[1], p[2]);
    put_text(b, line);
  }
}

static bytes obj(const mesh *m, int relative) {
  bytes b = text_file("# a plane\no plane\n");
  char line[256];
  uint32_t i;
  put_vertices(&b, m, "v ");
  for (i = 0; i < m->faces; ++i) {
    const uint32_t *t = m->triangles + 3 * (size_t)i;
    const long n = relative ? -(long)m->vertices : 1;
    snprintf(line, sizeof line, relative ? "f %ld %ld %ld\n" : "f %ld/1 %ld//1 %ld/1/1\n", (long)t[0] + n,
             (long)t[1] + n, (long)t[2] + n);
    put_text(&b, line);
  }
  return b;
}

static bytes off(const mesh *m) {
  bytes b = text_file("OFF\n");
  char line[256];
  uint32_t i;
  snprintf(line, sizeof line, "%lu %lu 0\n", (unsigned long)m->vertices, (unsigned long)m->faces);
  put_text(&b, line);
  put_vertices(&b, m, "");
  for (i = 0; i < m->faces; ++i) {
    const uint32_t *t = m->triangles + 3 * (size_t)i;
    snprintf(line, sizeof line, "3 %lu %lu %lu\n", (unsigned long)t[0], (unsigned long)t[1], (unsigned long)t[2]);
    put_text(&b, line);
  }
  return b;
}

/* --------------------------------------------------------------------------------------------------------- reading */

static const char *const path = "test_files_scratch.bin";

static int write_file(const bytes *b) {
  FILE *file = fopen(path, "wb");
  size_t written;
  if (file == NULL) return 0;
  written = b->size ? fwrite(b->data, 1, b->size, file) : 0;
  return fclose(file) == 0 && written == b->size;
}

/* From memory and from a file: the same. Frees the bytes. */
static void expect(const char *name, bytes b, ts_file_format format, ts_status expected) {
  char mark;
  ts_model *const sentinel = (ts_model *)(void *)&mark;
  ts_model *model = sentinel;
  ts_status status;
  harness_case("%s", name);
  status = ts_model_read(context, b.data, b.size, format, NULL, NULL, &model);
  CHECK_STATUS(status, expected);
  CHECK((status == TS_OK) == (model != sentinel));
  if (status == TS_OK) ts_model_destroy(model);
  model = sentinel;
  if (format == TS_FORMAT_AUTO && CHECK(write_file(&b))) {
    status = ts_model_load(context, path, NULL, NULL, &model);
    CHECK_STATUS(status, expected);
    CHECK((status == TS_OK) == (model != sentinel));
    if (status != TS_OK) CHECK(strchr(ts_last_error_message(), '\n') == NULL);
    if (status == TS_OK) ts_model_destroy(model);
    remove(path);
  }
  free_bytes(&b);
}

static void expect_plane(const char *name, bytes b, ts_file_format format) {
  ts_model *model = NULL;
  ts_intake_report r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  harness_case("%s", name);
  if (CHECK_STATUS(ts_model_read(context, b.data, b.size, format, NULL, NULL, &model), TS_OK)) {
    CHECK_STATUS(ts_model_get_report(model, &r), TS_OK);
    CHECK(r.vertices == 81 && r.faces == 128 && r.components == 1 && r.boundary_loops == 1);
    CHECK_NEAR(r.area, 256, 1e-9);
    ts_model_destroy(model);
  }
  expect(name, b, TS_FORMAT_AUTO, TS_OK);
}

static bytes cut(bytes b, size_t to) {
  if (to < b.size) b.size = to;
  return b;
}

static bytes with(bytes b, const char *text) {
  put_text(&b, text);
  return b;
}

/* Replaces the first `from` by `to`. */
static bytes changed(bytes b, const char *from, const char *to) {
  const size_t n = strlen(from);
  size_t i;
  bytes out = {NULL, 0, 0};
  for (i = 0; i + n <= b.size && memcmp(b.data + i, from, n) != 0; ++i) {
  }
  if (!CHECK(i + n <= b.size)) return b;
  put_bytes(&out, b.data, i);
  put_text(&out, to);
  put_bytes(&out, b.data + i + n, b.size - i - n);
  free_bytes(&b);
  return out;
}

static mesh plane;

static void every_format_gives_the_same_model(void) {
  expect_plane("binary STL", binary_stl(&plane, "exported", plane.faces), TS_FORMAT_STL);
  expect_plane("binary STL that begins with solid", binary_stl(&plane, "solid exported", plane.faces), TS_FORMAT_STL);
  expect_plane("ASCII STL", ascii_stl(&plane), TS_FORMAT_STL);
  expect_plane("ASCII PLY", ply(&plane, "ascii", 81, 128), TS_FORMAT_PLY);
  expect_plane("little PLY", ply(&plane, "binary_little_endian", 81, 128), TS_FORMAT_PLY);
  expect_plane("big PLY", ply(&plane, "binary_big_endian", 81, 128), TS_FORMAT_PLY);
  expect_plane("OBJ", obj(&plane, 0), TS_FORMAT_OBJ);
  expect_plane("OBJ counted backwards", obj(&plane, 1), TS_FORMAT_OBJ);
  expect_plane("OFF", off(&plane), TS_FORMAT_OFF);
}

static void not_a_mesh_at_all(void) {
  static const unsigned char png[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  bytes b = {NULL, 0, 0};
  ts_model *model = NULL;
  expect("empty", b, TS_FORMAT_AUTO, TS_E_FILE_FORMAT);
  expect("prose", text_file("These are words, and no mesh.\n"), TS_FORMAT_AUTO, TS_E_FILE_FORMAT);
  put_bytes(&b, png, sizeof png);
  expect("a picture", b, TS_FORMAT_AUTO, TS_E_FILE_FORMAT);
  expect("binary OFF", text_file("OFF BINARY\n12345678901234567890"), TS_FORMAT_AUTO, TS_E_FILE_FORMAT);
  expect("4OFF", text_file("4OFF\n1 0 0\n0 0 0 1\n"), TS_FORMAT_AUTO, TS_E_FILE_FORMAT);
  harness_case("no such format");
  CHECK_STATUS(ts_model_read(context, "OFF", 3, (ts_file_format)5, NULL, NULL, &model), TS_E_INVALID_ARGUMENT);
  harness_case("no such file");
  CHECK_STATUS(ts_model_load(context, "no/such/file.stl", NULL, NULL, &model), TS_E_FILE_OPEN);
  harness_case("a directory");
  CHECK_STATUS(ts_model_load(context, ".", NULL, NULL, &model), TS_E_FILE_OPEN);
  harness_case("an empty name");
  CHECK_STATUS(ts_model_load(context, "", NULL, NULL, &model), TS_E_FILE_OPEN);
  CHECK(model == NULL);
}

static void stl(void) {
  expect("cut in a record", cut(binary_stl(&plane, "x", plane.faces), 84 + 50 * 60 + 7), TS_FORMAT_AUTO,
         TS_E_FILE_TRUNCATED);
  expect("cut between records", cut(binary_stl(&plane, "x", plane.faces), 84 + 50 * 60), TS_FORMAT_AUTO,
         TS_E_FILE_TRUNCATED);
  expect("cut in the header", cut(binary_stl(&plane, "x", plane.faces), 60), TS_FORMAT_STL, TS_E_FILE_TRUNCATED);
  expect("trailing", with(binary_stl(&plane, "x", plane.faces), "and so on"), TS_FORMAT_AUTO, TS_E_FILE_TRAILING);
  expect("a count of 2 billion", binary_stl(&plane, "x", 2000000000), TS_FORMAT_AUTO, TS_E_FILE_COUNT);
  expect("a count of 2^32 - 1", binary_stl(&plane, "x", UINT32_MAX), TS_FORMAT_AUTO, TS_E_FILE_COUNT);
  expect("a count of 0", cut(binary_stl(&plane, "x", 0), 84), TS_FORMAT_AUTO, TS_E_MESH_EMPTY);
  expect("text: a word for a number", changed(ascii_stl(&plane), "vertex 0 ", "vertex zero "), TS_FORMAT_AUTO,
         TS_E_FILE_SYNTAX);
  expect("text: a wrong keyword", changed(ascii_stl(&plane), "endloop", "endlop"), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("text: two corners", changed(ascii_stl(&plane), "vertex 0 0 0\n", ""), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("text: no end", changed(ascii_stl(&plane), "endsolid plane\n", ""), TS_FORMAT_AUTO, TS_E_FILE_TRUNCATED);
  expect("text: cut in a facet", cut(ascii_stl(&plane), 300), TS_FORMAT_AUTO, TS_E_FILE_TRUNCATED);
  expect("text: not a number", changed(ascii_stl(&plane), "vertex 0 0 0", "vertex nan 0 0"), TS_FORMAT_AUTO,
         TS_E_MESH_NON_FINITE);
  expect("text: no facet", text_file("solid nothing\nendsolid nothing\n"), TS_FORMAT_AUTO, TS_E_MESH_EMPTY);
}

static void syntax_errors_name_the_line(void) {
  bytes b = changed(ascii_stl(&plane), "vertex 0 0 0", "vertex 0 O 0"); /* in line 4: the letter, not the number */
  ts_model *model = NULL;
  CHECK_STATUS(ts_model_read(context, b.data, b.size, TS_FORMAT_STL, NULL, NULL, &model), TS_E_FILE_SYNTAX);
  CHECK(strstr(ts_last_error_message(), "line 4") != NULL);
  free_bytes(&b);
}

static void ply_files(void) {
  static const char *const codings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  size_t i;
  for (i = 0; i < 3; ++i) {
    char name[64];
    const bytes whole = ply(&plane, codings[i], 81, 128);
    const size_t size = whole.size;
    bytes keep = whole;
    free_bytes(&keep);
#define NAMED(what) (snprintf(name, sizeof name, "%s: %s", codings[i], what), name)
    /* "ply", "format ... 1.0": cut behind a line, since half a word may be a wrong one. */
    expect(NAMED("cut in the header"), cut(ply(&plane, codings[i], 81, 128), 4 + 12 + strlen(codings[i])),
           TS_FORMAT_AUTO, TS_E_FILE_TRUNCATED);
    expect(NAMED("cut at the end"), cut(ply(&plane, codings[i], 81, 128), size - 6), TS_FORMAT_AUTO,
           TS_E_FILE_TRUNCATED);
    expect(NAMED("trailing"), with(ply(&plane, codings[i], 81, 128), "and so on"), TS_FORMAT_AUTO, TS_E_FILE_TRAILING);
    expect(NAMED("4 billion vertices"), ply(&plane, codings[i], UINT32_MAX, 128), TS_FORMAT_AUTO, TS_E_FILE_COUNT);
    expect(NAMED("2 billion faces"), ply(&plane, codings[i], 81, 2000000000), TS_FORMAT_AUTO, TS_E_FILE_COUNT);
    expect(NAMED("no z"), changed(ply(&plane, codings[i], 81, 128), "property float z", "property float q"),
           TS_FORMAT_AUTO, TS_E_FILE_FORMAT);
    expect(NAMED("an unknown type"), changed(ply(&plane, codings[i], 81, 128), "property float x", "property real x"),
           TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
    expect(NAMED("no faces"), changed(ply(&plane, codings[i], 81, 128), "element face", "element edge"), TS_FORMAT_AUTO,
           TS_E_MESH_EMPTY);
#undef NAMED
  }
  expect("an unknown coding", ply(&plane, "binary_middle_endian", 81, 128), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("a word for a number", changed(ply(&plane, "ascii", 81, 128), "\n0 0 0 7\n", "\n0 zero 0 7\n"), TS_FORMAT_AUTO,
         TS_E_FILE_SYNTAX);
  expect("an index too large", changed(ply(&plane, "ascii", 81, 128), "\n3 0 1 10\n", "\n3 0 1 81\n"), TS_FORMAT_AUTO,
         TS_E_MESH_INDEX_RANGE);
  expect("a negative index", changed(ply(&plane, "ascii", 81, 128), "\n3 0 1 10\n", "\n3 0 1 -1\n"), TS_FORMAT_AUTO,
         TS_E_MESH_INDEX_RANGE);
}

static void obj_files(void) {
  bytes b;
  expect("a word for a number", changed(obj(&plane, 0), "v 0 0 0", "v 0 zero 0"), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("two coordinates", changed(obj(&plane, 0), "v 0 0 0", "v 0 0"), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("a face of two corners", with(obj(&plane, 0), "f 1 2\n"), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("an index too large", with(obj(&plane, 0), "f 1 2 82\n"), TS_FORMAT_AUTO, TS_E_MESH_INDEX_RANGE);
  expect("an index of 0", with(obj(&plane, 0), "f 1 2 0\n"), TS_FORMAT_AUTO, TS_E_MESH_INDEX_RANGE);
  expect("an index too far back", with(obj(&plane, 0), "f 1 2 -82\n"), TS_FORMAT_AUTO, TS_E_MESH_INDEX_RANGE);
  b = text_file("# only vertices\n");
  put_vertices(&b, &plane, "v ");
  expect("no faces", b, TS_FORMAT_AUTO, TS_E_MESH_EMPTY);
  b = obj(&plane, 0);
  expect("cut in a vertex", cut(b, 40), TS_FORMAT_AUTO, TS_E_FILE_TRUNCATED);
}

static void off_files(void) {
  const bytes whole = off(&plane);
  const size_t size = whole.size;
  bytes keep = whole;
  free_bytes(&keep);
  expect("cut at the end", cut(off(&plane), size - 5), TS_FORMAT_AUTO, TS_E_FILE_TRUNCATED);
  expect("cut in the vertices", cut(off(&plane), 200), TS_FORMAT_AUTO, TS_E_FILE_TRUNCATED);
  expect("trailing", with(off(&plane), "3 0 1 2\n"), TS_FORMAT_AUTO, TS_E_FILE_TRAILING);
  expect("2 billion vertices", changed(off(&plane), "81 128", "2000000000 128"), TS_FORMAT_AUTO, TS_E_FILE_COUNT);
  expect("minus one vertices", changed(off(&plane), "81 128", "-1 128"), TS_FORMAT_AUTO, TS_E_FILE_COUNT);
  expect("a word for a number", changed(off(&plane), "\n0 0 0\n", "\n0 zero 0\n"), TS_FORMAT_AUTO, TS_E_FILE_SYNTAX);
  expect("an index too large", changed(off(&plane), "\n3 0 1 10\n", "\n3 0 1 81\n"), TS_FORMAT_AUTO,
         TS_E_MESH_INDEX_RANGE);
}

/* Whatever is cut off anywhere or whichever byte is wrong: a status, and no crash. A coordinate may change unseen. */
static void any_damage_is_a_status(void) {
  size_t kind, i;
  for (kind = 0; kind < 6; ++kind) {
    mesh small = make_plane(16, 3);
    bytes b = kind == 0   ? binary_stl(&small, "x", small.faces)
              : kind == 1 ? ascii_stl(&small)
              : kind == 2 ? ply(&small, "ascii", small.vertices, small.faces)
              : kind == 3 ? ply(&small, "binary_little_endian", small.vertices, small.faces)
              : kind == 4 ? obj(&small, 0)
                          : off(&small);
    unsigned long crashed = 0;
    for (i = 0; i < b.size; ++i) {
      const unsigned char kept = b.data[i];
      ts_model *model = NULL;
      ts_status status = ts_model_read(context, b.data, i, TS_FORMAT_AUTO, NULL, NULL, &model);
      crashed += (status == TS_OK) != (model != NULL) || status == TS_E_INTERNAL;
      ts_model_destroy(model);
      model = NULL;
      b.data[i] = (unsigned char)(kept ^ (1u << i % 8));
      status = ts_model_read(context, b.data, b.size, TS_FORMAT_AUTO, NULL, NULL, &model);
      crashed += (status == TS_OK) != (model != NULL) || status == TS_E_INTERNAL;
      ts_model_destroy(model);
      b.data[i] = kept;
    }
    harness_case("kind %d", (int)kind);
    CHECK(crashed == 0);
    free_bytes(&b);
    free_mesh(&small);
  }
}

int main(void) {
  context = make_context(1);
  plane = make_plane(16, 8);
  RUN(every_format_gives_the_same_model);
  RUN(not_a_mesh_at_all);
  RUN(stl);
  RUN(syntax_errors_name_the_line);
  RUN(ply_files);
  RUN(obj_files);
  RUN(off_files);
  RUN(any_damage_is_a_status);
  free_mesh(&plane);
  ts_context_destroy(context);
  return harness_finish();
}
