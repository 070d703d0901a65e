#!/usr/bin/python3
"""The check itself: each measure is right on a tiny run made by hand, and each can fail."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from tiny_run import TinyRun, person, vehicle, walked, write, write_run


class Losses(TinyRun):
    def test_counts_departed_arrived_walking(self):
        figures = self.check([[person("a", 1, 0), person("b", 5, 0)], [person("b", 6, 0)]],
                             [walked("a", 0, 1), walked("b", 0, -1)])
        self.assertEqual([figures["persons"][key] for key in
                          ("departed", "arrived", "walking", "lost")], [2, 1, 1, 0])

    def test_person_that_vanishes_without_arriving_is_lost(self):
        for trips in ([], [walked("a", 0, -1)]):
            with self.subTest(trips=trips):
                figures = self.check([[person("a", 1, 0)], []], trips, "--max-lost", "0")
                self.assertEqual(figures["persons"]["lost_ids"], ["a"])
                self.assertEqual(len(figures["broken_limits"]), 1)

    def test_person_in_a_vehicle_that_teleports_at_the_end_is_not_lost(self):
        rider = ('    <personinfo id="a" depart="0.00" type="adult" speedFactor="1">\n'
                 '        <ride waitingTime="0.00" vehicle="v" depart="0.00" arrival="-1"/>\n'
                 '    </personinfo>\n')
        for arrival, lost in (("-1.00", []), ("1.00", ["a"])):
            with self.subTest(arrival=arrival):
                vehicle = (f'    <tripinfo id="v" depart="0.00" arrival="{arrival}" duration="1.00" '
                           'vType="van"/>\n')
                figures = self.check([[person("a", 1, 0)], []], [rider, vehicle])
                self.assertEqual(figures["persons"]["lost_ids"], lost)

    def test_person_whose_departure_lies_after_the_end_is_not_lost(self):
        late = '    <personinfo id="late" depart="99.00" type="adult" speedFactor="1"/>\n'
        figures = self.check([[person("a", 1, 0)]], [walked("a", 0, -1), late])
        self.assertEqual((figures["persons"]["departed"], figures["persons"]["lost"]), (1, 0))

    def test_person_that_departed_in_plain_sumo_only_is_missing(self):
        write_run(self.path("plain"), [[person("a", 1, 0)]], [walked("a", 0, 1), walked("b", 0, 1)])
        figures = self.check([[person("a", 1, 0)]], [walked("a", 0, 1)],
                             "--plain", self.path("plain"), "--max-missing", "0")
        self.assertEqual(figures["plain"]["missing_ids"], ["b"])
        self.assertEqual(len(figures["broken_limits"]), 1)


class Contacts(TinyRun):
    RADIUS = 0.239  # [m] half of SUMO's width of a pedestrian

    def pairs(self, person_row, vehicle_row, *options, trips=()):
        figures = self.check([[vehicle_row, person_row]], trips or [walked("p", 0, -1)], *options)
        return figures["contacts"]["all"]["pairs"]

    def test_disc_beside_the_van_touches_by_more_than_a_centimetre_or_not(self):
        side = 1.0 + self.RADIUS  # the van is 2 m wide
        for x in (30.0, 32.0, 34.9):  # its rectangle is x 30..35
            self.assertEqual(self.pairs(person("p", x, side - 0.019), vehicle("v", 35, 0)), 1)
            self.assertEqual(self.pairs(person("p", x, side - 0.009), vehicle("v", 35, 0)), 0)

    def test_front_bumper_is_the_reference_point(self):
        for angle, ahead, behind in ((90, (35.3, 0), (29.7, 0)), (0, (35, 0.3), (35, -5.3)),
                                     (270, (34.7, 0), (40.3, 0)), (180, (35, -0.3), (35, 5.3))):
            van = vehicle("v", 35, 0, angle)
            for x, y in (ahead, behind):
                toward = (x + (35 - x) * 0.05, y - y * 0.05)
                self.assertEqual(self.pairs(person("p", x, y), van), 0, (angle, x, y))
            inside = ((ahead[0] + behind[0]) / 2, (ahead[1] + behind[1]) / 2)
            self.assertEqual(self.pairs(person("p", *inside), van), 1, angle)

    def test_corner_of_a_turned_van(self):
        # Front at (10, 10), heading north-east: the front left corner is at (10, 10) + 1 m to the
        # north-west.
        corner = (10 - 2 ** -0.5, 10 + 2 ** -0.5)
        van = vehicle("v", 10, 10, 45)
        self.assertEqual(self.pairs(person("p", corner[0], corner[1] + 0.2), van), 1)
        self.assertEqual(self.pairs(person("p", corner[0], corner[1] + 0.26), van), 0)

    def test_body_is_half_the_types_width(self):
        row, van = person("p", 32, 1.4), vehicle("v", 35, 0)
        self.assertEqual(self.pairs(row, van), 0)
        self.assertEqual(self.pairs(row, van, trips=[walked("p", 0, -1, type_id="pram")]), 1)
        self.assertEqual(self.pairs(row, van, "--radius", "0.42"), 1)

    def test_pairs_frames_and_clearance(self):
        figures = self.check([[vehicle("v", 35, 0), person("p", 32, 0.9), person("q", 32, 1.739)],
                              [vehicle("v", 35, 0), person("p", 32.5, 0.9), person("q", 33, 1.74)]],
                             [walked("p", 0, -1), walked("q", 0, -1)], "--max-contacts", "0")
        contacts = figures["contacts"]
        self.assertEqual((contacts["all"]["pairs"], contacts["all"]["frames"]), (1, 2))
        self.assertAlmostEqual(contacts["min_clearance_m"], 0.9 - 1 - self.RADIUS)
        self.assertEqual(contacts["all"]["pairs_by_vehicle_type"], {"van": 1})
        self.assertEqual(contacts["all"]["examples"][0]["vehicle"], "v")
        self.assertEqual(len(figures["broken_limits"]), 1)

    def test_a_vehicle_inserted_on_top_of_somebody_is_told_apart_for_two_seconds(self):
        def pairs(frames_in_contact):
            frames = [[person("p", 10, 0)], *[[person("p", 10, 0), vehicle("v", 12, 0)]
                                              for _ in range(frames_in_contact)]]
            contacts = self.check(frames, [walked("p", 0, -1)])["contacts"]
            return contacts["at_insertion"]["pairs"], contacts["zone"]["pairs"]
        self.assertEqual(pairs(2), (1, 0))
        self.assertEqual(pairs(5), (1, 1))  # one row a second

    def test_contacts_are_told_by_place_and_by_who_walks(self):
        # On the shared street, on the road; and a person moved from outside.
        frames = [[vehicle("v", 200, 0), vehicle("w", 200, 50)],
                  [person("p", 10, 0), vehicle("v", 12, 0), person("q", 10, 50, edge="road"),
                   vehicle("w", 12, 50)]]
        contacts = self.check(frames, [walked("p", 0, -1), walked("q", 0, -1)])["contacts"]
        self.assertEqual([contacts[key]["pairs"] for key in
                          ("all", "zone", "elsewhere", "controlled")], [2, 1, 1, 0])
        frames = self.controlled([(10 + i, 50) for i in range(5)])
        frames[3].append(vehicle("v", 200, 50))
        frames[4].append(vehicle("v", 15, 50))
        contacts = self.check(frames, [walked("p", 0, -1)], "--max-controlled-contacts", "0")
        self.assertEqual(contacts["contacts"]["controlled"]["pairs"], 1)
        self.assertEqual(contacts["contacts"]["elsewhere"]["pairs"], 0)
        self.assertAlmostEqual(contacts["contacts"]["min_clearance_controlled_m"], -1 - self.RADIUS)
        self.assertEqual(len(contacts["broken_limits"]), 1)

    def test_somebody_whom_pedzone_walks_may_have_turned_beside_a_vehicle_that_crawls(self):
        def pairs(speed, gap):
            frames = self.controlled([(10 + 0.4 * k, 50) for k in range(5)])
            for k, frame in enumerate(frames[1:]):
                frame.append(vehicle("v", 12 + speed * k, 50 + 1.0 + gap))
            contacts = self.check(frames, [walked("p", 0, -1)])["contacts"]
            return contacts["turned"]["pairs"], contacts["controlled"]["pairs"]
        half = self.RADIUS / 2
        self.assertEqual(pairs(0.4, half + 0.005)[0], 1)
        self.assertEqual(pairs(0.0, half + 0.005)[0], 1)
        self.assertEqual(pairs(0.8, half + 0.005), (0, 1))
        self.assertEqual(pairs(0.4, half - 0.015), (0, 1))

    def test_a_ride_is_no_contact(self):
        ride = ('        <ride waitingTime="1.00" vehicle="v" depart="1.00" arrival="{}" '
                'arrivalPos="1" duration="1" routeLength="9"/>\n')
        frames = [[person("p", 33, 1.1), vehicle("v", 35, 0)],
                  [person("p", 50, 0, edge="x"), vehicle("v", 50, 0), vehicle("w", 51, 0)]]
        for arrival in ("1.00", "-1"):
            figures = self.check(frames, [walked("p", 0, 1, extra=ride.format(arrival))])
            self.assertEqual(figures["contacts"]["all"]["pairs"], 0)
            self.assertEqual(figures["jumps"]["events"], 0)
        self.assertEqual(self.check(frames, [walked("p", 0, -1)])["contacts"]["all"]["pairs"], 2)


class Jumps(TinyRun):
    def test_more_than_two_metres_a_second_and_three_metres(self):
        for distance, jumps in ((4.9, 0), (5.1, 1)):
            figures = self.check([[person("p", 10, 0)], [person("p", 10 + distance, 0)]],
                                 [walked("p", 0, -1)], "--max-jumps", "0")
            self.assertEqual(figures["jumps"]["events"], jumps)
            self.assertEqual(len(figures["broken_limits"]), jumps)

    def test_two_persons_are_not_one_that_jumps(self):
        figures = self.check([[person("p", 10, 0), person("q", 60, 0)],
                              [person("q", 61, 0), person("p", 11, 0)]],
                             [walked("p", 0, -1), walked("q", 0, -1)])
        self.assertEqual(figures["jumps"]["events"], 0)

    def test_a_jump_that_plain_sumo_makes_too_does_not_count(self):
        frames = [[person("p", 10, 0)], [person("p", 30, 0)]]
        trips = [walked("p", 0, -1)]
        for plain_x, jumps in ((29, 0), (60, 1), (14, 1)):
            write_run(self.path("plain"), [[person("p", 10, 0)], [person("p", plain_x, 0)]], trips)
            figures = self.check(frames, trips, "--plain", self.path("plain"))
            self.assertEqual(figures["jumps"]["events"], jumps, plain_x)

    def test_a_jump_of_anybody_in_plain_sumo_excuses_those_whom_sumo_walks(self):
        write_run(self.path("plain"), [[person("q", 10, 0)], [person("q", 29, 0)]], [])
        for x, jumps in ((28, 0), (26.9, 1)):
            figures = self.check([[person("p", 5, 0)], [person("p", x, 0)]], [walked("p", 0, -1)],
                                 "--plain", self.path("plain"))
            self.assertEqual(figures["jumps"]["events"], jumps, x)
        figures = self.check(self.controlled([(8, 0), (9, 0), (28, 0)]), [walked("p", 0, -1)],
                             "--plain", self.path("plain"))
        self.assertEqual((figures["jumps"]["events"], figures["jumps"]["controlled"]), (1, 1))

    def test_sumos_step_aside_at_a_stop_is_none_and_one_along_the_street_is(self):
        stop = '        <stop duration="9" arrival="{}" arrivalPos="30" actType="sitting"/>\n'
        for arrival, x, y, jumps in ((20, 30, 5.2, 0), (20, 30.9, 5.2, 0), (20, 35.2, 5.2, 1),
                                     (1, 30, 5.2, 0), (50, 30, 5.2, 1)):
            walk_ends = 1 if arrival == 20 else 0
            figures = self.check([[person("p", 30, 0)], [person("p", x, y)]], [
                walked("p", 0, walk_ends, extra=stop.format(arrival))
                if arrival != 50 else walked("p", 0, 40, extra=stop.format(arrival))])
            self.assertEqual(figures["jumps"]["events"], jumps, (arrival, x, y))


class Outside(TinyRun):
    def findings(self, places, *options):
        figures = self.check(self.controlled(places), [walked("p", 0, -1)], *options)
        self.assertEqual(figures["persons"]["controlled"], 1)
        return {key: value["events"] for key, value in figures["outside"].items()
                if isinstance(value, dict) and value["events"]}, figures

    def test_nothing_on_the_street_in_the_nook_and_through_the_arch(self):
        places = [(x, 1.9) for x in range(10, 20)] + [(22.5, 3.9)] + [(x, 0) for x in range(70, 95)]
        self.assertEqual(self.findings(places)[0], {})

    def test_person_in_a_building(self):
        # 45 is beyond the corridor that stays open along the centre line, and within the street.
        self.assertEqual(self.findings([(30, 0), (31, 0), (45, 2.1)])[0],
                         {"in_building": 1, "out_of_reach": 1})
        found, figures = self.findings([(30, 0), (31, 0), (82, 2.04), (82, 4)], "--max-outside", "0")
        self.assertEqual(found, {"in_building": 1, "out_of_reach": 1})
        self.assertEqual(figures["outside"]["in_building"]["examples"][0]["person"], "p")
        self.assertEqual(len(figures["broken_limits"]), 1)

    def test_five_centimetres_inside_a_building_are_allowed(self):
        # The porch reaches 1 m into the house.
        self.assertEqual(self.findings([(37, 0), (38, 3), (40.04, 3)])[0], {})
        self.assertEqual(self.findings([(37, 0), (38, 3), (40.07, 3)])[0], {"in_building": 1})

    def test_a_road_that_laps_into_the_zone_leaves_the_zones_lane_walkable(self):
        self.assertEqual(self.findings([(60, 0), (61, 0), (65, 1.9)])[0], {})
        self.assertEqual(self.findings([(60, 0), (61, 0), (65, 3.6)])[0],
                         {"on_road": 1, "out_of_reach": 1})

    def test_five_centimetres_beyond_the_street_are_allowed(self):
        self.assertEqual(self.findings([(30, 0), (31, 0), (32, 2.04)])[0], {})
        self.assertEqual(self.findings([(30, 0), (31, 0), (32, 2.07)])[0], {"out_of_reach": 1})

    def test_open_space_round_pedestrian_streets_ends_at_twelve_metres_and_before_roads(self):
        self.assertEqual(self.findings([(30, -30), (30, -29), (30, -17.1)])[0], {})
        self.assertEqual(self.findings([(30, -30), (30, -29), (30, -16.9)])[0], {"out_of_reach": 1})
        self.assertEqual(self.findings([(30, -30), (30, -31), (30, -36.4)])[0], {})
        self.assertEqual(self.findings([(30, -30), (30, -31), (30, -38)])[0], {"on_road": 1})

    def test_zone_file_says_what_the_zone_is(self):
        zone = self.path("zone.xml")
        write(zone, '<zones><zone id="z" edges="street" openSpace="5" polygons="lawn"/></zones>')
        self.assertEqual(self.findings([(30, 0), (31, 0), (32, 30)], "--zone", zone)[0], {})
        write(zone, '<zones><zone id="z" edges="street" openSpace="5"/></zones>')
        self.assertEqual(self.findings([(30, 0), (31, 0), (32, 6.9), (33, 7.1)], "--zone", zone)[0],
                         {"out_of_reach": 1})

    def test_persons_whom_sumo_walks_are_not_asked(self):
        frames = [[person("p", 30, 0)], [person("p", 31, 0)], [person("p", 45, 8)]]
        figures = self.check(frames, [walked("p", 0, -1)])
        self.assertEqual((figures["persons"]["controlled"], figures["outside"]["events"]), (0, 0))
        # ... unless the trajectories say that they were controlled.
        write(self.path("run/trajectories.csv"),
              "time,id,x,y,vx,vy,heading,motion\n2.00,p,0,0,0,0,0,walking\n")
        figures = self.check(frames, [walked("p", 0, -1)])
        self.assertEqual(figures["outside"]["in_building"]["events"], 1)
        self.assertEqual(figures["persons"]["controlled_person_steps"], 1)

    def test_where_sumo_put_a_person_before_it_was_taken_over_does_not_count(self):
        frames = [[person("p", 45, 4, position=0, speed=0)]] * 2 + [
            [person("p", x, 1, position=0)] for x in (45, 46, 47)]
        figures = self.check(frames, [walked("p", 0, -1)])
        self.assertEqual(figures["outside"]["events"], 0)
        self.assertEqual(figures["persons"]["controlled_person_steps"], 3)

    def test_standing_and_being_pushed_aside_are_not_control(self):
        frames = [[person("p", 30, 0)]] + [[person("p", 30, 0.2 * i, speed=0)] for i in range(9)]
        self.assertEqual(self.check(frames, [walked("p", 0, -1)])["persons"]["controlled"], 0)

    def test_a_position_that_is_no_number(self):
        frames = self.controlled([(30, 0), (31, 0), (float("nan"), 0)])
        figures = self.check(frames, [walked("p", 0, -1)], "--max-nan", "0")
        self.assertEqual(figures["nan"], 1)
        self.assertEqual(len(figures["broken_limits"]), 1)


if __name__ == "__main__":
    unittest.main()
