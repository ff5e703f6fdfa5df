#!/usr/bin/env bash
# Installs what is missing, reads the source for faults, builds, and runs all tests: the release build, then what the
# sanitizers see (AddressSanitizer with UndefinedBehaviorSanitizer; twenty seconds of each fuzzer; ThreadSanitizer).
# TS_TEST_SANITIZED=0 leaves the sanitizers out, TS_TEST_WEB=0 what needs Emscripten and Chromium, which is done where they are.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh test
jobs=$(nproc)

# What the Node binding is tested with, from the npm registry.
if [ ! -d bindings/node/node_modules ]; then
  (cd bindings/node && npm ci --ignore-scripts --no-audit --no-fund >/dev/null)
fi

begin=$SECONDS
part() {
  echo "== $1 (after $((SECONDS - begin)) s)"
}
run() {
  cmake --preset "$1" "${@:2}" >/dev/null
  cmake --build --preset "$1" -j "$jobs"
  ctest --preset "$1" -j "$jobs"
}

part "source"
scripts/lint.sh --quick
part "release build, warnings are errors"
run release -DTOOTHSEG_ABI_INFO=ON
if [ "${TS_TEST_WEB:-1}" = 1 ] && command -v emcc >/dev/null && command -v chromium >/dev/null; then
  part "WebAssembly and the page (scripts/web.sh installs what it needs)"
  scripts/web.sh
  (cd bindings/wasm && npm ci --ignore-scripts --no-audit --no-fund >/dev/null)
  bindings/wasm/test.sh build/release/samples
fi
if [ "${TS_TEST_SANITIZED:-1}" = 1 ]; then
  part "AddressSanitizer and UndefinedBehaviorSanitizer"
  run asan
  part "fuzzers, twenty seconds each"
  scripts/fuzz.sh all 20
  part "ThreadSanitizer"
  scripts/tsan.sh
fi
part "done"
