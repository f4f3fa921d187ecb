"""Series of the campaigns of this folder, for figures.py: strain over the cycles, its straight line, and paths
of contacts."""
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import arguments, read, refuse  # noqa: E402, F401 (of the folder above, for the scripts too)

PERIOD = 10.0  # s
DROPPED = 29  # cycles before the first that counts


def strains(path, dropped, step=1):
    """γ of every step-th row of the probe load, about the lengths of the first that counts."""
    rows = read(os.path.join(path, "series", "load.csv"))
    first = rows[dropped * step]
    x, y = float(first["length_x"]), float(first["length_y"])
    return [float(r["length_y"]) / y - float(r["length_x"]) / x for r in rows[::step]]


def cycles_of(path):
    """Cycles that the probe load of a run has seen."""
    rows = read(os.path.join(path, "series", "load.csv"))
    return round((float(rows[-1]["time"]) - float(rows[0]["time"])) / PERIOD) if rows else 0


def line_through(values):
    """Slope and root mean square deviation of the straight line by least squares."""
    count = len(values)
    middle, mean = (count - 1) / 2, sum(values) / count
    slope = sum((n - middle) * (v - mean) for n, v in enumerate(values)) / (count * (count**2 - 1) / 12)
    return slope, math.sqrt(sum((v - mean - slope * (n - middle)) ** 2 for n, v in enumerate(values)) / count)


def slope_of(path, dropped=DROPPED):
    return line_through(strains(path, dropped)[dropped:])


class Paths:
    """The last cycle of a run of paths.toml: F_n, F_t and slip of each contact that is ever closed."""

    def __init__(self, path):
        self.path = path
        rows = read(os.path.join(path, "series", "paths.csv"))
        self.per_cycle = round(PERIOD / (float(rows[1]["time"]) - float(rows[0]["time"])))
        last = rows[-self.per_cycle - 1 :]
        names = [n.removeprefix("normal_force_") for n in rows[0] if n.startswith("normal_force_")]
        self.contacts = {}
        for name in names:
            columns = [
                [float(r[f"{c}_{name}"]) for r in last] for c in ("normal_force", "tangential_force", "sliding")
            ]
            if max(columns[0]) > 0:
                self.contacts[name] = columns

    def area(self, name):
        """∮ F_n dF_t (N²)."""
        n, t, _ = self.contacts[name]
        return sum(a * d - b * c for a, b, c, d in zip(n, t, n[1:], t[1:])) / 2
