#!/usr/bin/python3
"""`pedzone conflicts` and `pedzone run --conflict-output`: what they write, that both say the same of
a run, and every kind of bad input.

usage: test_conflicts.py PEDZONE_PROGRAM
"""

import csv
import gzip
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyScenario, sumo_environment

PEDZONE = None  # set from the command line

# A car drives east at 8 m/s; a person stands in its way, 12 m ahead of it at the last step.
STEP = """<timestep time="{time:.2f}">
  <vehicle id="car" x="{x:.2f}" y="0.00" angle="90.00" type="van" speed="8.00"/>
  <person id="{person}" x="30.00" y="0.00" angle="0.00" speed="0.00"/></timestep>
"""
TYPES = '<routes><vType id="van" length="6" width="2"/></routes>'


def fcd(person="p", steps=10):
    return "<fcd-export>\n" + "".join(
        STEP.format(time=0.1 * i, x=10 + 0.8 * i, person=person) for i in range(steps)
    ) + "</fcd-export>\n"


class Conflicts(RefusalChecks, unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = Path(self.directory.name)
        self.write("types.rou.xml", TYPES)
        self.write("fcd.xml", fcd())

    def tearDown(self):
        self.directory.cleanup()

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def call(self, *words):
        return subprocess.run(list(map(str, words)), cwd=self.folder, text=True,
                              capture_output=True, timeout=120, env=sumo_environment())

    def measure(self, *words, file="fcd.xml"):
        return self.call(PEDZONE, "conflicts", file, "--vtypes", "types.rou.xml",
                         "--conflict-output", "out/c.xml", "--conflict-csv", "out/c.csv", *words)

    def conflicts(self):
        return ET.parse(self.folder / "out/c.xml").getroot().findall("conflict")

    def rows(self, name="out/c.csv"):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    # What is written

    def test_measures(self):
        done = self.measure()
        self.assertEqual(done.returncode, 0, done.stderr)
        (conflict,) = self.conflicts()
        # At the last step the front is at 17.2 m; the person's disc begins at 30 - 0.239 m.
        ttc = (30 - 0.239 - 17.2) / 8
        self.assertEqual(conflict.get("person"), "p")
        self.assertEqual(conflict.get("vehicle"), "car")
        self.assertIsNone(conflict.get("aware"), "not known")
        self.assertAlmostEqual(float(conflict.find("minTTC").get("value")), ttc, delta=0.01)
        self.assertEqual(conflict.find("minTTC").get("time"), "0.90")
        self.assertAlmostEqual(float(conflict.find("maxDRAC").get("value")), 8 / 2 / ttc, delta=0.03)
        self.assertAlmostEqual(float(conflict.find("PCT").get("value")), ttc + 0.9, delta=0.01)
        self.assertIsNone(conflict.find("contact"))
        (row,) = self.rows()
        self.assertEqual(row["minTTC"], conflict.find("minTTC").get("value"))
        self.assertEqual(row["contact"], "")

    def test_people_of_a_distribution_are_as_large_as_the_type_that_they_got(self):
        types = """<routes><vType id="van" length="6" width="2"/>
            <vTypeDistribution id="all"><vType id="adult" vClass="pedestrian"/>
              <vType id="pram" vClass="pedestrian" width="0.9" length="0.8"/></vTypeDistribution>
            {}<walk edges="a"/></{}></routes>"""
        self.write("types.rou.xml", types.format('<person id="p" type="all" depart="0">', "person"))

        def contact_in(*words):
            done = self.measure(*words)
            self.assertEqual(done.returncode, 0, done.stderr)
            return float(self.rows()[0]["minTTC"]), done.stderr
        guessed, errors = contact_in()
        self.assertIn("vTypeDistribution 'all'", errors)
        self.assertAlmostEqual(guessed, (30 - 0.239 - 17.2) / 8, delta=0.01)
        for name, text in (("trips.xml", '<tripinfos><personinfo id="p" type="pram"/></tripinfos>'),
                           ("routes.xml", '<routes><person id="p" type="pram"/></routes>')):
            self.write(name, text)
            known, errors = contact_in("--vtypes", name)
            self.assertNotIn("vTypeDistribution", errors)
            self.assertAlmostEqual(known, (30 - 0.479 - 17.2) / 8, delta=0.01)
        # Of a flow's persons SUMO names each.
        self.write("fcd.xml", fcd("f.0"))
        self.write("types.rou.xml", types.format('<personFlow id="f" type="all" begin="0" end="9"'
                                                 ' period="3">', "personFlow"))
        self.assertIn("vTypeDistribution 'all'", contact_in()[1])
        self.write("routes.xml", '<routes><person id="f.0" type="pram"/></routes>')
        known, errors = contact_in("--vtypes", "routes.xml")
        self.assertNotIn("vTypeDistribution", errors)
        self.assertAlmostEqual(known, (30 - 0.479 - 17.2) / 8, delta=0.01)

    def test_long_steps_are_warned_of(self):
        for seconds, warned in ((0.1, False), (2, False), (5, True)):
            self.write("fcd.xml", "<fcd-export>" + "".join(
                STEP.format(time=seconds * i, x=10 + i, person="p") for i in range(10))
                + "</fcd-export>")
            done = self.measure()
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("has a step of 5 s" in done.stderr, warned, done.stderr)

    def test_compressed(self):
        with gzip.open(self.folder / "fcd.xml.gz", "wt") as file:
            file.write(fcd())
        self.assertEqual(self.measure(file="fcd.xml.gz").returncode, 0)
        self.assertEqual(len(self.conflicts()), 1)

    def test_hostile_ids(self):
        self.write("fcd.xml", fcd("&lt;a b=&quot;1&quot;,&#10;&amp;c&gt;"))
        self.assertEqual(self.measure().returncode, 0)
        self.assertEqual(self.conflicts()[0].get("person"), '<a b="1",\n&c>')
        self.assertEqual(self.rows()[0]["person"], '<a b="1",\n&c>')

    def test_limits(self):
        self.assertEqual(self.measure("--conflict-ttc", "1", "--conflict-drac", "9").returncode, 0)
        self.assertEqual(self.conflicts(), [])

    def test_vehicles_as_persons(self):
        text = fcd().replace('<person id="p"', '<vehicle id="p" type="chair"')
        self.write("fcd.xml", text)
        self.write("types.rou.xml", TYPES.replace(
            "</routes>", '<vType id="chair" length="1" width="0.6"/></routes>'))
        self.assertEqual(self.measure("--treat-as-person", "chair").returncode, 0)
        self.assertEqual(self.conflicts()[0].get("person"), "p")

    def test_both_commands_tell_of_whom_pedzone_walks_unless_all_are_asked_for(self):
        """People walk through the shared street; SUMO walks them on the crossing streets."""
        config = self.crowded_street()
        tables = {}
        for of in ("zones", "all"):
            done = self.call(PEDZONE, "run", config, "--conflicts-of", of, "--conflict-csv",
                             "run.csv", "--trajectories", "walked.csv", "--",
                             "--fcd-output", "run.fcd.xml", "--precision", "4", "--step-length",
                             "0.1", "--default.action-step-length", "0.1")
            self.assertEqual(done.returncode, 0, done.stderr)
            done = self.call(PEDZONE, "conflicts", "run.fcd.xml", "--scenario", config,
                             "--trajectories", "walked.csv", "--conflicts-of", of,
                             "--conflict-csv", "fcd.csv")
            self.assertEqual(done.returncode, 0, done.stderr)
            whose = "everybody" if of == "all" else "people whom pedzone walked"
            self.assertIn(f"conflicts of {whose}", done.stdout)
            tables[of] = [{(row["person"], row["vehicle"]): row for row in self.rows(name)}
                          for name in ("run.csv", "fcd.csv")]
        found = tables["zones"][1]

        def taken_over(pair):
            at = found[pair]["minTTC_time"] if pair in found else ""
            return at != "" and abs(float(at) - walked[pair[0]]) < 0.15
        tables = {of: [set(rows) for rows in both] for of, both in tables.items()}
        (run, measured), (run_all, measured_all) = tables["zones"], tables["all"]
        self.assertGreater(len(run), 5)
        walked = {}
        for row in self.rows("walked.csv"):
            walked.setdefault(row["id"], float(row["time"]))
        self.assertLessEqual({person for person, _ in run | measured}, set(walked))
        self.assertGreater(len({person for person, _ in measured_all} - set(walked)), 0)
        self.assertLess(len(run - measured), 0.2 * len(run))
        # A few pairs are at a limit: by directions, which the file does not have. When pedzone takes
        # somebody over the file has the direction of the step before, that of SUMO.
        self.assertLess(len({pair for pair in run ^ measured if not taken_over(pair)}),
                        0.35 * len(run))
        self.assertLess(run, run_all)
        self.assertLess(measured, measured_all)

    def test_without_trajectories_everybody_counts_and_that_is_said(self):
        self.write("fcd.xml", fcd())
        done = self.measure()
        self.assertRegex(done.stdout, r"^\d+ conflicts of everybody in the file\n$")

    def crowded_street(self):
        tiny = TinyScenario(self.folder)
        demand = '<vType id="van" length="6" width="2" maxSpeed="4"/>'
        for i in range(360):
            way = 'from="west" to="east"' if i % 2 else 'from="east" to="west"'
            demand += f'<person id="p{i}" depart="{i}"><walk {way}/></person>'
            if i % 12 == 10:
                demand += (f'<vehicle id="v{i}" type="van" depart="{i}">'
                           '<route edges="west shared east"/></vehicle>')
        tiny.write("tiny.rou.xml", f"<routes>{demand}</routes>")
        return tiny.config()

    def test_run_and_its_floating_car_data_say_the_same(self):
        config = self.crowded_street()
        everything = ("--conflict-ttc", "60", "--conflict-pet", "60",  # no pair at a limit's edge
                      "--conflicts-of", "all")
        done = self.call(PEDZONE, "run", config, "--conflict-csv", "run.csv", *everything, "--",
                         "--fcd-output", "run.fcd.xml", "--precision", "4", "--step-length", "0.1",
                         "--default.action-step-length", "0.1", "--end", "500")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.call(PEDZONE, "conflicts", "run.fcd.xml", "--scenario", config,
                         "--conflict-csv", "fcd.csv", *everything)
        self.assertEqual(done.returncode, 0, done.stderr)
        run, measured = ({(row["person"], row["vehicle"]): row for row in self.rows(name)}
                         for name in ("run.csv", "fcd.csv"))
        # A run sees who is near the zone: the shared street, from x = 60 to 120 m.
        # At its very ends one of the two sees them no more.
        def within(row, name, most, end=3):
            return (row[name] and float(row[name]) < most
                    and 60 + end < float(row[f"{name}_x"]) < 120 - end)
        pairs = [pair for pair, row in run.items() if within(row, "minClearance", 1000, end=10)
                 and (within(row, "minTTC", 4) or within(row, "PET", 4))]
        self.assertGreater(len(pairs), 30)
        # A time to collision hangs on a direction, which the file does not have: of those who stand
        # about in the jam some come to one for a single frame only. A PET hangs on places.
        both = [pair for pair in pairs if pair in measured]
        self.assertEqual([pair for pair in pairs if within(run[pair], "PET", 4) and pair not in both], [])
        self.assertGreater(len(both), 0.95 * len(pairs))
        self.assertIn("true", {run[pair]["aware"] for pair in pairs})
        # Places are the same; directions are estimated from the way gone, so that some pairs fall on
        # another side of what counts as the same way, or have their extreme at another moment.
        # Who stands beside a vehicle for most of a minute has a PET of 10 s and more, of a moment that
        # may be another here and there: that is no conflict.
        # A time to collision hangs on a direction, and people turn often since they take Eq. 1 among
        # people (its 80th percentile is 0.23 s with SUMO 1.15 and 0.38 s with 1.18).
        # Of those who crawl past each other with 0.1 m between them it may be a second: a quarter here.
        for name, tolerance, share in (("minClearance", 0.02, 0.8), ("PET", 0.1, 0.8), ("minTTC", 0.45, 0.7),
                                       ("maxDRAC", 0.2, 0.8)):
            differences = []
            for pair in both:
                a, b = run[pair][name], measured[pair][name]
                if a and b and max(float(a), float(b)) < 10.0:
                    differences.append(abs(float(a) - float(b)))
            differences.sort()
            self.assertGreaterEqual(len(differences), 8)
            self.assertLess(differences[int(len(differences) * share)], tolerance, name)

    # Bad input

    def test_no_output_asked_for(self):
        self.check_refused(self.call(PEDZONE, "conflicts", "fcd.xml"), "--conflict-output")

    def test_missing_file(self):
        self.check_refused(self.measure(file="gone.xml"), "gone.xml", "cannot be opened")

    def test_no_xml(self):
        self.write("fcd.xml", "time,id,x,y\n0,p,1,2\n")
        self.check_refused(self.measure(), "fcd.xml:1", "not well-formed")

    def test_another_output(self):
        self.write("fcd.xml", "<tripinfos>\n</tripinfos>")
        self.check_refused(self.measure(), "fcd.xml:1", "tripinfos", "fcd-export")

    def test_broken_off(self):
        self.write("fcd.xml", fcd()[:-20])
        self.check_refused(self.measure(), "fcd.xml:", "not well-formed")

    def test_compressed_and_broken_off(self):
        data = gzip.compress(fcd(steps=500).encode())
        (self.folder / "fcd.xml.gz").write_bytes(data[:len(data) // 2])
        self.check_refused(self.measure(file="fcd.xml.gz"), "fcd.xml.gz")

    def test_no_number(self):
        self.write("fcd.xml", fcd().replace('y="0.00" angle="90.00"', 'y="north" angle="90.00"', 1))
        self.check_refused(self.measure(), "fcd.xml:3", 'id="car"', "y", "north", "number")

    def test_out_of_range(self):
        self.write("fcd.xml", fcd().replace('angle="0.00"', 'angle="1000"', 1))
        self.check_refused(self.measure(), "fcd.xml:4", 'id="p"', "angle", "1000", "-360 to 360")

    def test_missing_attribute(self):
        self.write("fcd.xml", fcd().replace(' speed="8.00"', ""))
        self.check_refused(self.measure(), "fcd.xml:3", "speed", "missing")

    def test_time_runs_backwards(self):
        self.write("fcd.xml", fcd().replace('time="0.50"', 'time="0.30"'))
        self.check_refused(self.measure(), "fcd.xml:17", "time", "0.30", "not later")

    def test_one_id_twice_in_a_step(self):
        self.write("fcd.xml", fcd().replace('<person id="p"', '<vehicle type="van" id="car"', 1))
        self.check_refused(self.measure(), "fcd.xml:4", "car", "twice")

    def test_unknown_type(self):
        self.write("types.rou.xml", "<routes/>")
        self.check_refused(self.measure(), "fcd.xml:3", 'id="car"', "type", "van", "--vtypes")

    def test_bad_size(self):
        self.write("types.rou.xml", TYPES.replace('"6"', '"long"'))
        self.check_refused(self.measure(), "types.rou.xml:1", 'id="van"', "length", "long")

    def test_unknown_type_as_person(self):
        self.check_refused(self.measure("--treat-as-person", "chair"), "--treat-as-person", "chair")

    def test_missing_scenario(self):
        self.check_refused(self.measure("--scenario", "gone.sumocfg"), "gone.sumocfg")

    def test_limit_out_of_range(self):
        done = self.measure("--conflict-ttc", "-1")
        self.check_refused(done, "--conflict-ttc")

    def test_output_that_cannot_be_written(self):
        self.write("out", "a file, not a folder")
        done = self.measure()
        self.assertEqual(done.returncode, 2)
        self.assertIn("--conflict-output", done.stderr)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
