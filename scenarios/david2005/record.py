"""Numbers of cyclic loading as rows of results.csv."""
import math
import statistics

from tables import runs_of  # of the folder above, which runs.py adds

LATE = 50  # cycles


def mean_of(values):
    """Mean and standard error; nan where a value is."""
    if any(math.isnan(value) for value in values):
        return math.nan, math.nan
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.fmean(values), error


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
    return [(name, unit, *mean_of([quantity(run) for run in runs])) for name, unit, quantity in quantities]


def text(value, digits):
    return "" if math.isnan(value) else f"{value:.{digits}g}"


def put_groups(results, study, groups, campaign):
    """Means of the packings of each size, friction and spring. campaign: None for runs that runs.csv keeps."""
    for (size, friction, spring), runs in groups.items():
        for name, unit, mean, error in quantities_of(runs):
            if not math.isnan(mean):
                key = study, name, f"{size} spheres, μ = {friction:g}, {spring}"
                results.put(
                    key, unit, text(mean, 3), text(error, 2), len(runs), campaign, "runs" if campaign else "runs.csv"
                )


def put_runs(results, study, runs, campaign):
    """The numbers of each run, of campaigns over period and step."""
    for run in runs:
        case = f"seed {run.seed}, period {run.period:g} s, step {run.step:g} s"
        numbers = [(name, unit, text(value, 3)) for name, unit, value, _ in quantities_of([run])
                   if not (math.isnan(value) or "per cycle" in name)]
        results.put_numbers(study, case, numbers, campaign)


def put_frictions(results, study, campaign):
    """Means over the seeds of what the campaigns of quickstart.toml collect."""
    columns = (("contacts.coordination_number.last", "contacts per sphere after the cycle"),
               ("box.deviatoric_strain.max", "largest deviatoric strain"))
    rows = [run.row for run in runs_of(campaign, *(column for column, _ in columns), "contact.static_friction")]
    for friction in dict.fromkeys(row["contact.static_friction"] for row in rows):
        chosen = [row for row in rows if row["contact.static_friction"] == friction]
        for column, name in columns:
            mean, error = mean_of([row[column] for row in chosen])
            results.put((study, name, f"μ = {friction:g}"), "1", text(mean, 3), text(error, 2), len(chosen), campaign)
