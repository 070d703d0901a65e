#!/usr/bin/python3
"""Whatever people's plans say, they do it in a zone as soon as in plain SUMO.

usage: plans.py PEDZONE [--keep FOLDER]

On a grid of streets with sidewalks, all of them one zone, with one person or car on its way:
- riders: cars with somebody aboard, and without, wait at a red light: they drive off when it is green
- rounds: walks that lead there and back, or round a block, are walked as their edges say
On a grid without sidewalks, whose edges have one lane:
- cars: people walk along one street to their own car, or to where a taxi is to pick them up
On a footway, an edge of one lane:
- twice: a second walk begins where the first one ended
Read from SUMO's tripinfo: every stage takes as long as in plain SUMO, but for 15 % and 10 s, is as
long but for 5 % (and junctions), and begins and ends in the same place, but for 1 m.
"""
import argparse
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / "vehicles"))
from junction import call, zone_of_all  # noqa: E402

LONGER, MORE, FARTHER, BESIDE = 0.15, 10.0, 0.05, 1.0  # shares and [s]; share; [m]
JUNCTIONS = 0.15  # share of a way
END = 1200  # [s]
CAR = '<vType id="car" sigma="0" speedDev="0"/><vType id="taxi" vClass="taxi" speedDev="0"><param' \
      ' key="has.taxi.device" value="true"/></vType><vType id="walker" vClass="pedestrian"/>'
PLACES = ("departPos", "arrivalPos")


def riders():
    for k in range(6):
        time = 10 + 12 * k
        yield time, f'<vehicle id="c{k}" depart="triggered" type="car"><route edges="A1B1 B1C1"/>' \
                    "</vehicle>"
        yield time, f'<person id="p{k}" type="walker" depart="{time}" departPos="30"><ride' \
                    f' from="A1B1" to="B1C1" lines="c{k}" arrivalPos="100"/></person>'
        yield time + 400, f'<vehicle id="e{k}" depart="{time + 400}" type="car" departPos="30">' \
                          '<route edges="A1B1 B1C1"/></vehicle>'


def cars():
    yield 0, '<trip id="tx" type="taxi" depart="0" from="C1C2"><stop lane="C1C2_0" endPos="60"' \
             ' triggered="person" parking="true"/></trip>'
    yield 1, '<vehicle id="car1" type="car" depart="1"><route edges="A1B1 B1B2 B2C2"/><stop' \
             ' lane="B1B2_0" endPos="70" triggered="person" expected="own" parking="true"/>' \
             "</vehicle>"
    yield 60, '<person id="own" type="walker" depart="60"><walk edges="B1B2" arrivalPos="70"/>' \
              '<ride to="B2C2" lines="car1"/><walk to="C2C3"/></person>'
    yield 300, '<person id="fare" type="walker" depart="300"><walk edges="A1B1" arrivalPos="70"/>' \
               '<ride from="A1B1" to="C1D1" lines="taxi"/><walk to="D1D2"/></person>'


def rounds():
    for name, edges, arrival in (("block", "A1B1 B1B2 B2A2 A2A1", 100),
                                 ("back", "A1B1 B1C1 C1B1 B1A1", 95),
                                 ("long", "A1A2 A2A3 A3B3 B3B2 B2B1 B1C1", 50)):
        yield 0, f'<person id="{name}" type="walker" depart="0" departPos="10"><walk' \
                 f' edges="{edges}" arrivalPos="{arrival}"/></person>'


def twice():
    yield 0, '<person id="p" type="walker" depart="0"><walk edges="a" arrivalPos="70"/>' \
             '<walk edges="a b" arrivalPos="30"/></person>'
    yield 0, '<person id="q" type="walker" depart="0"><walk edges="a" arrivalPos="70"/>' \
             '<walk edges="a" arrivalPos="10"/><walk edges="a b" arrivalPos="30"/></person>'


def grid(folder, *more):
    call("netgenerate", "--grid", "--grid.number", "4", "--grid.length", "120", *more,
         "--no-turnarounds", "-o", "n.net.xml", folder=folder)


def streets(folder):
    grid(folder, "--sidewalks.guess", "--crossings.guess", "--tls.set", "B1")


def footway(folder):
    (folder / "n.nod.xml").write_text('<nodes><node id="0" x="0" y="0"/><node id="1" x="100" y="0"/>'
                                      '<node id="2" x="200" y="0"/></nodes>')
    way = 'numLanes="1" width="4" allow="pedestrian"'
    (folder / "e.edg.xml").write_text(f'<edges><edge id="a" from="0" to="1" {way}/>'
                                      f'<edge id="b" from="1" to="2" {way}/></edges>')
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-o", "n.net.xml", folder=folder)


SCENES = {"riders": (streets, riders), "rounds": (streets, rounds), "cars": (grid, cars),
          "twice": (footway, twice)}


def stages(folder):
    """{(person or vehicle, number): its stage}"""
    found = {}
    for trip in xml.parse(folder / "tripinfo.xml").getroot():
        parts = [trip] if trip.tag == "tripinfo" else list(trip)
        for number, part in enumerate(parts):
            found[trip.get("id"), number] = part
    return found


def differences(plain, ours):
    for key, stage in plain.items():
        if float(stage.get("arrival", -1)) < 0:  # a taxi that waits for somebody
            continue
        name = f"{key[0]}, stage {key[1]} ({stage.tag})"
        own = ours.get(key)
        if own is None or own.tag != stage.tag or float(own.get("arrival", -1)) < 0:
            yield f"{name}: does not end"
            continue
        lasts, shall = float(own.get("duration")), float(stage.get("duration"))
        if abs(lasts - shall) > LONGER * shall + MORE:
            yield f"{name}: takes {lasts:.0f} s, in plain SUMO {shall:.0f} s"
        long, shall = float(own.get("routeLength")), float(stage.get("routeLength"))
        # From 1.16 on SUMO leaves out the junctions that pedzone walks people over.
        if not (1 - JUNCTIONS) * shall <= long <= (1 + FARTHER) * shall:
            yield f"{name}: is {long:.0f} m long, in plain SUMO {shall:.0f} m"
        for place in PLACES:
            if abs(float(own.get(place, 0)) - float(stage.get(place, 0))) > BESIDE:
                yield f"{name}: {place} is {own.get(place)}, in plain SUMO {stage.get(place)}"


def compare(pedzone, name, folder):
    folder.mkdir(parents=True, exist_ok=True)
    make_network, demand = SCENES[name]
    make_network(folder)
    zone_of_all(folder)
    routes = "".join(text for _, text in sorted(demand(), key=lambda one: one[0]))
    (folder / "s.rou.xml").write_text(f"<routes>{CAR}{routes}</routes>")
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="n.net.xml"/><route-files value="s.rou.xml"/>'
        f'<end value="{END}"/></configuration>')
    found = {}
    for who, command in (("plain", ["sumo", "-c", "../s.sumocfg", "--no-step-log", "true"]),
                         ("ours", [pedzone, "run", "../s.sumocfg", "--zone", "../all.zone.xml",
                                   "--quiet", "--"])):
        (folder / who).mkdir(exist_ok=True)
        call(*command, "--tripinfo-output", "tripinfo.xml", "--tripinfo-output.write-unfinished",
             "true", folder=folder / who)
        found[who] = stages(folder / who)
    if not found["plain"]:
        raise SystemExit(f"{name}: plain SUMO has no stage")
    wrong = list(differences(found["plain"], found["ours"]))
    print(f"{name}: {len(found['plain'])} stages, {len(wrong)} differences", flush=True)
    for line in wrong:
        print(f"  WRONG: {line}")
    return not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("--keep", help="folder for networks and outputs")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        folder = Path(asked.keep or work).resolve()
        return 0 if all([compare(Path(asked.pedzone).resolve(), name, folder / name)
                         for name in SCENES]) else 1


if __name__ == "__main__":
    sys.exit(main())
