#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# overhead.sh LIBDIR BINDIR: what the Pascal layer costs, as JSON, on an arch of 300,000 faces. overhead.pas says what is what.
set -euo pipefail
[ $# = 2 ] || { echo "usage: overhead.sh LIBDIR BINDIR" >&2; exit 2; }
lib=$(cd "$1" && pwd) bin=$(cd "$2" && pwd) here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LD_LIBRARY_PATH=$lib
fpc -O2 -l- -v0e -Fu"$here/src" -FU"$work" -FE"$work" -Fl"$lib" -k"-rpath=$lib" "$here/overhead.pas" >"$work/log" 2>&1 ||
  { cat "$work/log" >&2; exit 1; }
"$bin/make-arch" "$work/arch.ply" --triangles 300000 >/dev/null
"$work/overhead" "$work/arch.ply"
