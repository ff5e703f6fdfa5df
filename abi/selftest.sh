#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Whether check.sh catches what breaks old callers, and lets pass what does not: each change is made to a copy of the header, or
# to how a library of it is linked. The libraries are skeletons (make_skeleton.py), the reference is that of the unchanged one.
#   selftest.sh
set -euo pipefail
. "$(dirname "$0")/facts.sh"
root=$(dirname "$abi")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
base=$work/base
real_defaults=$(ls "$abi"/reference/toothseg-"$(major_of "$root")".defaults)
bad=0

# Describes the header in a folder as a developer would, and makes a library of it: libtoothseg.so.
build() {
  local at=$1
  "$python" "$abi/describe.py" --header "$at/include/toothseg.h" -o "$at/abi/toothseg.json"
  "$python" "$abi/make_layout.py" --json "$at/abi/toothseg.json" -o "$at/abi/layout.c"
  "$python" "$abi/make_skeleton.py" "$at/abi/toothseg.json" "$at/defaults" >"$at/skeleton.c"
  cat "$at/more.c" >>"$at/skeleton.c"
  "${CC:-cc}" -std=c99 -Wall -Wextra -Werror -g -fPIC -fvisibility=hidden -I"$at/include" -shared \
    -Wl,-soname,"$(cat "$at/soname")" -Wl,--version-script="$at/toothseg.map" "$at/skeleton.c" -o "$at/libtoothseg.so"
}

# edit FILE SED: a change that changes nothing is a fault of this script.
edit() {
  sed -i.before -E "$2" "$at/$1"
  ! cmp -s "$at/$1" "$at/$1.before" || { echo "selftest.sh: nothing in $1 is changed by: $2"; exit 1; }
}
header() { edit include/toothseg.h "$1"; }

# The table begins with ok or FAIL: whether it came out as expected.
row() { printf '%-5s %-42s %-9s %-9s %s\n' "$@"; }
verdict() { [ "$1" = - ] && echo passes || echo caught; }

# change WHAT CHECKS COMMAND...: after COMMAND exactly CHECKS have to fail; "-" for none.
change() {
  local what=$1 expected=$2 got status=0 at=$work/changed
  shift 2
  rm -rf "$at"
  cp -r "$base" "$at"
  "$@"
  build "$at"
  "$abi/check.sh" --root "$at" "$at/libtoothseg.so" >"$at/said" || status=$?
  got=$(sed -n 's/^check.sh: failed: //p' "$at/said")
  [ $status = 0 ] && got=-
  if [ "$got" = "$expected" ]; then
    row ok "$what" "$(verdict "$expected")" "$(verdict "$got")" "$got"
  else
    row FAIL "$what" "$(verdict "$expected")" "$(verdict "$got")" "$got (expected: $expected)"
    sed 's/^/      | /' "$at/said"
    bad=1
  fi
}

mkdir -p "$base/include" "$base/abi/reference"
cp "$root/include/toothseg.h" "$base/include/"
cp "$root/src/api/toothseg.map" "$base/"
cp "$real_defaults" "$base/defaults"
echo "libtoothseg.so.$(major_of "$root")" >"$base/soname"
echo 'struct ts_job { int inside; };' >"$base/more.c"
build "$base"
reference=$base/abi/reference/toothseg-$(major_of "$base")
types_of "$base/libtoothseg.so" "$base/include" >"$reference.abi"
symbols_of "$base/libtoothseg.so" >"$reference.symbols"
defaults_of "$base/libtoothseg.so" "$base/include" "$base/abi/toothseg.json" >"$reference.defaults"
"$python" "$abi/describe.py" --bare --header "$base/include/toothseg.h" -o "$reference.json"
cmp "$reference.defaults" "$real_defaults" || { echo "selftest.sh: the skeleton's defaults are not those it was given"; exit 1; }

leak() {
  edit toothseg.map 's/global: ts_\*;/global: ts_*; _ZN*;/'
  echo '__attribute__((visibility("default"))) int _ZN2ts4leakEv(void); int _ZN2ts4leakEv(void) { return 0; }' >>"$at/more.c"
}
next_major() {
  header 's/^(#define TS_VERSION_MAJOR) [0-9]+$/\1 99/'
  edit soname 's/[0-9]+$/99/'
}
all_allowed() { header "$new_function;$appended;$grown"; }
new_function='s/^TS_API void ts_mesh_destroy\(/TS_API TS_NODISCARD ts_status ts_mesh_weigh(const ts_mesh *mesh, double *gram);\n&/'
grown='s/^} ts_save_options;/  uint32_t added;\n&/; s/^} ts_mesh_info;/  double added;\n&/'
appended='s/^( *TS_OUTPUT_GLB = )3,/\13, TS_OUTPUT_ADDED = 1000,/; s/^( *TS_E_MISMATCH = )105,/\1105, TS_E_ADDED = 149,/'

row "" change expected got "caught by"
change "nothing" - true
change "enum value inserted" "layout compare types" header 's/^( *)TS_OUTPUT_GLB = 3,/\1TS_OUTPUT_ADDED = 3, TS_OUTPUT_GLB = 4,/'
change "enum values swapped" "layout compare types" header 's/TS_OUTPUT_OBJ = 2/TS_OUTPUT_OBJ = 3/; s/TS_OUTPUT_GLB = 3/TS_OUTPUT_GLB = 2/'
change "status renumbered" "layout compare types" header 's/TS_E_CANCELLED = 201/TS_E_CANCELLED = 203/'
change "macro value changed" "layout compare" header 's/^#define TS_NONE UINT32_MAX/#define TS_NONE 4294967294/'
change "struct grown in the middle" "layout compare types" header 's/^  double fill_area;/  double added;\n&/'
change "struct grown within its padding" "compare types" header 's/^} ts_contour_info;/  uint32_t added;\n&/'
change "struct grown that has no struct_size" "layout compare types" header 's/^} ts_contour_info;/  double added;\n&/'
change "struct grown, and a field of it retyped" "compare types" header "$grown; s/^  uint32_t open_rims;/  int32_t open_rims;/"
change "field retyped, of the same size" "compare types" header 's/^  uint32_t open_rims;/  int32_t open_rims;/'
change "field renamed" "layout compare" header 's/^  uint32_t open_rims;/  uint32_t rims;/'
change "argument added" "compare types" header 's/(ts_tooth_merge\(.*)uint32_t other,/\1uint32_t other, uint32_t how,/'
change "callback retyped" "compare types" header 's/(\*ts_progress_fn\)\()double/\1float/'
change "function gone" "compare symbols types" header '/^TS_API void ts_job_reset\(/d'
change "symbol dropped" "symbols types" edit toothseg.map 's/local:/local: ts_job_reset;/'
change "C++ symbol leaked" "symbols" leak
change "SONAME changed" "soname types" edit soname 's/[0-9]+$/99/'
change "major version and SONAME changed" "reference" next_major
change "default changed" "defaults" edit defaults '/^ts_segment_options\(TS_PRESET_DEFAULT\).alpha/s/=.*/= 1/'
change "inside of a handle changed" - edit more.c 's/int inside/double inside[3]/'
change "function added" - header "$new_function"
change "struct grown at the end" - header "$grown"
change "enum value appended" - header "$appended"
change "these three" - all_allowed
[ $bad = 0 ] || { echo "selftest.sh: not all as expected"; exit 1; }
