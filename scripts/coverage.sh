#!/usr/bin/env bash
# Which lines and branches of src/ run: coverage.sh [CORPUS]. First of the fuzzers alone, on their corpus (build/fuzz/corpus unless
# given; scripts/fuzz.sh lets it grow) and on what they found, then of those and the tests in C and C++. Prints a table a room;
# pages with every line and branch are in build/coverage/html.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh coverage
corpus=$(realpath "${1:-build/fuzz/corpus}")
build=$PWD/build/coverage
jobs=$(nproc)
cmake --preset coverage >/dev/null
cmake --build --preset coverage -j "$jobs" >/dev/null
scripts/build_installed.sh "$build" tests/c -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 \
  -DCMAKE_EXE_LINKER_FLAGS=-fprofile-instr-generate >/dev/null
rm -rf "$build/profiles" "$build/html"
mkdir -p "$build/profiles/fuzzers" "$build/profiles/tests"

# run GROUP NAME PROGRAM...: fails as the program does.
run() {
  local group=$1 name=$2
  shift 2
  LLVM_PROFILE_FILE="$build/profiles/$group/$name-%p.profraw" "$@" >"$build/profiles/$name.log" 2>&1 ||
    { echo "coverage.sh: $name failed: $build/profiles/$name.log" >&2; return 1; }
}
programs=()
for target in stl ply obj off mesh pipeline session calls; do
  program=$build/tests/fuzz/fuzz_$target inputs=()
  for folder in "$corpus/$target" "tests/fuzz/regressions/$target"; do [ ! -d "$folder" ] || inputs+=("$folder"); done
  programs+=("$program")
  run fuzzers "$target" "$program" -runs=0 -timeout=60 "${inputs[@]}"
done

# table PROFILES: lines and branches a room.
table() {
  llvm-profdata-14 merge -sparse "$@" -o "$build/coverage.profdata"
  llvm-cov-14 export -summary-only -instr-profile "$build/coverage.profdata" "${programs[0]}" "${programs[@]/#/-object=}" |
    python3 -c '
import json, sys
rooms = {}
for file in json.load(sys.stdin)["data"][0]["files"]:
    path = file["filename"]
    if "/src/" not in path or not path.startswith(sys.argv[1]):
        continue
    for room in (path.split("/src/")[1].split("/")[0], "all"):
        sums = rooms.setdefault(room, [0, 0, 0, 0])
        for i, (kind, what) in enumerate([("lines", "covered"), ("lines", "count"), ("branches", "covered"), ("branches", "count")]):
            sums[i] += file["summary"][kind][what]
print("%-10s %18s %22s" % ("room", "lines", "branches"))
for room in "base mesh geometry features field cut tooth api all".split():
    a, b, c, d = rooms[room]
    print("%-10s %6d / %d %5.1f %% %7d / %d %5.1f %%" % (room, a, b, 100 * a / b, c, d, 100 * c / d))
' "$PWD/src/"
}
echo "the fuzzers alone"
table "$build"/profiles/fuzzers/*.profraw

reliability=$build/tests/reliability work=$build/profiles
for room in base mesh geometry features field cut tooth; do
  programs+=("$build/tests/$room/test_$room")
  run tests "$room" "$build/tests/$room/test_$room"
done
for name in faults cancel numbers many_threads thread_rules mutate; do
  program=$reliability/test_$name arguments=()
  case $name in
    faults) arguments=("$work" --quick) ;;
    cancel) arguments=("$work" abi/toothseg.json) ;;
    thread_rules) arguments=(abi/toothseg.json "$work") ;;
    mutate) program=$reliability/mutate arguments=(1000) ;;
  esac
  programs+=("$program")
  run tests "$name" "$program" ${arguments[@]+"${arguments[@]}"}
done
for program in "$build"/consumer/c_*; do
  [ -x "$program" ] && [ -f "$program" ] || continue
  programs+=("$program")
done
LLVM_PROFILE_FILE="$build/profiles/tests/c-%p.profraw" ctest --test-dir "$build/consumer" -j "$jobs" >"$work/c.log" 2>&1 ||
  { echo "coverage.sh: a test in C failed: $work/c.log" >&2; exit 1; }
echo "the fuzzers, the rooms' tests, tests/reliability and tests/c"
table "$build"/profiles/*/*.profraw
llvm-cov-14 show -format=html -show-branches=count -instr-profile "$build/coverage.profdata" -output-dir "$build/html" \
  "${programs[0]}" "${programs[@]/#/-object=}" "$PWD/src" >/dev/null
echo "$build/html/index.html"
