// SPDX-License-Identifier: Apache-2.0
//! Options. Their defaults come from the library; change what is wanted with struct-update syntax.

use crate::raw::{check, FromRaw, IntoRaw};
use crate::values::*;
use toothseg_sys as sys;

macro_rules! options {
    ($(#[$doc:meta])* $name:ident: $raw:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $type,)*
        }

        impl $name {
            pub(crate) fn raw(&self) -> sys::$raw {
                sys::$raw { $($field: self.$field.into_raw(),)* ..sys::$raw::default() }
            }

            fn initialised(init: impl FnOnce(&mut sys::$raw) -> sys::ts_status) -> Self {
                let mut raw = sys::$raw::default();
                check(init(&mut raw)).expect("the library is too old");
                $name { $($field: FromRaw::from_raw(raw.$field),)* }
            }
        }
    };
}

macro_rules! default_from {
    ($($name:ident: $init:ident),*) => {$(
        impl Default for $name {
            fn default() -> Self {
                Self::initialised(|raw| unsafe { sys::$init(raw, raw.struct_size) })
            }
        }
    )*};
}

default_from!(
    IntakeOptions: ts_intake_options_init,
    FeatureOptions: ts_feature_options_init,
    NumberOptions: ts_number_options_init,
    ToothMeshOptions: ts_tooth_mesh_options_init,
    SaveOptions: ts_save_options_init
);

options! {
    /// How a mesh comes in.
    IntakeOptions: ts_intake_options {
        /// Unit of the coordinates. Default [`Unit::CHECKED_MM`].
        unit: Unit,
        /// Vertices closer than this become one, mm. Default 0: only exactly equal ones.
        weld_tolerance: f64,
    }
}

options! {
    /// How feature points are found.
    FeatureOptions: ts_feature_options {
        /// Most points a tooth. Default 8.
        max_points: u32,
        /// A direction to use instead of the estimated one. Default: none.
        occlusal: Option<[f64; 3]>,
        /// Radius of the convexity measure, mm. Default 2.
        radius: f64,
    }
}

options! {
    /// How teeth are separated. Defaults are given as: default preset / paper preset.
    SegmentOptions: ts_segment_options {
        /// What the options were initialised to; informative.
        preset: Preset,
        /// CONCAVITY / PAPER
        weights: Weights,
        /// ALL / NEIGHBOUR
        background: Background,
        /// COMPONENT / GRADIENT
        cut_rule: CutRule,
        /// Number of iso-values sampled. 100 / 100
        contours: u32,
        /// 50 / 50
        histogram_bins: u32,
        /// Most constraint points used a tooth; 0 = all. 0 / 0
        points_per_group: u32,
        /// Penalty; 0 = exact constraints. 1e8 / 1e8
        alpha: f64,
        /// Factor of a concave edge, least weight of CONCAVITY. 1e-3 / 0.01
        beta: f64,
        /// 1e-4 / 1e-4
        gamma: f64,
        /// Threshold of a concave edge. 0.2 / 0.001
        theta: f64,
        /// Decay of the CONCAVITY weights, 1/mm. 0.07
        c0: f64,
        /// Radius of the smoothed normals, mm. 0.15
        normal_radius: f64,
        /// A constraint point is a disc of this radius, mm; 0 = one vertex. 0.7 / 0
        seed_radius: f64,
        /// From every feature point, mm, at which gingiva begins for certain. 13
        gingiva_distance: f64,
        /// Least area of a tooth, mm^2. 25
        area_min: f64,
        /// Largest area of a tooth, mm^2. 330
        area_max: f64,
        /// Holes in a tooth's region up to this are filled, mm^2. 40 / 0
        hole_area: f64,
        /// Half width of the band of the min-cut refinement, mm; 0 = none. 2.5 / 0
        refine_band: f64,
        /// Smoothing of the final line, mm; 0 = none. 0.2 / 0
        smooth_radius: f64,
        /// A click further from the surface than this is off it, mm. 2 / 2
        click_reach: f64,
        /// How much further a click has it to points across concave valleys. 60 / 0
        click_concavity: f64,
        /// Free feature points that contradict the field. true / false
        reject_outliers: bool,
        /// Bytes that may be kept beside the model; 0 = no limit. 0 / 0
        memory_limit: u64,
    }
}

impl SegmentOptions {
    /// The options of a preset.
    pub fn preset(preset: Preset) -> Self {
        Self::initialised(|raw| unsafe { sys::ts_segment_options_init(raw, raw.struct_size, preset.code()) })
    }
}

/// Those of [`Preset::DEFAULT`].
impl Default for SegmentOptions {
    fn default() -> Self {
        Self::preset(Preset::DEFAULT)
    }
}

options! {
    /// How numbers are told.
    NumberOptions: ts_number_options {
        /// Default [`Jaw::UNKNOWN`]: estimated.
        jaw: Jaw,
        /// The scan is a mirror image of the patient. Default false.
        mirrored: bool,
        /// A number or a jaw under it is uncertain, 0 to 1. Default 0.9.
        least_confidence: f64,
    }
}

options! {
    /// How the mesh of a tooth is made.
    ToothMeshOptions: ts_tooth_mesh_options {
        /// All rims are closed by smooth membranes. Default false.
        closed: bool,
    }
}

options! {
    /// How a scan with its teeth is written.
    SaveOptions: ts_save_options {
        /// The model's faces as they are, not split along the cuts. Default false.
        whole_faces: bool,
    }
}
