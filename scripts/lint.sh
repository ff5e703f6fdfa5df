#!/usr/bin/env bash
# Reads the source for faults: lint.sh [--quick]. Form (clang-format), the order of the rooms, cppcheck, clang-tidy; a line a step,
# and fails on any finding. clang-tidy takes ten seconds for what a file includes and a fifth of one for the file itself: those of a
# target are read at once, and the other steps go on beside it. A plug-in (lint_scope.cpp) keeps it from seeking
# in system headers what it would not report of them: that took three quarters of its time. --quick is for CI: clang-tidy reads src/
# and synth/, without the analyzer's paths (clang-analyzer-*); samples/ is left out.
set -euo pipefail
cd "$(dirname "$0")/.."
quick=0
case ${1:-} in
  "") ;;
  --quick) quick=1 ;;
  *) echo "usage: lint.sh [--quick]" >&2; exit 2 ;;
esac
scripts/install_deps.sh lint
build=build/lint
jobs=$(nproc)

# step NAME COMMAND...: its output only where it found something, which $build/failed then names.
step() {
  local name=$1 log=$build/$1.log begin=$SECONDS said=clean
  shift
  "$@" >"$log" 2>&1 || said=FAILED
  [ $said = clean ] || { cat "$log" && echo "$name" >>"$build/failed"; }
  echo "$name: $said, $((SECONDS - begin)) s"
}

# Ours and not generated. toothseg.h is the manual: its tables are aligned by hand.
sources() { git ls-files -- "$@" | grep -vE '^(abi/layout\.c|abi/history/.*|include/toothseg\.h)$'; }

form() { sources '*.c' '*.cpp' '*.h' '*.hpp' | xargs clang-format-14 --dry-run -Werror; }

# A room includes only rooms before it, and only api knows the header.
rooms() {
  local order="base mesh geometry features field cut tooth api" later room bad=0
  later=$order
  for room in $order; do
    later=${later#"$room"} later=${later# }
    [ -n "$later" ] || break
    grep -rnE "#include \"(${later// /|})/" "src/$room" && bad=1
    grep -rnE '#include [<"]toothseg\.' "src/$room" && bad=1
  done
  return $bad
}

check() { cppcheck -j "$jobs" --quiet --inline-suppr --suppressions-list=.cppcheck-suppressions --error-exitcode=1 \
  --enable=warning,performance,portability -Iinclude -Isynth/include "$@"; }
cppcheck_cpp() { check --language=c++ --std=c++20 -Isrc src include samples/cpp; }
cppcheck_c() { check --language=c --std=c99 samples/c; }

# units FOLDERS: what the build compiles of them.
units() {
  python3 - "$build/compile_commands.json" "$@" <<'EOF'
import json, os, sys
root, build = os.getcwd(), os.path.join(os.getcwd(), "build/lint")
for file in sorted({entry["file"] for entry in json.load(open(sys.argv[1]))}):
    at = os.path.relpath(file, build if file.startswith(build + "/") else root)
    if at.split("/")[0] in sys.argv[2:]:
        print(file)
EOF
}
scope() { c++ -std=c++17 -fno-rtti -fPIC -shared -I/usr/lib/llvm-14/include scripts/lint_scope.cpp -o "$build/lint_scope.so"; }
tidy() {
  units "$@" | xargs -P "$jobs" -n 1 clang-tidy-14 --load "$build/lint_scope.so" --quiet -p "$build" ${options[@]+"${options[@]}"}
}
# Samples and C tests are projects of their own, which need no more than the headers.
tidy_samples() {
  sources 'samples/c/*.c' | xargs -P "$jobs" -n 4 sh -c 'clang-tidy-14 --quiet "$@" -- -std=c99 -Iinclude -Isynth/include' tidy
  sources 'samples/cpp/*.cpp' | xargs -P "$jobs" -n 2 sh -c 'clang-tidy-14 --quiet "$@" -- -std=c++17 -Iinclude -Isynth/include' tidy
}

mkdir -p "$build"
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTOOTHSEG_BUILD_TESTS=OFF -DTOOTHSEG_BUILD_BENCH=OFF \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 >/dev/null
rm -f "$build/failed"
{
  step form form
  step rooms rooms
  step cppcheck_c cppcheck_c
  step cppcheck_cpp cppcheck_cpp
} &
options=()
scope
if [ $quick = 1 ]; then
  options=(--checks=-clang-analyzer-*)
fi
step tidy tidy src synth
[ $quick = 1 ] || step tidy_samples tidy_samples
wait
[ ! -e "$build/failed" ]
