/* Every struct with a struct_size as 0.1.0 knows it, and as it was before it grew where it did: filled as far as that
 * goes, and not a byte further read or written. sizes SCAN TRUTH FOLDER. SPDX-License-Identifier: Apache-2.0 */
#define _DEFAULT_SOURCE
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "caller.h"

static ts_context *context;
static ts_model *model;
static ts_features *features;
static ts_segmentation *segmentation;
static ts_mesh *mesh;
static uint32_t tooth;
static const char *scan, *folder;

/* Structs end where memory that can be touched ends: what is beyond them cannot be read or written unnoticed. */
static unsigned char *end;
static size_t before;

static void make_room(void) {
  const size_t page = (size_t)sysconf(_SC_PAGESIZE);
  unsigned char *pages = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  CHECK(pages != MAP_FAILED);
  CHECK(mprotect(pages + page, page, PROT_NONE) == 0);
  end = pages + page;
  before = page;
}

static void *room(uint32_t size) {
  memset(end - before, 0xa5, before);
  return end - size;
}

static int all_before(uint32_t size) {
  const unsigned char *p;
  for (p = end - before; p < end - size; ++p)
    if (*p != 0xa5) return 0;
  return 1;
}

#define INIT(type, arguments)                            \
  static ts_status init_##type(void *o, uint32_t size) { \
    return type##_init arguments;                        \
  }
INIT(ts_context_options, (o, size))
INIT(ts_mesh_input, (o, size))
INIT(ts_intake_options, (o, size))
INIT(ts_feature_options, (o, size))
INIT(ts_segment_options, (o, size, TS_PRESET_PAPER))
INIT(ts_number_options, (o, size))
INIT(ts_tooth_mesh_options, (o, size))
INIT(ts_save_options, (o, size))

static ts_status use_context(void *o) {
  ts_context *out = NULL;
  const ts_status status = ts_context_create(o, &out);
  ts_context_destroy(out);
  return status;
}
static ts_status use_input(void *o) {
  static const double xyz[] = {0, 0, 0, 20, 0, 0, 0, 20, 0};
  static const uint32_t face[] = {0, 1, 2};
  ts_mesh_input *input = o;
  ts_model *out = NULL;
  ts_status status;
  input->scalar = TS_FLOAT64;
  input->positions = xyz;
  input->vertex_count = 3;
  input->triangles = face;
  input->triangle_count = 1;
  status = ts_model_create(context, input, NULL, NULL, &out);
  ts_model_destroy(out);
  return status;
}
static ts_status use_intake(void *o) {
  ts_model *out = NULL;
  const ts_status status = ts_model_load(context, scan, o, NULL, &out);
  ts_model_destroy(out);
  return status;
}
static ts_status use_features(void *o) {
  ts_features *out = NULL;
  const ts_status status = ts_detect_features(model, o, NULL, &out);
  ts_features_destroy(out);
  return status;
}
static ts_status use_segment(void *o) {
  ts_segmentation *out = NULL;
  const ts_status status = ts_segmentation_create(features, o, NULL, &out);
  ts_segmentation_destroy(out);
  return status;
}
static ts_status use_number(void *o) {
  return ts_assign_numbers(segmentation, o);
}
static ts_status use_tooth_mesh(void *o) {
  ts_mesh *out = NULL;
  const ts_status status = ts_tooth_mesh_create(segmentation, tooth, o, NULL, &out);
  ts_mesh_destroy(out);
  return status;
}
static ts_status use_save(void *o) {
  char path[4096];
  CHECK((size_t)snprintf(path, sizeof path, "%s/sizes.stl", folder) < sizeof path);
  return ts_segmentation_save(segmentation, path, TS_OUTPUT_STL, o, NULL);
}

static ts_status get_report(void *o) {
  return ts_model_get_report(model, o);
}
static ts_status get_features(void *o) {
  return ts_features_get_info(features, o);
}
static ts_status get_click(void *o) {
  return ts_get_click(segmentation, 0, o);
}
static ts_status get_tooth(void *o) {
  return ts_get_tooth(segmentation, tooth, o);
}
static ts_status get_cut(void *o) {
  return ts_get_cut(segmentation, tooth, 0, o, NULL, 0, NULL);
}
static ts_status get_times(void *o) {
  return ts_get_prepare_times(segmentation, o);
}
static ts_status get_memory(void *o) {
  return ts_get_memory(segmentation, o);
}
static ts_status get_history(void *o) {
  return ts_get_history(segmentation, o);
}
static ts_status get_number(void *o) {
  return ts_get_number(segmentation, tooth, o);
}
static ts_status get_jaw(void *o) {
  return ts_get_jaw(segmentation, o);
}
static ts_status get_palmer(void *o) {
  return ts_fdi_to_palmer(26, o);
}
static ts_status get_mesh(void *o) {
  return ts_mesh_get_info(mesh, o);
}
static ts_status get_frame(void *o) {
  return ts_get_tooth_frame(segmentation, tooth, o);
}

/* `last`: where the last field of a form ends; bytes after it up to the size are padding. */
#define END_OF(type, field) (offsetof(type, field) + sizeof(((type *)0)->field))
#define FORM(type, field) sizeof(type), END_OF(type, field)

static const struct {
  const char *name;
  ts_status (*init)(void *, uint32_t);
  ts_status (*use)(void *);
  size_t size, last;
} forms[] = {
    {"ts_context_options", init_ts_context_options, use_context, FORM(ts_context_options, log_user)},
    {"ts_mesh_input", init_ts_mesh_input, use_input, FORM(ts_mesh_input, triangle_count)},
    {"ts_intake_options", init_ts_intake_options, use_intake, FORM(ts_intake_options, weld_tolerance)},
    {"ts_feature_options", init_ts_feature_options, use_features, FORM(ts_feature_options, radius)},
    {"ts_segment_options", init_ts_segment_options, use_segment, FORM(ts_segment_options, memory_limit)},
    {"ts_segment_options", init_ts_segment_options, use_segment, offsetof(ts_segment_options, memory_limit),
     END_OF(ts_segment_options, reject_outliers)},
    {"ts_number_options", init_ts_number_options, use_number, FORM(ts_number_options, least_confidence)},
    {"ts_tooth_mesh_options", init_ts_tooth_mesh_options, use_tooth_mesh, FORM(ts_tooth_mesh_options, closed)},
    {"ts_save_options", init_ts_save_options, use_save, FORM(ts_save_options, whole_faces)},
    {"ts_intake_report", NULL, get_report, FORM(ts_intake_report, mean_edge)},
    {"ts_features_info", NULL, get_features, FORM(ts_features_info, arch_length)},
    {"ts_features_info", NULL, get_features, offsetof(ts_features_info, warnings),
     END_OF(ts_features_info, inside_out)},
    {"ts_click_info", NULL, get_click, FORM(ts_click_info, ms)},
    {"ts_tooth_info", NULL, get_tooth, FORM(ts_tooth_info, warnings)},
    {"ts_cut_info", NULL, get_cut, FORM(ts_cut_info, concavity)},
    {"ts_prepare_times", NULL, get_times, FORM(ts_prepare_times, factorise)},
    {"ts_memory_info", NULL, get_memory, FORM(ts_memory_info, click)},
    {"ts_history_info", NULL, get_history, FORM(ts_history_info, limit)},
    {"ts_number_info", NULL, get_number, FORM(ts_number_info, confidence)},
    {"ts_jaw_info", NULL, get_jaw, FORM(ts_jaw_info, confidence)},
    {"ts_palmer", NULL, get_palmer, FORM(ts_palmer, symbol)},
    {"ts_mesh_info", NULL, get_mesh, FORM(ts_mesh_info, lost)},
    {"ts_tooth_frame", NULL, get_frame, FORM(ts_tooth_frame, height)},
};

/* A form is filled up to its last field: twice over different bytes it comes out the same. */
static void check_form(size_t i) {
  const uint32_t size = (uint32_t)forms[i].size, length = (uint32_t)forms[i].last;
  unsigned char first[1024];
  uint32_t *o, k;
  CHECK(size <= sizeof first);
  fprintf(stderr, "%s of %lu bytes\n", forms[i].name, (unsigned long)size);
  for (k = 0; k < 2; ++k) {
    o = room(size);
    memset(o, k ? 0x5a : 0xa5, size);
    *o = size;
    DO(forms[i].init ? forms[i].init(o, size) : forms[i].use(o));
    CHECK(*o == size && all_before(size));
    if (k == 0) memcpy(first, o, size);
  }
  CHECK(memcmp(first, o, length) == 0);
  if (forms[i].init) DO(forms[i].use(o));
  CHECK(all_before(size));
  o = room(size);
  *o = size + 1;
  CHECK(forms[i].use(o) == TS_E_STRUCT_SIZE && *o == size + 1);
}

int main(int argc, char **argv) {
  uint32_t count = 0, teeth[32];
  size_t i;
  CHECK(argc == 4);
  scan = argv[1];
  folder = argv[3];
  make_room();
  DO(ts_context_create(NULL, &context));
  DO(ts_model_load(context, scan, NULL, NULL, &model));
  DO(ts_detect_features(model, NULL, NULL, &features));
  DO(ts_segmentation_create(features, NULL, NULL, &segmentation));
  DO(ts_segment_all(segmentation, NULL));
  DO(ts_get_teeth(segmentation, teeth, 32, &count));
  CHECK(count > 0);
  tooth = teeth[0];
  DO(ts_assign_numbers(segmentation, NULL));
  DO(ts_tooth_mesh_create(segmentation, tooth, NULL, NULL, &mesh));
  for (i = 0; i < sizeof forms / sizeof *forms; ++i) check_form(i);
  ts_mesh_destroy(mesh);
  ts_segmentation_destroy(segmentation);
  ts_features_destroy(features);
  ts_model_destroy(model);
  ts_context_destroy(context);
  return 0;
}
