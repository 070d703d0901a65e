#!/usr/bin/python3
"""A long recording of a busy street, made up: what `pedzone validate` takes for it.

usage: large_site.py FOLDER [--persons N] [--vehicles N] [--seconds S] [--pedzone PROGRAM]

Writes FOLDER/site/street_01.csv: persons who cross a street of two lanes at any place and time, and
vehicles on it, some of which stop for a while. With --pedzone it is validated (one seed) and the
processor's time is printed, and a hash of all figures, by which two programs can be compared.
"""

import argparse
import hashlib
import math
import os
import random
import resource
import subprocess
from pathlib import Path

RATE = 10  # [1/s] of clips


def person(rng, name, seconds):
    """From one side of the street to the other, not quite straight."""
    begin = rng.randrange(int(seconds * RATE))
    x, slope, sway = rng.uniform(-30, 30), rng.uniform(-0.5, 0.5), rng.uniform(0, 0.6)
    speed, side = rng.uniform(0.9, 1.7), rng.choice((-1, 1))
    for k in range(int(24 / speed * RATE)):
        way = -12 + speed * k / RATE
        yield (f"{(begin + k) / RATE:.1f},ped,{name},{x + slope * way + sway * math.sin(way):.3f},"
               f"{side * way:.3f},,,,")


def vehicle(rng, name, seconds):
    """Along its lane; one in four stops on the way."""
    k, x, speed = rng.randrange(int(seconds * RATE)), -60.0, rng.uniform(3, 9)
    lane = rng.choice((-1, 1))
    stop, rest = (rng.uniform(-30, 30), rng.randrange(20, 200)) if rng.random() < 0.25 else (99, 0)
    while x < 60:
        yield (f"{k / RATE:.1f},veh,{name},{lane * x:.3f},{-1.75 * lane:.3f},"
               f"{0.0 if lane > 0 else math.pi:.4f},2.2,2.2,0.9")
        k += 1
        if x >= stop and rest > 0:
            rest -= 1
        else:
            x += speed / RATE


def write(folder, options):
    rng = random.Random(7)
    rows = ["t,kind,id,x,y,heading,front,rear,half_width"]
    for count, make in ((options.persons, person), (options.vehicles, vehicle)):
        for name in range(count):
            rows += make(rng, name, options.seconds)
    path = Path(folder) / "site" / "street_01.csv"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(rows) + "\n", encoding="ascii")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--persons", type=int, default=1115)
    parser.add_argument("--vehicles", type=int, default=331)
    parser.add_argument("--seconds", type=float, default=1200.0)
    parser.add_argument("--pedzone")
    options = parser.parse_args()
    write(options.folder, options)
    if not options.pedzone:
        return
    figures = Path(options.folder) / "figures.json"
    subprocess.run([options.pedzone, "validate", "--data", options.folder, "--seeds", "1",
                    "--resamples", "10", "--json", str(figures)], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{options.persons} persons, {options.vehicles} vehicles, {options.seconds:g} s: "
          f"{used.ru_utime:.1f} s of processor, figures "
          f"{hashlib.sha256(figures.read_bytes()).hexdigest()[:16]}")


if __name__ == "__main__":
    main()
