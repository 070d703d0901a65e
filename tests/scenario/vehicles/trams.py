#!/usr/bin/python3
"""Trams of 36 m, and trains of 180 m, on a bend across a square with people.

usage: trams.py PEDZONE [--seeds N,N] [--steps S,S] [--keep FOLDER] [--model M]

A tram bends where its carriages meet; a straight body of that length would cut the corner by 6 m. A
train's rear is still in the zone when its front has left that by far.
Where the carriages are is worked out here from SUMO's own outputs, by the shapes of the network's
lanes:
- nobody is touched by a carriage that drives
- hardly anybody is pushed by one, and nobody far (the run's summary)
- they drive on average at most half as long again as without people (in plain SUMO, whose people
  and trams do not see each other)
- everybody arrives
With --model constant-velocity it fails.
"""
import itertools
import json
import math
import statistics
import sys
import xml.etree.ElementTree as xml
from bisect import bisect_right
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from junction import Run, arguments, call, judge

FLOWS, END = 600, 1000  # [s]
RADIUS, WIDTH = 25, 2.4  # [m]
PERSON = 0.5 * 0.478  # [m] SUMO's default
TOUCH, DRIVES = 0.01, 1.0  # [m]; [m/s]
PUSHED, FAR = 0.02, 0.5  # share of all people; [m]
LONGER = 1.5
FOOTWAYS = {"a": ((20, 60), (140, 10)), "b": ((60, -40), (80, 90)), "c": ((60, -40), (150, 60))}


@dataclass(frozen=True)
class Scene:
    name: str
    length: float  # [m]
    carriages: int
    period: int  # [s] between two of them
    footways: str  # names
    top: int  # [m] the square's edge

    def each(self):
        return self.length / self.carriages


SCENES = [Scene("tram", 36.0, 3, 60, "abc", 100), Scene("train", 180.0, 10, 150, "ac", 45)]


def make_network(folder, scene):
    nodes = {"west": (-400, 0), "begin": (0, 0), "end": (100, 100), "north": (100, 500)}
    for name in scene.footways:
        nodes |= {f"{name}0": FOOTWAYS[name][0], f"{name}1": FOOTWAYS[name][1]}
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
    for name in scene.footways:
        edges.append(f'<edge id="{name}+" from="{name}0" to="{name}1" {footway}/>')
        edges.append(f'<edge id="{name}-" from="{name}1" to="{name}0" {footway}/>')
    (folder / "e.edg.xml").write_text(f"<edges>{''.join(edges)}</edges>")
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-o", "net.net.xml",
         "--offset.disable-normalization", folder=folder)


def make_scene(folder, scene, seed, step):
    folder.mkdir(parents=True, exist_ok=True)
    make_network(folder, scene)
    times = f'begin="0" end="{FLOWS}"'
    lengths = "".join(f'<param key="{key}" value="{scene.each()}"/>'
                      for key in ("locomotiveLength", "carriageLength"))
    walks = "".join(f'<personFlow id="{name}{way}" {times} period="exp(0.15)">'
                    f'<walk edges="{name}{way}"/></personFlow>'
                    for name in scene.footways for way in "+-")
    (folder / "all.rou.xml").write_text(
        f'<routes><vType id="tram" vClass="tram" length="{scene.length}" width="{WIDTH}">{lengths}'
        f'</vType><flow id="tram" type="tram" {times} period="{scene.period}">'
        '<route edges="in bend out"/></flow>'
        f"{walks}</routes>")
    (folder / "square.add.xml").write_text(
        '<additional><poly id="square" type="pedzone.walkable" color="grey"'
        f' shape="5,-40 150,-40 150,{scene.top} 5,{scene.top}"/></additional>')
    edges = " ".join(f"{name}{way}" for name in scene.footways for way in "+-")
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

    def carriages(self, scene, front):
        """(front, rear) of each, where the tram's front is at that offset [m]."""
        ends = [self.at(front - k * scene.each()) for k in range(scene.carriages + 1)]
        return list(zip(ends, ends[1:]))


def inside(carriage, length, point):
    """[m] how deep that is in a carriage of that length; negative: outside."""
    (fx, fy), (rx, ry) = carriage
    chord = math.dist(*carriage)
    ax, ay = (fx - rx) / chord, (fy - ry) / chord
    # The body begins at the front and has its full length, as a straight body has.
    dx, dy = fx - point[0], fy - point[1]
    along, aside = dx * ax + dy * ay, abs(dx * ay - dy * ax)
    outside_x, outside_y = max(-along, along - length), aside - 0.5 * WIDTH
    if outside_x > 0 and outside_y > 0:
        return -math.hypot(outside_x, outside_y)
    return -max(outside_x, outside_y)


def touched(folder, scene):
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
            for carriage in track.carriages(scene, front):
                for name, point in people:
                    depth = inside(carriage, scene.each(), point) + PERSON
                    if depth > TOUCH:
                        pair = name, tram.get("id")
                        pairs[pair] = max(depth, pairs.get(pair, 0.0))
        step.clear()
    return pairs


def compare(pedzone, folder, scene, seed, step, model):
    """What is wrong."""
    make_scene(folder, scene, seed, step)
    config, ours = folder / "s.sumocfg", folder / "ours"
    plain = Run(folder / "plain", ["sumo", "-c", config, "--no-step-log", "true"])
    run = Run(ours, [pedzone, "run", config, "--zone", folder / "all.zone.xml", "--summary",
                     ours / "summary.json", *(["--model", model] if model else []), "--"])
    pushed = json.loads((ours / "summary.json").read_text())["pushes"]
    pairs = touched(folder, scene)
    drives = [statistics.mean(one.driven) for one in (plain, run)]
    print(f"{scene.name}, seed {seed}, steps of {step} s: touched {len(pairs)} of {len(run.walks)}"
          f" (deepest {max(pairs.values(), default=0):.2f} m), pushed {pushed['persons']}"
          f" (by at most {pushed['longest_m']:.2f} m),"
          f" drives {drives[0]:.0f} -> {drives[1]:.0f} s", flush=True)
    wrong = []
    if pairs:
        wrong.append(f"{len(pairs)} people are touched")
    if pushed["persons"] > PUSHED * len(run.walks) or pushed["longest_m"] > FAR:
        wrong.append("people are pushed")
    late = sum(math.isinf(walk) for walk in run.walks.values())
    if late:
        wrong.append(f"{late} people do not arrive")
    if drives[1] > LONGER * drives[0]:
        wrong.append("they drive too long")
    return wrong


def main():
    parser = arguments(__doc__, "1,2")
    parser.add_argument("--steps", default="0.1,1")
    parser.add_argument("--model", help="walking model")
    asked = parser.parse_args()
    cases = {f"{scene.name}-{step}-{seed}": (scene, int(seed), float(step), asked.model)
             for scene, step, seed in itertools.product(SCENES, asked.steps.split(","),
                                                        asked.seeds.split(","))}
    return judge(cases, asked.keep, partial(compare, Path(asked.pedzone).resolve()))


if __name__ == "__main__":
    sys.exit(main())
