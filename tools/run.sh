#!/bin/bash
# Installs what is missing, builds, and runs the main job: Bad Hersfeld with shuttles.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tools/fingerprint.sh

usage() {
  cat <<'TEXT'
usage: tools/run.sh [--again] [-- OPTIONS OF pedzone run]

Installs what is missing, builds, walks the people of Bad Hersfeld's old town among its shuttles,
and says where the results are (out/bad-hersfeld). Does nothing but say so when program and
scenario have not changed since; --again runs all the same.
TEXT
}

again=no
options=()
while (($#)); do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --again) again=yes ;;
    --) shift; options=("$@"); break ;;
    *) echo "Error: unknown option '$1'" >&2; usage >&2; exit 2 ;;
  esac
  shift
done

tools/install.sh
[[ -f build/build.ninja ]] || cmake --preset release
cmake --build --preset release --target pedzone

out=out/bad-hersfeld
print_results() {
  cat <<TEXT
Results in $PWD/$out:
  paths.svg, paths.png   everybody's path through the zone
  summary.json           the table above, as JSON
  trajectories.csv       time,id,x,y,vx,vy,heading,activity,pastime
  tripinfo.xml           SUMO's own trip report
TEXT
}

stamp=$(fingerprint build/src/app/pedzone scenarios/bad-hersfeld networks/bad-hersfeld \
        tools/run.sh <<<"${options[*]}")
if [[ "$again" == no && -f $out/stamp && "$(<$out/stamp)" == "$stamp" ]]; then
  cat $out/table.txt
  echo "Program and scenario unchanged: these are the results of $(date -r $out/stamp '+%F %H:%M')."
  print_results
  exit 0
fi

rm -rf $out
mkdir -p $out
build/src/app/pedzone run scenarios/bad-hersfeld/centre-shuttle.sumocfg \
  --summary $out/summary.json --trajectories $out/trajectories.csv --paths-svg $out/paths.svg \
  "${options[@]}" -- --tripinfo-output "$PWD/$out/tripinfo.xml" | tee $out/table.txt
rsvg-convert --width 1600 --keep-aspect-ratio --output $out/paths.png $out/paths.svg
echo "$stamp" >$out/stamp
print_results
