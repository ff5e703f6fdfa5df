# SPDX-License-Identifier: Apache-2.0
"""What the library tells, as frozen dataclasses. Fields are named as in toothseg.h, which says what they are; an index that
may be "none" there is None here, and 0 or 1 for no or yes a bool."""
from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, Self, get_type_hints

from ._abi import NONE, EditKind, FeaturesWarning, Jaw, Status, ToothWarning
from ._core import Array, Point


def _reader(hint: Any) -> Callable[[Any], Any]:
    """How a field of a C struct becomes one with this type."""
    if hint == Point:
        return tuple
    if hint == int | None:
        return lambda value: None if value == NONE else value
    if hint is str:
        return bytes.decode
    if issubclass(hint, Record):
        return hint._of  # type: ignore[no-any-return]
    return hint  # type: ignore[no-any-return]


@functools.cache
def _readers(record: Any) -> list[tuple[str, Callable[[Any], Any]]]:
    hints = get_type_hints(record)
    return [(f.name.rstrip("_"), _reader(hints[f.name])) for f in fields(record)]  # from_ is `from` in C


class Record:
    @classmethod
    def _of(cls, struct: Any) -> Self:
        return cls(*(read(getattr(struct, name)) for name, read in _readers(cls)))  # type: ignore[arg-type]


@dataclass(frozen=True)
class IntakeReport(Record):
    """What intake found and repaired: ts_intake_report."""

    input_vertices: int
    input_faces: int
    polygons: int
    welded_vertices: int
    unreferenced_vertices: int
    degenerate_faces: int
    duplicate_faces: int
    flipped_faces: int
    non_manifold_edges: int
    non_manifold_vertices: int
    unorientable_edges: int
    vertices: int
    faces: int
    components: int
    boundary_loops: int
    diagonal: float
    area: float
    mean_edge: float


@dataclass(frozen=True)
class SurfacePoint(Record):
    """A point on the surface: ts_surface_point."""

    face: int
    nearest_vertex: int
    barycentric: Point
    position: Point
    distance: float


@dataclass(frozen=True)
class FeaturesInfo(Record):
    """Counts, and what the detection saw: ts_features_info."""

    groups: int
    points: int
    inside_out: bool
    warnings: FeaturesWarning
    opposed: float
    coverage: float
    arch_length: float


@dataclass(frozen=True)
class FeaturePoint(Record):
    """A cusp or a corner of an incisal edge: ts_feature_point."""

    id: int
    group: int
    vertex: int
    by_hand: bool
    position: Point
    convexity: float


@dataclass(frozen=True)
class FeatureGroup(Record):
    """The feature points of a tooth: ts_feature_group."""

    id: int
    points: int
    previous: int | None
    next: int | None
    centre: Point
    arch_from: float
    arch_to: float
    confidence: float


@dataclass(frozen=True)
class ClickTimes(Record):
    """Milliseconds a stage took: ts_click_times."""

    pick: float
    field: float
    cut: float
    label: float
    total: float


@dataclass(frozen=True)
class ClickInfo(Record):
    """What came of a click: ts_click_info."""

    target: int
    neighbour: int | None
    position: Point
    target_distance: float
    neighbour_distance: float
    v_med: float
    target_iso: float
    neighbour_iso: float
    ms: ClickTimes


@dataclass(frozen=True)
class ContourInfo(Record):
    """One iso-value's contour: ts_contour_info."""

    iso: float
    gradient: float
    concavity: float
    length: float
    points: int
    polylines: int
    chosen: int


@dataclass(frozen=True)
class ToothInfo(Record):
    """A separated tooth: ts_tooth_info."""

    id: int
    label: int
    click: int
    faces: int
    vertices: int
    loops: int
    seeds: int
    area: float
    iso: float
    gradient: float
    confidence: float
    warnings: ToothWarning


@dataclass(frozen=True)
class CutInfo(Record):
    """A loop of a tooth's cut: ts_cut_info."""

    points: int
    closed: bool
    length: float
    iso: float
    gradient: float
    concavity: float


@dataclass(frozen=True)
class PrepareTimes(Record):
    """Milliseconds of the preparation: ts_prepare_times."""

    intake: float
    features: float
    weights: float
    factorise: float


@dataclass(frozen=True)
class MemoryInfo(Record):
    """Bytes that are kept: ts_memory_info."""

    model: int
    segmentation: int
    factor: int
    factor_whole: int
    click: int


@dataclass(frozen=True)
class ReviewItem(Record):
    """A tooth that wants a look: ts_review_item."""

    tooth: int
    separated: bool
    warnings: ToothWarning
    confidence: float
    group_confidence: float


@dataclass(frozen=True)
class Overlap(Record):
    """Faces that two teeth hold: ts_overlap."""

    winner: int
    loser: int
    faces: int
    area: float


@dataclass(frozen=True)
class HistoryInfo(Record):
    """The steps that are kept: ts_history_info."""

    undo: int
    redo: int
    complete: bool
    bytes: int
    limit: int


@dataclass(frozen=True)
class NumberInfo(Record):
    """The number of a tooth: ts_number_info."""

    fdi: int
    set_by_hand: bool
    uncertain: bool
    confidence: float


@dataclass(frozen=True)
class JawInfo(Record):
    """The jaw that the numbers are of: ts_jaw_info."""

    jaw: Jaw
    given: bool
    uncertain: bool
    confidence: float


@dataclass(frozen=True)
class Palmer(Record):
    """A number as Palmer's notation has it: ts_palmer."""

    quadrant: int
    position: int
    letters: str
    symbol: str


@dataclass(frozen=True)
class CutEdit(Record):
    """An edit of a cut that is kept: ts_cut_edit."""

    kind: EditKind
    status: Status
    points: int
    amount: float
    from_: Point
    to: Point


@dataclass(frozen=True)
class MeshInfo(Record):
    """The mesh of a tooth, or of the gingiva: ts_mesh_info."""

    label: int
    vertices: int
    triangles: int
    fill_triangles: int
    cut_vertices: int
    open_rims: int
    closed_rims: int
    components: int
    trimmed: int
    area: float
    fill_area: float
    volume: float
    lost: float


@dataclass(frozen=True)
class ToothFrame(Record):
    """Which way a tooth looks, and its extent that way: ts_tooth_frame."""

    from_arch: bool
    centre: Point
    occlusal: Point
    mesial: Point
    buccal: Point
    width: float
    depth: float
    height: float


@dataclass(frozen=True, eq=False)
class Polyline:
    """A line on edges of the mesh. `points` is a structured array: a, b (model vertices of the edge), t (how far from a to
    b), position (mm); points["position"] are n x 3 coordinates, without a copy."""

    points: Array
    closed: bool

    @property
    def positions(self) -> Array:
        return self.points["position"]


@dataclass(frozen=True, eq=False)
class Cut(Polyline):
    """A loop of a tooth's cut."""

    info: CutInfo
