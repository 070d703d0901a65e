"""tools/recordings.py on small data sets of known motion, and on damaged ones."""
import csv
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = Path(__file__).parents[2] / "tools/recordings.py"
COLUMNS = "t,kind,id,x,y,vx,vy,heading,front,rear,half_width"
CITR_FPS, DUT_FPS = 29.97, 23.98  # [1/s] as published
ROUNDING = 0.0005 + 1e-9  # [m], [m/s] three decimals
RATIO = 28.0  # [pixel/m] of the synthetic DUT clip
FILTERED = "data/trajectories_filtered"


class Original:
    """A synthetic data set: people walk straight, vehicles drive straight."""

    def __init__(self, folder, fps):
        self.folder, self.fps = folder, fps

    def path(self, name):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def people(self, clip, *tracks):
        """Each track: id, first and last frame, x, y [m] at frame 0, vx, vy [m/s]."""
        rows = ["id,frame,label,x_est,y_est,vx_est,vy_est"]
        for who, first, last, x, y, vx, vy in tracks:
            for frame in range(first, last + 1):
                t = frame / self.fps
                rows.append(f"{who},{frame},ped,{x + vx * t},{y + vy * t},9,9")
        self.path(f"{FILTERED}/{clip}_traj_ped_filtered.csv").write_text("\n".join(rows) + "\n")

    def vehicles(self, clip, *tracks):
        """Each track: id, first and last frame, x, y [m] and heading [rad] at frame 0, speed [m/s],
        turn [rad/s]; the turn changes the heading only."""
        rows = ["id,frame,label,x_est,y_est,psi_est,vel_est"]
        for who, first, last, x, y, heading, speed, turn in tracks:
            for frame in range(first, last + 1):
                t = frame / self.fps
                psi = math.remainder(heading + turn * t, 2 * math.pi)
                rows.append(f"{who},{frame},veh,{x + speed * math.cos(heading) * t},"
                            f"{y + speed * math.sin(heading) * t},{psi},{speed}")
        self.path(f"{FILTERED}/{clip}_traj_veh_filtered.csv").write_text("\n".join(rows) + "\n")

    def corners(self, clip, *boxes):
        """Each box: id, length and width [m], heading [rad]; with one mark far off."""
        rows = ["id,x_c,y_c,x_fl,y_fl,x_fr,y_fr,x_rr,y_rr,x_rl,y_rl,frame,label"]
        for who, length, width, heading in boxes:
            for frame in range(40, 45):
                half = length / 2 + (1 if frame == 42 else 0)  # [m] the outlier
                marks = [(300 + RATIO * (ahead * half * math.cos(heading)
                                         - left * width / 2 * math.sin(heading)),
                          200 + RATIO * (ahead * half * math.sin(heading)
                                         + left * width / 2 * math.cos(heading)))
                         for ahead, left in ((1, 1), (1, -1), (-1, -1), (-1, 1))]
                rows.append(f"{who},300,200," + ",".join(f"{x},{y}" for x, y in marks)
                            + f",{frame},veh")
        self.path(f"data/trajectories/{clip}_traj_veh.csv").write_text("\n".join(rows) + "\n")
        self.path(f"data/ratios/{clip}_ratio_pixel2meter.txt").write_text(f"{RATIO:.18e}\n")


class Recordings(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.folder = Path(self.directory.name)
        self.out = self.folder / "deep/out"
        self.original = self.folder / "original"

    def convert(self, *words):
        return subprocess.run([sys.executable, TOOL, *map(str, words)], text=True,
                              capture_output=True, timeout=60, check=False)

    def rows(self, clip):
        with open(self.out / clip, newline="", encoding="ascii") as stream:
            self.assertEqual(stream.readline(), COLUMNS + "\n")
            stream.seek(0)
            return list(csv.DictReader(stream))

    def tracks(self, clip):
        result = {}
        for row in self.rows(clip):
            result.setdefault(row["kind"] + row["id"], []).append(row)
        return result

    def citr(self):
        """A clip with the golf cart, in a scenario folder, and one without."""
        data = Original(self.original, CITR_FPS)
        data.people("vci_back/back_01", (1, 311, 400, 20, 5, -1.2, 0.3), (10, 320, 350, 3, 4, 0, 1),
                    (2, 330, 332, 0, 0, 1, 0))
        data.vehicles("vci_back/back_01", (1, 311, 500, 40, 8, 3.0, 2.5, 5))
        data.people("p2p/bidirection_no_vehicle_01", (1, 0, 30, 1, 1, 1, 0))
        return data

    def dut(self):
        """People from frame 41, vehicles from frame 60: one clock for both."""
        data = Original(self.original, DUT_FPS)
        data.people("intersection_01", (0, 41, 140, 2, 3, 1.4, -0.2))
        data.vehicles("intersection_01", (0, 60, 140, 5, 6, 0.5, 3, 0),
                      (1, 70, 140, 9, 9, -2, 1, 0))
        data.corners("intersection_01", (0, 4.3, 1.4, 0.5), (1, 5.8, 2.0, -2))
        return data

    def expect_error(self, done, *fragments):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for fragment in ("Error: ", *fragments):
            self.assertIn(fragment, done.stderr)
        self.assertFalse(self.out.parent.exists(), "outputs are complete or absent")

    def expect_times(self, rows, first, last):
        """[s] Multiples of 0.1 from first to last, with one decimal."""
        count = round((last - first) * 10) + 1
        self.assertEqual([row["t"] for row in rows],
                         [f"{first + number / 10:.1f}" for number in range(count)])

    def expect_straight(self, rows, x, y, vx, vy, clock=0.0):
        """x, y [m] at the original time 0, which is `clock` s before the clip's."""
        for row in rows:
            t = float(row["t"]) + clock
            self.assertAlmostEqual(float(row["x"]), x + vx * t, delta=ROUNDING)
            self.assertAlmostEqual(float(row["y"]), y + vy * t, delta=ROUNDING)
            self.assertAlmostEqual(float(row["vx"]), vx, delta=ROUNDING)
            self.assertAlmostEqual(float(row["vy"]), vy, delta=ROUNDING)

    # What is written

    def test_citr_clips_keep_the_videos_clock(self):
        self.citr()
        done = self.convert("citr", self.original, self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 clips, 3 people, 1 vehicles; left out: 0 clips with a "
                      "missing file, 1 tracks", done.stdout)
        self.assertEqual(sorted(path.name for path in self.out.rglob("*") if path.is_file()),
                         ["back_01.csv", "bidirection_no_vehicle_01.csv"])
        tracks = self.tracks("citr/back_01.csv")
        self.assertEqual(list(tracks), ["ped1", "ped10", "veh1"])
        self.expect_times(tracks["ped1"], 10.4, 13.3)  # frames 311 to 400: 10.377 to 13.347 s
        self.expect_straight(tracks["ped1"], 20, 5, -1.2, 0.3)
        self.expect_straight(tracks["ped10"], 3, 4, 0, 1)

    def test_a_clip_without_a_vehicle_has_people_only(self):
        self.citr()
        self.convert("citr", self.original, self.out)
        tracks = self.tracks("citr/bidirection_no_vehicle_01.csv")
        self.assertEqual(list(tracks), ["ped1"])
        self.expect_times(tracks["ped1"], 0, 1)  # frame 30 is at 1.001 s
        self.assertEqual({row[name] for row in tracks["ped1"]
                          for name in ("heading", "front", "rear", "half_width")}, {""})

    def test_the_golf_carts_box_and_heading(self):
        self.citr()
        self.convert("citr", self.original, self.out)
        rows = self.tracks("citr/back_01.csv")["veh1"]
        self.expect_straight(rows, 40, 8, 2.5 * math.cos(3), 2.5 * math.sin(3))
        self.assertEqual({(row["front"], row["rear"], row["half_width"]) for row in rows},
                         {("1.00", "1.20", "0.60")})
        for row in rows:  # turns through pi, where linear interpolation would pass through 0
            wrong = float(row["heading"]) - 3 - 5 * float(row["t"])
            self.assertAlmostEqual(math.remainder(wrong, 2 * math.pi), 0, delta=0.00005 + 1e-9)
            self.assertLessEqual(abs(float(row["heading"])), 3.1416)

    def test_dut_clips_have_one_clock_for_people_and_vehicles(self):
        self.dut()
        done = self.convert("dut", self.original, self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        tracks = self.tracks("dut/intersection_01.csv")
        self.assertEqual(list(tracks), ["ped0", "veh0", "veh1"])
        clock = 41 / DUT_FPS
        self.expect_times(tracks["ped0"], 0, 4.1)  # 99 frames: 4.128 s
        self.expect_straight(tracks["ped0"], 2, 3, 1.4, -0.2, clock)
        self.expect_times(tracks["veh0"], 0.8, 4.1)  # from frame 60: 0.792 s
        self.expect_straight(tracks["veh0"], 5, 6, 3 * math.cos(0.5), 3 * math.sin(0.5), clock)

    def test_dut_boxes_are_medians_of_marked_corners(self):
        self.dut()
        self.convert("dut", self.original, self.out)
        tracks = self.tracks("dut/intersection_01.csv")
        for who, box in (("veh0", ("2.15", "2.15", "0.70")), ("veh1", ("2.90", "2.90", "1.00"))):
            self.assertEqual({(row["front"], row["rear"], row["half_width"])
                              for row in tracks[who]}, {box})

    def test_both_sites_go_beside_each_other(self):
        self.citr()
        self.dut()
        for site in ("citr", "dut"):
            done = self.convert(site, self.original, self.out)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(path.name for path in self.out.iterdir()), ["citr", "dut"])

    def test_finished_clips_are_never_touched(self):
        self.citr()
        self.convert("citr", self.original, self.out)
        before = (self.out / "citr/back_01.csv").read_bytes()
        done = self.convert("citr", self.original, self.out)
        self.assertEqual(done.returncode, 2)
        self.assertIn("exists already", done.stderr)
        self.assertEqual((self.out / "citr/back_01.csv").read_bytes(), before)
        self.assertEqual([path.name for path in self.out.iterdir()], ["citr"])

    def test_help_says_where_the_data_is(self):
        for words in (["--help"], ["citr", "--help"], ["dut", "--help"]):
            done = self.convert(*words)
            self.assertEqual(done.returncode, 0)
            for fragment in ("github.com/dongfang-steven-yang", "pedzone validate --data",
                             "1902.00487"):
                self.assertIn(fragment, done.stdout)

    # Bad input

    def damage(self, site, name, change):
        """Converts after `change` of the text of a file."""
        getattr(self, site)()
        path = self.original / name
        path.write_text(change(path.read_text()))
        return self.convert(site, self.original, self.out)

    def test_no_clips(self):
        self.expect_error(self.convert("citr", self.folder / "nowhere", self.out), "nowhere",
                          "git clone")
        self.citr()
        self.expect_error(self.convert("dut", self.original, self.out), FILTERED)

    def test_missing_column(self):
        name = f"{FILTERED}/vci_back/back_01_traj_ped_filtered.csv"
        done = self.damage("citr", name, lambda text: text.replace("x_est", "x_measure", 1))
        self.expect_error(done, f"{name}:1: ", "'x_est'", "id,frame,x_est,y_est")

    def test_value_that_is_no_number(self):
        name = f"{FILTERED}/vci_back/back_01_traj_veh_filtered.csv"
        for bad in ("east", "nan", "inf", ""):
            with self.subTest(bad):
                def change(text, bad=bad):
                    lines = text.split("\n")
                    fields = lines[2].split(",")
                    lines[2] = ",".join([*fields[:5], bad, *fields[6:]])
                    return "\n".join(lines)
                self.expect_error(self.damage("citr", name, change), f"{name}:3: ", "'psi_est'",
                                  f"'{bad}'", "a finite number")

    def test_frame_that_is_not_whole(self):
        name = f"{FILTERED}/intersection_01_traj_ped_filtered.csv"
        for bad in ("41.5", "-1"):
            with self.subTest(bad):
                done = self.damage(
                    "dut", name, lambda text, bad=bad: text.replace(",41,", f",{bad},"))
                self.expect_error(done, f"{name}:2: ", "'frame'", f"'{bad}'", "whole number")

    def test_missing_and_repeated_frames(self):
        name = f"{FILTERED}/intersection_01_traj_ped_filtered.csv"
        for bad in (",51,", ",49,"):  # instead of 50, in line 11
            with self.subTest(bad):
                done = self.damage("dut", name, lambda text, bad=bad: text.replace(",50,", bad))
                self.expect_error(done, f"{name}:11: ", "'frame'", "after 49", "50 is needed")

    def test_row_of_another_length(self):
        name = f"{FILTERED}/intersection_01_traj_ped_filtered.csv"
        done = self.damage("dut", name, lambda text: text[:text.rindex(",")])
        self.expect_error(done, f"{name}:101: ", "6 fields", "7")

    def test_empty_files(self):
        name = f"{FILTERED}/vci_back/back_01_traj_veh_filtered.csv"
        self.expect_error(self.damage("citr", name, lambda text: ""), name, "is empty")
        self.expect_error(self.damage("citr", name, lambda text: text.split("\n")[0]), name,
                          "no rows")

    def expect_left_out(self, done, site, written, name):
        """The other clips are there, and one line names the missing file."""
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual([path.name for path in (self.out / site).iterdir()], written)
        self.assertRegex(done.stderr, rf"\AWarning: .*{name}: is missing; .*\n\Z")
        self.assertIn("left out: 1 clips with a missing file", done.stdout)

    def test_missing_vehicle_file(self):
        self.citr()
        name = f"{FILTERED}/vci_back/back_01_traj_veh_filtered.csv"
        (self.original / name).unlink()
        self.expect_left_out(self.convert("citr", self.original, self.out), "citr",
                             ["bidirection_no_vehicle_01.csv"], name)

    def test_missing_file_of_people(self):
        self.dut()
        Original(self.original, DUT_FPS).vehicles("roundabout_02", (0, 1, 9, 0, 0, 0, 1, 0))
        self.expect_left_out(self.convert("dut", self.original, self.out), "dut",
                             ["intersection_01.csv"], "roundabout_02_traj_ped_filtered.csv")

    def test_missing_corners_and_scale(self):
        for name in ("data/trajectories/roundabout_02_traj_veh.csv",
                     "data/ratios/roundabout_02_ratio_pixel2meter.txt"):
            with self.subTest(name):
                shutil.rmtree(self.original, ignore_errors=True)
                shutil.rmtree(self.out, ignore_errors=True)
                data = self.dut()
                data.people("roundabout_02", (0, 41, 140, 2, 3, 1.4, -0.2))
                data.vehicles("roundabout_02", (0, 60, 140, 5, 6, 0.5, 3, 0))
                data.corners("roundabout_02", (0, 4.3, 1.4, 0.5))
                (self.original / name).unlink()
                self.expect_left_out(self.convert("dut", self.original, self.out), "dut",
                                     ["intersection_01.csv"], name)

    def test_no_clip_is_complete(self):
        self.dut()
        name = "data/ratios/intersection_01_ratio_pixel2meter.txt"
        (self.original / name).unlink()
        self.expect_error(self.convert("dut", self.original, self.out), name, "is missing",
                          "no other clip")

    def test_missing_or_wrong_scale(self):
        name = "data/ratios/intersection_01_ratio_pixel2meter.txt"
        for bad in ("", "wide", "0", "nan"):
            with self.subTest(bad):
                self.expect_error(self.damage("dut", name, lambda text, bad=bad: bad), name,
                                  f"'{bad}'", "above 0")

    def test_vehicle_without_marks(self):
        done = self.damage("dut", "data/trajectories/intersection_01_traj_veh.csv",
                           lambda text: "\n".join(text.split("\n")[:6]))
        self.expect_error(done, "intersection_01_traj_veh.csv", "id 1")

    def test_same_clip_twice(self):
        self.citr()
        Original(self.original, CITR_FPS).people("vci_front/back_01", (1, 1, 9, 0, 0, 1, 0))
        self.expect_error(self.convert("citr", self.original, self.out), "back_01", "vci_back")

    def test_unwritable_output(self):
        self.citr()
        (self.folder / "file").write_text("")
        done = self.convert("citr", self.original, self.folder / "file/out")
        self.expect_error(done, "file", "Not a directory")


if __name__ == "__main__":
    unittest.main()
