#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""make_def.py [--check]: abi/toothseg.def, the names and ordinals that toothseg.dll exports, from abi/toothseg.json.

Who has an ordinal keeps it: in the last release (reference/toothseg-N.def), and in abi/toothseg.def as it is. New functions get the
next ones, in the order of the header. --check writes nothing, and fails where the file is not what would be written, or where a
function of the last release has another ordinal or none."""
import argparse
import json
import pathlib
import re
import sys

ABI = pathlib.Path(__file__).resolve().parent
HEAD = """; Made by abi/make_def.py: what toothseg.dll exports. A name keeps its ordinal. SPDX-License-Identifier: Apache-2.0
LIBRARY toothseg.dll
EXPORTS
"""


def read(path):
    """Name -> ordinal; nothing of a file that is not there."""
    if not path.exists():
        return {}
    lines = re.findall(r"^  (\w+) @(\d+)$", path.read_text(encoding="utf-8"), re.M)
    return {name: int(ordinal) for name, ordinal in lines}


def ordinals(functions, released, before):
    """Name -> ordinal of each function. What went since the last release may leave its number free, what was released never."""
    kept = {name: n for name, n in before.items() if name in functions} | released
    following = max(kept.values(), default=0) + 1
    for name in functions:
        if name not in kept:
            kept[name] = following
            following += 1
    return kept


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--check", action="store_true")
    options.add_argument("--json", type=pathlib.Path, default=ABI / "toothseg.json")
    options.add_argument("--reference", type=pathlib.Path)
    options.add_argument("-o", "--out", type=pathlib.Path, default=ABI / "toothseg.def")
    options = options.parse_args()
    data = json.loads(options.json.read_text(encoding="utf-8"))
    major = data["version"].split(".")[0]
    released = read(options.reference or ABI / f"reference/toothseg-{major}.def")
    functions = [f["name"] for f in data["functions"]]
    before = read(options.out)
    if options.check:
        broken = sorted(name for name, n in released.items() if before.get(name) != n)
        if broken:
            sys.exit(f"make_def.py: not with the ordinal of the last release: {', '.join(broken)}")
    gone = sorted(set(released) - set(functions))
    if gone:
        sys.exit(f"make_def.py: exported by the last release, and no function of the header: {', '.join(gone)}")
    wanted = ordinals(functions, released, before)
    if len(set(wanted.values())) != len(wanted):
        sys.exit("make_def.py: an ordinal twice")
    text = HEAD + "".join(f"  {name} @{n}\n" for name, n in sorted(wanted.items(), key=lambda item: item[1]))
    if options.check:
        if not options.out.exists() or options.out.read_text(encoding="utf-8") != text:
            sys.exit(f"make_def.py: {options.out} is not of this header: scripts/generate.sh")
    else:
        options.out.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
