# SPDX-License-Identifier: Apache-2.0
"""What a call that fails raises: one exception a block of statuses."""
from __future__ import annotations

from ._abi import Status


class Error(Exception):
    """A status other than OK, with the library's message in one line."""

    #: what went wrong
    status: Status
    #: of the status, as in toothseg.h: "TS_E_NO_TEETH"
    name: str
    #: what was wrong, and where
    message: str

    def __init__(self, status: int, name: str, message: str) -> None:
        super().__init__(status, name, message)  # as given: exceptions are pickled by their arguments
        self.status = Status(status)
        self.name = name
        self.message = message

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"


class UsageError(Error):
    """100: the call itself is wrong."""


class SurroundingsError(Error):
    """200: memory, cancellation, a fault in the library."""


class OutOfMemory(SurroundingsError):
    """200: an allocation failed, or memory_limit is too small."""


class Cancelled(SurroundingsError):
    """201: the job was cancelled."""


class FileError(Error):
    """300: a file cannot be read or written."""


class MeshError(Error):
    """400: the mesh is no scan."""


class FeaturesError(Error):
    """500: no teeth, or nothing to separate."""


class SegmentationError(Error):
    """600: a click or a correction was refused."""


class EditError(Error):
    """650: an edit of a cut was refused."""


class NumberError(Error):
    """700: the numbers of teeth do not fit."""


class ToothMeshError(Error):
    """750: the mesh of a tooth cannot be made."""


_BLOCKS: dict[int, type[Error]] = {
    100: UsageError,
    200: SurroundingsError,
    300: FileError,
    400: MeshError,
    500: FeaturesError,
    600: SegmentationError,
    650: EditError,
    700: NumberError,
    750: ToothMeshError,
}
_SINGLE: dict[int, type[Error]] = {Status.OUT_OF_MEMORY: OutOfMemory, Status.CANCELLED: Cancelled}


def class_of(status: int) -> type[Error]:
    """A block is 50 or 100 wide; a status of a block that is not known here is an Error."""
    block = status - status % 50
    return _SINGLE.get(status) or _BLOCKS.get(block) or _BLOCKS.get(block - block % 100) or Error
