"""The table of verdicts, a line a case and seed."""

_COLUMNS = (("case", -52), ("seed", 4), ("people", 6), ("striping", 8), ("pedzone", 7),
            ("time s", 7), ("ratio", 6), ("on foot", 7), ("boarded", 9), ("overlap", 7),
            ("nearest", 7), ("out", 4), ("jump", 4), ("jams", 4), ("cpu s", 10))


def _row(texts):
    return " | ".join(text.ljust(-width) if width < 0 else text.rjust(width)
                      for text, (_, width) in zip(texts, _COLUMNS))


def _ratio(own, other):
    return "-" if own is None or not other else f"{own / other:.2f}"


def _number(value, digits):
    return "-" if value is None else f"{value:.{digits}f}"


def heading():
    return (_row([name for name, _ in _COLUMNS]) + "\n"
            + "-|-".join("-" * abs(width) for _, width in _COLUMNS))


def line(verdict):
    """People in the demand, arrived with striping and with pedzone, mean time with pedzone and over
    striping's, the same ratio of those who only walk, boarded with both, ..."""
    plain, own = verdict.striping, verdict.pedzone
    cpu = "/".join(f"{seconds:.1f}" for seconds in verdict.processor)
    if own is None:
        return _row([verdict.case, str(verdict.seed), *["-"] * 12, cpu]) + " | broken"
    return _row([
        verdict.case, str(verdict.seed), str(verdict.demand), str(plain.arrived), str(own.arrived),
        _number(own.mean, 0), _ratio(own.mean, plain.mean), _ratio(own.mean_walk, plain.mean_walk),
        f"{plain.boarded}/{own.boarded}", str(verdict.overlaps), _number(verdict.nearest, 2),
        str(verdict.outside), str(verdict.jumps), str(verdict.jams), cpu]) + (
            " | broken" if verdict.broken else " | holds")
