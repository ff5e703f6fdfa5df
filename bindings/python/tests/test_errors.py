# SPDX-License-Identifier: Apache-2.0
"""Every block of statuses, provoked: the right exception, and the object as it was."""
import ctypes
import json
import os
import pickle
import unittest

import numpy as np

import fixture
import toothseg
from toothseg import Features, FileFormat, Mesh, Model, Segmentation, Session, Status, _abi
from toothseg._core import check
from toothseg._library import lib

FAR = (500, 500, 500)
TRIANGLE = ([[0, 0, 0], [20, 0, 0], [0, 20, 0]], [[0, 1, 2]])


def sphere(radius=20, rings=24):
    """A closed mesh without teeth."""
    theta, phi = np.meshgrid(np.linspace(0, np.pi, rings), np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False), indexing="ij")
    xyz = radius * np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1).reshape(-1, 3)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(rings - 1), np.arange(2 * rings), indexing="ij"))
    a, b = i * 2 * rings + j, i * 2 * rings + (j + 1) % (2 * rings)
    return xyz, np.concatenate([np.stack([a, a + 2 * rings, b], 1), np.stack([b, a + 2 * rings, b + 2 * rings], 1)])


class Errors(unittest.TestCase):
    def refused(self, kind, status, call, *arguments, **named):
        """The call raises exactly `kind`, with a message of one line."""
        error = fixture.status_of(call, *arguments, **named)
        self.assertIs(type(error), kind, error)
        self.assertIs(error.status, status, error)
        self.assertEqual(error.name, lib.ts_status_name(status).decode())
        self.assertGreater(len(error.message), 10)
        self.assertNotIn("\n", error.message)
        self.assertEqual(str(error), f"{error.name}: {error.message}")
        return error

    def unchanged(self, segmentation, refusals):
        """refusals: (exception, status, call, arguments...)"""
        before = fixture.dump(segmentation)
        for kind, status, call, *arguments in refusals:
            with self.subTest(f"{status.name} {call.__name__}"):
                self.refused(kind, status, call, *arguments)
                self.assertEqual(fixture.dump(segmentation), before)

    def test_all_have_one_base(self):
        for name in toothseg.__all__:
            kind = getattr(toothseg, name)
            if isinstance(kind, type) and issubclass(kind, Exception):
                self.assertTrue(issubclass(kind, toothseg.Error))
        self.assertTrue(issubclass(toothseg.Cancelled, toothseg.SurroundingsError))

    def test_pickled(self):
        error = fixture.status_of(toothseg.fdi_to_universal, 99)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((type(again), again.status, again.name, str(again)), (type(error), error.status, error.name, str(error)))

    def test_100_usage(self):
        usage, model, s = toothseg.UsageError, fixture.model(), fixture.unclicked()
        self.refused(usage, Status.INVALID_ARGUMENT, toothseg.fdi_to_universal, 99)
        self.refused(usage, Status.INVALID_ARGUMENT, model.nearest, (0, float("nan"), 0))
        self.refused(usage, Status.INVALID_ARGUMENT, toothseg.Context, threads=5000)
        self.refused(usage, Status.NOT_FOUND, model.raycast, FAR, (1, 1, 1))
        self.refused(usage, Status.NOT_FOUND, s.contour, 4, 7)
        self.refused(usage, Status.MISMATCH, Session.read, Model(fixture.context(), *sphere()), s.write_session())
        # These a caller of the public layer cannot bring about.
        report, count = _abi.ts_intake_report(), ctypes.c_uint32(77)
        low = lambda function, *arguments: check(function(*arguments))  # noqa: E731
        self.refused(usage, Status.NULL, low, lib.ts_model_get_report, model.handle, None)
        self.refused(usage, Status.STRUCT_SIZE, low, lib.ts_model_get_report, model.handle, report)
        self.refused(usage, Status.BUFFER_TOO_SMALL, low, lib.ts_model_get_face_sources, model.handle, count, 1,
                     ctypes.byref(count))
        self.assertEqual(count.value, 77)

    def test_100_segmentation_unchanged(self):
        s, usage = fixture.separated(), toothseg.UsageError
        nan = (0, float("nan"), 0)
        self.unchanged(s, [
            (usage, Status.INVALID_ARGUMENT, s.click, nan),
            (usage, Status.INVALID_ARGUMENT, s.clicks, [nan]),
            (usage, Status.NOT_FOUND, s.include, 4000, FAR),
            (usage, Status.NOT_FOUND, s.tooth, toothseg.NONE),
            (usage, Status.NOT_FOUND, s.merge, s.teeth()[0], 4000),
            (usage, Status.INVALID_ARGUMENT, s.draw_cut, s.teeth()[0], []),
            (usage, Status.INVALID_ARGUMENT, s.set_number, s.teeth()[0], 99),
        ])

    def test_what_python_finds_first(self):
        s, model = fixture.separated(), fixture.model()
        for index in (-1, 2**32, 2**40 + s.teeth()[0]):
            self.assertRaises(ValueError, s.tooth, index)
        self.assertRaises(TypeError, s.tooth, 1.0)
        for position in ((1, 2), (1, 2, 3, 4)):
            self.assertRaises(ValueError, model.nearest, position)
        self.assertRaises(TypeError, model.nearest, "abc")
        self.assertRaises(ValueError, s.clicks, [[1, 2]])
        self.assertRaises(ValueError, Model, fixture.context(), [[1, 2]])
        self.assertRaises(ValueError, Model, fixture.context(), TRIANGLE[0], [[0, 1, -1]])
        self.assertRaises(ValueError, Model, fixture.context(), TRIANGLE[0], [[0, 1, 2.5]])
        self.assertRaises(ValueError, Model.load, fixture.context(), fixture.arch() + "\0.stl")

    def test_200_out_of_memory(self):
        with fixture.unclicked() as s:
            whole = s.memory().segmentation
        for limit in (1, whole // 100):
            error = self.refused(toothseg.OutOfMemory, Status.OUT_OF_MEMORY, Segmentation, fixture.features(),
                                 toothseg.SegmentOptions(memory_limit=limit))
            self.assertIn("memory_limit", error.message)

    def test_200_failing_allocator(self):
        """Memory ends at one allocation after the other: nothing is left, and what was there is as it was."""
        counter, small = fixture.Counter(), fixture.arch(5000)
        with counter.context(threads=1) as context, Model.load(context, small) as model, Features.detect(model) as features, \
             Segmentation(features) as s:
            live, made = len(counter.live), counter.made
            Segmentation(features).close()
            needed = counter.made - made
            self.assertEqual(len(counter.live), live)
            self.assertGreater(needed, 10)
            for left in range(0, needed, max(1, needed // 12)):
                counter.left = left
                self.refused(toothseg.OutOfMemory, Status.OUT_OF_MEMORY, Segmentation, features)
                self.assertEqual(len(counter.live), live)
            counter.left = None
            before = fixture.dump(s)
            for left in (0, 3, 20):
                counter.left = left
                self.refused(toothseg.OutOfMemory, Status.OUT_OF_MEMORY, s.segment_all)
                counter.left = None
                self.assertEqual(fixture.dump(s), before)
            s.segment_all()
            self.assertGreater(len(s.teeth()), 10)
        self.assertEqual(len(counter.live), 0)

    def test_201_cancelled(self):
        with fixture.unclicked() as s, toothseg.Job(fixture.context()) as job:
            job.cancel()
            before = fixture.dump(s)
            self.refused(toothseg.Cancelled, Status.CANCELLED, s.segment_all, job=job)
            self.refused(toothseg.Cancelled, Status.CANCELLED, Model.load, fixture.context(), fixture.arch(), job=job)
            self.assertEqual(fixture.dump(s), before)
            job.reset()
            s.segment_all(job=job)

    def test_300_files(self):
        with open(fixture.arch(5000), "rb") as f:
            ply = f.read()
        cut, more = ply[:-100], ply + b"more"
        stl = bytes(80) + (2**31).to_bytes(4, "little") + bytes(50)
        read = lambda data, format=FileFormat.AUTO: Model.read(fixture.context(), data, format)  # noqa: E731
        kind = toothseg.FileError
        self.refused(kind, Status.FILE_OPEN, Model.load, fixture.context(), fixture.path("no such file.stl"))
        self.refused(kind, Status.FILE_FORMAT, read, b"\x89PNG of a tooth, but no scan" * 10)
        self.refused(kind, Status.FILE_TRUNCATED, read, cut)
        self.refused(kind, Status.FILE_TRAILING, read, more)
        self.refused(kind, Status.FILE_COUNT, read, stl, FileFormat.STL)
        error = self.refused(kind, Status.FILE_SYNTAX, read, b"v 0 0 0\nv 1 0 zero\nf 1 2 1\n", FileFormat.OBJ)
        self.assertIn("2", error.message)
        with fixture.separated() as s:
            nowhere = fixture.path(os.path.join("no such folder", "x.stl"))
            self.unchanged(s, [(kind, Status.FILE_WRITE, s.save_session, nowhere),
                               (kind, Status.FILE_WRITE, s.save, nowhere, toothseg.OutputFormat.STL)])
            session = json.loads(s.write_session())
        text = json.dumps(session)
        self.refused(kind, Status.FILE_FORMAT, Session.read, fixture.model(), '{"teeth": 3}')
        self.refused(kind, Status.FILE_TRUNCATED, Session.read, fixture.model(), text[:-40])
        name = next(n for n, v in session.items() if isinstance(v, int) and v == 1)
        self.refused(kind, Status.FILE_NEWER, Session.read, fixture.model(), json.dumps({**session, name: 999}))
        self.refused(kind, Status.FILE_OPEN, Session.load, fixture.model(), nowhere)

    def test_400_mesh(self):
        xyz, triangles = (np.array(a) for a in TRIANGLE)
        make = lambda p, t=triangles: Model(fixture.context(), p, t)  # noqa: E731
        kind = toothseg.MeshError
        self.refused(kind, Status.MESH_EMPTY, make, xyz, np.empty((0, 3), np.uint32))
        self.refused(kind, Status.MESH_EMPTY, make, np.empty((0, 3)), None)
        self.refused(kind, Status.MESH_EMPTY, make, [], [])
        self.refused(kind, Status.MESH_NON_FINITE, make, xyz * np.nan)
        self.refused(kind, Status.MESH_INDEX_RANGE, make, xyz, [[0, 1, 3]])
        self.refused(kind, Status.MESH_INDEX_RANGE, make, xyz, np.array([[0, 1, -1]], np.int32))
        self.refused(kind, Status.MESH_UNITS, make, xyz / 1000.)
        self.refused(kind, Status.MESH_TOO_LARGE, make, xyz * 1e12)

    def test_500_features(self):
        with Model(fixture.context(), *sphere()) as model, Features(model) as none:
            self.refused(toothseg.FeaturesError, Status.NO_TEETH, Features.detect, model)
            self.refused(toothseg.FeaturesError, Status.NO_CONSTRAINT, Segmentation, none)

    def test_600_segmentation(self):
        s, kind = fixture.separated(), toothseg.SegmentationError
        tooth, other = s.teeth()[4:6]
        positions, labels = fixture.model().positions(), s.labels()
        height = positions[fixture.model().triangles()].mean(axis=1) @ np.array(fixture.features().occlusal)
        gum = positions[fixture.model().triangles()[np.argmin(np.where(labels == 0, height, np.inf))]].mean(axis=0)
        seed = positions[s.tooth_seeds(other)[0]]
        s.set_locked(other)
        error = self.refused(kind, Status.CLICK_OFF_SURFACE, s.click, FAR)
        self.assertIn("mm from the surface", error.message)
        self.unchanged(s, [
            (kind, Status.CLICK_OFF_SURFACE, s.click, FAR),
            (kind, Status.CLICK_ON_GINGIVA, s.click, gum),
            (kind, Status.LOCKED, s.click, seed),
            (kind, Status.LOCKED, s.remove, other),
            (kind, Status.LOCKED, s.merge, tooth, other),
            (kind, Status.NO_CHANGE, s.set_locked, other),
            (kind, Status.NO_CHANGE, s.merge, tooth, tooth),
            (kind, Status.NO_HISTORY, s.redo),
        ])
        fresh = fixture.unclicked()
        self.unchanged(fresh, [(kind, Status.NO_HISTORY, fresh.undo)])

    def test_650_edits(self):
        s, kind = fixture.separated(), toothseg.EditError
        tooth = s.teeth()[6]
        xyz = fixture.model().positions()
        middle = fixture.model().nearest(xyz[s.tooth_vertices(tooth)].mean(axis=0)).position
        neighbour = xyz[s.tooth_seeds(s.teeth()[7])[0]]
        s.offset_cut(tooth, .1)  # so that there is an edit to be lost
        line = s.cut(tooth).positions
        # Where the cut runs along the gums, as far as can be from the teeth beside it; and across from there.
        beside = xyz[np.concatenate([s.tooth_vertices(s.teeth()[i]) for i in (5, 7)])]
        room = np.linalg.norm(line[:, None] - beside, axis=2).min(axis=1)
        at = int(np.argmax(room))
        across = int(np.argmax(np.where(room > 1.5, np.linalg.norm(line - line[at], axis=1), 0)))
        nearest = int(np.argmin(np.linalg.norm(line - neighbour, axis=1)))
        self.unchanged(s, [
            (kind, Status.EDIT_NOTHING, s.drag_cut, tooth, 0, at, line[at]),
            (kind, Status.EDIT_NOTHING, s.offset_cut, tooth, 0),
            (kind, Status.EDIT_NO_LOOP, s.offset_cut, tooth, -5),
            (kind, Status.EDIT_ON_TOOTH, s.offset_cut, tooth, 9),
            (kind, Status.EDIT_ON_TOOTH, s.drag_cut, tooth, 0, nearest, neighbour),
            (kind, Status.EDIT_CROSSING, s.drag_cut, tooth, 0, at, line[across]),
            (kind, Status.EDIT_OFF_CUT, s.draw_cut, tooth, [line[at], middle]),
        ])

    def test_700_numbers(self):
        s, kind = fixture.separated(), toothseg.NumberError
        teeth, upper = s.teeth(), toothseg.NumberOptions(jaw=toothseg.Jaw.UPPER)
        s.assign_numbers(upper)
        s.set_number(teeth[3], s.number(teeth[3]).fdi)
        numbers = lambda: [s.number(t) for t in teeth]  # noqa: E731
        before = numbers()
        for arguments in ((Status.NUMBER_TAKEN, s.set_number, teeth[2], before[3].fdi),
                          (Status.NUMBER_JAW, s.set_number, teeth[2], 36),
                          (Status.NUMBER_ORDER, s.set_number, teeth[2], before[4].fdi),
                          (Status.NUMBER_JAW, s.assign_numbers, toothseg.NumberOptions(jaw=toothseg.Jaw.LOWER))):
            self.refused(kind, *arguments)
            self.assertEqual(numbers(), before)
        with fixture.features().clone() as many:
            seen = set()
            for p in many.points():  # a group of its own for each point but the first of a tooth
                if p.group in seen and many.info().groups < 20:
                    many.set_group(p.id)
                seen.add(p.group)
            with Segmentation(many) as segmentation:
                self.refused(kind, Status.TOO_MANY_TEETH, segmentation.assign_numbers)
                self.refused(toothseg.UsageError, Status.NOT_FOUND, segmentation.jaw)

    def test_750_tooth_meshes(self):
        """A scan so noisy that it crosses itself all over cannot be closed."""
        noisy = fixture.arch(5000, "--noise", "1", "--isotropic")
        with Model.load(fixture.context(), noisy) as model, Features.detect(model) as features, Segmentation(features) as s:
            s.click(s.propose_clicks()[0])
            self.refused(toothseg.ToothMeshError, Status.NOT_CLOSED, Mesh.tooth, s, s.teeth()[0],
                         toothseg.ToothMeshOptions(closed=True))
            Mesh.tooth(s, s.teeth()[0]).close()
