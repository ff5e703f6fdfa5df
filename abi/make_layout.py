#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""abi/layout.c, made from abi/toothseg.json: a compiler that takes it lays the header out as the data say.

    make_layout.py                  write abi/layout.c
    make_layout.py --check          fail if that is not what the data say
    make_layout.py --json J -o F    other data, another file ("-": standard output)
    make_layout.py --released       for data of a release: structs behind struct_size may have grown since
"""
import argparse
import json
import os
import sys

ABI = os.path.dirname(os.path.abspath(__file__))
POINTERS = {"lp64": 8, "llp64": 8, "wasm32": 4}
MODELS = {"lp64": "defined(__LP64__)", "llp64": "defined(_WIN64)", "wasm32": "defined(__wasm32__)"}
HEAD = """/* Made by abi/make_layout.py: every constant, enum value, size and offset of toothseg.h. Compiled, not run: C99, C++17.
 * SPDX-License-Identifier: Apache-2.0 */
#include <stddef.h>

#include "toothseg.h"

/* Declared again and again, an array of one element; of -1 where the condition does not hold. */
#define HOLDS(condition) extern char holds[(condition) ? 1 : -1]
#define OFFSET(type, field, offset) HOLDS(offsetof(type, field) == (offset))
#define EXTENT(type, field, size) HOLDS(sizeof(((type *)0)->field) == (size))
#define ALIGN(type, align) \\
  struct type##_aligned { \\
    char before; \\
    type it; \\
  }; \\
  HOLDS(offsetof(struct type##_aligned, it) == (align))
"""


SCALARS = {"double": 8, "float": 4, "char": 1, "uint8_t": 1, "int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8}


def extent(field_type, model, structs):
    """Bytes of a field."""
    if field_type.get("pointer") or field_type["kind"] == "callback":
        size = POINTERS[model]
    elif field_type["kind"] == "struct":
        size = structs[field_type["base"]]["layout"][model]["size"]
    else:
        size = 4 if field_type["kind"] == "enum" else SCALARS[field_type["base"]]
    return size * field_type.get("length", 1)


def layout_lines(struct, model, released, structs):
    """What holds of a struct in a data model."""
    name, layout = struct["name"], struct["layout"][model]
    at_least = ">=" if released and struct["versioned"] else "=="
    lines = [f"HOLDS(sizeof({name}) {at_least} {layout['size']});", f"ALIGN({name}, {layout['align']});"]
    for field in struct["fields"]:
        lines.append(f"OFFSET({name}, {field['name']}, {layout['offsets'][field['name']]});")
        lines.append(f"EXTENT({name}, {field['name']}, {extent(field['type'], model, structs)});")
    return lines


def make(data, released):
    structs = {s["name"]: s for s in data["structs"]}
    lines = []
    for c in data["constants"]:
        if not (released and c["name"].startswith("TS_VERSION_")):
            lines.append(f"HOLDS({c['name']} == {c['value']}u);")
    for e in data["enums"]:
        lines.append("")
        lines.append(f"HOLDS(sizeof({e['name']}) == 4);")
        lines += [f"HOLDS((int){v['name']} == {v['value']});" for v in e["values"]]
    for s in data["structs"]:
        lines.append("")
        by_model = {model: layout_lines(s, model, released, structs) for model in MODELS}
        if len(set(map(tuple, by_model.values()))) == 1:
            lines += by_model["lp64"]
            continue
        for i, (model, condition) in enumerate(MODELS.items()):
            lines.append(f"#{'elif' if i else 'if'} {condition}")
            lines += by_model[model]
        lines += ["#else", f'#error "{s["name"]}: its layout in this data model is not in toothseg.json"', "#endif"]
    return HEAD + "\n" + "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", default=os.path.join(ABI, "toothseg.json"))
    parser.add_argument("-o", "--output", default=os.path.join(ABI, "layout.c"))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--released", action="store_true")
    o = parser.parse_args()
    with open(o.json, encoding="utf-8") as f:
        text = make(json.load(f), o.released)
    if o.output == "-":
        sys.stdout.write(text)
    elif o.check:
        with open(o.output, encoding="utf-8") as f:
            if f.read() != text:
                sys.exit(f"{o.output} is not what {o.json} says: run abi/make_layout.py, and look at the difference")
    else:
        with open(o.output, "w", encoding="utf-8") as f:
            f.write(text)


if __name__ == "__main__":
    main()
