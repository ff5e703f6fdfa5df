#!/usr/bin/env bash
# The installed tree in another folder than it was installed to, as packages do: a C program built by pkg-config against the
# shared library, one built by CMake against the static library, and the same cut from both.
#   moved_tree.sh BUILD ARCH.ply CC
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1 arch=$2 cc=$3
work=$build/moved
rm -rf "$work"
mkdir -p "$work"
cp -r "$build/install" "$work/tree"

pc=$(find "$work/tree" -name toothseg.pc)
export PKG_CONFIG_PATH=${pc%/*}
libdir=$(pkg-config --variable=libdir toothseg)
for file in "$(pkg-config --variable=includedir toothseg)/toothseg.h" "$libdir/libtoothseg.so"; do
  [[ -e $file && $(realpath "$file") = $(realpath "$work")/tree/* ]] || { echo "pkg-config leads to $file"; exit 1; }
done
if grep -rIlF "$build/install" "$work/tree"; then
  echo "these files name the folder that they were installed to"
  exit 1
fi
# shellcheck disable=SC2046
"$cc" -std=c99 -Wall -Wextra -pedantic -Werror "$here/../../samples/c/hello_tooth.c" -o "$work/shared" \
  $(pkg-config --cflags --libs toothseg)
[[ $(LD_LIBRARY_PATH=$libdir ldd "$work/shared") = *"$work/tree"* ]] || { echo "not linked to the moved library"; exit 1; }
LD_LIBRARY_PATH=$libdir "$work/shared" "$arch" >"$work/shared.txt"

cmake -S "$here/static" -B "$work/static" -G Ninja -DCMAKE_PREFIX_PATH="$work/tree" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/static" >/dev/null
[[ $(ldd "$work/static/hello_static") != *libtoothseg* ]] || { echo "toothseg::static is linked as a shared library"; exit 1; }
"$work/static/hello_static" "$arch" >"$work/static.txt"

[ "$(wc -l <"$work/shared.txt")" -gt 10 ] || { echo "no cut"; exit 1; }
cmp "$work/shared.txt" "$work/static.txt"
