# SPDX-License-Identifier: Apache-2.0
"""Options. Each begins with the library's defaults; what the settings mean is said in toothseg.h."""
from __future__ import annotations

from ctypes import byref, sizeof
from typing import Any

from . import _abi
from ._abi import Background, CutRule, Jaw, Preset, Unit, Weights
from ._core import Options, Point, Setting, check
from ._library import lib


def _point(value: Any) -> Point:
    x, y, z = value
    return x, y, z


class IntakeOptions(Options):
    """How a mesh is taken in: ts_intake_options."""

    _ctype = _abi.ts_intake_options
    unit = Setting(Unit)
    weld_tolerance = Setting(float)


class FeatureOptions(Options):
    """How feature points are found: ts_feature_options."""

    _ctype = _abi.ts_feature_options
    max_points = Setting(int)
    occlusal = Setting(_point)
    radius = Setting(float)


class SegmentOptions(Options):
    """How teeth are separated: ts_segment_options. The preset says what the other settings begin with."""

    _ctype = _abi.ts_segment_options
    weights = Setting(Weights)
    background = Setting(Background)
    cut_rule = Setting(CutRule)
    contours = Setting(int)
    histogram_bins = Setting(int)
    points_per_group = Setting(int)
    alpha = Setting(float)
    beta = Setting(float)
    gamma = Setting(float)
    theta = Setting(float)
    c0 = Setting(float)
    normal_radius = Setting(float)
    seed_radius = Setting(float)
    gingiva_distance = Setting(float)
    area_min = Setting(float)
    area_max = Setting(float)
    hole_area = Setting(float)
    refine_band = Setting(float)
    smooth_radius = Setting(float)
    click_reach = Setting(float)
    click_concavity = Setting(float)
    reject_outliers = Setting(bool)
    memory_limit = Setting(int)

    def __init__(self, preset: Preset = Preset.DEFAULT, **settings: Any) -> None:
        self._preset = preset
        super().__init__(**settings)

    def _initialise(self) -> None:
        check(lib.ts_segment_options_init(byref(self._struct), sizeof(self._struct), self._preset))

    @property
    def preset(self) -> Preset:
        """What the options began as."""
        return Preset(self._struct.preset)


class NumberOptions(Options):
    """How teeth are numbered: ts_number_options."""

    _ctype = _abi.ts_number_options
    jaw = Setting(Jaw)
    mirrored = Setting(bool)
    least_confidence = Setting(float)


class ToothMeshOptions(Options):
    """How the mesh of a tooth is made: ts_tooth_mesh_options."""

    _ctype = _abi.ts_tooth_mesh_options
    closed = Setting(bool)


class SaveOptions(Options):
    """How a whole scan is written: ts_save_options."""

    _ctype = _abi.ts_save_options
    whole_faces = Setting(bool)
