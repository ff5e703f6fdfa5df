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
  targets=(--target sanitized_tests) tests=(-LE whole) seconds=20
  [ "$sanitized" != whole ] || targets=() tests=() seconds=60
  cmake --preset asan >/dev/null
  cmake --build --preset asan -j "$jobs" ${targets[@]+"${targets[@]}"}
  ctest --preset asan -j "$jobs" ${tests[@]+"${tests[@]}"}
  part "fuzzers, $seconds seconds each"
  scripts/fuzz.sh all "$seconds"
  part "ThreadSanitizer"
  scripts/tsan.sh
fi
part "done"
