#!/usr/bin/python3
"""The report of a real study in Chromium, on paper too, against the study's own tables.

usage: test_report.py PEDZONE_PROGRAM SCENARIOS_FOLDER
"""

import csv
import os
import re
import statistics
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.sax.saxutils import quoteattr

from browser import Browser

PEDZONE = SCENARIOS = None  # set from the command line

HOSTILE = """</script><script>window.injected = 1</script><img src=x onerror="window.injected=2">"""
HOSTILE_NAME = HOSTILE.replace("<img ", "<img/").replace(" onerror", "/onerror").replace(" ", "")
STREET = """<study id="street" seeds="1-2" end="200">
  <scenario id="cars" file="@folder@/cars-1200.sumocfg" zone="@folder@/cross-anywhere.zone.xml"/>
</study>"""
SEEDS = (1, 2, 3, 4)
MODELS = ("striping", "heuristic")
LEVELS = ("normal", HOSTILE_NAME)
STUDY = f"""<study id="page" title={quoteattr("Plaza " + HOSTILE)} question={quoteattr(HOSTILE)}
       seeds="1-4" end="60">
  <scenario id="plaza" file={quoteattr("@scenario@")}/>
  <factor id="demand"><level name="normal"/>
    <level name={quoteattr(HOSTILE_NAME)}><set sumo="scale" value="2"/></level></factor>
</study>"""

READY = """while (!(window.report && window.report.ready))
             await new Promise((done) => setTimeout(done, 20));
           await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));"""


def call(*words, folder, timeout=900):
    environment = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
    return subprocess.run(list(map(str, words)), cwd=folder, check=True, capture_output=True,
                          timeout=timeout, env=environment, stdin=subprocess.DEVNULL).stdout


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        cls.folder = folder = Path(cls.directory.name)
        (folder / "page.study.xml").write_text(
            STUDY.replace("@scenario@", str(SCENARIOS / "plaza/plaza-low.sumocfg")))
        call(PEDZONE, "study", "run", "page.study.xml", "--out", "results", "--jobs", "2",
             folder=folder)
        call(PEDZONE, "study", "report", "results", folder=folder)
        cls.page = folder / "results/report.html"
        with open(folder / "results/runs.csv", newline="") as file:
            cls.runs = list(csv.DictReader(file))
        cls.browser = Browser().__enter__()
        cls.addClassCleanup(cls.browser.__exit__, None, None, None)

    def open(self, width=1280, height=900, mobile=False, page=None):
        self.browser.resize(width, height, mobile)
        self.browser.open(page or self.page)
        self.browser.run(READY)

    def ask(self, expression, *arguments):
        return self.browser.run("return " + expression, *arguments)

    def values(self, level, model, measure):
        found = [float(row[measure]) for row in self.runs
                 if (row["factor.demand"], row["model"]) == (level, model) and row[measure]]
        self.assertEqual(len(found), len(SEEDS), (level, model, measure))
        return found

    # It needs nothing else

    def test_nothing_is_fetched_and_nothing_complains(self):
        self.open()
        self.assertEqual(self.browser.requests(), [self.browser.address])
        self.assertEqual(self.browser.messages(), [])

    # It says what the tables say

    def test_means_and_differences_are_those_of_the_runs(self):
        self.open()
        tables = self.ask("""[...document.querySelectorAll(".forests")].map((table) => ({
            rows: [...table.tBodies[0].rows].map((row) => [...row.cells].map(
                (cell) => cell.textContent))}))""")
        self.assertEqual(len(tables), len(LEVELS))
        shown = {"people's travel time s": "person.travelTime",
                 "people's speed in the zone m/s": "person.speed",
                 "vehicles' stops": "vehicle.stops"}
        number = r"[−+]?[0-9.]+"
        for level, table in zip(LEVELS, tables):
            rows = {row[0]: row for row in table["rows"]}
            for name, measure in shown.items():
                reference, model = (self.values(level, one, measure) for one in MODELS)
                for text, expected in ((rows[name][1], statistics.mean(reference)),
                                       (rows[name][2], statistics.mean(model)),
                                       (re.match(number, rows[name][3])[0],
                                        statistics.mean(model) - statistics.mean(reference))):
                    digits = len(text.partition(".")[2])
                    self.assertAlmostEqual(float(text.replace("−", "-")), expected,
                                           delta=0.51 * 10 ** -digits, msg=(level, name, text))

    def test_one_sentence_comes_first_then_the_free_speed_then_the_table(self):
        self.open()
        first = self.ask("""document.querySelector("#verdict p").textContent""")
        self.assertRegex(first, "^(With heuristic instead of striping, |No difference was found|"
                                "Nothing is certain|Too few seeds|Too few runs)")
        order = self.ask("""[...document.querySelectorAll(
            "#verdict .summary, #verdict .free:not(.warning), #verdict table, #verdict ul.found")].map(
            (one) => one.tagName + (one.classList.contains("summary") ? " summary" : ""))""")
        self.assertEqual(order, ["P summary", "P", "TABLE", "UL"])
        free = self.ask("""document.querySelector("#verdict .free:not(.warning)").textContent""")
        self.assertRegex(free, "(?i)with interaction switched off, heuristic walks "
                                "(as fast as|[0-9.]+ % (slower|faster) than) striping")

    # Its charts hold the runs

    def test_distributions_have_a_point_for_each_run_and_a_box_for_each_model(self):
        self.open()
        charts = self.ask("""[...document.querySelectorAll("#distribution-charts .chart")].map(
            (chart) => ({title: chart.querySelector("h4").textContent,
                         points: chart.querySelectorAll(".mark-symbol path").length,
                         boxes: chart.querySelectorAll(".mark-rect path").length}))""")
        titles = {one["title"]: one for one in charts}
        for title, measure in (("People's travel time", "person.travelTime"),
                               ("Vehicles' stops", "vehicle.stops")):
            runs = [row for row in self.runs if row[measure]]
            self.assertEqual(titles[title]["points"], len(runs), titles)
            self.assertGreaterEqual(titles[title]["boxes"], len(LEVELS) * len(MODELS), titles)

    def test_lines_over_time_are_drawn_in_the_models_colours(self):
        self.open()
        colours, found = self.browser.run("""
            const probe = document.createElement("i");
            document.body.append(probe);
            const colours = ["--model-0", "--model-1"].map((name) => {
                probe.style.color = `var(${name})`;
                return getComputedStyle(probe).color;
            });
            probe.remove();
            const looks = (chart, marks, part) => [...chart.querySelectorAll(marks + " path")].map(
                (path) => getComputedStyle(path)[part]);
            return [colours, [...document.querySelectorAll("[data-series] .chart")].map(
                (chart) => [looks(chart, ".mark-area", "fill"),
                            looks(chart, ".mark-line", "stroke")])];""")
        self.assertGreaterEqual(len(found), 4)
        self.assertNotEqual(*colours)
        for bands, means in found:
            self.assertEqual([bands, means], [colours, colours])

    def test_lines_over_time_have_the_seeds_means(self):
        self.open()
        title, mean, drawn = self.browser.run("""
            const [{times, lines}] = report.data.series[0];
            const chart = document.querySelector("[data-series] .chart");
            const shape = chart.querySelector(".mark-line path").getAttribute("d");
            return [chart.querySelector("h4").textContent, lines.persons.mean,
                    [...shape.matchAll(/[ML]([-0-9.e]+),([-0-9.e]+)/g)].map(
                        ([, x, y]) => [Number(x), Number(y)])];""")
        self.assertEqual(title, "People in the zone")
        mean = [value for value in mean if value is not None]
        self.assertEqual(len(drawn), len(mean))
        # Heights are linear in the values: the largest is the highest, the rest in proportion.
        low, high = min(mean), max(mean)
        bottom, top = max(y for _, y in drawn), min(y for _, y in drawn)
        for value, (_, y) in zip(mean, drawn):
            self.assertAlmostEqual(y, bottom + (top - bottom) * (value - low) / (high - low),
                                   delta=0.1)

    def test_conditions_that_are_opened_are_drawn(self):
        self.open()
        drawn = """[...document.querySelectorAll("details.condition")].map(
                   (one) => one.querySelectorAll("[data-series] svg").length)"""
        before = self.ask(drawn)
        self.assertGreaterEqual(before[0], 4)
        self.assertEqual(before[1], 0)
        self.browser.click("details.condition:nth-of-type(2) > summary")
        self.browser.run(READY)
        self.assertEqual(self.ask(drawn), [before[0], before[0]])

    def test_maps_lie_over_the_place_and_share_a_scale(self):
        self.open()
        maps = self.ask("""[...document.querySelectorAll(".maps")].map((figure) => ({
            legend: figure.querySelectorAll(".legend span").length,
            colours: [...figure.querySelectorAll(".legend path")].map((one) =>
                one.getAttribute("fill")),
            pictures: [...figure.querySelectorAll("svg.map")].map((map) => ({
                ground: !!document.querySelector(map.querySelector("use").getAttribute("href")
                                                 + " path"),
                box: map.getAttribute("viewBox"),
                fills: [...map.querySelectorAll(":scope > path[fill]")].map((one) =>
                    one.getAttribute("fill"))}))}))""")
        self.assertGreaterEqual(len(maps), len(LEVELS))
        for figure in maps:
            self.assertEqual(len(figure["pictures"]), len(MODELS))
            self.assertEqual(len({one["box"] for one in figure["pictures"]}), 1)
            for picture in figure["pictures"]:
                self.assertTrue(picture["ground"])
                self.assertLessEqual(set(picture["fills"]), set(figure["colours"]))
        density = maps[0]["pictures"]
        self.assertTrue(all(one["fills"] for one in density), "somebody was everywhere")

    def test_letters_of_still_pictures_can_be_read_and_are_not_cut(self):
        self.open()
        stills = self.ask("""[...document.querySelectorAll(".still svg")].filter((one) =>
            !one.parentElement.closest("svg")).map((one) => {
          const frame = one.getBoundingClientRect();
          return [...one.querySelectorAll("text")].map((text) => {
            const box = text.getBoundingClientRect();
            return {text: text.textContent, height: box.height,
                    inside: box.left >= frame.left && box.right <= frame.right
                            && box.top >= frame.top && box.bottom <= frame.bottom};
          });
        })""")
        self.assertGreaterEqual(len(stills), 2)
        for texts in stills:
            self.assertTrue(texts)
            for text in texts:
                self.assertGreaterEqual(text["height"], 10.0, text)
                self.assertTrue(text["inside"], text)

    def test_gaps_are_not_spoken_of_where_no_street_may_be_crossed_anywhere(self):
        self.open()
        self.assertIsNone(self.ask("document.getElementById('gaps')"))
        self.assertNotIn("kerb", self.ask("document.querySelector('main').textContent"))

    def test_gaps_are_drawn_of_all_seeds(self):
        (self.folder / "street.study.xml").write_text(
            STREET.replace("@folder@", str(SCENARIOS / "cross-anywhere")))
        call(PEDZONE, "study", "run", "street.study.xml", "--out", "street", "--jobs", "2",
             folder=self.folder)
        taken, left, seconds = 0, 0, set()
        for file in self.folder.glob("street/runs/*/crossings.csv"):
            with open(file, newline="") as table:
                for row in csv.DictReader(table):
                    passed = [float(gap) for gap in row["let_pass"].split()]
                    own = [float(row["gap"])] if row["gap"] else []
                    if row["place"] != "between":
                        continue
                    taken, left = taken + len(own), left + len(passed)
                    seconds |= {int(gap) for gap in passed + own if gap < 20}
        self.assertGreater(min(taken, left), 5)
        for width, mobile in ((1280, False), (390, True)):
            self.open(width, 844, mobile, page=self.folder / "street/report.html")
            self.assertEqual(self.browser.messages(), [])
            dots, curves, diamonds = (self.ask(
                f"document.querySelectorAll('#gap-charts .{marks} path').length")
                for marks in ("layer_0_marks", "layer_1_marks", "layer_3_marks"))
            self.assertEqual((dots, curves, diamonds), (len(seconds), 1, 1))
            self.assertEqual(self.ask("document.querySelector('#gap-keys').textContent"),
                             "heuristic")
            row = self.ask("[...document.querySelectorAll('#gaps tbody td')].map((cell) => "
                           "cell.textContent)")
            self.assertRegex(row[0], r"^\d+\.\d \[−?\d+\.\d, \d+\.\d\]$")
            self.assertEqual(row[1:], [str(taken), str(left)])
            self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), width)

    # It plays

    def test_a_scene_plays_when_it_is_opened(self):
        self.open()
        self.assertGreater(self.ask("""document.querySelectorAll(".scene").length"""), 0)
        self.assertEqual(self.ask("document.querySelectorAll('iframe').length"), 0)
        self.browser.click(".scene button")
        self.browser.enter_frame(".scene iframe")
        try:
            begin = self.browser.run("""
                while (!window.pedzone) await new Promise((done) => setTimeout(done, 20));
                return pedzone.clock.time;""")
            self.browser.click("#play")
            state = self.browser.run("""
                while (pedzone.clock.time < arguments[0] + 0.5)
                    await new Promise((done) => requestAnimationFrame(done));
                return pedzone.state();""", begin)
        finally:
            self.browser.leave_frame()
        self.assertTrue(state["panels"][0]["persons"])
        self.assertEqual(self.browser.messages(), [])

    # Whoever made the input

    def test_hostile_names_are_text(self):
        self.open()
        self.assertEqual(self.ask("document.querySelector('h1').textContent"), "Plaza " + HOSTILE)
        self.assertEqual(self.ask("document.title"), "Plaza " + HOSTILE)
        self.assertIn(HOSTILE_NAME, self.ask("document.querySelector('#setup').textContent"))
        self.assertEqual(self.ask("""[window.injected, document.images.length,
            document.querySelectorAll("[onerror]").length]"""), [None, 0, 0])

    # Wherever it is shown

    def test_on_a_phone_nothing_scrolls_sideways(self):
        for width in (390, 320):
            self.open(width, 844, True)
            self.assertEqual(self.ask("innerWidth"), width)
            self.assertLessEqual(
                self.ask("""Math.max(document.documentElement.scrollWidth,
                                     document.body.scrollWidth)"""), width)

    def test_light_and_dark(self):
        self.addCleanup(self.browser.prefer, "light")
        luminance = """return ["backgroundColor", "color"].map((name) =>
            getComputedStyle(document.body)[name].match(/[0-9]+/g).slice(0, 3)
                .reduce((sum, part) => sum + Number(part), 0) / 765)"""
        for scheme, dark in (("dark", True), ("light", False)):
            self.browser.prefer(scheme)
            self.open()
            ground, ink = self.browser.run(luminance)
            self.assertEqual(ground < ink, dark)
            self.assertGreater(abs(ground - ink), 0.6)

    def test_the_axis_of_differences_stays_in_sight_on_a_phone(self):
        self.open(390, 844, True)
        axis, zero, forest = self.ask("""(() => {
            const table = document.querySelector(".forests");
            const row = [...table.tBodies[0].rows].at(-1);
            row.scrollIntoView({block: "center"});
            const box = (one) => {
              const {left, right, top, bottom} = one.getBoundingClientRect();
              return {left, right, top, bottom};
            };
            return [box(table.querySelector("th.axis")),
                    box(table.querySelectorAll("th.axis span")[1]), box(row.querySelector("svg"))];
        })()""")
        self.assertGreaterEqual(axis["top"], 0)
        self.assertLess(axis["bottom"], forest["top"])
        self.assertAlmostEqual((zero["left"] + zero["right"]) / 2,
                               (forest["left"] + forest["right"]) / 2, delta=4)

    def test_the_screen_is_as_it_was_after_printing(self):
        self.open()
        shape = """[...document.querySelectorAll("main details")].map(
            (one) => [one.open, one.parentElement.id, one.querySelector("summary").textContent])"""
        before = self.ask(shape)
        self.browser.print_page(self.folder / "again.pdf")
        self.assertEqual(self.ask(shape), before)
        self.assertIsNone(self.ask("document.getElementById('appendix')"))

    def test_on_paper(self):
        self.open()
        paper = self.folder / "report.pdf"
        self.browser.print_page(paper)
        text = call("pdftotext", "-layout", paper, "-", folder=self.folder).decode()
        pages = text.rstrip("\f").split("\f")
        self.assertGreater(len(pages), 2)
        self.assertIn("What the study found", pages[0])
        self.assertIn("pedzone study run", text)
        for number, page in enumerate(pages, 1):
            self.assertIn(f"{number} / {len(pages)}", page)
        # The second condition is folded on the screen.
        appendix = text[text.index("Appendix\n"):]
        self.assertIn("Speed of people in the zone", appendix)
        self.assertRegex(appendix, r"\b20 s\b.*\b40 s\b", "lines over time are drawn")
        self.assertIn("Density of people", appendix)
        call("pdftoppm", "-r", "40", "-gray", paper, "page", folder=self.folder)
        pictures = sorted(self.folder.glob("page-*.pgm"))
        self.assertEqual(len(pictures), len(pages))
        for picture in pictures:
            _, size, _, pixels = picture.read_bytes().split(b"\n", 3)
            width, height = map(int, size.split())
            self.assertEqual((width, height), (331, 468), "A4")
            inked = sum(pixel < 200 for pixel in pixels)
            self.assertGreater(inked, 0.002 * width * height, f"{picture.name} is blank")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv[1]).resolve())
    SCENARIOS = Path(sys.argv[2]).resolve()
    del sys.argv[1:3]
    unittest.main()
