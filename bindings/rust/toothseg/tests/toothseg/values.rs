// SPDX-License-Identifier: Apache-2.0
use std::ffi::CStr;
use toothseg::*;
use toothseg_sys as sys;

#[test]
fn version_is_the_library_s() {
    let header = format!("{}.{}.{}", sys::TS_VERSION_MAJOR, sys::TS_VERSION_MINOR, sys::TS_VERSION_PATCH);
    assert_eq!(version(), header);
    assert_eq!(version(), env!("CARGO_PKG_VERSION"));
}

/// Every value of the C API has a name here, which ends its name there.
macro_rules! all_are_named {
    ($($name:ident: $values:ident;)*) => {
        #[test]
        fn all_values_are_named() {
            $(
                assert_eq!($name::NAMED.len(), sys::$values.len(), stringify!($name));
                for (name, value) in sys::$values {
                    let here = $name::NAMED.iter().find(|v| v.code() == *value).expect(name);
                    let text = format!("{here:?}");
                    assert!(name.ends_with(text.trim_matches(&['{', '}'][..])), "{name} is {text}");
                }
            )*
        }
    };
}
all_are_named! {
    Status: TS_STATUS_VALUES;
    LogLevel: TS_LOG_LEVEL_VALUES;
    Scalar: TS_SCALAR_VALUES;
    Unit: TS_UNIT_VALUES;
    FileFormat: TS_FILE_FORMAT_VALUES;
    FeaturesWarnings: TS_FEATURES_WARNING_VALUES;
    Preset: TS_PRESET_VALUES;
    Weights: TS_WEIGHTS_VALUES;
    Background: TS_BACKGROUND_VALUES;
    CutRule: TS_CUT_RULE_VALUES;
    ToothWarnings: TS_TOOTH_WARNING_VALUES;
    Jaw: TS_JAW_VALUES;
    EditKind: TS_EDIT_KIND_VALUES;
    VertexFlags: TS_MESH_VERTEX_FLAG_VALUES;
    OutputFormat: TS_OUTPUT_FORMAT_VALUES;
}

#[test]
fn statuses_have_the_library_s_names() {
    for (name, value) in sys::TS_STATUS_VALUES {
        let library = unsafe { CStr::from_ptr(sys::ts_status_name(*value)) };
        assert_eq!(library.to_str(), Ok(*name));
        assert_eq!(Status::NAMED.iter().find(|s| s.code() == *value).unwrap().name(), *name);
    }
    assert!(Status::OK.is_ok() && !Status::NO_CUT.is_ok());
}

#[test]
fn flags_add_up() {
    let both = ToothWarnings::WIDTH | ToothWarnings::FLAT_TOP;
    assert!(both.contains(ToothWarnings::WIDTH) && !ToothWarnings::WIDTH.contains(both) && !both.is_empty());
    assert_eq!(format!("{both:?}"), "{WIDTH, FLAT_TOP}");
    assert_eq!(both.code(), 64 + 256);
}

#[test]
fn defaults_are_the_library_s() {
    let default = SegmentOptions::default();
    assert_eq!(
        (default.preset, default.weights, default.cut_rule),
        (Preset::DEFAULT, Weights::CONCAVITY, CutRule::COMPONENT)
    );
    assert_eq!((default.background, default.contours, default.alpha), (Background::ALL, 100, 1e8));
    assert!(default.reject_outliers);
    let paper = SegmentOptions::preset(Preset::PAPER);
    assert_eq!((paper.preset, paper.weights, paper.seed_radius), (Preset::PAPER, Weights::PAPER, 0.0));
    let changed = SegmentOptions { contours: 50, ..paper.clone() };
    assert_eq!((changed.contours, changed.beta), (50, paper.beta));
    assert_eq!(IntakeOptions::default(), IntakeOptions { unit: Unit::CHECKED_MM, weld_tolerance: 0.0 });
    assert_eq!(FeatureOptions::default(), FeatureOptions { max_points: 8, occlusal: None, radius: 2.0 });
    assert_eq!(NumberOptions::default(), NumberOptions { jaw: Jaw::UNKNOWN, mirrored: false, least_confidence: 0.9 });
    assert!(!ToothMeshOptions::default().closed && !SaveOptions::default().whole_faces);
    assert_eq!(ContextOptions::default().threads, 0);
}

#[test]
fn numbers_in_other_notations() {
    assert_eq!(fdi_to_universal(18), Ok(1));
    assert_eq!(fdi_to_universal(36), Ok(19));
    assert_eq!(universal_to_fdi(32), Ok(48));
    let palmer = fdi_to_palmer(16).unwrap();
    assert_eq!((palmer.quadrant, palmer.position, palmer.letters.as_str()), (1, 6, "UR6"));
    assert!(palmer.symbol.contains('6') && palmer.symbol.chars().count() == 2, "{palmer:?}");
}
