// SPDX-License-Identifier: Apache-2.0
// Made by bindings/rust/generate.py from abi/toothseg.json, version 0.1.0. Not to be edited.

use std::marker::PhantomData;
use std::os::raw::{c_char, c_int, c_void};

pub const TS_VERSION_MAJOR: u32 = 0;
pub const TS_VERSION_MINOR: u32 = 1;
pub const TS_VERSION_PATCH: u32 = 0;
pub const TS_NONE: u32 = 4294967295;

/// What came of a call. Values are fixed for ever; new ones are added within their block.
pub type ts_status = u32;
/// done
pub const TS_OK: ts_status = 0;
/// a value outside its stated range
pub const TS_E_INVALID_ARGUMENT: ts_status = 100;
/// a pointer that must not be NULL is
pub const TS_E_NULL: ts_status = 101;
/// struct_size is 0, or no size that any release had
pub const TS_E_STRUCT_SIZE: ts_status = 102;
/// capacity is less than the number of elements
pub const TS_E_BUFFER_TOO_SMALL: ts_status = 103;
/// no such group, point, click, tooth, loop or contour
pub const TS_E_NOT_FOUND: ts_status = 104;
/// objects that do not belong together (features of another model)
pub const TS_E_MISMATCH: ts_status = 105;
/// an allocation failed, or memory_limit is too small for any way of work
pub const TS_E_OUT_OF_MEMORY: ts_status = 200;
/// the job was cancelled, by ts_job_cancel or its callback
pub const TS_E_CANCELLED: ts_status = 201;
/// a fault in the library: please report the message
pub const TS_E_INTERNAL: ts_status = 202;
/// cannot be opened or read
pub const TS_E_FILE_OPEN: ts_status = 300;
/// not STL, PLY, OBJ or OFF, or a variant that is not read
pub const TS_E_FILE_FORMAT: ts_status = 301;
/// ends before what its header or its last statement promises
pub const TS_E_FILE_TRUNCATED: ts_status = 302;
/// goes on after what its header promises
pub const TS_E_FILE_TRAILING: ts_status = 303;
/// a count that the file's size contradicts
pub const TS_E_FILE_COUNT: ts_status = 304;
/// text where a number or keyword belongs; the message has the line
pub const TS_E_FILE_SYNTAX: ts_status = 305;
/// cannot be written; nothing is left half written
pub const TS_E_FILE_WRITE: ts_status = 306;
/// a session of a later format than this library reads
pub const TS_E_FILE_NEWER: ts_status = 307;
/// no face, or none that is not degenerate
pub const TS_E_MESH_EMPTY: ts_status = 400;
/// NaN or infinity among the coordinates
pub const TS_E_MESH_NON_FINITE: ts_status = 401;
/// a triangle names a vertex that is not there
pub const TS_E_MESH_INDEX_RANGE: ts_status = 402;
/// too small or too large for a scan in mm: probably in other units
pub const TS_E_MESH_UNITS: ts_status = 403;
/// more than 2^30 faces or vertices, or coordinates beyond 1e9 mm
pub const TS_E_MESH_TOO_LARGE: ts_status = 404;
/// nothing on the mesh looks like a tooth
pub const TS_E_NO_TEETH: ts_status = 500;
/// no group with a point: there is nothing to separate
pub const TS_E_NO_CONSTRAINT: ts_status = 501;
/// the click is further from the surface than click_reach
pub const TS_E_CLICK_OFF_SURFACE: ts_status = 600;
/// the click lies on gingiva or base, not on a tooth
pub const TS_E_CLICK_ON_GINGIVA: ts_status = 601;
/// no contour of the field separates the tooth
pub const TS_E_NO_CUT: ts_status = 602;
/// the linear system could not be factorised
pub const TS_E_SOLVER: ts_status = 603;
/// the tooth is locked, and the call would change it
pub const TS_E_LOCKED: ts_status = 604;
/// what is asked for is so already
pub const TS_E_NO_CHANGE: ts_status = 605;
/// nothing to undo, or to redo
pub const TS_E_NO_HISTORY: ts_status = 606;
/// the edit would change nothing: a drag to where the point is, a stroke of no length
pub const TS_E_EDIT_NOTHING: ts_status = 650;
/// the new line would run on another tooth, or take in its feature points
pub const TS_E_EDIT_ON_TOOTH: ts_status = 651;
/// the new line would cross the rest of the cut, or part the tooth's feature points from it
pub const TS_E_EDIT_CROSSING: ts_status = 652;
/// the edit does not come near the cut that it is to change
pub const TS_E_EDIT_OFF_CUT: ts_status = 653;
/// a loop of the cut would vanish, or become several
pub const TS_E_EDIT_NO_LOOP: ts_status = 654;
/// more teeth along the arch than the 16 that a jaw has
pub const TS_E_TOO_MANY_TEETH: ts_status = 700;
/// a number of the other jaw
pub const TS_E_NUMBER_JAW: ts_status = 701;
/// the number has been set for another tooth
pub const TS_E_NUMBER_TAKEN: ts_status = 702;
/// numbers would not rise along the arch, or leave none for the teeth between
pub const TS_E_NUMBER_ORDER: ts_status = 703;
/// a rim cannot be closed without the mesh running through itself
pub const TS_E_NOT_CLOSED: ts_status = 750;
/// no value: makes the enum 32 bits wide
pub const TS_STATUS_FORCE_INT: ts_status = 2147483647;
/// The names and values of [`ts_status`].
pub const TS_STATUS_VALUES: &[(&str, ts_status)] = &[
    ("TS_OK", TS_OK),
    ("TS_E_INVALID_ARGUMENT", TS_E_INVALID_ARGUMENT),
    ("TS_E_NULL", TS_E_NULL),
    ("TS_E_STRUCT_SIZE", TS_E_STRUCT_SIZE),
    ("TS_E_BUFFER_TOO_SMALL", TS_E_BUFFER_TOO_SMALL),
    ("TS_E_NOT_FOUND", TS_E_NOT_FOUND),
    ("TS_E_MISMATCH", TS_E_MISMATCH),
    ("TS_E_OUT_OF_MEMORY", TS_E_OUT_OF_MEMORY),
    ("TS_E_CANCELLED", TS_E_CANCELLED),
    ("TS_E_INTERNAL", TS_E_INTERNAL),
    ("TS_E_FILE_OPEN", TS_E_FILE_OPEN),
    ("TS_E_FILE_FORMAT", TS_E_FILE_FORMAT),
    ("TS_E_FILE_TRUNCATED", TS_E_FILE_TRUNCATED),
    ("TS_E_FILE_TRAILING", TS_E_FILE_TRAILING),
    ("TS_E_FILE_COUNT", TS_E_FILE_COUNT),
    ("TS_E_FILE_SYNTAX", TS_E_FILE_SYNTAX),
    ("TS_E_FILE_WRITE", TS_E_FILE_WRITE),
    ("TS_E_FILE_NEWER", TS_E_FILE_NEWER),
    ("TS_E_MESH_EMPTY", TS_E_MESH_EMPTY),
    ("TS_E_MESH_NON_FINITE", TS_E_MESH_NON_FINITE),
    ("TS_E_MESH_INDEX_RANGE", TS_E_MESH_INDEX_RANGE),
    ("TS_E_MESH_UNITS", TS_E_MESH_UNITS),
    ("TS_E_MESH_TOO_LARGE", TS_E_MESH_TOO_LARGE),
    ("TS_E_NO_TEETH", TS_E_NO_TEETH),
    ("TS_E_NO_CONSTRAINT", TS_E_NO_CONSTRAINT),
    ("TS_E_CLICK_OFF_SURFACE", TS_E_CLICK_OFF_SURFACE),
    ("TS_E_CLICK_ON_GINGIVA", TS_E_CLICK_ON_GINGIVA),
    ("TS_E_NO_CUT", TS_E_NO_CUT),
    ("TS_E_SOLVER", TS_E_SOLVER),
    ("TS_E_LOCKED", TS_E_LOCKED),
    ("TS_E_NO_CHANGE", TS_E_NO_CHANGE),
    ("TS_E_NO_HISTORY", TS_E_NO_HISTORY),
    ("TS_E_EDIT_NOTHING", TS_E_EDIT_NOTHING),
    ("TS_E_EDIT_ON_TOOTH", TS_E_EDIT_ON_TOOTH),
    ("TS_E_EDIT_CROSSING", TS_E_EDIT_CROSSING),
    ("TS_E_EDIT_OFF_CUT", TS_E_EDIT_OFF_CUT),
    ("TS_E_EDIT_NO_LOOP", TS_E_EDIT_NO_LOOP),
    ("TS_E_TOO_MANY_TEETH", TS_E_TOO_MANY_TEETH),
    ("TS_E_NUMBER_JAW", TS_E_NUMBER_JAW),
    ("TS_E_NUMBER_TAKEN", TS_E_NUMBER_TAKEN),
    ("TS_E_NUMBER_ORDER", TS_E_NUMBER_ORDER),
    ("TS_E_NOT_CLOSED", TS_E_NOT_CLOSED),
];

/// How much a line of the log matters.
pub type ts_log_level = u32;
/// not used so far: a call that fails says so in its status
pub const TS_LOG_ERROR: ts_log_level = 0;
/// the call did its work, and something about it is odd
pub const TS_LOG_WARNING: ts_log_level = 1;
/// what was found and how long it took
pub const TS_LOG_INFO: ts_log_level = 2;
/// no value: makes the enum 32 bits wide
pub const TS_LOG_FORCE_INT: ts_log_level = 2147483647;
/// The names and values of [`ts_log_level`].
pub const TS_LOG_LEVEL_VALUES: &[(&str, ts_log_level)] = &[
    ("TS_LOG_ERROR", TS_LOG_ERROR),
    ("TS_LOG_WARNING", TS_LOG_WARNING),
    ("TS_LOG_INFO", TS_LOG_INFO),
];

/// Type of the caller's coordinates.
pub type ts_scalar = u32;
/// float
pub const TS_FLOAT32: ts_scalar = 0;
/// double
pub const TS_FLOAT64: ts_scalar = 1;
/// no value: makes the enum 32 bits wide
pub const TS_SCALAR_FORCE_INT: ts_scalar = 2147483647;
/// The names and values of [`ts_scalar`].
pub const TS_SCALAR_VALUES: &[(&str, ts_scalar)] = &[
    ("TS_FLOAT32", TS_FLOAT32),
    ("TS_FLOAT64", TS_FLOAT64),
];

/// Unit of the caller's coordinates. TS_UNIT_CHECKED_MM: mm, and TS_E_MESH_UNITS if the size of the mesh contradicts it (bounding box diagonal under 9 or over 400); the others convert without a check of the size, as long as coordinates stay within 1e9 mm. Distances of the library are of teeth in mm, whatever the size: on a surface over 400 mm across no teeth are found (TS_E_NO_TEETH), and parts under 0.5 mm are not closed (TS_E_NOT_CLOSED).
pub type ts_unit = u32;
/// mm, checked
pub const TS_UNIT_CHECKED_MM: ts_unit = 0;
/// mm, whatever the size
pub const TS_UNIT_MM: ts_unit = 1;
/// 10 mm
pub const TS_UNIT_CM: ts_unit = 2;
/// 1000 mm
pub const TS_UNIT_M: ts_unit = 3;
/// 25.4 mm
pub const TS_UNIT_INCH: ts_unit = 4;
/// no value: makes the enum 32 bits wide
pub const TS_UNIT_FORCE_INT: ts_unit = 2147483647;
/// The names and values of [`ts_unit`].
pub const TS_UNIT_VALUES: &[(&str, ts_unit)] = &[
    ("TS_UNIT_CHECKED_MM", TS_UNIT_CHECKED_MM),
    ("TS_UNIT_MM", TS_UNIT_MM),
    ("TS_UNIT_CM", TS_UNIT_CM),
    ("TS_UNIT_M", TS_UNIT_M),
    ("TS_UNIT_INCH", TS_UNIT_INCH),
];

/// Formats that are read.
pub type ts_file_format = u32;
/// told from the content, not from the name
pub const TS_FORMAT_AUTO: ts_file_format = 0;
/// binary or ASCII
pub const TS_FORMAT_STL: ts_file_format = 1;
/// ASCII, or binary of either byte order
pub const TS_FORMAT_PLY: ts_file_format = 2;
/// `v` and `f` lines; the rest is passed over
pub const TS_FORMAT_OBJ: ts_file_format = 3;
/// ASCII; [ST][C][N]OFF
pub const TS_FORMAT_OFF: ts_file_format = 4;
/// no value: makes the enum 32 bits wide
pub const TS_FORMAT_FORCE_INT: ts_file_format = 2147483647;
/// The names and values of [`ts_file_format`].
pub const TS_FILE_FORMAT_VALUES: &[(&str, ts_file_format)] = &[
    ("TS_FORMAT_AUTO", TS_FORMAT_AUTO),
    ("TS_FORMAT_STL", TS_FORMAT_STL),
    ("TS_FORMAT_PLY", TS_FORMAT_PLY),
    ("TS_FORMAT_OBJ", TS_FORMAT_OBJ),
    ("TS_FORMAT_OFF", TS_FORMAT_OFF),
];

/// What the detection found odd about the scan as a whole. Results are there all the same, and may be wrong or not all there is.
pub type ts_features_warning = u32;
/// the faces look inwards: harmless
pub const TS_WARN_FEATURES_INSIDE_OUT: ts_features_warning = 1;
/// teeth look both ways: two jaws in occlusion, or the direction is wrong
pub const TS_WARN_FEATURES_OPPOSED: ts_features_warning = 2;
/// much that is as rough as teeth lies off the arch, or the arch is longer than any jaw's: two jaws side by side
pub const TS_WARN_FEATURES_SEVERAL_ARCHES: ts_features_warning = 4;
/// no value: makes the enum 32 bits wide
pub const TS_WARN_FEATURES_FORCE_INT: ts_features_warning = 2147483647;
/// The names and values of [`ts_features_warning`].
pub const TS_FEATURES_WARNING_VALUES: &[(&str, ts_features_warning)] = &[
    ("TS_WARN_FEATURES_INSIDE_OUT", TS_WARN_FEATURES_INSIDE_OUT),
    ("TS_WARN_FEATURES_OPPOSED", TS_WARN_FEATURES_OPPOSED),
    ("TS_WARN_FEATURES_SEVERAL_ARCHES", TS_WARN_FEATURES_SEVERAL_ARCHES),
];

/// What options are initialised to.
pub type ts_preset = u32;
/// the best we know: docs/method.md
pub const TS_PRESET_DEFAULT: ts_preset = 0;
/// the paper to the letter
pub const TS_PRESET_PAPER: ts_preset = 1;
/// no value: makes the enum 32 bits wide
pub const TS_PRESET_FORCE_INT: ts_preset = 2147483647;
/// The names and values of [`ts_preset`].
pub const TS_PRESET_VALUES: &[(&str, ts_preset)] = &[
    ("TS_PRESET_DEFAULT", TS_PRESET_DEFAULT),
    ("TS_PRESET_PAPER", TS_PRESET_PAPER),
];

/// Weights of the Laplacian (paper, "Selection of weighting scheme"; Fig. 10).
pub type ts_weights = u32;
/// beta + (1 - beta) exp(-c / c0), c the concavity at a physical radius
pub const TS_WEIGHTS_CONCAVITY: ts_weights = 0;
/// Eq. 8 with the test of Eq. 9
pub const TS_WEIGHTS_PAPER: ts_weights = 1;
/// paper ref. 39, negative cotangents clamped
pub const TS_WEIGHTS_COTANGENT: ts_weights = 2;
/// 1
pub const TS_WEIGHTS_UNIFORM: ts_weights = 3;
/// feature-preserving, as paper ref. 40: Eq. 8 without its test, so that every bend counts, convex or concave (the paper does not print the formula of ref. 40)
pub const TS_WEIGHTS_FEATURE: ts_weights = 4;
/// no value: makes the enum 32 bits wide
pub const TS_WEIGHTS_FORCE_INT: ts_weights = 2147483647;
/// The names and values of [`ts_weights`].
pub const TS_WEIGHTS_VALUES: &[(&str, ts_weights)] = &[
    ("TS_WEIGHTS_CONCAVITY", TS_WEIGHTS_CONCAVITY),
    ("TS_WEIGHTS_PAPER", TS_WEIGHTS_PAPER),
    ("TS_WEIGHTS_COTANGENT", TS_WEIGHTS_COTANGENT),
    ("TS_WEIGHTS_UNIFORM", TS_WEIGHTS_UNIFORM),
    ("TS_WEIGHTS_FEATURE", TS_WEIGHTS_FEATURE),
];

/// What is held at the background value beside the neighbour tooth.
pub type ts_background = u32;
/// nothing: the paper's pair
pub const TS_BACKGROUND_NEIGHBOUR: ts_background = 0;
/// vertices far from every feature point
pub const TS_BACKGROUND_GINGIVA: ts_background = 1;
/// these, and the points of all other groups
pub const TS_BACKGROUND_ALL: ts_background = 2;
/// no value: makes the enum 32 bits wide
pub const TS_BACKGROUND_FORCE_INT: ts_background = 2147483647;
/// The names and values of [`ts_background`].
pub const TS_BACKGROUND_VALUES: &[(&str, ts_background)] = &[
    ("TS_BACKGROUND_NEIGHBOUR", TS_BACKGROUND_NEIGHBOUR),
    ("TS_BACKGROUND_GINGIVA", TS_BACKGROUND_GINGIVA),
    ("TS_BACKGROUND_ALL", TS_BACKGROUND_ALL),
];

/// How the contour of a tooth is chosen.
pub type ts_cut_rule = u32;
/// the paper's: largest mean gradient in [0, V_med] and (V_med, 1]
pub const TS_CUT_GRADIENT: ts_cut_rule = 0;
/// the component around the seeds with the best concavity x gradient, and a tooth's area
pub const TS_CUT_COMPONENT: ts_cut_rule = 1;
/// the contour half way between the tooth's value and the background's
pub const TS_CUT_HALF: ts_cut_rule = 2;
/// no value: makes the enum 32 bits wide
pub const TS_CUT_FORCE_INT: ts_cut_rule = 2147483647;
/// The names and values of [`ts_cut_rule`].
pub const TS_CUT_RULE_VALUES: &[(&str, ts_cut_rule)] = &[
    ("TS_CUT_GRADIENT", TS_CUT_GRADIENT),
    ("TS_CUT_COMPONENT", TS_CUT_COMPONENT),
    ("TS_CUT_HALF", TS_CUT_HALF),
];

/// What looks wrong about a tooth.
pub type ts_tooth_warning = u32;
/// under area_min
pub const TS_WARN_AREA_SMALL: ts_tooth_warning = 1;
/// over area_max
pub const TS_WARN_AREA_LARGE: ts_tooth_warning = 2;
/// the crown runs into a border of the scan
pub const TS_WARN_OPEN_AT_BORDER: ts_tooth_warning = 4;
/// the cut is not one closed line
pub const TS_WARN_SEVERAL_LOOPS: ts_tooth_warning = 8;
/// no neighbour was there to be background
pub const TS_WARN_NO_NEIGHBOUR: ts_tooth_warning = 16;
/// a feature point contradicted the field and was not used
pub const TS_WARN_SEED_REJECTED: ts_tooth_warning = 32;
/// wider or narrower along the arch than a tooth is, or than its stretch of the arch
pub const TS_WARN_WIDTH: ts_tooth_warning = 64;
/// a feature point of another group lies on it, before overlaps are resolved
pub const TS_WARN_TWO_GROUPS: ts_tooth_warning = 128;
/// its top is one plane: a scan body or a post, not a crown
pub const TS_WARN_FLAT_TOP: ts_tooth_warning = 256;
/// no feature group lies on it: the click alone says that it is a tooth
pub const TS_WARN_MADE_BY_CLICK: ts_tooth_warning = 512;
/// no value: makes the enum 32 bits wide
pub const TS_WARN_FORCE_INT: ts_tooth_warning = 2147483647;
/// The names and values of [`ts_tooth_warning`].
pub const TS_TOOTH_WARNING_VALUES: &[(&str, ts_tooth_warning)] = &[
    ("TS_WARN_AREA_SMALL", TS_WARN_AREA_SMALL),
    ("TS_WARN_AREA_LARGE", TS_WARN_AREA_LARGE),
    ("TS_WARN_OPEN_AT_BORDER", TS_WARN_OPEN_AT_BORDER),
    ("TS_WARN_SEVERAL_LOOPS", TS_WARN_SEVERAL_LOOPS),
    ("TS_WARN_NO_NEIGHBOUR", TS_WARN_NO_NEIGHBOUR),
    ("TS_WARN_SEED_REJECTED", TS_WARN_SEED_REJECTED),
    ("TS_WARN_WIDTH", TS_WARN_WIDTH),
    ("TS_WARN_TWO_GROUPS", TS_WARN_TWO_GROUPS),
    ("TS_WARN_FLAT_TOP", TS_WARN_FLAT_TOP),
    ("TS_WARN_MADE_BY_CLICK", TS_WARN_MADE_BY_CLICK),
];

/// The jaw of a scan.
pub type ts_jaw = u32;
/// not known
pub const TS_JAW_UNKNOWN: ts_jaw = 0;
/// maxilla
pub const TS_JAW_UPPER: ts_jaw = 1;
/// mandible
pub const TS_JAW_LOWER: ts_jaw = 2;
/// no value: makes the enum 32 bits wide
pub const TS_JAW_FORCE_INT: ts_jaw = 2147483647;
/// The names and values of [`ts_jaw`].
pub const TS_JAW_VALUES: &[(&str, ts_jaw)] = &[
    ("TS_JAW_UNKNOWN", TS_JAW_UNKNOWN),
    ("TS_JAW_UPPER", TS_JAW_UPPER),
    ("TS_JAW_LOWER", TS_JAW_LOWER),
];

/// What an edit did.
pub type ts_edit_kind = u32;
/// ts_cut_drag
pub const TS_EDIT_DRAG: ts_edit_kind = 1;
/// ts_cut_draw
pub const TS_EDIT_DRAW: ts_edit_kind = 2;
/// ts_cut_offset
pub const TS_EDIT_OFFSET: ts_edit_kind = 3;
/// ts_cut_smooth
pub const TS_EDIT_SMOOTH: ts_edit_kind = 4;
/// no value: makes the enum 32 bits wide
pub const TS_EDIT_FORCE_INT: ts_edit_kind = 2147483647;
/// The names and values of [`ts_edit_kind`].
pub const TS_EDIT_KIND_VALUES: &[(&str, ts_edit_kind)] = &[
    ("TS_EDIT_DRAG", TS_EDIT_DRAG),
    ("TS_EDIT_DRAW", TS_EDIT_DRAW),
    ("TS_EDIT_OFFSET", TS_EDIT_OFFSET),
    ("TS_EDIT_SMOOTH", TS_EDIT_SMOOTH),
];

/// What a vertex is.
pub type ts_mesh_vertex_flag = u32;
/// shared with another part
pub const TS_VERTEX_ON_CUT: ts_mesh_vertex_flag = 1;
/// on a rim of the scan
pub const TS_VERTEX_ON_RIM: ts_mesh_vertex_flag = 2;
/// made to close the mesh
pub const TS_VERTEX_OF_FILL: ts_mesh_vertex_flag = 4;
/// no value: makes the enum 32 bits wide
pub const TS_VERTEX_FORCE_INT: ts_mesh_vertex_flag = 2147483647;
/// The names and values of [`ts_mesh_vertex_flag`].
pub const TS_MESH_VERTEX_FLAG_VALUES: &[(&str, ts_mesh_vertex_flag)] = &[
    ("TS_VERTEX_ON_CUT", TS_VERTEX_ON_CUT),
    ("TS_VERTEX_ON_RIM", TS_VERTEX_ON_RIM),
    ("TS_VERTEX_OF_FILL", TS_VERTEX_OF_FILL),
];

/// Formats that are written.
pub type ts_output_format = u32;
/// binary; floats
pub const TS_OUTPUT_STL: ts_output_format = 0;
/// binary; floats; red, green, blue (uchar) and label (int) a triangle
pub const TS_OUTPUT_PLY: ts_output_format = 1;
/// a group a part, of shared vertices
pub const TS_OUTPUT_OBJ: ts_output_format = 2;
/// glTF 2.0 binary, in m as it has to be: a mesh and a node a part, floats
pub const TS_OUTPUT_GLB: ts_output_format = 3;
/// no value: makes the enum 32 bits wide
pub const TS_OUTPUT_FORCE_INT: ts_output_format = 2147483647;
/// The names and values of [`ts_output_format`].
pub const TS_OUTPUT_FORMAT_VALUES: &[(&str, ts_output_format)] = &[
    ("TS_OUTPUT_STL", TS_OUTPUT_STL),
    ("TS_OUTPUT_PLY", TS_OUTPUT_PLY),
    ("TS_OUTPUT_OBJ", TS_OUTPUT_OBJ),
    ("TS_OUTPUT_GLB", TS_OUTPUT_GLB),
];

/// Holds the hooks (allocator, log, threads) for all objects made from it.
#[repr(C)]
pub struct ts_context {
    _opaque: [u8; 0],
    _neither_send_nor_sync: PhantomData<*mut u8>,
}

/// Progress and cancellation of one long call at a time. Every long call takes a ts_job pointer, which may be NULL.
#[repr(C)]
pub struct ts_job {
    _opaque: [u8; 0],
    _neither_send_nor_sync: PhantomData<*mut u8>,
}

/// A mesh after intake: welded, clean, manifold, consistently wound. Never changes once made.
#[repr(C)]
pub struct ts_model {
    _opaque: [u8; 0],
    _neither_send_nor_sync: PhantomData<*mut u8>,
}

/// Feature points of the teeth (cusps, incisal edges: paper ref. 38) in groups, one a tooth (ref. 30), with the occlusal direction and the arch curve they were found with. Can be edited, or built by hand from nothing. A segmentation takes a copy: editing features does not change one already made.
#[repr(C)]
pub struct ts_features {
    _opaque: [u8; 0],
    _neither_send_nor_sync: PhantomData<*mut u8>,
}

/// A prepared scan and the teeth separated so far.
#[repr(C)]
pub struct ts_segmentation {
    _opaque: [u8; 0],
    _neither_send_nor_sync: PhantomData<*mut u8>,
}

/// A tooth, or the gingiva, as a mesh of its own, cut exactly along the cuts of the teeth: triangles that a cut crosses are split on it. What a tooth's cuts enclose is its own; where the cuts of several teeth enclose the same, it is that of the tooth with the nearest constraint point (ts_get_tooth_seeds), as ts_get_labels has it for whole faces: the teeth meet where these are equally far, and ts_mesh_info::lost says how much that took off. The meshes of all teeth and of the gingiva, open, add up to the model, and vertices on cuts have the same coordinates in both meshes, bit for bit. They belong to the teeth separated when they are made. Never changes once made.
#[repr(C)]
pub struct ts_mesh {
    _opaque: [u8; 0],
    _neither_send_nor_sync: PhantomData<*mut u8>,
}

/// Allocator hook. `alloc` returns memory aligned to 16 bytes, or NULL when there is none. Both may be called from any thread that works for the context. The large buffers of the library come from here; Eigen and oneTBB keep their own.
pub type ts_alloc_fn = Option<unsafe extern "C" fn(bytes: usize, user: *mut c_void) -> *mut c_void>;

/// Gives back what `alloc` of the same hook gave; `memory` is never NULL.
pub type ts_free_fn = Option<unsafe extern "C" fn(memory: *mut c_void, user: *mut c_void)>;

/// Log hook: one line without newline, valid during the call only; may come from any thread that works for the context.
pub type ts_log_fn = Option<unsafe extern "C" fn(level: ts_log_level, text: *const c_char, user: *mut c_void)>;

/// Called during a long call, from a thread that works for it, one call at a time: `fraction` in [0, 1], never falling within one call; `stage` a short English name. Return 0 to go on, anything else to cancel: sticky, as ts_job_cancel is. Must not call the library.
pub type ts_progress_fn = Option<unsafe extern "C" fn(fraction: f64, stage: *const c_char, user: *mut c_void) -> c_int>;

/// Called on the thread of the call that changed something, after the change, with what ts_get_changes tells; `teeth` lives as long as the callback. It may read the segmentation and must not destroy it; calls that would change it are refused (TS_E_INVALID_ARGUMENT).
pub type ts_change_fn = Option<unsafe extern "C" fn(user: *mut c_void, teeth: *const u32, count: u32)>;

/// Hooks and threads of a context.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_context_options {
    /// set by ts_context_options_init
    pub struct_size: u32,
    /// worker threads: 0 = one a core, 1 = only the calling thread, at most 1024. Default 0
    pub threads: u32,
    /// NULL = the system's; give both or none
    pub alloc: ts_alloc_fn,
    /// NULL if `alloc` is
    pub free: ts_free_fn,
    /// given to both as `user`
    pub alloc_user: *mut c_void,
    /// NULL = silent
    pub log: ts_log_fn,
    /// given to it as `user`
    pub log_user: *mut c_void,
}

impl Default for ts_context_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// The caller's mesh, read only during ts_model_create.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_mesh_input {
    /// set by ts_mesh_input_init
    pub struct_size: u32,
    /// type of the coordinates
    pub scalar: ts_scalar,
    /// x, y, z of vertex i at byte i * stride
    pub positions: *const c_void,
    /// number of vertices
    pub vertex_count: u32,
    /// bytes from one vertex to the next; 0 = packed (12 or 24)
    pub stride: u32,
    /// 3 indices a face; NULL = soup: vertices 3i, 3i+1, 3i+2 are face i
    pub triangles: *const u32,
    /// number of faces; for a soup vertex_count / 3 or 0
    pub triangle_count: u32,
    /// 0
    pub reserved: u32,
}

impl Default for ts_mesh_input {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// How a mesh is taken in.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_intake_options {
    /// set by ts_intake_options_init
    pub struct_size: u32,
    /// default TS_UNIT_CHECKED_MM
    pub unit: ts_unit,
    /// vertices closer than this become one, mm. Default 0: only exactly equal ones
    pub weld_tolerance: f64,
}

impl Default for ts_intake_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// What intake found and repaired. Counts of the caller's elements unless said otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_intake_report {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// as given (a soup: 3 a face)
    pub input_vertices: u32,
    /// as given; polygons count once
    pub input_faces: u32,
    /// input faces with more than 3 corners, triangulated
    pub polygons: u32,
    /// input vertices merged into another
    pub welded_vertices: u32,
    /// used by no face: dropped
    pub unreferenced_vertices: u32,
    /// fewer than 3 distinct corners, or no area: dropped
    pub degenerate_faces: u32,
    /// same corners as another face: dropped
    pub duplicate_faces: u32,
    /// wound against the majority of their piece: turned round
    pub flipped_faces: u32,
    /// edges of more than 2 faces: split
    pub non_manifold_edges: u32,
    /// vertices where several fans met: split
    pub non_manifold_vertices: u32,
    /// edges cut open because no winding fits both sides (Moebius)
    pub unorientable_edges: u32,
    /// of the model
    pub vertices: u32,
    /// of the model
    pub faces: u32,
    /// connected pieces of the model
    pub components: u32,
    /// open rims of the model
    pub boundary_loops: u32,
    /// of the bounding box, mm
    pub diagonal: f64,
    /// mm^2
    pub area: f64,
    /// mm
    pub mean_edge: f64,
}

impl Default for ts_intake_report {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// A point on the surface: a model face and the weights of its three corners (sum 1).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_surface_point {
    /// of the model
    pub face: u32,
    /// the corner with the largest weight
    pub nearest_vertex: u32,
    /// weights of its corners, in their order
    pub barycentric: [f64; 3],
    /// mm
    pub position: [f64; 3],
    /// from the query position, or along the ray from its origin, mm
    pub distance: f64,
}

impl Default for ts_surface_point {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// How features are found.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_feature_options {
    /// set by ts_feature_options_init
    pub struct_size: u32,
    /// most points a tooth. Default 8
    pub max_points: u32,
    /// a direction to use instead of the estimated one; 0,0,0 = estimate (default)
    pub occlusal: [f64; 3],
    /// r of the convexity measure, mm. Default 2.0: about half a cusp's width
    pub radius: f64,
}

impl Default for ts_feature_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// Counts of a set of features, and what the detection saw of the scan.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_features_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// number of groups
    pub groups: u32,
    /// number of points in all of them
    pub points: u32,
    /// 1 if the detection found that the faces look inwards; everything works all the same
    pub inside_out: u32,
    /// sum of ts_features_warning
    pub warnings: u32,
    /// 0
    pub reserved: u32,
    /// roughness that faces against the occlusal direction over that which faces with it: under .05 on most scans of one jaw, at most .33; .5 to 1 for two jaws in occlusion
    pub opposed: f64,
    /// share of the roughness within 14 mm of the arch curve: .9 and more on scans of one jaw
    pub coverage: f64,
    /// of the arch curve, mm: up to 180 on scans of one jaw
    pub arch_length: f64,
}

impl Default for ts_features_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// A feature point: where a tooth is held.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_feature_point {
    /// stays the same while the point exists
    pub id: u32,
    /// id of its group
    pub group: u32,
    /// nearest model vertex
    pub vertex: u32,
    /// 1 if the caller set it
    pub by_hand: u32,
    /// mm
    pub position: [f64; 3],
    /// dimensionless: 0 on a plane, 0.25 to 0.4 on a cusp; 0 for a point set by hand
    pub convexity: f64,
}

impl Default for ts_feature_point {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// The feature points of a tooth.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_feature_group {
    /// stays the same while the group exists
    pub id: u32,
    /// number of points
    pub points: u32,
    /// id of the neighbour group along the arch, TS_NONE at an end
    pub previous: u32,
    /// the other one
    pub next: u32,
    /// mean of its points, mm
    pub centre: [f64; 3],
    /// where its tooth begins along the arch curve, mm; 0 if made by hand
    pub arch_from: f64,
    /// where it ends, mm; 0 if made by hand
    pub arch_to: f64,
    /// 0 to 1: how sure the detection is that this is one tooth; 1 if made by hand
    pub confidence: f64,
}

impl Default for ts_feature_group {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// Defaults are given as: default preset / paper preset.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_segment_options {
    /// set by ts_segment_options_init
    pub struct_size: u32,
    /// what the options were initialised to; informative
    pub preset: ts_preset,
    /// CONCAVITY / PAPER
    pub weights: ts_weights,
    /// ALL / NEIGHBOUR
    pub background: ts_background,
    /// COMPONENT / GRADIENT
    pub cut_rule: ts_cut_rule,
    /// number of iso-values sampled in (0, 1) (Fig. 4A). 100 / 100
    pub contours: u32,
    /// of Fig. 4C. 50 / 50
    pub histogram_bins: u32,
    /// most constraint points used a tooth (Figs. 2, 3); 0 = all. 0 / 0
    pub points_per_group: u32,
    /// penalty of Eq. 6; 0 = exact constraints. 1e8 / 1e8
    pub alpha: f64,
    /// factor of a concave edge (Eq. 8), least weight of CONCAVITY. 1e-3 / 0.01
    pub beta: f64,
    /// added to the divisor of Eq. 8. 1e-4 / 1e-4
    pub gamma: f64,
    /// threshold of Eq. 9. 0.2 / 0.001
    pub theta: f64,
    /// decay of the CONCAVITY weights, 1/mm. 0.07
    pub c0: f64,
    /// r of the smoothed normals, mm. 0.15
    pub normal_radius: f64,
    /// a constraint point is a disc of this radius, mm; 0 = one vertex. 0.7 / 0
    pub seed_radius: f64,
    /// from every feature point, mm, at which gingiva begins for certain. 13
    pub gingiva_distance: f64,
    /// least area of a tooth, mm^2, for COMPONENT and for warnings. 25 / 25
    pub area_min: f64,
    /// largest area of a tooth, mm^2. 330 / 330
    pub area_max: f64,
    /// holes in a tooth's region up to this are filled, mm^2. 40 / 0
    pub hole_area: f64,
    /// half width of the band of the min-cut refinement, mm; 0 = none. 2.5 / 0
    pub refine_band: f64,
    /// smoothing of the final line, mm; 0 = none. 0.2 / 0
    pub smooth_radius: f64,
    /// a click further from the surface than this is off it, mm. 2 / 2
    pub click_reach: f64,
    /// geodesic cost |e| (1 + this * concavity) from click to points. 60 / 0
    pub click_concavity: f64,
    /// 1 = free feature points that contradict the field. 1 / 0
    pub reject_outliers: u32,
    /// bytes that the segmentation may keep beside the model, clicks' results and work space left out (ts_get_memory); 0 = no limit. What does not fit of the factor is worked out again by each click that needs it: slower, the same bytes. 0 / 0
    pub memory_limit: u64,
}

impl Default for ts_segment_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// Milliseconds a stage took (paper, Fig. 11). With the default preset the field is solved where the cut looks at it: then `field` is the share of that in `cut` and `label`, and not added to `total` again.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_click_times {
    /// click to groups
    pub pick: f64,
    /// solve; of the slower of the two teeth where they are worked out at the same time
    pub field: f64,
    /// contours, selection, refinement
    pub cut: f64,
    /// lines and labels
    pub label: f64,
    /// of the call, but for its entry in the history
    pub total: f64,
}

impl Default for ts_click_times {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// What came of a click.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_click_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// tooth clicked: id of its group
    pub target: u32,
    /// tooth beside it; TS_NONE if there is but one. Where no cut was found for it, ts_get_tooth says TS_E_NOT_FOUND: the tooth clicked stands alone
    pub neighbour: u32,
    /// the surface point taken, mm
    pub position: [f64; 3],
    /// along the surface to the closest point of each, in the metric of the options
    pub target_distance: f64,
    /// this and v_med are worked out when a click's info is first asked for
    pub neighbour_distance: f64,
    /// centre of the fullest bin (Fig. 4C)
    pub v_med: f64,
    /// chosen iso-values
    pub target_iso: f64,
    /// NaN if there is no neighbour
    pub neighbour_iso: f64,
    /// how long it took
    pub ms: ts_click_times,
}

impl Default for ts_click_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// One iso-value's contour of a click's field (Fig. 4A).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_contour_info {
    /// the value
    pub iso: f64,
    /// mean of |grad u| along it, 1/mm
    pub gradient: f64,
    /// share of it in concave valleys, 0 to 1
    pub concavity: f64,
    /// mm
    pub length: f64,
    /// in all its polylines
    pub points: u32,
    /// number of these
    pub polylines: u32,
    /// 1 = cut of the target, 2 = of the neighbour, 0 = neither
    pub chosen: u32,
}

impl Default for ts_contour_info {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// A point of a contour or cut: on the edge from model vertex `a` to `b`, at (1 - t) a + t b.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_edge_point {
    /// model vertex
    pub a: u32,
    /// model vertex
    pub b: u32,
    /// 0 at a, 1 at b
    pub t: f64,
    /// mm
    pub position: [f64; 3],
}

impl Default for ts_edge_point {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// A separated tooth. Its id is the id of its feature group, or of the group that a click made (ts_segment_click).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_tooth_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// of the tooth
    pub id: u32,
    /// what ts_get_labels writes: place of its feature group along the arch counted from 1; of the n-th group made by a click the number of feature groups + n; not an FDI number
    pub label: u32,
    /// the click that separated it (last)
    pub click: u32,
    /// model faces
    pub faces: u32,
    /// model vertices of these
    pub vertices: u32,
    /// closed polylines of its cut
    pub loops: u32,
    /// constraint points used
    pub seeds: u32,
    /// mm^2
    pub area: f64,
    /// iso-value of the cut
    pub iso: f64,
    /// mean of |grad u| along it, 1/mm
    pub gradient: f64,
    /// 0 to 1
    pub confidence: f64,
    /// sum of ts_tooth_warning
    pub warnings: u32,
    /// 0
    pub reserved: u32,
}

impl Default for ts_tooth_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// A loop of a cut.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_cut_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// number of these
    pub points: u32,
    /// 1: the last point is joined to the first
    pub closed: u32,
    /// mm
    pub length: f64,
    /// iso-value it was chosen at
    pub iso: f64,
    /// mean of |grad u| along it, 1/mm
    pub gradient: f64,
    /// share of it in concave valleys, 0 to 1
    pub concavity: f64,
}

impl Default for ts_cut_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// Milliseconds of the preparation.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_prepare_times {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// of the model
    pub intake: f64,
    /// of the detection; 0 if set by hand
    pub features: f64,
    /// curvature, concavity, weights
    pub weights: f64,
    /// constraints, ordering, factorisation
    pub factorise: f64,
}

impl Default for ts_prepare_times {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// Bytes that are kept. Most of them come from the context's allocator.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_memory_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// of the model, which segmentations share
    pub model: u64,
    /// of what a segmentation keeps beside it, the factor included: what memory_limit bounds
    pub segmentation: u64,
    /// of the factor, as far as it is kept
    pub factor: u64,
    /// of the factor if all of it were
    pub factor_whole: u64,
    /// of the work space of one tooth; as many are kept as teeth were cut at the same time
    pub click: u64,
}

impl Default for ts_memory_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// A tooth that wants a look.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_review_item {
    /// id of its group
    pub tooth: u32,
    /// 0: no cut has been made for this group so far
    pub separated: u32,
    /// sum of ts_tooth_warning
    pub warnings: u32,
    /// 0
    pub reserved: u32,
    /// of the tooth, 0 to 1; 0 where it is not separated
    pub confidence: f64,
    /// that the group is exactly one tooth; 1 for groups made by hand
    pub group_confidence: f64,
}

impl Default for ts_review_item {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// Faces that two teeth hold. In ts_get_labels they go to the tooth that is locked, or, where neither or both are, to the one whose nearest seed is nearer to the middle of the face; ts_get_tooth_faces has them for both.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_overlap {
    /// id of the tooth that they go to
    pub winner: u32,
    /// id of the other one
    pub loser: u32,
    /// of the model
    pub faces: u32,
    /// 0
    pub reserved: u32,
    /// mm^2
    pub area: f64,
}

impl Default for ts_overlap {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// The steps that are kept.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_history_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// steps that can be taken back
    pub undo: u32,
    /// steps that can be brought again
    pub redo: u32,
    /// 1: back to the beginning; 0: the limit has dropped the oldest
    pub complete: u32,
    /// about what the steps keep
    pub bytes: u64,
    /// how much they may (ts_set_history_limit)
    pub limit: u64,
}

impl Default for ts_history_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// How numbers are told.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_number_options {
    /// set by ts_number_options_init
    pub struct_size: u32,
    /// UNKNOWN (default): estimated
    pub jaw: ts_jaw,
    /// 1: the scan is a mirror image of the patient, so left and right change places. No scan shows whether it is one. Default 0
    pub mirrored: u32,
    /// 0
    pub reserved: u32,
    /// 0 to 1: a number or a jaw under it is uncertain. Default 0.9
    pub least_confidence: f64,
}

impl Default for ts_number_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// The number of a tooth.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_number_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// the most probable, also where it is uncertain
    pub fdi: u32,
    /// 1: by ts_set_number
    pub set_by_hand: u32,
    /// 1: confidence under least_confidence: to be shown to a person before it is used
    pub uncertain: u32,
    /// probability of this number, the jaw's included, under the model; 1 if set by hand
    pub confidence: f64,
}

impl Default for ts_number_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// The jaw that the numbers are of.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_jaw_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// the more probable, also where it is uncertain
    pub jaw: ts_jaw,
    /// 1: by the options or by a number set by hand
    pub given: u32,
    /// 1: confidence under least_confidence
    pub uncertain: u32,
    /// .5 where nothing tells; 1 if given
    pub confidence: f64,
}

impl Default for ts_jaw_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// A number as Palmer's notation has it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_palmer {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// as in FDI: 1 upper right, 2 upper left, 3 lower left, 4 lower right
    pub quadrant: u32,
    /// 1 (central incisor) to 8
    pub position: u32,
    /// "UR6"
    pub letters: [c_char; 4],
    /// UTF-8: the position in the angle of its quadrant, as on a chart that faces the patient
    pub symbol: [c_char; 8],
}

impl Default for ts_palmer {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// An edit that is kept.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_cut_edit {
    /// which of them
    pub kind: ts_edit_kind,
    /// TS_OK: it shows in the cut; else why it was dropped when the tooth was last separated again. A dropped edit is tried again the next time
    pub status: ts_status,
    /// 2 of a drag, those of a stroke, 0 of the others
    pub points: u32,
    /// 0
    pub reserved: u32,
    /// reach, mm or strength as given; 0 of a stroke
    pub amount: f64,
    /// of a drag where the cut was taken, of a stroke its first point, mm
    pub from: [f64; 3],
    /// of a drag where it was taken to, of a stroke its last point, mm
    pub to: [f64; 3],
}

impl Default for ts_cut_edit {
    /// All zero.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        unsafe { std::mem::zeroed() }
    }
}

/// How meshes of teeth are made.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_tooth_mesh_options {
    /// set by ts_tooth_mesh_options_init
    pub struct_size: u32,
    /// 1: all rims are closed by smooth membranes, those of the scan (holes, open ends) as well. Default 0
    pub closed: u32,
}

impl Default for ts_tooth_mesh_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// Counts and measures of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_mesh_info {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// ts_tooth_info::label, 0 of the gingiva
    pub label: u32,
    /// number of vertices
    pub vertices: u32,
    /// number of triangles
    pub triangles: u32,
    /// of these, at the end: those that close it
    pub fill_triangles: u32,
    /// that it shares with other parts
    pub cut_vertices: u32,
    /// 0: watertight
    pub open_rims: u32,
    /// rims that were closed
    pub closed_rims: u32,
    /// connected pieces
    pub components: u32,
    /// triangles left out at its rims, because the scan crosses itself there, or every membrane would cross them; only of closed meshes, up to 3 % of the area
    pub trimmed: u32,
    /// of all triangles, mm^2
    pub area: f64,
    /// of those that close it, mm^2
    pub fill_area: f64,
    /// mm^3; 0 while a rim is open
    pub volume: f64,
    /// of a tooth: what its cuts enclose and another tooth or the gingiva has, mm^2
    pub lost: f64,
}

impl Default for ts_mesh_info {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// How a segmentation is written.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_save_options {
    /// set by ts_save_options_init
    pub struct_size: u32,
    /// 1: the model's faces as they are, each of the tooth that ts_get_labels says. Default 0: split along the cuts
    pub whole_faces: u32,
}

impl Default for ts_save_options {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

/// Which way a tooth looks, and its extent that way over the faces of ts_get_tooth_faces.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ts_tooth_frame {
    /// in: sizeof this struct
    pub struct_size: u32,
    /// 1: mesial is along the arch curve; 0: there is none (features made by hand), and mesial is the direction in which the tooth is widest, to either side
    pub from_arch: u32,
    /// of the area of its faces, mm
    pub centre: [f64; 3],
    /// unit vector: that of the features
    pub occlusal: [f64; 3],
    /// unit vector along the arch, at right angles to occlusal, towards the middle of the arch curve's length: the midline, where the scan is of a whole arch
    pub mesial: [f64; 3],
    /// unit vector at right angles to both, away from the middle between the ends of the arch
    pub buccal: [f64; 3],
    /// mesial-distal extent, mm
    pub width: f64,
    /// buccal-lingual extent, mm
    pub depth: f64,
    /// occlusal-gingival extent of what the scan shows of the crown, mm
    pub height: f64,
}

impl Default for ts_tooth_frame {
    /// All zero, but for `struct_size`.
    fn default() -> Self {
        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero.
        let mut all_zero: Self = unsafe { std::mem::zeroed() };
        all_zero.struct_size = std::mem::size_of::<Self>() as u32;
        all_zero
    }
}

extern "C" {
    /// The library's version, e.g. "0.1.0". Static; any thread.
    pub fn ts_version() -> *const c_char;
    /// The name of a status, e.g. "TS_E_NO_TEETH"; "TS_E_?" for an unknown one. Static; any thread.
    pub fn ts_status_name(status: ts_status) -> *const c_char;
    /// What the last failed call of this thread reported: one line, never NULL, "" before any failure. Lives until the next failing call of the same thread. Do not use it to find out whether a call failed.
    pub fn ts_last_error_message() -> *const c_char;
    /// Fills `options` with the defaults. `struct_size`: sizeof(ts_context_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any.
    pub fn ts_context_options_init(options: *mut ts_context_options, struct_size: u32) -> ts_status;
    /// Makes a context. `options` in, may be NULL; `out` out, owned by the caller. Errors: TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT, TS_E_OUT_OF_MEMORY. Thread: any.
    pub fn ts_context_create(options: *const ts_context_options, out: *mut *mut ts_context) -> ts_status;
    /// Gives a context back; NULL is fine. It lives on until its last child is gone.
    pub fn ts_context_destroy(context: *mut ts_context);
    /// Makes a job. `progress` may be NULL (then the job serves to cancel only). `out` owned by the caller. Errors: TS_E_NULL, TS_E_OUT_OF_MEMORY.
    pub fn ts_job_create(context: *mut ts_context, progress: ts_progress_fn, user: *mut c_void, out: *mut *mut ts_job) -> ts_status;
    /// Asks the running call to stop: it returns TS_E_CANCELLED soon, with nothing changed. Sticky until ts_job_reset. Any thread, any time between create and destroy; NULL is fine.
    pub fn ts_job_cancel(job: *mut ts_job);
    /// Makes a cancelled job usable again. Not while a call uses it.
    pub fn ts_job_reset(job: *mut ts_job);
    /// The last reported fraction, 0 before any. Any thread. NULL gives 0.
    pub fn ts_job_progress(job: *const ts_job) -> f64;
    /// Gives a job back; NULL is fine. Not while a call uses it.
    pub fn ts_job_destroy(job: *mut ts_job);
    /// Fills `input` with an empty mesh of doubles. `struct_size`: sizeof(ts_mesh_input). Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any.
    pub fn ts_mesh_input_init(input: *mut ts_mesh_input, struct_size: u32) -> ts_status;
    /// Fills `options` with the defaults. `struct_size`: sizeof(ts_intake_options). Errors and threads: as above.
    pub fn ts_intake_options_init(options: *mut ts_intake_options, struct_size: u32) -> ts_status;
    /// Makes a model from the caller's arrays. Errors: TS_E_MESH_*, TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT, TS_E_OUT_OF_MEMORY, TS_E_CANCELLED. `options` and `job` may be NULL.
    pub fn ts_model_create(context: *mut ts_context, input: *const ts_mesh_input, options: *const ts_intake_options, job: *mut ts_job, out: *mut *mut ts_model) -> ts_status;
    /// Makes a model from a file: binary or ASCII STL, PLY (ASCII, binary of either byte order), OBJ, OFF. `path`: UTF-8. Errors: TS_E_FILE_*, and those of ts_model_create.
    pub fn ts_model_load(context: *mut ts_context, path: *const c_char, options: *const ts_intake_options, job: *mut ts_job, out: *mut *mut ts_model) -> ts_status;
    /// The same from a file already in memory.
    pub fn ts_model_read(context: *mut ts_context, bytes: *const c_void, size: usize, format: ts_file_format, options: *const ts_intake_options, job: *mut ts_job, out: *mut *mut ts_model) -> ts_status;
    /// Gives a model back; NULL is fine. It lives on until its last child is gone.
    pub fn ts_model_destroy(model: *mut ts_model);
    /// Fills the report. `report->struct_size` in, the rest out.
    pub fn ts_model_get_report(model: *const ts_model, report: *mut ts_intake_report) -> ts_status;
    /// Vertices of the model: `xyz` 3 doubles a vertex, `capacity` and `count` in vertices.
    pub fn ts_model_get_positions(model: *const ts_model, xyz: *mut f64, capacity: u32, count: *mut u32) -> ts_status;
    /// Faces of the model: 3 vertex indices each; `capacity` and `count` in faces.
    pub fn ts_model_get_triangles(model: *const ts_model, triangles: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// For each model face the caller's face it came from.
    pub fn ts_model_get_face_sources(model: *const ts_model, input_face: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// For each of the caller's vertices the model vertex that stands for it (after welding and splitting the first of several), TS_NONE if it was dropped.
    pub fn ts_model_get_vertex_map(model: *const ts_model, model_vertex: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// The surface point nearest to `position`. Errors: TS_E_NULL, TS_E_INVALID_ARGUMENT (not finite).
    pub fn ts_model_nearest(model: *const ts_model, position: *const f64, out: *mut ts_surface_point) -> ts_status;
    /// The first surface point hit by a ray (both sides of a face count). `direction` need not have length 1. Errors: TS_E_NOT_FOUND (the ray misses), TS_E_NULL, TS_E_INVALID_ARGUMENT.
    pub fn ts_model_raycast(model: *const ts_model, origin: *const f64, direction: *const f64, out: *mut ts_surface_point) -> ts_status;
    /// Fills `options` with the defaults. `struct_size`: sizeof(ts_feature_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any.
    pub fn ts_feature_options_init(options: *mut ts_feature_options, struct_size: u32) -> ts_status;
    /// Finds the features of a model. Errors: TS_E_NO_TEETH, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage.
    pub fn ts_detect_features(model: *const ts_model, options: *const ts_feature_options, job: *mut ts_job, out: *mut *mut ts_features) -> ts_status;
    /// Makes an empty set, to be filled by hand.
    pub fn ts_features_create(model: *const ts_model, out: *mut *mut ts_features) -> ts_status;
    /// Makes a copy.
    pub fn ts_features_clone(features: *const ts_features, out: *mut *mut ts_features) -> ts_status;
    /// Gives features back; NULL is fine.
    pub fn ts_features_destroy(features: *mut ts_features);
    /// Counts, and what the detection saw (0 in a set made by hand). `info->struct_size` in, the rest out.
    pub fn ts_features_get_info(features: *const ts_features, info: *mut ts_features_info) -> ts_status;
    /// The unit vector from the gums to the biting surface.
    pub fn ts_features_get_occlusal(features: *const ts_features, direction: *mut f64) -> ts_status;
    /// Sets it by hand; `direction` need not have length 1. Errors: TS_E_INVALID_ARGUMENT (no length, not finite), TS_E_NULL.
    pub fn ts_features_set_occlusal(features: *mut ts_features, direction: *const f64) -> ts_status;
    /// The arch curve as a polyline from one end of the arch to the other: 3 doubles a point, mm.
    pub fn ts_features_get_arch(features: *const ts_features, xyz: *mut f64, capacity: u32, count: *mut u32) -> ts_status;
    /// All points, in the order of their groups.
    pub fn ts_features_get_points(features: *const ts_features, points: *mut ts_feature_point, capacity: u32, count: *mut u32) -> ts_status;
    /// All groups, in the order of the arch.
    pub fn ts_features_get_groups(features: *const ts_features, groups: *mut ts_feature_group, capacity: u32, count: *mut u32) -> ts_status;
    /// Adds a point at the surface point nearest to `position`, to `group` (TS_NONE: a new group, placed along the arch by its position). `point` and `group_out` may be NULL. Errors: TS_E_NOT_FOUND, usage.
    pub fn ts_features_add_point(features: *mut ts_features, position: *const f64, group: u32, point: *mut u32, group_out: *mut u32) -> ts_status;
    /// Moves a point to the surface point nearest to `position`; it counts as set by hand then. Errors: TS_E_NOT_FOUND, usage.
    pub fn ts_features_move_point(features: *mut ts_features, point: u32, position: *const f64) -> ts_status;
    /// Puts a point into another group (TS_NONE: a new one). A group without points ceases to exist.
    pub fn ts_features_set_group(features: *mut ts_features, point: u32, group: u32, group_out: *mut u32) -> ts_status;
    /// Takes a point away, and its group with the last of them. Errors: TS_E_NOT_FOUND, TS_E_NULL.
    pub fn ts_features_remove_point(features: *mut ts_features, point: u32) -> ts_status;
    /// Takes a group away with all its points. Errors: TS_E_NOT_FOUND, TS_E_NULL.
    pub fn ts_features_remove_group(features: *mut ts_features, group: u32) -> ts_status;
    /// Fills `options` with those of a preset. `struct_size`: sizeof(ts_segment_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT (no such preset). Thread: any.
    pub fn ts_segment_options_init(options: *mut ts_segment_options, struct_size: u32, preset: ts_preset) -> ts_status;
    /// Prepares a scan: weights, and the factorisation that all clicks share. `features` are copied. Errors: TS_E_NO_CONSTRAINT, TS_E_SOLVER, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage.
    pub fn ts_segmentation_create(features: *const ts_features, options: *const ts_segment_options, job: *mut ts_job, out: *mut *mut ts_segmentation) -> ts_status;
    /// Gives a segmentation back; NULL is fine.
    pub fn ts_segmentation_destroy(segmentation: *mut ts_segmentation);
    /// Separates the tooth under `position` (mm, on the surface) and its neighbour: the group closest along the surface is the target (0), the next closest the background (1) (paper, "User interface"). The default preset takes for the neighbour the tooth beside the target along the arch that the click faces; one that is separated already is passed over where the tooth on the other side is not. With everything else as background, as the default preset has it, the click is evidence: where the tooth of the closest group does not hold the click, the target is the group that the field at the click is most of; where that one's tooth does not hold it either, the click makes a group of its own, held on a disc of seed_radius (TS_WARN_MADE_BY_CLICK). A click that succeeds gives the tooth that it lies on, or, on no other, within 1 mm of. A group made by a click belongs to the segmentation, not to the features: later clicks find it and have it as background; its id is the smallest larger than those of all groups of the features and of those made before it. TS_E_CLICK_ON_GINGIVA also where what could be cut out around the click is no tooth. `click` out, may be NULL: its number, counted from 0. Errors: TS_E_CLICK_*, TS_E_NO_CUT, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage.
    pub fn ts_segment_click(segmentation: *mut ts_segmentation, position: *const f64, job: *mut ts_job, click: *mut u32) -> ts_status;
    /// Several clicks at once, solved in parallel; the result is that of the same clicks one after the other. `positions` 3 doubles a click. `statuses` out, may be NULL: one a click; a click that fails leaves no trace, the others stand, and numbers are given to those that succeed, in order. Returns TS_OK if the batch ran, even if clicks failed; ts_last_error_message then tells of the last that did. TS_E_INVALID_ARGUMENT if a position is not finite.
    pub fn ts_segment_clicks(segmentation: *mut ts_segmentation, positions: *const f64, count: u32, job: *mut ts_job, statuses: *mut ts_status) -> ts_status;
    /// The fewest clicks that cover every group of the features not yet separated (paper: N/2, or N/2 + 1 in all): 3 doubles a click, to be given to ts_segment_clicks. No clicks once all are separated.
    pub fn ts_propose_clicks(segmentation: *const ts_segmentation, positions: *mut f64, capacity: u32, count: *mut u32) -> ts_status;
    /// How many clicks have succeeded so far. Errors: TS_E_NULL.
    pub fn ts_get_click_count(segmentation: *const ts_segmentation, count: *mut u32) -> ts_status;
    /// `click`: counted from 0. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_click(segmentation: *const ts_segmentation, click: u32, info: *mut ts_click_info) -> ts_status;
    /// u of Eq. 3 for a click, a value a model vertex: 0 on the target, 1 on the neighbour; NaN on pieces of the mesh that hold no constraint: Eq. 3 leaves u open there. Their faces belong to no tooth (label 0), and clicks and corrections on a piece without any feature point are refused with TS_E_CLICK_ON_GINGIVA.
    pub fn ts_get_field(segmentation: *const ts_segmentation, click: u32, u: *mut f64, capacity: u32, count: *mut u32) -> ts_status;
    /// The histogram of Fig. 4C: vertices a bin over [0, 1].
    pub fn ts_get_histogram(segmentation: *const ts_segmentation, click: u32, bins: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// All contours of a click, by rising iso-value (ts_segment_options::contours of them). Errors: TS_E_NOT_FOUND, usage.
    pub fn ts_get_contours(segmentation: *const ts_segmentation, click: u32, contours: *mut ts_contour_info, capacity: u32, count: *mut u32) -> ts_status;
    /// The points of one contour. `starts` out, may be NULL: index of the first point of each polyline (`polylines` of them); closed polylines repeat no point; `closed` out, may be NULL: 1 or 0 each.
    pub fn ts_get_contour_points(segmentation: *const ts_segmentation, click: u32, contour: u32, points: *mut ts_edge_point, capacity: u32, count: *mut u32, starts: *mut u32, closed: *mut u8) -> ts_status;
    /// Ids of the teeth separated so far, along the arch.
    pub fn ts_get_teeth(segmentation: *const ts_segmentation, teeth: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// `tooth`: id. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_tooth(segmentation: *const ts_segmentation, tooth: u32, info: *mut ts_tooth_info) -> ts_status;
    /// Model faces of a tooth, ascending, those that another tooth holds as well included. Errors: TS_E_NOT_FOUND, usage.
    pub fn ts_get_tooth_faces(segmentation: *const ts_segmentation, tooth: u32, faces: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// Model vertices of these faces, ascending. Errors: TS_E_NOT_FOUND, usage.
    pub fn ts_get_tooth_vertices(segmentation: *const ts_segmentation, tooth: u32, vertices: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// Model vertices held as this tooth's constraint.
    pub fn ts_get_tooth_seeds(segmentation: *const ts_segmentation, tooth: u32, vertices: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// The cut of a tooth: loop `loop` (0 = the longest) of its closed polyline(s), seen from outside counter-clockwise around the tooth. `info` may be NULL, `points` may be NULL.
    pub fn ts_get_cut(segmentation: *const ts_segmentation, tooth: u32, r#loop: u32, info: *mut ts_cut_info, points: *mut ts_edge_point, capacity: u32, count: *mut u32) -> ts_status;
    /// A label for each of the CALLER's faces, in the caller's order: 0 = no tooth (so far), else ts_tooth_info::label. Faces that intake dropped have the label of the face they duplicate or touch.
    pub fn ts_get_labels(segmentation: *const ts_segmentation, labels: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// `times->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_prepare_times(segmentation: *const ts_segmentation, times: *mut ts_prepare_times) -> ts_status;
    /// Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_memory(segmentation: *const ts_segmentation, info: *mut ts_memory_info) -> ts_status;
    /// Every tooth without a click of the caller's: the clicks of ts_propose_clicks until none is left, as one step. Teeth that stand already stay. Errors: TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage; a tooth for which no cut is found is told by ts_get_review.
    pub fn ts_segment_all(segmentation: *mut ts_segmentation, job: *mut ts_job) -> ts_status;
    /// Teeth with a confidence under 0.9 or a warning, and groups without a tooth, those that need it most first. Of teeth above 0.9 the share that is right is in docs/accuracy.md.
    pub fn ts_get_review(segmentation: *const ts_segmentation, items: *mut ts_review_item, capacity: u32, count: *mut u32) -> ts_status;
    /// "This too": a disc of seed_radius around `position` (mm, within click_reach of the surface) is held for the tooth, which is cut anew, as are separated teeth on which the disc lies. On a feature point of another tooth that point goes over to this one. Errors: TS_E_CLICK_OFF_SURFACE; TS_E_CLICK_ON_GINGIVA on what is gingiva for certain (gingiva_distance); TS_E_NO_CHANGE where the point is held for the tooth already; TS_E_NO_CUT where no cut is left, or on the last point of another tooth; TS_E_LOCKED; TS_E_NOT_FOUND; TS_E_CANCELLED; usage.
    pub fn ts_tooth_include(segmentation: *mut ts_segmentation, tooth: u32, position: *const f64, job: *mut ts_job) -> ts_status;
    /// "Not this": the disc is held for the tooth that the field there is most of after this one, or for the gingiva where that has more. A feature point of the tooth that lies there is no longer used. Errors: as ts_tooth_include.
    pub fn ts_tooth_exclude(segmentation: *mut ts_segmentation, tooth: u32, position: *const f64, job: *mut ts_job) -> ts_status;
    /// Two teeth of one: of its points those nearer to `part` than to `keep` go to a new group, and a disc at each of the two positions is held for its own. `second` out, may be NULL: id of the new tooth. Errors: as ts_tooth_include.
    pub fn ts_tooth_split(segmentation: *mut ts_segmentation, tooth: u32, keep: *const f64, part: *const f64, job: *mut ts_job, second: *mut u32) -> ts_status;
    /// Moves a feature point of the tooth: the one that lies at `from` is no longer used, and a disc of seed_radius around `to` is held instead; both in mm, within click_reach of the surface. The tooth is cut anew, as are separated teeth on which the disc lies. Errors: TS_E_NO_CHANGE where no point of the tooth lies at `from`, or one lies at `to` already; TS_E_NO_CUT also where what is held for another tooth lies at `to`; else as ts_tooth_include.
    pub fn ts_tooth_move_point(segmentation: *mut ts_segmentation, tooth: u32, from: *const f64, to: *const f64, job: *mut ts_job) -> ts_status;
    /// One tooth of two: the points of `other` are held for `tooth`, and `other` is no tooth any more. Errors: TS_E_NO_CUT, TS_E_NO_CHANGE where both are the same, TS_E_LOCKED, TS_E_NOT_FOUND, TS_E_CANCELLED, usage.
    pub fn ts_tooth_merge(segmentation: *mut ts_segmentation, tooth: u32, other: u32, job: *mut ts_job) -> ts_status;
    /// The tooth is as if it had not been separated; its group stays. Errors: TS_E_LOCKED, TS_E_NOT_FOUND, usage.
    pub fn ts_tooth_remove(segmentation: *mut ts_segmentation, tooth: u32) -> ts_status;
    /// `locked` 1: nothing changes the tooth until it is unlocked (0): a click on it is refused (TS_E_LOCKED), and as a neighbour it is left as it is. Errors: TS_E_NO_CHANGE where it is so already, TS_E_NOT_FOUND, usage.
    pub fn ts_tooth_set_locked(segmentation: *mut ts_segmentation, tooth: u32, locked: u32) -> ts_status;
    /// `locked` out: 1 or 0. Errors: TS_E_NOT_FOUND, TS_E_NULL.
    pub fn ts_tooth_get_locked(segmentation: *const ts_segmentation, tooth: u32, locked: *mut u32) -> ts_status;
    /// All of them, by pairs of teeth. Errors: TS_E_NULL, TS_E_BUFFER_TOO_SMALL.
    pub fn ts_get_overlaps(segmentation: *const ts_segmentation, overlaps: *mut ts_overlap, capacity: u32, count: *mut u32) -> ts_status;
    /// Takes back the last step: the teeth, clicks and groups are then, byte for byte, what they were. Errors: TS_E_NO_HISTORY, usage.
    pub fn ts_undo(segmentation: *mut ts_segmentation) -> ts_status;
    /// Brings again the step that was taken back last. A new step forgets those. Errors: TS_E_NO_HISTORY, usage.
    pub fn ts_redo(segmentation: *mut ts_segmentation) -> ts_status;
    /// `info->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_history(segmentation: *const ts_segmentation, info: *mut ts_history_info) -> ts_status;
    /// How many bytes the steps may keep; the oldest are dropped over it, at once. 256 MiB unless set.
    pub fn ts_set_history_limit(segmentation: *mut ts_segmentation, bytes: u64) -> ts_status;
    /// Ids of the teeth that the last step, ts_undo or ts_redo changed: separated, cut anew, taken away, locked or unlocked.
    pub fn ts_get_changes(segmentation: *const ts_segmentation, teeth: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// `callback` NULL: none. Errors: TS_E_NULL.
    pub fn ts_set_change_callback(segmentation: *mut ts_segmentation, callback: ts_change_fn, user: *mut c_void) -> ts_status;
    /// The session as JSON (docs/session-file.md): a hash of the mesh, features, options, every step and how many of them are taken back; no surface, no tooth. The two-call idiom; `text` is UTF-8 without a final 0.
    pub fn ts_session_write(segmentation: *const ts_segmentation, text: *mut c_char, capacity: u32, count: *mut u32) -> ts_status;
    /// The same into a file, which is there whole or, where the call fails, as it was. Errors: TS_E_FILE_WRITE, usage.
    pub fn ts_session_save(segmentation: *const ts_segmentation, path: *const c_char) -> ts_status;
    /// Goes through the steps of a session again, on the model that it was of; what comes out goes on as the one that was written would. `features` out, may be NULL: as they were, to be destroyed by the caller. Only steps that can still be undone when the limit is 256 MiB can be. Errors: TS_E_MISMATCH where the model is another mesh, or what the library makes of a step is no longer what it was; TS_E_FILE_NEWER, TS_E_FILE_FORMAT (no session), TS_E_FILE_TRUNCATED, TS_E_FILE_SYNTAX (with the place), TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage.
    pub fn ts_session_read(model: *const ts_model, text: *const c_char, size: usize, job: *mut ts_job, features: *mut *mut ts_features, out: *mut *mut ts_segmentation) -> ts_status;
    /// The same from a file. Errors: TS_E_FILE_OPEN, and as ts_session_read.
    pub fn ts_session_load(model: *const ts_model, path: *const c_char, job: *mut ts_job, features: *mut *mut ts_features, out: *mut *mut ts_segmentation) -> ts_status;
    /// Fills `options` with the defaults. `struct_size`: sizeof(ts_number_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any.
    pub fn ts_number_options_init(options: *mut ts_number_options, struct_size: u32) -> ts_status;
    /// Gives the teeth of a segmentation their FDI numbers: all feature groups in use and all groups made by clicks, separated or not (separated crowns are measured, which tells more). Permanent teeth only. The numbers rise along the arch; missing teeth leave theirs out. Told from widths and depths of the teeth, their places along the arch, the gaps between them and how their feature points lie; the patient's right from the occlusal direction and the side to which the arch bends. Coordinates are taken to be right-handed; which way faces look has no say. Numbers that were set by hand stay, and decide. Numbers do not change by themselves: call again after clicks. `options` in, may be NULL: the defaults; kept for ts_set_number. Errors, with all numbers as they were: TS_E_TOO_MANY_TEETH (over 16), TS_E_NUMBER_JAW (a number set by hand is of the other jaw than `options` give), TS_E_NUMBER_ORDER (those set fit no numbering), TS_E_INVALID_ARGUMENT (also where the features have no occlusal direction, or the line along the teeth is over 1000 mm long: a mesh in other units than it says), TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_OUT_OF_MEMORY.
    pub fn ts_assign_numbers(segmentation: *mut ts_segmentation, options: *const ts_number_options) -> ts_status;
    /// Sets the number of a tooth by hand; those of the others follow, and so does the jaw. `tooth`: id of its group (that of its feature group, as ts_tooth_info::id), separated or not. `fdi`: 11 to 18, 21 to 28, 31 to 38, 41 to 48; 0 forgets one that was set. Works before ts_assign_numbers too, with its default options. Errors, with all numbers as they were: TS_E_NOT_FOUND (no such tooth; 0 where none was set), TS_E_INVALID_ARGUMENT (no FDI number of a permanent tooth), TS_E_NUMBER_JAW (of the other jaw than was given or set), TS_E_NUMBER_TAKEN (set for another tooth), TS_E_NUMBER_ORDER (breaks the order along the arch, or leaves too few numbers between), TS_E_TOO_MANY_TEETH, TS_E_NULL, TS_E_OUT_OF_MEMORY.
    pub fn ts_set_number(segmentation: *mut ts_segmentation, tooth: u32, fdi: u32) -> ts_status;
    /// `tooth`: id of its group. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND (no number was assigned to it), TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_number(segmentation: *const ts_segmentation, tooth: u32, info: *mut ts_number_info) -> ts_status;
    /// `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND (no numbers were assigned), TS_E_NULL, TS_E_STRUCT_SIZE.
    pub fn ts_get_jaw(segmentation: *const ts_segmentation, info: *mut ts_jaw_info) -> ts_status;
    /// FDI to Universal: 1 to 32 from the upper right third molar to the upper left, on from the lower left to the lower right. Errors: TS_E_INVALID_ARGUMENT (no number of a permanent tooth), TS_E_NULL. Thread: any.
    pub fn ts_fdi_to_universal(fdi: u32, universal: *mut u32) -> ts_status;
    /// And back. Errors and threads: as ts_fdi_to_universal.
    pub fn ts_universal_to_fdi(universal: u32, fdi: *mut u32) -> ts_status;
    /// `palmer->struct_size` in, the rest out. Errors: TS_E_INVALID_ARGUMENT (no FDI number of a permanent tooth), TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any.
    pub fn ts_fdi_to_palmer(fdi: u32, palmer: *mut ts_palmer) -> ts_status;
    /// Takes a point of the cut to another place on the surface. A stretch around the point follows, along the cheapest way through the new place in the prices of the minimum cut, which run along the bottoms of valleys; smoothed as the cut of a click is. All points outside the stretch stay the same to the bit. On an open loop the ends stay, too. `loop`, `point`: index of the point as ts_get_cut gives it; afterwards the points may have other indices. `to`: mm, taken to the nearest surface point. `reach`: half the length of the stretch along the cut, mm; 0: as long as the drag, and at least 2.5, as far as the minimum cut looks for a valley; at most 0.4 of the loop is taken. Errors: TS_E_NOT_FOUND (no such loop or point), TS_E_CLICK_OFF_SURFACE (further than click_reach), TS_E_EDIT_NOTHING (under 0.01 mm), TS_E_EDIT_ON_TOOTH, TS_E_EDIT_CROSSING, TS_E_EDIT_NO_LOOP.
    pub fn ts_cut_drag(segmentation: *mut ts_segmentation, tooth: u32, r#loop: u32, point: u32, to: *const f64, reach: f64, job: *mut ts_job) -> ts_status;
    /// Draws a stretch of the cut: `count` points, at least 2, of 3 doubles, mm, taken to the surface and joined by shortest ways along it, the first and the last to the points of the cut that are nearest to them and have to be within click_reach. Of the two pieces of the loop between these the shorter one is replaced (of an open loop the one between them); the other stays the same to the bit. Corners are rounded only as far as the triangle that they lie in. Where the stroke crosses itself the loop is left out. Errors: TS_E_CLICK_OFF_SURFACE, TS_E_EDIT_OFF_CUT, TS_E_EDIT_NOTHING, TS_E_EDIT_ON_TOOTH, TS_E_EDIT_CROSSING (also where no short way along the surface leads from one point to the next), TS_E_EDIT_NO_LOOP.
    pub fn ts_cut_draw(segmentation: *mut ts_segmentation, tooth: u32, points: *const f64, count: u32, job: *mut ts_job) -> ts_status;
    /// Moves the whole cut along the surface by `mm`, outwards where positive: to where the distance along the surface from the cut is that. What comes off or is enclosed by it up to 1 mm^2, and loops up to 3.5 mm long, are let go; open lines may come off the rim of the scan. Errors: TS_E_EDIT_NOTHING (0), TS_E_EDIT_NO_LOOP (also where feature points of the tooth would be left out), TS_E_EDIT_ON_TOOTH.
    pub fn ts_cut_offset(segmentation: *mut ts_segmentation, tooth: u32, mm: f64, job: *mut ts_job) -> ts_status;
    /// Smooths the whole cut: what bends within less than `strength`, mm, over 0 to 2, is straightened. The cut of a click is smoothed with smooth_radius already. Errors: TS_E_EDIT_NO_LOOP, TS_E_EDIT_CROSSING.
    pub fn ts_cut_smooth(segmentation: *mut ts_segmentation, tooth: u32, strength: f64, job: *mut ts_job) -> ts_status;
    /// Gives the tooth the cut of its click again and forgets its edits. TS_OK also where there are none.
    pub fn ts_cut_reset(segmentation: *mut ts_segmentation, tooth: u32) -> ts_status;
    /// The edits of a tooth since the click, or the last ts_cut_reset, in their order. Const handle. Errors: TS_E_NULL, TS_E_NOT_FOUND, TS_E_BUFFER_TOO_SMALL.
    pub fn ts_get_cut_edits(segmentation: *const ts_segmentation, tooth: u32, edits: *mut ts_cut_edit, capacity: u32, count: *mut u32) -> ts_status;
    /// Fills `options` with the defaults. `struct_size`: sizeof(ts_tooth_mesh_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any.
    pub fn ts_tooth_mesh_options_init(options: *mut ts_tooth_mesh_options, struct_size: u32) -> ts_status;
    /// Makes the mesh of a tooth. `tooth` an id of ts_get_teeth; `options` in, may be NULL; `out` out, owned by the caller. Errors: TS_E_NOT_FOUND (no such tooth), TS_E_NO_CUT (its cut does not part it from the rest, or other teeth leave nothing of it), TS_E_NOT_CLOSED, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. Thread: const.
    pub fn ts_tooth_mesh_create(segmentation: *const ts_segmentation, tooth: u32, options: *const ts_tooth_mesh_options, job: *mut ts_job, out: *mut *mut ts_mesh) -> ts_status;
    /// Makes the mesh of what belongs to no tooth separated so far: gingiva, base, and teeth not separated. Closed, its sockets and the rims of the scan are. Otherwise as ts_tooth_mesh_create.
    pub fn ts_gingiva_mesh_create(segmentation: *const ts_segmentation, options: *const ts_tooth_mesh_options, job: *mut ts_job, out: *mut *mut ts_mesh) -> ts_status;
    /// Gives a mesh back; NULL is fine.
    pub fn ts_mesh_destroy(mesh: *mut ts_mesh);
    /// `info->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: const.
    pub fn ts_mesh_get_info(mesh: *const ts_mesh, info: *mut ts_mesh_info) -> ts_status;
    /// Vertices: `xyz` 3 doubles a vertex, mm; `capacity` and `count` in vertices. Errors: TS_E_NULL, TS_E_BUFFER_TOO_SMALL. Thread: const.
    pub fn ts_mesh_get_positions(mesh: *const ts_mesh, xyz: *mut f64, capacity: u32, count: *mut u32) -> ts_status;
    /// Unit normals of the vertices, outwards: 3 doubles a vertex; 0, 0, 0 where the triangles around cancel out. Otherwise as ts_mesh_get_positions.
    pub fn ts_mesh_get_normals(mesh: *const ts_mesh, xyz: *mut f64, capacity: u32, count: *mut u32) -> ts_status;
    /// Triangles: 3 vertex indices each, counter-clockwise seen from outside, also where the faces of the scan look inwards; `capacity` and `count` in triangles. Otherwise as ts_mesh_get_positions.
    pub fn ts_mesh_get_triangles(mesh: *const ts_mesh, triangles: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// For each triangle the model face that it is of, TS_NONE for those that close the mesh. Otherwise as ts_mesh_get_triangles.
    pub fn ts_mesh_get_faces(mesh: *const ts_mesh, faces: *mut u32, capacity: u32, count: *mut u32) -> ts_status;
    /// For each vertex a sum of ts_mesh_vertex_flag. Otherwise as ts_mesh_get_positions.
    pub fn ts_mesh_get_vertex_flags(mesh: *const ts_mesh, flags: *mut u8, capacity: u32, count: *mut u32) -> ts_status;
    /// Writes a mesh to a file. `path`: UTF-8; it is written to a temporary file beside it and renamed, so that nothing is left half written, and what was there stays if it fails. Parts are named tooth_LABEL and gingiva in formats with names. Errors: TS_E_FILE_WRITE (the message says why: disk full, no such directory, not a regular file, ...), TS_E_INVALID_ARGUMENT, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, TS_E_NULL. Thread: const.
    pub fn ts_mesh_save(mesh: *const ts_mesh, path: *const c_char, format: ts_output_format, job: *mut ts_job) -> ts_status;
    /// Fills `options` with the defaults. As ts_tooth_mesh_options_init.
    pub fn ts_save_options_init(options: *mut ts_save_options, struct_size: u32) -> ts_status;
    /// Writes the whole scan with its teeth: colours and labels (PLY), a group (OBJ) or a node (GLB) a tooth and one for the gingiva; STL has the triangles alone. `options` in, may be NULL. Errors: those of ts_mesh_save, and TS_E_NO_CUT. Thread: const.
    pub fn ts_segmentation_save(segmentation: *const ts_segmentation, path: *const c_char, format: ts_output_format, options: *const ts_save_options, job: *mut ts_job) -> ts_status;
    /// `frame->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_INVALID_ARGUMENT (the features have no occlusal direction), TS_E_NULL, TS_E_STRUCT_SIZE. Thread: const.
    pub fn ts_get_tooth_frame(segmentation: *const ts_segmentation, tooth: u32, frame: *mut ts_tooth_frame) -> ts_status;
}

/// That the structs lie in memory as the C compiler lays them out.
#[cfg(test)]
mod layout {
    macro_rules! check {
        ($name:ident, $size:expr, $align:expr, $($field:ident: $offset:expr),*) => {
            #[test]
            fn $name() {
                assert_eq!(std::mem::size_of::<crate::$name>(), $size);
                assert_eq!(std::mem::align_of::<crate::$name>(), $align);
                let s = <crate::$name>::default();
                let at = std::ptr::addr_of!(s) as usize;
                $(assert_eq!(std::ptr::addr_of!(s.$field) as usize - at, $offset, stringify!($field));)*
            }
        };
    }

    #[cfg(all(target_pointer_width = "64", not(windows)))]
    mod lp64 {
        check!(ts_context_options, 48, 8, struct_size: 0, threads: 4, alloc: 8, free: 16, alloc_user: 24, log: 32, log_user: 40);
        check!(ts_mesh_input, 40, 8, struct_size: 0, scalar: 4, positions: 8, vertex_count: 16, stride: 20, triangles: 24, triangle_count: 32, reserved: 36);
        check!(ts_intake_options, 16, 8, struct_size: 0, unit: 4, weld_tolerance: 8);
        check!(ts_intake_report, 88, 8, struct_size: 0, input_vertices: 4, input_faces: 8, polygons: 12, welded_vertices: 16, unreferenced_vertices: 20, degenerate_faces: 24, duplicate_faces: 28, flipped_faces: 32, non_manifold_edges: 36, non_manifold_vertices: 40, unorientable_edges: 44, vertices: 48, faces: 52, components: 56, boundary_loops: 60, diagonal: 64, area: 72, mean_edge: 80);
        check!(ts_surface_point, 64, 8, face: 0, nearest_vertex: 4, barycentric: 8, position: 32, distance: 56);
        check!(ts_feature_options, 40, 8, struct_size: 0, max_points: 4, occlusal: 8, radius: 32);
        check!(ts_features_info, 48, 8, struct_size: 0, groups: 4, points: 8, inside_out: 12, warnings: 16, reserved: 20, opposed: 24, coverage: 32, arch_length: 40);
        check!(ts_feature_point, 48, 8, id: 0, group: 4, vertex: 8, by_hand: 12, position: 16, convexity: 40);
        check!(ts_feature_group, 64, 8, id: 0, points: 4, previous: 8, next: 12, centre: 16, arch_from: 40, arch_to: 48, confidence: 56);
        check!(ts_segment_options, 168, 8, struct_size: 0, preset: 4, weights: 8, background: 12, cut_rule: 16, contours: 20, histogram_bins: 24, points_per_group: 28, alpha: 32, beta: 40, gamma: 48, theta: 56, c0: 64, normal_radius: 72, seed_radius: 80, gingiva_distance: 88, area_min: 96, area_max: 104, hole_area: 112, refine_band: 120, smooth_radius: 128, click_reach: 136, click_concavity: 144, reject_outliers: 152, memory_limit: 160);
        check!(ts_click_times, 40, 8, pick: 0, field: 8, cut: 16, label: 24, total: 32);
        check!(ts_click_info, 120, 8, struct_size: 0, target: 4, neighbour: 8, position: 16, target_distance: 40, neighbour_distance: 48, v_med: 56, target_iso: 64, neighbour_iso: 72, ms: 80);
        check!(ts_contour_info, 48, 8, iso: 0, gradient: 8, concavity: 16, length: 24, points: 32, polylines: 36, chosen: 40);
        check!(ts_edge_point, 40, 8, a: 0, b: 4, t: 8, position: 16);
        check!(ts_tooth_info, 72, 8, struct_size: 0, id: 4, label: 8, click: 12, faces: 16, vertices: 20, loops: 24, seeds: 28, area: 32, iso: 40, gradient: 48, confidence: 56, warnings: 64, reserved: 68);
        check!(ts_cut_info, 48, 8, struct_size: 0, points: 4, closed: 8, length: 16, iso: 24, gradient: 32, concavity: 40);
        check!(ts_prepare_times, 40, 8, struct_size: 0, reserved: 4, intake: 8, features: 16, weights: 24, factorise: 32);
        check!(ts_memory_info, 48, 8, struct_size: 0, reserved: 4, model: 8, segmentation: 16, factor: 24, factor_whole: 32, click: 40);
        check!(ts_review_item, 32, 8, tooth: 0, separated: 4, warnings: 8, reserved: 12, confidence: 16, group_confidence: 24);
        check!(ts_overlap, 24, 8, winner: 0, loser: 4, faces: 8, reserved: 12, area: 16);
        check!(ts_history_info, 32, 8, struct_size: 0, undo: 4, redo: 8, complete: 12, bytes: 16, limit: 24);
        check!(ts_number_options, 24, 8, struct_size: 0, jaw: 4, mirrored: 8, reserved: 12, least_confidence: 16);
        check!(ts_number_info, 24, 8, struct_size: 0, fdi: 4, set_by_hand: 8, uncertain: 12, confidence: 16);
        check!(ts_jaw_info, 24, 8, struct_size: 0, jaw: 4, given: 8, uncertain: 12, confidence: 16);
        check!(ts_palmer, 24, 4, struct_size: 0, quadrant: 4, position: 8, letters: 12, symbol: 16);
        check!(ts_cut_edit, 72, 8, kind: 0, status: 4, points: 8, reserved: 12, amount: 16, from: 24, to: 48);
        check!(ts_tooth_mesh_options, 8, 4, struct_size: 0, closed: 4);
        check!(ts_mesh_info, 72, 8, struct_size: 0, label: 4, vertices: 8, triangles: 12, fill_triangles: 16, cut_vertices: 20, open_rims: 24, closed_rims: 28, components: 32, trimmed: 36, area: 40, fill_area: 48, volume: 56, lost: 64);
        check!(ts_save_options, 8, 4, struct_size: 0, whole_faces: 4);
        check!(ts_tooth_frame, 128, 8, struct_size: 0, from_arch: 4, centre: 8, occlusal: 32, mesial: 56, buccal: 80, width: 104, depth: 112, height: 120);
    }

    #[cfg(all(target_pointer_width = "64", windows))]
    mod llp64 {
        check!(ts_context_options, 48, 8, struct_size: 0, threads: 4, alloc: 8, free: 16, alloc_user: 24, log: 32, log_user: 40);
        check!(ts_mesh_input, 40, 8, struct_size: 0, scalar: 4, positions: 8, vertex_count: 16, stride: 20, triangles: 24, triangle_count: 32, reserved: 36);
        check!(ts_intake_options, 16, 8, struct_size: 0, unit: 4, weld_tolerance: 8);
        check!(ts_intake_report, 88, 8, struct_size: 0, input_vertices: 4, input_faces: 8, polygons: 12, welded_vertices: 16, unreferenced_vertices: 20, degenerate_faces: 24, duplicate_faces: 28, flipped_faces: 32, non_manifold_edges: 36, non_manifold_vertices: 40, unorientable_edges: 44, vertices: 48, faces: 52, components: 56, boundary_loops: 60, diagonal: 64, area: 72, mean_edge: 80);
        check!(ts_surface_point, 64, 8, face: 0, nearest_vertex: 4, barycentric: 8, position: 32, distance: 56);
        check!(ts_feature_options, 40, 8, struct_size: 0, max_points: 4, occlusal: 8, radius: 32);
        check!(ts_features_info, 48, 8, struct_size: 0, groups: 4, points: 8, inside_out: 12, warnings: 16, reserved: 20, opposed: 24, coverage: 32, arch_length: 40);
        check!(ts_feature_point, 48, 8, id: 0, group: 4, vertex: 8, by_hand: 12, position: 16, convexity: 40);
        check!(ts_feature_group, 64, 8, id: 0, points: 4, previous: 8, next: 12, centre: 16, arch_from: 40, arch_to: 48, confidence: 56);
        check!(ts_segment_options, 168, 8, struct_size: 0, preset: 4, weights: 8, background: 12, cut_rule: 16, contours: 20, histogram_bins: 24, points_per_group: 28, alpha: 32, beta: 40, gamma: 48, theta: 56, c0: 64, normal_radius: 72, seed_radius: 80, gingiva_distance: 88, area_min: 96, area_max: 104, hole_area: 112, refine_band: 120, smooth_radius: 128, click_reach: 136, click_concavity: 144, reject_outliers: 152, memory_limit: 160);
        check!(ts_click_times, 40, 8, pick: 0, field: 8, cut: 16, label: 24, total: 32);
        check!(ts_click_info, 120, 8, struct_size: 0, target: 4, neighbour: 8, position: 16, target_distance: 40, neighbour_distance: 48, v_med: 56, target_iso: 64, neighbour_iso: 72, ms: 80);
        check!(ts_contour_info, 48, 8, iso: 0, gradient: 8, concavity: 16, length: 24, points: 32, polylines: 36, chosen: 40);
        check!(ts_edge_point, 40, 8, a: 0, b: 4, t: 8, position: 16);
        check!(ts_tooth_info, 72, 8, struct_size: 0, id: 4, label: 8, click: 12, faces: 16, vertices: 20, loops: 24, seeds: 28, area: 32, iso: 40, gradient: 48, confidence: 56, warnings: 64, reserved: 68);
        check!(ts_cut_info, 48, 8, struct_size: 0, points: 4, closed: 8, length: 16, iso: 24, gradient: 32, concavity: 40);
        check!(ts_prepare_times, 40, 8, struct_size: 0, reserved: 4, intake: 8, features: 16, weights: 24, factorise: 32);
        check!(ts_memory_info, 48, 8, struct_size: 0, reserved: 4, model: 8, segmentation: 16, factor: 24, factor_whole: 32, click: 40);
        check!(ts_review_item, 32, 8, tooth: 0, separated: 4, warnings: 8, reserved: 12, confidence: 16, group_confidence: 24);
        check!(ts_overlap, 24, 8, winner: 0, loser: 4, faces: 8, reserved: 12, area: 16);
        check!(ts_history_info, 32, 8, struct_size: 0, undo: 4, redo: 8, complete: 12, bytes: 16, limit: 24);
        check!(ts_number_options, 24, 8, struct_size: 0, jaw: 4, mirrored: 8, reserved: 12, least_confidence: 16);
        check!(ts_number_info, 24, 8, struct_size: 0, fdi: 4, set_by_hand: 8, uncertain: 12, confidence: 16);
        check!(ts_jaw_info, 24, 8, struct_size: 0, jaw: 4, given: 8, uncertain: 12, confidence: 16);
        check!(ts_palmer, 24, 4, struct_size: 0, quadrant: 4, position: 8, letters: 12, symbol: 16);
        check!(ts_cut_edit, 72, 8, kind: 0, status: 4, points: 8, reserved: 12, amount: 16, from: 24, to: 48);
        check!(ts_tooth_mesh_options, 8, 4, struct_size: 0, closed: 4);
        check!(ts_mesh_info, 72, 8, struct_size: 0, label: 4, vertices: 8, triangles: 12, fill_triangles: 16, cut_vertices: 20, open_rims: 24, closed_rims: 28, components: 32, trimmed: 36, area: 40, fill_area: 48, volume: 56, lost: 64);
        check!(ts_save_options, 8, 4, struct_size: 0, whole_faces: 4);
        check!(ts_tooth_frame, 128, 8, struct_size: 0, from_arch: 4, centre: 8, occlusal: 32, mesial: 56, buccal: 80, width: 104, depth: 112, height: 120);
    }

    #[cfg(target_arch = "wasm32")]
    mod wasm32 {
        check!(ts_context_options, 28, 4, struct_size: 0, threads: 4, alloc: 8, free: 12, alloc_user: 16, log: 20, log_user: 24);
        check!(ts_mesh_input, 32, 4, struct_size: 0, scalar: 4, positions: 8, vertex_count: 12, stride: 16, triangles: 20, triangle_count: 24, reserved: 28);
        check!(ts_intake_options, 16, 8, struct_size: 0, unit: 4, weld_tolerance: 8);
        check!(ts_intake_report, 88, 8, struct_size: 0, input_vertices: 4, input_faces: 8, polygons: 12, welded_vertices: 16, unreferenced_vertices: 20, degenerate_faces: 24, duplicate_faces: 28, flipped_faces: 32, non_manifold_edges: 36, non_manifold_vertices: 40, unorientable_edges: 44, vertices: 48, faces: 52, components: 56, boundary_loops: 60, diagonal: 64, area: 72, mean_edge: 80);
        check!(ts_surface_point, 64, 8, face: 0, nearest_vertex: 4, barycentric: 8, position: 32, distance: 56);
        check!(ts_feature_options, 40, 8, struct_size: 0, max_points: 4, occlusal: 8, radius: 32);
        check!(ts_features_info, 48, 8, struct_size: 0, groups: 4, points: 8, inside_out: 12, warnings: 16, reserved: 20, opposed: 24, coverage: 32, arch_length: 40);
        check!(ts_feature_point, 48, 8, id: 0, group: 4, vertex: 8, by_hand: 12, position: 16, convexity: 40);
        check!(ts_feature_group, 64, 8, id: 0, points: 4, previous: 8, next: 12, centre: 16, arch_from: 40, arch_to: 48, confidence: 56);
        check!(ts_segment_options, 168, 8, struct_size: 0, preset: 4, weights: 8, background: 12, cut_rule: 16, contours: 20, histogram_bins: 24, points_per_group: 28, alpha: 32, beta: 40, gamma: 48, theta: 56, c0: 64, normal_radius: 72, seed_radius: 80, gingiva_distance: 88, area_min: 96, area_max: 104, hole_area: 112, refine_band: 120, smooth_radius: 128, click_reach: 136, click_concavity: 144, reject_outliers: 152, memory_limit: 160);
        check!(ts_click_times, 40, 8, pick: 0, field: 8, cut: 16, label: 24, total: 32);
        check!(ts_click_info, 120, 8, struct_size: 0, target: 4, neighbour: 8, position: 16, target_distance: 40, neighbour_distance: 48, v_med: 56, target_iso: 64, neighbour_iso: 72, ms: 80);
        check!(ts_contour_info, 48, 8, iso: 0, gradient: 8, concavity: 16, length: 24, points: 32, polylines: 36, chosen: 40);
        check!(ts_edge_point, 40, 8, a: 0, b: 4, t: 8, position: 16);
        check!(ts_tooth_info, 72, 8, struct_size: 0, id: 4, label: 8, click: 12, faces: 16, vertices: 20, loops: 24, seeds: 28, area: 32, iso: 40, gradient: 48, confidence: 56, warnings: 64, reserved: 68);
        check!(ts_cut_info, 48, 8, struct_size: 0, points: 4, closed: 8, length: 16, iso: 24, gradient: 32, concavity: 40);
        check!(ts_prepare_times, 40, 8, struct_size: 0, reserved: 4, intake: 8, features: 16, weights: 24, factorise: 32);
        check!(ts_memory_info, 48, 8, struct_size: 0, reserved: 4, model: 8, segmentation: 16, factor: 24, factor_whole: 32, click: 40);
        check!(ts_review_item, 32, 8, tooth: 0, separated: 4, warnings: 8, reserved: 12, confidence: 16, group_confidence: 24);
        check!(ts_overlap, 24, 8, winner: 0, loser: 4, faces: 8, reserved: 12, area: 16);
        check!(ts_history_info, 32, 8, struct_size: 0, undo: 4, redo: 8, complete: 12, bytes: 16, limit: 24);
        check!(ts_number_options, 24, 8, struct_size: 0, jaw: 4, mirrored: 8, reserved: 12, least_confidence: 16);
        check!(ts_number_info, 24, 8, struct_size: 0, fdi: 4, set_by_hand: 8, uncertain: 12, confidence: 16);
        check!(ts_jaw_info, 24, 8, struct_size: 0, jaw: 4, given: 8, uncertain: 12, confidence: 16);
        check!(ts_palmer, 24, 4, struct_size: 0, quadrant: 4, position: 8, letters: 12, symbol: 16);
        check!(ts_cut_edit, 72, 8, kind: 0, status: 4, points: 8, reserved: 12, amount: 16, from: 24, to: 48);
        check!(ts_tooth_mesh_options, 8, 4, struct_size: 0, closed: 4);
        check!(ts_mesh_info, 72, 8, struct_size: 0, label: 4, vertices: 8, triangles: 12, fill_triangles: 16, cut_vertices: 20, open_rims: 24, closed_rims: 28, components: 32, trimmed: 36, area: 40, fill_area: 48, volume: 56, lost: 64);
        check!(ts_save_options, 8, 4, struct_size: 0, whole_faces: 4);
        check!(ts_tooth_frame, 128, 8, struct_size: 0, from_arch: 4, centre: 8, occlusal: 32, mesial: 56, buccal: 80, width: 104, depth: 112, height: 120);
    }
}
