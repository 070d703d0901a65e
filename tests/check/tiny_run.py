"""A tiny scenario and its outputs, written by hand, for the tests of the check.

Network (y up; a house stands on the shared street's north side, another across its centre line):

    y=50   ----- road (13.9 m/s, vehicles only) -----
    y= 8      [house 40..50 x 2..12]
    y= 3   a road whose shape laps 0.5 m into the street, x 60..75
    y= 0   ===== street (living_street, 4 m wide) ===[arch 80..84]=====  x 0..100
    y=-30  ----- promenade (highway.pedestrian, 2 m wide) -----
"""
import contextlib
import io
import json
import os
import shutil
import tempfile
import unittest

import check_run

_HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
NET = _HEAD + """<net version="1.9">
    <edge id="street" from="a" to="b" type="highway.living_street">
        <lane id="street_0" index="0" disallow="tram rail" speed="2.78" length="100.00" width="4.00" shape="0.00,0.00 100.00,0.00"/>
    </edge>
    <edge id="road" from="c" to="d" type="highway.residential">
        <lane id="road_0" index="0" disallow="pedestrian tram" speed="13.89" length="100.00" width="3.00" shape="0.00,50.00 100.00,50.00"/>
    </edge>
    <edge id="lapping" from="i" to="j" type="highway.residential">
        <lane id="lapping_0" index="0" disallow="pedestrian" speed="13.89" length="15.00" width="3.00" shape="60.00,3.00 75.00,3.00"/>
    </edge>
    <edge id="promenade" from="e" to="f" type="highway.pedestrian">
        <lane id="promenade_0" index="0" allow="pedestrian" speed="2.78" length="100.00" width="2.00" shape="0.00,-30.00 100.00,-30.00"/>
    </edge>
    <edge id="lane_near_promenade" from="g" to="h" type="highway.residential">
        <lane id="lane_near_promenade_0" index="0" disallow="pedestrian" speed="13.89" length="100.00" width="3.00" shape="0.00,-38.00 100.00,-38.00"/>
    </edge>
    <junction id="a" type="dead_end" x="0" y="0" shape="0.00,2.00 0.00,-2.00"/>
    <junction id="b" type="dead_end" x="100" y="0" shape="100.00,2.00 100.00,-2.00"/>
</net>
"""
POLYGONS = _HEAD + """<additional>
    <poly id="house" type="building" shape="40,1 50,1 50,12 40,12 40,1"/>
    <poly id="arch" type="building" shape="80,-6 84,-6 84,6 80,6 80,-6"/>
    <poly id="nook" type="pedzone.walkable" shape="20,1 25,1 25,4 20,4 20,1"/>
    <poly id="porch" type="pedzone.walkable" shape="36,1 41,1 41,4 36,4 36,1"/>
    <poly id="lawn" type="landuse.grass" shape="0,-100 100,-100 100,100 0,100 0,-100"/>
</additional>
"""
TYPES = """    <vType id="van" vClass="delivery" length="5.0" width="2.0"/>
    <vType id="adult" vClass="pedestrian"/>
    <vType id="pram" vClass="pedestrian" width="1.0"/>
"""
CONFIG = _HEAD + """<configuration>
    <input>
        <net-file value="tiny.net.xml"/>
        <route-files value="tiny.rou.xml"/>
        <additional-files value="tiny.poly.xml"/>
    </input>
    <time><step-length value="1"/></time>
</configuration>
"""


def person(name, x, y, position=None, edge="street", speed=1.0):
    """A person's row in FCD; by default SUMO has it at position x of its edge."""
    position = x if position is None else position
    return (f'        <person id="{name}" x="{x:.2f}" y="{y:.2f}" angle="90.00" '
            f'speed="{speed:.2f}" pos="{position:.2f}" edge="{edge}" slope="0.00"/>\n')


def vehicle(name, x, y, angle=90.0, type_id="van"):
    """A vehicle's row in FCD; x, y are its front bumper, angle 90 is eastward."""
    return (f'        <vehicle id="{name}" x="{x:.2f}" y="{y:.2f}" angle="{angle:.2f}" '
            f'type="{type_id}" speed="1.00" pos="0.00" lane="street_0" slope="0.00"/>\n')


def walked(name, depart, arrival, length=100.0, type_id="adult", extra=""):
    """A person's tripinfo with one walk; arrival -1: not arrived."""
    return (f'    <personinfo id="{name}" depart="{depart:.2f}" type="{type_id}" speedFactor="1">\n'
            f'        <walk depart="{depart:.2f}" departPos="0" arrival="{arrival:.2f}" '
            f'arrivalPos="1" duration="1" routeLength="{length:.2f}" timeLoss="0"/>\n{extra}'
            "    </personinfo>\n")


def driven(name, duration, arrived=True, type_id="van"):
    """A vehicle's tripinfo."""
    arrival = duration if arrived else -1
    return (f'    <tripinfo id="{name}" depart="0.00" arrival="{arrival:.2f}" '
            f'duration="{duration:.2f}" routeLength="100" vType="{type_id}" vaporized=""/>\n')


def plan(name, *stages):
    """A person's vehroute."""
    return f'    <person id="{name}" depart="0.00">\n' + "".join(
        f"        {stage}\n" for stage in stages) + "    </person>\n"


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def write_scenario(folder, types=TYPES):
    """Writes the scenario; returns its sumocfg."""
    for name, text in (("tiny.net.xml", NET), ("tiny.poly.xml", POLYGONS),
                       ("tiny.rou.xml", f"{_HEAD}<routes>\n{types}</routes>\n"),
                       ("tiny.sumocfg", CONFIG)):
        write(os.path.join(folder, name), text)
    return os.path.join(folder, "tiny.sumocfg")


def write_run(folder, frames, trips, plans=None, statistics=None, version=None):
    """Writes a run's outputs; frames: one list of FCD rows a second; version: of SUMO."""
    head = _HEAD
    if version:
        head += f"<!-- generated on 2023-01-01 by Eclipse SUMO sumo Version {version}\n-->\n"
    fcd = _HEAD + "<fcd-export>\n"
    for time, rows in enumerate(frames):
        if rows:
            fcd += f'    <timestep time="{time:.2f}">\n{"".join(rows)}    </timestep>\n'
        else:
            fcd += f'    <timestep time="{time:.2f}"/>\n'
    write(os.path.join(folder, "fcd.xml"), fcd + "</fcd-export>\n")
    write(os.path.join(folder, "tripinfo.xml"),
          f"{head}<tripinfos>\n{''.join(trips)}</tripinfos>\n")
    if plans is not None:
        write(os.path.join(folder, "vehroute.xml"),
              f"{_HEAD}<routes>\n{''.join(plans)}</routes>\n")
    if statistics is not None:
        write(os.path.join(folder, "statistics.xml"), f"{_HEAD}<statistics>\n"
              f'    <teleports total="{statistics}" jam="0"/>\n    <persons jammed="3"/>\n'
              "</statistics>\n")
    return folder


class TinyRun(unittest.TestCase):
    """Writes runs into a temporary folder and checks them."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.config = write_scenario(os.path.join(self.folder, "scenario"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def call(self, *options):
        """(exit code, figures or None, standard error)."""
        figures, errors = self.path("figures.json"), io.StringIO()
        if os.path.exists(figures):
            os.remove(figures)
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors):
            code = check_run.main([self.config, self.path("run"), "--json", figures, *options])
        if not os.path.exists(figures):
            return code, None, errors.getvalue()
        with open(figures, encoding="utf-8") as stream:
            return code, json.load(stream), errors.getvalue()

    def check(self, frames, trips, *options, **files):
        """Figures of a run that can be checked."""
        write_run(self.path("run"), frames, trips, **files)
        code, figures, errors = self.call(*options)
        self.assertIn(code, (0, 1), errors)
        return figures

    def controlled(self, places, name="p"):
        """Frames of a person moved from outside: coordinates change, SUMO's own place does not."""
        return [[person(name, x, y, position=0.5)] for x, y in places]
