"""One random scenario: made from a seed, run by plain SUMO and by pedzone, and checked."""

import json
import math
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path

from kinds_of_people import make_people
from random_demand import make_demand
from random_network import SUMO_ENVIRONMENT, make_network

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "check"))
import check_run  # noqa: E402  (found only now)
from overlap import overlapping_pairs  # noqa: E402

LONGER = 1500  # [s] for who is late: SUMO lets people and vehicles that block each other go after 300
END = 600  # [s] everybody departs in the first minute; a walk through a whole network takes less
TIMEOUT = 300  # [s] of wall time for one run
STEP_LENGTHS = (0.1, 0.5, 1.0)
MOST_DISCONNECTED = 12
MOST_ACROSS = 8.0  # [m] the widest lane, and what is walked in a step
MOST_AT_BUS_STOP = 16.0  # [m] waiting places are spread over its 12 m, 3 m beside the lane


@dataclass
class Outcome:
    """What became of one seed."""
    seed: int
    step_length: float = 0.0
    skipped: str = ""              # why the input is no fair one: plain SUMO fails on it
    failures: list = field(default_factory=list)
    person_steps: int = 0          # rows of the trajectories
    controlled: int = 0            # persons
    stuck: int = 0                 # persons that arrive in plain SUMO and never with pedzone
    events: int = 0                # meddled with
    contacts: int = 0              # person-vehicle pairs, for information

    def line(self) -> str:
        text = f"seed {self.seed}: {self.step_length} s steps, "
        if self.skipped:
            return text + "skipped: " + self.skipped
        text += f"{self.controlled} persons, {self.person_steps} person-steps, {self.events} events"
        bad = self.failures + ([f"{self.stuck} arrived in plain SUMO only"] if self.stuck else [])
        return text + (": " + "; ".join(bad) if bad else ": fine")


def last_words(text: str) -> str:
    """The line of a failed program's output that says why."""
    lines = [line for line in text.splitlines() if line.strip()]
    telling = [line for line in lines if "Assertion" in line or "Error" in line]
    return re.sub(r"\s+", " ", (telling or lines or ["no message"])[-1])[-200:]


def most_between(before: ET.Element, stage: ET.Element) -> float:
    """[m] how far apart a walk's end and the begin of the next stage may be."""
    if stage.tag == "ride":
        return MOST_AT_BUS_STOP
    if stage.tag == "walk":
        gap = float(stage.get("departPos", "0")) - float(before.get("arrivalPos", "0"))
        return MOST_ACROSS + abs(gap)
    return MOST_ACROSS


class Case:
    """A seed's scenario in a folder of its own."""

    def __init__(self, seed: int, folder: Path, pedzone: str, meddler: str, people: bool):
        self.folder, self.pedzone, self.meddler, self.people = folder, pedzone, meddler, people
        self.rng = random.Random(seed)
        self.outcome = Outcome(seed, STEP_LENGTHS[seed % len(STEP_LENGTHS)])
        self.walked, self.reroutes = set(), set()  # (time, person)

    def run(self) -> Outcome:
        self.folder.mkdir(parents=True, exist_ok=True)
        try:
            self.make()
        except subprocess.CalledProcessError as error:
            self.outcome.skipped = "SUMO's tools: " + last_words(error.stdout or "")
            return self.outcome
        if self.plain():
            self.walk_and_check()
        return self.outcome

    # --- input ---

    def make(self) -> None:
        edges = make_network(self.rng, self.folder)
        make_demand(self.rng, self.folder, edges)
        root = ET.Element("configuration")
        for name, value in (("net-file", "net.net.xml"), ("route-files", "routes.rou.xml"),
                            ("additional-files", "stops.add.xml,polygons.add.xml"),
                            ("step-length", f"{self.outcome.step_length:g}"), ("end", str(END)),
                            ("seed", str(self.outcome.seed)), ("no-warnings", "true")):
            ET.SubElement(root, name, {"value": value})
        ET.ElementTree(root).write(self.folder / "town.sumocfg")
        self.zone_file = self.make_zone_file(edges) if self.rng.random() < 0.3 else None
        if self.people:
            self.zone_file = make_people(self.outcome.seed, self.folder, self.zone_file)

    def make_zone_file(self, edges: list) -> Path:
        """A zone file that asks for something else than the rule without one does."""
        zone = {"id": "random"}
        shared = [edge for edge in edges if edge.shared]
        choice = self.rng.choice(("types", "edges", "open"))
        if choice == "types":
            zone["edgeTypes"] = self.rng.choice(sorted({edge.type for edge in shared}))
        elif choice == "edges":
            chosen = self.rng.sample(shared, self.rng.randint(1, len(shared)))
            zone["edges"] = " ".join(edge.id for edge in chosen)
        if choice == "open" or self.rng.random() < 0.5:
            zone["openSpace"] = f"{self.rng.choice((0, 3, 12)):g}"
        root = ET.Element("zones")
        node = ET.SubElement(root, "zone", zone)
        ET.SubElement(node, "param", {"key": "sight", "value": f"{self.rng.uniform(3, 12):.1f}"})
        path = self.folder / "random.zone.xml"
        ET.ElementTree(root).write(path)
        return path

    # --- runs ---

    def outputs(self, kind: str) -> list:
        """SUMO's options that write what the check reads into a folder of that kind of run."""
        folder = self.folder / kind
        folder.mkdir(exist_ok=True)
        return ["--fcd-output", str(folder / "fcd.xml"), "--fcd-output.acceleration", "false",
                "--tripinfo-output", str(folder / "tripinfo.xml"),
                "--tripinfo-output.write-unfinished", "true",
                "--vehroute-output", str(folder / "vehroute.xml"),
                "--vehroute-output.write-unfinished", "true",
                "--statistic-output", str(folder / "statistics.xml")]

    def execute(self, command: list) -> tuple:
        """(exit code, output); 124 after the timeout."""
        try:
            done = subprocess.run(command, cwd=self.folder, env=SUMO_ENVIRONMENT, timeout=TIMEOUT,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace")
            return done.returncode, done.stdout
        except subprocess.TimeoutExpired as error:
            return 124, f"{error.output or ''}\nno end after {TIMEOUT} s"

    def plain(self) -> bool:
        """Plain SUMO on the same input, which drops persons whose plan it refuses. False where it
        aborts: the input is no fair one then."""
        for _ in range(MOST_DISCONNECTED):
            code, text = self.execute(["sumo", "-c", "town.sumocfg", *self.outputs("plain")])
            refused = re.search(r"Disconnected walk for person '(\w+)'", text)
            if not refused:
                break
            self.drop_person(refused.group(1))
        if code == 0 and self.meddler:
            code, text = self.execute([self.meddler, "town.sumocfg", str(self.outcome.seed),
                                       "plain-events.csv", "--plain", "--",
                                       *self.outputs("plain-meddled")])
        if code != 0:
            self.outcome.skipped = "plain SUMO: " + last_words(text)
        return code == 0

    def drop_person(self, name: str) -> None:
        path = self.folder / "routes.rou.xml"
        tree = ET.parse(path)
        for node in list(tree.getroot()):
            if node.get("id") in (name, f"car-{name}"):
                tree.getroot().remove(node)
        tree.write(path)

    def walk_and_check(self) -> None:
        outcome, trajectories = self.outcome, self.folder / "run" / "trajectories.csv"
        if self.meddler:
            command = [self.meddler, "town.sumocfg", str(outcome.seed), "events.csv",
                       str(trajectories), "--", *self.outputs("run")]
        else:
            command = self.pedzone_command("--trajectories", str(trajectories), "--summary",
                                           str(self.folder / "run" / "summary.json"), "--",
                                           *self.outputs("run"))
        code, text = self.execute(command)
        (self.folder / "run" / "output.txt").write_text(text)
        if code != 0:
            outcome.failures.append(f"exit code {code}: {last_words(text)}")
            return
        self.read_trajectories(trajectories)
        removed = self.read_events()
        self.check(removed)

    def pedzone_command(self, *arguments: str) -> list:
        zone = ["--zone", str(self.zone_file)] if self.zone_file else []
        return [self.pedzone, "run", "town.sumocfg", *zone, "--seed", str(self.outcome.seed),
                "--threads", "1", *arguments]

    # --- checks ---

    def read_trajectories(self, path: Path) -> None:
        """Counts person-steps; every figure must be finite, every person once a step."""
        outcome, persons, seen = self.outcome, set(), set()
        with open(path, encoding="utf-8") as stream:
            assert stream.readline().startswith("time,id,x,y,vx,vy,heading,motion")
            for line in stream:
                time, name, *figures = line.rstrip("\n").split(",")
                outcome.person_steps += 1
                persons.add(name)
                if not all(math.isfinite(float(text)) for text in figures[:5]):
                    outcome.failures.append(f"{name} at {time} s is no number: {line.strip()}")
                if (time, name) in seen:
                    outcome.failures.append(f"{name} twice at {time} s")
                seen.add((time, name))
        outcome.controlled = len(persons)
        self.walked = {(float(time), name) for time, name in seen}

    def read_events(self) -> dict:
        """{person: set of events} of a meddler's run."""
        events = {}
        path = self.folder / "events.csv"
        if self.meddler and path.exists():
            for line in path.read_text().splitlines():
                time, event, name = line.split(",")
                events.setdefault(name, set()).add(event)
                if event == "reroute":
                    self.reroutes.add((float(time), name))
                self.outcome.events += 1
        return events

    def measure(self, plain: str) -> dict:
        """The figures of tests/check against that plain run. The trajectories tell who is
        controlled: what FCD shows by itself also takes in the moment before, when somebody stands
        still on the same edge."""
        arguments = ["town.sumocfg", "run", "--plain", plain]
        arguments = [str(self.folder / name) if "-" != name[0] else name for name in arguments]
        if self.zone_file and not self.meddler:
            arguments += ["--zone", str(self.zone_file)]
        check = check_run.Check(check_run.parse_arguments(arguments))
        check.controlled = check_run.read_controlled(
            str(self.folder / "run" / "trajectories.csv"), check.fcd)
        self.checked = check
        return check.measure()

    def overlaps(self) -> int:
        """Pairs of people whom pedzone walks nearer than their turned shoulders allow."""
        summary = json.loads((self.folder / "run" / "summary.json").read_text())
        return len(overlapping_pairs(self.checked, summary["jams"])[0])

    def check(self, events: dict) -> None:
        """Takes the measure; what was meddled with is compared with nothing."""
        outcome = self.outcome
        try:
            result = self.measure("plain-meddled" if self.meddler else "plain")
            jumps = result["jumps"]["controlled_jumps"]
            if self.meddler and jumps:
                # A jump that SUMO makes without any meddling is its own, too.
                unmeddled = self.measure("plain")["jumps"]["controlled_jumps"]
                jumps = [jump for jump in jumps if jump in unmeddled]
        except check_run.CheckError as error:
            outcome.failures.append(f"check_run: {error}")
            return
        (self.folder / "check.json").write_text(json.dumps(result, indent=1))
        removed = [name for name, what in events.items() if "remove" in what]
        lost = [name for name in result["persons"]["lost_ids"] if name not in removed]
        expect = {"lost": len(lost), "jumps": self.count_jumps(jumps),
                  "not a number": result["nan"], "persons outside": result["outside"]["persons"]}
        if not self.meddler:
            expect["pairs of bodies that overlap"] = self.overlaps()
            expect["other stages than in plain SUMO"] = result["plain"]["stages_differ"]
            expect["not departed, unlike in plain SUMO"] = result["plain"]["missing"]
            outcome.stuck = len(self.stranded())
        for name, count in expect.items():
            if count:
                outcome.failures.append(f"{count} {name}")
        outcome.contacts = result["contacts"]["controlled"]["pairs"]

    def count_jumps(self, jumps: list) -> int:
        """Jumps of persons in pedzone's hands, but those at the end of a walk to where SUMO begins
        the next stage: beside the lane or somewhere across it, along a bus stop, or for a walk that
        a meddler appended at that stage's own departPos. A reroute ends the walk, too, and begins
        another where SUMO believes the person to be; where the new way leaves the zone from that
        very edge, pedzone cannot take it over again (README)."""
        ends = {}
        for node in ET.parse(self.folder / "run" / "tripinfo.xml").getroot().iter("personinfo"):
            stages = list(node)
            ends[node.get("id")] = [
                (float(before.get("arrival", "-1")), most_between(before, stage))
                for before, stage in zip(stages, stages[1:]) if before.tag == "walk"]

        def explained(jump: dict) -> bool:
            moment = (jump["time"], jump["person"])
            if moment in self.reroutes and moment not in self.walked:
                return True
            return any(abs(jump["time"] - time) <= 1.5 * self.outcome.step_length
                       and jump["distance"] <= distance
                       for time, distance in ends.get(jump["person"], ()))

        return sum(not explained(jump) for jump in jumps)

    def arrivals(self, kind: str) -> dict:
        """{person: time [s]} of those who have ended all of their stages."""
        found = {}
        for node in ET.parse(self.folder / kind / "tripinfo.xml").getroot().iter("personinfo"):
            times = [float(stage.get("arrival", "-1")) for stage in node]
            if times and min(times) >= 0:
                found[node.get("id")] = times[-1]
        return found

    def stranded(self) -> set:
        """Persons that arrive in plain SUMO, with half the time left, and never with pedzone."""
        due = {name for name, time in self.arrivals("plain").items() if time < END / 2}
        late = due - self.arrivals("run").keys()
        if not late:
            return late
        code, _ = self.execute(self.pedzone_command("--end", str(LONGER), "--",
                                                    *self.outputs("longer")))
        return late if code else late - self.arrivals("longer").keys()
