"""SUMO's outputs of one run: persons' and vehicles' trips, routes, and overall statistics."""
import os
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

from junction_ways import counts_own_ways
from scenario import CheckError, open_bytes

# What SUMO leaves in a plan when the walk that was the last stage is removed while it is walked.
_REMOVED_STAGE = "last stage removed"
_HEAD_SIZE = 1000  # [bytes] of an output, in which its first comment names the version


@dataclass
class Stage:
    """One stage of a person's tripinfo; unset times are None."""
    kind: str  # walk, ride, stop, access, transport, tranship
    depart: float = None  # [s]
    arrival: float = None  # [s]
    route_length: float = None  # [m]
    vehicle: str = ""  # of a ride
    depart_pos: float = 0.0  # [m] of a walk
    arrival_pos: float = 0.0  # [m] of a walk that has ended


@dataclass
class PersonTrip:
    """A person's tripinfo."""
    type: str
    depart: float  # [s]
    stages: list

    @property
    def arrived(self):
        """Whether every stage has ended."""
        return bool(self.stages) and all(stage.arrival is not None for stage in self.stages)

    @property
    def duration(self):
        """[s] from departure to arrival; None unless arrived."""
        return self.stages[-1].arrival - self.depart if self.arrived else None


@dataclass
class VehicleTrip:
    """A vehicle's tripinfo."""
    type: str
    depart: float  # [s]
    duration: float  # [s] driven until the end of the simulation where not arrived
    arrived: bool


@dataclass
class Run:
    """The outputs in one folder; None where the run did not write them."""
    folder: str
    fcd_file: str
    persons: dict  # id -> PersonTrip
    vehicles: dict  # id -> VehicleTrip
    plans: dict = None  # id -> [(kind, edges)]
    teleports: int = None
    person_jams: int = None
    own_junctions_only: bool = False  # routeLength: see junction_ways
    extra: dict = field(default_factory=dict)


def find_output(folder, stem, suffixes=(".xml", ".xml.gz")):
    """Path of FOLDER/STEM.xml or .xml.gz, or None."""
    for suffix in suffixes:
        path = os.path.join(folder, stem + suffix)
        if os.path.exists(path):
            return path
    return None


def _time(element, name):
    """[s] an attribute of tripinfo; None where absent or not reached (SUMO writes -1)."""
    text = element.get(name)
    if text is None or text == "" or float(text) < 0:
        return None
    return float(text)


def _is_removed_stage(element):
    return element.tag == "stop" and element.get("actType") == _REMOVED_STAGE


def _complete_elements(path, names):
    """The closed elements of a long XML file that have one of these names, one at a time."""
    with open_bytes(path) as stream:
        try:
            parser = ElementTree.iterparse(stream, events=("start", "end"))
            _, root = next(parser)
            for event, element in parser:
                if event == "end" and element.tag in names:
                    yield element
                    root.clear()
        except (ElementTree.ParseError, OSError, EOFError, StopIteration) as error:
            raise CheckError(f"{path}: {error or 'empty'}") from error


def read_tripinfo(path):
    """(persons, vehicles) of a tripinfo-output."""
    persons, vehicles = {}, {}
    for element in _complete_elements(path, ("personinfo", "tripinfo")):
        if element.tag == "tripinfo":
            vehicles[element.get("id")] = VehicleTrip(
                element.get("vType"), float(element.get("depart")),
                float(element.get("duration")), _time(element, "arrival") is not None
                and not element.get("vaporized"))
            continue
        stages = []
        for child in element:
            if _is_removed_stage(child):
                continue
            length = child.get("routeLength")
            stages.append(Stage(child.tag, _time(child, "depart"), _time(child, "arrival"),
                                None if length is None else float(length),
                                child.get("vehicle", ""), float(child.get("departPos") or 0.0),
                                float(child.get("arrivalPos") or 0.0)))
        persons[element.get("id")] = PersonTrip(
            element.get("type", "DEFAULT_PEDTYPE"), float(element.get("depart")), stages)
    return persons, vehicles


def read_plans(path):
    """Each person's [(stage, edges)] of a vehroute-output."""
    plans = {}
    for element in _complete_elements(path, ("person",)):
        plan = []
        for child in element:
            if _is_removed_stage(child):
                continue
            place = child.get("edges") or child.get("lane") or child.get("busStop") or ""
            if child.tag == "ride":
                place = child.get("to") or child.get("busStop") or ""
            plan.append((child.tag, place))
        plans[element.get("id")] = plan
    return plans


def _read_counts(folder):
    """(teleports, person jams) of statistics.xml, else of log.txt, else (None, None)."""
    path = find_output(folder, "statistics")
    if path:
        counts = {}
        for element in _complete_elements(path, ("teleports", "persons")):
            counts.update({(element.tag, name): int(value)
                           for name, value in element.attrib.items() if value.isdigit()})
        if ("teleports", "total") not in counts:
            raise CheckError(f"{path}: no <teleports total=...>")
        return counts["teleports", "total"], counts.get(("persons", "jammed"))
    path = find_output(folder, "log", (".txt",))
    if path:
        with open_bytes(path) as stream:
            text = stream.read().decode("utf-8", "replace")
        return (len(re.findall(r"^Warning: Teleporting vehicle", text, re.M)),
                len(re.findall(r"^Warning: Person '.*' is jammed", text, re.M)))
    return None, None


def read_run(folder, need_fcd=True):
    """Reads FOLDER/{tripinfo,vehroute,statistics}.xml[.gz] and log.txt; finds fcd.xml[.gz]."""
    fcd_file = find_output(folder, "fcd")
    if need_fcd and fcd_file is None:
        raise CheckError(f"{folder}: no fcd.xml or fcd.xml.gz")
    tripinfo = find_output(folder, "tripinfo")
    if tripinfo is None:
        raise CheckError(f"{folder}: no tripinfo.xml or tripinfo.xml.gz")
    persons, vehicles = read_tripinfo(tripinfo)
    vehroute = find_output(folder, "vehroute")
    teleports, jams = _read_counts(folder)
    with open_bytes(tripinfo) as stream:
        own_junctions_only = counts_own_ways(stream.read(_HEAD_SIZE))
    return Run(folder, fcd_file, persons, vehicles, read_plans(vehroute) if vehroute else None,
               teleports, jams, own_junctions_only)
