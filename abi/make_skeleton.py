#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A library of empty functions in C, with the interface of the real one and its defaults, to standard output.

    make_skeleton.py toothseg.json DEFAULTS     DEFAULTS: what the program of make_defaults.py prints
"""
import json
import re
import sys


def read_defaults(path):
    """(struct, variant or "") -> [(field, value)]"""
    out = {}
    with open(path, encoding="utf-8") as f:
        for line in f:
            struct, variant, field, value = re.fullmatch(r"(\w+)(?:\((\w+)\))?\.([\w\[\]]+) = (.*)\n", line).groups()
            out.setdefault((struct, variant or ""), []).append((field, value))
    return out


def declaration(t, name):
    """`t name` in C; an array's length stands behind the name."""
    spelling, _, length = t["spelling"].partition("[")
    return f"{spelling} {name}" + (f"[{length}" if length else "")


def filling(struct, defaults):
    """An init function's body; what is a default of no field is left out."""
    fields = {f["name"] for f in struct["fields"]}
    lines = ["  memset(p0, 0, sizeof *p0);", "  p0->struct_size = p1;"]
    for (name, variant), values in defaults.items():
        condition = f"if (p2 == {variant}) " if variant else ""
        lines += [f"  {condition}p0->{field} = {value};" for field, value in values
                  if name == struct["name"] and field.partition("[")[0] in fields]
    return lines


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as f:
        data = json.load(f)
    defaults = read_defaults(sys.argv[2])
    initialised = {s["init"]: s for s in data["structs"] if "init" in s}
    out = ["#include <string.h>", "", '#include "toothseg.h"', ""]
    for f in data["functions"]:
        arguments = ", ".join(declaration(a["type"], f"p{i}") for i, a in enumerate(f["arguments"])) or "void"
        out.append(f"{declaration(f['returns'], f['name'])}({arguments}) {{")
        if f["name"] in initialised:
            out += filling(initialised[f["name"]], defaults)
        else:
            out += [f"  (void)p{i};" for i in range(len(f["arguments"]))]
        if f["returns"]["kind"] != "void" or f["returns"].get("pointer"):
            out.append("  return 0;")
        out += ["}", ""]
    print("\n".join(out))


if __name__ == "__main__":
    main()
