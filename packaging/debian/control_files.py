#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""control_files.py LIBRARY OUT: what Debian's package of the shared library says of it, as files in the folder OUT:
symbols (each exported function and the version that it is since, from abi/toothseg.json), shlibs, triggers, and depends
(what dpkg-shlibdeps finds)."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def output(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, text=True, stdout=subprocess.PIPE, **options).stdout


def soname(library):
    return re.search(r"SONAME +(\S+)", output("objdump", "-p", library)).group(1)


def symbols(library, so, package):
    since = {f["name"]: f["since"] for f in json.loads((ROOT / "abi/toothseg.json").read_text())["functions"]}
    lines = [f"{so} {package} #MINVER#", "* Build-Depends-Package: libtoothseg-dev"]
    for line in sorted(output("nm", "-D", "--defined-only", "--with-symbol-versions", library).splitlines()):
        name, _, node = line.split()[2].replace("@@", "@").partition("@")
        node = node or name  # the node itself has the name of the version that it stands for
        if name != node and name not in since:
            sys.exit(f"control_files.py: {name} is exported, and not in abi/toothseg.json")
        lines.append(f" {name}@{node} {since.get(name) or min(since.values())}")
    return "\n".join([*lines[:2], *sorted(lines[2:])]) + "\n"


def depends(library):
    with tempfile.TemporaryDirectory() as folder:  # dpkg-shlibdeps wants a source package around it
        (pathlib.Path(folder) / "debian").mkdir()
        (pathlib.Path(folder) / "debian/control").write_text("Source: toothseg\n\nPackage: toothseg\nArchitecture: any\n")
        found = output("dpkg-shlibdeps", "-O", library, cwd=folder)
    return found.strip().partition("shlibs:Depends=")[2]


def main():
    library, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    so = soname(library)
    name, major = re.fullmatch(r"(\w+)\.so\.(\d+)", so).groups()
    package = name + major
    (out / "symbols").write_text(symbols(library, so, package))
    (out / "shlibs").write_text(f"{name} {major} {package}\n")
    (out / "triggers").write_text("activate-noawait ldconfig\n")
    (out / "depends").write_text(depends(library))


if __name__ == "__main__":
    main()
