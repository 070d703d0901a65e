#!/usr/bin/python3
"""Persons on random networks: nobody is lost, jumps, leaves the walkable area or ends the program.

    random_networks.py --pedzone build/src/app/pedzone [--steps 100000] [--networks 24]
    random_networks.py --pedzone build/src/app/pedzone --seed 17 --networks 1 --steps 0 --keep out

Each seed makes a network (grid, spider's web or random; with or without sidewalks, crossings,
traffic lights; random streets of it shared space; buildings, some of them dirty), persons (walks,
stops, rides in cars and buses, routes over an edge twice, groups that depart on one point), vehicles
and bicycles, and a step length. pedzone runs it in a process of its own; tests/check looks at what
SUMO wrote. Inputs on which plain SUMO itself aborts are skipped and counted.

With --meddler, a program that embeds pedzone also removes, reroutes and adds persons between steps.

Exit code 0: enough person-steps, and no failure.
"""

import argparse
import concurrent.futures
import functools
import shutil
import sys
import tempfile
from pathlib import Path

from random_case import Case

BATCH = 12  # seeds that are run to the end before it is asked whether there have been enough
SKIPPED_SHARE = 0.25  # of the inputs at most may be unfair, else the test tests too little


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pedzone", required=True, help="the command")
    parser.add_argument("--meddler", help="the program that embeds pedzone; used instead")
    parser.add_argument("--people", action="store_true", help="with profiles, activities, groups, "
                        "families and weather")
    parser.add_argument("--steps", type=int, default=100_000, help="controlled person-steps wanted")
    parser.add_argument("--networks", type=int, default=24, help="networks wanted")
    parser.add_argument("--seed", type=int, default=1, help="the first seed")
    parser.add_argument("--max-stuck", type=int, default=0, help="networks at most in which people "
                        "who arrive in plain SUMO never do: jams in very narrow places")
    parser.add_argument("--jobs", type=int, default=1, help="networks at once")
    parser.add_argument("--keep", help="folder for inputs and outputs; default: only those of "
                        "failures are kept, in a temporary one")
    return parser.parse_args()


def run_seed(work: Path, pedzone: str, meddler: str, people: bool, keep: bool, seed: int):
    folder = work / f"seed{seed}"
    outcome = Case(seed, folder, pedzone, meddler, people).run()
    print(outcome.line(), flush=True)
    if not outcome.failures and not outcome.stuck and not keep:
        shutil.rmtree(folder)
    return outcome


def main() -> int:
    options = parse_arguments()
    work = Path(options.keep or tempfile.mkdtemp(prefix="pedzone-property-")).resolve()
    pedzone = str(Path(options.pedzone).resolve())
    meddler = str(Path(options.meddler).resolve()) if options.meddler else ""

    one = functools.partial(run_seed, work, pedzone, meddler, options.people, bool(options.keep))
    outcomes, seed = [], options.seed
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        while (len(outcomes) < options.networks
               or sum(outcome.person_steps for outcome in outcomes) < options.steps):
            size = min(BATCH, options.networks) if options.steps == 0 else BATCH
            outcomes += pool.map(one, range(seed, seed + size))
            seed += size
            if not any(outcome.person_steps for outcome in outcomes) and len(outcomes) > 4 * BATCH:
                break
    return report(options, outcomes, work)


def report(options: argparse.Namespace, outcomes: list, work: Path) -> int:
    failed = [outcome for outcome in outcomes if outcome.failures]
    skipped = [outcome for outcome in outcomes if outcome.skipped]
    stuck = [outcome for outcome in outcomes if outcome.stuck]
    print(f"\n{len(outcomes)} networks: {sum(o.person_steps for o in outcomes)} controlled "
          f"person-steps of {sum(o.controlled for o in outcomes)} persons, "
          f"{sum(o.events for o in outcomes)} events; {len(failed)} failed, {len(stuck)} with "
          f"people stuck for ever, {len(skipped)} skipped since plain SUMO fails; {sum(o.contacts for o in outcomes)} pairs in contact")
    for outcome in failed + [one for one in stuck if not one.failures]:
        meddler = f" --meddler {options.meddler}" if options.meddler else ""
        verdict = "failed" if outcome.failures else "stuck"
        print(f"{verdict}: {outcome.line()}\n  kept in {work}/seed{outcome.seed}; again: {sys.argv[0]} "
              f"--pedzone {options.pedzone}{meddler} --seed {outcome.seed} --networks 1 --steps 0 "
              f"--keep {work}")
    if not failed and not stuck and not options.keep:
        shutil.rmtree(work)
    if len(skipped) > max(1, SKIPPED_SHARE * len(outcomes)):
        print("failed: too many inputs were skipped")
        return 1
    if len(stuck) > options.max_stuck:
        print(f"failed: people are stuck in {len(stuck)} networks, allowed {options.max_stuck}")
        return 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
