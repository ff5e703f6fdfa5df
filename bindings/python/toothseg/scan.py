# SPDX-License-Identifier: Apache-2.0
"""The scan and its feature points."""
from __future__ import annotations

from ctypes import POINTER, byref, c_double, c_uint32, cast, sizeof
from typing import Any, Self, SupportsIndex

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import NONE, FileFormat, Scalar
from ._core import (Array, Owner, PathLike, Point, PointLike, Resource, check, elements, handle_of, hooks_of, info, make, path,
                    point, struct_of, structs, u32)
from ._library import lib
from .context import Context, Job
from .options import FeatureOptions, IntakeOptions
from .records import FeatureGroup, FeaturePoint, FeaturesInfo, IntakeReport, SurfacePoint


def _coordinates(positions: npt.ArrayLike) -> Array:
    """n x 3 floats or doubles, rows at any distance: as given where that will do, else a copy."""
    array = np.asarray(positions)
    if array.shape == (0,):
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError("positions have to be n x 3")
    if array.dtype not in (np.float32, np.float64):
        array = array.astype(np.float64)
    row, column = array.strides
    if column != array.itemsize or not 3 * array.itemsize <= row <= NONE or not array.flags.aligned:
        array = np.ascontiguousarray(array)
    return array


def _indices(triangles: npt.ArrayLike) -> Array:
    """m x 3 uint32: as given, int32 looked at anew, or a copy of what fits."""
    array = np.asarray(triangles)
    if array.shape == (0,):
        array = np.empty((0, 3), np.uint32)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "iu":
        raise ValueError("triangles have to be m x 3 whole numbers")
    if array.dtype == np.int32:
        array = array.view(np.uint32)  # a negative one is then out of range, which the library says
    elif array.dtype != np.uint32:
        if array.size and not (array.min() >= 0 and array.max() <= NONE):
            raise ValueError("triangles have to be within 0 and 2^32 - 1")
        array = array.astype(np.uint32)
    return np.ascontiguousarray(array)


def _mesh_input(xyz: Array, triangles: Array | None) -> Any:
    """The struct; the arrays have to live until the model is made."""
    struct = _abi.ts_mesh_input()
    check(lib.ts_mesh_input_init(byref(struct), sizeof(struct)))
    struct.scalar = Scalar.FLOAT32 if xyz.dtype == np.float32 else Scalar.FLOAT64
    struct.positions = xyz.ctypes.data
    struct.vertex_count = u32(len(xyz))
    struct.stride = xyz.strides[0] if len(xyz) else 0
    if triangles is not None:
        struct.triangles = cast(triangles.ctypes.data, POINTER(c_uint32))
        struct.triangle_count = u32(len(triangles))
    return struct


class Model(Resource):
    """A mesh after intake: welded, clean, manifold, consistently wound. Never changes.

    From `positions` (n x 3 floats or doubles) and `triangles` (m x 3 indices; None: every three positions are a face).
    Floats, doubles and 32-bit indices are read where they are, also from rows with more in them than x, y, z.
    """

    def __init__(self, context: Context, positions: npt.ArrayLike, triangles: npt.ArrayLike | None = None,
                 options: IntakeOptions | None = None, *, job: Job | None = None) -> None:
        xyz = _coordinates(positions)
        indices = None if triangles is None else _indices(triangles)
        mesh = _mesh_input(xyz, indices)
        self._owner = make(_abi.ts_model, lambda out: lib.ts_model_create(
            context.handle, byref(mesh), struct_of(options), handle_of(job), out), job, hooks_of(context))

    @classmethod
    def _made(cls, owner: Owner) -> Self:
        model = cls.__new__(cls)
        model._owner = owner
        return model

    @classmethod
    def load(cls, context: Context, file: PathLike, options: IntakeOptions | None = None, *, job: Job | None = None) -> Self:
        """From an STL, PLY, OBJ or OFF file."""
        return cls._made(make(_abi.ts_model, lambda out: lib.ts_model_load(
            context.handle, path(file), struct_of(options), handle_of(job), out), job, hooks_of(context)))

    @classmethod
    def read(cls, context: Context, data: bytes | bytearray | memoryview | Array, format: FileFormat = FileFormat.AUTO,
             options: IntakeOptions | None = None, *, job: Job | None = None) -> Self:
        """From a file that is in memory already: anything with contiguous bytes, read where it is."""
        view = np.frombuffer(data, np.uint8)
        return cls._made(make(_abi.ts_model, lambda out: lib.ts_model_read(
            context.handle, view.ctypes.data, len(view), format, struct_of(options), handle_of(job), out), job,
            hooks_of(context)))

    def report(self) -> IntakeReport:
        return IntakeReport._of(info(_abi.ts_intake_report, lambda out: lib.ts_model_get_report(self.handle, out)))

    def positions(self) -> npt.NDArray[np.float64]:
        """n x 3, mm."""
        return elements(lambda *a: lib.ts_model_get_positions(self.handle, *a), c_double, 3)

    def triangles(self) -> npt.NDArray[np.uint32]:
        """m x 3 vertices."""
        return elements(lambda *a: lib.ts_model_get_triangles(self.handle, *a), c_uint32, 3)

    def face_sources(self) -> npt.NDArray[np.uint32]:
        """For each face the caller's face that it came from."""
        return elements(lambda *a: lib.ts_model_get_face_sources(self.handle, *a), c_uint32)

    def vertex_map(self) -> npt.NDArray[np.uint32]:
        """For each of the caller's vertices the model's, NONE if it was dropped."""
        return elements(lambda *a: lib.ts_model_get_vertex_map(self.handle, *a), c_uint32)

    def nearest(self, position: PointLike) -> SurfacePoint:
        out = _abi.ts_surface_point()
        check(lib.ts_model_nearest(self.handle, point(position), byref(out)))
        return SurfacePoint._of(out)

    def raycast(self, origin: PointLike, direction: PointLike) -> SurfacePoint:
        """The first point hit. UsageError (NOT_FOUND) where the ray misses."""
        out = _abi.ts_surface_point()
        check(lib.ts_model_raycast(self.handle, point(origin), point(direction), byref(out)))
        return SurfacePoint._of(out)


class Features(Resource):
    """Feature points of the teeth in groups, one a tooth. Features(model) is an empty set, to be filled by hand."""

    def __init__(self, model: Model) -> None:
        self._owner = make(_abi.ts_features, lambda out: lib.ts_features_create(model.handle, out), hooks=hooks_of(model))

    @classmethod
    def _made(cls, owner: Owner) -> Self:
        features = cls.__new__(cls)
        features._owner = owner
        return features

    @classmethod
    def detect(cls, model: Model, options: FeatureOptions | None = None, *, job: Job | None = None) -> Self:
        return cls._made(make(_abi.ts_features, lambda out: lib.ts_detect_features(
            model.handle, struct_of(options), handle_of(job), out), job, hooks_of(model)))

    def clone(self) -> Self:
        return self._made(make(_abi.ts_features, lambda out: lib.ts_features_clone(self.handle, out), hooks=hooks_of(self)))

    def info(self) -> FeaturesInfo:
        return FeaturesInfo._of(info(_abi.ts_features_info, lambda out: lib.ts_features_get_info(self.handle, out)))

    @property
    def occlusal(self) -> Point:
        """The unit vector from the gums to the biting surface."""
        out = (c_double * 3)()
        check(lib.ts_features_get_occlusal(self.handle, out))
        return tuple(out)  # type: ignore[return-value]

    @occlusal.setter
    def occlusal(self, direction: PointLike) -> None:
        check(lib.ts_features_set_occlusal(self.handle, point(direction)))

    def arch(self) -> npt.NDArray[np.float64]:
        """The arch curve, n x 3."""
        return elements(lambda *a: lib.ts_features_get_arch(self.handle, *a), c_double, 3)

    def points(self) -> list[FeaturePoint]:
        """In the order of their groups."""
        return [FeaturePoint._of(p) for p in structs(
            lambda *a: lib.ts_features_get_points(self.handle, *a), _abi.ts_feature_point)]

    def groups(self) -> list[FeatureGroup]:
        """In the order of the arch."""
        return [FeatureGroup._of(g) for g in structs(
            lambda *a: lib.ts_features_get_groups(self.handle, *a), _abi.ts_feature_group)]

    def add_point(self, position: PointLike, group: SupportsIndex | None = None) -> tuple[int, int]:
        """Adds a point to a group, or to a new one. The ids of the point and of its group."""
        added, into = c_uint32(), c_uint32()
        check(lib.ts_features_add_point(self.handle, point(position), _group(group), byref(added), byref(into)))
        return added.value, into.value

    def move_point(self, point_id: SupportsIndex, position: PointLike) -> None:
        check(lib.ts_features_move_point(self.handle, u32(point_id), point(position)))

    def set_group(self, point_id: SupportsIndex, group: SupportsIndex | None = None) -> int:
        """Puts a point into another group, or into a new one. The id of that group."""
        into = c_uint32()
        check(lib.ts_features_set_group(self.handle, u32(point_id), _group(group), byref(into)))
        return into.value

    def remove_point(self, point_id: SupportsIndex) -> None:
        check(lib.ts_features_remove_point(self.handle, u32(point_id)))

    def remove_group(self, group: SupportsIndex) -> None:
        check(lib.ts_features_remove_group(self.handle, u32(group)))


def _group(group: SupportsIndex | None) -> int:
    return NONE if group is None else u32(group)
