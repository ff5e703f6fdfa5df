# SPDX-License-Identifier: Apache-2.0
"""What all of the public layer stands on: statuses, owners of handles, arrays, structs, callbacks."""
from __future__ import annotations

import collections
import contextlib
import ctypes
import operator
import os
import threading
from collections.abc import Callable, Iterator, Sequence
from ctypes import POINTER, byref, c_uint32, sizeof
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Self, SupportsIndex, TypeVar, overload

import numpy as np
import numpy.typing as npt

from . import errors
from ._abi import NONE
from ._library import lib

if TYPE_CHECKING:
    from .context import Job

#: x, y, z in mm, or a direction
Point = tuple[float, float, float]
#: what is taken for one
PointLike = Sequence[float] | npt.NDArray[Any]
PathLike = str | bytes | os.PathLike[str] | os.PathLike[bytes]
Array = npt.NDArray[Any]

T = TypeVar("T")

_here = threading.local()
#: destroy, the handle, and what has to live until it is destroyed
_deferred: collections.deque[tuple[Callable[[Any], None], Any, object, object]] = collections.deque()


# ---------------------------------------------------------------------------------------------------------------- statuses


def error_of(status: int) -> errors.Error:
    """The exception for what the last call of this thread returned."""
    message = lib.ts_last_error_message().decode("utf-8", "replace")
    return errors.class_of(status)(status, lib.ts_status_name(status).decode(), message)


def raise_thrown(thrown: BaseException | None) -> None:
    """What a callback raised, if it did."""
    if thrown is not None:
        try:
            raise thrown
        finally:
            del thrown  # the exception knows this frame, which would know the exception


def check(status: int, job: Job | None = None) -> None:
    """Raises what the job's callback raised, else what the status says."""
    if job is not None:
        if _deferred:
            _destroy_deferred()
        raise_thrown(job._take_thrown())
    if status:
        raise error_of(status)


# ----------------------------------------------------------------------------------------------------------------- handles


@contextlib.contextmanager
def in_callback() -> Iterator[None]:
    """Around what a callback runs of the caller's. The library must not be called from one, but Python may collect
    garbage in there: what would be destroyed waits until the call is over."""
    _here.depth = getattr(_here, "depth", 0) + 1
    try:
        yield
    finally:
        _here.depth -= 1


def _destroy_deferred() -> None:
    while getattr(_here, "depth", 0) == 0:
        try:
            destroy, handle, *kept = _deferred.popleft()
        except IndexError:
            return
        destroy(handle)


class Owner:
    """Owns a handle, and keeps alive what the library calls back for it. A call under way refers to the owner too, so
    that an object which another thread closes meanwhile is destroyed after the call, and not during it."""

    def __init__(self, handle: Any, hooks: object, callback: object) -> None:
        self._as_parameter_ = handle
        self.hooks = hooks  # of the context
        self.callback = callback  # of the object
        self._destroy = getattr(lib, type(handle)._type_.__name__ + "_destroy")

    def release(self) -> None:
        """Destroys the handle now."""
        handle, self._as_parameter_ = self._as_parameter_, None
        if not handle:
            return
        if getattr(_here, "depth", 0):
            _deferred.append((self._destroy, handle, self.hooks, self.callback))
        else:
            self._destroy(handle)
            if _deferred:
                _destroy_deferred()

    def __del__(self) -> None:
        if getattr(self, "_as_parameter_", None):
            self.release()


def make(handle: Any, create: Callable[[Any], Any], job: Job | None = None, hooks: object = None,
         callback: object = None) -> Owner:
    """An object of the library: create(out) makes it."""
    if _deferred:
        _destroy_deferred()
    out = POINTER(handle)()
    status = create(byref(out))
    owner = Owner(out, hooks, callback) if out else None
    try:
        check(status, job)  # a callback may raise at the very end, when the object is there
    except BaseException:
        if owner is not None:
            owner.release()
        raise
    assert owner is not None
    return owner


class Resource:
    """Something of the library's that is given back by close(), at the end of a with block, or when it is forgotten."""

    _owner: Owner | None = None

    @property
    def handle(self) -> Owner:
        """For ctypes, as an argument of the library's functions. ValueError once it is closed."""
        owner = self._owner
        if owner is None:
            raise ValueError(f"this {type(self).__name__} is closed")
        return owner

    @property
    def closed(self) -> bool:
        return self._owner is None

    def close(self) -> None:
        """Gives it back. Twice is fine, and so is any order among objects."""
        self._owner = None

    def __enter__(self) -> Self:
        self.handle
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def handle_of(resource: Resource | None) -> Owner | None:
    return None if resource is None else resource.handle


def hooks_of(parent: Resource) -> object:
    """The hooks of the context, which what is made from `parent` keeps alive."""
    return parent.handle.hooks


# --------------------------------------------------------------------------------------------------------------- arguments


def u32(value: SupportsIndex) -> int:
    """An index or a count. ctypes alone would take the lowest 32 bits of whatever it is given."""
    number = operator.index(value)
    if not 0 <= number <= NONE:
        raise ValueError(f"{number} is not within 0 and 2^32 - 1")
    return number


def point(value: PointLike) -> Any:
    """Three doubles for the library."""
    x, y, z = value
    return (ctypes.c_double * 3)(x, y, z)


def points(value: PointLike | Sequence[PointLike]) -> Array:
    """n x 3 doubles for the library; no copy of an array that is that already."""
    array = np.ascontiguousarray(value, np.float64)
    if array.size == 0:
        return array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"n x 3 coordinates are needed, not {' x '.join(map(str, array.shape))}")
    return array


def path(value: PathLike) -> bytes:
    """UTF-8, or the bytes that the file system has."""
    encoded = os.fsencode(value)
    if b"\0" in encoded:  # the library would see a shorter path
        raise ValueError("a path with a zero character")
    return encoded


def address(array: Array, ctype: Any) -> Any:
    return array.ctypes.data_as(POINTER(ctype))


# -------------------------------------------------------------------------------------------------------- arrays, structs

Get = Callable[[Any, int, Any], Any]


def elements(get: Get, ctype: Any, width: int = 1, out: Array | None = None) -> Array:
    """An array from the two calls of a getter, get(buffer, capacity, count); into `out` where that is given."""
    count = c_uint32()
    check(get(None, 0, byref(count)))
    n, dtype = count.value, np.dtype(ctype)
    if out is None:
        out = np.empty((n, width) if width > 1 else n, dtype)
    elif out.dtype != dtype or out.ndim != 1 or not out.flags.c_contiguous or not out.flags.writeable or len(out) < n:
        raise ValueError(f"out has to be a writeable contiguous array of at least {n} {dtype}")
    if n:
        check(get(address(out, ctype), n, byref(count)))
    return out[:n]


def structs(get: Get, ctype: Any) -> Any:
    """The same as ctypes structs, for what is turned into records."""
    count = c_uint32()
    check(get(None, 0, byref(count)))
    out = (ctype * count.value)()
    if count.value:
        check(get(out, count.value, byref(count)))
    return out


def info(ctype: Any, get: Callable[[Any], Any]) -> Any:
    """A struct that begins with struct_size."""
    out = ctype()
    out.struct_size = sizeof(out)
    check(get(byref(out)))
    return out


# ----------------------------------------------------------------------------------------------------------------- options


class Setting(Generic[T]):
    """A field of an options struct, as Python has it."""

    def __init__(self, read: Callable[[Any], T]) -> None:
        self.read = read

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, options: None, owner: type) -> Self: ...

    @overload
    def __get__(self, options: Options, owner: type) -> T: ...

    def __get__(self, options: Options | None, owner: type) -> Any:
        return self if options is None else self.read(getattr(options._struct, self.name))

    def __set__(self, options: Options, value: T) -> None:
        given: Any = value
        current = getattr(options._struct, self.name)
        if isinstance(current, ctypes.Array):
            given = point(given)
        elif isinstance(current, int):
            given = operator.index(given)
        setattr(options._struct, self.name, given)
        if isinstance(current, int) and getattr(options._struct, self.name) != given:
            setattr(options._struct, self.name, current)  # ctypes had kept the bits for which there is room
            raise ValueError(f"{self.name} cannot be {value!r}")


class Options:
    """Options with the library's defaults, set by keyword or by attribute; toothseg.h says what each is."""

    _ctype: ClassVar[Any]

    def __init__(self, **settings: Any) -> None:
        self._struct = self._ctype()
        self._initialise()
        for name, value in settings.items():
            if not isinstance(getattr(type(self), "__dict__").get(name), Setting):
                raise TypeError(f"{type(self).__name__} has no setting {name!r}")
            setattr(self, name, value)

    def _initialise(self) -> None:
        init = getattr(lib, self._ctype.__name__ + "_init")
        check(init(byref(self._struct), sizeof(self._struct)))

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and name not in type(self).__dict__:
            raise AttributeError(f"{type(self).__name__} has no setting {name!r}")
        super().__setattr__(name, value)

    def __repr__(self) -> str:
        names = [n for n, s in type(self).__dict__.items() if isinstance(s, Setting)]
        return f"{type(self).__name__}({', '.join(f'{n}={getattr(self, n)!r}' for n in names)})"


def struct_of(options: Options | None) -> Any:
    return None if options is None else byref(options._struct)
