#!/usr/bin/env bash
# The reference of the C API and the task pages as HTML, into build/docs/html. A symbol of the header without a description, a
# broken link between pages, or an example that does not compile is an error. `docs.sh --check`: the examples alone.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0 pages=0
for page in docs/tasks/*.md; do
  awk '/^```c$/ {on = 1; next} /^```$/ {on = 0; next} on' "$page" >"$scratch/page.c"
  pages=$((pages + 1))
  ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -fsyntax-only -Iinclude "$scratch/page.c" || {
    echo "docs.sh: the examples of $page do not compile" >&2
    failed=1
  }
  for link in $(grep -o '](\([a-z_-]*\.md\))' "$page" | sed 's/](\(.*\))/\1/'); do
    [ -f "docs/tasks/$link" ] || { echo "docs.sh: $page links to $link, which is not there" >&2; failed=1; }
  done
done
[ "$failed" = 0 ] || exit 1
echo "examples of $pages pages compile"
[ "${1:-}" != --check ] || exit 0
mkdir -p build
doxygen docs/Doxyfile
echo "build/docs/html/index.html"
