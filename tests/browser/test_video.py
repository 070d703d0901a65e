#!/usr/bin/python3
"""`pedzone animate --video`: films, looked at by ffprobe and ffmpeg.

usage: test_video.py PEDZONE_PROGRAM
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PEDZONE = None  # set from the command line

WIDTH, HEIGHT = 320, 180
SECONDS = 8


def walkers():
    """One walks east, one stands."""
    return "<fcd-export>" + "".join(
        f'<timestep time="{t}"><person id="a" x="{3 * t}" y="0" angle="90" speed="3"/>'
        f'<person id="b" x="12" y="6" angle="0" speed="0"/></timestep>'
        for t in range(SECONDS + 1)) + "</fcd-export>"


class Video(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        self.scratch = self.folder / "scratch"
        self.scratch.mkdir()
        (self.folder / "fcd.xml").write_text(walkers())

    def command(self, file, *words):
        return [PEDZONE, "animate", "fcd.xml", "--video", file, "--video-width", str(WIDTH), *words]

    def animate(self, *words, **more):
        return subprocess.run(self.command(*words), cwd=self.folder, text=True, timeout=300,
                              capture_output=True, stdin=subprocess.DEVNULL,
                              env={**os.environ, "TMPDIR": str(self.scratch), **more})

    def probe(self, file):
        done = subprocess.run(["ffprobe", "-v", "error", "-of", "json", "-count_frames",
                               "-show_entries", "stream=codec_name,width,height,nb_read_frames",
                               "-show_entries", "format=duration", file],
                              cwd=self.folder, check=True, capture_output=True, text=True)
        found = json.loads(done.stdout)
        return {**found["streams"][0], "duration": float(found["format"]["duration"])}

    def grey(self, file, number):
        """Pixels of a frame."""
        done = subprocess.run(["ffmpeg", "-v", "error", "-i", file, "-vf",
                               f"select=eq(n\\,{number})", "-frames:v", "1", "-f", "rawvideo",
                               "-pix_fmt", "gray", "-"], cwd=self.folder, check=True,
                              capture_output=True)
        self.assertEqual(len(done.stdout), WIDTH * HEIGHT)
        return done.stdout

    def check(self, file, codec, speed, rate):
        done = self.animate(file, "--video-speed", str(speed), "--video-fps", str(rate))
        self.assertEqual(done.returncode, 0, done.stderr)
        frames = SECONDS * rate // speed + 1
        found = self.probe(file)
        self.assertEqual((found["codec_name"], found["width"], found["height"],
                          int(found["nb_read_frames"])), (codec, WIDTH, HEIGHT, frames))
        self.assertAlmostEqual(found["duration"], frames / rate, delta=1.5 / rate)
        first, middle, last = (self.grey(file, k) for k in (0, frames // 2, frames - 1))
        for frame in (first, middle, last):
            self.assertGreater(max(frame) - min(frame), 100, "not blank")
        for one, other in ((first, middle), (middle, last)):
            changed = sum(abs(a - b) > 40 for a, b in zip(one, other))
            self.assertGreater(changed, 20, "people move")
            self.assertLess(changed, WIDTH * HEIGHT // 4, "the ground does not")
        self.assertEqual(list(self.scratch.iterdir()), [], "nothing is left over")

    def test_mp4(self):
        self.check("out/film.mp4", "h264", 4, 5)

    def test_webm(self):
        self.check("film.webm", "vp9", 4, 5)

    def test_gif(self):
        self.check("film.gif", "gif", 4, 5)

    def test_the_time_shown(self):
        done = self.animate("film.mp4", "--begin", "2", "--end", "4", "--video-fps", "5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(int(self.probe("film.mp4")["nb_read_frames"]), 11)

    def test_the_same_again(self):
        self.assertEqual(self.animate("a.mp4", "--video-speed", "8").returncode, 0)
        self.assertEqual(self.animate("b.mp4", "--video-speed", "8").returncode, 0)
        self.assertEqual((self.folder / "a.mp4").read_bytes(), (self.folder / "b.mp4").read_bytes())

    def test_page_and_film(self):
        done = self.animate("film.gif", "--out", "page.html", "--video-speed", "8",
                            "--video-fps", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "page.html").exists() and (self.folder / "film.gif").exists())

    def test_bytes_in_a_name(self):
        self.assertEqual(self.animate("50 % #ü?.gif", "--video-speed", "8", "--video-fps",
                                      "2").returncode, 0)
        self.assertTrue((self.folder / "50 % #ü?.gif").exists())

    # Bad input

    def check_refused(self, done, *fragments):
        self.assertEqual(done.returncode, 2, done.stderr)
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)
        self.assertEqual(done.stderr.count("Error: "), 1, done.stderr)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"fcd.xml", "scratch"})

    def test_another_kind_of_file(self):
        self.check_refused(self.animate("film.avi"), "--video", "film.avi", ".mp4, .webm or .gif")

    def test_programs_that_are_missing(self):
        nothing = self.scratch / "bin"
        nothing.mkdir()
        done = self.animate("film.mp4", PATH=str(nothing))
        self.check_refused(done, "--video", "ffmpeg", "apt-get install ffmpeg chromium")

    def test_a_program_that_fails(self):
        tools = self.scratch / "bin"
        tools.mkdir()
        (tools / "ffmpeg").write_text("#!/bin/sh\necho no such codec >&2\nexit 3\n")
        (tools / "ffmpeg").chmod(0o755)
        done = self.animate("film.mp4", PATH=f"{tools}:{os.environ['PATH']}")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no such codec", done.stderr)
        self.assertEqual([path.name for path in self.folder.glob("film*")], [])

    def test_options(self):
        for words in (("--video-speed", "0"), ("--video-fps", "1000"), ("--video-width", "7")):
            self.check_refused(self.animate("film.mp4", *words), words[0], words[1])

    def test_interrupted(self):
        process = subprocess.Popen(self.command("film.mp4", "--video-speed", "0.01"),
                                   cwd=self.folder, stderr=subprocess.PIPE, text=True,
                                   stdin=subprocess.DEVNULL,
                                   env={**os.environ, "TMPDIR": str(self.scratch)})
        self.addCleanup(process.kill)
        while not list(self.scratch.glob("pedzone-*/page.html")):
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        time.sleep(1)  # it films by now; it does not matter where it is
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGINT, errors)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"fcd.xml", "scratch"})
        self.assertEqual(list(self.scratch.iterdir()), [])


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
