#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A source package of Debian 12, unpacked and with Debian's patches: debian_source.sh PACKAGE FOLDER. apt checks its hashes.
set -euo pipefail
cd "$2"
# The system's own lists of packages stay as they are: they may be without sources.
mkdir -p sources lists/partial
cat >sources/debian.sources <<'E'
Types: deb-src
URIs: http://deb.debian.org/debian
Suites: bookworm
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
E
options=(-q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$PWD/sources" -o Dir::State::lists="$PWD/lists"
  -o APT::Sandbox::User="$(id -un)")
apt-get "${options[@]}" update
apt-get "${options[@]}" source "$1"
