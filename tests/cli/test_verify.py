#!/usr/bin/python3
"""`pedzone verify`: a quick sample of the standard tests, and what is refused.

usage: test_verify.py PEDZONE_PROGRAM [--all]

With --all: every test with the default and the blind model, three seeds. The default must pass them
all but those that src/verify/README.md says it does not, and a check of behaviour must fail for the
model that minds nobody.
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from refusal import RefusalChecks

PEDZONE = None  # set from the command line
QUICK = ["rimea-1", "juelich-free-flow", "juelich-rotated", "juelich-drift", "rimea-6"]
BLIND = "constant-velocity"
NOT_KEPT = {"diagram-two-ways", "lanes-by-width"}  # by the default


class Verify(RefusalChecks, unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)

    def verify(self, *words):
        return subprocess.run([PEDZONE, "verify", *map(str, words)], cwd=self.folder, text=True,
                              capture_output=True, timeout=280)

    def result(self, *words):
        """The exit code, and what the JSON holds."""
        done = self.verify(*words, "--json", "out/verify.json")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return done.returncode, json.loads((self.folder / "out/verify.json").read_text())

    def test_an_unknown_test_is_refused_with_all_that_are_known(self):
        done = self.verify("--only", "rimea-99", "--html", "out/verify.html")
        self.check_refused(done, "rimea-99", "option --only", *QUICK)

    def test_an_unknown_model_is_refused_with_all_that_are_known(self):
        done = self.verify("--model", "striping", "--json", "out/verify.json")
        self.check_refused(done, "striping", "option --model", "heuristic", BLIND)

    def test_a_bad_number_of_seeds_is_refused(self):
        self.assertEqual(self.verify("--seeds", "0").returncode, 2)

    def test_a_place_that_cannot_be_written_is_refused_before_anything_is_walked(self):
        (self.folder / "file").write_text("")
        done = self.verify("--only", "rimea-9", "--html", "file/verify.html")
        self.check_refused(done, "--html")

    def test_the_list_has_every_test_once(self):
        lines = self.verify("--list").stdout.splitlines()
        ids = [line.split()[0] for line in lines]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertLessEqual(set(QUICK), set(ids))

    def test_single_walkers_pass_and_everything_is_told(self):
        code, found = self.result("--model", "heuristic", "--seeds", "2", "--only", *QUICK)
        self.assertEqual(code, 0)
        self.assertEqual((found["models"], found["seeds"]), (["heuristic"], 2))
        self.assertEqual({test["id"] for test in found["tests"]}, set(QUICK))
        self.assertEqual(found["passed"], {"heuristic": True})
        for test in found["tests"]:
            self.assertTrue(test["source"] and test["setup"], test["id"])
            result = test["results"]["heuristic"]
            self.assertTrue(result["passed"], test["id"])
            for figure in result["figures"]:
                self.assertLessEqual(figure["least"], figure["value"])
                self.assertLessEqual(figure["value"], figure["most"])
                if figure["judged"]:
                    self.assertGreaterEqual(figure["value"], figure["limit_least"] or 0.0)
                    self.assertTrue(figure["limit_source"])

    def test_the_code_is_1_where_the_first_model_fails(self):
        only = ("--only", "moussaid-lanes", "--seeds", "1")
        code, found = self.result("--model", BLIND, *only)
        self.assertEqual(code, 1)
        self.assertFalse(found["passed"][BLIND])

    def test_it_is_the_same_for_any_number_of_threads(self):
        words = ("--model", "heuristic", "--only", "moussaid-lanes", "rimea-6", "--seeds", "2")
        self.assertEqual(self.result(*words, "--threads", "1"),
                         self.result(*words, "--threads", "4"))


class All(unittest.TestCase):
    """All tests, with the two models that have to pass or fail: a few minutes. The others take an
    hour, and nothing is asked of them."""
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "verify.json"
            cls.done = subprocess.run([PEDZONE, "verify", "--model", "heuristic", BLIND,
                                       "--json", str(out)], text=True, stdout=subprocess.PIPE)
            cls.found = json.loads(out.read_text())

    def test_the_default_passes_all_but_the_known_ones(self):
        failed = {test["id"] for test in self.found["tests"]
                  if not test["results"]["heuristic"]["passed"]}
        self.assertEqual(failed, NOT_KEPT, self.done.stdout)
        self.assertEqual(self.done.returncode, 1)

    def test_every_check_of_behaviour_fails_for_the_blind(self):
        passed = [test["id"] for test in self.found["tests"]
                  if test["behaviour"] and test["results"][BLIND]["passed"]]
        self.assertEqual(passed, [])


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv[1]).resolve())
    if "--all" in sys.argv:
        del Verify
    else:
        del All
    unittest.main(argv=sys.argv[:1])
