#!/usr/bin/env bash
# Makes all that is made from include/toothseg.h anew: the API as data, the layout's asserts, the bindings' lowest layers. Their
# tests fail where this was forgotten.
set -euo pipefail
cd "$(dirname "$0")/.."
python=/usr/bin/python3 # which has libclang
$python abi/describe.py
$python abi/make_layout.py
$python abi/make_def.py
for binding in python rust pascal csharp; do
  [ ! -f bindings/$binding/generate.py ] || $python bindings/$binding/generate.py
done
node bindings/node/generate.mjs
node bindings/wasm/generate.mjs
git status --short abi bindings
