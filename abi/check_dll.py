#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""check_dll.py DLL [--def FILE]: does toothseg.dll export what abi/toothseg.def says, each name with its ordinal and nothing else,
and does it need nothing but DLLs that are part of Windows? Asked of objdump, which reads them without Windows."""
import argparse
import pathlib
import re
import subprocess
import sys

import make_def

# Of Windows itself; msvcrt.dll is the C library that MinGW-w64 builds for.
SYSTEM = {"kernel32.dll", "msvcrt.dll", "advapi32.dll", "user32.dll", "ntdll.dll", "shell32.dll", "bcrypt.dll"}


def said_of(dll, objdump):
    return subprocess.run([objdump, "-p", str(dll)], check=True, text=True, stdout=subprocess.PIPE).stdout


def exports(text):
    """Name -> ordinal. The table of addresses has ordinals, that of names the place in it, counted from 0."""
    base = re.search(r"^Ordinal Base\s+(\d+)$", text, re.M)
    table = re.search(r"^\[Ordinal/Name Pointer\] Table.*?$(.*?)^\s*$", text, re.M | re.S)
    if not base or not table:
        sys.exit("check_dll.py: it has no export table")
    pairs = re.findall(r"^\s*\[\s*(\d+)\]\s+(?:\+base\[\s*\d+\]\s+)?(?:[0-9a-f]{4}\s+)?(\w+)$", table.group(1), re.M)
    return {name: int(place) + int(base.group(1)) for place, name in pairs}


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("dll", type=pathlib.Path)
    options.add_argument("--def", dest="definition", type=pathlib.Path, default=make_def.ABI / "toothseg.def")
    options.add_argument("--objdump", default="x86_64-w64-mingw32-objdump")
    options = options.parse_args()
    text = said_of(options.dll, options.objdump)
    wanted, found = make_def.read(options.definition), exports(text)
    faults = [f"{name} @{n} is not exported" if name not in found else f"{name} has ordinal {found[name]}, and not {n}"
              for name, n in wanted.items() if found.get(name) != n]
    faults += [f"{name} is exported, and is no function of toothseg.h" for name in sorted(set(found) - set(wanted))]
    needed = sorted(re.findall(r"^\s*DLL Name: (\S+)$", text, re.M), key=str.lower)
    faults += [f"needs {name}, which is not part of Windows" for name in needed if name.lower() not in SYSTEM]
    if not needed or not wanted:
        faults.append("no DLL that it needs, or no function that it should export, was found: nothing was checked")
    for fault in faults:
        print(f"check_dll.py: {fault}")
    print(f"{len(found)} exports, {len(faults)} faults; needs {', '.join(needed)}")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
