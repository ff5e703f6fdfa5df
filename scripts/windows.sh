#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# toothseg for 64-bit Windows, from a clean clone on Debian 12: installs what is missing, builds toothseg.dll by MinGW-w64 (before it,
# from Debian's sources, oneTBB and mathematical functions), makes the zip and runs tests, samples and bindings under Wine.
# docs/windows.md says what of this was run and what not.
#   scripts/windows.sh            all of it
#   scripts/windows.sh --build    the library and the zip, without the tests
# The last lines are counts, and the zip with its size.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
[ $# = 0 ] || [ "$*" = --build ] || { sed -n '3,9s/^# \{0,1\}//p' "$0" >&2; exit 2; }
scripts/install_deps.sh windows
build=$root/build/windows prefix=$root/build/windows-deps/prefix
jobs=${TS_JOBS:-$(nproc)}

scripts/windows_tbb.sh "$prefix"
scripts/windows_libm.sh "$prefix"
abi/make_def.py --check
cmake --preset windows >/dev/null
cmake --build "$build" -j "$jobs"
abi/check_dll.py "$build/src/api/toothseg.dll"
abi/make_layout.py --check
x86_64-w64-mingw32-gcc-posix -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only -Iinclude abi/layout.c
scripts/build_installed.sh "$build" samples -DCMAKE_TOOLCHAIN_FILE="$root/cmake/mingw-w64.cmake"
(cd "$build" && cpack --config CPackConfig.cmake >package.log) || { cat "$build/package.log" >&2; exit 1; }
zip=$(ls "$build"/packages/toothseg-*-Windows-x64.zip)
[ "${1:-}" = --build ] || tests/windows/test.sh "$build" "$zip"
echo "$zip: $(stat -c %s "$zip") bytes"
