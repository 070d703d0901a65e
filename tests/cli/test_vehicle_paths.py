#!/usr/bin/python3
"""Scripted vehicles: that they are exactly where the file says, and what is refused.

usage: test_vehicle_paths.py PEDZONE_PROGRAM
"""

import bisect
import math
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyCase

PEDZONE = None  # set from the command line
EXACT = 0.01    # [m]

# The shared street leads from (60, 0) to (120, 0) and is 8 m wide; the vehicle's lane is beside it.
ROUTES = """<routes>
<vType id="car" length="4" width="1.8"/>
<person id="p0" depart="0"><walk edges="west shared east"/></person>
<person id="p1" depart="0"><walk edges="shared" departPos="5" arrivalPos="50"/></person>
<vehicle id="av" type="car" depart="{depart}"><route edges="west shared east"/></vehicle>
<flow id="cars" type="car" begin="10" end="105" period="30"><route edges="west shared east"/></flow>
</routes>"""

ZONES = """<zones>
<zone id="z"/>
{paths}</zones>"""
ONE = '<vehiclePath vehicle="av" file="paths/av.csv"/>\n'

# Off the road to begin with, a rest, a corner in the street, faster than its type may, off again.
ROWS = [(10.2, 70.0, 30.0), (20.0, 70.0, 10.0), (24.0, 70.0, 10.0), (30.0, 70.0, -1.0),
        (60.0, 105.0, 1.5), (62.0, 150.0, 1.0), (65.3, 150.0, 20.0)]


def text_of(rows):
    return "t,x,y\n" + "".join(f"{t},{x},{y}\n" for t, x, y in rows)


def place(rows, time):
    """(x, y) and direction [deg clockwise from north] where it moves straight."""
    k = min(max(bisect.bisect_right([row[0] for row in rows], time), 1), len(rows) - 1)
    (t0, x0, y0), (t1, x1, y1) = rows[k - 1], rows[k]
    share = (time - t0) / (t1 - t0)
    return x0 + share * (x1 - x0), y0 + share * (y1 - y0)


class VehiclePaths(RefusalChecks, TinyCase):
    def setUp(self):
        super().setUp()
        (self.folder / "paths").mkdir()

    def run_path(self, csv=text_of(ROWS), paths=ONE, depart="10", words=(), zones=ZONES):
        """`pedzone run` with outputs into out/; returns the finished process."""
        self.tiny.config()
        self.tiny.write("tiny.rou.xml", ROUTES.format(depart=depart))
        self.tiny.write("tiny.zone.xml", zones.format(paths=paths))
        if csv is not None:
            (self.folder / "paths/av.csv").write_text(csv)
        return subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", "--zone", "tiny.zone.xml", "--trajectories",
             "out/trajectories.csv", *words, "--", "--fcd-output", "fcd.xml", "--precision", "4",
             "--tripinfo-output", "trips.xml"],
            cwd=self.folder, text=True, capture_output=True, timeout=120)

    def seen(self, vehicle="av"):
        """[(time, x, y, angle)] in SUMO's own output."""
        return [(float(step.get("time")), *(float(node.get(key)) for key in ("x", "y", "angle")))
                for step in ET.parse(self.folder / "fcd.xml").iter("timestep")
                for node in step.iter("vehicle") if node.get("id") == vehicle]

    def check_exact(self, rows, vehicle="av"):
        steered = [row for row in self.seen(vehicle) if rows[0][0] <= row[0] <= rows[-1][0]]
        times = [row[0] for row in steered]
        first = math.ceil(rows[0][0] * 2)
        last = math.floor(rows[-1][0] * 2)
        self.assertEqual(times, [k / 2 for k in range(first, last + 1)])
        for time, x, y, _ in steered:
            self.assertLess(math.dist((x, y), place(rows, time)), EXACT, time)
        return steered

    # What works

    def test_is_where_the_file_says(self):
        done = self.run_path()
        self.assertEqual(done.returncode, 0, done.stderr)
        steered = self.check_exact(ROWS)
        # It left after the last row, as one that arrived.
        self.assertLessEqual(self.seen()[-1][0], ROWS[-1][0])
        trip = next(t for t in ET.parse(self.folder / "trips.xml").iter("tripinfo")
                    if t.get("id") == "av")
        self.assertGreaterEqual(float(trip.get("arrival")), ROWS[-1][0])
        angles = {time: angle for time, _, _, angle in steered}
        self.assertAlmostEqual(angles[15.0], 180.0, delta=0.1)  # south
        self.assertAlmostEqual(angles[22.0], 180.0, delta=0.1)  # rests
        expected = 90.0 - math.degrees(math.atan2(2.5, 35.0))
        self.assertAlmostEqual(angles[50.0], expected, delta=0.1)
        # 60 degrees a second at most at the corner, where it drives at 1.2 to 1.8 m/s.
        turns = [abs(math.remainder(b[3] - a[3], 360.0)) for a, b in zip(steered, steered[1:])
                 if b[0] < 55.0]
        self.assertLess(max(turns), 30.0)
        self.assertGreater(max(turns), 5.0)

    def test_everybody_else_arrives(self):
        self.assertEqual(self.run_path().returncode, 0)
        trips = ET.parse(self.folder / "trips.xml").getroot()
        self.assertEqual({p.get("id") for p in trips.iter("personinfo")}, {"p0", "p1"})
        self.assertEqual(sum(t.get("id").startswith("cars") for t in trips.iter("tripinfo")), 4)

    def walk(self, rows):
        """time -> y [m] of p1."""
        done = self.run_path(text_of(rows))
        self.assertEqual(done.returncode, 0, done.stderr)
        file = self.folder / "out/trajectories.csv"
        walk = [row.split(",") for row in file.read_text().splitlines()[1:]]
        file.unlink()
        return {float(row[0]): float(row[3]) for row in walk if row[1] == "p1"}

    def test_people_make_way(self):
        """It comes towards p1 on the line on which p1 walks while it stays away."""
        free = self.walk([(11, 110, 30), (60, 60, 30)])
        met = self.walk([(11, 110, free[20.0]), (60, 60, free[20.0])])
        self.assertGreater(max(abs(met[t] - free[t]) for t in met if t in free), 1.0)

    def test_departs_by_its_path(self):
        """Its own departure may be earlier: until the first row SUMO drives it."""
        done = self.run_path(depart="0")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_exact(ROWS)
        self.assertEqual(self.seen()[0][0], 0.0)

    def test_from_the_second_step(self):
        rows = [(0.5, 70.0, 1.0), (30.0, 110.0, 1.0)]
        self.assertEqual(self.run_path(text_of(rows), depart="0").returncode, 0)
        self.check_exact(rows)

    def test_two_of_them_and_one_of_a_flow(self):
        (self.folder / "paths/other.csv").write_text(text_of([(50, 80, 5), (70, 110, 5)]))
        done = self.run_path(paths=ONE + '<vehiclePath vehicle="cars.1" file="paths/other.csv"/>\n')
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_exact(ROWS)
        self.check_exact([(50, 80, 5), (70, 110, 5)], "cars.1")

    def test_absolute_file_and_windows_lines(self):
        (self.folder / "av.csv").write_bytes(b"t,x,y\r\n1,70,0\r\n9,80,0\r\n")
        path = f'<vehiclePath vehicle="av" file="{self.folder}/av.csv"/>\n'
        done = self.run_path(None, path, depart="0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_exact([(1, 70, 0), (9, 80, 0)])

    def test_same_bits_for_any_number_of_threads(self):
        texts = []
        for threads in ("1", "2"):
            self.assertEqual(self.run_path(words=("--threads", threads)).returncode, 0)
            texts.append((self.folder / "out/trajectories.csv").read_bytes())
        self.assertEqual(*texts)

    # What is refused

    def test_missing_file(self):
        self.check_refused(self.run_path(None), "tiny.zone.xml:3: <vehiclePath> attribute file",
                           "'paths/av.csv' does not exist", "allowed: a CSV file")

    def test_folder_for_a_file(self):
        path = '<vehiclePath vehicle="av" file="paths"/>\n'
        self.check_refused(self.run_path(None, path), "tiny.zone.xml:3", "'paths' does not exist")

    def test_headers(self):
        for header in ("", "x,y,t", "t,x", "t;x;y", "0,1,2"):
            self.check_refused(self.run_path(header + "\n1,2,3\n2,3,4\n"), "paths/av.csv:1:",
                               "is another header", "allowed: t,x,y")
        self.check_refused(self.run_path(""), "paths/av.csv:1:", "is empty", "t,x,y")

    def test_numbers(self):
        for row, column, value in (("2,north,0", "x", "north"), ("2,1,nan", "y", "nan"),
                                   ("two,1,1", "t", "two"), ("2,,0", "x", ""),
                                   ("-1,0,0", "t", "-1"), ("2,1e99,0", "x", "1e99")):
            self.check_refused(self.run_path(f"t,x,y\n1,0,0\n{row}\n"),
                               f"paths/av.csv:3: column {column}", value, "allowed: ")

    def test_rows_of_another_length(self):
        for row in ("2,1", "2,1,1,1", "2", ""):
            self.check_refused(self.run_path(f"t,x,y\n1,0,0\n{row}\n"), "paths/av.csv:3:",
                               f"has {row.count(',') + 1} fields", "allowed: 3 fields: t,x,y")
        self.check_refused(self.run_path("t,x,y\n1,0,0\n2,5"), "paths/av.csv:3:", "is cut off")

    def test_times_that_do_not_increase(self):
        for time in ("1", "0.5"):
            self.check_refused(self.run_path(f"t,x,y\n1,0,0\n{time},5,0\n"),
                               "paths/av.csv:3: column t", f"'{time}' is not later",
                               "allowed: increasing times")

    def test_too_few_rows(self):
        for rows in ("", "1,0,0\n", "1,0,0\n2,0,0\n"):
            self.check_refused(self.run_path("t,x,y\n" + rows), "paths/av.csv",
                               "does not lead anywhere", "allowed: two or more")

    def test_unknown_vehicle(self):
        for vehicle in ("va", "cars", "cars.", "cars.x", "p0", "car"):
            path = f'<vehiclePath vehicle="{vehicle}" file="paths/av.csv"/>\n'
            self.check_refused(self.run_path(paths=path),
                               "tiny.zone.xml:3: <vehiclePath> attribute vehicle",
                               f"'{vehicle}' is no vehicle of the scenario", "allowed: ")

    def test_hostile_name(self):
        path = '<vehiclePath vehicle="&lt;a&#10;&quot;&gt;" file="paths/av.csv"/>\n'
        self.check_refused(self.run_path(paths=path), "tiny.zone.xml:3", "is no vehicle")

    def test_two_paths_of_one_vehicle(self):
        self.check_refused(self.run_path(paths=ONE + ONE), "tiny.zone.xml:4: <vehiclePath",
                           "'av' has a path already", "allowed: one path a vehicle")

    def test_attributes(self):
        for path, *fragments in (('<vehiclePath vehicle="av"/>', "attribute file"),
                                 ('<vehiclePath file="paths/av.csv"/>', "attribute vehicle"),
                                 ('<vehiclePath vehicle="av" file="paths/av.csv" speed="3"/>',
                                  "speed")):
            self.check_refused(self.run_path(paths=path), "tiny.zone.xml:3", *fragments)

    def test_not_departed_by_its_first_row(self):
        for depart in ("1", "9", "900"):
            done = self.run_path(text_of([(1, 70, 30), (9, 80, 30)]), depart=depart)
            self.check_refused(done, "tiny.zone.xml:3: <vehiclePath> attribute vehicle",
                               "'av' is not under way at the first row",
                               "allowed: vehicles that depart a step before")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
