"""The limits of the command line, and the table."""
from scenario import CheckError

# option -> (where the figure is, what it is)
_MAXIMA = {
    "lost": (("persons", "lost"), "persons lost"),
    "walking": (("persons", "walking"), "persons still in SUMO at the end"),
    "contacts": (("contacts", "all", "pairs"), "person-vehicle pairs in contact"),
    "controlled-contacts": (("contacts", "controlled", "pairs"),
                            "pairs in contact, controlled persons"),
    "zone-contacts": (("contacts", "zone", "pairs"), "pairs in contact, controlled or on the zone's edges"),
    "jumps": (("jumps", "events"), "jumps"),
    "controlled-jumps": (("jumps", "controlled"), "jumps of controlled persons"),
    "outside": (("outside", "persons"), "persons outside the walkable area"),
    "teleports": (("teleports",), "teleports of vehicles"),
    "nan": (("nan",), "positions that are no numbers"),
    "missing": (("plain", "missing"), "persons that departed in plain SUMO only"),
    "stages-differ": (("plain", "stages_differ"), "persons with other stages than in plain SUMO"),
    "edges-differ": (("plain", "edges_differ"), "persons with other edges than in plain SUMO"),
    "route-length-differs": (("plain", "route_length_differs"),
                             "persons with another routeLength than in plain SUMO"),
}
_STRICT = ("lost", "walking", "controlled-contacts", "jumps", "outside", "teleports", "nan")


def add_limits(parser):
    """Options --max-..., --min-... of the command line."""
    limits = parser.add_argument_group("limits")
    for name, (_, meaning) in _MAXIMA.items():
        limits.add_argument(f"--max-{name}", type=int, metavar="N", help=meaning)
    limits.add_argument("--strict", action="store_true",
                        help="0 for " + ", ".join(f"--max-{name}" for name in _STRICT)
                        + " where not given")
    limits.add_argument("--min-arrived", type=int, metavar="N", help="persons arrived")
    limits.add_argument("--min-controlled", type=int, metavar="N",
                        help="persons walked by somebody else than SUMO at some time")
    limits.add_argument("--duration-ratio", type=float, nargs=2, metavar=("LOW", "HIGH"),
                        help="persons' durations over plain SUMO's, of all that arrived in both")
    limits.add_argument("--max-vehicle-median", action="append", default=[],
                        metavar="TYPE=SECONDS", help="median duration of arrived vehicles")
    limits.add_argument("--max-vehicle-ratio", action="append", default=[],
                        metavar="TYPE=RATIO", help="slowest vehicle over its duration in FREE; "
                        "all of the type must arrive")


def _figure(result, path, option):
    value = result
    for key in path:
        value = value.get(key) if isinstance(value, dict) else None
        if value is None:
            raise CheckError(f"--{option}: the run has no outputs to tell {'.'.join(path)}")
    return value


def _by_type(texts, option, result):
    """(type, limit, figures) of each TYPE=NUMBER."""
    for text in texts:
        type_id, _, number = text.rpartition("=")
        try:
            limit = float(number)
        except ValueError:
            raise CheckError(f"--{option} {text}: is not TYPE=NUMBER") from None
        if type_id not in result["vehicles"]:
            raise CheckError(f"--{option} {text}: no vehicle of type '{type_id}'")
        yield type_id, limit, result["vehicles"][type_id]


def broken_limits(options, result):
    """One line for each limit that the figures break."""
    broken = []

    def expect(kept, text):
        if not kept:
            broken.append(text)

    for name, (path, meaning) in _MAXIMA.items():
        limit = getattr(options, "max_" + name.replace("-", "_"))
        if limit is None and options.strict and name in _STRICT:
            limit = 0
        if limit is not None:
            value = _figure(result, path, f"max-{name}")
            expect(value <= limit, f"{meaning}: {value}, at most {limit}")
    for name in ("arrived", "controlled"):
        limit = getattr(options, f"min_{name}")
        if limit is not None:
            value = result["persons"][name]
            expect(value >= limit, f"persons {name}: {value}, at least {limit}")
    if options.duration_ratio:
        low, high = options.duration_ratio
        value = _figure(result, ("plain", "duration_ratio"), "duration-ratio")
        expect(low <= value <= high, f"durations over plain SUMO's: {value:.3f}, {low} to {high}")
    for type_id, limit, figures in _by_type(options.max_vehicle_median, "max-vehicle-median",
                                            result):
        value = figures["median_s"]
        expect(value is not None and value <= limit,
               f"median duration of {type_id}: {value} s, at most {limit:g} s")
    for type_id, limit, figures in _by_type(options.max_vehicle_ratio, "max-vehicle-ratio",
                                            result):
        value = _figure(figures, ("largest_ratio_to_free",), "max-vehicle-ratio")
        expect(value <= limit, f"{figures['slowest']} of type {type_id} took {value:.2f} times "
               f"its free time, at most {limit:g}")
        expect(figures["arrived"] == figures["departed"],
               f"{figures['departed'] - figures['arrived']} of type {type_id} did not arrive")
    return broken


def _number(value, digits=2):
    return "-" if value is None else f"{value:.{digits}f}"


def _contact_lines(contacts):
    for name, meaning in (("all", "all"), ("controlled", "controlled persons"),
                          ("zone", "in shared space"), ("elsewhere", "elsewhere"),
                          ("at_insertion", "at insertion"),
                          ("turned", "unless they have turned")):
        part = contacts[name]
        types = ", ".join(f"{count} {kind}" for kind, count in
                          sorted(part["pairs_by_vehicle_type"].items()))
        yield (f"  {meaning}", f"{part['pairs']} pairs in {part['frames']} frames"
               + (f", deepest {part['deepest_m']:.2f} m ({types})" if part["pairs"] else ""))
    yield ("  smallest clearance", f"{_number(contacts['min_clearance_m'])} m; controlled "
           f"{_number(contacts['min_clearance_controlled_m'])} m")


def _plain_lines(plain):
    yield ("against plain SUMO", f"{plain['persons_compared']} persons arrived in both")
    yield ("  departed there only", str(plain["missing"]))
    differing = "not compared" if plain["edges_differ"] is None else plain["edges_differ"]
    yield ("  other stages / edges", f"{plain['stages_differ']} / {differing}")
    yield ("  other routeLength", f"{plain['route_length_differs']}, without the zone's junctions "
           f"{plain['route_length_without_junctions']}")
    yield ("  mean duration", f"ratio {_number(plain['duration_ratio'], 3)}, plain "
           f"{_number(plain['mean_duration_s'], 1)} s")


def table(result):
    """The figures for people to read."""
    persons, outside = result["persons"], result["outside"]
    lines = [
        ("persons", f"{persons['departed']} departed, {persons['arrived']} arrived, "
         f"{persons['walking']} still in SUMO, {persons['lost']} lost"),
        ("  controlled", f"{persons['controlled']} persons, "
         f"{persons['controlled_person_steps']} person-steps"),
        ("  mean duration", f"{_number(persons['mean_duration_s'], 1)} s"),
        ("  jams", "-" if result["jams"] is None else str(result["jams"])),
        ("contacts", ""), *_contact_lines(result["contacts"]),
        ("jumps", f"{result['jumps']['events']} of {result['jumps']['persons']} persons, "
         f"{result['jumps']['controlled']} of them controlled"),
        ("outside", f"{outside['persons']} persons in {outside['events']} frames")]
    lines += [(f"  {name.replace('_', ' ')}", f"{outside[name]['persons']} persons in "
               f"{outside[name]['events']} frames")
              for name in ("in_building", "on_road", "out_of_reach")]
    lines += [("teleports", "-" if result["teleports"] is None else str(result["teleports"])),
              ("not a number", str(result["nan"])), ("vehicles", "")]
    for type_id, figures in result["vehicles"].items():
        text = (f"{figures['arrived']} of {figures['departed']} arrived, median "
                f"{_number(figures['median_s'], 1)} s")
        for other in ("plain", "free"):
            if f"{other}_median_s" in figures:
                text += f", {other} {_number(figures[f'{other}_median_s'], 1)} s"
        if "largest_ratio_to_free" in figures:
            text += f", slowest {figures['largest_ratio_to_free']:.2f} times free"
        lines.append((f"  {type_id}", text))
    if "plain" in result:
        lines += _plain_lines(result["plain"])
    return "\n".join(f"{name:<24}{text}".rstrip() for name, text in lines)
