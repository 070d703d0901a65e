#!/usr/bin/python3
"""Another client of a SUMO that pedzone has joined, with SUMO's own traci module.

usage: client.py --port PORT [--order 1] [--steps N] [--then close|hang|die] [--saves FILE]

--saves: what it has found, when it is asked to end, which takes a second.
"""

import argparse
import os
import signal
import sys
import time

sys.path.append(os.path.join(os.environ.get("SUMO_HOME", "/usr/share/sumo"), "tools"))
import traci  # noqa: E402  (SUMO's tools have to be found first)


def save(file):
    time.sleep(1)
    with open(file, "w", encoding="utf-8") as found:
        found.write("found")
    sys.exit()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--port", type=int, required=True)
    parser.add_argument("--order", type=int, default=1)
    parser.add_argument("--steps", type=int, default=10**9)
    parser.add_argument("--then", choices=["close", "hang", "die"], default="close")
    parser.add_argument("--saves")
    options = parser.parse_args()
    if options.saves:
        signal.signal(signal.SIGTERM, lambda *_: save(options.saves))
    traci.init(options.port, numRetries=300)
    traci.setOrder(options.order)
    for _ in range(options.steps):
        traci.simulationStep()
    if options.then == "close":
        traci.close()
    elif options.then == "hang":
        print("hangs", flush=True)
        time.sleep(600)
    else:
        os.kill(os.getpid(), signal.SIGKILL)


if __name__ == "__main__":
    main()
