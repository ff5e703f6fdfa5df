/* From a file to a label a face, with every hook a program can have: labels SCAN TRUTH FOLDER.
 * SPDX-License-Identifier: Apache-2.0 */
#include <string.h>

#include "caller.h"

typedef struct counts {
  long blocks; /* handed out and not given back */
  long lines;
  long reports;
  double fraction;
} counts;

static void *alloc(size_t bytes, void *user) {
  ++((counts *)user)->blocks;
  return malloc(bytes);
}
static void give_back(void *memory, void *user) {
  if (memory) --((counts *)user)->blocks;
  free(memory);
}
static void hear(ts_log_level level, const char *text, void *user) {
  if (level <= TS_LOG_INFO && text[0]) ++((counts *)user)->lines;
}
static int follow(double fraction, const char *stage, void *user) {
  counts *c = user;
  if (stage && fraction >= 0 && fraction <= 1) ++c->reports;
  c->fraction = fraction;
  return 0;
}
static int refuse(double fraction, const char *stage, void *user) {
  (void)fraction, (void)stage, (void)user;
  return 1;
}

/* Labels are of the teeth that the truth knows, one each, and most faces are right. */
static void judge(const char *truth, const uint32_t *labels, uint32_t faces, uint32_t teeth) {
  static uint32_t votes[64][64];
  uint32_t *fdi = room_for(sizeof *fdi * faces), f, i, right = 0, best[64] = {0};
  FILE *file = fopen(truth, "r");
  CHECK(file != NULL);
  for (f = 0; f < faces; ++f) {
    unsigned long value;
    CHECK(fscanf(file, "%lu", &value) == 1 && value < 64);
    CHECK(labels[f] < 64);
    fdi[f] = (uint32_t)value;
    ++votes[labels[f]][fdi[f]];
  }
  fclose(file);
  for (i = 0; i < 64; ++i)
    for (f = 0; f < 64; ++f)
      if (votes[i][f] > votes[i][best[i]]) best[i] = f;
  for (i = 1; i <= teeth; ++i) {
    CHECK(best[i] != 0);
    for (f = 1; f < i; ++f) CHECK(best[f] != best[i]);
  }
  for (f = 0; f < faces; ++f) right += best[labels[f]] == fdi[f];
  CHECK(right > 0.9 * faces);
  free(fdi);
}

int main(int argc, char **argv) {
  counts c = {0, 0, 0, 0};
  ts_context_options context_options;
  ts_intake_options intake;
  ts_feature_options feature_options;
  ts_segment_options options;
  ts_context *context = NULL;
  ts_job *job = NULL, *no = NULL;
  ts_model *model = NULL, *none = NULL;
  ts_features *features = NULL;
  ts_segmentation *segmentation = NULL;
  ts_intake_report report;
  ts_features_info found;
  ts_status *statuses;
  double *clicks;
  uint32_t *labels, *teeth, *faces, count = 0, n = 0, i, k;
  CHECK(argc == 4);

  CHECK(strtol(ts_version(), NULL, 10) == TS_VERSION_MAJOR);
  CHECK(strcmp(ts_status_name(TS_E_NO_TEETH), "TS_E_NO_TEETH") == 0);
  DO(ts_context_options_init(&context_options, sizeof context_options));
  context_options.threads = 1;
  context_options.alloc = alloc;
  context_options.free = give_back;
  context_options.alloc_user = context_options.log_user = &c;
  context_options.log = hear;
  DO(ts_context_create(&context_options, &context));
  DO(ts_job_create(context, follow, &c, &job));
  DO(ts_job_create(context, refuse, NULL, &no));

  CHECK(ts_model_load(context, "no such file", NULL, job, &none) == TS_E_FILE_OPEN && none == NULL);
  CHECK(ts_last_error_message()[0] != 0);
  CHECK(ts_model_load(context, argv[1], NULL, no, &none) == TS_E_CANCELLED && none == NULL);
  DO(ts_intake_options_init(&intake, sizeof intake));
  DO(ts_model_load(context, argv[1], &intake, job, &model));
  CHECK(c.reports > 0 && c.fraction == 1 && ts_job_progress(job) == 1);
  report.struct_size = sizeof report;
  DO(ts_model_get_report(model, &report));
  CHECK(report.faces > 1000 && report.faces <= report.input_faces && report.diagonal > 9 && report.mean_edge > 0);

  DO(ts_feature_options_init(&feature_options, sizeof feature_options));
  DO(ts_detect_features(model, &feature_options, job, &features));
  found.struct_size = sizeof found;
  DO(ts_features_get_info(features, &found));
  CHECK(found.groups >= 12 && found.points > found.groups && found.arch_length > 50);

  DO(ts_segment_options_init(&options, sizeof options, TS_PRESET_DEFAULT));
  CHECK(options.weights == TS_WEIGHTS_CONCAVITY && options.background == TS_BACKGROUND_ALL);
  DO(ts_segmentation_create(features, &options, job, &segmentation));
  ts_features_destroy(features); /* parents may go first */
  ts_model_destroy(model);

  DO(ts_propose_clicks(segmentation, NULL, 0, &count));
  CHECK(count > 0);
  clicks = room_for(3 * sizeof *clicks * count);
  statuses = room_for(sizeof *statuses * count);
  DO(ts_propose_clicks(segmentation, clicks, count, NULL));
  DO(ts_segment_clicks(segmentation, clicks, count, job, statuses));
  for (i = 0; i < count; ++i) CHECK(statuses[i] == TS_OK);

  DO(ts_get_labels(segmentation, NULL, 0, &n));
  CHECK(n == report.input_faces);
  labels = room_for(sizeof *labels * n);
  CHECK(ts_get_labels(segmentation, labels, n - 1, NULL) == TS_E_BUFFER_TOO_SMALL);
  DO(ts_get_labels(segmentation, labels, n, &n));
  DO(ts_get_teeth(segmentation, NULL, 0, &count));
  CHECK(count >= 12 && count <= 16);
  judge(argv[2], labels, n, count);

  teeth = room_for(sizeof *teeth * count);
  DO(ts_get_teeth(segmentation, teeth, count, &count));
  for (i = 0; i < count; ++i) {
    ts_tooth_info tooth;
    ts_cut_info cut;
    ts_edge_point *points;
    uint32_t own = 0, of_cut = 0;
    tooth.struct_size = sizeof tooth;
    cut.struct_size = sizeof cut;
    DO(ts_get_tooth(segmentation, teeth[i], &tooth));
    CHECK(tooth.id == teeth[i] && tooth.area > 1 && tooth.confidence > 0 && tooth.confidence <= 1);
    DO(ts_get_tooth_faces(segmentation, teeth[i], NULL, 0, &own));
    CHECK(own == tooth.faces);
    faces = room_for(sizeof *faces * own);
    DO(ts_get_tooth_faces(segmentation, teeth[i], faces, own, NULL));
    for (k = 0; k < own; ++k) CHECK(faces[k] < report.faces);
    free(faces);
    DO(ts_get_cut(segmentation, teeth[i], 0, &cut, NULL, 0, &of_cut));
    CHECK(cut.points == of_cut && cut.closed <= 1 && cut.length > 5);
    points = room_for(sizeof *points * of_cut);
    DO(ts_get_cut(segmentation, teeth[i], 0, NULL, points, of_cut, NULL));
    for (k = 0; k < of_cut; ++k) CHECK(points[k].t >= 0 && points[k].t <= 1 && points[k].a < report.vertices);
    free(points);
  }
  free(teeth);
  free(labels);
  free(statuses);
  free(clicks);
  ts_segmentation_destroy(segmentation);
  ts_job_destroy(no);
  ts_job_destroy(job);
  ts_context_destroy(context);
  CHECK(c.blocks == 0);
  return 0;
}
