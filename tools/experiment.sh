#!/bin/bash
# Runs one of the paper's experiments, draws it and prints what is measured.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'TEXT'
usage: tools/experiment.sh EXPERIMENT [--model M] [--seed N] [--out FOLDER]

EXPERIMENT: 5.1, 5.2a, 5.2b, 5.3, 5.4 (scenarios/experiments/README.md says what they show).
Results are in FOLDER, out/experiments/EXPERIMENT where none is given: a time-plot, charts of speed
and clearance, an animation (5.1: one each for the vehicle steered straight, half and fully),
trajectories and SUMO's floating-car data; for 5.1 all three in one picture, for 5.3 four snapshots,
for 5.4 the ways stretched across.
TEXT
}

fail() { echo "Error: $1" >&2; usage >&2; exit 2; }

[[ "${1:-}" != --help && "${1:-}" != -h ]] || { usage; exit 0; }
experiment=${1:-}
case "$experiment" in
  5.1) variants=(-straight -half -full) ;;
  5.2a | 5.2b | 5.3 | 5.4) variants=("") ;;
  *) fail "'$experiment' is no experiment; allowed: 5.1, 5.2a, 5.2b, 5.3, 5.4" ;;
esac
shift
seed=1 out=out/experiments/$experiment
model=()
while (($#)); do
  (($# > 1)) || fail "$1 has no value"
  case "$1" in
    --model) model=(--model "$2") ;;
    --seed) seed=$2 ;;
    --out) out=$2 ;;
    *) fail "unknown option '$1'" ;;
  esac
  shift 2
done

[[ -x ${PEDZONE:-build/src/app/pedzone} ]] || {
  tools/install.sh
  [[ -f build/build.ninja ]] || cmake --preset release
  cmake --build --preset release --target pedzone
}
pedzone=${PEDZONE:-build/src/app/pedzone}
folder=scenarios/experiments
mkdir -p "$out"
for variant in "${variants[@]}"; do
  name=$experiment$variant
  zone=$folder/$name.zone.xml
  fcd=$(realpath "$out")/$name.fcd.xml
  $pedzone run "$folder/$experiment.sumocfg" --zone "$zone" --seed "$seed" "${model[@]}" \
    --trajectories "$out/$name.csv" --summary "$out/$name.json" \
    -- --fcd-output "$fcd" --no-warnings true >"$out/$name.txt"
  scenario=(--fcd "$fcd" --scenario "$folder/$experiment.sumocfg" --zone "$zone")
  kinds=(time speed)
  [[ ! -f $folder/$name.csv ]] || kinds+=(clearance)  # where a vehicle drives
  for kind in "${kinds[@]}"; do
    $pedzone plot "$out/$name.csv" "${scenario[@]}" --kind $kind --out "$out/$name-$kind.svg"
  done
  $pedzone animate "$out/$name.csv" "${scenario[@]}" --out "$out/$name.html"
  echo "$name, seed $seed:"
  /usr/bin/python3 tests/scenario/experiments.py --fcd "$fcd" "$experiment" --variant "${variant#-}"
done
# The paper's figures.
scenario=(--scenario "$folder/$experiment.sumocfg")
case "$experiment" in
  5.1)
    $pedzone plot "$out/5.1-straight.fcd.xml" --beside "$out"/5.1-{half,full}.fcd.xml \
      "${scenario[@]}" --zone $folder/5.1-full.zone.xml --out "$out/5.1-all.svg"
    ;;
  5.3)
    $pedzone plot "$out/5.3.fcd.xml" "${scenario[@]}" --zone $folder/5.3.zone.xml \
      --at 10 15 20 30 --out "$out/5.3-snapshots.svg"
    ;;
  5.4)
    for pair in upper lower; do
      $pedzone plot "$out/5.4.fcd.xml" "${scenario[@]}" --kind across --out "$out/5.4-across-$pair.svg" \
        --title "$pair pair" --persons $pair.eastbound $pair.westbound
    done
    ;;
esac
echo "Results in $(realpath "$out"): $experiment*.svg, .html (animation), .csv, .fcd.xml"
