"""Speed against error of a cyclic load by dynamics and without them, for a packing of biaxial.toml with slip.

Usage: python3 scenarios/mcnamara2008/quasi_static.py SCREE FOLDER [PACKING, default 5] [KEY=VALUE of the scenario ...]
Runs SCREE, a path or a name in PATH, with periods from 10 to 160 τ, and `SCREE quasi-static` with 10
to 640 increments a cycle, 30 cycles each or stage.cycles.cycles=N, into FOLDER; prints the strain after a cycle
and, of more than 12 cycles, the strain per cycle from cycle 10 on, with their differences from the numbers of the most increments, and draws FOLDER/quasi-static.png. Needs python3-matplotlib."""
import json
import math
import os
import shutil
import subprocess

from series import arguments, line_through, read, refuse
from style import BLUE, ORANGE, label, pyplot, save, ticker

CYCLES, DROPPED = 30, 10
CYCLES_KEY = "stage.cycles.cycles="
PERIODS = (10, 20, 40, 80, 160)  # τ
INCREMENTS = (10, 20, 40, 80, 160, 640)
SCENARIO = os.path.join(os.path.dirname(os.path.abspath(__file__)), "biaxial.toml")


def call(scree, verb, out, overrides):
    sets = [word for override in overrides for word in ("--set", override)]
    done = subprocess.run(
        [scree, *verb, "--out", out, "--overwrite", "--quiet", *sets], capture_output=True, text=True, check=False
    )
    if done.returncode:
        refuse((done.stderr.strip().splitlines() or [f"{scree} {verb[0]} ended with {done.returncode}"])[-1])


def record(folder, name):
    try:
        with open(os.path.join(folder, name), encoding="utf-8") as text:
            return json.load(text)
    except (OSError, ValueError):
        return refuse(f"{folder}: no {name}; SCREE is not the program scree")


class Load:
    """Strains at the least load of each cycle, and wall time (s) of a cycle."""

    def __init__(self, name, rows, seconds):
        x, y = float(rows[0]["length_x"]), float(rows[0]["length_y"])
        self.name, self.seconds = name, seconds
        strains = [float(r["length_y"]) / y - float(r["length_x"]) / x for r in rows]
        self.first = strains[1]
        self.slope = line_through(strains[DROPPED:])[0] if len(strains) > DROPPED + 2 else math.nan


def cycles_of(overrides):
    return next((int(o.removeprefix(CYCLES_KEY)) for o in overrides if o.startswith(CYCLES_KEY)), None)


def check(scree, packing, overrides):
    """Ends the script with one line if an argument is wrong that scree would not see or name."""
    if shutil.which(scree) is None:
        refuse(f"{scree}: there is no such program")
    if not packing.isdecimal():
        refuse(f"{packing}: a packing is a number, 1 or more")
    for override in overrides:
        if "=" not in override:
            refuse(f"{override}: not KEY=VALUE")
        if override.startswith(CYCLES_KEY) and (
            not override.removeprefix(CYCLES_KEY).isdecimal() or cycles_of([override]) < 1
        ):
            refuse(f"{override}: cycles are a number, 1 or more")


def by_dynamics(scree, folder, overrides, period):
    out = os.path.join(folder, f"period-{period}")
    keys = (
        "stage.cycles.period",
        "stage.cycles.set.box.stress_y_high.period",
        "probe.load.every",
        "probe.touching.every",
    )
    call(scree, ["run", SCENARIO], out, [*overrides, *(f"{k}={period}" for k in keys)])
    run = record(out, "run.json")
    last = run["stages"][-1]
    share = last["steps"] / sum(stage["steps"] for stage in run["stages"])
    return Load(
        f"{period} τ", read(os.path.join(out, "series", "load.csv")), run["stepping_s"] * share / cycles_of(overrides)
    )


def without_dynamics(scree, folder, overrides, increments):
    out = os.path.join(folder, f"increments-{increments}")
    verb = ["quasi-static", SCENARIO, "--increments", str(increments)]
    call(scree, verb, out, overrides)
    rows = read(os.path.join(out, "series", "quasi_static.csv"))[::increments]
    return Load(f"{increments}", rows, record(out, "quasi_static.json")["wall_s"]["all"] / cycles_of(overrides))


def draw(axes, methods, exact, value, title, unit):
    for (name, loads), colour, mark in zip(methods, (ORANGE, BLUE), "so"):
        shown = [(c, abs(value(c) / value(exact) - 1)) for c in loads]
        shown = [(c, error) for c, error in shown if error > 0]
        axes.loglog([1e3 * c.seconds for c, _ in shown], [e for _, e in shown], mark + "-", color=colour, label=name)
        for k, (c, error) in enumerate(shown):
            lowest = 0 < k < len(shown) - 1 and error < min(shown[k - 1][1], shown[k + 1][1])
            axes.annotate(
                c.name,
                (1e3 * c.seconds, error),
                textcoords="offset points",
                xytext=(-3, -14) if lowest else (8, 5),
                fontsize=8,
            )
    label(axes, title, "wall time of a cycle / ms", unit)
    axes.margins(0.2, 0.12)
    axes.xaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter("{x:g}")
    axes.xaxis.set_minor_formatter(ticker.NullFormatter())
    axes.legend(frameon=False, fontsize=9, loc="lower right")


def main(scree, folder, packing="5", *overrides):
    check(scree, packing, overrides)
    overrides = [f"scene.seed={packing}", *overrides]
    if cycles_of(overrides) is None:
        overrides.append(f"{CYCLES_KEY}{CYCLES}")
    dynamic = [by_dynamics(scree, folder, overrides, period) for period in PERIODS]
    static = [without_dynamics(scree, folder, overrides, increments) for increments in INCREMENTS]
    exact = static[-1]
    for name, loads in (("period", dynamic), ("increments", static)):
        for c in loads:
            per_cycle = "" if math.isnan(c.slope) else f", per cycle {c.slope:.5e} ({c.slope / exact.slope - 1:+.1e})"
            print(
                f"{name} {c.name:>6}: {1e3 * c.seconds:8.2f} ms a cycle, strain after the first {c.first:.6e} "
                f"({c.first / exact.first - 1:+.1e}){per_cycle}"
            )
    methods = (("dynamics, period", dynamic), ("quasi-static, increments", static[:-1]))
    values = [(lambda c: c.first, "Strain after a cycle")]
    if not math.isnan(exact.slope):
        values.append((lambda c: c.slope, f"Strain per cycle, cycles {DROPPED} to {cycles_of(overrides)}"))
    figure, axes = pyplot.subplots(1, len(values), figsize=(5.5 * len(values), 4.4), squeeze=False)
    for part, (value, title) in zip(axes[0], values):
        draw(part, methods, exact, value, f"{title}, packing {packing}", "relative difference from 640 increments")
    save(figure, folder, "quasi-static.png")


if __name__ == "__main__":
    main(*arguments(__doc__, 2, math.inf))
