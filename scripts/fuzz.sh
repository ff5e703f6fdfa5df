#!/usr/bin/env bash
# Fuzzes: fuzz.sh TARGET|all SECONDS [CORPUS]. Targets: stl ply obj off mesh pipeline session calls. Seconds are for each. What was
# found goes to build/fuzz/found; the corpus (build/fuzz/corpus unless given) grows and is kept; inputs of tests/fuzz/regressions
# run first. As many targets at once as there are processors. Fails if anything is found.
set -euo pipefail
cd "$(dirname "$0")/.."
all="stl ply obj off mesh pipeline session calls"
[ $# -ge 2 ] || { echo "usage: fuzz.sh TARGET|all SECONDS [CORPUS]; targets: $all" >&2; exit 2; }
targets=$1 seconds=$2 corpus=${3:-build/fuzz/corpus}
[ "$targets" != all ] || targets=$all
scripts/install_deps.sh fuzz
jobs=$(nproc)
cmake --preset asan >/dev/null
cmake --build --preset asan -j "$jobs" --target fuzzers
found=$PWD/build/fuzz/found
mkdir -p "$found"
[ -d "$corpus" ] || build/asan/tests/fuzz/make_corpus "$corpus"

# fuzz TARGET: a line of what became of it; fails if something was found.
fuzz() {
  local target=$1 log=build/fuzz/$1.log dict=() seeds=("$corpus/$1") failed=0 runs cover
  case $target in
    stl | ply | obj | off) dict=(-dict=tests/fuzz/files.dict) ;;
    session) dict=(-dict=tests/fuzz/session.dict) ;;
  esac
  mkdir -p "$corpus/$target"
  [ ! -d "tests/fuzz/regressions/$target" ] || seeds+=("tests/fuzz/regressions/$target")
  if ! build/asan/tests/fuzz/fuzz_"$target" ${dict[@]+"${dict[@]}"} -max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 \
    -max_len=16384 -artifact_prefix="$found/$target-" -print_final_stats=1 "${seeds[@]}" >"$log" 2>&1; then
    failed=1
    grep -aE 'does not hold|ERROR|SUMMARY|last message|runtime error' "$log" | head -8
  fi
  runs=$(grep -a 'number_of_executed_units' "$log" | awk '{print $2}')
  cover=$(grep -aoE 'cov: [0-9]+' "$log" | tail -1)
  echo "$target: ${runs:-0} runs, ${cover:-cov: ?}"
  return $failed
}
export -f fuzz
export corpus found seconds
# shellcheck disable=SC2086
if printf '%s\n' $targets | xargs -n 1 -P "$jobs" bash -c 'fuzz "$0"'; then
  echo "nothing found"
else
  echo "something was found: $found"
  exit 1
fi
