"""The example with plots runs as a user would run it, and draws something.

    test_script.py SCRIPT PEDZONE
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import matplotlib.image
import numpy

SCRIPT, PEDZONE = None, None


class Script(unittest.TestCase):
    def test_all_pictures_show_something(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "pictures"
            subprocess.run([sys.executable, SCRIPT, out, "--pedzone", PEDZONE], check=True, cwd=folder,
                           stdout=subprocess.DEVNULL)
            pictures = sorted(out.glob("*.png"))
            self.assertEqual([one.stem for one in pictures], ["crossing", "measures", "models", "plaza"])
            for picture in pictures:
                pixels = matplotlib.image.imread(picture)[..., :3].reshape(-1, 3)
                self.assertGreater(len(numpy.unique((pixels * 15).astype(int), axis=0)), 12, picture)


if __name__ == "__main__":
    SCRIPT, PEDZONE = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
