#!/usr/bin/env bash
# Installs what is missing, reads the source for faults, builds, and runs all tests: the release build, then what the
# sanitizers see (AddressSanitizer with UndefinedBehaviorSanitizer of all that goes through the public API; twenty seconds of
# each fuzzer; ThreadSanitizer). TS_TEST_SANITIZED=0 leaves the sanitizers out; =whole asks them of the rooms' own tests too, and
# of a minute of each fuzzer, which takes ten minutes more. TS_TEST_WEB=0 leaves out what needs Emscripten and Chromium, which
# is done where they are.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh test
jobs=$(nproc)
sanitized=${TS_TEST_SANITIZED:-1}

# What the Node binding is tested with, from the npm registry.
if [ ! -d bindings/node/node_modules ]; then
  (cd bindings/node && npm ci --ignore-scripts --no-audit --no-fund >/dev/null)
fi

begin=$SECONDS
part() {
  echo "== $1 (after $((SECONDS - begin)) s)"
}

# What the sanitizers are asked of is compiled beside what goes before, at the lowest priority: on the cores that a link, a step of
# lint.sh or the last test of a part leave idle. Where there is little memory each has its turn.
asan_targets=(--target sanitized_tests) asan_tests=(-LE whole) fuzz_seconds=20
[ "$sanitized" != whole ] || asan_targets=() asan_tests=() fuzz_seconds=60
compile_asan() {
  cmake --preset asan >/dev/null && cmake --build --preset asan -j "$jobs" ${asan_targets[@]+"${asan_targets[@]}"}
}
compile_tsan() {
  cmake --preset tsan >/dev/null && cmake --build --preset tsan -j "$jobs"
}
aside=""
mkdir -p build
if [ "$sanitized" != 0 ] && awk '/^MemAvailable:/ {exit $2 < 6 * 1024 * 1024}' /proc/meminfo; then
  rm -f build/asan.done build/tsan.done
  set -m  # a process group of its own, to be ended as one
  (
    renice -n 19 $BASHPID >/dev/null
    for kind in asan tsan; do
      status=0
      compile_$kind >"build/$kind.log" 2>&1 || status=$?
      echo $status >"build/$kind.done"
    done
  ) &
  aside=$!
  set +m
  trap 'kill -- -$aside 2>/dev/null || true' EXIT
fi
# compiled KIND: waits for what is compiled aside, or compiles it now.
compiled() {
  [ -n "$aside" ] || { compile_"$1"; return; }
  while [ ! -s "build/$1.done" ] && kill -0 "$aside" 2>/dev/null; do sleep 1; done
  tail -n 1 "build/$1.log"
  [ "$(cat "build/$1.done")" = 0 ] || { cat "build/$1.log"; return 1; }
}

part "source"
scripts/lint.sh --quick
part "release build, warnings are errors"
cmake --preset release -DTOOTHSEG_ABI_INFO=ON >/dev/null
cmake --build --preset release -j "$jobs"
ctest --preset release -j "$jobs"
if [ "${TS_TEST_WEB:-1}" = 1 ] && command -v emcc >/dev/null && command -v chromium >/dev/null; then
  part "WebAssembly and the page (scripts/web.sh installs what it needs)"
  scripts/web.sh
  (cd bindings/wasm && npm ci --ignore-scripts --no-audit --no-fund >/dev/null)
  bindings/wasm/test.sh build/release/samples
fi
if [ "$sanitized" != 0 ]; then
  part "AddressSanitizer and UndefinedBehaviorSanitizer"
  compiled asan
  ctest --preset asan -j "$jobs" ${asan_tests[@]+"${asan_tests[@]}"}
  part "fuzzers, $fuzz_seconds seconds each"
  scripts/fuzz.sh all "$fuzz_seconds"
  part "ThreadSanitizer"
  compiled tsan
  scripts/tsan.sh
fi
part "done"
