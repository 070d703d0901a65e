"""A street of 7 m with sidewalks between two zebra crossings 200 m apart: demand, runs, and what is
read from SUMO's own outputs. Shares nothing with src/."""
import argparse
import math
import os
import random
import subprocess
import tempfile
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from pathlib import Path

NETWORK = Path(__file__).resolve().parents[3] / "networks/shopping-street/shopping-street.net.xml"
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
LENGTH = 200.0  # [m] of the street
BODY = 0.239  # [m] radius of SUMO's person, 0.478 m wide
CAR = (5.0, 1.8)  # [m] length and width of SUMO's passenger car
DECEL = 4.5  # [m/s²] of it
STEP = 0.1  # [s]
ROUNDING = 0.11  # [m/s²] speeds are told with two digits
ANYWHERE = '<zones><zone id="street" edges="eastward westward" crossing="anywhere"/></zones>'


def arrivals(rng, per_hour, end):
    """Times [s] of a Poisson process."""
    now = 0.0
    while True:
        now += rng.expovariate(per_hour / 3600.0)
        if now >= end:
            return
        yield now


def straight_across(rng):
    """Where a person departs and arrives [m from the west]: at doors opposite each other."""
    at = rng.uniform(2.0, LENGTH - 2.0)
    return at, at


def demand(seed, cars, people, end, places=straight_across, types=None):
    """Route file's text. `types`: vType ids of persons with their shares and definitions."""
    rng = random.Random(seed)
    types = types or {"person": (1.0, '<vType id="person" vClass="pedestrian"/>')}
    lines = []
    for way in ("in_west eastward out_east", "in_east westward out_west"):
        for time in arrivals(rng, cars / 2, end):
            lines.append((time, f'<vehicle id="c{len(lines)}" type="car" depart="{time:.1f}" '
                          f'departSpeed="max"><route edges="{way}"/></vehicle>'))
    for time in arrivals(rng, people, end):
        begin, goal = places(rng)
        north = rng.random() < 0.5
        edges = ("westward", "eastward") if north else ("eastward", "westward")
        depart, arrive = (LENGTH - begin, goal) if north else (begin, LENGTH - goal)
        kind = rng.choices(list(types), [share for share, _ in types.values()])[0]
        lines.append((time, f'<person id="p{len(lines)}" type="{kind}" depart="{time:.1f}" '
                      f'departPos="{depart:.1f}"><walk edges="{" ".join(edges)}" '
                      f'arrivalPos="{arrive:.1f}"/></person>'))
    lines.sort(key=lambda line: line[0])
    car = f'<vType id="car" vClass="passenger" decel="{DECEL}"/>'
    kinds = "".join(definition for _, definition in types.values())
    return f"<routes>{car}{kinds}\n" + "\n".join(text for _, text in lines) + "\n</routes>\n"


def write_scenario(folder, routes, end, zone=ANYWHERE, network=NETWORK):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "s.rou.xml").write_text(routes)
    (folder / "s.zone.xml").write_text(zone)
    (folder / "s.sumocfg").write_text(
        f'<configuration><input><net-file value="{network}"/><route-files value="s.rou.xml"/>'
        f'</input><time><end value="{end}"/><step-length value="{STEP}"/></time></configuration>')


def options(usage, seeds):
    """What the command line says, and the folder to work in."""
    parser = argparse.ArgumentParser(description=usage,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda path: Path(path).resolve())
    parser.add_argument("--seeds", type=int, default=seeds, help="how many, from 1 on")
    parser.add_argument("--model", help="of walking")
    parser.add_argument("--keep", type=Path, help="folder in which runs stay")
    given = parser.parse_args()
    given.model = ["--model", given.model] if given.model else []
    given.scratch = tempfile.TemporaryDirectory()
    given.keep = given.keep or Path(given.scratch.name)
    return given


def run(folder, name, *command):
    """Runs SUMO or pedzone in the scenario's folder; outputs are NAME.fcd.xml and so on."""
    outputs = ["--fcd-output", f"{name}.fcd.xml", "--tripinfo-output", f"{name}.trips.xml",
               "--statistic-output", f"{name}.stats.xml", "--no-step-log", "true",
               "--tripinfo-output.write-unfinished", "true"]
    if command[0] != "sumo":
        outputs = ["--", *outputs]
    done = subprocess.run([str(word) for word in (*command, *outputs)], cwd=folder, env=ENV,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise SystemExit(f"{name} ends with code {done.returncode}:\n{done.stdout[-2000:]}")
    return done.stdout


def run_sumo(folder, seed):
    return run(folder, "sumo", "sumo", "-c", "s.sumocfg", "--seed", seed)


def run_pedzone(folder, program, seed, *options):
    return run(folder, "pedzone", program, "run", "s.sumocfg", "--zone", "s.zone.xml", "--quiet",
               "--seed", seed, "--summary", "pedzone.json", *options)


@dataclass
class Walk:
    """One person, seen from outside."""
    track: list = field(default_factory=list)  # (time, x, y)

    @property
    def way(self):
        return sum(math.dist(a[1:], b[1:]) for a, b in zip(self.track, self.track[1:]))

    @property
    def straight(self):
        return math.dist(self.track[0][1:], self.track[-1][1:])

    def longest_stand(self):
        """[s] within half a metre."""
        longest, since = 0.0, self.track[0]
        for place in self.track:
            if math.dist(place[1:], since[1:]) > 0.5:
                since = place
            longest = max(longest, place[0] - since[0])
        return longest


@dataclass
class Seen:
    """What the floating-car data of a run hold."""
    walks: dict = field(default_factory=dict)
    cars: dict = field(default_factory=dict)  # id -> [(time, x), ...]
    contacts: list = field(default_factory=list)  # (time, person, vehicle, its speed)
    brakings: list = field(default_factory=list)  # (time, vehicle, deceleration)


def gap_to_car(person, car):
    """[m] between a point and a car's rectangle; 0 inside. SUMO tells the middle of the front
    bumper, and degrees clockwise from north."""
    x, y, angle = car
    ahead = (math.sin(math.radians(angle)), math.cos(math.radians(angle)))
    dx, dy = person[0] - x, person[1] - y
    along, aside = dx * ahead[0] + dy * ahead[1], dx * ahead[1] - dy * ahead[0]
    return math.hypot(max(along, -CAR[0] - along, 0.0), max(abs(aside) - CAR[1] / 2, 0.0))


def read_fcd(path):
    seen, speeds = Seen(), {}
    people, cars, now = {}, {}, 0.0
    for event, element in xml.iterparse(path, events=("start", "end")):
        if event == "start":
            if element.tag == "timestep":
                now, people, cars = float(element.get("time")), {}, {}
            continue
        if element.tag == "person":
            place = (float(element.get("x")), float(element.get("y")))
            people[element.get("id")] = place
            seen.walks.setdefault(element.get("id"), Walk()).track.append((now, *place))
        elif element.tag == "vehicle":
            name, speed = element.get("id"), float(element.get("speed"))
            cars[name] = (float(element.get("x")), float(element.get("y")),
                          float(element.get("angle")), speed)
            seen.cars.setdefault(name, []).append((now, cars[name][0]))
        elif element.tag == "timestep":
            for name, car in cars.items():
                slowed = (speeds.get(name, car[3]) - car[3]) / STEP
                if slowed > DECEL + ROUNDING:
                    seen.brakings.append((now, name, slowed))
                for person, place in people.items():
                    if abs(place[0] - car[0]) < 7 and gap_to_car(place, car[:3]) < BODY - 0.01:
                        seen.contacts.append((now, person, name, car[3]))
            speeds = {name: car[3] for name, car in cars.items()}
        element.clear()
    return seen


def read_trips(path):
    """Of each person whether it arrived, its duration [s] and its stages' kinds."""
    trips = {}
    for person in xml.parse(path).getroot().iter("personinfo"):
        arrivals_ = [float(stage.get("arrival", -1)) for stage in person]
        trips[person.get("id")] = (min(arrivals_) >= 0, max(arrivals_) - float(person.get("depart")),
                                   [stage.tag for stage in person])
    return trips


def read_types(path):
    """Of each person its vType."""
    return {person.get("id"): person.get("type")
            for person in xml.parse(path).getroot().iter("personinfo")}


def read_collisions(path):
    return int(xml.parse(path).getroot().find("safety").get("collisions"))
