#!/usr/bin/python3
"""Friedloser Straße in Bad Hersfeld (scenarios/cross-anywhere): who lives opposite crosses there, also near
the end of the street at the network's border, across which SUMO walks people.

usage: real_street.py PEDZONE [--seeds N] [--model M] [--keep FOLDER]

From SUMO's own outputs of each seed, beside plain SUMO: all arrive who do there, and whoever crosses
(across_*) needs on average at most half as long.
"""
import statistics
import sys
from pathlib import Path

import street

FOLDER = Path(__file__).resolve().parents[3] / "scenarios/cross-anywhere"
SCENARIO, ZONE = FOLDER / "bad-hersfeld.sumocfg", FOLDER / "bad-hersfeld.zone.xml"
SHARE = 0.5


def main():
    given = street.options(__doc__, seeds=2)
    faults = 0
    for seed in range(1, given.seeds + 1):
        folder = given.keep / str(seed)
        folder.mkdir(parents=True, exist_ok=True)
        street.run(folder, "pedzone", given.program, "run", SCENARIO, "--zone", ZONE, "--quiet",
                   "--seed", seed, *given.model)
        street.run(folder, "sumo", "sumo", "-c", SCENARIO, "--seed", seed)
        ours, plain = (street.read_trips(folder / f"{name}.trips.xml") for name in ("pedzone", "sumo"))
        who = [name for name in plain if name.startswith("across") and plain[name][0]]
        missing = [name for name in who if not ours[name][0]]
        trips, plain_trips = (statistics.mean(run[name][1] for name in who) for run in (ours, plain))
        print(f"seed {seed}: {len(who)} people cross, {len(missing)} do not arrive; trips {trips:.1f} s,"
              f" plain SUMO {plain_trips:.1f} s")
        faults += bool(missing) or trips > SHARE * plain_trips
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
