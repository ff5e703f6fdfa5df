#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# overhead.sh LIBDIR BINDIR: what the layer costs, as JSON, on a synthetic arch of 300,000 triangles.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
[ $# = 2 ] || { echo "usage: overhead.sh LIBDIR BINDIR" >&2; exit 2; }
export LD_LIBRARY_PATH=$(cd "$1" && pwd)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$here/build.sh" "$out"
mcs -nologo -optimize -r:"$out/Toothseg.dll" -out:"$out/overhead.exe" "$here/overhead.cs"
"$2/make-arch" "$out/arch.ply" --triangles 300000 >/dev/null
mono "$out/overhead.exe" "$out/arch.ply"
