# SPDX-License-Identifier: Apache-2.0
"""The C API of toothseg for ctypes. Made by generate.py from abi/toothseg.json: do not edit.

Structs, handles and callbacks have their names from toothseg.h, which is the manual; enums have Python's kind of names.
"""
# fmt: off
from __future__ import annotations

import ctypes
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_float, c_int, c_int8,  # noqa: F401
                    c_int16, c_int32, c_int64, c_size_t, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p)
from enum import IntEnum, IntFlag
from typing import Any, Self


class Enum(IntEnum):
    """An enum that takes values which only a newer library knows."""

    @classmethod
    def _missing_(cls, value: object) -> Self | None:
        if not isinstance(value, int):
            return None
        member = int.__new__(cls, value)
        member._name_, member._value_ = f"UNKNOWN_{value}", value
        return member


VERSION = "0.1.0"
NONE = 0xffffffff


class Status(Enum):
    """What came of a call. Values are fixed for ever; new ones are added within their block."""

    #: done
    OK = 0
    #: a value outside its stated range
    INVALID_ARGUMENT = 100
    #: a pointer that must not be NULL is
    NULL = 101
    #: struct_size is 0, or no size that any release had
    STRUCT_SIZE = 102
    #: capacity is less than the number of elements
    BUFFER_TOO_SMALL = 103
    #: no such group, point, click, tooth, loop or contour
    NOT_FOUND = 104
    #: objects that do not belong together (features of another model)
    MISMATCH = 105
    #: an allocation failed, or memory_limit is too small for any way of work
    OUT_OF_MEMORY = 200
    #: the job was cancelled, by ts_job_cancel or its callback
    CANCELLED = 201
    #: a fault in the library: please report the message
    INTERNAL = 202
    #: cannot be opened or read
    FILE_OPEN = 300
    #: not STL, PLY, OBJ or OFF, or a variant that is not read
    FILE_FORMAT = 301
    #: ends before what its header or its last statement promises
    FILE_TRUNCATED = 302
    #: goes on after what its header promises
    FILE_TRAILING = 303
    #: a count that the file's size contradicts
    FILE_COUNT = 304
    #: text where a number or keyword belongs; the message has the line
    FILE_SYNTAX = 305
    #: cannot be written; nothing is left half written
    FILE_WRITE = 306
    #: a session of a later format than this library reads
    FILE_NEWER = 307
    #: no face, or none that is not degenerate
    MESH_EMPTY = 400
    #: NaN or infinity among the coordinates
    MESH_NON_FINITE = 401
    #: a triangle names a vertex that is not there
    MESH_INDEX_RANGE = 402
    #: too small or too large for a scan in mm: probably in other units
    MESH_UNITS = 403
    #: more than 2^30 faces or vertices, or coordinates beyond 1e9 mm
    MESH_TOO_LARGE = 404
    #: nothing on the mesh looks like a tooth
    NO_TEETH = 500
    #: no group with a point: there is nothing to separate
    NO_CONSTRAINT = 501
    #: the click is further from the surface than click_reach
    CLICK_OFF_SURFACE = 600
    #: the click lies on gingiva or base, not on a tooth
    CLICK_ON_GINGIVA = 601
    #: no contour of the field separates the tooth
    NO_CUT = 602
    #: the linear system could not be factorised
    SOLVER = 603
    #: the tooth is locked, and the call would change it
    LOCKED = 604
    #: what is asked for is so already
    NO_CHANGE = 605
    #: nothing to undo, or to redo
    NO_HISTORY = 606
    #: the edit would change nothing: a drag to where the point is, a stroke of no length
    EDIT_NOTHING = 650
    #: the new line would run on another tooth, or take in its feature points
    EDIT_ON_TOOTH = 651
    #: the new line would cross the rest of the cut, or part the tooth's feature points from it
    EDIT_CROSSING = 652
    #: the edit does not come near the cut that it is to change
    EDIT_OFF_CUT = 653
    #: a loop of the cut would vanish, or become several
    EDIT_NO_LOOP = 654
    #: more teeth along the arch than the 16 that a jaw has
    TOO_MANY_TEETH = 700
    #: a number of the other jaw
    NUMBER_JAW = 701
    #: the number has been set for another tooth
    NUMBER_TAKEN = 702
    #: numbers would not rise along the arch, or leave none for the teeth between
    NUMBER_ORDER = 703
    #: a rim cannot be closed without the mesh running through itself
    NOT_CLOSED = 750


class LogLevel(Enum):
    """How much a line of the log matters."""

    #: not used so far: a call that fails says so in its status
    ERROR = 0
    #: the call did its work, and something about it is odd
    WARNING = 1
    #: what was found and how long it took
    INFO = 2


class Scalar(Enum):
    """Type of the caller's coordinates."""

    #: float
    FLOAT32 = 0
    #: double
    FLOAT64 = 1


class Unit(Enum):
    """Unit of the caller's coordinates. TS_UNIT_CHECKED_MM: mm, and TS_E_MESH_UNITS if the size of the mesh contradicts
    it (bounding box diagonal under 9 or over 400); the others convert without a check of the size, as long as
    coordinates stay within 1e9 mm. Distances of the library are of teeth in mm, whatever the size: on a surface over
    400 mm across no teeth are found (TS_E_NO_TEETH), and parts under 0.5 mm are not closed (TS_E_NOT_CLOSED)."""

    #: mm, checked
    CHECKED_MM = 0
    #: mm, whatever the size
    MM = 1
    #: 10 mm
    CM = 2
    #: 1000 mm
    M = 3
    #: 25.4 mm
    INCH = 4


class FileFormat(Enum):
    """Formats that are read."""

    #: told from the content, not from the name
    AUTO = 0
    #: binary or ASCII
    STL = 1
    #: ASCII, or binary of either byte order
    PLY = 2
    #: `v` and `f` lines; the rest is passed over
    OBJ = 3
    #: ASCII; [ST][C][N]OFF
    OFF = 4


class FeaturesWarning(IntFlag):
    """What the detection found odd about the scan as a whole. Results are there all the same, and may be wrong or not
    all there is."""

    #: the faces look inwards: harmless
    INSIDE_OUT = 1
    #: teeth look both ways: two jaws in occlusion, or the direction is wrong
    OPPOSED = 2
    #: much that is as rough as teeth lies off the arch, or the arch is longer than any jaw's: two jaws side by side
    SEVERAL_ARCHES = 4


class Preset(Enum):
    """What options are initialised to."""

    #: the best we know: docs/method.md
    DEFAULT = 0
    #: the paper to the letter
    PAPER = 1


class Weights(Enum):
    """Weights of the Laplacian (paper, "Selection of weighting scheme"; Fig. 10)."""

    #: beta + (1 - beta) exp(-c / c0), c the concavity at a physical radius
    CONCAVITY = 0
    #: Eq. 8 with the test of Eq. 9
    PAPER = 1
    #: paper ref. 39, negative cotangents clamped
    COTANGENT = 2
    #: 1
    UNIFORM = 3
    #: feature-preserving, as paper ref. 40: Eq. 8 without its test, so that every bend counts, convex or concave (the
    #: paper does not print the formula of ref. 40)
    FEATURE = 4


class Background(Enum):
    """What is held at the background value beside the neighbour tooth."""

    #: nothing: the paper's pair
    NEIGHBOUR = 0
    #: vertices far from every feature point
    GINGIVA = 1
    #: these, and the points of all other groups
    ALL = 2


class CutRule(Enum):
    """How the contour of a tooth is chosen."""

    #: the paper's: largest mean gradient in [0, V_med] and (V_med, 1]
    GRADIENT = 0
    #: the component around the seeds with the best concavity x gradient, and a tooth's area
    COMPONENT = 1
    #: the contour half way between the tooth's value and the background's
    HALF = 2


class ToothWarning(IntFlag):
    """What looks wrong about a tooth."""

    #: under area_min
    AREA_SMALL = 1
    #: over area_max
    AREA_LARGE = 2
    #: the crown runs into a border of the scan
    OPEN_AT_BORDER = 4
    #: the cut is not one closed line
    SEVERAL_LOOPS = 8
    #: no neighbour was there to be background
    NO_NEIGHBOUR = 16
    #: a feature point contradicted the field and was not used
    SEED_REJECTED = 32
    #: wider or narrower along the arch than a tooth is, or than its stretch of the arch
    WIDTH = 64
    #: a feature point of another group lies on it, before overlaps are resolved
    TWO_GROUPS = 128
    #: its top is one plane: a scan body or a post, not a crown
    FLAT_TOP = 256
    #: no feature group lies on it: the click alone says that it is a tooth
    MADE_BY_CLICK = 512


class Jaw(Enum):
    """The jaw of a scan."""

    #: not known
    UNKNOWN = 0
    #: maxilla
    UPPER = 1
    #: mandible
    LOWER = 2


class EditKind(Enum):
    """What an edit did."""

    #: ts_cut_drag
    DRAG = 1
    #: ts_cut_draw
    DRAW = 2
    #: ts_cut_offset
    OFFSET = 3
    #: ts_cut_smooth
    SMOOTH = 4


class MeshVertexFlag(IntFlag):
    """What a vertex is."""

    #: shared with another part
    ON_CUT = 1
    #: on a rim of the scan
    ON_RIM = 2
    #: made to close the mesh
    OF_FILL = 4


class OutputFormat(Enum):
    """Formats that are written."""

    #: binary; floats
    STL = 0
    #: binary; floats; red, green, blue (uchar) and label (int) a triangle
    PLY = 1
    #: a group a part, of shared vertices
    OBJ = 2
    #: glTF 2.0 binary, in m as it has to be: a mesh and a node a part, floats
    GLB = 3


class ts_context(Structure):
    pass


class ts_job(Structure):
    pass


class ts_model(Structure):
    pass


class ts_features(Structure):
    pass


class ts_segmentation(Structure):
    pass


class ts_mesh(Structure):
    pass


class ts_context_options(Structure):
    pass


class ts_mesh_input(Structure):
    pass


class ts_intake_options(Structure):
    pass


class ts_intake_report(Structure):
    pass


class ts_surface_point(Structure):
    pass


class ts_feature_options(Structure):
    pass


class ts_features_info(Structure):
    pass


class ts_feature_point(Structure):
    pass


class ts_feature_group(Structure):
    pass


class ts_segment_options(Structure):
    pass


class ts_click_times(Structure):
    pass


class ts_click_info(Structure):
    pass


class ts_contour_info(Structure):
    pass


class ts_edge_point(Structure):
    pass


class ts_tooth_info(Structure):
    pass


class ts_cut_info(Structure):
    pass


class ts_prepare_times(Structure):
    pass


class ts_memory_info(Structure):
    pass


class ts_review_item(Structure):
    pass


class ts_overlap(Structure):
    pass


class ts_history_info(Structure):
    pass


class ts_number_options(Structure):
    pass


class ts_number_info(Structure):
    pass


class ts_jaw_info(Structure):
    pass


class ts_palmer(Structure):
    pass


class ts_cut_edit(Structure):
    pass


class ts_tooth_mesh_options(Structure):
    pass


class ts_mesh_info(Structure):
    pass


class ts_save_options(Structure):
    pass


class ts_tooth_frame(Structure):
    pass


ts_alloc_fn = CFUNCTYPE(c_void_p, c_size_t, c_void_p)
ts_free_fn = CFUNCTYPE(None, c_void_p, c_void_p)
ts_log_fn = CFUNCTYPE(None, c_int32, c_char_p, c_void_p)
ts_progress_fn = CFUNCTYPE(c_int, c_double, c_char_p, c_void_p)
ts_change_fn = CFUNCTYPE(None, c_void_p, POINTER(c_uint32), c_uint32)

ts_context_options._fields_ = [("struct_size", c_uint32), ("threads", c_uint32), ("alloc", ts_alloc_fn),
        ("free", ts_free_fn), ("alloc_user", c_void_p), ("log", ts_log_fn), ("log_user", c_void_p)]
ts_mesh_input._fields_ = [("struct_size", c_uint32), ("scalar", c_int32), ("positions", c_void_p),
        ("vertex_count", c_uint32), ("stride", c_uint32), ("triangles", POINTER(c_uint32)),
        ("triangle_count", c_uint32), ("reserved", c_uint32)]
ts_intake_options._fields_ = [("struct_size", c_uint32), ("unit", c_int32), ("weld_tolerance", c_double)]
ts_intake_report._fields_ = [("struct_size", c_uint32), ("input_vertices", c_uint32), ("input_faces", c_uint32),
        ("polygons", c_uint32), ("welded_vertices", c_uint32), ("unreferenced_vertices", c_uint32),
        ("degenerate_faces", c_uint32), ("duplicate_faces", c_uint32), ("flipped_faces", c_uint32),
        ("non_manifold_edges", c_uint32), ("non_manifold_vertices", c_uint32), ("unorientable_edges", c_uint32),
        ("vertices", c_uint32), ("faces", c_uint32), ("components", c_uint32), ("boundary_loops", c_uint32),
        ("diagonal", c_double), ("area", c_double), ("mean_edge", c_double)]
ts_surface_point._fields_ = [("face", c_uint32), ("nearest_vertex", c_uint32), ("barycentric", c_double * 3),
        ("position", c_double * 3), ("distance", c_double)]
ts_feature_options._fields_ = [("struct_size", c_uint32), ("max_points", c_uint32), ("occlusal", c_double * 3),
        ("radius", c_double)]
ts_features_info._fields_ = [("struct_size", c_uint32), ("groups", c_uint32), ("points", c_uint32),
        ("inside_out", c_uint32), ("warnings", c_uint32), ("reserved", c_uint32), ("opposed", c_double),
        ("coverage", c_double), ("arch_length", c_double)]
ts_feature_point._fields_ = [("id", c_uint32), ("group", c_uint32), ("vertex", c_uint32), ("by_hand", c_uint32),
        ("position", c_double * 3), ("convexity", c_double)]
ts_feature_group._fields_ = [("id", c_uint32), ("points", c_uint32), ("previous", c_uint32), ("next", c_uint32),
        ("centre", c_double * 3), ("arch_from", c_double), ("arch_to", c_double), ("confidence", c_double)]
ts_segment_options._fields_ = [("struct_size", c_uint32), ("preset", c_int32), ("weights", c_int32),
        ("background", c_int32), ("cut_rule", c_int32), ("contours", c_uint32), ("histogram_bins", c_uint32),
        ("points_per_group", c_uint32), ("alpha", c_double), ("beta", c_double), ("gamma", c_double),
        ("theta", c_double), ("c0", c_double), ("normal_radius", c_double), ("seed_radius", c_double),
        ("gingiva_distance", c_double), ("area_min", c_double), ("area_max", c_double), ("hole_area", c_double),
        ("refine_band", c_double), ("smooth_radius", c_double), ("click_reach", c_double),
        ("click_concavity", c_double), ("reject_outliers", c_uint32), ("memory_limit", c_uint64)]
ts_click_times._fields_ = [("pick", c_double), ("field", c_double), ("cut", c_double), ("label", c_double),
        ("total", c_double)]
ts_click_info._fields_ = [("struct_size", c_uint32), ("target", c_uint32), ("neighbour", c_uint32),
        ("position", c_double * 3), ("target_distance", c_double), ("neighbour_distance", c_double),
        ("v_med", c_double), ("target_iso", c_double), ("neighbour_iso", c_double), ("ms", ts_click_times)]
ts_contour_info._fields_ = [("iso", c_double), ("gradient", c_double), ("concavity", c_double), ("length", c_double),
        ("points", c_uint32), ("polylines", c_uint32), ("chosen", c_uint32)]
ts_edge_point._fields_ = [("a", c_uint32), ("b", c_uint32), ("t", c_double), ("position", c_double * 3)]
ts_tooth_info._fields_ = [("struct_size", c_uint32), ("id", c_uint32), ("label", c_uint32), ("click", c_uint32),
        ("faces", c_uint32), ("vertices", c_uint32), ("loops", c_uint32), ("seeds", c_uint32), ("area", c_double),
        ("iso", c_double), ("gradient", c_double), ("confidence", c_double), ("warnings", c_uint32),
        ("reserved", c_uint32)]
ts_cut_info._fields_ = [("struct_size", c_uint32), ("points", c_uint32), ("closed", c_uint32), ("length", c_double),
        ("iso", c_double), ("gradient", c_double), ("concavity", c_double)]
ts_prepare_times._fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("intake", c_double),
        ("features", c_double), ("weights", c_double), ("factorise", c_double)]
ts_memory_info._fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("model", c_uint64),
        ("segmentation", c_uint64), ("factor", c_uint64), ("factor_whole", c_uint64), ("click", c_uint64)]
ts_review_item._fields_ = [("tooth", c_uint32), ("separated", c_uint32), ("warnings", c_uint32), ("reserved", c_uint32),
        ("confidence", c_double), ("group_confidence", c_double)]
ts_overlap._fields_ = [("winner", c_uint32), ("loser", c_uint32), ("faces", c_uint32), ("reserved", c_uint32),
        ("area", c_double)]
ts_history_info._fields_ = [("struct_size", c_uint32), ("undo", c_uint32), ("redo", c_uint32), ("complete", c_uint32),
        ("bytes", c_uint64), ("limit", c_uint64)]
ts_number_options._fields_ = [("struct_size", c_uint32), ("jaw", c_int32), ("mirrored", c_uint32),
        ("reserved", c_uint32), ("least_confidence", c_double)]
ts_number_info._fields_ = [("struct_size", c_uint32), ("fdi", c_uint32), ("set_by_hand", c_uint32),
        ("uncertain", c_uint32), ("confidence", c_double)]
ts_jaw_info._fields_ = [("struct_size", c_uint32), ("jaw", c_int32), ("given", c_uint32), ("uncertain", c_uint32),
        ("confidence", c_double)]
ts_palmer._fields_ = [("struct_size", c_uint32), ("quadrant", c_uint32), ("position", c_uint32),
        ("letters", c_char * 4), ("symbol", c_char * 8)]
ts_cut_edit._fields_ = [("kind", c_int32), ("status", c_int32), ("points", c_uint32), ("reserved", c_uint32),
        ("amount", c_double), ("from", c_double * 3), ("to", c_double * 3)]
ts_tooth_mesh_options._fields_ = [("struct_size", c_uint32), ("closed", c_uint32)]
ts_mesh_info._fields_ = [("struct_size", c_uint32), ("label", c_uint32), ("vertices", c_uint32),
        ("triangles", c_uint32), ("fill_triangles", c_uint32), ("cut_vertices", c_uint32), ("open_rims", c_uint32),
        ("closed_rims", c_uint32), ("components", c_uint32), ("trimmed", c_uint32), ("area", c_double),
        ("fill_area", c_double), ("volume", c_double), ("lost", c_double)]
ts_save_options._fields_ = [("struct_size", c_uint32), ("whole_faces", c_uint32)]
ts_tooth_frame._fields_ = [("struct_size", c_uint32), ("from_arch", c_uint32), ("centre", c_double * 3),
        ("occlusal", c_double * 3), ("mesial", c_double * 3), ("buccal", c_double * 3), ("width", c_double),
        ("depth", c_double), ("height", c_double)]

#: name: (what it returns, its arguments)
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "ts_version": (c_char_p, []),
    "ts_status_name": (c_char_p, [c_int32]),
    "ts_last_error_message": (c_char_p, []),
    "ts_context_options_init": (c_int32, [POINTER(ts_context_options), c_uint32]),
    "ts_context_create": (c_int32, [POINTER(ts_context_options), POINTER(POINTER(ts_context))]),
    "ts_context_destroy": (None, [POINTER(ts_context)]),
    "ts_job_create": (c_int32, [POINTER(ts_context), ts_progress_fn, c_void_p, POINTER(POINTER(ts_job))]),
    "ts_job_cancel": (None, [POINTER(ts_job)]),
    "ts_job_reset": (None, [POINTER(ts_job)]),
    "ts_job_progress": (c_double, [POINTER(ts_job)]),
    "ts_job_destroy": (None, [POINTER(ts_job)]),
    "ts_mesh_input_init": (c_int32, [POINTER(ts_mesh_input), c_uint32]),
    "ts_intake_options_init": (c_int32, [POINTER(ts_intake_options), c_uint32]),
    "ts_model_create": (c_int32, [POINTER(ts_context), POINTER(ts_mesh_input), POINTER(ts_intake_options),
        POINTER(ts_job), POINTER(POINTER(ts_model))]),
    "ts_model_load": (c_int32, [POINTER(ts_context), c_char_p, POINTER(ts_intake_options), POINTER(ts_job),
        POINTER(POINTER(ts_model))]),
    "ts_model_read": (c_int32, [POINTER(ts_context), c_void_p, c_size_t, c_int32, POINTER(ts_intake_options),
        POINTER(ts_job), POINTER(POINTER(ts_model))]),
    "ts_model_destroy": (None, [POINTER(ts_model)]),
    "ts_model_get_report": (c_int32, [POINTER(ts_model), POINTER(ts_intake_report)]),
    "ts_model_get_positions": (c_int32, [POINTER(ts_model), POINTER(c_double), c_uint32, POINTER(c_uint32)]),
    "ts_model_get_triangles": (c_int32, [POINTER(ts_model), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_model_get_face_sources": (c_int32, [POINTER(ts_model), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_model_get_vertex_map": (c_int32, [POINTER(ts_model), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_model_nearest": (c_int32, [POINTER(ts_model), POINTER(c_double), POINTER(ts_surface_point)]),
    "ts_model_raycast": (c_int32, [POINTER(ts_model), POINTER(c_double), POINTER(c_double), POINTER(ts_surface_point)]),
    "ts_feature_options_init": (c_int32, [POINTER(ts_feature_options), c_uint32]),
    "ts_detect_features": (c_int32, [POINTER(ts_model), POINTER(ts_feature_options), POINTER(ts_job),
        POINTER(POINTER(ts_features))]),
    "ts_features_create": (c_int32, [POINTER(ts_model), POINTER(POINTER(ts_features))]),
    "ts_features_clone": (c_int32, [POINTER(ts_features), POINTER(POINTER(ts_features))]),
    "ts_features_destroy": (None, [POINTER(ts_features)]),
    "ts_features_get_info": (c_int32, [POINTER(ts_features), POINTER(ts_features_info)]),
    "ts_features_get_occlusal": (c_int32, [POINTER(ts_features), POINTER(c_double)]),
    "ts_features_set_occlusal": (c_int32, [POINTER(ts_features), POINTER(c_double)]),
    "ts_features_get_arch": (c_int32, [POINTER(ts_features), POINTER(c_double), c_uint32, POINTER(c_uint32)]),
    "ts_features_get_points": (c_int32, [POINTER(ts_features), POINTER(ts_feature_point), c_uint32, POINTER(c_uint32)]),
    "ts_features_get_groups": (c_int32, [POINTER(ts_features), POINTER(ts_feature_group), c_uint32, POINTER(c_uint32)]),
    "ts_features_add_point": (c_int32, [POINTER(ts_features), POINTER(c_double), c_uint32, POINTER(c_uint32),
        POINTER(c_uint32)]),
    "ts_features_move_point": (c_int32, [POINTER(ts_features), c_uint32, POINTER(c_double)]),
    "ts_features_set_group": (c_int32, [POINTER(ts_features), c_uint32, c_uint32, POINTER(c_uint32)]),
    "ts_features_remove_point": (c_int32, [POINTER(ts_features), c_uint32]),
    "ts_features_remove_group": (c_int32, [POINTER(ts_features), c_uint32]),
    "ts_segment_options_init": (c_int32, [POINTER(ts_segment_options), c_uint32, c_int32]),
    "ts_segmentation_create": (c_int32, [POINTER(ts_features), POINTER(ts_segment_options), POINTER(ts_job),
        POINTER(POINTER(ts_segmentation))]),
    "ts_segmentation_destroy": (None, [POINTER(ts_segmentation)]),
    "ts_segment_click": (c_int32, [POINTER(ts_segmentation), POINTER(c_double), POINTER(ts_job), POINTER(c_uint32)]),
    "ts_segment_clicks": (c_int32, [POINTER(ts_segmentation), POINTER(c_double), c_uint32, POINTER(ts_job),
        POINTER(c_int32)]),
    "ts_propose_clicks": (c_int32, [POINTER(ts_segmentation), POINTER(c_double), c_uint32, POINTER(c_uint32)]),
    "ts_get_click_count": (c_int32, [POINTER(ts_segmentation), POINTER(c_uint32)]),
    "ts_get_click": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_click_info)]),
    "ts_get_field": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_double), c_uint32, POINTER(c_uint32)]),
    "ts_get_histogram": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_get_contours": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_contour_info), c_uint32,
        POINTER(c_uint32)]),
    "ts_get_contour_points": (c_int32, [POINTER(ts_segmentation), c_uint32, c_uint32, POINTER(ts_edge_point), c_uint32,
        POINTER(c_uint32), POINTER(c_uint32), POINTER(c_uint8)]),
    "ts_get_teeth": (c_int32, [POINTER(ts_segmentation), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_get_tooth": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_tooth_info)]),
    "ts_get_tooth_faces": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_uint32), c_uint32,
        POINTER(c_uint32)]),
    "ts_get_tooth_vertices": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_uint32), c_uint32,
        POINTER(c_uint32)]),
    "ts_get_tooth_seeds": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_uint32), c_uint32,
        POINTER(c_uint32)]),
    "ts_get_cut": (c_int32, [POINTER(ts_segmentation), c_uint32, c_uint32, POINTER(ts_cut_info), POINTER(ts_edge_point),
        c_uint32, POINTER(c_uint32)]),
    "ts_get_labels": (c_int32, [POINTER(ts_segmentation), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_get_prepare_times": (c_int32, [POINTER(ts_segmentation), POINTER(ts_prepare_times)]),
    "ts_get_memory": (c_int32, [POINTER(ts_segmentation), POINTER(ts_memory_info)]),
    "ts_segment_all": (c_int32, [POINTER(ts_segmentation), POINTER(ts_job)]),
    "ts_get_review": (c_int32, [POINTER(ts_segmentation), POINTER(ts_review_item), c_uint32, POINTER(c_uint32)]),
    "ts_tooth_include": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_double), POINTER(ts_job)]),
    "ts_tooth_exclude": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_double), POINTER(ts_job)]),
    "ts_tooth_split": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_double), POINTER(c_double),
        POINTER(ts_job), POINTER(c_uint32)]),
    "ts_tooth_move_point": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_double), POINTER(c_double),
        POINTER(ts_job)]),
    "ts_tooth_merge": (c_int32, [POINTER(ts_segmentation), c_uint32, c_uint32, POINTER(ts_job)]),
    "ts_tooth_remove": (c_int32, [POINTER(ts_segmentation), c_uint32]),
    "ts_tooth_set_locked": (c_int32, [POINTER(ts_segmentation), c_uint32, c_uint32]),
    "ts_tooth_get_locked": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_uint32)]),
    "ts_get_overlaps": (c_int32, [POINTER(ts_segmentation), POINTER(ts_overlap), c_uint32, POINTER(c_uint32)]),
    "ts_undo": (c_int32, [POINTER(ts_segmentation)]),
    "ts_redo": (c_int32, [POINTER(ts_segmentation)]),
    "ts_get_history": (c_int32, [POINTER(ts_segmentation), POINTER(ts_history_info)]),
    "ts_set_history_limit": (c_int32, [POINTER(ts_segmentation), c_uint64]),
    "ts_get_changes": (c_int32, [POINTER(ts_segmentation), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_set_change_callback": (c_int32, [POINTER(ts_segmentation), ts_change_fn, c_void_p]),
    "ts_session_write": (c_int32, [POINTER(ts_segmentation), POINTER(c_char), c_uint32, POINTER(c_uint32)]),
    "ts_session_save": (c_int32, [POINTER(ts_segmentation), c_char_p]),
    "ts_session_read": (c_int32, [POINTER(ts_model), c_char_p, c_size_t, POINTER(ts_job), POINTER(POINTER(ts_features)),
        POINTER(POINTER(ts_segmentation))]),
    "ts_session_load": (c_int32, [POINTER(ts_model), c_char_p, POINTER(ts_job), POINTER(POINTER(ts_features)),
        POINTER(POINTER(ts_segmentation))]),
    "ts_number_options_init": (c_int32, [POINTER(ts_number_options), c_uint32]),
    "ts_assign_numbers": (c_int32, [POINTER(ts_segmentation), POINTER(ts_number_options)]),
    "ts_set_number": (c_int32, [POINTER(ts_segmentation), c_uint32, c_uint32]),
    "ts_get_number": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_number_info)]),
    "ts_get_jaw": (c_int32, [POINTER(ts_segmentation), POINTER(ts_jaw_info)]),
    "ts_fdi_to_universal": (c_int32, [c_uint32, POINTER(c_uint32)]),
    "ts_universal_to_fdi": (c_int32, [c_uint32, POINTER(c_uint32)]),
    "ts_fdi_to_palmer": (c_int32, [c_uint32, POINTER(ts_palmer)]),
    "ts_cut_drag": (c_int32, [POINTER(ts_segmentation), c_uint32, c_uint32, c_uint32, POINTER(c_double), c_double,
        POINTER(ts_job)]),
    "ts_cut_draw": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(c_double), c_uint32, POINTER(ts_job)]),
    "ts_cut_offset": (c_int32, [POINTER(ts_segmentation), c_uint32, c_double, POINTER(ts_job)]),
    "ts_cut_smooth": (c_int32, [POINTER(ts_segmentation), c_uint32, c_double, POINTER(ts_job)]),
    "ts_cut_reset": (c_int32, [POINTER(ts_segmentation), c_uint32]),
    "ts_get_cut_edits": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_cut_edit), c_uint32,
        POINTER(c_uint32)]),
    "ts_tooth_mesh_options_init": (c_int32, [POINTER(ts_tooth_mesh_options), c_uint32]),
    "ts_tooth_mesh_create": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_tooth_mesh_options),
        POINTER(ts_job), POINTER(POINTER(ts_mesh))]),
    "ts_gingiva_mesh_create": (c_int32, [POINTER(ts_segmentation), POINTER(ts_tooth_mesh_options), POINTER(ts_job),
        POINTER(POINTER(ts_mesh))]),
    "ts_mesh_destroy": (None, [POINTER(ts_mesh)]),
    "ts_mesh_get_info": (c_int32, [POINTER(ts_mesh), POINTER(ts_mesh_info)]),
    "ts_mesh_get_positions": (c_int32, [POINTER(ts_mesh), POINTER(c_double), c_uint32, POINTER(c_uint32)]),
    "ts_mesh_get_normals": (c_int32, [POINTER(ts_mesh), POINTER(c_double), c_uint32, POINTER(c_uint32)]),
    "ts_mesh_get_triangles": (c_int32, [POINTER(ts_mesh), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_mesh_get_faces": (c_int32, [POINTER(ts_mesh), POINTER(c_uint32), c_uint32, POINTER(c_uint32)]),
    "ts_mesh_get_vertex_flags": (c_int32, [POINTER(ts_mesh), POINTER(c_uint8), c_uint32, POINTER(c_uint32)]),
    "ts_mesh_save": (c_int32, [POINTER(ts_mesh), c_char_p, c_int32, POINTER(ts_job)]),
    "ts_save_options_init": (c_int32, [POINTER(ts_save_options), c_uint32]),
    "ts_segmentation_save": (c_int32, [POINTER(ts_segmentation), c_char_p, c_int32, POINTER(ts_save_options),
        POINTER(ts_job)]),
    "ts_get_tooth_frame": (c_int32, [POINTER(ts_segmentation), c_uint32, POINTER(ts_tooth_frame)]),
}


def bind(library: ctypes.CDLL) -> ctypes.CDLL:
    """Tells ctypes the types of all functions. AttributeError where the library lacks one."""
    for name, (returns, arguments) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = returns, arguments
    return library
