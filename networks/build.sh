#!/bin/bash
# Rebuilds the networks from their netconvert sources (SUMO 1.15), byte for byte.
#
#   networks/build.sh            rebuilds every NAME/NAME.net.xml
#   networks/build.sh --check    rebuilds into a temporary folder and fails where one differs
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

export SUMO_HOME="${SUMO_HOME:-/usr/share/sumo}"
readonly kNames=(plaza narrow-lane street-zone dense-square crossing experiments)

# build NAME FILE
build() {
  local name=$1 file=$2 connections=()
  [[ -f $name/$name.con.xml ]] && connections=(--connection-files "$name/$name.con.xml")
  netconvert --type-files streets.typ.xml --node-files "$name/$name.nod.xml" \
    --edge-files "$name/$name.edg.xml" "${connections[@]}" \
    --walkingareas true --no-turnarounds true --offset.disable-normalization true \
    --junctions.internal-link-detail 8 --output-file "$file.raw" > "$file.log"
  # The comment that netconvert writes at the top holds the date and the paths of this machine.
  sed '/^<!-- generated on/,/^-->/d' "$file.raw" > "$file"
  rm "$file.raw" "$file.log"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
differing=0
for name in "${kNames[@]}"; do
  build "$name" "$work/$name.net.xml"
  if [[ ${1:-} != --check ]]; then
    cp "$work/$name.net.xml" "$name/$name.net.xml"
  elif ! cmp "$work/$name.net.xml" "$name/$name.net.xml"; then
    differing=1
  fi
done
exit $differing
