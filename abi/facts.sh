# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# What there is to know of a library, as functions for check.sh and store.sh: each writes to standard output. Sourced.
export LC_ALL=C
abi=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
python=/usr/bin/python3 # the one that python3-clang-14 is for

fail() {
  echo "$*"
  return 1
}

major_of() { sed -n 's/^#define TS_VERSION_MAJOR \([0-9]*\)$/\1/p' "$1/include/toothseg.h"; }

soname_of() { readelf -d "$1" | sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p'; }

# Functions of a description, as symbols_of has them.
declared_in() {
  "$python" -c 'import json, sys
for f in json.load(open(sys.argv[1], encoding="utf-8"))["functions"]: print("T", f["name"] + "@@TS_" + sys.argv[2])' "$1" "$2" |
    sort
}

# Names and versions of all that is exported, beside the version node itself.
symbols_of() {
  nm -D --defined-only "$1" | awk '$2 != "A" {print $2, $3}' | sort
}

# Functions and public types, by the debug information. What the public header does not define (the insides of handles, C++) is
# private and left out, and so is all that differs from build to build: folders, lines, needed libraries.
types_of() {
  local lib=$1 include=$2 out
  out=$(timeout 120 abidw --headers-dir "$include" --drop-private-types --no-corpus-path --no-comp-dir-path --no-show-locs \
    --no-elf-needed --no-parameter-names --no-write-default-sizes --type-id-style hash --exported-interfaces-only \
    "$lib" | sed -E "s|( path='[^']*)/([^/']*')| path='\2|") || return 1
  # A function without debug information would not be compared.
  [ "$(grep -c ' elf-symbol-id=' <<<"$out")" = "$(grep -c '<elf-symbol name' <<<"$out")" ] ||
    fail "$lib: not all of the interface has debug information. Build with: cmake -DTOOTHSEG_ABI_INFO=ON" || return 1
  printf '%s\n' "$out"
}

# Options as their init functions fill them.
defaults_of() {
  local lib=$1 include=$2 data=$3 work
  work=$(mktemp -d)
  (
    trap 'rm -rf "$work"' EXIT
    name=$(soname_of "$lib")
    ln -s "$(realpath "$lib")" "$work/$name" &&
      "$python" "$abi/make_defaults.py" "$data" >"$work/defaults.c" &&
      "${CC:-cc}" -std=c99 -Wall -Wextra -pedantic -Werror -I"$include" "$work/defaults.c" -o "$work/defaults" "$work/$name" &&
      LD_LIBRARY_PATH=$work "$work/defaults"
  )
}
