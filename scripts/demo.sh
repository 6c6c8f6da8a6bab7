#!/usr/bin/env bash
# Breaks glass with one command on a fresh machine: installs missing packages, builds a release, runs the
# paper's first plate and lists the files it wrote.
#
#   scripts/demo.sh [OUTPUT FOLDER]      default: out/edge_crack beside this checkout
set -euo pipefail
here=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m -- "${1:-$here/out/edge_crack}")

"$here/scripts/setup.sh" release hackle
"$here/build/release/bin/hackle" run "$here/scripts/samples/edge_crack.lua" -o "$out"
