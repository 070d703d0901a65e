"""Runs a scenario in plain SUMO and with pedzone, each in a process of its own."""
import os
import resource
import subprocess
import time
from dataclasses import dataclass

from footway import ENVIRONMENT

PLAIN_TIMEOUT = 120.0  # [s]
PEDZONE_TIMEOUT = 300.0  # [s]
FCD_PERIOD = 0.5  # [s] positions are looked at so often, or each step where that is longer


@dataclass
class Ended:
    """How a program ended."""
    failure: str  # empty: well
    seconds: float  # of wall time
    processor: float  # [s] of user time


def _trips(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return ["--tripinfo-output", str(folder / "tripinfo.xml"),
            "--tripinfo-output.write-unfinished", "true", "--no-warnings", "true"]


def _positions(folder, step_length):
    return ["--fcd-output", str(folder / "fcd.xml"),
            "--device.fcd.period", f"{max(step_length, FCD_PERIOD):g}"]


def _execute(words, log, timeout):
    began, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    failure = ""
    with open(log, "wb") as stream:
        try:
            code = subprocess.run(words, env=ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=stream,
                                  stderr=subprocess.STDOUT, timeout=timeout).returncode
            if code:
                failure = f"{os.path.basename(words[0])} ended with {code}, see {log}"
        except subprocess.TimeoutExpired:
            failure = f"{os.path.basename(words[0])} did not end within {timeout:g} s"
    used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return Ended(failure, time.monotonic() - began, used)


def run_plain(config, folder, seed):
    """Plain SUMO, striping."""
    return _execute(["sumo", "-c", str(config), "--seed", str(seed), "--no-step-log",
                     *_trips(folder)], folder.parent / "plain.log", PLAIN_TIMEOUT)


def run_pedzone(pedzone, config, zone, folder, seed, step_length, model=None):
    """pedzone on the same input, everybody on the zone's footways walked by it."""
    words = [pedzone, "run", str(config), "--zone", str(zone), "--seed", str(seed),
             "--threads", "1", *(["--model", model] if model else []), "--",
             *_trips(folder), *_positions(folder, step_length)]
    return _execute(words, folder.parent / "pedzone.log", PEDZONE_TIMEOUT)
