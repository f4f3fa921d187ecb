"""Series of the campaigns of this folder, for figures.py: strain over the cycles, its straight line, and paths
of contacts."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import arguments, refuse, scree  # noqa: E402, F401 (of the folder above, for the scripts too)

numpy = scree.errors.package("numpy")
PERIOD = 10.0  # s
DROPPED = 29  # cycles before the first that counts


def strain_of(box, first=0):
    """γ of all rows of a table with lengths, about the lengths of a row."""
    return (box.length_y / box.length_y[first] - box.length_x / box.length_x[first]).to_numpy()


def strains(run, dropped):
    """γ of every row of the probe load, about the lengths of the first that counts."""
    return strain_of(run.series["load"], dropped)


def cycles_of(run):
    """Cycles that the probe load of a run has seen."""
    time = run.series["load"].time
    return round((time.iloc[-1] - time.iloc[0]) / PERIOD) if len(time) else 0


def line_through(values):
    """Slope and root mean square deviation of the straight line by least squares."""
    cycles = numpy.arange(len(values)) - (len(values) - 1) / 2
    about_mean = numpy.asarray(values) - numpy.mean(values)
    slope = (cycles @ about_mean) / (cycles @ cycles)
    return slope, numpy.sqrt(numpy.mean((about_mean - slope * cycles) ** 2))


def slope_of(run, dropped=DROPPED):
    """Slope and deviation of the strains from the first cycle that counts on."""
    return line_through(strains(run, dropped)[dropped:])


class Paths:
    """The last cycle of a run of paths.toml: F_n, F_t and slip of each contact that is ever closed."""

    def __init__(self, run):
        rows = run.series["paths"]
        self.per_cycle = round(PERIOD / (rows.time[1] - rows.time[0]))
        last = rows.iloc[-self.per_cycle - 1 :]
        names = [name.removeprefix("normal_force_") for name in rows if name.startswith("normal_force_")]
        columns = ("normal_force", "tangential_force", "sliding")
        self.contacts = {name: [last[f"{column}_{name}"].to_numpy() for column in columns] for name in names
                         if last[f"normal_force_{name}"].max() > 0}

    def area(self, name):
        """∮ F_n dF_t (N²)."""
        n, t, _ = self.contacts[name]
        return (n[:-1] * t[1:] - t[:-1] * n[1:]).sum() / 2
