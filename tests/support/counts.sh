# shellcheck shell=sh
# SPDX-License-Identifier: Apache-2.0
# Sourced by tests that are scripts: counts what passes and fails. $work is a folder of theirs; say_ok=1 says what passes as well.
passed=0
failed=0

# check NAME COMMAND...: one test. What the command said, in $work/log, is shown where it fails.
check() {
  checked=$1
  shift
  if "$@" >"$work/log" 2>&1; then
    passed=$((passed + 1))
    [ -z "${say_ok:-}" ] || echo "ok      $checked"
  else
    failed=$((failed + 1))
    echo "FAILED  $checked"
    tail -n 30 "$work/log" | sed 's/^/        /'
  fi
}

fails() { ! "$@"; }

# add_counts WHAT FILE: a program that counts for itself wrote FILE. Without `N passed, M failed` in its last line it broke off.
add_counts() {
  counted=$(tail -n 1 "$2" | tr -d '\r')
  if echo "$counted" | grep -Eqx '[0-9]+ passed, [0-9]+ failed'; then
    passed=$((passed + ${counted%% *}))
    counted=${counted#*, }
    failed=$((failed + ${counted%% *}))
  else
    failed=$((failed + 1))
    echo "FAILED  $1 broke off: $counted"
  fi
}

# The last line of all, and the script's exit status.
finish() {
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ]
}
