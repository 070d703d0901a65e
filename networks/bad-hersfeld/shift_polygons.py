#!/usr/bin/python3
"""Moves SUMO polygons from one network's frame into another's.

Two networks cut from the same map can have different netOffsets; a polygon file fits only the one
it was made with. This shifts every shape by the difference of the offsets:

    ./shift_polygons.py centre.net.xml.gz centre-shuttle.net.xml.gz centre.poly.xml \
        > centre-shuttle.poly.xml
"""
import gzip
import re
import sys
from decimal import Decimal


def net_offset(path):
    """[m] (x, y) that the network adds to projected coordinates."""
    opener = gzip.open if path.endswith(".gz") else open
    with opener(path, "rt", encoding="utf-8") as net:
        for line in net:
            found = re.search(r'<location netOffset="([^",]+),([^"]+)"', line)
            if found:
                return Decimal(found[1]), Decimal(found[2])
    raise SystemExit(f"{path}: no <location netOffset=...>")


def shifted_shape(shape, dx, dy):
    """The points "x,y[,z] ..." moved by (dx, dy) [m]; z is kept."""
    points = []
    for point in shape.split():
        x, y, *z = point.split(",")
        points.append(",".join([str(Decimal(x) + dx), str(Decimal(y) + dy), *z]))
    return " ".join(points)


def main():
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    from_x, from_y = net_offset(sys.argv[1])
    to_x, to_y = net_offset(sys.argv[2])
    with open(sys.argv[3], encoding="utf-8") as polygons:
        text = polygons.read()
    sys.stdout.write(re.sub(
        r'shape="([^"]*)"',
        lambda found: f'shape="{shifted_shape(found[1], to_x - from_x, to_y - from_y)}"', text))


if __name__ == "__main__":
    main()
