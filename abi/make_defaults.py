#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A C program that prints every field of every struct as its init function fills it, to standard output.

    make_defaults.py toothseg.json
"""
import json
import sys

FORMATS = {"double": ("%.17g", ""), "float": ("%.9g", "(double)"), "uint64_t": ("%llu", "(unsigned long long)"),
           "int64_t": ("%lld", "(long long)")}
HEAD = """#include <stdio.h>
#include <string.h>

#include "toothseg.h"

int main(void) {
"""
TAIL = """  return 0;
}
"""


def variants(function, enums):
    """The calls to be made: by the values of the enum that the init function takes beside struct and size, if any."""
    more = function["arguments"][2:]
    if not more:
        return [("", "")]
    if len(more) != 1 or more[0]["type"]["kind"] != "enum":
        sys.exit(f"make_defaults.py: {function['name']} takes more than a struct, its size and an enum")
    values = enums[more[0]["type"]["base"]]["values"]
    return [(f"({v['name']})", f", {v['name']}") for v in values if not v["name"].endswith("_FORCE_INT")]


def print_field(name, field):
    t = field["type"]
    lines = []
    for index in [f"[{i}]" for i in range(t["length"])] if "length" in t else [""]:
        value = f"o.{field['name']}{index}"
        if t.get("pointer") or t["kind"] == "callback":
            form, value = "%s", f'{value} ? "set" : "NULL"'
        else:
            form, cast = FORMATS.get(t["base"], ("%ld", "(long)"))
            value = cast + value
        lines.append(f'    printf("{name}.{field["name"]}{index} = {form}\\n", {value});\n')
    return lines


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as f:
        data = json.load(f)
    functions = {f["name"]: f for f in data["functions"]}
    enums = {e["name"]: e for e in data["enums"]}
    out = [HEAD]
    for s in data["structs"]:
        if "init" not in s:
            continue
        for name, argument in variants(functions[s["init"]], enums):
            # What init does not fill shows as a number of its own.
            out.append(f"  {{\n    {s['name']} o;\n    memset(&o, 0xa5, sizeof o);\n"
                       f"    if ({s['init']}(&o, sizeof o{argument}) != TS_OK) return 1;\n")
            for field in s["fields"]:
                if field["name"] != "struct_size":
                    out += print_field(s["name"] + name, field)
            out.append("  }\n")
    sys.stdout.write("".join(out) + TAIL)


if __name__ == "__main__":
    main()
