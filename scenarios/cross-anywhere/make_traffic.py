#!/usr/bin/python3
"""Writes people, parked cars and buses of the example: people.rou.xml, parked.rou.xml. Doors of shops
every 20 m on both sides; a bus stop; gaps between the parked cars. (cars-*.rou.xml have the traffic,
types-*.rou.xml the types.)

usage: make_traffic.py [--seed 1]
"""
import argparse
import random
from pathlib import Path

LENGTH, END = 200.5, 1200  # [m], [s]
PEOPLE = 300  # an hour
DOORS = [20 * k for k in range(1, 10)]  # [m] from the west
SAME_SIDE, BY_BUS = 0.25, 0.1  # shares of people
BUS_EVERY = 300  # [s]
SLOTS = [15 + 7 * k for k in range(25)]  # [m] where cars are parked, along each edge
PARKED = 0.6  # share of them
NOTE = "<!-- by make_traffic.py -->\n"


def times(rng, per_hour):
    now = rng.expovariate(per_hour / 3600)
    while now < END:
        yield now
        now += rng.expovariate(per_hour / 3600)


def parked(rng):
    for edge in ("eastward", "westward"):
        for slot in SLOTS:
            near_stop = edge == "eastward" and 120 < slot < 165
            if rng.random() < PARKED and not near_stop:
                name = f"parked_{edge}_{slot}"
                yield (f'    <vehicle id="{name}" type="parked" depart="0" departLane="1" '
                       f'departPos="{slot}"><route edges="{edge}"/>'
                       f'<stop lane="{edge}_1" startPos="{slot - 0.5}" endPos="{slot}" '
                       f'duration="{10 * END}"/></vehicle>')


def buses():
    for time in range(60, END, BUS_EVERY):
        yield (f'    <vehicle id="bus_{time}" type="bus" depart="{time}" departSpeed="max">'
               f'<route edges="in_west eastward out_east"/>'
               f'<stop busStop="shops" duration="20"/></vehicle>')


def walk(rng, at, to, from_north, to_north):
    """Edges and place of arrival of a walk from door to door."""
    edges = ("westward" if from_north else "eastward", "westward" if to_north else "eastward")
    arrive = LENGTH - to if to_north else to
    both = edges[0] if edges[0] == edges[1] else " ".join(edges)
    return f'<walk edges="{both}" arrivalPos="{arrive:.1f}"/>'


def people(rng):
    for n, time in enumerate(times(rng, PEOPLE)):
        at, north = rng.choice(DOORS), rng.random() < 0.5
        kind = rng.choices(("adult", "senior", "child"), (0.7, 0.22, 0.08))[0]
        depart = LENGTH - at if north else at
        head = (f'    <person id="{kind}_{n}" type="{kind}" depart="{time:.1f}" '
                f'departPos="{depart:.1f}">')
        if rng.random() < BY_BUS:
            edges = "westward eastward" if north else "eastward"
            yield f'{head}<walk edges="{edges}" busStop="shops"/><ride lines="ANY" to="out_east"/></person>'
            continue
        stays = rng.random() < SAME_SIDE
        to = rng.choice([door for door in DOORS if door != at or not stays])
        yield f"{head}{walk(rng, at, to, north, north == stays)}</person>"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    rng = random.Random(parser.parse_args().seed)
    here = Path(__file__).resolve().parent
    (here / "parked.rou.xml").write_text(
        f"<routes>\n{NOTE}" + "\n".join([*parked(rng), *buses()]) + "\n</routes>\n")
    (here / "people.rou.xml").write_text(
        f"<routes>\n{NOTE}" + "\n".join(people(rng)) + "\n</routes>\n")


if __name__ == "__main__":
    main()
