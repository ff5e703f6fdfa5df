#!/usr/bin/env bash
# Installs what is missing, builds ts-bench and runs it with the arguments given (--help lists them).
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_deps.sh bench
log=build/bench.log
mkdir -p build
if ! { cmake --preset bench && cmake --build --preset bench --target ts-bench -j "$(nproc)"; } >"$log" 2>&1; then
  tail -n 40 "$log" >&2
  echo "bench.sh: the build failed; all of it is in $log" >&2
  exit 1
fi
exec build/release/bench/ts-bench "$@"
