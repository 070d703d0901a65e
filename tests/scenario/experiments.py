#!/usr/bin/python3
"""The paper's experiments over seeds: what must be seen, checked with numbers.

usage: experiments.py PEDZONE [EXPERIMENT ...] [--seeds N] [--jobs N] [--model M ...]
                      [--markdown] [--fails]
       experiments.py --fcd FILE EXPERIMENT

EXPERIMENT: 5.1, 5.2a, 5.2b, 5.3, 5.4; all where none is named. Measures come from SUMO's own
floating-car data (experiment_measures.py). A check holds when the 95 % interval (Student) of the
mean lies where it says, or as many seeds as it says are as it says. With --model another walking
model, and the checks are told but do not count; several models make a table. With --fcd, the
measures of one run that has been made. Exit code: 0 when all checks hold.
"""

import argparse
import concurrent.futures
import os
import statistics
import sys
from dataclasses import dataclass

import experiment_measures as m
from experiment_checks import SEEDS, Around, Figure, Mean, Missed, Share, verdict
from experiment_tracks import (RADIUS, SCENARIOS, STEP, Run, outside, read_fcd, run, run_only,
                               stars, vehicle_sizes)

APART = 5.0     # [m] all so near each other: a group (it waits beyond 4 m along the way)
FARTHER = 0.05  # [m] what counts as farther
OVERLAP = 0.01  # [m] less is rounding


def walkers_and_shuttle(runs):
    """5.1: two persons towards whom a shuttle is steered: not, half, fully."""
    at = stars("5.1")
    lines = {person: at[f"goal.{person}"][1] for person in ("a", "b")}
    row = {"clearance": min(m.clearance(run, "av") for run in runs.values()) - RADIUS,
           "outside": max(outside(run, "street") for run in runs.values())}
    for variant, one in runs.items():
        aside = {p: m.most(one.persons[p].y - line) for p, line in lines.items()}
        row[f"deviation {variant}"] = statistics.fmean(abs(value) for value in aside.values())
        row |= {f"{p} {variant}": abs(value) for p, value in aside.items()}
        if variant != "straight" and "straight" in runs:
            onsets = [m.onset(one, runs["straight"], p, "av") for p in lines]
            row[f"onset {variant}"] = min(gap for gap, _ in onsets)
            row[f"onset time {variant}"] = min(time for _, time in onsets)
        row[f"same side {variant}"] = float(aside["a"] * aside["b"] > 0)
        row[f"alike {variant}"] = m.likeness(one, lines, "av")
        row[f"clearance {variant}"] = m.clearance(one, "av")
        row[f"sharpest {variant}"] = max(m.sharpest(one, p, "av") for p in lines)
    if set(runs) >= {"straight", "half", "full"}:
        for p in lines:
            row[f"{p} half - straight"] = row[f"{p} half"] - row[f"{p} straight"]
            row[f"{p} full - half"] = row[f"{p} full"] - row[f"{p} half"]
    return row


def group(one, edge):
    times = m.common_times(one)
    x, y = m.places(one, times)
    spread = m.spread(one, times)
    foreseen = m.foreseen(one, times)
    came = [gap < m.TOUCH for gap in foreseen]
    return {"foreseen": len(foreseen) / (len(x) * len(times) * STEP / 60.0),
            "came": statistics.fmean(came) if came else None,
            "spread": float(spread.mean()), "most apart": float(spread.max()),
            "waits": m.waits(one, times), "changes": m.changes(x) + m.changes(y),
            "outside": outside(one, edge)}


def free_group(runs):
    """5.2a."""
    return group(runs[""], "square")


OBSTACLE = (36.0, 28.0, 44.0, 46.0)  # [m] x0, y0, x1, y1, as in 5.2b.add.xml
CORNER = (36.0, 46.0)                # the one that the shorter way round it passes


def group_and_obstacle(runs):
    """5.2b."""
    one = runs[""]
    gaps = [m.box_distance(track, OBSTACLE) for track in one.persons.values()]
    off = [m.off_course(track, 9.0, CORNER) for track in one.persons.values()]
    return group(one, "square") | {
        "nearest": min(gaps), "farthest": max(gaps), "mean gap": statistics.fmean(gaps),
        "off course": statistics.fmean(off),
        "round the corner": float(all(max(track.y) > CORNER[1] for track in one.persons.values()))}


def group_and_shuttle(runs):
    """5.3."""
    one = runs[""]
    line = stars("5.3")["goal"][1]
    north, south, gap = m.split(one, "av", line)
    return group(one, "lane") | {
        "north": north, "south": south, "smaller part": min(north, south), "split": gap,
        "clearance": m.clearance(one, "av") - RADIUS,
        "sharpest": statistics.fmean(m.sharpest(one, p, "av") for p in one.persons),
        "rejoin": m.rejoin(one, "av", APART, one.sizes["av"][1])}


def crossing_pairs(runs):
    """5.4."""
    at, row = stars("5.4"), {}
    for pair in ("upper", "lower"):
        both = m.shares(runs[""], {f"{pair}.{way}": at[f"{pair}.east"][1]
                                   for way in ("eastbound", "westbound")})
        east, west = both.values()
        row[f"{pair} share"] = east / (east + west)
        row[f"{pair} larger share"] = max(east, west) / (east + west)
        row[f"{pair} least"], row[f"{pair} most"] = min(east, west), max(east, west)
        row[f"{pair} contact"] = m.nearest(runs[""], *both) - 2 * RADIUS
        row[f"{pair} kept speed"] = m.kept_speed(runs[""], *both)
        if "eastbound" in runs:
            alone = {p: runs[p.split(".")[1]].persons[p] for p in both}
            needed = m.nearest(Run(alone, {}), *both) < 2 * RADIUS
            row[f"{pair} onset"] = m.turns(runs[""], alone, *both) if needed else None
    return row


# Limits that are recorded: scenarios/experiments/README.md has where, experiment_recordings.py how.
NOBODY_TOUCHED = Share("nobody is touched [m]", "clearance", least=-OVERLAP, share=1.0)
INSIDE = Share("nobody leaves the zone [m]", "outside", most=0.0, share=1.0)
TOGETHER = Mean("the group stays together: farthest two, mean over time [m]", "spread", most=APART)
WAITS = Share("somebody waits and walks on", "waits", least=1)
CHANGES = Share("they change places", "changes", least=1)
EARLY = Mean("they turn early: courses on which a contact is 1 to 1.5 s ahead, per person and minute",
             "foreseen", most=3.6)
SPACE = Missed(Mean("... and clear: share of these contacts that come about", "came", most=0.2))


@dataclass
class Experiment:
    measure: object  # runs by variant -> {name: number}
    checks: list
    variants: tuple = ("",)
    alone: tuple = ()  # further runs, each with those persons only whose id ends so


EXPERIMENTS = {
    "5.1": Experiment(walkers_and_shuttle, [
        Share("steered fully, both have stepped aside when it is so far [m]", "onset full",
              least=5.6, most=15.4),
        Share("... and so long before it is nearest [s]", "onset time full", least=1.0),
        Share("... smoothly: the sharpest change of velocity [m/s^2]", "sharpest full", most=1.7),
        Missed(Share("... and keep so far from it: centres [m]", "clearance full", least=0.9)),
        Mean("a goes farther when it is steered half than not [m]", "a half - straight",
             least=FARTHER),
        Mean("b too", "b half - straight", least=FARTHER),
        Mean("a goes farther when it is steered fully than half [m]", "a full - half",
             least=FARTHER),
        Mean("b too", "b full - half", least=FARTHER),
        Share("both to the same side", "same side full", least=1.0),
        Share("in nearly the same pattern: correlation", "alike full", least=0.8),
        NOBODY_TOUCHED, INSIDE], ("straight", "half", "full")),
    "5.2a": Experiment(free_group, [TOGETHER, WAITS, CHANGES, EARLY, SPACE, INSIDE]),
    "5.2b": Experiment(group_and_obstacle, [
        Mean("they head for the corner at once: off that course [deg]", "off course", least=-3.0,
             most=3.0),
        Share("all go round it", "round the corner", least=1.0),
        Mean("close to it: gap of bodies [m]", "mean gap", most=0.5),
        TOGETHER, CHANGES, EARLY, SPACE, INSIDE]),
    "5.3": Experiment(group_and_shuttle, [
        Share("the group splits to both sides: smaller part", "smaller part", least=1),
        Share("early: some are on either side of its way from so far [m]", "split", least=5.6),
        Mean("smoothly: the sharpest change of velocity, mean of the six [m/s^2]", "sharpest",
             most=1.7),
        Share("behind it they join again before they arrive: within 5 m, no wider than it, after "
              "[s]", "rejoin", least=0.0),
        EARLY, SPACE, NOBODY_TOUCHED, INSIDE]),
    # The lower pair walks by ORCA, what the paper calls RVO: it is shown, not judged.
    "5.4": Experiment(crossing_pairs, [
        Share("who would touch turn before they are so near [m]", "upper onset", least=3.7,
              share=0.75),
        Share("both keep their speed: least share of it", "upper kept speed", least=0.86,
              share=0.75),
        Missed(Share("they pass clear of each other: gap of bodies [m]", "upper contact",
                     least=0.1)),
        Around("the eastbound's share of the deviation", "upper share", 0.5),
        Mean("the share of the one that does more", "upper larger share", most=0.75),
        Share("both deviate, the one that does less by [m]", "upper least", least=0.1),
        Share("they do not overlap [m]", "upper contact", least=-OVERLAP, share=1.0),
        Figure("lower pair: the first turns at [m]", "lower onset"),
        Figure("lower pair: least share of their speed", "lower kept speed"),
        Figure("lower pair: the eastbound's share", "lower share"),
        Figure("lower pair: the share of the one that does more", "lower larger share"),
        Figure("lower pair: the one that does less deviates by [m]", "lower least"),
        Figure("lower pair: gap of bodies [m]", "lower contact")],
        alone=("eastbound", "westbound")),
}


def zone_file(name, variant):
    return SCENARIOS / f"{name}{'-' + variant if variant else ''}.zone.xml"


def measure(pedzone, name, seed, words):
    experiment = EXPERIMENTS[name]
    runs = {variant: run(pedzone, name, zone_file(name, variant), seed, words)
            for variant in experiment.variants}
    runs |= {ending: run_only(pedzone, name, zone_file(name, ""), seed, words, ending)
             for ending in experiment.alone}
    return experiment.measure(runs)


def measure_all(options, name, words=()):
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        return list(pool.map(lambda seed: measure(options.pedzone, name, seed, words),
                             range(1, options.seeds + 1)))


def print_checks(name, rows):
    """Whether all hold."""
    good = True
    print(f"{name}, {len(rows)} seeds")
    for check in EXPERIMENTS[name].checks:
        holds, text, more = check.result(rows)
        good = good and (holds or isinstance(check, Missed))
        print(f"  {check.text}: {text}{more}; {check.limits()}{verdict(check, holds)}", flush=True)
    return good


def fails(name, rows):
    """Whether a check that counts is failed beyond doubt; prints those."""
    failed = [check.text for check in EXPERIMENTS[name].checks
              if isinstance(check, (Mean, Share)) and check.failed(rows)]
    print(f"{name}: " + ("; ".join(failed) if failed else "NO check tells it apart"), flush=True)
    return bool(failed)


def print_table(options, names):
    """A row for each check, a column for each model."""
    print("| experiment | what must be seen | " + " | ".join(options.model) + " |")
    print("| --- | --- |" + " --- |" * len(options.model))
    for name in names:
        columns = []
        for model in options.model:
            rows = measure_all(options, name, ("--model", model))
            columns.append([check.result(rows) for check in EXPERIMENTS[name].checks])
        for check, *results in zip(EXPERIMENTS[name].checks, *columns):
            cells = (f"{'' if holds else '**no** '}{text}" for holds, text, _ in results)
            print(f"| {name} | {check.text} | " + " | ".join(cells) + " |", flush=True)


def print_run(fcd, name, variant):
    persons, vehicles = read_fcd(fcd)
    one = Run(persons, vehicles, vehicle_sizes(SCENARIOS / f"{name}.rou.xml"))
    for key, value in EXPERIMENTS[name].measure({variant: one}).items():
        print(f"  {key:24} {value:8.2f}" if value is not None else f"  {key:24}        -")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("words", nargs="*", metavar="PEDZONE EXPERIMENT")
    parser.add_argument("--seeds", type=int, default=20, choices=SEEDS)
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1))
    parser.add_argument("--model", nargs="+", default=[])
    parser.add_argument("--fails", action="store_true",
                        help="exit 0 when the models fail each experiment")
    parser.add_argument("--markdown", action="store_true", help="print a table of the models")
    parser.add_argument("--fcd")
    parser.add_argument("--variant", default="")
    options = parser.parse_args()
    if options.fcd:
        print_run(options.fcd, options.words[0], options.variant)
        return 0
    options.pedzone, *names = options.words
    names = names or list(EXPERIMENTS)
    if options.markdown:
        print_table(options, names)
        return 0
    good = True
    for model in options.model or [None]:
        for name in names:
            rows = measure_all(options, name, ("--model", model) if model else ())
            good = (fails if options.fails else print_checks)(name, rows) and good
    return 0 if good or (options.model and not options.fails) else 1


if __name__ == "__main__":
    sys.exit(main())
