#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh LIBDIR BINDIR: builds the binding and runs its tests. LIBDIR has libtoothseg.so, BINDIR ts-segment and make-arch.
# Needs mono-mcs, mono-runtime and python3.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
[ $# = 2 ] || { echo "usage: test.sh LIBDIR BINDIR" >&2; exit 2; }
lib=$(cd "$1" && pwd)
bin=$(cd "$2" && pwd)
export LD_LIBRARY_PATH=$lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
mkdir "$out/scratch"

"$here/build.sh" "$out/plain"
SPAN=1 "$here/build.sh" "$out/span"
mcs -nologo -warnaserror -define:TOOTHSEG_SPAN -r:"$out/span/Toothseg.dll" -out:"$out/span/Tests.exe" "$here"/tests/*.cs
"$bin/make-arch" "$out/arch.ply" --triangles 20000 --seed 1
package=$("$here/pack.py" "$out/plain" "$lib" "$out/package")

status=0
passed=0
failed=0
run() { # a program whose last line is "N passed, M failed"
  local log=$out/log last
  "$@" 2>&1 | tee "$log" || status=1
  last=$(tail -n 1 "$log")
  if [[ $last =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed$ ]]; then
    passed=$((passed + BASH_REMATCH[1]))
    failed=$((failed + BASH_REMATCH[2]))
  else
    status=1
    failed=$((failed + 1)) # it broke off
  fi
}
run python3 "$here/tests/test_tools.py" "$package" "$out/plain" "$out/arch.ply" "$out/scratch"
# Where Mono waits for a thread of the library this does not end by itself.
run timeout 120 mono --debug "$out/span/Tests.exe" "$out/arch.ply" "$bin" "$out/span" "$out/scratch"
echo "$passed passed, $failed failed"
[ $status = 0 ] && [ $failed = 0 ]
