#!/usr/bin/python3
"""Any SUMO scenario runs: with a zone as its people can walk, without one as in plain SUMO.

Each scenario is run by plain SUMO, too. Who arrives, how long the ways are and about how long they take is
compared by SUMO's tripinfo-output.

usage: test_any_scenario.py PEDZONE_PROGRAM
"""

import csv
import math
import re
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from xml.sax.saxutils import quoteattr

from refusal import RefusalChecks
from tiny_scenario import EDGES, WALKS, TinyScenario, sumo_environment

PEDZONE = None  # set from the command line
SLOWER = 1.25   # nobody is held up: a walk takes so much longer at most, or shorter
STEP = 0.5      # [s] of the scenario
NO_ZONE = EDGES.replace('type="highway.living_street"', "").replace('speed="2.78"', 'speed="13.89"')
CARS = """<vType id="car" maxSpeed="6" speedDev="0"/>
  <vehicle id="v0" type="car" depart="90"><route edges="west shared east"/></vehicle>"""
WALKER = '<vType id="DEFAULT_PEDTYPE" vClass="pedestrian" speedFactor="1" jmDriveAfterRedTime="-1"/>'


class ScenarioCase(RefusalChecks, unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)

    def scenario(self, *, edges=EDGES, netconvert=(), routes=WALKS, additional="<additional/>",
                 more=""):
        self.tiny = TinyScenario(self.folder, edges, netconvert)
        self.tiny.write("tiny.rou.xml", routes.replace("<routes>", "<routes>" + WALKER))
        self.tiny.write("tiny.add.xml", additional)
        self.tiny.config(more=more)

    def pedzone(self, *words, options=()):
        """`options`: for SUMO."""
        return subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", "--trajectories", "out/walked.csv", *words, "--",
             "--tripinfo-output", "pedzone.trips.xml", "--fcd-output", "pedzone.fcd.xml", *options],
            cwd=self.folder, text=True, capture_output=True, timeout=120)

    def sumo(self, *options):
        subprocess.run(["sumo", "-c", "tiny.sumocfg", "--no-step-log", "true", "--tripinfo-output",
                        "sumo.trips.xml", "--fcd-output", "sumo.fcd.xml", *options],
                       cwd=self.folder, check=True, capture_output=True, env=sumo_environment())

    def trips(self, who):
        """{id: (kind, [(tag, way [m], duration [s])])}"""
        found = {}
        for node in ElementTree.parse(self.folder / f"{who}.trips.xml").getroot():
            legs = [(leg.tag, float(leg.get("routeLength", "nan")), float(leg.get("duration")))
                    for leg in node]
            if node.tag == "tripinfo":
                legs = [("drive", float(node.get("routeLength")), float(node.get("duration")))]
            found[node.get("id")] = (node.tag, legs)
        return found

    def walked(self):
        with open(self.folder / "out/walked.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def check_as_in_sumo(self, *words, walked=None, options=()):
        """`walked`: who is walked by pedzone; unset: everybody."""
        done = self.pedzone(*words, options=options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.sumo(*options)
        ours, sumos = self.trips("pedzone"), self.trips("sumo")
        self.assertGreater(len(sumos), 2)
        self.assertEqual(set(ours), set(sumos))
        for name, (kind, legs) in sumos.items():
            self.assertEqual(ours[name][0], kind)
            self.assertEqual([leg[0] for leg in ours[name][1]], [leg[0] for leg in legs], name)
            for mine, its in zip(ours[name][1], legs):
                self.assertAlmostEqual(mine[1], its[1], delta=0.05, msg=name)
                self.assertLess(mine[2], its[2] * SLOWER + 2 * STEP, name)
                self.assertGreater(mine[2], its[2] / SLOWER - 2 * STEP, name)
        persons = {name for name, (kind, _) in sumos.items() if kind == "personinfo"}
        self.assertEqual({row["id"] for row in self.walked()},
                         persons if walked is None else walked)
        return done

    def check_same_bytes(self):
        """What plain SUMO and pedzone write is the same but for the time of day."""
        for file in ("trips.xml", "fcd.xml"):
            texts = [re.sub(r"<!--.*?-->", "", (self.folder / f"{who}.{file}").read_text(),
                            flags=re.DOTALL) for who in ("sumo", "pedzone")]
            self.assertEqual(*texts)


class BackAndForth(ScenarioCase):
    """Somebody comes back over the edge on which pedzone gave it back to SUMO."""

    def test_it_is_walked_by_pedzone_again(self):
        routes = "".join(
            f'<person id="p{k}" depart="{5 * k}"><walk edges="shared east" arrivalPos="10"/>'
            '<walk edges="east shared west" arrivalPos="50"/></person>' for k in range(3))
        self.scenario(routes=f"<routes>{routes}</routes>")
        self.check_as_in_sumo()
        for name in ("p0", "p1", "p2"):
            times = [float(row["time"]) for row in self.walked() if row["id"] == name]
            visits = 1 + sum(b - a > 1.5 * STEP for a, b in zip(times, times[1:]))
            self.assertEqual(visits, 2, name)


class WalksThatSaySo(ScenarioCase):
    """By speed or duration of a <walk>."""

    def test_they_take_as_long_as_in_sumo(self):
        over = 'edges="shared" departPos="0" arrivalPos="60"'
        self.scenario(routes=f"""<routes>
          <person id="slow" depart="0"><walk {over} speed="0.5"/></person>
          <person id="long" depart="20"><walk {over} duration="100"/></person>
          <person id="usual" depart="40"><walk {over}/></person>
          <personFlow id="flow" begin="60" end="100" number="2"><walk {over} speed="2.2"/>
            <walk from="shared" to="west" arrivalPos="20" duration="70"/></personFlow></routes>""")
        self.check_as_in_sumo()
        walks = {name: legs[0][2] for name, (_, legs) in self.trips("pedzone").items()}
        self.assertGreater(walks["slow"], 2.0 * walks["usual"])
        self.assertLess(walks["flow.0"], 0.75 * walks["usual"])


class WithoutSharedSpace(ScenarioCase):
    def test_it_runs_as_in_sumo_with_one_warning(self):
        self.scenario(edges=NO_ZONE, routes=WALKS.replace("</routes>", CARS + "</routes>"))
        done = self.check_as_in_sumo(walked=set())
        self.check_same_bytes()
        self.assertEqual(done.stderr.count("Warning: tiny.net.xml has no shared space"), 1)
        self.assertIn("pedzone inspect tiny.sumocfg", done.stderr)

    def test_inspect_shows_what_could_be_a_zone(self):
        self.scenario(edges=NO_ZONE)
        shown = subprocess.run([PEDZONE, "inspect", "tiny.sumocfg"], cwd=self.folder, text=True,
                               capture_output=True, check=True).stdout
        self.assertIn("No shared space", shown)
        named = re.search(r'edges="(\w+) \.\.\."', shown)
        self.tiny.write("a.zone.xml", f'<zones><zone id="a" edges="{named[1]}"/></zones>')
        done = self.pedzone("--zone", "a.zone.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("no shared space", done.stderr)
        self.assertNotEqual(self.walked(), [])

    def test_strict(self):
        self.scenario(edges=NO_ZONE)
        self.check_refused(self.pedzone("--strict"), "tiny.net.xml", "has no shared space")
        self.assertFalse((self.folder / "pedzone.trips.xml").exists())

    def test_a_zone_file_that_names_nothing_that_is_there(self):
        self.scenario(edges=NO_ZONE)
        self.tiny.write("a.zone.xml", '<zones><zone id="a"/></zones>')
        self.check_refused(self.pedzone("--zone", "a.zone.xml"), "a.zone.xml:1", "is empty")

    def test_nobody_may_walk(self):
        closed = (NO_ZONE.replace(' sidewalkWidth="2"', "")
                  .replace('speed="13.89"', 'speed="13.89" disallow="pedestrian"')
                  .replace('disallow="tram" ', ""))
        self.scenario(edges=closed, routes=f"<routes>{CARS * 1}</routes>")
        done = self.pedzone()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.sumo()
        self.check_same_bytes()
        self.assertIn("names no person", done.stderr)
        done = self.pedzone("--strict")
        self.assertEqual((done.returncode, "names no person" in done.stderr), (2, True))

    def test_no_edges(self):
        self.scenario(routes="<routes/>")
        net = (self.folder / "tiny.net.xml").read_text()
        self.tiny.write("tiny.net.xml", re.sub(r"(<net [^>]*>).*</net>", r"\1"
                        '<location netOffset="0,0" convBoundary="0,0,0,0" origBoundary="0,0,0,0" '
                        'projParameter="!"/></net>', net, flags=re.DOTALL))
        done = self.pedzone("--end", "20")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.sumo("--end", "20")
        self.check_same_bytes()


class KindsOfNetworks(ScenarioCase):
    def test_left_hand(self):
        self.scenario(netconvert=("--lefthand", "true"),
                      routes=WALKS.replace("</routes>", CARS + "</routes>"))
        self.check_as_in_sumo()

    def test_georeferenced(self):
        self.scenario(routes=WALKS.replace("</routes>", CARS + "</routes>"))
        net = (self.folder / "tiny.net.xml").read_text()
        self.tiny.write("tiny.net.xml", re.sub(
            r"<location .*/>", '<location netOffset="-500000,-5600000" '
            'convBoundary="0,-8,180,0" origBoundary="9,50,10,51" projParameter="+proj=utm +zone=32 '
            '+ellps=WGS84 +datum=WGS84 +units=m +no_defs"/>', net))
        self.check_as_in_sumo(options=("--fcd-output.geo",))
        # Whom pedzone walks is where its own output has it.
        self.assertTrue(all(math.isfinite(float(row["x"])) for row in self.walked()))

    def test_street_that_ends(self):
        """Whom SUMO walks across the street's end does not go back to the crossing instead."""
        pairs = ("bc", "B", "C"), ("cb", "C", "B"), ("cd", "C", "D"), ("dc", "D", "C")
        edges = "".join(f'<edge id="{name}" from="{a}" to="{b}" numLanes="1" speed="13.89"'
                        ' sidewalkWidth="2"/>' for name, a, b in pairs)
        (self.folder / "tiny.con.xml").write_text(
            '<connections><crossing node="C" edges="cd dc" priority="false"/></connections>')
        walks = {"end": ("dc cd", 2, 50), "crossing": ("dc cd", 55, 5), "ahead": ("bc cd", 20, 30)}
        routes = "".join(f'<person id="{name}" depart="0"><walk edges="{way}" departPos="{begin}"'
                         f' arrivalPos="{end}"/></person>'
                         for name, (way, begin, end) in walks.items())
        self.scenario(edges=f"<edges>{edges}</edges>", netconvert=("-x", "tiny.con.xml"),
                      routes=f"<routes>{routes}</routes>")
        self.tiny.write("a.zone.xml", '<zones><zone id="a" edges="bc cb cd dc"/></zones>')
        self.check_as_in_sumo("--zone", "a.zone.xml")

    def test_opposite_driving(self):
        """A slow vehicle is overtaken in the opposite lane."""
        both = EDGES.replace("</edges>", """
          <edge id="tsew" from="B" to="A" numLanes="1" speed="13.89"/>
          <edge id="derahs" from="C" to="B" numLanes="1" speed="2.78"/>
          <edge id="tsae" from="D" to="C" numLanes="1" speed="13.89"/></edges>""")
        slow = ('<vType id="slow" maxSpeed="1" speedDev="0"/><vehicle id="tractor" type="slow" '
                'depart="80"><route edges="west shared east"/></vehicle>')
        self.scenario(edges=both, netconvert=("--opposites.guess", "true"),
                      routes=WALKS.replace("</routes>", slow + CARS + "</routes>"))
        self.assertIn("<neigh ", (self.folder / "tiny.net.xml").read_text())
        self.check_as_in_sumo(options=("--end", "400"), walked={"p0", "p1"})

    def check_edge(self, name):
        """The shared street is named so."""
        self.scenario(routes="""<routes>
          <person id="p0" depart="0"><walk from="west" to="east"/></person>
          <person id="p1" depart="1"><walk from="west" to="shared" arrivalPos="40"/>
          </person><person id="p2" depart="2"><walk from="shared" to="east"/></person></routes>""")
        for file, mark in (("tiny.net.xml", r'(?<=["\s])shared(?=["_])'),
                           ("tiny.rou.xml", r'(?<=")shared(?=")')):
            text = (self.folder / file).read_text(encoding="utf-8")
            self.tiny.write(file, re.sub(mark, lambda _: quoteattr(name)[1:-1], text))
        self.check_as_in_sumo()

    def test_ids_of_edges(self):
        """(SUMO itself finds no edge of a walk whose id has other letters than ASCII's.)"""
        for name in ("a#1", "a%20b%s", "a[0]{1}(2)", "-a+b=c", "a$b~c^d`", "a/b@c",
                     "a&b&amp;c", "<a>", "it's", "a|b;c,d", "!a*?"):
            with self.subTest(name):
                self.check_edge(name)

    def test_ids_of_persons(self):
        """SUMO allows fewer characters here, and none that XML has to escape."""
        for name in ("a#1", "a%20b%s", "a[0]{1}(2)", "Jürgen_€_日本", "a+b=c", "a$b~c^d`", "a/b@c:d"):
            with self.subTest(name):
                self.scenario(routes=WALKS.replace('id="p0"', f'id="{name}"'))
                done = self.check_as_in_sumo("--summary", "out/s.json")
                self.assertIn(name, {row["id"] for row in self.walked()})
                self.assertEqual(done.stderr.count("Error"), 0)
        self.scenario(routes=WALKS.replace('id="p0"', 'id="a&amp;b"'))
        with self.assertRaises(subprocess.CalledProcessError):
            self.sumo()
        self.assertEqual(self.pedzone().returncode, 3)


class Bridge(ScenarioCase):
    """A road over a footway that is the zone."""

    NODES = ('<nodes><node id="w" x="-200" y="0" z="{z}"/><node id="e" x="200" y="0" z="{z}"/>'
             '<node id="s" x="0" y="-50" z="0"/><node id="n" x="0" y="50" z="0"/></nodes>')
    EDGES = ('<edges><edge id="road" from="w" to="e" speed="27.8" disallow="pedestrian"/>'
             '<edge id="path" from="s" to="n" speed="1.4" width="4" allow="pedestrian"/></edges>')
    ROUTES = ('<routes><flow id="c" begin="0" end="100" period="5" from="road" to="road"/>'
              '<personFlow id="p" begin="0" end="100" period="4"><walk edges="path"/></personFlow></routes>')

    def drives(self, z):
        """How long [s] each vehicle drives, (with pedzone, in plain SUMO)."""
        self.scenario(routes=self.ROUTES)
        self.tiny.write("tiny.nod.xml", self.NODES.format(z=z))
        self.tiny.write("tiny.edg.xml", self.EDGES)
        self.tiny.convert()
        self.tiny.write("path.zone.xml", '<zones><zone id="path" edges="path"/></zones>')
        done = self.pedzone("--zone", "path.zone.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual(self.walked(), [])
        self.sumo()
        return [{name: legs[0][2] for name, (kind, legs) in self.trips(who).items()
                 if kind == "tripinfo"} for who in ("pedzone", "sumo")]

    def test_its_vehicles_are_not_in_the_zone(self):
        for z in (8, -8):
            ours, plain = self.drives(z)
            self.assertEqual(ours, plain)
            self.assertEqual(len(plain), 20)
        ours, plain = self.drives(0)
        self.assertGreater(sum(ours.values()), sum(plain.values()) + 5.0, "on the ground they are")


class Coordinates(ScenarioCase):
    def places(self, x, y):
        """{(time, id): place} of all who are walked, relative to (x, y) [m]."""
        self.scenario(netconvert=("--offset.disable-normalization", "true", "--offset.x", str(x),
                                  "--offset.y", str(y)))
        self.done = self.pedzone()
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        return {(row["time"], row["id"]): (float(row["x"]) - x, float(row["y"]) - y)
                for row in self.walked()}

    def test_far_from_the_origin_everything_is_the_same(self):
        near = self.places(0, 0)
        self.assertGreater(len(near), 200)
        for x, y in ((500000, 5600000), (-5e6, 8e6)):
            far = self.places(x, y)
            self.assertEqual(set(far), set(near), (x, y))
            worst = max(math.dist(far[key], near[key]) for key in near)
            self.assertLess(worst, 0.0021, (x, y))  # the file has millimetres
            self.assertNotIn("coordinates", self.done.stderr)

    def test_beyond_that_it_is_told(self):
        self.places(500000, 1e7)
        self.assertIn("Warning: tiny.net.xml has coordinates beyond 8388608 m", self.done.stderr)

    def test_a_polygon_of_200_km_costs_no_more_than_what_is_reached(self):
        corners = "-100000,-100000 100000,-100000 100000,100000 -100000,100000"
        self.scenario(additional=f'<additional><poly id="sea" type="pedzone.walkable" '
                                 f'shape="{corners}"/></additional>')
        begin = time.process_time()
        done = self.pedzone("--summary", "out/s.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual(self.walked(), [])
        wall = float(re.search(r"wall +([\d.]+) s", done.stdout)[1])
        self.assertLess(wall, 40.0)  # 125 s when each cell of 8 m was looked at

    def test_polygons_that_are_left_out_are_named(self):
        islands = "".join(f'<poly id="island{k}" type="pedzone.walkable" '
                          f'shape="{x},200 {x + 5},200 {x + 5},205"/>'
                          for k, x in enumerate(range(60, 120, 15)))
        self.scenario(additional=f"<additional>{islands}</additional>")
        done = self.pedzone()
        self.assertEqual(done.returncode, 0, done.stderr)
        told = [line for line in done.stderr.splitlines() if "zone 'shared-space': " in line]
        self.assertEqual(len(told), 4, done.stderr)
        for k, line in enumerate(told[:3]):
            self.assertIn(f"walkable polygon 'island{k}' touches no lane of the zone: left out.",
                          line)
        self.assertIn("1 more of its shape; `pedzone inspect` lists them.", told[3])


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
