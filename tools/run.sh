#!/bin/bash
# Installs what is missing, builds, and runs the main job: a small study, whose report it opens.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'TEXT'
usage: tools/run.sh [--again] [-- OPTIONS OF pedzone study run]

Installs what is missing, builds, asks on a plaza with vans and shuttles what changes if people
walk by pedzone's heuristic instead of SUMO's striping (scenarios/study/plaza.study.xml), and opens
the report, or says where it is where there is no display. Results are in out/plaza-study; runs
that are there and whose inputs have not changed are kept, --again makes all of them anew.
TEXT
}

out=out/plaza-study
options=()
while (($#)); do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --again) rm -rf $out ;;
    --) shift; options=("$@"); break ;;
    *) echo "Error: unknown option '$1'" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

tools/install.sh
[[ -f build/build.ninja ]] || cmake --preset release
cmake --build --preset release --target pedzone

# Results of another build are refused, as they should be; here they are only an example.
build=$(sha256sum build/src/app/pedzone | cut -d ' ' -f 1)
[[ ! -d $out ]] || grep -qs "$build" $out/study.json || rm -rf $out

build/src/app/pedzone study run scenarios/study/plaza.study.xml --out $out --jobs "$(nproc)" \
  "${options[@]}"

if [[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]] && command -v xdg-open >/dev/null; then
  xdg-open $out/report.html
fi
echo "Report: $PWD/$out/report.html"
