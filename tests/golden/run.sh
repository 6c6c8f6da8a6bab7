#!/usr/bin/env bash
# Compares the final states of small scenes with those of hashes.txt, to the bit.
#
#   tests/golden/run.sh PROGRAM ...         the states of each program
#   tests/golden/run.sh --builds            those of g++ and clang++ at -O2 and -O3, which it builds in build/golden
#   tests/golden/run.sh --accept PROGRAM    writes hashes.txt anew: every user's results change
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."
scenes=tests/golden/scenes.lua
hashes=tests/golden/hashes.txt

states() {
  local out
  out=$(mktemp -d)
  "$1" run -q "$scenes" -o "$out"
  rm -rf "$out"
}

compare() {
  if ! diff <(states "$1") "$hashes"; then
    echo "$1 gives other states than $hashes (above: its own, then those expected)" >&2
    return 1
  fi
  echo "$1: $(wc -l <"$hashes") states are equal to the bit"
}

build() {
  cmake --preset release -B "$3" -DCMAKE_CXX_COMPILER="$1" -DCMAKE_CXX_FLAGS_RELEASE="$2 -DNDEBUG" \
    -DHACKLE_KERNEL_LEVEL="$2" -DHACKLE_WERROR=OFF -DBUILD_TESTING=OFF >/dev/null
  cmake --build "$3" --target hackle
}

case ${1:-} in
  --accept)
    states "$2" >"$hashes"
    ;;
  --builds)
    for compiler in g++ clang++; do
      for level in -O2 -O3; do
        folder=build/golden/$compiler$level
        build "$compiler" "$level" "$folder"
        compare "$folder/bin/hackle"
      done
    done
    ;;
  *)
    for program in "$@"; do compare "$program"; done
    ;;
esac
