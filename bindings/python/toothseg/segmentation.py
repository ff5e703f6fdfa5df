# SPDX-License-Identifier: Apache-2.0
"""Teeth: separated, corrected, numbered, written; and the session that all of it is."""
from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from ctypes import POINTER, byref, c_char, c_double, c_int32, c_uint8, c_uint32
from typing import Any, NamedTuple, Self, SupportsIndex

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import OutputFormat, Status
from ._core import (Owner, PathLike, PointLike, Resource, address, check, elements, handle_of, hooks_of, info,
                    make, path, point, points, raise_thrown, struct_of, structs, u32)
from ._library import lib
from .context import Job
from .options import NumberOptions, SaveOptions, SegmentOptions
from .records import (ClickInfo, ContourInfo, Cut, CutEdit, CutInfo, HistoryInfo, JawInfo, MemoryInfo, NumberInfo, Overlap,
                      Polyline, PrepareTimes, ReviewItem, ToothFrame, ToothInfo)
from .scan import Features, Model

#: gets the ids of the teeth that a call changed
ChangeHook = Callable[[list[int]], object]


class _Listener:
    """What the change callback does, apart from the Segmentation so that the library's pointer to it makes no cycle."""

    def __init__(self, hook: ChangeHook) -> None:
        self.hook = hook
        self.telling: int | None = None  # the thread that is in the hook
        self.thrown: BaseException | None = None

    def __call__(self, user: object, teeth: Any, count: int) -> None:
        self.telling = threading.get_ident()
        try:
            self.hook(teeth[:count])
        except BaseException as e:
            self.thrown = e
        finally:
            self.telling = None


class Segmentation(Resource):
    """A prepared scan and the teeth separated so far. Each call that changes something is a step that undo() takes back; one
    that fails changes nothing. Teeth and feature groups share their ids."""

    _listener: _Listener | None = None

    def __init__(self, features: Features, options: SegmentOptions | None = None, *, job: Job | None = None) -> None:
        self._owner = make(_abi.ts_segmentation, lambda out: lib.ts_segmentation_create(
            features.handle, struct_of(options), handle_of(job), out), job, hooks_of(features))

    @classmethod
    def _made(cls, owner: Owner) -> Self:
        segmentation = cls.__new__(cls)
        segmentation._owner = owner
        return segmentation

    # ------------------------------------------------------------------------------------------------ what changes it

    @property
    def _own(self) -> Owner:
        """The handle, for a call that needs it to itself."""
        self._refuse_while_telling()
        return self.handle

    def _refuse_while_telling(self) -> None:
        if self._listener is not None and self._listener.telling == threading.get_ident():
            raise RuntimeError("a change callback may read the segmentation, and must not change or close it")

    def _changed(self, status: int, job: Job | None = None) -> None:
        """What came of a call that may have changed something: what the change callback raised comes out of it."""
        thrown = None
        if self._listener is not None:
            thrown, self._listener.thrown = self._listener.thrown, None
        check(status, job)
        try:
            raise_thrown(thrown)
        finally:
            del thrown

    def close(self) -> None:
        self._refuse_while_telling()
        super().close()

    def on_change(self, hook: ChangeHook | None) -> None:
        """`hook` is called with the ids of the teeth that a call changed, on the thread of that call, before it returns; it may
        read the segmentation, and not change it. None: nobody is told."""
        owner = self._own
        listener = None if hook is None else _Listener(hook)
        function = _abi.ts_change_fn(listener) if listener else _abi.ts_change_fn(0)
        check(lib.ts_set_change_callback(owner, function, None))
        self._listener, owner.callback = listener, function

    def click(self, position: PointLike, *, job: Job | None = None) -> int:
        """Separates the tooth under `position` and its neighbour. The number of the click."""
        number = c_uint32()
        self._changed(lib.ts_segment_click(self._own, point(position), handle_of(job), byref(number)), job)
        return number.value

    def clicks(self, positions: PointLike | Sequence[PointLike], *, job: Job | None = None) -> list[Status]:
        """Several at once. A status a click: one that fails leaves no trace, and the others stand."""
        xyz = points(positions)
        statuses = (c_int32 * len(xyz))()
        own = self._own
        if len(xyz):
            self._changed(lib.ts_segment_clicks(own, address(xyz, c_double), u32(len(xyz)), handle_of(job), statuses), job)
        return [Status(s) for s in statuses]

    def segment_all(self, *, job: Job | None = None) -> None:
        """Every tooth without a click; review() tells which want a look."""
        self._changed(lib.ts_segment_all(self._own, handle_of(job)), job)

    def include(self, tooth: SupportsIndex, position: PointLike, *, job: Job | None = None) -> None:
        """This too."""
        self._changed(lib.ts_tooth_include(self._own, u32(tooth), point(position), handle_of(job)), job)

    def exclude(self, tooth: SupportsIndex, position: PointLike, *, job: Job | None = None) -> None:
        """Not this."""
        self._changed(lib.ts_tooth_exclude(self._own, u32(tooth), point(position), handle_of(job)), job)

    def split(self, tooth: SupportsIndex, keep: PointLike, part: PointLike, *, job: Job | None = None) -> int:
        """Two teeth of one. The id of the new one."""
        second = c_uint32()
        self._changed(lib.ts_tooth_split(self._own, u32(tooth), point(keep), point(part), handle_of(job), byref(second)), job)
        return second.value

    def move_point(self, tooth: SupportsIndex, start: PointLike, to: PointLike, *, job: Job | None = None) -> None:
        """Moves the tooth's feature point that lies at `start`."""
        self._changed(lib.ts_tooth_move_point(self._own, u32(tooth), point(start), point(to), handle_of(job)), job)

    def merge(self, tooth: SupportsIndex, other: SupportsIndex, *, job: Job | None = None) -> None:
        """One tooth of two."""
        self._changed(lib.ts_tooth_merge(self._own, u32(tooth), u32(other), handle_of(job)), job)

    def remove(self, tooth: SupportsIndex) -> None:
        """As if it had not been separated."""
        self._changed(lib.ts_tooth_remove(self._own, u32(tooth)))

    def set_locked(self, tooth: SupportsIndex, locked: bool = True) -> None:
        """Nothing changes a locked tooth."""
        self._changed(lib.ts_tooth_set_locked(self._own, u32(tooth), bool(locked)))

    def drag_cut(self, tooth: SupportsIndex, loop: SupportsIndex, point_index: SupportsIndex, to: PointLike, reach: float = 0,
                 *, job: Job | None = None) -> None:
        """Takes a point of the cut to another place; `reach`, mm, is half the length of the stretch that follows."""
        self._changed(lib.ts_cut_drag(self._own, u32(tooth), u32(loop), u32(point_index), point(to), reach, handle_of(job)),
                      job)

    def draw_cut(self, tooth: SupportsIndex, stroke: PointLike | Sequence[PointLike], *, job: Job | None = None) -> None:
        """Draws a stretch of the cut."""
        xyz = points(stroke)
        self._changed(lib.ts_cut_draw(self._own, u32(tooth), address(xyz, c_double), u32(len(xyz)), handle_of(job)), job)

    def offset_cut(self, tooth: SupportsIndex, mm: float, *, job: Job | None = None) -> None:
        """Moves the whole cut, outwards where positive."""
        self._changed(lib.ts_cut_offset(self._own, u32(tooth), mm, handle_of(job)), job)

    def smooth_cut(self, tooth: SupportsIndex, strength: float, *, job: Job | None = None) -> None:
        self._changed(lib.ts_cut_smooth(self._own, u32(tooth), strength, handle_of(job)), job)

    def reset_cut(self, tooth: SupportsIndex) -> None:
        """The cut of its click again."""
        self._changed(lib.ts_cut_reset(self._own, u32(tooth)))

    def assign_numbers(self, options: NumberOptions | None = None) -> None:
        """FDI numbers for all teeth."""
        self._changed(lib.ts_assign_numbers(self._own, struct_of(options)))

    def set_number(self, tooth: SupportsIndex, fdi: SupportsIndex | None) -> None:
        """By hand; the others follow. None forgets it."""
        self._changed(lib.ts_set_number(self._own, u32(tooth), 0 if fdi is None else u32(fdi)))

    def undo(self) -> None:
        self._changed(lib.ts_undo(self._own))

    def redo(self) -> None:
        self._changed(lib.ts_redo(self._own))

    def set_history_limit(self, size: SupportsIndex) -> None:
        """How many bytes the steps may keep."""
        limit = size.__index__()
        if not 0 <= limit < 2**64:
            raise ValueError(f"{limit} is not within 0 and 2^64 - 1")
        check(lib.ts_set_history_limit(self._own, limit))

    # ---------------------------------------------------------------------------------------------------- what is there

    def propose_clicks(self) -> npt.NDArray[np.float64]:
        """The fewest clicks that cover what is not yet separated, n x 3."""
        return elements(lambda *a: lib.ts_propose_clicks(self.handle, *a), c_double, 3)

    def click_count(self) -> int:
        return self._number(lambda out: lib.ts_get_click_count(self.handle, out))

    def click_info(self, click: SupportsIndex) -> ClickInfo:
        return ClickInfo._of(info(_abi.ts_click_info, lambda out: lib.ts_get_click(self.handle, u32(click), out)))

    def field(self, click: SupportsIndex, out: npt.NDArray[np.float64] | None = None) -> npt.NDArray[np.float64]:
        """The field of a click, a value a model vertex; into `out` where that is given."""
        return elements(lambda *a: lib.ts_get_field(self.handle, u32(click), *a), c_double, out=out)

    def histogram(self, click: SupportsIndex) -> npt.NDArray[np.uint32]:
        return elements(lambda *a: lib.ts_get_histogram(self.handle, u32(click), *a), c_uint32)

    def contours(self, click: SupportsIndex) -> list[ContourInfo]:
        return [ContourInfo._of(c) for c in structs(
            lambda *a: lib.ts_get_contours(self.handle, u32(click), *a), _abi.ts_contour_info)]

    def contour(self, click: SupportsIndex, contour: SupportsIndex) -> list[Polyline]:
        """The polylines of one contour."""
        infos = self.contours(click)
        # One that is not there is the library's to refuse.
        polylines = infos[u32(contour)].polylines if u32(contour) < len(infos) else 0
        starts, closed = (c_uint32 * polylines)(), (c_uint8 * polylines)()
        all_points = elements(lambda *a: lib.ts_get_contour_points(
            self.handle, u32(click), u32(contour), *a, starts, closed), _abi.ts_edge_point)
        ends = [*starts[1:], len(all_points)]
        return [Polyline(all_points[a:b], bool(c)) for a, b, c in zip(starts, ends, closed)]

    def teeth(self) -> list[int]:
        """The ids of the teeth separated so far, along the arch."""
        ids: list[int] = elements(lambda *a: lib.ts_get_teeth(self.handle, *a), c_uint32).tolist()
        return ids

    def tooth(self, tooth: SupportsIndex) -> ToothInfo:
        return ToothInfo._of(info(_abi.ts_tooth_info, lambda out: lib.ts_get_tooth(self.handle, u32(tooth), out)))

    def tooth_faces(self, tooth: SupportsIndex) -> npt.NDArray[np.uint32]:
        """Model faces."""
        return elements(lambda *a: lib.ts_get_tooth_faces(self.handle, u32(tooth), *a), c_uint32)

    def tooth_vertices(self, tooth: SupportsIndex) -> npt.NDArray[np.uint32]:
        """Model vertices."""
        return elements(lambda *a: lib.ts_get_tooth_vertices(self.handle, u32(tooth), *a), c_uint32)

    def tooth_seeds(self, tooth: SupportsIndex) -> npt.NDArray[np.uint32]:
        """Model vertices held as the tooth's constraint."""
        return elements(lambda *a: lib.ts_get_tooth_seeds(self.handle, u32(tooth), *a), c_uint32)

    def tooth_frame(self, tooth: SupportsIndex) -> ToothFrame:
        return ToothFrame._of(info(_abi.ts_tooth_frame, lambda out: lib.ts_get_tooth_frame(self.handle, u32(tooth), out)))

    def cut(self, tooth: SupportsIndex, loop: SupportsIndex = 0) -> Cut:
        """A loop of the cut; 0 is the longest."""
        about = info(_abi.ts_cut_info, lambda out: lib.ts_get_cut(self.handle, u32(tooth), u32(loop), out, None, 0, None))
        line = elements(lambda *a: lib.ts_get_cut(self.handle, u32(tooth), u32(loop), None, *a), _abi.ts_edge_point)
        return Cut(line, bool(about.closed), CutInfo._of(about))

    def cut_edits(self, tooth: SupportsIndex) -> list[CutEdit]:
        return [CutEdit._of(e) for e in structs(
            lambda *a: lib.ts_get_cut_edits(self.handle, u32(tooth), *a), _abi.ts_cut_edit)]

    def labels(self, out: npt.NDArray[np.uint32] | None = None) -> npt.NDArray[np.uint32]:
        """A label for each of the caller's faces, 0 for no tooth; into `out` where that is given."""
        return elements(lambda *a: lib.ts_get_labels(self.handle, *a), c_uint32, out=out)

    def locked(self, tooth: SupportsIndex) -> bool:
        return bool(self._number(lambda out: lib.ts_tooth_get_locked(self.handle, u32(tooth), out)))

    def review(self) -> list[ReviewItem]:
        """The teeth that want a look, those that need it most first."""
        return [ReviewItem._of(i) for i in structs(lambda *a: lib.ts_get_review(self.handle, *a), _abi.ts_review_item)]

    def overlaps(self) -> list[Overlap]:
        return [Overlap._of(o) for o in structs(lambda *a: lib.ts_get_overlaps(self.handle, *a), _abi.ts_overlap)]

    def number(self, tooth: SupportsIndex) -> NumberInfo:
        return NumberInfo._of(info(_abi.ts_number_info, lambda out: lib.ts_get_number(self.handle, u32(tooth), out)))

    def jaw(self) -> JawInfo:
        return JawInfo._of(info(_abi.ts_jaw_info, lambda out: lib.ts_get_jaw(self.handle, out)))

    def changes(self) -> list[int]:
        """The ids of the teeth that the last step, undo or redo changed."""
        ids: list[int] = elements(lambda *a: lib.ts_get_changes(self.handle, *a), c_uint32).tolist()
        return ids

    def history(self) -> HistoryInfo:
        return HistoryInfo._of(info(_abi.ts_history_info, lambda out: lib.ts_get_history(self.handle, out)))

    def prepare_times(self) -> PrepareTimes:
        return PrepareTimes._of(info(_abi.ts_prepare_times, lambda out: lib.ts_get_prepare_times(self.handle, out)))

    def memory(self) -> MemoryInfo:
        return MemoryInfo._of(info(_abi.ts_memory_info, lambda out: lib.ts_get_memory(self.handle, out)))

    def save(self, file: PathLike, format: OutputFormat, options: SaveOptions | None = None, *, job: Job | None = None) -> None:
        """The whole scan with its teeth."""
        check(lib.ts_segmentation_save(self.handle, path(file), format, struct_of(options), handle_of(job)), job)

    def write_session(self) -> str:
        """The session as JSON, for Session.read."""
        return elements(lambda *a: lib.ts_session_write(self.handle, *a), c_char).tobytes().decode()

    def save_session(self, file: PathLike) -> None:
        """The same into a file, for Session.load."""
        check(lib.ts_session_save(self.handle, path(file)))

    @staticmethod
    def _number(get: Callable[[Any], Any]) -> int:
        out = c_uint32()
        check(get(byref(out)))
        return out.value


class Session(NamedTuple):
    """A session gone through again: the features as they were, and the segmentation, to go on with."""

    features: Features
    segmentation: Segmentation

    @classmethod
    def load(cls, model: Model, file: PathLike, *, job: Job | None = None) -> Session:
        return cls._again(model, lambda features, out: lib.ts_session_load(
            model.handle, path(file), handle_of(job), features, out), job)

    @classmethod
    def read(cls, model: Model, text: str | bytes, *, job: Job | None = None) -> Session:
        """From what Segmentation.write_session gave."""
        data = text.encode() if isinstance(text, str) else text
        return cls._again(model, lambda features, out: lib.ts_session_read(
            model.handle, data, len(data), handle_of(job), features, out), job)

    @classmethod
    def _again(cls, model: Model, create: Callable[[Any, Any], Any], job: Job | None) -> Session:
        features: list[Owner] = []
        hooks = hooks_of(model)

        def create_both(out: Any) -> int:
            handle = POINTER(_abi.ts_features)()
            status: int = create(byref(handle), out)
            if handle:
                features.append(Owner(handle, hooks, None))
            return status

        try:
            segmentation = make(_abi.ts_segmentation, create_both, job, hooks)
        except BaseException:
            for owner in features:
                owner.release()
            raise
        return cls(Features._made(features[0]), Segmentation._made(segmentation))

    def close(self) -> None:
        self.segmentation.close()
        self.features.close()

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()
