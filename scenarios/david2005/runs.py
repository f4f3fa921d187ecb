"""Runs of cyclic loading: strain after each cycle, areas and slopes of the loops, from campaigns and from the
table that keeps them; their means as rows of results.csv."""
import csv
import itertools
import math
import os
from collections.abc import Sequence
from typing import NamedTuple

from scree import Error, read_table
from scree.fits import cycles_of, loop_area, loop_slope, mean_and_error

SPRINGS = {"linear_spring_dashpot": "David et al.", "sphere_path_independent": "painted points"}
DAVID = SPRINGS["linear_spring_dashpot"]
HEADER = ("spheres", "friction", "spring", "seed", "period [s]", "step [s]", "cycle", "strain", "loop_area [Pa]",
          "slope [Pa]")
LATE = 50  # cycles
COLLECTED = {"contacts.coordination_number.last": "contacts per sphere after the cycle",
             "box.deviatoric_strain.max": "largest deviatoric strain"}  # by the campaigns of quickstart.toml


class Run(NamedTuple):
    """Of the cycles of a run, and without the last two of one that a table kept:"""

    key: tuple  # spheres, friction, spring, seed, period (s), step (s)
    strain: Sequence[float]  # deviatoric, at the least load before and after each cycle
    loop_area: Sequence[float]  # ∮ σ dε of each cycle (Pa)
    slope: Sequence[float]  # between the extreme points of each (Pa)
    cycles: tuple = None  # strains and stresses (Pa)
    first_cycle: tuple = None


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
    length = round(period / (box.time[1] - box.time[0]))
    loops = list(zip(cycles_of(strain, length), cycles_of(stress, length)))
    areas, slopes = ([quantity(*loop) for loop in loops] for quantity in (loop_area, loop_slope))
    return Run(key, strain[::length], areas, slopes, (strain, stress), loops[0])


def runs_at(campaign):
    """Finished runs of a campaign. An error if they are of another kind."""
    try:
        return [run_of(run) for run in campaign.finished()]
    except (AttributeError, KeyError, IndexError) as error:
        if isinstance(error, Error):
            raise
        line = f"{campaign.path}: not a campaign of cyclic loading of a scenario of this folder: no {error}"
        raise Error(line) from None


def kept_runs(table):
    """Runs of a table that `merged` wrote; none if there is none."""
    if not os.path.exists(table):
        return []
    groups = read_table(table).groupby([name.split(" [")[0] for name in HEADER[:6]], sort=False)
    return [Run(key, rows.strain.tolist(), *(rows[name].tolist()[1:] for name in ("loop_area", "slope")))
            for key, rows in groups]


def merged(found, campaign, table):
    """Runs of a campaign, and runs of the table that it lacks. Writes both into the table, one row a cycle; before the
    first there is no loop. An error where they have other periods or steps."""
    runs = {run.key: run for run in kept_runs(table) + found}
    for at, what in ((4, "period"), (5, "step")):
        if len({key[at] for key in runs}) > 1:
            raise Error(f"{table}: its runs have another {what} than the runs of {campaign.path}; move it away")
    with open(table, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(HEADER)
        for key, run in sorted(runs.items()):
            loops = itertools.chain([(math.nan, math.nan)], zip(run.loop_area, run.slope))
            for cycle, (strain, (area, slope)) in enumerate(zip(run.strain, loops)):
                rows.writerow((*key, cycle, f"{strain:.8g}", f"{area:.5g}", f"{slope:.5g}"))
    return [runs[key] for key in sorted(runs)]


def late_slope(run):
    """Strain per cycle from cycle LATE on, or in the second half of fewer than twice as many."""
    from_cycle = min(LATE, len(run.strain) // 2)
    cycles = len(run.strain) - 1 - from_cycle
    return (run.strain[-1] - run.strain[from_cycle]) / cycles if cycles > 0 else math.nan


def quantities_of(runs):
    """Name, unit, mean and standard error of what is measured of packings of one kind."""
    cycles = len(runs[0].strain) - 1
    late = f"strain per cycle, cycles {min(LATE, (cycles + 1) // 2)} to {cycles}"
    quantities = [(f"strain after {cycles} cycle{'s' * (cycles != 1)}", "1", lambda run: run.strain[-1]),
                  (late, "1", late_slope), ("area of the first loop", "Pa", lambda run: run.loop_area[0]),
                  ("slope of the first loop", "kPa", lambda run: run.slope[0] / 1e3)]
    if cycles > 1:
        quantities.append(("strain after 1 cycle", "1", lambda run: run.strain[1]))
    return [(name, unit, *mean_and_error(map(quantity, runs))) for name, unit, quantity in quantities]


def put_groups(numbers, study, groups, campaign):
    """Means of the packings of each size, friction and spring. campaign: None for runs that runs.csv keeps."""
    for (size, friction, spring), runs in groups.items():
        case, source = f"{size} spheres, μ = {friction:g}, {spring}", "runs" if campaign else "runs.csv"
        numbers.put(study, case, quantities_of(runs), campaign, len(runs), source)


def put_runs(numbers, study, runs, campaign):
    """The numbers of each run, of campaigns over period and step."""
    for run in runs:
        size, friction, spring, seed, period, step = run.key
        found = [row for row in quantities_of([run]) if "per cycle" not in row[0]]
        case = f"seed {seed}, period {period:g} s, step {step:g} s"
        numbers.put(study, case, found, campaign, note=f"{size} spheres, μ = {friction:g}, {spring}")


def put_frictions(numbers, study, campaign):
    """Means over the seeds of what the campaigns of quickstart.toml collect."""
    friction = "contact.static_friction"
    runs = campaign.finished(*COLLECTED, friction)
    for value in dict.fromkeys(run.row[friction] for run in runs):
        rows = [run.row for run in runs if run.row[friction] == value]
        found = [(name, "1", *mean_and_error(row[column] for row in rows)) for column, name in COLLECTED.items()]
        numbers.put(study, f"μ = {value:g}", found, campaign.path, len(rows))
