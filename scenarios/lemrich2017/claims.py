"""What Lemrich et al. (2017) claim, as the rows of results.csv have it: modes over the stress, and 3λ/4 over
the strain, plain and scaled (figure 3)."""
import os
import re

from exponent import NAMES
from drawing import pyplot, ticker  # of the folder above, which figures.py adds

MODULUS = 65e9  # Pa, of the beads
COLOURS = ("#1b3a6b", "#2a7ab0", "#49a078", "#d98e04", "#c0392b", "#7d3c98")


def numbers_of(results, study, quantity):
    """Stress (kPa), the rest of the case, and the number, of all rows."""
    for key in list(results.rows):
        case, value = re.fullmatch(r"([\d.]+) kPa, (.*)", key[2]), results.value(*key)
        if key[:2] == (study, quantity) and case and value:
            yield float(case[1]), case[2], value[0]


def plot_modes(axes, results):
    for (wavelengths, name), colour in zip(NAMES.items(), COLOURS):
        points = sorted(
            (stress, frequency) for stress, _, frequency in numbers_of(results, "spectra", f"frequency of {name}")
        )
        if points:
            axes.loglog(*zip(*points), "o", markersize=4, fillstyle="none", color=colour, label=name)
            stresses = sorted({stress for stress, _ in points})
            middle = sum(frequency * stress ** (-1 / 6) for stress, frequency in points) / len(points)
            axes.plot(stresses, [middle * stress ** (1 / 6) for stress in stresses], color=colour, linewidth=0.9)
    axes.set_title("Linear modes, four packings a stress;\nlines: f ∝ σ$^{1/6}$", loc="left", fontsize=10)
    axes.set(xlabel="confining stress / kPa", ylabel="frequency / kHz")
    axes.set_xticks((10, 22, 55, 113), ("10", "22", "55", "113"))
    axes.set_yticks((5, 10, 20, 50), ("5", "10", "20", "50"))


def plot_drives(axes, results, scaled):
    strains = {(stress, drive): strain for stress, drive,
               strain in numbers_of(results, "drives", "local strain at the maximum")}
    curves = {}
    for stress, drive, frequency in numbers_of(results, "drives", "frequency of the maximum"):
        if (stress, drive) in strains:
            share = stress * 1e3 / MODULUS if scaled else 1
            curves.setdefault(stress, []).append(
                (strains[stress, drive] * share ** (-2 / 3), frequency * share ** (-1 / 6))
            )
    for (stress, points), colour in zip(sorted(curves.items()), COLOURS):
        axes.plot(*zip(*sorted(points)), "o-", color=colour, markersize=5, linewidth=1.2, label=f"{stress:g} kPa")
    axes.set(xscale="log", ylim=(0, None))
    axes.set_xlabel(r"local strain $\cdot\ (\sigma/Y)^{-2/3}$" if scaled else "local strain")
    axes.set_ylabel(r"frequency of 3λ/4 $\cdot\ (\sigma/Y)^{-1/6}$ / kHz" if scaled else "frequency of 3λ/4 / kHz")
    axes.set_title(
        "The same, scaled after Hertz\n(figure 3, below)"
        if scaled
        else "Rising drives under four stresses\n(figure 3, above)",
        loc="left",
        fontsize=10,
    )
    ticks = (0.5, 1, 2) if scaled else (5e-5, 1e-4, 2e-4)
    axes.set_xticks(ticks, [f"{tick:g}" if scaled else f"{tick:.0e}" for tick in ticks])


def draw_claims(results, folder):
    figure, panels = pyplot.subplots(1, 3, figsize=(13, 4.2))
    plot_modes(panels[0], results)
    plot_drives(panels[1], results, False)
    plot_drives(panels[2], results, True)
    for axes in panels:
        axes.xaxis.set_minor_formatter(ticker.NullFormatter())
        axes.yaxis.set_minor_formatter(ticker.NullFormatter())
        axes.legend(frameon=False, fontsize=8, loc="lower right" if axes is panels[0] else "lower left")
        axes.grid(color="#eeeeee")
    figure.tight_layout()
    path = os.path.join(folder, "claims.png")
    figure.savefig(path, dpi=80)
    print(path)
