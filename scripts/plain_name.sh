#!/usr/bin/env bash
# Prints a name of this checkout that CMake, compilers and shells accept: its own if that consists of
# letters, digits, blanks and _ . / + -, otherwise a link to it. CMake 3.25 breaks at quotes, and at more than those.
set -euo pipefail
here=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
LC_ALL=C

is_plain() { [[ $1 != *[^A-Za-z0-9_./+\ -]* ]]; }

if is_plain "$here"; then
  printf '%s\n' "$here"
  exit
fi
# The name must never change, otherwise a build would start again.
for folder in "${XDG_CACHE_HOME:-}" "${HOME:+$HOME/.cache}" "/tmp/hackle-$(id -u)"; do
  link=$folder/hackle/checkout-$(printf '%s' "$here" | sha256sum | head -c 12)
  if [ -n "$folder" ] && is_plain "$folder" && mkdir -p -- "${link%/*}" && ln -sfn -- "$here" "$link"; then
    printf '%s\n' "$link"
    exit
  fi
done
echo "Hackle cannot be built in '$here', and no link with a plainer name could be made" >&2
exit 1
