#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The header and the samples as clang reads them for MSVC's target: LLP64, Microsoft's keywords and extensions. The headers of its
# C library are not there, so those of MinGW-w64 stand in for them, and for C++ only the C header is read.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cl=(clang-14 --driver-mode=cl --target=x86_64-pc-windows-msvc /nologo /Zs /W4 /WX -Wno-unused-command-line-argument /I"$root/include")
echo '#include <toothseg.h>' >/tmp/msvc_syntax_$$.h
trap 'rm -f /tmp/msvc_syntax_$$.*' EXIT
for how in '/TC' '/TP /std:c++17' '/TP /std:c++20' '/TC /DTS_STATIC' '/TC /DTS_BUILD'; do
  # shellcheck disable=SC2086
  "${cl[@]}" $how "$root/include/toothseg.h"
done
# stdint.h and stddef.h are clang's own here: the layout is asserted without any other header.
clang-14 --target=x86_64-pc-windows-msvc -ffreestanding -nostdlibinc -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only \
  -I"$root/include" "$root/abi/layout.c"
clang-14 --target=x86_64-pc-windows-msvc -ffreestanding -nostdlibinc -std=c++17 -x c++ -Wall -Wextra -pedantic -Werror -fsyntax-only \
  -I"$root/include" "$root/abi/layout.c"
for source in "$root"/samples/c/*.c; do
  clang-14 --target=x86_64-w64-windows-gnu -fms-extensions -std=c99 -Wall -Wextra -pedantic -Wshorten-64-to-32 -Werror -fsyntax-only \
    -I"$root/include" -I"$root/synth/include" "$source"
done
