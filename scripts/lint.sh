#!/usr/bin/env bash
# Checks the formatting (clang-format 14), the spelling (codespell) and, with --tidy, the whole program with
# clang-tidy 14. Installs missing tools if it may.
set -euo pipefail
here=$(dirname -- "${BASH_SOURCE[0]}")
cd "$("$here/plain_name.sh")"

missing=()
for tool in clang-format clang-tidy codespell; do
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
git ls-files -z | xargs -0 codespell --quiet-level 3
echo "spelling: clean"

if [ "${1:-}" = --tidy ]; then
  # A release is built in units of several sources, so each header is checked once for all of them. The kernels
  # are compiled from one source, once per instruction set: it is also checked only once.
  # Without precompiled headers, every unit must include what it uses.
  cmake --preset release -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DBUILD_TESTING=OFF
  cmake --build build/tidy --target hackle_git_hash
  units() {
    find "$PWD/build/tidy/src" -name 'unity_*_cxx.cxx' ! -path '*/hackle_kernel_*'
    find "$PWD/build/tidy/src" -name 'unity_*_cxx.cxx' -path '*/hackle_kernel_baseline_double.dir/*'
    printf '%s\n' "$PWD/src/base/version.cpp"
  }
  units | xargs -d '\n' -P "$(nproc)" -n 1 \
    clang-tidy -p build/tidy --quiet --header-filter='/src/.*\.[ch]pp$' --warnings-as-errors='*'
  echo "clang-tidy: clean"
fi
