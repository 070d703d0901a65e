"""The crowd from Python is the crowd: everybody is in the same place, to the bit.

    test_twin.py CROWD_TWIN
"""
import subprocess
import sys
import unittest

from crowd_twin import walk

TWIN = None


class Twin(unittest.TestCase):
    def test_people_are_where_they_are_in_c_plus_plus(self):
        _, _, crowd = walk(300, 60)
        lines = subprocess.run([TWIN, "300", "60"], check=True, capture_output=True,
                               text=True).stdout.splitlines()[1:]
        there = [tuple(map(float.fromhex, line.split())) for line in lines]
        self.assertEqual(list(zip(crowd.x.tolist(), crowd.y.tolist())), there)
        self.assertEqual(len(there), 300)


if __name__ == "__main__":
    TWIN = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
