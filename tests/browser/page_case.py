"""What the tests of pages that are drawn once share: opening them, and light and dark."""

import tempfile
import unittest
from pathlib import Path


class PageCase(unittest.TestCase):
    """Subclasses set the class attributes `browser` and `page`, the path of an HTML file."""

    @classmethod
    def make_folder(cls):
        """A folder that is there until the last test of the class."""
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        return Path(directory.name)

    def open(self, width=1280, height=900, mobile=False):
        self.browser.resize(width, height, mobile)
        self.browser.open(self.page)
        self.browser.run("""while (!(window.report && window.report.ready))
                              await new Promise((done) => setTimeout(done, 20));
                            await new Promise((done) => requestAnimationFrame(
                              () => requestAnimationFrame(done)));""")

    def ask(self, expression, *arguments):
        return self.browser.run("return " + expression, *arguments)

    def test_light_and_dark(self):
        self.addCleanup(self.browser.prefer, "light")
        for scheme, dark in (("dark", True), ("light", False)):
            self.browser.prefer(scheme)
            self.open()
            ground = self.ask("""getComputedStyle(document.body).backgroundColor
                .match(/[0-9]+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0)""")
            self.assertEqual(ground < 380, dark)
