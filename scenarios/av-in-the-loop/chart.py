#!/usr/bin/python3
"""What a study over sensor ranges found: means with their 95 % confidence intervals (Student).

usage: chart.py RESULTS PICTURE.png     RESULTS: of `pedzone study run sweep.study.xml --out RESULTS`
"""

import csv
import math
import statistics
import sys

SHOWN = {"conflict.clearance": "least clearance of a run [m]",
         "conflict.serious": "serious conflicts of a run",
         "conflict.ttc": "median time to contact [s]"}
# Student's t, two-sided 95 %, for 1, 2, ... degrees of freedom.
STUDENT = (12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14,
           2.13, 2.12, 2.11, 2.10, 2.09)


def interval(values):
    """Mean, and half of its 95 % confidence interval; of one value there is none."""
    if len(values) == 1:
        return values[0], 0.0
    half = STUDENT[min(len(values) - 1, len(STUDENT)) - 1] * statistics.stdev(values) / math.sqrt(len(values))
    return statistics.mean(values), half


def read(results):
    """By measure and sensor range: one value a run."""
    found = {measure: {} for measure in SHOWN}
    with open(f"{results}/runs.csv", newline="") as file:
        for run in csv.DictReader(file):
            for measure in SHOWN:
                if run.get(measure):
                    values = found[measure].setdefault(float(run["factor.range"]), [])
                    values.append(float(run[measure]))
    return found


def draw(found, picture):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plot
    figure, charts = plot.subplots(1, len(SHOWN), figsize=(11, 3.4), layout="constrained")
    for chart, (measure, title) in zip(charts, SHOWN.items()):
        ranges = sorted(found[measure])
        points = [interval(found[measure][reach]) for reach in ranges]
        for reach in ranges:
            values = found[measure][reach]
            chart.plot([reach] * len(values), values, ".", color="#b8cfe2", zorder=1)
        chart.errorbar(ranges, [mean for mean, _ in points], [half for _, half in points],
                       marker="o", capsize=4, color="#1f6fb4", zorder=2)
        chart.set(xlabel="sensor range [m]", title=title, ylim=(0, None), xticks=ranges)
        chart.title.set_fontsize(10)
        for side in ("top", "right"):
            chart.spines[side].set_visible(False)
        print(measure, *(f"{reach:g} m: {mean:.2f} ± {half:.2f}"
                         for reach, (mean, half) in zip(ranges, points)), sep="  ")
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    draw(read(sys.argv[1]), sys.argv[2])
