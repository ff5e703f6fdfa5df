#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The packages of a finished build as their users meet them: the .deb files installed below another root, the tarball unpacked in
# a folder with spaces in its name; each linked by CMake and by pkg-config, shared and static, from C and C++. Then what a host
# may do beside the library, the recipes, and THIRD_PARTY.md.
#   test.sh BUILD      as root, or with fakeroot; programs and logs are in BUILD/packages-test
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "$1" && pwd)
work=$build/packages-test
deb=$work/deb
tree="$work/a folder of a user/toothseg"
export LC_ALL=C
rm -rf "$work"
mkdir -p "$work"
compiler() { sed -n "s/^CMAKE_$1_COMPILER:[A-Z]*=//p" "$build/CMakeCache.txt"; }
cc=$(compiler C) cxx=$(compiler CXX)
passed=0 failed=0

# check NAME COMMAND...: one line; what the command said only if it failed.
check() {
  local name=$1 log=$work/log.txt status
  shift
  set +e  # in a condition, bash would go on after a command that fails
  (set -e; "$@") >"$log" 2>&1
  status=$?
  set -e
  if [ $status = 0 ]; then
    passed=$((passed + 1))
    echo "ok      $name"
  else
    failed=$((failed + 1))
    echo "FAILED  $name"
    sed 's/^/        /' "$log"
  fi
}
complain() { echo "$*"; exit 1; }

# ------------------------------------------------------------------------------------------------------------- packages

make_packages() {
  TS_PACKAGE_BUILD=$build "$root/scripts/package.sh" "$work/out"
  [ "$(find "$work/out" -name '*.deb' | wc -l)" = 2 ] || complain "not two .deb packages"
  [ "$(find "$work/out" -name '*.tar.gz' | wc -l)" = 1 ] || complain "not one tarball"
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else fakeroot "$@"; fi
}
below() { as_root dpkg --root="$deb" --force-not-root --force-script-chrootless --log=/dev/null "$@"; }

# dpkg's own installation, below another root. It starts with what is installed here, so that Depends is asked of that; where
# nothing is, dpkg refuses.
install_debs() {
  mkdir -p "$deb/var/lib/dpkg/"{info,updates,triggers}
  touch "$deb/var/lib/dpkg/status"
  if below -i "$work"/out/*.deb >"$work/refused.txt" 2>&1; then complain "installed without what they depend on"; fi
  grep -q 'libtoothseg0 depends on libtbb12' "$work/refused.txt"
  cp /var/lib/dpkg/status "$deb/var/lib/dpkg/status"
  below -i "$work"/out/*.deb
  [ "$(find "$deb" -name 'libtoothseg.so.0' | wc -l)" = 1 ] || complain "no library"
}

remove_debs() {
  below -r libtoothseg-dev libtoothseg0
  [ -z "$(find "$deb/usr" -name '*toothseg*')" ] || complain "left behind: $(find "$deb/usr" -name '*toothseg*')"
}

# Debian's tools see the library, and a program that needs it, as they should.
debian_metadata() {
  local runtime dev version library
  runtime=$(ls "$work"/out/libtoothseg0_*.deb) dev=$(ls "$work"/out/libtoothseg-dev_*.deb)
  version=$(dpkg-deb -f "$runtime" Version)
  dpkg-deb -R "$runtime" "$work/control"
  for library in libc6 libgcc-s1 libstdc++6 libtbb12; do
    [[ $(dpkg-deb -f "$runtime" Depends) == *"$library (>= "* ]] || complain "Depends lacks $library"
  done
  [[ $(dpkg-deb -f "$dev" Depends) == "libtoothseg0 (= $version), "* ]] || complain "Depends of -dev"
  grep -q MPL-2.0 "$work/control/usr/share/doc/libtoothseg0/copyright"
  [ ! -e "$work/control/DEBIAN/postinst" ] || complain "a script where a trigger does"
  mkdir -p "$work/source/debian"
  printf 'Source: toothseg\n\nPackage: libtoothseg0\nArchitecture: any\n' >"$work/source/debian/control"
  cd "$work/source"
  # Level 4: each symbol that is new, or gone, is a fault.
  dpkg-gensymbols -c4 -plibtoothseg0 -v"${version%-*}" -I"$work/control/DEBIAN/symbols" -P"$work/control" -O/dev/null
  [[ $(dpkg-shlibdeps -O -S"$work/control" "$work/deb_pc/c_shared") == *"libtoothseg0 (>= 0.1.0)"* ]] ||
    complain "a program that needs the library does not depend on it"
}

unpack_tarball() {
  mkdir -p "$tree"
  tar -xzf "$work"/out/*.tar.gz -C "$tree" --strip-components=1
  for file in LICENSE THIRD_PARTY.md; do cmp "$root/$file" "$tree/share/doc/toothseg/$file"; done
  # It may lie anywhere: no file names the folders that it comes from.
  if grep -rIlF -e "$build" -e "$root" -e /usr/local "$tree"; then complain "these name a folder of this machine"; fi
}

# ------------------------------------------------------------------------------------------------------------ consumers

# The labels are the same from every package, library and language. The first program says which.
says_the_same() {
  local said
  said=$("$@")
  [ -e "$work/labels.txt" ] || echo "$said" >"$work/labels.txt"
  [[ $said =~ ^([0-9]+)" labels on "[0-9]+" faces" && ${BASH_REMATCH[1]} -ge 2 ]] || complain "no labels: $said"
  [ "$said" = "$(cat "$work/labels.txt")" ] || complain "other labels: $said"
}
needs_the_shared() { [[ $(ldd "$1") == *"libtoothseg.so.0 => $2/"* ]] || complain "not linked to the library below $2"; }
needs_no_shared() { [[ $(ldd "$1") != *libtoothseg* ]] || complain "the static library was not taken"; }

by_cmake() {
  local out=$1 prefix=$2
  env -u PKG_CONFIG_PATH cmake -S "$here/consumer" -B "$out" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_C_FLAGS_DEBUG=-O0 -DCMAKE_CXX_FLAGS_DEBUG=-O0
  grep -qF "toothseg_DIR:PATH=$prefix/" "$out/CMakeCache.txt" || complain "another package was found"
  cmake --build "$out" -j 1
  for language in c cpp; do
    needs_the_shared "$out/${language}_toothseg" "$prefix"
    needs_no_shared "$out/${language}_static"
    says_the_same "$out/${language}_toothseg"
    says_the_same "$out/${language}_static"
  done
}

# pkg-config escapes spaces for a shell, hence the evals. A linker takes the shared library where both are, unless told.
by_pkg_config() {
  local out=$1 prefix=$2 libdir flags shared static link language
  PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name toothseg.pc)")
  export PKG_CONFIG_PATH
  libdir=${PKG_CONFIG_PATH%/pkgconfig}
  flags="-O0 -Wall -Wextra -pedantic -Werror $(pkg-config --cflags toothseg)"
  shared=$(pkg-config --libs toothseg)
  static=$(pkg-config --static --libs toothseg | sed 's/-ltoothseg/-ltoothseg_arch -l:libtoothseg.a/')
  [[ $(pkg-config --static --cflags toothseg) == *-DTS_STATIC* ]] || complain "--static does not define TS_STATIC"
  mkdir -p "$out"
  cd "$out"
  eval "$cc -c -std=c99 $flags '$here/consumer/count_labels.c' -o c.o"
  eval "$cxx -c -std=c++17 $flags '$here/consumer/count_labels.cpp' -o cpp.o"
  for language in c cpp; do
    link=$cxx
    [ $language = cpp ] || link=$cc
    # The arch is in C++, so a program in C has to name the C++ library.
    eval "$link $language.o -o ${language}_shared $shared -ltoothseg_arch -lstdc++ -lm"
    eval "$link $language.o -o ${language}_static $static"
    LD_LIBRARY_PATH=$libdir needs_the_shared "./${language}_shared" "$prefix"
    needs_no_shared "./${language}_static"
    LD_LIBRARY_PATH=$libdir says_the_same "./${language}_shared"
    says_the_same "./${language}_static"
  done
}

# ----------------------------------------------------------------------------------------------------------------- hosts

no_openmesh_inside() {
  nm -C "$tree/lib/libtoothseg.a" "$tree/lib/libtoothseg_arch.a" >"$work/symbols.txt"
  nm -C -D "$tree/lib/libtoothseg.so" >>"$work/symbols.txt"
  objdump -p "$tree/lib/libtoothseg.so" >>"$work/symbols.txt"
  grep -q ts_segment_click "$work/symbols.txt"
  if grep OpenMesh "$work/symbols.txt"; then complain "is OpenMesh's"; fi
}

own_openmesh() {
  local lib=$tree/lib
  "$cxx" -c -O0 -std=c++17 -I"$tree/include" "$here/own_openmesh.cpp" -o "$work/own_openmesh.o"
  "$cxx" "$work/own_openmesh.o" -o "$work/own_openmesh" -L"$lib" -ltoothseg_arch -ltoothseg -lOpenMeshCore
  "$cxx" "$work/own_openmesh.o" -o "$work/own_openmesh_static" -L"$lib" -ltoothseg_arch -l:libtoothseg.a -ltbb -lOpenMeshCore
  [[ $(ldd "$work/own_openmesh") == *libOpenMeshCore* ]] || complain "the host does not use OpenMesh's library"
  LD_LIBRARY_PATH=$lib says_the_same "$work/own_openmesh"
  says_the_same "$work/own_openmesh_static"
}

two_copies() {
  mkdir -p "$work/copies"
  cp "$tree/lib/libtoothseg.so" "$work/copies/plugin_a.so"
  cp "$tree/lib/libtoothseg.so" "$work/copies/plugin_b.so"
  "$cxx" -O0 -std=c++17 -Wall -Wextra -Werror -I"$tree/include" "$here/two_copies.cpp" -o "$work/two_copies" \
    -L"$tree/lib" -ltoothseg_arch -ldl -pthread
  says_the_same "$work/two_copies" "$work/copies/plugin_a.so" "$work/copies/plugin_b.so"
}

check "the packages are made" make_packages
check "dpkg installs them, with what they depend on" install_debs
check "the tarball is whole, and names no folder" unpack_tarball
check ".deb, by CMake" by_cmake "$work/deb_build" "$deb/usr"
check ".deb, by pkg-config" by_pkg_config "$work/deb_pc" "$deb/usr"
check "tarball, by CMake" by_cmake "$work/tree build" "$tree"
check "tarball, by pkg-config" by_pkg_config "$work/tree pc" "$tree"
check "Depends, symbols and triggers" debian_metadata
check "no OpenMesh in the libraries" no_openmesh_inside
check "a host with an OpenMesh of its own" own_openmesh
check "two copies in one process" two_copies
check "dpkg removes them, and all of them" remove_debs
check "the recipes" /usr/bin/python3 "$here/test_recipes.py" "$build"
export TS_PACKAGE_OWNERS=$work/owners.json # dpkg is asked once
check "THIRD_PARTY.md" /usr/bin/python3 "$root/scripts/check_third_party.py" "$build"
check "what is not in THIRD_PARTY.md is found" /usr/bin/python3 "$here/test_third_party.py" "$build"

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
