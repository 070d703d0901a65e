"""A run beside plain SUMO's, and beside vehicles that have the streets to themselves."""
import statistics

from junction_ways import least_way

ROUTE_LENGTH_SHARE = 0.01  # a person's routeLength may differ by this share,
ROUTE_LENGTH_ROUNDING = 0.1  # [m] or by this, on routes of a few metres
_SHOWN = 20


def mean_duration(persons):
    """[s] of the persons that arrived; None where nobody did."""
    durations = [trip.duration for trip in persons.values() if trip.arrived]
    return statistics.fmean(durations) if durations else None


def _walked(trip):
    """[m] routeLength of each walk of a person that arrived."""
    return [stage.route_length for stage in trip.stages if stage.kind == "walk"]


def _tolerance(length):
    return max(ROUTE_LENGTH_SHARE * length, ROUTE_LENGTH_ROUNDING)


def _lengths_agree(lengths, plain_lengths):
    return len(lengths) == len(plain_lengths) and all(
        abs(length - plain) <= _tolerance(plain) for length, plain in zip(lengths, plain_lengths))


def _least_ways(trip, plan, network):
    """[m] of each walk of a person, without junctions."""
    edges = [stage[1].split() for stage in plan if stage[0] == "walk"]
    walks = [stage for stage in trip.stages if stage.kind == "walk"]
    if len(edges) != len(walks):
        return [0.0] * len(walks)
    return [least_way(network, route, walk.depart_pos, walk.arrival_pos)
            for route, walk in zip(edges, walks)]


def _lengths_between(lengths, least, plain_lengths):
    """Whether only the way across junctions is shorter than plain SUMO's."""
    return len(lengths) == len(plain_lengths) and all(
        low - ROUTE_LENGTH_ROUNDING <= length <= plain + _tolerance(plain)
        for length, low, plain in zip(lengths, least, plain_lengths))


def compare_persons(run, plain, shorter=frozenset(), network=None):
    """Persons' arrivals, stages, edges, routeLengths and durations against plain SUMO's.

    `shorter`: whose routeLength may lack the way across junctions; that needs the run's plans.
    """
    both = [name for name, trip in plain.persons.items()
            if trip.arrived and name in run.persons and run.persons[name].arrived]
    departed = [name for name, trip in plain.persons.items() if trip.stages]
    missing = sorted(name for name in departed
                     if name not in run.persons or not run.persons[name].stages)
    kinds = [name for name in both
             if [stage.kind for stage in run.persons[name].stages]
             != [stage.kind for stage in plain.persons[name].stages]]
    lengths, without_junctions = [], 0
    for name in both:
        own, its = _walked(run.persons[name]), _walked(plain.persons[name])
        if _lengths_agree(own, its):
            continue
        if name in shorter and run.plans is not None and _lengths_between(
                own, _least_ways(run.persons[name], run.plans.get(name, []), network), its):
            without_junctions += 1
        else:
            lengths.append(name)
    result = {
        "persons_compared": len(both), "plain_arrived": sum(
            trip.arrived for trip in plain.persons.values()),
        "missing": len(missing), "missing_ids": missing[:_SHOWN],
        "stages_differ": len(kinds), "stages_differ_ids": kinds[:_SHOWN],
        "route_length_differs": len(lengths), "route_length_differs_ids": lengths[:_SHOWN],
        "route_length_without_junctions": without_junctions,
        "edges_differ": None, "duration_ratio": None,
        "teleports": plain.teleports, "jams": plain.person_jams,
        "mean_duration_s": mean_duration(plain.persons),
    }
    if both:
        durations = [run.persons[name].duration for name in both]
        plain_durations = [plain.persons[name].duration for name in both]
        ratios = [own / max(other, 1e-9) for own, other in zip(durations, plain_durations)]
        result["duration_ratio"] = sum(durations) / max(sum(plain_durations), 1e-9)
        result["duration_ratio_median"] = statistics.median(ratios)
        result["duration_ratio_range"] = [min(ratios), max(ratios)]
    if run.plans is not None and plain.plans is not None:
        edges = [name for name in both if run.plans.get(name) != plain.plans.get(name)]
        result["edges_differ"], result["edges_differ_ids"] = len(edges), edges[:_SHOWN]
    return result


def vehicle_durations(run, plain=None, free=None):
    """[s] by vehicle type: how many, how many arrived, median and range; and against other runs.

    Medians are over vehicles that arrived; the largest ratio to the free run counts one that has not
    arrived by the time it has been driving.
    """
    result = {}
    for type_id in sorted({trip.type for trip in run.vehicles.values()}):
        trips = {name: trip for name, trip in run.vehicles.items() if trip.type == type_id}
        arrived = {name: trip.duration for name, trip in trips.items() if trip.arrived}
        figures = {"departed": len(trips), "arrived": len(arrived), "median_s": None,
                   "range_s": None}
        if arrived:
            figures["median_s"] = statistics.median(arrived.values())
            figures["range_s"] = [min(arrived.values()), max(arrived.values())]
        for other_name, other in (("plain", plain), ("free", free)):
            durations = [trip.duration for trip in other.vehicles.values()
                         if trip.type == type_id and trip.arrived] if other else []
            if durations:
                figures[f"{other_name}_median_s"] = statistics.median(durations)
        if free:
            ratios = [(trip.duration / free.vehicles[name].duration, name)
                      for name, trip in trips.items()
                      if name in free.vehicles and free.vehicles[name].arrived
                      and free.vehicles[name].duration > 0]
            if ratios:
                figures["largest_ratio_to_free"], figures["slowest"] = max(ratios)
        result[type_id] = figures
    return result
