"""The crowd of crowd_twin.cpp from Python: the same people, vehicles and steps.

    crowd_twin.py PEOPLE STEPS
"""
import math
import sys
import time

import pedzone

SIDE = 60.0
VEHICLES = 10


def make_crowd(people):
    zone = pedzone.Zone.from_polygons([(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)],
                                      holes=[[(28, 28), (32, 28), (32, 32), (28, 32)]])
    crowd = pedzone.Crowd(zone, seed=1)
    for k in range(people):
        column, row = 1.0 + 1.7 * (k % 34), 1.0 + 1.7 * (k // 34)
        crowd.add((column, row), (SIDE - 1.0, row) if k % 2 == 0 else (column, SIDE - 1.0),
                  speed=1.0 + 0.05 * (k % 13), id=f"p{k}")
    return crowd


def vehicles_at(now):
    vehicles = []
    for v in range(VEHICLES):
        way = -20.0 - 3.0 * v + 2.0 * now
        east = v % 2 == 0
        vehicles.append(pedzone.Vehicle(f"v{v}", (way if east else SIDE - way, 3.0 + 5.5 * v),
                                        heading=0.0 if east else math.pi, speed=2.0))
    return vehicles


def walk(people, steps):
    """Seconds that the steps took, on the wall and of the processors, and the crowd after them."""
    crowd = make_crowd(people)
    begin, work_begin = time.perf_counter(), time.process_time()
    total = 0.0
    for step in range(steps):
        crowd.step(0.1, vehicles_at(0.1 * step))
        total += crowd.x.sum() + crowd.y.sum()
    return time.perf_counter() - begin, time.process_time() - work_begin, crowd


if __name__ == "__main__":
    wall, work, _ = walk(int(sys.argv[1]), int(sys.argv[2]))
    print(f"{wall:.6f} {work:.6f}")
