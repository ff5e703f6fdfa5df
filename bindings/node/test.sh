#!/bin/sh
# Tests of the Node binding: test.sh LIBDIR BINDIR. SPDX-License-Identifier: Apache-2.0
#   LIBDIR  folder with libtoothseg.so     BINDIR  folder with ts-segment and make-arch
# `npm ci` comes first, and is the only step that wants a registry.
set -eu
[ $# -eq 2 ] || { echo "usage: test.sh LIBDIR BINDIR" >&2; exit 2; }
library=$(cd "$1" && pwd)
programs=$(cd "$2" && pwd)
cd "$(dirname "$0")"
[ -d node_modules/koffi ] && [ -d node_modules/typescript ] || { echo "test.sh: npm ci first (in $PWD)" >&2; exit 2; }

TOOTHSEG_TEST_FOLDER=$(mktemp -d)
trap 'rm -rf "$TOOTHSEG_TEST_FOLDER"' EXIT
export TOOTHSEG_TEST_FOLDER
export TOOTHSEG_LIBRARY="$library/libtoothseg.so" LD_LIBRARY_PATH="$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
"$programs/make-arch" "$TOOTHSEG_TEST_FOLDER/arch.ply" --triangles 20000 --seed 1 >/dev/null
"$programs/make-arch" "$TOOTHSEG_TEST_FOLDER/small.ply" --triangles 5000 --seed 2 >/dev/null
"$programs/make-arch" "$TOOTHSEG_TEST_FOLDER/noisy.ply" --triangles 8000 --noise 1 --isotropic >/dev/null
"$programs/ts-segment" "$TOOTHSEG_TEST_FOLDER/arch.ply" --labels "$TOOTHSEG_TEST_FOLDER/labels.txt" >/dev/null

tap="$TOOTHSEG_TEST_FOLDER/tap"
status=0
node --test --test-reporter=spec --test-reporter-destination=stdout --test-reporter=tap --test-reporter-destination="$tap" \
  test/*.test.js || status=$?
count() { sed -n "s/^# $1 //p" "$tap"; }
failed=$(($(count fail) + $(count cancelled) + $(count skipped)))
[ "$failed" -ne 0 ] || [ "$status" -eq 0 ] || failed=1
echo "$(count pass) passed, $failed failed"
[ "$failed" -eq 0 ]
