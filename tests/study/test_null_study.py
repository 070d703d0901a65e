"""Nothing is found where there is nothing: striping against striping, on disjoint seeds.

100 real runs of a street; 200 times two sets of 25 of its seeds are drawn and compared with the
study's own statistics. The same street with people who want to walk at 90 % of the speed is the
planted difference, and must be found at its size.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from random_street import random_street  # noqa: E402

STUDY = """<study id="null" seeds="1-100" models="striping">
  <scenario file="street.sumocfg"/>
  <scenario file="slow.sumocfg"/>
</study>
"""
LEAST, MOST = 0.02, 0.09  # of repetitions called different at the 5 % level
# The same of a single measure: all but 1 in 400 of binomial counts with 200 repetitions. What hardly
# happens in a run is called different more seldom: Welch's test is cautious with few counts.
LEAST_OF_ONE, MOST_OF_ONE = 0.01, 0.1
SELDOM = 3.0  # a run
SLOWER = 0.9  # of the walking speed


def run_study(pedzone, folder):
    """The table of runs of a study that has been run and reported."""
    (folder / "study.xml").write_text(STUDY)
    results = folder / "results"
    subprocess.run([pedzone, "study", "run", folder / "study.xml", "--out", results, "--jobs", "2"],
                   check=True)
    return results / "runs.csv"


def check_null(found):
    # What is the same in every run, as the share of those who arrive is here, never is different.
    same = {key for key, trial in found["planted"].items() if trial["size"] == 0}
    share = {key: trial["different"] / found["repetitions"] for key, trial in found["null"].items()
             if key not in same}
    overall = sum(share.values()) / len(share)
    print(f"called different where nothing is: {overall:.1%} over all; " +
          ", ".join(f"{key} {value:.1%}" for key, value in share.items()))
    assert LEAST <= overall <= MOST, overall
    for key, value in share.items():
        seldom = key.startswith("conflict.") and found["null"][key]["reference"] < SELDOM
        assert (seldom or LEAST_OF_ONE <= value) and value <= MOST_OF_ONE, (key, value)
    family = found["anyOfFamily"] / found["repetitions"]
    print(f"any of the family, corrected: {family:.1%}")
    assert family <= MOST, family


def check_planted(found):
    speed, time = (found["planted"][key] for key in ("person.speed", "person.travelTime"))
    for trial, factor in ((speed, SLOWER), (time, 1 / SLOWER)):
        # Nearly that of free walking: whom others hold up loses less.
        planted = (factor - 1) * trial["reference"]
        print(f"planted {planted:+.3f}, in all runs {trial['size']:+.3f}; "
              f"found in {trial['different']}, at its size in {trial['withinStudent']} and "
              f"{trial['withinBootstrap']} (bootstrap) of {found['repetitions']}")
        assert abs(trial["size"] / planted - 1) < 0.05, trial
        assert trial["different"] >= 0.95 * found["repetitions"], trial
        for within in ("withinStudent", "withinBootstrap"):
            assert trial[within] >= 0.91 * found["repetitions"], trial


def main():
    pedzone, null_study = (Path(argument).resolve() for argument in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as name:
        random_street(name)
        table = run_study(pedzone, Path(name))
        found = json.loads(subprocess.run([null_study, table, "street", "slow"], check=True,
                                          capture_output=True, text=True).stdout)
    assert set(found["runs"].values()) == {100}, found["runs"]
    check_null(found)
    check_planted(found)


if __name__ == "__main__":
    main()
