#!/usr/bin/python3
"""What people type by mistake, and the one line that they are told: command line, exact message.

usage: test_mistakes.py PEDZONE_PROGRAM
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tiny_scenario import TinyScenario

PEDZONE = None  # set from the command line

COMMANDS = ("run, attach, inspect, demand, conflicts, animate, plot, maps, geojson, study, validate, calibrate, "
            "verify, parameters, profiles, help, completion, man")
MODELS = ("heuristic, heuristic-original, plain, orca, social-force, gradient-navigation, "
          "optimal-steps, constant-velocity, or the path of a plug-in (*.so)")
RUN = "pedzone run SCENARIO [OPTIONS] [-- SUMO OPTIONS]"

# The exit code of all of them is 2, and nothing is written. {PARAMETERS}, {TESTS}: of the program.
MISTAKES = [
    # Commands
    ("rn tiny.sumocfg", f"pedzone: 'rn' is no command; allowed: {COMMANDS}. Did you mean 'run'?"),
    ("inpsect tiny.sumocfg",
     f"pedzone: 'inpsect' is no command; allowed: {COMMANDS}. Did you mean 'inspect'?"),
    ("simulate", f"pedzone: 'simulate' is no command; allowed: {COMMANDS}"),
    ("tiny.sumocfg", f"pedzone: 'tiny.sumocfg' is no command; allowed: {COMMANDS}"),
    ("study staus out",
     "pedzone study: 'staus' is no command; allowed: run, status, report. Did you mean 'status'?"),
    ("help anim", f"pedzone: 'anim' is no command; allowed: {COMMANDS}. Did you mean 'animate'?"),
    ("help study rn",
     "pedzone study: 'rn' is no command; allowed: run, status, report. Did you mean 'run'?"),
    # Options
    ("run tiny.sumocfg --sed 7",
     "pedzone run: '--sed' is no option; allowed: those of `pedzone run --help`. "
     "Did you mean '--seed'?"),
    ("run tiny.sumocfg --trajectoris=out/t.csv",
     "pedzone run: '--trajectoris' is no option; allowed: those of `pedzone run --help`. "
     "Did you mean '--trajectories'?"),
    ("run tiny.sumocfg -seed 7",
     "pedzone run: '-seed' is no option; allowed: those of `pedzone run --help`. "
     "Did you mean '--seed'?"),
    ("run tiny.sumocfg --sed 7 -- --no-warnings true",
     "pedzone run: '--sed' is no option; allowed: those of `pedzone run --help`. "
     "Did you mean '--seed'?"),
    ("run tiny.sumocfg more -- --no-warnings true",
     f"pedzone run: 'more' is no option of SUMO; allowed: {RUN}"),
    ("run tiny.sumocfg --wheather rain",
     "pedzone run: '--wheather' is no option; allowed: those of `pedzone run --help`"),
    ("plot run.csv --oput a.svg",
     "pedzone plot: '--oput' is no option; allowed: those of `pedzone plot --help`. "
     "Did you mean '--out'?"),
    ("--verison",
     "pedzone: '--verison' is no option; allowed: those of `pedzone --help`; options of a command "
     "go after its name. Did you mean '--version'?"),
    ("-x",
     "pedzone: '-x' is no option; allowed: those of `pedzone --help`; options of a command go "
     "after its name"),
    ("--seed 7 run tiny.sumocfg",
     "pedzone: '--seed' is no option; allowed: those of `pedzone --help`; options of a command go "
     "after its name"),
    # What is SUMO's and what is pedzone's
    ("run tiny.sumocfg --fcd-output out/f.xml",
     "before --: '--fcd-output' is an option of SUMO; allowed: options of pedzone run; those of "
     "SUMO go after --"),
    ("inspect tiny.sumocfg --net-file=a.net.xml",
     "before --: '--net-file' is an option of SUMO; allowed: options of pedzone inspect; those of "
     "SUMO go after --"),
    ("run tiny.sumocfg -- --model orca",
     "after --: '--model' is an option of pedzone; allowed: options of SUMO; those of pedzone go "
     "before --"),
    ("run tiny.sumocfg other.sumocfg",
     f"pedzone run: 'other.sumocfg' is no option of SUMO; allowed: {RUN}"),
    # What is missing, or too much
    ("run", "SCENARIO: is missing; allowed: SUMO configuration (.sumocfg)"),
    ("run --end 5", "SCENARIO: is missing; allowed: SUMO configuration (.sumocfg)"),
    ("animate run.csv", "option --out: is missing; allowed: --out or --video"),
    ("conflicts fcd.xml",
     "option --conflict-output, --conflict-csv or --json: is missing; allowed: one of them or "
     "more"),
    ("parameters sight",
     "pedzone parameters: 'sight' is one word too many; allowed: pedzone parameters [OPTIONS]"),
    ("run tiny.sumocfg --trajectories", "option --trajectories: has no value; allowed: FILE"),
    ("run tiny.sumocfg --trajectories --seed 7",
     "option --trajectories: has no value; allowed: FILE"),
    ("run tiny.sumocfg --summary -- --step-length 1",
     "option --summary: has no value; allowed: FILE"),
    ("run tiny.sumocfg --end --seed 7", "option --end: has no value; allowed: SECONDS"),
    ("run tiny.sumocfg --model", "option --model: has no value; allowed: MODEL"),
    ("run tiny.sumocfg --seed 1 --seed 2", "option --seed: is given 2 times; allowed: once"),
    ("run tiny.sumocfg --quiet=5", "option --quiet: takes no value; allowed: --quiet alone"),
    ("plot run.csv --area 1 2 3 --out out/a.svg",
     "option --area: has 3 values; allowed: 4: LEFT BOTTOM RIGHT TOP"),
    ("plot run.csv --zone a.zone.xml --out out/a.svg",
     "option --zone: is given without --scenario; allowed: both of them, or none"),
    ("study run a.xml --out out/r --slurm --jobs 3",
     "option --jobs: is given beside --slurm; allowed: one of them"),
    # Values
    ("run tiny.sumocfg --seed -3",
     "option --seed: '-3' is out of range; allowed: 0 to 2147483647"),
    ("run tiny.sumocfg --seed many",
     "option --seed: 'many' is not a number; allowed: 0 to 2147483647"),
    ("run tiny.sumocfg --end -5", "option --end: '-5' is out of range; allowed: 0 to 1000000000"),
    ("run tiny.sumocfg --end 40 -- --begin 50",
     "option --end: '40' is not later than the run's begin; allowed: a time after the begin that "
     "tiny.sumocfg says"),
    ("run tiny.sumocfg --trajectories - --summary /dev/stdout",
     "option --trajectories: '-' names the same file as --summary; allowed: a file for each output"),
    ("verify --only fundamental-diagram --json a.json --html a.json",
     "option --html: 'a.json' names the same file as --json; allowed: a file for each output"),
    ("conflicts fcd.xml --conflict-csv - --json",
     "option --conflict-csv: '-' is standard output, where --json prints; allowed: a file"),
    ("run tiny.sumocfg --threads 1.5",
     "option --threads: '1.5' is no whole number; allowed: 0 to 1024"),
    ("run tiny.sumocfg --conflict-ttc 99",
     "option --conflict-ttc: '99' is out of range; allowed: 0 to 60"),
    ("run tiny.sumocfg --pedestrians -5",
     "option --pedestrians: '-5' is out of range; allowed: 1 to 1000000"),
    ("plot run.csv --kind tme --out out/a.svg",
     "option --kind: 'tme' is unknown; allowed: time, path, across, speed, "
     "clearance. Did you mean 'time'?"),
    ("completion fish", "SHELL: 'fish' is unknown; allowed: bash, zsh"),
    # Models, parameters, tests
    ("run tiny.sumocfg --model hueristic",
     f"option --model: 'hueristic' is not known; allowed: {MODELS}. Did you mean 'heuristic'?"),
    ("verify --model telepathy", f"option --model: 'telepathy' is not known; allowed: {MODELS}"),
    ("verify --only dors",
     "option --only: 'dors' is no standard test; allowed: {TESTS}. Did you mean 'doors'?"),
    ("validate --data . --param sigth=5",
     "option --param: 'sigth' is no parameter; allowed: {PARAMETERS}. Did you mean 'sight'?"),
    ("validate --data . --param sight", "option --param: 'sight' has no value; allowed: KEY=VALUE"),
    ("validate --data . --param sight=far",
     "option --param sight: 'far' is out of range; allowed: 1 to 50"),
    ("run tiny.sumocfg --zone typo.zone.xml",
     "typo.zone.xml:1: <param> attribute key: 'patiense' is no parameter; allowed: {PARAMETERS}. "
     "Did you mean 'patience'?"),
    # Files
    ("run tiny.sumocf", "tiny.sumocf: cannot be opened"),
]


def printed(*words):
    return subprocess.run([PEDZONE, *words], text=True, capture_output=True, check=True).stdout


class Mistakes(unittest.TestCase):
    def test_each_is_told_in_one_line(self):
        rows = [line.split("`")[1] for line in printed("parameters").split("\nAttributes")[0]
                .splitlines() if line.startswith("| `")]
        tests = [line.split()[0] for line in printed("verify", "--list").splitlines()]
        lists = {"{PARAMETERS}": ", ".join(rows), "{TESTS}": ", ".join(tests)}
        self.assertGreaterEqual(len(MISTAKES), 40)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            tiny = TinyScenario(folder)
            tiny.config()
            tiny.write("typo.zone.xml", '<zones><zone id="a"><param key="patiense" value="1"/>'
                                        '</zone></zones>')
            before = sorted(folder.rglob("*"))
            for line, message in MISTAKES:
                for mark, text in lists.items():
                    message = message.replace(mark, text)
                with self.subTest(line):
                    done = subprocess.run([PEDZONE, *line.split()], cwd=folder, text=True,
                                          capture_output=True, timeout=60)
                    self.assertEqual((done.returncode, done.stderr, done.stdout),
                                     (2, f"Error: {message}\n", ""))
            self.assertEqual(sorted(folder.rglob("*")), before, "nothing is written")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
