#!/usr/bin/python3
"""The report of a study of 1,000 runs takes less than 30 s and 1 GB.

A few runs are real; their outputs stand in for all others, each under its own id, with measures
that differ a little. Time is the processor's, so that a busy machine does not decide.

usage: test_report_speed.py PEDZONE_PROGRAM PLANNED_RUNS_PROGRAM SCENARIOS_FOLDER
"""

import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

REAL_SEEDS, SEEDS = 3, 500
MODELS = 2
MOST_SECONDS, MOST_MEMORY = 30.0, 1e9  # [s], [bytes]
STUDY = """<study id="many" seeds="1-{seeds}" end="600">
  <scenario id="plaza" file="{scenario}"/>
</study>"""


def stand_in(results, planned, real):
    """Makes the missing runs' folders from those that were made."""
    scatter = random.Random(1)
    for run in planned:
        folder = results / "runs" / run["id"]
        if folder.exists():
            continue
        definition = run["definition"]
        twin = real[definition["model"], 1 + definition["seed"] % REAL_SEEDS]
        folder.mkdir()
        for output in twin.iterdir():
            if output.name != "record.json":
                os.link(output, folder / output.name)
        record = json.loads((twin / "record.json").read_text())
        measures = {key: value * scatter.uniform(0.9, 1.1)
                    for key, value in record["measures"].items()}
        record |= {"id": run["id"], "definition": definition, "measures": measures}
        (folder / "record.json").write_text(json.dumps(record))


def main():
    pedzone, planned_runs, scenarios = map(Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        study, results = Path(name) / "many.study.xml", Path(name) / "results"
        text = STUDY.format(seeds=REAL_SEEDS, scenario=scenarios / "plaza/plaza-medium.sumocfg")
        study.write_text(text)
        subprocess.run([pedzone, "study", "run", study, "--out", results, "--jobs", "2"],
                       check=True)
        (results / "study.xml").write_text(text.replace(f"1-{REAL_SEEDS}", f"1-{SEEDS}"))
        planned = json.loads(subprocess.check_output([planned_runs, results]))
        real = {(run["definition"]["model"], run["definition"]["seed"]): results / "runs" / run["id"]
                for run in planned if run["definition"]["kind"] == "study"
                and run["definition"]["seed"] <= REAL_SEEDS}
        assert len(real) == MODELS * REAL_SEEDS, real
        stand_in(results, planned, real)

        report = subprocess.Popen([pedzone, "study", "report", results])
        _, status, used = os.wait4(report.pid, 0)
        assert status == 0, status
        rows = (results / "runs.csv").read_text().count("\n") - 1
        assert rows == MODELS * SEEDS, rows
        seconds, memory = used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss
        print(f"{rows} runs: {seconds:.1f} s, {memory / 1e6:.0f} MB, page of "
              f"{(results / 'report.html').stat().st_size / 1e6:.1f} MB")
        assert seconds < MOST_SECONDS and memory < MOST_MEMORY


if __name__ == "__main__":
    main()
