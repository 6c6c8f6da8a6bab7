#!/usr/bin/env bash
# Checks the formatting (clang-format 14) and, with --tidy, the whole program with clang-tidy 14.
# Installs both when they are missing and it may.
set -euo pipefail
here=$(dirname -- "${BASH_SOURCE[0]}")
cd "$("$here/plain_name.sh")"

missing=()
for tool in clang-format clang-tidy; do
  command -v "$tool" >/dev/null || missing+=("$tool")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "Installing ${missing[*]}"
  as_root=(env)
  [ "$(id -u)" -eq 0 ] || as_root=(sudo env)
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    "${missing[@]}"
fi

git ls-files '*.cpp' '*.hpp' | xargs -d '\n' clang-format --dry-run -Werror
echo "formatting: clean"

if [ "${1:-}" = --tidy ]; then
  cmake --preset release
  cmake --build --preset release --target hackle_git_hash
  # The kernels are compiled many times from one source, once a set of instructions: it is read once.
  mkdir -p build/tidy
  awk -v RS='},?\n' '{ sub(/^\[\n/, "") }
    match($0, /"file": "[^"]*"/) && !seen[substr($0, RSTART, RLENGTH)]++ { list = list (list ? ",\n" : "") $0 "}" }
    END { print "[" list "]" }' build/release/compile_commands.json >build/tidy/compile_commands.json
  git ls-files 'src/*.cpp' | xargs -d '\n' -P "$(nproc)" -n 1 \
    clang-tidy -p build/tidy --quiet --warnings-as-errors='*'
  echo "clang-tidy: clean"
fi
