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
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()[0])


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
    ratios = [python / cpp for python, cpp in zip(from_python, from_cpp)]
    steps = int(given.steps)
    print(f"C++    {1e3 * statistics.median(from_cpp) / steps:.3f} ms a step")
    print(f"Python {1e3 * statistics.median(from_python) / steps:.3f} ms a step")
    print(f"ratio  {statistics.median(from_python) / statistics.median(from_cpp):.3f} of medians, "
          f"{min(ratios):.3f} to {max(ratios):.3f} of pairs")


if __name__ == "__main__":
    main()
