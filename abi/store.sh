#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Keeps a library as the reference that check.sh compares with, and its header as that of old callers: for a release, and for
# nothing else.
#   store.sh [--replace] [LIB]    LIB: libtoothseg.so, its API with debug information. Default: build/release
# Refuses what check.sh finds fault with. --replace does it all the same: for a reference that no release has had.
set -euo pipefail
. "$(dirname "$0")/facts.sh"
root=$(dirname "$abi")
replace=0
if [ "${1:-}" = --replace ]; then
  replace=1
  shift
fi
lib=${1:-$root/build/release/src/api/libtoothseg.so}
include=$root/include data=$root/abi/toothseg.json
reference=$abi/reference/toothseg-$(major_of "$root")

"$python" "$abi/describe.py"
"$python" "$abi/make_layout.py"
"$python" "$abi/make_def.py"
if [ -e "$reference.json" ] && [ $replace = 0 ]; then
  "$abi/check.sh" "$lib" || { echo "store.sh: nothing is stored"; exit 1; }
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
types_of "$lib" "$include" >"$work/abi" || { cat "$work/abi"; exit 1; }
symbols_of "$lib" >"$work/symbols"
defaults_of "$lib" "$include" "$data" >"$work/defaults"
"$python" "$abi/describe.py" --bare -o "$work/json"
version=$(sed -n 's/^ "version": "\(.*\)",$/\1/p' "$work/json")
mkdir -p "$abi/reference" "$abi/history/$version"
for kind in abi symbols defaults json; do
  cp "$work/$kind" "$reference.$kind"
done
sed '1s/.*/; What the last release of toothseg.dll exports: kept by store.sh. SPDX-License-Identifier: Apache-2.0/' "$abi/toothseg.def" >"$reference.def"
cp "$include/toothseg.h" "$abi/history/$version/toothseg.h"
echo "stored $version as $reference.*, its header in abi/history/$version: look at the difference, and see abi/README.md for the rest"
