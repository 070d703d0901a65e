#!/usr/bin/python3
"""A study's runs: made once, made again where something has changed, given up where they fail.

usage: test_runs.py PEDZONE_PROGRAM FOLDER_OF_PLUGINS
"""

import csv
import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path

import study_case
from family import family, wait_until_none_uses
from study_case import StudyCase

PLUGINS = None  # set from the command line
HANGS_FOR = 15  # [s] limit of a run that hangs; far more than a good one takes


def finished(done):
    """Ids of the runs that a driver has told as done."""
    return sorted(line.split()[1] for line in done.stderr.splitlines() if " done in " in line)


class Resuming(StudyCase):
    def test_makes_each_run_once_and_has_nothing_to_do_afterwards(self):
        study = self.study()
        first = self.make(study)
        self.assertEqual(len(finished(first)), 6)  # 2 seeds, 2 models, and free speeds of each
        self.assertEqual(finished(first), self.run_names())
        rows = list(csv.DictReader((self.results / "runs.csv").read_text().splitlines()))
        self.assertEqual({(row["model"], row["seed"], row["status"]) for row in rows},
                         {(model, seed, "done") for model in ("striping", "nonInteracting")
                          for seed in ("1", "2")})
        self.assertEqual(len(rows), 4)
        before = self.records()
        self.assertEqual(finished(self.make(study)), [])
        self.assertEqual(self.records(), before)

    def test_records_say_what_went_in(self):
        self.make(self.study(seeds="1"))
        for name, record in self.records().items():
            self.assertEqual(record["id"], name)
            self.assertIn(str(self.folder / "tiny.net.xml"), record["inputs"])
            for path, checksum in record["inputs"].items():
                self.assertEqual(checksum, hashlib.sha256(Path(path).read_bytes()).hexdigest())
            self.assertEqual(record["versions"]["build"],
                             hashlib.sha256(Path(self.PEDZONE).read_bytes()).hexdigest())
            for word in (word for command in record["commands"] for word in command):
                self.assertNotIn("/.", word, "outputs are named where they are now")

    def test_more_seeds_keep_what_is_there(self):
        self.make(self.study(seeds="1-2"))
        before = self.records()
        done = self.make(self.study(seeds="1-3"))
        self.assertEqual(len(finished(done)), 2)
        after = self.records()
        self.assertEqual({name: after[name] for name in before}, before)

    def test_a_changed_input_has_only_its_runs_made_again(self):
        self.tiny.write("other.rou.xml", (self.folder / "tiny.rou.xml").read_text())
        config = self.tiny.config(routes="other.rou.xml")
        config.rename(self.folder / "other.sumocfg")
        self.tiny.config()
        study = self.study(seeds="1", more='<scenario file="other.sumocfg"/>')
        self.assertEqual(len(finished(self.make(study))), 8)
        routes = self.folder / "other.rou.xml"
        routes.write_text(routes.read_text().replace('departPos="5"', 'departPos="9"'))
        again = finished(self.make(study))
        self.assertEqual(again, [name for name in self.run_names() if "other" in name])

    def test_a_run_of_which_a_part_is_gone_is_made_again(self):
        study = self.study(seeds="1")
        self.make(study)
        victim = self.run_names()[0]
        (self.results / "runs" / victim / "record.json").write_text("")
        self.assertEqual(finished(self.make(study)), [victim])


class Directories(StudyCase):
    def check_untouched(self, message, study):
        before = {path: path.read_bytes() for path in self.results.rglob("*") if path.is_file()}
        done = self.make(study, code=2)
        self.assertEqual(done.stderr.count("Error: "), 1, done.stderr)
        self.assertIn(message, done.stderr)
        after = {path: path.read_bytes() for path in self.results.rglob("*") if path.is_file()}
        self.assertEqual(after, before)

    def test_of_another_study(self):
        study = self.study(seeds="1")
        self.make(study)
        study.write_text(study.read_text().replace('id="tiny"', 'id="other"'))
        self.check_untouched("another study: 'tiny'", study)

    def test_of_something_else(self):
        self.results.mkdir()
        (self.results / "letters.txt").write_text("mine")
        self.check_untouched("letters.txt", self.study())

    def test_of_another_version(self):
        study = self.study(seeds="1")
        self.make(study)
        identity = json.loads((self.results / "study.json").read_text())
        identity["versions"]["sumo"] = "Eclipse SUMO sumo Version 1.20.0"
        (self.results / "study.json").write_text(json.dumps(identity))
        self.check_untouched("another version (sumo: Eclipse SUMO sumo Version 1.20.0", study)

    def test_that_is_none(self):
        for command in ("status", "report"):
            for folder in (self.folder, self.folder / "nowhere"):
                done = self.command(command, folder)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn("holds no study", done.stderr)

    @unittest.skipUnless(os.geteuid() == 0, "only root may mount")
    def test_on_a_full_disk(self):
        self.results.mkdir()
        # Room for the first runs, not for all: each has some 30 kB, and writes in blocks of 4 kB.
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=600k", "none", self.results],
                       check=True)
        self.addCleanup(subprocess.run, ["umount", self.results], check=True)
        study = self.study(seeds="1-20")
        done = self.make(study, "--jobs", "2", code=2)
        self.assertIn("No space left on device", done.stderr)
        self.assertEqual(done.stderr.count("Error: "), 1, done.stderr)
        kept = self.run_names()
        # The other run may have ended in the moment in which the disk was full: kept, but not told.
        self.assertLessEqual(set(finished(done)), set(kept))
        self.assertLessEqual(len(kept) - len(finished(done)), 1)
        self.assertEqual({record["status"] for record in self.records().values()}, {"done"})
        subprocess.run(["mount", "-o", "remount,size=1g", self.results], check=True)
        self.assertEqual(sorted(kept + finished(self.make(study))), self.run_names())
        self.assertEqual(len(self.run_names()), 42)


class StrangeNames(StudyCase):
    FOLDER = """it's "strange" & <b>; $(touch oops) `touch oops` ä"""

    def test_files_whose_paths_have_blanks_and_quotes(self):
        self.make(self.study(seeds="1", models="striping constant-velocity"))
        self.assertEqual(self.statuses(), {"striping": ["done"], "constant-velocity": ["done"]})
        self.assertEqual(list(self.folder.rglob("oops")), [])


class Everybody(StudyCase):
    """Measures are of everybody, whomever the scenario has SUMO write."""

    CARS = """<vType id="car" vClass="passenger"/>
      <vehicle id="a" type="car" depart="3"><route edges="west shared east"/></vehicle>
      <vehicle id="b" type="car" depart="5"><route edges="west shared east"/></vehicle></routes>"""

    def routes(self, **replaced):
        text = study_case.WALKS.replace("</routes>", self.CARS)
        for old, new in replaced.values():
            text = text.replace(old, new)
        self.tiny.write("tiny.rou.xml", text)

    def measures(self, where):
        results = self.folder / where
        self.make(self.study(seeds="1", end=40), results=results)
        with open(results / "runs.csv", encoding="utf-8", newline="") as file:
            return [{key: value for key, value in row.items() if key not in ("id", "wall")}
                    for row in csv.DictReader(file)]

    def test_who_is_listed_to_be_written(self):
        self.routes()
        self.tiny.write("some.txt", "west\n")
        everybody = self.measures("all")
        self.tiny.config(more="""<fcd_device><device.fcd.explicit value="b"/>
            <person-device.fcd.explicit value="p0"/><device.fcd.probability value="0.5"/></fcd_device>
            <tripinfo_device><device.tripinfo.explicit value="b"/></tripinfo_device>
            <output><fcd-output.filter-edges.input-file value="some.txt"/></output>""")
        self.assertEqual(self.measures("listed"), everybody)

    def test_who_is_left_out_by_its_type(self):
        for device, who in (("fcd", "2 of the vehicles, such as 'a'"), ("tripinfo", "2 of the vehicles, such as 'a'")):
            with self.subTest(device):
                self.routes(car=('vClass="passenger"/>', f'vClass="passenger">'
                                 f'<param key="has.{device}.device" value="false"/></vType>'))
                study = self.study(seeds="1", models="striping", end=40)
                self.make(study, results=self.folder / device, code=4)
                failure, = {record["failure"] for record in self.records(self.folder / device).values()
                            if record["status"] == "failed"}
                self.assertIn(who, failure)
                self.assertIn(f"has.{device}.device", failure)


class Misbehaving(StudyCase):
    def setUp(self):
        super().setUp()
        for name in ("aborting", "hanging", "stumbling"):
            shutil.copy(PLUGINS / f"lib{name}.so", self.folder / f"{name}.so")

    def test_what_fails_is_tried_again_then_recorded_and_the_study_goes_on(self):
        study = self.study(seeds="1", limit=HANGS_FOR,
                           models="striping ./aborting.so ./hanging.so ./stumbling.so")
        done = self.make(study, "--jobs", "4", code=4)
        self.assertEqual(self.statuses(), {"striping": ["done"], "aborting": ["failed"],
                                           "hanging": ["failed"], "stumbling": ["done"]})
        wait_until_none_uses(self.folder)
        self.assertEqual([name for name in self.run_names() if name.startswith(".")], [])
        attempts = {}
        for record in self.records().values():
            model = Path(record["definition"]["model"]).stem
            attempts.setdefault(model, []).append(record["attempts"])
            if model == "aborting":
                self.assertRegex(record["failure"], "^pedzone ended with exit code 3\n")
                self.assertIn("SUMO died in the middle of the run", record["failure"])
            if model == "hanging":
                self.assertRegex(record["failure"], f"^took longer than {HANGS_FOR} s\n")
        self.assertEqual((attempts["striping"], attempts["aborting"], attempts["hanging"]),
                         ([1, 1], [2, 2], [2, 2]))
        self.assertIn(2, attempts["stumbling"])
        self.check_what_is_told(done)
        self.check_what_is_tried_again(study)

    def check_what_is_told(self, done):
        self.assertIn("8 runs: 4 done, 4 failed, 0 killed, 0 missing", done.stdout)
        status = self.command("status", self.results)
        self.assertEqual(status.returncode, 4, status.stderr)
        self.assertIn("failed: pedzone ended with exit code 3", status.stdout)
        self.assertIn(f"failed: took longer than {HANGS_FOR} s", status.stdout)
        self.assertEqual(self.command("report", self.results).returncode, 4)

    def check_what_is_tried_again(self, study):
        """Nothing, unless its input has changed or it is asked for."""
        self.assertNotIn("tried again", self.make(study, code=4).stderr)
        shutil.copy(PLUGINS / "libstumbling.so", self.folder / "aborting.so")
        shutil.copy(PLUGINS / "libstumbling.so", self.folder / "hanging.so")
        self.assertEqual(len(finished(self.make(study))), 4)

    def test_failed_runs_are_made_again_where_that_is_asked_for(self):
        study = self.study(seeds="1", models="striping ./stumbling.so ./aborting.so")
        self.make(study, code=4)
        done = self.make(study, "--retry-failed", code=4)
        self.assertEqual(done.stderr.count("exit code 3; tried again"), 2, done.stderr)

    def test_a_run_that_sumo_refuses(self):
        self.tiny.write("bad.rou.xml", '<routes><person id="p" depart="0">'
                        '<walk edges="no such edges"/></person></routes>')
        self.tiny.config(routes="bad.rou.xml").rename(self.folder / "bad.sumocfg")
        self.tiny.config()
        study = self.study(seeds="1", more='<scenario file="bad.sumocfg"/>')
        self.make(study, code=4)
        for name, record in self.records().items():
            bad = "bad" in name
            self.assertEqual(record["status"], "failed" if bad else "done", record["failure"])

    def test_what_is_killed_twice_is_missing(self):
        study = self.study(seeds="1", models="striping ./hanging.so")
        driver = self.start("run", study, "--out", self.results, "--jobs", "1")
        killed = 0
        while killed < 4:  # two runs, each twice
            self.assertIsNone(driver.poll())
            killed += self.kill_hanging(driver.pid)
        output, errors = driver.communicate(timeout=120)
        self.assertEqual(driver.returncode, 4, errors)
        self.assertIn("4 runs: 2 done, 0 failed, 2 killed, 0 missing", output)
        self.assertEqual(errors.count("pedzone was killed (signal 9)"), 4, errors)
        self.assertEqual(self.statuses(), {"striping": ["done"], "hanging": ["killed"]})
        shutil.copy(PLUGINS / "libstumbling.so", self.folder / "hanging.so")
        self.assertEqual(len(finished(self.make(study))), 2)

    @staticmethod
    def kill_hanging(driver):
        """Kills the innermost process of the run that hangs, where there is one."""
        for process in family(driver)[1:]:
            try:
                command = Path(f"/proc/{process}/cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if command[1:2] == [b"run"] and len(family(process)) > 1:
                os.kill(family(process)[-1], signal.SIGKILL)
                while Path(f"/proc/{process}").exists():
                    pass
                return 1
        return 0

    def test_a_second_driver_is_kept_off(self):
        study = self.study(seeds="1", models="striping ./hanging.so")
        driver = self.start("run", study, "--out", self.results, "--jobs", "1")
        while not any(name.startswith(".") for name in self.run_names()):
            self.assertIsNone(driver.poll())
        refused = self.make(study, code=2)
        self.assertIn(f"in use by pedzone study run, process {driver.pid} on ", refused.stderr)
        status = self.command("status", self.results)
        self.assertIn(f"At work: pedzone study run, process {driver.pid}", status.stdout)
        driver.send_signal(signal.SIGTERM)
        _, errors = driver.communicate(timeout=60)
        self.assertEqual(driver.returncode, 130, errors)
        self.assertNotIn("At work", self.command("status", self.results).stdout)


class Interrupting(StudyCase):
    def interrupt(self, how):
        study = self.study(seeds="1-6")
        driver = self.start("run", study, "--out", self.results, "--jobs", "2")
        first = driver.stderr.readline()
        self.assertIn(" done in ", first)
        how(driver)
        output, errors = driver.communicate(timeout=60)
        self.assertEqual(driver.returncode, 130, errors)
        self.assertIn("the same command goes on from there", errors)
        wait_until_none_uses(self.folder)
        kept = self.records()
        self.assertEqual(sorted(kept), self.run_names(), "nothing unfinished is left")
        self.assertIn(first.split()[1], kept)
        self.assertFalse((self.results / "runs.csv").exists())
        rest = finished(self.make(study))
        self.assertEqual(sorted([*kept, *rest]), self.run_names())
        self.assertEqual(len(self.run_names()), 14)
        after = self.records()
        self.assertEqual({name: after[name] for name in kept}, kept)

    def test_from_the_terminal(self):
        # The terminal signals all of the foreground's processes.
        self.interrupt(lambda driver: os.killpg(driver.pid, signal.SIGINT))

    def test_from_a_queueing_system(self):
        self.interrupt(lambda driver: driver.send_signal(signal.SIGTERM))


if __name__ == "__main__":
    PLUGINS = Path(sys.argv.pop(2))
    study_case.main()
