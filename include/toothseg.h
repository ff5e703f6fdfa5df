/* toothseg.h - separate the teeth of a scanned dental arch, one click a pair.
 * SPDX-License-Identifier: Apache-2.0
 *
 * This header is the manual of the library. It is plain C99 and includes nothing but <stdint.h> and <stddef.h>.
 *
 * READ ME FIRST
 *   Way of work  context -> model (intake of a mesh) -> features (found, or set by hand) -> segmentation (prepared
 *                once) -> clicks -> teeth, cuts, labels. Each object is made by a function with an `out` argument
 *                and given back to the ..._destroy function of its kind, which accepts NULL.
 *   Units        millimetres. `unit` in ts_intake_options converts a mesh in other units on its way in; every
 *                coordinate that goes in or out after that is in mm, in the axes of the caller's mesh. Any pose.
 *   Indices      0-based, uint32_t. TS_NONE means "none".
 *   Arrays       C-contiguous, owned by whoever allocated them. The library copies what it is given before a call
 *                returns and never keeps a caller's pointer (hooks and their `user` pointers excepted).
 *                Getters fill a buffer of the caller's: pass NULL and capacity 0 to learn the number of elements;
 *                `count` may be NULL when a buffer is given.
 *   Strings      UTF-8, zero-terminated. What the library returns as const char * stays its own; how long it lives
 *                is said at the function.
 *   Errors       Every function that can fail returns ts_status; TS_OK is 0. On failure all out-parameters and all
 *                objects are as they were, and ts_last_error_message() says what was wrong, and where, in one line.
 *                No exception, abort, or output to stdout or stderr crosses this interface.
 *   Threads      A function that takes a const handle may run at the same time as other such calls on the same
 *                object. One that takes a non-const handle needs that object to itself. Different objects are
 *                independent, also when they share a context or a model. A context may be given to any number of
 *                calls at once. ts_job_cancel and ts_job_progress may be called at any time from any thread.
 *   Hooks        A context's hooks and their `user` pointers must live as long as anything made from it; a job's as
 *                long as the job.
 *   Floats       Called with the floating-point environment that C starts with: rounding to nearest, exceptions masked. Who
 *                unmasks them (Pascal does) masks them around calls.
 *   Lifetime     A child keeps its parents alive (a segmentation its features and model, a model its context): handles
 *                may be destroyed in any order.
 *   Options      Structs that begin with struct_size are filled by their ..._init function, called with sizeof the
 *                struct as the caller knows it, then changed where wanted. They only ever grow at the end. A NULL
 *                options pointer means: as initialised.
 *   Results      The same input gives the same bytes, whatever the number of threads.
 *   Windows      The calling convention, of callbacks too, is the one of 64-bit Windows, which __cdecl names. No type here depends
 *                on the size of long. Names of files are UTF-8, whatever the code page.
 *   Paper        "Interactive Tooth Separation from Dental Model Using Segmentation Field", Li & Wang, PLOS ONE 2016,
 *                doi 10.1371/journal.pone.0161159. Eq., Fig. and Table below are its.
 *
 * All functions are since 0.1.0 unless marked otherwise.
 */
#ifndef TOOTHSEG_H
#define TOOTHSEG_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && !defined(TS_STATIC)
#if defined(TS_BUILD)
#define TS_API __declspec(dllexport)
#else
#define TS_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define TS_API __attribute__((visibility("default")))
#else
#define TS_API
#endif

#if defined(__GNUC__)
#define TS_NODISCARD __attribute__((warn_unused_result))
#else
#define TS_NODISCARD
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------ version, status */

/** Version of this header; ts_version() gives that of the library. Same major: old programs run on new libraries. */
#define TS_VERSION_MAJOR 0
#define TS_VERSION_MINOR 1
#define TS_VERSION_PATCH 0

/** "No index": a face, vertex, group or tooth that is not there. */
#define TS_NONE UINT32_MAX

/** What came of a call. Values are fixed for ever; new ones are added within their block. */
typedef enum ts_status {
  TS_OK = 0, /**< done */

  /* 100: the call itself is wrong (a bug in the calling program) */
  TS_E_INVALID_ARGUMENT = 100, /**< a value outside its stated range */
  TS_E_NULL = 101,             /**< a pointer that must not be NULL is */
  TS_E_STRUCT_SIZE = 102,      /**< struct_size is 0, or no size that any release had */
  TS_E_BUFFER_TOO_SMALL = 103, /**< capacity is less than the number of elements */
  TS_E_NOT_FOUND = 104,        /**< no such group, point, click, tooth, loop or contour */
  TS_E_MISMATCH = 105,         /**< objects that do not belong together (features of another model) */

  /* 200: the surroundings */
  TS_E_OUT_OF_MEMORY = 200, /**< an allocation failed, or memory_limit is too small for any way of work */
  TS_E_CANCELLED = 201,     /**< the job was cancelled, by ts_job_cancel or its callback */
  TS_E_INTERNAL = 202,      /**< a fault in the library: please report the message */

  /* 300: files */
  TS_E_FILE_OPEN = 300,      /**< cannot be opened or read */
  TS_E_FILE_FORMAT = 301,    /**< not STL, PLY, OBJ or OFF, or a variant that is not read */
  TS_E_FILE_TRUNCATED = 302, /**< ends before what its header or its last statement promises */
  TS_E_FILE_TRAILING = 303,  /**< goes on after what its header promises */
  TS_E_FILE_COUNT = 304,     /**< a count that the file's size contradicts */
  TS_E_FILE_SYNTAX = 305,    /**< text where a number or keyword belongs; the message has the line */
  TS_E_FILE_WRITE = 306,     /**< cannot be written; nothing is left half written */
  TS_E_FILE_NEWER = 307,     /**< a session of a later format than this library reads */

  /* 400: the mesh */
  TS_E_MESH_EMPTY = 400,        /**< no face, or none that is not degenerate */
  TS_E_MESH_NON_FINITE = 401,   /**< NaN or infinity among the coordinates */
  TS_E_MESH_INDEX_RANGE = 402,  /**< a triangle names a vertex that is not there */
  TS_E_MESH_UNITS = 403,        /**< too small or too large for a scan in mm: probably in other units */
  TS_E_MESH_TOO_LARGE = 404,    /**< more than 2^30 faces or vertices, or coordinates beyond 1e9 mm */

  /* 500: features */
  TS_E_NO_TEETH = 500,      /**< nothing on the mesh looks like a tooth */
  TS_E_NO_CONSTRAINT = 501, /**< no group with a point: there is nothing to separate */

  /* 600: segmentation */
  TS_E_CLICK_OFF_SURFACE = 600, /**< the click is further from the surface than click_reach */
  TS_E_CLICK_ON_GINGIVA = 601,  /**< the click lies on gingiva or base, not on a tooth */
  TS_E_NO_CUT = 602,            /**< no contour of the field separates the tooth */
  TS_E_SOLVER = 603,            /**< the linear system could not be factorised */
  TS_E_LOCKED = 604,            /**< the tooth is locked, and the call would change it */
  TS_E_NO_CHANGE = 605,         /**< what is asked for is so already */
  TS_E_NO_HISTORY = 606,        /**< nothing to undo, or to redo */

  /* 650: edits of a cut */
  TS_E_EDIT_NOTHING = 650,  /**< the edit would change nothing: a drag to where the point is, a stroke of no length */
  TS_E_EDIT_ON_TOOTH = 651, /**< the new line would run on another tooth, or take in its feature points */
  TS_E_EDIT_CROSSING = 652, /**< the new line would cross the rest of the cut, or part the tooth's feature points from it */
  TS_E_EDIT_OFF_CUT = 653,  /**< the edit does not come near the cut that it is to change */
  TS_E_EDIT_NO_LOOP = 654,  /**< a loop of the cut would vanish, or become several */

  /* 700: numbers of teeth */
  TS_E_TOO_MANY_TEETH = 700, /**< more teeth along the arch than the 16 that a jaw has */
  TS_E_NUMBER_JAW = 701,     /**< a number of the other jaw */
  TS_E_NUMBER_TAKEN = 702,   /**< the number has been set for another tooth */
  TS_E_NUMBER_ORDER = 703,   /**< numbers would not rise along the arch, or leave none for the teeth between */

  /* 750: the meshes of teeth */
  TS_E_NOT_CLOSED = 750, /**< a rim cannot be closed without the mesh running through itself */

  TS_STATUS_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_status;

/** The library's version, e.g. "0.1.0". Static; any thread. */
TS_API const char *ts_version(void);

/** The name of a status, e.g. "TS_E_NO_TEETH"; "TS_E_?" for an unknown one. Static; any thread. */
TS_API const char *ts_status_name(ts_status status);

/** What the last failed call of this thread reported: one line, never NULL, "" before any failure. Lives until the
 *  next failing call of the same thread. Do not use it to find out whether a call failed. */
TS_API const char *ts_last_error_message(void);

/* --------------------------------------------------------------------------------------------------------- context */

/** Holds the hooks (allocator, log, threads) for all objects made from it. */
typedef struct ts_context ts_context;

/** How much a line of the log matters. */
typedef enum ts_log_level {
  TS_LOG_ERROR = 0,   /**< not used so far: a call that fails says so in its status */
  TS_LOG_WARNING = 1, /**< the call did its work, and something about it is odd */
  TS_LOG_INFO = 2,    /**< what was found and how long it took */
  TS_LOG_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_log_level;

/** Allocator hook. `alloc` returns memory aligned to 16 bytes, or NULL when there is none. Both may be called from any
 *  thread that works for the context. The large buffers of the library come from here; Eigen and oneTBB keep their
 *  own. */
typedef void *(*ts_alloc_fn)(size_t bytes, void *user);
/** Gives back what `alloc` of the same hook gave; `memory` is never NULL. */
typedef void (*ts_free_fn)(void *memory, void *user);

/** Log hook: one line without newline, valid during the call only; may come from any thread that works for the context. */
typedef void (*ts_log_fn)(ts_log_level level, const char *text, void *user);

/** Hooks and threads of a context. */
typedef struct ts_context_options {
  uint32_t struct_size; /**< set by ts_context_options_init */
  uint32_t threads;     /**< worker threads: 0 = one a core, 1 = only the calling thread, at most 1024. Default 0 */
  ts_alloc_fn alloc;    /**< NULL = the system's; give both or none */
  ts_free_fn free;      /**< NULL if `alloc` is */
  void *alloc_user;     /**< given to both as `user` */
  ts_log_fn log;        /**< NULL = silent */
  void *log_user;       /**< given to it as `user` */
} ts_context_options;

/** Fills `options` with the defaults. `struct_size`: sizeof(ts_context_options).
 *  Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any. */
TS_API TS_NODISCARD ts_status ts_context_options_init(ts_context_options *options, uint32_t struct_size);

/** Makes a context. `options` in, may be NULL; `out` out, owned by the caller.
 *  Errors: TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT, TS_E_OUT_OF_MEMORY. Thread: any. */
TS_API TS_NODISCARD ts_status ts_context_create(const ts_context_options *options, ts_context **out);

/** Gives a context back; NULL is fine. It lives on until its last child is gone. */
TS_API void ts_context_destroy(ts_context *context);

/* ------------------------------------------------------------------------------------------------------------- job */

/** Progress and cancellation of one long call at a time. Every long call takes a ts_job pointer, which may be NULL. */
typedef struct ts_job ts_job;

/** Called during a long call, from a thread that works for it, one call at a time: `fraction` in [0, 1], never falling within
 *  one call; `stage` a short English name. Return 0 to go on, anything else to cancel: sticky, as ts_job_cancel is. Must not
 *  call the library. */
typedef int (*ts_progress_fn)(double fraction, const char *stage, void *user);

/** Makes a job. `progress` may be NULL (then the job serves to cancel only). `out` owned by the caller.
 *  Errors: TS_E_NULL, TS_E_OUT_OF_MEMORY. */
TS_API TS_NODISCARD ts_status ts_job_create(ts_context *context, ts_progress_fn progress, void *user, ts_job **out);

/** Asks the running call to stop: it returns TS_E_CANCELLED soon, with nothing changed. Sticky until ts_job_reset.
 *  Any thread, any time between create and destroy; NULL is fine. */
TS_API void ts_job_cancel(ts_job *job);

/** Makes a cancelled job usable again. Not while a call uses it. */
TS_API void ts_job_reset(ts_job *job);

/** The last reported fraction, 0 before any. Any thread. NULL gives 0. */
TS_API double ts_job_progress(const ts_job *job);

/** Gives a job back; NULL is fine. Not while a call uses it. */
TS_API void ts_job_destroy(ts_job *job);

/* ----------------------------------------------------------------------------------------------------------- model */

/** A mesh after intake: welded, clean, manifold, consistently wound. Never changes once made. */
typedef struct ts_model ts_model;

/** Type of the caller's coordinates. */
typedef enum ts_scalar {
  TS_FLOAT32 = 0, /**< float */
  TS_FLOAT64 = 1, /**< double */
  TS_SCALAR_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_scalar;

/** Unit of the caller's coordinates. TS_UNIT_CHECKED_MM: mm, and TS_E_MESH_UNITS if the size of the mesh contradicts
 *  it (bounding box diagonal under 9 or over 400); the others convert without a check of the size, as long as coordinates
 *  stay within 1e9 mm. Distances of the library are of teeth in mm, whatever the size: on a surface over 400 mm across no
 *  teeth are found (TS_E_NO_TEETH), and parts under 0.5 mm are not closed (TS_E_NOT_CLOSED). */
typedef enum ts_unit {
  TS_UNIT_CHECKED_MM = 0, /**< mm, checked */
  TS_UNIT_MM = 1,         /**< mm, whatever the size */
  TS_UNIT_CM = 2,         /**< 10 mm */
  TS_UNIT_M = 3,          /**< 1000 mm */
  TS_UNIT_INCH = 4,       /**< 25.4 mm */
  TS_UNIT_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_unit;

/** Formats that are read. */
typedef enum ts_file_format {
  TS_FORMAT_AUTO = 0, /**< told from the content, not from the name */
  TS_FORMAT_STL = 1,  /**< binary or ASCII */
  TS_FORMAT_PLY = 2,  /**< ASCII, or binary of either byte order */
  TS_FORMAT_OBJ = 3,  /**< `v` and `f` lines; the rest is passed over */
  TS_FORMAT_OFF = 4,  /**< ASCII; [ST][C][N]OFF */
  TS_FORMAT_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_file_format;

/** The caller's mesh, read only during ts_model_create. */
typedef struct ts_mesh_input {
  uint32_t struct_size; /**< set by ts_mesh_input_init */
  ts_scalar scalar;          /**< type of the coordinates */
  const void *positions;     /**< x, y, z of vertex i at byte i * stride */
  uint32_t vertex_count;     /**< number of vertices */
  uint32_t stride;           /**< bytes from one vertex to the next; 0 = packed (12 or 24) */
  const uint32_t *triangles; /**< 3 indices a face; NULL = soup: vertices 3i, 3i+1, 3i+2 are face i */
  uint32_t triangle_count;   /**< number of faces; for a soup vertex_count / 3 or 0 */
  uint32_t reserved;         /**< 0 */
} ts_mesh_input;

/** How a mesh is taken in. */
typedef struct ts_intake_options {
  uint32_t struct_size; /**< set by ts_intake_options_init */
  ts_unit unit;          /**< default TS_UNIT_CHECKED_MM */
  double weld_tolerance; /**< vertices closer than this become one, mm. Default 0: only exactly equal ones */
} ts_intake_options;

/** Fills `input` with an empty mesh of doubles. `struct_size`: sizeof(ts_mesh_input). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
 *  Thread: any. */
TS_API TS_NODISCARD ts_status ts_mesh_input_init(ts_mesh_input *input, uint32_t struct_size);
/** Fills `options` with the defaults. `struct_size`: sizeof(ts_intake_options). Errors and threads: as above. */
TS_API TS_NODISCARD ts_status ts_intake_options_init(ts_intake_options *options, uint32_t struct_size);

/** What intake found and repaired. Counts of the caller's elements unless said otherwise. */
typedef struct ts_intake_report {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t input_vertices;        /**< as given (a soup: 3 a face) */
  uint32_t input_faces;           /**< as given; polygons count once */
  uint32_t polygons;              /**< input faces with more than 3 corners, triangulated */
  uint32_t welded_vertices;       /**< input vertices merged into another */
  uint32_t unreferenced_vertices; /**< used by no face: dropped */
  uint32_t degenerate_faces;      /**< fewer than 3 distinct corners, or no area: dropped */
  uint32_t duplicate_faces;       /**< same corners as another face: dropped */
  uint32_t flipped_faces;         /**< wound against the majority of their piece: turned round */
  uint32_t non_manifold_edges;    /**< edges of more than 2 faces: split */
  uint32_t non_manifold_vertices; /**< vertices where several fans met: split */
  uint32_t unorientable_edges;    /**< edges cut open because no winding fits both sides (Moebius) */
  uint32_t vertices;              /**< of the model */
  uint32_t faces;                 /**< of the model */
  uint32_t components;            /**< connected pieces of the model */
  uint32_t boundary_loops;        /**< open rims of the model */
  double diagonal;                /**< of the bounding box, mm */
  double area;                    /**< mm^2 */
  double mean_edge;               /**< mm */
} ts_intake_report;

/** Makes a model from the caller's arrays. Errors: TS_E_MESH_*, TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT,
 *  TS_E_OUT_OF_MEMORY, TS_E_CANCELLED. `options` and `job` may be NULL. */
TS_API TS_NODISCARD ts_status ts_model_create(ts_context *context, const ts_mesh_input *input,
                                              const ts_intake_options *options, ts_job *job, ts_model **out);

/** Makes a model from a file: binary or ASCII STL, PLY (ASCII, binary of either byte order), OBJ, OFF.
 *  `path`: UTF-8. Errors: TS_E_FILE_*, and those of ts_model_create. */
TS_API TS_NODISCARD ts_status ts_model_load(ts_context *context, const char *path, const ts_intake_options *options,
                                            ts_job *job, ts_model **out);

/** The same from a file already in memory. */
TS_API TS_NODISCARD ts_status ts_model_read(ts_context *context, const void *bytes, size_t size, ts_file_format format,
                                            const ts_intake_options *options, ts_job *job, ts_model **out);

/** Gives a model back; NULL is fine. It lives on until its last child is gone. */
TS_API void ts_model_destroy(ts_model *model);

/** Fills the report. `report->struct_size` in, the rest out. */
TS_API TS_NODISCARD ts_status ts_model_get_report(const ts_model *model, ts_intake_report *report);

/** Vertices of the model: `xyz` 3 doubles a vertex, `capacity` and `count` in vertices. */
TS_API TS_NODISCARD ts_status ts_model_get_positions(const ts_model *model, double *xyz, uint32_t capacity, uint32_t *count);

/** Faces of the model: 3 vertex indices each; `capacity` and `count` in faces. */
TS_API TS_NODISCARD ts_status ts_model_get_triangles(const ts_model *model, uint32_t *triangles, uint32_t capacity,
                                                     uint32_t *count);

/** For each model face the caller's face it came from. */
TS_API TS_NODISCARD ts_status ts_model_get_face_sources(const ts_model *model, uint32_t *input_face, uint32_t capacity,
                                                        uint32_t *count);

/** For each of the caller's vertices the model vertex that stands for it (after welding and splitting the first of
 *  several), TS_NONE if it was dropped. */
TS_API TS_NODISCARD ts_status ts_model_get_vertex_map(const ts_model *model, uint32_t *model_vertex, uint32_t capacity,
                                                      uint32_t *count);

/** A point on the surface: a model face and the weights of its three corners (sum 1). */
typedef struct ts_surface_point {
  uint32_t face;           /**< of the model */
  uint32_t nearest_vertex; /**< the corner with the largest weight */
  double barycentric[3];   /**< weights of its corners, in their order */
  double position[3]; /**< mm */
  double distance;    /**< from the query position, or along the ray from its origin, mm */
} ts_surface_point;

/** The surface point nearest to `position`. Errors: TS_E_NULL, TS_E_INVALID_ARGUMENT (not finite). */
TS_API TS_NODISCARD ts_status ts_model_nearest(const ts_model *model, const double position[3], ts_surface_point *out);

/** The first surface point hit by a ray (both sides of a face count). `direction` need not have length 1.
 *  Errors: TS_E_NOT_FOUND (the ray misses), TS_E_NULL, TS_E_INVALID_ARGUMENT. */
TS_API TS_NODISCARD ts_status ts_model_raycast(const ts_model *model, const double origin[3], const double direction[3],
                                               ts_surface_point *out);

/* -------------------------------------------------------------------------------------------------------- features */

/** Feature points of the teeth (cusps, incisal edges: paper ref. 38) in groups, one a tooth (ref. 30), with the
 *  occlusal direction and the arch curve they were found with. Can be edited, or built by hand from nothing. A
 *  segmentation takes a copy: editing features does not change one already made. */
typedef struct ts_features ts_features;

/** How features are found. */
typedef struct ts_feature_options {
  uint32_t struct_size; /**< set by ts_feature_options_init */
  uint32_t max_points;    /**< most points a tooth. Default 8 */
  double occlusal[3];     /**< a direction to use instead of the estimated one; 0,0,0 = estimate (default) */
  double radius;          /**< r of the convexity measure, mm. Default 2.0: about half a cusp's width */
} ts_feature_options;

/** Fills `options` with the defaults. `struct_size`: sizeof(ts_feature_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
 *  Thread: any. */
TS_API TS_NODISCARD ts_status ts_feature_options_init(ts_feature_options *options, uint32_t struct_size);

/** Finds the features of a model. Errors: TS_E_NO_TEETH, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. */
TS_API TS_NODISCARD ts_status ts_detect_features(const ts_model *model, const ts_feature_options *options, ts_job *job,
                                                 ts_features **out);

/** Makes an empty set, to be filled by hand. */
TS_API TS_NODISCARD ts_status ts_features_create(const ts_model *model, ts_features **out);

/** Makes a copy. */
TS_API TS_NODISCARD ts_status ts_features_clone(const ts_features *features, ts_features **out);

/** Gives features back; NULL is fine. */
TS_API void ts_features_destroy(ts_features *features);

/** Counts of a set of features, and what the detection saw of the scan. */
typedef struct ts_features_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t groups;     /**< number of groups */
  uint32_t points;     /**< number of points in all of them */
  uint32_t inside_out; /**< 1 if the detection found that the faces look inwards; everything works all the same */
  uint32_t warnings;   /**< sum of ts_features_warning */
  uint32_t reserved; /**< 0 */
  double opposed;      /**< roughness that faces against the occlusal direction over that which faces with it: under
                            .05 on most scans of one jaw, at most .33; .5 to 1 for two jaws in occlusion */
  double coverage;     /**< share of the roughness within 14 mm of the arch curve: .9 and more on scans of one jaw */
  double arch_length;  /**< of the arch curve, mm: up to 180 on scans of one jaw */
} ts_features_info;

/** What the detection found odd about the scan as a whole. Results are there all the same, and may be wrong or not all
 *  there is. */
typedef enum ts_features_warning {
  TS_WARN_FEATURES_INSIDE_OUT = 1,     /**< the faces look inwards: harmless */
  TS_WARN_FEATURES_OPPOSED = 2,        /**< teeth look both ways: two jaws in occlusion, or the direction is wrong */
  TS_WARN_FEATURES_SEVERAL_ARCHES = 4, /**< much that is as rough as teeth lies off the arch, or the arch is longer than
                                            any jaw's: two jaws side by side */
  TS_WARN_FEATURES_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_features_warning;

/** Counts, and what the detection saw (0 in a set made by hand). `info->struct_size` in, the rest out. */
TS_API TS_NODISCARD ts_status ts_features_get_info(const ts_features *features, ts_features_info *info);

/** A feature point: where a tooth is held. */
typedef struct ts_feature_point {
  uint32_t id;        /**< stays the same while the point exists */
  uint32_t group;     /**< id of its group */
  uint32_t vertex;    /**< nearest model vertex */
  uint32_t by_hand;   /**< 1 if the caller set it */
  double position[3]; /**< mm */
  double convexity;   /**< dimensionless: 0 on a plane, 0.25 to 0.4 on a cusp; 0 for a point set by hand */
} ts_feature_point;

/** The feature points of a tooth. */
typedef struct ts_feature_group {
  uint32_t id;        /**< stays the same while the group exists */
  uint32_t points;    /**< number of points */
  uint32_t previous;  /**< id of the neighbour group along the arch, TS_NONE at an end */
  uint32_t next;      /**< the other one */
  double centre[3];   /**< mean of its points, mm */
  double arch_from;   /**< where its tooth begins along the arch curve, mm; 0 if made by hand */
  double arch_to;     /**< where it ends, mm; 0 if made by hand */
  double confidence;  /**< 0 to 1: how sure the detection is that this is one tooth; 1 if made by hand */
} ts_feature_group;

/** The unit vector from the gums to the biting surface. */
TS_API TS_NODISCARD ts_status ts_features_get_occlusal(const ts_features *features, double direction[3]);
/** Sets it by hand; `direction` need not have length 1. Errors: TS_E_INVALID_ARGUMENT (no length, not finite), TS_E_NULL. */
TS_API TS_NODISCARD ts_status ts_features_set_occlusal(ts_features *features, const double direction[3]);

/** The arch curve as a polyline from one end of the arch to the other: 3 doubles a point, mm. */
TS_API TS_NODISCARD ts_status ts_features_get_arch(const ts_features *features, double *xyz, uint32_t capacity, uint32_t *count);

/** All points, in the order of their groups. */
TS_API TS_NODISCARD ts_status ts_features_get_points(const ts_features *features, ts_feature_point *points,
                                                     uint32_t capacity, uint32_t *count);

/** All groups, in the order of the arch. */
TS_API TS_NODISCARD ts_status ts_features_get_groups(const ts_features *features, ts_feature_group *groups,
                                                     uint32_t capacity, uint32_t *count);

/** Adds a point at the surface point nearest to `position`, to `group` (TS_NONE: a new group, placed along the arch by
 *  its position). `point` and `group_out` may be NULL. Errors: TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_features_add_point(ts_features *features, const double position[3], uint32_t group,
                                                    uint32_t *point, uint32_t *group_out);

/** Moves a point to the surface point nearest to `position`; it counts as set by hand then. Errors: TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_features_move_point(ts_features *features, uint32_t point, const double position[3]);

/** Puts a point into another group (TS_NONE: a new one). A group without points ceases to exist. */
TS_API TS_NODISCARD ts_status ts_features_set_group(ts_features *features, uint32_t point, uint32_t group,
                                                    uint32_t *group_out);

/** Takes a point away, and its group with the last of them. Errors: TS_E_NOT_FOUND, TS_E_NULL. */
TS_API TS_NODISCARD ts_status ts_features_remove_point(ts_features *features, uint32_t point);

/** Takes a group away with all its points. Errors: TS_E_NOT_FOUND, TS_E_NULL. */
TS_API TS_NODISCARD ts_status ts_features_remove_group(ts_features *features, uint32_t group);

/* ---------------------------------------------------------------------------------------------------- segmentation */

/** A prepared scan and the teeth separated so far. */
typedef struct ts_segmentation ts_segmentation;

/** What options are initialised to. */
typedef enum ts_preset {
  TS_PRESET_DEFAULT = 0, /**< the best we know: docs/method.md */
  TS_PRESET_PAPER = 1,   /**< the paper to the letter */
  TS_PRESET_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_preset;

/** Weights of the Laplacian (paper, "Selection of weighting scheme"; Fig. 10). */
typedef enum ts_weights {
  TS_WEIGHTS_CONCAVITY = 0, /**< beta + (1 - beta) exp(-c / c0), c the concavity at a physical radius */
  TS_WEIGHTS_PAPER = 1,     /**< Eq. 8 with the test of Eq. 9 */
  TS_WEIGHTS_COTANGENT = 2, /**< paper ref. 39, negative cotangents clamped */
  TS_WEIGHTS_UNIFORM = 3,   /**< 1 */
  TS_WEIGHTS_FEATURE = 4,   /**< feature-preserving, as paper ref. 40: Eq. 8 without its test, so that every bend counts,
                                 convex or concave (the paper does not print the formula of ref. 40) */
  TS_WEIGHTS_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_weights;

/** What is held at the background value beside the neighbour tooth. */
typedef enum ts_background {
  TS_BACKGROUND_NEIGHBOUR = 0, /**< nothing: the paper's pair */
  TS_BACKGROUND_GINGIVA = 1,   /**< vertices far from every feature point */
  TS_BACKGROUND_ALL = 2,       /**< these, and the points of all other groups */
  TS_BACKGROUND_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_background;

/** How the contour of a tooth is chosen. */
typedef enum ts_cut_rule {
  TS_CUT_GRADIENT = 0,  /**< the paper's: largest mean gradient in [0, V_med] and (V_med, 1] */
  TS_CUT_COMPONENT = 1, /**< the component around the seeds with the best concavity x gradient, and a tooth's area */
  TS_CUT_HALF = 2,      /**< the contour half way between the tooth's value and the background's */
  TS_CUT_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_cut_rule;

/** Defaults are given as: default preset / paper preset. */
typedef struct ts_segment_options {
  uint32_t struct_size; /**< set by ts_segment_options_init */
  ts_preset preset;            /**< what the options were initialised to; informative */
  ts_weights weights;          /**< CONCAVITY / PAPER */
  ts_background background;    /**< ALL / NEIGHBOUR */
  ts_cut_rule cut_rule;        /**< COMPONENT / GRADIENT */
  uint32_t contours;           /**< number of iso-values sampled in (0, 1) (Fig. 4A). 100 / 100 */
  uint32_t histogram_bins;     /**< of Fig. 4C. 50 / 50 */
  uint32_t points_per_group;   /**< most constraint points used a tooth (Figs. 2, 3); 0 = all. 0 / 0 */
  double alpha;                /**< penalty of Eq. 6; 0 = exact constraints. 1e8 / 1e8 */
  double beta;                 /**< factor of a concave edge (Eq. 8), least weight of CONCAVITY. 1e-3 / 0.01 */
  double gamma;                /**< added to the divisor of Eq. 8. 1e-4 / 1e-4 */
  double theta;                /**< threshold of Eq. 9. 0.2 / 0.001 */
  double c0;                   /**< decay of the CONCAVITY weights, 1/mm. 0.07 */
  double normal_radius;        /**< r of the smoothed normals, mm. 0.15 */
  double seed_radius;          /**< a constraint point is a disc of this radius, mm; 0 = one vertex. 0.7 / 0 */
  double gingiva_distance;     /**< from every feature point, mm, at which gingiva begins for certain. 13 */
  double area_min;             /**< least area of a tooth, mm^2, for COMPONENT and for warnings. 25 / 25 */
  double area_max;             /**< largest area of a tooth, mm^2. 330 / 330 */
  double hole_area;            /**< holes in a tooth's region up to this are filled, mm^2. 40 / 0 */
  double refine_band;          /**< half width of the band of the min-cut refinement, mm; 0 = none. 2.5 / 0 */
  double smooth_radius;        /**< smoothing of the final line, mm; 0 = none. 0.2 / 0 */
  double click_reach;          /**< a click further from the surface than this is off it, mm. 2 / 2 */
  double click_concavity;      /**< geodesic cost |e| (1 + this * concavity) from click to points. 60 / 0 */
  uint32_t reject_outliers;    /**< 1 = free feature points that contradict the field. 1 / 0 */
  uint64_t memory_limit;       /**< bytes that the segmentation may keep beside the model, clicks' results and work space
                                    left out (ts_get_memory); 0 = no limit. What does not fit of the factor is worked out
                                    again by each click that needs it: slower, the same bytes. 0 / 0 */
} ts_segment_options;

/** Fills `options` with those of a preset. `struct_size`: sizeof(ts_segment_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE,
 *  TS_E_INVALID_ARGUMENT (no such preset). Thread: any. */
TS_API TS_NODISCARD ts_status ts_segment_options_init(ts_segment_options *options, uint32_t struct_size, ts_preset preset);

/** Prepares a scan: weights, and the factorisation that all clicks share. `features` are copied.
 *  Errors: TS_E_NO_CONSTRAINT, TS_E_SOLVER, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. */
TS_API TS_NODISCARD ts_status ts_segmentation_create(const ts_features *features, const ts_segment_options *options,
                                                     ts_job *job, ts_segmentation **out);

/** Gives a segmentation back; NULL is fine. */
TS_API void ts_segmentation_destroy(ts_segmentation *segmentation);

/** Separates the tooth under `position` (mm, on the surface) and its neighbour: the group closest along the surface is
 *  the target (0), the next closest the background (1) (paper, "User interface"). The default preset takes for the
 *  neighbour the tooth beside the target along the arch that the click faces; one that is separated already is passed
 *  over where the tooth on the other side is not.
 *
 *  With everything else as background, as the default preset has it, the click is evidence: where the tooth of the
 *  closest group does not hold the click, the target is the group that the field at the click is most of; where that
 *  one's tooth does not hold it either, the click makes a group of its own, held on a disc of seed_radius
 *  (TS_WARN_MADE_BY_CLICK). A click that succeeds gives the tooth that it lies on, or, on no other, within 1 mm of. A group
 *  made by a click belongs to the segmentation, not to the features: later clicks find it and have it as background; its id
 *  is the smallest larger than those of all groups of the features and of those made before it. TS_E_CLICK_ON_GINGIVA also
 *  where what could be cut out around the click is no tooth.
 *
 *  `click` out, may be NULL: its number, counted from 0. Errors: TS_E_CLICK_*, TS_E_NO_CUT, TS_E_CANCELLED,
 *  TS_E_OUT_OF_MEMORY, usage. */
TS_API TS_NODISCARD ts_status ts_segment_click(ts_segmentation *segmentation, const double position[3], ts_job *job,
                                               uint32_t *click);

/** Several clicks at once, solved in parallel; the result is that of the same clicks one after the other. `positions`
 *  3 doubles a click. `statuses` out, may be NULL: one a click; a click that fails leaves no trace, the others stand,
 *  and numbers are given to those that succeed, in order. Returns TS_OK if the batch ran, even if clicks failed;
 *  ts_last_error_message then tells of the last that did. TS_E_INVALID_ARGUMENT if a position is not finite. */
TS_API TS_NODISCARD ts_status ts_segment_clicks(ts_segmentation *segmentation, const double *positions, uint32_t count,
                                                ts_job *job, ts_status *statuses);

/** The fewest clicks that cover every group of the features not yet separated (paper: N/2, or N/2 + 1 in all): 3 doubles
 *  a click, to be given to ts_segment_clicks. No clicks once all are separated. */
TS_API TS_NODISCARD ts_status ts_propose_clicks(const ts_segmentation *segmentation, double *positions, uint32_t capacity,
                                                uint32_t *count);

/* --------------------------------------------------------------------------------------------------------- results */

/** Milliseconds a stage took (paper, Fig. 11). With the default preset the field is solved where the cut looks at it:
 *  then `field` is the share of that in `cut` and `label`, and not added to `total` again. */
typedef struct ts_click_times {
  double pick;  /**< click to groups */
  double field; /**< solve; of the slower of the two teeth where they are worked out at the same time */
  double cut;   /**< contours, selection, refinement */
  double label; /**< lines and labels */
  double total; /**< of the call, but for its entry in the history */
} ts_click_times;

/** What came of a click. */
typedef struct ts_click_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t target;           /**< tooth clicked: id of its group */
  uint32_t neighbour;        /**< tooth beside it; TS_NONE if there is but one. Where no cut was found for it,
                                  ts_get_tooth says TS_E_NOT_FOUND: the tooth clicked stands alone */
  double position[3];        /**< the surface point taken, mm */
  double target_distance;    /**< along the surface to the closest point of each, in the metric of the options */
  double neighbour_distance; /**< this and v_med are worked out when a click's info is first asked for */
  double v_med;              /**< centre of the fullest bin (Fig. 4C) */
  double target_iso;         /**< chosen iso-values */
  double neighbour_iso;      /**< NaN if there is no neighbour */
  ts_click_times ms;         /**< how long it took */
} ts_click_info;

/** How many clicks have succeeded so far. Errors: TS_E_NULL. */
TS_API TS_NODISCARD ts_status ts_get_click_count(const ts_segmentation *segmentation, uint32_t *count);

/** `click`: counted from 0. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_click(const ts_segmentation *segmentation, uint32_t click, ts_click_info *info);

/** u of Eq. 3 for a click, a value a model vertex: 0 on the target, 1 on the neighbour; NaN on pieces of the mesh that
 *  hold no constraint: Eq. 3 leaves u open there. Their faces belong to no tooth (label 0), and clicks and corrections on a
 *  piece without any feature point are refused with TS_E_CLICK_ON_GINGIVA. */
TS_API TS_NODISCARD ts_status ts_get_field(const ts_segmentation *segmentation, uint32_t click, double *u, uint32_t capacity,
                                           uint32_t *count);

/** The histogram of Fig. 4C: vertices a bin over [0, 1]. */
TS_API TS_NODISCARD ts_status ts_get_histogram(const ts_segmentation *segmentation, uint32_t click, uint32_t *bins,
                                               uint32_t capacity, uint32_t *count);

/** One iso-value's contour of a click's field (Fig. 4A). */
typedef struct ts_contour_info {
  double iso;         /**< the value */
  double gradient;    /**< mean of |grad u| along it, 1/mm */
  double concavity;   /**< share of it in concave valleys, 0 to 1 */
  double length;      /**< mm */
  uint32_t points;    /**< in all its polylines */
  uint32_t polylines; /**< number of these */
  uint32_t chosen;    /**< 1 = cut of the target, 2 = of the neighbour, 0 = neither */
} ts_contour_info;

/** All contours of a click, by rising iso-value (ts_segment_options::contours of them). Errors: TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_get_contours(const ts_segmentation *segmentation, uint32_t click,
                                              ts_contour_info *contours, uint32_t capacity, uint32_t *count);

/** A point of a contour or cut: on the edge from model vertex `a` to `b`, at (1 - t) a + t b. */
typedef struct ts_edge_point {
  uint32_t a;         /**< model vertex */
  uint32_t b;         /**< model vertex */
  double t;           /**< 0 at a, 1 at b */
  double position[3]; /**< mm */
} ts_edge_point;

/** The points of one contour. `starts` out, may be NULL: index of the first point of each polyline (`polylines` of
 *  them); closed polylines repeat no point; `closed` out, may be NULL: 1 or 0 each. */
TS_API TS_NODISCARD ts_status ts_get_contour_points(const ts_segmentation *segmentation, uint32_t click, uint32_t contour,
                                                    ts_edge_point *points, uint32_t capacity, uint32_t *count,
                                                    uint32_t *starts, uint8_t *closed);

/** A separated tooth. Its id is the id of its feature group, or of the group that a click made (ts_segment_click). */
typedef struct ts_tooth_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t id;         /**< of the tooth */
  uint32_t label;      /**< what ts_get_labels writes: place of its feature group along the arch counted from 1; of the
                            n-th group made by a click the number of feature groups + n; not an FDI number */
  uint32_t click;      /**< the click that separated it (last) */
  uint32_t faces;      /**< model faces */
  uint32_t vertices;   /**< model vertices of these */
  uint32_t loops;      /**< closed polylines of its cut */
  uint32_t seeds;      /**< constraint points used */
  double area;         /**< mm^2 */
  double iso;          /**< iso-value of the cut */
  double gradient;     /**< mean of |grad u| along it, 1/mm */
  double confidence;   /**< 0 to 1 */
  uint32_t warnings;   /**< sum of ts_tooth_warning */
  uint32_t reserved;   /**< 0 */
} ts_tooth_info;

/** What looks wrong about a tooth. */
typedef enum ts_tooth_warning {
  TS_WARN_AREA_SMALL = 1,     /**< under area_min */
  TS_WARN_AREA_LARGE = 2,     /**< over area_max */
  TS_WARN_OPEN_AT_BORDER = 4, /**< the crown runs into a border of the scan */
  TS_WARN_SEVERAL_LOOPS = 8,  /**< the cut is not one closed line */
  TS_WARN_NO_NEIGHBOUR = 16,  /**< no neighbour was there to be background */
  TS_WARN_SEED_REJECTED = 32, /**< a feature point contradicted the field and was not used */
  TS_WARN_WIDTH = 64,         /**< wider or narrower along the arch than a tooth is, or than its stretch of the arch */
  TS_WARN_TWO_GROUPS = 128,   /**< a feature point of another group lies on it, before overlaps are resolved */
  TS_WARN_FLAT_TOP = 256,     /**< its top is one plane: a scan body or a post, not a crown */
  TS_WARN_MADE_BY_CLICK = 512, /**< no feature group lies on it: the click alone says that it is a tooth */
  TS_WARN_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_tooth_warning;

/** Ids of the teeth separated so far, along the arch. */
TS_API TS_NODISCARD ts_status ts_get_teeth(const ts_segmentation *segmentation, uint32_t *teeth, uint32_t capacity,
                                           uint32_t *count);

/** `tooth`: id. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_tooth(const ts_segmentation *segmentation, uint32_t tooth, ts_tooth_info *info);

/** Model faces of a tooth, ascending, those that another tooth holds as well included. Errors: TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_get_tooth_faces(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *faces,
                                                 uint32_t capacity, uint32_t *count);

/** Model vertices of these faces, ascending. Errors: TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_get_tooth_vertices(const ts_segmentation *segmentation, uint32_t tooth,
                                                    uint32_t *vertices, uint32_t capacity, uint32_t *count);

/** Model vertices held as this tooth's constraint. */
TS_API TS_NODISCARD ts_status ts_get_tooth_seeds(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *vertices,
                                                 uint32_t capacity, uint32_t *count);

/** A loop of a cut. */
typedef struct ts_cut_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t points;  /**< number of these */
  uint32_t closed;  /**< 1: the last point is joined to the first */
  double length;    /**< mm */
  double iso;       /**< iso-value it was chosen at */
  double gradient;  /**< mean of |grad u| along it, 1/mm */
  double concavity; /**< share of it in concave valleys, 0 to 1 */
} ts_cut_info;

/** The cut of a tooth: loop `loop` (0 = the longest) of its closed polyline(s), seen from outside counter-clockwise
 *  around the tooth. `info` may be NULL, `points` may be NULL. */
TS_API TS_NODISCARD ts_status ts_get_cut(const ts_segmentation *segmentation, uint32_t tooth, uint32_t loop,
                                         ts_cut_info *info, ts_edge_point *points, uint32_t capacity, uint32_t *count);

/** A label for each of the CALLER's faces, in the caller's order: 0 = no tooth (so far), else ts_tooth_info::label.
 *  Faces that intake dropped have the label of the face they duplicate or touch. */
TS_API TS_NODISCARD ts_status ts_get_labels(const ts_segmentation *segmentation, uint32_t *labels, uint32_t capacity,
                                            uint32_t *count);

/** Milliseconds of the preparation. */
typedef struct ts_prepare_times {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t reserved; /**< 0 */
  double intake;    /**< of the model */
  double features;  /**< of the detection; 0 if set by hand */
  double weights;   /**< curvature, concavity, weights */
  double factorise; /**< constraints, ordering, factorisation */
} ts_prepare_times;

/** `times->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_prepare_times(const ts_segmentation *segmentation, ts_prepare_times *times);

/** Bytes that are kept. Most of them come from the context's allocator. */
typedef struct ts_memory_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t reserved; /**< 0 */
  uint64_t model;        /**< of the model, which segmentations share */
  uint64_t segmentation; /**< of what a segmentation keeps beside it, the factor included: what memory_limit bounds */
  uint64_t factor;       /**< of the factor, as far as it is kept */
  uint64_t factor_whole; /**< of the factor if all of it were */
  uint64_t click;        /**< of the work space of one tooth; as many are kept as teeth were cut at the same time */
} ts_memory_info;

/** Errors: TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_memory(const ts_segmentation *segmentation, ts_memory_info *info);

/* --------------------------------------------------------------------------------------------------------- session */

/* A segmentation is a session: each of the calls below, and each click, is one step that ts_undo takes back. All that take
 * a non-const segmentation are strong: a call that fails changes nothing, and is no step. */

/** Every tooth without a click of the caller's: the clicks of ts_propose_clicks until none is left, as one step. Teeth that
 *  stand already stay. Errors: TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage; a tooth for which no cut is found is told by
 *  ts_get_review. */
TS_API TS_NODISCARD ts_status ts_segment_all(ts_segmentation *segmentation, ts_job *job);

/** A tooth that wants a look. */
typedef struct ts_review_item {
  uint32_t tooth;          /**< id of its group */
  uint32_t separated;      /**< 0: no cut has been made for this group so far */
  uint32_t warnings;       /**< sum of ts_tooth_warning */
  uint32_t reserved; /**< 0 */
  double confidence;       /**< of the tooth, 0 to 1; 0 where it is not separated */
  double group_confidence; /**< that the group is exactly one tooth; 1 for groups made by hand */
} ts_review_item;

/** Teeth with a confidence under 0.9 or a warning, and groups without a tooth, those that need it most first. Of teeth
 *  above 0.9 the share that is right is in docs/accuracy.md. */
TS_API TS_NODISCARD ts_status ts_get_review(const ts_segmentation *segmentation, ts_review_item *items, uint32_t capacity,
                                            uint32_t *count);

/** "This too": a disc of seed_radius around `position` (mm, within click_reach of the surface) is held for the tooth, which
 *  is cut anew, as are separated teeth on which the disc lies. On a feature point of another tooth that point goes over to
 *  this one. Errors: TS_E_CLICK_OFF_SURFACE; TS_E_CLICK_ON_GINGIVA on what is gingiva for certain (gingiva_distance);
 *  TS_E_NO_CHANGE where the point is held for the tooth already; TS_E_NO_CUT where no cut is left, or on the last
 *  point of another tooth; TS_E_LOCKED; TS_E_NOT_FOUND; TS_E_CANCELLED; usage. */
TS_API TS_NODISCARD ts_status ts_tooth_include(ts_segmentation *segmentation, uint32_t tooth, const double position[3],
                                               ts_job *job);

/** "Not this": the disc is held for the tooth that the field there is most of after this one, or for the gingiva where that
 *  has more. A feature point of the tooth that lies there is no longer used. Errors: as ts_tooth_include. */
TS_API TS_NODISCARD ts_status ts_tooth_exclude(ts_segmentation *segmentation, uint32_t tooth, const double position[3],
                                               ts_job *job);

/** Two teeth of one: of its points those nearer to `part` than to `keep` go to a new group, and a disc at each of the two
 *  positions is held for its own. `second` out, may be NULL: id of the new tooth. Errors: as ts_tooth_include. */
TS_API TS_NODISCARD ts_status ts_tooth_split(ts_segmentation *segmentation, uint32_t tooth, const double keep[3],
                                             const double part[3], ts_job *job, uint32_t *second);

/** Moves a feature point of the tooth: the one that lies at `from` is no longer used, and a disc of seed_radius around `to` is
 *  held instead; both in mm, within click_reach of the surface. The tooth is cut anew, as are separated teeth on which the
 *  disc lies. Errors: TS_E_NO_CHANGE where no point of the tooth lies at `from`, or one lies at `to` already; TS_E_NO_CUT
 *  also where what is held for another tooth lies at `to`; else as ts_tooth_include. */
TS_API TS_NODISCARD ts_status ts_tooth_move_point(ts_segmentation *segmentation, uint32_t tooth, const double from[3],
                                                  const double to[3], ts_job *job);

/** One tooth of two: the points of `other` are held for `tooth`, and `other` is no tooth any more. Errors: TS_E_NO_CUT,
 *  TS_E_NO_CHANGE where both are the same, TS_E_LOCKED, TS_E_NOT_FOUND, TS_E_CANCELLED, usage. */
TS_API TS_NODISCARD ts_status ts_tooth_merge(ts_segmentation *segmentation, uint32_t tooth, uint32_t other, ts_job *job);

/** The tooth is as if it had not been separated; its group stays. Errors: TS_E_LOCKED, TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_tooth_remove(ts_segmentation *segmentation, uint32_t tooth);

/** `locked` 1: nothing changes the tooth until it is unlocked (0): a click on it is refused (TS_E_LOCKED), and as a
 *  neighbour it is left as it is. Errors: TS_E_NO_CHANGE where it is so already, TS_E_NOT_FOUND, usage. */
TS_API TS_NODISCARD ts_status ts_tooth_set_locked(ts_segmentation *segmentation, uint32_t tooth, uint32_t locked);

/** `locked` out: 1 or 0. Errors: TS_E_NOT_FOUND, TS_E_NULL. */
TS_API TS_NODISCARD ts_status ts_tooth_get_locked(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *locked);

/** Faces that two teeth hold. In ts_get_labels they go to the tooth that is locked, or, where neither or both are, to the
 *  one whose nearest seed is nearer to the middle of the face; ts_get_tooth_faces has them for both. */
typedef struct ts_overlap {
  uint32_t winner; /**< id of the tooth that they go to */
  uint32_t loser;  /**< id of the other one */
  uint32_t faces;  /**< of the model */
  uint32_t reserved; /**< 0 */
  double area; /**< mm^2 */
} ts_overlap;

/** All of them, by pairs of teeth. Errors: TS_E_NULL, TS_E_BUFFER_TOO_SMALL. */
TS_API TS_NODISCARD ts_status ts_get_overlaps(const ts_segmentation *segmentation, ts_overlap *overlaps, uint32_t capacity,
                                              uint32_t *count);

/** Takes back the last step: the teeth, clicks and groups are then, byte for byte, what they were. Errors: TS_E_NO_HISTORY,
 *  usage. */
TS_API TS_NODISCARD ts_status ts_undo(ts_segmentation *segmentation);

/** Brings again the step that was taken back last. A new step forgets those. Errors: TS_E_NO_HISTORY, usage. */
TS_API TS_NODISCARD ts_status ts_redo(ts_segmentation *segmentation);

/** The steps that are kept. */
typedef struct ts_history_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t undo;     /**< steps that can be taken back */
  uint32_t redo;     /**< steps that can be brought again */
  uint32_t complete; /**< 1: back to the beginning; 0: the limit has dropped the oldest */
  uint64_t bytes;    /**< about what the steps keep */
  uint64_t limit;    /**< how much they may (ts_set_history_limit) */
} ts_history_info;

/** `info->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_history(const ts_segmentation *segmentation, ts_history_info *info);

/** How many bytes the steps may keep; the oldest are dropped over it, at once. 256 MiB unless set. */
TS_API TS_NODISCARD ts_status ts_set_history_limit(ts_segmentation *segmentation, uint64_t bytes);

/** Ids of the teeth that the last step, ts_undo or ts_redo changed: separated, cut anew, taken away, locked or unlocked. */
TS_API TS_NODISCARD ts_status ts_get_changes(const ts_segmentation *segmentation, uint32_t *teeth, uint32_t capacity,
                                             uint32_t *count);

/** Called on the thread of the call that changed something, after the change, with what ts_get_changes tells; `teeth` lives
 *  as long as the callback. It may read the segmentation and must not destroy it; calls that would change it are refused
 *  (TS_E_INVALID_ARGUMENT). */
typedef void (*ts_change_fn)(void *user, const uint32_t *teeth, uint32_t count);

/** `callback` NULL: none. Errors: TS_E_NULL. */
TS_API TS_NODISCARD ts_status ts_set_change_callback(ts_segmentation *segmentation, ts_change_fn callback, void *user);

/** The session as JSON (docs/session-file.md): a hash of the mesh, features, options, every step and how many of them are
 *  taken back; no surface, no tooth. The two-call idiom; `text` is UTF-8 without a final 0. */
TS_API TS_NODISCARD ts_status ts_session_write(const ts_segmentation *segmentation, char *text, uint32_t capacity,
                                               uint32_t *count);

/** The same into a file, which is there whole or, where the call fails, as it was. Errors: TS_E_FILE_WRITE, usage. */
TS_API TS_NODISCARD ts_status ts_session_save(const ts_segmentation *segmentation, const char *path);

/** Goes through the steps of a session again, on the model that it was of; what comes out goes on as the one that was
 *  written would. `features` out, may be NULL: as they were, to be destroyed by the caller. Only steps that can still be
 *  undone when the limit is 256 MiB can be. Errors: TS_E_MISMATCH where the model is another mesh, or what the library makes
 *  of a step is no longer what it was; TS_E_FILE_NEWER, TS_E_FILE_FORMAT (no session), TS_E_FILE_TRUNCATED,
 *  TS_E_FILE_SYNTAX (with the place), TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. */
TS_API TS_NODISCARD ts_status ts_session_read(const ts_model *model, const char *text, size_t size, ts_job *job,
                                              ts_features **features, ts_segmentation **out);

/** The same from a file. Errors: TS_E_FILE_OPEN, and as ts_session_read. */
TS_API TS_NODISCARD ts_status ts_session_load(const ts_model *model, const char *path, ts_job *job, ts_features **features,
                                              ts_segmentation **out);

/* --------------------------------------------------------------------------------------------------------- numbers */

/** The jaw of a scan. */
typedef enum ts_jaw {
  TS_JAW_UNKNOWN = 0, /**< not known */
  TS_JAW_UPPER = 1,   /**< maxilla */
  TS_JAW_LOWER = 2,   /**< mandible */
  TS_JAW_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_jaw;

/** How numbers are told. */
typedef struct ts_number_options {
  uint32_t struct_size; /**< set by ts_number_options_init */
  ts_jaw jaw;              /**< UNKNOWN (default): estimated */
  uint32_t mirrored;       /**< 1: the scan is a mirror image of the patient, so left and right change places. No scan
                                shows whether it is one. Default 0 */
  uint32_t reserved; /**< 0 */
  double least_confidence; /**< 0 to 1: a number or a jaw under it is uncertain. Default 0.9 */
} ts_number_options;

/** Fills `options` with the defaults. `struct_size`: sizeof(ts_number_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
 *  Thread: any. */
TS_API TS_NODISCARD ts_status ts_number_options_init(ts_number_options *options, uint32_t struct_size);

/** Gives the teeth of a segmentation their FDI numbers: all feature groups in use and all groups made by clicks,
 *  separated or not (separated crowns are measured, which tells more). Permanent teeth only. The numbers rise along the
 *  arch; missing teeth leave theirs out. Told from widths and depths of the teeth, their places along the arch, the
 *  gaps between them and how their feature points lie; the patient's right from the occlusal direction and the side to
 *  which the arch bends. Coordinates are taken to be right-handed; which way faces look has no say.
 *
 *  Numbers that were set by hand stay, and decide. Numbers do not change by themselves: call again after clicks.
 *  `options` in, may be NULL: the defaults; kept for ts_set_number.
 *  Errors, with all numbers as they were: TS_E_TOO_MANY_TEETH (over 16), TS_E_NUMBER_JAW (a number set by hand is of
 *  the other jaw than `options` give), TS_E_NUMBER_ORDER (those set fit no numbering), TS_E_INVALID_ARGUMENT (also
 *  where the features have no occlusal direction, or the line along the teeth is over 1000 mm long: a mesh in other
 *  units than it says), TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_OUT_OF_MEMORY. */
TS_API TS_NODISCARD ts_status ts_assign_numbers(ts_segmentation *segmentation, const ts_number_options *options);

/** Sets the number of a tooth by hand; those of the others follow, and so does the jaw. `tooth`: id of its group (that of
 *  its feature group, as ts_tooth_info::id), separated or not. `fdi`: 11 to 18, 21 to 28, 31 to 38, 41 to 48; 0 forgets
 *  one that was set. Works before ts_assign_numbers too, with its default options.
 *  Errors, with all numbers as they were: TS_E_NOT_FOUND (no such tooth; 0 where none was set), TS_E_INVALID_ARGUMENT
 *  (no FDI number of a permanent tooth), TS_E_NUMBER_JAW (of the other jaw than was given or set), TS_E_NUMBER_TAKEN
 *  (set for another tooth), TS_E_NUMBER_ORDER (breaks the order along the arch, or leaves too few numbers between),
 *  TS_E_TOO_MANY_TEETH, TS_E_NULL, TS_E_OUT_OF_MEMORY. */
TS_API TS_NODISCARD ts_status ts_set_number(ts_segmentation *segmentation, uint32_t tooth, uint32_t fdi);

/** The number of a tooth. */
typedef struct ts_number_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t fdi;         /**< the most probable, also where it is uncertain */
  uint32_t set_by_hand; /**< 1: by ts_set_number */
  uint32_t uncertain;   /**< 1: confidence under least_confidence: to be shown to a person before it is used */
  double confidence;    /**< probability of this number, the jaw's included, under the model; 1 if set by hand */
} ts_number_info;

/** `tooth`: id of its group. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND (no number was assigned to it),
 *  TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_number(const ts_segmentation *segmentation, uint32_t tooth, ts_number_info *info);

/** The jaw that the numbers are of. */
typedef struct ts_jaw_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  ts_jaw jaw;         /**< the more probable, also where it is uncertain */
  uint32_t given;     /**< 1: by the options or by a number set by hand */
  uint32_t uncertain; /**< 1: confidence under least_confidence */
  double confidence;  /**< .5 where nothing tells; 1 if given */
} ts_jaw_info;

/** `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND (no numbers were assigned), TS_E_NULL, TS_E_STRUCT_SIZE. */
TS_API TS_NODISCARD ts_status ts_get_jaw(const ts_segmentation *segmentation, ts_jaw_info *info);

/** FDI to Universal: 1 to 32 from the upper right third molar to the upper left, on from the lower left to the lower
 *  right. Errors: TS_E_INVALID_ARGUMENT (no number of a permanent tooth), TS_E_NULL. Thread: any. */
TS_API TS_NODISCARD ts_status ts_fdi_to_universal(uint32_t fdi, uint32_t *universal);

/** And back. Errors and threads: as ts_fdi_to_universal. */
TS_API TS_NODISCARD ts_status ts_universal_to_fdi(uint32_t universal, uint32_t *fdi);

/** A number as Palmer's notation has it. */
typedef struct ts_palmer {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t quadrant; /**< as in FDI: 1 upper right, 2 upper left, 3 lower left, 4 lower right */
  uint32_t position; /**< 1 (central incisor) to 8 */
  char letters[4];   /**< "UR6" */
  char symbol[8];    /**< UTF-8: the position in the angle of its quadrant, as on a chart that faces the patient */
} ts_palmer;

/** `palmer->struct_size` in, the rest out. Errors: TS_E_INVALID_ARGUMENT (no FDI number of a permanent tooth), TS_E_NULL,
 *  TS_E_STRUCT_SIZE. Thread: any. */
TS_API TS_NODISCARD ts_status ts_fdi_to_palmer(uint32_t fdi, ts_palmer *palmer);

/* ---------------------------------------------------------------------------------------------------- edit the cut */

/* Corrections of a tooth's cut by hand. What they have in common:
 *   After each the cut is closed where it was, crosses no triangle twice, and lies on edges of the mesh; faces, vertices,
 *   area, warnings, gradient, concavity and confidence of the tooth are those of the new cut. A face that the new cut
 *   crosses belongs to the tooth with more than half of its area within; faces further away stay. The iso-value stays that
 *   of the click. Other teeth are not changed: where two come to overlap, ts_get_labels decides.
 *   The edits of a tooth are kept. When it is separated again by another click they are applied to the new cut, in their
 *   order; one that cannot be is dropped, which the log and ts_get_cut_edits say.
 *   Each needs the segmentation to itself and takes about as long as a click. `job` may be NULL.
 *   Errors of all: TS_E_NULL, TS_E_NOT_FOUND (no such tooth), TS_E_INVALID_ARGUMENT (not finite, out of range),
 *   TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, and the TS_E_EDIT_... that are named. */

/** Takes a point of the cut to another place on the surface. A stretch around the point follows, along the cheapest way
 *  through the new place in the prices of the minimum cut, which run along the bottoms of valleys; smoothed as the cut
 *  of a click is. All points outside the stretch stay the same to the bit. On an open loop the ends stay, too.
 *  `loop`, `point`: index of the point as ts_get_cut gives it; afterwards the points may have other indices. `to`: mm,
 *  taken to the nearest surface point. `reach`: half the length of the stretch along the cut, mm; 0: as long as the drag,
 *  and at least 2.5, as far as the minimum cut looks for a valley; at most 0.4 of the loop is taken.
 *  Errors: TS_E_NOT_FOUND (no such loop or point), TS_E_CLICK_OFF_SURFACE (further than click_reach), TS_E_EDIT_NOTHING
 *  (under 0.01 mm), TS_E_EDIT_ON_TOOTH, TS_E_EDIT_CROSSING, TS_E_EDIT_NO_LOOP. */
TS_API TS_NODISCARD ts_status ts_cut_drag(ts_segmentation *segmentation, uint32_t tooth, uint32_t loop, uint32_t point,
                                          const double to[3], double reach, ts_job *job);

/** Draws a stretch of the cut: `count` points, at least 2, of 3 doubles, mm, taken to the surface and joined by shortest
 *  ways along it, the first and the last to the points of the cut that are nearest to them and have to be within
 *  click_reach. Of the two pieces of the loop between these the shorter one is replaced (of an open loop the one between
 *  them); the other stays the same to the bit. Corners are rounded only as far as the triangle that they lie in. Where
 *  the stroke crosses itself the loop is left out.
 *  Errors: TS_E_CLICK_OFF_SURFACE, TS_E_EDIT_OFF_CUT, TS_E_EDIT_NOTHING, TS_E_EDIT_ON_TOOTH, TS_E_EDIT_CROSSING (also
 *  where no short way along the surface leads from one point to the next), TS_E_EDIT_NO_LOOP. */
TS_API TS_NODISCARD ts_status ts_cut_draw(ts_segmentation *segmentation, uint32_t tooth, const double *points,
                                          uint32_t count, ts_job *job);

/** Moves the whole cut along the surface by `mm`, outwards where positive: to where the distance along the surface from
 *  the cut is that. What comes off or is enclosed by it up to 1 mm^2, and loops up to 3.5 mm long, are
 *  let go; open lines may come off the rim of the scan.
 *  Errors: TS_E_EDIT_NOTHING (0), TS_E_EDIT_NO_LOOP (also where feature points of the tooth would be left out),
 *  TS_E_EDIT_ON_TOOTH. */
TS_API TS_NODISCARD ts_status ts_cut_offset(ts_segmentation *segmentation, uint32_t tooth, double mm, ts_job *job);

/** Smooths the whole cut: what bends within less than `strength`, mm, over 0 to 2, is straightened. The cut of a click is
 *  smoothed with smooth_radius already. Errors: TS_E_EDIT_NO_LOOP, TS_E_EDIT_CROSSING. */
TS_API TS_NODISCARD ts_status ts_cut_smooth(ts_segmentation *segmentation, uint32_t tooth, double strength, ts_job *job);

/** Gives the tooth the cut of its click again and forgets its edits. TS_OK also where there are none. */
TS_API TS_NODISCARD ts_status ts_cut_reset(ts_segmentation *segmentation, uint32_t tooth);

/** What an edit did. */
typedef enum ts_edit_kind {
  TS_EDIT_DRAG = 1,   /**< ts_cut_drag */
  TS_EDIT_DRAW = 2,   /**< ts_cut_draw */
  TS_EDIT_OFFSET = 3, /**< ts_cut_offset */
  TS_EDIT_SMOOTH = 4, /**< ts_cut_smooth */
  TS_EDIT_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_edit_kind;

/** An edit that is kept. */
typedef struct ts_cut_edit {
  ts_edit_kind kind; /**< which of them */
  ts_status status;  /**< TS_OK: it shows in the cut; else why it was dropped when the tooth was last separated again. A
                          dropped edit is tried again the next time */
  uint32_t points;   /**< 2 of a drag, those of a stroke, 0 of the others */
  uint32_t reserved; /**< 0 */
  double amount;     /**< reach, mm or strength as given; 0 of a stroke */
  double from[3];    /**< of a drag where the cut was taken, of a stroke its first point, mm */
  double to[3];      /**< of a drag where it was taken to, of a stroke its last point, mm */
} ts_cut_edit;

/** The edits of a tooth since the click, or the last ts_cut_reset, in their order. Const handle.
 *  Errors: TS_E_NULL, TS_E_NOT_FOUND, TS_E_BUFFER_TOO_SMALL. */
TS_API TS_NODISCARD ts_status ts_get_cut_edits(const ts_segmentation *segmentation, uint32_t tooth, ts_cut_edit *edits,
                                               uint32_t capacity, uint32_t *count);

/* ------------------------------------------------------------------------------ meshes of teeth and gingiva, files */

/** A tooth, or the gingiva, as a mesh of its own, cut exactly along the cuts of the teeth: triangles that a cut crosses are
 *  split on it. What a tooth's cuts enclose is its own; where the cuts of several teeth enclose the same, it is that of the
 *  tooth with the nearest constraint point (ts_get_tooth_seeds), as ts_get_labels has it for whole faces: the teeth meet
 *  where these are equally far, and ts_mesh_info::lost says how much that took off. The meshes of all teeth and of the
 *  gingiva, open, add up to the model, and vertices on cuts have the same coordinates in both meshes, bit for bit. They
 *  belong to the teeth separated when they are made. Never changes once made. */
typedef struct ts_mesh ts_mesh;

/** How meshes of teeth are made. */
typedef struct ts_tooth_mesh_options {
  uint32_t struct_size; /**< set by ts_tooth_mesh_options_init */
  uint32_t closed; /**< 1: all rims are closed by smooth membranes, those of the scan (holes, open ends) as well. Default 0 */
} ts_tooth_mesh_options;

/** Fills `options` with the defaults. `struct_size`: sizeof(ts_tooth_mesh_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
 *  Thread: any. */
TS_API TS_NODISCARD ts_status ts_tooth_mesh_options_init(ts_tooth_mesh_options *options, uint32_t struct_size);

/** Makes the mesh of a tooth. `tooth` an id of ts_get_teeth; `options` in, may be NULL; `out` out, owned by the caller.
 *  Errors: TS_E_NOT_FOUND (no such tooth), TS_E_NO_CUT (its cut does not part it from the rest, or other teeth leave nothing of
 *  it), TS_E_NOT_CLOSED, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. Thread: const. */
TS_API TS_NODISCARD ts_status ts_tooth_mesh_create(const ts_segmentation *segmentation, uint32_t tooth,
                                                   const ts_tooth_mesh_options *options, ts_job *job, ts_mesh **out);

/** Makes the mesh of what belongs to no tooth separated so far: gingiva, base, and teeth not separated. Closed, its sockets
 *  and the rims of the scan are. Otherwise as ts_tooth_mesh_create. */
TS_API TS_NODISCARD ts_status ts_gingiva_mesh_create(const ts_segmentation *segmentation,
                                                     const ts_tooth_mesh_options *options, ts_job *job, ts_mesh **out);

/** Gives a mesh back; NULL is fine. */
TS_API void ts_mesh_destroy(ts_mesh *mesh);

/** Counts and measures of a mesh. */
typedef struct ts_mesh_info {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t label;          /**< ts_tooth_info::label, 0 of the gingiva */
  uint32_t vertices;       /**< number of vertices */
  uint32_t triangles;      /**< number of triangles */
  uint32_t fill_triangles; /**< of these, at the end: those that close it */
  uint32_t cut_vertices;   /**< that it shares with other parts */
  uint32_t open_rims;      /**< 0: watertight */
  uint32_t closed_rims;    /**< rims that were closed */
  uint32_t components;     /**< connected pieces */
  uint32_t trimmed;        /**< triangles left out at its rims, because the scan crosses itself there, or every membrane
                                would cross them; only of closed meshes, up to 3 % of the area */
  double area;             /**< of all triangles, mm^2 */
  double fill_area;        /**< of those that close it, mm^2 */
  double volume;           /**< mm^3; 0 while a rim is open */
  double lost;             /**< of a tooth: what its cuts enclose and another tooth or the gingiva has, mm^2 */
} ts_mesh_info;

/** `info->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: const. */
TS_API TS_NODISCARD ts_status ts_mesh_get_info(const ts_mesh *mesh, ts_mesh_info *info);

/** Vertices: `xyz` 3 doubles a vertex, mm; `capacity` and `count` in vertices. Errors: TS_E_NULL, TS_E_BUFFER_TOO_SMALL.
 *  Thread: const. */
TS_API TS_NODISCARD ts_status ts_mesh_get_positions(const ts_mesh *mesh, double *xyz, uint32_t capacity, uint32_t *count);

/** Unit normals of the vertices, outwards: 3 doubles a vertex; 0, 0, 0 where the triangles around cancel out. Otherwise as
 *  ts_mesh_get_positions. */
TS_API TS_NODISCARD ts_status ts_mesh_get_normals(const ts_mesh *mesh, double *xyz, uint32_t capacity, uint32_t *count);

/** Triangles: 3 vertex indices each, counter-clockwise seen from outside, also where the faces of the scan look inwards;
 *  `capacity` and `count` in triangles. Otherwise as ts_mesh_get_positions. */
TS_API TS_NODISCARD ts_status ts_mesh_get_triangles(const ts_mesh *mesh, uint32_t *triangles, uint32_t capacity,
                                                    uint32_t *count);

/** For each triangle the model face that it is of, TS_NONE for those that close the mesh. Otherwise as
 *  ts_mesh_get_triangles. */
TS_API TS_NODISCARD ts_status ts_mesh_get_faces(const ts_mesh *mesh, uint32_t *faces, uint32_t capacity, uint32_t *count);

/** What a vertex is. */
typedef enum ts_mesh_vertex_flag {
  TS_VERTEX_ON_CUT = 1,  /**< shared with another part */
  TS_VERTEX_ON_RIM = 2,  /**< on a rim of the scan */
  TS_VERTEX_OF_FILL = 4, /**< made to close the mesh */
  TS_VERTEX_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_mesh_vertex_flag;

/** For each vertex a sum of ts_mesh_vertex_flag. Otherwise as ts_mesh_get_positions. */
TS_API TS_NODISCARD ts_status ts_mesh_get_vertex_flags(const ts_mesh *mesh, uint8_t *flags, uint32_t capacity,
                                                       uint32_t *count);

/** Formats that are written. */
typedef enum ts_output_format {
  TS_OUTPUT_STL = 0, /**< binary; floats */
  TS_OUTPUT_PLY = 1, /**< binary; floats; red, green, blue (uchar) and label (int) a triangle */
  TS_OUTPUT_OBJ = 2, /**< a group a part, of shared vertices */
  TS_OUTPUT_GLB = 3, /**< glTF 2.0 binary, in m as it has to be: a mesh and a node a part, floats */
  TS_OUTPUT_FORCE_INT = 0x7fffffff /**< no value: makes the enum 32 bits wide */
} ts_output_format;

/** Writes a mesh to a file. `path`: UTF-8; it is written to a temporary file beside it and renamed, so that nothing is left half
 *  written, and what was there stays if it fails. Parts are named tooth_LABEL and gingiva in formats with names.
 *  Errors: TS_E_FILE_WRITE (the message says why: disk full, no such directory, not a regular file, ...),
 *  TS_E_INVALID_ARGUMENT, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, TS_E_NULL. Thread: const. */
TS_API TS_NODISCARD ts_status ts_mesh_save(const ts_mesh *mesh, const char *path, ts_output_format format, ts_job *job);

/** How a segmentation is written. */
typedef struct ts_save_options {
  uint32_t struct_size; /**< set by ts_save_options_init */
  uint32_t whole_faces; /**< 1: the model's faces as they are, each of the tooth that ts_get_labels says. Default 0: split
                             along the cuts */
} ts_save_options;

/** Fills `options` with the defaults. As ts_tooth_mesh_options_init. */
TS_API TS_NODISCARD ts_status ts_save_options_init(ts_save_options *options, uint32_t struct_size);

/** Writes the whole scan with its teeth: colours and labels (PLY), a group (OBJ) or a node (GLB) a tooth and one for the
 *  gingiva; STL has the triangles alone. `options` in, may be NULL. Errors: those of ts_mesh_save, and TS_E_NO_CUT.
 *  Thread: const. */
TS_API TS_NODISCARD ts_status ts_segmentation_save(const ts_segmentation *segmentation, const char *path,
                                                   ts_output_format format, const ts_save_options *options, ts_job *job);

/** Which way a tooth looks, and its extent that way over the faces of ts_get_tooth_faces. */
typedef struct ts_tooth_frame {
  uint32_t struct_size; /**< in: sizeof this struct */
  uint32_t from_arch;  /**< 1: mesial is along the arch curve; 0: there is none (features made by hand), and mesial is the
                            direction in which the tooth is widest, to either side */
  double centre[3];    /**< of the area of its faces, mm */
  double occlusal[3];  /**< unit vector: that of the features */
  double mesial[3];    /**< unit vector along the arch, at right angles to occlusal, towards the middle of the arch curve's
                            length: the midline, where the scan is of a whole arch */
  double buccal[3];    /**< unit vector at right angles to both, away from the middle between the ends of the arch */
  double width;        /**< mesial-distal extent, mm */
  double depth;        /**< buccal-lingual extent, mm */
  double height;       /**< occlusal-gingival extent of what the scan shows of the crown, mm */
} ts_tooth_frame;

/** `frame->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_INVALID_ARGUMENT (the features have no occlusal
 *  direction), TS_E_NULL, TS_E_STRUCT_SIZE. Thread: const. */
TS_API TS_NODISCARD ts_status ts_get_tooth_frame(const ts_segmentation *segmentation, uint32_t tooth, ts_tooth_frame *frame);

#ifdef __cplusplus
}
#endif

#endif /* TOOTHSEG_H */
