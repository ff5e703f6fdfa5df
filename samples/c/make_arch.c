/* make_arch.c - writes a synthetic dental arch, with the tooth of every face if wanted.
 * SPDX-License-Identifier: Apache-2.0 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "toothseg_arch.h"
#include "utf8.h"

static const char usage[] =
    "usage: make-arch OUT.ply|OUT.stl|OUT.obj [options]\n"
    "  --labels FILE      FDI number of every face, one a line; 0 = gingiva\n"
    "  --features FILE    cusp tips and incisal corners: FDI x y z, one a line\n"
    "  --jaw upper|lower  default upper\n"
    "  --triangles N      5000 to 4000000, default 100000\n"
    "  --crowding C       none, mild, moderate, severe, or 0 to 1\n"
    "  --missing LIST     FDI numbers, such as 36,46\n"
    "  --base             close the arch with a plaster base\n"
    "  --noise X          vertex noise in mean edge lengths, 0 to 1\n"
    "  --isotropic        noise in all directions, not along the normals\n"
    "  --seed S           default 1\n";

typedef struct mesh {
  float *positions;
  uint32_t *triangles, *labels, *fdi;
  uint32_t vertices, faces, teeth;
} mesh;

static int bad(const char *what, const char *value) {
  fprintf(stderr, "make-arch: %s: %s\n", what, value);
  return 2;
}

static int read_number(const char *text, double *out) {
  char *end;
  errno = 0;
  *out = strtod(text, &end);
  return errno == 0 && end != text && *end == 0;
}

static int read_count(const char *text, uint64_t *out) {
  char *end;
  errno = 0;
  *out = strtoull(text, &end, 10);
  return errno == 0 && text[0] >= '0' && text[0] <= '9' && *end == 0;
}

static int read_crowding(const char *text, double *out) {
  static const char *names[] = {"none", "mild", "moderate", "severe"};
  static const double values[] = {0, 0.35, 0.65, 1};
  for (int i = 0; i < 4; ++i)
    if (strcmp(text, names[i]) == 0) {
      *out = values[i];
      return 1;
    }
  return read_number(text, out);
}

static int read_missing(const char *text, uint32_t *list, uint32_t capacity, uint32_t *count) {
  *count = 0;
  for (;;) {
    char *end;
    if (*text < '0' || *text > '9' || *count == capacity) return 0;
    const unsigned long value = strtoul(text, &end, 10);
    if (value > 48) return 0;
    list[(*count)++] = (uint32_t)value;
    if (*end == 0) return 1;
    if (*end != ',') return 0;
    text = end + 1;
  }
}

/* Little endian whatever the machine. */
static void put32(FILE *f, const void *value) {
  uint32_t v;
  memcpy(&v, value, 4);
  const unsigned char bytes[4] = {(unsigned char)v, (unsigned char)(v >> 8), (unsigned char)(v >> 16),
                                  (unsigned char)(v >> 24)};
  fwrite(bytes, 1, 4, f);
}

static void write_ply(FILE *f, const mesh *m) {
  fprintf(f,
          "ply\nformat binary_little_endian 1.0\ncomment toothseg synthetic arch, mm\nelement vertex %u\n"
          "property float x\nproperty float y\nproperty float z\nelement face %u\n"
          "property list uchar uint vertex_indices\nend_header\n",
          (unsigned)m->vertices, (unsigned)m->faces);
  for (size_t i = 0; i < 3 * (size_t)m->vertices; ++i) put32(f, &m->positions[i]);
  for (size_t i = 0; i < m->faces; ++i) {
    fputc(3, f);
    for (size_t k = 0; k < 3; ++k) put32(f, &m->triangles[3 * i + k]);
  }
}

static void write_stl(FILE *f, const mesh *m) {
  char header[80] = "toothseg synthetic arch, mm";
  const float zero = 0; /* readers take the normal from the corners */
  fwrite(header, 1, sizeof header, f);
  put32(f, &m->faces);
  for (size_t i = 0; i < m->faces; ++i) {
    for (int k = 0; k < 3; ++k) put32(f, &zero);
    for (size_t k = 0; k < 3; ++k)
      for (size_t c = 0; c < 3; ++c) put32(f, &m->positions[3 * (size_t)m->triangles[3 * i + k] + c]);
    fputc(0, f);
    fputc(0, f);
  }
}

static void write_obj(FILE *f, const mesh *m) {
  fprintf(f, "# toothseg synthetic arch, mm\n");
  for (size_t i = 0; i < m->vertices; ++i)
    fprintf(f, "v %.6g %.6g %.6g\n", m->positions[3 * i], m->positions[3 * i + 1], m->positions[3 * i + 2]);
  for (size_t i = 0; i < m->faces; ++i)
    fprintf(f, "f %u %u %u\n", m->triangles[3 * i] + 1, m->triangles[3 * i + 1] + 1, m->triangles[3 * i + 2] + 1);
}

typedef void (*writer)(FILE *, const mesh *);

static writer writer_for(const char *path) {
  const char *dot = strrchr(path, '.');
  if (dot && strcmp(dot, ".ply") == 0) return write_ply;
  if (dot && strcmp(dot, ".stl") == 0) return write_stl;
  if (dot && strcmp(dot, ".obj") == 0) return write_obj;
  return NULL;
}

static int close_file(FILE *f, const char *path) {
  const int wrong = ferror(f);
  if (fclose(f) != 0 || wrong) {
    fprintf(stderr, "make-arch: cannot write %s\n", path);
    return 1;
  }
  return 0;
}

static FILE *open_file(const char *path) {
  FILE *f = utf8_fopen(path, "wb");
  if (!f) fprintf(stderr, "make-arch: cannot write %s: %s\n", path, strerror(errno));
  return f;
}

static int get_mesh(const tsa_arch *arch, mesh *m) {
  if (tsa_get_positions_f32(arch, NULL, 0, &m->vertices) || tsa_get_triangles(arch, NULL, 0, &m->faces) ||
      tsa_get_teeth(arch, NULL, 0, &m->teeth))
    return 0;
  m->positions = malloc(3 * sizeof(float) * (size_t)m->vertices);
  m->triangles = malloc(3 * sizeof(uint32_t) * (size_t)m->faces);
  m->labels = malloc(sizeof(uint32_t) * (size_t)m->faces);
  m->fdi = malloc(sizeof(uint32_t) * (size_t)(m->teeth + 1));
  if (!m->positions || !m->triangles || !m->labels || !m->fdi) return 0;
  return !tsa_get_positions_f32(arch, m->positions, m->vertices, &m->vertices) &&
         !tsa_get_triangles(arch, m->triangles, m->faces, &m->faces) &&
         !tsa_get_labels(arch, m->labels, m->faces, &m->faces) && !tsa_get_teeth(arch, m->fdi, m->teeth, &m->teeth);
}

static int write_labels(const char *path, const mesh *m) {
  FILE *f = open_file(path);
  if (!f) return 1;
  for (size_t i = 0; i < m->faces; ++i) fprintf(f, "%u\n", (unsigned)(m->labels[i] ? m->fdi[m->labels[i] - 1] : 0));
  return close_file(f, path);
}

static int write_features(const char *path, const tsa_arch *arch, const mesh *m) {
  uint32_t count = 0;
  tsa_feature *features = NULL;
  FILE *f;
  if (tsa_get_features(arch, NULL, 0, &count) || !(features = malloc(sizeof *features * (size_t)(count + 1))) ||
      tsa_get_features(arch, features, count, &count)) {
    free(features);
    fprintf(stderr, "make-arch: cannot read the features\n");
    return 1;
  }
  f = open_file(path);
  if (f)
    for (uint32_t i = 0; i < count; ++i)
      fprintf(f, "%u %.6f %.6f %.6f\n", (unsigned)m->fdi[features[i].label - 1], features[i].position[0],
              features[i].position[1], features[i].position[2]);
  free(features);
  return f ? close_file(f, path) : 1;
}

static int write_all(const tsa_arch *arch, const char *out, const char *labels, const char *features) {
  mesh m = {0};
  int failed = 1;
  if (!get_mesh(arch, &m)) {
    fprintf(stderr, "make-arch: out of memory\n");
  } else {
    FILE *f = open_file(out);
    if (f) {
      writer_for(out)(f, &m);
      failed = close_file(f, out);
    }
    if (!failed && labels) failed = write_labels(labels, &m);
    if (!failed && features) failed = write_features(features, arch, &m);
    if (!failed)
      printf("%s: %u vertices, %u triangles, %u teeth\n", out, (unsigned)m.vertices, (unsigned)m.faces,
             (unsigned)m.teeth);
  }
  free(m.positions);
  free(m.triangles);
  free(m.labels);
  free(m.fdi);
  return failed;
}

int main(int argc, char **argv) {
  const char *out = NULL, *labels = NULL, *features = NULL;
  uint32_t missing[14];
  tsa_options options;
  tsa_arch *arch;
  int i, status, failed;

  if (tsa_options_init(&options, sizeof options)) return 1;
  options.missing = missing;
  for (i = 1; i < argc; ++i) {
    const char *a = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    uint64_t n;
    if (strcmp(a, "--help") == 0) {
      fputs(usage, stdout);
      return 0;
    }
    if (strcmp(a, "--base") == 0) {
      options.base = 1;
    } else if (strcmp(a, "--isotropic") == 0) {
      options.noise_kind = TSA_NOISE_ISOTROPIC;
    } else if (strncmp(a, "--", 2) != 0) {
      if (out) return bad("more than one output", a);
      out = a;
    } else {
      if (!value) return bad("unknown option, or no value after it", a);
      ++i;
      if (strcmp(a, "--labels") == 0)
        labels = value;
      else if (strcmp(a, "--features") == 0)
        features = value;
      else if (strcmp(a, "--jaw") == 0) {
        if (strcmp(value, "upper") != 0 && strcmp(value, "lower") != 0)
          return bad("--jaw: neither upper nor lower", value);
        options.jaw = value[0] == 'u' ? TSA_JAW_UPPER : TSA_JAW_LOWER;
      } else if (strcmp(a, "--triangles") == 0) {
        if (!read_count(value, &n) || n > 4000000) return bad("--triangles: not a number from 5000 to 4000000", value);
        options.triangles = (uint32_t)n;
      } else if (strcmp(a, "--crowding") == 0) {
        if (!read_crowding(value, &options.crowding))
          return bad("--crowding: not none, mild, moderate, severe or a number", value);
      } else if (strcmp(a, "--missing") == 0) {
        if (!read_missing(value, missing, 14, &options.missing_count))
          return bad("--missing: not a list of FDI numbers", value);
      } else if (strcmp(a, "--noise") == 0) {
        if (!read_number(value, &options.noise)) return bad("--noise: not a number", value);
      } else if (strcmp(a, "--seed") == 0) {
        if (!read_count(value, &options.seed)) return bad("--seed: not a number", value);
      } else {
        return bad("unknown option", a);
      }
    }
  }
  if (!out) return bad("no output file given", "try --help");
  if (!writer_for(out)) return bad("output is not .ply, .stl or .obj", out);

  status = tsa_create(&options, &arch);
  if (status) {
    fprintf(stderr, "make-arch: %s\n", tsa_last_error_message());
    return status < 200 ? 2 : 1;
  }
  failed = write_all(arch, out, labels, features);
  tsa_destroy(arch);
  return failed;
}
