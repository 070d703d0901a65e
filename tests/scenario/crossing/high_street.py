#!/usr/bin/python3
"""The high street of scenarios/cross-anywhere, with parked cars, a bus stop and 1,200 cars an hour: nobody
stands for ever, neither people nor cars.

usage: high_street.py PEDZONE [--seeds N] [--model M] [--keep FOLDER]

From SUMO's own outputs of each seed, beside plain SUMO:
- the same people arrive with the same stages
- nobody who takes no bus stands over 300 s
- no vehicle is teleported that plain SUMO gets through, none collides
- people's trips are shorter than in plain SUMO, cars lose at most 10 s more
"""
import statistics
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import street

FOLDER = Path(__file__).resolve().parents[3] / "scenarios/cross-anywhere"
SCENARIO, ZONE = FOLDER / "cars-1200.sumocfg", FOLDER / "cross-anywhere.zone.xml"
END = 1500  # [s]
LONGEST_STAND, MOST_LOSS = 300.0, 10.0  # [s]


def read_statistics(path):
    """(teleports, collisions, mean time loss of vehicles [s])."""
    root = xml.parse(path).getroot()
    return (int(root.find("teleports").get("total")), int(root.find("safety").get("collisions")),
            float(root.find("vehicleTripStatistics").get("timeLoss")))


def one_seed(folder, given, seed):
    folder.mkdir(parents=True, exist_ok=True)
    options = ("--seed", seed, "--end", END)
    street.run(folder, "pedzone", given.program, "run", SCENARIO, "--zone", ZONE, "--quiet", *options,
               *given.model)
    street.run(folder, "sumo", "sumo", "-c", SCENARIO, *options)
    ours, plain = (street.read_trips(folder / f"{name}.trips.xml") for name in ("pedzone", "sumo"))
    faults = []
    if {k: trip[::2] for k, trip in ours.items()} != {k: trip[::2] for k, trip in plain.items()}:
        faults.append("other people arrive, or by other stages, than in plain SUMO")
    for name, walk in street.read_fcd(folder / "pedzone.fcd.xml").walks.items():
        if "ride" not in ours[name][2] and walk.longest_stand() > LONGEST_STAND:
            faults.append(f"{name} stands for {walk.longest_stand():.0f} s")
    (teleports, collisions, loss), (plain_teleports, _, plain_loss) = (
        read_statistics(folder / f"{name}.stats.xml") for name in ("pedzone", "sumo"))
    both = [name for name in ours if ours[name][0] and plain[name][0]]
    trips, plain_trips = (statistics.mean(run[name][1] for name in both) for run in (ours, plain))
    if teleports > plain_teleports or collisions:
        faults.append(f"{teleports} teleports (plain SUMO {plain_teleports}), {collisions} collisions")
    if loss > plain_loss + MOST_LOSS:
        faults.append(f"cars lose {loss:.1f} s, in plain SUMO {plain_loss:.1f} s")
    if trips > plain_trips:
        faults.append(f"trips take {trips:.1f} s, in plain SUMO {plain_trips:.1f} s")
    print(f"seed {seed}: trips {trips:.1f} s, plain SUMO {plain_trips:.1f} s; cars lose {loss:.1f} s, plain "
          f"SUMO {plain_loss:.1f} s; {len(faults)} faults")
    return faults


def main():
    given = street.options(__doc__, seeds=10)
    faults = []
    for seed in range(1, given.seeds + 1):
        faults += one_seed(given.keep / str(seed), given, seed)
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
