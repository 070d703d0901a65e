#!/usr/bin/python3
"""Crossings as netconvert guesses them, without a zebra: who turns gives way to people there.

usage: unmarked.py PEDZONE [--seeds N,N] [--steps S,S] [--keep FOLDER] [--model M]

A street with sidewalks, and one that joins it. A car turns into that every 4 s, over its crossing;
20 people walk along the street, over the same one. SUMO's junction table says that the cars give way
to them. All is read from SUMO's own outputs:
- nobody is touched, no vehicle collides, is teleported or performs an emergency braking
- everybody arrives, people and cars on average at most a tenth later than in plain SUMO
When people waited there for a gap they took 180 s instead of 151 with steps of 0.2 s, and 213 s
instead of 153 with steps of 1 s. It is a check of who waits, and vehicles give way to any model's
people: --model constant-velocity passes.
"""
import itertools
import statistics
import sys
from functools import partial
from pathlib import Path

from junction import arguments, call, contacts, judge, run_both

NODES = {"west": (-120, 0), "middle": (0, 0), "east": (120, 0), "south": (0, -120)}
CARS = 100
EVERY = 4  # [s]
LATER = 1.1


def make_network(folder):
    nodes = "".join(f'<node id="{name}" x="{x}" y="{y}"/>' for name, (x, y) in NODES.items())
    (folder / "n.nod.xml").write_text(f"<nodes>{nodes}</nodes>")
    edges = "".join(f'<edge id="{a}-{b}" from="{a}" to="{b}" speed="13" sidewalkWidth="2"'
                    f' priority="{1 if "south" in (a, b) else 3}"/>'
                    for other in ("west", "east", "south")
                    for a, b in (("middle", other), (other, "middle")))
    (folder / "e.edg.xml").write_text(f"<edges>{edges}</edges>")
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "--crossings.guess", "--walkingareas",
         "-o", "net.net.xml", folder=folder)


def make_scene(folder, seed, step):
    folder.mkdir(parents=True, exist_ok=True)
    make_network(folder)
    cars = (f'<flow id="car" begin="0" period="{EVERY}" number="{CARS}" from="west-middle"'
            ' to="middle-south" departSpeed="max"/>')
    people = "".join(f'<personFlow id="{begin}" begin="10" period="10" number="10">'
                     f'<walk from="{begin}-middle" to="middle-{end}"/></personFlow>'
                     for begin, end in (("west", "east"), ("east", "west")))
    (folder / "all.rou.xml").write_text(f"<routes>{cars}{people}</routes>")
    edges = " ".join(f"{a}-{b}" for other in ("west", "east", "south")
                     for a, b in (("middle", other), (other, "middle")))
    (folder / "all.zone.xml").write_text(f'<zones><zone id="z" edges="{edges}"/></zones>')
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="net.net.xml"/><route-files value="all.rou.xml"/>'
        f'<end value="1500"/><step-length value="{step}"/><seed value="{seed}"/>'
        '<collision.check-junctions value="true"/></configuration>')


def compare(pedzone, options, folder, seed, step):
    """What is wrong."""
    make_scene(folder, seed, step)
    plain, ours = run_both(pedzone, folder, *options)
    touched = sum(contacts(folder))
    print(f"seed {seed}, steps of {step} s:", flush=True)
    wrong = [f"{touched} people are touched"] if touched else []
    wrong += [f"{name}: {getattr(ours, name)}" for name in ("brakings", "teleports", "collisions")
              if getattr(ours, name)]
    for what, before, now in (("drive", plain.driven, ours.driven),
                              ("walk", plain.walks.values(), ours.walks.values())):
        usual, mean = statistics.mean(before), statistics.mean(now)
        print(f"  they {what} {usual:.1f} -> {mean:.1f} s")
        if len(now) < len(before) or mean > LATER * usual:
            wrong.append(f"{len(now)} of {len(before)} {what} for {mean:.1f} s instead of {usual:.1f}")
    return wrong


def main():
    parser = arguments(__doc__, "1")
    parser.add_argument("--steps", default="0.2,1")
    parser.add_argument("--model", help="walking model")
    asked = parser.parse_args()
    cases = {f"{seed}-{step}": (int(seed), float(step))
             for seed, step in itertools.product(asked.seeds.split(","), asked.steps.split(","))}
    options = ["--model", asked.model] if asked.model else []
    return judge(cases, asked.keep, partial(compare, Path(asked.pedzone).resolve(), options))


if __name__ == "__main__":
    sys.exit(main())
