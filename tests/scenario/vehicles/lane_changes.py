#!/usr/bin/python3
"""People on streets with several lanes for one direction and no sidewalk, where cars change lanes.

usage: lane_changes.py PEDZONE [--seeds N,N] [--steps S,S] [--keep FOLDER]

Two scenes: a street of two lanes where cars keep right and overtake, and one of three where every
second car must come from the first lane to the third. SUMO does not see people whom pedzone walks. In
the first scene it puts a car from one lane onto the other within a step: where nothing holds it
back, ten cars and more are put onto people in each of these runs. In the second it takes 3 s for that
(lanechange.duration), and two to seven cars sweep over people between the lanes.
Everything is read from SUMO's own messages and outputs, beside plain SUMO:
- of people and vehicles, at most one pair a run touches (but where SUMO inserts a vehicle), with steps of
  1 s two (with SUMO 1.18, in four runs of the second scene 0 to 2; with 1.15 none)
- all cars and people arrive, and cars take at most 1.5 times as long as in plain SUMO (1.7 times where
  they have to get over: they wait for people)
- no vehicle is teleported or collides with another, at most one emergency braking more than in plain
  SUMO. In steps of 1 s this is told only: one that stops for people there may be too hard for the one
  behind it.
"""
import argparse
import itertools
import sys
import tempfile
from pathlib import Path

from junction import call, contacts, run_both

END = 700  # [s]


def make_overtaking(folder):
    (folder / "n.nod.xml").write_text(
        '<nodes><node id="a" x="0" y="0"/><node id="b" x="200" y="0"/><node id="c" x="400" y="0"/></nodes>')
    (folder / "e.edg.xml").write_text(
        '<edges><edge id="ab" from="a" to="b" numLanes="2" speed="8.33"/>'
        '<edge id="bc" from="b" to="c" numLanes="2" speed="8.33"/></edges>')
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-o", "net.net.xml", folder=folder)
    (folder / "r.rou.xml").write_text("""<routes>
    <vType id="slow" maxSpeed="4"/>
    <personFlow id="there" begin="0" end="250" period="5"><walk from="ab" to="bc"/></personFlow>
    <personFlow id="back" begin="0" end="250" period="9" departPos="190">
        <walk from="bc" to="ab" arrivalPos="5"/>
    </personFlow>
    <flow id="car" begin="5" end="300" period="7" departLane="1" departSpeed="max" from="ab" to="bc"/>
    <flow id="cart" type="slow" begin="8" end="300" period="21" departLane="1" from="ab" to="bc"/>
</routes>""")
    return "ab bc", ""


def make_turning(folder):
    (folder / "n.nod.xml").write_text(
        '<nodes><node id="a" x="0" y="0"/><node id="b" x="300" y="0"/><node id="c" x="500" y="0"/>'
        '<node id="d" x="300" y="150"/></nodes>')
    (folder / "e.edg.xml").write_text(
        '<edges><edge id="ab" from="a" to="b" numLanes="3" speed="13.89"/>'
        '<edge id="bc" from="b" to="c" numLanes="2" speed="13.89"/>'
        '<edge id="bd" from="b" to="d" speed="13.89"/></edges>')
    (folder / "c.con.xml").write_text(
        '<connections><connection from="ab" to="bd" fromLane="2" toLane="0"/>'
        '<connection from="ab" to="bc" fromLane="0" toLane="0"/>'
        '<connection from="ab" to="bc" fromLane="1" toLane="1"/></connections>')
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-x", "c.con.xml", "-o", "net.net.xml",
         folder=folder)
    (folder / "r.rou.xml").write_text("""<routes>
    <personFlow id="there" begin="0" end="300" period="6" departPos="20"><walk edges="ab"/></personFlow>
    <flow id="on" begin="0" end="360" period="12" departLane="0" from="ab" to="bc"/>
    <personFlow id="back" begin="4" end="300" period="6" departPos="280">
        <walk edges="ab" arrivalPos="10"/>
    </personFlow>
    <flow id="left" begin="6" end="360" period="12" departLane="0" from="ab" to="bd"/>
</routes>""")
    return "ab", '<lanechange.duration value="3"/>'


SCENES = {"overtaking": (make_overtaking, 57, 78, 1.5), "turning": (make_turning, 60, 100, 1.7)}


def make_scene(make, folder, seed, step):
    folder.mkdir(parents=True, exist_ok=True)
    edges, more = make(folder)
    (folder / "all.zone.xml").write_text(f'<zones><zone id="all" edges="{edges}"/></zones>')
    (folder / "s.sumocfg").write_text(
        f'<configuration><net-file value="net.net.xml"/><route-files value="r.rou.xml"/>{more}'
        f'<end value="{END}"/><step-length value="{step}"/><seed value="{seed}"/></configuration>')


def mean(numbers):
    return sum(numbers) / max(1, len(numbers))


def check(pedzone, folder, scene, seed, step):
    """What is wrong."""
    make, cars, people, slower = SCENES[scene]
    make_scene(make, folder, seed, step)
    plain, ours = run_both(pedzone, folder)
    inserted, touched = contacts(folder)
    drives = [mean(run.driven) for run in (plain, ours)]
    walks = [mean(run.walks.values()) for run in (plain, ours)]
    print(f"{scene}, seed {seed}, step {step} s: contacts {touched} and {inserted} at insertions, emergency "
          f"brakings {plain.brakings} -> {ours.brakings}, collisions {len(ours.collisions)}, "
          f"drives {drives[0]:.0f} -> {drives[1]:.0f} s, walks {walks[0]:.0f} -> {walks[1]:.0f} s", flush=True)
    wrong = {
        "touch": touched > (1 if step < 1 else 2),
        f"of {cars} and {people} are not there ({len(ours.driven)}, {len(ours.walks)})": len(ours.driven) != cars or len(ours.walks) != people,
        "do not arrive": walks[1] == float("inf"),
        "drive too slowly": drives[1] > slower * drives[0],
        "are teleported": step < 1 and ours.teleports - plain.teleports,
        "collide": step < 1 and ours.collisions,
        "brake too hard": step < 1 and ours.brakings > plain.brakings + 1}
    return [f"{scene}, seed {seed}, step {step} s: some {what}" for what, found in wrong.items() if found]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone", type=Path)
    parser.add_argument("--seeds", default="1")
    parser.add_argument("--steps", default="0.1,1")
    parser.add_argument("--keep", type=Path, help="folder for networks and outputs")
    options = parser.parse_args()
    wrong = []
    with tempfile.TemporaryDirectory() as temporary:
        cases = itertools.product(SCENES, options.steps.split(","), options.seeds.split(","))
        for scene, step, seed in cases:
            folder = (options.keep or Path(temporary)).resolve() / f"{scene}-{step}-{seed}"
            wrong += check(options.pedzone.resolve(), folder, scene, int(seed), float(step))
    print("\n".join(wrong or ["all as it should be"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
