#!/usr/bin/env bash
# The main job, start to end: installs what is missing, builds, makes a synthetic arch (or takes the scan that is named),
# separates its teeth with N/2 clicks, scores the result where the truth is known, and draws it.
#   scripts/demo.sh [SCAN.stl|ply|obj|off]      results in out/
#   scripts/demo.sh --web                       builds the viewer for browsers and serves it on this machine (TS_WEB_PORT: on that port)
# TS_DEMO_BIN names a folder with ts-segment and make-arch to use those, TS_DEMO_OUT another folder for the results.
set -euo pipefail
if [ "$*" = --web ]; then
  cd "$(dirname "$0")/.."
  scripts/web.sh --build
  echo "the viewer, until Ctrl-C:"
  exec node samples/web/test/serve.mjs samples/web/dist "${TS_WEB_PORT:-0}"
fi
if [ $# -gt 1 ] || [[ ${1:-} = -* ]]; then
  echo "usage: scripts/demo.sh [SCAN.stl|ply|obj|off] | --web" >&2
  exit 2
fi
scan=""
if [ $# = 1 ]; then
  if [ ! -f "$1" ] || [ ! -r "$1" ]; then
    echo "demo.sh: cannot read $1: no such file, or no right to" >&2
    exit 2
  fi
  scan=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
fi
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

bin=${TS_DEMO_BIN:-build/release/samples}
if [ -z "${TS_DEMO_BIN:-}" ]; then
  scripts/install_deps.sh demo
  echo "building in build/release"
  log=build/demo.log
  mkdir -p build
  if ! { cmake --preset demo && cmake --build --preset demo && scripts/build_installed.sh build/release samples; } >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "demo.sh: the build failed; all of it is in $log" >&2
    exit 1
  fi
fi
folder=${TS_DEMO_OUT:-$root/out}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

truth=()
name=$(basename "${scan:-arch.ply}")
out=$folder/${name%.*}
if [ -z "$scan" ]; then
  scan=$out.ply
  "$bin/make-arch" "$scan" --labels "${out}_truth.txt" --jaw lower --crowding mild --triangles 100000
  truth=(--mesh "$scan" --truth "${out}_truth.txt" --labels "${out}_labels.txt")
fi

# 1: some click failed; what the others did stands, and is drawn.
status=0
"$bin/ts-segment" "$scan" --auto --labels "${out}_labels.txt" --cuts "${out}_cuts.obj" --ply "${out}_teeth.ply" \
  --report "${out}_report.json" --features "${out}_features.json" || status=$?
[ "$status" -le 1 ] || exit "$status"

echo
/usr/bin/python3 scripts/demo_table.py "${out}_report.json" "${truth[@]}"
mapfile -t caption < <(/usr/bin/python3 scripts/demo_table.py "${out}_report.json" "${truth[@]}" --caption)
/usr/bin/python3 scripts/render.py "${out}_teeth.ply" "$out.png" --cuts "${out}_cuts.obj" --up="${caption[0]}" \
  --title "${name%.*}" --note "${caption[1]}"
echo
echo "picture        $out.png"
echo "coloured mesh  ${out}_teeth.ply"
exit "$status"
