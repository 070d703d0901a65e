#!/usr/bin/python3
"""`pedzone validate` and `pedzone calibrate`: bad recordings, outputs, repeatability.

usage: test_recordings.py PEDZONE_PROGRAM
"""

import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from refusal import RefusalChecks

PEDZONE = None  # set from the command line
COLUMNS = "t,kind,id,x,y,vx,vy,heading,front,rear,half_width"


def clip(offset=0.0, speed=2.5, seconds=8.0):
    """Two persons cross the way of a vehicle that drives along y = 0: rows without the header."""
    rows = []
    for k in range(int(seconds * 10) + 1):
        t = k / 10
        for name, x in (("1", 10.0 + offset), ("2", 11.5 + offset)):
            sway = 0.4 * math.sin(0.6 * t)
            rows.append(f"{t:.1f},ped,{name},{x + sway:.3f},{-4.0 + 1.2 * t:.3f},0,1.2,,,,")
        rows.append(f"{t:.1f},veh,v,{-4.0 + speed * t:.3f},0.000,{speed},0,0.0,2.1,2.1,0.8")
    return rows


class Recordings(RefusalChecks, unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = Path(self.directory.name)
        self.write("here/front_01.csv", clip())
        self.write("here/back_02.csv", clip(1.0))
        self.write("there/intersection_01.csv", clip(2.0, 3.5))

    def tearDown(self):
        self.directory.cleanup()

    def write(self, name, rows, header=COLUMNS):
        path = self.folder / "data" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join([header, *rows]) + "\n")

    def pedzone(self, *words):
        return subprocess.run([PEDZONE, *map(str, words)], cwd=self.folder, text=True,
                              capture_output=True, timeout=120)

    def validate(self, *words):
        return self.pedzone("validate", "--data", "data", "--seeds", "2", "--resamples", "20",
                            "--json", "out/v.json", "--html", "out/v.html", *words)

    def bad_rows(self, change, *fragments):
        rows = clip()
        change(rows)
        self.write("here/front_01.csv", rows)
        self.check_refused(self.validate(), "front_01.csv", *fragments)

    # What comes out

    def test_all_figures_for_all_models_in_both_sets(self):
        done = self.validate()
        self.assertEqual(done.returncode, 0, done.stderr)
        result = json.loads((self.folder / "out/v.json").read_text())
        self.assertEqual(result["persons"], 6)
        models = {row["model"] for row in result["rows"]}
        self.assertEqual(models, {"recorded", "straight to goal", "constant velocity", "plain",
                                  "heuristic"})
        self.assertEqual({row["set"] for row in result["rows"]}, {"recorded", "straight"})
        groups = {row["group"] for row in result["rows"]}
        self.assertLessEqual({"all", "here", "there", "here: front", "there: intersection"}, groups)
        page = (self.folder / "out/v.html").read_text()
        self.assertIn("<svg", page)
        self.assertIn("here: front", done.stdout)

    def test_the_recorded_figures_are_those_of_the_recording(self):
        self.assertEqual(self.validate().returncode, 0)
        rows = json.loads((self.folder / "out/v.json").read_text())["rows"]
        row = next(r for r in rows if (r["set"], r["group"], r["model"]) ==
                   ("recorded", "here: front", "recorded"))
        # By hand: the person is where the track says, the vehicle's box is x ± 2.1 m, y ± 0.8 m.
        clearances = []
        for x0 in (10.0, 11.5):
            least = min(math.hypot(max(0, abs(x0 + 0.4 * math.sin(0.06 * k) + 4 - 0.25 * k) - 2.1),
                                   max(0, abs(-4 + 0.12 * k) - 0.8)) for k in range(81))
            clearances.append(least)
        self.assertAlmostEqual(row["figures"]["clearance"]["value"], sum(clearances) / 2, places=2)

    def test_the_same_again_and_with_one_thread(self):
        for name in ("a", "b"):
            done = self.pedzone("validate", "--data", "data", "--seeds", "2", "--resamples", "20",
                                "--json", f"{name}.json")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "a.json").read_bytes(),
                         (self.folder / "b.json").read_bytes())

    def test_a_parameter_changes_the_result(self):
        outputs = [self.pedzone("validate", "--data", "data", "--seeds", "1", "--resamples", "10",
                                *more).stdout for more in ((), ("--param", "discomfort=0"))]
        self.assertNotEqual(*outputs)

    def test_calibration_goes_on_where_it_was_broken_off(self):
        few = ("--first", "6", "--rounds", "1", "--points", "2", "--seeds", "1")
        first = self.pedzone("calibrate", "--data", "data", "--out", "out", *few)
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertRegex(first.stdout, r"\b0 of them known from before")
        log = self.folder / "out/evaluations.csv"
        lines = log.read_text().splitlines()
        log.write_text("\n".join(lines[:6]) + "\n" + lines[6][:7])  # the last one cut off
        wanted = (self.folder / "out/calibration.json").read_text()
        again = self.pedzone("calibrate", "--data", "data", "--out", "out", *few)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertRegex(again.stdout, r"\b4 of them known from before")
        self.assertEqual((self.folder / "out/calibration.json").read_text(), wanted)
        self.assertEqual(sorted(log.read_text().splitlines()), sorted(lines))
        folds = [fold["tuned_on"] for fold in json.loads(wanted)["folds"]]
        self.assertIn("without there", folds)
        self.assertIn("without front", folds)
        self.assertIn("calibrated(discomfort, ", (self.folder / "out/calibrated.inc").read_text())
        more = self.pedzone("calibrate", "--data", "data", "--out", "out", *few[:-1], "2")
        self.assertEqual(more.returncode, 2, more.stderr)
        self.assertIn("2 seeds", more.stderr)
        self.write("here/front_01.csv", clip(0.5))
        other = self.pedzone("calibrate", "--data", "data", "--out", "out", *few)
        self.assertEqual(other.returncode, 2, other.stderr)
        self.assertIn("of another search, other clips or seeds", other.stderr)
        self.assertEqual(sorted(log.read_text().splitlines()), sorted(lines))

    # Bad input

    def test_missing_column(self):
        self.write("here/front_01.csv", clip(), COLUMNS.replace(",half_width", ""))
        self.check_refused(self.validate(), "front_01.csv:1", "half_width", "missing")

    def test_a_recording_is_not_written_over(self):
        clip_file = self.folder / "data/here/front_01.csv"
        before = clip_file.read_text()
        done = self.pedzone("validate", "--data", "data", "--seeds", "1", "--json", clip_file)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("names a file that is read", done.stderr)
        self.assertEqual(clip_file.read_text(), before)

    def test_degrees_and_millimetres_are_refused(self):
        self.bad_rows(lambda rows: rows.__setitem__(
            2, rows[2].replace(",0.0,2.1,", ",90.0,2.1,")), "heading", "'90.0'", "out of range")
        self.bad_rows(lambda rows: rows.__setitem__(
            slice(None), [row.replace(",ped,1,10.", ",ped,1,10") for row in rows]), "farther", "metres")

    def test_nothing_to_tune_on_is_told(self):
        for name in ("here/front_01.csv", "here/back_02.csv", "there/intersection_01.csv"):
            self.write(name, clip(500.0))
        done = self.pedzone("calibrate", "--data", "data", "--out", "out", "--seeds", "1")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("nothing to tune on", done.stderr)
        self.assertIn("rad", done.stderr)
        done = self.pedzone("validate", "--data", "data", "--seeds", "1", "--resamples", "20")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("nobody is scored", done.stderr)

    def test_gap_in_time(self):
        self.bad_rows(lambda rows: rows.__delitem__(30), ":34", "gap", "id 1")

    def test_no_number(self):
        self.bad_rows(lambda rows: rows.__setitem__(0, rows[0].replace("10.000", "ten")), ":2",
                      "column x", "ten")

    def test_infinity(self):
        self.bad_rows(lambda rows: rows.__setitem__(3, rows[3].replace("-3.880", "inf")), ":5",
                      "column y", "inf")

    def test_vehicle_without_size(self):
        self.bad_rows(lambda rows: rows.__setitem__(2, rows[2].replace("2.1,2.1,0.8", ",,")), ":4",
                      "column front")

    def test_vehicle_of_no_width(self):
        self.bad_rows(lambda rows: rows.__setitem__(2, rows[2].replace(",0.8", ",0")), ":4",
                      "half_width", "more than 0")

    def test_row_cut_off(self):
        self.bad_rows(lambda rows: rows.__setitem__(-1, rows[-1][:12]), "cut off")

    def test_unknown_kind(self):
        self.bad_rows(lambda rows: rows.__setitem__(1, rows[1].replace("ped", "dog")), ":3", "dog")

    def test_empty_file(self):
        (self.folder / "data/here/front_01.csv").write_text("")
        self.check_refused(self.validate(), "front_01.csv", "empty")

    def test_vehicles_only(self):
        self.write("here/front_01.csv", [row for row in clip() if ",veh," in row])
        self.check_refused(self.validate(), "front_01.csv", "no rows of persons")

    def test_no_folder_and_no_clips(self):
        done = self.pedzone("validate", "--data", "nowhere")
        self.check_refused(done, "nowhere")
        (self.folder / "bare").mkdir()
        self.check_refused(self.pedzone("validate", "--data", "bare"), "no clips")

    def test_unknown_model_and_parameter(self):
        self.check_refused(self.validate("--model", "telepathy"), "telepathy", "heuristic")
        self.check_refused(self.validate("--param", "discomfrt=1"), "discomfrt")
        self.check_refused(self.validate("--param", "discomfort=-1"), "discomfort", "0 to 100")

    def test_one_clip_cannot_be_cross_validated(self):
        for name in ("here/back_02.csv", "there/intersection_01.csv"):
            (self.folder / "data" / name).unlink()
        done = self.pedzone("calibrate", "--data", "data", "--out", "out", "--first", "2")
        self.check_refused(done, "cross-validate")


if __name__ == "__main__":
    PEDZONE = Path(sys.argv.pop(1)).resolve()
    unittest.main()
