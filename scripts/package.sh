#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The packages of a finished build: toothseg-VERSION-Linux-ARCH.tar.gz and, on Debian, libtoothseg0_*.deb and
# libtoothseg-dev_*.deb.
#   scripts/package.sh [OUT]      default BUILD/packages; TS_PACKAGE_BUILD: another build than build/release
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=${TS_PACKAGE_BUILD:-$root/build/release}
[[ -f $build/src/api/libtoothseg.a && -f $build/CPackConfig.cmake ]] ||
  { echo "package.sh: $build is no finished build: cmake --preset demo && cmake --build --preset demo" >&2; exit 1; }
build=$(cd "$build" && pwd)
out=${1:-$build/packages}
mkdir -p "$out"
out=$(cd "$out" && pwd)
cd "$build"
log=$build/package.log
cpack --config CPackConfig.cmake -B "$out" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
rm -rf "$out/_CPack_Packages"
sed -n 's/^CPack: - package: \(.*\) generated\.$/\1/p' "$log"
