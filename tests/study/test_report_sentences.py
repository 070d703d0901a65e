#!/usr/bin/python3
"""The sentences of a study's report are true: of runs that are cut off, too.

usage: test_report_sentences.py PEDZONE
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
HERE = Path(__file__).resolve().parent
PLAZA = HERE.parent.parent / "scenarios/plaza/plaza-medium.sumocfg"


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "cut.study.xml").write_text(
            f'<study seeds="1-3" end="250"><scenario file="{PLAZA}"/></study>\n', encoding="utf-8")
        subprocess.run([sys.argv[1], "study", "run", folder / "cut.study.xml", "--out",
                        folder / "results", "--jobs", "2"], check=True, env=ENV,
                       capture_output=True)
        return subprocess.run([sys.executable, HERE / "check_report.py", folder / "results"],
                              check=False, env=ENV).returncode


if __name__ == "__main__":
    sys.exit(main())
