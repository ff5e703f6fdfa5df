#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The header and the samples as clang reads them for MSVC's target: LLP64, Microsoft's keywords and extensions. The headers of its
# C library are not there, so those of MinGW-w64 stand in for them, and for C++ only the C header is read.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '#include <toothseg.h>\nint known = TS_VERSION_MINOR;\n' | tee "$work/alone.c" >"$work/alone.cpp"
read_as() { # options, file
  clang-14 --driver-mode=cl --target=x86_64-pc-windows-msvc /Zs /W4 /WX -Xclang -ffreestanding /I"$root/include" "$@"
}
read_as /TC "$work/alone.c"
read_as /TC /DTS_STATIC "$work/alone.c"
read_as /TC /DTS_BUILD "$work/alone.c"
read_as /TP /std:c++17 "$work/alone.cpp"
read_as /TP /std:c++20 "$work/alone.cpp"
# stdint.h and stddef.h are clang's own here: the layout is asserted without any other header.
clang-14 --target=x86_64-pc-windows-msvc -ffreestanding -nostdlibinc -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only \
  -I"$root/include" "$root/abi/layout.c"
clang-14 --target=x86_64-pc-windows-msvc -ffreestanding -nostdlibinc -std=c++17 -x c++ -Wall -Wextra -pedantic -Werror -fsyntax-only \
  -I"$root/include" "$root/abi/layout.c"
for source in "$root"/samples/c/*.c; do
  clang-14 --target=x86_64-w64-windows-gnu -fms-extensions -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only \
    -I"$root/include" -I"$root/synth/include" "$source"
done
