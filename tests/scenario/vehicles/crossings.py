#!/usr/bin/python3
"""Where people cross streets whose networks netconvert makes of a few lines: beside plain SUMO.

usage: crossings.py PEDZONE [--scenes NAME,NAME] [--seeds N,N] [--steps S,S] [--keep FOLDER]

All streets are one zone (in "side" only the first one), and cars drive on them.
- zebra: a zebra crossing over a street with 1,200 cars an hour each way: these let people go first,
  whatever the length of SUMO's steps
- end: people come from a street that is cut off at the network's border, where netconvert lays no
  walking area: they cross at its junction, as SUMO's do, not where cars appear and vanish
- bend: netconvert makes a walking area only a few decimetres wide in its middle: people get through
  it, and not straight across the street
- far: a street with a signalled crossing at one end and another without a signal at the other, 500 m
  away: people cross where SUMO's do
- rails: people cross a railway with trains of 20 m/s on the level: these need not wait for them
- side: people leave the zone on the road: at its side, where SUMO's cars get past them
Read from SUMO's tripinfo: everybody arrives who does in plain SUMO, people's walks are on average no
longer than there by more than 25 % and 5 s, and cars' drives by more than 25 %, trains' by 4 %.
"""
import itertools
import statistics
import sys
from functools import partial
from pathlib import Path

from junction import arguments, call, judge, run_both

LONGER, MORE, DRIVEN = 0.25, 5.0, 0.25  # share and [s] of walks; share of drives
TRAINS = 0.04  # share of trains' drives: 0.06 to 0.14 where they waited
END = 2000  # [s]
TYPES = '<vType id="c" vClass="passenger"/><vType id="t" vClass="rail" length="80"/>'
FLOWS = 'begin="0" end="600"'
NODES = {"light": "traffic_light", "rails": "rail_crossing"}


def flow(name, start, end, period, kind="c"):
    return f'<flow id="{name}" type="{kind}" from="{start}" to="{end}" {FLOWS} period="{period}"' \
           ' departSpeed="max"/>'


def people(name, edges, depart=0, arrive=50, period=10):
    return f'<personFlow id="{name}" begin="20" end="520" period="{period}" departPos="{depart}">' \
           f'<walk edges="{edges}" arrivalPos="{arrive}"/></personFlow>'


# Nodes, edges with their attributes (one or both ways), connections, demand.
STREET = 'speed="13.89" sidewalkWidth="2"'
RAILS = 'allow="rail" speed="20"'
PATH = 'allow="pedestrian" width="1.5"'  # in one direction: people take it in both
SCENES = {
    "zebra": ("w -300 0, m 0 0, e 300 0", [("w", "m", STREET), ("m", "e", STREET)],
              '<crossing node="m" edges="wm mw" priority="true"/>',
              flow("a", "wm", "me", 3) + flow("b", "em", "mw", 3)
              + people("p", "wm em", 250, 250) + people("q", "em wm", 250, 250)),
    "end": ("e 0 0, j 100 0, k 200 0, n 100 100",
            [("e", "j", STREET), ("j", "k", STREET), ("j", "n", STREET)],
            '<crossing node="j" edges="jk kj" priority="true"/>'
            '<crossing node="j" edges="jn nj" priority="true"/>',
            flow("v", "ej", "jk", 3) + flow("w", "kj", "je", 3)
            + people("p", "ej jn") + people("q", "jn ej", 50, 0) + people("u", "ej je")),
    "bend": ("1 0 0, 2 120 0, 4 0 120, 9 60 60",
             [("1", "2", 'speed="10" sidewalkWidth="2"'),
              ("1", "4", 'speed="10" sidewalkWidth="2" numLanes="2"'),
              ("1", "9", PATH), ("1", "9", PATH + ' shape="0,0 20,50 60,60"')], "",
             flow("v", "21", "14", 12) + flow("w", "41", "12", 4)
             + people("p", "12 19", 60) + people("q", "19 12", 50, 60)),
    "far": ("s 0 0 light, u 500 0, a -100 0, b 0 100, c 600 0, d 500 100",
            [("s", "u", STREET), ("s", "a", STREET), ("s", "b", STREET), ("u", "c", STREET),
             ("u", "d", STREET)], "",
            people("p", "su us", 10, 470) + people("q", "us su", 450, 20)),
    "side": ("a 0 0, b 200 0, c 400 0",
             [("a", "b", 'speed="13.89"'), ("b", "c", 'speed="13.89"')], "",
             flow("v", "ab", "bc", 40) + people("p", "ab bc", 60, 190, 100)),
    "rails": ("w -200 0, m 0 0 rails, e 200 0, s 0 -400, n 0 400",
              [("w", "m", 'speed="8.3"'), ("m", "e", 'speed="8.3"'),
               ("s", "m", RAILS), ("m", "n", RAILS)], "",
              flow("t", "sm", "mn", 60, "t") + people("p", "wm me", 120, 80)
              + people("q", "em mw", 120, 80)),
}
OPTIONS = {"end": ["--walkingareas", "--fringe.guess"], "rails": []}
ZONES = {"side": ["ab", "ba"], "rails": ["wm", "mw", "me", "em"]}


def make_scene(folder, name, seed, step):
    folder.mkdir(parents=True, exist_ok=True)
    nodes, edges, connections, demand = SCENES[name]
    text = ""
    for node in nodes.split(","):
        id_, x, y, *special = node.split()
        kind = f'type="{NODES[special[0]]}"' if special else ""
        text += f'<node id="{id_}" x="{x}" y="{y}" {kind}/>'
    (folder / "n.nod.xml").write_text(f"<nodes>{text}</nodes>")
    text, names = "", []
    for one, other, more in edges:
        for start, end in ((one, other),) if PATH in more else ((one, other), (other, one)):
            names.append(start + end + "b" * names.count(start + end))
            text += f'<edge id="{names[-1]}" from="{start}" to="{end}" {more}/>'
    (folder / "n.edg.xml").write_text(f"<edges>{text}</edges>")
    (folder / "n.con.xml").write_text(f"<connections>{connections}</connections>")
    usual = ["--walkingareas"] if connections else ["--crossings.guess"]
    call("netconvert", "-n", "n.nod.xml", "-e", "n.edg.xml", "-x", "n.con.xml", "-o", "n.net.xml",
         "--no-turnarounds", *OPTIONS.get(name, usual), folder=folder)
    (folder / "all.zone.xml").write_text(
        f'<zones><zone id="all" edges="{" ".join(ZONES.get(name, names))}"/></zones>')
    (folder / "s.rou.xml").write_text(f"<routes>{TYPES}{demand}</routes>")
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="n.net.xml"/><route-files value="s.rou.xml"/>'
        f'<end value="{END}"/><step-length value="{step}"/><seed value="{seed}"/></configuration>')


def compare(pedzone, folder, name, seed, step):
    """What is wrong."""
    make_scene(folder, name, seed, step)
    plain, ours = run_both(pedzone, folder)
    walks = [statistics.mean(run.walks.values()) for run in (plain, ours)]
    drives = [statistics.mean(run.driven) if run.driven else 0.0 for run in (plain, ours)]
    print(f"{name}, seed {seed}, steps of {step} s: walks {walks[0]:.0f} -> {walks[1]:.0f} s, drives"
          f" {drives[0]:.0f} -> {drives[1]:.0f} s", flush=True)
    late = TRAINS if name == "rails" else DRIVEN
    wrong = []
    if not walks[1] <= (1 + LONGER) * walks[0] + MORE:
        wrong.append("people walk longer, or do not arrive")
    if len(ours.driven) < len(plain.driven) or drives[1] > (1 + late) * drives[0]:
        wrong.append("cars drive longer, or do not arrive")
    return wrong


def main():
    parser = arguments(__doc__, "1")
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--steps", default="0.1,1")
    asked = parser.parse_args()
    cases = {f"{name}-{step}-{seed}": (name, int(seed), float(step))
             for name, step, seed in itertools.product(
                 asked.scenes.split(","), asked.steps.split(","), asked.seeds.split(","))}
    return judge(cases, asked.keep, partial(compare, Path(asked.pedzone).resolve()))


if __name__ == "__main__":
    sys.exit(main())
