#!/usr/bin/env bash
# ThreadSanitizer on what has threads: builds the library and these tests, loops on threads of the standard library
# (docs/reliability.md), and runs them. Any report fails.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh test
cmake --preset tsan >/dev/null
cmake --build --preset tsan -j "${TS_JOBS:-$(nproc)}"
TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1 ${TSAN_OPTIONS:-}" ctest --preset tsan -j "${TS_JOBS:-$(nproc)}"
