#!/usr/bin/python3
"""The page of `pedzone validate` in Chromium, against its JSON.

usage: test_validation.py PEDZONE_PROGRAM
"""

import json
import math
import subprocess
import sys
import unittest
from pathlib import Path

import page_case
from browser import Browser

PEDZONE = None  # set from the command line

HOSTILE = "<img src=x onerror=window.injected=1>"  # a name of files may hold it, too
MODELS = ["straight to goal", "constant velocity", "plain", "orca", "heuristic"]  # as the page has them
DRAWN = ["straight to goal", "plain", "heuristic"]
SEEDS = 2


def clip(offset):
    """Two persons cross the way of a vehicle."""
    rows = ["t,kind,id,x,y,heading,front,rear,half_width"]
    for k in range(81):
        for name, x in (("1", 10.0 + offset), (HOSTILE, 11.5 + offset)):
            rows.append(f"{k / 10:.1f},ped,{name},{x + 0.4 * math.sin(0.06 * k):.3f},"
                        f"{-4.0 + 0.12 * k:.3f},,,,")
        rows.append(f"{k / 10:.1f},veh,v,{-4.0 + 0.25 * k:.3f},0,0,2.1,2.1,0.8")
    return "\n".join(rows) + "\n"


class Page(page_case.PageCase):
    @classmethod
    def setUpClass(cls):
        folder = cls.make_folder()
        for k, site in enumerate(("here", HOSTILE)):
            (folder / "data" / site).mkdir(parents=True)
            for name in ("front_01", f"back_02{HOSTILE}"):
                (folder / "data" / site / f"{name}.csv").write_text(clip(k))
        cls.page = folder / "validation.html"
        subprocess.run([PEDZONE, "validate", "--data", folder / "data", "--model", *MODELS[3:],
                        "--seeds", str(SEEDS), "--resamples", "20", "--html", cls.page, "--json",
                        folder / "v.json"], check=True, capture_output=True, timeout=300)
        cls.rows = json.loads((folder / "v.json").read_text())["rows"]
        cls.groups = list(dict.fromkeys(row["group"] for row in cls.rows))
        cls.browser = Browser().__enter__()
        cls.addClassCleanup(cls.browser.__exit__, None, None, None)

    def open_all(self):
        self.browser.run("""for (const one of document.querySelectorAll("details")) one.open = true;
                            await new Promise((done) => setTimeout(done, 500));""")

    def test_nothing_is_fetched_nothing_complains_and_no_name_is_run(self):
        self.open()
        self.open_all()
        self.assertEqual(self.browser.requests(), [self.browser.address])
        self.assertEqual(self.browser.messages(), [])
        self.assertIsNone(self.ask("window.injected"))
        self.assertEqual(self.ask("document.querySelectorAll('main img').length"), 0)
        self.assertIn(HOSTILE, self.ask("document.querySelector('#worst').textContent"))

    def test_tables_have_the_figures_of_the_json(self):
        self.open()
        tables = self.ask("""[...document.querySelectorAll("#tables .figures")].map((table) =>
            [table.closest(".scroll").previousElementSibling.firstChild.textContent.trim(),
             [...table.querySelectorAll("tbody tr")].map((row) =>
               [...row.children].map((cell) => cell.firstChild.textContent))])""")
        self.assertEqual([name for name, _ in tables], self.groups)
        for name, lines in tables:
            rows = [row for row in self.rows if row["set"] == "recorded" and row["group"] == name]
            self.assertEqual([line[0] for line in lines], ["recorded"] + MODELS)
            for line, row in zip(lines, rows, strict=True):
                keys = list(row["figures"])
                for key, digits in (("clearance", 2), ("first_count", 0), ("ade", 2)):
                    value = row["figures"][key]["value"]
                    self.assertEqual(line[1 + keys.index(key)],
                                     "–" if value is None else f"{value:.{digits}f}", key)

    def test_what_must_be_seen_at_once_is_open(self):
        self.open()
        seen = self.ask("""[...document.querySelectorAll("#tables .figures")].map(
            (table) => table.getBoundingClientRect().height > 50)""")
        self.assertEqual(seen, [True] * len(self.groups), "the manoeuvres' tables, too")
        sites = self.ask("""[...document.querySelectorAll("#glance h3")].map(
            (heading) => heading.firstChild.textContent.trim())""")
        self.assertEqual(sites, ["all", HOSTILE, "here"])
        first = self.ask("document.querySelector('header p:not(.kind)').textContent")
        self.assertIn("tuned on 27 clips", first)
        self.assertIn("None of them is scored here", first)
        self.assertIn("4 of the 4 clips scored here it was not tuned on", first)
        self.assertIn(HOSTILE, first)

    def test_four_clips_have_no_intervals(self):
        self.open()
        small = self.ask("""[...document.querySelectorAll("#tables td")].filter(
            (cell) => cell.firstChild.textContent !== "–").map(
            (cell) => cell.querySelector("small").textContent)""")
        self.assertEqual(set(small), {"—", ""}, "a dash, and nothing below a count")
        self.assertGreater(small.count("—"), small.count(""))

    def test_every_row_has_a_dot_at_its_value(self):
        self.open()
        charts = self.ask("""[...document.querySelectorAll("#glance .chart")].map((chart) =>
            ({dots: [...chart.querySelectorAll(".mark-symbol path")].map((dot) =>
                [getComputedStyle(dot).fill, dot.getBoundingClientRect().x]),
              texts: [...chart.querySelectorAll(".mark-text text")].map(
                (text) => text.textContent).filter((text) => /^[0-9.]+$/.test(text))}))""")
        self.assertEqual(len(charts), 4 * 3, "of all, and of two sites")
        rows = [row for row in self.rows if row["set"] == "recorded" and row["group"] == "all"]
        values = [row["figures"]["clearance"]["value"] for row in rows]
        self.assertEqual(len({colour for colour, _ in charts[0]["dots"]}), 1 + len(MODELS))
        places = [x for _, x in charts[0]["dots"]]
        order = sorted(range(len(values)), key=values.__getitem__)
        self.assertEqual(sorted(places), [places[k] for k in order])
        for value in values:
            self.assertIn(f"{value:.2f}", charts[0]["texts"])

    def test_curves_rise_to_all_persons_also_where_they_are_folded(self):
        self.open()
        count = """[...document.querySelectorAll("[data-group]")].filter(
            (place) => place.childElementCount > 0).length"""
        self.assertEqual(self.ask(count), 3, "all, and two sites")
        self.open_all()
        self.assertEqual(self.ask(count), 2 * len(self.groups))
        curves = self.ask("""[...document.querySelectorAll("[data-group] .chart svg.marks")].map((svg) =>
            [...svg.querySelectorAll(".mark-line path")].map((curve) => {
              const box = curve.getBBox(), frame = svg.querySelector(".background").getBBox();
              return [box.height / frame.height, box.width / frame.width,
                      getComputedStyle(curve).stroke];
            }))""")
        self.assertEqual(len(curves), 4 * 2 * len(self.groups))
        for chart in curves:
            self.assertEqual(len(chart), 1 + len(DRAWN))
            self.assertEqual(len({colour for _, _, colour in chart}), len(chart))
            for height, width, _ in chart:
                self.assertAlmostEqual(height, 1.0, delta=0.02)
                self.assertAlmostEqual(width, 1.0, delta=0.02)

    def test_a_model_has_one_colour_in_tables_charts_and_pictures(self):
        self.open()
        colours = self.ask("""[
            getComputedStyle(document.querySelector("#tables .main th path")).stroke,
            getComputedStyle([...document.querySelectorAll("#glance .mark-symbol path")][5]).fill,
            getComputedStyle([...document.querySelectorAll(
              "#curves .chart .mark-line path")][3]).stroke,
            getComputedStyle(document.querySelector("figure .way.walked")).stroke]""")
        self.assertEqual(set(colours), {"rgb(0, 114, 178)"})

    def test_cases_are_drawn(self):
        self.open()
        pictures = self.ask("""[...document.querySelectorAll(".case")].map((one) =>
            ({width: one.querySelector("svg").getBoundingClientRect().width,
              ways: one.querySelectorAll(".way").length,
              vehicles: one.querySelectorAll(".vehicle").length}))""")
        self.assertEqual(len(pictures), 4)  # one of a clip
        for picture in pictures:
            self.assertGreater(picture["width"], 300)
            self.assertEqual(picture["ways"], 2)
            self.assertGreater(picture["vehicles"], 3)

    def test_it_fits_a_phone(self):
        self.open(390, 844, mobile=True)
        self.open_all()
        self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), 390)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv[1]).resolve())
    del sys.argv[1]
    unittest.main()
