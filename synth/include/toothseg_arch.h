/* toothseg_arch.h - a synthetic dental arch: a mesh with the look of an intraoral scan and its exact labels.
 * SPDX-License-Identifier: Apache-2.0
 *
 * For tests, benchmarks and samples that need a scan with known teeth and may not ship one of a patient. Plain C99,
 * independent of the toothseg library. Conventions are those of toothseg.h: millimetres, 0-based indices, options
 * structs with struct_size, functions that return 0 or a status of toothseg.h, outputs untouched on failure, getters
 * that fill a buffer of the caller's (NULL and capacity 0: only the count). No output, no abort, no globals; the same
 * options give the same bytes. Different arches may be made and read from different threads at the same time.
 *
 * Axes: +z is the occlusal direction in either jaw, +y the front. Seen from +z with the front on top, an upper arch has
 * the patient's right (quadrant 1) on the left, a lower one (quadrant 4) on the right.
 */
#ifndef TOOTHSEG_ARCH_H
#define TOOTHSEG_ARCH_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define TSA_API __attribute__((visibility("default"), warn_unused_result))
#define TSA_API_VOID __attribute__((visibility("default")))
#else
#define TSA_API
#define TSA_API_VOID
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What came of a call; the values are those of ts_status in toothseg.h. */
enum {
  TSA_OK = 0,
  TSA_E_INVALID_ARGUMENT = 100, /**< an option outside its stated range */
  TSA_E_NULL = 101,             /**< a pointer that must not be NULL is */
  TSA_E_STRUCT_SIZE = 102,      /**< struct_size is 0, or no size that any release had */
  TSA_E_BUFFER_TOO_SMALL = 103, /**< capacity is less than the number of elements */
  TSA_E_OUT_OF_MEMORY = 200,
  TSA_E_INTERNAL = 202
};

enum { TSA_JAW_UPPER = 1, TSA_JAW_LOWER = 2 };
enum { TSA_NOISE_NORMAL = 0, TSA_NOISE_ISOTROPIC = 1 };

/** What to make. */
typedef struct tsa_options {
  uint32_t struct_size;
  uint32_t jaw;            /**< TSA_JAW_UPPER (default) or TSA_JAW_LOWER */
  uint32_t triangles;      /**< wanted, 5000 to 4000000; the result is within 5 %. Default 100000 */
  uint32_t base;           /**< 0 = open shell with a rim as a scan has (default), 1 = closed by a flat plaster base */
  uint64_t seed;           /**< shapes, positions and noise vary with it. Default 1 */
  double crowding;         /**< 0 none (default), 0.35 mild, 0.65 moderate, 1 severe */
  double noise;            /**< standard deviation of the vertex noise, in mean edge lengths, 0 (default) to 1 */
  uint32_t noise_kind;     /**< TSA_NOISE_NORMAL (default): along the normals, TSA_NOISE_ISOTROPIC: each coordinate */
  uint32_t missing_count;  /**< number of missing teeth, default 0 */
  const uint32_t *missing; /**< their FDI numbers, of this jaw and 1 to 7 in the quadrant; read during the call only */
} tsa_options;

/** A point that a dentist would name. */
enum { TSA_CUSP = 0, TSA_INCISAL_CORNER = 1 };
typedef struct tsa_feature {
  uint32_t label;     /**< of its tooth */
  uint32_t kind;      /**< TSA_CUSP or TSA_INCISAL_CORNER */
  double position[3]; /**< on the surface before noise */
} tsa_feature;

/** A made arch; never changes. */
typedef struct tsa_arch tsa_arch;

/** Fills `options` with the defaults. `struct_size`: sizeof(tsa_options). */
TSA_API int tsa_options_init(tsa_options *options, uint32_t struct_size);

/** Makes an arch. `options` may be NULL: the defaults. `out` is owned by the caller. */
TSA_API int tsa_create(const tsa_options *options, tsa_arch **out);

/** Gives an arch back; NULL is fine. */
TSA_API_VOID void tsa_destroy(tsa_arch *arch);

/** What the last failed call of this thread reported: one line, never NULL, "" before any failure. Lives until the next
 *  failing call of the same thread. */
TSA_API_VOID const char *tsa_last_error_message(void);

/** 3 coordinates a vertex; `capacity` and `count` are in vertices. */
TSA_API int tsa_get_positions(const tsa_arch *arch, double *positions, uint32_t capacity, uint32_t *count);
TSA_API int tsa_get_positions_f32(const tsa_arch *arch, float *positions, uint32_t capacity, uint32_t *count);

/** 3 vertices a triangle, counter-clockwise seen from outside; `capacity` and `count` are in triangles. */
TSA_API int tsa_get_triangles(const tsa_arch *arch, uint32_t *triangles, uint32_t capacity, uint32_t *count);

/** A label a triangle: 0 gingiva, else 1 + index into tsa_get_teeth. */
TSA_API int tsa_get_labels(const tsa_arch *arch, uint32_t *labels, uint32_t capacity, uint32_t *count);

/** The FDI numbers of the teeth, along the arch from the patient's right to the left: label k is tooth k - 1 here. */
TSA_API int tsa_get_teeth(const tsa_arch *arch, uint32_t *fdi, uint32_t capacity, uint32_t *count);

/** Cusp tips and incisal corners, tooth by tooth. Those buried in an overlapping neighbour are left out. */
TSA_API int tsa_get_features(const tsa_arch *arch, tsa_feature *features, uint32_t capacity, uint32_t *count);

#ifdef __cplusplus
}
#endif

#endif /* TOOTHSEG_ARCH_H */
