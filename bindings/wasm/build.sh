#!/usr/bin/env bash
# Builds the library for WebAssembly and makes the npm package of it: build.sh [PACKAGE]. SPDX-License-Identifier: Apache-2.0
#   PACKAGE  folder that becomes the package (default: build/wasm/package); `npm install PACKAGE` or `npm pack` there.
# Wants Debian's emscripten (scripts/install_deps.sh web).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build/wasm
package=${1:-$build/package}
command -v emcc >/dev/null || { echo "build.sh: no emcc: scripts/install_deps.sh web" >&2; exit 2; }

export NODE_PATH=/usr/share/nodejs # of Debian's node-acorn, for a Node of whatever origin
node "$here/generate.mjs" --check
cd "$root"
mkdir -p build
cmake --preset wasm >"$build.log" 2>&1 || { cat "$build.log" >&2; exit 1; }
cmake --build --preset wasm

# All but the two modules that know what is below them is the Node binding's.
rm -rf "$package"
mkdir -p "$package/lib"
node=$root/bindings/node
for file in abi.js abi.d.ts context.js errors.js features.js mesh.js model.js numbers.js resource.js segmentation.js values.js; do
  cp "$node/lib/$file" "$package/lib/"
done
sed 's|\./lib/|./|' "$node/index.js" >"$package/lib/public.js"
sed 's|\./lib/|./|' "$node/index.d.ts" >"$package/lib/public.d.ts"
cp "$here"/lib/*.js "$here/lib/later.d.ts" "$build/bindings/wasm/toothseg.mjs" "$build/bindings/wasm/toothseg.wasm" "$package/lib/"
for file in index.js index.node.js index.d.ts package.json README.md; do cp "$here/$file" "$package/"; done
cp "$root/LICENSE" "$root/THIRD_PARTY.md" "$package/"
echo "$package"
