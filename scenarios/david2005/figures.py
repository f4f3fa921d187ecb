"""Draws strain accumulation over the cycles for packings of several sizes and frictions (figures 3 and 5 of David et al. 2005) and their loops
(figures 2 and 4) with each tangential spring, from a campaign of accumulation.toml, and prints their numbers: means over the seeds ± standard
error.

Usage: python3 scenarios/david2005/figures.py campaigns/accumulation [FOLDER for the pictures, default: that of the campaign]
Needs python3-matplotlib."""
import math
import os
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 (the choice of the backend comes first)

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import arguments, no_runs, read, runs_of, scenario_of  # noqa: E402 (of the folder above)

SPRINGS = {"linear_spring_dashpot": "David et al.", "sphere_path_independent": "painted points"}
LATE = 50  # cycles


class Run:
    """Deviatoric strain and stress of a run over its cycles."""

    def __init__(self, path):
        scenario = scenario_of(path)
        self.size = math.prod(scenario["particles"]["lattice"]["count"])
        self.friction = scenario["contact"][0]["static_friction"]
        self.spring = SPRINGS[scenario["contact"][0]["plugin"]]
        rows = read(os.path.join(path, "series", "box.csv"))
        times, self.strain, self.stress = ([float(r[c]) for r in rows] for c in ("time", "deviatoric_strain", "deviatoric_stress"))
        self.per_cycle = round(scenario["stage"][-1]["period"] / (times[1] - times[0]))
        self.accumulated = self.strain[:: self.per_cycle]

    def first_loop(self):
        return self.strain[: self.per_cycle + 1], self.stress[: self.per_cycle + 1]

    def loop_area(self):
        """∮ σ dε of the first cycle (Pa)."""
        strain, stress = self.first_loop()
        return sum((a + b) / 2 * (d - c) for a, b, c, d in zip(stress, stress[1:], strain, strain[1:]))

    def stiffness(self):
        """Slope between the extreme points of the first cycle (Pa)."""
        strain, stress = self.first_loop()
        top = max(range(len(stress)), key=stress.__getitem__)
        return (stress[top] - stress[0]) / (strain[top] - strain[0])

    def late_slope(self):
        """Strain per cycle from cycle LATE on, or in the second half of fewer than twice as many."""
        from_cycle = min(LATE, len(self.accumulated) // 2)
        cycles = len(self.accumulated) - 1 - from_cycle
        return (self.accumulated[-1] - self.accumulated[from_cycle]) / cycles if cycles > 0 else math.nan


def mean_of(values):
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.fmean(values), error


def groups_of(folder):
    """Runs by size, friction and spring."""
    groups = {}
    for run in (Run(row["path"]) for row in runs_of(folder)):
        groups.setdefault((run.size, run.friction, run.spring), []).append(run)
    return dict(sorted(groups.items()))


def print_numbers(groups):
    print(f"{'spheres':>7} {'μ':>5} {'spring':14} {'seeds':>5}  {'strain after the last cycle':>28}  {'per cycle, late':>24}  {'first loop [Pa]':>20}  {'slope [kPa]':>16}")
    for (size, friction, spring), runs in groups.items():
        quantities = (lambda r: r.accumulated[-1], Run.late_slope, Run.loop_area, lambda r: r.stiffness() / 1e3)
        numbers = [mean_of([quantity(r) for r in runs]) for quantity in quantities]
        texts = [f"{mean:.3g} ± {error:.1g}" for mean, error in numbers]
        print(f"{size:7} {friction:5} {spring:14} {len(runs):5}  {texts[0]:>28}  {texts[1]:>24}  {texts[2]:>20}  {texts[3]:>16}")


def plot_accumulation(axes, groups, title, name_of):
    """Means of the seeds, with standard errors after the last cycle."""
    for at, (label, runs, look) in enumerate(with_looks(groups, name_of)):
        last = min(len(r.accumulated) for r in runs) - 1
        axes.plot(range(last + 1), [1e3 * statistics.fmean(r.accumulated[c] for r in runs) for c in range(last + 1)], label=label, **look)
        mean, error = mean_of([1e3 * r.accumulated[last] for r in runs])
        error = None if math.isnan(error) else error
        # Beside one another.
        fill = "none" if look["linestyle"] == "--" else "full"
        axes.errorbar(last * (1.02 + 0.012 * at), mean, yerr=error, marker="o", markersize=4, fillstyle=fill, capsize=2, **look)
    axes.set(title=title, xlabel="cycle", ylabel="deviatoric strain at the least load / 10⁻³")


def plot_loops(axes, groups, title, name_of, loop_of, width=1.2):
    for label, runs, look in with_looks(groups, name_of):
        strain, stress = loop_of(runs[0])
        axes.plot([1e3 * e for e in strain], stress, label=label, **(look | {"linewidth": width}))
    axes.set(title=title, xlabel="deviatoric strain / 10⁻³", ylabel="deviatoric stress / Pa")


def with_looks(groups, name_of):
    """Groups with a colour for each name and a style for each spring; with a label where a name is new."""
    names = list(dict.fromkeys(name_of(key) for key in groups))
    colours, labelled = pyplot.get_cmap("viridis"), set()
    for key, runs in groups.items():
        name = name_of(key)
        colour = colours(0.9 * names.index(name) / max(len(names) - 1, 1))
        style = "-" if key[2] == SPRINGS["linear_spring_dashpot"] else "--"
        yield None if name in labelled else name, runs, {"color": colour, "linestyle": style, "linewidth": 1.2}
        labelled.add(name)


def save(figure, panels, file):
    figure.suptitle("Tangential springs: solid lines that of David et al., dashed lines painted points", fontsize=10)
    for axes in panels:
        axes.grid(color="#eeeeee")
        axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(file, dpi=80)
    print(file)


def draw(groups, folder):
    weakest = min(friction for _, friction, _ in groups)
    sizes = {key: runs for key, runs in groups.items() if key[1] == weakest}
    # Frictions are compared in one size, that of most groups.
    compared = max(groups, key=lambda key: sum(other[0] == key[0] for other in groups))[0]
    frictions = {key: runs for key, runs in groups.items() if key[0] == compared}
    largest = {key: runs for key, runs in sizes.items() if key[0] == max(size for size, _, _ in sizes)}

    def size_of(key):
        return f"{key[0]} spheres"

    def friction_of(key):
        return f"μ = {key[1]}"

    # Without other frictions one panel each.
    count = 2 if len({friction for _, friction, _ in frictions}) > 1 else 1
    figure, panels = pyplot.subplots(1, count, figsize=(1 + 5.5 * count, 5), squeeze=False)
    plot_accumulation(panels[0][0], sizes, f"Size, μ = {weakest}, mean of the seeds", size_of)
    if count > 1:
        plot_accumulation(panels[0][1], frictions, f"Friction, {compared} spheres, mean of the seeds", friction_of)
    save(figure, panels[0], os.path.join(folder, "accumulation.png"))

    figure, panels = pyplot.subplots(1, count, figsize=(1 + 5.5 * count, 5), squeeze=False)
    plot_loops(panels[0][0], largest, f"All cycles, μ = {weakest}, first seed", size_of, lambda run: (run.strain, run.stress), 0.4)
    if count > 1:
        plot_loops(panels[0][1], frictions, f"First cycle, {compared} spheres, first seed", friction_of, Run.first_loop)
    save(figure, panels[0], os.path.join(folder, "loops.png"))


def main():
    folder, *out = arguments(__doc__, 1, 2)
    groups = groups_of(folder)
    if not groups:
        no_runs(folder, "scenarios/david2005/accumulation.toml")
    print_numbers(groups)
    draw(groups, *(out or [folder]))


if __name__ == "__main__":
    main()
