# SPDX-License-Identifier: Apache-2.0
"""The way from a scan to labels and teeth, by the samples and by the API, comes to the same bytes as ts-segment's."""
import os
import signal
import subprocess
import sys
import unittest

import numpy as np

import fixture
import toothseg
from toothseg import Mesh, Model, OutputFormat, Session, Status, ToothMeshOptions

SAMPLES = os.path.join(fixture.PYTHON, "samples")


def content(path):
    with open(path, "rb") as f:
        return f.read()


def sample(name, *arguments):
    return subprocess.run([sys.executable, os.path.join(SAMPLES, name), *arguments], capture_output=True, text=True)


class Labels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scan, cls.labels, cls.teeth = fixture.arch(), fixture.path("ts.txt"), fixture.path("ts-teeth")
        fixture.program("ts-segment", cls.scan, "--labels", cls.labels, "--teeth", cls.teeth)

    def test_by_the_sample(self):
        out, teeth = fixture.path("clicks.txt"), fixture.path("clicks-teeth")
        run = sample("segment_arch.py", self.scan, "--labels", out, "--teeth", teeth)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(content(out), content(self.labels))
        self.assertEqual(sorted(os.listdir(teeth)), sorted(os.listdir(self.teeth)))
        self.assertEqual(len(os.listdir(teeth)), 15)
        for name in os.listdir(teeth):
            self.assertEqual(content(os.path.join(teeth, name)), content(os.path.join(self.teeth, name)), name)
        self.assertIn("100 %", run.stderr)

    def test_by_the_sample_with_all(self):
        out = fixture.path("all.txt")
        run = sample("segment_arch.py", self.scan, "--labels", out, "--all", "--threads", "1")
        self.assertEqual(run.returncode, 0, run.stderr)
        with Model.load(fixture.context(), self.scan) as model, toothseg.Features.detect(model) as features, \
             toothseg.Segmentation(features) as segmentation:
            segmentation.segment_all()
            expected = "".join(f"{n}\n" for n in segmentation.labels())
        self.assertEqual(content(out).decode(), expected)

    def test_by_the_api(self):
        with toothseg.Context() as context, Model.load(context, self.scan) as model, \
             toothseg.Features.detect(model) as features, toothseg.Segmentation(features) as segmentation:
            statuses = segmentation.clicks(segmentation.propose_clicks())
            self.assertEqual(statuses, [Status.OK] * 7)
            labels = segmentation.labels()
        self.assertEqual("".join(f"{n}\n" for n in labels).encode(), content(self.labels))

    def test_by_arrays(self):
        """The model's own arrays, in all the forms that are taken, are the same model."""
        with Model.load(fixture.context(), self.scan) as loaded:
            xyz, triangles = loaded.positions(), loaded.triangles()
        wide = np.zeros((len(xyz), 5))
        wide[:, 1:4] = xyz
        forms = [(xyz, triangles), (wide[:, 1:4], triangles.astype(np.int32)),
                 (xyz[:, ::-1][:, ::-1], triangles.astype(np.int64)),
                 (xyz.astype(">f8"), triangles.tolist()), (np.asfortranarray(xyz), np.asfortranarray(triangles)),
                 (xyz.astype(np.float32), triangles), (xyz[triangles].reshape(-1, 3), None)]
        for coordinates, indices in forms:
            with self.subTest(f"{coordinates.dtype} {coordinates.strides}"), \
                 Model(fixture.context(), coordinates, indices) as model, toothseg.Features.detect(model) as features, \
                 toothseg.Segmentation(features) as segmentation:
                segmentation.clicks(segmentation.propose_clicks())
                self.assertEqual("".join(f"{n}\n" for n in segmentation.labels()).encode(), content(self.labels))

    def test_from_memory(self):
        data = content(self.scan)
        for form in (data, bytearray(data), memoryview(data), np.frombuffer(data, np.uint8)):
            with Model.read(fixture.context(), form) as model:
                self.assertEqual(model.report(), fixture.model().report())

    def test_ctrl_c(self):
        """As the sample is run, but slower, so that there is something to be stopped."""
        slow = ("import sys, time; sys.path.insert(0, sys.argv.pop(1)); import segment_arch as s; show = s.show\n"
                "s.show = lambda *a: (show(*a), time.sleep(.05))\nsys.exit(s.main())")
        out = fixture.path("stopped.txt")
        run = subprocess.Popen([sys.executable, "-c", slow, SAMPLES, self.scan, "--labels", out], stderr=subprocess.PIPE)
        first = run.stderr.read(10)
        run.send_signal(signal.SIGINT)
        rest = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 130, first + rest)
        self.assertIn(b"stopped", rest)
        self.assertFalse(os.path.exists(out))

    def test_samples_complain(self):
        for name, more in (("segment_arch.py", ["--labels", fixture.path("none.txt")]), ("hello_tooth.py", [])):
            run = sample(name, "no such scan.stl", *more)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn("TS_E_FILE_OPEN", run.stderr)
            self.assertNotIn("Traceback", run.stderr)

    def test_hello_tooth(self):
        run = sample("hello_tooth.py", self.scan)
        self.assertEqual(run.returncode, 0, run.stderr)
        cut = np.loadtxt(run.stdout.splitlines())
        self.assertGreater(len(cut), 20)
        again = sample("hello_tooth.py", self.scan, *run.stdout.splitlines()[0].split())
        self.assertEqual(again.returncode, 0, again.stderr)


class Work(unittest.TestCase):
    """What can be asked for says what is so."""

    @classmethod
    def setUpClass(cls):
        cls.segmentation = fixture.separated()
        cls.teeth = cls.segmentation.teeth()

    def test_model(self):
        model, report = fixture.model(), fixture.model().report()
        xyz, triangles = model.positions(), model.triangles()
        self.assertEqual((xyz.shape, xyz.dtype), ((report.vertices, 3), np.float64))
        self.assertEqual((triangles.shape, triangles.dtype), ((report.faces, 3), np.uint32))
        self.assertTrue((model.face_sources() == np.arange(report.faces)).all())
        self.assertTrue((model.vertex_map() == np.arange(report.vertices)).all())
        corners = xyz[triangles]
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
        self.assertAlmostEqual(area, report.area, 6)
        on = model.nearest(xyz[5])
        self.assertEqual((on.nearest_vertex, on.distance, on.position), (5, 0, tuple(xyz[5])))
        up = np.array(fixture.features().occlusal)
        hit = model.raycast(xyz[5] + 50 * up, -up)
        self.assertLessEqual(hit.distance, 50 + 1e-9)
        self.assertAlmostEqual(sum(hit.barycentric), 1)

    def test_features(self):
        with fixture.features().clone() as features:
            info, groups, points = features.info(), features.groups(), features.points()
            self.assertEqual((info.groups, info.points, info.warnings), (14, len(points), 0))
            self.assertEqual((groups[0].previous, groups[0].next, groups[-1].next), (None, groups[1].id, None))
            self.assertEqual(sum(g.points for g in groups), len(points))
            self.assertGreater(len(features.arch()), 10)
            new, group = features.add_point(points[0].position)
            self.assertNotIn(group, [g.id for g in groups])
            self.assertEqual(features.set_group(new, groups[3].id), groups[3].id)
            features.move_point(new, points[-1].position)
            moved = next(p for p in features.points() if p.id == new)
            self.assertTrue(moved.by_hand)
            self.assertEqual(moved.position, fixture.model().nearest(points[-1].position).position)
            features.remove_point(new)
            features.remove_group(groups[0].id)
            self.assertEqual(features.info().groups, 13)
            features.occlusal = (0, 0, 2)
            self.assertEqual(features.occlusal, (0, 0, 1))
        self.assertEqual(fixture.features().info(), info)

    def test_clicks(self):
        with fixture.unclicked() as s:
            where = s.propose_clicks()[2]
            number = s.click(where)
            info = s.click_info(number)
            self.assertEqual((s.click_count(), number), (1, 0))
            self.assertEqual(sorted(s.teeth()), sorted([info.target, info.neighbour]))
            self.assertEqual(s.tooth(info.target).click, number)
            field = s.field(number)
            self.assertEqual(field.shape, (fixture.model().report().vertices,))
            self.assertTrue((field[s.tooth_seeds(info.target)] < .5).all())
            self.assertEqual(s.histogram(number).shape, (50,))
            contours = s.contours(number)
            self.assertEqual(len(contours), 100)
            lines = s.contour(number, 50)
            self.assertEqual(len(lines), contours[50].polylines)
            self.assertEqual(sum(len(line.points) for line in lines), contours[50].points)
            self.assertAlmostEqual(info.ms.total, info.ms.pick + info.ms.cut + info.ms.label, delta=info.ms.total)
            self.assertEqual(s.clicks([where, [500, 500, 500]]), [Status.OK, Status.CLICK_OFF_SURFACE])
            self.assertEqual(s.clicks([]), [])

    def test_a_tooth(self):
        s, xyz = self.segmentation, fixture.model().positions()
        for tooth in self.teeth:
            info, cut = s.tooth(tooth), s.cut(tooth)
            self.assertEqual((tooth, len(s.tooth_faces(tooth)), len(s.tooth_vertices(tooth))),
                             (info.id, info.faces, info.vertices))
            self.assertEqual((len(cut.points), cut.closed), (cut.info.points, True))
            p = cut.points
            between = xyz[p["a"]] + p["t"][:, None] * (xyz[p["b"]] - xyz[p["a"]])
            np.testing.assert_allclose(between, cut.positions, atol=1e-9)
            self.assertTrue(np.shares_memory(cut.positions, cut.points))
            frame = s.tooth_frame(tooth)
            self.assertAlmostEqual(np.linalg.norm(frame.mesial), 1)
            self.assertTrue(frame.from_arch and 3 < frame.width < 15)
        self.assertEqual({s.tooth(t).label for t in self.teeth} | {0}, set(s.labels().tolist()))

    def test_out_is_filled_in_place(self):
        n = fixture.model().report().input_faces
        out = np.full(n + 3, 99, np.uint32)
        labels = self.segmentation.labels(out)
        self.assertTrue(np.shares_memory(labels, out) and (labels == self.segmentation.labels()).all())
        self.assertEqual(out[n:].tolist(), [99] * 3)
        for bad in (np.empty(n, np.int32), np.empty(n - 1, np.uint32), np.empty((n, 1), np.uint32),
                    np.empty(2 * n, np.uint32)[::2]):
            self.assertRaises(ValueError, self.segmentation.labels, bad)
        out.flags.writeable = False
        self.assertRaises(ValueError, self.segmentation.labels, out)

    def test_corrections(self):
        with fixture.separated() as s:
            whole = fixture.dump(s)
            tooth, other = s.teeth()[1:3]
            cut = s.cut(tooth)
            up = np.array(fixture.features().occlusal)
            below = cut.positions[np.argmin(cut.positions @ up)] - .5 * up
            area = s.tooth(tooth).area
            s.include(tooth, below)
            self.assertGreater(s.tooth(tooth).area, area)
            self.assertIn(tooth, s.changes())
            s.undo()
            self.assertEqual(fixture.dump(s)[1:4], whole[1:4])
            s.redo()
            s.undo()
            points = [p for p in fixture.features().points() if p.group == tooth]
            second = s.split(tooth, points[0].position, points[-1].position)
            self.assertIn(second, s.teeth())
            s.merge(tooth, second)
            self.assertNotIn(second, s.teeth())
            s.undo()
            s.undo()
            s.exclude(tooth, points[0].position)
            s.undo()
            here, there = (np.array(p.position) for p in points[:2])
            s.move_point(tooth, here, here + .6 * (there - here))
            s.undo()
            s.set_locked(other)
            self.assertTrue(s.locked(other) and not s.locked(tooth))
            s.set_locked(other, False)
            s.remove(other)
            self.assertNotIn(other, s.teeth())
            s.undo()
            self.assertEqual(fixture.dump(s)[1], whole[1])
            history = s.history()
            self.assertGreater(history.undo, 0)
            s.set_history_limit(0)
            self.assertEqual((s.history().undo, s.history().complete), (0, False))

    def test_edits(self):
        with fixture.separated() as s:
            tooth = s.teeth()[6]
            before, cut = s.tooth(tooth), s.cut(tooth)
            centre = fixture.model().positions()[s.tooth_vertices(tooth)].mean(axis=0)
            at = int(np.argmin(cut.positions @ np.array(fixture.features().occlusal)))
            away = cut.positions[at] - centre
            to = fixture.model().nearest(cut.positions[at] + .6 * away / np.linalg.norm(away)).position
            s.drag_cut(tooth, 0, at, to)
            edit, = s.cut_edits(tooth)
            self.assertEqual((edit.kind, edit.status, edit.points), (toothseg.EditKind.DRAG, Status.OK, 2))
            np.testing.assert_allclose(edit.from_, cut.positions[at])
            np.testing.assert_allclose(edit.to, to)
            s.reset_cut(tooth)
            n = len(cut.points)
            s.draw_cut(tooth, [cut.positions[at - n // 20], to, cut.positions[(at + n // 20) % n]])
            rough = s.cut(tooth).info.length
            s.smooth_cut(tooth, .4)
            self.assertLess(s.cut(tooth).info.length, rough)
            s.reset_cut(tooth)
            s.offset_cut(tooth, -.3)
            self.assertLess(s.tooth(tooth).area, before.area)
            s.reset_cut(tooth)
            self.assertEqual((s.tooth(tooth), s.cut_edits(tooth)), (before, []))

    def test_numbers(self):
        with fixture.separated() as s:
            s.assign_numbers(toothseg.NumberOptions(jaw=toothseg.Jaw.UPPER))
            self.assertEqual([s.number(t).fdi for t in s.teeth()], [17, 16, 15, 14, 13, 12, 11, 21, 22, 23, 24, 25, 26, 27])
            self.assertEqual((s.jaw().jaw, s.jaw().given), (toothseg.Jaw.UPPER, True))
            s.set_number(s.teeth()[0], 18)
            self.assertEqual((s.number(s.teeth()[0]).fdi, s.number(s.teeth()[0]).set_by_hand), (18, True))
            s.set_number(s.teeth()[0], None)
            self.assertFalse(s.number(s.teeth()[0]).set_by_hand)
        for universal in range(1, 33):
            fdi = toothseg.universal_to_fdi(universal)
            palmer = toothseg.fdi_to_palmer(fdi)
            self.assertEqual(toothseg.fdi_to_universal(fdi), universal)
            self.assertEqual((10 * palmer.quadrant + palmer.position, palmer.letters[2]), (fdi, str(fdi % 10)))
        self.assertEqual((toothseg.fdi_to_palmer(16).letters, toothseg.fdi_to_palmer(16).symbol), ("UR6", "6\u2518"))

    def test_meshes(self):
        s = self.segmentation
        with Mesh.tooth(s, self.teeth[3], ToothMeshOptions(closed=True)) as mesh:
            info, xyz, triangles = mesh.info(), mesh.positions(), mesh.triangles()
            self.assertEqual((info.open_rims, info.label), (0, s.tooth(self.teeth[3]).label))
            self.assertEqual((xyz.shape, triangles.shape), ((info.vertices, 3), (info.triangles, 3)))
            a, b, c = xyz[triangles.astype(int)].transpose(1, 0, 2)
            self.assertAlmostEqual(np.einsum("ij,ij->", a, np.cross(b, c)) / 6, info.volume, 3)
            np.testing.assert_allclose(np.linalg.norm(mesh.normals(), axis=1), 1)
            self.assertEqual((mesh.faces() == toothseg.NONE).sum(), info.fill_triangles)
            flags = mesh.vertex_flags()
            self.assertEqual((flags & toothseg.MeshVertexFlag.ON_CUT != 0).sum(), info.cut_vertices)
            for format in OutputFormat:
                out = fixture.path(f"z\u00e4hne.{format.name.lower()}")
                mesh.save(out, format)
                self.assertGreater(os.path.getsize(out), 1000)
            with Model.load(fixture.context(), fixture.path("z\u00e4hne.stl")) as again:
                self.assertEqual(again.report().faces, info.triangles)
        with Mesh.gingiva(s) as gingiva:
            self.assertEqual((gingiva.info().label, gingiva.info().fill_triangles), (0, 0))
        s.save(fixture.path("split.ply"), OutputFormat.PLY)
        s.save(fixture.path("whole.ply"), OutputFormat.PLY, toothseg.SaveOptions(whole_faces=True))
        with Model.load(fixture.context(), fixture.path("whole.ply")) as whole, \
             Model.load(fixture.context(), fixture.path("split.ply")) as split:
            self.assertEqual(whole.report().faces, fixture.model().report().faces)
            self.assertGreater(split.report().faces, whole.report().faces)

    def test_session(self):
        with fixture.separated() as s:
            s.offset_cut(s.teeth()[4], .2)
            s.save_session(fixture.path("session.json"))
            text = s.write_session()
            self.assertEqual(content(fixture.path("session.json")).decode(), text)
            for again in (Session.load(fixture.model(), fixture.path("session.json")), Session.read(fixture.model(), text),
                          Session.read(fixture.model(), text.encode())):
                with again as (features, segmentation):
                    self.assertEqual(fixture.dump(segmentation)[:8], fixture.dump(s)[:8])
                    self.assertEqual(features.points(), fixture.features().points())
                self.assertTrue(features.closed and segmentation.closed)

    def test_times_and_memory(self):
        self.assertGreater(self.segmentation.prepare_times().factorise, 0)
        memory = self.segmentation.memory()
        self.assertGreaterEqual(memory.segmentation, memory.factor)
        self.assertEqual(memory.factor, memory.factor_whole)

    def test_options(self):
        options = toothseg.SegmentOptions(beta=.5, memory_limit=2**40, weights=toothseg.Weights.UNIFORM)
        self.assertEqual((options.preset, options.beta, options.memory_limit, options.weights, options.alpha),
                         (toothseg.Preset.DEFAULT, .5, 2**40, toothseg.Weights.UNIFORM, 1e8))
        paper = toothseg.SegmentOptions(toothseg.Preset.PAPER)
        self.assertEqual((paper.beta, paper.reject_outliers, paper.cut_rule), (.01, False, toothseg.CutRule.GRADIENT))
        self.assertIn("beta=0.01", repr(paper))
        self.assertEqual(toothseg.FeatureOptions(occlusal=(0, 0, 1)).occlusal, (0, 0, 1))
        self.assertEqual(toothseg.FeatureOptions().max_points, 8)
        self.assertEqual(toothseg.IntakeOptions().unit, toothseg.Unit.CHECKED_MM)
        self.assertRaises(TypeError, toothseg.SegmentOptions, betta=1)
        self.assertRaises(AttributeError, setattr, options, "betta", 1)
        self.assertRaises(AttributeError, setattr, options, "preset", toothseg.Preset.PAPER)
        for value in (-1, 2**32, 2**32 + 5):
            self.assertRaises(ValueError, toothseg.SegmentOptions, contours=value)
        self.assertRaises(TypeError, toothseg.SegmentOptions, contours=1.5)
        with toothseg.Segmentation(fixture.features(), paper) as segmentation:
            segmentation.click(segmentation.propose_clicks()[0])
            self.assertEqual(segmentation.histogram(0).sum(), fixture.model().report().vertices)
        inches = Model.load(fixture.context(), fixture.arch(), toothseg.IntakeOptions(unit=toothseg.Unit.CM))
        self.assertAlmostEqual(inches.report().diagonal, 10 * fixture.model().report().diagonal, 3)
        inches.close()
