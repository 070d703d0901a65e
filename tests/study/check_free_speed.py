#!/usr/bin/python3
"""The free speed that a study measures is that of tests/scenario/free_speed.py, person by person.

usage: check_free_speed.py PEDZONE MEASURE_RUN SCENARIO.sumocfg
"""
import csv
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scenario"))
from free_speed import ENV, SPACING, STEP, lonely_demand, option, speeds  # noqa: E402

PERSONS = 3
SAME = 1e-6  # relative: the same sums


def measured(program, *files):
    text = subprocess.run([program, "--free-speed", *files], check=True, capture_output=True,
                          text=True).stdout
    return {name: float(value) for name, value in (line.split() for line in text.splitlines())}


def agree(model, ours, found):
    print(f"{model}: {ours}\n{'':>{len(model)}}  {found}")
    return bool(found) and ours.keys() == found.keys() and all(
        abs(ours[person] - speed) <= SAME * speed for person, speed in found.items())


def main():
    pedzone, program, scenario = sys.argv[1:]
    scenario = Path(scenario).resolve()
    routes = option(ElementTree.parse(scenario).getroot(), "route-files")
    demand, count = lonely_demand([scenario.parent / name for name in routes], PERSONS)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        ElementTree.ElementTree(demand).write(folder / "lonely.rou.xml")
        common = ["--route-files", str(folder / "lonely.rou.xml"), "--end", str(count * SPACING),
                  "--step-length", str(STEP), "--precision", "4", "--fcd-output"]
        plain, ours, table = folder / "plain.xml", folder / "ours.xml", folder / "t.csv"
        subprocess.run(["sumo", "-c", scenario, *common, plain], check=True, env=ENV,
                       capture_output=True)
        subprocess.run([pedzone, "run", scenario, "--trajectories", table, "--", *common, ours],
                       check=True, env=ENV, capture_output=True)
        with open(table, newline="", encoding="utf-8") as file:
            controlled = {(row["id"], round(float(row["time"]), 2)) for row in csv.DictReader(file)}
        good = agree("striping", measured(program, plain), speeds(plain))
        good &= agree("pedzone", measured(program, ours, table), speeds(ours, controlled))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
