#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""check_third_party.py BUILD [--table FILE]: is THIRD_PARTY.md true? Debian only, and of a build by Ninja.

Each Debian package that the shipped libraries are linked with, that a header they were compiled from belongs to, or that
scripts/install_deps.sh installs, or a package.json names, has an entry; each entry is in use; nothing copyleft is compiled in; and Eigen is compiled
without its LGPL parts. TS_PACKAGE_OWNERS: a file where what dpkg said is kept for the next time."""
import argparse
import collections
import fnmatch
import functools
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
SHIPPED = ("src/", "synth/")  # objects of the libraries that are installed
Entry = collections.namedtuple("Entry", "name licence reaches packages")


def output(*command):
    return subprocess.run([str(c) for c in command], check=True, text=True, stdout=subprocess.PIPE).stdout


def entries(table):
    lines = [line for line in table.read_text().splitlines() if line.startswith("|")]
    rows = [re.split(r" *\| *", line.strip("| ")) for line in lines]
    return [Entry(r[0], r[1], r[3], re.findall(r"`([^`]+)`", r[4])) for r in rows[2:]]


def headers(build):
    """Object -> files outside of the project that it was compiled from, for what is shipped."""
    found, current = {}, None
    real = functools.cache(os.path.realpath)  # few headers, in many objects
    for line in output("ninja", "-n", "-C", build, "-t", "deps").splitlines():
        if line.startswith("    /"):
            if current is not None and not line.startswith((f"    {ROOT}/", f"    {build}/")):
                current.add(real(line.strip()))
        elif ": #deps" in line:
            name = line.split(":")[0]
            current = found.setdefault(name, set()) if name.startswith(SHIPPED) else None
    if not found:
        sys.exit(f"check_third_party.py: {build} has no dependencies of objects: not built, or not by Ninja")
    return found


def linked(build):
    """File names of the libraries that the shared one needs, and of those that a program with the static one is linked with."""
    library = build / "src/api/libtoothseg.so"
    names = re.findall(r"NEEDED +(\S+)", output("objdump", "-p", library))
    pc = (build / "toothsegTargets/toothseg.pc").read_text()
    wanted = re.findall(r"-l(\S+)", re.search(r"^Libs.private:(.*)$", pc, re.M).group(1))
    (exported,) = (build / "CMakeFiles/Export").rglob("toothsegTargets.cmake")
    interface = re.findall(r'INTERFACE_LINK_LIBRARIES "([^"]*)"', exported.read_text())
    wanted += re.findall(r"(?:\w+::)?(\w+)>?(?:;|$)", ";".join(interface))
    for name in wanted:
        file = pathlib.Path(output("c++", f"-print-file-name=lib{name}.so").strip()).resolve()
        if not file.is_absolute() or not file.exists():
            sys.exit(f"check_third_party.py: the static library's -l{name} is not installed")
        soname = re.search(r"SONAME +(\S+)", output("objdump", "-p", file)) if file.read_bytes()[:4] == b"\x7fELF" else None
        if soname:  # else a linker script for what the compiler links anyway: libm.so
            names.append(soname.group(1))
    return set(names)


def owners(paths):
    """Path -> the Debian package that it belongs to, and the paths that belong to none."""
    def twin(path):  # dpkg knows a file by its place before or after /lib became a link to /usr/lib
        return path[4:] if path.startswith("/usr/") else "/usr" + path

    kept = pathlib.Path(os.environ["TS_PACKAGE_OWNERS"]) if os.environ.get("TS_PACKAGE_OWNERS") else None
    if kept and kept.exists():
        known = json.loads(kept.read_text())
        if set(paths) <= known.keys():
            return {p: known[p] for p in paths if known[p]}, sorted(p for p in paths if not known[p])
    owner, lost, left = {}, [], sorted(paths)
    while left:  # dpkg -S is slow: asked once a package
        answer = subprocess.run(["dpkg", "-S", left[0], twin(left[0])], text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, check=False).stdout
        if not answer:
            lost.append(left.pop(0))
            continue
        package = re.split("[,:]", answer)[0]
        multiarch = re.match("[^, ]+", answer).group().rstrip(":")
        files = set(output("dpkg", "-L", multiarch).splitlines())
        owner.update((path, package) for path in left if path in files or twin(path) in files)
        left = [path for path in left if path not in owner]
    if kept:
        kept.write_text(json.dumps({**dict.fromkeys(lost), **owner}))
    return owner, lost


def from_npm():
    """npm:NAME of each package that a package.json of the project asks the registry for."""
    files = [p for folder in ("bindings", "samples") for p in ROOT.glob(f"{folder}/*/package.json")]
    wanted = [json.loads(p.read_text()).get(kind, {}) for p in files for kind in ("dependencies", "devDependencies")]
    return {f"npm:{name}" for packages in wanted for name, version in packages.items() if not version.startswith("file:")}


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--table", type=pathlib.Path, default=ROOT / "THIRD_PARTY.md")
    options = options.parse_args()
    build, table, faults = options.build.resolve(), entries(options.table), []

    included, names = headers(build), linked(build)
    multiarch = output("c++", "-print-multiarch").strip()
    libraries = {f"/usr/lib/{multiarch}/{name}": name for name in names if not name.startswith("ld-")}
    owner, lost = owners(set().union(*included.values()) | set(libraries))
    faults += [f"{path} belongs to no Debian package" for path in lost]
    shipped = collections.defaultdict(set)
    for path, package in owner.items():
        shipped[package].add(libraries.get(path, path))
    text = (ROOT / "scripts/install_deps.sh").read_text()
    installed = {word for words in re.findall(r'packages="([^"]*)"', text) for word in words.split() if word[0] != "$"}
    installed |= from_npm()

    def has_entry(package, rows):
        return any(fnmatch.fnmatchcase(package, pattern) for row in rows for pattern in row.packages)

    reaching = [e for e in table if not e.reaches.startswith("no")]
    for package, files in sorted(shipped.items()):
        if not has_entry(package, reaching):
            faults.append(f"{package} reaches the library ({sorted(files)[0]}), and has no entry that says so")
    faults += [f"install_deps.sh installs {p}, and it has no entry" for p in sorted(installed) if not has_entry(p, table)]
    for entry in table:
        used = shipped if entry in reaching else installed
        if not any(has_entry(package, [entry]) for package in used):
            faults.append(f"the entry {entry.name} is not in use")
        licence = re.sub(r" \(.*?\)", "", entry.licence)
        if "headers" in entry.reaches and "GPL" in licence and "Exception" not in licence:
            faults.append(f"{entry.name} is compiled in, and is under {entry.licence}")

    eigen = {o for o, paths in included.items() if any(owner.get(p) == "libeigen3-dev" for p in paths)}
    commands = [c["command"] for c in json.loads((build / "compile_commands.json").read_text())]
    commands = {re.search(r" -o (\S+)", c).group(1): c for c in commands}
    for name in sorted(eigen & set(commands)):
        if not re.search(r"-DEIGEN_MPL2_ONLY\b", commands[name]):
            faults.append(f"{name} is compiled from Eigen without EIGEN_MPL2_ONLY")
    if not eigen & set(commands):
        faults.append("no object in compile_commands.json is compiled from Eigen")

    for fault in faults:
        print(f"check_third_party.py: {fault}")
    print(f"{len(table)} entries; {len(included)} objects of {len(shipped)} packages, {len(eigen)} of them with Eigen; "
          f"{len(faults)} faults")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
