#!/usr/bin/python3
"""What pedzone writes, as checksums: to see that a change of the code changes no result.

    tools/fingerprints.py build/src/app/pedzone --out before.txt     # before the change
    tools/fingerprints.py build/src/app/pedzone --compare before.txt # after it

Runs every scenario, the plaza and the narrow lane with every model, and three standard tests. Of each
run it takes the trajectories, the conflicts and the picture of the paths; of the tests their figures.
Half a minute on two cores. Exit code: 0, 1 something has changed, 2 input at fault.
"""
import argparse
import concurrent.futures
import hashlib
import os
import subprocess
import sys
import tempfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
SCENARIOS = PROJECT / "scenarios"
MODELS = ("heuristic-original", "plain", "orca", "social-force", "gradient-navigation",
          "optimal-steps", "constant-velocity")
OTHER_MODELS_ON = ("plaza-low", "narrow-lane-low")
MODELS_END = "120"  # [s]
VERIFY = ["verify", "--seeds", "1", "--only", "rimea-1", "rimea-6", "moussaid-lanes"]


def zone_files(config):
    """Those that are meant for a scenario: their names begin with its own."""
    return sorted(config.parent.glob(f"{config.stem}*.zone.xml"))


def runs():
    """[(name, arguments of pedzone)]"""
    for config in sorted(SCENARIOS.glob("*/*.sumocfg")):
        for zone in zone_files(config) or [None]:
            name = f"{config.parent.name}/{zone.name if zone else config.name}"
            yield name, ["run", config, *(["--zone", zone] if zone else [])]
        if config.stem in OTHER_MODELS_ON:
            for model in MODELS:
                yield f"{config.stem}/{model}", ["run", config, "--model", model, "--end", MODELS_END]


def checksum(path):
    """Of what a file says, wherever the project lies: pictures name the scenario's file."""
    if not path.exists():
        return "nothing"
    text = path.read_bytes().replace(str(PROJECT).encode(), b"")
    return hashlib.sha256(text).hexdigest()[:16]


def prints_of(pedzone, name, arguments):
    """Lines `NAME FILE CHECKSUM` of one call."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        files = {"--json": "figures.json"} if arguments[0] == "verify" else {
            "--trajectories": "trajectories.csv", "--conflict-csv": "conflicts.csv",
            "--paths-svg": "paths.svg"}
        options = [word for option, file in files.items() for word in (option, out / file)]
        done = subprocess.run([pedzone, *arguments, *options], capture_output=True, text=True)
        if arguments[0] == "run" and done.returncode != 0:
            raise RuntimeError(f"{name}: exit code {done.returncode}\n{done.stderr[-1000:]}")
        return [f"{name} {file} {checksum(out / file)}" for file in files.values()]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone", help="the program")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--out", help="write them")
    what.add_argument("--compare", help="compare with those of another time")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at once")
    options = parser.parse_args()
    pedzone = Path(options.pedzone).resolve()
    if not pedzone.exists() or (options.compare and not Path(options.compare).exists()):
        print(f"Error: there is no {options.compare if pedzone.exists() else pedzone}",
              file=sys.stderr)
        return 2
    calls = [*runs(), ("verify", VERIFY)]
    lines = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done, found in enumerate(pool.map(lambda call: prints_of(pedzone, *call), calls), 1):
            lines += found
            print(f"\r{done} of {len(calls)}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    if options.out:
        Path(options.out).write_text("\n".join(lines) + "\n", encoding="utf-8")
        return 0
    before = Path(options.compare).read_text(encoding="utf-8").splitlines()
    changed = sorted(set(before) ^ set(lines))
    for line in changed:
        print(("- " if line in before else "+ ") + line)
    print(f"{len(lines)} files, " + (f"{len(set(lines) - set(before))} changed" if changed
                                     else "all as before"))
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())
