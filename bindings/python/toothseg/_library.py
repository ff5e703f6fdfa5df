# SPDX-License-Identifier: Apache-2.0
"""Finds and loads the library: TOOTHSEG_LIBRARY, else the one inside this package, else the system's."""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import sys
from collections.abc import Iterator

from . import _abi

if sys.platform == "win32":
    _NAMES = ["toothseg.dll", "libtoothseg.dll"]
elif sys.platform == "darwin":
    _NAMES = ["libtoothseg.0.dylib", "libtoothseg.dylib"]
else:
    _NAMES = ["libtoothseg.so.0", "libtoothseg.so"]


def _candidates() -> Iterator[str]:
    given = os.environ.get("TOOTHSEG_LIBRARY")
    if given:  # what is asked for by name is taken, or nothing
        yield given
        return
    folder = os.path.dirname(os.path.abspath(__file__))
    inside = [path for path in (os.path.join(folder, name) for name in _NAMES) if os.path.exists(path)]
    yield from inside or _NAMES
    found = ctypes.util.find_library("toothseg")
    if found and not inside:
        yield found


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def _load() -> ctypes.CDLL:
    tried = []
    for path in _candidates():
        try:
            library = ctypes.CDLL(path)
        except OSError as e:
            tried.append(f"{path}: {e}")
            continue
        return _checked(library, path)
    raise ImportError("the toothseg library was not found; TOOTHSEG_LIBRARY may name it. Tried:\n  " + "\n  ".join(tried))


def _checked(library: ctypes.CDLL, path: str) -> ctypes.CDLL:
    """Old programs run on new libraries of the same major version, not the other way round."""
    try:
        library.ts_version.restype = ctypes.c_char_p
        version = library.ts_version().decode()
        if _numbers(version)[0] == _numbers(_abi.VERSION)[0] and _numbers(version) >= _numbers(_abi.VERSION):
            return _abi.bind(library)
    except AttributeError as e:
        raise ImportError(f"{path} is no toothseg library that this package can use: {e}") from None
    raise ImportError(f"{path} is toothseg {version}; this package needs {_abi.VERSION} or newer, of the same major version")


lib = _load()
