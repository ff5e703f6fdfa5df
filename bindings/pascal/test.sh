#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh LIBDIR BINDIR: all tests of the Pascal binding. LIBDIR has libtoothseg.so, BINDIR ts-segment and make-arch.
# The last line is `N passed, M failed`.
set -uo pipefail
[ $# = 2 ] || { echo "usage: test.sh LIBDIR BINDIR" >&2; exit 2; }
lib=$(cd "$1" && pwd) bin=$(cd "$2" && pwd) here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LD_LIBRARY_PATH=$lib
. "$here/../../tests/support/counts.sh"

compile() { # program, name, options...
  local source=$1 name=$2
  shift 2
  mkdir -p "$work/units-$name"
  fpc -O2 -l- -v0ew -vm5036,5027,5093,5094 "$@" -Fu"$here/src" -Fi"$here/tests" -FU"$work/units-$name" -FE"$work" -o"$work/$name" \
    -Fl"$lib" -k"-rpath=$lib" "$source"
}

# The generated files.
check "generate.py --check" python3 "$here/generate.py" --check
check "a later JSON" python3 "$here/tests/grown.py" "$here/../../abi/toothseg.json" "$work/grown.json"
check "--check sees it" fails python3 "$here/generate.py" --check --json "$work/grown.json"
check "units for it" python3 "$here/generate.py" --json "$work/grown.json" --out "$work/grown"
check "they compile" fpc -l- -v0ew -Fu"$work/grown/src" -Fi"$work/grown/tests" -FU"$work/grown" -o"$work/test_grown" \
  -Fl"$lib" "$here/tests/test_grown.pas"
check "their layouts" "$work/test_grown"

# The programs.
check "compile the tests" compile "$here/tests/test_toothseg.pas" test_toothseg -Ct -Cr -Co
check "compile unmasked" compile "$here/tests/unmasked.pas" unmasked
check "compile hello_tooth" compile "$here/samples/hello_tooth.pas" hello_tooth
check "compile segment_arch" compile "$here/samples/segment_arch.pas" segment_arch
check "compile for a library found at run time" compile "$here/samples/hello_tooth.pas" hello_dynamic -dTOOTHSEG_DYNAMIC

# Synthetic arches, and what ts-segment makes of one.
check "arch" "$bin/make-arch" "$work/arch.ply" --triangles 20000 --seed 1
check "small arch" "$bin/make-arch" "$work/small.ply" --triangles 6000 --seed 2
check "large arch" "$bin/make-arch" "$work/large.ply" --triangles 60000 --seed 3
check "ts-segment" "$bin/ts-segment" "$work/arch.ply" --labels "$work/labels.txt"

# The samples.
check "segment_arch" "$work/segment_arch" "$work/arch.ply" --labels "$work/clicks.txt" --teeth "$work/teeth"
check "its labels are ts-segment's" cmp "$work/labels.txt" "$work/clicks.txt"
check "its teeth" test "$(find "$work/teeth" -name 'tooth_*.stl' -size +1k 2>/dev/null | wc -l)" = 14
check "segment_arch --all" "$work/segment_arch" "$work/arch.ply" --all --labels "$work/all.txt" --threads 1
check "its labels are the same" cmp "$work/labels.txt" "$work/all.txt"
check "no scan is a complaint" fails "$work/segment_arch" "$work/none.ply"
check "hello_tooth" "$work/hello_tooth" "$work/arch.ply"
"$work/hello_tooth" "$work/arch.ply" >"$work/cut.txt"
read -r x y z <"$work/cut.txt"
check "hello_tooth at a point" "$work/hello_tooth" "$work/arch.ply" "$x" "$y" "$z"
TOOTHSEG_LIBRARY=$lib/libtoothseg.so check "hello_tooth, library by TOOTHSEG_LIBRARY" "$work/hello_dynamic" "$work/arch.ply"
TOOTHSEG_LIBRARY=$lib/libtoothseg.so "$work/hello_dynamic" "$work/arch.ply" >"$work/dynamic.txt"
check "gives the same" cmp "$work/cut.txt" "$work/dynamic.txt"
TOOTHSEG_LIBRARY=$work/none.so check "no library is a complaint" fails "$work/hello_dynamic" "$work/arch.ply"

# Strings of UTF-16, as Delphi's are.
utf16() {
  mkdir -p "$work/utf16/src" && cp "$here"/src/*.pas "$work/utf16/src" && cp "$here/samples/hello_tooth.pas" "$work/utf16" &&
    sed -i 's/{\$MODE DELPHI}/{$MODE DELPHIUNICODE}/' "$work"/utf16/*.pas "$work"/utf16/src/*.pas &&
    fpc -l- -v0e -dUNICODE -Fu"$work/utf16/src" -FE"$work/utf16" -Fl"$lib" -k"-rpath=$lib" "$work/utf16/hello_tooth.pas" &&
    "$work/utf16/hello_tooth" "$work/arch.ply" >"$work/utf16/cut.txt" &&
    cmp "$work/cut.txt" "$work/utf16/cut.txt"
}
check "strings of UTF-16" utf16

# Ctrl-C: as soon as there is progress.
interrupt() {
  "$work/segment_arch" "$work/large.ply" --all --labels "$work/interrupted.txt" 2>"$work/progress" &
  local run=$!
  while [ ! -s "$work/progress" ] && kill -0 $run; do sleep 0.01; done
  kill -INT $run
  wait $run
  [ $? = 130 ] && [ ! -e "$work/interrupted.txt" ] && grep -q cancelled "$work/progress"
}
check "Ctrl-C" interrupt

# What happens without the care that toothseg.pas takes.
check "floating-point exceptions masked" "$work/unmasked" "$work/arch.ply" masked
check "not masked" fails "$work/unmasked" "$work/arch.ply"

"$work/test_toothseg" "$work/arch.ply" "$work/labels.txt" "$work/small.ply" "$work/" >"$work/results" 2>&1
sed '$d' "$work/results"
add_counts test_toothseg "$work/results"
finish
