#!/usr/bin/python3
"""Ids, routes and declarations that another client of SUMO changes while pedzone walks the people:
an id can come again for somebody else, and SUMO gives a route's id out again.

usage: test_again.py PEDZONE_PROGRAM
"""

import attached
from attached import AttachedCase, rows

FORK = """<edges>
  <edge id="west" from="A" to="B" numLanes="1" speed="13.89" disallow="pedestrian"/>
  <edge id="shared" from="B" to="C" numLanes="1" speed="13.89" type="highway.living_street"
        disallow="tram" width="8"/>
  <edge id="east" from="C" to="D" numLanes="1" speed="13.89"/>
  <edge id="north" from="B" to="N" numLanes="1" speed="13.89" disallow="pedestrian"/>
</edges>"""
CROWD = """
  <vType id="walker" vClass="pedestrian"/>
  <personFlow id="f" type="walker" begin="0" end="300" period="1">
    <walk edges="shared east" departPosLat="random"/></personFlow>"""
STANDS = """<vType id="stands" vClass="pedestrian"><param key="pedzone.external" value="true"/></vType>
  <person id="visitor" type="stands" depart="1"><walk edges="shared east" departPos="20"/></person>"""
HOLD = """
            if "visitor" in persons:
                traci.person.moveToXY("visitor", "", 75.0, -4.0, 90, 2, -1)
            """


class Again(AttachedCase):
    def fork(self):
        """West of the shared street a road turns off to the north."""
        nodes = self.folder / "tiny.nod.xml"
        nodes.write_text(nodes.read_text().replace("</nodes>", '<node id="N" x="60" y="120"/></nodes>')
                         .replace('x="0"', 'x="-140"'))
        self.tiny.write("tiny.edg.xml", FORK)
        self.tiny.convert("--offset.disable-normalization", "true")

    def hardest_braking(self, program):
        """[m/s²] of a car that comes to somebody who stands 15 m behind the fork."""
        self.fork()
        self.together(HOLD + program, end=100, routes=f"""<routes>{STANDS}
            <vehicle id="v" depart="20" departSpeed="max"><route edges="west shared east"/></vehicle>
            </routes>""")
        speeds = [speed for _, (speed, x) in sorted(self.speeds().items()) if x < 100.0]
        self.assertLess(min(speeds), 0.5, "it stops before who stands there")
        return max(a - b for a, b in zip(speeds, speeds[1:])) / 0.5

    def test_a_route_whose_id_comes_again(self):
        """SUMO calls the third route as the first: the car's way is then not that of the first."""
        self.assertLess(self.hardest_braking(""), 4.6)
        self.assertLess(self.hardest_braking("""
            if "v" in vehicles and traci.vehicle.getPosition("v")[0] > 5 and len(seen) < 3:
                seen.append(t)
                traci.vehicle.changeTarget("v", ["north", "shared", "east"][len(seen) - 1])
                assert len(seen) == 2 or traci.vehicle.getRouteID("v") == "!v!var#1", len(seen)
            """), 4.6)

    def test_a_vehicle_of_an_id_that_another_program_drove(self):
        self.together(HOLD + """
            if "v" in vehicles and t < 70:
                traci.vehicle.setParameter("v", "pedzone.external", "true")
            if t == 70:
                traci.vehicle.remove("v")
            if t == 75:
                traci.vehicle.add("v", "through", typeID="car")
            """, end=150, routes=f"""<routes><vType id="car"/>{STANDS}
            <route id="through" edges="west shared east"/>
            <vehicle id="v" type="car" route="through" depart="60"/></routes>""")
        second = [speed for t, (speed, x) in self.speeds().items() if t > 75 and 60.0 < x < 110.0]
        self.assertGreater(len(second), 10)
        self.assertLess(min(second), 0.5, "it stops before who stands there")

    def test_a_vehicle_that_is_declared_while_it_drives(self):
        errors = self.together("""
            if "v" in vehicles:
                seen.append(t)
                if len(seen) == 4:
                    traci.vehicle.setParameter("v", "pedzone.external", "true")
                if len(seen) > 8:
                    traci.vehicle.setSpeedMode("v", 0)
                    traci.vehicle.setSpeed("v", 3.0)
            """, routes=f"""<routes>{CROWD}
            <vehicle id="v" depart="60"><route edges="west shared east"/></vehicle></routes>""")
        self.assertNotIn("Another program", errors)
        inside = {speed for speed, x in self.speeds().values() if 70.0 < x < 110.0}
        self.assertEqual(inside, {3.0})

    def test_a_speed_mode_that_another_client_has_set(self):
        """pedzone has the car brake hard for somebody who is put before it, then gives it back."""
        self.fork()
        self.together("""
            if "v" in vehicles:
                seen.append(traci.vehicle.getSpeedMode("v"))
                if len(seen) == 1:
                    traci.vehicle.setSpeedMode("v", 23)  # no right of way
                if traci.vehicle.getPosition("v")[0] > 60:
                    free = t > 60
                    traci.person.moveToXY("visitor", "", 75.0, 30.0 if free else -4.0, 90, 2, -1)
            if t == 79:
                assert 27 in seen and seen[-1] == 23, seen
            """, end=80, routes=f"""<routes>{STANDS}
            <vehicle id="v" depart="20" departSpeed="max"><route edges="west shared east"/></vehicle>
            </routes>""")

    def test_a_person_of_an_id_that_was_there_before(self):
        self.together("""
            if t in (5, 100) and "p" not in persons:
                seen.append(t)
                traci.person.add("p", "west", 50)
                traci.person.appendWalkingStage("p", ["west", "shared", "east"], 20)
            if t == 199:
                assert len(seen) == 2, seen
            """, end=200, routes="<routes/>")
        times = [float(row["time"]) for row in rows(self.folder / "t.csv") if row["id"] == "p"]
        self.assertTrue([t for t in times if t < 100], "walked by pedzone")
        self.assertTrue([t for t in times if t > 100], "the second, too")

    def test_a_second_walk_from_where_the_first_was_too_short(self):
        """The first ends 1 m into the zone, and stays SUMO's."""
        self.together("pass", end=200, routes="""<routes><person id="p" depart="1">
            <walk edges="west shared" arrivalPos="1"/><stop lane="shared_0" endPos="2" duration="5"/>
            <walk edges="shared east" arrivalPos="20"/></person></routes>""")
        walked = [float(row["x"]) for row in rows(self.folder / "t.csv") if row["id"] == "p"]
        self.assertTrue(walked, "walked by pedzone")
        self.assertGreater(max(walked), 110.0)


if __name__ == "__main__":
    attached.main(__doc__)
