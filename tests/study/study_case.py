"""What tests of `pedzone study` share: a folder with a tiny scenario, studies of it, their results."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from tiny_scenario import WALKS, TinyScenario, sumo_environment  # noqa: E402

STUDY = """<study id="tiny" seeds="{seeds}" models="{models}" end="{end}" timeLimit="{limit}">
  <scenario file="tiny.sumocfg"/>{more}
</study>"""

TABLES = ("runs.csv", "summary.csv", "summary.json")


class StudyCase(unittest.TestCase):
    """Makes the folder `self.folder`; runs write to `self.results`."""

    PEDZONE = None  # set from the command line
    FOLDER = "study"  # name of the folder

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="pedzone-study-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name).resolve() / self.FOLDER
        self.folder.mkdir()
        self.results = self.folder / "results"
        self.tiny = TinyScenario(self.folder)
        self.tiny.config()

    def study(self, seeds="1-2", models="striping nonInteracting", end=20, limit=300, more=""):
        return self.tiny.write("study.xml", STUDY.format(seeds=seeds, models=models, end=end,
                                                         limit=limit, more=more))

    def words(self, *words):
        return [self.PEDZONE, "study", *map(str, words)]

    def command(self, *words, **options):
        return subprocess.run(self.words(*words), text=True, capture_output=True, timeout=300,
                              cwd=self.folder, env=sumo_environment(), **options)

    def start(self, *words):
        """In a session of its own, as from another terminal."""
        return subprocess.Popen(self.words(*words), text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, cwd=self.folder, env=sumo_environment(),
                                start_new_session=True)

    def make(self, study, *words, results=None, code=0):
        """`study run`, which has to end with this code."""
        done = self.command("run", study, "--out", results or self.results, *words)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def run_names(self, results=None):
        """Names in runs/, those of unfinished runs (they begin with a dot) too."""
        folder = (results or self.results) / "runs"
        return sorted(path.name for path in folder.iterdir()) if folder.exists() else []

    def records(self, results=None):
        folder = (results or self.results) / "runs"
        return {name: json.loads((folder / name / "record.json").read_text())
                for name in self.run_names(results) if not name.startswith(".")}

    def statuses(self):
        """By model, of runs of the study proper."""
        found = {}
        for record in self.records().values():
            if record["definition"]["kind"] == "study":
                found.setdefault(Path(record["definition"]["model"]).stem, []).append(
                    record["status"])
        return found

    def check_same_tables(self, results, reference):
        for table in TABLES:
            self.assertEqual((results / table).read_text(), (reference / table).read_text(), table)


def main():
    StudyCase.PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=2)
