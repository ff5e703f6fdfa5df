#!/usr/bin/env bash
# The viewer for browsers: installs what is missing, builds the library for WebAssembly and the page, and runs the tests in Chromium.
#   scripts/web.sh [--build]      --build: without the tests. The page is samples/web/dist, a folder that any server can serve
# TS_WEB_PACKAGE=1 takes the WebAssembly package in build/wasm/package as it is.
set -euo pipefail
cd "$(dirname "$0")/.."
case ${1:-} in
  "" | --build) ;;
  *) echo "usage: scripts/web.sh [--build]" >&2; exit 2 ;;
esac
scripts/install_deps.sh web
mkdir -p build
[ "${TS_WEB_PACKAGE:-}" = 1 ] || bindings/wasm/build.sh
cd samples/web
# The package that was just built is linked, so only a changed lock file asks for the registry.
if [ ! -f node_modules/.package-lock.json ] || [ package-lock.json -nt node_modules/.package-lock.json ]; then
  npm ci --ignore-scripts --no-audit --no-fund >/dev/null
fi
npm run --silent build
[ "${1:-}" = --build ] || npm test --silent
