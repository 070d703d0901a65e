"""A run's trips from tripinfo-output: whole trips, walks, and who was to travel."""
import hashlib
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

import numpy


@dataclass
class Trip:
    id: str
    type: str
    due: float  # [s] intended departure
    arrival: float  # [s] None: not by the end
    walks: list  # of persons: [s, s, m/s] begin, end (infinite: not by the end), maximum speed
    loss: float = 0.0  # [s] of vehicles: delay of the departure and time lost


def _came(text):
    return float(text) if text is not None and float(text) >= 0 else None


def read_trips(path, end):
    """(persons, vehicles) due before the end of the run [s]."""
    persons, vehicles = [], []
    for element in ElementTree.parse(path).getroot():
        if element.tag == "personinfo":
            stages = list(element)
            moves = [stage for stage in stages if stage.tag != "stop"] or stages
            walks = [(float(stage.get("depart")), _came(stage.get("arrival")) or numpy.inf,
                      float(stage.get("maxSpeed"))) for stage in stages
                     if stage.tag == "walk" and _came(stage.get("depart")) is not None]
            persons.append(Trip(element.get("id"), element.get("type"),
                                float(element.get("depart")),
                                _came(moves[-1].get("arrival")) if moves else None, walks))
        elif element.tag == "tripinfo":
            departed, delay = _came(element.get("depart")), float(element.get("departDelay"))
            vehicles.append(Trip(
                element.get("id"), element.get("vType").split("@")[0],
                (end if departed is None else departed) - delay,
                None if element.get("vaporized") else _came(element.get("arrival")), [],
                delay + float(element.get("timeLoss"))))
    return tuple([trip for trip in trips if trip.due < end - 1e-9] for trips in (persons, vehicles))


def trip_measures(persons, vehicles, end):
    values = {}
    for who, trips in (("person", persons), ("vehicle", vehicles)):
        times = [(end if trip.arrival is None else trip.arrival) - trip.due for trip in trips]
        values[f"{who}.count"] = len(trips)
        values[f"{who}.travelTime"] = numpy.mean(times)
        values[f"{who}.arrived"] = numpy.mean([trip.arrival is not None for trip in trips])
    values["person.nearlyAll"] = nearly_all(persons, end)
    values["vehicle.delay"] = numpy.mean([trip.loss for trip in vehicles])
    return values


def nearly_all(persons, end):
    """When 99 % have arrived; after the end as if people went on to arrive as in its last quarter."""
    arrivals = sorted(trip.arrival for trip in persons if trip.arrival is not None)
    wanted = int(numpy.ceil(0.99 * len(persons)))
    if len(arrivals) >= wanted:
        return arrivals[wanted - 1]
    part = 0.25 * (end - min(trip.due for trip in persons))
    late = sum(arrival > end - part for arrival in arrivals)
    return end + (wanted - len(arrivals)) * part / late


def demand(trips):
    lines = sorted(f"{trip.id},{trip.type},{trip.due:.3f}\n" for trip in trips)
    return hashlib.sha256("".join(lines).encode()).hexdigest()
