"""What has to be true of a measure over seeds.

Each check has a text, and result(rows) -> (whether it holds, the figures, more of them) of rows
{measure: number}, one for each seed.
"""

import math
import statistics
from dataclasses import dataclass

# Student's t, 97.5 %, for n - 1 degrees of freedom; of the nearest smaller n that is here
STUDENT = {1: 12.706, 4: 2.776, 9: 2.262, 14: 2.145, 19: 2.093, 29: 2.045, 39: 2.023}
SEEDS = [n + 1 for n in STUDENT]


def interval(values):
    """Mean and 95 % interval."""
    mean, count = statistics.fmean(values), len(values)
    if count < 2:
        return mean, mean, mean
    freedom = max(n for n in STUDENT if n < count)
    half = STUDENT[freedom] * statistics.stdev(values) / math.sqrt(count)
    return mean, mean - half, mean + half


def known(rows, measure):
    """Of the seeds that have it: None stands for a seed in which it was not asked for."""
    return [row[measure] for row in rows if row[measure] is not None]


def limits(check):
    """As text."""
    low = [f"at least {check.least:g}"] if check.least > -math.inf else []
    high = [f"at most {check.most:g}"] if check.most < math.inf else []
    return " and ".join(low + high)


@dataclass
class Mean:
    """The interval of the mean is inside [least, most]."""
    text: str
    measure: str
    least: float = -math.inf
    most: float = math.inf

    def result(self, rows):
        mean, low, high = interval(known(rows, self.measure))
        return low >= self.least and high <= self.most, f"{mean:.2f} [{low:.2f}, {high:.2f}]", ""

    def failed(self, rows):
        """Beyond doubt: the whole interval is outside."""
        _, low, high = interval(known(rows, self.measure))
        return high < self.least or low > self.most

    def limits(self):
        return limits(self)


@dataclass
class Share:
    """At least `share` of the seeds are inside [least, most]; of those that have the measure."""
    text: str
    measure: str
    least: float = -math.inf
    most: float = math.inf
    share: float = 0.9

    def result(self, rows):
        values = known(rows, self.measure)
        inside = sum(self.least <= value <= self.most for value in values)
        numbers = [value for value in values if not math.isnan(value)] or [math.nan]
        return (bool(values) and inside >= self.share * len(values),
                f"{inside} of {len(values)} ({statistics.median(numbers):.2f})",
                f": median in brackets, {min(numbers):.2f} to {max(numbers):.2f}")

    def failed(self, rows):
        """Beyond doubt: fewer than half as many as there should be."""
        values = known(rows, self.measure)
        inside = sum(self.least <= value <= self.most for value in values)
        return inside < 0.5 * self.share * len(values)

    def limits(self):
        return limits(self)


@dataclass
class Around:
    """The interval of the mean contains `value`."""
    text: str
    measure: str
    value: float

    def result(self, rows):
        mean, low, high = interval(known(rows, self.measure))
        return low <= self.value <= high, f"{mean:.2f} [{low:.2f}, {high:.2f}]", ""

    def limits(self):
        return f"around {self.value:g}"


@dataclass
class Figure:
    """Told only."""
    text: str
    measure: str

    def result(self, rows):
        mean, low, high = interval(known(rows, self.measure))
        return True, f"{mean:.2f} [{low:.2f}, {high:.2f}]", ""

    def limits(self):
        return "not judged"


@dataclass
class Missed:
    """A check that the default model is known not to hold: told with its limit, not counted."""
    check: object

    @property
    def text(self):
        return self.check.text

    def result(self, rows):
        return self.check.result(rows)

    def limits(self):
        return self.check.limits()


def verdict(check, holds):
    """What is printed behind a result."""
    if isinstance(check, Missed):
        return "  holds now: let it count" if holds else "  DOES NOT HOLD, as is known"
    return "" if holds else "  DOES NOT HOLD"
