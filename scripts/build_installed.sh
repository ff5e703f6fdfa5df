#!/usr/bin/env bash
# Installs a finished build into BUILD/install and builds projects of this tree (samples, tests/c) against that, as a user
# would, into BUILD/PROJECT:
#   build_installed.sh BUILD PROJECT [cmake arguments]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
project=$2
shift 2
[ "$project" != tests/c ] || out=$build/consumer
out=${out:-$build/$project}
cmake --install "$build" --prefix "$build/install" >/dev/null
cmake -S "$root/$project" -B "$out" -G Ninja -DCMAKE_PREFIX_PATH="$build/install" -DCMAKE_BUILD_TYPE=Release "$@" >/dev/null
cmake --build "$out"
