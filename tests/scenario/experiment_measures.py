"""What is measured in the paper's experiments: from tracks alone, in metres and seconds."""

import itertools

import numpy

from experiment_tracks import RADIUS, STEP, Run

ASIDE = 0.3      # [m] so far from its line somebody gives way
STANDS = 0.2     # [m/s] slower than this somebody waits ...
WALKS = 0.6      # [m/s] ... and faster it walks on
WAIT = 1.0       # [s] a shorter stand is no wait
AROUND = 10.0    # [s] before and after an encounter
ORDER = 0.3      # [m] so far ahead of another somebody is before it
TURNED = 0.05    # [m] so far from where it would be alone somebody has begun to turn
TOUCH = 2 * RADIUS + 0.01    # [m] two centres so near each other: bodies touch
FORESEEN = (1.0, 1.5)        # [s] before a contact it is foreseen
COURSE = 0.5     # [s] over which a course is taken
NEAR = 20.0      # [m] gap from which a vehicle is near
NONE = float("nan")


def clearance(run, vehicle):
    """Least distance of a person's centre to the vehicle."""
    return min(float(run.gaps(person, vehicle)[1].min()) for person in run.persons)


def most(values):
    """The value that is farthest from 0."""
    return float(values[numpy.argmax(numpy.abs(values))])


def onset(run, control, person, vehicle):
    """Gap [m] to the vehicle, and time [s] to the least gap, when the person is first ASIDE from
    where it is in `control`, the same without an encounter; 0 where it never is before."""
    t, gap = run.gaps(person, vehicle)
    away = numpy.abs(run.persons[person].at(t)[1] - control.persons[person].at(t)[1])
    nearest = int(gap.argmin())
    first = numpy.flatnonzero(away[:nearest] > ASIDE)
    if len(first) == 0:
        return 0.0, 0.0
    return float(gap[first[0]]), float(t[nearest] - t[first[0]])


def smooth(values, over=COURSE):
    """Mean over so long [s] on, at each step from which there are so many."""
    count = round(over / STEP)
    return numpy.convolve(values, numpy.ones(count) / count, "valid")


def sharpest(run, person, vehicle):
    """Greatest change of a person's velocity [m/s^2], from its mean over COURSE to that over the
    next COURSE, while the vehicle is NEAR until 2 s after it is nearest."""
    track, count = run.persons[person], round(COURSE / STEP)
    vx, vy = (smooth(numpy.gradient(values, STEP)) for values in (track.x, track.y))
    change = numpy.hypot(vx[count:] - vx[:-count], vy[count:] - vy[:-count]) / COURSE
    times = track.t[count:count + len(change)]
    t, gap = run.gaps(person, vehicle)
    there = (times >= t[gap < NEAR][0]) & (times <= t[gap.argmin()] + 2.0)
    return float(change[there].max())


def foreseen(run, times):
    """Of each contact of two persons that comes FORESEEN from now if both keep their course:
    the least distance [m] of their centres from then until 2 s after it would come."""
    x, y = places(run, times)
    back = round(COURSE / STEP)
    found = []
    for i, j in itertools.combinations(range(len(x)), 2):
        away = numpy.stack([x[j] - x[i], y[j] - y[i]])
        course, away = (away[:, back:] - away[:, :-back]) / COURSE, away[:, back:]
        distance, k = numpy.hypot(*away), 0
        until = time_to_contact(away, course)
        while k < len(until):
            end = k + round((min(until[k], FORESEEN[1]) + 2.0) / STEP)
            if FORESEEN[0] < until[k] <= FORESEEN[1] and end < len(until):
                found.append(float(distance[k:end].min()))
                k = end
            k += 1
    return found


def time_to_contact(away, course):
    """[s] until two bodies touch, of relative places and velocities (2 x times); inf: never."""
    square, along = (course * course).sum(axis=0), (away * course).sum(axis=0)
    room = (away * away).sum(axis=0) - (2 * RADIUS) ** 2
    root = along * along - square * room
    with numpy.errstate(invalid="ignore", divide="ignore"):
        return numpy.where((root > 0) & (along < 0) & (room > 0),
                           (-along - numpy.sqrt(root)) / square, numpy.inf)


def likeness(run, lines, vehicle):
    """Correlation of two persons' deviations from their lines (id -> y), from AROUND [s] before
    each is beside the vehicle until as long after; nan where one does not deviate at all."""
    moments, sides = numpy.arange(-AROUND, AROUND, STEP), []
    for person, line in lines.items():
        t, ahead, _ = run.seen_from(person, vehicle)
        beside = t[numpy.abs(ahead + run.sizes[vehicle][0] / 2).argmin()]
        sides.append(run.persons[person].at(beside + moments)[1] - line)
    sides = [side[~numpy.isnan(sides).any(axis=0)] for side in sides]
    if min(side.std() for side in sides) < 1e-3:
        return NONE
    return float(numpy.corrcoef(sides)[0, 1])


def common_times(run):
    """Times at which everybody is there."""
    tracks = list(run.persons.values())
    first, last = max(t.t[0] for t in tracks), min(t.t[-1] for t in tracks)
    return next(t.t[(t.t >= first) & (t.t <= last)] for t in tracks)


def places(run, times):
    """Arrays persons x times of x and of y."""
    at = [track.at(times) for track in run.persons.values()]
    return numpy.array([x for x, _ in at]), numpy.array([y for _, y in at])


def spread(run, times):
    """Distance of the two that are farthest apart, at each time."""
    x, y = places(run, times)
    pairs = list(itertools.combinations(range(len(x)), 2))
    return numpy.max([numpy.hypot(x[i] - x[j], y[i] - y[j]) for i, j in pairs], axis=0)


def waits(run, times):
    """How often somebody stands for a while and walks on, while somebody else walks."""
    speeds = numpy.array([numpy.interp(times, t.t, t.speed) for t in run.persons.values()])
    count = 0
    for k, own in enumerate(speeds):
        others = numpy.delete(speeds, k, axis=0).max(axis=0)
        since = None
        for i, speed in enumerate(own):
            if speed < STANDS and others[i] > WALKS:
                since = i if since is None else since
            elif speed > WALKS:
                count += since is not None and (i - since) * STEP >= WAIT
                since = None
    return count


def changes(values):
    """How often two change their order in `values` (persons x times), by more than ORDER."""
    count = 0
    for one, other in itertools.combinations(values, 2):
        ahead = one - other
        sides = numpy.sign(ahead[numpy.abs(ahead) > ORDER])
        count += int(numpy.count_nonzero(sides[1:] != sides[:-1]))
    return count


def while_there(run, vehicle):
    """Times at which everybody and the vehicle are there, and its front's x."""
    track, times = run.vehicles[vehicle], common_times(run)
    times = times[(times >= track.t[0]) & (times <= track.t[-1])]
    return times, track.at(times)[0]


def split(run, vehicle, line):
    """How many the vehicle, which drives west on y = `line`, passes with the group to the north of
    it, how many to the south, and the gap [m] from its front to the first of them from when on
    somebody is clear of its side to the north and somebody to the south; nan: not before it is
    there."""
    half = run.sizes[vehicle][1] / 2
    times, front = while_there(run, vehicle)
    x, y = places(run, times)
    north = sum(own[numpy.argmin(numpy.abs(front - along))] > line for own, along in zip(y, x))
    gap = front - x.max(axis=0)
    there = numpy.flatnonzero(gap <= 0.0)  # none: it never gets there, such as behind the blind
    before = int(there[0]) if len(there) else len(gap)  # steps until it is there
    both = ((y > line + half).any(axis=0) & (y < line - half).any(axis=0))[:before]
    if not both.any() or not both[-1]:
        return north, len(x) - north, NONE
    not_yet = numpy.flatnonzero(~both)
    return north, len(x) - north, float(gap[not_yet[-1] + 1 if len(not_yet) else 0])


def width(run, times):
    """How far apart those two are who are farthest apart across the street."""
    _, y = places(run, times)
    return y.max(axis=0) - y.min(axis=0)


def rejoin(run, vehicle, apart, across):
    """Time [s] from when the vehicle's rear is behind the last one until all are within `apart` [m]
    of each other, and within `across` [m] across the street; nan: not before the first arrives."""
    times, front = while_there(run, vehicle)
    rear = front + run.sizes[vehicle][0]
    passed = times[rear < places(run, times)[0].min(axis=0)]
    if len(passed) == 0:
        return NONE
    after = common_times(run)
    after = after[after >= passed[0]]
    together = after[(spread(run, after) <= apart) & (width(run, after) <= across)]
    return float(together[0] - passed[0]) if len(together) else NONE


def box_distance(track, box):
    """Least distance of the person's body to a box x0, y0, x1, y1."""
    x0, y0, x1, y1 = box
    dx = numpy.maximum(numpy.maximum(x0 - track.x, track.x - x1), 0.0)
    dy = numpy.maximum(numpy.maximum(y0 - track.y, track.y - y1), 0.0)
    return float(numpy.hypot(dx, dy).min()) - RADIUS


def off_course(track, start, corner):
    """Mean angle [deg] between the way a person has made from when it has passed `start` (x) until
    half way to the corner, and the direct way from there to the corner."""
    inside = (track.x >= start) & (track.x <= (start + corner[0]) / 2)
    x, y = track.x[inside], track.y[inside]
    made = numpy.arctan2(y[-1] - y[0], x[-1] - x[0])
    direct = numpy.arctan2(corner[1] - y[0], corner[0] - x[0])
    return float(numpy.degrees(made - direct))


def shares(run, lines):
    """Of persons on straight lines (id -> y): each one's greatest deviation."""
    return {person: abs(most(run.persons[person].y - line)) for person, line in lines.items()}


def distances(run, one, other):
    """t, and the distance of two persons' centres, while both are there."""
    t = common_times(Run({key: run.persons[key] for key in (one, other)}, {}))
    (x0, y0), (x1, y1) = run.persons[one].at(t), run.persons[other].at(t)
    return t, numpy.hypot(x0 - x1, y0 - y1)


def nearest(run, one, other):
    """Least distance of two persons' centres."""
    return float(distances(run, one, other)[1].min())


def turns(run, control, one, other, aside=TURNED):
    """Distance [m] of two at which the first of them is so far `aside` [m] from where it is in
    `control` (persons, each without the other); 0 where neither is before they are nearest."""
    t, gap = distances(run, one, other)
    first = [numpy.abs(run.persons[p].at(t)[1] - control[p].at(t)[1]) > aside for p in (one, other)]
    before = numpy.flatnonzero((first[0] | first[1])[:gap.argmin()])
    return float(gap[before[0]]) if len(before) else 0.0


def kept_speed(run, one, other):
    """The least speed (mean over COURSE) of two who meet, from 4 s before to 1.5 s after they are
    nearest, as a share of that one's median."""
    t, gap = distances(run, one, other)
    met, shares = t[gap.argmin()], []
    for track in (run.persons[one], run.persons[other]):
        speed = smooth(track.speed[1:])
        times = track.t[1:1 + len(speed)] + COURSE / 2
        there = (times >= met - 4.0) & (times <= met + 1.5)
        shares.append(float(speed[there].min() / numpy.median(track.speed)))
    return min(shares)
