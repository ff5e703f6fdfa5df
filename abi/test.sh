#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# All that guards the ABI, on a library whose API has debug information (cmake -DTOOTHSEG_ABI_INFO=ON).
#   test.sh LIBDIR BUILD_DIR    LIBDIR: has libtoothseg.so; BUILD_DIR: has samples/make-arch, or bin/make-arch
# Last line: N passed, M failed.
set -euo pipefail
. "$(dirname "$0")/facts.sh"
libdir=$(realpath "$1") lib=$libdir/libtoothseg.so
for make_arch in "$2/samples/make-arch" "$2/bin/make-arch"; do [ ! -x "$make_arch" ] || break; done
[ -x "$make_arch" ] || { echo "test.sh: no make-arch in $2"; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/described"
export TS_ABI_DESCRIBED=$work/described # headers that are described again, by the selftest's check.sh above all
major=$(major_of "$(dirname "$abi")")
passed=0 failed=0

# Counts the lines that begin with ok and FAIL; an exit code that goes with neither is a failure as well.
run() {
  local status=0 ok bad
  echo "== $1"
  shift
  "$@" >"$work/said" 2>&1 || status=$?
  cat "$work/said"
  ok=$(grep -c '^ok ' "$work/said" || true)
  bad=$(grep -c '^FAIL ' "$work/said" || true)
  if [ $status != 0 ] && [ "$bad" = 0 ] || [ "$((ok + bad))" = 0 ]; then
    bad=$((bad + 1))
  fi
  passed=$((passed + ok))
  failed=$((failed + bad))
}

# says WHAT TEXT COMMAND...: fails, and says so.
says() {
  local what=$1 text=$2 status=0
  shift 2
  "$@" >"$work/heard" 2>&1 || status=$?
  if [ $status != 0 ] && grep -qF "$text" "$work/heard"; then
    echo "ok    $what: $text"
  else
    echo "FAIL  $what: exit $status, without: $text"
    sed 's/^/      | /' "$work/heard"
  fi
}

# The callers of old against libraries with a fault: each is to be noticed by the caller named.
faults() {
  local fault
  cat >"$work/fault.c" <<'C'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <string.h>
#include "toothseg.h"
#define REAL(type, name) type real = (type)dlsym(RTLD_NEXT, name)
#if FAULT == 0
/* None: what is noticed of the others is not that something stands before the library. */
#elif FAULT == 1
/* Fills more than the caller's struct. */
ts_status ts_save_options_init(ts_save_options *options, uint32_t size) {
  memset(options, 0, size + 4);
  options->struct_size = size;
  return TS_OK;
}
#elif FAULT == 2
/* Forgets a form that was. */
typedef ts_status (*get_info)(const ts_features *, ts_features_info *);
ts_status ts_features_get_info(const ts_features *features, ts_features_info *info) {
  REAL(get_info, "ts_features_get_info");
  return info->struct_size == sizeof *info ? real(features, info) : TS_E_STRUCT_SIZE;
}
#elif FAULT == 3
/* Leaves a field as it is. */
typedef ts_status (*get_jaw)(const ts_segmentation *, ts_jaw_info *);
ts_status ts_get_jaw(const ts_segmentation *segmentation, ts_jaw_info *info) {
  const double confidence = info->confidence;
  REAL(get_jaw, "ts_get_jaw");
  const ts_status status = real(segmentation, info);
  info->confidence = confidence;
  return status;
}
#elif FAULT == 4
/* Another tooth's label. */
typedef ts_status (*get_labels)(const ts_segmentation *, uint32_t *, uint32_t, uint32_t *);
ts_status ts_get_labels(const ts_segmentation *segmentation, uint32_t *labels, uint32_t capacity, uint32_t *count) {
  REAL(get_labels, "ts_get_labels");
  const ts_status status = real(segmentation, labels, capacity, count);
  uint32_t i;
  for (i = 0; labels && status == TS_OK && i < capacity; ++i) labels[i] /= 2;
  return status;
}
#elif FAULT == 5
/* Takes nothing back. */
ts_status ts_undo(ts_segmentation *segmentation) { return segmentation ? TS_OK : TS_E_NULL; }
#endif
C
  for fault in 0: 1:sizes 2:sizes 3:sizes 4:labels 5:session; do
    "${CC:-cc}" -std=gnu99 -w -fPIC -shared -DFAULT="${fault%:*}" -I"$(dirname "$abi")/include" "$work/fault.c" -o "$work/fault.so"
    if [ "$fault" = 0: ]; then
      LD_PRELOAD=$work/fault.so "$abi/run_history.sh" "$libdir" "$make_arch" "" "$work" || echo "FAIL  without a fault"
      continue
    fi
    says "$(sed -n "/FAULT == ${fault%:*}$/{n;s|/\\* \\(.*\\)\\. \\*/|\\1|p}" "$work/fault.c")" "FAIL  0.1.0/${fault#*:}" \
       env LD_PRELOAD="$work/fault.so" "$abi/run_history.sh" "$libdir" "$make_arch" "0.1.0/${fault#*:}" "$work"
  done
}

# What a release keeps belongs together, and its caller of sizes has every struct with a struct_size in every form.
kept() {
  local reference version forms
  for reference in "$abi"/reference/*.json; do
    version=$(sed -n 's/^ "version": "\(.*\)",$/\1/p' "$reference")
    if "$python" "$abi/describe.py" --bare --header "$abi/history/$version/toothseg.h" -o - | cmp - "$reference"; then
      echo "ok    history/$version has the header of $(basename "$reference")"
    else
      echo "FAIL  history/$version has another header than $(basename "$reference")"
    fi
    "$python" -c 'import json, sys
for s in json.load(open(sys.argv[1], encoding="utf-8"))["structs"]:
    if s["versioned"]: print(s["name"])' "$reference" | sort >"$work/structs"
    forms=$(sed -n 's/^ *{"\(ts_[a-z_]*\)", .*/\1/p' "$abi/history/$version/sizes.c" | sort -u)
    if cmp "$work/structs" <(echo "$forms"); then
      echo "ok    history/$version/sizes.c has every struct"
    else
      echo "FAIL  history/$version/sizes.c has not every struct with a struct_size"
    fi
  done
}

refusals() {
  strip -o "$work/libtoothseg.so" "$lib"
  says "a library without debug information" "not all of the interface has debug information" "$abi/check.sh" "$work/libtoothseg.so"
  says "none" "no library" "$abi/check.sh" "$work/none.so"
}

# store.sh, in a copy of the project.
stored() {
  local copy=$work/project kind
  mkdir -p "$copy"
  cp -r "$abi" "$(dirname "$abi")/include" "$copy"
  "$copy/abi/store.sh" "$lib" >"$work/heard" || { cat "$work/heard"; return 1; }
  for kind in json symbols defaults; do
    cmp "$copy/abi/reference/toothseg-$major.$kind" "$abi/reference/toothseg-$major.$kind" || return 1
  done
  "$copy/abi/check.sh" "$lib" >"$work/heard" || { cat "$work/heard"; return 1; }
  echo "ok    stored anew it is the same"
  sed -i.before 's/^  uint32_t open_rims;/  uint32_t rims;/' "$copy/include/toothseg.h"
  says "a break is not stored" "store.sh: nothing is stored" "$copy/abi/store.sh" "$lib"
  "$copy/abi/store.sh" --replace "$lib" >"$work/heard" || { cat "$work/heard"; return 1; }
  "$copy/abi/check.sh" "$lib" >"$work/heard" || { cat "$work/heard"; return 1; }
  echo "ok    with --replace it is"
}

run "the library, beside the last release" "$abi/check.sh" "$lib"
run "what is refused" refusals
run "the reference, stored" stored
run "rules" "$python" "$abi/test_compare.py"
run "changes, made to copies" "$abi/selftest.sh"
run "what releases keep" kept
run "callers of all releases" "$abi/run_history.sh" "$libdir" "$make_arch" "" "$work"
run "faults that they notice" faults
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
