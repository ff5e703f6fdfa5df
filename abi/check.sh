#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Whether callers of the last release can go on with this library: abi/README.md has the rules.
#   check.sh [--root DIR] [LIB]    LIB: libtoothseg.so, its API with debug information. Default: build/release
#                                  DIR: has include/toothseg.h, abi/toothseg.json, abi/layout.c and abi/reference. Default: the project
# All checks are run; the last line names those that failed.
set -euo pipefail
. "$(dirname "$0")/facts.sh"
root=$(dirname "$abi")
if [ "${1:-}" = --root ]; then
  root=$(realpath "$2")
  shift 2
fi
lib=${1:-$root/build/release/src/api/libtoothseg.so}
include=$root/include data=$root/abi/toothseg.json
major=$(major_of "$root")
reference=$root/abi/reference/toothseg-$major
[ -e "$lib" ] || { echo "check.sh: no library $lib"; exit 2; }
[ -e "$reference.json" ] || {
  echo "check.sh: no reference for major version $major ($reference.json)."
  echo "A new major version, and with it a new SONAME, is a decision: see abi/README.md. It begins with abi/store.sh."
  echo "check.sh: failed: reference"
  exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=""

# check NAME COMMAND...: its output is shown where it fails, and what the comparison of descriptions says always.
check() {
  local name=$1
  shift
  if "$@" >"$work/said" 2>&1; then
    echo "ok    $name"
    [ "$name" != compare ] || sed 's/^/      /' "$work/said"
  else
    echo "FAIL  $name"
    sed 's/^/      /' "$work/said"
    failed="$failed $name"
  fi
}

data() { "$python" "$abi/describe.py" --check --header "$include/toothseg.h" -o "$data"; }

# The header as compilers see it is what the data say, and what the data of the last release say.
layout() {
  local flags=(-Wall -Wextra -pedantic -Werror -fsyntax-only -I"$include") own="$root/abi/layout.c" target
  "$python" "$abi/make_layout.py" --check --json "$data" -o "$own" || return 1
  "$python" "$abi/make_layout.py" --released --json "$reference.json" -o "$work/released.c" || return 1
  "${CC:-cc}" -std=c99 "${flags[@]}" "$own" && "${CXX:-c++}" -std=c++17 -x c++ "${flags[@]}" "$own" || return 1
  for target in x86_64-w64-windows-gnu wasm32-unknown-unknown; do
    "${CLANG:-clang-14}" -target "$target" -ffreestanding -nostdlibinc -std=c99 "${flags[@]}" "$own" || return 1
  done
  "${CC:-cc}" -std=c99 "${flags[@]}" "$work/released.c" ||
    fail "The header has no longer the layout of the last release. Undo it, or add what is new beside what is there."
}

compare() { "$python" "$abi/compare.py" "$reference.json" "$data" "$work/grown"; }

soname() {
  local is
  is=$(soname_of "$lib")
  [ "$is" = "libtoothseg.so.$major" ] ||
    fail "SONAME is $is, and has to be libtoothseg.so.$major: TS_VERSION_MAJOR of the header and SOVERSION in src/api/CMakeLists.txt" \
      "go together, and neither changes while old programs run"
}

# Functions of the header, and nothing else, in the version node of the SONAME; with all of the last release.
symbols() {
  local bad=0 lines
  declared_in "$data" "$major" >"$work/declared"
  symbols_of "$lib" >"$work/symbols"
  lines=$(comm -13 "$work/declared" "$work/symbols")
  [ -z "$lines" ] || { echo "Exported, and no function of toothseg.h (version script: src/api/toothseg.map):
$lines" && bad=1; }
  lines=$(comm -23 "$work/declared" "$work/symbols")
  [ -z "$lines" ] || { echo "In toothseg.h, and not exported (define it in src/api):
$lines" && bad=1; }
  lines=$(comm -23 "$reference.symbols" "$work/symbols")
  [ -z "$lines" ] || { echo "Exported by the last release, and no longer (bring it back):
$lines" && bad=1; }
  return $bad
}

types() {
  types_of "$lib" "$include" >"$work/types.abi" || { cat "$work/types.abi"; return 1; }
  # Without --no-added-syms the functions that are new would fail; `symbols` sees to them. Both sides are descriptions: with a
  # library on one side, types whose place in the source is not stored count as private, and their changes as none.
  timeout 120 abidiff --no-added-syms --suppressions "$work/grown" "$reference.abi" "$work/types.abi" ||
    fail "abidiff: $?. Compiled callers of the last release would not get on with this. Undo it, or add what is new beside it."
}

defaults() {
  local lines
  defaults_of "$lib" "$include" "$data" >"$work/defaults" || { cat "$work/defaults"; return 1; }
  lines=$(grep -vxFf "$work/defaults" "$reference.defaults" || true)
  [ -z "$lines" ] || {
    echo "Defaults of the last release that are others now. Keep them: callers get other results. A better set is a new preset."
    while IFS= read -r line; do
      echo "was: $line"
      echo "is:  $(grep -F "${line%% = *} = " "$work/defaults" || echo gone)"
    done <<<"$lines"
    return 1
  }
}

: >"$work/grown"
check data data
check layout layout
check compare compare
check soname soname
check symbols symbols
check types types
check defaults defaults
[ -z "$failed" ] || { echo "check.sh: failed:$failed"; exit 1; }
echo "check.sh: $(soname_of "$lib") is what callers of $(sed -n 's/^ "version": "\(.*\)",$/\1/p' "$reference.json") expect"
