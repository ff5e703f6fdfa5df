#!/usr/bin/env bash
# Installs a finished build into BUILD/install and builds the samples and the C tests against that tree, as a user would:
#   build_installed.sh BUILD_DIR [cmake arguments]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
shift
cmake --install "$build" --prefix "$build/install" >/dev/null
for project in samples tests/c; do
  out=$build/$(basename "$project" | sed 's/^c$/consumer/')
  cmake -S "$root/$project" -B "$out" -G Ninja -DCMAKE_PREFIX_PATH="$build/install" -DCMAKE_BUILD_TYPE=Release "$@" >/dev/null
  cmake --build "$out"
done
