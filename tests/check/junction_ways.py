"""What SUMO counts of a walk's way across junctions, and the least that a walk's way can be.

SUMO 1.15 adds the straight line across each junction to the edges' lengths, whoever walks there.
SUMO 1.18 (its list of changes says: since 1.16) adds the ways that its own model has walked there,
and straight lines only where it has walked none. Of a person that pedzone walked, tripinfo's
routeLength therefore lacks the junctions inside the zone.
"""
import re

_SINCE = (1, 16)
_VERSION = re.compile(rb"generated on .* by Eclipse SUMO \S+ Version (\d+)\.(\d+)")


def counts_own_ways(head):
    """Whether an output that begins with these bytes is of a SUMO that counts own ways only."""
    found = _VERSION.search(head)
    return bool(found) and (int(found[1]), int(found[2])) >= _SINCE


def least_way(network, edges, depart_pos, arrival_pos):
    """[m] of a walk's way along its edges, with nothing for junctions; 0 for edges not known.

    Where the walk can begin or end in both directions of an edge, the shorter one.
    """
    route = [network.edges.get(name) for name in edges]
    if not route or not all(edge and edge.lanes for edge in route):
        return 0.0
    lengths = [edge.lanes[0].length for edge in route]
    if len(route) == 1:
        return abs(arrival_pos - depart_pos)
    start, end = route[0].ends, route[-1].ends
    first = [way for way, node in ((depart_pos, start[0]), (lengths[0] - depart_pos, start[1]))
             if node in route[1].ends]
    last = [way for way, node in ((arrival_pos, end[0]), (lengths[-1] - arrival_pos, end[1]))
            if node in route[-2].ends]
    return min(first, default=0.0) + sum(lengths[1:-1]) + min(last, default=0.0)
