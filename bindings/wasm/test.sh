#!/bin/sh
# Tests of the package: test.sh BINDIR [PACKAGE]. SPDX-License-Identifier: Apache-2.0
#   BINDIR   folder with ts-segment and make-arch, native ones      PACKAGE  what build.sh made (default: build/wasm/package)
# `npm ci` comes first, and is the only step that wants a registry.
set -eu
[ $# -eq 1 ] || [ $# -eq 2 ] || { echo "usage: test.sh BINDIR [PACKAGE]" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
TOOTHSEG_TEST_PROGRAMS=$(cd "$1" && pwd)
package=${2:-$here/../../build/wasm/package}
[ -f "$package/lib/toothseg.wasm" ] || { echo "test.sh: build.sh first: no package in $package" >&2; exit 2; }
TOOTHSEG_TEST_PACKAGE=$(cd "$package" && pwd)
cd "$here"
[ -d node_modules/typescript ] || { echo "test.sh: npm ci first (in $PWD)" >&2; exit 2; }

TOOTHSEG_TEST_FOLDER=$(mktemp -d)
trap 'rm -rf "$TOOTHSEG_TEST_FOLDER"' EXIT
export TOOTHSEG_TEST_FOLDER TOOTHSEG_TEST_PACKAGE TOOTHSEG_TEST_PROGRAMS
arch() {
  name=$1
  shift
  "$TOOTHSEG_TEST_PROGRAMS/make-arch" "$TOOTHSEG_TEST_FOLDER/$name.ply" "$@" >/dev/null
}
segment() {
  name=$1
  shift
  "$TOOTHSEG_TEST_PROGRAMS/ts-segment" "$TOOTHSEG_TEST_FOLDER/$name.ply" --labels "$TOOTHSEG_TEST_FOLDER/$name.txt" "$@" >/dev/null
}
arch arch --triangles 20000 --seed 1
arch crowded --triangles 30000 --seed 3 --jaw lower --crowding 0.65
arch noisy --triangles 20000 --seed 5 --noise 0.1
arch small --triangles 5000 --seed 2
arch isotropic --triangles 8000 --noise 1 --isotropic
segment arch --session "$TOOTHSEG_TEST_FOLDER/arch.session.json" --teeth "$TOOTHSEG_TEST_FOLDER/teeth" --closed
segment crowded
segment noisy

tap="$TOOTHSEG_TEST_FOLDER/tap"
status=0
node --test --test-reporter=spec --test-reporter-destination=stdout --test-reporter=tap --test-reporter-destination="$tap" \
  test/*.test.js || status=$?
count() { sed -n "s/^# $1 //p" "$tap"; }
failed=$(($(count fail) + $(count cancelled) + $(count skipped)))
[ "$failed" -ne 0 ] || [ "$status" -eq 0 ] || failed=1
echo "$(count pass) passed, $failed failed"
[ "$failed" -eq 0 ]
