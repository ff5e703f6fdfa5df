#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Callers of all releases (abi/history/VERSION), compiled with the header that they had, on today's library. Exit 1 if any fails.
#   run_history.sh LIBDIR MAKE_ARCH [CALLER [FOLDER]]    LIBDIR: has libtoothseg.so; MAKE_ARCH: the sample that makes a scan
#     CALLER: VERSION/NAME, of one alone; FOLDER: where the scan is kept for the next run
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
lib=$(realpath "$1") make_arch=$2 only=${3:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scan=${4:-$work}
[ -e "$scan/truth.txt" ] ||
  "$make_arch" "$scan/scan.ply" --triangles 10000 --labels "$scan/truth.txt" >"$work/said" || { cat "$work/said"; exit 2; }
ran=0 failed=0
for version in "$here"/history/*/; do
  for caller in "$version"*.c; do
    name=$(basename "$version")/$(basename "$caller" .c)
    [ -z "$only" ] || [ "$only" = "$name" ] || continue
    ran=$((ran + 1))
    mkdir "$work/$ran"
    # The folder of the caller comes first: today's header is not seen.
    if "${CC:-cc}" -std=c99 -Wall -Wextra -pedantic -Werror -I"$version" "$caller" -o "$work/caller" -L"$lib" -ltoothseg \
      >"$work/said" 2>&1 && LD_LIBRARY_PATH=$lib "$work/caller" "$scan/scan.ply" "$scan/truth.txt" "$work/$ran" >"$work/said" 2>&1; then
      echo "ok    $name"
    else
      echo "FAIL  $name"
      sed 's/^/      /' "$work/said"
      failed=$((failed + 1))
    fi
  done
done
echo "run_history.sh: $((ran - failed)) callers passed, $failed failed"
[ $failed = 0 ] && [ $ran -gt 0 ]
