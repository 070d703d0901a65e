"""Runs a scenario in plain SUMO and with pedzone, each in a process of its own."""
import os
import resource
import signal
import subprocess
from dataclasses import dataclass

from footway import ENVIRONMENT

PLAIN_LIMIT = 120  # [s] of processor time, so that other load on the machine breaks no test
PEDZONE_LIMIT = 300  # [s] the same
PATIENCE = 10  # times as long may it take in all
SUMMARY = "summary.json"  # in the run's folder
FCD_PERIOD = 0.5  # [s] positions are looked at so often, or each step where that is longer


@dataclass
class Ended:
    """How a program ended."""
    failure: str  # empty: well
    processor: float  # [s] of user time


def _trips(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return ["--tripinfo-output", str(folder / "tripinfo.xml"),
            "--tripinfo-output.write-unfinished", "true", "--no-warnings", "true"]


def _positions(folder, step_length):
    return ["--fcd-output", str(folder / "fcd.xml"),
            "--device.fcd.period", f"{max(step_length, FCD_PERIOD):g}"]


def _last_line(log):
    lines = [line for line in log.read_text(errors="replace").splitlines() if line.strip()]
    return lines[-1] if lines else "it said nothing"


def _execute(words, log, limit):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    failure = ""
    with open(log, "wb") as stream:
        try:
            code = subprocess.run(
                words, env=ENVIRONMENT, stdin=subprocess.DEVNULL, stdout=stream,
                stderr=subprocess.STDOUT, timeout=PATIENCE * limit,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1)),
            ).returncode
            if code in (-signal.SIGXCPU, -signal.SIGKILL):
                failure = f"{os.path.basename(words[0])} has not ended after {limit} s of work"
            elif code:
                failure = f"{os.path.basename(words[0])} ended with {code}: {_last_line(log)}"
        except subprocess.TimeoutExpired:
            failure = f"{os.path.basename(words[0])} has not ended after {PATIENCE * limit} s"
    used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return Ended(failure, used)


def run_plain(config, folder, seed):
    """Plain SUMO, striping."""
    return _execute(["sumo", "-c", str(config), "--seed", str(seed), "--no-step-log",
                     *_trips(folder)], folder.parent / "plain.log", PLAIN_LIMIT)


def run_pedzone(pedzone, config, zone, folder, seed, step_length, model=None):
    """pedzone on the same input, everybody on the zone's footways walked by it."""
    words = [pedzone, "run", str(config), "--zone", str(zone), "--seed", str(seed),
             "--threads", "1", "--summary", str(folder / SUMMARY), *(["--model", model] if model else []), "--",
             *_trips(folder), *_positions(folder, step_length)]
    return _execute(words, folder.parent / "pedzone.log", PEDZONE_LIMIT)
