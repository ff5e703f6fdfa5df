#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""hardening.py FILE...: what the files that are shipped were built to. ELF only; reads them with binutils.

A shared library: fully relocated and read-only before its first call, no code on the stack, nothing both writable and
executable, no relocations of code, stack protector and checked calls of the C library in use. The objects of a static library
(or a single object): nothing that lives as long as the process and can change, but for what ALLOWED explains, and nothing that
runs when the library is loaded."""
import re
import subprocess
import sys

# Of the symbol, by its name in C++: why it may be there.
ALLOWED = {
    "ts::(anonymous namespace)::current_hooks": "the allocator that the running thread works for: AllocatorScope",
    "ts::(anonymous namespace)::current_monitor": "whom the running thread asks whether to stop: StopScope",
    "__tls_guard": "the compiler's, for current_hooks: is it constructed in this thread?",
    "ts::api::(anonymous namespace)::last_message": "ts_last_error_message of each thread",
    "ts::field::dense_kernels()::best": "const, set once: the kernels that this processor runs",
    "ts::field::runnable_dense_kernels()::count": "const, set once: how many kinds it could run",
    "Eigen::internal::manage_caching_sizes(Eigen::Action, long*, long*, long*)::m_cacheSizes":
        "Eigen's, set once: nothing calls setCpuCacheSizes",
}
GUARD = "guard variable for "  # of an initialisation that happens once, whichever thread comes first
# What the loader writes before any code runs, and nothing afterwards.
RELOCATED = re.compile(r"\.data\.rel\.(ro|local\.DW\.ref)\b")


def output(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


def faults_of_shared(path):
    """(rule, what is wrong) of a shared library."""
    segments = re.findall(r"^  (\w+) .* ([R ][W ][E ]) 0x[0-9a-f]+$", output("readelf", "-lW", path), re.M)
    flags = {}
    for kind, flag in segments:
        flags.setdefault(kind, []).append(flag)
    dynamic = output("readelf", "-dW", path)
    imports = set(re.findall(r"U (\w+)", output("nm", "-D", "--undefined-only", path)))

    if "GNU_RELRO" not in flags:
        yield "relro", "no segment is made read-only after relocation"
    if not re.search(r"\((FLAGS|FLAGS_1)\).*\b(BIND_NOW|NOW)\b", dynamic):
        yield "bind_now", "functions are bound when they are first called, so that their table stays writable"
    if any("E" in flag for flag in flags.get("GNU_STACK", ["RWE"])):
        yield "stack", "asks for an executable stack"
    if any("W" in flag and "E" in flag for flag in flags.get("LOAD", [])):
        yield "segments", "a segment is writable and executable"
    if re.search(r"\(TEXTREL\)|\(FLAGS\).*\bTEXTREL\b", dynamic):
        yield "textrel", "its code is relocated, and therefore writable for a time"
    if "__stack_chk_fail" not in imports:
        yield "protector", "no function checks its stack: built without -fstack-protector-strong"
    if not any(re.fullmatch(r"__\w+_chk", name) for name in imports):
        yield "fortify", "no call of the C library is checked: built without _FORTIFY_SOURCE"


def globals_of(path):
    """(object, name in C++, bytes) of what is in memory that can be written to."""
    member = path
    for line in output("objdump", "-tC", "-w", path).splitlines():
        if m := re.match(r"(\S+): +file format", line):
            member = m.group(1)
        # value, 7 flags (d: of debugging, or the section itself), section, size, visibility, name
        m = re.match(r"[0-9a-f]+ (.{7}) (\S+)\t([0-9a-f]+) (?:\.\w+ )?(.*)", line)
        if not m or "d" in m.group(1) or not re.match(r"\.t?(data|bss)\b|\.l(data|bss)\b|\*COM\*", m.group(2)):
            continue
        if not RELOCATED.match(m.group(2)):
            yield member, m.group(4), int(m.group(3), 16)


def faults_of_objects(path, allowed):
    if re.search(r"^ +\d+ \.(init_array|ctors)\b", output("objdump", "-hw", path), re.M):
        yield "initialiser", "code runs when the library is loaded"
    used = set()
    for member, name, size in globals_of(path):
        what = name.removeprefix(GUARD)
        if what in allowed:
            used.add(what)
        else:
            yield "globals", f"{member}: {name} ({size} bytes) outlives every call and can change"
    for name in sorted(set(allowed) - used):
        yield "allowed", f"{name} is allowed and not there"


def faults(path, allowed):
    shared = re.search(r"Type: +DYN", output("readelf", "-hW", path))
    return list(faults_of_shared(path) if shared else faults_of_objects(path, allowed))


def main(paths):
    if not paths:
        sys.exit(__doc__)
    found = [f"{path}: {rule}: {what}" for path in paths for rule, what in faults(path, ALLOWED)]
    for line in found:
        print(line)
    print(f"{len(paths)} files, {len(ALLOWED)} globals explained, {len(found)} faults")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
