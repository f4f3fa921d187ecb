"""Runs of cyclic loading: strain after each cycle, areas and slopes of the loops, from campaigns and from the
table that keeps them."""
import csv
import itertools
import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import read, refuse, runs_of, scenario_of  # noqa: E402 (of the folder above)

SPRINGS = {"linear_spring_dashpot": "David et al.", "sphere_path_independent": "painted points"}
KEYS = ("spheres", "friction", "spring", "seed", "period [s]", "step [s]")
COLUMNS = ("cycle", "strain", "loop_area [Pa]", "slope [Pa]")


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
    closed_strain, closed_stress = [*strain, strain[0]], [*stress, stress[0]]
    return sum(
        (a + b) / 2 * (d - c)
        for a, b, c, d in zip(closed_stress, closed_stress[1:], closed_strain, closed_strain[1:])
    )


def slope(strain, stress):
    top = max(range(len(stress)), key=stress.__getitem__)
    return (stress[top] - stress[0]) / (strain[top] - strain[0])


def bodies_of(path, scenario):
    """Number of bodies of the lattice, or of the state from which the run began."""
    if "lattice" in scenario["particles"]:
        return math.prod(scenario["particles"]["lattice"]["count"])
    with open(os.path.join(path, "run.json"), encoding="utf-8") as record:
        return json.load(record)["footprint"]["bodies"]


def run_at(path):
    """A run of a campaign."""
    scenario = scenario_of(path)
    contact, stage = scenario["contact"][0], scenario["stage"][-1]
    # Cycles may have another friction than the preparation.
    friction = (
        stage.get("set", {})
        .get(contact.get("name", contact["plugin"]), {})
        .get("static_friction", contact["static_friction"])
    )
    key = (
        bodies_of(path, scenario),
        float(friction),
        SPRINGS[contact["plugin"]],
        scenario["scene"]["seed"],
        float(stage["period"]),
        float(scenario["time"]["step"]),
    )
    rows = read(os.path.join(path, "series", "box.csv"))
    times, strain, stress = ([float(r[c]) for r in rows] for c in ("time", "deviatoric_strain", "deviatoric_stress"))
    n = round(stage["period"] / (times[1] - times[0]))
    loops = [(strain[at : at + n + 1], stress[at : at + n + 1]) for at in range(0, len(strain) - n, n)]
    return Run(
        key, strain[::n], [area(*loop) for loop in loops], [slope(*loop) for loop in loops], (strain, stress), n
    )


def runs_at(folder):
    """Finished runs of a campaign. Ends the script with one line if they are of another kind."""
    runs = []
    for row in runs_of(folder):
        try:
            runs.append(run_at(row["path"]))
        except (KeyError, IndexError, OSError) as error:
            refuse(f"{row['path']}: not a run of cyclic loading of a scenario of this folder: no {error}")
    return runs


def kept_runs(table):
    """Runs of a table that `keep` wrote; none if there is none."""
    rows = [list(row.values()) for row in read(table)] if os.path.exists(table) else []
    runs = []
    for texts, cycles in itertools.groupby(rows, key=lambda row: row[: len(KEYS)]):
        strain, loop_area, slopes = ([float(v) for v in values] for values in list(zip(*cycles))[len(KEYS) + 1 :])
        size, friction, spring, seed, period, step = texts
        runs.append(
            Run(
                (int(size), float(friction), spring, int(seed), float(period), float(step)),
                strain,
                loop_area[1:],
                slopes[1:],
            )
        )
    return runs


def keep(runs, table):
    """Writes one row a cycle of each run; before the first cycle there is no loop."""
    with open(table, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(KEYS + COLUMNS)
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
