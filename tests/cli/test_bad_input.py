#!/usr/bin/python3
"""Every kind of bad input: one clear error, the exit code, and no file half-written.

usage: test_bad_input.py PEDZONE_PROGRAM
"""

import json
import os
import re
import signal
import subprocess
import sys
import unittest
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import EDGES, TinyCase, TinyScenario

PEDZONE = None  # set from the command line


class BadInput(RefusalChecks, TinyCase):
    def pedzone(self, *words):
        return subprocess.run([PEDZONE, *map(str, words)], cwd=self.folder, text=True,
                              capture_output=True, timeout=120)

    def run_scenario(self, *words):
        """`pedzone run` with both outputs; returns the finished process."""
        return self.pedzone("run", *words[:1], "--summary", "out/summary.json", "--trajectories",
                            "out/trajectories.csv", *words[1:])

    def expect(self, done, code, *fragments):
        self.check_refused(done, *fragments, code=code)

    def zone(self, body):
        self.tiny.config()
        self.tiny.write("bad.zone.xml", body)
        return self.run_scenario("tiny.sumocfg", "--zone", "bad.zone.xml")

    # The scenario

    def test_the_good_scenario_runs(self):
        done = self.run_scenario(self.tiny.config(), "--paths-svg", "out/paths.svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertGreater(summary["persons"]["controlled"], 0)
        rows = (self.folder / "out/trajectories.csv").read_text().splitlines()
        self.assertGreater(len(rows), 10)
        paths = re.search(r"paths of people in the zone \((\d+)\)",
                          (self.folder / "out/paths.svg").read_text())
        self.assertEqual(int(paths.group(1)), summary["persons"]["controlled"])

    def test_missing_scenario(self):
        self.expect(self.run_scenario("nowhere.sumocfg"), 2, "nowhere.sumocfg")

    def test_malformed_scenario(self):
        self.tiny.write("broken.sumocfg", "<configuration>\n<input>\n</configuration>")
        self.expect(self.run_scenario("broken.sumocfg"), 2, "broken.sumocfg:3")

    def test_scenario_without_network(self):
        self.tiny.write("empty.sumocfg", "<configuration/>")
        self.expect(self.run_scenario("empty.sumocfg"), 2, "empty.sumocfg:1", "net-file")

    def test_scenario_with_missing_network(self):
        done = self.run_scenario(self.tiny.config(net="gone.net.xml"))
        self.expect(done, 2, "tiny.sumocfg:2", "gone.net.xml", "<net-file")

    def test_malformed_network(self):
        self.tiny.write("broken.net.xml", "<net>\n<edge id='a'>\n</net>")
        self.expect(self.run_scenario(self.tiny.config(net="broken.net.xml")), 2,
                    "broken.net.xml:3")

    def test_scenario_without_persons(self):
        self.tiny.write("none.rou.xml", "<routes/>")
        self.expect(self.run_scenario(self.tiny.config(routes="none.rou.xml"), "--strict"), 2,
                    "person")

    def test_network_without_room_for_persons(self):
        cars = TinyScenario(self.folder, edges=EDGES.replace(' sidewalkWidth="2"', "").replace(
            'disallow="tram"', 'disallow="pedestrian"').replace(
                'speed="13.89"', 'speed="13.89" disallow="pedestrian"'))
        self.expect(self.run_scenario(cars.config(), "--strict"), 2, "tiny.net.xml", "shared space")

    def test_network_without_shared_space(self):
        plain = TinyScenario(self.folder, edges=EDGES.replace(
            'type="highway.living_street"', '').replace('speed="2.78"', 'speed="13.89"'))
        self.expect(self.run_scenario(plain.config(), "--strict"), 2, "shared space")

    def test_other_pedestrian_model(self):
        more = '  <processing>\n<pedestrian.model value="nonInteracting"/></processing>'
        self.expect(self.run_scenario(self.tiny.config(more=more)), 2, "tiny.sumocfg:6",
                    "nonInteracting", "striping")

    def test_other_pedestrian_model_on_the_command_line(self):
        done = self.run_scenario(self.tiny.config(), "--", "--pedestrian.model", "nonInteracting")
        self.expect(done, 2, "nonInteracting", "striping")

    # The zone file

    # Who people are

    def person_with(self, key, value):
        self.tiny.write("people.rou.xml", "<routes><vType id=\"walker\" vClass=\"pedestrian\">"
                        f"<param key=\"{key}\" value=\"{value}\"/></vType>"
                        "<person id=\"p0\" type=\"walker\" depart=\"0\">"
                        "<walk edges=\"west shared east\"/></person></routes>")
        return self.run_scenario(self.tiny.config(routes="people.rou.xml"))

    def test_unknown_profile(self):
        self.expect(self.person_with("pedzone.profile", "giant"), 2, "people.rou.xml:1",
                    "giant", "is no profile", "infant, child")

    def test_unknown_activity(self):
        self.expect(self.person_with("pedzone.activities", "texting dancing"), 2,
                    "people.rou.xml:1", "dancing", "texting, phoning")

    def test_activity_without_a_rate(self):
        self.expect(self.person_with("pedzone.activities", "texting=often"), 2, "texting=often",
                    "per minute")

    def test_awareness_that_is_neither(self):
        self.expect(self.person_with("pedzone.aware", "maybe"), 2, "people.rou.xml:1", "maybe",
                    "true, false")

    def persons_in_groups(self, *groups):
        persons = "".join(
            f"\n<person id=\"p{k}\" depart=\"0\"><param key=\"pedzone.group\" value=\"{group}\"/>"
            "<walk edges=\"west shared east\"/></person>" for k, group in enumerate(groups))
        self.tiny.write("people.rou.xml", f"<routes>{persons}</routes>")
        return self.run_scenario(self.tiny.config(routes="people.rou.xml"))

    def test_group_of_one(self):
        self.expect(self.persons_in_groups("two", "two", "lonely"), 2, "people.rou.xml:4",
                    "'lonely'", "is a group of one", "two persons or more")

    def test_group_of_two(self):
        self.assertEqual(self.persons_in_groups("two", "two").returncode, 0)

    def test_missing_zone_file(self):
        done = self.run_scenario(self.tiny.config(), "--zone", "gone.zone.xml")
        self.expect(done, 2, "gone.zone.xml")

    def test_zone_file_that_is_no_xml(self):
        self.expect(self.zone("<zones>\n<zone id='a'>\n</zones>"), 2, "bad.zone.xml:3")

    def test_wrong_element(self):
        self.expect(self.zone('<zones>\n<zone id="a">\n<rule/></zone></zones>'), 2,
                    "bad.zone.xml:3", "rule", "param")

    def test_wrong_root(self):
        self.expect(self.zone('<zone id="a"/>'), 2, "bad.zone.xml:1", "zones")

    def test_unknown_attribute(self):
        self.expect(self.zone('<zones>\n<zone id="a" edge="shared"/></zones>'), 2,
                    "bad.zone.xml:2", "'edge'", "edges")

    def test_missing_id(self):
        self.expect(self.zone('<zones>\n<zone edges="shared"/></zones>'), 2, "bad.zone.xml:2", "id")

    def test_number_out_of_range(self):
        self.expect(self.zone('<zones><zone id="a">\n<param key="sight" value="1000"/>'
                              '</zone></zones>'), 2, "bad.zone.xml:2", "1000", "1 to 50")

    def test_open_space_out_of_range(self):
        self.expect(self.zone('<zones>\n<zone id="a" openSpace="-1"/></zones>'), 2,
                    "bad.zone.xml:2", "openSpace", "-1", "0 to 50")

    def test_no_number(self):
        self.expect(self.zone('<zones>\n<zone id="a" openSpace="wide"/></zones>'), 2,
                    "bad.zone.xml:2", "openSpace", "wide")

    def test_unknown_parameter(self):
        self.expect(self.zone('<zones>\n<zone id="a"><param key="sigth" value="5"/></zone>'
                              '</zones>'), 2, "bad.zone.xml:2", "sigth", "sight")

    def test_unknown_model(self):
        self.expect(self.zone('<zones>\n<zone id="a" model="magic"/></zones>'), 2,
                    "bad.zone.xml:2", "magic", "heuristic")

    def test_unknown_model_on_the_command_line(self):
        for model in ("telepathy", "", "heuristic "):
            done = self.run_scenario(self.tiny.config(), "--model", model)
            self.expect(done, 2, "option --model", model, "heuristic-original", "orca")

    def test_missing_plugin(self):
        done = self.run_scenario(self.tiny.config(), "--model", "./libnowhere.so")
        self.expect(done, 2, "option --model", "'./libnowhere.so' is missing")
        self.expect(self.zone('<zones>\n<zone id="a" model="libnowhere.so"/></zones>'), 2,
                    "bad.zone.xml:2", "libnowhere.so' is missing")

    def test_inspect_misses_the_plugin_too(self):
        zone = self.tiny.write("bad.zone.xml",
                               '<zones>\n<zone id="a" model="libnowhere.so"/></zones>')
        done = self.pedzone("inspect", self.tiny.config(), "--zone", zone, "--svg", "zone.svg")
        self.expect(done, 2, "bad.zone.xml:2", "libnowhere.so' is missing")
        self.assertFalse((self.tiny.folder / "zone.svg").exists())

    def test_plugin_that_is_no_library(self):
        self.tiny.write("libtext.so", "no library")
        done = self.run_scenario(self.tiny.config(), "--model", "libtext.so")
        self.expect(done, 2, "option --model", "'libtext.so' cannot be loaded")

    def test_unknown_edge(self):
        self.expect(self.zone('<zones>\n<zone id="a" edges="shared nowhere"/></zones>'), 2,
                    "bad.zone.xml:2", "nowhere")

    def test_unknown_polygon(self):
        self.expect(self.zone('<zones>\n<zone id="a" edges="shared" polygons="sea"/></zones>'), 2,
                    "bad.zone.xml:2", "sea")

    def test_zone_without_any_edge(self):
        self.expect(self.zone('<zones>\n<zone id="a" edgeTypes="highway.canal"/></zones>'), 2,
                    "bad.zone.xml:2", "highway.canal")

    def test_zones_file_without_a_zone(self):
        self.expect(self.zone("<zones/>"), 2, "bad.zone.xml:1", "zone")

    def test_self_crossing_polygon_named_by_a_zone(self):
        self.tiny.write("tiny.add.xml", '<additional><poly id="bow" type="pedzone.walkable" '
                        'shape="60,0 100,30 100,0 60,30"/></additional>')
        self.expect(self.zone('<zones>\n<zone id="a" edges="shared" polygons="bow"/></zones>'), 2,
                    "bad.zone.xml:2", "bow", "cross")

    # SUMO

    def test_sumo_that_fails_to_start(self):
        self.tiny.write("tiny.rou.xml", '<routes><person id="p" depart="0">'
                        '<walk edges="no such edges"/></person></routes>')
        self.expect(self.run_scenario(self.tiny.config()), 3, "SUMO failed")

    def test_sumo_that_refuses_an_option(self):
        done = self.run_scenario(self.tiny.config(), "--", "--no-such-option", "1")
        self.expect(done, 2, "no-such-option")

    def test_sumo_that_dies_in_the_middle(self):
        # What abort() inside SUMO does: the process that runs it dies by SIGABRT.
        words = ["run", str(self.tiny.config()), "--end", "100000000", "--summary",
                 "out/summary.json", "--trajectories", "out/trajectories.csv"]
        running = subprocess.Popen([PEDZONE, *words], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        children = Path(f"/proc/{running.pid}/task/{running.pid}/children")
        started = self.folder / "out/trajectories.csv.partial"
        while not (started.exists() and children.read_text().split()):
            self.assertIsNone(running.poll(), "ended before it could be killed")
        os.kill(int(children.read_text().split()[0]), signal.SIGABRT)
        output, errors = running.communicate(timeout=60)
        self.expect(subprocess.CompletedProcess(words, running.returncode, output, errors), 3,
                    "SUMO died")

    # The command line

    def test_unknown_option(self):
        self.expect(self.pedzone("run", self.tiny.config(), "--sed", "7"), 2)

    def test_negative_end(self):
        self.expect(self.pedzone("run", self.tiny.config(), "--end", "-5"), 2)

    def test_output_that_cannot_be_written(self):
        self.tiny.write("out", "a file, not a folder")
        done = self.pedzone("run", self.tiny.config(), "--summary", "out/summary.json")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("--summary", done.stderr)

    def test_inspect_reports_bad_input_alike(self):
        done = self.pedzone("inspect", "nowhere.sumocfg", "--svg", "out/zone.svg")
        self.expect(done, 2, "nowhere.sumocfg")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
