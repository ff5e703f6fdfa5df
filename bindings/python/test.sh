#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh LIBDIR BINDIR: all tests of the Python binding. LIBDIR has libtoothseg.so, BINDIR ts-segment and make-arch. Builds the
# wheel with the library inside and tests what that installs; then the package without the library. Needs Debian's python3-venv,
# python3-numpy, python3-pip, python3-setuptools and python3-wheel; checks the types where mypy is there.
set -euo pipefail
[ $# = 2 ] || { echo "usage: test.sh LIBDIR BINDIR" >&2; exit 2; }
python=/usr/bin/python3
here=$(cd "$(dirname "$0")" && pwd)
TOOTHSEG_TEST_LIBDIR=$(cd "$1" && pwd)
TOOTHSEG_TEST_BINDIR=$(cd "$2" && pwd)
export TOOTHSEG_TEST_LIBDIR TOOTHSEG_TEST_BINDIR PYTHONDONTWRITEBYTECODE=1 PIP_ROOT_USER_ACTION=ignore
unset TOOTHSEG_LIBRARY LD_LIBRARY_PATH PYTHONPATH PYTHONHOME VIRTUAL_ENV
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pip() { "$python" -m pip --disable-pip-version-check --quiet "$@"; }
fail() { echo "$1"; echo "0 passed, 1 failed"; exit 1; }

if "$python" -c "import mypy" 2>/dev/null; then
  (cd "$here" && "$python" -m mypy --cache-dir "$work/mypy") || fail "mypy: the types do not hold"
else
  echo "mypy is not there: the types are not checked"
fi

"$here/build_wheel.sh" "$TOOTHSEG_TEST_LIBDIR" "$work/wheel" || fail "the wheel cannot be built"
"$python" -m venv --without-pip --system-site-packages "$work/venv"
pip --python "$work/venv/bin/python" install --no-index --no-compile "$work"/wheel/*.whl || fail "the wheel cannot be installed"

# The package alone, from a copy, because a build leaves files in the tree.
cp -r "$here" "$work/source"
(cd "$work/source" && pip install --no-build-isolation --no-index --no-deps --no-compile --target "$work/alone" .) ||
  fail "pip install . fails"
export TOOTHSEG_TEST_ALONE="$work/alone"

cd "$work"
"$work/venv/bin/python" -W error -X faulthandler "$here/tests/run.py"
