#!/bin/bash
# Makes a root of the other Debian that pedzone is for, and runs the two commands of the README in it.
#
#   other_debian.sh SOURCE_FOLDER [SUITE]
#
# SUITE: trixie (Debian 13), on that itself bookworm (Debian 12). Exit code 77: skipped, since there
# is no mmdebstrap, no right to make a root, or no package source that has the suite.
set -euo pipefail
source=$(realpath "$1")

skip() {
  echo "Skipped: $1"
  exit 77
}

((EUID == 0)) || skip "only root can make the root of another Debian"
command -v mmdebstrap >/dev/null || skip "mmdebstrap is not installed"
unshare --mount --pid --fork true 2>/dev/null || skip "this process may not make namespaces"

codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
suite=${2:-$([[ "$codename" == trixie ]] && echo bookworm || echo trixie)}
# The package source of this machine has the other suite, too.
mirror=$(apt-get indextargets --format '$(CODENAME) $(REPO_URI)' 'Created-By: Packages' \
                'Origin: Debian' 2>/dev/null | sed -n "s/^$codename //p" | head -n 1)
[[ -n "$mirror" ]] || skip "apt-get knows no package source of Debian $codename (apt-get update?)"

work=$(mktemp -d -t pedzone-debian-XXXXXX)
trap 'rm -rf --one-file-system "$work"' EXIT
chmod 755 "$work"
root=$work/root
echo "Making a root of $suite from $mirror"
if ! mmdebstrap --quiet --variant=apt --include=ca-certificates \
                --skip=cleanup/apt/lists "$suite" "$root" "$mirror" >"$work/log" 2>&1; then
  cat "$work/log"
  skip "no root of $suite can be made from $mirror"
fi

# As on this machine: names of hosts, and what npm needs to reach its registry.
cp /etc/resolv.conf /etc/hosts "$root/etc/"
settings=(HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
for name in http_proxy https_proxy no_proxy; do
  [[ -z "${!name:-}" ]] || settings+=("$name=${!name}")
done
if command -v npm >/dev/null; then
  settings+=("npm_config_registry=$(npm config get registry)")
fi
if [[ -r "${NODE_EXTRA_CA_CERTS:-}" ]]; then
  cp "$NODE_EXTRA_CA_CERTS" "$root/etc/host-certificates.crt"
  settings+=(NODE_EXTRA_CA_CERTS=/etc/host-certificates.crt)
fi

mkdir "$root/pedzone"
tar -C "$source" --exclude='./build*' --exclude=./out --exclude=./.git -cf - . |
  tar -C "$root/pedzone" -xf -

# In namespaces of its own: whatever it mounts or starts ends with it.
unshare --mount --propagation private --pid --fork --kill-child \
  bash -c 'mount -t proc proc "$0/proc" && mount --rbind /sys "$0/sys" &&
           mount --rbind /dev "$0/dev" && mount -t tmpfs tmpfs "$0/run" || exit 1
           exec chroot "$0" env -i "$@"' \
  "$root" "${settings[@]}" \
  bash -c 'cd /pedzone && tools/test.sh && tools/run.sh' </dev/null
