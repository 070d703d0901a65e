"""Two studies with overlapping seeds give the same rows for the shared seeds.

Whatever the number of jobs, the order in which runs are made, and what else is in the study.
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from random_street import random_street  # noqa: E402

ONE = """<study id="one" seeds="1-4" models="striping heuristic">
  <scenario file="street.sumocfg"/>
  <scenario file="slow.sumocfg"/>
</study>
"""
# Models, scenarios and seeds the other way round, other seeds and a factor with it.
OTHER = """<study id="other" seeds="6 3-4" models="nonInteracting heuristic striping"
       reference="striping">
  <scenario file="slow.sumocfg"/>
  <scenario file="street.sumocfg"/>
  <factor id="demand">
    <level name="twice"><set sumo="scale" value="2"/></level>
    <level name="as-is"/>
  </factor>
</study>
"""


def rows_of(pedzone, folder, name, text, jobs):
    """Rows of a study's runs, by scenario, demand, model and seed."""
    study = folder / f"{name}.xml"
    study.write_text(text)
    results = folder / name
    subprocess.run([pedzone, "study", "run", study, "--out", results, "--jobs", str(jobs)],
                   check=True)
    with open(results / "runs.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    keyed = {}
    for row in rows:
        level = row.pop("factor.demand", "as-is")
        keyed[row["scenario"], level, row["model"], int(row["seed"])] = row
    assert len(keyed) == len(rows), "a row twice"
    return keyed


def main():
    pedzone = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        random_street(name)
        one = rows_of(pedzone, Path(name), "one", ONE, jobs=1)
        other = rows_of(pedzone, Path(name), "other", OTHER, jobs=2)
    shared = sorted(one.keys() & other.keys())
    assert len(shared) == 2 * 2 * 2, shared  # scenarios, models, seeds 3 and 4
    for key in shared:
        assert one[key]["status"] == "done", (key, one[key])
        assert float(one[key]["person.travelTime"]) > 0, (key, one[key])
        assert one[key] == other[key], (key, one[key], other[key])
    times = {row["person.travelTime"] for row in one.values()}
    assert len(times) == len(one), "runs that do not differ by seed and model show nothing"
    print(f"{len(shared)} shared runs are the same in all {len(one[shared[0]])} columns")


if __name__ == "__main__":
    main()
