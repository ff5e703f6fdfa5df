#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What changed from one description of the API (abi/toothseg.json) to another, and whether old callers live with it.

    compare.py OLD.json NEW.json [GROWN]    a line a change; fails if one is not allowed
                                            GROWN: abidiff's suppressions for structs that grew, and did so as allowed

Allowed: whole new things; values added to an enum; fields added to the end of a struct that begins with struct_size.
What names alone decide (threads, direction, owner) follows from the types, documentation is not compared.
"""
import json
import sys

NEW_MAJOR = "a change like this needs a new SONAME (abi/README.md)"


class Report:
    def __init__(self):
        self.forbidden = 0
        self.grown = []

    def allow(self, what):
        print(f"allowed: {what}")

    def forbid(self, what, instead):
        self.forbidden += 1
        print(f"BREAK: {what}\n       {instead}")


def by_name(items):
    return {i["name"]: i for i in items}


def pairs(report, kind, old, new, instead):
    """The things of a kind that are in both; says which came and went."""
    old, new = by_name(old), by_name(new)
    for name in new:
        if name not in old:
            report.allow(f"{kind} {name} is new")
    for name in old:
        if name not in new:
            report.forbid(f"{kind} {name} is gone", instead)
    return [(old[name], new[name]) for name in old if name in new]


def version(data):
    return tuple(map(int, data["version"].split(".")))


def constants(report, old, new):
    for a, b in pairs(report, "constant", old["constants"], new["constants"], "keep it, marked as deprecated"):
        if a["value"] != b["value"] and not a["name"].startswith("TS_VERSION_"):
            report.forbid(f"{a['name']} was {a['value']} and is {b['value']}",
                          "compiled callers hold the old value: give the new one a new name")
    if version(new) < version(old):
        report.forbid(f"the header's version was {old['version']} and is {new['version']}", "versions only rise")
    if version(new)[0] != version(old)[0]:
        report.forbid(f"the header's version was {old['version']} and is {new['version']}", NEW_MAJOR)


def is_guard(value):
    return value["name"].endswith("_FORCE_INT")


def block(enum, value):
    """The part of an enum within which values are appended: statuses come in blocks."""
    return value["value"] // 50 if enum["name"] == "ts_status" else 0


def enums(report, old, new):
    for a, b in pairs(report, "enum", old["enums"], new["enums"], "keep it; it may be marked as deprecated"):
        was, now = by_name(a["values"]), by_name(b["values"])
        for name, value in was.items():
            if name not in now:
                report.forbid(f"{a['name']}: {name} is gone", "keep it, even if nothing gives or takes it any more")
            elif now[name]["value"] != value["value"]:
                report.forbid(f"{a['name']}: {name} was {value['value']} and is {now[name]['value']}",
                              "values are fixed for ever: new ones go behind the last, with a number of their own")
        for name, value in now.items():
            if name in was:
                continue
            others = [v["value"] for v in a["values"] if not is_guard(v) and block(a, v) == block(a, value)]
            if any(value["value"] <= v for v in others):
                report.forbid(f"{a['name']}: {name} = {value['value']} is new among the old values",
                              f"new values go behind the last: larger than {max(others)}")
            else:
                report.allow(f"{a['name']}: {name} = {value['value']} is new")


def layout_fault(versioned, old, new, was, added):
    """What old callers of a struct would stumble over, and what to do instead; None if nothing."""
    for n in was:
        if n in new["offsets"] and new["offsets"][n] != old["offsets"][n]:
            return (f"{n} was at byte {old['offsets'][n]} and is at {new['offsets'][n]}", "the fields that are there keep their places")
    if new["size"] < old["size"]:
        return f"it had {old['size']} bytes and has {new['size']}", "structs only grow"
    if new["align"] != old["align"]:
        return (f"alignment was {old['align']} and is {new['align']}", "old callers' structs lie anywhere: take smaller types")
    for n in added:
        if versioned and new["offsets"][n] < old["size"] and not n.startswith("reserved"):
            return (f"{n} is at byte {new['offsets'][n]}, in what was padding of the {old['size']} bytes",
                    "struct_size does not tell whether a caller knows it: put a field `reserved...` into the padding")
    return None


def structs(report, old, new):
    for a, b in pairs(report, "struct", old["structs"], new["structs"], "keep it; it may be marked as deprecated"):
        name, before = a["name"], report.forbidden
        was, now = [f["name"] for f in a["fields"]], [f["name"] for f in b["fields"]]
        if was != now[:len(was)]:
            for old_name, new_name in zip(was, now + [None] * len(was)):
                if old_name != new_name:
                    what = (f"{name}::{old_name} is gone, moved or renamed" if old_name not in now else
                            f"{name}::{new_name} stands where {old_name} was")
                    report.forbid(what, "fields stay where they are, with their names; new ones go to the end")
                    break
        fields = by_name(b["fields"])
        for f in a["fields"]:
            if f["name"] in fields and f["type"]["spelling"] != fields[f["name"]]["type"]["spelling"]:
                report.forbid(f"{name}::{f['name']} was {f['type']['spelling']} and is {fields[f['name']]['type']['spelling']}",
                              "a field keeps its type: add another to the end")
        added = [n for n in now if n not in was]
        for model, layout in a["layout"].items():
            fault = layout_fault(a["versioned"], layout, b["layout"][model], was,
                                 added if was == now[:len(was)] else [])
            if fault:
                report.forbid(f"{name} ({model}): {fault[0]}", fault[1])
                break
        if added and not a["versioned"]:
            report.forbid(f"{name} grew by {', '.join(added)}, and has no struct_size",
                          "callers have arrays of it, or hold it by value: make another struct and function")
        if a.get("init") and a.get("init") != b.get("init"):
            report.forbid(f"{name} was initialised by {a['init']}, now by {b.get('init')}", "keep the function")
        if added and report.forbidden == before:
            report.allow(f"{name} grew by {', '.join(added)}")
            report.grown.append(name)


def signature(f):
    return f"{f['returns']['spelling']} ({', '.join(a['type']['spelling'] for a in f['arguments'])})"


def callables(report, kind, old, new):
    instead = "keep it, marked as deprecated; it may call what replaces it"
    for a, b in pairs(report, kind, old, new, instead):
        if signature(a) != signature(b):
            report.forbid(f"{kind} {a['name']} was {signature(a)} and is {signature(b)}",
                          "add another with the new arguments, and keep this one")
        elif [x["name"] for x in a["arguments"]] != [x["name"] for x in b["arguments"]]:
            report.forbid(f"{kind} {a['name']} has arguments of other names: "
                          f"{', '.join(x['name'] for x in b['arguments'])}", "bindings pass arguments by name: keep them")


def compare(old, new):
    report = Report()
    constants(report, old, new)
    enums(report, old, new)
    pairs(report, "handle", old["handles"], new["handles"], "keep the type")
    callables(report, "callback", old["callbacks"], new["callbacks"])
    structs(report, old, new)
    callables(report, "function", old["functions"], new["functions"])
    return report


def load(path):
    with open(path, encoding="utf-8") as f:
        return json.load(f)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    report = compare(load(sys.argv[1]), load(sys.argv[2]))
    if len(sys.argv) == 4:
        with open(sys.argv[3], "w", encoding="utf-8") as f:
            for name in report.grown:
                f.write(f"[suppress_type]\n  name = {name}\n  type_kind = struct\n  has_data_member_inserted_at = end\n\n")
    sys.exit(1 if report.forbidden else 0)


if __name__ == "__main__":
    main()
