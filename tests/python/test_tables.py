"""Tables of runs and studies, against Python's own reader of CSV.

    test_tables.py PEDZONE SCENARIOS
"""
import csv
import gzip
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

import pedzone

PEDZONE, SCENARIOS = None, None
STUDY = """<study seeds="1-2" end="40" models="striping heuristic">
  <scenario file="{scenario}"/>
  <factor id="sight" parameter="sight" values="8 12"/>
</study>
"""


def rows_of(file):
    opened = gzip.open(file, "rt", encoding="utf-8") if str(file).endswith(".gz") else \
        open(file, encoding="utf-8", newline="")
    with opened as lines:
        return list(csv.DictReader(lines))


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        scenario = SCENARIOS / "plaza" / "plaza-low.sumocfg"
        cls.run_program("run", str(scenario), "--end", "90", "--quiet", "--trajectories",
                        str(cls.folder / "run.csv.gz"), "--conflict-csv",
                        str(cls.folder / "conflicts.csv"), "--conflict-ttc", "60", "--conflict-pet", "60")
        (cls.folder / "small.study.xml").write_text(STUDY.format(scenario=scenario), encoding="utf-8")
        cls.run_program("study", "run", str(cls.folder / "small.study.xml"), "--quiet", "--out",
                        str(cls.folder / "results"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def run_program(cls, *words):
        subprocess.run([PEDZONE, *words], check=True, stdout=subprocess.DEVNULL)

    def check(self, file, texts):
        rows, table = rows_of(file), pedzone.read_table(file)
        self.assertGreater(len(rows), 0, file)
        self.assertEqual(list(table), list(rows[0]))
        self.assertEqual([name for name, array in table.items() if array.dtype == object], texts)
        for name, array in table.items():
            self.assertEqual(array.shape, (len(rows),))
            for value, row in zip(array, rows):
                field = row[name]
                if isinstance(value, str):
                    self.assertEqual(value, field)
                elif value is None or isinstance(value, bool):
                    self.assertEqual(value, {"": None, "true": True, "false": False}[field])
                else:
                    self.assertTrue(value == float(field) if field else math.isnan(value), name)
        told = pedzone.table_columns(file)
        self.assertEqual([name for name, _, _ in told], list(table))
        return table

    def test_trajectories(self):
        table = self.check(self.folder / "run.csv.gz", ["id", "motion", "activity"])
        self.assertIn(("x", "m", "of the body's centre, in the network"),
                      pedzone.table_columns(self.folder / "run.csv.gz"))
        first = table["id"] == table["id"][0]
        self.assertGreater(first.sum(), 10)
        self.assertTrue((numpy.diff(table["time"][first]) > 0).all())

    def test_conflicts(self):
        table = pedzone.read_table(self.folder / "conflicts.csv")
        self.check(self.folder / "conflicts.csv", [name for name in table if name in (
            "person", "vehicle", "type", "first", "aware") or name.endswith("_type")])

    def test_crossings(self):
        file = self.folder / "seen.csv"
        file.write_text("person,place,begin,end,waited,gap,let_pass,near_conflicts,far_conflicts\n"
                        "p,between,1.5,9.0,2.0,,1.5 2.5,1,0\nq,junction,3.0,11.0,0.0,4.5,,0,2\n",
                        encoding="utf-8")
        self.check(file, ["person", "place", "let_pass"])

    def test_a_study(self):
        study = pedzone.Study(self.folder / "results")
        self.assertEqual(study.models, ["striping", "heuristic"])
        self.assertEqual((study.reference, study.seeds), ("striping", [1, 2]))
        self.assertEqual(len(study.conditions), 2)
        results = Path(study.folder)
        runs = self.check(results / "runs.csv", ["scenario", "factor.sight", "model", "status"])
        self.assertEqual(set(runs["status"]), {"done"})
        summary = self.check(results / "summary.csv", [
            "scenario", "factor.sight", "model", "reference", "measure", "unit", "family",
            "difference.allEqual", "finding", "bound"])
        self.assertEqual(list(study.runs()), list(runs))
        self.assertEqual(list(study.summary()), list(summary))
        folder = Path(study.run_folder("heuristic", 2, condition=1))
        self.check(folder / "series.csv", [])
        self.check(folder / "density.csv", [])
        with self.assertRaisesRegex(KeyError, "no run of model 'orca' with seed 1 in condition 0"):
            study.run_folder("orca", 1)
        for unknown in (("heuristic", 3, 0), ("heuristic", 1, 2)):
            with self.assertRaises(KeyError):
                study.run_folder(*unknown)

    def test_what_is_no_table_is_refused_with_its_place(self):
        cases = {"other.csv": ("a,b\n1,2\n", "other.csv:1.*none of pedzone's tables"),
                 "empty.csv": ("", "empty.csv:1.*none of pedzone's tables"),
                 "short.csv": ("x,y,personSeconds\n1,2\n", "short.csv:2: .*has 2 fields"),
                 "word.csv": ("x,y,personSeconds\n1,2,many\n",
                              "word.csv:2: column personSeconds: .*many.*is not a number")}
        for name, (text, problem) in cases.items():
            file = self.folder / name
            file.write_text(text, encoding="utf-8")
            with self.subTest(name), self.assertRaisesRegex(pedzone.InputError, problem):
                pedzone.read_table(file)
        with self.assertRaisesRegex(pedzone.InputError, "missing.csv.*cannot be opened"):
            pedzone.read_table(self.folder / "missing.csv")
        with self.assertRaisesRegex(pedzone.InputError, "holds no study"):
            pedzone.Study(self.folder)

    def test_zones_are_those_of_the_program(self):
        folder = SCENARIOS / "waypoints"
        zone, = pedzone.read_zones(folder / "waypoints.sumocfg", folder / "waypoints.zone.xml")
        told = subprocess.run([PEDZONE, "inspect", folder / "waypoints.sumocfg", "--zone",
                               folder / "waypoints.zone.xml", "--json"],
                              check=True, capture_output=True, text=True).stdout
        self.assertIn(zone.id, told)
        self.assertIn(f"{zone.area:.0f}", told)
        outer, _ = zone.polygons[0]
        self.assertEqual(outer.shape[1], 2)
        with self.assertRaisesRegex(pedzone.InputError, "waypoints.sumocfg"):
            pedzone.read_zones(folder / "waypoints.sumocfg", folder / "waypoints.sumocfg")


if __name__ == "__main__":
    PEDZONE, SCENARIOS = sys.argv[1], Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1])
