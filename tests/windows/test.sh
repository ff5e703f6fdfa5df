#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What runs of toothseg.dll under Wine: test.sh BUILD ZIP. BUILD: a finished build of the preset `windows` with its samples. Beside it a
# build for Linux is wanted, to compare with: TS_LINUX_SAMPLES is where its ts-segment and make-arch are; else build/release/samples,
# which is built where it is missing. Last line: N passed, M failed.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd) zip=$2
export WINEDEBUG=-all WINEPREFIX=${TS_WINEPREFIX:-$root/build/wine} WINEPATH
WINEPATH=$build/install/bin
linux=${TS_LINUX_SAMPLES:-$root/build/release/samples}
work=$build/test
rm -rf "$work"
mkdir -p "$work" "$WINEPREFIX"
say_ok=1
. "$root/tests/support/counts.sh"

# ctest of a project that is built; its tests count one by one.
suite() { # name, folder
  local line good bad
  ctest --test-dir "$2" --output-on-failure -j "${TS_JOBS:-1}" >"$work/log" 2>&1
  line=$(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\)$/\1 \2/p' "$work/log")
  if [ -z "$line" ] || [ "${line#* }" = 0 ]; then
    cat "$work/log"
    bad=1 good=0
  else
    bad=${line% *} good=$((${line#* } - ${line% *}))
    [ "$bad" = 0 ] || cat "$work/log"
  fi
  passed=$((passed + good)) failed=$((failed + bad))
  echo "$1: $good passed, $bad failed"
}

# Shares the machine's ways of being called with the build for Linux.
if [ ! -x "$linux/ts-segment" ]; then
  (cd "$root" && cmake --preset demo && cmake --build --preset demo && scripts/build_installed.sh build/release samples) >"$work/log" 2>&1 ||
    { cat "$work/log"; exit 1; }
fi
# Wine's services are started by the first program and keep its output open, for which ctest would wait: so this one is the first,
# and is there until the end.
timeout 120 wineboot -i >"$work/log" 2>&1
mkfifo "$work/keep"
wine cmd /c "set /p x=" <"$work/keep" >/dev/null 2>&1 &
exec 9>"$work/keep"
toolchain=(-DCMAKE_TOOLCHAIN_FILE="$root/cmake/mingw-w64.cmake")
for project in tests/c tests/windows; do
  out=$build/$(basename "$project")
  [ $project != tests/c ] || out=$build/consumer
  cmake -S "$root/$project" -B "$out" -G Ninja -DCMAKE_PREFIX_PATH="$build/install" -DCMAKE_BUILD_TYPE=Release "${toolchain[@]}" >"$work/log" 2>&1 &&
    cmake --build "$out" -j "${TS_JOBS:-$(nproc)}" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
done
suite "tests/c" "$build/consumer"
suite "tests/reliability" "$build/windows"
suite "samples" "$build/samples"

# The same arch, and the same labels and session of it, as on Linux.
segment=$build/samples/ts-segment.exe
"$linux/make-arch" "$work/arch.ply" --triangles 100000 --labels "$work/fdi.txt" >/dev/null
outputs() { # folder
  echo --auto --labels "$1/labels.txt" --report "$1/report.json" --cuts "$1/cuts.obj"
}
mkdir "$work/linux" "$work/wine"
wine "$build/samples/make-arch.exe" "$work/wine.ply" --triangles 100000 >"$work/log" 2>&1
# shellcheck disable=SC2046
"$linux/ts-segment" "$work/arch.ply" $(outputs "$work/linux") >"$work/log"
# shellcheck disable=SC2046
check "ts-segment" wine "$segment" "$work/arch.ply" $(outputs "$work/wine")
check "labels differ from those of Linux in less than 1e-4" /usr/bin/python3 "$here/labels.py" "$work/linux/labels.txt" "$work/wine/labels.txt"
cat "$work/log"
cmp -s "$work/arch.ply" "$work/wine.ply" && echo "make-arch: the same bytes as on Linux" || echo "make-arch: other bytes than on Linux"

# Names in the command line; folders of any name.
odd="$work/Zähne 牙 von heute"
mkdir "$odd"
cp "$work/arch.ply" "$odd/Scan groß.ply"
check "ts-segment on odd names" wine "$segment" "$odd/Scan groß.ply" --auto --labels "$odd/Etiketten 牙.txt" --teeth "$odd/einzeln ü"
check "labels by an odd name" cmp "$odd/Etiketten 牙.txt" "$work/wine/labels.txt"
check "a tooth a file" test "$(find "$odd/einzeln ü" -name '*.stl' | wc -l)" -gt 10
check "no output into a read-only folder" test ! -e /sys/labels.txt -a "$(wine "$segment" "$work/arch.ply" --auto --labels /sys/labels.txt >"$work/log" 2>&1; echo $?)" = 2

# The DLL: names, ordinals, what it needs; what is checked notices what it should.
check "exports and needed DLLs" "$root/abi/check_dll.py" "$build/src/api/toothseg.dll"
sed 's/ts_undo @\([0-9]*\)/ts_undo @999/' "$root/abi/toothseg.def" >"$work/other.def"
check "another ordinal is seen" bash -c '! "$1" "$2" --def "$3"' - "$root/abi/check_dll.py" "$build/src/api/toothseg.dll" "$work/other.def"
x87() { x86_64-w64-mingw32-objdump -d "$1" | grep -E '\s(f2xm1|fyl2xp?1?|fpatan|fptan|fsin|fcos|fsincos|fprem1?)\b'; }
check "no function of the x87 is in it" bash -c "$(declare -f x87)"'; ! x87 "$1"' - "$build/src/api/toothseg.dll"
check "C# names what is exported" /usr/bin/python3 "$here/csharp_names.py"
check "header and samples by clang for MSVC's target" "$here/msvc_syntax.sh"
timeout 900 "$here/pascal.sh" "$build" >"$work/pascal.log" 2>&1
sed 's/^/Pascal: /' "$work/pascal.log"
add_counts Pascal "$work/pascal.log"

# The zip, unpacked where there is nothing else: a program is built against it, and runs.
mkdir "$work/zip"
(cd "$work/zip" && unzip -q "$zip") || failed=$((failed + 1))
unpacked=$(echo "$work"/zip/*)
check "samples build against the zip" bash -c 'cmake -S "$1/samples" -B "$2" -G Ninja -DCMAKE_PREFIX_PATH="$1" "$3" && cmake --build "$2" --target hello_tooth hello_tooth_cpp dll' - \
  "$unpacked" "$work/from_zip" "${toolchain[@]}"
WINEPATH= check "and run" wine "$work/from_zip/hello_tooth.exe" "$work/arch.ply"
for file in bin/toothseg.dll bin/ts-segment.exe lib/toothseg.lib lib/libtoothseg.dll.a lib/toothseg.def include/toothseg.h \
  lib/cmake/toothseg/toothsegConfig.cmake samples/CMakePresets.json share/doc/toothseg/THIRD_PARTY.md share/doc/toothseg/LICENSE; do
  check "the zip has $file" test -s "$unpacked/$file"
done

/usr/bin/python3 "$here/ratio.py" "$linux/ts-segment" "$segment" "$work/arch.ply" "$work"
exec 9>&-
finish
