#!/usr/bin/python3
"""The READMEs say what the program prints, and name only what is there.

    test_readmes.py PEDZONE PROJECT_FOLDER
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

PEDZONE, PROJECT = None, None
MOST_LINES = 150  # of the project's README
CODE = re.compile(r"^```.*?^```|^ {4}[^\n]*|`[^`\n]+`", re.MULTILINE | re.DOTALL)
FOLDERS = "src|networks|scenarios|tests|tools"


def readmes():
    yield PROJECT / "README.md"
    for folder in ("src", "networks", "scenarios"):
        yield from sorted((PROJECT / folder).rglob("README.md"))


def printed(command):
    done = subprocess.run([PEDZONE, *command.split()], capture_output=True, text=True, check=True)
    return done.stdout


class Tables(unittest.TestCase):
    def holds(self, folder, table):
        text = (PROJECT / folder / "README.md").read_text(encoding="utf-8")
        self.assertGreater(len(table.splitlines()), 2)
        self.assertIn(table.strip("\n"), text, f"{folder}/README.md is not what the program prints")

    def test_parameters_and_attributes_of_people(self):
        parameters, attributes = re.findall(r"(?:^\|.*\n)+", printed("parameters"), re.MULTILINE)
        self.holds("src/world", parameters)
        self.holds("src/demand", attributes)

    def test_profiles_activities_and_weather(self):
        self.holds("src/world", printed("profiles"))


class Names(unittest.TestCase):
    def test_the_first_one_is_short(self):
        lines = (PROJECT / "README.md").read_text(encoding="utf-8").splitlines()
        self.assertLessEqual(len(lines), MOST_LINES)

    def test_files_that_are_named_are_there(self):
        for readme in readmes():
            text = readme.read_text(encoding="utf-8")
            for name in re.findall(rf"(?<![\w/.])((?:{FOLDERS})/[\w./-]*[\w/])", text):
                found = (PROJECT / name).exists() or list(PROJECT.glob(name + "*"))
                self.assertTrue(found, f"{readme} names {name}, which is not there")

    def test_pictures_and_links_lead_somewhere(self):
        for readme in readmes():
            for link in re.findall(r"\]\(([^)#]+)\)", readme.read_text(encoding="utf-8")):
                if "://" not in link:
                    self.assertTrue((readme.parent / link).exists(), f"{readme}: {link}")

    def test_every_folder_of_the_source_stands_in_its_map(self):
        text = (PROJECT / "src" / "README.md").read_text(encoding="utf-8")
        named = set(re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE))
        there = {folder.name for folder in (PROJECT / "src").iterdir() if folder.is_dir()}
        self.assertEqual(named, there - {"cmake"})

    def test_commands_are_commands(self):
        commands = set(re.findall(r"^  (\w+) {2,}\S", printed("--help"),
                                  re.MULTILINE))
        self.assertIn("run", commands)
        for readme in readmes():
            for code in CODE.findall(readme.read_text(encoding="utf-8")):
                for command in re.findall(r"^[ `]*pedzone ([a-z]+)", code, re.MULTILINE):
                    self.assertIn(command, commands, str(readme))


if __name__ == "__main__":
    PEDZONE, PROJECT = sys.argv[1], Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1])
