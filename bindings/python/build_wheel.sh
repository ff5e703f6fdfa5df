#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build_wheel.sh LIBDIR OUT: a wheel with the library of LIBDIR inside, for this platform, into the folder OUT. Needs Debian's
# python3-pip, python3-setuptools and python3-wheel, and no network. The library's own libraries (oneTBB) are not inside.
set -euo pipefail
[ $# = 2 ] || { echo "usage: build_wheel.sh LIBDIR OUT" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
library=$(readlink -f "$1/libtoothseg.so")
[ -f "$library" ] || { echo "build_wheel.sh: no libtoothseg.so in $1" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$here"/{pyproject.toml,setup.py,README.md,toothseg} "$here"/../../{LICENSE,THIRD_PARTY.md} "$work"
cp "$library" "$work/toothseg/libtoothseg.so.0"
cd "$work"
/usr/bin/python3 -m pip wheel --quiet --disable-pip-version-check --no-build-isolation --no-index --no-deps -w "$out" . 2>log ||
  { cat log >&2; exit 1; }
