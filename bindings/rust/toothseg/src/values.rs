// SPDX-License-Identifier: Apache-2.0
//! Enums and sums of flags. They are numbers with names, not enums: a newer library may have values that are not known here.

use crate::raw::{FromRaw, IntoRaw};
use std::fmt;
use toothseg_sys::*;

macro_rules! named {
    ($(#[$doc:meta])* $name:ident: $raw:ident { $($(#[$value_doc:meta])* $value:ident = $c:ident,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        pub struct $name($raw);

        impl $name {
            $($(#[$value_doc])* pub const $value: $name = $name($c);)*

            /// All that have a name here.
            pub const NAMED: &'static [$name] = &[$($name::$value),*];

            /// Its number in the C API.
            pub const fn code(self) -> u32 {
                self.0
            }
        }

        impl FromRaw<$raw> for $name {
            fn from_raw(raw: $raw) -> Self {
                $name(raw)
            }
        }

        impl IntoRaw<$raw> for $name {
            fn into_raw(self) -> $raw {
                self.0
            }
        }
    };
}

macro_rules! enumeration {
    ($(#[$doc:meta])* $name:ident: $raw:ident { $($(#[$value_doc:meta])* $value:ident = $c:ident,)* }) => {
        named! { $(#[$doc])* $name: $raw { $($(#[$value_doc])* $value = $c,)* } }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match *self {
                    $($name::$value => f.write_str(stringify!($value)),)*
                    $name(other) => write!(f, "{other}"),
                }
            }
        }
    };
}

macro_rules! flags {
    ($(#[$doc:meta])* $name:ident: $raw:ident { $($(#[$value_doc:meta])* $value:ident = $c:ident,)* }) => {
        named! { $(#[$doc])* $name: $raw { $($(#[$value_doc])* $value = $c,)* } }

        impl $name {
            /// Whether there is none.
            pub const fn is_empty(self) -> bool {
                self.0 == 0
            }

            /// Whether all of `other` are among them.
            pub const fn contains(self, other: $name) -> bool {
                self.0 & other.0 == other.0
            }
        }

        impl std::ops::BitOr for $name {
            type Output = $name;
            fn bitor(self, other: $name) -> $name {
                $name(self.0 | other.0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let mut set = f.debug_set();
                $(if self.contains($name::$value) {
                    set.entry(&format_args!("{}", stringify!($value)));
                })*
                set.finish()
            }
        }
    };
}

enumeration! {
    /// What came of a call.
    Status: ts_status {
        /// Done.
        OK = TS_OK,
        /// A value outside its stated range.
        INVALID_ARGUMENT = TS_E_INVALID_ARGUMENT,
        /// A pointer that must not be NULL is.
        NULL = TS_E_NULL,
        /// A size of a struct that no release had.
        STRUCT_SIZE = TS_E_STRUCT_SIZE,
        /// A buffer is too small.
        BUFFER_TOO_SMALL = TS_E_BUFFER_TOO_SMALL,
        /// No such group, point, click, tooth, loop or contour.
        NOT_FOUND = TS_E_NOT_FOUND,
        /// Objects that do not belong together.
        MISMATCH = TS_E_MISMATCH,
        /// An allocation failed, or the memory limit is too small for any way of work.
        OUT_OF_MEMORY = TS_E_OUT_OF_MEMORY,
        /// The job was cancelled.
        CANCELLED = TS_E_CANCELLED,
        /// A fault in the library: please report the message.
        INTERNAL = TS_E_INTERNAL,
        /// Cannot be opened or read.
        FILE_OPEN = TS_E_FILE_OPEN,
        /// Not a format that is read.
        FILE_FORMAT = TS_E_FILE_FORMAT,
        /// Ends before what its header or its last statement promises.
        FILE_TRUNCATED = TS_E_FILE_TRUNCATED,
        /// Goes on after what its header promises.
        FILE_TRAILING = TS_E_FILE_TRAILING,
        /// A count that the file's size contradicts.
        FILE_COUNT = TS_E_FILE_COUNT,
        /// Text where a number or keyword belongs.
        FILE_SYNTAX = TS_E_FILE_SYNTAX,
        /// Cannot be written; nothing is left half written.
        FILE_WRITE = TS_E_FILE_WRITE,
        /// A session of a later format than this library reads.
        FILE_NEWER = TS_E_FILE_NEWER,
        /// No face, or none that is not degenerate.
        MESH_EMPTY = TS_E_MESH_EMPTY,
        /// NaN or infinity among the coordinates.
        MESH_NON_FINITE = TS_E_MESH_NON_FINITE,
        /// A triangle names a vertex that is not there.
        MESH_INDEX_RANGE = TS_E_MESH_INDEX_RANGE,
        /// Too small or too large for a scan in mm.
        MESH_UNITS = TS_E_MESH_UNITS,
        /// Too many faces or vertices, or coordinates too large.
        MESH_TOO_LARGE = TS_E_MESH_TOO_LARGE,
        /// Nothing on the mesh looks like a tooth.
        NO_TEETH = TS_E_NO_TEETH,
        /// No group with a point: there is nothing to separate.
        NO_CONSTRAINT = TS_E_NO_CONSTRAINT,
        /// The click is too far from the surface.
        CLICK_OFF_SURFACE = TS_E_CLICK_OFF_SURFACE,
        /// The click lies on gingiva or base, not on a tooth.
        CLICK_ON_GINGIVA = TS_E_CLICK_ON_GINGIVA,
        /// No contour of the field separates the tooth.
        NO_CUT = TS_E_NO_CUT,
        /// The linear system could not be factorised.
        SOLVER = TS_E_SOLVER,
        /// The tooth is locked, and the call would change it.
        LOCKED = TS_E_LOCKED,
        /// What is asked for is so already.
        NO_CHANGE = TS_E_NO_CHANGE,
        /// Nothing to undo, or to redo.
        NO_HISTORY = TS_E_NO_HISTORY,
        /// The edit would change nothing.
        EDIT_NOTHING = TS_E_EDIT_NOTHING,
        /// The new line would run on another tooth, or take in its feature points.
        EDIT_ON_TOOTH = TS_E_EDIT_ON_TOOTH,
        /// The new line would cross the rest of the cut, or part the tooth's feature points from it.
        EDIT_CROSSING = TS_E_EDIT_CROSSING,
        /// The edit does not come near the cut that it is to change.
        EDIT_OFF_CUT = TS_E_EDIT_OFF_CUT,
        /// A loop of the cut would vanish, or become several.
        EDIT_NO_LOOP = TS_E_EDIT_NO_LOOP,
        /// More teeth along the arch than a jaw has.
        TOO_MANY_TEETH = TS_E_TOO_MANY_TEETH,
        /// A number of the other jaw.
        NUMBER_JAW = TS_E_NUMBER_JAW,
        /// The number has been set for another tooth.
        NUMBER_TAKEN = TS_E_NUMBER_TAKEN,
        /// Numbers would not rise along the arch, or leave none for the teeth between.
        NUMBER_ORDER = TS_E_NUMBER_ORDER,
        /// A rim cannot be closed without the mesh running through itself.
        NOT_CLOSED = TS_E_NOT_CLOSED,
    }
}

enumeration! {
    /// How much a line of the log matters.
    LogLevel: ts_log_level {
        /// A call failed.
        ERROR = TS_LOG_ERROR,
        /// Something looks odd; results are there all the same.
        WARNING = TS_LOG_WARNING,
        /// What is being done.
        INFO = TS_LOG_INFO,
    }
}

enumeration! {
    /// Type of a coordinate.
    Scalar: ts_scalar {
        /// f32
        FLOAT32 = TS_FLOAT32,
        /// f64
        FLOAT64 = TS_FLOAT64,
    }
}

enumeration! {
    /// Unit of the coordinates of a mesh that comes in.
    Unit: ts_unit {
        /// mm, refused where the size of the mesh contradicts it.
        CHECKED_MM = TS_UNIT_CHECKED_MM,
        /// mm, without a check.
        MM = TS_UNIT_MM,
        /// cm
        CM = TS_UNIT_CM,
        /// m
        M = TS_UNIT_M,
        /// inch
        INCH = TS_UNIT_INCH,
    }
}

enumeration! {
    /// Format of a file that is read.
    FileFormat: ts_file_format {
        /// Told from the content.
        AUTO = TS_FORMAT_AUTO,
        /// STL, binary or ASCII.
        STL = TS_FORMAT_STL,
        /// PLY, ASCII or binary.
        PLY = TS_FORMAT_PLY,
        /// OBJ
        OBJ = TS_FORMAT_OBJ,
        /// OFF
        OFF = TS_FORMAT_OFF,
    }
}

flags! {
    /// What the detection found odd about the scan as a whole.
    FeaturesWarnings: ts_features_warning {
        /// The faces look inwards: harmless.
        INSIDE_OUT = TS_WARN_FEATURES_INSIDE_OUT,
        /// Teeth look both ways: two jaws in occlusion, or the direction is wrong.
        OPPOSED = TS_WARN_FEATURES_OPPOSED,
        /// Much that is as rough as teeth lies off the arch: two jaws side by side.
        SEVERAL_ARCHES = TS_WARN_FEATURES_SEVERAL_ARCHES,
    }
}

enumeration! {
    /// Where the options of a segmentation begin.
    Preset: ts_preset {
        /// The best we know.
        DEFAULT = TS_PRESET_DEFAULT,
        /// The paper to the letter.
        PAPER = TS_PRESET_PAPER,
    }
}

enumeration! {
    /// Weights of the Laplacian.
    Weights: ts_weights {
        /// By concavity at a physical radius.
        CONCAVITY = TS_WEIGHTS_CONCAVITY,
        /// The paper's, with its test.
        PAPER = TS_WEIGHTS_PAPER,
        /// Cotangents, negative ones clamped.
        COTANGENT = TS_WEIGHTS_COTANGENT,
        /// 1
        UNIFORM = TS_WEIGHTS_UNIFORM,
        /// Feature-preserving: every bend counts.
        FEATURE = TS_WEIGHTS_FEATURE,
    }
}

enumeration! {
    /// What is held at the background value beside the neighbour tooth.
    Background: ts_background {
        /// Nothing: the paper's pair.
        NEIGHBOUR = TS_BACKGROUND_NEIGHBOUR,
        /// Vertices far from every feature point.
        GINGIVA = TS_BACKGROUND_GINGIVA,
        /// These, and the points of all other groups.
        ALL = TS_BACKGROUND_ALL,
    }
}

enumeration! {
    /// How the contour of a tooth is chosen.
    CutRule: ts_cut_rule {
        /// The largest mean gradient: the paper's.
        GRADIENT = TS_CUT_GRADIENT,
        /// The best concavity and gradient, and a tooth's area.
        COMPONENT = TS_CUT_COMPONENT,
        /// Half way between the tooth's value and the background's.
        HALF = TS_CUT_HALF,
    }
}

flags! {
    /// What looks wrong about a tooth.
    ToothWarnings: ts_tooth_warning {
        /// Under the least area.
        AREA_SMALL = TS_WARN_AREA_SMALL,
        /// Over the largest area.
        AREA_LARGE = TS_WARN_AREA_LARGE,
        /// The crown runs into a border of the scan.
        OPEN_AT_BORDER = TS_WARN_OPEN_AT_BORDER,
        /// The cut is not one closed line.
        SEVERAL_LOOPS = TS_WARN_SEVERAL_LOOPS,
        /// No neighbour was there to be background.
        NO_NEIGHBOUR = TS_WARN_NO_NEIGHBOUR,
        /// A feature point contradicted the field and was not used.
        SEED_REJECTED = TS_WARN_SEED_REJECTED,
        /// Wider or narrower along the arch than a tooth is.
        WIDTH = TS_WARN_WIDTH,
        /// A feature point of another group lies on it.
        TWO_GROUPS = TS_WARN_TWO_GROUPS,
        /// Its top is one plane: a scan body or a post.
        FLAT_TOP = TS_WARN_FLAT_TOP,
        /// The click alone says that it is a tooth.
        MADE_BY_CLICK = TS_WARN_MADE_BY_CLICK,
    }
}

enumeration! {
    /// The jaw of a scan.
    Jaw: ts_jaw {
        /// Not known; in options: to be estimated.
        UNKNOWN = TS_JAW_UNKNOWN,
        /// Maxilla.
        UPPER = TS_JAW_UPPER,
        /// Mandible.
        LOWER = TS_JAW_LOWER,
    }
}

enumeration! {
    /// How a cut was edited.
    EditKind: ts_edit_kind {
        /// A point was taken to another place.
        DRAG = TS_EDIT_DRAG,
        /// A stretch was drawn.
        DRAW = TS_EDIT_DRAW,
        /// The whole cut was moved along the surface.
        OFFSET = TS_EDIT_OFFSET,
        /// The whole cut was smoothed.
        SMOOTH = TS_EDIT_SMOOTH,
    }
}

flags! {
    /// What a vertex of a mesh is.
    VertexFlags: ts_mesh_vertex_flag {
        /// Shared with another part.
        ON_CUT = TS_VERTEX_ON_CUT,
        /// On a rim of the scan.
        ON_RIM = TS_VERTEX_ON_RIM,
        /// Made to close the mesh.
        OF_FILL = TS_VERTEX_OF_FILL,
    }
}

impl FromRaw<u8> for VertexFlags {
    fn from_raw(raw: u8) -> Self {
        VertexFlags(raw.into())
    }
}

enumeration! {
    /// Format of a file that is written.
    OutputFormat: ts_output_format {
        /// Binary STL.
        STL = TS_OUTPUT_STL,
        /// Binary PLY with colours and labels.
        PLY = TS_OUTPUT_PLY,
        /// OBJ, a group a part.
        OBJ = TS_OUTPUT_OBJ,
        /// glTF 2.0 binary, a mesh a part.
        GLB = TS_OUTPUT_GLB,
    }
}
