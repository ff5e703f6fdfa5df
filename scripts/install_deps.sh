#!/usr/bin/env bash
# Installs the Debian packages that are missing: `install_deps.sh build|demo|test|web|windows|lint|fuzz|coverage|bench|study`. Nothing is asked of the network
# when all are there. As root or through sudo.
set -euo pipefail
what=${1:-build}
packages="g++ cmake ninja-build libeigen3-dev libtbb-dev nlohmann-json3-dev"
case $what in
  build) ;;
  demo) packages="$packages python3 python3-numpy python3-pil fonts-dejavu-core" ;;
  test) packages="$packages python3 python3-numpy python3-scipy python3-pil fonts-dejavu-core doctest-dev libopenmesh-dev pkg-config valgrind"
    packages="$packages python3-clang-14 clang-14 libclang-rt-14-dev lld-14 abigail-tools doxygen"
    # The languages of bindings/. A Node that is there, of whatever origin, will do.
    packages="$packages python3-pip python3-setuptools python3-wheel python3-venv rustc cargo fp-compiler mono-mcs mono-runtime dpkg-dev"
    command -v node >/dev/null && command -v npm >/dev/null || packages="$packages nodejs npm" ;;
  # WebAssembly and the viewer, with the browser that tests it.
  web) packages="$packages emscripten chromium fonts-dejavu-core"
    command -v node >/dev/null && command -v npm >/dev/null || packages="$packages nodejs npm" ;;
  # toothseg.dll and its tests under Wine. llvm-14 has llvm-dlltool, dpkg-dev unpacks oneTBB's source.
  windows) packages="$packages g++-mingw-w64-x86-64-posix wine64 wine llvm-14 clang-14 dpkg-dev python3 python3-clang-14 unzip"
    packages="$packages mono-mcs mono-runtime fp-compiler fpc-source" ;;
  lint) packages="$packages python3 clang-format-14 clang-tidy-14 libclang-14-dev cppcheck" ;;
  fuzz) packages="$packages clang-14 libclang-rt-14-dev lld-14" ;;
  coverage) packages="$packages clang-14 libclang-rt-14-dev llvm-14 doctest-dev libopenmesh-dev" ;;
  bench) packages="$packages libsuitesparse-dev libopenblas-dev" ;;
  study) packages="$packages python3 python3-numpy python3-scipy python3-matplotlib python3-pil fonts-dejavu-core libcgal-dev libopenmesh-dev" ;;
  *) echo "install_deps.sh: build, demo, test, web, windows, lint, fuzz, coverage, bench or study, not $what" >&2; exit 2 ;;
esac
command -v dpkg-query >/dev/null || { echo "install_deps.sh: needs Debian's packages: $packages" >&2; exit 1; }
missing=""
for p in $packages; do
  dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing="$missing $p"
done
[ -n "$missing" ] || exit 0
sudo=""
if [ "$(id -u)" != 0 ]; then
  sudo=sudo
  command -v sudo >/dev/null || { echo "install_deps.sh: neither root nor sudo; as root: apt-get install$missing" >&2; exit 1; }
fi
echo "installing:$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
for step in "update" "install -y --no-install-recommends $missing"; do
  # shellcheck disable=SC2086
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get -q $step >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
done
