#!/usr/bin/env python3
"""The C API as data: abi/toothseg.json, made from include/toothseg.h by libclang. abi/README.md has the format.

    describe.py                 write abi/toothseg.json
    describe.py --check         fail if that is not what the header says
    describe.py --header H -o F another header, another file ("-": standard output)
    describe.py --bare          without documentation, as releases are kept

TS_ABI_DESCRIBED: a folder for what has been described in this run, by the text of the header.
"""
import argparse
import hashlib
import json
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TARGETS = {"lp64": "x86_64-linux-gnu", "llp64": "x86_64-w64-windows-gnu", "wasm32": "wasm32-unknown-emscripten"}
# Enough of the two standard headers for a target whose own are not installed.
STANDARD = {
    "stddef.h": "typedef __SIZE_TYPE__ size_t;\n#define NULL ((void *)0)\n",
    "stdint.h": "".join(f"typedef __{s}INT{b}_TYPE__ {s.lower()}int{b}_t;\n" for s in ("U", "") for b in (8, 16, 32, 64)) +
    "#define UINT32_MAX 4294967295U\n",
}
# Arrays without the two-call idiom: `count` is an argument, `as_many` what another call tells.
ARRAYS = {
    ("ts_segment_clicks", "statuses"): {"count": "count"},
    ("ts_get_contour_points", "starts"): {"as_many": "ts_contour_info.polylines"},
    ("ts_get_contour_points", "closed"): {"as_many": "ts_contour_info.polylines"},
}
ci = K = T = None  # libclang, from when a header is read


def load_libclang():
    global ci, K, T
    import clang.cindex
    ci = clang.cindex
    K, T = ci.CursorKind, ci.TypeKind


class Problem(Exception):
    pass


def parse(header, target):
    folder = "/toothseg-standard"
    files = [(f"{folder}/{name}", text) for name, text in STANDARD.items()]
    unit = ci.Index.create().parse(
        header, ["-x", "c", "-std=c99", "-target", target, "-nostdinc", "-isystem", folder], files,
        ci.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
    wrong = [str(d) for d in unit.diagnostics if d.severity >= ci.Diagnostic.Error]
    if wrong:
        raise Problem("\n".join(wrong))
    return unit


def doc_of(cursor):
    """The comment as plain text, without its stars."""
    raw = cursor.raw_comment or ""
    raw = re.sub(r"^/\*\*<?|\*/$", "", raw.strip())
    lines = [re.sub(r"^\s*\*\s?", "", line).strip() for line in raw.splitlines()]
    return re.sub(r"\s+", " ", " ".join(lines)).strip()


def type_of(t):
    """A type as data: what it is, how many stars, and an array's length."""
    out = {"spelling": t.spelling}
    if t.kind == T.CONSTANTARRAY:
        out["length"] = t.element_count
        t = t.element_type
    stars = 0
    while t.kind == T.POINTER and t.get_pointee().kind not in (T.FUNCTIONPROTO,):
        stars += 1
        t = t.get_pointee()
    if stars:
        out["pointer"] = stars
    if t.is_const_qualified():
        out["const"] = True
    name = re.sub(r"^const ", "", t.spelling)
    declared = t.get_declaration()
    canonical = t.get_canonical()
    if name.startswith("ts_"):
        under = canonical
        if under.kind == T.ENUM:
            kind = "enum"
        elif under.kind == T.POINTER:
            kind = "callback"
        elif under.kind == T.RECORD:
            kind = "struct" if under.get_declaration().is_definition() else "handle"
        else:
            raise Problem(f"{declared.location}: {name} is of no kind that is known")
    elif name == "char" and stars:
        kind = "text"
    elif name == "void":
        kind = "void"
    else:
        kind = "scalar"
    return {"base": name, "kind": kind, **out}


def fields_of(cursor):
    for c in cursor.get_children():
        if c.kind == K.FIELD_DECL:
            yield c


def is_versioned(struct):
    return bool(struct["fields"]) and struct["fields"][0]["name"] == "struct_size"


def describe_argument(a, names, at, function, structs):
    """`a` with direction, owner, and what it is an array of."""
    t = a["type"]
    name, stars, const, kind = a["name"], t.get("pointer", 0), t.get("const", False), t["kind"]
    following = names[at + 1:at + 3]
    if kind == "handle":
        if stars == 2:
            a["direction"], a["owner"] = "out", f"the caller, who gives it to {t['base']}_destroy"
        else:
            a["direction"] = "in"
            if function.endswith("_destroy"):
                a["owner"] = "the library from then on"
    elif kind == "void" and stars and name == "user":
        a["direction"] = "in"
    elif not stars and "length" not in t or const or kind == "callback":
        a["direction"] = "in"
    else:
        versioned = kind == "struct" and t["base"] in structs and is_versioned(structs[t["base"]])
        a["direction"] = "inout" if versioned and not function.endswith("_init") else "out"
    if (stars or "length" in t) and kind in ("scalar", "text", "struct", "enum"):
        if following == ["capacity", "count"]:
            a["array"] = {"capacity": "capacity", "count": "count"}
        elif "length" not in t and a["direction"] == "in" and kind != "struct":
            if kind == "text" and following[:1] != ["size"]:
                a["array"] = {"zero_terminated": True}
            elif following[:1] and following[0] in ("count", "size"):
                a["array"] = {"count": following[0]}
    if kind == "void" and stars and following[:1] == ["size"]:
        a["array"] = {"count": "size"}
    if (function, name) in ARRAYS:
        a["array"] = ARRAYS[function, name]
    return a


def thread_rule(function):
    """Of the objects beside the job, which belongs to the call, and the context, which things may be made from at once."""
    if function["name"] in ("ts_job_reset", "ts_job_destroy", "ts_context_destroy"):
        return "exclusive"
    handles = [a["type"] for a in function["arguments"] if a["type"]["kind"] == "handle" and
               a["type"].get("pointer") == 1 and a["type"]["base"] not in ("ts_job", "ts_context")]
    if not handles:
        return "any"
    return "concurrent" if all(t.get("const") for t in handles) else "exclusive"


def describe(header):
    load_libclang()
    units = {name: parse(header, target) for name, target in TARGETS.items()}
    unit = units["lp64"]
    own = os.path.abspath(header)

    def mine(u):
        return [c for c in u.cursor.get_children() if c.location.file and os.path.abspath(c.location.file.name) == own]

    constants, enums, handles, callbacks, structs, functions = [], [], {}, [], {}, []
    layouts = {}
    for name, u in units.items():
        for c in mine(u):
            if c.kind == K.STRUCT_DECL and c.is_definition():
                layouts.setdefault(c.spelling, {})[name] = {
                    "size": c.type.get_size(), "align": c.type.get_align(),
                    "offsets": {f.spelling: f.get_field_offsetof() // 8 for f in fields_of(c)}}
    for c in mine(unit):
        if c.kind == K.MACRO_DEFINITION:
            tokens = [t.spelling for t in c.get_tokens()]
            if len(tokens) == 2 and tokens[1] in ("UINT32_MAX",):
                constants.append({"name": c.spelling, "value": 0xffffffff})
            elif len(tokens) == 2 and re.fullmatch(r"\d+", tokens[1]):
                constants.append({"name": c.spelling, "value": int(tokens[1])})
        elif c.kind == K.ENUM_DECL:
            values = [{"name": v.spelling, "value": v.enum_value, "doc": doc_of(v)} for v in c.get_children()
                      if v.kind == K.ENUM_CONSTANT_DECL]
            enums.append({"name": c.spelling, "doc": doc_of(c), "values": values})
        elif c.kind == K.STRUCT_DECL and c.is_definition():
            fields = [{"name": f.spelling, "type": type_of(f.type), "doc": doc_of(f)} for f in fields_of(c)]
            structs[c.spelling] = {"name": c.spelling, "doc": doc_of(c), "versioned": False, "fields": fields,
                                   "layout": layouts[c.spelling]}
            structs[c.spelling]["versioned"] = is_versioned(structs[c.spelling])
        elif c.kind == K.TYPEDEF_DECL:
            under = c.underlying_typedef_type.get_canonical()
            if under.kind == T.RECORD and not under.get_declaration().is_definition():
                handles[c.spelling] = {"name": c.spelling, "doc": doc_of(c)}
            elif under.kind == T.POINTER and under.get_pointee().kind == T.FUNCTIONPROTO:
                arguments = [{"name": p.spelling, "type": type_of(p.type)} for p in c.get_children() if p.kind == K.PARM_DECL]
                callbacks.append({"name": c.spelling, "doc": doc_of(c), "returns": type_of(under.get_pointee().get_result()),
                                  "arguments": arguments})
    for c in mine(unit):
        if c.kind != K.FUNCTION_DECL:
            continue
        names = [p.spelling for p in c.get_arguments()]
        f = {"name": c.spelling, "doc": doc_of(c), "returns": type_of(c.result_type), "arguments": [
            describe_argument({"name": p.spelling, "type": type_of(p.type)}, names, i, c.spelling, structs)
            for i, p in enumerate(c.get_arguments())]}
        since = re.search(r"Since (\d+\.\d+\.\d+)", f["doc"])
        f["since"] = since.group(1) if since else "0.1.0"
        f["threads"] = thread_rule(f)
        functions.append(f)
    taken = {f["name"] for f in functions}
    for s in structs.values():
        if s["name"] + "_init" in taken:
            s["init"] = s["name"] + "_init"
    for h in handles.values():
        h["destroy"] = h["name"] + "_destroy"
        if h["destroy"] not in taken:
            raise Problem(f"{h['name']} has no {h['destroy']}")
    version = {c["name"]: c["value"] for c in constants}
    return {"format": 1, "header": os.path.basename(header),
            "version": ".".join(str(version["TS_VERSION_" + p]) for p in ("MAJOR", "MINOR", "PATCH")),
            "constants": constants, "enums": enums, "handles": list(handles.values()), "callbacks": callbacks,
            "structs": list(structs.values()), "functions": functions}


def without_docs(data):
    if isinstance(data, list):
        return [without_docs(d) for d in data]
    if isinstance(data, dict):
        return {name: without_docs(d) for name, d in data.items() if name != "doc"}
    return data


def bare(data):
    """Without documentation, and an item of a list a line."""
    lines = []
    for name, value in without_docs(data).items():
        if isinstance(value, list):
            value = "[\n  " + ",\n  ".join(json.dumps(item) for item in value) + "\n ]"
        else:
            value = json.dumps(value)
        lines.append(f' {json.dumps(name)}: {value}')
    return "{\n" + ",\n".join(lines) + "\n}\n"


def text_of(header, is_bare):
    data = describe(header)
    return bare(data) if is_bare else json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def known_text_of(header, is_bare):
    """The same, from TS_ABI_DESCRIBED where it is there."""
    folder = os.environ.get("TS_ABI_DESCRIBED")
    if not folder:
        return text_of(header, is_bare)
    digest = hashlib.sha256(f"{os.path.basename(header)} {is_bare} ".encode())
    for file in (header, __file__):
        with open(file, "rb") as f:
            digest.update(f.read())
    path = os.path.join(folder, digest.hexdigest())
    if not os.path.exists(path):
        text = text_of(header, is_bare)
        with open(path + ".part", "w", encoding="utf-8") as f:
            f.write(text)
        os.replace(path + ".part", path)
        return text
    with open(path, encoding="utf-8") as f:
        return f.read()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--header", default=os.path.join(ROOT, "include", "toothseg.h"))
    parser.add_argument("-o", "--output", default=os.path.join(ROOT, "abi", "toothseg.json"))
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--bare", action="store_true")
    o = parser.parse_args()
    try:
        text = known_text_of(o.header, o.bare)
    except Problem as e:
        sys.exit(f"describe.py: {e}")
    if o.output == "-":
        sys.stdout.write(text)
        return
    if o.check:
        with open(o.output, encoding="utf-8") as f:
            if f.read() != text:
                sys.exit(f"{o.output} is not what {o.header} says: run abi/describe.py, and look at the difference")
        return
    with open(o.output, "w", encoding="utf-8") as f:
        f.write(text)


if __name__ == "__main__":
    main()
