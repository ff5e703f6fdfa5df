# SPDX-License-Identifier: Apache-2.0
"""Scans to test with, made once, and everything a segmentation can be asked for."""
import atexit
import ctypes
import functools
import os
import shutil
import subprocess
import tempfile

import toothseg
from toothseg import Context, Features, Model, Segmentation

PYTHON = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
REPOSITORY = os.path.dirname(os.path.dirname(PYTHON))
LIBRARIES = os.environ["TOOTHSEG_TEST_LIBDIR"]
PROGRAMS = os.environ["TOOTHSEG_TEST_BINDIR"]
FOLDER = tempfile.mkdtemp(prefix="toothseg-test-")
atexit.register(shutil.rmtree, FOLDER)


def path(name):
    return os.path.join(FOLDER, name)


def program(name, *arguments):
    """A program of the library's own, which does not know where that is."""
    environment = dict(os.environ, LD_LIBRARY_PATH=LIBRARIES)
    subprocess.run([os.path.join(PROGRAMS, name), *map(str, arguments)], env=environment, check=True, stdout=subprocess.DEVNULL)


@functools.cache
def arch(triangles=20000, *options):
    """The path of a synthetic arch."""
    out = path(f"arch{len(os.listdir(FOLDER))}.ply")
    program("make-arch", out, "--triangles", triangles, "--seed", 1, *options)
    return out


@functools.cache
def context():
    return Context(threads=2)


@functools.cache
def model():
    return Model.load(context(), arch())


@functools.cache
def features():
    return Features.detect(model())


def unclicked():
    return Segmentation(features())


def separated():
    segmentation = unclicked()
    segmentation.segment_all()
    return segmentation


def dump(segmentation):
    """All there is to be compared, but for times."""
    teeth = segmentation.teeth()
    history = segmentation.history()
    return (teeth, segmentation.labels().tobytes(), [segmentation.tooth(t) for t in teeth],
            [segmentation.cut(t, loop).points.tobytes() for t in teeth for loop in range(segmentation.tooth(t).loops)],
            [segmentation.cut_edits(t) for t in teeth], [segmentation.locked(t) for t in teeth], segmentation.review(),
            segmentation.overlaps(), segmentation.changes(), (history.undo, history.redo), segmentation.click_count(),
            segmentation.write_session())


class Counter:
    """An allocator that knows what is out, and has no more when `left` is used up."""

    def __init__(self, left=None):
        self.libc = ctypes.CDLL(None)
        self.libc.aligned_alloc.restype = ctypes.c_void_p
        self.libc.aligned_alloc.argtypes = [ctypes.c_size_t, ctypes.c_size_t]
        self.libc.free.argtypes = [ctypes.c_void_p]
        self.live, self.made, self.left = set(), 0, left

    def alloc(self, size):
        if self.left is not None:
            if self.left == 0:
                return None
            self.left -= 1
        memory = self.libc.aligned_alloc(16, (size + 15) // 16 * 16)
        self.live.add(memory)
        self.made += 1
        return memory

    def free(self, memory):
        self.live.remove(memory)
        self.libc.free(memory)

    def context(self, **more):
        return Context(allocator=(self.alloc, self.free), **more)


def status_of(call, *arguments, **named):
    """The exception that a call raises."""
    try:
        call(*arguments, **named)
    except toothseg.Error as e:
        return e
    raise AssertionError("no toothseg.Error was raised")
