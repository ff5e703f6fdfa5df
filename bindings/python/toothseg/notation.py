# SPDX-License-Identifier: Apache-2.0
"""Numbers of teeth in other notations."""
from __future__ import annotations

from ctypes import byref, c_uint32
from typing import SupportsIndex

from . import _abi
from ._core import check, info, u32
from ._library import lib
from .records import Palmer


def fdi_to_universal(fdi: SupportsIndex) -> int:
    out = c_uint32()
    check(lib.ts_fdi_to_universal(u32(fdi), byref(out)))
    return out.value


def universal_to_fdi(universal: SupportsIndex) -> int:
    out = c_uint32()
    check(lib.ts_universal_to_fdi(u32(universal), byref(out)))
    return out.value


def fdi_to_palmer(fdi: SupportsIndex) -> Palmer:
    return Palmer._of(info(_abi.ts_palmer, lambda out: lib.ts_fdi_to_palmer(u32(fdi), out)))
