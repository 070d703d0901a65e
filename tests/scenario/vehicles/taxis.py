#!/usr/bin/python3
"""Taxis that SUMO sends here and there among people: nobody is run into where they turn.

usage: taxis.py PEDZONE [--seeds N,N] [--idle ALGORITHM,...] [--keep FOLDER]

A grid of 16 junctions, all streets one zone, 30 taxis, 100 people who ride and 600 who walk, steps of
1 s. A taxi's route is another one after each order, under the same id. Told by check_run.py from SUMO's
outputs: people whom pedzone walks are touched by as few vehicles that drive as in the same town with
other vehicles.
"""
import itertools
import random
import sys
import xml.etree.ElementTree as xml
from functools import partial
from pathlib import Path

from junction import all_contacts, arguments, call, judge, run_both, zone_of_all

TAXIS, PEOPLE, EVERY, WINDOW, END = 30, 700, 7, 1200, 2400  # numbers; every so many rides; [s]
TOUCHED = 2  # of a run; with the routes of the last rides 7 to 10 were


def make_scene(folder, seed, idle):
    folder.mkdir(parents=True, exist_ok=True)
    call("netgenerate", "--grid", "--grid.number", 4, "--grid.length", 120, "--sidewalks.guess",
         "--crossings.guess", "--no-turnarounds", "--default.speed", 13.89, "--seed", seed,
         "-o", "n.net.xml", folder=folder)
    edges = [edge.get("id") for edge in xml.parse(folder / "n.net.xml").getroot().iter("edge")
             if edge.get("function") is None]
    zone_of_all(folder)
    draw = random.Random(seed)
    demand = "".join(f'<trip id="t{k}" type="taxi" depart="0" from="{draw.choice(edges)}"/>'
                     for k in range(TAXIS))
    for k, time in enumerate(sorted(draw.uniform(0, WINDOW) for _ in range(PEOPLE))):
        start, goal = draw.sample(edges, 2)
        how = 'ride lines="taxi"' if draw.randrange(EVERY) == 0 else "walk"
        demand += (f'<person id="p{k}" depart="{time:.2f}" departPos="{draw.randint(5, 80)}">'
                   f'<{how} from="{start}" to="{goal}"/></person>')
    (folder / "s.rou.xml").write_text(
        '<routes><vType id="taxi" vClass="taxi"><param key="has.taxi.device" value="true"/></vType>'
        f"{demand}</routes>")
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="n.net.xml"/><route-files value="s.rou.xml"/>'
        f'<end value="{END}"/><device.taxi.dispatch-algorithm value="greedy"/>'
        f'<device.taxi.idle-algorithm value="{idle}"/>'
        '<collision.check-junctions value="true"/></configuration>')


def compare(pedzone, folder, seed, idle):
    """What is wrong."""
    make_scene(folder, seed, idle)
    plain, ours = run_both(pedzone, folder)
    found = all_contacts(folder)
    touched = found["controlled"]["pairs"]
    print(f"seed {seed}, idle taxis {idle}: {touched} people touched by a taxi that drives,"
          f" {found['at_insertion']['pairs']} at insertions;"
          f" {len(plain.walks)} -> {len(ours.walks)} people", flush=True)
    if touched > TOUCHED:
        yield f"more than {TOUCHED} people are touched"
    if len(ours.walks) < len(plain.walks) or float("inf") in ours.walks.values():
        yield "somebody does not arrive"


def main():
    parser = arguments(__doc__, "1,2")
    parser.add_argument("--idle", default="stop,randomCircling")
    asked = parser.parse_args()
    cases = {f"{idle}-{seed}": (int(seed), idle) for idle, seed in
             itertools.product(asked.idle.split(","), asked.seeds.split(","))}
    return judge(cases, asked.keep, partial(compare, Path(asked.pedzone).resolve()))


if __name__ == "__main__":
    sys.exit(main())
