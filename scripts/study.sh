#!/usr/bin/env bash
# Installs what is missing, builds, and runs the study with the arguments given (--quick; bench/study/study.py --help lists
# them all). Writes docs/study.md; with --quick build/study-quick/study.md. TS_STUDY_BUILD: a folder that is built already, to
# be taken as it is; nothing is installed then.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ -n "${TS_STUDY_BUILD:-}" ]; then
  exec /usr/bin/python3 bench/study/study.py --build "$TS_STUDY_BUILD" "$@"
fi
scripts/install_deps.sh study
log=build/study.log
mkdir -p build
if ! { cmake --preset bench && cmake --build --preset bench -j "$(nproc)" &&
  scripts/build_installed.sh build/release samples; } >"$log" 2>&1; then
  tail -n 40 "$log" >&2
  echo "study.sh: the build failed; all of it is in $log" >&2
  exit 1
fi
exec /usr/bin/python3 bench/study/study.py "$@"
