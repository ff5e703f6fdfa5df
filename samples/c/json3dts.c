/* Labels and instances a vertex, as the 3DTeethSeg challenge has them. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "complain.h"
#include "json.h"
#include "writers.h"

/* Of each model vertex the place + 1 in r->teeth of its tooth, 0 = gingiva: what most of its faces are of; of those
 * with as many a tooth before gingiva, and the one that comes first along the arch. */
static ts_status vote(const run *r, uint32_t vertices, uint32_t *winner) {
  const uint32_t kinds = r->tooth_count + 1;
  uint32_t faces = 0, all = 0, i, k, t;
  uint32_t *triangles = NULL, *source = NULL, *labels = NULL, *votes = NULL;
  ts_status status = ts_model_get_triangles(r->model, NULL, 0, &faces);
  if (status == TS_OK) status = ts_get_labels(r->segmentation, NULL, 0, &all);
  if (status != TS_OK) return status;
  triangles = malloc((size_t)faces * 3 * sizeof *triangles + 1);
  source = malloc((size_t)faces * sizeof *source + 1);
  labels = malloc((size_t)all * sizeof *labels + 1);
  votes = calloc((size_t)vertices * kinds + 1, sizeof *votes);
  status = triangles != NULL && source != NULL && labels != NULL && votes != NULL ? TS_OK : TS_E_OUT_OF_MEMORY;
  if (status == TS_OK) status = ts_model_get_triangles(r->model, triangles, faces, &faces);
  if (status == TS_OK) status = ts_model_get_face_sources(r->model, source, faces, &faces);
  if (status == TS_OK) status = ts_get_labels(r->segmentation, labels, all, &all);
  if (status == TS_OK) {
    for (i = 0; i < faces; ++i) {
      for (t = r->tooth_count; t > 0 && r->teeth[t - 1].label != labels[source[i]]; --t) continue;
      for (k = 0; k < 3; ++k) ++votes[(size_t)triangles[3 * (size_t)i + k] * kinds + t];
    }
    for (i = 0; i < vertices; ++i) {
      const uint32_t *own = votes + (size_t)i * kinds;
      winner[i] = 0;
      for (t = 1; t < kinds; ++t)
        if (own[t] > own[winner[i]] || (winner[i] == 0 && own[t] > 0 && own[t] == own[0])) winner[i] = t;
    }
  }
  free(triangles);
  free(source);
  free(labels);
  free(votes);
  return status;
}

/* The name of the scan without folders, ending, and _upper or _lower: the challenge's files are PATIENT_upper.obj. */
static void patient_of(const char *path, char *id, size_t size) {
  const char *name = path, *c;
  char *dot;
  size_t n;
  for (c = path; *c != '\0'; ++c)
    if (*c == '/' || *c == '\\') name = c + 1;
  n = strlen(name) < size - 1 ? strlen(name) : size - 1;
  memcpy(id, name, n);
  id[n] = '\0';
  dot = strrchr(id, '.');
  if (dot != NULL && dot != id) *dot = '\0';
  n = strlen(id);
  if (n > 6 && (strcmp(id + n - 6, "_upper") == 0 || strcmp(id + n - 6, "_lower") == 0)) id[n - 6] = '\0';
}

/* Long arrays of small numbers, on one line each: the writer of the report would give each number its own. */
static void put_array(FILE *file, const char *key, const run *r, const uint32_t *map, uint32_t count,
                      const uint32_t *winner, int fdi) {
  uint32_t i;
  fprintf(file, ",\n  \"%s\": [", key);
  for (i = 0; i < count; ++i) {
    const uint32_t tooth = map[i] == TS_NONE ? 0 : winner[map[i]];
    const uint32_t value = tooth == 0 || !fdi ? tooth : r->numbers[tooth - 1].fdi;
    fprintf(file, i == 0 ? "%lu" : ", %lu", (unsigned long)value);
  }
  fputc(']', file);
}

int write_json3dts(const run *r, FILE *file) {
  uint32_t count = 0, vertices = 0;
  uint32_t *map = NULL, *winner = NULL;
  char patient[1024];
  ts_status status = ts_model_get_vertex_map(r->model, NULL, 0, &count);
  if (status == TS_OK) status = ts_model_get_positions(r->model, NULL, 0, &vertices);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  map = malloc((size_t)count * sizeof *map + 1);
  winner = malloc((size_t)vertices * sizeof *winner + 1);
  status = map != NULL && winner != NULL ? TS_OK : TS_E_OUT_OF_MEMORY;
  if (status == TS_OK) status = ts_model_get_vertex_map(r->model, map, count, &count);
  if (status == TS_OK) status = vote(r, vertices, winner);
  if (status == TS_OK) {
    json j = json_begin(file);
    patient_of(r->options->scan, patient, sizeof patient);
    json_open_object(&j, NULL);
    json_text(&j, "id_patient", patient);
    json_text(&j, "jaw", r->jaw.jaw == TS_JAW_UPPER ? "upper" : "lower");
    put_array(file, "labels", r, map, count, winner, 1);
    put_array(file, "instances", r, map, count, winner, 0);
    json_close_object(&j);
    json_end(&j);
  }
  free(map);
  free(winner);
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}
