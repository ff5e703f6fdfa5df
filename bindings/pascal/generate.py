#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The low-level unit and the table of layouts, made from abi/toothseg.json.

    generate.py            write src/toothseg_api.pas and tests/layout.inc
    generate.py --check    fail if these are not what the JSON says
    generate.py --json J   another JSON; with --out DIR, another place for both files
"""
import argparse
import json
import os
import re
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
SCALARS = {
    "char": ("AnsiChar", "PAnsiChar"), "double": ("Double", "PDouble"), "float": ("Single", "PSingle"),
    "int": ("Integer", "PInteger"), "unsigned int": ("Cardinal", "PCardinal"), "size_t": ("NativeUInt", "PNativeUInt"),
    "int8_t": ("ShortInt", "PShortInt"), "uint8_t": ("Byte", "PByte"), "int16_t": ("SmallInt", "PSmallInt"),
    "uint16_t": ("Word", "PWord"), "int32_t": ("Integer", "PInteger"), "uint32_t": ("Cardinal", "PCardinal"),
    "int64_t": ("Int64", "PInt64"), "uint64_t": ("UInt64", "PUInt64"), "void": (None, "Pointer"),
}
KEYWORDS = set("""and array as asm begin case class const constructor destructor dispinterface div do downto else end except
exports file finalization finally for function goto if implementation in inherited initialization inline interface is label
library mod nil not object of on operator or out packed procedure program property raise record repeat resourcestring set shl
shr string then threadvar to try type unit until uses var while with xor result self""".split())


class Problem(Exception):
    pass


def safe(name):
    return name + "_" if name.lower() in KEYWORDS else name


def camel(name):
    """A field as Pascal writes it: nearest_vertex is NearestVertex."""
    return safe("".join(part[:1].upper() + part[1:] for part in name.split("_")))


def unique(names, where):
    seen = {}
    for name in names:
        if name.lower() in seen:
            raise Problem(f"{where}: {name} and {seen[name.lower()]} are one name in Pascal")
        seen[name.lower()] = name
    return names


def comment(text, indent="", wide=118):
    return textwrap.wrap(text, wide, initial_indent=indent + "// ", subsequent_indent=indent + "// ",
                         break_long_words=False) if text else []


def described(text, doc):
    """A declaration and what it is: beside it where that fits, else above."""
    line = f"{text} // {doc}"
    if not doc or len(line) <= 118:
        return [line if doc else text]
    return comment(doc, " " * (len(text) - len(text.lstrip()))) + [text]


class Writer:
    def __init__(self, api):
        self.api = api
        used = {t["base"] for t in self.types() if t["kind"] == "enum"}
        # An enum that nothing is declared as is a sum of flags. A status of a later release has to fit, too.
        self.flags = {e["name"] for e in api["enums"] if e["name"] not in used or e["name"] == "ts_status"}
        self.constants = self.free_constants()

    def types(self):
        for s in self.api["structs"]:
            yield from (f["type"] for f in s["fields"])
        for f in self.api["functions"] + self.api["callbacks"]:
            yield f["returns"]
            yield from (a["type"] for a in f["arguments"])

    def free_constants(self):
        """Pascal knows no upper and lower case: a constant gives way to a type or function of its name."""
        taken = {x["name"].lower() for kind in ("enums", "handles", "callbacks", "structs", "functions") for x in self.api[kind]}
        names = [c["name"] for c in self.api["constants"]] + [v["name"] for e in self.api["enums"] for v in e["values"]]
        return {n: n + "_" if n.lower() in taken else n for n in unique(names, "constants")}

    def pascal(self, t):
        stars, base = t.get("pointer", 0), t["base"]
        if t.get("length"):
            if stars:
                raise Problem(f"array of pointers: {t['spelling']}")
            return f"ts_{base.removeprefix('ts_').removesuffix('_t')}{t['length']}"
        if base in SCALARS:
            plain, pointer = SCALARS[base]
            chain = [plain, pointer, "P" + pointer]
        elif base.startswith("ts_"):
            chain = [base, "P" + base, "PP" + base]
        else:
            raise Problem(f"no Pascal type for {t['spelling']}")
        if stars >= len(chain) or chain[stars] is None:
            raise Problem(f"no Pascal type for {t['spelling']}")
        return chain[stars]

    def parameter(self, t):
        """C passes arrays by address."""
        return "P" + self.pascal(t) if t.get("length") else self.pascal(t)

    def signature(self, f, name=""):
        arguments = unique([safe(a["name"]) for a in f["arguments"]], f["name"])
        inside = "; ".join(f"{n}: {self.parameter(a['type'])}" for n, a in zip(arguments, f["arguments"]))
        inside = f"({inside})" if inside else ""
        void = f["returns"]["kind"] == "void" and not f["returns"].get("pointer")
        head = f"procedure {name}" if void else f"function {name}"
        return head.rstrip() + inside + ("" if void else f": {self.pascal(f['returns'])}")

    # ---------------------------------------------------------------------------------------------------- sections

    def consts(self):
        yield "const"
        for c in self.api["constants"]:
            yield f"  {self.constants[c['name']]} = {c['value']};"
        for e in self.api["enums"]:
            if e["name"] in self.flags:
                yield ""
                yield from comment(f"{e['name']}: {e['doc']}" if e["doc"] else e["name"], "  ")
                for v in self.values(e):
                    yield from described(f"  {self.constants[v['name']]} = {v['value']};", v["doc"])

    @staticmethod
    def values(e):
        return [v for v in sorted(e["values"], key=lambda v: v["value"]) if not v["name"].endswith("_FORCE_INT")]

    def enums(self):
        for e in self.api["enums"]:
            yield ""
            if e["name"] in self.flags:
                yield f"  {e['name']} = Integer;"
            else:
                yield from comment(e["doc"], "  ")
                yield f"  {e['name']} = ("
                values = self.values(e)
                for i, v in enumerate(values):
                    comma = "," if i + 1 < len(values) else ""
                    yield from described(f"    {self.constants[v['name']]} = {v['value']}{comma}", v["doc"])
                yield "  );"
            yield f"  P{e['name']} = ^{e['name']};"

    def handles(self):
        for h in self.api["handles"]:
            yield ""
            yield from comment(h["doc"], "  ")
            yield f"  {h['name']} = record end;"
            yield f"  P{h['name']} = ^{h['name']};"
            yield f"  PP{h['name']} = ^P{h['name']};"

    def arrays(self, wanted):
        """Arrays of fixed length, a type each; of elements that are declared by then."""
        lengths = {self.pascal(t): t for t in self.types() if t.get("length") and wanted(t)}
        for name, t in sorted(lengths.items()):
            yield f"  {name} = array [0 .. {t['length'] - 1}] of {self.pascal({**t, 'length': 0})};"
            yield f"  P{name} = ^{name};"

    def pointers(self):
        """Ahead of the structs, which callbacks may be told of."""
        for s in self.api["structs"]:
            yield f"  P{s['name']} = ^{s['name']};"

    def structs(self):
        for s in self.api["structs"]:
            yield ""
            yield from comment(s["doc"], "  ")
            yield f"  {s['name']} = record"
            unique([camel(f["name"]) for f in s["fields"]], s["name"])
            for f in s["fields"]:
                yield from described(f"    {camel(f['name'])}: {self.pascal(f['type'])};", f["doc"])
            yield "  end;"
            yield from self.arrays(lambda t, name=s["name"]: t["base"] == name)

    def callbacks(self):
        for c in self.api["callbacks"]:
            yield ""
            yield from comment(c["doc"], "  ")
            yield f"  {c['name']} = {self.signature(c)}; cdecl;"
            yield from self.arrays(lambda t, name=c["name"]: t["base"] == name)

    def functions(self, dynamic):
        for f in self.api["functions"]:
            if dynamic:
                yield f"  {f['name']}: {self.signature(f)}; cdecl;"
            else:
                yield ""
                yield from comment(f"{f['doc']} Since {f['since']}; threads: {f['threads']}.".strip())
                yield f"{self.signature(f, f['name'])}; cdecl; external TS_LIBRARY;"

    def unit(self):
        out = [HEAD % self.api["version"]]
        out += [*self.consts(), "", "type", *list(self.enums())[1:], *self.handles(), "",
                *self.arrays(lambda t: t["kind"] not in ("struct", "callback")), "", *self.pointers(), *self.callbacks(),
                *self.structs(), "", "{$IFDEF TOOTHSEG_DYNAMIC}", LOADER_INTERFACE, "var", *self.functions(True), "{$ELSE}",
                *self.functions(False), "{$ENDIF}", "", "implementation", "", "{$IFDEF TOOTHSEG_DYNAMIC}", LOADER,
                "procedure ts_load(const Path: string);", "begin", "  OpenLibrary(Path);"]
        out += [f"  @{f['name']} := Find('{f['name']}');" for f in self.api["functions"]]
        return "\n".join([*out, "  Loaded := True;", "end;", "{$ENDIF}", "", "end.", ""])

    def layout(self):
        """Statements of the tests: what the compiler made of a record beside what C made of the struct."""
        out = ["// SPDX-License-Identifier: Apache-2.0", "// Made by generate.py from abi/toothseg.json; do not edit."]

        def expect(what, actual, lp64, llp64):
            if lp64 == llp64:
                out.append(f"Expect('{what}', {actual}, {lp64});")
            else:
                out.append(f"Expect('{what}', {actual}, {{$IFDEF MSWINDOWS}}{llp64}{{$ELSE}}{lp64}{{$ENDIF}});")

        for s in self.api["structs"]:
            unix, windows = s["layout"]["lp64"], s["layout"]["llp64"]
            expect(s["name"], f"SizeOf({s['name']})", unix["size"], windows["size"])
            for f in s["fields"]:
                at = "@@" if f["type"]["kind"] == "callback" else "@"  # one @ is the function that a variable holds
                expect(f"{s['name']}.{f['name']}", f"NativeUInt({at}P{s['name']}(nil)^.{camel(f['name'])})",
                       unix["offsets"][f["name"]], windows["offsets"][f["name"]])
        for e in self.api["enums"]:
            expect(e["name"], f"SizeOf({e['name']})", 4, 4)
            if e["name"] not in self.flags:
                for v in self.values(e):
                    expect(v["name"], f"Ord({self.constants[v['name']]})", v["value"], v["value"])
        return "\n".join(out) + "\n"


HEAD = """// toothseg's C functions, %s, as they are. The units to program with is toothseg.pas.
// SPDX-License-Identifier: Apache-2.0
// Made by generate.py from abi/toothseg.json; do not edit.
//
// The library is bound when the program is linked or, with TOOTHSEG_DYNAMIC defined, by ts_load.
// C++ expects floating-point exceptions to be masked, and Pascal does not mask them: whoever calls these functions has
// to mask them first. toothseg.pas does.
unit toothseg_api;

{$IFDEF FPC}
{$MODE DELPHI}
{$PACKRECORDS C}
{$ELSE}
{$ALIGN 8}
{$ENDIF}
{$MINENUMSIZE 4}

interface

{$IFNDEF TOOTHSEG_DYNAMIC}
const
{$IFDEF MSWINDOWS}
  TS_LIBRARY = 'toothseg.dll';
{$ELSE}
{$IFDEF FPC}
  TS_LIBRARY = 'toothseg';
{$ELSE}
  TS_LIBRARY = {$IFDEF MACOS}'libtoothseg.dylib'{$ELSE}'libtoothseg.so.0'{$ENDIF};
{$ENDIF}
{$ENDIF}

{$ENDIF}""".replace("The units to", "The unit to")

LOADER_INTERFACE = """
// Loads the library: the file named, else the one that the environment variable TOOTHSEG_LIBRARY names, else the one that
// the system finds. An exception where it, or one of its functions, is not there.
procedure ts_load(const Path: string);
// The same, once, without a name.
procedure ts_need;
"""

LOADER = """
uses
{$IFDEF FPC}
  dynlibs,
{$ELSE}
{$IFDEF MSWINDOWS}
  Windows,
{$ENDIF}
{$ENDIF}
  SysUtils;

const
{$IFDEF MSWINDOWS}
  FileName = 'toothseg.dll';
{$ELSE}
  FileName = {$IF DEFINED(DARWIN) OR DEFINED(MACOS)}'libtoothseg.dylib'{$ELSE}'libtoothseg.so.0'{$IFEND};
{$ENDIF}

type
  THandleOfLibrary = {$IFDEF FPC}TLibHandle{$ELSE}HMODULE{$ENDIF};

var
  Handle: THandleOfLibrary;
  OpenName: string;
  Loaded: Boolean;

procedure OpenLibrary(const Path: string);
begin
  OpenName := Path;
  if OpenName = '' then
    OpenName := GetEnvironmentVariable('TOOTHSEG_LIBRARY');
  if OpenName = '' then
    OpenName := FileName;
  Handle := LoadLibrary({$IFDEF FPC}OpenName{$ELSE}PChar(OpenName){$ENDIF});
  if Handle = 0 then
    raise EOSError.CreateFmt('%s: cannot be loaded', [OpenName]);
end;

function Find(const Name: string): Pointer;
begin
  Result := GetProcAddress(Handle, {$IFDEF FPC}Name{$ELSE}PChar(Name){$ENDIF});
  if Result = nil then
    raise EOSError.CreateFmt('%s: has no function %s', [OpenName, Name]);
end;

procedure ts_need;
begin
  if not Loaded then
    ts_load('');
end;
"""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--json", default=os.path.join(HERE, "..", "..", "abi", "toothseg.json"))
    parser.add_argument("--out", default=HERE)
    options = parser.parse_args()
    with open(options.json, encoding="utf-8") as file:
        writer = Writer(json.load(file))
    stale = []
    for name, text in (("src/toothseg_api.pas", writer.unit()), ("tests/layout.inc", writer.layout())):
        path = os.path.join(options.out, name)
        if options.check:
            try:
                with open(path, encoding="utf-8") as file:
                    same = file.read() == text
            except OSError:
                same = False
            stale += [] if same else [path]
        else:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8", newline="\n") as file:
                file.write(text)
    if stale:
        print("\n".join(f"{path}: not what abi/toothseg.json says; run generate.py" for path in stale), file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Problem as problem:
        sys.exit(f"generate.py: {problem}")
