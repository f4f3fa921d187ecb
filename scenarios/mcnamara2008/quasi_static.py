"""Speed against error of a cyclic load by dynamics and without them, for a packing of biaxial.toml with slip.

Usage: python3 scenarios/mcnamara2008/quasi_static.py SCREE FOLDER [PACKING, default 5] [KEY=VALUE of the scenario ...]
Runs SCREE, a path or a name in PATH, with periods from 10 to 160 τ, and `SCREE quasi-static` with 10
to 640 increments a cycle, 30 cycles each or stage.cycles.cycles=N, into FOLDER; prints the strain after a cycle
and, of more than 12 cycles, the strain per cycle from cycle 10 on, with their differences from the numbers of the most
increments, and draws FOLDER/quasi-static.png. Needs python3-matplotlib and python3-pandas."""
import math
import os
import pathlib
import sys

PAPER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(PAPER.parents[1] / "tools" / "python"))
import scree  # noqa: E402 (of this tree)

scree.scripts.start("matplotlib", "pandas")
from scree.charts import BLUE, ORANGE, Curve, Panel, draw  # noqa: E402
from scree.fits import line_through  # noqa: E402
from series import strain_of  # noqa: E402 (of this folder)

DROPPED = 10
CYCLES_KEY = "stage.cycles.cycles"
PERIODS = (10, 20, 40, 80, 160)  # τ
INCREMENTS = (10, 20, 40, 80, 160, 640)
SCENARIO = PAPER / "biaxial.toml"
PERIOD_KEYS = ("stage.cycles.period", "stage.cycles.set.box.stress_y_high.period", "probe.load.every",
               "probe.touching.every")


class Load:
    """Strains at the least load of each cycle, and wall time (s) of a cycle."""

    def __init__(self, name, rows, seconds):
        self.name, self.seconds = name, seconds
        strains = strain_of(rows)
        self.first = strains[1]
        self.slope = line_through(strains[DROPPED:])[0] if len(strains) > DROPPED + 2 else math.nan


def by_dynamics(folder, values, period):
    """The load with a period (τ) by dynamics."""
    out = os.path.join(folder, f"period-{period}")
    run = scree.run(SCENARIO, values | dict.fromkeys(PERIOD_KEYS, period), out, overwrite=True)
    share = run.stages[-1]["steps"] / sum(stage["steps"] for stage in run.stages)
    return Load(f"{period} τ", run.series["load"], run.record["stepping_s"] * share / values[CYCLES_KEY])


def without_dynamics(folder, values, increments):
    """The load in a number of increments a cycle."""
    out = os.path.join(folder, f"increments-{increments}")
    load = scree.study("quasi-static", SCENARIO, values, out, overwrite=True, increments=increments)
    rows = load.series["quasi_static"][::increments].reset_index()
    return Load(f"{increments}", rows, load.record["wall_s"]["all"] / values[CYCLES_KEY])


def panel(title, methods, exact, value):
    """Relative differences of a value over the wall time, with the name of each load."""
    curves = []
    for (method, loads), colour, mark in zip(methods.items(), (ORANGE, BLUE), "so"):
        errors = {load: abs(value(load) / value(exact) - 1) for load in loads}
        shown = [load for load in loads if errors[load] > 0]
        curves.append(Curve([1e3 * load.seconds for load in shown], [errors[load] for load in shown], mark + "-",
                            color=colour, label=method, names=[load.name for load in shown]))
    return Panel(title, "wall time of a cycle / ms", "relative difference from 640 increments", *curves,
                 lambda axes: axes.margins(0.2, 0.12), legend={"fontsize": 9, "loc": "lower right"}, xscale="log",
                 yscale="log", xticks="1 2 5")


def main(program, folder, packing="5", *words):
    values = scree.values.overrides([f"scene.seed={packing}", f"{CYCLES_KEY}=30", *words])
    os.environ["SCREE_PROGRAM"] = program
    dynamic = [by_dynamics(folder, values, period) for period in PERIODS]
    *static, exact = [without_dynamics(folder, values, increments) for increments in INCREMENTS]
    for name, loads in (("period", dynamic), ("increments", [*static, exact])):
        for load in loads:
            first = f"strain after the first {load.first:.6e} ({load.first / exact.first - 1:+.1e})"
            slope = f", per cycle {load.slope:.5e} ({load.slope / exact.slope - 1:+.1e})"
            print(f"{name} {load.name:>6}: {1e3 * load.seconds:8.2f} ms a cycle, {first}"
                  f"{'' if math.isnan(load.slope) else slope}")
    methods = {"dynamics, period": dynamic, "quasi-static, increments": static}
    panels = [panel(f"Strain after a cycle, packing {packing}", methods, exact, lambda load: load.first)]
    if not math.isnan(exact.slope):
        title = f"Strain per cycle, cycles {DROPPED} to {values[CYCLES_KEY]}, packing {packing}"
        panels.append(panel(title, methods, exact, lambda load: load.slope))
    print(draw(pathlib.Path(folder, "quasi-static.png"), panels, (5.5 * len(panels), 4.4)))


if __name__ == "__main__":
    main(*scree.scripts.arguments(__doc__, 2, math.inf))
