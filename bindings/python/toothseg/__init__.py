# SPDX-License-Identifier: Apache-2.0
"""Separates the teeth of a scanned dental arch.

    with toothseg.Context() as context, toothseg.Model.load(context, "scan.stl") as model, \\
         toothseg.Features.detect(model) as features, toothseg.Segmentation(features) as segmentation:
        segmentation.segment_all()
        labels = segmentation.labels()

Lengths are mm, arrays NumPy's, indices count from 0. What is said of a function in toothseg.h holds for its method here.
"""
from ._abi import (NONE, Background, CutRule, EditKind, FeaturesWarning, FileFormat, Jaw, LogLevel, MeshVertexFlag, OutputFormat,
                   Preset, Status, ToothWarning, Unit, Weights)
from ._library import lib as _lib
from .context import Context, Job
from .errors import (Cancelled, EditError, Error, FeaturesError, FileError, MeshError, NumberError, OutOfMemory,
                     SegmentationError, SurroundingsError, ToothMeshError, UsageError)
from .mesh import Mesh
from .notation import fdi_to_palmer, fdi_to_universal, universal_to_fdi
from .options import FeatureOptions, IntakeOptions, NumberOptions, SaveOptions, SegmentOptions, ToothMeshOptions
from .records import (ClickInfo, ClickTimes, ContourInfo, Cut, CutEdit, CutInfo, FeatureGroup, FeaturePoint, FeaturesInfo,
                      HistoryInfo, IntakeReport, JawInfo, MemoryInfo, MeshInfo, NumberInfo, Overlap, Palmer, Polyline,
                      PrepareTimes, ReviewItem, SurfacePoint, ToothFrame, ToothInfo)
from .scan import Features, Model
from .segmentation import Segmentation, Session

#: of the library that is loaded
__version__: str = _lib.ts_version().decode()

__all__ = [
    "Background", "Cancelled", "ClickInfo", "ClickTimes", "Context", "ContourInfo", "Cut", "CutEdit", "CutInfo",
    "CutRule", "EditError", "EditKind", "Error", "FeatureGroup", "FeatureOptions", "FeaturePoint", "Features",
    "FeaturesError", "FeaturesInfo", "FeaturesWarning", "FileError", "FileFormat", "HistoryInfo", "IntakeOptions",
    "IntakeReport", "Jaw", "JawInfo", "Job", "LogLevel", "MemoryInfo", "Mesh", "MeshError", "MeshInfo",
    "MeshVertexFlag", "Model", "NONE", "NumberError", "NumberInfo", "NumberOptions", "OutOfMemory", "OutputFormat",
    "Overlap", "Palmer", "Polyline", "PrepareTimes", "Preset", "ReviewItem", "SaveOptions", "SegmentOptions",
    "Segmentation", "SegmentationError", "Session", "Status", "SurfacePoint", "SurroundingsError", "ToothFrame",
    "ToothInfo", "ToothMeshError", "ToothMeshOptions", "ToothWarning", "Unit", "UsageError", "Weights", "fdi_to_palmer",
    "fdi_to_universal", "universal_to_fdi", "__version__",
]
