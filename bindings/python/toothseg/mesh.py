# SPDX-License-Identifier: Apache-2.0
"""Teeth and gingiva as meshes of their own."""
from __future__ import annotations

from ctypes import c_double, c_uint8, c_uint32
from typing import Self, SupportsIndex

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import OutputFormat
from ._core import Owner, PathLike, Resource, check, elements, handle_of, hooks_of, info, make, path, struct_of, u32
from ._library import lib
from .context import Job
from .options import ToothMeshOptions
from .records import MeshInfo
from .segmentation import Segmentation


class Mesh(Resource):
    """A tooth, or the gingiva, cut exactly along the cuts of the teeth. Made by tooth() and gingiva(); never changes."""

    def __init__(self, owner: Owner) -> None:
        self._owner = owner

    @classmethod
    def tooth(cls, segmentation: Segmentation, tooth: SupportsIndex, options: ToothMeshOptions | None = None, *,
              job: Job | None = None) -> Self:
        return cls(make(_abi.ts_mesh, lambda out: lib.ts_tooth_mesh_create(
            segmentation.handle, u32(tooth), struct_of(options), handle_of(job), out), job, hooks_of(segmentation)))

    @classmethod
    def gingiva(cls, segmentation: Segmentation, options: ToothMeshOptions | None = None, *, job: Job | None = None) -> Self:
        """What belongs to no tooth separated so far."""
        return cls(make(_abi.ts_mesh, lambda out: lib.ts_gingiva_mesh_create(
            segmentation.handle, struct_of(options), handle_of(job), out), job, hooks_of(segmentation)))

    def info(self) -> MeshInfo:
        return MeshInfo._of(info(_abi.ts_mesh_info, lambda out: lib.ts_mesh_get_info(self.handle, out)))

    def positions(self) -> npt.NDArray[np.float64]:
        """n x 3, mm."""
        return elements(lambda *a: lib.ts_mesh_get_positions(self.handle, *a), c_double, 3)

    def normals(self) -> npt.NDArray[np.float64]:
        """n x 3, outwards."""
        return elements(lambda *a: lib.ts_mesh_get_normals(self.handle, *a), c_double, 3)

    def triangles(self) -> npt.NDArray[np.uint32]:
        """m x 3 vertices, counter-clockwise seen from outside."""
        return elements(lambda *a: lib.ts_mesh_get_triangles(self.handle, *a), c_uint32, 3)

    def faces(self) -> npt.NDArray[np.uint32]:
        """For each triangle the model face that it is of, NONE for those that close the mesh."""
        return elements(lambda *a: lib.ts_mesh_get_faces(self.handle, *a), c_uint32)

    def vertex_flags(self) -> npt.NDArray[np.uint8]:
        """For each vertex a sum of MeshVertexFlag."""
        return elements(lambda *a: lib.ts_mesh_get_vertex_flags(self.handle, *a), c_uint8)

    def save(self, file: PathLike, format: OutputFormat, *, job: Job | None = None) -> None:
        check(lib.ts_mesh_save(self.handle, path(file), format, handle_of(job)), job)
