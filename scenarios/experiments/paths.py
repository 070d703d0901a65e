#!/usr/bin/python3
"""Writes the shuttle's paths of experiments 5.1 and 5.3.

usage: paths.py                    all of them, beside this file
       paths.py --steering S       that of 5.1 with another steering, to the standard output

Steering 0 leaves the shuttle on its line (y = 2.5 m), whose side is 2.5 m from the nearer person's
(y = -1 m); with 1 it goes over to that person's line and drives along it: the other one's (y = -1.5 m)
is inside its width, too. It changes over as a cosine does while x goes from 62 m to 47 m, at 2 m/s
along the path, so that it has done so before it meets the first.
"""

import argparse
import math
from pathlib import Path

SPEED = 2.0                 # [m/s] a shuttle among people
BEGIN = 5.0                 # [s]
FROM, TO = 76.0, 2.0        # [m] x of the front bumper
CHANGE = (62.0, 47.0)       # [m] x between which it changes over
LINE, ASIDE = 2.5, 3.5       # [m] its y without steering, and by how much less with steering 1
LANE = -40.0                # [m] y of the middle of 5.3's lane
PIECE = 0.5                 # [m] of x from row to row
STEERINGS = {"straight": 0.0, "half": 0.5, "full": 1.0}


def place(x, steering):
    """y [m] at x."""
    share = min(1.0, max(0.0, (CHANGE[0] - x) / (CHANGE[0] - CHANGE[1])))
    return LINE - steering * ASIDE * (1.0 - math.cos(math.pi * share)) / 2.0


def rows(points):
    """Times at constant speed."""
    time, text = BEGIN, "t,x,y\n"
    for k, (x, y) in enumerate(points):
        if k > 0:
            time += math.dist(points[k - 1], (x, y)) / SPEED
        text += f"{time:.4f},{x:.3f},{y:.3f}\n"
    return text


def steered(steering):
    count = round((FROM - TO) / PIECE)
    return rows([(x, round(place(x, steering), 3))
                 for x in (FROM - k * PIECE for k in range(count + 1))])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steering", type=float)
    options = parser.parse_args()
    if options.steering is not None:
        print(steered(options.steering), end="")
        return
    folder = Path(__file__).resolve().parent
    for name, steering in STEERINGS.items():
        (folder / f"5.1-{name}.csv").write_text(steered(steering), encoding="utf-8")
    (folder / "5.3.csv").write_text(rows([(FROM, LANE), (TO, LANE)]), encoding="utf-8")


if __name__ == "__main__":
    main()
