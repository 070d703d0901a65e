#!/usr/bin/python3
"""What a TraCI connection costs: N people on one square, SUMO in process and over TraCI, the same
walks. Prints how many times faster than real time each is, and microseconds a person and step.

usage: attach_cost.py PEDZONE_PROGRAM [--persons 100 500 2000] [--seconds 30]
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "cli"))
sys.path.append(str(Path(__file__).resolve().parent.parent / "attach"))
from attached import free_port  # noqa: E402
from tiny_scenario import EDGES, TinyScenario, sumo_environment  # noqa: E402

SQUARE = EDGES.replace('width="8"', 'width="60"')


def scenario(folder, persons):
    """People all over a square of 60 m, who walk to its end and on."""
    tiny = TinyScenario(folder, edges=SQUARE)
    dice = random.Random(1)
    walks = "".join(
        f'<person id="p{k}" depart="0" departPos="{dice.uniform(1, 40):.2f}">'
        f'<walk edges="shared east" departPosLat="{dice.uniform(-28, 28):.2f}"/></person>'
        for k in range(persons))
    tiny.write("tiny.rou.xml", f"<routes>{walks}</routes>")
    return tiny.config()


def summary(pedzone, words, folder):
    file = Path(folder) / "s.json"
    subprocess.run([pedzone, *map(str, words), "--summary", str(file), "--quiet"], check=True,
                   cwd=folder, capture_output=True)
    return json.loads(file.read_text())["time"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pedzone", type=os.path.abspath)
    parser.add_argument("--persons", type=int, nargs="+", default=[100, 500, 2000])
    parser.add_argument("--seconds", type=float, default=20)
    options = parser.parse_args()
    print(f"{'persons':>8} {'how':>12} {'x real time':>12} {'us a person and step':>22}")
    for persons in options.persons:
        with tempfile.TemporaryDirectory() as folder:
            config = scenario(folder, persons)
            port = free_port()
            (Path(folder) / "fine.sumocfg").write_text(
                Path(config).read_text().replace('step-length value="0.5"',
                                                 'step-length value="0.1"'))
            config = Path(folder) / "fine.sumocfg"
            inside = summary(options.pedzone, ["run", config, "--end", options.seconds], folder)
            sumo = subprocess.Popen(["sumo", "-c", config, "--remote-port", str(port),
                                     "--no-step-log"], env=sumo_environment(), cwd=folder,
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            over = summary(options.pedzone, ["attach", config, "--port", port, "--order", 1,
                                             "--end", options.seconds], folder)
            sumo.wait(timeout=60)
            for how, time in (("in process", inside), ("over TraCI", over)):
                print(f"{persons:8} {how:>12} {time['simulated_s'] / time['wall_s']:12.1f} "
                      f"{1e6 * time['wall_s'] / max(1, time['person_steps']):22.1f}")


if __name__ == "__main__":
    main()
