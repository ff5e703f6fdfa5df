#!/usr/bin/env python3
"""Tests of the command line tool: test_ts_segment.py TS_SEGMENT MAKE_ARCH [unittest arguments]

SPDX-License-Identifier: Apache-2.0
"""
import atexit
import functools
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

TOOL = MAKE_ARCH = None
OUTPUTS = {"--labels": "l.txt", "--cuts": "c.obj", "--ply": "m.ply", "--report": "r.json", "--features": "f.json"}


class Scan:
    """A synthetic arch as files that stay as they are."""

    def __init__(self):
        folder = tempfile.mkdtemp()
        atexit.register(shutil.rmtree, folder)
        self.stl = os.path.join(folder, "arch.stl")
        self.ply = os.path.join(folder, "arch.ply")
        self.truth = os.path.join(folder, "truth.txt")
        for path in (self.stl, self.ply):
            subprocess.run([MAKE_ARCH, path, "--triangles", "12000", "--labels", self.truth],
                           check=True, stdout=subprocess.DEVNULL)
        with open(self.truth) as f:
            self.labels = [int(line) for line in f]
        self.faces = len(self.labels)
        self.teeth = len(set(self.labels) - {0})


@functools.cache
def scan_of_all():
    return Scan()


class ToolTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scan = scan_of_all()

    def setUp(self):
        self.folder = tempfile.mkdtemp()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w") as f:
            f.write(text)
        return self.path(name)

    def outputs(self):
        return [x for option, name in OUTPUTS.items() for x in (option, self.path(name))]

    def run_tool(self, *arguments):
        return subprocess.run([TOOL, *arguments], capture_output=True, text=True, cwd=self.folder, timeout=300)

    def load(self, name):
        with open(self.path(name)) as f:
            return json.load(f)

    def refused(self, *arguments, says):
        """Exit 2, one line on stderr that says what and where, nothing on stdout, no file."""
        before = sorted(os.listdir(self.folder))
        done = self.run_tool(*arguments)
        self.assertEqual(done.returncode, 2, done)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("ts-segment: "), done.stderr)
        for word in [says] if isinstance(says, str) else says:
            self.assertIn(word, done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before)


class Usage(ToolTest):
    def test_help_and_version(self):
        done = self.run_tool("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for option in [*OUTPUTS, "--clicks", "--auto", "--preset", "--unit", "--threads", "--help", "--version"]:
            self.assertIn(option, done.stdout)
        done = self.run_tool("--version")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^ts-segment \d+\.\d+\.\d+\n$")

    def test_bad_command_lines(self):
        scan = self.scan.stl
        self.refused(says="no scan")
        self.refused("", says="no scan")
        self.refused(scan, "--frobnicate", says="--frobnicate")
        self.refused(scan, "-x", says="-x")
        self.refused(scan, scan, says="second scan")
        self.refused(scan, "--labels", says="--labels")
        self.refused(scan, "--labels", "", says="--labels")
        self.refused(scan, "--preset", "best", says=["--preset", "best"])
        self.refused(scan, "--unit", "furlong", says=["--unit", "furlong"])
        for threads in ("-1", "1025", "many", "2x", "99999999999999999999"):
            self.refused(scan, "--threads", threads, says=["--threads", threads])
        self.refused(scan, "--jaw", "left", says=["--jaw", "left"])
        self.refused(scan, "--jaw", says="--jaw")
        clicks = self.write("clicks.txt", "0 0 0\n")
        self.refused(scan, "--auto", "--clicks", clicks, says="--auto")


class BadInput(ToolTest):
    def test_scan(self):
        self.refused(self.path("none.stl"), *self.outputs(), says=["none.stl", "TS_E_FILE_OPEN"])
        self.refused(self.folder, *self.outputs(), says="TS_E_FILE_OPEN")
        self.refused("two\nlines.stl", says="lines.stl")
        self.refused(self.write("prose.stl", "no mesh at all"), *self.outputs(), says=["prose.stl", "TS_E_FILE_FORMAT"])
        with open(self.scan.stl, "rb") as f:
            whole = f.read()
        with open(self.path("cut.stl"), "wb") as f:
            f.write(whole[:len(whole) // 2])
        self.refused(self.path("cut.stl"), *self.outputs(), says=["cut.stl", "TS_E_FILE_TRUNCATED"])

    def test_no_teeth(self):
        plane = ["OFF", "441 800 0"]
        plane += [f"{2 * x} {2 * y} 0" for y in range(21) for x in range(21)]
        for y in range(20):
            for x in range(20):
                a = 21 * y + x
                plane += [f"3 {a} {a + 1} {a + 22}", f"3 {a} {a + 22} {a + 21}"]
        scan = self.write("plane.off", "\n".join(plane) + "\n")
        self.refused(scan, *self.outputs(), says=["plane.off", "TS_E_NO_TEETH"])
        self.refused(scan, "--unit", "inch", *self.outputs(), says="plane.off")

    def test_units(self):
        done = subprocess.run([MAKE_ARCH, self.path("mm.obj"), "--triangles", "6000"], stdout=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0)
        with open(self.path("mm.obj")) as f, open(self.path("m.obj"), "w") as out:
            for line in f:
                if line.startswith("v "):
                    line = "v " + " ".join(f"{float(x) / 1000:.9g}" for x in line.split()[1:4]) + "\n"
                out.write(line)
        self.refused(self.path("m.obj"), says="TS_E_MESH_UNITS")
        done = self.run_tool("m.obj", "--unit", "m", "--report", "r.json", "--cuts", "c.obj")
        self.assertEqual(done.returncode, 0, done)
        self.assertGreater(self.load("r.json")["intake"]["diagonal"], 30)
        with open(self.path("c.obj")) as f:
            reach = max(abs(float(x)) for line in f if line.startswith("v ") for x in line.split()[1:])
        self.assertGreater(reach, 10)  # mm come out

    def test_clicks_file(self):
        scan = self.scan.stl
        self.refused(scan, "--clicks", self.path("none.txt"), *self.outputs(), says="none.txt")
        self.refused(scan, "--clicks", self.write("empty.txt", "# nothing\n\n"), *self.outputs(), says="empty.txt")
        bad = {"1 2": ":3:", "1 two 3": ":3:", "nan 0 0": ":3:", "1 2 inf": ":3:", "1,2,3": ":3:", "1 2 3x": ":3:"}
        for line, where in bad.items():
            clicks = self.write("bad.txt", "# clicks\n1 2 3\n" + line + "\n4 5 6\n")
            self.refused(scan, "--clicks", clicks, *self.outputs(), says="bad.txt" + where)


class BadOutput(ToolTest):
    def test_places_that_cannot_be_written(self):
        scan = self.scan.stl
        self.refused(scan, "--labels", self.path("none/l.txt"), says="none/l.txt")
        self.refused(scan, "--labels", self.path("l.txt"), "--report", self.path("none/r.json"), says="none/r.json")
        os.mkdir(self.path("folder"))
        self.refused(scan, "--labels", self.path("folder"), says="folder")
        self.refused(scan, "--labels", "/dev/null", says="/dev/null")

    def test_two_outputs_in_one_place(self):
        scan = self.scan.stl
        self.refused(scan, "--labels", "o.txt", "--cuts", "o.txt", says="o.txt")
        self.refused(scan, "--labels", "o.txt", "--cuts", "./o.txt", says="o.txt")
        shutil.copy(scan, self.path("scan.stl"))
        self.refused("scan.stl", "--ply", "./scan.stl", says="scan.stl")

    def test_what_was_there_stays_when_nothing_is_written(self):
        for name in OUTPUTS.values():
            self.write(name, "old " + name)
        with open(self.scan.stl, "rb") as f:
            half = f.read()[:5000]
        with open(self.path("cut.stl"), "wb") as f:
            f.write(half)
        self.refused("cut.stl", *self.outputs(), says="cut.stl")
        for name in OUTPUTS.values():
            with open(self.path(name)) as f:
                self.assertEqual(f.read(), "old " + name)

    @unittest.skipUnless(os.path.exists("/bin/sh"), "needs a shell with ulimit")
    def test_a_disk_that_fills_up(self):
        # A limit on the size of files stands in for the full disk: the larger outputs hit it, the smaller do not.
        for name in OUTPUTS.values():
            self.write(name, "old " + name)
        before = sorted(os.listdir(self.folder))
        done = subprocess.run(["sh", "-c", 'trap "" XFSZ; ulimit -f 100; exec "$@"', "sh", TOOL, self.scan.stl,
                               *self.outputs()], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 2, done)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertRegex(done.stderr, r"(c\.obj|m\.ply): cannot be written")
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        for name in OUTPUTS.values():
            with open(self.path(name)) as f:
                self.assertEqual(f.read(), "old " + name)


class Teeth(ToolTest):
    def triangles(self, path):
        with open(path, "rb") as f:
            data = f.read()
        count = struct.unpack_from("<I", data, 80)[0]
        self.assertEqual(len(data), 84 + 50 * count)
        return [struct.unpack_from("<9f", data, 84 + 50 * i + 12) for i in range(count)]

    def test_a_file_a_tooth(self):
        done = self.run_tool(self.scan.stl, "--teeth", "teeth", "--closed", "--report", "r.json")
        self.assertEqual(done.returncode, 0, done)
        teeth = self.load("r.json")["counts"]["teeth"]
        names = {f"tooth_{k}.stl" for k in range(1, teeth + 1)} | {"gingiva.stl"}
        self.assertEqual(set(os.listdir(self.path("teeth"))), names)
        for name in names:
            sides = {}
            for t in self.triangles(os.path.join(self.path("teeth"), name)):
                corners = [t[0:3], t[3:6], t[6:9]]
                for k in range(3):
                    a, b = corners[k], corners[(k + 1) % 3]
                    sides[a, b] = sides.get((a, b), 0) + 1
            self.assertTrue(all(n == sides.get((b, a)) for (a, b), n in sides.items()), name)

    def test_refused(self):
        self.refused(self.scan.stl, "--closed", says="--closed")
        self.refused(self.scan.stl, "--teeth", self.path("none/teeth"), says="none/teeth")
        self.write("file", "no directory")
        self.refused(self.scan.stl, "--teeth", self.path("file"), says="file")

    @unittest.skipUnless(os.path.exists("/bin/sh"), "needs a shell with ulimit")
    def test_a_disk_that_fills_up(self):
        before = sorted(os.listdir(self.folder))
        done = subprocess.run(["sh", "-c", 'trap "" XFSZ; ulimit -f 100; exec "$@"', "sh", TOOL, self.scan.stl,
                               "--teeth", self.path("teeth")], capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 2, done)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("cannot be written", done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before)


def read_ply(path):
    with open(path, "rb") as f:
        data = f.read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode().splitlines()
    count = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element ")}
    xyz = [struct.unpack_from("<3f", data, end + 12 * i) for i in range(count["vertex"])]
    at = end + 12 * count["vertex"]
    faces = [struct.unpack_from("<BiiiBBBi", data, at + 20 * i) for i in range(count["face"])]
    assert at + 20 * count["face"] == len(data)
    return header, xyz, faces


class Results(ToolTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.out = tempfile.mkdtemp()
        cls.done = subprocess.run([TOOL, cls.scan.stl, "--threads", "1", *cls.all_outputs()], capture_output=True,
                                 text=True, timeout=300)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.out)
        super().tearDownClass()

    @classmethod
    def all_outputs(cls):
        return [x for option, name in OUTPUTS.items() for x in (option, os.path.join(cls.out, name))]

    def result(self, name):
        with open(os.path.join(self.out, name)) as f:
            return json.load(f) if name.endswith(".json") else f.read()

    def teeth(self):
        return self.result("r.json")["counts"]["teeth"]

    def labels(self):
        return [int(x) for x in self.result("l.txt").split("\n")[:-1]]

    def test_run(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""), self.done)
        self.assertEqual(sorted(os.listdir(self.out)), sorted(OUTPUTS.values()))
        # How many teeth are found is not the matter of these tests; that it is an arch's number is.
        self.assertTrue(self.scan.teeth * 3 / 4 <= self.teeth() <= self.scan.teeth + 1)
        self.assertIn(f"{self.teeth()} teeth", self.done.stdout)

    def test_labels(self):
        labels = self.labels()
        self.assertEqual(len(labels), self.scan.faces)
        self.assertEqual(set(labels), set(range(self.teeth() + 1)))
        agree = {}
        for mine, truth in zip(labels, self.scan.labels):
            agree[mine, truth] = agree.get((mine, truth), 0) + 1
        right = sum(max(n for (mine, truth), n in agree.items() if mine == m) for m in set(labels))
        self.assertGreater(right / len(labels), 0.8)

    def test_report(self):
        report = self.result("r.json")
        self.assertEqual(report["scan"], self.scan.stl)
        self.assertEqual(report["preset"], "default")
        self.assertEqual(report["intake"]["input_faces"], self.scan.faces)
        self.assertAlmostEqual(math.hypot(*report["occlusal"]), 1)
        self.assertEqual(report["counts"], {"teeth": self.teeth(), "clicks": len(report["clicks"]), "failed_clicks": 0})
        self.assertIn(len(report["clicks"]), (self.teeth() // 2, self.teeth() // 2 + 1))
        self.assertEqual([t["label"] for t in report["teeth"]], list(range(1, self.teeth() + 1)))
        for click in report["clicks"]:
            self.assertEqual(click["status"], "TS_OK")
            pair = {click["target"]["label"], click["neighbour"]["label"]}
            self.assertEqual(max(pair) - min(pair), 1)
            for side in ("target", "neighbour"):
                self.assertTrue(0 < click[side]["iso"] < 1)
                self.assertTrue(5 < click[side]["cut_length"] < 100)
            self.assertEqual(set(click["ms"]), {"pick", "field", "cut", "label", "total"})
        labels = self.labels()
        for tooth in report["teeth"]:
            self.assertEqual(tooth["faces"], labels.count(tooth["label"]))
            self.assertGreater(tooth["area"], 10)
            self.assertIsInstance(tooth["warnings"], list)
            self.assertTrue(all(loop["closed"] for loop in tooth["cut"]))
        self.assertGreater(report["ms"]["total"], 0)

    def test_cuts(self):
        report, vertices, objects = self.result("r.json"), [], {}
        for line in self.result("c.obj").splitlines():
            word, *rest = line.split()
            if word == "o":
                name = rest[0]
                objects[name] = []
            elif word == "v":
                vertices.append(tuple(map(float, rest)))
            elif word == "l":
                objects[name].append([int(i) for i in rest])
        self.assertEqual(list(objects), [f"tooth_{t['label']}" for t in report["teeth"]])
        used = [i for loops in objects.values() for loop in loops for i in loop[:-1]]
        self.assertEqual(used, list(range(1, len(vertices) + 1)))
        for tooth in report["teeth"]:
            loops = objects[f"tooth_{tooth['label']}"]
            self.assertEqual(len(loops), len(tooth["cut"]))
            for loop, cut in zip(loops, tooth["cut"]):
                self.assertEqual(loop[0], loop[-1])
                self.assertEqual(len(loop) - 1, cut["points"])
                length = sum(math.dist(vertices[a - 1], vertices[b - 1]) for a, b in zip(loop, loop[1:]))
                self.assertAlmostEqual(length, cut["length"], delta=1e-3)

    def test_ply(self):
        header, xyz, faces = read_ply(os.path.join(self.out, "m.ply"))
        self.assertIn("format binary_little_endian 1.0", header)
        report, labels = self.result("r.json"), self.labels()
        self.assertEqual((len(xyz), len(faces)), (report["intake"]["vertices"], report["intake"]["faces"]))
        self.assertTrue(all(n == 3 and max(a, b, c) < len(xyz) and min(a, b, c) >= 0 for n, a, b, c, *_ in faces))
        colours = {}
        for *_, red, green, blue, label in faces:
            colours.setdefault(label, set()).add((red, green, blue))
        self.assertEqual(set(colours), set(labels))
        self.assertTrue(all(len(c) == 1 for c in colours.values()))
        self.assertEqual(len(set.union(*colours.values())), len(colours))
        self.assertEqual([f[-1] for f in faces], labels)  # intake of a clean arch drops and moves nothing

    def test_features(self):
        features = self.result("f.json")
        self.assertEqual(len(features["groups"]), self.teeth())
        self.assertTrue(all(len(p) == 3 for p in features["arch"]))
        for before, after in zip(features["groups"], features["groups"][1:]):
            self.assertEqual((before["next"], after["previous"]), (after["id"], before["id"]))
        self.assertIsNone(features["groups"][0]["previous"])
        self.assertTrue(all(g["points"] for g in features["groups"]))

    def test_threads_do_not_matter(self):
        for threads in ("2", "8"):
            done = self.run_tool(self.scan.stl, "--threads", threads, *self.outputs())
            self.assertEqual((done.returncode, done.stderr), (0, ""), done)
            for name in OUTPUTS.values():
                with open(os.path.join(self.out, name), "rb") as a, open(self.path(name), "rb") as b:
                    if name != "r.json":
                        self.assertEqual(a.read(), b.read(), name)
            mine, other = self.result("r.json"), self.load("r.json")
            for report in (mine, other):
                del report["ms"], report["threads"]
                for click in report["clicks"]:
                    del click["ms"]
            self.assertEqual(mine, other)

    def test_formats_do_not_matter(self):
        done = self.run_tool(self.scan.ply, "--labels", "l.txt")
        self.assertEqual(done.returncode, 0, done)
        with open(self.path("l.txt")) as f:
            self.assertEqual(f.read(), self.result("l.txt"))

    def test_paper_preset(self):
        done = self.run_tool(self.scan.stl, "--preset", "paper", "--report", "r.json", "--labels", "l.txt")
        self.assertIn(done.returncode, (0, 1), done)
        self.assertEqual(self.load("r.json")["preset"], "paper")
        self.assertEqual(done.returncode, 1 if self.load("r.json")["counts"]["failed_clicks"] else 0)


class Numbers(ToolTest):
    def test_fdi(self):
        done = self.run_tool(self.scan.ply, "--fdi", "--jaw", "upper", "--labels", "l.txt", "--report", "r.json")
        self.assertEqual(done.returncode, 0, done)
        report = self.load("r.json")
        self.assertEqual((report["jaw"], report["jaw_confidence"]), ("upper", 1))
        with open(self.path("l.txt")) as f:
            labels = [int(x) for x in f]
        self.assertEqual(set(labels), {t["fdi"] for t in report["teeth"]} | {0})
        agree = sum(a == b for a, b in zip(labels, self.scan.labels) if b)
        self.assertGreater(agree, 0.8 * sum(b > 0 for b in self.scan.labels))
        # A complaint for each that is uncertain, and for nothing else.
        unsure = [t for t in report["teeth"] if t["fdi_confidence"] < 0.9]
        self.assertEqual(done.stderr.count("is uncertain"), len(unsure))
        self.assertEqual(done.stderr.count("\n"), len(unsure))
        other = self.run_tool(self.scan.ply, "--fdi", "--labels", "e.txt", "--report", "e.json")
        self.assertEqual(other.returncode, 0, other)
        self.assertEqual(self.load("e.json")["jaw"], "upper")
        self.assertTrue(0.9 <= self.load("e.json")["jaw_confidence"] < 1)

    def test_without_numbers_the_report_has_none(self):
        self.run_tool(self.scan.ply, "--report", "r.json")
        self.assertNotIn("jaw", self.load("r.json"))
        self.assertNotIn("fdi", self.load("r.json")["teeth"][0])

    def test_json3dts(self):
        # The scan with a vertex that no face uses, and each face with corners of its own: the labels are of the file's.
        vertices, faces = [], []
        subprocess.run([MAKE_ARCH, self.path("p7_upper.obj"), "--triangles", "12000"], check=True, stdout=subprocess.DEVNULL)
        with open(self.path("p7_upper.obj")) as f:
            for line in f:
                if line.startswith("v "):
                    vertices.append(line)
                elif line.startswith("f "):
                    faces.append([int(x) for x in line.split()[1:]])
        with open(self.path("p7_upper.obj"), "a") as f:
            f.write("v 1 2 3\n")
        done = self.run_tool("p7_upper.obj", "--jaw", "upper", "--fdi", "--labels", "l.txt", "--json3dts", "out.json")
        self.assertEqual(done.returncode, 0, done)
        out = self.load("out.json")
        self.assertEqual(list(out), ["id_patient", "jaw", "labels", "instances"])
        self.assertEqual((out["id_patient"], out["jaw"]), ("p7", "upper"))
        self.assertEqual(len(out["labels"]), len(vertices) + 1)
        self.assertEqual((len(out["instances"]), out["labels"][-1], out["instances"][-1]), (len(vertices) + 1, 0, 0))
        self.assertEqual(len(set(zip(out["labels"], out["instances"]))), len(set(out["labels"])))
        with open(self.path("l.txt")) as f:
            of_face = [int(x) for x in f]
        votes = [{} for _ in vertices]
        for face, label in zip(faces, of_face):
            for v in face:
                votes[v - 1][label] = votes[v - 1].get(label, 0) + 1
        for label, own in zip(out["labels"], votes):
            self.assertEqual(own[label], max(own.values()))
            if label == 0:
                self.assertTrue(all(n < own[0] for other, n in own.items() if other))
        self.refused("p7_upper.obj", "--json3dts", self.path("none/o.json"), says="none/o.json")

    def test_a_jaw_that_is_given_decides(self):
        done = self.run_tool(self.scan.ply, "--jaw", "lower", "--fdi", "--labels", "l.txt")
        self.assertEqual(done.returncode, 0)
        with open(self.path("l.txt")) as f:
            self.assertTrue(all(int(x) == 0 or int(x) > 30 for x in f))

    def test_a_jaw_that_cannot_be_told_is_not_written(self):
        # Canines are as wide in either jaw.
        missing = ",".join(str(q + p) for q in (10, 20) for p in (1, 2, 4, 5, 6, 7))
        subprocess.run([MAKE_ARCH, self.path("few.ply"), "--triangles", "12000", "--missing", missing], check=True,
                       stdout=subprocess.DEVNULL)
        self.refused("few.ply", "--fdi", *self.outputs(), says=["few.ply", "jaw", "--jaw"])
        self.refused("few.ply", "--json3dts", self.path("o.json"), says=["few.ply", "jaw", "--jaw"])
        done = self.run_tool("few.ply", "--fdi", "--jaw", "upper", "--labels", "l.txt")
        self.assertEqual(done.returncode, 0, done)
        with open(self.path("l.txt")) as f:
            self.assertEqual({int(x) for x in f}, {0, 13, 23})


class Session(ToolTest):
    def test_what_was_done_is_there_again(self):
        done = self.run_tool(self.scan.ply, "--session", "s.json", "--labels", "a.txt")
        self.assertEqual(done.returncode, 0, done)
        self.assertEqual(self.load("s.json")["toothseg_session"], 1)
        again = self.run_tool(self.scan.ply, "--session", "s.json", "--labels", "b.txt")
        self.assertEqual(again.returncode, 0, again)
        self.assertIn(" from 0 clicks", again.stdout)
        with open(self.path("a.txt")) as a, open(self.path("b.txt")) as b:
            self.assertEqual(a.read(), b.read())

    def test_a_session_that_is_none_is_refused_and_stays(self):
        with open(self.path("s.json"), "w") as f:
            f.write("{}")
        done = self.run_tool(self.scan.ply, "--session", "s.json", "--labels", "l.txt")
        self.assertEqual(done.returncode, 2, done)
        self.assertIn("TS_E_FILE_FORMAT", done.stderr)
        self.assertFalse(os.path.exists(self.path("l.txt")))
        with open(self.path("s.json")) as f:
            self.assertEqual(f.read(), "{}")

    def test_teeth_are_named_by_their_numbers(self):
        done = self.run_tool(self.scan.ply, "--jaw", "upper", "--fdi", "--teeth", "teeth", "--report", "r.json")
        self.assertEqual(done.returncode, 0, done)
        wanted = {"tooth_%d.stl" % t["fdi"] for t in self.load("r.json")["teeth"]}
        self.assertEqual(set(os.listdir(self.path("teeth"))), wanted | {"gingiva.stl"})


class Clicks(ToolTest):
    def test_from_a_file(self):
        auto = self.run_tool(self.scan.stl, "--auto", "--report", "auto.json", "--labels", "auto.txt")
        self.assertEqual(auto.returncode, 0, auto)
        lines = ["# x y z and more", "", "   "]
        for i, click in enumerate(self.load("auto.json")["clicks"]):
            lines.append("\t".join(repr(x) for x in click["position"]) + f" tooth {i} " + "x" * 3000 * (i % 2))
        clicks = self.write("clicks.txt", "\r\n".join(lines))
        done = self.run_tool(self.scan.stl, "--clicks", clicks, "--report", "file.json", "--labels", "file.txt")
        self.assertEqual(done.returncode, 0, done)
        a, b = self.load("auto.json"), self.load("file.json")
        self.assertEqual([c["line"] for c in b["clicks"]], list(range(4, 4 + len(a["clicks"]))))
        self.assertEqual([c["position"] for c in a["clicks"]], [c["position"] for c in b["clicks"]])
        with open(self.path("auto.txt")) as x, open(self.path("file.txt")) as y:
            self.assertEqual(x.read(), y.read())

    def test_a_click_that_fails(self):
        self.run_tool(self.scan.stl, "--report", "auto.json")
        good = " ".join(map(repr, self.load("auto.json")["clicks"][0]["position"]))
        clicks = self.write("clicks.txt", f"1000 0 0\n{good}\n")
        done = self.run_tool(self.scan.stl, "--clicks", clicks, *self.outputs())
        self.assertEqual(done.returncode, 1, done)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("clicks.txt:1:", done.stderr)
        self.assertIn("TS_E_CLICK_OFF_SURFACE", done.stderr)
        report = self.load("r.json")
        self.assertEqual(report["counts"], {"teeth": 2, "clicks": 2, "failed_clicks": 1})
        bad, stood = report["clicks"]
        self.assertEqual((bad["status"], stood["status"]), ("TS_E_CLICK_OFF_SURFACE", "TS_OK"))
        self.assertTrue(bad["message"])
        self.assertNotIn("target", bad)
        with open(self.path("l.txt")) as f:
            self.assertEqual(len(set(f.read().split())), 3)

    def test_names_with_odd_characters(self):
        name = 'a "scan"\\ \u00e4\t1.stl'
        shutil.copy(self.scan.stl, self.path(name))
        done = self.run_tool(name, "--report", "r.json")
        self.assertEqual(done.returncode, 0, done)
        self.assertEqual(self.load("r.json")["scan"], name)

    def test_outputs_replace_what_was_there(self):
        for name in OUTPUTS.values():
            self.write(name, "old " * 100000)
        done = self.run_tool(self.scan.stl, *self.outputs())
        self.assertEqual(done.returncode, 0, done)
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(OUTPUTS.values()))
        for name in OUTPUTS.values():
            with open(self.path(name), "rb") as f:
                self.assertNotIn(b"old old", f.read(), name)
        self.load("r.json")


def read_stl(path):
    """Vertices, welded, and faces of a binary STL."""
    with open(path, "rb") as f:
        data = f.read()
    place, faces = {}, []
    for k in range(struct.unpack_from("<I", data, 80)[0]):
        xyz = struct.unpack_from("<9f", data, 84 + 50 * k + 12)
        faces.append([place.setdefault(xyz[3 * c:3 * c + 3], len(place)) for c in range(3)])
    return list(place), faces


class Pieces(ToolTest):
    """Parts of an arch, two arches in one file, faces the wrong way round: a result that holds, or a status."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.vertices, cls.faces = read_stl(cls.scan.stl)

    def segment(self, faces, truth, vertices=None, status=(0,)):
        """Teeth of the truth that a label of the tool covers for the most part, wrong labels, report."""
        with open(self.path("piece.off"), "w") as out:
            vertices = vertices or self.vertices
            out.write("OFF\n%d %d 0\n" % (len(vertices), len(faces)))
            out.writelines("%.9g %.9g %.9g\n" % tuple(v) for v in vertices)
            out.writelines("3 %d %d %d\n" % tuple(f) for f in faces)
        done = self.run_tool(self.path("piece.off"), "--labels", self.path("l.txt"), "--report", self.path("r.json"))
        self.assertIn(done.returncode, status, done.stderr)
        if done.returncode == 2:
            return done.stderr
        with open(self.path("l.txt")) as f:
            labels = [int(line) for line in f]
        found, wrong = set(), 0
        for label in set(labels) - {0}:
            on = [t for l, t in zip(labels, truth) if l == label]
            tooth = max(set(on), key=on.count)
            if tooth and on.count(tooth) > 0.7 * max(len(on), truth.count(tooth)):
                found.add(tooth)
            else:
                wrong += 1
        return found, wrong, self.load("r.json")

    def keep(self, wanted):
        chosen = [k for k in range(len(self.faces)) if wanted(k)]
        return [self.faces[k] for k in chosen], [self.scan.labels[k] for k in chosen]

    def side(self, k):
        return sum(self.vertices[i][0] for i in self.faces[k])

    def test_half_an_arch(self):
        faces, truth = self.keep(lambda k: self.side(k) > 0)
        found, wrong, report = self.segment(faces, truth)
        self.assertEqual(report["warnings"], [])
        self.assertGreaterEqual(len(found), self.scan.teeth // 2 - 1)
        self.assertLessEqual(wrong, 1)

    def test_gingiva_alone(self):
        said = self.segment(*self.keep(lambda k: self.scan.labels[k] == 0), status=(2,))
        self.assertIn("TS_E_NO_TEETH", said)

    def test_one_crown_alone(self):
        molar = max(self.scan.labels)
        result = self.segment(*self.keep(lambda k: self.scan.labels[k] == molar), status=(0, 1, 2))
        if isinstance(result, str):
            self.assertIn("TS_E_NO_TEETH", result)
        else:
            self.assertLessEqual(len(result[0]) + result[1], 1)

    def test_inside_out_and_mirrored(self):
        back = [f[::-1] for f in self.faces]
        mirror = [(-x, y, z) for x, y, z in self.vertices]
        for faces, vertices, inside_out in (
                (back, self.vertices, True), (back, mirror, False), (self.faces, mirror, True)):
            found, wrong, report = self.segment(faces, self.scan.labels, vertices)
            self.assertEqual((len(found), wrong, report["inside_out"]), (self.scan.teeth, 0, inside_out))
            self.assertEqual(report["warnings"], ["inside_out"] if inside_out else [])

    def test_two_arches_side_by_side(self):
        width = max(v[0] for v in self.vertices) - min(v[0] for v in self.vertices)
        vertices = self.vertices + [(x + width + 10, y, z) for x, y, z in self.vertices]
        faces = self.faces + [[i + len(self.vertices) for i in f] for f in self.faces]
        truth = self.scan.labels + [t and t + 100 for t in self.scan.labels]
        found, wrong, report = self.segment(faces, truth, vertices, status=(0, 1))
        self.assertIn("several_arches", report["warnings"])
        self.assertGreaterEqual(len(found), self.scan.teeth // 2)  # one curve runs through part of both
        self.assertLessEqual(wrong, 2)  # where it crosses from one to the other


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    TOOL, MAKE_ARCH = (os.path.abspath(p) for p in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
