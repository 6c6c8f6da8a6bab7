#!/usr/bin/env bash
# Installs what is missing, builds a release and passes every test.
#
#   scripts/test.sh [PRESET] [CTEST OPTION ...]      default preset: release
#   scripts/test.sh asan                             the same under address and UB sanitizers
#   scripts/test.sh release -L unit                  only what is over in seconds
set -euo pipefail
here=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-release}
[ $# -eq 0 ] || shift

"$here/scripts/setup.sh" "$preset"
cd "$here"
ctest --preset "$preset" --parallel "$(nproc)" --no-label-summary "$@"
