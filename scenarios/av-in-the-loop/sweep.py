#!/usr/bin/python3
"""The example for several sensor ranges and seeds: how clearance and braking depend on the range.

usage: sweep.py OUT [--pedzone build/src/app/pedzone] [--ranges 5 10 20 30] [--seeds 5] [--jobs 2]

Writes OUT/sweep.csv (a line a run) and OUT/sweep.png (means with 95 % confidence intervals).
"""

import argparse
import csv
import math
import statistics
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import run as example

SHOWN = ("least clearance [m]", "hardest braking [m/s2]", "trip [s], mean")
# Student's t, two-sided 95 %, for 1, 2, ... degrees of freedom.
STUDENT = (12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14,
           2.13, 2.12, 2.11, 2.10, 2.09)


def one(pedzone, sensor_range, seed):
    with tempfile.TemporaryDirectory() as folder:
        example.run(pedzone, Path(folder), seed, sensor_range)
        found = {"range [m]": sensor_range, "seed": seed, **example.measures(Path(folder))}
    print(f"range {sensor_range:g} m, seed {seed}: clearance {found[SHOWN[0]]:.2f} m", flush=True)
    return found


def interval(values):
    """Mean, and half of its 95 % confidence interval."""
    values = [value for value in values if value is not None]
    degrees = min(len(values) - 1, len(STUDENT))
    half = STUDENT[degrees - 1] * statistics.stdev(values) / math.sqrt(len(values))
    return statistics.mean(values), half


def draw(results, ranges, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plot
    figure, charts = plot.subplots(1, len(SHOWN), figsize=(11, 3.4), layout="constrained")
    for chart, name in zip(charts, SHOWN):
        points = [interval([found[name] for found in results if found["range [m]"] == reach])
                  for reach in ranges]
        chart.errorbar(ranges, [mean for mean, _ in points], [half for _, half in points],
                       marker="o", capsize=4, color="#1f6fb4")
        chart.set(xlabel="sensor range [m]", title=name, ylim=(0, None))
        for side in ("top", "right"):
            chart.spines[side].set_visible(False)
    figure.savefig(file, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=Path)
    parser.add_argument("--pedzone", default=example.PROGRAM)
    parser.add_argument("--ranges", type=float, nargs="+", default=[5, 10, 20, 30], help="m")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--jobs", type=int, default=2, help="runs at a time")
    options = parser.parse_args()
    if options.seeds < 2:
        parser.error("--seeds: 2 at least, for an interval")
    options.out.mkdir(parents=True, exist_ok=True)
    plan = [(reach, seed + 1) for seed in range(options.seeds) for reach in options.ranges]
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda case: one(options.pedzone, *case), plan))
    with open(options.out / "sweep.csv", "w", newline="") as file:
        table = csv.DictWriter(file, fieldnames=list(results[0]))
        table.writeheader()
        table.writerows(results)
    draw(results, options.ranges, options.out / "sweep.png")


if __name__ == "__main__":
    main()
