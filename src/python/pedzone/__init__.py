"""Walks pedestrians through shared space: pedzone's crowd, its measures and its tables.

    import pedzone
    zone = pedzone.Zone.from_polygons([(0, 0), (40, 0), (40, 20), (0, 20)])
    crowd = pedzone.Crowd(zone)
    crowd.add((2, 10), (38, 10))
    while not crowd.arrived.all():
        crowd.step(0.1)

Metres, seconds, radians counter-clockwise from +x. A running SUMO cannot be reached from here:
`pedzone attach` joins a simulation that your program drives through TraCI.
"""
from ._pedzone import *  # noqa: F401,F403
from ._pedzone import __version__  # noqa: F401
