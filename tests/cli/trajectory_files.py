"""Trajectories as PedPy and JuPedSim read them: by their documented rules, sharing nothing with src/.

PedPy: pedpy/io/trajectory_loader.py (text) and jupedsim_loader.py (database, versions 1 and 2);
JuPedSim: sqlite_serialization.py (the database it writes, version 2).
"""

import csv
import sqlite3

import numpy
import shapely.ops
import shapely.wkt

# Table: its columns as (name, type, may be NULL).
JUPEDSIM = {
    "trajectory_data": [("frame", "INTEGER", False), ("id", "INTEGER", False),
                        ("pos_x", "REAL", False), ("pos_y", "REAL", False),
                        ("ori_x", "REAL", False), ("ori_y", "REAL", False)],
    "metadata": [("key", "TEXT", False), ("value", "TEXT", False)],
    "geometry": [("hash", "INTEGER", False), ("wkt", "TEXT", False)],
    "frame_data": [("frame", "INTEGER", False), ("geometry_hash", "INTEGER", False)],
}


class Database:
    def __init__(self, path):
        self.connection = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        self.metadata = dict(self.connection.execute("SELECT key, value FROM metadata"))
        self.rate = float(self.metadata["fps"])
        self.persons = dict(self.connection.execute("SELECT id, person FROM person_ids"))
        # [frame, id, x, y, orientation]
        self.rows = numpy.array(self.connection.execute(
            "SELECT frame, id, pos_x, pos_y, ori_x, ori_y FROM trajectory_data").fetchall(),
            dtype=float).reshape(-1, 6)

    def columns(self, table):
        return [(name, kind, not not_null) for _, name, kind, not_null, _, _ in
                self.connection.execute(f"PRAGMA table_info({table})")]

    def ground(self):
        """Where people can be: the union of all, as PedPy takes it."""
        return shapely.ops.unary_union([shapely.wkt.loads(text) for text, in
                                        self.connection.execute("SELECT wkt FROM geometry")])

    def geometry_of(self, frame):
        """As JuPedSim's player finds it."""
        return self.connection.execute(
            "SELECT wkt FROM geometry JOIN frame_data ON hash = geometry_hash WHERE frame = ?",
            (frame,)).fetchall()


class Text:
    def __init__(self, path):
        self.rate = self.unit = None
        with open(path, encoding="utf-8-sig") as lines:
            for line in lines:
                if not line.startswith("#"):
                    break
                if "framerate" in line and self.rate is None:
                    self.rate = next(float(word) for word in line.split() if is_number(word))
                if "x/cm" in line.lower() or "in cm" in line.lower():
                    self.unit = "cm"
                if "x/m" in line.lower() or "in m" in line.lower():
                    self.unit = "m"
        # [id, frame, x, y, z]
        self.rows = numpy.loadtxt(path, ndmin=2)


def is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def table_rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))
