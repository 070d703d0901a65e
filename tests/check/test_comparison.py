#!/usr/bin/python3
"""Comparison with plain SUMO, vehicles' times, limits, bad input, and a real SUMO run."""
import gzip
import os
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from tiny_run import (NET, TinyRun, driven, person, plan, vehicle, walked, write, write_run)

STOP = ('        <stop duration="0" arrival="9.00" arrivalPos="1" '
        'actType="last stage removed"/>\n')


class AgainstPlainSumo(TinyRun):
    FRAMES = [[person("p", 1, 0)]]

    def compare(self, trips, plain_trips, *options, plans=None, plain_plans=None):
        write_run(self.path("plain"), self.FRAMES, plain_trips, plans=plain_plans, statistics=5)
        return self.check(self.FRAMES, trips, "--plain", self.path("plain"), *options,
                          plans=plans, statistics=0)

    def test_route_length_within_a_hundredth(self):
        for length, differs in ((100.9, 0), (99.1, 0), (101.1, 1), (98.9, 1)):
            figures = self.compare([walked("p", 0, 9, length)], [walked("p", 0, 9, 100)],
                                   "--max-route-length-differs", "0")
            self.assertEqual(figures["plain"]["route_length_differs"], differs, length)
            self.assertEqual(len(figures["broken_limits"]), differs)

    def test_stages_and_edges(self):
        ride = '        <ride vehicle="v" depart="9.00" arrival="9.50" routeLength="9"/>\n'
        walk, other = '<walk edges="a b"/>', '<walk edges="a c"/>'
        same = self.compare([walked("p", 0, 9)], [walked("p", 0, 9)],
                            plans=[plan("p", walk)], plain_plans=[plan("p", walk)])["plain"]
        self.assertEqual((same["stages_differ"], same["edges_differ"]), (0, 0))
        figures = self.compare([walked("p", 0, 9)], [walked("p", 0, 9, extra=ride)],
                               "--max-edges-differ", "0", "--max-stages-differ", "0",
                               plans=[plan("p", walk)], plain_plans=[plan("p", other)])
        self.assertEqual((figures["plain"]["stages_differ"], figures["plain"]["edges_differ"]),
                         (1, 1))
        self.assertEqual(len(figures["broken_limits"]), 2)

    def test_trace_of_a_removed_last_stage_is_no_stage(self):
        trace = '<stop lane="a_0" duration="0.00" actType="last stage removed"/>'
        figures = self.compare(
            [walked("p", 0, 9, extra=STOP)], [walked("p", 0, 9)],
            plans=[plan("p", '<walk edges="a"/>', trace)],
            plain_plans=[plan("p", '<walk edges="a"/>')])["plain"]
        self.assertEqual((figures["stages_differ"], figures["edges_differ"]), (0, 0))

    def test_durations_of_those_who_arrived_in_both(self):
        trips = [walked("p", 0, 12), walked("q", 10, 40), walked("r", 0, -1)]
        plain = [walked("p", 0, 10), walked("q", 10, 30), walked("r", 0, 90)]
        figures = self.compare(trips, plain, "--duration-ratio", "0.85", "1.15")
        self.assertAlmostEqual(figures["plain"]["duration_ratio"], 42 / 30)
        self.assertEqual(figures["plain"]["duration_ratio_range"], [1.2, 1.5])
        self.assertEqual(len(figures["broken_limits"]), 1)
        self.assertEqual(self.compare(trips, plain, "--duration-ratio", "1.3", "1.5")
                         ["broken_limits"], [])

    def test_without_routes_edges_are_not_compared_and_no_limit_on_them_passes(self):
        figures = self.compare([walked("p", 0, 9)], [walked("p", 0, 9)])
        self.assertIsNone(figures["plain"]["edges_differ"])
        code, _, errors = self.call("--plain", self.path("plain"), "--max-edges-differ", "0")
        self.assertEqual(code, 2)
        self.assertIn("edges_differ", errors)


class Vehicles(TinyRun):
    FRAMES = [[person("p", 1, 0), vehicle("v", 80, 50)]]

    def figures(self, trips, free, *options):
        write_run(self.path("free"), [[]], free)
        return self.check(self.FRAMES, [walked("p", 0, 9), *trips], "--free", self.path("free"),
                          *options)

    def test_median_by_type(self):
        trips = [driven("a", 10), driven("b", 30), driven("c", 40), driven("d", 90, False),
                 driven("e", 500, type_id="bus")]
        figures = self.check(self.FRAMES, [walked("p", 0, 9), *trips],
                             "--max-vehicle-median", "van=29", "--max-vehicle-median", "bus=500")
        van = figures["vehicles"]["van"]
        self.assertEqual((van["departed"], van["arrived"], van["median_s"]), (4, 3, 30))
        self.assertEqual(len(figures["broken_limits"]), 1)

    def test_slowest_over_free_time_counts_one_that_has_not_arrived(self):
        free = [driven("a", 10), driven("b", 10)]
        for trips, limit, broken in (([driven("a", 11), driven("b", 29)], "van=3", 0),
                                     ([driven("a", 11), driven("b", 31)], "van=3", 1),
                                     ([driven("a", 11), driven("b", 31, False)], "van=3", 2),
                                     ([driven("a", 11), driven("b", 5, False)], "van=3", 1)):
            figures = self.figures(trips, free, "--max-vehicle-ratio", limit)
            self.assertEqual(len(figures["broken_limits"]), broken, trips)
        self.assertEqual(figures["vehicles"]["van"]["slowest"], "a")

    def test_limit_on_a_type_that_is_not_there(self):
        write_run(self.path("run"), self.FRAMES, [walked("p", 0, 9)])
        code, _, errors = self.call("--max-vehicle-median", "tank=3")
        self.assertEqual(code, 2)
        self.assertIn("tank", errors)

    def test_teleports_from_statistics_or_from_the_log(self):
        self.assertEqual(self.check(self.FRAMES, [walked("p", 0, 9)], "--max-teleports", "1",
                                    statistics=2)["broken_limits"],
                         ["teleports of vehicles: 2, at most 1"])
        os.remove(self.path("run/statistics.xml"))
        write(self.path("run/log.txt"), "Warning: Teleporting vehicle 'v'; waited too long\n"
              "Warning: Vehicle 'v' ends teleporting on edge 'e', time=1\n"
              "Warning: Person 'p' is jammed on edge 'e', time=1\n")
        figures = self.check(self.FRAMES, [walked("p", 0, 9)])
        self.assertEqual((figures["teleports"], figures["jams"]), (1, 1))


class BadInput(TinyRun):
    FRAMES = [[person("p", 1, 0)]]

    def setUp(self):
        super().setUp()
        write_run(self.path("run"), self.FRAMES, [walked("p", 0, 1)])

    def refused(self, named, *options):
        code, figures, errors = self.call(*options)
        self.assertEqual((code, figures), (2, None), errors)
        self.assertIn(named, errors)
        self.assertEqual(errors.count("\n"), 1)

    def test_sound_run_passes(self):
        self.assertEqual(self.call()[0], 0)

    def test_missing_files(self):
        for name in ("fcd.xml", "tripinfo.xml"):
            shutil.move(self.path(f"run/{name}"), self.path("aside"))
            self.refused(name)
            shutil.move(self.path("aside"), self.path(f"run/{name}"))
        os.remove(self.path("scenario/tiny.poly.xml"))
        self.refused("tiny.poly.xml")

    def test_torn_files(self):
        for name in ("fcd.xml", "tripinfo.xml"):
            with open(self.path(f"run/{name}"), encoding="utf-8") as stream:
                text = stream.read()
            write(self.path(f"run/{name}"), text[:-12])
            self.refused(name)
            write(self.path(f"run/{name}"), text)

    def test_rows_that_are_not_sumos(self):
        write_run(self.path("run"), [['<person id="p" y="1" x="2"/>\n']], [walked("p", 0, 1)])
        self.refused("fcd.xml")

    def test_nobody_to_check(self):
        write_run(self.path("run"), [[]], [])
        self.refused("no persons")

    def test_unknown_type(self):
        write_run(self.path("run"), self.FRAMES, [walked("p", 0, 1, type_id="martian")])
        self.refused("martian")

    def test_trajectories_that_are_no_csv_of_ours(self):
        write(self.path("run/trajectories.csv"), "a,b,c\n")
        self.refused("trajectories.csv")

    def test_network_without_shared_space(self):
        net = self.path("scenario/tiny.net.xml")
        write(net, NET.replace("highway.living_street", "x").replace("highway.pedestrian", "x")
              .replace('speed="2.78"', 'speed="13.9"'))
        self.refused("no shared space")

    def test_teleports_unknown(self):
        self.refused("teleports", "--max-teleports", "0")
        self.refused("teleports", "--strict")


class Formats(TinyRun):
    def test_gzipped_outputs_give_the_same_figures(self):
        frames = [[person("p", x, 0), vehicle("v", 12, 1)] for x in range(5, 20)]
        plain = self.check(frames, [walked("p", 0, -1)])
        for name in ("fcd.xml", "tripinfo.xml"):
            with open(self.path(f"run/{name}"), "rb") as stream:
                text = stream.read()
            with gzip.open(self.path(f"run/{name}.gz"), "wb") as stream:
                stream.write(text)
            os.remove(self.path(f"run/{name}"))
        self.assertEqual(self.call()[1], plain)

    def test_strict_passes_a_sound_run(self):
        figures = self.check(self.controlled([(x, 0) for x in range(10, 20)]),
                             [walked("p", 0, -1)], "--max-lost", "0", "--strict",
                             "--max-walking", "1", "--min-controlled", "1", statistics=0)
        self.assertEqual(figures["broken_limits"], [])


@unittest.skipUnless(shutil.which("sumo"), "sumo is not installed")
class RealSumo(TinyRun):
    """That SUMO writes what the check takes for granted: a walk, a ride, another walk."""

    def test_a_person_that_rides_is_neither_lost_nor_in_contact_nor_jumping(self):
        write(self.path("a.nod.xml"), '<nodes><node id="a" x="0" y="0"/><node id="b" x="200" y="0"/>'
              '<node id="c" x="400" y="0"/></nodes>')
        write(self.path("a.edg.xml"), '<edges><edge id="one" from="a" to="b" numLanes="1" '
              'speed="13.9"/><edge id="two" from="b" to="c" '
              'numLanes="1" speed="5"/></edges>')
        environment = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
        subprocess.run(["netconvert", "-n", self.path("a.nod.xml"), "-e", self.path("a.edg.xml"),
                        "-o", self.path("scenario/tiny.net.xml")], check=True,
                       capture_output=True, env=environment)
        write(self.path("scenario/tiny.rou.xml"), """<routes>
            <vType id="van" vClass="delivery"/>
            <vehicle id="v" type="van" depart="0" arrivalPos="150"><route edges="one two"/>
                <stop edge="one" endPos="100" triggered="true"/><stop edge="two" endPos="50" duration="20"/>
            </vehicle>
            <person id="p" depart="0"><walk edges="one" arrivalPos="97"/>
                <ride from="one" to="two" lines="v"/><walk edges="two" arrivalPos="150"/></person>
            </routes>""")
        write(self.path("scenario/tiny.poly.xml"), "<additional/>")
        os.makedirs(self.path("run"))
        subprocess.run(
            ["sumo", "-c", self.config, "--end", "400", "--fcd-output", self.path("run/fcd.xml"),
             "--tripinfo-output", self.path("run/tripinfo.xml"), "--vehroute-output",
             self.path("run/vehroute.xml"), "--statistic-output", self.path("run/statistics.xml"),
             "--tripinfo-output.write-unfinished", "--no-step-log"], check=True,
            capture_output=True, env=environment)
        code, figures, errors = self.call("--strict", "--min-arrived", "1", "--max-contacts", "0",
                                          "--plain", self.path("run"), "--max-edges-differ", "0")
        self.assertEqual(code, 0, errors)
        self.assertEqual(figures["vehicles"]["van"]["arrived"], 1)
        self.assertEqual(figures["persons"]["controlled"], 0)


if __name__ == "__main__":
    unittest.main()
