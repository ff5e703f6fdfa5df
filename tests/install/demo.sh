#!/usr/bin/env bash
# The demo with samples that are built: on its own arch, on a file of the user's, and on what is none.
#   demo.sh SAMPLES_DIR OUT_DIR
set -euo pipefail
demo=$(cd "$(dirname "$0")/../../scripts" && pwd)/demo.sh
export TS_DEMO_BIN=$1 TS_DEMO_OUT=$2
rm -rf "$2"
mkdir -p "$2/a user's scans"

complain() { echo "$*"; exit 1; }
is_picture() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || complain "$1 is no PNG"; }

"$demo" | tee "$2/table.txt"
is_picture "$2/arch.png"
# Far below what is reached, far above what a wrong arch, or labels in another order, would give.
awk '/^IoU, mean/ {found = 1; if ($4 < 0.8) exit 1} END {exit !found}' "$2/table.txt" || complain "IoU"
grep -q '^teeth  *14$' "$2/table.txt" || complain "not the 14 teeth of the arch"

"$1/make-arch" "$2/a user's scans/jaw no. 1.stl" --jaw upper --triangles 20000
(cd "$2/a user's scans" && "$demo" "jaw no. 1.stl")
is_picture "$2/jaw no. 1.png"
[ -s "$2/jaw no. 1_teeth.ply" ] || complain "no coloured mesh"

status=0
"$demo" "$2/none.stl" >"$2/said.txt" 2>&1 || status=$?
[ "$status" != 0 ] || complain "a missing file is no error"
[ "$(wc -l <"$2/said.txt")" = 1 ] || complain "a missing file: $(cat "$2/said.txt")"
