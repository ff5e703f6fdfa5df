# SPDX-License-Identifier: Apache-2.0
"""The low-level layer is what the JSON says, and the public layer leads to all of it."""
import ctypes
import json
import os
import re
import subprocess
import sys
import unittest

import fixture
import toothseg
from toothseg import _abi, errors, options, records

JSON = os.path.join(fixture.REPOSITORY, "abi", "toothseg.json")
GENERATOR = os.path.join(fixture.PYTHON, "generate.py")
with open(JSON, encoding="utf-8") as file:
    API = json.load(file)
STRUCTS = {s["name"]: s for s in API["structs"]}
LAYOUT = "llp64" if sys.platform == "win32" else "lp64"


def fields(struct):
    return {f["name"] for f in struct["fields"]} - {"struct_size", "reserved"}


def of_struct(kind, words):
    """The classes of a module by the struct that they stand for."""
    return {s: c for c in vars(kind).values() if isinstance(c, type) for s in [words(c)] if s in STRUCTS}


class Generated(unittest.TestCase):
    def test_check_is_content(self):
        subprocess.run([sys.executable, GENERATOR, "--check"], check=True)

    def test_check_sees_a_difference(self):
        other = fixture.path("other.py")
        with open(_abi.__file__, encoding="utf-8") as source, open(other, "w", encoding="utf-8") as out:
            out.write(source.read().replace("MESH_UNITS = 403", "MESH_UNITS = 404"))
        run = subprocess.run([sys.executable, GENERATOR, "--check", "-o", other], capture_output=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn(b"is not what", run.stderr)

    def test_the_installed_file_is_that_of_the_tree(self):
        with open(_abi.__file__, "rb") as installed, open(os.path.join(fixture.PYTHON, "toothseg", "_abi.py"), "rb") as tree:
            self.assertEqual(installed.read(), tree.read())

    def test_layouts(self):
        for name, struct in STRUCTS.items():
            layout, ours = struct["layout"][LAYOUT], getattr(_abi, name)
            with self.subTest(name):
                self.assertEqual(ctypes.sizeof(ours), layout["size"])
                self.assertEqual(ctypes.alignment(ours), layout["align"])
                self.assertEqual({n: getattr(ours, n).offset for n, _ in ours._fields_}, layout["offsets"])

    def test_all_of_it_is_there(self):
        self.assertEqual(set(_abi.FUNCTIONS), {f["name"] for f in API["functions"]})
        for f in API["functions"]:
            self.assertEqual(len(_abi.FUNCTIONS[f["name"]][1]), len(f["arguments"]), f["name"])
        for thing in API["handles"] + API["callbacks"]:
            self.assertTrue(hasattr(_abi, thing["name"]), thing["name"])
        self.assertEqual(_abi.VERSION, API["version"])
        self.assertEqual(_abi.NONE, next(c["value"] for c in API["constants"] if c["name"] == "TS_NONE"))

    def test_enum_values(self):
        for enum in API["enums"]:
            ours = getattr(_abi, "".join(w.capitalize() for w in enum["name"][3:].split("_")))
            there = {v["value"]: v["name"] for v in enum["values"] if not v["name"].endswith("_FORCE_INT")}
            self.assertEqual({int(m) for m in ours}, set(there), enum["name"])
            for member in ours:
                self.assertTrue(there[member.value].endswith(member.name), member)

    def test_names_of_statuses_are_the_librarys(self):
        for status in toothseg.Status:
            name = _abi_name(status)
            self.assertIn(name, {f"TS_{status.name}", f"TS_E_{status.name}"})

    def test_a_value_of_a_newer_library(self):
        status = toothseg.Status(899)
        self.assertEqual((status, status.name), (899, "UNKNOWN_899"))
        self.assertIs(errors.class_of(899), toothseg.Error)
        self.assertIs(errors.class_of(640), toothseg.SegmentationError)

    def test_the_api_grows(self):
        """A new enum, handle, callback, struct and function."""
        more = json.loads(json.dumps(API))
        scalar = {"base": "uint32_t", "kind": "scalar", "spelling": "uint32_t"}
        more["enums"].append({"name": "ts_colour", "doc": "", "values": [
            {"name": "TS_COLOUR_NONE", "value": 0, "doc": ""}, {"name": "TS_COLOUR_3D", "value": 1, "doc": "new \\ doc"},
            {"name": "TS_COLOUR_None", "value": 2, "doc": ""}, {"name": "TS_COLOUR_FORCE_INT", "value": 0x7fffffff, "doc": ""}]})
        more["handles"].append({"name": "ts_brush", "doc": "", "destroy": "ts_brush_destroy"})
        more["structs"].append({"name": "ts_stroke", "doc": "", "versioned": False, "layout": {}, "fields": [
            {"name": "from", "type": {"base": "ts_edge_point", "kind": "struct", "spelling": "", "length": 2}, "doc": ""},
            {"name": "call", "type": {"base": "ts_paint_fn", "kind": "callback", "spelling": ""}, "doc": ""},
            {"name": "colour", "type": {"base": "ts_colour", "kind": "enum", "spelling": ""}, "doc": ""},
            {"name": "names", "type": {"base": "char", "kind": "text", "const": True, "pointer": 1, "length": 3,
                                       "spelling": ""}, "doc": ""}]})
        more["callbacks"].append({"name": "ts_paint_fn", "doc": "", "returns": scalar, "arguments": [
            {"name": "stroke", "type": {"base": "ts_stroke", "kind": "struct", "pointer": 1, "const": True, "spelling": ""}}]})
        more["functions"].append({"name": "ts_paint", "doc": "", "since": "0.2.0", "threads": "any", "returns": scalar,
                                  "arguments": [{"name": "brush", "type": {"base": "ts_brush", "kind": "handle", "pointer": 2,
                                                                           "spelling": ""}}]})
        grown, out = fixture.path("grown.json"), fixture.path("grown.py")
        with open(grown, "w", encoding="utf-8") as f:
            json.dump(more, f)
        subprocess.run([sys.executable, GENERATOR, "--json", grown, "-o", out], check=True)
        names = {"__name__": "grown"}
        with open(out, encoding="utf-8") as f:
            exec(f.read(), names)
        self.assertEqual([m.name for m in names["Colour"]], ["NONE", "_3D", "_None"])
        self.assertEqual(ctypes.sizeof(names["ts_stroke"]), 2 * ctypes.sizeof(_abi.ts_edge_point) + 5 * 8)
        self.assertEqual(names["ts_paint_fn"](lambda stroke: stroke[0].colour)(names["ts_stroke"](colour=2)), 2)
        self.assertEqual(len(names["FUNCTIONS"]["ts_paint"][1]), 1)


def _abi_name(status):
    from toothseg._library import lib
    return lib.ts_status_name(status).decode()


class Public(unittest.TestCase):
    """A function, struct, field or block of statuses that has no place in the public layer is found here."""

    def test_functions(self):
        folder, text = os.path.dirname(toothseg.__file__), ""
        for name in os.listdir(folder):
            if name.endswith(".py") and name != "_abi.py":
                with open(os.path.join(folder, name), encoding="utf-8") as f:
                    text += f.read()
        used = set(re.findall(r"\b_?lib(?:rary)?\.(ts_\w+)", text))
        by_name = {h["destroy"] for h in API["handles"]} | {s["init"] for s in API["structs"] if "init" in s}
        self.assertEqual({f["name"] for f in API["functions"]} - by_name - used, set())

    def test_records(self):
        ours = of_struct(records, lambda c: (c.__doc__ or "").rstrip(".").rpartition(": ")[2])
        told = {s["name"] for s in API["structs"] if "init" not in s} - {"ts_edge_point"}  # which is a NumPy type
        self.assertEqual(set(ours), told)
        for name, record in ours.items():
            self.assertEqual({f.rstrip("_") for f in record.__dataclass_fields__}, fields(STRUCTS[name]), name)

    def test_options(self):
        ours = of_struct(options, lambda c: getattr(getattr(c, "_ctype", None), "__name__", ""))
        given = {s["name"] for s in API["structs"] if "init" in s}
        self.assertEqual(set(ours), given - {"ts_context_options", "ts_mesh_input"})  # made of a Context's, a Model's arguments
        for name, kind in ours.items():
            self.assertEqual({n for n in vars(kind) if not n.startswith("_")}, fields(STRUCTS[name]), name)

    def test_every_block_of_statuses_has_its_exception(self):
        for status in toothseg.Status:
            if status:
                self.assertIsNot(errors.class_of(status), toothseg.Error, status)

    def test_exports(self):
        self.assertEqual(toothseg.__version__, API["version"])
        public = {n for n, c in vars(_abi).items() if isinstance(c, type) and issubclass(c, int) and not n.startswith("_")}
        self.assertEqual(public - set(toothseg.__all__) - {"IntEnum", "IntFlag", "Enum", "Scalar"}, set())
        there = {n for n, c in vars(toothseg).items() if getattr(c, "__module__", "").startswith("toothseg.")}
        self.assertEqual(there - set(toothseg.__all__), set())
        self.assertTrue(all(hasattr(toothseg, n) for n in toothseg.__all__))
