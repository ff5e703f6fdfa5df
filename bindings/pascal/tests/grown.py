#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""grown.py JSON OUT: the API as a later release may have it, with a function, a struct, an enum, a constant, a handle and a
callback more, and names that Pascal keeps for itself."""
import json
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    api = json.load(file)


def scalar(base, **more):
    return {"base": base, "kind": "scalar", "spelling": base, **more}


layout = {"size": 48, "align": 8, "offsets": {"struct_size": 0, "begin": 4, "type": 8, "end": 16, "next": 40}}
api["constants"].append({"name": "TS_MOST", "value": 7})
api["enums"].append({"name": "ts_most", "doc": "Collides.", "values": [
    {"name": "TS_MOST_B", "value": 4, "doc": "of this"}, {"name": "TS_MOST_A", "value": -1, "doc": ""},
    {"name": "TS_MOST_FORCE_INT", "value": 0x7fffffff, "doc": ""}]})
api["handles"].append({"name": "ts_plan", "doc": "", "destroy": "ts_plan_destroy"})
api["callbacks"].append({"name": "ts_plan_fn", "doc": "", "returns": scalar("double"), "arguments": [
    {"name": "type", "type": scalar("uint64_t")}, {"name": "user", "type": {"base": "void", "kind": "void", "pointer": 1,
                                                                           "spelling": "void *"}},
    {"name": "info", "type": {"base": "ts_plan_info", "kind": "struct", "pointer": 1, "spelling": "ts_plan_info *"}}]})
api["structs"].append({"name": "ts_plan_info", "doc": "", "versioned": True, "fields": [
    {"name": "struct_size", "type": scalar("uint32_t"), "doc": ""},
    {"name": "begin", "type": {"base": "ts_most", "kind": "enum", "spelling": "ts_most"}, "doc": "first"},
    {"name": "type", "type": scalar("uint16_t", length=3), "doc": ""},
    {"name": "end", "type": scalar("float", length=5), "doc": "last"},
    {"name": "next", "type": {"base": "ts_plan_fn", "kind": "callback", "spelling": "ts_plan_fn"}, "doc": ""}],
    "layout": {"lp64": layout, "llp64": layout, "wasm32": layout}})
pair = {"size": 96, "align": 8, "offsets": {"both": 0}}
api["structs"].append({"name": "ts_plan_pair", "doc": "", "versioned": False, "fields": [
    {"name": "both", "type": {"base": "ts_plan_info", "kind": "struct", "length": 2, "spelling": "ts_plan_info[2]"}, "doc": ""}],
    "layout": {"lp64": pair, "llp64": pair, "wasm32": pair}})
plan = {"base": "ts_plan", "kind": "handle", "spelling": "ts_plan *", "pointer": 1}
api["functions"].append({"name": "ts_plan_create", "doc": "", "since": "0.2.0", "threads": "any", "arguments": [
    {"name": "var", "direction": "in", "type": scalar("int64_t", pointer=1)},
    {"name": "begin", "direction": "in", "type": {"base": "ts_most", "kind": "enum", "spelling": "ts_most"}},
    {"name": "out", "direction": "out", "type": {**plan, "spelling": "ts_plan **", "pointer": 2}}],
    "returns": {"base": "ts_status", "kind": "enum", "spelling": "ts_status"}})
api["functions"].append({"name": "ts_plan_destroy", "doc": "", "since": "0.2.0", "threads": "any", "arguments": [
    {"name": "plan", "direction": "in", "type": plan}], "returns": {"base": "void", "kind": "void", "spelling": "void"}})
with open(sys.argv[2], "w", encoding="utf-8") as file:
    json.dump(api, file)
