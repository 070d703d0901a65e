"""What every refusal of pedzone must look like."""


class RefusalChecks:
    """Mixed into a TestCase whose programs write below `self.folder`/out."""

    def check_refused(self, done, *fragments, code=2):
        """The exit code, one clear error with these fragments, and nothing half-written."""
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)
        errors = [line for line in done.stderr.splitlines() if line.startswith("Error: ")]
        if code == 2:
            self.assertEqual(len(errors), 1, done.stderr)
        left = [str(path) for path in (self.folder / "out").rglob("*") if path.is_file()]
        self.assertEqual(left, [], "outputs are complete or absent")
