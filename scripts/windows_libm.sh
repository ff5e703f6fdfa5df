#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The mathematical functions of toothseg.dll: PREFIX/lib/libtoothseg_m.a, from Debian's source package of musl, whose hashes apt checks.
# MinGW-w64's own work on the x87, where bits of exp and pow depend on the precision that a thread has set, or are those of the
# msvcrt.dll that a Windows has; musl's use nothing but SSE, and exp, log and pow are those of glibc.
#   scripts/windows_libm.sh PREFIX      nothing is done where PREFIX has it
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
prefix=$1
[ ! -e "$prefix/lib/libtoothseg_m.a" ] || exit 0
work=$(dirname "$prefix")/work-m
rm -rf "$work"
mkdir -p "$work" "$prefix/lib"
log=$work/log
cc=x86_64-w64-mingw32-gcc-posix

compile() { # object, source, options
  local object=$1 source=$2
  shift 2
  # Contracted where there is an instruction for it, as glibc's are.
  $cc -std=c99 -O2 -fno-math-errno -ffp-contract=fast -D'hidden=' -Istub -Imusl/src/internal -Imusl/arch/generic "$@" -c "$source" -o "$object.o"
}
{
  "$root/scripts/debian_source.sh" musl "$work"
  cd "$work"
  mv musl-*/ musl
  # What musl's own headers would say, of which Windows has none.
  mkdir stub
  printf '#define __BYTE_ORDER 1234\n#define __LITTLE_ENDIAN 1234\n#define __BIG_ENDIAN 4321\n' >stub/endian.h
  : >stub/features.h
  for f in exp_data log_data pow_data __math_{oflow,uflow,invalid,divzero,xflow} \
    sin cos sincos tan __sin __cos __tan __rem_pio2 __rem_pio2_large scalbn atan atan2 hypot cbrt log1p fmod; do
    compile "$f" "musl/src/math/$f.c"
  done
  for f in exp log pow; do
    compile "${f}_plain" "musl/src/math/$f.c" -D"$f=${f}_plain"
    compile "${f}_fused" "musl/src/math/$f.c" -D"$f=${f}_fused" -mfma -mavx2
  done
  compile choose "$root/cmake/mingw/choose.c"
  x86_64-w64-mingw32-ar rcs libtoothseg_m.a ./*.o
} >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
mv "$work/libtoothseg_m.a" "$prefix/lib/"
rm -rf "$work"
