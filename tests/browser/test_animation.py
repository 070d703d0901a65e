#!/usr/bin/python3
"""`pedzone animate`: its page in Chromium, against the recording it was made from.

usage: test_animation.py PEDZONE_PROGRAM SCENARIOS_FOLDER
"""

import csv
import math
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from browser import Browser
from recorded import Recorded
from recorded_page import SET_TIME, SETTLED, STATE, call, enter, open_page

PEDZONE = SCENARIOS = None  # set from the command line

RATE = 5  # [1/s] of the steps that the page keeps; the recording has 10
ROUNDING = 0.0051  # [m] the page keeps places to the centimetre
HOSTILE = """</script><script>window.injected = 1</script><img src=x onerror="window.injected=2">
'&amp;"""  # a line end, quotes and an entity, too

# Where on the window a person or vehicle is drawn.
ON_SCREEN = SETTLED + """
const [kind, id, number] = arguments, panel = pedzone.panels[number];
const pose = panel[kind].find((one) => one.track.id === id);
const box = panel.canvas.getBoundingClientRect(), [x, y] = panel.to_screen(pose.x, pose.y);
return [box.left + x, box.top + y];"""
# Places of all controls that are to be seen, as far as their column has not been scrolled away.
BOXES = """
return [...document.querySelectorAll('button, input, select, output, summary, h1')].filter(
  (one) => one.offsetParent).map((one) => {
    const {left, top, right, bottom} = one.getBoundingClientRect();
    const window = (one.closest('aside') || document.body).getBoundingClientRect();
    return {id: one.id || one.tagName, left, right, top: Math.max(top, window.top),
            bottom: Math.min(bottom, window.bottom)};
  }).filter(({top, bottom}) => top < bottom);"""


class Animation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        cls.folder = folder = Path(cls.directory.name)
        cls.scenario = SCENARIOS / "plaza/plaza-low.sumocfg"
        types = ET.parse(SCENARIOS / "plaza/plaza.vehicles.rou.xml").iter("vType")
        cls.sizes = {one.get("id"): (float(one.get("length")), float(one.get("width")))
                     for one in types}
        call(PEDZONE, "run", cls.scenario, "--end", "60", "--trajectories", "walked.csv", "--",
             "--fcd-output", folder / "walked.xml", folder=folder)
        call("sumo", "-c", cls.scenario, "--end", "60", "--fcd-output", folder / "striping.xml",
             folder=folder)
        hostile = HOSTILE.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
        hostile = hostile.replace('"', "&quot;").replace("\n", "&#10;")
        cls.recorded = {name: Recorded(folder / f"{name}.xml", cls.sizes)
                        for name in ("walked", "striping")}
        victim = next(iter(cls.recorded["striping"].at("persons", 30)))
        text = (folder / "striping.xml").read_text()
        (folder / "hostile.xml").write_text(text.replace(f'"{victim}"', f'"{hostile}"'))
        cls.animate("walked.xml", "one.html")
        cls.animate("walked.csv", "both.html", "--fcd", "walked.xml", "--beside", "striping.xml")
        cls.animate("hostile.xml", "hostile.html", "--title", HOSTILE, "--name", HOSTILE)
        cls.browser = enter(cls, Browser())

    @classmethod
    def animate(cls, recording, page, *words):
        call(PEDZONE, "animate", recording, "--scenario", cls.scenario, "--rate", RATE,
             "--out", page, *words, folder=cls.folder)

    def open(self, page, width=1280, height=800, mobile=False):
        return open_page(self.browser, self.folder / page, width, height, mobile)

    def tearDown(self):
        self.assertEqual(self.browser.messages(), [], "the console stays empty")
        asked = set(self.browser.requests())
        self.assertEqual({one for one in asked if not one.startswith("data:")},
                         {self.browser.address}, "nothing but the page is asked for")

    def check_places(self, shown, kind, expected, tolerance=ROUNDING):
        places = {one["id"]: (one["x"], one["y"]) for one in shown[kind]}
        self.assertEqual(set(places), set(expected))
        for name, place in places.items():
            self.assertLessEqual(math.dist(place, expected[name]), tolerance * math.sqrt(2), name)

    def check_recorded(self, shown, recorded, time, every=2):
        for kind in ("persons", "vehicles"):
            # Vehicles' headings are kept to half a degree.
            self.check_places(shown, kind, recorded.at(kind, time, every))

    # It plays

    def test_shows_the_recording_from_its_beginning(self):
        state = self.open("one.html")
        recorded = self.recorded["walked"]
        self.assertEqual(state["time"], recorded.times[0])
        self.assertFalse(state["playing"])
        self.assertEqual(self.browser.run("return document.title"), "plaza-low")

    def test_the_slider_moves_people(self):
        self.open("one.html")
        recorded = self.recorded["walked"]
        seen = []
        for wanted in (20, 33, 30, 59):
            state = self.browser.run(SET_TIME, wanted)
            self.assertAlmostEqual(state["time"], wanted, delta=0.5 / RATE + 1e-9)
            (shown,) = state["panels"]
            self.check_recorded(shown, recorded, state["time"])
            self.assertGreater(len(shown["persons"]), 1)
            seen.append({one["id"]: one["x"] for one in shown["persons"]})
        both = set(seen[1]) & set(seen[2])
        self.assertTrue([name for name in both if abs(seen[1][name] - seen[2][name]) > 1])

    def test_its_colours_are_the_palettes(self):
        self.open("one.html")
        blue, walker, zone = self.browser.run("""
            const light = getComputedStyle(document.documentElement);
            return ["--blue", "--walker", "--zone"].map((name) => light.getPropertyValue(name));""")
        self.assertRegex(zone, "^#[0-9a-f]{6}$")
        self.assertEqual(walker, blue)

    def test_people_are_drawn_where_they_are(self):
        self.open("one.html")
        self.browser.run(SET_TIME, 30.0)
        drawn = self.browser.run("""
            const panel = pedzone.panels[0], copy = document.createElement("canvas");
            const places = panel.persons.map((pose) => panel.to_screen(pose.x, pose.y));
            const colours = () => {
              Object.assign(copy, {width: panel.canvas.width, height: panel.canvas.height});
              const context = copy.getContext("2d", {willReadFrequently: true});
              context.drawImage(panel.canvas, 0, 0);
              return places.map(([x, y]) => context.getImageData(
                x * panel.ratio, y * panel.ratio, 1, 1).data.join());
            };
            const with_people = colours();
            panel.figures = () => [];
            panel.draw(pedzone.clock.time, null);
            const without = colours();
            return with_people.map((one, i) => one !== without[i]);""")
        self.assertGreater(len(drawn), 3)
        self.assertTrue(all(drawn))

    def test_plays_and_pauses(self):
        before = self.open("one.html")["time"]
        self.browser.click("#play")
        self.browser.run(f"while (pedzone.clock.time < {before} + 0.5)" + SETTLED)
        self.assertEqual(self.browser.run("return document.getElementById('play').ariaLabel"),
                         "Pause")
        self.browser.run("document.activeElement.blur();")
        self.browser.press(" ")
        first, second = self.browser.run(STATE), self.browser.run(STATE)
        self.assertFalse(first["playing"])
        self.assertEqual(first["time"], second["time"])
        slider = self.browser.run("return Number(document.getElementById('time').value)")
        self.assertAlmostEqual(slider, first["time"], delta=0.5 / RATE + 1e-9)
        # Between the steps that are kept, too, people are where even motion has them.
        self.check_recorded(first["panels"][0], self.recorded["walked"], first["time"])

    def test_speed(self):
        self.open("one.html")
        advanced = self.browser.run("""
            const speed = document.getElementById("speed"), found = [];
            for (const option of speed.options) {
              speed.value = option.value;
              speed.dispatchEvent(new Event("change"));
              pedzone.clock.set(pedzone.clock.begin);
              pedzone.clock.play(true);
              pedzone.clock.advance(0.125);
              pedzone.clock.play(false);
              found.push([Number(option.value), pedzone.clock.time - pedzone.clock.begin]);
            }
            return found;""")
        self.assertEqual([factor for factor, _ in advanced], [0.25, 0.5, 1, 2, 4, 8, 16, 50])
        for factor, time in advanced:
            self.assertAlmostEqual(time, 0.125 * factor, places=9)

    def test_stops_at_the_end_and_begins_again(self):
        self.open("one.html")
        self.browser.press("\ue010")  # End
        end = self.browser.run(STATE)
        self.assertAlmostEqual(end["time"], self.recorded["walked"].times[::2][-1], places=6)
        self.browser.press(" ")
        self.browser.run("while (pedzone.clock.time > 20)" + SETTLED)
        self.browser.press(" ")

    def test_steps(self):
        self.open("one.html")
        time = self.browser.run(SET_TIME, 12)["time"]
        self.browser.press("\ue014")  # right
        self.assertAlmostEqual(self.browser.run(STATE)["time"], time + 1 / RATE, places=6)
        self.browser.click("#back")
        self.browser.click("#back")
        self.assertAlmostEqual(self.browser.run(STATE)["time"], time - 1 / RATE, places=6)

    # It shows what one wants to see

    def test_zoom_and_pan_and_fit(self):
        fitted = self.open("one.html")
        x, y = 640, 300
        self.browser.wheel(x, y, -300)
        near = self.browser.run(STATE)
        self.assertGreater(near["scale"], 1.3 * fitted["scale"])
        self.browser.pointer(("move", x, y), ("down",), ("move", x + 60, y + 30),
                             ("move", x + 100, y + 50), ("up",))
        moved = self.browser.run(STATE)
        metres = 1 / near["scale"]
        for now, before, pixels in zip(moved["centre"], near["centre"], (-100, 50)):
            self.assertAlmostEqual(now, before + pixels * metres, places=6)
        self.assertIsNone(moved["selected"], "a drag is no click")
        self.browser.click("#fit")
        again = self.browser.run(STATE)
        self.assertEqual((again["scale"], again["centre"]), (fitted["scale"], fitted["centre"]))

    def test_numbers_of_a_person_that_is_clicked_on_follow_it(self):
        self.open("both.html")
        recorded = self.recorded["walked"]
        time = next(time for time in recorded.times[::10]
                    if recorded.at("vehicles", time) and len(recorded.at("persons", time)) > 5)
        shown = self.browser.run(SET_TIME, time)["panels"][0]
        name = shown["persons"][0]["id"]
        self.browser.click_at(*self.browser.run(ON_SCREEN, "persons", name, 0))
        for now in (time, time + 2):
            state = self.browser.run(SET_TIME, now)
            rows = self.browser.run("""return Object.fromEntries([...document.querySelectorAll(
                "#details-rows tr")].map((row) => [...row.cells].slice(0, 2).map(
                (cell) => cell.textContent)));""")
            self.assertEqual(state["selected"], {"kind": "person", "id": name})
            x, y = recorded.at("persons", now)[name]
            shown = [float(number.strip(" m")) for number in rows["Place"].split(",")]
            self.assertLess(math.dist(shown, (x, y)), 0.08)
            pose = next(one for one in state["panels"][0]["persons"] if one["id"] == name)
            self.assertEqual(rows["Speed"], f"{pose['speed']:.2f} m/s")
            room = min(self.clearance((x, y), one) for one in state["panels"][0]["vehicles"])
            self.assertAlmostEqual(float(rows["Clearance"].split()[0]), room, delta=0.03)

    def test_people_walked_by_sumo_are_pale(self):
        self.open("both.html")
        with open(self.folder / "walked.csv", encoding="utf-8") as file:
            rows = {(row["id"], float(row["time"])) for row in csv.DictReader(file)}
        doing = STATE.replace("return pedzone.state()", """
            const panel = pedzone.panels[0];
            return [panel.persons.map((pose) => [pose.track.id,
                                                 panel.recording.doing(pose).motion]),
                    panel.figures().filter(({pale}) => pale).length];""")
        pale = set()
        for time in (20.0, 40.0, 59.0):
            time = round(self.browser.run(SET_TIME, time)["time"], 2)
            persons, drawn_pale = self.browser.run(doing)
            outside = {name for name, motion in persons if motion == "walked by SUMO"}
            self.assertEqual(outside, {name for name, _ in persons if (name, time) not in rows})
            self.assertEqual(drawn_pale, len(outside))
            pale |= outside
        self.assertTrue(pale)

    def test_find_says_when_nobody_is_called_that(self):
        self.open("one.html")
        self.browser.click("#find")
        self.browser.press(*"nobody at all", "\ue007")
        text = "return document.getElementById('nobody').textContent"
        self.assertEqual(self.browser.run(text), "Nobody is called “nobody at all”.")
        self.assertIsNone(self.browser.run(STATE)["selected"])

    def test_find(self):
        self.open("one.html")
        name = next(iter(self.recorded["walked"].at("persons", 40)))
        self.browser.click("#find")
        self.browser.press(*name, "\ue007")  # Enter
        state = self.browser.run(STATE)
        self.assertEqual(state["selected"], {"kind": "person", "id": name})
        shown = {one["id"]: (one["x"], one["y"]) for one in state["panels"][0]["persons"]}
        self.assertLess(math.dist(shown[name], state["centre"]), 1e-6, "it is in the middle")
        self.browser.press("\ue00c")  # Escape

    def clearance(self, person, vehicle):
        """Room between the disc of SUMO's default person and a vehicle."""
        dx, dy = person[0] - vehicle["x"], person[1] - vehicle["y"]
        along = dx * math.cos(vehicle["heading"]) + dy * math.sin(vehicle["heading"])
        across = dy * math.cos(vehicle["heading"]) - dx * math.sin(vehicle["heading"])
        length, width = self.sizes[vehicle["id"].split(".")[0]]
        return math.hypot(max(abs(along) - length / 2, 0), max(abs(across) - width / 2, 0)) - 0.239

    def test_side_by_side_stays_in_step(self):
        self.open("both.html")
        self.browser.press(" ")
        for time in (3, 6):
            self.browser.run(f"while (pedzone.clock.time < {time})" + SETTLED)
            state = self.browser.run(STATE)  # while it plays
            walked, striping = state["panels"]
            self.assertTrue(state["playing"])
            self.check_recorded(striping, self.recorded["striping"], state["time"])
            # With --fcd those are there, too, whom pedzone does not walk.
            everybody = self.recorded["walked"].at("persons", state["time"], 2)
            self.check_places(walked, "persons", everybody, 0.011)
        self.browser.press(" ")

    # Whoever made the input

    def test_a_hostile_id_is_text(self):
        self.open("hostile.html")
        state = self.browser.run(SET_TIME, 30.0)
        self.assertIn(HOSTILE, [one["id"] for one in state["panels"][0]["persons"]])
        self.browser.click_at(*self.browser.run(ON_SCREEN, "persons", HOSTILE, 0))
        self.browser.run(SETTLED)
        for selector in ("#details-id", "h1", "figcaption b"):
            text = "return document.querySelector(arguments[0]).textContent"
            self.assertEqual(self.browser.run(text, selector), HOSTILE)
        scripts = (self.folder / "one.html").read_text().count("<script")
        self.assertEqual(self.browser.run("""return [
            window.injected, document.images.length, document.scripts.length,
            document.querySelectorAll("[onerror]").length];"""), [None, 0, scripts, 0])

    # Wherever it is shown

    def check_layout(self, page, width, height, mobile):
        self.open(page, width, height, mobile)
        self.browser.run(SET_TIME, 30.0)
        self.browser.run("""const [panel] = pedzone.panels, [pose] = panel.persons;
                            pedzone.select({kind: "person", id: pose.track.id});""")
        size = self.browser.run("""
            const root = document.documentElement, body = document.body;
            return [root.scrollWidth, body.scrollWidth, root.scrollHeight, innerWidth, innerHeight,
                    ...pedzone.panels.map((one) => one.canvas.clientWidth * one.canvas.clientHeight)
                   ];""")
        self.assertEqual((size[3], size[4]), (width, height))
        self.assertLessEqual(max(size[0], size[1]), width, "nothing to scroll sideways")
        self.assertLessEqual(size[2], height)
        self.assertGreater(sum(size[5:]), 0.35 * width * height, "the picture has room")
        boxes = self.browser.run(BOXES)
        self.assertGreater(len(boxes), 11)
        for i, a in enumerate(boxes):
            self.assertGreaterEqual(a["left"], 0, a)
            self.assertLessEqual(a["right"], width, a)
            for b in boxes[:i]:
                apart = (a["right"] <= b["left"] or b["right"] <= a["left"]
                         or a["bottom"] <= b["top"] or b["bottom"] <= a["top"])
                self.assertTrue(apart, (a, b))

    def test_on_a_phone(self):
        self.check_layout("one.html", 390, 844, True)
        self.check_layout("both.html", 390, 844, True)
        self.check_layout("both.html", 844, 390, True)

    def test_on_a_projector(self):
        self.check_layout("one.html", 1920, 1080, False)
        self.check_layout("both.html", 1920, 1080, False)

    def test_light_and_dark(self):
        theme = "return document.documentElement.dataset.theme"
        self.addCleanup(self.browser.prefer, "light")
        for scheme, other in (("dark", "light"), ("light", "dark")):
            self.browser.prefer(scheme)
            self.open("one.html")
            self.assertEqual(self.browser.run(theme), scheme)
            self.browser.click("#theme")
            self.assertEqual(self.browser.run(theme), other)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv[1]).resolve())
    SCENARIOS = Path(sys.argv[2]).resolve()
    del sys.argv[1:3]
    unittest.main()
