// toothseg's C functions, 0.1.0, as they are. The unit to program with is toothseg.pas.
// SPDX-License-Identifier: Apache-2.0
// Made by generate.py from abi/toothseg.json; do not edit.
//
// The library is bound when the program is linked or, with TOOTHSEG_DYNAMIC defined, by ts_load.
// C++ expects floating-point exceptions to be masked, and Pascal does not mask them: whoever calls these functions has
// to mask them first. toothseg.pas does.
unit toothseg_api;

{$IFDEF FPC}
{$MODE DELPHI}
{$PACKRECORDS C}
{$ELSE}
{$ALIGN 8}
{$ENDIF}
{$MINENUMSIZE 4}

interface

{$IFNDEF TOOTHSEG_DYNAMIC}
const
{$IFDEF MSWINDOWS}
  TS_LIBRARY = 'toothseg.dll';
{$ELSE}
{$IFDEF FPC}
  TS_LIBRARY = 'toothseg';
{$ELSE}
  TS_LIBRARY = {$IFDEF MACOS}'libtoothseg.dylib'{$ELSE}'libtoothseg.so.0'{$ENDIF};
{$ENDIF}
{$ENDIF}

{$ENDIF}
const
  TS_VERSION_MAJOR = 0;
  TS_VERSION_MINOR = 1;
  TS_VERSION_PATCH = 0;
  TS_NONE = 4294967295;

  // ts_status: What came of a call. Values are fixed for ever; new ones are added within their block.
  TS_OK = 0; // done
  TS_E_INVALID_ARGUMENT = 100; // a value outside its stated range
  TS_E_NULL = 101; // a pointer that must not be NULL is
  TS_E_STRUCT_SIZE = 102; // struct_size is 0, or no size that any release had
  TS_E_BUFFER_TOO_SMALL = 103; // capacity is less than the number of elements
  TS_E_NOT_FOUND = 104; // no such group, point, click, tooth, loop or contour
  TS_E_MISMATCH = 105; // objects that do not belong together (features of another model)
  TS_E_OUT_OF_MEMORY = 200; // an allocation failed, or memory_limit is too small for any way of work
  TS_E_CANCELLED = 201; // the job was cancelled, by ts_job_cancel or its callback
  TS_E_INTERNAL = 202; // a fault in the library: please report the message
  TS_E_FILE_OPEN = 300; // cannot be opened or read
  TS_E_FILE_FORMAT = 301; // not STL, PLY, OBJ or OFF, or a variant that is not read
  TS_E_FILE_TRUNCATED = 302; // ends before what its header or its last statement promises
  TS_E_FILE_TRAILING = 303; // goes on after what its header promises
  TS_E_FILE_COUNT = 304; // a count that the file's size contradicts
  TS_E_FILE_SYNTAX = 305; // text where a number or keyword belongs; the message has the line
  TS_E_FILE_WRITE = 306; // cannot be written; nothing is left half written
  TS_E_FILE_NEWER = 307; // a session of a later format than this library reads
  TS_E_MESH_EMPTY = 400; // no face, or none that is not degenerate
  TS_E_MESH_NON_FINITE = 401; // NaN or infinity among the coordinates
  TS_E_MESH_INDEX_RANGE = 402; // a triangle names a vertex that is not there
  TS_E_MESH_UNITS = 403; // too small or too large for a scan in mm: probably in other units
  TS_E_MESH_TOO_LARGE = 404; // more than 2^30 faces or vertices, or coordinates beyond 1e9 mm
  TS_E_NO_TEETH = 500; // nothing on the mesh looks like a tooth
  TS_E_NO_CONSTRAINT = 501; // no group with a point: there is nothing to separate
  TS_E_CLICK_OFF_SURFACE = 600; // the click is further from the surface than click_reach
  TS_E_CLICK_ON_GINGIVA = 601; // the click lies on gingiva or base, not on a tooth
  TS_E_NO_CUT = 602; // no contour of the field separates the tooth
  TS_E_SOLVER = 603; // the linear system could not be factorised
  TS_E_LOCKED = 604; // the tooth is locked, and the call would change it
  TS_E_NO_CHANGE = 605; // what is asked for is so already
  TS_E_NO_HISTORY = 606; // nothing to undo, or to redo
  TS_E_EDIT_NOTHING = 650; // the edit would change nothing: a drag to where the point is, a stroke of no length
  TS_E_EDIT_ON_TOOTH = 651; // the new line would run on another tooth, or take in its feature points
  // the new line would cross the rest of the cut, or part the tooth's feature points from it
  TS_E_EDIT_CROSSING = 652;
  TS_E_EDIT_OFF_CUT = 653; // the edit does not come near the cut that it is to change
  TS_E_EDIT_NO_LOOP = 654; // a loop of the cut would vanish, or become several
  TS_E_TOO_MANY_TEETH = 700; // more teeth along the arch than the 16 that a jaw has
  TS_E_NUMBER_JAW = 701; // a number of the other jaw
  TS_E_NUMBER_TAKEN = 702; // the number has been set for another tooth
  TS_E_NUMBER_ORDER = 703; // numbers would not rise along the arch, or leave none for the teeth between
  TS_E_NOT_CLOSED = 750; // a rim cannot be closed without the mesh running through itself

  // ts_features_warning: What the detection found odd about the scan as a whole. Results are there all the same, and
  // may be wrong or not all there is.
  TS_WARN_FEATURES_INSIDE_OUT = 1; // the faces look inwards: harmless
  TS_WARN_FEATURES_OPPOSED = 2; // teeth look both ways: two jaws in occlusion, or the direction is wrong
  // much that is as rough as teeth lies off the arch, or the arch is longer than any jaw's: two jaws side by side
  TS_WARN_FEATURES_SEVERAL_ARCHES = 4;

  // ts_tooth_warning: What looks wrong about a tooth.
  TS_WARN_AREA_SMALL = 1; // under area_min
  TS_WARN_AREA_LARGE = 2; // over area_max
  TS_WARN_OPEN_AT_BORDER = 4; // the crown runs into a border of the scan
  TS_WARN_SEVERAL_LOOPS = 8; // the cut is not one closed line
  TS_WARN_NO_NEIGHBOUR = 16; // no neighbour was there to be background
  TS_WARN_SEED_REJECTED = 32; // a feature point contradicted the field and was not used
  TS_WARN_WIDTH = 64; // wider or narrower along the arch than a tooth is, or than its stretch of the arch
  TS_WARN_TWO_GROUPS = 128; // a feature point of another group lies on it, before overlaps are resolved
  TS_WARN_FLAT_TOP = 256; // its top is one plane: a scan body or a post, not a crown
  TS_WARN_MADE_BY_CLICK = 512; // no feature group lies on it: the click alone says that it is a tooth

  // ts_mesh_vertex_flag: What a vertex is.
  TS_VERTEX_ON_CUT = 1; // shared with another part
  TS_VERTEX_ON_RIM = 2; // on a rim of the scan
  TS_VERTEX_OF_FILL = 4; // made to close the mesh

type
  ts_status = Integer;
  Pts_status = ^ts_status;

  // How much a line of the log matters.
  ts_log_level = (
    TS_LOG_ERROR = 0, // not used so far: a call that fails says so in its status
    TS_LOG_WARNING = 1, // the call did its work, and something about it is odd
    TS_LOG_INFO = 2 // what was found and how long it took
  );
  Pts_log_level = ^ts_log_level;

  // Type of the caller's coordinates.
  ts_scalar = (
    TS_FLOAT32 = 0, // float
    TS_FLOAT64 = 1 // double
  );
  Pts_scalar = ^ts_scalar;

  // Unit of the caller's coordinates. TS_UNIT_CHECKED_MM: mm, and TS_E_MESH_UNITS if the size of the mesh contradicts
  // it (bounding box diagonal under 9 or over 400); the others convert without a check of the size, as long as
  // coordinates stay within 1e9 mm. Distances of the library are of teeth in mm, whatever the size: on a surface over
  // 400 mm across no teeth are found (TS_E_NO_TEETH), and parts under 0.5 mm are not closed (TS_E_NOT_CLOSED).
  ts_unit = (
    TS_UNIT_CHECKED_MM = 0, // mm, checked
    TS_UNIT_MM = 1, // mm, whatever the size
    TS_UNIT_CM = 2, // 10 mm
    TS_UNIT_M = 3, // 1000 mm
    TS_UNIT_INCH = 4 // 25.4 mm
  );
  Pts_unit = ^ts_unit;

  // Formats that are read.
  ts_file_format = (
    TS_FORMAT_AUTO = 0, // told from the content, not from the name
    TS_FORMAT_STL = 1, // binary or ASCII
    TS_FORMAT_PLY = 2, // ASCII, or binary of either byte order
    TS_FORMAT_OBJ = 3, // `v` and `f` lines; the rest is passed over
    TS_FORMAT_OFF = 4 // ASCII; [ST][C][N]OFF
  );
  Pts_file_format = ^ts_file_format;

  ts_features_warning = Integer;
  Pts_features_warning = ^ts_features_warning;

  // What options are initialised to.
  ts_preset = (
    TS_PRESET_DEFAULT = 0, // the best we know: docs/method.md
    TS_PRESET_PAPER = 1 // the paper to the letter
  );
  Pts_preset = ^ts_preset;

  // Weights of the Laplacian (paper, "Selection of weighting scheme"; Fig. 10).
  ts_weights = (
    TS_WEIGHTS_CONCAVITY = 0, // beta + (1 - beta) exp(-c / c0), c the concavity at a physical radius
    TS_WEIGHTS_PAPER = 1, // Eq. 8 with the test of Eq. 9
    TS_WEIGHTS_COTANGENT = 2, // paper ref. 39, negative cotangents clamped
    TS_WEIGHTS_UNIFORM = 3, // 1
    // feature-preserving, as paper ref. 40: Eq. 8 without its test, so that every bend counts, convex or concave (the
    // paper does not print the formula of ref. 40)
    TS_WEIGHTS_FEATURE = 4
  );
  Pts_weights = ^ts_weights;

  // What is held at the background value beside the neighbour tooth.
  ts_background = (
    TS_BACKGROUND_NEIGHBOUR = 0, // nothing: the paper's pair
    TS_BACKGROUND_GINGIVA = 1, // vertices far from every feature point
    TS_BACKGROUND_ALL = 2 // these, and the points of all other groups
  );
  Pts_background = ^ts_background;

  // How the contour of a tooth is chosen.
  ts_cut_rule = (
    TS_CUT_GRADIENT = 0, // the paper's: largest mean gradient in [0, V_med] and (V_med, 1]
    TS_CUT_COMPONENT = 1, // the component around the seeds with the best concavity x gradient, and a tooth's area
    TS_CUT_HALF = 2 // the contour half way between the tooth's value and the background's
  );
  Pts_cut_rule = ^ts_cut_rule;

  ts_tooth_warning = Integer;
  Pts_tooth_warning = ^ts_tooth_warning;

  // The jaw of a scan.
  ts_jaw = (
    TS_JAW_UNKNOWN = 0, // not known
    TS_JAW_UPPER = 1, // maxilla
    TS_JAW_LOWER = 2 // mandible
  );
  Pts_jaw = ^ts_jaw;

  // What an edit did.
  ts_edit_kind = (
    TS_EDIT_DRAG = 1, // ts_cut_drag
    TS_EDIT_DRAW = 2, // ts_cut_draw
    TS_EDIT_OFFSET = 3, // ts_cut_offset
    TS_EDIT_SMOOTH = 4 // ts_cut_smooth
  );
  Pts_edit_kind = ^ts_edit_kind;

  ts_mesh_vertex_flag = Integer;
  Pts_mesh_vertex_flag = ^ts_mesh_vertex_flag;

  // Formats that are written.
  ts_output_format = (
    TS_OUTPUT_STL = 0, // binary; floats
    TS_OUTPUT_PLY = 1, // binary; floats; red, green, blue (uchar) and label (int) a triangle
    TS_OUTPUT_OBJ = 2, // a group a part, of shared vertices
    TS_OUTPUT_GLB = 3 // glTF 2.0 binary, in m as it has to be: a mesh and a node a part, floats
  );
  Pts_output_format = ^ts_output_format;

  // Holds the hooks (allocator, log, threads) for all objects made from it.
  ts_context = record end;
  Pts_context = ^ts_context;
  PPts_context = ^Pts_context;

  // Progress and cancellation of one long call at a time. Every long call takes a ts_job pointer, which may be NULL.
  ts_job = record end;
  Pts_job = ^ts_job;
  PPts_job = ^Pts_job;

  // A mesh after intake: welded, clean, manifold, consistently wound. Never changes once made.
  ts_model = record end;
  Pts_model = ^ts_model;
  PPts_model = ^Pts_model;

  // Feature points of the teeth (cusps, incisal edges: paper ref. 38) in groups, one a tooth (ref. 30), with the
  // occlusal direction and the arch curve they were found with. Can be edited, or built by hand from nothing. A
  // segmentation takes a copy: editing features does not change one already made.
  ts_features = record end;
  Pts_features = ^ts_features;
  PPts_features = ^Pts_features;

  // A prepared scan and the teeth separated so far.
  ts_segmentation = record end;
  Pts_segmentation = ^ts_segmentation;
  PPts_segmentation = ^Pts_segmentation;

  // A tooth, or the gingiva, as a mesh of its own, cut exactly along the cuts of the teeth: triangles that a cut
  // crosses are split on it. What a tooth's cuts enclose is its own; where the cuts of several teeth enclose the
  // same, it is that of the tooth with the nearest constraint point (ts_get_tooth_seeds), as ts_get_labels has it for
  // whole faces: the teeth meet where these are equally far, and ts_mesh_info::lost says how much that took off. The
  // meshes of all teeth and of the gingiva, open, add up to the model, and vertices on cuts have the same coordinates
  // in both meshes, bit for bit. They belong to the teeth separated when they are made. Never changes once made.
  ts_mesh = record end;
  Pts_mesh = ^ts_mesh;
  PPts_mesh = ^Pts_mesh;

  ts_char4 = array [0 .. 3] of AnsiChar;
  Pts_char4 = ^ts_char4;
  ts_char8 = array [0 .. 7] of AnsiChar;
  Pts_char8 = ^ts_char8;
  ts_double3 = array [0 .. 2] of Double;
  Pts_double3 = ^ts_double3;

  Pts_context_options = ^ts_context_options;
  Pts_mesh_input = ^ts_mesh_input;
  Pts_intake_options = ^ts_intake_options;
  Pts_intake_report = ^ts_intake_report;
  Pts_surface_point = ^ts_surface_point;
  Pts_feature_options = ^ts_feature_options;
  Pts_features_info = ^ts_features_info;
  Pts_feature_point = ^ts_feature_point;
  Pts_feature_group = ^ts_feature_group;
  Pts_segment_options = ^ts_segment_options;
  Pts_click_times = ^ts_click_times;
  Pts_click_info = ^ts_click_info;
  Pts_contour_info = ^ts_contour_info;
  Pts_edge_point = ^ts_edge_point;
  Pts_tooth_info = ^ts_tooth_info;
  Pts_cut_info = ^ts_cut_info;
  Pts_prepare_times = ^ts_prepare_times;
  Pts_memory_info = ^ts_memory_info;
  Pts_review_item = ^ts_review_item;
  Pts_overlap = ^ts_overlap;
  Pts_history_info = ^ts_history_info;
  Pts_number_options = ^ts_number_options;
  Pts_number_info = ^ts_number_info;
  Pts_jaw_info = ^ts_jaw_info;
  Pts_palmer = ^ts_palmer;
  Pts_cut_edit = ^ts_cut_edit;
  Pts_tooth_mesh_options = ^ts_tooth_mesh_options;
  Pts_mesh_info = ^ts_mesh_info;
  Pts_save_options = ^ts_save_options;
  Pts_tooth_frame = ^ts_tooth_frame;

  // Allocator hook. `alloc` returns memory aligned to 16 bytes, or NULL when there is none. Both may be called from
  // any thread that works for the context. The large buffers of the library come from here; Eigen and oneTBB keep
  // their own.
  ts_alloc_fn = function(bytes: NativeUInt; user: Pointer): Pointer; cdecl;

  // Gives back what `alloc` of the same hook gave; `memory` is never NULL.
  ts_free_fn = procedure(memory: Pointer; user: Pointer); cdecl;

  // Log hook: one line without newline, valid during the call only; may come from any thread that works for the
  // context.
  ts_log_fn = procedure(level: ts_log_level; text: PAnsiChar; user: Pointer); cdecl;

  // Called during a long call, from a thread that works for it, one call at a time: `fraction` in [0, 1], never
  // falling within one call; `stage` a short English name. Return 0 to go on, anything else to cancel: sticky, as
  // ts_job_cancel is. Must not call the library.
  ts_progress_fn = function(fraction: Double; stage: PAnsiChar; user: Pointer): Integer; cdecl;

  // Called on the thread of the call that changed something, after the change, with what ts_get_changes tells;
  // `teeth` lives as long as the callback. It may read the segmentation and must not destroy it; calls that would
  // change it are refused (TS_E_INVALID_ARGUMENT).
  ts_change_fn = procedure(user: Pointer; teeth: PCardinal; count: Cardinal); cdecl;

  // Hooks and threads of a context.
  ts_context_options = record
    StructSize: Cardinal; // set by ts_context_options_init
    Threads: Cardinal; // worker threads: 0 = one a core, 1 = only the calling thread, at most 1024. Default 0
    Alloc: ts_alloc_fn; // NULL = the system's; give both or none
    Free: ts_free_fn; // NULL if `alloc` is
    AllocUser: Pointer; // given to both as `user`
    Log: ts_log_fn; // NULL = silent
    LogUser: Pointer; // given to it as `user`
  end;

  // The caller's mesh, read only during ts_model_create.
  ts_mesh_input = record
    StructSize: Cardinal; // set by ts_mesh_input_init
    Scalar: ts_scalar; // type of the coordinates
    Positions: Pointer; // x, y, z of vertex i at byte i * stride
    VertexCount: Cardinal; // number of vertices
    Stride: Cardinal; // bytes from one vertex to the next; 0 = packed (12 or 24)
    Triangles: PCardinal; // 3 indices a face; NULL = soup: vertices 3i, 3i+1, 3i+2 are face i
    TriangleCount: Cardinal; // number of faces; for a soup vertex_count / 3 or 0
    Reserved: Cardinal; // 0
  end;

  // How a mesh is taken in.
  ts_intake_options = record
    StructSize: Cardinal; // set by ts_intake_options_init
    Unit_: ts_unit; // default TS_UNIT_CHECKED_MM
    WeldTolerance: Double; // vertices closer than this become one, mm. Default 0: only exactly equal ones
  end;

  // What intake found and repaired. Counts of the caller's elements unless said otherwise.
  ts_intake_report = record
    StructSize: Cardinal; // in: sizeof this struct
    InputVertices: Cardinal; // as given (a soup: 3 a face)
    InputFaces: Cardinal; // as given; polygons count once
    Polygons: Cardinal; // input faces with more than 3 corners, triangulated
    WeldedVertices: Cardinal; // input vertices merged into another
    UnreferencedVertices: Cardinal; // used by no face: dropped
    DegenerateFaces: Cardinal; // fewer than 3 distinct corners, or no area: dropped
    DuplicateFaces: Cardinal; // same corners as another face: dropped
    FlippedFaces: Cardinal; // wound against the majority of their piece: turned round
    NonManifoldEdges: Cardinal; // edges of more than 2 faces: split
    NonManifoldVertices: Cardinal; // vertices where several fans met: split
    UnorientableEdges: Cardinal; // edges cut open because no winding fits both sides (Moebius)
    Vertices: Cardinal; // of the model
    Faces: Cardinal; // of the model
    Components: Cardinal; // connected pieces of the model
    BoundaryLoops: Cardinal; // open rims of the model
    Diagonal: Double; // of the bounding box, mm
    Area: Double; // mm^2
    MeanEdge: Double; // mm
  end;

  // A point on the surface: a model face and the weights of its three corners (sum 1).
  ts_surface_point = record
    Face: Cardinal; // of the model
    NearestVertex: Cardinal; // the corner with the largest weight
    Barycentric: ts_double3; // weights of its corners, in their order
    Position: ts_double3; // mm
    Distance: Double; // from the query position, or along the ray from its origin, mm
  end;

  // How features are found.
  ts_feature_options = record
    StructSize: Cardinal; // set by ts_feature_options_init
    MaxPoints: Cardinal; // most points a tooth. Default 8
    Occlusal: ts_double3; // a direction to use instead of the estimated one; 0,0,0 = estimate (default)
    Radius: Double; // r of the convexity measure, mm. Default 2.0: about half a cusp's width
  end;

  // Counts of a set of features, and what the detection saw of the scan.
  ts_features_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Groups: Cardinal; // number of groups
    Points: Cardinal; // number of points in all of them
    InsideOut: Cardinal; // 1 if the detection found that the faces look inwards; everything works all the same
    Warnings: Cardinal; // sum of ts_features_warning
    Reserved: Cardinal; // 0
    // roughness that faces against the occlusal direction over that which faces with it: under .05 on most scans of
    // one jaw, at most .33; .5 to 1 for two jaws in occlusion
    Opposed: Double;
    Coverage: Double; // share of the roughness within 14 mm of the arch curve: .9 and more on scans of one jaw
    ArchLength: Double; // of the arch curve, mm: up to 180 on scans of one jaw
  end;

  // A feature point: where a tooth is held.
  ts_feature_point = record
    Id: Cardinal; // stays the same while the point exists
    Group: Cardinal; // id of its group
    Vertex: Cardinal; // nearest model vertex
    ByHand: Cardinal; // 1 if the caller set it
    Position: ts_double3; // mm
    Convexity: Double; // dimensionless: 0 on a plane, 0.25 to 0.4 on a cusp; 0 for a point set by hand
  end;

  // The feature points of a tooth.
  ts_feature_group = record
    Id: Cardinal; // stays the same while the group exists
    Points: Cardinal; // number of points
    Previous: Cardinal; // id of the neighbour group along the arch, TS_NONE at an end
    Next: Cardinal; // the other one
    Centre: ts_double3; // mean of its points, mm
    ArchFrom: Double; // where its tooth begins along the arch curve, mm; 0 if made by hand
    ArchTo: Double; // where it ends, mm; 0 if made by hand
    Confidence: Double; // 0 to 1: how sure the detection is that this is one tooth; 1 if made by hand
  end;

  // Defaults are given as: default preset / paper preset.
  ts_segment_options = record
    StructSize: Cardinal; // set by ts_segment_options_init
    Preset: ts_preset; // what the options were initialised to; informative
    Weights: ts_weights; // CONCAVITY / PAPER
    Background: ts_background; // ALL / NEIGHBOUR
    CutRule: ts_cut_rule; // COMPONENT / GRADIENT
    Contours: Cardinal; // number of iso-values sampled in (0, 1) (Fig. 4A). 100 / 100
    HistogramBins: Cardinal; // of Fig. 4C. 50 / 50
    PointsPerGroup: Cardinal; // most constraint points used a tooth (Figs. 2, 3); 0 = all. 0 / 0
    Alpha: Double; // penalty of Eq. 6; 0 = exact constraints. 1e8 / 1e8
    Beta: Double; // factor of a concave edge (Eq. 8), least weight of CONCAVITY. 1e-3 / 0.01
    Gamma: Double; // added to the divisor of Eq. 8. 1e-4 / 1e-4
    Theta: Double; // threshold of Eq. 9. 0.2 / 0.001
    C0: Double; // decay of the CONCAVITY weights, 1/mm. 0.07
    NormalRadius: Double; // r of the smoothed normals, mm. 0.15
    SeedRadius: Double; // a constraint point is a disc of this radius, mm; 0 = one vertex. 0.7 / 0
    GingivaDistance: Double; // from every feature point, mm, at which gingiva begins for certain. 13
    AreaMin: Double; // least area of a tooth, mm^2, for COMPONENT and for warnings. 25 / 25
    AreaMax: Double; // largest area of a tooth, mm^2. 330 / 330
    HoleArea: Double; // holes in a tooth's region up to this are filled, mm^2. 40 / 0
    RefineBand: Double; // half width of the band of the min-cut refinement, mm; 0 = none. 2.5 / 0
    SmoothRadius: Double; // smoothing of the final line, mm; 0 = none. 0.2 / 0
    ClickReach: Double; // a click further from the surface than this is off it, mm. 2 / 2
    ClickConcavity: Double; // geodesic cost |e| (1 + this * concavity) from click to points. 60 / 0
    RejectOutliers: Cardinal; // 1 = free feature points that contradict the field. 1 / 0
    // bytes that the segmentation may keep beside the model, clicks' results and work space left out (ts_get_memory);
    // 0 = no limit. What does not fit of the factor is worked out again by each click that needs it: slower, the same
    // bytes. 0 / 0
    MemoryLimit: UInt64;
  end;

  // Milliseconds a stage took (paper, Fig. 11). With the default preset the field is solved where the cut looks at
  // it: then `field` is the share of that in `cut` and `label`, and not added to `total` again.
  ts_click_times = record
    Pick: Double; // click to groups
    Field: Double; // solve; of the slower of the two teeth where they are worked out at the same time
    Cut: Double; // contours, selection, refinement
    Label_: Double; // lines and labels
    Total: Double; // of the call, but for its entry in the history
  end;

  // What came of a click.
  ts_click_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Target: Cardinal; // tooth clicked: id of its group
    // tooth beside it; TS_NONE if there is but one. Where no cut was found for it, ts_get_tooth says TS_E_NOT_FOUND:
    // the tooth clicked stands alone
    Neighbour: Cardinal;
    Position: ts_double3; // the surface point taken, mm
    TargetDistance: Double; // along the surface to the closest point of each, in the metric of the options
    NeighbourDistance: Double; // this and v_med are worked out when a click's info is first asked for
    VMed: Double; // centre of the fullest bin (Fig. 4C)
    TargetIso: Double; // chosen iso-values
    NeighbourIso: Double; // NaN if there is no neighbour
    Ms: ts_click_times; // how long it took
  end;

  // One iso-value's contour of a click's field (Fig. 4A).
  ts_contour_info = record
    Iso: Double; // the value
    Gradient: Double; // mean of |grad u| along it, 1/mm
    Concavity: Double; // share of it in concave valleys, 0 to 1
    Length: Double; // mm
    Points: Cardinal; // in all its polylines
    Polylines: Cardinal; // number of these
    Chosen: Cardinal; // 1 = cut of the target, 2 = of the neighbour, 0 = neither
  end;

  // A point of a contour or cut: on the edge from model vertex `a` to `b`, at (1 - t) a + t b.
  ts_edge_point = record
    A: Cardinal; // model vertex
    B: Cardinal; // model vertex
    T: Double; // 0 at a, 1 at b
    Position: ts_double3; // mm
  end;

  // A separated tooth. Its id is the id of its feature group, or of the group that a click made (ts_segment_click).
  ts_tooth_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Id: Cardinal; // of the tooth
    // what ts_get_labels writes: place of its feature group along the arch counted from 1; of the n-th group made by
    // a click the number of feature groups + n; not an FDI number
    Label_: Cardinal;
    Click: Cardinal; // the click that separated it (last)
    Faces: Cardinal; // model faces
    Vertices: Cardinal; // model vertices of these
    Loops: Cardinal; // closed polylines of its cut
    Seeds: Cardinal; // constraint points used
    Area: Double; // mm^2
    Iso: Double; // iso-value of the cut
    Gradient: Double; // mean of |grad u| along it, 1/mm
    Confidence: Double; // 0 to 1
    Warnings: Cardinal; // sum of ts_tooth_warning
    Reserved: Cardinal; // 0
  end;

  // A loop of a cut.
  ts_cut_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Points: Cardinal; // number of these
    Closed: Cardinal; // 1: the last point is joined to the first
    Length: Double; // mm
    Iso: Double; // iso-value it was chosen at
    Gradient: Double; // mean of |grad u| along it, 1/mm
    Concavity: Double; // share of it in concave valleys, 0 to 1
  end;

  // Milliseconds of the preparation.
  ts_prepare_times = record
    StructSize: Cardinal; // in: sizeof this struct
    Reserved: Cardinal; // 0
    Intake: Double; // of the model
    Features: Double; // of the detection; 0 if set by hand
    Weights: Double; // curvature, concavity, weights
    Factorise: Double; // constraints, ordering, factorisation
  end;

  // Bytes that are kept. Most of them come from the context's allocator.
  ts_memory_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Reserved: Cardinal; // 0
    Model: UInt64; // of the model, which segmentations share
    Segmentation: UInt64; // of what a segmentation keeps beside it, the factor included: what memory_limit bounds
    Factor: UInt64; // of the factor, as far as it is kept
    FactorWhole: UInt64; // of the factor if all of it were
    Click: UInt64; // of the work space of one tooth; as many are kept as teeth were cut at the same time
  end;

  // A tooth that wants a look.
  ts_review_item = record
    Tooth: Cardinal; // id of its group
    Separated: Cardinal; // 0: no cut has been made for this group so far
    Warnings: Cardinal; // sum of ts_tooth_warning
    Reserved: Cardinal; // 0
    Confidence: Double; // of the tooth, 0 to 1; 0 where it is not separated
    GroupConfidence: Double; // that the group is exactly one tooth; 1 for groups made by hand
  end;

  // Faces that two teeth hold. In ts_get_labels they go to the tooth that is locked, or, where neither or both are,
  // to the one whose nearest seed is nearer to the middle of the face; ts_get_tooth_faces has them for both.
  ts_overlap = record
    Winner: Cardinal; // id of the tooth that they go to
    Loser: Cardinal; // id of the other one
    Faces: Cardinal; // of the model
    Reserved: Cardinal; // 0
    Area: Double; // mm^2
  end;

  // The steps that are kept.
  ts_history_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Undo: Cardinal; // steps that can be taken back
    Redo: Cardinal; // steps that can be brought again
    Complete: Cardinal; // 1: back to the beginning; 0: the limit has dropped the oldest
    Bytes: UInt64; // about what the steps keep
    Limit: UInt64; // how much they may (ts_set_history_limit)
  end;

  // How numbers are told.
  ts_number_options = record
    StructSize: Cardinal; // set by ts_number_options_init
    Jaw: ts_jaw; // UNKNOWN (default): estimated
    // 1: the scan is a mirror image of the patient, so left and right change places. No scan shows whether it is one.
    // Default 0
    Mirrored: Cardinal;
    Reserved: Cardinal; // 0
    LeastConfidence: Double; // 0 to 1: a number or a jaw under it is uncertain. Default 0.9
  end;

  // The number of a tooth.
  ts_number_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Fdi: Cardinal; // the most probable, also where it is uncertain
    SetByHand: Cardinal; // 1: by ts_set_number
    Uncertain: Cardinal; // 1: confidence under least_confidence: to be shown to a person before it is used
    Confidence: Double; // probability of this number, the jaw's included, under the model; 1 if set by hand
  end;

  // The jaw that the numbers are of.
  ts_jaw_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Jaw: ts_jaw; // the more probable, also where it is uncertain
    Given: Cardinal; // 1: by the options or by a number set by hand
    Uncertain: Cardinal; // 1: confidence under least_confidence
    Confidence: Double; // .5 where nothing tells; 1 if given
  end;

  // A number as Palmer's notation has it.
  ts_palmer = record
    StructSize: Cardinal; // in: sizeof this struct
    Quadrant: Cardinal; // as in FDI: 1 upper right, 2 upper left, 3 lower left, 4 lower right
    Position: Cardinal; // 1 (central incisor) to 8
    Letters: ts_char4; // "UR6"
    Symbol: ts_char8; // UTF-8: the position in the angle of its quadrant, as on a chart that faces the patient
  end;

  // An edit that is kept.
  ts_cut_edit = record
    Kind: ts_edit_kind; // which of them
    // TS_OK: it shows in the cut; else why it was dropped when the tooth was last separated again. A dropped edit is
    // tried again the next time
    Status: ts_status;
    Points: Cardinal; // 2 of a drag, those of a stroke, 0 of the others
    Reserved: Cardinal; // 0
    Amount: Double; // reach, mm or strength as given; 0 of a stroke
    From: ts_double3; // of a drag where the cut was taken, of a stroke its first point, mm
    To_: ts_double3; // of a drag where it was taken to, of a stroke its last point, mm
  end;

  // How meshes of teeth are made.
  ts_tooth_mesh_options = record
    StructSize: Cardinal; // set by ts_tooth_mesh_options_init
    // 1: all rims are closed by smooth membranes, those of the scan (holes, open ends) as well. Default 0
    Closed: Cardinal;
  end;

  // Counts and measures of a mesh.
  ts_mesh_info = record
    StructSize: Cardinal; // in: sizeof this struct
    Label_: Cardinal; // ts_tooth_info::label, 0 of the gingiva
    Vertices: Cardinal; // number of vertices
    Triangles: Cardinal; // number of triangles
    FillTriangles: Cardinal; // of these, at the end: those that close it
    CutVertices: Cardinal; // that it shares with other parts
    OpenRims: Cardinal; // 0: watertight
    ClosedRims: Cardinal; // rims that were closed
    Components: Cardinal; // connected pieces
    // triangles left out at its rims, because the scan crosses itself there, or every membrane would cross them; only
    // of closed meshes, up to 3 % of the area
    Trimmed: Cardinal;
    Area: Double; // of all triangles, mm^2
    FillArea: Double; // of those that close it, mm^2
    Volume: Double; // mm^3; 0 while a rim is open
    Lost: Double; // of a tooth: what its cuts enclose and another tooth or the gingiva has, mm^2
  end;

  // How a segmentation is written.
  ts_save_options = record
    StructSize: Cardinal; // set by ts_save_options_init
    // 1: the model's faces as they are, each of the tooth that ts_get_labels says. Default 0: split along the cuts
    WholeFaces: Cardinal;
  end;

  // Which way a tooth looks, and its extent that way over the faces of ts_get_tooth_faces.
  ts_tooth_frame = record
    StructSize: Cardinal; // in: sizeof this struct
    // 1: mesial is along the arch curve; 0: there is none (features made by hand), and mesial is the direction in
    // which the tooth is widest, to either side
    FromArch: Cardinal;
    Centre: ts_double3; // of the area of its faces, mm
    Occlusal: ts_double3; // unit vector: that of the features
    // unit vector along the arch, at right angles to occlusal, towards the middle of the arch curve's length: the
    // midline, where the scan is of a whole arch
    Mesial: ts_double3;
    Buccal: ts_double3; // unit vector at right angles to both, away from the middle between the ends of the arch
    Width: Double; // mesial-distal extent, mm
    Depth: Double; // buccal-lingual extent, mm
    Height: Double; // occlusal-gingival extent of what the scan shows of the crown, mm
  end;

{$IFDEF TOOTHSEG_DYNAMIC}

// Loads the library: the file named, else the one that the environment variable TOOTHSEG_LIBRARY names, else the one that
// the system finds. An exception where it, or one of its functions, is not there.
procedure ts_load(const Path: string);
// The same, once, without a name.
procedure ts_need;

var
  ts_version: function: PAnsiChar; cdecl;
  ts_status_name: function(status: ts_status): PAnsiChar; cdecl;
  ts_last_error_message: function: PAnsiChar; cdecl;
  ts_context_options_init: function(options: Pts_context_options; struct_size: Cardinal): ts_status; cdecl;
  ts_context_create: function(options: Pts_context_options; out_: PPts_context): ts_status; cdecl;
  ts_context_destroy: procedure(context: Pts_context); cdecl;
  ts_job_create: function(context: Pts_context; progress: ts_progress_fn; user: Pointer; out_: PPts_job): ts_status; cdecl;
  ts_job_cancel: procedure(job: Pts_job); cdecl;
  ts_job_reset: procedure(job: Pts_job); cdecl;
  ts_job_progress: function(job: Pts_job): Double; cdecl;
  ts_job_destroy: procedure(job: Pts_job); cdecl;
  ts_mesh_input_init: function(input: Pts_mesh_input; struct_size: Cardinal): ts_status; cdecl;
  ts_intake_options_init: function(options: Pts_intake_options; struct_size: Cardinal): ts_status; cdecl;
  ts_model_create: function(context: Pts_context; input: Pts_mesh_input; options: Pts_intake_options; job: Pts_job; out_: PPts_model): ts_status; cdecl;
  ts_model_load: function(context: Pts_context; path: PAnsiChar; options: Pts_intake_options; job: Pts_job; out_: PPts_model): ts_status; cdecl;
  ts_model_read: function(context: Pts_context; bytes: Pointer; size: NativeUInt; format: ts_file_format; options: Pts_intake_options; job: Pts_job; out_: PPts_model): ts_status; cdecl;
  ts_model_destroy: procedure(model: Pts_model); cdecl;
  ts_model_get_report: function(model: Pts_model; report: Pts_intake_report): ts_status; cdecl;
  ts_model_get_positions: function(model: Pts_model; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_model_get_triangles: function(model: Pts_model; triangles: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_model_get_face_sources: function(model: Pts_model; input_face: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_model_get_vertex_map: function(model: Pts_model; model_vertex: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_model_nearest: function(model: Pts_model; position: Pts_double3; out_: Pts_surface_point): ts_status; cdecl;
  ts_model_raycast: function(model: Pts_model; origin: Pts_double3; direction: Pts_double3; out_: Pts_surface_point): ts_status; cdecl;
  ts_feature_options_init: function(options: Pts_feature_options; struct_size: Cardinal): ts_status; cdecl;
  ts_detect_features: function(model: Pts_model; options: Pts_feature_options; job: Pts_job; out_: PPts_features): ts_status; cdecl;
  ts_features_create: function(model: Pts_model; out_: PPts_features): ts_status; cdecl;
  ts_features_clone: function(features: Pts_features; out_: PPts_features): ts_status; cdecl;
  ts_features_destroy: procedure(features: Pts_features); cdecl;
  ts_features_get_info: function(features: Pts_features; info: Pts_features_info): ts_status; cdecl;
  ts_features_get_occlusal: function(features: Pts_features; direction: Pts_double3): ts_status; cdecl;
  ts_features_set_occlusal: function(features: Pts_features; direction: Pts_double3): ts_status; cdecl;
  ts_features_get_arch: function(features: Pts_features; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_features_get_points: function(features: Pts_features; points: Pts_feature_point; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_features_get_groups: function(features: Pts_features; groups: Pts_feature_group; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_features_add_point: function(features: Pts_features; position: Pts_double3; group: Cardinal; point: PCardinal; group_out: PCardinal): ts_status; cdecl;
  ts_features_move_point: function(features: Pts_features; point: Cardinal; position: Pts_double3): ts_status; cdecl;
  ts_features_set_group: function(features: Pts_features; point: Cardinal; group: Cardinal; group_out: PCardinal): ts_status; cdecl;
  ts_features_remove_point: function(features: Pts_features; point: Cardinal): ts_status; cdecl;
  ts_features_remove_group: function(features: Pts_features; group: Cardinal): ts_status; cdecl;
  ts_segment_options_init: function(options: Pts_segment_options; struct_size: Cardinal; preset: ts_preset): ts_status; cdecl;
  ts_segmentation_create: function(features: Pts_features; options: Pts_segment_options; job: Pts_job; out_: PPts_segmentation): ts_status; cdecl;
  ts_segmentation_destroy: procedure(segmentation: Pts_segmentation); cdecl;
  ts_segment_click: function(segmentation: Pts_segmentation; position: Pts_double3; job: Pts_job; click: PCardinal): ts_status; cdecl;
  ts_segment_clicks: function(segmentation: Pts_segmentation; positions: PDouble; count: Cardinal; job: Pts_job; statuses: Pts_status): ts_status; cdecl;
  ts_propose_clicks: function(segmentation: Pts_segmentation; positions: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_click_count: function(segmentation: Pts_segmentation; count: PCardinal): ts_status; cdecl;
  ts_get_click: function(segmentation: Pts_segmentation; click: Cardinal; info: Pts_click_info): ts_status; cdecl;
  ts_get_field: function(segmentation: Pts_segmentation; click: Cardinal; u: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_histogram: function(segmentation: Pts_segmentation; click: Cardinal; bins: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_contours: function(segmentation: Pts_segmentation; click: Cardinal; contours: Pts_contour_info; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_contour_points: function(segmentation: Pts_segmentation; click: Cardinal; contour: Cardinal; points: Pts_edge_point; capacity: Cardinal; count: PCardinal; starts: PCardinal; closed: PByte): ts_status; cdecl;
  ts_get_teeth: function(segmentation: Pts_segmentation; teeth: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_tooth: function(segmentation: Pts_segmentation; tooth: Cardinal; info: Pts_tooth_info): ts_status; cdecl;
  ts_get_tooth_faces: function(segmentation: Pts_segmentation; tooth: Cardinal; faces: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_tooth_vertices: function(segmentation: Pts_segmentation; tooth: Cardinal; vertices: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_tooth_seeds: function(segmentation: Pts_segmentation; tooth: Cardinal; vertices: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_cut: function(segmentation: Pts_segmentation; tooth: Cardinal; loop: Cardinal; info: Pts_cut_info; points: Pts_edge_point; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_labels: function(segmentation: Pts_segmentation; labels: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_get_prepare_times: function(segmentation: Pts_segmentation; times: Pts_prepare_times): ts_status; cdecl;
  ts_get_memory: function(segmentation: Pts_segmentation; info: Pts_memory_info): ts_status; cdecl;
  ts_segment_all: function(segmentation: Pts_segmentation; job: Pts_job): ts_status; cdecl;
  ts_get_review: function(segmentation: Pts_segmentation; items: Pts_review_item; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_tooth_include: function(segmentation: Pts_segmentation; tooth: Cardinal; position: Pts_double3; job: Pts_job): ts_status; cdecl;
  ts_tooth_exclude: function(segmentation: Pts_segmentation; tooth: Cardinal; position: Pts_double3; job: Pts_job): ts_status; cdecl;
  ts_tooth_split: function(segmentation: Pts_segmentation; tooth: Cardinal; keep: Pts_double3; part: Pts_double3; job: Pts_job; second: PCardinal): ts_status; cdecl;
  ts_tooth_move_point: function(segmentation: Pts_segmentation; tooth: Cardinal; from: Pts_double3; to_: Pts_double3; job: Pts_job): ts_status; cdecl;
  ts_tooth_merge: function(segmentation: Pts_segmentation; tooth: Cardinal; other: Cardinal; job: Pts_job): ts_status; cdecl;
  ts_tooth_remove: function(segmentation: Pts_segmentation; tooth: Cardinal): ts_status; cdecl;
  ts_tooth_set_locked: function(segmentation: Pts_segmentation; tooth: Cardinal; locked: Cardinal): ts_status; cdecl;
  ts_tooth_get_locked: function(segmentation: Pts_segmentation; tooth: Cardinal; locked: PCardinal): ts_status; cdecl;
  ts_get_overlaps: function(segmentation: Pts_segmentation; overlaps: Pts_overlap; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_undo: function(segmentation: Pts_segmentation): ts_status; cdecl;
  ts_redo: function(segmentation: Pts_segmentation): ts_status; cdecl;
  ts_get_history: function(segmentation: Pts_segmentation; info: Pts_history_info): ts_status; cdecl;
  ts_set_history_limit: function(segmentation: Pts_segmentation; bytes: UInt64): ts_status; cdecl;
  ts_get_changes: function(segmentation: Pts_segmentation; teeth: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_set_change_callback: function(segmentation: Pts_segmentation; callback: ts_change_fn; user: Pointer): ts_status; cdecl;
  ts_session_write: function(segmentation: Pts_segmentation; text: PAnsiChar; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_session_save: function(segmentation: Pts_segmentation; path: PAnsiChar): ts_status; cdecl;
  ts_session_read: function(model: Pts_model; text: PAnsiChar; size: NativeUInt; job: Pts_job; features: PPts_features; out_: PPts_segmentation): ts_status; cdecl;
  ts_session_load: function(model: Pts_model; path: PAnsiChar; job: Pts_job; features: PPts_features; out_: PPts_segmentation): ts_status; cdecl;
  ts_number_options_init: function(options: Pts_number_options; struct_size: Cardinal): ts_status; cdecl;
  ts_assign_numbers: function(segmentation: Pts_segmentation; options: Pts_number_options): ts_status; cdecl;
  ts_set_number: function(segmentation: Pts_segmentation; tooth: Cardinal; fdi: Cardinal): ts_status; cdecl;
  ts_get_number: function(segmentation: Pts_segmentation; tooth: Cardinal; info: Pts_number_info): ts_status; cdecl;
  ts_get_jaw: function(segmentation: Pts_segmentation; info: Pts_jaw_info): ts_status; cdecl;
  ts_fdi_to_universal: function(fdi: Cardinal; universal: PCardinal): ts_status; cdecl;
  ts_universal_to_fdi: function(universal: Cardinal; fdi: PCardinal): ts_status; cdecl;
  ts_fdi_to_palmer: function(fdi: Cardinal; palmer: Pts_palmer): ts_status; cdecl;
  ts_cut_drag: function(segmentation: Pts_segmentation; tooth: Cardinal; loop: Cardinal; point: Cardinal; to_: Pts_double3; reach: Double; job: Pts_job): ts_status; cdecl;
  ts_cut_draw: function(segmentation: Pts_segmentation; tooth: Cardinal; points: PDouble; count: Cardinal; job: Pts_job): ts_status; cdecl;
  ts_cut_offset: function(segmentation: Pts_segmentation; tooth: Cardinal; mm: Double; job: Pts_job): ts_status; cdecl;
  ts_cut_smooth: function(segmentation: Pts_segmentation; tooth: Cardinal; strength: Double; job: Pts_job): ts_status; cdecl;
  ts_cut_reset: function(segmentation: Pts_segmentation; tooth: Cardinal): ts_status; cdecl;
  ts_get_cut_edits: function(segmentation: Pts_segmentation; tooth: Cardinal; edits: Pts_cut_edit; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_tooth_mesh_options_init: function(options: Pts_tooth_mesh_options; struct_size: Cardinal): ts_status; cdecl;
  ts_tooth_mesh_create: function(segmentation: Pts_segmentation; tooth: Cardinal; options: Pts_tooth_mesh_options; job: Pts_job; out_: PPts_mesh): ts_status; cdecl;
  ts_gingiva_mesh_create: function(segmentation: Pts_segmentation; options: Pts_tooth_mesh_options; job: Pts_job; out_: PPts_mesh): ts_status; cdecl;
  ts_mesh_destroy: procedure(mesh: Pts_mesh); cdecl;
  ts_mesh_get_info: function(mesh: Pts_mesh; info: Pts_mesh_info): ts_status; cdecl;
  ts_mesh_get_positions: function(mesh: Pts_mesh; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_mesh_get_normals: function(mesh: Pts_mesh; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_mesh_get_triangles: function(mesh: Pts_mesh; triangles: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_mesh_get_faces: function(mesh: Pts_mesh; faces: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_mesh_get_vertex_flags: function(mesh: Pts_mesh; flags: PByte; capacity: Cardinal; count: PCardinal): ts_status; cdecl;
  ts_mesh_save: function(mesh: Pts_mesh; path: PAnsiChar; format: ts_output_format; job: Pts_job): ts_status; cdecl;
  ts_save_options_init: function(options: Pts_save_options; struct_size: Cardinal): ts_status; cdecl;
  ts_segmentation_save: function(segmentation: Pts_segmentation; path: PAnsiChar; format: ts_output_format; options: Pts_save_options; job: Pts_job): ts_status; cdecl;
  ts_get_tooth_frame: function(segmentation: Pts_segmentation; tooth: Cardinal; frame: Pts_tooth_frame): ts_status; cdecl;
{$ELSE}

// The library's version, e.g. "0.1.0". Static; any thread. Since 0.1.0; threads: any.
function ts_version: PAnsiChar; cdecl; external TS_LIBRARY;

// The name of a status, e.g. "TS_E_NO_TEETH"; "TS_E_?" for an unknown one. Static; any thread. Since 0.1.0; threads:
// any.
function ts_status_name(status: ts_status): PAnsiChar; cdecl; external TS_LIBRARY;

// What the last failed call of this thread reported: one line, never NULL, "" before any failure. Lives until the
// next failing call of the same thread. Do not use it to find out whether a call failed. Since 0.1.0; threads: any.
function ts_last_error_message: PAnsiChar; cdecl; external TS_LIBRARY;

// Fills `options` with the defaults. `struct_size`: sizeof(ts_context_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
// Thread: any. Since 0.1.0; threads: any.
function ts_context_options_init(options: Pts_context_options; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Makes a context. `options` in, may be NULL; `out` out, owned by the caller. Errors: TS_E_NULL, TS_E_STRUCT_SIZE,
// TS_E_INVALID_ARGUMENT, TS_E_OUT_OF_MEMORY. Thread: any. Since 0.1.0; threads: any.
function ts_context_create(options: Pts_context_options; out_: PPts_context): ts_status; cdecl; external TS_LIBRARY;

// Gives a context back; NULL is fine. It lives on until its last child is gone. Since 0.1.0; threads: exclusive.
procedure ts_context_destroy(context: Pts_context); cdecl; external TS_LIBRARY;

// Makes a job. `progress` may be NULL (then the job serves to cancel only). `out` owned by the caller. Errors:
// TS_E_NULL, TS_E_OUT_OF_MEMORY. Since 0.1.0; threads: any.
function ts_job_create(context: Pts_context; progress: ts_progress_fn; user: Pointer; out_: PPts_job): ts_status; cdecl; external TS_LIBRARY;

// Asks the running call to stop: it returns TS_E_CANCELLED soon, with nothing changed. Sticky until ts_job_reset. Any
// thread, any time between create and destroy; NULL is fine. Since 0.1.0; threads: any.
procedure ts_job_cancel(job: Pts_job); cdecl; external TS_LIBRARY;

// Makes a cancelled job usable again. Not while a call uses it. Since 0.1.0; threads: exclusive.
procedure ts_job_reset(job: Pts_job); cdecl; external TS_LIBRARY;

// The last reported fraction, 0 before any. Any thread. NULL gives 0. Since 0.1.0; threads: any.
function ts_job_progress(job: Pts_job): Double; cdecl; external TS_LIBRARY;

// Gives a job back; NULL is fine. Not while a call uses it. Since 0.1.0; threads: exclusive.
procedure ts_job_destroy(job: Pts_job); cdecl; external TS_LIBRARY;

// Fills `input` with an empty mesh of doubles. `struct_size`: sizeof(ts_mesh_input). Errors: TS_E_NULL,
// TS_E_STRUCT_SIZE. Thread: any. Since 0.1.0; threads: any.
function ts_mesh_input_init(input: Pts_mesh_input; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Fills `options` with the defaults. `struct_size`: sizeof(ts_intake_options). Errors and threads: as above. Since
// 0.1.0; threads: any.
function ts_intake_options_init(options: Pts_intake_options; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Makes a model from the caller's arrays. Errors: TS_E_MESH_*, TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT,
// TS_E_OUT_OF_MEMORY, TS_E_CANCELLED. `options` and `job` may be NULL. Since 0.1.0; threads: any.
function ts_model_create(context: Pts_context; input: Pts_mesh_input; options: Pts_intake_options; job: Pts_job; out_: PPts_model): ts_status; cdecl; external TS_LIBRARY;

// Makes a model from a file: binary or ASCII STL, PLY (ASCII, binary of either byte order), OBJ, OFF. `path`: UTF-8.
// Errors: TS_E_FILE_*, and those of ts_model_create. Since 0.1.0; threads: any.
function ts_model_load(context: Pts_context; path: PAnsiChar; options: Pts_intake_options; job: Pts_job; out_: PPts_model): ts_status; cdecl; external TS_LIBRARY;

// The same from a file already in memory. Since 0.1.0; threads: any.
function ts_model_read(context: Pts_context; bytes: Pointer; size: NativeUInt; format: ts_file_format; options: Pts_intake_options; job: Pts_job; out_: PPts_model): ts_status; cdecl; external TS_LIBRARY;

// Gives a model back; NULL is fine. It lives on until its last child is gone. Since 0.1.0; threads: exclusive.
procedure ts_model_destroy(model: Pts_model); cdecl; external TS_LIBRARY;

// Fills the report. `report->struct_size` in, the rest out. Since 0.1.0; threads: concurrent.
function ts_model_get_report(model: Pts_model; report: Pts_intake_report): ts_status; cdecl; external TS_LIBRARY;

// Vertices of the model: `xyz` 3 doubles a vertex, `capacity` and `count` in vertices. Since 0.1.0; threads:
// concurrent.
function ts_model_get_positions(model: Pts_model; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Faces of the model: 3 vertex indices each; `capacity` and `count` in faces. Since 0.1.0; threads: concurrent.
function ts_model_get_triangles(model: Pts_model; triangles: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// For each model face the caller's face it came from. Since 0.1.0; threads: concurrent.
function ts_model_get_face_sources(model: Pts_model; input_face: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// For each of the caller's vertices the model vertex that stands for it (after welding and splitting the first of
// several), TS_NONE if it was dropped. Since 0.1.0; threads: concurrent.
function ts_model_get_vertex_map(model: Pts_model; model_vertex: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// The surface point nearest to `position`. Errors: TS_E_NULL, TS_E_INVALID_ARGUMENT (not finite). Since 0.1.0;
// threads: concurrent.
function ts_model_nearest(model: Pts_model; position: Pts_double3; out_: Pts_surface_point): ts_status; cdecl; external TS_LIBRARY;

// The first surface point hit by a ray (both sides of a face count). `direction` need not have length 1. Errors:
// TS_E_NOT_FOUND (the ray misses), TS_E_NULL, TS_E_INVALID_ARGUMENT. Since 0.1.0; threads: concurrent.
function ts_model_raycast(model: Pts_model; origin: Pts_double3; direction: Pts_double3; out_: Pts_surface_point): ts_status; cdecl; external TS_LIBRARY;

// Fills `options` with the defaults. `struct_size`: sizeof(ts_feature_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
// Thread: any. Since 0.1.0; threads: any.
function ts_feature_options_init(options: Pts_feature_options; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Finds the features of a model. Errors: TS_E_NO_TEETH, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. Since 0.1.0;
// threads: concurrent.
function ts_detect_features(model: Pts_model; options: Pts_feature_options; job: Pts_job; out_: PPts_features): ts_status; cdecl; external TS_LIBRARY;

// Makes an empty set, to be filled by hand. Since 0.1.0; threads: concurrent.
function ts_features_create(model: Pts_model; out_: PPts_features): ts_status; cdecl; external TS_LIBRARY;

// Makes a copy. Since 0.1.0; threads: concurrent.
function ts_features_clone(features: Pts_features; out_: PPts_features): ts_status; cdecl; external TS_LIBRARY;

// Gives features back; NULL is fine. Since 0.1.0; threads: exclusive.
procedure ts_features_destroy(features: Pts_features); cdecl; external TS_LIBRARY;

// Counts, and what the detection saw (0 in a set made by hand). `info->struct_size` in, the rest out. Since 0.1.0;
// threads: concurrent.
function ts_features_get_info(features: Pts_features; info: Pts_features_info): ts_status; cdecl; external TS_LIBRARY;

// The unit vector from the gums to the biting surface. Since 0.1.0; threads: concurrent.
function ts_features_get_occlusal(features: Pts_features; direction: Pts_double3): ts_status; cdecl; external TS_LIBRARY;

// Sets it by hand; `direction` need not have length 1. Errors: TS_E_INVALID_ARGUMENT (no length, not finite),
// TS_E_NULL. Since 0.1.0; threads: exclusive.
function ts_features_set_occlusal(features: Pts_features; direction: Pts_double3): ts_status; cdecl; external TS_LIBRARY;

// The arch curve as a polyline from one end of the arch to the other: 3 doubles a point, mm. Since 0.1.0; threads:
// concurrent.
function ts_features_get_arch(features: Pts_features; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// All points, in the order of their groups. Since 0.1.0; threads: concurrent.
function ts_features_get_points(features: Pts_features; points: Pts_feature_point; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// All groups, in the order of the arch. Since 0.1.0; threads: concurrent.
function ts_features_get_groups(features: Pts_features; groups: Pts_feature_group; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Adds a point at the surface point nearest to `position`, to `group` (TS_NONE: a new group, placed along the arch by
// its position). `point` and `group_out` may be NULL. Errors: TS_E_NOT_FOUND, usage. Since 0.1.0; threads: exclusive.
function ts_features_add_point(features: Pts_features; position: Pts_double3; group: Cardinal; point: PCardinal; group_out: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Moves a point to the surface point nearest to `position`; it counts as set by hand then. Errors: TS_E_NOT_FOUND,
// usage. Since 0.1.0; threads: exclusive.
function ts_features_move_point(features: Pts_features; point: Cardinal; position: Pts_double3): ts_status; cdecl; external TS_LIBRARY;

// Puts a point into another group (TS_NONE: a new one). A group without points ceases to exist. Since 0.1.0; threads:
// exclusive.
function ts_features_set_group(features: Pts_features; point: Cardinal; group: Cardinal; group_out: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Takes a point away, and its group with the last of them. Errors: TS_E_NOT_FOUND, TS_E_NULL. Since 0.1.0; threads:
// exclusive.
function ts_features_remove_point(features: Pts_features; point: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Takes a group away with all its points. Errors: TS_E_NOT_FOUND, TS_E_NULL. Since 0.1.0; threads: exclusive.
function ts_features_remove_group(features: Pts_features; group: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Fills `options` with those of a preset. `struct_size`: sizeof(ts_segment_options). Errors: TS_E_NULL,
// TS_E_STRUCT_SIZE, TS_E_INVALID_ARGUMENT (no such preset). Thread: any. Since 0.1.0; threads: any.
function ts_segment_options_init(options: Pts_segment_options; struct_size: Cardinal; preset: ts_preset): ts_status; cdecl; external TS_LIBRARY;

// Prepares a scan: weights, and the factorisation that all clicks share. `features` are copied. Errors:
// TS_E_NO_CONSTRAINT, TS_E_SOLVER, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. Since 0.1.0; threads: concurrent.
function ts_segmentation_create(features: Pts_features; options: Pts_segment_options; job: Pts_job; out_: PPts_segmentation): ts_status; cdecl; external TS_LIBRARY;

// Gives a segmentation back; NULL is fine. Since 0.1.0; threads: exclusive.
procedure ts_segmentation_destroy(segmentation: Pts_segmentation); cdecl; external TS_LIBRARY;

// Separates the tooth under `position` (mm, on the surface) and its neighbour: the group closest along the surface is
// the target (0), the next closest the background (1) (paper, "User interface"). The default preset takes for the
// neighbour the tooth beside the target along the arch that the click faces; one that is separated already is passed
// over where the tooth on the other side is not. With everything else as background, as the default preset has it,
// the click is evidence: where the tooth of the closest group does not hold the click, the target is the group that
// the field at the click is most of; where that one's tooth does not hold it either, the click makes a group of its
// own, held on a disc of seed_radius (TS_WARN_MADE_BY_CLICK). A click that succeeds gives the tooth that it lies on,
// or, on no other, within 1 mm of. A group made by a click belongs to the segmentation, not to the features: later
// clicks find it and have it as background; its id is the smallest larger than those of all groups of the features
// and of those made before it. TS_E_CLICK_ON_GINGIVA also where what could be cut out around the click is no tooth.
// `click` out, may be NULL: its number, counted from 0. Errors: TS_E_CLICK_*, TS_E_NO_CUT, TS_E_CANCELLED,
// TS_E_OUT_OF_MEMORY, usage. Since 0.1.0; threads: exclusive.
function ts_segment_click(segmentation: Pts_segmentation; position: Pts_double3; job: Pts_job; click: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Several clicks at once, solved in parallel; the result is that of the same clicks one after the other. `positions`
// 3 doubles a click. `statuses` out, may be NULL: one a click; a click that fails leaves no trace, the others stand,
// and numbers are given to those that succeed, in order. Returns TS_OK if the batch ran, even if clicks failed;
// ts_last_error_message then tells of the last that did. TS_E_INVALID_ARGUMENT if a position is not finite. Since
// 0.1.0; threads: exclusive.
function ts_segment_clicks(segmentation: Pts_segmentation; positions: PDouble; count: Cardinal; job: Pts_job; statuses: Pts_status): ts_status; cdecl; external TS_LIBRARY;

// The fewest clicks that cover every group of the features not yet separated (paper: N/2, or N/2 + 1 in all): 3
// doubles a click, to be given to ts_segment_clicks. No clicks once all are separated. Since 0.1.0; threads:
// concurrent.
function ts_propose_clicks(segmentation: Pts_segmentation; positions: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// How many clicks have succeeded so far. Errors: TS_E_NULL. Since 0.1.0; threads: concurrent.
function ts_get_click_count(segmentation: Pts_segmentation; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// `click`: counted from 0. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_NULL, TS_E_STRUCT_SIZE.
// Since 0.1.0; threads: concurrent.
function ts_get_click(segmentation: Pts_segmentation; click: Cardinal; info: Pts_click_info): ts_status; cdecl; external TS_LIBRARY;

// u of Eq. 3 for a click, a value a model vertex: 0 on the target, 1 on the neighbour; NaN on pieces of the mesh that
// hold no constraint: Eq. 3 leaves u open there. Their faces belong to no tooth (label 0), and clicks and corrections
// on a piece without any feature point are refused with TS_E_CLICK_ON_GINGIVA. Since 0.1.0; threads: concurrent.
function ts_get_field(segmentation: Pts_segmentation; click: Cardinal; u: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// The histogram of Fig. 4C: vertices a bin over [0, 1]. Since 0.1.0; threads: concurrent.
function ts_get_histogram(segmentation: Pts_segmentation; click: Cardinal; bins: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// All contours of a click, by rising iso-value (ts_segment_options::contours of them). Errors: TS_E_NOT_FOUND, usage.
// Since 0.1.0; threads: concurrent.
function ts_get_contours(segmentation: Pts_segmentation; click: Cardinal; contours: Pts_contour_info; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// The points of one contour. `starts` out, may be NULL: index of the first point of each polyline (`polylines` of
// them); closed polylines repeat no point; `closed` out, may be NULL: 1 or 0 each. Since 0.1.0; threads: concurrent.
function ts_get_contour_points(segmentation: Pts_segmentation; click: Cardinal; contour: Cardinal; points: Pts_edge_point; capacity: Cardinal; count: PCardinal; starts: PCardinal; closed: PByte): ts_status; cdecl; external TS_LIBRARY;

// Ids of the teeth separated so far, along the arch. Since 0.1.0; threads: concurrent.
function ts_get_teeth(segmentation: Pts_segmentation; teeth: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// `tooth`: id. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_NULL, TS_E_STRUCT_SIZE. Since
// 0.1.0; threads: concurrent.
function ts_get_tooth(segmentation: Pts_segmentation; tooth: Cardinal; info: Pts_tooth_info): ts_status; cdecl; external TS_LIBRARY;

// Model faces of a tooth, ascending, those that another tooth holds as well included. Errors: TS_E_NOT_FOUND, usage.
// Since 0.1.0; threads: concurrent.
function ts_get_tooth_faces(segmentation: Pts_segmentation; tooth: Cardinal; faces: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Model vertices of these faces, ascending. Errors: TS_E_NOT_FOUND, usage. Since 0.1.0; threads: concurrent.
function ts_get_tooth_vertices(segmentation: Pts_segmentation; tooth: Cardinal; vertices: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Model vertices held as this tooth's constraint. Since 0.1.0; threads: concurrent.
function ts_get_tooth_seeds(segmentation: Pts_segmentation; tooth: Cardinal; vertices: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// The cut of a tooth: loop `loop` (0 = the longest) of its closed polyline(s), seen from outside counter-clockwise
// around the tooth. `info` may be NULL, `points` may be NULL. Since 0.1.0; threads: concurrent.
function ts_get_cut(segmentation: Pts_segmentation; tooth: Cardinal; loop: Cardinal; info: Pts_cut_info; points: Pts_edge_point; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// A label for each of the CALLER's faces, in the caller's order: 0 = no tooth (so far), else ts_tooth_info::label.
// Faces that intake dropped have the label of the face they duplicate or touch. Since 0.1.0; threads: concurrent.
function ts_get_labels(segmentation: Pts_segmentation; labels: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// `times->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Since 0.1.0; threads: concurrent.
function ts_get_prepare_times(segmentation: Pts_segmentation; times: Pts_prepare_times): ts_status; cdecl; external TS_LIBRARY;

// Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Since 0.1.0; threads: concurrent.
function ts_get_memory(segmentation: Pts_segmentation; info: Pts_memory_info): ts_status; cdecl; external TS_LIBRARY;

// Every tooth without a click of the caller's: the clicks of ts_propose_clicks until none is left, as one step. Teeth
// that stand already stay. Errors: TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage; a tooth for which no cut is found is
// told by ts_get_review. Since 0.1.0; threads: exclusive.
function ts_segment_all(segmentation: Pts_segmentation; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Teeth with a confidence under 0.9 or a warning, and groups without a tooth, those that need it most first. Of teeth
// above 0.9 the share that is right is in docs/accuracy.md. Since 0.1.0; threads: concurrent.
function ts_get_review(segmentation: Pts_segmentation; items: Pts_review_item; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// "This too": a disc of seed_radius around `position` (mm, within click_reach of the surface) is held for the tooth,
// which is cut anew, as are separated teeth on which the disc lies. On a feature point of another tooth that point
// goes over to this one. Errors: TS_E_CLICK_OFF_SURFACE; TS_E_CLICK_ON_GINGIVA on what is gingiva for certain
// (gingiva_distance); TS_E_NO_CHANGE where the point is held for the tooth already; TS_E_NO_CUT where no cut is left,
// or on the last point of another tooth; TS_E_LOCKED; TS_E_NOT_FOUND; TS_E_CANCELLED; usage. Since 0.1.0; threads:
// exclusive.
function ts_tooth_include(segmentation: Pts_segmentation; tooth: Cardinal; position: Pts_double3; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// "Not this": the disc is held for the tooth that the field there is most of after this one, or for the gingiva where
// that has more. A feature point of the tooth that lies there is no longer used. Errors: as ts_tooth_include. Since
// 0.1.0; threads: exclusive.
function ts_tooth_exclude(segmentation: Pts_segmentation; tooth: Cardinal; position: Pts_double3; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Two teeth of one: of its points those nearer to `part` than to `keep` go to a new group, and a disc at each of the
// two positions is held for its own. `second` out, may be NULL: id of the new tooth. Errors: as ts_tooth_include.
// Since 0.1.0; threads: exclusive.
function ts_tooth_split(segmentation: Pts_segmentation; tooth: Cardinal; keep: Pts_double3; part: Pts_double3; job: Pts_job; second: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Moves a feature point of the tooth: the one that lies at `from` is no longer used, and a disc of seed_radius around
// `to` is held instead; both in mm, within click_reach of the surface. The tooth is cut anew, as are separated teeth
// on which the disc lies. Errors: TS_E_NO_CHANGE where no point of the tooth lies at `from`, or one lies at `to`
// already; TS_E_NO_CUT also where what is held for another tooth lies at `to`; else as ts_tooth_include. Since 0.1.0;
// threads: exclusive.
function ts_tooth_move_point(segmentation: Pts_segmentation; tooth: Cardinal; from: Pts_double3; to_: Pts_double3; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// One tooth of two: the points of `other` are held for `tooth`, and `other` is no tooth any more. Errors:
// TS_E_NO_CUT, TS_E_NO_CHANGE where both are the same, TS_E_LOCKED, TS_E_NOT_FOUND, TS_E_CANCELLED, usage. Since
// 0.1.0; threads: exclusive.
function ts_tooth_merge(segmentation: Pts_segmentation; tooth: Cardinal; other: Cardinal; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// The tooth is as if it had not been separated; its group stays. Errors: TS_E_LOCKED, TS_E_NOT_FOUND, usage. Since
// 0.1.0; threads: exclusive.
function ts_tooth_remove(segmentation: Pts_segmentation; tooth: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// `locked` 1: nothing changes the tooth until it is unlocked (0): a click on it is refused (TS_E_LOCKED), and as a
// neighbour it is left as it is. Errors: TS_E_NO_CHANGE where it is so already, TS_E_NOT_FOUND, usage. Since 0.1.0;
// threads: exclusive.
function ts_tooth_set_locked(segmentation: Pts_segmentation; tooth: Cardinal; locked: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// `locked` out: 1 or 0. Errors: TS_E_NOT_FOUND, TS_E_NULL. Since 0.1.0; threads: concurrent.
function ts_tooth_get_locked(segmentation: Pts_segmentation; tooth: Cardinal; locked: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// All of them, by pairs of teeth. Errors: TS_E_NULL, TS_E_BUFFER_TOO_SMALL. Since 0.1.0; threads: concurrent.
function ts_get_overlaps(segmentation: Pts_segmentation; overlaps: Pts_overlap; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Takes back the last step: the teeth, clicks and groups are then, byte for byte, what they were. Errors:
// TS_E_NO_HISTORY, usage. Since 0.1.0; threads: exclusive.
function ts_undo(segmentation: Pts_segmentation): ts_status; cdecl; external TS_LIBRARY;

// Brings again the step that was taken back last. A new step forgets those. Errors: TS_E_NO_HISTORY, usage. Since
// 0.1.0; threads: exclusive.
function ts_redo(segmentation: Pts_segmentation): ts_status; cdecl; external TS_LIBRARY;

// `info->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Since 0.1.0; threads: concurrent.
function ts_get_history(segmentation: Pts_segmentation; info: Pts_history_info): ts_status; cdecl; external TS_LIBRARY;

// How many bytes the steps may keep; the oldest are dropped over it, at once. 256 MiB unless set. Since 0.1.0;
// threads: exclusive.
function ts_set_history_limit(segmentation: Pts_segmentation; bytes: UInt64): ts_status; cdecl; external TS_LIBRARY;

// Ids of the teeth that the last step, ts_undo or ts_redo changed: separated, cut anew, taken away, locked or
// unlocked. Since 0.1.0; threads: concurrent.
function ts_get_changes(segmentation: Pts_segmentation; teeth: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// `callback` NULL: none. Errors: TS_E_NULL. Since 0.1.0; threads: exclusive.
function ts_set_change_callback(segmentation: Pts_segmentation; callback: ts_change_fn; user: Pointer): ts_status; cdecl; external TS_LIBRARY;

// The session as JSON (docs/session-file.md): a hash of the mesh, features, options, every step and how many of them
// are taken back; no surface, no tooth. The two-call idiom; `text` is UTF-8 without a final 0. Since 0.1.0; threads:
// concurrent.
function ts_session_write(segmentation: Pts_segmentation; text: PAnsiChar; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// The same into a file, which is there whole or, where the call fails, as it was. Errors: TS_E_FILE_WRITE, usage.
// Since 0.1.0; threads: concurrent.
function ts_session_save(segmentation: Pts_segmentation; path: PAnsiChar): ts_status; cdecl; external TS_LIBRARY;

// Goes through the steps of a session again, on the model that it was of; what comes out goes on as the one that was
// written would. `features` out, may be NULL: as they were, to be destroyed by the caller. Only steps that can still
// be undone when the limit is 256 MiB can be. Errors: TS_E_MISMATCH where the model is another mesh, or what the
// library makes of a step is no longer what it was; TS_E_FILE_NEWER, TS_E_FILE_FORMAT (no session),
// TS_E_FILE_TRUNCATED, TS_E_FILE_SYNTAX (with the place), TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. Since 0.1.0;
// threads: concurrent.
function ts_session_read(model: Pts_model; text: PAnsiChar; size: NativeUInt; job: Pts_job; features: PPts_features; out_: PPts_segmentation): ts_status; cdecl; external TS_LIBRARY;

// The same from a file. Errors: TS_E_FILE_OPEN, and as ts_session_read. Since 0.1.0; threads: concurrent.
function ts_session_load(model: Pts_model; path: PAnsiChar; job: Pts_job; features: PPts_features; out_: PPts_segmentation): ts_status; cdecl; external TS_LIBRARY;

// Fills `options` with the defaults. `struct_size`: sizeof(ts_number_options). Errors: TS_E_NULL, TS_E_STRUCT_SIZE.
// Thread: any. Since 0.1.0; threads: any.
function ts_number_options_init(options: Pts_number_options; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Gives the teeth of a segmentation their FDI numbers: all feature groups in use and all groups made by clicks,
// separated or not (separated crowns are measured, which tells more). Permanent teeth only. The numbers rise along
// the arch; missing teeth leave theirs out. Told from widths and depths of the teeth, their places along the arch,
// the gaps between them and how their feature points lie; the patient's right from the occlusal direction and the
// side to which the arch bends. Coordinates are taken to be right-handed; which way faces look has no say. Numbers
// that were set by hand stay, and decide. Numbers do not change by themselves: call again after clicks. `options` in,
// may be NULL: the defaults; kept for ts_set_number. Errors, with all numbers as they were: TS_E_TOO_MANY_TEETH (over
// 16), TS_E_NUMBER_JAW (a number set by hand is of the other jaw than `options` give), TS_E_NUMBER_ORDER (those set
// fit no numbering), TS_E_INVALID_ARGUMENT (also where the features have no occlusal direction, or the line along the
// teeth is over 1000 mm long: a mesh in other units than it says), TS_E_NULL, TS_E_STRUCT_SIZE, TS_E_OUT_OF_MEMORY.
// Since 0.1.0; threads: exclusive.
function ts_assign_numbers(segmentation: Pts_segmentation; options: Pts_number_options): ts_status; cdecl; external TS_LIBRARY;

// Sets the number of a tooth by hand; those of the others follow, and so does the jaw. `tooth`: id of its group (that
// of its feature group, as ts_tooth_info::id), separated or not. `fdi`: 11 to 18, 21 to 28, 31 to 38, 41 to 48; 0
// forgets one that was set. Works before ts_assign_numbers too, with its default options. Errors, with all numbers as
// they were: TS_E_NOT_FOUND (no such tooth; 0 where none was set), TS_E_INVALID_ARGUMENT (no FDI number of a
// permanent tooth), TS_E_NUMBER_JAW (of the other jaw than was given or set), TS_E_NUMBER_TAKEN (set for another
// tooth), TS_E_NUMBER_ORDER (breaks the order along the arch, or leaves too few numbers between),
// TS_E_TOO_MANY_TEETH, TS_E_NULL, TS_E_OUT_OF_MEMORY. Since 0.1.0; threads: exclusive.
function ts_set_number(segmentation: Pts_segmentation; tooth: Cardinal; fdi: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// `tooth`: id of its group. `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND (no number was assigned to
// it), TS_E_NULL, TS_E_STRUCT_SIZE. Since 0.1.0; threads: concurrent.
function ts_get_number(segmentation: Pts_segmentation; tooth: Cardinal; info: Pts_number_info): ts_status; cdecl; external TS_LIBRARY;

// `info->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND (no numbers were assigned), TS_E_NULL,
// TS_E_STRUCT_SIZE. Since 0.1.0; threads: concurrent.
function ts_get_jaw(segmentation: Pts_segmentation; info: Pts_jaw_info): ts_status; cdecl; external TS_LIBRARY;

// FDI to Universal: 1 to 32 from the upper right third molar to the upper left, on from the lower left to the lower
// right. Errors: TS_E_INVALID_ARGUMENT (no number of a permanent tooth), TS_E_NULL. Thread: any. Since 0.1.0;
// threads: any.
function ts_fdi_to_universal(fdi: Cardinal; universal: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// And back. Errors and threads: as ts_fdi_to_universal. Since 0.1.0; threads: any.
function ts_universal_to_fdi(universal: Cardinal; fdi: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// `palmer->struct_size` in, the rest out. Errors: TS_E_INVALID_ARGUMENT (no FDI number of a permanent tooth),
// TS_E_NULL, TS_E_STRUCT_SIZE. Thread: any. Since 0.1.0; threads: any.
function ts_fdi_to_palmer(fdi: Cardinal; palmer: Pts_palmer): ts_status; cdecl; external TS_LIBRARY;

// Takes a point of the cut to another place on the surface. A stretch around the point follows, along the cheapest
// way through the new place in the prices of the minimum cut, which run along the bottoms of valleys; smoothed as the
// cut of a click is. All points outside the stretch stay the same to the bit. On an open loop the ends stay, too.
// `loop`, `point`: index of the point as ts_get_cut gives it; afterwards the points may have other indices. `to`: mm,
// taken to the nearest surface point. `reach`: half the length of the stretch along the cut, mm; 0: as long as the
// drag, and at least 2.5, as far as the minimum cut looks for a valley; at most 0.4 of the loop is taken. Errors:
// TS_E_NOT_FOUND (no such loop or point), TS_E_CLICK_OFF_SURFACE (further than click_reach), TS_E_EDIT_NOTHING (under
// 0.01 mm), TS_E_EDIT_ON_TOOTH, TS_E_EDIT_CROSSING, TS_E_EDIT_NO_LOOP. Since 0.1.0; threads: exclusive.
function ts_cut_drag(segmentation: Pts_segmentation; tooth: Cardinal; loop: Cardinal; point: Cardinal; to_: Pts_double3; reach: Double; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Draws a stretch of the cut: `count` points, at least 2, of 3 doubles, mm, taken to the surface and joined by
// shortest ways along it, the first and the last to the points of the cut that are nearest to them and have to be
// within click_reach. Of the two pieces of the loop between these the shorter one is replaced (of an open loop the
// one between them); the other stays the same to the bit. Corners are rounded only as far as the triangle that they
// lie in. Where the stroke crosses itself the loop is left out. Errors: TS_E_CLICK_OFF_SURFACE, TS_E_EDIT_OFF_CUT,
// TS_E_EDIT_NOTHING, TS_E_EDIT_ON_TOOTH, TS_E_EDIT_CROSSING (also where no short way along the surface leads from one
// point to the next), TS_E_EDIT_NO_LOOP. Since 0.1.0; threads: exclusive.
function ts_cut_draw(segmentation: Pts_segmentation; tooth: Cardinal; points: PDouble; count: Cardinal; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Moves the whole cut along the surface by `mm`, outwards where positive: to where the distance along the surface
// from the cut is that. What comes off or is enclosed by it up to 1 mm^2, and loops up to 3.5 mm long, are let go;
// open lines may come off the rim of the scan. Errors: TS_E_EDIT_NOTHING (0), TS_E_EDIT_NO_LOOP (also where feature
// points of the tooth would be left out), TS_E_EDIT_ON_TOOTH. Since 0.1.0; threads: exclusive.
function ts_cut_offset(segmentation: Pts_segmentation; tooth: Cardinal; mm: Double; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Smooths the whole cut: what bends within less than `strength`, mm, over 0 to 2, is straightened. The cut of a click
// is smoothed with smooth_radius already. Errors: TS_E_EDIT_NO_LOOP, TS_E_EDIT_CROSSING. Since 0.1.0; threads:
// exclusive.
function ts_cut_smooth(segmentation: Pts_segmentation; tooth: Cardinal; strength: Double; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Gives the tooth the cut of its click again and forgets its edits. TS_OK also where there are none. Since 0.1.0;
// threads: exclusive.
function ts_cut_reset(segmentation: Pts_segmentation; tooth: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// The edits of a tooth since the click, or the last ts_cut_reset, in their order. Const handle. Errors: TS_E_NULL,
// TS_E_NOT_FOUND, TS_E_BUFFER_TOO_SMALL. Since 0.1.0; threads: concurrent.
function ts_get_cut_edits(segmentation: Pts_segmentation; tooth: Cardinal; edits: Pts_cut_edit; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Fills `options` with the defaults. `struct_size`: sizeof(ts_tooth_mesh_options). Errors: TS_E_NULL,
// TS_E_STRUCT_SIZE. Thread: any. Since 0.1.0; threads: any.
function ts_tooth_mesh_options_init(options: Pts_tooth_mesh_options; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Makes the mesh of a tooth. `tooth` an id of ts_get_teeth; `options` in, may be NULL; `out` out, owned by the
// caller. Errors: TS_E_NOT_FOUND (no such tooth), TS_E_NO_CUT (its cut does not part it from the rest, or other teeth
// leave nothing of it), TS_E_NOT_CLOSED, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, usage. Thread: const. Since 0.1.0;
// threads: concurrent.
function ts_tooth_mesh_create(segmentation: Pts_segmentation; tooth: Cardinal; options: Pts_tooth_mesh_options; job: Pts_job; out_: PPts_mesh): ts_status; cdecl; external TS_LIBRARY;

// Makes the mesh of what belongs to no tooth separated so far: gingiva, base, and teeth not separated. Closed, its
// sockets and the rims of the scan are. Otherwise as ts_tooth_mesh_create. Since 0.1.0; threads: concurrent.
function ts_gingiva_mesh_create(segmentation: Pts_segmentation; options: Pts_tooth_mesh_options; job: Pts_job; out_: PPts_mesh): ts_status; cdecl; external TS_LIBRARY;

// Gives a mesh back; NULL is fine. Since 0.1.0; threads: exclusive.
procedure ts_mesh_destroy(mesh: Pts_mesh); cdecl; external TS_LIBRARY;

// `info->struct_size` in, the rest out. Errors: TS_E_NULL, TS_E_STRUCT_SIZE. Thread: const. Since 0.1.0; threads:
// concurrent.
function ts_mesh_get_info(mesh: Pts_mesh; info: Pts_mesh_info): ts_status; cdecl; external TS_LIBRARY;

// Vertices: `xyz` 3 doubles a vertex, mm; `capacity` and `count` in vertices. Errors: TS_E_NULL,
// TS_E_BUFFER_TOO_SMALL. Thread: const. Since 0.1.0; threads: concurrent.
function ts_mesh_get_positions(mesh: Pts_mesh; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Unit normals of the vertices, outwards: 3 doubles a vertex; 0, 0, 0 where the triangles around cancel out.
// Otherwise as ts_mesh_get_positions. Since 0.1.0; threads: concurrent.
function ts_mesh_get_normals(mesh: Pts_mesh; xyz: PDouble; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Triangles: 3 vertex indices each, counter-clockwise seen from outside, also where the faces of the scan look
// inwards; `capacity` and `count` in triangles. Otherwise as ts_mesh_get_positions. Since 0.1.0; threads: concurrent.
function ts_mesh_get_triangles(mesh: Pts_mesh; triangles: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// For each triangle the model face that it is of, TS_NONE for those that close the mesh. Otherwise as
// ts_mesh_get_triangles. Since 0.1.0; threads: concurrent.
function ts_mesh_get_faces(mesh: Pts_mesh; faces: PCardinal; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// For each vertex a sum of ts_mesh_vertex_flag. Otherwise as ts_mesh_get_positions. Since 0.1.0; threads: concurrent.
function ts_mesh_get_vertex_flags(mesh: Pts_mesh; flags: PByte; capacity: Cardinal; count: PCardinal): ts_status; cdecl; external TS_LIBRARY;

// Writes a mesh to a file. `path`: UTF-8; it is written to a temporary file beside it and renamed, so that nothing is
// left half written, and what was there stays if it fails. Parts are named tooth_LABEL and gingiva in formats with
// names. Errors: TS_E_FILE_WRITE (the message says why: disk full, no such directory, not a regular file, ...),
// TS_E_INVALID_ARGUMENT, TS_E_CANCELLED, TS_E_OUT_OF_MEMORY, TS_E_NULL. Thread: const. Since 0.1.0; threads:
// concurrent.
function ts_mesh_save(mesh: Pts_mesh; path: PAnsiChar; format: ts_output_format; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// Fills `options` with the defaults. As ts_tooth_mesh_options_init. Since 0.1.0; threads: any.
function ts_save_options_init(options: Pts_save_options; struct_size: Cardinal): ts_status; cdecl; external TS_LIBRARY;

// Writes the whole scan with its teeth: colours and labels (PLY), a group (OBJ) or a node (GLB) a tooth and one for
// the gingiva; STL has the triangles alone. `options` in, may be NULL. Errors: those of ts_mesh_save, and
// TS_E_NO_CUT. Thread: const. Since 0.1.0; threads: concurrent.
function ts_segmentation_save(segmentation: Pts_segmentation; path: PAnsiChar; format: ts_output_format; options: Pts_save_options; job: Pts_job): ts_status; cdecl; external TS_LIBRARY;

// `frame->struct_size` in, the rest out. Errors: TS_E_NOT_FOUND, TS_E_INVALID_ARGUMENT (the features have no occlusal
// direction), TS_E_NULL, TS_E_STRUCT_SIZE. Thread: const. Since 0.1.0; threads: concurrent.
function ts_get_tooth_frame(segmentation: Pts_segmentation; tooth: Cardinal; frame: Pts_tooth_frame): ts_status; cdecl; external TS_LIBRARY;
{$ENDIF}

implementation

{$IFDEF TOOTHSEG_DYNAMIC}

uses
{$IFDEF FPC}
  dynlibs,
{$ELSE}
{$IFDEF MSWINDOWS}
  Windows,
{$ENDIF}
{$ENDIF}
  SysUtils;

const
{$IFDEF MSWINDOWS}
  FileName = 'toothseg.dll';
{$ELSE}
  FileName = {$IF DEFINED(DARWIN) OR DEFINED(MACOS)}'libtoothseg.dylib'{$ELSE}'libtoothseg.so.0'{$IFEND};
{$ENDIF}

type
  THandleOfLibrary = {$IFDEF FPC}TLibHandle{$ELSE}HMODULE{$ENDIF};

var
  Handle: THandleOfLibrary;
  OpenName: string;
  Loaded: Boolean;

procedure OpenLibrary(const Path: string);
begin
  OpenName := Path;
  if OpenName = '' then
    OpenName := GetEnvironmentVariable('TOOTHSEG_LIBRARY');
  if OpenName = '' then
    OpenName := FileName;
  Handle := LoadLibrary({$IFDEF FPC}OpenName{$ELSE}PChar(OpenName){$ENDIF});
  if Handle = 0 then
    raise EOSError.CreateFmt('%s: cannot be loaded', [OpenName]);
end;

function Find(const Name: string): Pointer;
begin
  Result := GetProcAddress(Handle, {$IFDEF FPC}Name{$ELSE}PChar(Name){$ENDIF});
  if Result = nil then
    raise EOSError.CreateFmt('%s: has no function %s', [OpenName, Name]);
end;

procedure ts_need;
begin
  if not Loaded then
    ts_load('');
end;

procedure ts_load(const Path: string);
begin
  OpenLibrary(Path);
  @ts_version := Find('ts_version');
  @ts_status_name := Find('ts_status_name');
  @ts_last_error_message := Find('ts_last_error_message');
  @ts_context_options_init := Find('ts_context_options_init');
  @ts_context_create := Find('ts_context_create');
  @ts_context_destroy := Find('ts_context_destroy');
  @ts_job_create := Find('ts_job_create');
  @ts_job_cancel := Find('ts_job_cancel');
  @ts_job_reset := Find('ts_job_reset');
  @ts_job_progress := Find('ts_job_progress');
  @ts_job_destroy := Find('ts_job_destroy');
  @ts_mesh_input_init := Find('ts_mesh_input_init');
  @ts_intake_options_init := Find('ts_intake_options_init');
  @ts_model_create := Find('ts_model_create');
  @ts_model_load := Find('ts_model_load');
  @ts_model_read := Find('ts_model_read');
  @ts_model_destroy := Find('ts_model_destroy');
  @ts_model_get_report := Find('ts_model_get_report');
  @ts_model_get_positions := Find('ts_model_get_positions');
  @ts_model_get_triangles := Find('ts_model_get_triangles');
  @ts_model_get_face_sources := Find('ts_model_get_face_sources');
  @ts_model_get_vertex_map := Find('ts_model_get_vertex_map');
  @ts_model_nearest := Find('ts_model_nearest');
  @ts_model_raycast := Find('ts_model_raycast');
  @ts_feature_options_init := Find('ts_feature_options_init');
  @ts_detect_features := Find('ts_detect_features');
  @ts_features_create := Find('ts_features_create');
  @ts_features_clone := Find('ts_features_clone');
  @ts_features_destroy := Find('ts_features_destroy');
  @ts_features_get_info := Find('ts_features_get_info');
  @ts_features_get_occlusal := Find('ts_features_get_occlusal');
  @ts_features_set_occlusal := Find('ts_features_set_occlusal');
  @ts_features_get_arch := Find('ts_features_get_arch');
  @ts_features_get_points := Find('ts_features_get_points');
  @ts_features_get_groups := Find('ts_features_get_groups');
  @ts_features_add_point := Find('ts_features_add_point');
  @ts_features_move_point := Find('ts_features_move_point');
  @ts_features_set_group := Find('ts_features_set_group');
  @ts_features_remove_point := Find('ts_features_remove_point');
  @ts_features_remove_group := Find('ts_features_remove_group');
  @ts_segment_options_init := Find('ts_segment_options_init');
  @ts_segmentation_create := Find('ts_segmentation_create');
  @ts_segmentation_destroy := Find('ts_segmentation_destroy');
  @ts_segment_click := Find('ts_segment_click');
  @ts_segment_clicks := Find('ts_segment_clicks');
  @ts_propose_clicks := Find('ts_propose_clicks');
  @ts_get_click_count := Find('ts_get_click_count');
  @ts_get_click := Find('ts_get_click');
  @ts_get_field := Find('ts_get_field');
  @ts_get_histogram := Find('ts_get_histogram');
  @ts_get_contours := Find('ts_get_contours');
  @ts_get_contour_points := Find('ts_get_contour_points');
  @ts_get_teeth := Find('ts_get_teeth');
  @ts_get_tooth := Find('ts_get_tooth');
  @ts_get_tooth_faces := Find('ts_get_tooth_faces');
  @ts_get_tooth_vertices := Find('ts_get_tooth_vertices');
  @ts_get_tooth_seeds := Find('ts_get_tooth_seeds');
  @ts_get_cut := Find('ts_get_cut');
  @ts_get_labels := Find('ts_get_labels');
  @ts_get_prepare_times := Find('ts_get_prepare_times');
  @ts_get_memory := Find('ts_get_memory');
  @ts_segment_all := Find('ts_segment_all');
  @ts_get_review := Find('ts_get_review');
  @ts_tooth_include := Find('ts_tooth_include');
  @ts_tooth_exclude := Find('ts_tooth_exclude');
  @ts_tooth_split := Find('ts_tooth_split');
  @ts_tooth_move_point := Find('ts_tooth_move_point');
  @ts_tooth_merge := Find('ts_tooth_merge');
  @ts_tooth_remove := Find('ts_tooth_remove');
  @ts_tooth_set_locked := Find('ts_tooth_set_locked');
  @ts_tooth_get_locked := Find('ts_tooth_get_locked');
  @ts_get_overlaps := Find('ts_get_overlaps');
  @ts_undo := Find('ts_undo');
  @ts_redo := Find('ts_redo');
  @ts_get_history := Find('ts_get_history');
  @ts_set_history_limit := Find('ts_set_history_limit');
  @ts_get_changes := Find('ts_get_changes');
  @ts_set_change_callback := Find('ts_set_change_callback');
  @ts_session_write := Find('ts_session_write');
  @ts_session_save := Find('ts_session_save');
  @ts_session_read := Find('ts_session_read');
  @ts_session_load := Find('ts_session_load');
  @ts_number_options_init := Find('ts_number_options_init');
  @ts_assign_numbers := Find('ts_assign_numbers');
  @ts_set_number := Find('ts_set_number');
  @ts_get_number := Find('ts_get_number');
  @ts_get_jaw := Find('ts_get_jaw');
  @ts_fdi_to_universal := Find('ts_fdi_to_universal');
  @ts_universal_to_fdi := Find('ts_universal_to_fdi');
  @ts_fdi_to_palmer := Find('ts_fdi_to_palmer');
  @ts_cut_drag := Find('ts_cut_drag');
  @ts_cut_draw := Find('ts_cut_draw');
  @ts_cut_offset := Find('ts_cut_offset');
  @ts_cut_smooth := Find('ts_cut_smooth');
  @ts_cut_reset := Find('ts_cut_reset');
  @ts_get_cut_edits := Find('ts_get_cut_edits');
  @ts_tooth_mesh_options_init := Find('ts_tooth_mesh_options_init');
  @ts_tooth_mesh_create := Find('ts_tooth_mesh_create');
  @ts_gingiva_mesh_create := Find('ts_gingiva_mesh_create');
  @ts_mesh_destroy := Find('ts_mesh_destroy');
  @ts_mesh_get_info := Find('ts_mesh_get_info');
  @ts_mesh_get_positions := Find('ts_mesh_get_positions');
  @ts_mesh_get_normals := Find('ts_mesh_get_normals');
  @ts_mesh_get_triangles := Find('ts_mesh_get_triangles');
  @ts_mesh_get_faces := Find('ts_mesh_get_faces');
  @ts_mesh_get_vertex_flags := Find('ts_mesh_get_vertex_flags');
  @ts_mesh_save := Find('ts_mesh_save');
  @ts_save_options_init := Find('ts_save_options_init');
  @ts_segmentation_save := Find('ts_segmentation_save');
  @ts_get_tooth_frame := Find('ts_get_tooth_frame');
  Loaded := True;
end;
{$ENDIF}

end.
