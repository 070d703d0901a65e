#!/usr/bin/python3
"""People get through footways and past bus stops as they do with SUMO's own striping.

    flow.py PEDZONE                      the sample of the default suite
    flow.py PEDZONE --all --seeds 1-10   every case with ten seeds
    flow.py PEDZONE --case bus-stop --seeds 3 --keep out    cases whose name contains it

Each case is run in plain SUMO and with pedzone, with the same seed, until the same end. At least
99 % as many must arrive as with striping, in at most 1.25 times the mean time of all that arrive
with both; no bodies overlap (tests/check/overlap.py), nobody is lost, outside or thrown about (tests/check).
Past the bus stop all must arrive, and the last no later than 1.2 times striping's last.

Exit code 0: all cases hold; 1: some do not; 2: there is no such case.
"""
import argparse
import concurrent.futures
import functools
import shutil
import sys
import tempfile
from pathlib import Path

import cases
from judge import Verdict, judge
from runs import run_pedzone, run_plain
from table import heading, line


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone", help="the program")
    parser.add_argument("--all", action="store_true", help="every case, not the sample")
    parser.add_argument("--every-combination", action="store_true",
                        help="of shapes, widths, flows, ...: hours")
    parser.add_argument("--case", help="of all cases those with this in their name")
    parser.add_argument("--seeds", default="1", help="one, or a range as 1-10 (not of the sample)")
    parser.add_argument("--model", help="another walking model")
    parser.add_argument("--must-break", action="store_true",
                        help="exit code 0 only if no case holds: the measures tell bad models")
    parser.add_argument("--jobs", type=int, default=1, help="cases at once")
    parser.add_argument("--keep", help="folder for inputs and outputs")
    return parser.parse_args()


def chosen_cases(options):
    """[(case, seed)]"""
    if not (options.all or options.every_combination or options.case):
        return cases.sample()
    chosen = cases.all_footways() if options.every_combination else cases.all_cases()
    chosen = [case for case in chosen if not options.case or options.case in case.name]
    first, _, last = options.seeds.partition("-")
    return [(case, seed) for seed in range(int(first), int(last or first) + 1) for case in chosen]


def run_case(pedzone, model, work, keep, case_and_seed):
    """Makes, runs and judges one case with one seed."""
    case, seed = case_and_seed
    folder = work / f"{case.name}-seed{seed}"
    folder.mkdir(parents=True, exist_ok=True)
    verdict = Verdict(case.name, seed)
    config, zone = case.make(folder, seed), folder / "town.zone.xml"
    plain = run_plain(config, folder / "plain", seed)
    own = run_pedzone(pedzone, config, zone, folder / "run", seed, case.step_length, model)
    verdict.processor = plain.processor, own.processor
    verdict.broken = [ended.failure for ended in (plain, own) if ended.failure]
    if not verdict.broken:
        judge(verdict, case.limits, config, zone, folder / "plain", folder / "run")
    if not keep:
        shutil.rmtree(folder)
    print(line(verdict), flush=True)
    return verdict


def main():
    options = parse_arguments()
    chosen = chosen_cases(options)
    if not chosen:
        print(f"flow: no case has '{options.case}' in its name", file=sys.stderr)
        return 2
    work = Path(options.keep or tempfile.mkdtemp(prefix="pedzone-flow-")).resolve()
    pedzone = str(Path(options.pedzone).resolve())
    print(heading(), flush=True)
    one = functools.partial(run_case, pedzone, options.model, work, bool(options.keep))
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        verdicts = list(pool.map(one, chosen))
    if not options.keep:
        shutil.rmtree(work)
    broken = [verdict for verdict in verdicts if verdict.broken]
    print(f"\n{len(verdicts) - len(broken)} of {len(verdicts)} cases hold")
    for verdict in broken:
        print(f"broken: {verdict.case}, seed {verdict.seed}: {'; '.join(verdict.broken)}")
    if options.must_break:
        return 0 if len(broken) == len(verdicts) else 1
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
