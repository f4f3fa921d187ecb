"""Speed against error of a cyclic load by dynamics and without them, for a packing of biaxial.toml with slip.

Usage: python3 scenarios/mcnamara2008/quasi_static.py SCREE FOLDER [PACKING, default 5] [KEY=VALUE of the scenario ...]
Runs SCREE, a path or a name in PATH, with periods from 10 to 160 τ, and `SCREE quasi-static` with 10
to 640 increments a cycle, 30 cycles each or stage.cycles.cycles=N, into FOLDER; prints the strain after a cycle
and, of more than 12 cycles, the strain per cycle from cycle 10 on, with their differences from the numbers of the most
increments, and draws FOLDER/quasi-static.png. Needs python3-matplotlib and python3-pandas."""
import math
import os
import tomllib

from series import arguments, line_through, refuse, scree, strain_of
from style import BLUE, ORANGE, label, pyplot, save, ticker

CYCLES, DROPPED = 30, 10
CYCLES_KEY = "stage.cycles.cycles"
PERIODS = (10, 20, 40, 80, 160)  # τ
INCREMENTS = (10, 20, 40, 80, 160, 640)
SCENARIO = os.path.join(os.path.dirname(os.path.abspath(__file__)), "biaxial.toml")


class Load:
    """Strains at the least load of each cycle, and wall time (s) of a cycle."""

    def __init__(self, name, rows, seconds):
        self.name, self.seconds = name, seconds
        strains = strain_of(rows)
        self.first = strains[1]
        self.slope = line_through(strains[DROPPED:])[0] if len(strains) > DROPPED + 2 else math.nan


def values_of(overrides):
    """KEY=VALUE by key, numbers as numbers. Ends the script with one line if cycles are none, or there is no "="."""
    values = {CYCLES_KEY: CYCLES}
    for override in overrides:
        key, sign, value = override.partition("=")
        if not sign:
            refuse(f"{override}: not KEY=VALUE")
        try:
            values |= tomllib.loads(f'"{key}" = {value}')
        except tomllib.TOMLDecodeError:
            values[key] = value
    if not isinstance(values[CYCLES_KEY], int) or values[CYCLES_KEY] < 1:
        refuse(f"{CYCLES_KEY}={values[CYCLES_KEY]}: cycles are a number, 1 or more")
    return values


def by_dynamics(folder, values, period):
    """The load with a period (τ) by dynamics."""
    keys = ("stage.cycles.period", "stage.cycles.set.box.stress_y_high.period", "probe.load.every",
            "probe.touching.every")
    out = os.path.join(folder, f"period-{period}")
    run = scree.run(SCENARIO, values | dict.fromkeys(keys, period), out, overwrite=True)
    share = run.stages[-1]["steps"] / sum(stage["steps"] for stage in run.stages)
    return Load(f"{period} τ", run.series["load"], run.record["stepping_s"] * share / values[CYCLES_KEY])


def without_dynamics(folder, values, increments):
    """The load in a number of increments a cycle."""
    out = os.path.join(folder, f"increments-{increments}")
    load = scree.study("quasi-static", SCENARIO, values, out, overwrite=True, increments=increments)
    rows = load.series["quasi_static"][::increments].reset_index()
    return Load(f"{increments}", rows, load.record["wall_s"]["all"] / values[CYCLES_KEY])


def draw(axes, methods, exact, value, title, unit):
    for (name, loads), colour, mark in zip(methods, (ORANGE, BLUE), "so"):
        shown = [(c, abs(value(c) / value(exact) - 1)) for c in loads]
        shown = [(c, error) for c, error in shown if error > 0]
        axes.loglog([1e3 * c.seconds for c, _ in shown], [e for _, e in shown], mark + "-", color=colour, label=name)
        for k, (c, error) in enumerate(shown):
            lowest = 0 < k < len(shown) - 1 and error < min(shown[k - 1][1], shown[k + 1][1])
            axes.annotate(c.name, (1e3 * c.seconds, error), textcoords="offset points",
                          xytext=(-3, -14) if lowest else (8, 5), fontsize=8)
    label(axes, title, "wall time of a cycle / ms", unit)
    axes.margins(0.2, 0.12)
    axes.xaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter(ticker.NullFormatter())
    axes.legend(frameon=False, fontsize=9, loc="lower right")


def main(program, folder, packing="5", *overrides):
    if not packing.isdecimal():
        refuse(f"{packing}: a packing is a number, 1 or more")
    values = {"scene.seed": int(packing)} | values_of(overrides)
    os.environ["SCREE_PROGRAM"] = program
    dynamic = [by_dynamics(folder, values, period) for period in PERIODS]
    static = [without_dynamics(folder, values, increments) for increments in INCREMENTS]
    exact = static[-1]
    for name, loads in (("period", dynamic), ("increments", static)):
        for c in loads:
            per_cycle = "" if math.isnan(c.slope) else f", per cycle {c.slope:.5e} ({c.slope / exact.slope - 1:+.1e})"
            print(
                f"{name} {c.name:>6}: {1e3 * c.seconds:8.2f} ms a cycle, strain after the first {c.first:.6e} "
                f"({c.first / exact.first - 1:+.1e}){per_cycle}"
            )
    methods = (("dynamics, period", dynamic), ("quasi-static, increments", static[:-1]))
    drawn = [(lambda c: c.first, "Strain after a cycle")]
    if not math.isnan(exact.slope):
        drawn.append((lambda c: c.slope, f"Strain per cycle, cycles {DROPPED} to {values[CYCLES_KEY]}"))
    figure, axes = pyplot.subplots(1, len(drawn), figsize=(5.5 * len(drawn), 4.4), squeeze=False)
    for part, (value, title) in zip(axes[0], drawn):
        draw(part, methods, exact, value, f"{title}, packing {packing}", "relative difference from 640 increments")
    save(figure, folder, "quasi-static.png")


if __name__ == "__main__":
    main(*arguments(__doc__, 2, math.inf))
