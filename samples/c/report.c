/* The JSON outputs: what was found and done, and how long it took. SPDX-License-Identifier: Apache-2.0 */
#include <stdlib.h>
#include <string.h>

#include "complain.h"
#include "json.h"
#include "writers.h"

/* -------------------------------------------------------------------------------------------------------- report */

static int write_intake(const run *r, json *j) {
  ts_intake_report report;
  ts_status status;
  memset(&report, 0, sizeof report);
  report.struct_size = sizeof report;
  status = ts_model_get_report(r->model, &report);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  json_open_object(j, "intake");
#define COUNT(member) json_count(j, #member, report.member)
  COUNT(input_vertices);
  COUNT(input_faces);
  COUNT(polygons);
  COUNT(welded_vertices);
  COUNT(unreferenced_vertices);
  COUNT(degenerate_faces);
  COUNT(duplicate_faces);
  COUNT(flipped_faces);
  COUNT(non_manifold_edges);
  COUNT(non_manifold_vertices);
  COUNT(unorientable_edges);
  COUNT(vertices);
  COUNT(faces);
  COUNT(components);
  COUNT(boundary_loops);
#undef COUNT
  json_number(j, "diagonal", report.diagonal);
  json_number(j, "area", report.area);
  json_number(j, "mean_edge", report.mean_edge);
  json_close_object(j);
  return 1;
}

typedef struct bit_name {
  uint32_t bit;
  const char *name;
} bit_name;

static const bit_name of_scan[] = {{TS_WARN_FEATURES_INSIDE_OUT, "inside_out"},
                                   {TS_WARN_FEATURES_OPPOSED, "opposed"},
                                   {TS_WARN_FEATURES_SEVERAL_ARCHES, "several_arches"}};

static const bit_name of_tooth[] = {{TS_WARN_AREA_SMALL, "area_small"},
                                    {TS_WARN_AREA_LARGE, "area_large"},
                                    {TS_WARN_OPEN_AT_BORDER, "open_at_border"},
                                    {TS_WARN_SEVERAL_LOOPS, "several_loops"},
                                    {TS_WARN_NO_NEIGHBOUR, "no_neighbour"},
                                    {TS_WARN_SEED_REJECTED, "seed_rejected"},
                                    {TS_WARN_WIDTH, "width"},
                                    {TS_WARN_TWO_GROUPS, "two_groups"},
                                    {TS_WARN_FLAT_TOP, "flat_top"},
                                    {TS_WARN_MADE_BY_CLICK, "made_by_click"}};

static void write_warnings(json *j, uint32_t warnings, const bit_name *names, size_t count) {
  size_t i;
  json_open_array(j, "warnings");
  for (i = 0; i < count; ++i)
    if (warnings & names[i].bit) json_text(j, NULL, names[i].name);
  json_close_array(j);
}
#define WRITE_WARNINGS(j, warnings, names) write_warnings(j, warnings, names, sizeof(names) / sizeof(names)[0])

static ts_status write_loops(const run *r, json *j, const ts_tooth_info *tooth) {
  uint32_t loop;
  ts_status status = TS_OK;
  json_open_array(j, "cut");
  for (loop = 0; status == TS_OK && loop < tooth->loops; ++loop) {
    ts_cut_info cut;
    uint32_t points;
    memset(&cut, 0, sizeof cut);
    cut.struct_size = sizeof cut;
    status = ts_get_cut(r->segmentation, tooth->id, loop, &cut, NULL, 0, &points);
    json_open_object(j, NULL);
    json_count(j, "points", cut.points);
    json_bool(j, "closed", cut.closed != 0);
    json_number(j, "length", cut.length);
    json_number(j, "concavity", cut.concavity);
    json_close_object(j);
  }
  json_close_array(j);
  return status;
}

static int write_teeth(const run *r, json *j) {
  ts_status status = TS_OK;
  uint32_t i;
  json_open_array(j, "teeth");
  for (i = 0; status == TS_OK && i < r->tooth_count; ++i) {
    const ts_tooth_info *tooth = &r->teeth[i];
    json_open_object(j, NULL);
    json_count(j, "label", tooth->label);
    json_count(j, "group", tooth->id);
    if (r->numbers != NULL) {
      json_count(j, "fdi", r->numbers[i].fdi);
      json_number(j, "fdi_confidence", r->numbers[i].confidence);
    }
    json_count(j, "click", tooth->click);
    json_count(j, "faces", tooth->faces);
    json_count(j, "vertices", tooth->vertices);
    json_count(j, "seeds", tooth->seeds);
    json_number(j, "area", tooth->area);
    json_number(j, "iso", tooth->iso);
    json_number(j, "gradient", tooth->gradient);
    json_number(j, "confidence", tooth->confidence);
    WRITE_WARNINGS(j, tooth->warnings, of_tooth);
    status = write_loops(r, j, tooth);
    json_close_object(j);
  }
  json_close_array(j);
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}

/* The label of a group's tooth; null if it has none. */
static void write_label(const run *r, json *j, const char *key, uint32_t group) {
  uint32_t i;
  for (i = 0; i < r->tooth_count; ++i)
    if (r->teeth[i].id == group) {
      json_count(j, key, r->teeth[i].label);
      return;
    }
  json_null(j, key);
}

static void write_side(const run *r, json *j, const char *key, uint32_t group, double distance, double iso,
                       double length) {
  if (group == TS_NONE) {
    json_null(j, key);
    return;
  }
  json_open_object(j, key);
  write_label(r, j, "label", group);
  json_count(j, "group", group);
  json_number(j, "distance", distance);
  json_number(j, "iso", iso);
  json_number(j, "cut_length", length);
  json_close_object(j);
}

static void write_click(const run *r, json *j, const click *c) {
  const ts_click_info *info = &c->info;
  json_open_object(j, NULL);
  json_point(j, "position", c->position);
  if (c->line != 0) json_count(j, "line", c->line);
  json_text(j, "status", ts_status_name(c->status));
  if (c->status != TS_OK) {
    json_text(j, "message", c->message);
  } else {
    json_point(j, "surface_point", info->position);
    json_number(j, "v_med", info->v_med);
    write_side(r, j, "target", info->target, info->target_distance, info->target_iso, c->target_length);
    write_side(r, j, "neighbour", info->neighbour, info->neighbour_distance, info->neighbour_iso, c->neighbour_length);
    json_open_object(j, "ms");
    json_number(j, "pick", info->ms.pick);
    json_number(j, "field", info->ms.field);
    json_number(j, "cut", info->ms.cut);
    json_number(j, "label", info->ms.label);
    json_number(j, "total", info->ms.total);
    json_close_object(j);
  }
  json_close_object(j);
}

static int write_times(const run *r, json *j) {
  ts_prepare_times times;
  ts_status status;
  double clicks = 0;
  uint32_t i;
  memset(&times, 0, sizeof times);
  times.struct_size = sizeof times;
  status = ts_get_prepare_times(r->segmentation, &times);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  for (i = 0; i < r->click_count; ++i)
    if (r->clicks[i].status == TS_OK) clicks += r->clicks[i].info.ms.total;
  json_open_object(j, "ms");
  json_number(j, "intake", times.intake);
  json_number(j, "features", times.features);
  json_number(j, "weights", times.weights);
  json_number(j, "factorise", times.factorise);
  json_number(j, "clicks", clicks);
  json_number(j, "total", times.intake + times.features + times.weights + times.factorise + clicks);
  json_close_object(j);
  return 1;
}

static void write_how(const run *r, json *j) {
  static const char *const units[] = {"checked_mm", "mm", "cm", "m", "inch"};
  json_text(j, "library", ts_version());
  json_text(j, "scan", r->options->scan);
  json_text(j, "preset", r->options->preset == TS_PRESET_PAPER ? "paper" : "default");
  json_text(j, "unit", units[r->options->unit]);
  json_count(j, "threads", r->options->threads);
  json_text(j, "clicks_from", r->options->clicks); /* null: proposed by the library */
}

int write_report(const run *r, FILE *file) {
  json j = json_begin(file);
  double occlusal[3];
  uint32_t i;
  ts_features_info features;
  ts_status status = ts_features_get_occlusal(r->features, occlusal);
  memset(&features, 0, sizeof features);
  features.struct_size = sizeof features;
  if (status == TS_OK) status = ts_features_get_info(r->features, &features);
  if (status != TS_OK) return complain_status(r->options->scan, status);
  json_open_object(&j, NULL);
  write_how(r, &j);
  if (!write_intake(r, &j)) return 0;
  json_point(&j, "occlusal", occlusal);
  json_bool(&j, "inside_out", features.inside_out != 0);
  json_number(&j, "opposed", features.opposed);
  json_number(&j, "coverage", features.coverage);
  json_number(&j, "arch_length", features.arch_length);
  WRITE_WARNINGS(&j, features.warnings, of_scan);
  if (r->numbers != NULL) {
    json_text(&j, "jaw", r->jaw.jaw == TS_JAW_UPPER ? "upper" : "lower");
    json_number(&j, "jaw_confidence", r->jaw.confidence);
  }
  json_open_object(&j, "counts");
  json_count(&j, "teeth", r->tooth_count);
  json_count(&j, "clicks", r->click_count);
  json_count(&j, "failed_clicks", r->failed);
  json_close_object(&j);
  json_open_array(&j, "clicks");
  for (i = 0; i < r->click_count; ++i) write_click(r, &j, &r->clicks[i]);
  json_close_array(&j);
  if (!write_teeth(r, &j) || !write_times(r, &j)) return 0;
  json_close_object(&j);
  json_end(&j);
  return 1;
}

/* ------------------------------------------------------------------------------------------------------ features */

static void write_point(json *j, const ts_feature_point *point) {
  json_open_object(j, NULL);
  json_count(j, "id", point->id);
  json_count(j, "vertex", point->vertex);
  json_point(j, "position", point->position);
  json_number(j, "convexity", point->convexity);
  json_close_object(j);
}

static void write_end(json *j, const char *key, uint32_t group) {
  if (group == TS_NONE)
    json_null(j, key);
  else
    json_count(j, key, group);
}

static void write_group(json *j, const ts_feature_group *group, const ts_feature_point *points, uint32_t count) {
  uint32_t i;
  json_open_object(j, NULL);
  json_count(j, "id", group->id);
  write_end(j, "previous", group->previous);
  write_end(j, "next", group->next);
  json_point(j, "centre", group->centre);
  json_number(j, "arch_from", group->arch_from);
  json_number(j, "arch_to", group->arch_to);
  json_number(j, "confidence", group->confidence);
  json_open_array(j, "points");
  for (i = 0; i < count; ++i)
    if (points[i].group == group->id) write_point(j, &points[i]);
  json_close_array(j);
  json_close_object(j);
}

static ts_status write_groups(const run *r, json *j) {
  uint32_t group_count = 0, point_count = 0, i;
  ts_feature_group *groups = NULL;
  ts_feature_point *points = NULL;
  ts_status status = ts_features_get_groups(r->features, NULL, 0, &group_count);
  if (status == TS_OK) status = ts_features_get_points(r->features, NULL, 0, &point_count);
  if (status != TS_OK) return status;
  groups = malloc((size_t)group_count * sizeof *groups + 1);
  points = malloc((size_t)point_count * sizeof *points + 1);
  status = groups != NULL && points != NULL ? TS_OK : TS_E_OUT_OF_MEMORY;
  if (status == TS_OK) status = ts_features_get_groups(r->features, groups, group_count, &group_count);
  if (status == TS_OK) status = ts_features_get_points(r->features, points, point_count, &point_count);
  if (status == TS_OK) {
    json_open_array(j, "groups");
    for (i = 0; i < group_count; ++i) write_group(j, &groups[i], points, point_count);
    json_close_array(j);
  }
  free(groups);
  free(points);
  return status;
}

static ts_status write_arch(const run *r, json *j) {
  uint32_t count = 0, i;
  double *xyz;
  ts_status status = ts_features_get_arch(r->features, NULL, 0, &count);
  if (status != TS_OK) return status;
  xyz = malloc((size_t)count * 3 * sizeof *xyz + 1);
  if (xyz == NULL) return TS_E_OUT_OF_MEMORY;
  status = ts_features_get_arch(r->features, xyz, count, &count);
  if (status == TS_OK) {
    json_open_array(j, "arch");
    for (i = 0; i < count; ++i) json_point(j, NULL, xyz + 3 * (size_t)i);
    json_close_array(j);
  }
  free(xyz);
  return status;
}

int write_features(const run *r, FILE *file) {
  json j = json_begin(file);
  double occlusal[3];
  ts_status status = ts_features_get_occlusal(r->features, occlusal);
  json_open_object(&j, NULL);
  if (status == TS_OK) json_point(&j, "occlusal", occlusal);
  if (status == TS_OK) status = write_arch(r, &j);
  if (status == TS_OK) status = write_groups(r, &j);
  json_close_object(&j);
  json_end(&j);
  return status == TS_OK ? 1 : complain_status(r->options->scan, status);
}
