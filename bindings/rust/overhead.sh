#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# overhead.sh LIBDIR BINDIR: what a call and the labels of 300,000 faces cost, as JSON.
set -eu
[ $# = 2 ] || { echo "usage: overhead.sh LIBDIR BINDIR" >&2; exit 2; }
lib=$(cd "$1" && pwd)
bin=$(cd "$2" && pwd)
cd "$(dirname "$0")"
export TOOTHSEG_LIB_DIR="$lib" LD_LIBRARY_PATH="$lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$bin/make-arch" "$work/arch.ply" --triangles 300000 --seed 1 > /dev/null
${CARGO:-cargo} build --quiet --offline --locked --release --example overhead >&2
target/release/examples/overhead "$work/arch.ply"
