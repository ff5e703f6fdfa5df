/* Labels, cuts and the coloured mesh. SPDX-License-Identifier: Apache-2.0 */
#include "writers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "complain.h"

/* -------------------------------------------------------------------------------------------------------- labels */

/* What stands for a label in the output. */
static uint32_t written_label(const run *r, uint32_t label) {
  uint32_t i;
  if (!r->options->fdi) return label;
  for (i = 0; i < r->tooth_count; ++i)
    if (r->teeth[i].label == label) return r->numbers[i].fdi;
  return 0;
}

int write_labels(const run *r, FILE *file) {
  uint32_t count = 0, i;
  uint32_t *labels;
  ts_status status = ts_get_labels(r->segmentation, NULL, 0, &count);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  labels = malloc((size_t)count * sizeof *labels + 1);
  if (labels == NULL) return complain_status(r->options->scan, TS_E_OUT_OF_MEMORY);
  status = ts_get_labels(r->segmentation, labels, count, &count);
  for (i = 0; status == TS_OK && i < count; ++i) fprintf(file, "%lu\n", (unsigned long)written_label(r, labels[i]));
  free(labels);
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}

/* ---------------------------------------------------------------------------------------------------------- cuts */

/* One closed polyline; `written` counts the vertices of the file so far, from which OBJ counts its indices. */
static ts_status write_loop(const run *r, FILE *file, uint32_t tooth, uint32_t loop, unsigned long *written) {
  uint32_t count = 0, i;
  ts_edge_point *points;
  ts_status status = ts_get_cut(r->segmentation, tooth, loop, NULL, NULL, 0, &count);
  if (status != TS_OK || count == 0) return status;
  points = malloc((size_t)count * sizeof *points);
  if (points == NULL) return TS_E_OUT_OF_MEMORY;
  status = ts_get_cut(r->segmentation, tooth, loop, NULL, points, count, &count);
  if (status == TS_OK) {
    for (i = 0; i < count; ++i)
      fprintf(file, "v %.9g %.9g %.9g\n", points[i].position[0], points[i].position[1], points[i].position[2]);
    fputc('l', file);
    for (i = 0; i < count; ++i) fprintf(file, " %lu", *written + i + 1);
    fprintf(file, " %lu\n", *written + 1);
    *written += count;
  }
  free(points);
  return status;
}

int write_cuts(const run *r, FILE *file) {
  uint32_t i, loop;
  unsigned long written = 0;
  ts_status status = TS_OK;
  fprintf(file, "# cuts by toothseg %s, mm\n", ts_version());
  for (i = 0; i < r->tooth_count; ++i) {
    const ts_tooth_info *tooth = &r->teeth[i];
    fprintf(file, "o tooth_%lu\n", (unsigned long)tooth->label);
    for (loop = 0; status == TS_OK && loop < tooth->loops; ++loop)
      status = write_loop(r, file, tooth->id, loop, &written);
  }
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}

/* ----------------------------------------------------------------------------------------------------------- ply */

static void colour_of(uint32_t label, unsigned char rgb[3]) {
  static const unsigned char gingiva[3] = {214, 160, 152};
  /* Steps of the golden ratio keep the hues of neighbours far apart. */
  const double hue = 6 * fmod(label * 0.6180339887498949, 1.0);
  int i;
  for (i = 0; i < 3; ++i) {
    const double towards = fabs(fmod(hue + 6 - 2 * i, 6.0) - 3) - 1; /* 0 to 1: how much of this channel */
    const double part = towards < 0 ? 0 : towards > 1 ? 1 : towards;
    rgb[i] = label == 0 ? gingiva[i] : (unsigned char)floor(80 + 160 * part + 0.5);
  }
}

static void put32(unsigned char *out, uint32_t value) {
  int i;
  for (i = 0; i < 4; ++i) out[i] = (unsigned char)(value >> 8 * i);
}

static void put_float(unsigned char *out, double value) {
  const float f = (float)value;
  uint32_t bits;
  memcpy(&bits, &f, sizeof bits);
  put32(out, bits);
}

/* The label of every face of the model. */
static ts_status label_faces(const run *r, uint32_t *labels, uint32_t face_count, uint32_t *scratch) {
  uint32_t i, k;
  ts_status status = TS_OK;
  memset(labels, 0, (size_t)face_count * sizeof *labels);
  for (i = 0; status == TS_OK && i < r->tooth_count; ++i) {
    uint32_t count = 0;
    status = ts_get_tooth_faces(r->segmentation, r->teeth[i].id, scratch, face_count, &count);
    for (k = 0; status == TS_OK && k < count; ++k) labels[scratch[k]] = r->teeth[i].label;
  }
  return status;
}

static void put_mesh(FILE *file, const double *xyz, uint32_t vertex_count, const uint32_t *triangles,
                     uint32_t face_count, const uint32_t *labels) {
  uint32_t i, k;
  fprintf(file,
          "ply\nformat binary_little_endian 1.0\ncomment toothseg %s, mm\n"
          "element vertex %lu\nproperty float x\nproperty float y\nproperty float z\n"
          "element face %lu\nproperty list uchar int vertex_indices\n"
          "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int label\nend_header\n",
          ts_version(), (unsigned long)vertex_count, (unsigned long)face_count);
  for (i = 0; i < vertex_count; ++i) {
    unsigned char record[12];
    for (k = 0; k < 3; ++k) put_float(record + 4 * k, xyz[3 * (size_t)i + k]);
    fwrite(record, sizeof record, 1, file);
  }
  for (i = 0; i < face_count; ++i) {
    unsigned char record[20];
    record[0] = 3;
    for (k = 0; k < 3; ++k) put32(record + 1 + 4 * k, triangles[3 * (size_t)i + k]);
    colour_of(labels[i], record + 13);
    put32(record + 16, labels[i]);
    fwrite(record, sizeof record, 1, file);
  }
}

int write_ply(const run *r, FILE *file) {
  uint32_t vertex_count = 0, face_count = 0;
  double *xyz = NULL;
  uint32_t *triangles = NULL, *labels = NULL;
  ts_status status = ts_model_get_positions(r->model, NULL, 0, &vertex_count);
  if (status == TS_OK) status = ts_model_get_triangles(r->model, NULL, 0, &face_count);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  xyz = malloc((size_t)vertex_count * 3 * sizeof *xyz + 1);
  triangles = malloc((size_t)face_count * 3 * sizeof *triangles + 1);
  labels = malloc((size_t)face_count * sizeof *labels + 1);
  status = xyz != NULL && triangles != NULL && labels != NULL ? TS_OK : TS_E_OUT_OF_MEMORY;
  if (status == TS_OK) status = label_faces(r, labels, face_count, triangles); /* triangles: free room so far */
  if (status == TS_OK) status = ts_model_get_positions(r->model, xyz, vertex_count, &vertex_count);
  if (status == TS_OK) status = ts_model_get_triangles(r->model, triangles, face_count, &face_count);
  if (status == TS_OK) put_mesh(file, xyz, vertex_count, triangles, face_count, labels);
  free(xyz);
  free(triangles);
  free(labels);
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}

int write_session(const run *r, FILE *file) {
  uint32_t size = 0;
  char *text = NULL;
  ts_status status = ts_session_write(r->segmentation, NULL, 0, &size);
  if (status == TS_OK && (text = malloc(size)) == NULL) return complain("%s: out of memory", r->options->session);
  if (status == TS_OK) status = ts_session_write(r->segmentation, text, size, &size);
  if (status == TS_OK) fwrite(text, 1, size, file);
  free(text);
  return status == TS_OK ? 1 : complain_status(r->options->session, status);
}
