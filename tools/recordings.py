#!/usr/bin/python3
"""Turns the data sets CITR and DUT, as their authors publish them, into pedzone's clips.

    git clone https://github.com/dongfang-steven-yang/vci-dataset-citr
    git clone https://github.com/dongfang-steven-yang/vci-dataset-dut
    tools/recordings.py citr vci-dataset-citr recordings
    tools/recordings.py dut vci-dataset-dut recordings
    pedzone validate --data recordings

The recordings show people around a vehicle, from above: CITR a golf cart on a parking lot, DUT cars
on a campus. Cite Yang, Li, Redmill and Ozguner, arXiv:1902.00487. They carry no licence, so pedzone
does not contain them.

What is read, below the clone:
    CITR  data/trajectories_filtered/SCENARIO/CLIP_traj_{ped,veh}_filtered.csv
    DUT   data/trajectories_filtered/CLIP_traj_{ped,veh}_filtered.csv
          data/trajectories/CLIP_traj_veh.csv, data/ratios/CLIP_ratio_pixel2meter.txt
A vehicle file may be missing where the clip's name has "no_vehicle". Where another file of a clip is
missing, that clip is left out with a warning that names the file, and the others are written.

What is written: OUT_DIR/citr/CLIP.csv and OUT_DIR/dut/CLIP.csv, with the columns
    t            [s] multiples of 0.1; of one clock for people and vehicles. CITR: since the video's
                 first frame; DUT: since the first frame with anybody in the clip
    kind, id     ped or veh; the original number
    x, y         [m] the original filtered position, linear between frames, never beyond them
    vx, vy       [m/s] central differences of x and y (one-sided at a track's ends)
    heading      [rad] (-pi, pi] from +x towards +y; vehicles only, as all below
    front, rear  [m] from x, y to the bumpers. CITR: 1.0, 1.2 (its README); DUT: half the median
                 distance of the marked front and rear corners
    half_width   [m] CITR: 0.6; DUT: half the median distance of the marked left and right corners
Tracks with less than two such times are left out, and counted. A track with a missing frame is an
error: the authors' filter cannot produce one, so the file is damaged.
"""
# Verified by hand against clips that somebody else had prepared (in brackets: largest difference):
# - DUT intersection_01, _13, _15, _17: excerpts of the published files (0 mm, 0 mm/s, 0.0002 rad;
#   the box of 13, from every tenth frame, 0.01 m). In 01, 15 and 17 those clips start people and
#   vehicles each at their own first frame: vehicles are 0.9, 1.6 and 1.6 s too early. The authors'
#   vis_and_demo.py draws both by one frame number, as here.
# - CITR back_interaction_01: the published files were not to be had. An earlier version, in pixels,
#   through the authors' filter_trajectories.py, with the scale fitted, gives the clip (11 mm,
#   0.003 rad). Names of files and columns: its README of April 2019, that script, others' readers.
import argparse
import csv
import math
import os
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

import numpy

RATE = 10  # [1/s] of the clips
HEADER = "t,kind,id,x,y,vx,vy,heading,front,rear,half_width"
PEOPLE, VEHICLES = "_traj_ped_filtered.csv", "_traj_veh_filtered.csv"
NO_VEHICLE = "no_vehicle"  # in the names of CITR's clips without one
CORNERS = ("fl", "fr", "rl", "rr")  # front left ... rear right
GOLF_CART = (1.0, 1.2, 0.6)  # [m] front, rear, half width: CITR's README


class Site(NamedTuple):
    """What the data sets differ in."""
    frames_per_second: float  # [1/s] (0, inf) CITR: filter_trajectories.py; DUT: README
    people: str  # where the files of people are, below data/trajectories_filtered
    starts_at_zero: bool  # a clip's clock starts with its first frame


SITES = {"citr": Site(29.97, "*/*" + PEOPLE, False), "dut": Site(23.98, "*" + PEOPLE, True)}


class Track(NamedTuple):
    """One person or vehicle: an array each, of equal lengths."""
    frame: numpy.ndarray
    x: numpy.ndarray  # [m]
    y: numpy.ndarray  # [m]
    heading: numpy.ndarray  # [rad] empty for people


class InputError(Exception):
    """One line for the user."""


def number(text, where, column, whole=False):
    """The value of a field; a whole one is 0 or more."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or (whole and (value < 0 or value != int(value))):
        allowed = "a whole number of 0 or more" if whole else "a finite number"
        raise InputError(f"{where}: column '{column}' is '{text}'; {allowed} is needed")
    return int(value) if whole else value


def read_rows(path, columns):
    """Yields line number, id, frame and the columns' values of each row."""
    names = ("id", "frame", *columns)
    with open(path, newline="", encoding="utf-8-sig", errors="replace") as stream:
        lines = csv.reader(stream, quoting=csv.QUOTE_NONE)
        header = [name.strip() for name in next(lines, [])]
        if not header:
            raise InputError(f"{path}: is empty; a first line with {','.join(names)} is needed")
        for name in names:
            if name not in header:
                raise InputError(f"{path}:1: has no column '{name}'; needed are {','.join(names)}")
        places = [header.index(name) for name in names]
        for row in lines:
            where = f"{path}:{lines.line_num}"
            if len(row) != len(header):
                raise InputError(f"{where}: has {len(row)} fields; the header has {len(header)}")
            yield lines.line_num, *(number(row[place], where, name, name in names[:2])
                                    for name, place in zip(names, places))


def read_columns(path, columns):
    """By id, in order: an array with a row for each frame of (frame, columns ...)."""
    tracks = {}
    for line, who, frame, *values in read_rows(path, columns):
        track = tracks.setdefault(who, [])
        if track and frame != track[-1][0] + 1:
            raise InputError(f"{path}:{line}: column 'frame' is {frame} after {track[-1][0]} of id "
                             f"{who}; {track[-1][0] + 1} is needed: tracks have every frame")
        track.append((frame, *values))
    if not tracks:
        raise InputError(f"{path}: has no rows below its header; at least one is needed")
    return {who: numpy.array(tracks[who]) for who in sorted(tracks)}


def read_tracks(path, with_heading):
    """Tracks by id of one of the filtered files."""
    columns = ("x_est", "y_est", "psi_est") if with_heading else ("x_est", "y_est")
    return {who: Track(*rows.T[:3], rows.T[3] if with_heading else numpy.empty(0))
            for who, rows in read_columns(path, columns).items()}


def read_ratio(path):
    """[pixel/m] (0, inf)."""
    text = path.read_text(encoding="utf-8", errors="replace").strip()
    try:
        ratio = float(text)
    except ValueError:
        ratio = math.nan
    if not 0 < ratio < math.inf:
        raise InputError(f"{path}:1: is '{text[:40]}'; one number of pixels/m, above 0, is "
                         "needed")
    return ratio


def marked_box(rows, ratio):
    """[m] front, rear and half width: medians over the frames of marked corners (in pixels).

         fl ___ rl
           |   |     length: between the middles of the ends; width: the mean of both ends'
         fr ‾‾‾ rr
    """
    fl, fr, rl, rr = (rows[:, at:at + 2] / ratio for at in (1, 3, 5, 7))
    length = numpy.median(numpy.hypot(*((fl + fr) / 2 - (rl + rr) / 2).T))
    width = numpy.median((numpy.hypot(*(fl - fr).T) + numpy.hypot(*(rl - rr).T)) / 2)
    return length / 2, length / 2, width / 2


def dut_boxes(original, clip, vehicles):
    """[m] front, rear and half width by id, of the vehicles in a clip of DUT."""
    path = original / f"data/trajectories/{clip}_traj_veh.csv"
    marks = read_columns(path, [f"{axis}_{corner}" for corner in CORNERS for axis in "xy"])
    ratio = read_ratio(original / f"data/ratios/{clip}_ratio_pixel2meter.txt")
    for who in vehicles:
        if who not in marks:
            raise InputError(f"{path}: has no rows of id {who}, which is in {clip}{VEHICLES}")
    return {who: marked_box(marks[who], ratio) for who in vehicles}


def resample(track, first_frame, frames_per_second):
    """t, x, y, vx, vy and heading at the multiples of 1/RATE in a track; None if less than two."""
    recorded = (track.frame - first_frame) / frames_per_second
    slack = 1e-9  # numerical: keeps a frame that falls on a multiple
    first, last = math.ceil(recorded[0] * RATE - slack), math.floor(recorded[-1] * RATE + slack)
    if last <= first:
        return None
    t = numpy.arange(first, last + 1) / RATE
    x, y = numpy.interp(t, recorded, track.x), numpy.interp(t, recorded, track.y)
    turned = numpy.interp(t, recorded, numpy.unwrap(track.heading)) if len(track.heading) else t * 0
    heading = numpy.arctan2(numpy.sin(turned), numpy.cos(turned))
    return t, x, y, numpy.gradient(x, t), numpy.gradient(y, t), heading


def clip_lines(kind, who, samples, box):
    """The lines of one track."""
    for t, x, y, vx, vy, heading in zip(*samples):
        motion = f"{t:.1f},{kind},{who},{x:.3f},{y:.3f},{vx:.3f},{vy:.3f}"
        shape = f"{heading:.4f}," + ",".join(f"{side:.2f}" for side in box) if box else ",,,"
        yield f"{motion},{shape}"


def read_clip(name, original, people_path):
    """Tracks of people and of vehicles, and the vehicles' boxes, each by id."""
    clip = people_path.name[:-len(PEOPLE)]
    vehicle_path = people_path.with_name(clip + VEHICLES)
    people = read_tracks(people_path, False)
    if NO_VEHICLE in clip and not vehicle_path.exists():
        return people, {}, {}
    vehicles = read_tracks(vehicle_path, True)
    if name == "dut":
        return people, vehicles, dut_boxes(original, clip, vehicles)
    return people, vehicles, dict.fromkeys(vehicles, GOLF_CART)


def convert_clip(name, original, people_path, counts):
    """The text of one clip's file."""
    people, vehicles, boxes = read_clip(name, original, people_path)
    first = min(track.frame[0] for track in (*people.values(), *vehicles.values()))
    lines = [HEADER]
    for kind, tracks in (("ped", people), ("veh", vehicles)):
        for who, track in tracks.items():
            samples = resample(track, first if SITES[name].starts_at_zero else 0,
                               SITES[name].frames_per_second)
            counts[kind if samples else "short"] += 1
            if samples:
                lines += clip_lines(kind, who, samples, boxes[who] if kind == "veh" else None)
    return "\n".join(lines) + "\n"


def find_clips(name, original):
    """The files of people, by clip; and those that are missing beside a file of vehicles."""
    folder, pattern, clips = original / "data/trajectories_filtered", SITES[name].people, {}
    for path in sorted(folder.glob(pattern)):
        clip = path.name[:-len(PEOPLE)]
        if clip in clips:
            raise InputError(f"{path}: {clip} is in {clips[clip].parent} as well; one is needed")
        clips[clip] = path
    if not clips:
        raise InputError(f"{folder}: has no {pattern}; name the folder that `git clone` made")
    alone = [path for path in sorted(folder.glob(pattern.replace(PEOPLE, VEHICLES)))
             if path.name[:-len(VEHICLES)] not in clips]
    return clips, [path.with_name(path.name[:-len(VEHICLES)] + PEOPLE) for path in alone]


def write_folder(folder, files):
    """Writes a folder that is complete or absent; so are folders above it that it makes."""
    made = [parent for parent in folder.parents if not parent.exists()]
    unfinished = folder.with_name(f".{folder.name}.{os.getpid()}")
    try:
        unfinished.mkdir(parents=True)
        for file_name, text in files.items():
            (unfinished / file_name).write_text(text, encoding="ascii")
        unfinished.rename(folder)
    except BaseException:
        shutil.rmtree(unfinished, ignore_errors=True)
        for parent in made:
            if parent.exists() and not any(parent.iterdir()):
                parent.rmdir()
        raise


def convert(name, original, out):
    """Writes OUT/NAME; the line that tells what is in it."""
    folder = out / name
    if folder.exists() or folder.is_symlink():
        raise InputError(f"{folder}: exists already; remove it or name another OUT_DIR")
    counts, files = {"ped": 0, "veh": 0, "short": 0}, {}
    clips, missing = find_clips(name, original)
    for clip, path in clips.items():
        try:
            files[f"{clip}.csv"] = convert_clip(name, original, path, counts)
        except FileNotFoundError as error:
            missing.append(error.filename)
    if not files:
        raise InputError(f"{missing[0]}: is missing, and no other clip is complete; one is needed")
    write_folder(folder, files)
    for path in missing:
        print(f"Warning: {path}: is missing; its clip is left out", file=sys.stderr)
    return (f"{folder}: {len(files)} clips, {counts['ped']} people, {counts['veh']} vehicles; "
            f"left out: {len(missing)} clips with a missing file, {counts['short']} tracks with "
            "less than two times")


def parse(words):
    """The command line."""
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=raw)
    sites = parser.add_subparsers(dest="site", required=True, metavar="{citr,dut}")
    for name in SITES:
        site = sites.add_parser(name, description=__doc__, formatter_class=raw, help=name.upper())
        site.add_argument("original", type=Path, metavar="ORIGINAL_DIR",
                          help=f"a clone of vci-dataset-{name}")
        site.add_argument("out", type=Path, metavar="OUT_DIR",
                          help=f"gets a folder {name}, which must not exist yet")
    return parser.parse_args(words)


def main(words=None):
    """The exit code: 0 done, 2 the input is at fault."""
    options = parse(words)
    try:
        print(convert(options.site, options.original, options.out))
    except InputError as error:
        print(f"Error: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"Error: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
