"""Draws figure 2 of Lemrich et al. (2017) from a campaign of sweeps.toml, figures 3 and 4 from one of
drives.toml, the cylindrical cell beside the periodic one from one of cell.toml, and what the paper claims (claims.png)
from results.csv; prints the numbers of these and of spectra.toml, and records them in results.csv.

Usage: python3 scenarios/lemrich2017/figures.py DIR... [--out FOLDER, default: the first DIR]
DIR: a campaign, or this folder, for claims.png of what is recorded. Needs python3-matplotlib and python3-pandas."""
import math
import pathlib
import sys

PAPER = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(PAPER), str(PAPER.parents[1] / "tools" / "python")]
import scree  # noqa: E402 (of this tree)

scree.scripts.start("matplotlib", "pandas")
import numpy  # noqa: E402
from scree.charts import COLOURS, Curve, Panel, draw, labels  # noqa: E402
from cells import put_cells  # noqa: E402 (of this folder, like the next)
from spectra import NAMES, put_spectra  # noqa: E402
from sweeps import COLUMNS, Sweep, apart_at_strains, over_hertz, put_maxima  # noqa: E402

CASE = r"([\d.]+) kPa, (.*)"  # stress, and seed or drive
LAYERS_APART = 3  # of 14: the 0.214 of the height in figure 4
LARGE = {"heading": {"loc": "left", "fontsize": 11}, "legend": {"fontsize": 9}}  # texts of panels


def draw_sweeps(sweeps, path):
    """Figure 2: responses over the frequency."""
    height = sweeps[0].height()
    curves = [Curve(s.frequencies / 1e3, s.response * height, "o-", color=colour, markersize=3, linewidth=1.3,
                    label=f"{s.amplitude / height:.1e}") for s, colour in zip(sweeps, COLOURS)]
    legend = {"title": "strain of the drive", "fontsize": 9, "title_fontsize": 9, "loc": "lower left", "ncols": 2}
    least = min(min(s.response) for s in sweeps) * height
    draw(path, [Panel(f"Sweeps at rising drives, {sweeps[0].case} (figure 2)", "frequency (kHz)",
                      "strain of the layer / strain of the drive", *curves, **LARGE | {"legend": legend}, yscale="log",
                      ylim=(least / 5, None))], (8, 5), dpi=120)


def frequency_panel(title, x, y, ticks, points, scale=lambda stress, *point: point, markersize=6, **options):
    """3λ/4 over the strain (figure 3). points: stress (kPa), strain and frequency (kHz) of curves by labels."""
    curves = [Curve(*numpy.reshape([scale(1e3 * stress, *point) for stress, *point in of_curve], (-1, 2)).T, "o-",
                    color=colour, markersize=markersize, linewidth=1.2, label=label)
              for (label, of_curve), colour in zip(points.items(), COLOURS)]
    return Panel(title, x, y, *curves, xscale="log", xticks=labels(*ticks), **options)


def draw_collapse(sweeps, path):
    """Figure 3 of a campaign: plain and scaled."""
    points = {s.case: [] for s in sweeps}
    for s in (s for s in sweeps if s.resonates):
        points[s.case].append((s.stress / 1e3, s.strain, s.frequency / 1e3))
    plain = frequency_panel("Peaks 3λ/4 under four stresses (figure 3)", "local strain", "frequency of 3λ/4 (kHz)",
                            (2e-5, 5e-5, 1e-4, 2e-4, 5e-4), points, **LARGE)
    scaled = frequency_panel("The same, scaled after Hertz", r"local strain · $(\sigma/Y)^{-2/3}$",
                             r"frequency · $(\sigma/Y)^{-1/6}$ (kHz)", (0.3, 0.5, 1, 2, 4), points, over_hertz,
                             **LARGE | {"legend": None})
    draw(path, [plain, scaled], (11, 5), dpi=120)


def draw_profile(sweeps, path):
    """Figure 4: strain between layers 0.214 of the height apart, of three drives and of the ideal mode."""
    curves = []
    for sweep, colour in zip(sweeps, (COLOURS[0], COLOURS[3], COLOURS[4])):
        strains = abs(sweep.layers[LAYERS_APART:] - sweep.layers[:-LAYERS_APART])
        heights = (numpy.arange(len(strains)) + 0.5 + LAYERS_APART / 2) / len(sweep.layers)
        curves.append(Curve(strains / max(strains), heights, "o-", color=colour, markersize=4, linewidth=1.2,
                            label=f"{sweep.amplitude:.0e} m, {sweep.frequency / 1e3:.1f} kHz"))
    # Of the mode 3λ/4 with a free lower end, cos(3π h/2).
    half, wave = LAYERS_APART / 14 / 2, 1.5 * math.pi
    heights = numpy.linspace(half, 1 - half, 201)
    strains = abs(numpy.cos(wave * (heights + half)) - numpy.cos(wave * (heights - half)))
    ideal = Curve(strains / max(strains), heights, color="black", linewidth=1.2, label="3λ/4")
    panel = Panel(f"Strain over the height at the peak, {sweeps[0].case} (figure 4)", "local strain / the largest",
                  "height / height of the packing", *curves, ideal, legend={"fontsize": 9}, ylim=(0, 1))
    draw(path, [panel], (5.5, 6), dpi=120)


def modes_panel(numbers):
    curves = []
    for name, colour in zip(NAMES.values(), COLOURS):
        found = numbers.over("spectra", f"frequency of {name}", CASE)
        points = sorted((float(stress), frequency) for (stress, _), frequency in found.items())
        if points:
            stresses = sorted({stress for stress, _ in points})
            middle = sum(frequency * stress ** (-1 / 6) for stress, frequency in points) / len(points)
            curves += [Curve(*zip(*points), "o", markersize=4, fillstyle="none", color=colour, label=name),
                       Curve(stresses, [middle * s ** (1 / 6) for s in stresses], color=colour, linewidth=0.9)]
    return Panel("Linear modes, four packings a stress;\nlines: f ∝ σ$^{1/6}$", "confining stress / kPa",
                 "frequency / kHz", *curves, legend={"loc": "lower right"}, xscale="log", yscale="log",
                 xticks=labels(10, 22, 55, 113), yticks=labels(5, 10, 20, 50))


def draw_claims(numbers, path):
    """Modes over the stress, and figure 3, from the rows of results.csv."""
    strains = numbers.over("drives", "local strain at the maximum", CASE)
    frequencies = numbers.over("drives", "frequency of the maximum", CASE)
    points = {}
    for case in sorted(strains.keys() & frequencies, key=lambda case: (float(case[0]), strains[case])):
        points.setdefault(f"{case[0]} kPa", []).append((float(case[0]), strains[case], frequencies[case]))
    options = {"legend": {"loc": "lower left"}, "markersize": 5, "ylim": (0, None)}
    plain = frequency_panel("Rising drives under four stresses\n(figure 3, above)", "local strain",
                            "frequency of 3λ/4 / kHz", (5e-5, 1e-4, 2e-4), points, **options)
    scaled = frequency_panel("The same, scaled after Hertz\n(figure 3, below)",
                             r"local strain $\cdot\ (\sigma/Y)^{-2/3}$",
                             r"frequency of 3λ/4 $\cdot\ (\sigma/Y)^{-1/6}$ / kHz", (0.5, 1, 2), points, over_hertz,
                             **options)
    print(draw(path, [modes_panel(numbers), plain, scaled], (13, 4.2)))


def evaluate(campaign, out, numbers):
    """Draws and records a campaign; nothing of this folder, whose numbers are recorded."""
    if campaign.path.resolve() == PAPER:
        return None
    if campaign.study == "spectra":
        return put_spectra(campaign, numbers)
    if campaign.study == "cell":
        return put_cells(campaign, numbers, out / "cell.png")
    sweeps = sorted(map(Sweep, campaign.finished(*COLUMNS)), key=lambda s: (s.stress, s.amplitude))
    if not sweeps:
        raise scree.scripts.no_runs(campaign, "scenarios/lemrich2017/sweeps.toml, drives.toml or spectra.toml")
    put_maxima(sweeps, campaign.study, campaign, numbers)
    numbers.print()
    if campaign.study == "sweeps":
        return draw_sweeps(sweeps, out / "sweeps.png")
    for name, strain, count, share in apart_at_strains(sweeps):
        row = "range of the frequencies over their mean", "%", f"{100 * share:.1f}"
        numbers.put("drives", f"{name} = {strain:g}", [row], campaign, count)
    numbers.print()
    draw_collapse(sweeps, out / "collapse.png")
    shaped = [s for s in sweeps if s.stress == sweeps[0].stress and len(s.layers)]
    if shaped:
        draw_profile([shaped[0], shaped[len(shaped) // 2], shaped[-1]], out / "profile.png")
    return None


if __name__ == "__main__":
    out, numbers = scree.scripts.record(__doc__, PAPER, evaluate)
    draw_claims(numbers, out / "claims.png")
