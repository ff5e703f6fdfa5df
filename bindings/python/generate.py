#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The C API for ctypes: toothseg/_abi.py, made from abi/toothseg.json.

    generate.py                write toothseg/_abi.py
    generate.py --check        fail if that is not what the JSON says
    generate.py --json J -o F  another description, another file ("-": standard output)
"""
import argparse
import json
import keyword
import os
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
JSON = os.path.join(HERE, "..", "..", "abi", "toothseg.json")
OUTPUT = os.path.join(HERE, "toothseg", "_abi.py")
WIDTH = 120
SCALARS = {
    "char": "c_char", "int": "c_int", "float": "c_float", "double": "c_double", "size_t": "c_size_t",
    **{f"{u}int{bits}_t": f"c_{u}int{bits}" for u in ("", "u") for bits in (8, 16, 32, 64)},
}
HEAD = '''\
# SPDX-License-Identifier: Apache-2.0
"""The C API of toothseg for ctypes. Made by generate.py from abi/toothseg.json: do not edit.

Structs, handles and callbacks have their names from toothseg.h, which is the manual; enums have Python's kind of names.
"""
# fmt: off
from __future__ import annotations

import ctypes
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_float, c_int, c_int8,  # noqa: F401
                    c_int16, c_int32, c_int64, c_size_t, c_uint8, c_uint16, c_uint32, c_uint64, c_void_p)
from enum import IntEnum, IntFlag
from typing import Any, Self


class Enum(IntEnum):
    """An enum that takes values which only a newer library knows."""

    @classmethod
    def _missing_(cls, value: object) -> Self | None:
        if not isinstance(value, int):
            return None
        member = int.__new__(cls, value)
        member._name_, member._value_ = f"UNKNOWN_{value}", value
        return member


'''
BIND = '''\


def bind(library: ctypes.CDLL) -> ctypes.CDLL:
    """Tells ctypes the types of all functions. AttributeError where the library lacks one."""
    for name, (returns, arguments) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = returns, arguments
    return library
'''


def stars(name, count):
    return name if count == 0 else stars(f"POINTER({name})", count - 1)


def ctype(t, field=False):
    """A type of the JSON in ctypes' words; arrays are pointers unless they are a struct's field."""
    kind, base, pointers = t["kind"], t["base"], t.get("pointer", 0)
    if kind == "void" and pointers == 0:
        return "None"
    if kind == "void":
        name = stars("c_void_p", pointers - 1)
    elif kind == "text" and t.get("const"):
        name = stars("c_char_p", pointers - 1)
    elif kind in ("scalar", "text"):
        name = stars(SCALARS[base], pointers)
    elif kind == "enum":
        name = stars("c_int32", pointers)
    else:
        name = stars(base, pointers)
    if "length" not in t:
        return name
    return f"{name} * {t['length']}" if field else f"POINTER({name})"


def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("ts_").split("_"))


def member_names(enum):
    """Without what all have in common up to an underscore, and without the E of errors."""
    names = [v["name"] for v in enum["values"]]
    common = os.path.commonprefix(names) if len(names) > 1 else "TS_"
    cut = common.rfind("_") + 1
    for name in names:
        short = name[cut:]
        if enum["name"] == "ts_status":
            short = short.removeprefix("E_")
        yield "_" + short if keyword.iskeyword(short) or not short[0].isalpha() else short


def comment(text, indent=""):
    return textwrap.wrap(text, WIDTH, initial_indent=indent + "#: ", subsequent_indent=indent + "#: ",
                         break_long_words=False, break_on_hyphens=False)


def enum_lines(enum):
    """An enum; those whose values are summed are flags."""
    enum = {**enum, "values": [v for v in enum["values"] if not v["name"].endswith("_FORCE_INT")]}
    base = "IntFlag" if enum["name"].endswith(("_warning", "_flag", "_flags", "_warnings")) else "Enum"
    yield from ("", "", f"class {camel(enum['name'])}({base}):")
    if enum["doc"]:
        yield from textwrap.wrap('"""' + enum["doc"].replace("\\", "\\\\") + '"""', WIDTH, initial_indent="    ",
                                 subsequent_indent="    ", break_on_hyphens=False)
        yield ""
    for value, name in zip(enum["values"], member_names(enum)):
        yield from comment(value["doc"], "    ") if value["doc"] else ()
        yield f"    {name} = {value['value']}"


def wrapped(head, items, tail):
    """head item, item, ... tail, on as many lines as that takes; an item stays whole."""
    line = head
    for i, item in enumerate(items):
        item += tail if i + 1 == len(items) else ","
        if len(line) + 1 + len(item) > WIDTH:
            yield line.rstrip()
            line = " " * 8
        line += item if line.endswith((" ", "[")) else " " + item
    yield line if items else line + tail


def struct_lines(struct):
    fields = [f'("{f["name"]}", {ctype(f["type"], field=True)})' for f in struct["fields"]]
    return wrapped(f"{struct['name']}._fields_ = [", fields, "]")


def callback_line(callback):
    types = [ctype(callback["returns"])] + [ctype(a["type"]) for a in callback["arguments"]]
    return f"{callback['name']} = CFUNCTYPE({', '.join(types)})"


def function_lines(function):
    arguments = [ctype(a["type"]) for a in function["arguments"]]
    return wrapped(f'    "{function["name"]}": ({ctype(function["returns"])}, [', arguments, "]),")


def generate(api):
    if api["format"] != 1:
        raise SystemExit(f"generate.py: format {api['format']} of the description is not known")
    lines = HEAD.splitlines() + [f'VERSION = "{api["version"]}"']
    for c in api["constants"]:
        if not c["name"].startswith("TS_VERSION_"):
            lines.append(f"{c['name'].removeprefix('TS_')} = {c['value']:#x}")
    for enum in api["enums"]:
        lines += enum_lines(enum)
    # All names before any content: structs hold callbacks, and callbacks take structs.
    for thing in api["handles"] + api["structs"]:
        lines += ["", "", f"class {thing['name']}(Structure):", "    pass"]
    lines += ["", ""]
    lines += map(callback_line, api["callbacks"])
    lines.append("")
    for struct in api["structs"]:
        lines += struct_lines(struct)
    lines += ["", "#: name: (what it returns, its arguments)", "FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {"]
    for function in api["functions"]:
        lines += function_lines(function)
    return "\n".join(lines + ["}"]) + "\n" + BIND


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", default=JSON)
    parser.add_argument("-o", "--output", default=OUTPUT)
    parser.add_argument("--check", action="store_true")
    o = parser.parse_args()
    with open(o.json, encoding="utf-8") as f:
        text = generate(json.load(f))
    if o.output == "-":
        sys.stdout.write(text)
    elif not o.check:
        with open(o.output, "w", encoding="utf-8") as f:
            f.write(text)
    else:
        with open(o.output, encoding="utf-8") as f:
            if f.read() != text:
                sys.exit(f"generate.py: {o.output} is not what {o.json} says: run generate.py, and look at the difference")


if __name__ == "__main__":
    main()
