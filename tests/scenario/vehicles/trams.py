#!/usr/bin/python3
"""Trams of 36 m on a bend across a square with people.

usage: trams.py PEDZONE [--seeds N,N] [--steps S,S] [--keep FOLDER] [--model M]

A tram bends where its carriages meet; a straight body of that length would cut the corner by 6 m.
Where the carriages are is worked out here from SUMO's own outputs, by the shapes of the network's
lanes:
- nobody is touched by a carriage that drives
- hardly anybody is pushed by one, and nobody far (the run's summary)
- trams drive on average at most half as long again as without people (in plain SUMO, whose people
  and trams do not see each other)
- everybody arrives
With --model constant-velocity it fails.
"""
import argparse
import json
import math
import statistics
import sys
import tempfile
import xml.etree.ElementTree as xml
from bisect import bisect_right
from pathlib import Path

from junction import Run, call

FLOWS, END = 600, 1000  # [s]
RADIUS, CARRIAGES, LENGTH, WIDTH = 25, 3, 36.0, 2.4  # [m] but for the number of carriages
PERSON = 0.5 * 0.478  # [m] SUMO's default
TOUCH, DRIVES = 0.01, 1.0  # [m]; [m/s]
PUSHED, FAR = 0.02, 0.5  # share of all people; [m]
LONGER = 1.5
FOOTWAYS = {"a": ((20, 60), (140, 10)), "b": ((60, -40), (80, 90)), "c": ((60, -40), (150, 60))}


def make_network(folder):
    nodes = {"west": (-200, 0), "begin": (0, 0), "end": (100, 100), "north": (100, 300)}
    for name, ends in FOOTWAYS.items():
        nodes |= {f"{name}0": ends[0], f"{name}1": ends[1]}
    text = "".join(f'<node id="{name}" x="{x}" y="{y}"/>' for name, (x, y) in nodes.items())
    (folder / "n.nod.xml").write_text(f"<nodes>{text}</nodes>")
    angles = [math.pi / 2 * i / 12 for i in range(13)]
    bend = [(0, 0), *((75 + RADIUS * math.sin(a), 25 - RADIUS * math.cos(a)) for a in angles),
            (100, 100)]
    shape = " ".join(f"{x:.2f},{y:.2f}" for x, y in bend)
    track = 'numLanes="1" width="3.2" allow="tram"'
    footway = 'numLanes="1" width="6" speed="2" allow="pedestrian"'
    edges = [f'<edge id="in" from="west" to="begin" speed="8" {track}/>',
             f'<edge id="bend" from="begin" to="end" speed="5" shape="{shape}" {track}/>',
             f'<edge id="out" from="end" to="north" speed="8" {track}/>']
    for name in FOOTWAYS:
        edges.append(f'<edge id="{name}+" from="{name}0" to="{name}1" {footway}/>')
        edges.append(f'<edge id="{name}-" from="{name}1" to="{name}0" {footway}/>')
    (folder / "e.edg.xml").write_text(f"<edges>{''.join(edges)}</edges>")
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-o", "net.net.xml",
         "--offset.disable-normalization", folder=folder)


def make_scene(folder, seed, step):
    folder.mkdir(parents=True, exist_ok=True)
    make_network(folder)
    times = f'begin="0" end="{FLOWS}"'
    carriage = LENGTH / CARRIAGES
    lengths = "".join(f'<param key="{key}" value="{carriage}"/>'
                      for key in ("locomotiveLength", "carriageLength"))
    walks = "".join(f'<personFlow id="{name}{way}" {times} period="exp(0.15)">'
                    f'<walk edges="{name}{way}"/></personFlow>'
                    for name in FOOTWAYS for way in "+-")
    (folder / "all.rou.xml").write_text(
        f'<routes><vType id="tram" vClass="tram" length="{LENGTH}" width="{WIDTH}">{lengths}</vType>'
        f'<flow id="tram" type="tram" {times} period="60"><route edges="in bend out"/></flow>'
        f"{walks}</routes>")
    (folder / "square.add.xml").write_text(
        '<additional><poly id="square" type="pedzone.walkable" color="grey"'
        ' shape="5,-40 150,-40 150,100 5,100"/></additional>')
    edges = " ".join(f"{name}{way}" for name in FOOTWAYS for way in "+-")
    (folder / "all.zone.xml").write_text(
        f'<zones><zone id="square" edges="{edges}" polygons="square"/></zones>')
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="net.net.xml"/><route-files value="all.rou.xml"/>'
        f'<additional-files value="square.add.xml"/><end value="{END}"/>'
        f'<step-length value="{step}"/><seed value="{seed}"/></configuration>')


class Track:
    """The trams' way as a line, and where on it each of its lanes begins."""

    def __init__(self, net_file):
        lanes = {lane.get("id"): [tuple(map(float, point.split(",")[:2]))
                                  for point in lane.get("shape").split()]
                 for lane in xml.parse(net_file).getroot().iter("lane")}
        way = ["in_0", ":begin_0_0", "bend_0", ":end_0_0", "out_0"]
        self.begins, self.points, self.offsets = {}, [lanes["in_0"][0]], [0.0]
        for lane in way:
            self.begins[lane] = self.offsets[-1]
            for point in lanes[lane]:
                piece = math.dist(self.points[-1], point)
                if piece > 0:
                    self.points.append(point)
                    self.offsets.append(self.offsets[-1] + piece)

    def at(self, offset):
        """The point so far [m] from its begin; straight on before that."""
        i = min(max(bisect_right(self.offsets, offset), 1), len(self.points) - 1)
        share = (offset - self.offsets[i - 1]) / (self.offsets[i] - self.offsets[i - 1])
        (ax, ay), (bx, by) = self.points[i - 1:i + 1]
        return ax + share * (bx - ax), ay + share * (by - ay)

    def carriages(self, front):
        """(front, rear) of each, where the tram's front is at that offset [m]."""
        each = LENGTH / CARRIAGES
        return [(self.at(front - k * each), self.at(front - (k + 1) * each))
                for k in range(CARRIAGES)]


def inside(carriage, point):
    """[m] how deep that is in a carriage; negative: outside."""
    (fx, fy), (rx, ry) = carriage
    chord = math.dist(*carriage)
    ax, ay = (fx - rx) / chord, (fy - ry) / chord
    # The body begins at the front and has its full length, as a straight body has.
    length = LENGTH / CARRIAGES
    dx, dy = fx - point[0], fy - point[1]
    along, aside = dx * ax + dy * ay, abs(dx * ay - dy * ax)
    outside_x, outside_y = max(-along, along - length), aside - 0.5 * WIDTH
    if outside_x > 0 and outside_y > 0:
        return -math.hypot(outside_x, outside_y)
    return -max(outside_x, outside_y)


def touched(folder):
    """Pairs of a person and a tram that drives: {(person, tram): deepest overlap [m]}."""
    track, pairs = Track(folder / "net.net.xml"), {}
    for _, step in xml.iterparse(folder / "ours" / "fcd.xml"):
        if step.tag != "timestep":
            continue
        people = [(one.get("id"), (float(one.get("x")), float(one.get("y"))))
                  for one in step.iter("person")]
        for tram in step.iter("vehicle"):
            if float(tram.get("speed")) < DRIVES:
                continue
            front = track.begins[tram.get("lane")] + float(tram.get("pos"))
            for carriage in track.carriages(front):
                for name, point in people:
                    depth = inside(carriage, point) + PERSON
                    if depth > TOUCH:
                        pair = name, tram.get("id")
                        pairs[pair] = max(depth, pairs.get(pair, 0.0))
        step.clear()
    return pairs


def compare(pedzone, folder, seed, step, model):
    """What is wrong."""
    make_scene(folder, seed, step)
    config, ours = folder / "s.sumocfg", folder / "ours"
    plain = Run(folder / "plain", ["sumo", "-c", config, "--no-step-log", "true"])
    run = Run(ours, [pedzone, "run", config, "--zone", folder / "all.zone.xml", "--summary",
                     ours / "summary.json", *(["--model", model] if model else []), "--"])
    pushed = json.loads((ours / "summary.json").read_text())["pushes"]
    pairs = touched(folder)
    drives = [statistics.mean(one.driven) for one in (plain, run)]
    print(f"seed {seed}, steps of {step} s: touched {len(pairs)} of {len(run.walks)}"
          f" (deepest {max(pairs.values(), default=0):.2f} m), pushed {pushed['persons']} (by at most {pushed['longest_m']:.2f} m),"
          f" trams drive {drives[0]:.0f} -> {drives[1]:.0f} s", flush=True)
    wrong = []
    if pairs:
        wrong.append(f"{len(pairs)} people are touched")
    if pushed["persons"] > PUSHED * len(run.walks) or pushed["longest_m"] > FAR:
        wrong.append("people are pushed")
    late = sum(math.isinf(walk) for walk in run.walks.values())
    if late:
        wrong.append(f"{late} people do not arrive")
    if drives[1] > LONGER * drives[0]:
        wrong.append("trams take too long")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("--seeds", default="1,2")
    parser.add_argument("--steps", default="0.1,1")
    parser.add_argument("--model", help="walking model")
    parser.add_argument("--keep", help="folder for networks and outputs")
    asked = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as work:
        for step in asked.steps.split(","):
            for seed in asked.seeds.split(","):
                folder = Path(asked.keep or work).resolve() / f"{step}-{seed}"
                for line in compare(Path(asked.pedzone).resolve(), folder, int(seed), float(step),
                                    asked.model):
                    failed = True
                    print(f"  WRONG: {line}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
