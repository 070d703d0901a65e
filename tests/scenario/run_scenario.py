#!/usr/bin/python3
"""Runs a scenario with pedzone, in plain SUMO, and without persons, and checks the run with the
independent check.

usage: run_scenario.py PEDZONE SCENARIO.sumocfg [--seed N] [--zone FILE] [--model M]
                       [--keep FOLDER] --
           LIMITS OF check_run.py

Plain SUMO is run when a limit compares with it, the run without persons when a limit compares with
free vehicles.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

CHECK = Path(__file__).resolve().parent.parent / "check" / "check_run.py"
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
COMPARES = {"--plain": ("--duration-ratio", "--max-missing", "--max-stages-differ", "--max-jumps",
                        "--max-edges-differ", "--max-route-length-differs", "--strict"),
            "--free": ("--max-vehicle-ratio",)}


def outputs(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return ["--fcd-output", str(folder / "fcd.xml"),
            "--tripinfo-output", str(folder / "tripinfo.xml"),
            "--tripinfo-output.write-unfinished", "true",
            "--vehroute-output", str(folder / "vehroute.xml"),
            "--statistic-output", str(folder / "statistics.xml"), "--no-warnings", "true"]


def without_persons(scenario, folder):
    """The scenario's route files with every person taken out, as a value for --route-files."""
    text = Path(scenario).read_text(encoding="utf-8")
    names = re.search(r'<route-files value="([^"]*)"', text).group(1).split(",")
    files = []
    for name in names:
        source = (Path(scenario).parent / name.strip()).resolve()
        routes = source.read_text(encoding="utf-8")
        routes = re.sub(r"<person(Flow)?\b.*?</person(Flow)?>", "", routes, flags=re.DOTALL)
        files.append(folder / source.name)
        files[-1].write_text(routes, encoding="utf-8")
    return ",".join(map(str, files))


def main():
    own = sys.argv[1:]
    limits = own[own.index("--") + 1:] if "--" in own else []
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("scenario")
    parser.add_argument("--seed", help="SUMO's own where none is given, as in a user's run")
    parser.add_argument("--zone", help="zone file")
    parser.add_argument("--model", help="walking model")
    parser.add_argument("--keep")
    arguments = parser.parse_args(own[:own.index("--")] if "--" in own else own)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.keep or temporary)
        run = folder / "run"
        seed = ["--seed", arguments.seed] if arguments.seed else []
        zone = ["--zone", arguments.zone] if arguments.zone else []
        model = ["--model", arguments.model] if arguments.model else []
        words = [arguments.pedzone, "run", arguments.scenario, *seed, *zone, *model,
                 "--trajectories", str(run / "trajectories.csv"), "--", *outputs(run)]
        if subprocess.run(words, env=ENV).returncode != 0:
            return 1
        against = []
        for option, users in COMPARES.items():
            if not set(users) & set(limits):
                continue
            other = folder / option.strip("-")
            plain = ["sumo", "-c", arguments.scenario, *seed, "--no-step-log", *outputs(other)]
            if option == "--free":
                plain += ["--route-files", without_persons(arguments.scenario, other)]
            subprocess.run(plain, check=True, env=ENV, stdout=subprocess.DEVNULL)
            against += [option, str(other)]
        return subprocess.run([sys.executable, str(CHECK), arguments.scenario, str(run), *against,
                               *limits]).returncode


if __name__ == "__main__":
    sys.exit(main())
