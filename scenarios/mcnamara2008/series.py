"""Series of the campaigns of this folder: strain over the cycles, its straight line, and paths of contacts."""
import numpy
from scree.fits import line_through, proportional

PERIOD = 10.0  # s
DROPPED = 29  # cycles before the first that counts
PHASE = "stage.cycles.set.box.stress_x_high.phase_deg"
LAWS = {"disc_cundall_strack": "Cundall and Strack", "disc_corrected": "corrected", "disc_angular": "painted points"}
WALLS = {"wall1": "left wall", "wall2": "right wall", "wall3": "lower wall", "wall4": "upper wall"}


def strain_of(box, first=0):
    """γ of all rows of a table with lengths, about the lengths of a row."""
    return (box.length_y / box.length_y[first] - box.length_x / box.length_x[first]).to_numpy()


def strains(run):
    """γ of the rows of the probe load from the first cycle that counts on, about the lengths there."""
    return strain_of(run.series["load"], DROPPED)[DROPPED:]


def slope_of(run):
    """Slope per cycle and root mean square deviation of the strains that count."""
    return line_through(strains(run))


def long_runs(campaign, *columns):
    """Runs of a campaign of at least 30 cycles of 10 τ whose table has the columns; none without a campaign."""
    found = []
    for run in campaign.finished() if campaign else []:
        time = run.series["load"].time
        if len(time) and round((time.iloc[-1] - time.iloc[0]) / PERIOD) > DROPPED and run.row.keys() >= set(columns):
            found.append(run)
    return found


def slopes_over(campaign, column, *columns, least):
    """By the values of columns: Δγ over that of a column, where there are at least so many."""
    found = {}
    for run in long_runs(campaign, column, *columns):
        found.setdefault(tuple(run.row[name] for name in columns), {})[run.row[column]] = slope_of(run)[0]
    return {key: slopes for key, slopes in found.items() if len(slopes) >= least}


def phases_of(campaign):
    """Δγ over φ − 90°, of each case and packing that has three phases or more."""
    return slopes_over(campaign, PHASE, "case", "seed", least=3)


def steps_of(campaign):
    """Δγ over the step, of each law and packing that has two steps or more."""
    return slopes_over(campaign, "time.step", "contact.discs.plugin", "seed", least=2)


def sine_fit(slopes):
    """A and R² of Δγ = A sin φ. slopes: Δγ over φ − 90°."""
    return proportional(numpy.cos(numpy.radians(list(slopes))), list(slopes.values()))


def bodies_of(contact):
    """A contact "3_7" or "3_wall1" in words."""
    return " and ".join(WALLS.get(part, f"disc {part}") for part in contact.split("_"))


class Paths:
    """A run of paths.toml: γ of all rows, and over the last cycle F_n, F_t and slip of each contact that is ever
    closed; areas ∮ F_n dF_t (N²), the largest first; slips: samples in which a contact slides, of those that do."""

    def __init__(self, run):
        self.seed, rows = run.row["seed"], run.series["paths"]
        self.name = f"{LAWS[run.scenario['contact'][0]['plugin']]}, packing {self.seed}"
        self.gamma = strain_of(run.series["load"])
        self.per_cycle = round(PERIOD / (rows.time[1] - rows.time[0]))
        self.minima = self.gamma[DROPPED * self.per_cycle :: self.per_cycle]
        last = rows.iloc[-self.per_cycle - 1 :]
        names = [name.removeprefix("normal_force_") for name in rows if name.startswith("normal_force_")]
        columns = ("normal_force", "tangential_force", "sliding")
        self.contacts = {name: [last[f"{column}_{name}"].to_numpy() for column in columns] for name in names
                         if last[f"normal_force_{name}"].max() > 0}
        self.slips = {name: int(sum(sliding)) for name, (*_, sliding) in self.contacts.items() if sum(sliding)}
        areas = {name: (n[:-1] * t[1:] - t[:-1] * n[1:]).sum() / 2 for name, (n, t, _) in self.contacts.items()}
        self.areas = dict(sorted(areas.items(), key=lambda item: -abs(item[1])))


def paths_of(campaign):
    """Paths of the runs of paths.toml by case: "biaxial", and "phase 90" and others about it."""
    return {run.row["case"]: Paths(run) for run in long_runs(campaign, "case")}


def ellipses_of(paths):
    """Paths by the phase of the load, in degrees, and the contact with the largest area at 90; none without that."""
    ellipses = {case.split()[1]: of_case for case, of_case in paths.items() if case.startswith("phase ")}
    return (ellipses, next(iter(ellipses["90"].areas))) if "90" in ellipses else ({}, None)
