#!/usr/bin/env bash
# Installs the Debian packages that Hackle needs and builds a release.
#
#   scripts/setup.sh [PRESET [TARGET]]      default: release, all that the preset builds
#
# Skips everything already done. Works as root, through sudo, or, if every package is installed, as any user.
set -euo pipefail
here=$(dirname -- "${BASH_SOURCE[0]}")
cd "$("$here/plain_name.sh")"
preset=${1:-release}
target=${2:-}

packages=(
  g++ cmake ninja-build pkg-config git
  libeigen3-dev libosmesa6-dev libegl-dev liblua5.4-dev libhdf5-dev zlib1g-dev
  libavcodec-dev libavformat-dev libavutil-dev libswscale-dev
  libtbb-dev libcli11-dev libfmt-dev nlohmann-json3-dev libxxhash-dev libedit-dev libchafa-dev
  libcairo2-dev libpng-dev fonts-dejavu-core libgtest-dev libgmock-dev libbenchmark-dev
)

if ! command -v dpkg-query >/dev/null; then
  echo "Hackle is built on Debian 12: there is no dpkg-query here. It needs: ${packages[*]}" >&2
  exit 1
fi
missing=()
for package in "${packages[@]}"; do
  # It fails for a package unknown to this machine, which counts as missing.
  if ! status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || [ "$status" != installed ]; then
    missing+=("$package")
  fi
done

if [ ${#missing[@]} -gt 0 ]; then
  if [ "$(id -u)" -eq 0 ]; then
    as_root=(env)
  elif command -v sudo >/dev/null; then
    as_root=(sudo env)
  else
    echo "Hackle needs packages that only root can install. Ask for:" >&2
    echo "  apt-get install ${missing[*]}" >&2
    exit 1
  fi
  echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  log=$(mktemp)
  install() {
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
  }
  # The package lists of a fresh machine are empty and those of an old one stale: refresh them once, then install.
  if ! { "${as_root[@]}" apt-get update && install; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "The packages could not be installed; the whole log is $log" >&2
    exit 1
  fi
  rm -f "$log"
fi

cmake --preset "$preset"
cmake --build --preset "$preset" ${target:+--target "$target"}
