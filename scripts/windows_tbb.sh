#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# oneTBB for toothseg.dll: a static library by MinGW-w64 from Debian's source package, whose hashes apt checks.
#   scripts/windows_tbb.sh PREFIX      nothing is done where PREFIX has it
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
prefix=$1
[ ! -e "$prefix/lib/cmake/TBB/TBBConfig.cmake" ] || exit 0
work=$(dirname "$prefix")/work
rm -rf "$work"
mkdir -p "$work"
log=$work/log
{
  "$root/scripts/debian_source.sh" onetbb "$work"
  cd "$work"
  # Its memory allocator is not needed, nor what it finds out about the machine by hwloc.
  cmake -S onetbb-*/ -B build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$root/cmake/mingw-w64.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DBUILD_SHARED_LIBS=OFF -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF -DTBB_STRICT=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON \
    -DCMAKE_INSTALL_PREFIX="$prefix"
  cmake --build build -j "${TS_JOBS:-$(nproc)}"
  cmake --install build
  # Its objects ask the linker to export what is oneTBB's, even from a library that only contains it.
  x86_64-w64-mingw32-objcopy --remove-section .drectve "$prefix/lib/libtbb12.a"
} >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
rm -rf "$work"
