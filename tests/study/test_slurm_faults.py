#!/usr/bin/python3
"""A study on a cluster whose tasks are cancelled, killed and requeued at random, and whose nodes'
daemons are killed and started again, ends with the tables of an undisturbed one.

usage: test_slurm_faults.py PEDZONE_PROGRAM
"""

import random
import sys
import time
import unittest
from pathlib import Path

from slurm_cluster import NODES, SlurmCluster, kill
from slurm_study import SlurmStudy

SEED = 6
MOST_BETWEEN = 5  # runs that are finished between two faults


class Chaos:
    """Does one thing at a time to a cluster that works on a study."""

    def __init__(self, cluster):
        self.cluster = cluster
        self.random = random.Random(SEED)
        self.done = []

    def running_tasks(self):
        return [job for job, state in self.cluster.jobs() if state == "RUNNING" and "_" in job]

    def task_processes(self):
        return self.cluster.processes("SLURM_ARRAY_TASK_ID=")

    def cancel(self):
        self.cluster.run("scancel", self.random.choice(self.running_tasks()))

    def requeue(self):
        self.cluster.run("scontrol", "requeue", self.random.choice(self.running_tasks()))

    def kill_process(self):
        """Any one of a task: of the run, or the task itself."""
        kill(self.random.choice(self.task_processes()))

    def kill_tasks(self):
        """All that run at the moment."""
        for process in self.task_processes():
            kill(process)

    def restart_node(self):
        node = self.random.choice(NODES)
        self.cluster.kill_node(node)
        time.sleep(self.random.uniform(0.1, 2.0))
        self.cluster.start_node(node)

    def kinds(self):
        return [self.cancel, self.requeue, self.kill_process, self.kill_tasks, self.restart_node]

    def strike(self):
        """False where no task runs at the moment."""
        kind = self.kinds()[len(self.done) % len(self.kinds())]
        try:
            kind()
        except IndexError:
            return False
        self.done.append(kind.__name__)
        return True

    def work(self, finished):
        """Strikes whenever some more runs are `finished()`, until the cluster has no jobs."""
        due = 1
        while self.cluster.jobs():
            time.sleep(self.random.uniform(0.0, 0.3))
            if finished() >= due and self.strike():
                due = finished() + self.random.randint(1, MOST_BETWEEN)


class Faults(SlurmStudy):
    def test_same_tables_as_undisturbed(self):
        # 60 runs: two models with 29 seeds, and a free-speed run of each.
        study, out = self.study("1-29"), self.folder / "out"
        reference = self.local_results(study)
        self.assertEqual(len(self.run_folders(reference)), 60)
        with SlurmCluster() as cluster:
            submitted = self.on(cluster, "run", study, "--out", out, "--slurm", "--per-task", "6")
            self.assertEqual(submitted.returncode, 0, submitted.stdout + submitted.stderr)
            chaos = Chaos(cluster)
            chaos.work(lambda: len(list((out / "runs").glob("[!.]*"))))
        print(f"faults: {chaos.done}, arrays: {len(list((out / 'slurm').glob('[0-9]*')))}")
        self.assertEqual(set(chaos.done), {kind.__name__ for kind in chaos.kinds()})
        self.assertTrue((out / "slurm/2").exists(), "nothing had to be submitted again")
        self.check_same(out, reference, 29)


if __name__ == "__main__":
    SlurmStudy.PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
