#!/usr/bin/python3
"""`pedzone study run --slurm` on a real cluster of two nodes.

usage: test_slurm.py PEDZONE_PROGRAM
"""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from slurm_cluster import NODES, SlurmCluster
from slurm_study import SlurmStudy, sumo_environment

HOSTILE = "it's 100%a \"$(touch hit)\" é"


class OnTheCluster(SlurmStudy):
    @classmethod
    def setUpClass(cls):
        cls.cluster = cls.enterClassContext(SlurmCluster())

    def submit(self, results, *more):
        ended = self.on(self.cluster, "run", self.folder / "study.xml", "--out", results,
                        "--slurm", *more)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        return ended.stdout

    def start_task(self, out, chunk):
        return subprocess.Popen([self.PEDZONE, "study", "task", out, chunk], text=True,
                                env=sumo_environment(), stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT)

    def finish(self):
        self.cluster.wait_until(lambda: not self.cluster.jobs(), limit=240)

    def test_same_tables_as_on_one_machine(self):
        study = self.study("1-12")
        reference = self.local_results(study)
        results = self.folder / HOSTILE
        self.submit(results, "--per-task", "4")
        self.finish()
        self.check_same(results, reference, 12)
        self.assertTrue((results / "report.html").is_file(), self.logs(results))
        self.assertEqual(list(self.folder.rglob("hit")), [])
        tasks = {path.name for path in (results / "slurm/1").glob("[0-9]*.log")}
        self.assertEqual(tasks, {f"{task}.log" for task in range(len(tasks))})
        self.assertGreaterEqual(len(tasks), 6)

    def test_only_what_is_missing(self):
        self.submit(self.folder / "out", "--per-task", "3") if self.study("1-2") else None
        self.finish()
        before = {run: (self.folder / "out/runs" / run / "record.json").stat().st_ino
                  for run in self.run_folders(self.folder / "out")}
        self.study("1-3")
        self.submit(self.folder / "out", "--per-task", "3")
        self.finish()
        chunks = [path for path in (self.folder / "out/slurm/2").iterdir() if path.name.isdigit()]
        self.assertEqual(sum(len(path.read_text().splitlines()) for path in chunks), 2)
        for run, file in before.items():
            self.assertEqual((self.folder / "out/runs" / run / "record.json").stat().st_ino, file)

    def test_second_driver_is_refused_while_jobs_are_queued(self):
        study, out = self.study("1-2"), self.folder / "out"
        printed = self.submit(out, "--per-task", "2", "--sbatch=--begin=now+1hour")
        job = re.search(r"job (\d+)", printed)[1]
        for words in (("--slurm",), ("--jobs", "2")):
            again = self.on(self.cluster, "run", study, "--out", out, *words)
            self.assertEqual(again.returncode, 2, again.stdout + again.stderr)
            self.assertIn(f"job {job}: ", again.stderr)
        status = self.on(self.cluster, "status", out)
        self.assertRegex(status.stdout, rf"job {job}: \d+ pending \(BeginTime\)")
        cancel = re.search(r"`(scancel [^`]*)`", again.stderr)[1]
        self.cluster.run(*cancel.split())
        self.finish()
        self.submit(out, "--per-task", "2")
        self.finish()
        self.assertTrue((out / "runs.csv").is_file(), self.logs(out))

    def test_gives_up_where_arrays_finish_nothing(self):
        study, out = self.study("1-2"), self.folder / "out"
        self.submit(out, "--per-task", "3", "--sbatch=--begin=now+3")
        (out / "runs").rmdir()
        (out / "runs").write_text("no folder")  # nothing can be put there
        self.finish()
        self.assertEqual(len(list((out / "slurm").glob("[0-9]*"))), 3, self.logs(out))
        self.assertIn("6 runs are missing", (out / "slurm/3/aggregate.log").read_text())
        (out / "runs").unlink()
        reference = self.local_results(study)
        self.submit(out, "--per-task", "3")
        self.finish()
        self.check_same(out, reference, 2)

    def chunk_of_cancelled(self, study, out):
        """The file of ids of a study's only task, which has been submitted, but never started."""
        self.study(study)
        self.submit(out, "--sbatch=--begin=now+1hour")
        self.cluster.run("scancel", "--user=root")
        self.finish()
        return out / "slurm/1/0"

    def test_task_that_is_asked_to_end(self):
        out = self.folder / "out"
        chunk = self.chunk_of_cancelled("1-9", out)
        ids = chunk.read_text().split()
        with self.start_task(out, chunk) as task:
            self.cluster.wait_until(lambda: len(self.run_folders(out)) > 2)
            task.terminate()
            printed, _ = task.communicate(timeout=60)
        self.assertEqual(task.returncode, 130, printed)
        self.assertIn("Asked to end", printed)
        left = self.run_folders(out)  # nothing unfinished
        self.assertEqual(left, [run for run in left if run in ids])
        self.assertLess(len(left), len(ids))

    def test_copies_of_a_task_at_the_same_time(self):
        out = self.folder / "out"
        chunk = self.chunk_of_cancelled("1-5", out)
        reference = self.local_results(self.folder / "study.xml")
        copies = [self.start_task(out, chunk) for _ in range(3)]
        for copy in copies:
            with copy:
                printed, _ = copy.communicate(timeout=240)
                self.assertEqual(copy.returncode, 0, printed)
        self.done("report", out)
        self.check_same(out, reference, 5)

    def test_node_that_is_given_up_while_its_task_lives_on(self):
        study, out = self.study("1-6"), self.folder / "out"
        reference = self.local_results(study)
        self.submit(out, "--per-task", "5")
        self.cluster.wait_until(lambda: len(self.run_folders(out)) > 2)
        node = NODES[0]
        self.cluster.kill_node(node)
        self.cluster.run("scontrol", "update", f"NodeName={node}", "State=DOWN", "Reason=test")
        self.cluster.wait_until(lambda: self.cluster.node_states()[node].startswith("down"))
        self.cluster.start_node(node)
        self.cluster.run("scontrol", "update", f"NodeName={node}", "State=RESUME")
        self.finish()
        self.check_same(out, reference, 6)

    def test_unknown_partition(self):
        study, out = self.study("1-2"), self.folder / "out"
        ended = self.on(self.cluster, "run", study, "--out", out, "--slurm", "--partition", "nope")
        self.assertEqual(ended.returncode, 2, ended.stdout + ended.stderr)
        self.assertIn("invalid partition specified: nope", ended.stderr)
        self.assertFalse(out.exists())

    def test_folder_that_cannot_be_written(self):
        (self.folder / "file").write_text("")
        for place in ("file/out", "back\\slash"):
            ended = self.on(self.cluster, "run", self.study("1-2"), "--out", self.folder / place,
                            "--slurm")
            self.assertEqual(ended.returncode, 2, ended.stdout + ended.stderr)
            self.assertIn(place, ended.stderr)
        self.assertEqual(self.cluster.jobs(), [])


class WithoutSlurm(SlurmStudy):
    def test_sbatch_is_missing(self):
        tools = self.folder / "bin"
        tools.mkdir()
        for program in Path("/usr/bin").glob("sumo*"):
            (tools / program.name).symlink_to(program)
        out = self.folder / "out"
        ended = self.command("run", self.study("1-2"), "--out", out, "--slurm",
                             environment={**os.environ, "PATH": str(tools)})
        self.assertEqual(ended.returncode, 2, ended.stdout + ended.stderr)
        self.assertIn("no program 'sbatch'", ended.stderr)
        self.assertIn("--jobs", ended.stderr)
        self.assertFalse(out.exists())


if __name__ == "__main__":
    SlurmStudy.PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
