"""Draws strain accumulation over the cycles (figures 3 and 5 of David et al. 2005) and the first loop (figure 4) with each tangential
spring, from a campaign of laws.toml or sizes.toml, and prints their numbers: means over the seeds ± standard error.

Usage: python3 scenarios/david2005/figures.py campaigns/laws [FOLDER for the picture, default: that of the campaign]
Needs python3-matplotlib."""
import math
import os
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 (the choice of the backend comes first)

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import no_runs, read, runs_of, scenario_of  # noqa: E402 (of the folder above)

SPRINGS = {"linear_spring_dashpot": "David et al.", "sphere_path_independent": "painted points"}
PLUGIN, FRICTION, COUNT = "contact.grains.plugin", "contact.grains.static_friction", "particles.lattice.count"
LATE = 50  # cycles from which the slope is taken, if there are more


class Run:
    """Deviatoric strain and stress of a run over its cycles."""

    def __init__(self, path):
        rows = read(os.path.join(path, "series", "box.csv"))
        times, self.strain, self.stress = ([float(r[c]) for r in rows] for c in ("time", "deviatoric_strain", "deviatoric_stress"))
        self.per_cycle = round(scenario_of(path)["stage"][-1]["period"] / (times[1] - times[0]))
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
        """Strain per cycle in the second half."""
        from_cycle = min(LATE, len(self.accumulated) // 2)
        return (self.accumulated[-1] - self.accumulated[from_cycle]) / (len(self.accumulated) - 1 - from_cycle)


def mean_of(values):
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.fmean(values), error


def groups_of(folder):
    """Runs by what varies beside the seed and the spring, and by the spring."""
    groups = {}
    for row in runs_of(folder):
        varied = f"μ = {row[FRICTION]}" if FRICTION in row else f"N = {math.prod(int(n) for n in row[COUNT].strip('[]').split(','))}" if COUNT in row else ""
        groups.setdefault(varied, {}).setdefault(row[PLUGIN], []).append(Run(row["path"]))
    return groups


def print_numbers(groups):
    print(f"{'':12} {'spring':16} {'seeds':>5}  {'strain after the last cycle':>28}  {'per cycle, second half':>24}  {'first loop [Pa]':>20}  {'slope [kPa]':>16}")
    for varied, springs in groups.items():
        for plugin, runs in springs.items():
            numbers = [mean_of([f(r) for r in runs]) for f in (lambda r: r.accumulated[-1], Run.late_slope, Run.loop_area, lambda r: r.stiffness() / 1e3)]
            texts = [f"{mean:.3g} ± {error:.1g}" for mean, error in numbers]
            print(f"{varied:12} {SPRINGS[plugin]:16} {len(runs):5}  {texts[0]:>28}  {texts[1]:>24}  {texts[2]:>20}  {texts[3]:>16}")


def draw(groups, file):
    figure, (accumulation, loops) = pyplot.subplots(1, 2, figsize=(11, 4.6))
    colours = pyplot.get_cmap("viridis")
    for k, (varied, springs) in enumerate(groups.items()):
        colour = colours(0.9 * k / max(len(groups) - 1, 1))
        for plugin, runs in springs.items():
            style = "-" if plugin == "linear_spring_dashpot" else "--"
            cycles = range(min(len(r.accumulated) for r in runs))
            means = [mean_of([1e3 * r.accumulated[c] for r in runs]) for c in cycles]
            text = ", ".join(part for part in (varied, SPRINGS[plugin]) if part)
            accumulation.plot(cycles, [m for m, _ in means], style, color=colour, label=text)
            if len(runs) > 1:
                low, high = ([m + sign * e for m, e in means] for sign in (-1, 1))
                accumulation.fill_between(cycles, low, high, color=colour, alpha=0.15, linewidth=0)
            strain, stress = runs[0].first_loop()
            loops.plot([1e3 * e for e in strain], stress, style, color=colour)
    accumulation.set(title="Strain at the least load, mean of the seeds", xlabel="cycle", ylabel="deviatoric strain / 10⁻³")
    loops.set(title="First cycle, first seed", xlabel="deviatoric strain / 10⁻³", ylabel="deviatoric stress / Pa")
    for axes in (accumulation, loops):
        axes.grid(color="#eeeeee")
    accumulation.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(file, dpi=80)
    print(file)


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) in (2, 3) else 2
    groups = groups_of(sys.argv[1])
    if not groups:
        no_runs(sys.argv[1], "scenarios/david2005/laws.toml")
    print_numbers(groups)
    draw(groups, os.path.join(sys.argv[2] if len(sys.argv) == 3 else sys.argv[1], "accumulation.png"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
