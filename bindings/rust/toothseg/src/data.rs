// SPDX-License-Identifier: Apache-2.0
//! What the library tells. Lengths are mm, areas mm^2, times ms.

use crate::raw::FromRaw;
use crate::values::*;
use toothseg_sys as sys;

macro_rules! data {
    ($(#[$doc:meta])* $name:ident: $raw:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $type,)*
        }

        impl FromRaw<sys::$raw> for $name {
            fn from_raw(raw: sys::$raw) -> Self {
                $name { $($field: FromRaw::from_raw(raw.$field),)* }
            }
        }
    };
}

data! {
    /// What intake found and repaired. Counts of the caller's elements unless said otherwise.
    IntakeReport: ts_intake_report {
        /// As given; a soup has 3 a face.
        input_vertices: u32,
        /// As given; polygons count once.
        input_faces: u32,
        /// Input faces with more than 3 corners, triangulated.
        polygons: u32,
        /// Input vertices merged into another.
        welded_vertices: u32,
        /// Used by no face: dropped.
        unreferenced_vertices: u32,
        /// Fewer than 3 distinct corners, or no area: dropped.
        degenerate_faces: u32,
        /// Same corners as another face: dropped.
        duplicate_faces: u32,
        /// Wound against the majority of their piece: turned round.
        flipped_faces: u32,
        /// Edges of more than 2 faces: split.
        non_manifold_edges: u32,
        /// Vertices where several fans met: split.
        non_manifold_vertices: u32,
        /// Edges cut open because no winding fits both sides.
        unorientable_edges: u32,
        /// Of the model.
        vertices: u32,
        /// Of the model.
        faces: u32,
        /// Connected pieces of the model.
        components: u32,
        /// Open rims of the model.
        boundary_loops: u32,
        /// Of the bounding box.
        diagonal: f64,
        /// Of the model.
        area: f64,
        /// Mean length of the model's edges.
        mean_edge: f64,
    }
}

data! {
    /// A point on the surface: a model face and the weights of its three corners.
    SurfacePoint: ts_surface_point {
        /// Model face.
        face: u32,
        /// The corner with the largest weight.
        nearest_vertex: u32,
        /// Weights of the corners, sum 1.
        barycentric: [f64; 3],
        /// Where it is.
        position: [f64; 3],
        /// From the query position, or along the ray from its origin.
        distance: f64,
    }
}

data! {
    /// What a set of features holds, and what the detection saw.
    FeaturesInfo: ts_features_info {
        /// Number of groups.
        groups: u32,
        /// Number of points.
        points: u32,
        /// The faces look inwards; everything works all the same.
        inside_out: bool,
        /// What is odd about the scan.
        warnings: FeaturesWarnings,
        /// Roughness that faces against the occlusal direction over that which faces with it.
        opposed: f64,
        /// Share of the roughness near the arch curve.
        coverage: f64,
        /// Length of the arch curve.
        arch_length: f64,
    }
}

data! {
    /// A feature point.
    FeaturePoint: ts_feature_point {
        /// Stays the same while the point exists.
        id: u32,
        /// Id of its group.
        group: u32,
        /// Nearest model vertex.
        vertex: u32,
        /// The caller set it.
        by_hand: bool,
        /// Where it is.
        position: [f64; 3],
        /// 0 on a plane, 0.25 to 0.4 on a cusp; 0 for a point set by hand.
        convexity: f64,
    }
}

data! {
    /// The feature points of one tooth.
    FeatureGroup: ts_feature_group {
        /// Stays the same while the group exists.
        id: u32,
        /// Number of points.
        points: u32,
        /// The neighbour group along the arch.
        previous: Option<u32>,
        /// The other one.
        next: Option<u32>,
        /// Mean of its points.
        centre: [f64; 3],
        /// Where its tooth begins along the arch curve.
        arch_from: f64,
        /// Where it ends.
        arch_to: f64,
        /// How sure the detection is that this is one tooth, 0 to 1.
        confidence: f64,
    }
}

data! {
    /// How long the stages of a click took.
    ClickTimes: ts_click_times {
        /// Click to groups.
        pick: f64,
        /// Solve; with the default preset a share of `cut` and `label`.
        field: f64,
        /// Contours and selection.
        cut: f64,
        /// Faces, refinement, labels.
        label: f64,
        /// All of it.
        total: f64,
    }
}

data! {
    /// What a click did.
    ClickInfo: ts_click_info {
        /// Tooth clicked.
        target: u32,
        /// Tooth beside it.
        neighbour: Option<u32>,
        /// The surface point taken.
        position: [f64; 3],
        /// Along the surface to the closest point of the target.
        target_distance: f64,
        /// Along the surface to the closest point of the neighbour.
        neighbour_distance: f64,
        /// Centre of the fullest bin of the field's histogram.
        v_med: f64,
        /// Iso-value chosen for the target.
        target_iso: f64,
        /// Iso-value chosen for the neighbour.
        neighbour_iso: Option<f64>,
        /// How long it took.
        ms: ClickTimes,
    }
}

impl FromRaw<u32> for Option<ChosenFor> {
    fn from_raw(raw: u32) -> Self {
        match raw {
            1 => Some(ChosenFor::Target),
            2 => Some(ChosenFor::Neighbour),
            _ => None,
        }
    }
}

/// Whose cut a contour is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChosenFor {
    /// Of the tooth clicked.
    Target,
    /// Of the tooth beside it.
    Neighbour,
}

data! {
    /// One iso-value's contour of a click's field.
    ContourInfo: ts_contour_info {
        /// Iso-value.
        iso: f64,
        /// Mean of the field's gradient along it, 1/mm.
        gradient: f64,
        /// Share of it in concave valleys, 0 to 1.
        concavity: f64,
        /// Of all its polylines.
        length: f64,
        /// In all its polylines.
        points: u32,
        /// Number of polylines.
        polylines: u32,
        /// Whose cut it is.
        chosen: Option<ChosenFor>,
    }
}

data! {
    /// A point of a contour or cut: on the edge from model vertex `a` to `b`, at (1 - t) a + t b.
    EdgePoint: ts_edge_point {
        /// Model vertex.
        a: u32,
        /// Model vertex.
        b: u32,
        /// 0 at `a`, 1 at `b`.
        t: f64,
        /// Where it is.
        position: [f64; 3],
    }
}

data! {
    /// A separated tooth.
    ToothInfo: ts_tooth_info {
        /// Id of its feature group, or of the group that a click made.
        id: u32,
        /// What the labels of its faces are; not an FDI number.
        label: u32,
        /// The click that separated it last.
        click: u32,
        /// Number of model faces.
        faces: u32,
        /// Number of model vertices of these.
        vertices: u32,
        /// Closed polylines of its cut.
        loops: u32,
        /// Constraint points used.
        seeds: u32,
        /// Of its faces.
        area: f64,
        /// Iso-value of the cut.
        iso: f64,
        /// Mean of the field's gradient along the cut, 1/mm.
        gradient: f64,
        /// 0 to 1.
        confidence: f64,
        /// What looks wrong about it.
        warnings: ToothWarnings,
    }
}

data! {
    /// How long the preparation took.
    PrepareTimes: ts_prepare_times {
        /// Of the model.
        intake: f64,
        /// Of the detection; 0 if set by hand.
        features: f64,
        /// Curvature, concavity, weights.
        weights: f64,
        /// Of the linear system.
        factorise: f64,
    }
}

data! {
    /// Bytes that are kept.
    MemoryInfo: ts_memory_info {
        /// Of the model, which segmentations share.
        model: u64,
        /// Of what a segmentation keeps beside it.
        segmentation: u64,
        /// Of the factor, as far as it is kept.
        factor: u64,
        /// Of the factor if all of it were.
        factor_whole: u64,
        /// Of the work space of one tooth.
        click: u64,
    }
}

data! {
    /// A tooth that wants a look.
    ReviewItem: ts_review_item {
        /// Id of its group.
        tooth: u32,
        /// false: no cut has been made for this group so far.
        separated: bool,
        /// What looks wrong about it.
        warnings: ToothWarnings,
        /// Of the tooth, 0 to 1; 0 where it is not separated.
        confidence: f64,
        /// That the group is exactly one tooth.
        group_confidence: f64,
    }
}

data! {
    /// Faces that two teeth hold.
    Overlap: ts_overlap {
        /// The tooth that labels give them to.
        winner: u32,
        /// The other one.
        loser: u32,
        /// Number of model faces.
        faces: u32,
        /// Of these.
        area: f64,
    }
}

data! {
    /// What can be undone.
    HistoryInfo: ts_history_info {
        /// Steps that can be taken back.
        undo: u32,
        /// Steps that can be brought again.
        redo: u32,
        /// Back to the beginning; false: the limit has dropped the oldest.
        complete: bool,
        /// About what the steps keep.
        bytes: u64,
        /// What they may keep.
        limit: u64,
    }
}

data! {
    /// The number of a tooth.
    NumberInfo: ts_number_info {
        /// The most probable FDI number, also where it is uncertain.
        fdi: u32,
        /// Set by hand.
        set_by_hand: bool,
        /// To be shown to a person before it is used.
        uncertain: bool,
        /// Probability of this number.
        confidence: f64,
    }
}

data! {
    /// The jaw that the numbers are of.
    JawInfo: ts_jaw_info {
        /// The more probable, also where it is uncertain.
        jaw: Jaw,
        /// By the options or by a number set by hand.
        given: bool,
        /// Confidence under the least.
        uncertain: bool,
        /// 0.5 where nothing tells; 1 if given.
        confidence: f64,
    }
}

data! {
    /// A number as Palmer's notation has it.
    Palmer: ts_palmer {
        /// 1 upper right, 2 upper left, 3 lower left, 4 lower right.
        quadrant: u32,
        /// 1 (central incisor) to 8.
        position: u32,
        /// Such as "UR6".
        letters: String,
        /// The position in the angle of its quadrant.
        symbol: String,
    }
}

data! {
    /// An edit of a cut that is kept.
    CutEdit: ts_cut_edit {
        /// What was done.
        kind: EditKind,
        /// [`Status::OK`]: it shows in the cut; else why it was dropped when the tooth was last separated again.
        status: Status,
        /// 2 of a drag, those of a stroke, 0 of the others.
        points: u32,
        /// Reach, mm or strength as given; 0 of a stroke.
        amount: f64,
        /// Of a drag where the cut was taken, of a stroke its first point.
        from: [f64; 3],
        /// Of a drag where it was taken to, of a stroke its last point.
        to: [f64; 3],
    }
}

data! {
    /// What a mesh of a tooth or of the gingiva holds.
    MeshInfo: ts_mesh_info {
        /// Label of the tooth, 0 of the gingiva.
        label: u32,
        /// Number of vertices.
        vertices: u32,
        /// Number of triangles.
        triangles: u32,
        /// Of these, at the end: those that close it.
        fill_triangles: u32,
        /// That it shares with other parts.
        cut_vertices: u32,
        /// 0: watertight.
        open_rims: u32,
        /// Rims that were closed.
        closed_rims: u32,
        /// Connected pieces.
        components: u32,
        /// Triangles left out at its rims.
        trimmed: u32,
        /// Of all triangles.
        area: f64,
        /// Of those that close it.
        fill_area: f64,
        /// mm^3; 0 while a rim is open.
        volume: f64,
        /// Of a tooth: what its cuts enclose and another part has.
        lost: f64,
    }
}

data! {
    /// Which way a tooth looks, and its extent that way.
    ToothFrame: ts_tooth_frame {
        /// Mesial is along the arch curve; false: there is none, and mesial is where the tooth is widest.
        from_arch: bool,
        /// Of the area of its faces.
        centre: [f64; 3],
        /// Unit vector: that of the features.
        occlusal: [f64; 3],
        /// Unit vector along the arch, towards its middle.
        mesial: [f64; 3],
        /// Unit vector at right angles to both, out of the arch.
        buccal: [f64; 3],
        /// Mesial-distal extent.
        width: f64,
        /// Buccal-lingual extent.
        depth: f64,
        /// Occlusal-gingival extent of what the scan shows of the crown.
        height: f64,
    }
}

data! {
    /// A closed polyline of a cut.
    CutInfo: ts_cut_info {
        /// Number of points.
        points: u32,
        /// The last point is joined to the first.
        closed: bool,
        /// Of the polyline.
        length: f64,
        /// Iso-value it was chosen at.
        iso: f64,
        /// Mean of the field's gradient along it, 1/mm.
        gradient: f64,
        /// Share of it in concave valleys, 0 to 1.
        concavity: f64,
    }
}
