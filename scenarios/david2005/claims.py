"""What David et al. (2005) claim, as the numbers of this folder have it: accumulation over size (figure 3), and
over friction (figures 4 and 5)."""
import os
import statistics

from runs import SPRINGS
from drawing import pyplot, ticker  # of the folder above, which runs.py adds

FRICTIONS = (0.1, 0.15, 0.2, 0.25, 0.5)
COLOURS = ("#1b3a6b", "#2a7ab0", "#49a078", "#d98e04", "#c0392b")
DAVID = SPRINGS["linear_spring_dashpot"]


def over_friction(results, study, quantity, size):
    """Frictions, values and errors of the packings that are loaded with spring DAVID."""
    found = [
        (friction, results.value(study, quantity, f"{size} spheres, μ = {friction:g}, {DAVID}"))
        for friction in FRICTIONS
    ]
    return list(zip(*((friction, *value) for friction, value in found if value)))


def plot_sizes(axes, groups):
    sizes = sorted({size for size, _, _ in groups})
    for (size, _, spring), runs in groups.items():
        last, solid = min(len(run.strain) for run in runs), spring == DAVID
        means = [1e3 * statistics.fmean(run.strain[cycle] for run in runs) for cycle in range(last)]
        axes.plot(range(last), means, "-" if solid else "--", color=COLOURS[sizes.index(size) % len(COLOURS)],
                  linewidth=1.3, label=f"{size} spheres" if solid else None)
    axes.set(ylim=(0, None), xlabel="cycle", ylabel="deviatoric strain at the least load / 10⁻³")
    axes.set_title("Size (figure 3), μ = 0.1\ndashed: path-independent springs", loc="left", fontsize=10)
    axes.legend(frameon=False, fontsize=8, loc="lower right")


def plot_frictions(axes, curves, title, y, legend):
    """legend: where it stands, as shares of the axes."""
    for (label, points), colour in zip(curves, (COLOURS[0], COLOURS[3])):
        if points:
            axes.errorbar(*points[:2], yerr=points[2], marker="o", markersize=5, capsize=3, linewidth=1.2, color=colour,
                          label=label)
    axes.set(xlabel="friction of the load", ylabel=y)
    axes.set_title(title, loc="left", fontsize=10)
    axes.legend(frameon=False, fontsize=8, loc="lower right", bbox_to_anchor=legend)
    axes.xaxis.set_major_locator(ticker.FixedLocator(FRICTIONS))


def draw_claims(sizes, results, folder):
    """sizes: runs by size, friction and spring, of one friction."""
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(13, 4.2))
    plot_sizes(left, sizes)
    strain = "strain after 100 cycles"
    curves = (("1000 spheres, the same packings", over_friction(results, "same-packings", strain, 1000)),
              ("1728 spheres, each prepared with its friction", over_friction(results, "accumulation", strain, 1728)))
    plot_frictions(middle, curves, "Friction (figure 5)", strain, (1, 0.55))
    middle.set_yscale("log")
    slope = "slope of the first loop"
    curves = (("1728 spheres, the same packings", over_friction(results, "first-cycle", slope, 1728)),
              ("1728 spheres, each prepared with its friction", over_friction(results, "accumulation", slope, 1728)))
    plot_frictions(right, curves, "Friction (figure 4)", slope + " / kPa", (1, 0.02))
    right.set_ylim(bottom=0)
    for axes in (left, middle, right):
        axes.grid(color="#eeeeee")
    figure.tight_layout()
    path = os.path.join(folder, "claims.png")
    figure.savefig(path, dpi=80)
    print(path)
