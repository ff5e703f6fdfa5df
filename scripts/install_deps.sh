#!/usr/bin/env bash
# Installs the Debian packages that are missing: `install_deps.sh build|demo|test`. Nothing is asked of the network when all are there.
set -euo pipefail
what=${1:-build}
packages="g++ cmake ninja-build pkg-config libeigen3-dev libopenmesh-dev libtbb-dev"
[ "$what" = build ] || packages="$packages python3 python3-numpy python3-scipy python3-pil"
[ "$what" = test ] && packages="$packages doctest-dev binutils valgrind abigail-tools"
missing=""
for p in $packages; do
  dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing="$missing $p"
done
[ -z "$missing" ] && exit 0
echo "installing:$missing"
sudo=""
[ "$(id -u)" = 0 ] || sudo=sudo
$sudo apt-get update -qq
DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y -qq --no-install-recommends $missing >/dev/null
