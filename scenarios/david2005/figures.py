"""Draws strain accumulation over the cycles for packings of several sizes and frictions (figures 3 and 5 of David et al. 2005) and their loops
(figures 2 and 4) with each tangential spring, from a campaign of accumulation.toml, and prints their numbers: means over the seeds ± standard
error. Writes runs.csv, one row a cycle of each run, beside the pictures; runs of an earlier runs.csv there that the campaign lacks are kept and
count too, but for their loops.

Usage: python3 scenarios/david2005/figures.py campaigns/accumulation [FOLDER for pictures and table, default: that of the campaign]
Needs python3-matplotlib."""
import math
import os
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 (the choice of the backend comes first)

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from runs import SPRINGS, merged  # noqa: E402 (of this folder)
from tables import arguments, no_runs  # noqa: E402 (of the folder above)

LATE = 50  # cycles


def late_slope(run):
    """Strain per cycle from cycle LATE on, or in the second half of fewer than twice as many."""
    from_cycle = min(LATE, len(run.strain) // 2)
    cycles = len(run.strain) - 1 - from_cycle
    return (run.strain[-1] - run.strain[from_cycle]) / cycles if cycles > 0 else math.nan


def mean_of(values):
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.fmean(values), error


def groups_of(runs):
    """Runs by size, friction and spring."""
    groups = {}
    for run in runs:
        groups.setdefault((run.size, run.friction, run.spring), []).append(run)
    return dict(sorted(groups.items()))


def print_numbers(groups):
    print(f"{'spheres':>7} {'μ':>5} {'spring':14} {'seeds':>5}  {'strain after the last cycle':>28}  {'per cycle, late':>24}  {'first loop [Pa]':>20}  {'slope [kPa]':>16}")
    for (size, friction, spring), runs in groups.items():
        quantities = (lambda r: r.strain[-1], late_slope, lambda r: r.loop_area[0], lambda r: r.slope[0] / 1e3)
        numbers = [mean_of([quantity(r) for r in runs]) for quantity in quantities]
        texts = [f"{mean:.3g}" + (f" ± {error:.1g}" if len(runs) > 1 else "") for mean, error in numbers]
        print(f"{size:7} {friction:5} {spring:14} {len(runs):5}  {texts[0]:>28}  {texts[1]:>24}  {texts[2]:>20}  {texts[3]:>16}")


def plot_accumulation(axes, groups, title, name_of):
    """Means of the seeds, with standard errors after the last cycle; on a logarithmic scale where they differ widely."""
    ends = [mean_of([run.strain[-1] for run in runs])[0] for runs in groups.values()]
    if min(ends) > 0 and max(ends) > 20 * min(ends):
        axes.set_yscale("log")
    for at, (label, runs, look) in enumerate(with_looks(groups, name_of)):
        last = min(len(r.strain) for r in runs) - 1
        axes.plot(range(last + 1), [1e3 * statistics.fmean(r.strain[c] for r in runs) for c in range(last + 1)], label=label, **look)
        mean, error = mean_of([1e3 * r.strain[last] for r in runs])
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
        axes.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.tight_layout()
    figure.savefig(file, dpi=80)
    print(file)


def size_of(key):
    return f"{key[0]} spheres"


def friction_of(key):
    return f"μ = {key[1]}"


def by_size(groups):
    """Groups with the weakest friction, and that friction."""
    weakest = min(friction for _, friction, _ in groups)
    return {key: runs for key, runs in groups.items() if key[1] == weakest}, weakest


def by_friction(groups):
    """Groups of the size that has most of them, and that size."""
    size = max(groups, key=lambda key: sum(other[0] == key[0] for other in groups))[0]
    return {key: runs for key, runs in groups.items() if key[0] == size}, size


def panels_for(frictions):
    """Without a second friction one panel."""
    count = 2 if len({friction for _, friction, _ in frictions}) > 1 else 1
    return pyplot.subplots(1, count, figsize=(1 + 6.2 * count, 5), squeeze=False)


def draw_accumulation(groups, folder):
    (sizes, weakest), (frictions, compared) = by_size(groups), by_friction(groups)
    figure, [panels] = panels_for(frictions)
    plot_accumulation(panels[0], sizes, f"Size, μ = {weakest}, mean of the seeds", size_of)
    if len(panels) > 1:
        plot_accumulation(panels[1], frictions, f"Friction, {compared} spheres, mean of the seeds", friction_of)
    save(figure, panels, os.path.join(folder, "accumulation.png"))


def draw_loops(groups, folder):
    """Of runs that have their loops."""
    looped = {key: [run for run in runs if run.loops] for key, runs in groups.items()}
    looped = {key: runs for key, runs in looped.items() if runs}
    if not looped:
        return
    (sizes, weakest), (frictions, compared) = by_size(looped), by_friction(looped)
    largest = {key: runs for key, runs in sizes.items() if key[0] == max(size for size, _, _ in sizes)}
    figure, [panels] = panels_for(frictions)
    # Those of two springs would hide each other.
    spring = min((key[2] for key in largest), key=list(SPRINGS.values()).index)
    largest = {key: runs for key, runs in largest.items() if key[2] == spring}
    plot_loops(panels[0], largest, f"All cycles, {spring}, μ = {weakest}, first seed", size_of, lambda run: run.loops, 0.4)
    if len(panels) > 1:
        plot_loops(panels[1], frictions, f"First cycle, {compared} spheres, first seed", friction_of, lambda run: run.first_loop())
    save(figure, panels, os.path.join(folder, "loops.png"))


def main():
    folder, *out = arguments(__doc__, 1, 2)
    out = out[0] if out else folder
    groups = groups_of(merged(folder, os.path.join(out, "runs.csv")))
    if not groups:
        no_runs(folder, "scenarios/david2005/accumulation.toml")
    print_numbers(groups)
    draw_accumulation(groups, out)
    draw_loops(groups, out)


if __name__ == "__main__":
    main()
