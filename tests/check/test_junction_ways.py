#!/usr/bin/python3
"""routeLength of a SUMO that counts only the junctions that it walked itself."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from shapely.geometry import LineString

from junction_ways import counts_own_ways, least_way
from tiny_run import TinyRun, person, plan, walked, write_run
from zone_area import Edge, Lane, Network


def network(**ends):
    """Edges of 100 m; ends: name -> (from, to)."""
    line = LineString([(0, 0), (1, 0)])
    return Network({name: Edge(name, "", "normal", nodes,
                               [Lane(name + "_0", name, True, True, 1.0, 2.0, line, 100.0)])
                    for name, nodes in ends.items()})


class LeastWay(unittest.TestCase):
    def test_along_and_against_edges(self):
        net = network(a=("1", "2"), b=("2", "3"), c=("4", "3"))
        self.assertEqual(least_way(net, ["a", "b", "c"], 30, 90), 70 + 100 + 10)
        self.assertEqual(least_way(net, ["c", "b", "a"], 30, 90), 70 + 100 + 10)
        self.assertEqual(least_way(net, ["b", "a"], 30, 90), 30 + 10)

    def test_one_edge(self):
        net = network(a=("1", "2"))
        self.assertEqual(least_way(net, ["a"], 30, 90), 60)
        self.assertEqual(least_way(net, ["a"], 90, 30), 60)

    def test_both_directions_lead_on(self):
        net = network(a=("1", "2"), b=("2", "1"))
        self.assertEqual(least_way(net, ["a", "b"], 30, 90), 30 + 10)

    def test_unknown_edge(self):
        self.assertEqual(least_way(network(a=("1", "2")), ["a", "x"], 30, 90), 0)


class Version(unittest.TestCase):
    def test_of_an_output(self):
        for words, own in ((b"sumo Version 1.15.0", False), (b"libsumo Version 1.16.0", True),
                           (b"sumo Version 1.18.0", True), (b"sumo Version 2.0.0", True),
                           (b"sumo", False)):
            head = b"<!-- generated on 2023-01-01 00:00:00 by Eclipse SUMO " + words
            self.assertEqual(counts_own_ways(head), own, words)


class AgainstPlainSumo(TinyRun):
    """One who walks 100 m of street; plain SUMO counts 10 m at junctions."""
    WALKED_BY_SUMO = [[person("p", x, 0)] for x in (1, 2, 3)]

    def differs(self, length, version, frames):
        plans = [plan("p", '<walk edges="street"/>')]
        trip = walked("p", 0, 9, length).replace('arrivalPos="1"', 'arrivalPos="100"')
        write_run(self.path("plain"), frames, [walked("p", 0, 9, 110)], plans=plans)
        figures = self.check(frames, [trip], "--plain", self.path("plain"), plans=plans,
                             version=version)["plain"]
        return figures["route_length_differs"], figures["route_length_without_junctions"]

    def test_junctions_may_lack_where_sumo_counts_only_its_own(self):
        moved = self.controlled([(1, 0), (2, 0), (3, 0)])
        for length, found in ((110, (0, 0)), (105, (0, 1)), (100, (0, 1)), (99, (1, 0)),
                              (112, (1, 0))):
            self.assertEqual(self.differs(length, "1.18.0", moved), found, length)

    def test_nothing_may_lack_of_a_walk_of_sumos(self):
        self.assertEqual(self.differs(105, "1.18.0", self.WALKED_BY_SUMO), (1, 0))

    def test_nothing_may_lack_with_an_older_sumo(self):
        moved = self.controlled([(1, 0), (2, 0), (3, 0)])
        for version in ("1.15.0", None):
            self.assertEqual(self.differs(105, version, moved), (1, 0))


if __name__ == "__main__":
    unittest.main()
