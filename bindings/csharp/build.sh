#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh OUT: builds OUT/Toothseg.dll and the samples with Debian's mcs (mono-mcs). SPAN=1: with the overloads that take spans.
#
# mcs knows no nullable annotations (C# 8): they are taken out of a copy. In these sources a ? right behind a type and before
# a blank, comma, bracket is one; that of a conditional expression has a blank before it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:?usage: build.sh OUT}
mkdir -p "$out/plain"
for source in "$here"/Toothseg/*.cs; do
  sed -E 's/^#nullable .*//; s/([A-Za-z0-9_>]|\])\?([ ,)>])/\1\2/g; s/([a-z])!([.(])/\1\2/g' "$source" >"$out/plain/$(basename "$source")"
done
define=()
[ "${SPAN:-0}" = 0 ] || define=(-define:TOOTHSEG_SPAN)
mcs -nologo -unsafe -optimize -warnaserror -warn:4 -nowarn:1591,0649 -target:library "${define[@]}" -doc:"$out/Toothseg.xml" -out:"$out/Toothseg.dll" "$out"/plain/*.cs
for sample in "$here"/samples/*.cs; do
  mcs -nologo -optimize -warnaserror -r:"$out/Toothseg.dll" -out:"$out/$(basename "$sample" .cs).exe" "$sample"
done
rm -r "$out/plain"
