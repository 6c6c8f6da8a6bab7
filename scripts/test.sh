#!/usr/bin/env bash
# Installs what is missing, builds a release and passes every test.
#
#   scripts/test.sh [PRESET] [CTEST OPTION ...]      default preset: release
#   scripts/test.sh asan                             the same under address and UB sanitizers
#   scripts/test.sh release -L unit                  only what is over in seconds
set -euo pipefail
scripts=$(dirname -- "${BASH_SOURCE[0]}")
preset=${1:-release}
[ $# -eq 0 ] || shift

"$scripts/setup.sh" "$preset"
cd "$("$scripts/plain_name.sh")"
ctest --preset "$preset" --parallel "$(nproc)" --no-label-summary "$@"
