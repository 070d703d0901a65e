#!/usr/bin/python3
"""SUMO's options after `--`: what the user says wins; mistakes are the user's, told with what to do.

usage: test_sumo_options.py PEDZONE_PROGRAM
"""

import os
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyCase, sumo_environment

PEDZONE = None  # set from the command line


class OptionsCase(RefusalChecks, TinyCase):
    def setUp(self):
        super().setUp()
        self.tiny.config()

    def pedzone(self, *words):
        return subprocess.run([PEDZONE, "run", "tiny.sumocfg", "--end", "60", *words],
                              cwd=self.folder, text=True, capture_output=True, timeout=120)

    def after(self, *sumo_options):
        return self.pedzone("--", *sumo_options)

    def succeeds(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def refused(self, done, *fragments):
        """Also: SUMO has written nothing."""
        self.check_refused(done, *fragments)
        self.assertEqual(list(self.folder.glob("from-sumo*")), [])


class TheUserWins(OptionsCase):
    def test_the_step_log(self):
        """(SUMO's library prints none.)"""
        for words in (["--no-step-log", "true"], ["--no-step-log"], ["--no-step-log=false"], []):
            with self.subTest(words):
                self.succeeds(self.after(*words))
        self.tiny.config(more='<report><no-step-log value="false"/></report>')
        self.succeeds(self.after("--no-step-log", "true"))

    def seed_and_end(self, *words):
        """As SUMO has them, by its output."""
        self.succeeds(subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", *words, "--log", "from-sumo.log", "--fcd-output",
             "from-sumo.xml"], cwd=self.folder, text=True, capture_output=True, timeout=120))
        text = (self.folder / "from-sumo.xml").read_text()
        seed = re.search(r'<seed value="(\d+)"', text)
        steps = ElementTree.fromstring(text).findall("timestep")
        return seed and int(seed[1]), float(steps[-1].get("time")) + 0.5

    def test_seed_and_end(self):
        self.assertEqual(self.seed_and_end("--"), (None, 200.0))
        for option in ("--seed", "--srand"):
            self.assertEqual(self.seed_and_end("--", option, "7")[0], 7)
        for words in (["--end", "30"], ["-e", "30"], ["--end=30"]):
            self.assertEqual(self.seed_and_end("--", *words), (None, 30.0))
        self.assertEqual(self.seed_and_end("--end", "40", "--seed", "5", "--"), (5, 40.0))

    def test_a_seed_wins_over_a_random_one_of_the_configuration(self):
        self.tiny.config(more='<random_number><random value="true"/></random_number>')
        self.seed_and_end("--seed", "5", "--")
        text = (self.folder / "from-sumo.xml").read_text()
        self.assertIn('<random value="false"', text)

    def test_nothing_is_said_twice(self):
        self.refused(self.pedzone("--seed", "5", "--", "--seed", "6"), "--seed", "'6' is said twice")
        self.refused(self.after("-e", "6"), "--end", "'6' is said twice")

    def test_additional_files_beside_people_of_ours(self):
        self.tiny.write("more.add.xml", '<additional><poly id="spot" type="mine" fill="1" '
                                        'shape="0,0 1,0 1,1"/></additional>')
        done = self.succeeds(self.pedzone("--pedestrians", "3", "--", "-a", "more.add.xml"))
        self.assertRegex(done.stdout, r"seen +6\n")


class Configurations(OptionsCase):
    """Whatever way a configuration says it that SUMO reads."""

    def seen(self, config):
        self.tiny.write("other.sumocfg", f"<configuration>{config}</configuration>")
        done = subprocess.run([PEDZONE, "run", "other.sumocfg", "--end", "60"], cwd=self.folder,
                              text=True, capture_output=True, timeout=120,
                              env={**os.environ, "WHERE": str(self.folder)})
        self.assertEqual(done.returncode, 0, done.stderr)
        return int(re.search(r"taken over by pedzone +(\d+)", done.stdout)[1]), done.stderr

    def test_values_texts_and_variables(self):
        for net in ('<net-file v="tiny.net.xml"/>', "<net-file>tiny.net.xml</net-file>",
                    '<net-file value="${WHERE}/tiny.net.xml"/>'):
            with self.subTest(net):
                self.assertEqual(self.seen(net + '<route-files value="tiny.rou.xml"/>')[0], 3)

    def test_included_files(self):
        (self.folder / "more").mkdir()
        (self.folder / "more/people.xml").write_text((self.folder / "tiny.rou.xml").read_text())
        self.tiny.write("all.rou.xml", '<routes><include href="more/people.xml"/></routes>')
        taken, errors = self.seen('<net-file value="tiny.net.xml"/><route-files value="all.rou.xml"/>')
        self.assertEqual(taken, 3)
        self.assertNotIn("names no person", errors)


class WrongNumbers(OptionsCase):
    """Outputs of SUMO that miscount people whom it does not walk: a warning says so."""

    def test_errors_in_spite_of_which_sumo_starts(self):
        self.tiny.write("tiny.rou.xml", """<routes>
          <vehicle id="v" depart="0"><route edges="west shared"/>
            <stop lane="shared_0" startPos="50" endPos="10" duration="5"/></vehicle>
          <person id="p" depart="0"><walk edges="west shared"/></person></routes>""")
        plain = subprocess.run(["sumo", "-c", str(self.tiny.config()), "--no-step-log", "true"],
                               cwd=self.folder, capture_output=True, text=True,
                               env=sumo_environment())
        error = next(line for line in plain.stderr.splitlines() if line.startswith("Error: "))
        done = self.pedzone()
        self.assertEqual(done.returncode == 0, plain.returncode == 0, "SUMO 1.18 does not start")
        self.assertIn(error.removeprefix("Error: "), done.stderr)

    def test_a_summary_of_persons(self):
        done = self.succeeds(self.after("--person-summary-output", "from-sumo.xml"))
        self.assertIn("person-summary-output 'walking' and 'riding' are wrong", done.stderr)
        step = ElementTree.parse(self.folder / "from-sumo.xml").getroot()[-1]
        number = {name: int(value) for name, value in step.items() if name != "time"}
        self.assertGreater(number["walking"], 3)  # all that there are: else SUMO has mended it
        self.assertEqual(number["walking"] + number["riding"], number["inserted"] - number["ended"])
        self.assertNotIn("person-summary-output", self.after().stderr)

    def passed(self):
        intervals = ElementTree.parse(self.folder / "from-sumo.xml").getroot()
        return sum(int(interval.get("nVehContrib")) for interval in intervals)

    def test_detectors_of_persons(self):
        loop = ('<additional><inductionLoop id="loop" lane="shared_0" pos="20" period="60"'
                ' file="from-sumo.xml"{}/></additional>')
        more = ["--additional-files", "loop.add.xml"]
        self.tiny.write("loop.add.xml", loop.format(' detectPersons="walk"'))
        subprocess.run(["sumo", "-c", "tiny.sumocfg", "--end", "60", *more], cwd=self.folder,
                       env=sumo_environment(), capture_output=True, check=True)
        self.assertGreater(self.passed(), 0)
        done = self.succeeds(self.after(*more))
        self.assertIn("1 detector is to count people (detectPersons), such as 'loop'", done.stderr)
        self.assertEqual(self.passed(), 0)  # else SUMO has mended it
        self.tiny.write("loop.add.xml", loop.format(""))
        self.assertNotIn("detector", self.succeeds(self.after(*more)).stderr)


class Mistakes(OptionsCase):
    def test_a_typo_is_the_users(self):
        self.refused(self.after("--fdc-output", "from-sumo.xml"),
                     "No option with the name 'fdc-output' exists.")

    def test_a_value_that_is_none(self):
        self.refused(self.after("--step-length", "long"), "does not understand", "long")

    def test_a_word_that_is_no_option(self):
        self.refused(self.after("from-sumo.xml"), "from-sumo.xml")

    def test_mesoscopic_simulation(self):
        for words in (["--mesosim"], ["--mesosim", "true"], ["--mesosim=1"]):
            self.refused(self.after("--fcd-output", "from-sumo.xml", *words), "--mesosim")
        self.tiny.config(more='<mesoscopic><mesosim value="true"/></mesoscopic>')
        self.refused(self.after(), "tiny.sumocfg:5: <mesosim")
        self.assertEqual(self.after("--mesosim", "false").returncode, 0)

    def test_what_would_not_simulate(self):
        for words in (["--help"], ["-?"], ["--version"], ["-V"], ["-C", "from-sumo.cfg"],
                      ["--save-template", "from-sumo.cfg"], ["--save-schema", "from-sumo.xsd"]):
            with self.subTest(words):
                self.refused(self.after(*words), "something else than simulate")
        self.refused(self.after("-c", "other.sumocfg"), "other.sumocfg", "second configuration")
        self.refused(self.after("--remote-port", "4001"), "remote-port")

    def test_options_of_pedzone_after_the_dashes(self):
        for words in (["--model", "orca"], ["--trajectories", "out/t.csv"], ["--zone=a.zone.xml"],
                      ["--quiet"]):
            with self.subTest(words):
                self.refused(self.after(*words), f"'{words[0].split('=')[0]}'",
                             "is an option of pedzone", "go before --")

    def test_options_of_sumo_before_the_dashes(self):
        for words in (["--fcd-output", "from-sumo.xml"], ["--step-length=0.1"]):
            with self.subTest(words):
                self.refused(self.pedzone(*words), words[0].split("=")[0],
                             "is an option of SUMO", "go after --")

    def test_a_typo_before_the_dashes_is_not_taken_for_sumos(self):
        done = self.pedzone("--trajectoris", "t.csv")
        self.refused(done, "--trajectoris")
        self.assertNotIn("option of SUMO", done.stderr)


class SavedStates(OptionsCase):
    def test_no_state_is_saved(self):
        for words in (["--save-state.times", "10"], ["--save-state.period", "10"],
                      ["--save-state.files", "from-sumo.xml"]):
            with self.subTest(words):
                self.refused(self.after("--save-state.prefix", "from-sumo", *words), words[0],
                             "saved states")
        self.tiny.config(more='<output><save-state.times value="5"/></output>')
        self.refused(self.after(), "tiny.sumocfg:5: <save-state.times", "saved states")

    def test_none_is_loaded(self):
        subprocess.run(["sumo", "-c", "tiny.sumocfg", "--save-state.times", "10",
                        "--save-state.files", "state.xml", "--save-state.transportables",
                        "--end", "20"], cwd=self.folder, check=True, capture_output=True)
        self.assertTrue((self.folder / "state.xml").exists())
        self.refused(self.after("--load-state", "state.xml"), "--load-state", "saved states")

    def test_options_that_save_nothing_are_taken(self):
        done = self.after("--save-state.period", "-1", "--save-state.prefix", "from-sumo")
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
