# For scripts that work in a root of a Debian of its own. Sourced; exit code 77 is "skipped".

skip() {
  echo "Skipped: $1"
  exit 77
}

# The Debian that this is, and the other one that pedzone is for.
this_suite() { (. /etc/os-release && echo "${VERSION_CODENAME:-}"); }
other_suite() { if [[ "$(this_suite)" == trixie ]]; then echo bookworm; else echo trixie; fi; }

# make_root SUITE   sets $work, a folder that goes with the script, and $root in it.
make_root() {
  local suite=$1 mirror
  ((EUID == 0)) || skip "only root can make the root of a Debian"
  command -v mmdebstrap >/dev/null || skip "mmdebstrap is not installed"
  unshare --mount --pid --fork true 2>/dev/null || skip "this process may not make namespaces"
  # The package source of this machine has the other suite, too.
  mirror=$(apt-get indextargets --format '$(CODENAME) $(REPO_URI)' 'Created-By: Packages' \
                  'Origin: Debian' 2>/dev/null | sed -n "s/^$(this_suite) //p" | head -n 1)
  [[ -n "$mirror" ]] || skip "apt-get knows no package source of Debian (apt-get update?)"
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
  cp /etc/resolv.conf /etc/hosts "$root/etc/"  # names of hosts, as on this machine
}

# in_root [NAME=VALUE...] COMMAND...   in namespaces of its own: what it mounts or starts ends with it.
# Where $compiled names a folder, it is /compiled there: what ccache keeps from one root to the next.
in_root() {
  local settings=(HOME=/root LANG=C.UTF-8
                  PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin) name
  for name in http_proxy https_proxy no_proxy; do
    [[ -z "${!name:-}" ]] || settings+=("$name=${!name}")
  done
  if [[ -n "${compiled:-}" ]]; then
    mkdir -p "$root/compiled"
    settings+=(CCACHE_DIR=/compiled)
  fi
  unshare --mount --propagation private --pid --fork --kill-child \
    bash -c 'mount -t proc proc "$0/proc" && mount --rbind /sys "$0/sys" &&
             mount --rbind /dev "$0/dev" && mount -t tmpfs tmpfs "$0/run" || exit 1
             [[ -z "$1" ]] || mount --bind "$1" "$0/compiled" || exit 1
             exec chroot "$0" env -i "${@:2}"' \
    "$root" "${compiled:-}" "${settings[@]}" "$@" </dev/null
}
