#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""compare.py on descriptions that differ in one thing: test_compare.py prints a line a rule."""
import contextlib
import copy
import io
import os
import sys

ABI = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, ABI)
import compare  # noqa: E402



def find(items, name):
    return next(i for i in items if i["name"] == name)


def drop(items, name):
    items.remove(find(items, name))


def grow(struct, name, base, size):
    """A field at the end."""
    struct["fields"].append({"name": name, "type": {"base": base, "kind": "scalar", "spelling": base}})
    for layout in struct["layout"].values():
        layout["offsets"][name] = layout["size"]
        layout["size"] += size


def rules(d):
    """(what is said, the change that has it said); "" for what nothing is said of."""

    def enum(name):
        return find(d["enums"], name)

    def struct(name):
        return find(d["structs"], name)

    def function(name):
        return find(d["functions"], name)

    def value(e, name, number):
        enum(e)["values"].insert(0, {"name": name, "value": number})

    return [
        ("", lambda: function("ts_undo").update(doc="other words")),
        ("BREAK: constant TS_NONE is gone", lambda: drop(d["constants"], "TS_NONE")),
        (f"BREAK: the header's version was {d['version']} and is 0.0.9", lambda: d.update(version="0.0.9")),
        (f"BREAK: the header's version was {d['version']} and is 99.0.0", lambda: d.update(version="99.0.0")),
        ("allowed: constant TS_MORE is new", lambda: d["constants"].append({"name": "TS_MORE", "value": 1})),
        ("BREAK: enum ts_jaw is gone", lambda: drop(d["enums"], "ts_jaw")),
        ("BREAK: ts_jaw: TS_JAW_LOWER is gone", lambda: drop(enum("ts_jaw")["values"], "TS_JAW_LOWER")),
        ("BREAK: ts_jaw: TS_JAW_MORE = 1 is new among the old values", lambda: value("ts_jaw", "TS_JAW_MORE", 1)),
        ("BREAK: ts_status: TS_E_MORE = 105 is new among the old values", lambda: value("ts_status", "TS_E_MORE", 105)),
        ("allowed: ts_status: TS_E_MORE = 800 is new", lambda: value("ts_status", "TS_E_MORE", 800)),
        ("BREAK: handle ts_mesh is gone", lambda: drop(d["handles"], "ts_mesh")),
        ("BREAK: callback ts_log_fn is gone", lambda: drop(d["callbacks"], "ts_log_fn")),
        ("BREAK: struct ts_palmer is gone", lambda: drop(d["structs"], "ts_palmer")),
        ("BREAK: ts_palmer::letters is gone, moved or renamed", lambda: drop(struct("ts_palmer")["fields"], "letters")),
        ("BREAK: ts_overlap (wasm32): area was at byte 16 and is at 12",
         lambda: struct("ts_overlap")["layout"]["wasm32"]["offsets"].update(area=12)),
        ("BREAK: ts_overlap (llp64): alignment was 8 and is 16", lambda: struct("ts_overlap")["layout"]["llp64"].update(align=16)),
        ("BREAK: ts_overlap (lp64): it had 24 bytes and has 16", lambda: struct("ts_overlap")["layout"]["lp64"].update(size=16)),
        ("BREAK: ts_overlap grew by more, and has no struct_size", lambda: grow(struct("ts_overlap"), "more", "double", 8)),
        ("BREAK: ts_save_options was initialised by ts_save_options_init, now by None", lambda: struct("ts_save_options").pop("init")),
        ("allowed: ts_jaw_info grew by more", lambda: grow(struct("ts_jaw_info"), "more", "double", 8)),
        ("BREAK: function ts_undo is gone", lambda: drop(d["functions"], "ts_undo")),
        ("BREAK: function ts_undo has arguments of other names: session",
         lambda: function("ts_undo")["arguments"][0].update(name="session")),
        ("BREAK: function ts_undo was ts_status (ts_segmentation *) and is void (ts_segmentation *)",
         lambda: function("ts_undo")["returns"].update(spelling="void")),
    ]


def main():
    old = compare.load(os.path.join(ABI, "toothseg.json"))
    failed = 0
    for i in range(len(rules(copy.deepcopy(old)))):
        new = copy.deepcopy(old)
        wanted, change = rules(new)[i]
        change()
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            report = compare.compare(old, new)
        first = said.getvalue().partition("\n")[0]
        well = first == wanted and (report.forbidden > 0) == wanted.startswith("BREAK")
        well = well and report.grown == (["ts_jaw_info"] if "ts_jaw_info grew" in wanted else [])
        failed += not well
        print(f"ok    {wanted or 'nothing to say'}" if well else f"FAIL  {wanted}\n      said: {said.getvalue()}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
