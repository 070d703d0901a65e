"""What a crowd's steps cost from Python, over what they cost from C++.

    crowd_cost.py CROWD_TWIN [--people 1000] [--steps 100] [--runs 9]

Alternates the two, each in a process of its own, and prints medians. `pedzone` must be importable.
"""
import argparse
import statistics
import subprocess
import sys
from pathlib import Path


def seconds(*command):
    """By the clock on the wall, and by the processors'."""
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    return float(told[0]), float(told[1])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("twin")
    parser.add_argument("--people", default="1000")
    parser.add_argument("--steps", default="100")
    parser.add_argument("--runs", type=int, default=9)
    given = parser.parse_args()
    script = str(Path(__file__).with_name("crowd_twin.py"))
    from_python, from_cpp = [], []
    for _ in range(given.runs):
        from_cpp.append(seconds(given.twin, given.people, given.steps))
        from_python.append(seconds(sys.executable, script, given.people, given.steps))
    for which, name in enumerate(("on the wall", "of processors")):
        python, cpp = ([1e3 * run[which] / int(given.steps) for run in runs]
                       for runs in (from_python, from_cpp))
        ratio = statistics.median(python) / statistics.median(cpp)
        print(f"ms a step {name}: C++ {statistics.median(cpp):.2f} ({min(cpp):.2f} to {max(cpp):.2f}), "
              f"Python {statistics.median(python):.2f} ({min(python):.2f} to {max(python):.2f}), "
              f"ratio of medians {ratio:.3f}")


if __name__ == "__main__":
    main()
