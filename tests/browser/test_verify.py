#!/usr/bin/python3
"""The page of `pedzone verify` in Chromium, against its JSON.

usage: test_verify.py PEDZONE_PROGRAM
"""

import json
import subprocess
import sys
import unittest
from pathlib import Path

import page_case
from browser import Browser

PEDZONE = None  # set from the command line

MODELS = ["heuristic", "orca", "constant-velocity"]
TESTS = ["rimea-1", "rimea-8", "rimea-13", "moussaid-lanes"]
CHARTED, MAPPED = "rimea-8", "rimea-13"


class Page(page_case.PageCase):
    @classmethod
    def setUpClass(cls):
        folder = cls.make_folder()
        cls.page = folder / "verify.html"
        done = subprocess.run([PEDZONE, "verify", "--model", *MODELS, "--only", *TESTS, "--seeds",
                               "2", "--html", cls.page, "--json", folder / "verify.json"],
                              capture_output=True, text=True, timeout=600)
        assert done.returncode in (0, 1), done.stderr
        found = json.loads((folder / "verify.json").read_text())
        cls.tests = {test["id"]: test for test in found["tests"]}
        cls.browser = Browser().__enter__()
        cls.addClassCleanup(cls.browser.__exit__, None, None, None)

    def test_nothing_is_fetched_and_nothing_complains(self):
        self.open()
        self.assertEqual(self.browser.requests(), [self.browser.address])
        self.assertEqual(self.browser.messages(), [])

    def test_the_overview_says_who_passes_what(self):
        self.open()
        rows = self.ask("""[...document.querySelectorAll("#overview tbody tr")].map(
            (row) => [row.querySelector("a")?.hash.slice(1),
                      ...[...row.querySelectorAll("td")].map((cell) => cell.textContent)])""")
        for test, *marks in rows[:-1]:
            expected = ["passed" if self.tests[test]["results"][model]["passed"] else "failed"
                        for model in MODELS]
            self.assertEqual(marks, expected, test)
        self.assertEqual({row[0] for row in rows[:-1]}, set(TESTS))

    def test_figures_are_those_of_the_json(self):
        self.open()
        for test in TESTS:
            rows = self.ask("""[...document.querySelectorAll(`#${arguments[0]} .figures tbody tr`)]
                .map((row) => [...row.querySelectorAll("td:not(.limits)")].map(
                    (cell) => [cell.firstChild.textContent, cell.className]))""", test)
            self.assertEqual(len(rows), len(self.tests[test]["results"][MODELS[0]]["figures"]))
            for f, row in enumerate(rows):
                for (text, name), model in zip(row, MODELS):
                    figure = self.tests[test]["results"][model]["figures"][f]
                    digits = len(text.partition(".")[2])
                    self.assertAlmostEqual(float(text), figure["value"],
                                           delta=0.51 * 10 ** -digits)
                    self.assertEqual(name, "told" if not figure["judged"] else
                                     "good" if figure["passed"] else "bad")

    def test_every_test_is_drawn_and_charts_have_every_model(self):
        self.open()
        drawn = self.ask("""[...document.querySelectorAll(".drawing svg")].map(
            (svg) => svg.getBoundingClientRect().width * svg.getBoundingClientRect().height)""")
        self.assertEqual(len(drawn), len(TESTS))
        self.assertGreater(min(drawn), 1000)
        points = self.ask("""document.querySelectorAll(
            `#${arguments[0]} .chart .mark-symbol path`).length""", CHARTED)
        curve = self.tests[CHARTED]["results"][MODELS[0]]["curves"]["time"]
        self.assertEqual(points, len(MODELS) * len(curve))

    def test_density_maps_show_people(self):
        self.open()
        self.browser.click(f"#{MAPPED} summary")
        cells = self.ask("""[...document.querySelectorAll(`#${arguments[0]} .map`)].map(
            (map) => map.querySelectorAll("path").length)""", MAPPED)
        self.assertEqual(len(cells), len(MODELS))
        self.assertGreater(min(cells), 0)

    def test_it_fits_a_phone(self):
        self.open(390, 844, mobile=True)
        self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), 390)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv[1]).resolve())
    del sys.argv[1]
    unittest.main()
