#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""test_third_party.py BUILD: scripts/check_third_party.py finds what is wrong: entries that are left out, one that nothing uses,
one under another licence, one that denies that it reaches the library, and a build without EIGEN_MPL2_ONLY."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def faults(build, lines, work):
    table = work / "table.md"
    table.write_text("\n".join(lines))
    done = subprocess.run(["/usr/bin/python3", ROOT / "scripts/check_third_party.py", build, "--table", table], text=True,
                          stdout=subprocess.PIPE, check=False)
    found = [line for line in done.stdout.splitlines() if line.startswith("check_third_party.py: ")]
    assert bool(found) == (done.returncode == 1), done.stdout
    return found


def expect(found, text):
    assert any(text in fault for fault in found), f"no fault says '{text}': {found}"


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    work = build / "packages-test/third_party"
    work.mkdir(parents=True, exist_ok=True)
    lines = (ROOT / "THIRD_PARTY.md").read_text().splitlines()
    missing = {"Eigen 3.4": "libeigen3-dev", "oneTBB": "libtbb12", "nlohmann/json": "nlohmann-json3-dev",
               "GCC's runtime": "libstdc++6", "glibc": "libc6", "doctest": "doctest-dev"}
    found = faults(build, [line for line in lines if not line.startswith(tuple(f"| {name}" for name in missing))], work)
    for package in missing.values():
        said = "installs {}, and it has no entry" if package == "doctest-dev" else " {} reaches the library"
        expect(found, said.format(package))

    wrong = [line.replace("| MIT | reads", "| GPL-3.0+ | reads").replace("linked (shared) | `libc6`", "no | `libc6`")
             for line in lines]
    wrong.insert(wrong.index("| DejaVu fonts | Bitstream Vera, public domain | text in pictures | no | `fonts-dejavu-core` |"),
                 "| Boost | BSL-1.0 | nothing | linked (shared) | `libboost-dev` |")
    found = faults(build, wrong, work)
    expect(found, "Boost is not in use")
    expect(found, "nlohmann/json 3.11 is compiled in, and is under GPL-3.0+")
    expect(found, "libc6 reaches the library")

    # The same build, but for one word in each command.
    shown = work / "build"
    shown.mkdir(exist_ok=True)
    for item in build.iterdir():
        link = shown / item.name
        if item.name != "packages-test" and not link.exists():
            link.symlink_to(item)
    commands = shown / "compile_commands.json"
    commands.unlink()
    commands.write_text((build / "compile_commands.json").read_text().replace("-DEIGEN_MPL2_ONLY", ""))
    expect(faults(shown, lines, work), "without EIGEN_MPL2_ONLY")


if __name__ == "__main__":
    main()
