#!/usr/bin/python3
"""SUMO, pedzone and the shuttle's controller in one command; tells how the encounters went.

usage: run.py [--pedzone build/src/app/pedzone] [--sensor-range 20] [--seed 1] [--gui] [--out FOLDER]
"""

import argparse
import csv
import json
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = HERE.parents[1] / "build/src/app/pedzone"


def run(pedzone, out, seed, sensor_range, gui=False):
    """One run; its files are in the folder `out`. pedzone starts SUMO and the controller."""
    controller = [sys.executable, HERE / "shuttle.py", "--sensor-range", sensor_range,
                  "--log", out / "shuttle.csv"]
    words = ["--gui"] if gui else []
    view = ["--gui-settings-file", HERE / "view.xml"] if gui else []
    done = subprocess.run(
        [str(word) for word in (
            pedzone, "run", HERE / "plaza.sumocfg", "--client",
            shlex.join(map(str, controller)) + " --port {port}",
            "--seed", seed, "--summary", out / "summary.json",
            "--trajectories", out / "people.csv", "--conflict-csv", out / "conflicts.csv",
            "--quiet", *words, "--", "--fcd-output", out / "fcd.xml", "--no-warnings", *view)],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)


def measures(out):
    """Figures of a run."""
    with open(out / "conflicts.csv", newline="") as file:
        met = [row for row in csv.DictReader(file) if row["vehicle"].startswith("shuttle")]
    with open(out / "shuttle.csv", newline="") as file:
        drive = list(csv.DictReader(file))
    trips = {}
    for row in drive:
        trips.setdefault(row["vehicle"], []).append(row)
    ended = [rows for rows in trips.values() if float(rows[-1]["travelled"]) > 270.0]
    least = lambda column: min((float(row[column]) for row in met if row[column]), default=None)
    summary = json.loads((out / "summary.json").read_text())
    return {
        "trips": len(ended),
        "conflicts": len(met),
        "least clearance [m]": least("minClearance"),
        "least TTC [s]": least("minTTC"),
        "PCT [s], least": least("PCT"),
        "TBT [s], least": least("TBT"),
        "TMT [s], least": least("TMT"),
        "hardest braking [m/s2]": max(-float(row["acceleration"]) for row in drive),
        "trip [s], mean": sum(0.1 * len(rows) for rows in ended) / len(ended) if ended else None,
        "people run into": len([one for one in summary["run_into"]
                                if one["vehicle"].startswith("shuttle")]),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pedzone", default=PROGRAM, help="the program")
    parser.add_argument("--sensor-range", type=float, default=20.0, help="m")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--gui", action="store_true", help="show it in sumo-gui")
    parser.add_argument("--out", help="keep the run's files in this folder")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        out = Path(options.out or folder)
        out.mkdir(parents=True, exist_ok=True)
        run(options.pedzone, out, options.seed, options.sensor_range, options.gui)
        for name, value in measures(out).items():
            print(f"{name:24}", "-" if value is None else f"{value:.2f}".rstrip("0").rstrip("."))


if __name__ == "__main__":
    main()
