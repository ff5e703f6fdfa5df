#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests. TS_TEST_ASAN=0 leaves the sanitizer build out.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh test
jobs=$(nproc)

echo "== release build"
cmake --preset release >/dev/null
cmake --build --preset release -j "$jobs"
ctest --preset release -j "$jobs" --output-on-failure

if [ "${TS_TEST_ASAN:-1}" = 1 ]; then
  echo "== AddressSanitizer + UndefinedBehaviorSanitizer"
  cmake --preset asan >/dev/null
  cmake --build --preset asan -j "$jobs"
  ctest --preset asan -j "$jobs" --output-on-failure -LE "install|valgrind|slow"
fi
