#!/usr/bin/env bash
# The main job, start to end: installs what is missing, builds, makes a synthetic arch (or takes the scan that is named),
# separates its teeth with N/2 clicks, scores the result where the truth is known, and draws it.
#   scripts/demo.sh [SCAN.stl|ply|obj|off]      results in out/
set -euo pipefail
here=$(pwd)
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
scripts/install_deps.sh demo
cmake --preset release -DTOOTHSEG_BUILD_TESTS=OFF -DTOOTHSEG_BUILD_BENCH=OFF >/dev/null
cmake --build --preset release -j "$(nproc)"
scripts/build_installed.sh build/release >/dev/null
bin=build/release/samples
mkdir -p out

if [ $# -ge 1 ]; then
  scan=$1
  [[ $scan = /* ]] || scan=$here/$scan
  name=$(basename "${scan%.*}")
else
  scan=out/arch.ply
  name=arch
  "$bin/make-arch" out/arch.ply --labels out/arch_truth.txt --jaw lower --crowding mild --triangles 100000
fi
"$bin/ts-segment" "$scan" --auto --labels "out/${name}_labels.txt" --cuts "out/${name}_cuts.obj" \
  --ply "out/${name}_teeth.ply" --report "out/${name}_report.json" --features "out/${name}_features.json"
truth=()
[ $# -ge 1 ] || truth=(--mesh out/arch.ply --truth out/arch_truth.txt --labels out/arch_labels.txt)
/usr/bin/python3 scripts/demo_table.py "out/${name}_report.json" "${truth[@]}"
/usr/bin/python3 scripts/render.py "out/${name}_teeth.ply" --cuts "out/${name}_cuts.obj" \
  --report "out/${name}_report.json" --out "out/${name}.png"
echo "picture: out/${name}.png    coloured mesh: out/${name}_teeth.ply"
