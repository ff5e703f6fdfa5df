#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# test.sh LIBDIR BINDIR: all tests of the Rust binding. LIBDIR holds libtoothseg, with ../include beside it; BINDIR
# ts-segment and make-arch. CARGO and RUSTC choose another compiler than that of the PATH.
set -u
[ $# = 2 ] || { echo "usage: test.sh LIBDIR BINDIR" >&2; exit 2; }
lib=$(cd "$1" && pwd) && bin=$(cd "$2" && pwd) && cd "$(dirname "$0")" || exit 2
export TOOTHSEG_LIB_DIR="$lib"
cargo=${CARGO:-cargo}
rustc=${RUSTC:-rustc}
TOOTHSEG_TEST_DIR=$(mktemp -d) && export TOOTHSEG_TEST_DIR || exit 2
trap 'rm -rf "$TOOTHSEG_TEST_DIR"' EXIT
work=$TOOTHSEG_TEST_DIR
. ../../tests/support/counts.sh

# The programs find the library beside them or by this; what is built here has an rpath.
with_lib() {
  LD_LIBRARY_PATH="$lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" "$@"
}

every_function_is_used() {
  grep -o 'pub fn ts_[a-z0-9_]*' toothseg-sys/src/generated.rs | cut -d' ' -f3 | while read -r function; do
    grep -rqw "$function" toothseg/src || echo "toothseg leaves out $function"
  done > "$work/left_out"
  cat "$work/left_out"
  [ ! -s "$work/left_out" ]
}

# A program of tests/refused is not compiled, for the reason in its first line.
is_refused() {
  reason=$(sed -n '1s,^// ,,p' "$1")
  "$rustc" --edition 2021 --emit metadata -L target/debug/deps --extern "toothseg=target/debug/libtoothseg.rlib" \
    -o "$work/refused" "$1" 2> "$work/reason" && return 1
  grep -q "^error\[$reason\]" "$work/reason" && [ "$(grep -c '^error\[' "$work/reason")" = 1 ] && return
  cat "$work/reason"
  return 1
}

# Each line of Rust in a document is one of the samples or tests.
is_run() {
  awk '/^```rust/ {on = 1; next} /^```/ {on = 0} on && NF' "$1" | sed 's/^ *//' | sort -u > "$work/lines"
  cat toothseg/examples/*.rs toothseg/tests/*/*.rs | sed 's/^ *//' | sort -u > "$work/run"
  comm -23 "$work/lines" "$work/run" > "$work/never_run"
  cat "$work/never_run"
  [ -s "$work/lines" ] && [ ! -s "$work/never_run" ]
}

segments_alike() {
  target/debug/examples/segment_arch "$work/arch.ply" --threads 1 --labels "$work/ours.txt" "$@" 2> "$work/progress" &&
    grep -q '100 %' "$work/progress" && cmp "$work/ours.txt" "$work/labels.txt"
}

hello_prints_a_cut() {
  target/debug/examples/hello_tooth "$work/arch.ply" > "$work/cut.txt" && [ "$(wc -l < "$work/cut.txt")" -gt 20 ] &&
    ! grep -Evq '^-?[0-9]+\.[0-9]{4} -?[0-9]+\.[0-9]{4} -?[0-9]+\.[0-9]{4}$' "$work/cut.txt"
}

lists_teeth() {
  list=$PWD/target/debug/examples/list_teeth
  (cd "$work" && "$list" > teeth.txt) && [ "$(grep -c '^tooth [0-9]*: [0-9]* mm^2, confidence [01]\.[0-9][0-9]$' "$work/teeth.txt")" = 14 ]
}

writes_teeth() {
  target/debug/examples/segment_arch "$work/small.ply" --all --teeth "$work/teeth" 2> "$work/progress" &&
    [ "$(ls "$work/teeth" | wc -l)" = 15 ] && [ -s "$work/teeth/gingiva.stl" ] && [ -s "$work/teeth/tooth_14.stl" ]
}

# The sample on a large scan, and Ctrl-C once it has begun.
stops_at_ctrl_c() {
  : > "$work/stopped"
  target/debug/examples/segment_arch "$work/large.ply" --labels "$work/none.txt" 2> "$work/stopped" &
  sample=$!
  while [ ! -s "$work/stopped" ] && kill -0 $sample; do sleep 0.01; done
  kill -INT $sample
  wait $sample
  [ $? = 2 ] && grep -q 'TS_E_CANCELLED' "$work/stopped" && [ ! -e "$work/none.txt" ]
}

check "arches are made" with_lib "$bin/make-arch" "$work/arch.ply" --triangles 20000 --seed 1
check "arches are made" with_lib "$bin/make-arch" "$work/small.ply" --triangles 5000 --seed 2
check "arches are made" with_lib "$bin/make-arch" "$work/large.ply" --triangles 100000 --seed 1
check "arches are made" with_lib "$bin/make-arch" "$work/noisy.ply" --triangles 5000 --seed 1 --noise 1 --isotropic --crowding severe
check "ts-segment runs" with_lib "$bin/ts-segment" "$work/arch.ply" --threads 1 --labels "$work/labels.txt"
check "generated.rs is what the JSON says" python3 generate.py --check
check "the safe crate leads to every function" every_function_is_used

if ! { "$cargo" test --quiet --offline --locked --jobs 1 --no-run && "$cargo" build --quiet --offline --locked --jobs 1; } \
  > "$work/build" 2>&1; then
  cat "$work/build"
  failed=$((failed + 1))
  finish
  exit
fi
if ! "$cargo" test --quiet --offline --locked --jobs 1 --tests > "$work/tests" 2>&1; then
  failed=$((failed + 1))
  cat "$work/tests"
fi
# Two programs: one of each crate.
succeeded=$(sed -n 's/^test result: [a-zA-Z]*\. \([0-9]*\) passed.*/\1/p' "$work/tests" | awk '{n += $1} END {print n + 0}')
passed=$((passed + succeeded))
check "both crates have tests" [ "$(grep -c '^test result' "$work/tests")" = 2 ]

check "hello_tooth prints a cut" hello_prints_a_cut
check "list_teeth lists 14" lists_teeth
check "segment_arch labels as ts-segment" segments_alike
check "segment_arch --all labels as ts-segment" segments_alike --all
check "segment_arch writes teeth" writes_teeth
check "segment_arch stops at Ctrl-C" stops_at_ctrl_c
for program in toothseg/tests/refused/*.rs; do
  check "$program is refused" is_refused "$program"
done
for document in README.md ../../docs/five-minutes-rust.md; do
  check "the code in $document is run" is_run "$document"
done

finish
