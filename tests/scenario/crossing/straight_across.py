#!/usr/bin/python3
"""People whose doors are opposite each other, on a street of 7 m with 600 cars an hour: with
crossing="anywhere" and in plain SUMO.

usage: straight_across.py PEDZONE [--seeds N] [--model M] [--keep FOLDER]

From SUMO's own outputs of each seed:
- the same people arrive with the same stages as in plain SUMO, nobody stands over 300 s
- nobody is touched at more than 0.5 m/s, no car brakes harder than its decel, none collides
- people's mean way is at most 1.1 of the straight one (plain SUMO: at least 2)
`--model constant-velocity` must fail: it does not look.
"""
import statistics
import sys

import street

CARS, PEOPLE = 600, 200  # an hour
BEGIN, END = 900, 1400  # [s] until when they depart, and are watched
LONGEST_STAND = 300.0  # [s]
MOVING = 0.5  # [m/s]


def one_seed(folder, program, seed, options):
    street.write_scenario(folder, street.demand(seed, CARS, PEOPLE, BEGIN), END)
    street.run_pedzone(folder, program, seed, *options)
    street.run_sumo(folder, seed)
    faults = []
    ours, plain = (street.read_trips(folder / f"{name}.trips.xml") for name in ("pedzone", "sumo"))
    if {k: trip[::2] for k, trip in ours.items()} != {k: trip[::2] for k, trip in plain.items()}:
        faults.append("other people arrive, or by other stages, than in plain SUMO")
    seen, seen_plain = (street.read_fcd(folder / f"{name}.fcd.xml") for name in ("pedzone", "sumo"))
    for walk_id, walk in seen.walks.items():
        if walk.longest_stand() > LONGEST_STAND:
            faults.append(f"{walk_id} stands for {walk.longest_stand():.0f} s")
    faults += [f"{person} is touched by {car} at {time:.1f} s, {speed:.1f} m/s"
               for time, person, car, speed in seen.contacts if speed > MOVING]
    faults += [f"{car} brakes by {slowed:.1f} m/s² at {time:.1f} s"
               for time, car, slowed in seen.brakings]
    collisions = street.read_collisions(folder / "pedzone.stats.xml")
    if collisions:
        faults.append(f"{collisions} collisions of cars")
    return faults, seen, seen_plain, ours, plain


def share(walks):
    """Mean way over mean straight way."""
    return statistics.mean(w.way for w in walks) / statistics.mean(w.straight for w in walks)


def main():
    given = street.options(__doc__, seeds=20)
    walks, plain_walks, all_faults, times = [], [], 0, []
    for seed in range(1, given.seeds + 1):
        faults, seen, seen_plain, ours, plain = one_seed(given.keep / str(seed), given.program,
                                                         seed, given.model)
        walks += seen.walks.values()
        plain_walks += seen_plain.walks.values()
        times += [(plain[k][1], ours[k][1]) for k in ours if ours[k][0] and plain[k][0]]
        all_faults += len(faults)
        for fault in faults[:5]:
            print(f"seed {seed}: {fault}")
    ours, theirs = share(walks), share(plain_walks)
    before, after = (statistics.mean(column) for column in zip(*times))
    print(f"{len(walks)} people, {given.seeds} seeds: ways {ours:.2f} of the straight ones, plain "
          f"SUMO {theirs:.2f}; trips {after:.1f} s, plain SUMO {before:.1f} s; "
          f"{all_faults} faults")
    if ours > 1.1 or theirs < 2.0 or all_faults:
        sys.exit(1)


if __name__ == "__main__":
    main()
