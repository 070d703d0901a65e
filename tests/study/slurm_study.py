"""What the tests of `pedzone study run --slurm` share: a study of short runs, and its results."""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from tiny_scenario import TinyScenario, sumo_environment  # noqa: E402

STUDY = """<study seeds="{seeds}" models="striping heuristic" end="60">
  <scenario file="tiny.sumocfg"/>
</study>"""

TABLES = ("runs.csv", "summary.csv")


class SlurmStudy(unittest.TestCase):
    """A folder with a study of two models; `self.local` and `self.on` run it."""

    PEDZONE = None  # set from the command line

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="pedzone-slurm-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        TinyScenario(self.folder).config()

    def study(self, seeds):
        path = self.folder / "study.xml"
        path.write_text(STUDY.format(seeds=seeds))
        return path

    def command(self, *words, environment=None):
        return subprocess.run([self.PEDZONE, "study", *(str(word) for word in words)], text=True,
                              capture_output=True, timeout=600, cwd=self.folder,
                              env=environment or sumo_environment())

    def done(self, *words, environment=None):
        ended = self.command(*words, environment=environment)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        return ended

    def on(self, cluster, *words):
        return self.command(*words, environment={**sumo_environment(), **cluster.environment})

    def local_results(self, study):
        out = self.folder / "local"
        self.done("run", study, "--out", out, "--jobs", "2")
        return out

    def check_same(self, results, reference, seeds):
        """The same tables byte for byte, with both models at each of so many seeds once."""
        for table in TABLES:
            self.assertEqual((results / table).read_text(), (reference / table).read_text(), table)
        with open(results / "runs.csv", newline="", encoding="utf-8") as table:
            rows = [(row["model"], int(row["seed"]), row["status"])
                    for row in csv.DictReader(table)]
        self.assertEqual(sorted(rows), sorted((model, seed + 1, "done") for seed in range(seeds)
                                              for model in ("striping", "heuristic")))
        self.assertEqual(self.run_folders(results), self.run_folders(reference))

    @staticmethod
    def run_folders(results):
        """Names in runs/, those that begin with a dot (runs in the making) too."""
        return sorted(path.name for path in (results / "runs").iterdir())

    @staticmethod
    def logs(results):
        return "\n".join(f"--- {log}\n{log.read_text()}"
                         for log in sorted((results / "slurm").glob("*/*.log")))
