#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""test_third_party.py BUILD: scripts/check_third_party.py finds what is wrong. Each entry in turn is left out; one is added that
nothing uses; one claims another licence; and a build is shown that does without EIGEN_MPL2_ONLY."""
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
    for name, package in (("Eigen 3.4", "libeigen3-dev"), ("oneTBB", "libtbb12"), ("nlohmann/json", "nlohmann-json3-dev"),
                          ("GCC's runtime", "libstdc++6"), ("glibc", "libc6"), ("doctest", "doctest-dev")):
        rest = [line for line in lines if not line.startswith(f"| {name}")]
        assert len(rest) == len(lines) - 1, name
        expect(faults(build, rest, work), f"{package} " if name == "glibc" else package)

    end = max(i for i, line in enumerate(lines) if line.startswith("|")) + 1
    expect(faults(build, lines[:end] + ["| Boost | BSL-1.0 | nothing | linked (shared) | `libboost-dev` |"] + lines[end:], work),
           "Boost is not in use")
    copyleft = [line.replace("| MIT | reads", "| GPL-3.0+ | reads") for line in lines]
    expect(faults(build, copyleft, work), "nlohmann/json 3.11 is compiled in, and is under GPL-3.0+")
    hidden = [line.replace("yes, as headers compiled in | `nl", "no | `nl") for line in lines]
    expect(faults(build, hidden, work), "nlohmann-json3-dev reaches the library")

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
