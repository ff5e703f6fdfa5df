# SPDX-License-Identifier: Apache-2.0
"""The surroundings of all work: hooks, threads, progress and cancellation."""
from __future__ import annotations

from collections.abc import Callable
from ctypes import CFUNCTYPE, byref, py_object, sizeof
from typing import Any, SupportsIndex

from . import _abi
from ._abi import LogLevel
from ._core import Resource, check, hooks_of, in_callback, make, u32
from ._library import lib

#: one line of the library's, from any thread that works for the context
LogHook = Callable[[LogLevel, str], object]
#: the fraction done and the name of the stage; False cancels, and so does an exception
ProgressHook = Callable[[float, str], object]
#: gives `bytes` bytes aligned to 16 as an address, or None; takes them back
Allocator = tuple[Callable[[int], int | None], Callable[[int], object]]


class Context(Resource):
    """Holds the hooks (log, allocator) and the number of threads for all objects made from it.

    `threads`: 0, the default, is one a core. `log` gets what the library has to say, from any thread; without it the library
    is silent. `allocator` is a pair of functions for the library's large buffers, from any thread; it is slow, and there
    to count or to limit. What these two raise goes to sys.unraisablehook, and the library's work goes on: without the
    memory where it was alloc.
    """

    def __init__(self, *, threads: SupportsIndex | None = None, log: LogHook | None = None,
                 allocator: Allocator | None = None) -> None:
        options = _abi.ts_context_options()
        check(lib.ts_context_options_init(byref(options), sizeof(options)))
        if threads is not None:
            options.threads = u32(threads)
        if log is not None:
            options.log = _log_function(log)
        if allocator is not None:
            options.alloc, options.free = _allocator_functions(*allocator)
        # The struct holds the functions, which every object made from the context needs to the end of its life.
        self._owner = make(_abi.ts_context, lambda out: lib.ts_context_create(byref(options), out), hooks=options)


def _raise(exception: BaseException) -> None:
    raise exception


#: hands an exception to sys.unraisablehook, as ctypes does with all that its callbacks raise
_tell_unraisable = CFUNCTYPE(None, py_object)(_raise)


def _log_function(log: LogHook) -> Any:
    def call(level: int, text: bytes, user: object) -> None:
        with in_callback():
            log(LogLevel(level), text.decode("utf-8", "replace"))

    return _abi.ts_log_fn(call)


def _allocator_functions(alloc: Callable[[int], int | None], free: Callable[[int], object]) -> tuple[Any, Any]:
    def call_alloc(size: int, user: object) -> int | None:
        try:
            with in_callback():
                return alloc(size)
        except MemoryError:
            return None
        except BaseException as e:
            _tell_unraisable(e)
            return None

    def call_free(memory: int, user: object) -> None:
        with in_callback():
            free(memory)

    return _abi.ts_alloc_fn(call_alloc), _abi.ts_free_fn(call_free)


class _Watcher:
    """What a job's callback does, apart from the Job so that the library's pointer to it makes no reference cycle."""

    def __init__(self, progress: ProgressHook) -> None:
        self.progress = progress
        self.thrown: BaseException | None = None

    def __call__(self, fraction: float, stage: bytes, user: object) -> int:
        try:
            with in_callback():
                proceed = self.progress(fraction, stage.decode("utf-8", "replace"))
                return 0 if proceed is None or proceed else 1
        except BaseException as e:
            self.thrown = e
            return 1


class Job(Resource):
    """Progress and cancellation of one long call at a time.

    `progress(fraction, stage)` is called from a thread that works for the call; it must not use the library. Where it returns
    False the call raises Cancelled; what it raises comes out of the call. A job that was cancelled is to be reset before
    it is used again.
    """

    def __init__(self, context: Context, progress: ProgressHook | None = None) -> None:
        self._watcher = None if progress is None else _Watcher(progress)
        function = _abi.ts_progress_fn(self._watcher) if self._watcher else _abi.ts_progress_fn(0)
        self._owner = make(_abi.ts_job, lambda out: lib.ts_job_create(context.handle, function, None, out),
                           hooks=hooks_of(context), callback=function)

    def cancel(self) -> None:
        """Asks the running call to stop. From any thread, at any time."""
        lib.ts_job_cancel(self.handle)

    def reset(self) -> None:
        """Makes a cancelled job usable again. Not while a call uses it."""
        lib.ts_job_reset(self.handle)

    @property
    def fraction(self) -> float:
        """The last reported fraction. From any thread."""
        return float(lib.ts_job_progress(self.handle))

    def _take_thrown(self) -> BaseException | None:
        if self._watcher is None:
            return None
        thrown, self._watcher.thrown = self._watcher.thrown, None
        return thrown
