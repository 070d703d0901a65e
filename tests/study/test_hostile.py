#!/usr/bin/python3
"""A real study whose names want to be more than names: its files, its tables, its page in Chromium.

usage: test_hostile.py PEDZONE_PROGRAM
"""

import csv
import json
import sys
from pathlib import Path
from xml.sax.saxutils import quoteattr

import study_case

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "browser"))
from browser import Browser  # noqa: E402

SCRIPT = "</script><script>window.injected=1</script><img src=x onerror=window.injected=2>"
TITLE = f"""{SCRIPT}
"quotes" & 'quotes' &amp; {{{{{{scripts}}}}}} `touch pwned` $(touch pwned) ../../title"""
STUDY_ID = f"../../../{SCRIPT} study, \"id\"\nof two lines"
SCENARIO = f"../../{SCRIPT} & 'scenario', \"one\""
FACTOR = f"../{SCRIPT}&factor"
LEVEL = "</script><script>window.injected=3</script>../../'\"&,level"  # without blanks
# No slash and no comma, which have a meaning in lists of files; of all else what a folder may have.
FOLDER = """<img src=x onerror=window.injected=4> "it's" & $(touch pwned) `touch pwned` {{{scripts}}}"""
# SUMO refuses ids with quotes, blanks, commas, less, greater and ampersand.
PERSON = "../../$(touch${IFS}pwned)`touch${IFS}pwned`{{{scripts}}}%3Cscript%3E"
VEHICLE = "../../{{{styles}}}$(touch${IFS}pwned)%22%3E"

ROUTES = f"""<routes>
  <vType id={quoteattr(VEHICLE + "type")}/>
  <personFlow id={quoteattr(PERSON)} begin="0" end="60" period="2">
    <walk edges="shared east" departPos="5"/></personFlow>
  <flow id={quoteattr(VEHICLE)} type={quoteattr(VEHICLE + "type")} begin="0" end="60" period="8"
        from="west" to="east"/>
</routes>"""


def attribute(text):
    return quoteattr(text).replace("\n", "&#10;")


STUDY = f"""<study id={attribute(STUDY_ID)} title={attribute(TITLE)} question={attribute(TITLE)}
       seeds="1-2" end="90">
  <scenario id={attribute(SCENARIO)} file="tiny.sumocfg"/>
  <factor id={attribute(FACTOR)}><level name={attribute(LEVEL)}/>
    <level name="more"><set sumo="scale" value="2"/></level></factor>
</study>"""

READY = """while (!(window.report && window.report.ready))
             await new Promise((done) => setTimeout(done, 20));"""
PLAYED = """while (!window.pedzone) await new Promise((done) => setTimeout(done, 20));
            return window.injected === undefined;"""


class Hostile(study_case.StudyCase):
    FOLDER = FOLDER

    def setUp(self):
        super().setUp()
        self.tiny.write("tiny.rou.xml", ROUTES)
        self.before = self.files()
        self.study = self.tiny.write("study.xml", STUDY)
        self.make(self.study, "--jobs", "2")

    def files(self):
        """Everything in and beside the study's folder, but for its results."""
        return {path: path.read_bytes() if path.is_file() else None
                for path in self.folder.parent.rglob("*")
                if self.results not in (path, *path.parents)}

    def test_names_stay_names(self):
        with self.subTest("files"):
            self.check_files()
        with self.subTest("tables"):
            self.check_tables()
        with Browser() as browser:
            self.check_page(browser)

    def check_files(self):
        after = self.files()
        self.assertEqual(after.pop(self.study), STUDY.encode())
        self.assertEqual(after, self.before)
        self.assertEqual(len(self.run_names()), 12)  # 2 models, 2 levels, 2 seeds; 4 free speeds
        for name in self.run_names():
            self.assertRegex(name, r"\A[A-Za-z0-9_-][A-Za-z0-9._-]{0,99}\Z")
        for path in self.results.rglob("*"):
            self.assertFalse(path.is_symlink(), path)
            self.assertNotIn("pwned", path.name)

    def check_tables(self):
        levels = set()
        for table in ("runs.csv", "summary.csv"):
            with open(self.results / table, newline="") as file:
                rows = list(csv.reader(file))
            head = rows.pop(0)
            self.assertEqual({len(row) for row in rows}, {len(head)})
            self.assertEqual({row[head.index("scenario")] for row in rows}, {SCENARIO})
            levels |= {row[head.index("factor." + FACTOR)] for row in rows}
        self.assertEqual(levels, {LEVEL, "more"})
        summary = json.loads((self.results / "summary.json").read_text())
        self.assertEqual(summary["study"]["id"], STUDY_ID)
        self.assertEqual(summary["study"]["title"], TITLE)
        self.assertEqual(set(self.statuses()), {"striping", "heuristic"})

    def check_page(self, browser):
        browser.open(self.results / "report.html")
        browser.run(READY)
        self.assertEqual(browser.run("return document.querySelector('h1').textContent"), TITLE)
        text = browser.run("return document.body.textContent")
        for name in (SCENARIO, FACTOR, LEVEL):
            self.assertIn(name, text)
        scenes = browser.run("return document.querySelectorAll('.scene').length")
        self.assertGreater(scenes, 1, "no pair side by side, or no encounter")
        for name in (PERSON, VEHICLE):
            self.assertIn(name, text, "encounters name who met")
        browser.run("for (const one of document.querySelectorAll('.scene button')) one.click()")
        for frame in range(scenes):
            browser._call("POST", "/frame", {"id": frame})
            self.assertTrue(browser.run(PLAYED), frame)
            browser._call("POST", "/frame", {"id": None})
        self.assertTrue(browser.run("return window.injected === undefined"))
        self.assertEqual(browser.messages(), [])
        self.assertEqual(browser.requests(), [browser.address])


if __name__ == "__main__":
    study_case.main()
