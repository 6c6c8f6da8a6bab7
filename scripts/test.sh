#!/usr/bin/env bash
# Installs missing packages, builds a release and runs every test.
#
#   scripts/test.sh [PRESET] [CTEST OPTION ...]      default preset: release
#   scripts/test.sh asan                             the same under address and UB sanitizers
#   scripts/test.sh release -L unit                  only the tests that take seconds
set -euo pipefail
scripts=$(dirname -- "${BASH_SOURCE[0]}")
preset=${1:-release}
[ $# -eq 0 ] || shift

"$scripts/setup.sh" "$preset"
cd "$("$scripts/plain_name.sh")"
ctest --preset "$preset" --parallel "$(nproc)" --no-label-summary "$@"
