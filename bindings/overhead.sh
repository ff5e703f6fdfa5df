#!/usr/bin/env bash
# What each language's layer costs beside C, a line of JSON each: ns a call that does nothing, ms (median of 50) to read the labels of
# 300,000 faces into a new array, and into one that is there. overhead.sh LIBDIR BINDIR. SPDX-License-Identifier: Apache-2.0
set -euo pipefail
[ $# = 2 ] || { echo "usage: overhead.sh LIBDIR BINDIR" >&2; exit 2; }
lib=$(cd "$1" && pwd) bin=$(cd "$2" && pwd)
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LD_LIBRARY_PATH=$lib TOOTHSEG_LIBRARY=$lib/libtoothseg.so
"$bin/make-arch" "$work/arch.ply" --triangles 300000 >/dev/null
cc -O2 -std=c99 -I"$lib/../include" overhead.c -o "$work/overhead" -L"$lib" -ltoothseg
run() {
  printf '%-7s ' "$1"
  shift
  "$@"
}
run c "$work/overhead" "$work/arch.ply"
run python env PYTHONPATH=python /usr/bin/python3 python/overhead.py "$lib" "$bin"
run node node node/overhead.js "$work/arch.ply"
run rust env CARGO=/usr/bin/cargo RUSTC=/usr/bin/rustc rust/overhead.sh "$lib" "$bin"
run csharp csharp/overhead.sh "$lib" "$bin"
run pascal pascal/overhead.sh "$lib" "$bin"
