#!/usr/bin/python3
"""The commands of the READMEs of scenarios and source run as they stand there.

usage: readme_commands.py PEDZONE PROJECT_FOLDER

Every block of lines indented by four spaces in scenarios/*/README.md and src/*/README.md is typed,
in a copy of the project's folders that it names; simulations end after 20 s of simulated time,
studies have one seed. Commands that need a display (sumo-gui) are left out. Exit code: 0 when all
of them ran.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

END = "20"  # [s] long enough for everything to be read, written and used
BLOCK = re.compile(r"(?:^    \S.*\n(?:^     .*\n)*)+", re.MULTILINE)


def commands(readme):
    """Each block as one shell script."""
    for block in BLOCK.findall(readme.read_text(encoding="utf-8")):
        text = re.sub(r"^    ", "", block, flags=re.MULTILINE)
        if not re.search(r"^(pedzone|sumo|tools/|tests/) ?", text, re.MULTILINE):
            continue  # an example of something else
        text = re.sub(r"^sumo-gui\b(?:.*\\\n)*.*\n", "", text, flags=re.MULTILINE)
        text = re.sub(r"^(pedzone run \S+|sumo -c \S+)", rf"\1 --end {END}", text,
                      flags=re.MULTILINE)
        yield text


def shorten(study):
    text = study.read_text(encoding="utf-8")
    for attribute, value in (("seeds", "1"), ("end", END)):
        text, found = re.subn(rf'(<study\b[^>]*\b{attribute}=")[^"]*"', rf'\g<1>{value}"', text)
        assert found == 1, f"{study} has no {attribute}"
    study.write_text(text, encoding="utf-8")


def main():
    pedzone, project = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    env = {**os.environ, "PATH": f"{pedzone.parent}:{os.environ['PATH']}",
           "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
    failed, count = 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for part in ("networks", "scenarios"):
            shutil.copytree(project / part, folder / part)
        for study in (folder / "scenarios").glob("*/*.study.xml"):
            shorten(study)
        for part in ("tests", "tools"):
            (folder / part).symlink_to(project / part)
        for readme in sorted([*project.glob("scenarios/*/README.md"),
                              *project.glob("src/*/README.md")]):
            for script in commands(readme):
                count += 1
                done = subprocess.run(["bash", "-euc", script], cwd=folder, env=env, text=True,
                                      stdin=subprocess.DEVNULL, capture_output=True)
                if done.returncode == 0:
                    continue
                failed += 1
                print(f"{readme}:\n{script}{done.stderr[-2000:]}\n")
    print(f"{count - failed} of {count} blocks of commands ran")
    return 1 if failed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
