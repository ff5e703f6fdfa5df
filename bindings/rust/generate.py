#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes toothseg-sys/src/generated.rs from abi/toothseg.json; with --check fails where it is not what the JSON says."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
OUT = HERE / "toothseg-sys" / "src" / "generated.rs"

SCALARS = {"double": "f64", "float": "f32", "int": "c_int", "size_t": "usize", "char": "c_char", "void": "c_void",
           "int8_t": "i8", "int16_t": "i16", "int32_t": "i32", "int64_t": "i64",
           "uint8_t": "u8", "uint16_t": "u16", "uint32_t": "u32", "uint64_t": "u64"}
KEYWORDS = set("as async await break const continue dyn else enum extern fn for if impl in let loop match mod move mut "
               "pub ref return static struct trait type unsafe use where while abstract become box do final macro "
               "override priv try typeof unsized virtual yield".split())
# Which of the JSON's layouts holds, as Rust says it.
TARGETS = {"lp64": 'all(target_pointer_width = "64", not(windows))', "llp64": 'all(target_pointer_width = "64", windows)',
           "wasm32": 'target_arch = "wasm32"'}


def name(text):
    return "r#" + text if text in KEYWORDS else text


def doc(text, indent=""):
    return [f"{indent}/// {line.strip()}".rstrip() for line in text.splitlines()] if text else []


def base(type_):
    if type_["kind"] in ("enum", "struct", "handle", "callback"):
        return type_["base"]
    return SCALARS[type_["base"]]


def rust_type(type_, is_argument):
    out = base(type_)
    stars = type_.get("pointer") or 0
    if type_.get("length"):
        if not is_argument:
            return f"[{out}; {type_['length']}]"
        stars = 1  # an array as an argument is a pointer to its first element
    for star in range(stars):
        # const belongs to what is pointed to, the innermost
        out = ("*const " if star == 0 and type_.get("const") else "*mut ") + out
    return out


def signature(function, separator):
    arguments = separator.join(f"{name(a['name'])}: {rust_type(a['type'], True)}" for a in function["arguments"])
    returns = rust_type(function["returns"], True)
    return arguments, "" if returns == "c_void" else f" -> {returns}"


def constants(api):
    for c in api["constants"]:
        value = c["value"]
        if isinstance(value, str):
            yield f"pub const {c['name']}: &str = {json.dumps(value)};"
        elif isinstance(value, float):
            yield f"pub const {c['name']}: f64 = {value!r};"
        else:
            yield f"pub const {c['name']}: u32 = {value};"
    yield ""


def enums(api):
    for e in api["enums"]:
        yield from doc(e["doc"])
        # No enum of Rust: a library that is newer may give a value that is not known here.
        yield f"pub type {e['name']} = {'i32' if min(v['value'] for v in e['values']) < 0 else 'u32'};"
        for v in e["values"]:
            yield from doc(v["doc"])
            yield f"pub const {v['name']}: {e['name']} = {v['value']};"
        yield f"/// The names and values of [`{e['name']}`]."
        yield f"pub const {e['name'].upper()}_VALUES: &[(&str, {e['name']})] = &["
        for v in e["values"]:
            if not v["name"].endswith("_FORCE_INT"):
                yield f'    ("{v["name"]}", {v["name"]}),'
        yield "];"
        yield ""


def handles(api):
    for h in api["handles"]:
        yield from doc(h["doc"])
        yield "#[repr(C)]"
        yield f"pub struct {h['name']} {{"
        yield "    _opaque: [u8; 0],"
        yield "    _neither_send_nor_sync: PhantomData<*mut u8>,"
        yield "}"
        yield ""


def callbacks(api):
    for c in api["callbacks"]:
        arguments, returns = signature(c, ", ")
        yield from doc(c["doc"])
        yield f"pub type {c['name']} = Option<unsafe extern \"C\" fn({arguments}){returns}>;"
        yield ""


def structs(api):
    for s in api["structs"]:
        yield from doc(s["doc"])
        yield "#[repr(C)]"
        yield "#[derive(Clone, Copy, Debug)]"
        yield f"pub struct {s['name']} {{"
        for f in s["fields"]:
            yield from doc(f["doc"], "    ")
            yield f"    pub {name(f['name'])}: {rust_type(f['type'], False)},"
        yield "}"
        yield ""
        yield f"impl Default for {s['name']} {{"
        yield "    /// All zero" + (", but for `struct_size`." if s["versioned"] else ".")
        yield "    fn default() -> Self {"
        yield "        // Numbers, arrays of numbers, pointers and optional functions: all of them may be zero."
        if s["versioned"]:
            yield "        let mut all_zero: Self = unsafe { std::mem::zeroed() };"
            yield "        all_zero.struct_size = std::mem::size_of::<Self>() as u32;"
            yield "        all_zero"
        else:
            yield "        unsafe { std::mem::zeroed() }"
        yield "    }"
        yield "}"
        yield ""


def functions(api):
    yield 'extern "C" {'
    for f in api["functions"]:
        arguments, returns = signature(f, ", ")
        yield from doc(f["doc"], "    ")
        yield f"    pub fn {f['name']}({arguments}){returns};"
    yield "}"
    yield ""


def layouts(api):
    yield "/// That the structs lie in memory as the C compiler lays them out."
    yield "#[cfg(test)]"
    yield "mod layout {"
    yield "    macro_rules! check {"
    yield "        ($name:ident, $size:expr, $align:expr, $($field:ident: $offset:expr),*) => {"
    yield "            #[test]"
    yield "            fn $name() {"
    yield "                assert_eq!(std::mem::size_of::<crate::$name>(), $size);"
    yield "                assert_eq!(std::mem::align_of::<crate::$name>(), $align);"
    yield "                let s = <crate::$name>::default();"
    yield "                let at = std::ptr::addr_of!(s) as usize;"
    yield "                $(assert_eq!(std::ptr::addr_of!(s.$field) as usize - at, $offset, stringify!($field));)*"
    yield "            }"
    yield "        };"
    yield "    }"
    for target, condition in TARGETS.items():
        yield ""
        yield f"    #[cfg({condition})]"
        yield f"    mod {target} {{"
        for s in api["structs"]:
            layout = s["layout"][target]
            offsets = ", ".join(f"{name(field)}: {at}" for field, at in layout["offsets"].items())
            yield f"        check!({s['name']}, {layout['size']}, {layout['align']}, {offsets});"
        yield "    }"
    yield "}"


def generated(api):
    lines = ["// SPDX-License-Identifier: Apache-2.0",
             f"// Made by bindings/rust/generate.py from abi/toothseg.json, version {api['version']}. Not to be edited.", "",
             "use std::marker::PhantomData;",
             "use std::os::raw::{c_char, c_int, c_void};", ""]
    for part in (constants, enums, handles, callbacks, structs, functions, layouts):
        lines += part(api)
    return "\n".join(lines) + "\n"


def main():
    api = json.loads((HERE.parents[1] / "abi" / "toothseg.json").read_text(encoding="utf-8"))
    if api["format"] != 1:
        sys.exit(f"abi/toothseg.json has format {api['format']}, not 1")
    text = generated(api)
    if sys.argv[1:] == ["--check"]:
        if OUT.read_text(encoding="utf-8") != text:
            sys.exit(f"{OUT} is not what abi/toothseg.json says: run {pathlib.Path(__file__).name}")
    elif sys.argv[1:]:
        sys.exit("usage: generate.py [--check]")
    else:
        OUT.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
