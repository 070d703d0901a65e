"""What pictures of `pedzone plot` show, read back from their SVG, and the same taken from SUMO's
floating-car data. Shares nothing with src/."""

import math
import re
import xml.etree.ElementTree as ET

SVG = "{http://www.w3.org/2000/svg}"


def numbers(text):
    return [float(word) for word in re.findall(r"-?\d+\.?\d*", text)]


def points(path):
    """Lists of (x, y), one for each line of a path's d."""
    return [list(zip(*[iter(numbers(line))] * 2)) for line in path.get("d").split("M")[1:]]


def lightness(colour):
    """CIELAB's L* of an sRGB colour."""
    linear = []
    for k in (1, 3, 5):
        value = int(colour[k:k + 2], 16) / 255
        linear.append(value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4)
    y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    return 116 * y ** (1 / 3) - 16 if y > 216 / 24389 else y * 24389 / 27


class Picture:
    def __init__(self, file):
        self.root = ET.parse(file).getroot()
        self.box = numbers(self.root.get("data-box"))  # least x, y, greatest x, y
        self.page = numbers(self.root.get("viewBox"))[2:]

    def group(self, name):
        return self.root.find(f".//{SVG}g[@id='{name}']")

    def of_class(self, name):
        return self.root.findall(f".//*[@class='{name}']")

    def place(self, x, y):
        """Network metres of a point of a map."""
        return self.box[0] + x, self.box[3] - y

    def holds(self, x, y, margin=0.0):
        return (self.box[0] - margin <= x <= self.box[2] + margin
                and self.box[1] - margin <= y <= self.box[3] + margin)

    def discs(self):
        """(id, time) -> (x, y, colour) of a time-plot's persons."""
        found = {}
        for circle in self.group("persons").findall(SVG + "circle"):
            who, time = re.fullmatch(r"(.*) at (\S+) s", circle.find(SVG + "title").text,
                                     re.DOTALL).groups()
            at = self.place(float(circle.get("cx")), float(circle.get("cy")))
            found[who, float(time)] = (*at, circle.get("fill"))
        return found

    def pale(self):
        """(id, time) of a time-plot's persons that are drawn paler."""
        circles = self.group("persons").findall(SVG + "circle[@fill-opacity]")
        titles = [circle.find(SVG + "title").text for circle in circles]
        found = [re.fullmatch(r"(.*) at (\S+) s", title, re.DOTALL).groups() for title in titles]
        return {(who, float(time)) for who, time in found}

    def outlines(self):
        """(id, time) -> (corners, colour) of a time-plot's vehicles."""
        found = {}
        for path in self.of_class("outline"):
            who, time = re.fullmatch(r"(.*) at (\S+) s", path.find(SVG + "title").text).groups()
            corners = [self.place(*point) for point in points(path)[0]]
            found[who, float(time)] = (corners, path.get("stroke"))
        return found

    def axis(self, name):
        """The function that takes places on an axis back to its values."""
        along = "x" if name == "x-tick" else "y"
        ticks = sorted((float(text.text), float(text.get(along))) for text in self.of_class(name))
        (v0, p0), (v1, p1) = ticks[0], ticks[-1]
        for value, place in ticks:  # evenly spaced, or the axis is none
            assert abs(p0 + (value - v0) * (p1 - p0) / (v1 - v0) - place) < 0.1, ticks
        return lambda place: v0 + (place - p0) * (v1 - v0) / (p1 - p0)

    def lines(self):
        """name -> (time, value) at the corners of a chart's lines."""
        text_height = 6.0  # of the labels of the y axis, which are centred on their ticks
        x, y = self.axis("x-tick"), self.axis("y-tick")
        found = {}
        for group in self.of_class("line"):
            for path in group.findall(SVG + "path"):
                found.setdefault(path.find(SVG + "title").text, []).extend(
                    (x(px), y(py + text_height)) for px, py in points(path)[0])
        return found


class Recorded:
    """persons and vehicles: time -> id -> row of SUMO's floating-car data."""

    def __init__(self, file):
        self.persons, self.vehicles = {}, {}
        for _, step in ET.iterparse(file):
            if step.tag != "timestep":
                continue
            for kind, rows in (("person", self.persons), ("vehicle", self.vehicles)):
                rows[float(step.get("time"))] = {
                    row.get("id"): {key: float(row.get(key)) for key in ("x", "y", "angle", "speed")}
                    for row in step.findall(kind)}
            step.clear()


def corners(row, length, width):
    """Of a vehicle, whose x and y are the middle of its front bumper."""
    angle = math.radians(90.0 - row["angle"])
    ahead, left = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    return [(row["x"] - back * length * ahead[0] + side * width * left[0],
             row["y"] - back * length * ahead[1] + side * width * left[1])
            for back, side in ((0, 0.5), (1, 0.5), (1, -0.5), (0, -0.5))]
