#!/bin/bash
# Makes a root of the other Debian that pedzone is for, and runs the two commands of the README in it.
#
#   other_debian.sh SOURCE_FOLDER [SUITE]
#
# SUITE: trixie (Debian 13), on that itself bookworm (Debian 12). Exit code 77: skipped, since there
# is no mmdebstrap, no right to make a root, or no package source that has the suite.
set -euo pipefail
source=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/root.sh"
make_root "${2:-$(other_suite)}"

# What npm needs to reach its registry, as on this machine.
settings=()
if command -v npm >/dev/null; then
  settings+=("npm_config_registry=$(npm config get registry)")
fi
if [[ -r "${NODE_EXTRA_CA_CERTS:-}" ]]; then
  cp "$NODE_EXTRA_CA_CERTS" "$root/etc/host-certificates.crt"
  settings+=(NODE_EXTRA_CA_CERTS=/etc/host-certificates.crt)
fi
# A second run compiles only what has changed.
if command -v ccache >/dev/null; then
  compiled=$(ccache --get-config cache_dir)
  mkdir -p "$compiled"
fi
mkdir "$root/pedzone"
tar -C "$source" --exclude='./build*' --exclude=./out --exclude=./.git -cf - . |
  tar -C "$root/pedzone" -xf -
in_root "${settings[@]}" bash -c 'cd /pedzone && tools/test.sh && tools/run.sh'
