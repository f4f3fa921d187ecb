"""Runs of cyclic loading: strain after each cycle, areas and slopes of the loops, from campaigns and from the
table that keeps them."""
import csv
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import refuse, runs_of, scree  # noqa: E402 (of the folder above)

numpy = scree.errors.package("numpy")
SPRINGS = {"linear_spring_dashpot": "David et al.", "sphere_path_independent": "painted points"}
HEADER = ("spheres", "friction", "spring", "seed", "period [s]", "step [s]", "cycle", "strain",
          "loop_area [Pa]", "slope [Pa]")
KEYS = ["spheres", "friction", "spring", "seed", "period", "step"]


class Run:
    """strain: deviatoric, at the least load before and after each cycle; loop_area: ∮ σ dε of each cycle (Pa);
    slope: between the extreme points of each (Pa); loops: strains and stresses (Pa) of all cycles, None of runs
    that a table kept."""

    def __init__(self, key, strain, loop_area, slope, loops=None, per_cycle=0):
        self.key = tuple(key)
        self.size, self.friction, self.spring, self.seed, self.period, self.step = self.key
        self.strain, self.loop_area, self.slope = strain, loop_area, slope
        self.loops, self.per_cycle = loops, per_cycle

    def first_loop(self):
        return tuple(values[: self.per_cycle + 1] for values in self.loops)


def area(strain, stress):
    """∮ σ dε, closed from the last point to the first, as `scree cycles` does."""
    return ((stress + numpy.roll(stress, -1)) / 2 * (numpy.roll(strain, -1) - strain)).sum()


def slope(strain, stress):
    """Slope from the first point of a loop to its largest stress."""
    top = stress.argmax()
    return (stress[top] - stress[0]) / (strain[top] - strain[0])


def run_of(run):
    """The Run of a result of a campaign."""
    scenario = run.scenario
    contact, stage, lattice = scenario["contact"][0], scenario["stage"][-1], scenario["particles"].get("lattice")
    # Cycles may have another friction than the preparation.
    changed = stage.get("set", {}).get(contact.get("name", contact["plugin"]), {})
    friction = changed.get("static_friction", contact["static_friction"])
    size = math.prod(lattice["count"]) if lattice else run.record["footprint"]["bodies"]
    period, step = float(stage["period"]), float(scenario["time"]["step"])
    key = size, float(friction), SPRINGS[contact["plugin"]], scenario["scene"]["seed"], period, step
    box = run.series["box"]
    strain, stress = box.deviatoric_strain.to_numpy(), box.deviatoric_stress.to_numpy()
    n = round(period / (box.time[1] - box.time[0]))
    loops = [(strain[at : at + n + 1], stress[at : at + n + 1]) for at in range(0, len(strain) - n, n)]
    return Run(key, strain[::n], [area(*loop) for loop in loops], [slope(*loop) for loop in loops], (strain, stress), n)


def runs_at(folder):
    """Finished runs of a campaign. Ends the script with one line if they are of another kind."""
    runs = []
    for run in runs_of(folder):
        try:
            runs.append(run_of(run))
        except scree.Error:
            raise
        except (AttributeError, KeyError, IndexError) as error:
            refuse(f"{run.path}: not a run of cyclic loading of a scenario of this folder: no {error}")
    return runs


def kept_runs(table):
    """Runs of a table that `keep` wrote; none if there is none."""
    if not os.path.exists(table):
        return []
    groups = scree.read_table(table).groupby(KEYS, sort=False)
    return [Run(key, *(rows[name].tolist()[first:] for name, first in (("strain", 0), ("loop_area", 1), ("slope", 1))))
            for key, rows in groups]


def keep(runs, table):
    """Writes one row a cycle of each run; before the first cycle there is no loop."""
    with open(table, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(HEADER)
        for run in runs:
            loops = itertools.chain([(math.nan, math.nan)], zip(run.loop_area, run.slope))
            for cycle, (strain, (loop_area, slopes)) in enumerate(zip(run.strain, loops)):
                rows.writerow((*run.key, cycle, f"{strain:.8g}", f"{loop_area:.5g}", f"{slopes:.5g}"))


def merged(found, folder, table):
    """Runs of a campaign, and runs of the table that it lacks. Writes both into the table. Ends the script with
    one line where they have other periods or steps."""
    runs = {run.key: run for run in kept_runs(table)}
    runs.update((run.key, run) for run in found)
    for at, what in ((4, "period"), (5, "step")):
        if len({key[at] for key in runs}) > 1:
            refuse(f"{table}: its runs have another {what} than the runs of {folder}; move it away")
    found = [runs[key] for key in sorted(runs)]
    if found:
        keep(found, table)
    return found
