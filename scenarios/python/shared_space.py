#!/usr/bin/python3
"""A walk through `import pedzone`, with pictures: cells (# %%) as in a notebook, run from top to end.

    shared_space.py OUT [--pedzone PROGRAM]

Writes crossing.png, measures.png, models.png and plaza.png to the folder OUT.
"""
# %% Set-up
import argparse
import subprocess
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # pictures go to files
import matplotlib.pyplot as plt
import numpy as np

import pedzone

parser = argparse.ArgumentParser(description="Pictures of a small crowd, by pedzone from Python.")
parser.add_argument("out", type=Path, help="folder for the pictures")
parser.add_argument("--pedzone", default="pedzone", help="the program, for the last part")
given = parser.parse_args()
given.out.mkdir(parents=True, exist_ok=True)
STEP = 0.1  # [s]


def draw_ground(axes, zone):
    for outer, holes in zone.polygons:
        axes.fill(*outer.T, color="#eeeeea")
        for hole in holes:
            axes.fill(*hole.T, color="#b0b0a8")
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")


def save(figure, name):
    figure.savefig(given.out / name, dpi=110, bbox_inches="tight")
    plt.close(figure)


# %% A square with a fountain; people cross it from south to north, a shuttle from west to east
def square(**wishes):
    fountain = [(34, 22), (40, 22), (40, 28), (34, 28)]
    return pedzone.Zone.from_polygons([(0, 0), (50, 0), (50, 30), (0, 30)], holes=[fountain], **wishes)


def people_in(zone, model=None):
    crowd = pedzone.Crowd(zone, seed=7, model=model)
    for k in range(24):
        x = 5 + 5.1 * (k % 8)
        crowd.add((x, 2.0 + 1.5 * (k // 8)), ((x + 2, 29), (x + 5, 29)), speed=1.1 + 0.05 * (k % 9),
                  id=f"person{k}")
    return crowd


def shuttle_at(time):
    return pedzone.Vehicle("shuttle", (-8 + 4.0 * time, 14.0), heading=0.0, speed=4.0, length=5.0, width=2.0)


def walk(crowd, seconds):
    """Times (n,), places (n, people, 2) by person, the shuttle's places (n, 2)."""
    order = crowd.keys.copy()
    times, places, shuttle = [], [], []
    for step in range(int(seconds / STEP)):
        vehicle = shuttle_at(step * STEP)
        crowd.step(STEP, [vehicle])
        rows = {key: row for row, key in enumerate(crowd.keys)}  # rows change places, keys stay
        times.append((step + 1) * STEP)
        places.append(crowd.positions()[[rows[key] for key in order]])
        shuttle.append(shuttle_at((step + 1) * STEP).centre)
    return np.array(times), np.array(places), np.array(shuttle)


zone = square()
times, places, shuttle = walk(people_in(zone), 30)

figure, axes = plt.subplots(figsize=(9, 5.5))
draw_ground(axes, zone)
speeds = np.linalg.norm(np.diff(places, axis=0), axis=2) / STEP
dots = axes.scatter(places[1:, :, 0], places[1:, :, 1], c=speeds, s=3, cmap="viridis", vmin=0, vmax=1.6)
figure.colorbar(dots, label="speed [m/s]", shrink=0.7)
axes.plot(*shuttle[(shuttle[:, 0] > 0) & (shuttle[:, 0] < 50)].T, color="#c04020", label="shuttle's centre")
axes.legend(loc="lower right")
axes.set_title("24 people cross the way of a shuttle")
save(figure, "crossing.png")

# %% TTC and clearance of everybody with the shuttle, and the conflicts that come of them
heading, still = np.zeros(len(times)), np.tile((4.0, 0.0), (len(times), 1))
sizes = {"length": 5.0, "width": 2.0, "radius": 0.24}
figure, (above, below) = plt.subplots(2, 1, figsize=(9, 6), sharex=True)
lowest = []
for k in range(places.shape[1]):
    velocity = np.gradient(places[:, k], STEP, axis=0)
    ttc = pedzone.time_to_contact(places[:, k], velocity, shuttle, still, heading, **sizes)
    room = pedzone.clearance(places[:, k], velocity, shuttle, still, heading, **sizes)
    above.plot(times, ttc, linewidth=1)
    below.plot(times, room, linewidth=1)
    found = pedzone.conflicts(times, places[:, k], shuttle, heading, ttc=60, pet=60, drac=0, **sizes)
    lowest += [one.pet.value for one in found if one.pet]
above.set_ylim(0, 10)
above.set_ylabel("TTC [s]")
above.set_title(f"{len(lowest)} people pass the shuttle's way; least PET {min(lowest):.1f} s")
below.set_ylim(0, 20)
below.set_ylabel("clearance [m]")
below.set_xlabel("time [s]")
save(figure, "measures.png")


# %% A model of one's own, in Python: the goal pulls, whoever is near pushes
class Magnets(pedzone.WalkingModel):
    """For trying out an idea: slow, and no model of people."""

    def decide(self, now):
        n = now.walking
        apart = np.stack([now.x[:n, None] - now.x, now.y[:n, None] - now.y], axis=2)
        distance = np.linalg.norm(apart, axis=2) + 1e-9
        push = (apart / distance[..., None] * np.exp(-distance / 0.5)[..., None]).sum(axis=1)
        goal = np.stack([np.cos(now.goal_direction[:n]), np.sin(now.goal_direction[:n])], axis=1)
        wish = goal + 2.0 * push
        length = np.linalg.norm(wish, axis=1)
        return (np.arctan2(wish[:, 1], wish[:, 0]), now.preferred_speed[:n] * np.minimum(1, length))


figure, all_axes = plt.subplots(2, 2, figsize=(11, 8), constrained_layout=True)
for axes, model in zip(all_axes.flat, ["heuristic", "orca", "social-force", Magnets()]):
    _, ways, _ = walk(people_in(zone, model), 30)
    draw_ground(axes, zone)
    axes.plot(ways[:, :, 0], ways[:, :, 1], color="#2060a0", linewidth=0.8)
    axes.set_title(model if isinstance(model, str) else "Magnets, in Python")
save(figure, "models.png")

# %% What a run of the program has left: tables as arrays
scenario = Path(__file__).resolve().parent.parent / "plaza" / "plaza-low.sumocfg"
table = given.out / "plaza.csv"
subprocess.run([given.pedzone, "run", scenario, "--end", "120", "--quiet", "--trajectories", table],
               check=True, stdout=subprocess.DEVNULL)  # what SUMO itself prints
run = pedzone.read_table(table)  # pandas.DataFrame(run) is a data frame
figure, axes = plt.subplots(figsize=(7, 5.5))
plaza, = pedzone.read_zones(scenario)
draw_ground(axes, plaza)
dots = axes.scatter(run["x"], run["y"], c=np.hypot(run["vx"], run["vy"]), s=2, cmap="viridis",
                    vmin=0, vmax=1.6)
waiting = run["motion"] == "waiting"
axes.scatter(run["x"][waiting], run["y"][waiting], s=30, facecolors="none", edgecolors="#c04020",
             linewidth=0.6, label="waits for a vehicle")
figure.colorbar(dots, label="speed [m/s]", shrink=0.7)
axes.legend(loc="upper left")
axes.set_title(f"The plaza: {len(set(run['id']))} people in two minutes")
save(figure, "plaza.png")
print(f"Pictures in {given.out}: crossing.png, measures.png, models.png, plaza.png")
