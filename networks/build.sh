#!/bin/bash
# Rebuilds the networks from their netconvert sources, with SUMO 1.15 byte for byte.
#
#   networks/build.sh            rebuilds every NAME/NAME.net.xml; only with SUMO 1.15's netconvert
#   networks/build.sh --check    rebuilds into a temporary folder and fails where one differs; with
#                                another netconvert where streets or links differ
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

export SUMO_HOME="${SUMO_HOME:-/usr/share/sumo}"
readonly kVersion='^<net version="1\.9"'  # of the format that netconvert 1.15 writes
readonly kNames=(plaza narrow-lane street-zone dense-square crossing experiments shopping-street high-street)
readonly kUnmarked=high-street/high-street-unmarked  # the same streets with other crossings

# build NAME FILE [CONNECTIONS]
build() {
  local name=$1 file=$2 connections=() own=${3:-$1/$1.con.xml}
  [[ -f $own ]] && connections=(--connection-files "$own")
  netconvert --type-files streets.typ.xml --node-files "$name/$name.nod.xml" \
    --edge-files "$name/$name.edg.xml" "${connections[@]}" \
    --walkingareas true --no-turnarounds true --offset.disable-normalization true \
    --junctions.internal-link-detail 8 --output-file "$file.raw" > "$file.log"
  # The comment that netconvert writes at the top holds the date and the paths of this machine.
  sed '/^<!-- generated on/,/^-->/d' "$file.raw" > "$file"
  rm "$file.raw" "$file.log"
}

# What netconvert 1.18 writes otherwise than 1.15 (measured; all the rest is the same): the version of
# the format, types that no edge has, walking areas and crossings (1.18 rounds their corners and
# allows 2.78 m/s instead of 1), junctions' shapes by 1 cm, and the right of way where two lanes of the
# high street become one.
streets_and_links() {
  sed -E -e 's/^<net version="[^"]*"//' -e '/^    <type id=/d' \
    -e '/<lane id=":[^"]*_[wc][0-9]+_0"/d' -e '/<junction /s/ shape="[^"]*"//' \
    -e '/<request /d' -e '/<connection /s/ state="[^"]*"//' "$1"
}

# differs BUILT KEPT
differs() {
  if grep -q "$kVersion" "$1"; then
    ! cmp "$1" "$2"
  else
    ! diff <(streets_and_links "$1") <(streets_and_links "$2")
  fi
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
differing=0 mode=${1:-}

# keep BUILT KEPT
keep() {
  if [[ $mode == --check ]]; then
    ! differs "$1" "$2" || differing=1
  elif grep -q "$kVersion" "$1"; then
    cp "$1" "$2"
  else
    echo "Error: the networks that are kept are netconvert 1.15's; this is another one" >&2
    exit 1
  fi
}

for name in "${kNames[@]}"; do
  build "$name" "$work/$name.net.xml"
  keep "$work/$name.net.xml" "$name/$name.net.xml"
done
build "${kUnmarked%/*}" "$work/unmarked.net.xml" "$kUnmarked.con.xml"
keep "$work/unmarked.net.xml" "$kUnmarked.net.xml"
exit $differing
