#!/usr/bin/python3
"""Whom no crossing helps: with crossing="anywhere" nobody is kept in a zone who cannot get on there.

usage: arms.py PEDZONE [--keep FOLDER]

A crossroads whose four arms end at the network's border, where vehicles appear and nobody crosses,
with a light, or without any crossing at the junction; the zone is all of it. Three people begin along
one arm, on the side from which their way leads over the junction, and no vehicle is there. Read from SUMO's outputs:
each of them arrives, no later than 1.2 times plain SUMO's time.
"""
import subprocess
import sys

import street

ARM = 150  # [m]
WAYS = {"ahead": "BC", "left": "BF", "left-across": "FB"}
SLOWER = 1.2


def write_scenario(folder, kind):
    folder.mkdir(parents=True)
    nodes = {"A": (0, 0), "C": (2 * ARM, 0), "F": (ARM, ARM), "H": (ARM, -ARM)}
    (folder / "n.nod.xml").write_text(
        f'<nodes><node id="B" x="{ARM}" y="0" type="{kind}"/>' +
        "".join(f'<node id="{name}" x="{x}" y="{y}"/>' for name, (x, y) in nodes.items())
        + "</nodes>")
    edges = [a + b for end in nodes for a, b in ((end, "B"), ("B", end))]
    (folder / "n.edg.xml").write_text(
        "<edges>" + "".join(f'<edge id="{edge}" from="{edge[0]}" to="{edge[1]}" numLanes="1" '
                            'speed="13.9" sidewalkWidth="2.5"/>' for edge in edges) + "</edges>")
    subprocess.run(["netconvert", "-n", "n.nod.xml", "-e", "n.edg.xml", "--crossings.guess",
                    "-o", "n.net.xml"], cwd=folder, env=street.ENV, check=True, capture_output=True)
    (folder / "s.rou.xml").write_text(
        "<routes>" + "".join(f'<person id="{name}" depart="0"><walk from="AB" to="{to}"/></person>'
                             for name, to in WAYS.items()) + "</routes>")
    (folder / "s.zone.xml").write_text(
        f'<zones><zone id="all" edges="{" ".join(edges)}" crossing="anywhere"/></zones>')
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="n.net.xml"/><route-files value="s.rou.xml"/>'
        '<end value="900"/><step-length value="0.5"/></configuration>')


def main():
    given = street.options(__doc__, seeds=1)
    wrong = []
    for kind in ("traffic_light", "priority"):
        folder = given.keep / kind
        write_scenario(folder, kind)
        street.run_pedzone(folder, given.program, 1, *given.model)
        street.run_sumo(folder, 1)
        ours, plain = (street.read_trips(folder / f"{name}.trips.xml")
                       for name in ("pedzone", "sumo"))
        for name in WAYS:
            (arrived, own), (_, theirs) = ours[name][:2], plain[name][:2]
            print(f"{kind}, {name}: {theirs:.0f} -> {own:.0f} s")
            if not arrived or own > SLOWER * theirs:
                how = "takes too long" if arrived else "does not arrive"
                wrong.append(f"{kind}: who goes {name} {how}")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
