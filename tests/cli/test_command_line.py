#!/usr/bin/python3
"""The command line as people, shells and `man` meet it: help, quiet, pipes, colours, completion.

usage: test_command_line.py PEDZONE_PROGRAM
"""

import os
import pty
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from tiny_scenario import TinyScenario

PEDZONE = None  # set from the command line
LOOK_UP = {"parameters", "profiles", "help", "completion", "man"}
GONE = 128 + signal.SIGPIPE  # nobody reads any more


def call(*words, **more):
    return subprocess.run([PEDZONE, *words], text=True, capture_output=True, timeout=120, **more)


def printed(*words):
    done = call(*words)
    assert (done.returncode, done.stderr) == (0, ""), done
    return done.stdout


def commands(*words):
    """Every command of the program as a list of words."""
    found, text = [], printed("help", *words)
    inner = re.search(r"^Usage: .* COMMAND", text, re.MULTILINE)
    names = re.findall(r"^  ([a-z]+) {2,}\S", text, re.MULTILINE) if inner else []
    for name in names:
        found += commands(*words, name) or [[*words, name]]
    return found


def quiet_scenario(folder):
    """One that SUMO has nothing to say about."""
    tiny = TinyScenario(folder)
    tiny.write("tiny.rou.xml", '<routes><person id="p" depart="0"><walk edges="west shared east"/>'
                               "</person></routes>")
    tiny.config()


class Help(unittest.TestCase):
    def test_three_ways_to_ask(self):
        self.assertEqual(printed(), printed("--help"))
        self.assertEqual(printed("help"), printed("--help"))
        self.assertEqual(printed("study"), printed("study", "--help"))
        self.assertEqual(printed("help", "study", "run"), printed("study", "run", "--help"))
        self.assertEqual(printed("-V"), printed("--version"))
        self.assertRegex(printed("-V"), r"^\d+\.\d+\.\d+\n$")

    def test_every_command_has_an_example_and_clean_types(self):
        found = commands()
        self.assertIn(["run"], found)
        self.assertIn(["study", "status"], found)
        for words in found:
            with self.subTest(words):
                text = printed("help", *words)
                self.assertRegex(text, rf"Usage: pedzone {' '.join(words)}\b")
                self.assertRegex(text, r"Examples?:\n")
                self.assertNotRegex(text, r"\b(FLOAT|U?INT|REQUIRED|Needs|Excludes)\b|e\+0")
                for line in text.splitlines():
                    self.assertLessEqual(len(line), 100)

    def test_quiet_is_everywhere(self):
        for words in commands():
            self.assertEqual("--quiet" in printed("help", *words), words[0] not in LOOK_UP, words)


class Pipes(unittest.TestCase):
    def to_a_closed_pipe(self, *words, ignored=False, **more):
        """The exit code and what is on standard error, where nobody reads standard output."""
        reader, writer = os.pipe()
        os.close(reader)
        before = signal.signal(signal.SIGPIPE, signal.SIG_IGN if ignored else signal.SIG_DFL)
        try:
            done = subprocess.run([PEDZONE, *words], stdout=writer, stderr=subprocess.PIPE,
                                  text=True, restore_signals=False, timeout=120, **more)
        finally:
            signal.signal(signal.SIGPIPE, before)
            os.close(writer)
        return done.returncode, done.stderr

    def test_head_is_no_error(self):
        for ignored in (False, True):  # a parent may have told us to ignore the signal
            for words in (["parameters"], ["profiles"], ["--help"], ["help", "run"], ["man"],
                          ["verify", "--list"], ["-V"]):
                with self.subTest(words, ignored=ignored):
                    self.assertEqual(self.to_a_closed_pipe(*words, ignored=ignored), (0, ""))

    def test_a_run(self):
        with tempfile.TemporaryDirectory() as name:
            quiet_scenario(name)
            run = ["run", "tiny.sumocfg", "--summary", "s.json"]
            self.assertEqual(self.to_a_closed_pipe(*run, cwd=name), (0, ""))
            (Path(name) / "s.json").unlink()
            # What was wanted on standard output is not there: nothing is, and the code says so.
            self.assertEqual(self.to_a_closed_pipe(*run, "--trajectories", "-", cwd=name,
                                                   ignored=True), (GONE, ""))
            self.assertEqual(list(Path(name).glob("s.json*")), [])

    def test_a_full_disk_is_an_error(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([PEDZONE, "parameters"], stdout=full, stderr=subprocess.PIPE,
                                  text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("No space left", done.stderr)


class Terminal(unittest.TestCase):
    def on_a_terminal(self, *words, **environment):
        """What a terminal gets."""
        reader, terminal = pty.openpty()
        known = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        subprocess.run([PEDZONE, *words], stdout=terminal, stderr=terminal,
                       env={**known, **environment}, timeout=120)
        os.close(terminal)
        text = b""
        try:
            while part := os.read(reader, 65536):
                text += part
        except OSError:  # the end
            pass
        os.close(reader)
        return text.decode().replace("\r\n", "\n")

    def test_colours(self):
        self.assertIn("\x1b[1;31mError:\x1b[0m pedzone: 'rn'", self.on_a_terminal("rn"))
        self.assertIn("\x1b[", self.on_a_terminal("rn", NO_COLOR=""))
        self.assertNotIn("\x1b", self.on_a_terminal("rn", NO_COLOR="1"))
        self.assertNotIn("\x1b", call("rn").stderr)
        self.assertNotIn("\x1b", self.on_a_terminal("help"))


class Quiet(unittest.TestCase):
    def test_only_what_was_asked_for(self):
        with tempfile.TemporaryDirectory() as name:
            quiet_scenario(name)
            for words in (["run", "tiny.sumocfg", "--trajectories", "t.csv"],
                          ["inspect", "tiny.sumocfg", "--svg", "z.svg"],
                          ["animate", "t.csv", "--out", "a.html"],
                          ["conflicts", "f.xml", "--conflict-csv", "c.csv"],
                          ["verify", "--model", "plain", "--only", "rimea-1", "--seeds", "1"]):
                with self.subTest(words):
                    (Path(name) / "f.xml").write_text("<fcd-export/>")
                    done = call(*words, "--quiet", cwd=name)
                    self.assertEqual((done.stdout, done.stderr), ("", ""))
                    self.assertIn(done.returncode, (0, 1))
            self.assertEqual({path.name for path in Path(name).glob("[tzac].*")},
                             {"t.csv", "z.svg", "a.html", "c.csv"})


class Completion(unittest.TestCase):
    def bash(self, *words):
        """What is offered for the last word."""
        script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _pedzone; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        with tempfile.NamedTemporaryFile("w") as file:
            file.write(printed("completion", "bash"))
            file.flush()
            done = subprocess.run(["bash", "-u", "-c", script, "bash", file.name, *words],
                                  text=True, capture_output=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash(self):
        self.assertEqual(self.bash("pedzone", "in"), ["inspect"])
        self.assertEqual(self.bash("pedzone", "study", "st"), ["status"])
        self.assertEqual(self.bash("pedzone", "study", "run", "a.xml", "--o"), ["--out"])
        self.assertEqual(self.bash("pedzone", "run", "--model", "o"), ["orca", "optimal-steps"])
        self.assertEqual(self.bash("pedzone", "plot", "--kind", "=", "p"), ["path"])
        self.assertEqual(self.bash("pedzone", "help", "ver"), ["verify"])
        self.assertEqual(self.bash("pedzone", "run", "--zone", "x"), [], "files, by bash itself")
        self.assertEqual(self.bash("pedzone", "run", "a.sumocfg", "--", "--s"), [], "SUMO's")

    def test_every_option_is_offered(self):
        for words in commands():
            options = set(re.findall(r"^  (?:-\w, )?(--[\w-]+)", printed("help", *words),
                                     re.MULTILINE))
            self.assertEqual(set(self.bash("pedzone", *words, "--")), options, words)

    def zsh(self, typed):
        """What zsh makes of a line when the Tab key is pressed."""
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "_pedzone").write_text(printed("completion", "zsh"))
            process, terminal = pty.fork()
            if process == 0:
                os.environ.update(TERM="dumb", HOME=name, PS1="", COLUMNS="200")
                os.execvp("zsh", ["zsh", "-f", "-i"])
            setup = f"fpath=({name} $fpath); autoload -Uz compinit; compinit -u -D; print rea''dy\n"
            os.write(terminal, setup.encode())
            self.read_until(terminal, "ready")
            os.write(terminal, typed.encode() + b"\t")
            time.sleep(1.0)
            os.write(terminal, b"\x01print -r -- '<\x05>'\n")
            text = self.read_until(terminal, r"\n<.*>\r")
            os.write(terminal, b"exit\n")
            os.close(terminal)
            os.waitpid(process, 0)
        return re.findall(r"\n<(.*?) *>\r", text)[-1]

    def read_until(self, terminal, pattern):
        text, begin = "", time.monotonic()
        while not re.search(pattern, text):
            self.assertLess(time.monotonic() - begin, 60.0, text)
            text += os.read(terminal, 65536).decode()
        return text

    def test_zsh(self):
        self.assertEqual(self.zsh("pedzone insp"), "pedzone inspect")
        self.assertEqual(self.zsh("pedzone study stat"), "pedzone study status")
        self.assertEqual(self.zsh("pedzone plot a.csv --ki"), "pedzone plot a.csv --kind")
        self.assertEqual(self.zsh("pedzone study run a.xml --sl"), "pedzone study run a.xml --slurm")
        self.assertEqual(self.zsh("pedzone run a --model orc"), "pedzone run a --model orca")


class Manual(unittest.TestCase):
    def test_it_names_every_command_and_option(self):
        done = subprocess.run(["groff", "-K", "utf8", "-man", "-Tutf8", "-P-c", "-ww", "-rLL=200n"],
                              input=printed("man"), text=True, capture_output=True, check=True)
        self.assertEqual(done.stderr, "")
        text = re.sub(r".\x08", "", done.stdout).replace("\u2212", "-").replace("\u2010", "-")
        for words in commands():
            section = re.search(rf"^   pedzone {' '.join(words)}\n(.*?)(?=^   \S|^\S|\Z)", text,
                                re.MULTILINE | re.DOTALL)
            self.assertIsNotNone(section, words)
            options = set(re.findall(r"^  (?:-\w, )?(--[\w-]+)", printed("help", *words),
                                     re.MULTILINE)) - {"--help"}
            told = set(re.findall(r"^ {7}(?:-\w, )?(--[\w-]+)", section[1], re.MULTILINE))
            self.assertEqual(told, options, words)
            self.assertRegex(section[1], r"Examples?:")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
