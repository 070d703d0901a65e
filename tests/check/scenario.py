"""What a SUMO scenario says about itself: files, step length, sizes of vehicle types, polygons."""
import gzip
import os
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

# [m] length and width that SUMO 1.15 gives a type that sets none, by vClass (read from it with
# vehicletype.getLength and getWidth).
_CLASS_SIZES = {
    "pedestrian": (0.215, 0.478), "bicycle": (1.6, 0.65), "moped": (2.1, 0.78),
    "motorcycle": (2.2, 0.9), "emergency": (6.5, 2.16), "delivery": (6.5, 2.16),
    "truck": (7.1, 2.4), "trailer": (16.5, 2.55), "bus": (12.0, 2.5), "coach": (14.0, 2.6),
    "tram": (22.0, 2.4), "rail_urban": (109.5, 3.0), "rail": (135.0, 2.84),
    "rail_electric": (200.0, 2.95), "rail_fast": (200.0, 2.95), "ship": (17.0, 4.0),
}
_CAR_SIZE = (5.0, 1.8)  # [m] all other vClasses
_DEFAULT_TYPES = {
    "DEFAULT_VEHTYPE": "passenger", "DEFAULT_PEDTYPE": "pedestrian",
    "DEFAULT_BIKETYPE": "bicycle", "DEFAULT_TAXITYPE": "taxi",
}


class CheckError(Exception):
    """The check cannot be made: an input is missing, malformed or contradicts another."""


def open_bytes(path):
    """Opens a plain or gzipped file for reading bytes."""
    try:
        return gzip.open(path, "rb") if path.endswith(".gz") else open(path, "rb")
    except OSError as error:
        raise CheckError(f"{path}: {error.strerror}") from error


def parse_xml(path):
    """Root element of a plain or gzipped XML file."""
    with open_bytes(path) as stream:
        try:
            return ElementTree.parse(stream).getroot()
        except (ElementTree.ParseError, OSError, EOFError) as error:
            raise CheckError(f"{path}: {error}") from error


@dataclass
class Polygon:
    """A SUMO polygon; points in network coordinates [m]."""
    id: str
    type: str
    points: list


@dataclass
class Scenario:
    """A sumocfg with what its files say."""
    net_file: str
    route_files: list
    additional_files: list
    step_length: float = 1.0  # [s] > 0
    sizes: dict = field(default_factory=dict)  # type id -> (length, width) [m]
    classes: dict = field(default_factory=dict)  # type id -> vClass
    polygons: list = field(default_factory=list)

    def size(self, type_id):
        """[m] (length, width) of a vehicle or person type."""
        base = type_id.split("@")[0]  # a type that was changed for one vehicle is TYPE@VEHICLE
        for name in (type_id, base):
            if name in self.sizes:
                return self.sizes[name]
        if base in _DEFAULT_TYPES:
            return class_size(_DEFAULT_TYPES[base])
        raise CheckError(f"type '{type_id}' is in none of {', '.join(self.route_files)}")


def class_size(vehicle_class):
    """[m] SUMO's default (length, width) of a vClass."""
    return _CLASS_SIZES.get(vehicle_class, _CAR_SIZE)


def parse_points(shape):
    """[(x, y)] of SUMO's "x,y[,z] x,y[,z] ..."."""
    return [tuple(float(value) for value in point.split(",")[:2]) for point in shape.split()]


def _read_types_and_polygons(path, scenario):
    """Streams a route or additional file, which may be long, for vTypes and polygons."""
    with open_bytes(path) as stream:
        try:
            for _, element in ElementTree.iterparse(stream):
                if element.tag == "vType":
                    name = element.get("id")
                    default_class = _DEFAULT_TYPES.get(name, "passenger")
                    vehicle_class = element.get("vClass", default_class)
                    length, width = class_size(vehicle_class)
                    scenario.classes[name] = vehicle_class
                    scenario.sizes[name] = (float(element.get("length", length)),
                                            float(element.get("width", width)))
                elif element.tag == "poly":
                    scenario.polygons.append(Polygon(element.get("id"), element.get("type", ""),
                                                     parse_points(element.get("shape"))))
                if element.tag in ("vehicle", "person", "trip", "flow", "personFlow", "poly"):
                    element.clear()
        except (ElementTree.ParseError, OSError, EOFError) as error:
            raise CheckError(f"{path}: {error}") from error


def read_scenario(config):
    """Reads a sumocfg and the vTypes and polygons of the files that it names."""
    root = parse_xml(config)
    folder = os.path.dirname(config)

    def value(*names):
        for name in names:
            element = root.find(f".//{name}")
            if element is not None:
                return element.get("value") or element.get("v") or ""
        return ""

    def files(*names):
        return [os.path.join(folder, name.strip())
                for name in value(*names).replace(";", ",").split(",") if name.strip()]

    nets = files("net-file", "net", "n")
    if len(nets) != 1:
        raise CheckError(f"{config}: needs one <net-file>, has {len(nets)}")
    scenario = Scenario(nets[0], files("route-files", "route-file", "r"),
                        files("additional-files", "additional", "a"),
                        float(value("step-length") or 1.0))
    for path in scenario.route_files + scenario.additional_files:
        _read_types_and_polygons(path, scenario)
    return scenario
