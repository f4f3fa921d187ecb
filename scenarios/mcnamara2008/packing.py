"""A packing of discs with the forces of its contacts, as in figure 16 of McNamara et al. (2008)."""
import math
import os

from series import read
from style import BLUE, GREEN, GREY, ORANGE, RED, label, pyplot

STIFFNESS = 100.0  # N/m, of discs and walls


def tangential_forces(path):
    """F_t (N) of the contacts at the end, by the pair of names, body first."""
    last = read(os.path.join(path, "series", "forces.csv"))[-1]
    names = [n.removeprefix("tangential_force_") for n in last if n.startswith("tangential_force_")]
    return {tuple(name.split("_")): float(last[f"tangential_force_{name}"]) for name in names}


def draw_force(axes, begin, end, normal, tangential):
    """A line between centres as wide as the normal force, and one across it as long as the tangential force."""
    axes.plot(*zip(begin, end), color=BLUE, linewidth=8 * normal)
    along = [(b - a) / math.dist(begin, end) for a, b in zip(begin, end)]
    middle = [(a + b) / 2 for a, b in zip(begin, end)]
    half = 3 * tangential  # L for 1 N, of which there are hundredths
    axes.plot(
        [middle[0] + half * along[1], middle[0] - half * along[1]],
        [middle[1] - half * along[0], middle[1] + half * along[0]],
        color=RED,
        linewidth=2,
        zorder=4,
    )


def draw_packing(axes, run):
    """Discs at the end, their forces, and velocities of discs without contacts."""
    path = run["path"]
    discs = [
        {k: float(v) for k, v in r.items() if k != "material"} for r in read(os.path.join(path, "final_packing.csv"))
    ]
    box = read(os.path.join(path, "series", "load.csv"))[-1]
    width, height = float(box["length_x"]), float(box["length_y"])
    tangential = tangential_forces(path)
    axes.add_patch(pyplot.Rectangle((0, 0), width, height, fill=False, color="black"))
    for a in discs:
        x, y, r = a["x"], a["y"], a["radius"]
        ends = [
            (r - x, "wall1", 0, y),
            (r - width + x, "wall2", width, y),
            (r - y, "wall3", x, 0),
            (r - height + y, "wall4", x, height),
        ]
        ends += [
            (r + b["radius"] - math.hypot(x - b["x"], y - b["y"]), f"{b['id']:.0f}", b["x"], b["y"])
            for b in discs
            if b is not a
        ]
        contacts = [end for end in ends if end[0] > 0]
        axes.add_patch(pyplot.Circle((x, y), r, facecolor="#eeeeee" if contacts else ORANGE, edgecolor=GREY))
        axes.annotate(
            f"{a['id']:.0f}",
            (x, y),
            ha="center",
            va="center",
            fontsize=8,
            zorder=3,
            bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )
        for overlap, name, to_x, to_y in contacts:
            draw_force(
                axes, (x, y), (to_x, to_y), STIFFNESS * overlap, abs(tangential.get((f"{a['id']:.0f}", name), 0))
            )
        if not contacts:
            speed = math.hypot(a["vx"], a["vy"]) or 1
            axes.annotate(
                "",
                (x + 0.12 * a["vx"] / speed, y + 0.12 * a["vy"] / speed),
                (x, y),
                arrowprops={"arrowstyle": "->", "color": GREEN, "linewidth": 1.8},
                zorder=4,
            )
    axes.set(xlim=(-0.02, width + 0.02), ylim=(-0.02, height + 0.02), aspect="equal")
    label(
        axes,
        f"Packing {run['seed']} (figure 16): normal forces blue,\ntangential red across them, velocity green",
        "$x$ / L",
        "$y$ / L",
    )
    axes.grid(False)
