#!/usr/bin/env bash
# Fails if the shared library exports anything but functions named ts_* and its version node.
set -euo pipefail
other=$(nm -D --defined-only "$1" | awk '{print $3}' | grep -vE '^ts_[a-z_]+(@@TS_0)?$|^TS_0$|^TS_0@@TS_0$' || true)
count=$(nm -D --defined-only "$1" | grep -c ' T ts_')
if [ -n "$other" ]; then
  echo "exported besides ts_*:"
  echo "$other"
  exit 1
fi
[ "$count" -gt 40 ] || { echo "only $count functions are exported"; exit 1; }
echo "$count functions exported, all ts_*"
