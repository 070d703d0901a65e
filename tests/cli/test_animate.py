#!/usr/bin/python3
"""`pedzone animate`: what it writes, and every kind of bad input. tests/browser looks at the page.

usage: test_animate.py PEDZONE_PROGRAM
"""

import base64
import gzip
import json
import re
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import EDGES, TinyScenario, sumo_environment

PEDZONE = None  # set from the command line

# A van drives east at 8 m/s, a person north at 1 m/s.
STEP = """<timestep time="{time:.2f}">
  <vehicle id="van.0" x="{x:.2f}" y="0.00" angle="90.00" type="van" speed="8.00"/>
  <person id="{person}" x="30.00" y="{y:.2f}" angle="0.00" speed="1.00"/></timestep>
"""
TYPES = '<routes><vType id="van" length="6" width="2"/></routes>'
HEADER = "time,id,x,y,vx,vy,heading,motion,activity\n"


def fcd(person="p", steps=21, every=0.1):
    return "<fcd-export>\n" + "".join(
        STEP.format(time=every * i, x=10 + 8 * every * i, y=every * i, person=person)
        for i in range(steps)) + "</fcd-export>\n"


def numbers(packed):
    """Base64 of deflated zigzag varints."""
    found, value, shift = [], 0, 0
    for byte in zlib.decompress(base64.b64decode(packed)):
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            found.append((value >> 1) ^ -(value & 1))
            value = shift = 0
    return found


def summed(differences):
    found = []
    for one in differences:
        found.append(one + (found[-1] if found else 0))
    return found


def summed_twice(differences):
    return summed(differences[:1] + summed(differences[1:]))


class Animate(RefusalChecks, unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.folder = Path(self.directory.name)
        self.write("types.rou.xml", TYPES)
        self.write("fcd.xml", fcd())

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def call(self, *words):
        return subprocess.run(list(map(str, words)), cwd=self.folder, text=True, timeout=120,
                              capture_output=True, env=sumo_environment(),
                              stdin=subprocess.DEVNULL)

    def animate(self, *words, file="fcd.xml"):
        return self.call(PEDZONE, "animate", file, "--vtypes", "types.rou.xml", "--out",
                         "out/a.html", *words)

    def page(self, *words, file="fcd.xml"):
        done = self.animate(*words, file=file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / "out/a.html").read_text()

    def data(self, *words, file="fcd.xml"):
        page = self.page(*words, file=file)
        (text,) = re.findall(r'type="application/json" id="data">(.*?)</script>', page, re.S)
        return json.loads(text)

    # What is written

    def test_help(self):
        done = self.call(PEDZONE, "animate", "--help")
        self.assertEqual(done.returncode, 0)
        for word in ("--beside", "--out", "--rate", "Examples"):
            self.assertIn(word, done.stdout)

    def test_places(self):
        (run,) = self.data("--rate", "10")["runs"]
        self.assertEqual(summed_twice(numbers(run["times"])), [100 * i for i in range(21)])
        x, y = (summed_twice(numbers(run[name])[:21]) for name in "xy")
        self.assertEqual(x, 21 * [3000])
        self.assertEqual(y, [10 * i for i in range(21)])
        # The van's centre is 3 m behind its front bumper.
        self.assertEqual(summed_twice(numbers(run["x"])[21:]), [700 + 80 * i for i in range(21)])
        self.assertEqual(summed(numbers(run["heading"])[:21]), 21 * [180], "half degrees")
        self.assertEqual(summed(numbers(run["speed"])[21:]), 21 * [800])
        self.assertEqual(run["persons"][0]["spans"], [[0, 21]])

    def test_rate(self):
        (run,) = self.data()["runs"]
        self.assertEqual(summed_twice(numbers(run["times"])), [200 * i for i in range(11)])
        (run,) = self.data("--rate", "3")["runs"]
        self.assertEqual(summed_twice(numbers(run["times"])), [400 * i for i in range(6)])
        self.assertEqual(summed_twice(numbers(run["y"])[:6]), [40 * i for i in range(6)])

    def test_a_pause_in_the_recording_is_one_in_the_animation(self):
        text = fcd()
        for i in range(6, 16):
            text = text.replace(f'<timestep time="{i / 10:.2f}">', "<gone>")
        text = re.sub(r"<gone>.*?</timestep>\n", "", text, flags=re.S)
        self.write("fcd.xml", text)
        (run,) = self.data("--rate", "10")["runs"]
        self.assertEqual([count for _, count in run["persons"][0]["spans"]], [6, 5])

    def test_activity(self):
        rows = "".join(f"{i / 10:.2f},p,{i / 10:.3f},0,1,0,0,{'waiting' if i > 4 else 'walking'},"
                       f"{'texting' if i > 8 else 'none'}\n" for i in range(20))
        self.write("t.csv", HEADER + rows)
        (run,) = self.data("--rate", "10", file="t.csv")["runs"]
        names = [(run["motions"][a], run["activities"][p])
                 for _, a, p in run["persons"][0]["changes"]]
        self.assertEqual(names, [("walking", "none"), ("waiting", "none"), ("waiting", "texting")])
        self.assertEqual([change[0] for change in run["persons"][0]["changes"]], [0, 5, 9])

    def test_who_does_not_move_stands(self):
        self.write("fcd.xml", fcd().replace('speed="1.00"', 'speed="0.00"'))
        (run,) = self.data()["runs"]
        ((_, motion, _),) = run["persons"][0]["changes"]
        self.assertEqual(run["motions"][motion], "standing")

    def test_compressed(self):
        with gzip.open(self.folder / "fcd.xml.gz", "wt") as file:
            file.write(fcd())
        self.assertEqual(self.data(file="fcd.xml.gz")["title"], "fcd")

    def test_beside(self):
        self.write("other.xml", fcd("q"))
        first, second = self.data("--beside", "other.xml", "--beside-name", "the other")["runs"]
        self.assertEqual([first["name"], second["name"]], ["fcd", "the other"])
        self.assertEqual([run["persons"][0]["id"] for run in (first, second)], ["p", "q"])

    def test_scenario(self):
        config = TinyScenario(self.folder).config()
        done = self.call("sumo", "-c", config, "--fcd-output", "fcd.xml", "--end", "60")
        self.assertEqual(done.returncode, 0, done.stderr)
        data = self.data("--scenario", config)
        self.assertEqual(data["title"], "tiny")
        (walkable,) = data["scenery"]["zone"]
        self.assertGreater(max(walkable[0][::2]) - min(walkable[0][::2]), 5000, "60 m of street")
        self.assertTrue(data["scenery"]["roads"])

    def test_roads_are_drawn_where_anybody_is(self):
        """Also far from the zones; where nobody goes near those, the picture has everybody, too."""
        tiny = TinyScenario(self.folder)
        tiny.write("a.zone.xml", '<zones><zone id="a" edges="east"/></zones>')
        for edges, left in (("west", 0), ("west shared east", 115)):
            tiny.write("tiny.rou.xml", f'<routes><person id="p" depart="0"><walk edges="{edges}"/>'
                       '</person></routes>')
            config = tiny.config()
            done = self.call("sumo", "-c", config, "--fcd-output", "fcd.xml")
            self.assertEqual(done.returncode, 0, done.stderr)
            data = self.data("--scenario", config, "--zone", "a.zone.xml")
            self.assertLess(min(x for lane in data["scenery"]["roads"] + data["scenery"]["footways"]
                                for x in lane["points"][::2]), 1000, "cm")
            self.assertAlmostEqual(data["box"][0], left, delta=10)

    def test_names_of_streets(self):
        edges = EDGES.replace('id="shared"', 'id="shared" name="Long &lt;b&gt; Lane"')
        edges = edges.replace('id="west"', 'id="west" name="West Street"')
        edges = edges.replace('id="east"', 'id="east" name="West Street"')
        config = TinyScenario(self.folder, edges, ("--output.street-names", "true")).config()
        done = self.call("sumo", "-c", config, "--fcd-output", "fcd.xml", "--end", "60")
        self.assertEqual(done.returncode, 0, done.stderr)
        streets = self.data("--scenario", config)["scenery"]["streets"]
        names = sorted(street["name"] for street in streets)
        # West Street's two parts do not meet: a line each.
        self.assertEqual(names, ["Long <b> Lane", "West Street", "West Street"])
        self.assertGreater(max(streets[0]["points"][::2]) - min(streets[0]["points"][::2]), 4000)

    # In one step

    def in_two_steps(self, config, *words, zone=()):
        done = self.call(PEDZONE, "run", config, *zone, "--trajectories", "two/t.csv", *words, "--",
                         "--fcd-output", self.folder / "two.fcd.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.call(PEDZONE, "animate", "two/t.csv", "--fcd", "two.fcd.xml", "--scenario",
                         config, *zone, "--name", "pedzone", "--out", "two.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / "two.html").read_bytes()

    def in_one_step(self, config, *words):
        scratch = self.folder / "scratch"
        scratch.mkdir(exist_ok=True)
        done = subprocess.run([PEDZONE, "run", str(config), "--animate", "one.html", *words],
                              cwd=self.folder, text=True, timeout=120, capture_output=True,
                              env={**sumo_environment(), "TMPDIR": str(scratch)},
                              stdin=subprocess.DEVNULL)
        self.assertEqual(list(scratch.iterdir()), [], "no file is left over")
        return done

    def test_run_animates_as_animate_does(self):
        config = TinyScenario(self.folder).config()
        done = self.in_one_step(config)
        self.assertEqual(done.returncode, 0, done.stderr)
        one = (self.folder / "one.html").read_bytes()
        self.assertEqual(one, self.in_two_steps(config))
        self.assertIn(b'"id":"p1"', one)

    def test_run_animates_beside_other_outputs(self):
        config = TinyScenario(self.folder).config()
        done = self.in_one_step(config, "--trajectories", "t.csv", "--", "--fcd-output", "own.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("t.csv", "own.xml", "one.html"):
            self.assertTrue((self.folder / name).exists(), name)
        self.assertEqual((self.folder / "one.html").read_bytes(), self.in_two_steps(config))

    def test_run_animates_whatever_else_is_said_of_outputs(self):
        config = TinyScenario(self.folder).config()
        self.assertEqual(self.in_one_step(config).returncode, 0)
        plain = (self.folder / "one.html").read_bytes()
        for words in (("--fcd-output.geo",), ("--fcd-output.attributes", "x,y"),
                      ("--device.fcd.probability", "0.1", "--person-device.fcd.explicit", "p0"),
                      ("--output-prefix", "mine_"), ("--human-readable-time",)):
            with self.subTest(words):
                (self.folder / "one.html").unlink()
                done = self.in_one_step(config, "--", *words)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual((self.folder / "one.html").read_bytes(), plain)

    def test_people_whom_only_sumo_walked(self):
        tiny = TinyScenario(self.folder)
        tiny.write("a.zone.xml", '<zones><zone id="a" edges="east"/></zones>')
        tiny.write("tiny.rou.xml", '<routes><person id="p" depart="0"><walk edges="west"/></person>'
                   '</routes>')
        config = tiny.config()
        done = self.call(PEDZONE, "run", config, "--zone", "a.zone.xml", "--trajectories", "t.csv", "--",
                         "--fcd-output", self.folder / "f.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.call(PEDZONE, "animate", "t.csv", "--fcd", "f.xml", "--scenario", config, "--zone",
                         "a.zone.xml", "--persons", "p", "--out", "a.html")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_run_without_anybody(self):
        tiny = TinyScenario(self.folder)
        tiny.write("tiny.rou.xml", "<routes/>")
        done = self.in_one_step(tiny.config())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("one.html is not written", done.stderr)
        self.assertFalse((self.folder / "one.html").exists())

    def test_run_refuses_floating_car_data_that_it_could_not_read(self):
        config = TinyScenario(self.folder).config()
        for words in (("--fcd-output", "stdout"), ("--fcd-output", "localhost:99"),
                      ("--fcd-output", "a.xml", "--output-prefix", "b"), ("--fcd-output", "NUL"),
                      ("--fcd-output", "a.xml", "--fcd-output.geo"),
                      ("--fcd-output", "a.xml", "--fcd-output.attributes", "x,y"),
                      ("--fcd-output.filter-edges.input-file", "west.txt")):
            done = self.in_one_step(config, "--", *words)
            self.check_refused(done, "fcd-output", "--animate")
            self.assertFalse((self.folder / "one.html").exists())

    def test_run_that_cannot_write_the_page(self):
        config = TinyScenario(self.folder).config()
        self.write("out", "a file, not a folder")
        done = self.call(PEDZONE, "run", config, "--animate", "out/a.html")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--animate", done.stderr)

    def test_hostile_ids(self):
        hostile = '</script><img src=x onerror="alert(1)">\n\'&\\<!--'
        entities = hostile.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
        self.write("fcd.xml", fcd(entities.replace("\n", "&#10;")))
        page = self.page("--title", hostile)
        self.assertNotIn("<img", page)
        self.assertEqual(page.count("</script>"), page.count("<script"))
        self.assertEqual(self.data("--title", hostile)["runs"][0]["persons"][0]["id"], hostile)
        self.assertEqual(self.data("--title", hostile)["title"], hostile)

    def test_the_same_again(self):
        self.assertEqual(self.page(), self.page())

    def test_nothing_from_elsewhere(self):
        self.assertEqual(re.findall(r"(?:https?:)?//[a-z]+\.[a-z]+|@import|url\(", self.page()), [])

    # Bad input

    def test_no_output_named(self):
        self.check_refused(self.call(PEDZONE, "animate", "fcd.xml"), "--out")

    def test_missing(self):
        self.check_refused(self.animate(file="gone.xml"), "gone.xml", "cannot be opened")
        self.check_refused(self.animate("--scenario", "gone.sumocfg"), "gone.sumocfg")
        self.check_refused(self.animate("--beside", "gone.xml"), "gone.xml")

    def test_empty(self):
        self.write("fcd.xml", "")
        self.check_refused(self.animate(), "fcd.xml", "empty")
        self.write("fcd.xml", "<fcd-export></fcd-export>")
        self.check_refused(self.animate(), "fcd.xml")

    def test_cut_off(self):
        self.write("fcd.xml", fcd()[:-20])
        self.check_refused(self.animate(), "fcd.xml:", "not well-formed")
        self.write("t.csv", HEADER + "0.00,p,1.000,2.0")
        self.check_refused(self.animate(file="t.csv"), "t.csv:2")
        data = gzip.compress(fcd(steps=500).encode())
        (self.folder / "fcd.xml.gz").write_bytes(data[:len(data) // 2])
        self.check_refused(self.animate(file="fcd.xml.gz"), "fcd.xml.gz")

    def test_not_ours(self):
        self.write("fcd.xml", "<tripinfos>\n</tripinfos>")
        self.check_refused(self.animate(), "fcd.xml:1", "tripinfos")
        self.write("t.csv", "a,b,c\n1,2,3\n")
        self.check_refused(self.animate(file="t.csv"), "t.csv:1", "time,id,x,y")

    def test_a_second_run_that_is_broken(self):
        self.write("other.xml", fcd().replace('y="0.30"', 'y="north"'))
        self.check_refused(self.animate("--beside", "other.xml"), "other.xml:", 'id="p"', "north")

    def test_too_far_away(self):
        self.write("fcd.xml", fcd().replace('x="30.00"', 'x="3e8"'))
        self.check_refused(self.animate(), "3000000", "too far away")

    def test_too_long(self):
        self.write("fcd.xml", fcd().replace('time="2.00"', 'time="3e6"'))
        self.check_refused(self.animate(), "too long", "--begin")

    def test_options(self):
        for words in (("--rate", "0"), ("--rate", "often"), ("--beside-fcd", "fcd.xml"),
                      ("--beside-name", "b")):
            self.check_refused(self.animate(*words), words[0])

    def test_output_that_cannot_be_written(self):
        self.write("out", "a file, not a folder")
        done = self.animate()
        self.assertEqual(done.returncode, 2)
        self.assertIn("--out", done.stderr)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
