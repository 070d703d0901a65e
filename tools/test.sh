#!/bin/bash
# Installs what is missing, builds, and runs the tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tools/fingerprint.sh

usage() {
  cat <<'TEXT'
usage: tools/test.sh [--long] [--again] [-- OPTIONS OF ctest]

Installs what is missing, builds in build/, and runs the tests.
  --long    also those that take long: the property test over 1,000,000 person-steps, many seeds,
            all tests in a root of the other Debian (12 or 13; only root can make it), and the unit
            tests under sanitizers: all of them for memory, those with threads for data races
            (build-*/)
  --again   run even when nothing has changed since the tests last passed
Exit code: 0 when all tests passed.
TEXT
}

long=no again=no
options=()
while (($#)); do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --long) long=yes ;;
    --again) again=yes ;;
    --) shift; options=("$@"); break ;;
    *) echo "Error: unknown option '$1'" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

jobs=$(($(nproc) + 1))  # some tests wait, for Slurm or a browser

# run_tests BUILD_PRESET TEST_PRESET...   builds, and runs each test preset unless it last passed
# with the same files.
run_tests() {
  local build=$1 preset stamp saved dir
  shift
  dir=build-$build
  [[ "$build" != release ]] || dir=build
  [[ -f "$dir/build.ninja" ]] || cmake --preset "$build"
  cmake --build --preset "$build"
  for preset in "$@"; do
    saved=$dir/tests-passed-$preset
    stamp=$(fingerprint CMakeLists.txt CMakePresets.json LICENSE src tests networks scenarios tools \
            <<<"${options[*]}")
    if [[ "$again" == no && -f $saved && "$(head -n 1 "$saved")" == "$stamp" ]]; then
      echo "Tests ($preset): nothing has changed since they passed, $(date -r "$saved" '+%F %H:%M'):"
      tail -n +2 "$saved"
      continue
    fi
    rm -f "$saved"
    ctest --preset "$preset" -j "$jobs" "${options[@]}" | tee "$dir/tests-$preset.log"
    { echo "$stamp"; grep -E 'tests passed|Total Test time' "$dir/tests-$preset.log"; } >"$saved"
  done
}

if [[ "$long" == yes ]]; then
  tools/install.sh --long
  run_tests release long
  for sanitizer in memory thread; do
    run_tests $sanitizer $sanitizer
  done
else
  tools/install.sh
  run_tests release release
fi
