# shellcheck shell=bash
# Sourced by the other scripts.

# fingerprint PATH...   one line that changes when a file below the paths, its name, or what is on
# standard input changes.
fingerprint() {
  {
    find "$@" -type f ! -path '*/__pycache__/*' -print0 | LC_ALL=C sort -z |
      xargs -0 sha256sum
    cat
  } | sha256sum | cut -d' ' -f1
}
