#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests. TS_TEST_ASAN=0 leaves the sanitizer build out.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh test
jobs=$(nproc)

# What the Node binding is tested with, from the npm registry.
if [ ! -d bindings/node/node_modules ]; then
  (cd bindings/node && npm ci --ignore-scripts --no-audit --no-fund >/dev/null)
fi

run() {
  echo "== $2"
  cmake --preset "$1" "${@:3}" >/dev/null
  cmake --build --preset "$1" -j "$jobs"
  ctest --preset "$1" -j "$jobs"
}
run release "release build, warnings are errors" -DTOOTHSEG_ABI_INFO=ON
[ "${TS_TEST_ASAN:-1}" != 1 ] || run asan "AddressSanitizer and UndefinedBehaviorSanitizer"
