"""Where everybody is, recomputed from SUMO's floating-car data."""

import bisect
import math
import xml.etree.ElementTree as ET


class Recorded:
    """`sizes`: length and width [m] of vehicles by type."""

    def __init__(self, path, sizes):
        self.times, self.persons, self.vehicles = [], [], []
        for _, step in ET.iterparse(path):
            if step.tag != "timestep":
                continue
            time, persons, vehicles = float(step.get("time")), {}, {}
            for one in step:
                x, y, angle = (float(one.get(name)) for name in ("x", "y", "angle"))
                heading = math.radians(90 - angle)
                if one.tag == "person":
                    persons[one.get("id")] = (x, y, heading)
                elif one.tag == "vehicle":
                    # SUMO has the middle of the front bumper.
                    half = sizes[one.get("type")][0] / 2
                    vehicles[one.get("id")] = (x - half * math.cos(heading),
                                               y - half * math.sin(heading), heading)
            step.clear()
            if persons or vehicles:  # pedzone leaves empty steps out
                self.times.append(time)
                self.persons.append(persons)
                self.vehicles.append(vehicles)

    def at(self, kind, time, every=1):
        """id -> (x, y) at a time, by even motion between the steps that are kept."""
        steps = getattr(self, kind)[::every]
        times = self.times[::every]
        after = bisect.bisect_right(times, time + 1e-9)
        before = after - 1
        if before < 0 or time > times[-1] + 1e-9:
            return {}
        share = 0.0
        if after < len(times) and time - times[before] > 1e-6:
            share = (time - times[before]) / (times[after] - times[before])
        if share == 0.0:
            return {name: place[:2] for name, place in steps[before].items()}
        return {name: tuple(a + share * (b - a) for a, b in zip(place[:2], steps[after][name][:2]))
                for name, place in steps[before].items() if name in steps[after]}
