#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Pascal binding on toothseg.dll under Wine: pascal.sh BUILD. Debian's Free Pascal compiles for Windows by itself, and has the
# run-time library for it as source: that is built first. WINEPREFIX and WINEPATH as test.sh sets them. Last line: N passed, M failed.
set -uo pipefail
build=$(cd "$1" && pwd)
pascal=$(cd "$(dirname "$0")/../../bindings/pascal" && pwd)
work=$build/pascal units=$build/pascal/units scan=arch.ply labels=labels.txt
rm -rf "$work"
mkdir -p "$units" "$work/teeth"
. "$pascal/../../tests/support/counts.sh"

# -n: without the settings for Linux.
windows() { ppcx64 -n -Twin64 -O2 -v0e -FU"${to:-$work}" -FE"${to:-$work}" -Fu"$units" "$@"; }
runtime() {
  local rtl inc to=$units
  rtl=$(ls -d /usr/share/fpcsrc/*/rtl | tail -n 1) || return 1
  inc=(-Fi../inc -Fi../x86_64 -Fi../win -Fi../win/wininc -Fi../objpas/sysutils -Fi../objpas/classes -Fi../objpas)
  cd "$rtl/win64" && windows "${inc[@]}" -Us -Sg system.pp && windows "${inc[@]}" ../inc/uuchar.pp &&
    windows "${inc[@]}" ../objpas/objpas.pp &&
    windows "${inc[@]}" -Fu../inc -Fu../x86_64 -Fu../win -Fu../win/wininc -Fu../objpas buildrtl.pp && cd "$work"
}
compile() { windows -Fu"$pascal/src" -Fi"$pascal/tests" "$@"; }

check "the run-time library" runtime
cd "$work" || exit 1
check "compile the tests" compile -Ct -Cr -Co "$pascal/tests/test_toothseg.pas"
check "compile unmasked" compile "$pascal/tests/unmasked.pas"
check "compile hello_tooth" compile "$pascal/samples/hello_tooth.pas"
check "compile segment_arch" compile "$pascal/samples/segment_arch.pas"
# The scans that bindings/pascal/test.sh has.
check "arch" wine "$build/samples/make-arch.exe" "$scan" --triangles 20000 --seed 1
check "small arch" wine "$build/samples/make-arch.exe" small.ply --triangles 6000 --seed 2
check "ts-segment" wine "$build/samples/ts-segment.exe" "$scan" --labels "$labels"
check "segment_arch" wine segment_arch.exe "$scan" --labels clicks.txt --teeth teeth
# Written as text by the system's ends of lines.
check "its labels are ts-segment's" bash -c 'cmp <(tr -d "\r" <clicks.txt) <(tr -d "\r" <"$1")' - "$labels"
check "no scan is a complaint" fails wine segment_arch.exe none.ply
check "hello_tooth" wine hello_tooth.exe "$scan"
check "floating-point exceptions masked" wine unmasked.exe "$scan" masked
timeout 300 wine test_toothseg.exe "$scan" "$labels" small.ply "$(wine winepath -w "$work/" 2>/dev/null | tr -d '\r')" >results 2>&1
sed '$d' results
add_counts test_toothseg results
finish
