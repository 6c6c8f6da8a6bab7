#!/usr/bin/env bash
# Runs the quick validation. Fails unless every check passes, or stands in the table of tests/README.md with the verdict that it
# has here.
#
#   tests/validation/quick.sh PROGRAM
set -euo pipefail
table=$(dirname -- "${BASH_SOURCE[0]}")/../README.md
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
printf '%s\n' '<!-- hackle validate: table -->' '<!-- end -->' >"$out/table.md"
code=0
"$1" validate --quick -q -o "$out" --update "$out/table.md" || code=$?
[ "$code" -le 1 ]
bad=0
while IFS= read -r row; do
  known=$(cut -d '|' -f 2,3 <<<"$row")
  grep -F -- "$known" "$table" | grep -q -- '| fail' && continue
  echo "fails, but not in tests/README.md: $row" >&2
  bad=1
done < <(grep -- '| fail' "$out/table.md" || true)
exit "$bad"
