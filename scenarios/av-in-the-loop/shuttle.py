#!/usr/bin/python3
"""An automated shuttle as a TraCI client: it follows a route, sees with a simple sensor, and brakes.

It is meant to be copied: replace Sensor and Driver by your own, keep the loop.

usage: shuttle.py --port 8813 [--order 1] [--speed 15] [--sensor-range 20] [--log shuttle.csv]
"""

import argparse
import csv
import math
import os
import sys

sys.path.append(os.path.join(os.environ.get("SUMO_HOME", "/usr/share/sumo"), "tools"))
import traci  # noqa: E402  (SUMO's tools have to be found first)

LENGTH, WIDTH = 3.93, 1.98  # m
ACCELERATION = 1.0          # m/s2
COMFORTABLE = 1.5           # m/s2 of braking
EMERGENCY = 6.0             # m/s2 of braking
STANDOFF = 1.5              # m kept before a person
MARGIN = 0.6                # m beside the shuttle that has to be free
FORESIGHT = 2.0             # s for which people are thought to walk on


class Way:
    """The line of a route's lanes, walked by its length."""

    def __init__(self, edges):
        self.points = []
        for edge in edges:
            for point in traci.lane.getShape(f"{edge}_0"):
                if not self.points or math.dist(point, self.points[-1]) > 0.01:
                    self.points.append(point)
        self.at = [0.0]
        for a, b in zip(self.points, self.points[1:]):
            self.at.append(self.at[-1] + math.dist(a, b))
        self.length = self.at[-1]

    def place(self, s):
        """Point and direction [rad] after s metres."""
        k = max(0, min(len(self.at) - 2, next((i for i, at in enumerate(self.at) if at > s), 1) - 1))
        (ax, ay), (bx, by) = self.points[k], self.points[k + 1]
        share = (s - self.at[k]) / (self.at[k + 1] - self.at[k])
        return (ax + share * (bx - ax), ay + share * (by - ay)), math.atan2(by - ay, bx - ax)


def crosses(a, b, c, d):
    """Whether the lines from a to b and from c to d cross."""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


class Sensor:
    """Sees persons within a range and an opening angle, but not behind buildings and vehicles."""

    def __init__(self, reach, opening):
        self.reach, self.half = reach, math.radians(opening) / 2
        self.walls = []
        for polygon in traci.polygon.getIDList():
            if traci.polygon.getType(polygon) == "building":
                self.walls += outline(traci.polygon.getShape(polygon))

    def see(self, me, place, heading):
        """Ids and places [m] of the persons that are seen from a place."""
        walls = self.walls + [line for other in traci.vehicle.getIDList() if other != me
                              for line in outline(body(other))]
        seen = {}
        for person in traci.person.getIDList():
            there = traci.person.getPosition(person)
            if not 0 < math.dist(place, there) <= self.reach:
                continue
            off = math.atan2(there[1] - place[1], there[0] - place[0]) - heading
            if abs(math.remainder(off, 2 * math.pi)) > self.half:
                continue
            if not any(crosses(place, there, *wall) for wall in walls):
                seen[person] = there
        return seen


def outline(points):
    return list(zip(points, list(points[1:]) + [points[0]]))


def body(vehicle):
    """The corners of a vehicle. SUMO's position is the middle of its front bumper."""
    x, y = traci.vehicle.getPosition(vehicle)
    heading = math.radians(90.0 - traci.vehicle.getAngle(vehicle))
    ahead, side = (math.cos(heading), math.sin(heading)), (-math.sin(heading), math.cos(heading))
    length, half = traci.vehicle.getLength(vehicle), traci.vehicle.getWidth(vehicle) / 2
    return [(x - back * ahead[0] + left * side[0], y - back * ahead[1] + left * side[1])
            for back, left in ((0, half), (0, -half), (length, -half), (length, half))]


class Driver:
    """Chooses an acceleration [m/s2] from what the sensor sees."""

    def __init__(self, step, cruise):
        self.step, self.cruise, self.before = step, cruise, {}

    def choose(self, seen, place, heading, speed):
        room = math.inf  # m to the nearest person who is or will be in the way
        for person, there in seen.items():
            last = self.before.get(person, there)
            velocity = [(now - then) / self.step for now, then in zip(there, last)]
            for ahead in (0.0, FORESIGHT / 2, FORESIGHT):
                x = there[0] + ahead * velocity[0] - place[0]
                y = there[1] + ahead * velocity[1] - place[1]
                along = x * math.cos(heading) + y * math.sin(heading)
                beside = abs(y * math.cos(heading) - x * math.sin(heading))
                if along > -0.5 and beside < WIDTH / 2 + MARGIN:
                    room = min(room, max(0.0, along - STANDOFF))
        self.before = seen
        if room == math.inf:
            return min(ACCELERATION, (self.cruise - speed) / self.step)
        needed = speed * speed / (2 * room) if room > 0 else EMERGENCY
        if needed > 2 * COMFORTABLE:
            return -min(EMERGENCY, speed / self.step)
        target = min(self.cruise, math.sqrt(2 * COMFORTABLE * room))
        return max(-EMERGENCY, min(ACCELERATION, (target - speed) / self.step))


def drive(options, log):
    step = traci.simulation.getDeltaT()
    way = Way(traci.route.getEdges(options.route))
    sensor = Sensor(options.sensor_range, options.opening)
    cruise, end = options.speed / 3.6, traci.simulation.getEndTime()
    trips, me, s, speed, driver = 0, None, 0.0, 0.0, None
    while traci.simulation.getTime() < end:
        time = traci.simulation.getTime()
        if me is None and options.begin <= time < options.last:
            me, s, speed, driver, trips = f"shuttle{trips}", 0.5, 0.0, Driver(step, cruise), trips + 1
            traci.vehicle.add(me, options.route, typeID="shuttle", departPos="0")
        elif me in traci.vehicle.getIDList():
            place, heading = way.place(s)
            seen = sensor.see(me, place, heading)
            pull = driver.choose(seen, place, heading, speed)
            speed = max(0.0, speed + pull * step)
            s += speed * step
            log.writerow([f"{time:.2f}", me, f"{s:.3f}", f"{speed:.3f}", f"{pull:.3f}", len(seen)])
            if s >= way.length:
                traci.vehicle.remove(me)
                me = None
            else:
                (x, y), heading = way.place(s)
                traci.vehicle.moveToXY(me, "", -1, x, y, 90.0 - math.degrees(heading), keepRoute=2)
        traci.simulationStep()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--port", type=int, default=8813, help="at which SUMO listens")
    parser.add_argument("--order", type=int, default=1, help="place among SUMO's clients")
    parser.add_argument("--route", default="westward", help="a route of the scenario")
    parser.add_argument("--speed", type=float, default=15.0, help="km/h that it keeps")
    parser.add_argument("--sensor-range", type=float, default=20.0, help="m")
    parser.add_argument("--opening", type=float, default=120.0, help="degrees")
    parser.add_argument("--begin", type=float, default=60.0, help="s, of the first trip")
    parser.add_argument("--last", type=float, default=220.0, help="s, no trip begins later")
    parser.add_argument("--log", default=os.devnull, help="CSV of what it did")
    options = parser.parse_args()
    traci.init(options.port, numRetries=60)
    traci.setOrder(options.order)
    with open(options.log, "w", newline="") as file:
        log = csv.writer(file)
        log.writerow(["time", "vehicle", "travelled", "speed", "acceleration", "persons_seen"])
        drive(options, log)
    traci.close()


if __name__ == "__main__":
    main()
