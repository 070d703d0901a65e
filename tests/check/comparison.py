"""A run beside plain SUMO's, and beside vehicles that have the streets to themselves."""
import statistics

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


def _lengths_agree(lengths, plain_lengths):
    return len(lengths) == len(plain_lengths) and all(
        abs(length - plain) <= max(ROUTE_LENGTH_SHARE * plain, ROUTE_LENGTH_ROUNDING)
        for length, plain in zip(lengths, plain_lengths))


def compare_persons(run, plain):
    """Persons' arrivals, stages, edges, routeLengths and durations against plain SUMO's."""
    both = [name for name, trip in plain.persons.items()
            if trip.arrived and name in run.persons and run.persons[name].arrived]
    departed = [name for name, trip in plain.persons.items() if trip.stages]
    missing = sorted(name for name in departed
                     if name not in run.persons or not run.persons[name].stages)
    kinds = [name for name in both
             if [stage.kind for stage in run.persons[name].stages]
             != [stage.kind for stage in plain.persons[name].stages]]
    lengths = [name for name in both if not _lengths_agree(
        _walked(run.persons[name]), _walked(plain.persons[name]))]
    result = {
        "persons_compared": len(both), "plain_arrived": sum(
            trip.arrived for trip in plain.persons.values()),
        "missing": len(missing), "missing_ids": missing[:_SHOWN],
        "stages_differ": len(kinds), "stages_differ_ids": kinds[:_SHOWN],
        "route_length_differs": len(lengths), "route_length_differs_ids": lengths[:_SHOWN],
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
