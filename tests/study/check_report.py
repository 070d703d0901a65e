#!/usr/bin/python3
"""Every number in the sentences of a study's report, recomputed from its runs' raw outputs.

Trips, ways, speeds, density and stops come from SUMO's floating-car data and tripinfo; conflicts are
the rows of the runs' conflicts.csv, sorted by zone and vehicle's speed here. Shares nothing with src/.
Sentences that it does not know are an error.

usage: check_report.py RESULTS    (a folder that `pedzone study run` made; the default zones)
"""
import html
import itertools
import json
import math
import multiprocessing
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections import defaultdict
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "check"))
sys.path.insert(0, str(Path(__file__).resolve().parent))
from check_measures import (FREE_SHARE, parted, space_measures, stops,  # noqa: E402
                            walking_rows)
from fcd import read_fcd  # noqa: E402
from scenario import read_scenario  # noqa: E402
from trips import read_trips, trip_measures  # noqa: E402
from visits import Ways, walk_measures  # noqa: E402
from zone_area import TOLERANCE, ZoneArea, ZoneRule, read_network  # noqa: E402
from zone_people import of_the_zone, read_table, rows_in_zone  # noqa: E402

# What a sentence is about, the words that say "less" in it, and what its amount is over the measure.
PHRASES = [("People's trips", "person.travelTime", 1), ("People's delay", "person.delay", 1),
           ("People wait", "person.waiting", 1), ("People walk", "person.speed", 1),
           ("People's ways", "person.detour", None), ("The density", "space.density", 1),
           ("The share of people who arrive", "person.arrived", 100),
           ("Vehicles' trips", "vehicle.travelTime", 1), ("Vehicles' delay", "vehicle.delay", 1),
           ("Vehicles stop", "vehicle.stops", 1), ("serious conflicts a run", "conflict.serious", 1),
           ("conflicts a run", "conflict.count", 1), ("contacts a run", "conflict.contacts", 1)]
LESS = ("shorter", "less", "slower", "lower", "fewer")
NUMBER = "[−+]?[0-9.]+"
# The area recomputed differs at its borders (check_measures.py), so do shortest ways in it: a share
# of the value. Of conflicts, whose values are rounded in the table, one or two a run may lie on
# either side of a limit.
SHARE = {"person.delay": 0.01}
LOOSE = {"person.delay": 0.1, "person.detour": 0.002, "conflict.count": 1.0,
         "conflict.serious": 1.5, "conflict.contacts": 1.0}


def number(text):
    return float(text.replace("−", "-"))


def student(freedom):
    """The 97.5 % quantile of Student's t, by integration of its density."""
    grid = numpy.linspace(0.0, 200.0, 2_000_001)
    density = (1 + grid ** 2 / freedom) ** (-(freedom + 1) / 2)
    density *= math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2))
    density /= math.sqrt(freedom * math.pi)
    area = numpy.concatenate(([0.0], numpy.cumsum((density[1:] + density[:-1]) / 2))) * 1e-4
    return float(grid[numpy.searchsorted(area, 0.475)])


class Places:
    """The zones of scenarios and the ways in them, each made once."""

    def __init__(self):
        self._known = {}

    def of(self, scenario):
        key = (scenario.net_file, tuple(scenario.additional_files))
        if key not in self._known:
            parts = ZoneArea(read_network(scenario.net_file), scenario.polygons, ZoneRule())
            area = parts.reach.area.difference(parts.buildings.area).difference(parts.roads.area)
            self._known[key] = parts.edges, Ways(area.buffer(-TOLERANCE))
        return self._known[key]


PLACES = Places()  # filled before the processes that use it are forked


def run_measures(folder, config):
    print(f"  {folder.name}", flush=True)
    fcd = read_fcd(str(folder / "fcd.xml.gz"))
    end = fcd.times[-1] + numpy.diff(fcd.times)[-1]
    persons, vehicles = read_trips(folder / "tripinfo.xml", end)
    edges, ways = PLACES.of(read_scenario(config))
    values = trip_measures(persons, vehicles, end)
    values["vehicle.stops"] = stops(folder / "fcd.xml.gz") / len(vehicles)
    inside = rows_in_zone(fcd, edges)
    values.update(walk_measures(fcd, persons, inside, ways, FREE_SHARE))
    values.update(space_measures(fcd, walking_rows(fcd, persons), inside))
    rows, _ = of_the_zone(fcd, read_table(folder / "conflicts.csv"), inside)
    moving = parted(rows)[1]
    values["conflict.count"] = len(moving)
    values["conflict.contacts"] = sum(bool(row["contact"]) for row in moving)
    values["conflict.serious"] = sum(bool(row["contact"]) or float(row["minTTC"] or 9) < 1.5
                                     or float(row["PET"] or 9) < 1.0 for row in moving)
    return values


def free_walks(folder):
    """{person: (way, time)} of those who are gone before the end."""
    fcd = read_fcd(str(folder / "fcd.xml.gz"))
    rows, walks = fcd.persons, {}
    for who, name in enumerate(rows.names):
        own = numpy.flatnonzero(rows.who == who)
        if len(own) and rows.step[own[-1]] < len(fcd.times) - 1:
            way = numpy.hypot(numpy.diff(rows.x[own]), numpy.diff(rows.y[own])).sum()
            walks[name] = way, fcd.times[rows.step[own[-1]]] - fcd.times[rows.step[own[0]]]
    return walks


def read_conditions(results):
    """[(name, scenario's file, SUMO's options, the panel's)] of the study file."""
    study = ElementTree.parse(results / "study.xml").getroot()
    factors = [[(factor.get("id"), level) for level in factor] for factor in study.iter("factor")]
    found = []
    for scenario in study.iter("scenario"):
        for levels in itertools.product(*factors):
            options = {"sumo": {}, "panel": {}}
            for one in (one for _, level in levels for one in level.iter("set")):
                kind = next((kind for kind in options if one.get(kind)), None)
                if kind and one.get("scenario") in (None, scenario.get("id")):
                    options[kind][one.get(kind)] = one.get("value")
            name = ", ".join([scenario.get("id") or Path(scenario.get("file")).stem,
                              *(f"{key}={level.get('name')}" for key, level in levels)])
            found.append((name, scenario.get("file"), options["sumo"], options["panel"]))
    return found


def read_runs(results):
    """({condition: {model: {seed: measures}}}, {condition: {model: free walks}})"""
    study, free, runs = defaultdict(lambda: defaultdict(dict)), defaultdict(dict), {}
    conditions = read_conditions(results)
    for file in sorted(results.glob("runs/*/record.json")):
        record = json.loads(file.read_text(encoding="utf-8"))
        if record["status"] != "done":
            continue
        folder, definition = file.parent, record["definition"]
        name = next(name for name, *what in conditions if what == [
            definition["scenario"], definition["sumo"], definition.get("panel", {})])
        if definition["kind"] != "study":
            free[name][definition["model"]] = free_walks(folder)
            continue
        config = next(word for command in record["commands"] for word in command
                      if word.endswith(".sumocfg"))
        PLACES.of(read_scenario(config))
        runs[name, definition["model"], definition["seed"]] = folder, config
    with multiprocessing.get_context("fork").Pool() as pool:
        found = pool.starmap(run_measures, runs.values(), chunksize=1)
    for (name, model, seed), measures in zip(runs, found):
        study[name][model][seed] = measures
    return study, free


class Check:
    def __init__(self):
        self.checked, self.failed = 0, 0

    def near(self, what, said, found, loose=0.0):
        """A number as it is written against one with all its digits."""
        decimals = len(said.partition(".")[2])
        good = abs(number(said) - found) <= 0.51 * 10 ** -decimals + loose
        self.checked += 1
        self.failed += not good
        if not good:
            print(f"  FAILED {what}: says {said}, found {found:.6g}")

    def require(self, what, good):
        self.checked += 1
        self.failed += not good
        if not good:
            print(f"  FAILED {what}")


def paired(reference, model, key):
    seeds = sorted(set(reference) & set(model))
    a = numpy.array([reference[seed][key] for seed in seeds])
    b = numpy.array([model[seed][key] for seed in seeds])
    return a, b


def check_difference(check, sentence, reference, model):
    phrase = next((one for one in PHRASES if one[0] in sentence), None)
    if phrase is None:
        check.require(f"a sentence that is known: {sentence}", False)
        return
    _, key, scale = phrase
    a, b = paired(reference, model, key)
    scale = scale or 100.0 / a.mean()
    loose = LOOSE.get(key, 0.0) + SHARE.get(key, 0.0) * max(abs(a.mean()), abs(b.mean()))
    differences = b - a
    down = any(word in sentence.split("(")[0] for word in LESS)
    sign = -scale if down else scale
    said = re.search(rf"({NUMBER}) ?(?:%|s|m/s|times|percentage points|persons/m²)? ?"
                     rf"\[({NUMBER}), ({NUMBER})\]", sentence)
    half = student(len(a) - 1) * differences.std(ddof=1) / math.sqrt(len(a))
    ends = sorted((sign * (differences.mean() - half), sign * (differences.mean() + half)))
    for what, text, found in (("mean", said[1], sign * differences.mean()), ("low", said[2], ends[0]),
                              ("high", said[3], ends[1])):
        check.near(f"{key} {what}", text, found, loose * scale * (1 if what == "mean" else 2))
    levels = re.search(rf"from ({NUMBER}) to ({NUMBER})", sentence)
    check.near(f"{key} reference", levels[1], a.mean(), loose)
    check.near(f"{key} model", levels[2], b.mean(), loose)
    if percent := re.search(rf": ({NUMBER}) %;", sentence):
        change = 100.0 * differences.mean() / a.mean()
        check.near(f"{key} percent", percent[1], change, 200.0 * loose / abs(a.mean()))
    check.require(f"{key} pairs", f"{len(a)} pairs of runs" in sentence)
    shares = paired(reference, model, key.split(".")[0] + ".arrived") \
        if key.split(".")[0] in ("person", "vehicle") else (a, a)
    cut = abs(shares[1].mean() - shares[0].mean()) > 0.05 and key.split(".")[1] in (
        "travelTime", "delay", "waiting")
    check.require(f"{key} is told as at least where runs are cut off", cut == ("at least" in sentence))


def check_geometry(check, sentence, reference, model, alone):
    common = sorted(set(alone[0]) & set(alone[1]))
    for part in re.finditer(rf"Of the ({NUMBER}) % by which people's trips are (\w+), "
                            rf"({NUMBER}) percentage points are there without others, too; "
                            rf"interaction makes ({NUMBER}) \[({NUMBER}), ({NUMBER})\]", sentence):
        key = "person.travelTime"
        theirs, own = (numpy.array([alone[k][name][1] for name in common]) for k in (0, 1))
        share_alone = own.sum() / theirs.sum() - 1
        ratio = (own - (1 + share_alone) * theirs) / theirs.mean()
        a, b = paired(reference, model, key)
        sign = -100.0 if part[2] == "shorter" else 100.0
        share, spread = (b - a).mean() / a.mean(), (b - a).std(ddof=1) / a.mean()
        u, v = spread ** 2 / len(a), ratio.var(ddof=1) / len(common)
        freedom = (u + v) ** 2 / (u ** 2 / (len(a) - 1) + v ** 2 / (len(common) - 1))
        half = student(freedom) * math.sqrt(u + v)
        left = share - share_alone
        ends = sorted((sign * (left - half), sign * (left + half)))
        loose = 100.0 * LOOSE.get(key, 0.0)
        for said, found in zip((part[1], part[3], part[4], part[5], part[6]),
                               (sign * share, sign * share_alone, sign * left, *ends)):
            check.near(f"geometry of {key}", said, found, loose)


def texts(page, pattern):
    """Plain text of what a pattern finds."""
    return [html.unescape(re.sub(r"<[^>]+>", "", found)).strip()
            for found in re.findall(pattern, page, flags=re.DOTALL)]


def sections(page):
    """[(condition, sentences of differences, others)]; no condition where the study has but one."""
    parts = re.findall(r'<article class="difference">(.*?)</article>', page, flags=re.DOTALL)
    found = []
    for part in parts:
        name = texts(part, r"<h3>(.*?)</h3>")[0].rpartition(":")[0]
        found.append((name, texts(part, r"<li class=.*?</li>"), texts(part, r'<p class="other">.*?</p>')))
    if any(differences for _, differences, _ in found):
        return found
    verdict = page[page.index('id="verdict"'):page.index('id="setup"')]
    return [("", texts(verdict, r"<li class=.*?</li>"), texts(verdict, r'<p class="other">.*?</p>'))]


def check_cut_off(check, page, study, models):
    """Its one sentence for a study of one condition."""
    found = re.search(r"by then ([0-9.]+) % of them have arrived with .*?, ([0-9.]+) % with", page)
    (condition,) = study.values()
    a, b = paired(condition[models[0]], condition[models[1]], "person.arrived")
    check.require("a warning where runs are cut off", bool(found) == (abs(b.mean() - a.mean()) > 0.05))
    if not found:
        return
    check.near("arrived", found[1], 100 * a.mean())
    check.near("arrived", found[2], 100 * b.mean())
    if end := re.search(r'end=&quot;(\d+)&quot; in the study', page):
        latest = max(one["person.nearlyAll"] for model in models for one in condition[model].values())
        check.require(f"end {end[1]} for {latest:.1f}", float(end[1]) == 100 * math.ceil(latest / 100))


def main():
    results = Path(sys.argv[1])
    page = (results / "report.html").read_text(encoding="utf-8")
    study, free = read_runs(results)
    conditions = json.loads((results / "summary.json").read_text(encoding="utf-8"))
    models = conditions["study"]["models"]
    check, sentences = Check(), 0
    for name, differences, others in sections(page):
        key = next((one for one in study if not name or one == name), None)
        check.require(f"runs of the condition {name}", key is not None)
        if key is None:
            continue
        reference, model = study[key][models[0]], study[key][models[1]]
        for sentence in differences:
            check_difference(check, sentence, reference, model)
        for sentence in others:
            check_geometry(check, sentence, reference, model,
                           [free[key][models[0]], free[key][models[1]]])
        sentences += len(differences)
    if len(study) == 1:
        check_cut_off(check, page, study, models)
    check.require("there are sentences", sentences > 0)
    print(f"{sentences} sentences, {check.checked} numbers and claims, {check.failed} wrong")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
