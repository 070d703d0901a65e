"""The cases: footways and bus stops, what is asked of each."""
import itertools
import random
from dataclasses import dataclass

from footway import SHAPES, make_footway, make_street, write_scenario
from people import Demand

STANDARD_BODY = 0.478  # [m] SUMO's person
BROAD_BODY = 0.7  # [m] with luggage, or in winter


@dataclass(frozen=True)
class Limits:
    """What a case asks of pedzone beside striping."""
    arrivals: float = 0.99  # share of striping's
    time_ratio: float = 1.25  # mean duration over striping's, of all that arrived with both
    everybody: bool = False  # all arrive, vehicles too, as many as are in the demand
    last_ratio: float = None  # time of the last arrival over striping's


@dataclass(frozen=True)
class Footway:
    """People who walk both ways along a footway of 100 m."""
    shape: str
    width: float  # [m]
    flow: float  # [persons/(m s)] both ways together
    major: float  # share of them that walks from a to c
    body: float  # [m] how wide they are
    step_length: float  # [s]
    limits = Limits()
    demand_time = 200.0  # [s] for which they come
    end = 600.0  # [s] time enough for four times the walk

    @property
    def name(self):
        return (f"{self.shape}-{self.width:g}m-{self.flow:g}-{self.major * 100:.0f}"
                f"-body{self.body:g}-step{self.step_length:g}")

    def make(self, folder, seed):
        """Writes the scenario; returns its sumocfg."""
        edges = make_footway(folder, self.shape, self.width)
        demand = Demand(random.Random(seed), self.body)
        count = self.flow * self.width * self.demand_time
        major = round(count * self.major)
        demand.passers(major, edges, "forward", 0.0, self.demand_time)
        demand.passers(round(count) - major, edges[::-1], "backward", 0.0, self.demand_time)
        return write_scenario(folder, edges, demand.routes(), None, self.step_length, self.end)


@dataclass(frozen=True)
class BusStop:
    """40 people wait where 50 each way pass; then the bus comes. 12 m of stop, one bus long: SUMO
    stands 15 in a row, three rows from the kerb on."""
    step_length: float  # [s]
    body: float = STANDARD_BODY  # [m]
    width: float = 2.0  # [m]
    limits = Limits(arrivals=1.0, time_ratio=1.2, everybody=True, last_ratio=1.2)
    end = 1200.0  # [s]

    @property
    def name(self):
        return f"bus-stop-{self.width:g}m-body{self.body:g}-step{self.step_length:g}"

    def make(self, folder, seed):
        """Writes the scenario; returns its sumocfg."""
        edges = make_street(folder, self.width)
        demand = Demand(random.Random(seed), self.body)
        demand.stop("middle", "ab_1", 44, 56, 100)
        demand.stop("last", "bc_1", 80, 92, 100)
        demand.waiting("waiting", 40, ["ab"], "forward", "middle", "L", "last", 0.0, 100.0)
        demand.passers(50, edges, "forward", 150.0, 400.0)
        demand.passers(50, edges[::-1], "backward", 150.0, 400.0)
        demand.bus("bus", "L", 600.0, edges, ["middle", "last"])
        return write_scenario(folder, edges, demand.routes(), demand.additional, self.step_length,
                              self.end, [f"{edge}_0" for edge in edges])


@dataclass(frozen=True)
class BusyStop:
    """Three lines whose buses meet every ten minutes: each time 60 people wait, 30 get off, and all
    the while 300 an hour pass each way. 20 m of stop: SUMO stands 25 in a row, three rows."""
    step_length: float  # [s]
    body: float = STANDARD_BODY  # [m]
    width: float = 2.5  # [m]
    limits = Limits(arrivals=0.99, time_ratio=1.25)
    lines, waiting, alighting = ("A", "B", "C"), 20, 10  # people of each line and bus
    interval, first_bus, buses = 600.0, 600.0, 3  # [s], [s], of each line
    end = 2700.0  # [s]

    @property
    def name(self):
        return f"busy-stop-{self.width:g}m-body{self.body:g}-step{self.step_length:g}"

    def make(self, folder, seed):
        """Writes the scenario; returns its sumocfg."""
        edges = make_street(folder, self.width)
        rng = random.Random(seed)
        demand = Demand(rng, self.body)
        demand.stop("middle", "ab_1", 40, 60, 200)
        demand.stop("last", "bc_1", 80, 92, 200)
        last_bus = self.first_bus + (self.buses - 1) * self.interval
        each_way = round(300 * last_bus / 3600)
        demand.passers(each_way, edges, "forward", 0.0, last_bus)
        demand.passers(each_way, edges[::-1], "backward", 0.0, last_bus)
        onward = ((["ab", "bc"], "forward"), (["ab"], "backward"))
        to_stop = ((["ab"], "forward"), (["bc", "ab"], "backward"))
        for run in range(self.buses):
            meeting = self.first_bus + run * self.interval
            for place, line in enumerate(self.lines):
                # From both sides in turn; the last two minutes before the bus nobody sets out.
                demand.waiting(f"{line}{run}-in", self.waiting, *to_stop[(place + run) % 2],
                               "middle", line, "last", meeting - self.interval, meeting - 180.0)
                demand.bus(f"{line}{run}", line, meeting + 15.0 * place, edges,
                           ["middle", "last"], [rng.choice(onward) for _ in range(self.alighting)],
                           "middle")
        return write_scenario(folder, edges, demand.routes(), demand.additional, self.step_length,
                              self.end, [f"{edge}_0" for edge in edges])


# What footways and people are like; each value meets each value of the others in some case.
FOOTWAY_VALUES = {
    "shape": SHAPES,
    "width": (1.5, 2.0, 3.0, 5.0),
    "flow": (0.2, 0.5, 0.8, 1.3),
    "major": (0.5, 0.9),
    "body": (STANDARD_BODY, BROAD_BODY),
    "step_length": (0.1, 0.5, 1.0),
}


def _pairs(footway):
    """Every two values that meet in a case, with what they are values of."""
    chosen = [(name, getattr(footway, name)) for name in FOOTWAY_VALUES]
    return {(one, other) for index, one in enumerate(chosen) for other in chosen[:index]}


def all_footways():
    """Every combination: far too many to run with ten seeds each."""
    return [Footway(**dict(zip(FOOTWAY_VALUES, values)))
            for values in itertools.product(*FOOTWAY_VALUES.values())]


def footways():
    """Few of them, greedily chosen, in which all pairs of values meet."""
    candidates = all_footways()
    missing = set().union(*map(_pairs, candidates))
    chosen = []
    while missing:
        # Of equals the last: it is the widest, fullest, coarsest.
        best = max(candidates[::-1], key=lambda footway: len(_pairs(footway) & missing))
        chosen.append(best)
        missing -= _pairs(best)
    return chosen


def all_cases():
    """Every case of the long suite, bus stops first."""
    steps = FOOTWAY_VALUES["step_length"]
    fullest = [Footway("straight", width, 1.3, 0.5, STANDARD_BODY, 0.5)
               for width in FOOTWAY_VALUES["width"]]
    chosen = footways()
    return ([BusStop(step) for step in steps] + [BusyStop(step) for step in steps] + chosen
            + [footway for footway in fullest if footway not in chosen])


def sample():
    """(case, seed) of the default suite: each kind once, cheap ones."""
    return [(BusStop(0.5), 1), (BusyStop(1.0), 2),
            (Footway("straight", 2.0, 0.8, 0.5, STANDARD_BODY, 0.5), 3),
            (Footway("bent", 3.0, 0.5, 0.9, BROAD_BODY, 0.5), 4),
            (Footway("walking-area", 2.0, 0.5, 0.5, STANDARD_BODY, 1.0), 5),
            (Footway("straight", 1.5, 0.5, 0.5, STANDARD_BODY, 0.1), 6)]
