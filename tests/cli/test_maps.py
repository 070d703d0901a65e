#!/usr/bin/python3
"""`pedzone maps`: densities, levels of service, speeds and conflicts of recordings that are made
here, so that every number is known; and bad input.

usage: test_maps.py PEDZONE_PROGRAM
"""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyScenario, sumo_environment

PEDZONE = None  # set from the command line

TYPES = '<routes><vType id="van" length="6" width="2"/></routes>'


def fcd(rows, seconds):
    """`rows`: what XML a second has."""
    return "<fcd-export>" + "".join(f'<timestep time="{t}">{rows(t)}</timestep>'
                                    for t in range(seconds)) + "</fcd-export>"


def person(name, x, y, speed):
    return f'<person id="{name}" x="{x}" y="{y}" angle="90" speed="{speed}"/>'


def crowd(t):
    """Four stand in one cell of 2 m for the second minute only, one walks east at 1 m/s."""
    rows = person("walker", -40 + t * 0.5, 20.5, 0.5)
    if 60 <= t < 120:
        rows += "".join(person(f"p{i}", 4.2 + 0.4 * i, 4.5, 0) for i in range(4))
    return rows


class Maps(RefusalChecks, unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        self.write("types.rou.xml", TYPES)
        self.write("crowd.xml", fcd(crowd, 181))

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def maps(self, *words, file="crowd.xml"):
        return subprocess.run([PEDZONE, "maps", file, "--vtypes", "types.rou.xml", *map(str, words)],
                              cwd=self.folder, text=True, timeout=120, capture_output=True,
                              env=sumo_environment(), stdin=subprocess.DEVNULL)

    def numbers(self, *words, file="crowd.xml"):
        done = self.maps("--json", *words, file=file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def page(self, *words, file="crowd.xml"):
        done = self.maps("--out", "out/maps.html", *words, file=file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / "out/maps.html").read_text()

    def test_the_peak_minute_and_its_level_of_service(self):
        found = self.numbers()
        self.assertEqual(found["persons"], 5)
        self.assertEqual(found["peak_minute"]["begin_s"], 60)
        # Four persons on 4 m² for the whole minute: Fruin's level D, 0.72 to 1.08.
        self.assertAlmostEqual(found["peak"]["density_per_m2"], 1.0, delta=1e-6)
        self.assertEqual(found["peak"]["level_of_service"], "D")
        self.assertEqual((found["peak"]["x_m"], found["peak"]["y_m"]), (5, 5))
        self.assertEqual(found["peak_minute"]["area_m2"]["D"], 4)
        self.assertEqual(found["peak_minute"]["area_m2"]["F"], 0)

    def test_the_last_minute_counts_though_it_is_no_whole_one(self):
        def rows(t):  # four on 4 m² for the last 30 of 100 s
            return person("walker", -40 + t * 0.5, 20.5, 0.5) + "".join(
                person(f"p{i}", 4.2 + 0.4 * i, 4.5, 0) for i in range(4) if t >= 70)
        self.write("late.xml", fcd(rows, 100))
        found = self.numbers(file="late.xml")
        self.assertEqual((found["begin_s"], found["end_s"]), (0, 100))
        self.assertEqual(found["peak_minute"]["begin_s"], 40)
        self.assertAlmostEqual(found["peak"]["density_per_m2"], 0.5, delta=1e-6)

    def test_densities_are_of_the_whole_run(self):
        def rows(t):  # one stands there for 50 of 200 s
            return person("p", 4.5, 4.5, 0) if 20 <= t < 70 else ""
        self.write("few.xml", fcd(rows, 200))
        found = self.numbers(file="few.xml")
        self.assertEqual((found["begin_s"], found["end_s"]), (0, 200))
        self.assertAlmostEqual(found["mean_density_per_m2"], 50 / 200 / 4, delta=1e-4)
        found = self.numbers("--begin", 10, "--end", 109, file="few.xml")
        self.assertEqual((found["begin_s"], found["end_s"]), (10, 110))
        self.assertAlmostEqual(found["mean_density_per_m2"], 50 / 100 / 4, delta=1e-4)

    def test_percentiles_are_of_persons(self):
        found = self.numbers()
        self.assertEqual(found["time_in_picture_s"]["median"], 59)
        # The fifth of five is the 100th percentile: between 59 and 180 s.
        self.assertAlmostEqual(found["time_in_picture_s"]["p95"], 59 + 0.8 * 121, delta=1e-6)

    def test_shown_area_only(self):
        found = self.numbers("--area", 0, 0, 10, 10)
        self.assertEqual(found["persons"], 4)

    def test_somebody_far_away_hides_no_crowd(self):
        def rows(t):
            return crowd(t) + person("far", 1500, 900, 0)
        self.write("far.xml", fcd(rows, 181))
        found = self.numbers(file="far.xml")
        self.assertAlmostEqual(found["peak"]["density_per_m2"], 1.0, delta=1e-6)
        self.assertEqual(found["peak_minute"]["area_m2"]["D"], 4)
        self.assertIn("Cells of ", self.page(file="far.xml"))

    def test_page_shows_all_maps(self):
        page = self.page("--title", "a <b>")
        for name in ("mean", "service", "speed", "paths", "conflicts"):
            self.assertIn(f'<figure id="{name}">', page)
        self.assertIn("a &lt;b&gt;", page)
        self.assertIn("D: 0.72 to 1.08", page)
        # As many ways as persons who move.
        paths = page[page.index('id="paths"'):page.index('id="conflicts"')]
        self.assertEqual(len(re.findall('<path d="M[^"]*"/>', paths)), 5)

    def test_the_same_again(self):
        self.assertEqual(self.page(), self.page())

    def test_conflicts_by_severity(self):
        def meeting(gap):
            # A van drives east at 5 m/s along y = 0; a person crosses its way.
            def rows(t):
                van = (f'<vehicle id="van.0" x="{5 * t - 47}" y="0" angle="90" type="van" '
                       f'speed="5"/>')
                return van + (f'<person id="&lt;p&gt;" x="{gap}" y="{t - 10}" angle="0" '
                              f'speed="1"/>')
            return rows
        self.write("far.xml", fcd(meeting(400), 21))
        self.assertEqual(self.numbers("--area", -60, -20, 450, 20, file="far.xml")["conflicts"],
                         {"slight": 0, "serious": 0, "contacts": 0})
        self.write("hit.xml", fcd(meeting(0), 21))
        found = self.numbers("--area", -60, -20, 60, 20, file="hit.xml")["conflicts"]
        self.assertEqual(found["contacts"], 1, found)
        elsewhere = self.numbers("--area", -20, 5, 20, 45, file="hit.xml")["conflicts"]
        self.assertEqual(elsewhere["contacts"], 0, elsewhere)
        page = self.page("--area", -60, -20, 60, 20, file="hit.xml")
        self.assertIn("<title>&lt;p&gt; and van.0 at ", page)
        self.assertNotIn("<p> and", page)

    def test_trajectories_alone_have_no_conflicts(self):
        rows = "".join(f"{t}.00,p,{t},0,1,0,0,walking,none\n" for t in range(30))
        self.write("t.csv", "time,id,x,y,vx,vy,heading,motion,activity\n" + rows)
        self.assertNotIn("conflicts", self.numbers(file="t.csv"))
        self.assertNotIn('id="conflicts"', self.page(file="t.csv"))

    def test_fundamental_diagram(self):
        """A lattice of persons 1 m apart who all walk at 0.8 m/s: 1 person/m², 0.8 1/(m·s)."""
        def rows(t):
            return "".join(person(f"p{i}.{k}", i + 0.8 * t - 20, k, 0.8)
                           for i in range(40) for k in range(-6, 7))
        self.write("lattice.xml", fcd(rows, 5))
        moments = self.numbers("--measure-area", -2, -2, 2, 2,
                               file="lattice.xml")["fundamental_diagram"]
        self.assertEqual(len(moments), 5)
        for moment in moments:
            self.assertAlmostEqual(moment["density_per_m2"], 1.0, delta=0.01)
            self.assertAlmostEqual(moment["speed_mps"], 0.8, delta=1e-6)
            self.assertAlmostEqual(moment["flow_per_ms"], 0.8, delta=0.01)
        page = self.page("--measure-area", -2, -2, 2, 2, file="lattice.xml")
        self.assertIn('id="diagram"', page)
        self.assertIn("5 points", page)

    def test_scenario(self):
        config = TinyScenario(self.folder).config()
        subprocess.run(["sumo", "-c", config, "--fcd-output", "fcd.xml", "--end", "100"],
                       cwd=self.folder, check=True, capture_output=True, env=sumo_environment())
        page = self.page("--scenario", config, file="fcd.xml")
        self.assertIn('id="ground"', page)

    # Bad input

    def test_nothing_asked_for(self):
        self.check_refused(self.maps(), "--out or --json")

    def test_areas(self):
        for option in ("--area", "--measure-area"):
            self.check_refused(self.maps(option, 5, 0, 1, 1, "--json"), option, "LEFT < RIGHT")
        self.check_refused(self.maps("--area", 1000, 1000, 1010, 1010, "--out", "out/a.html"),
                           "--area", "nobody")

    def test_missing(self):
        self.check_refused(self.maps("--out", "out/a.html", file="gone.xml"), "gone.xml")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
