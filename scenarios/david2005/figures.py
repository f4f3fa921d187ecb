"""Draws cyclic loading of packings of several sizes and frictions, and records its numbers (David et al. 2005):
claims.png, of figures 3 to 5; of each campaign its strain over the cycles (accumulation.png for
accumulation.toml) and its loops (loops.png); results.csv, means over the seeds and standard errors. Of
accumulation.toml also runs.csv, one row a cycle of each run; runs of an earlier runs.csv there that the
campaign lacks are kept and count too, but for their loops. Of rates.toml and of the campaigns of
quickstart.toml it records numbers alone.

Usage: python3 scenarios/david2005/figures.py DIR... [--out FOLDER, default: the first DIR]
DIR: a campaign of this folder, or this folder, for the runs that its runs.csv keeps. Needs python3-matplotlib
and python3-pandas."""
import itertools
import pathlib
import sys

PAPER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(PAPER.parents[1] / "tools" / "python"))
import scree  # noqa: E402 (of this tree)

scree.scripts.start("matplotlib", "pandas")
import numpy  # noqa: E402
from scree.charts import COLOURS, Curve, Panel, draw, shades  # noqa: E402
from runs import DAVID, kept_runs, merged, put_frictions, put_groups, put_runs, runs_at  # noqa: E402 (of this folder)

TABLE, KEPT = "runs.csv", "accumulation"  # the campaign whose runs the table keeps
FRICTIONS = (0.1, 0.15, 0.2, 0.25, 0.5)
OUTSIDE = {"legend": {"loc": "center left", "bbox_to_anchor": (1, 0.5)}, "heading": {}}  # of panels


def groups_of(runs):
    """Runs by size, friction and spring."""
    def kind(run):
        return run.key[:3]
    return {key: list(group) for key, group in itertools.groupby(sorted(runs, key=kind), kind)}


def groups_to_compare(groups):
    """The weakest friction and its groups, over the size; the size with most groups, and these, over the friction."""
    weakest = min(friction for _, friction, _ in groups)
    size = max(groups, key=lambda key: sum(other[0] == key[0] for other in groups))[0]
    return (weakest, {key: runs for key, runs in groups.items() if key[1] == weakest},
            size, {key: runs for key, runs in groups.items() if key[0] == size})


def looks_of(groups, at):
    """The runs of each group and the look of their curve: a colour for each size (0) or friction (1), which is named
    once, and dashes for painted points."""
    values = list(dict.fromkeys(key[at] for key in groups))
    colours, named = dict(zip(values, shades(len(values)))), set()
    for key, runs in groups.items():
        name = (f"{key[0]} spheres", f"μ = {key[1]:g}")[at]
        yield key, runs, {"label": None if name in named else name, "color": colours[key[at]], "linewidth": 1.2,
                          "linestyle": "-" if key[2] == DAVID else "--"}
        named.add(name)


def mean_strain(runs):
    """Strain (10⁻³) over the cycles that all of the runs have."""
    last = min(len(run.strain) for run in runs)
    return 1e3 * numpy.mean([run.strain[:last] for run in runs], axis=0)


def strain_panel(title, groups, at):
    """Means of the seeds, with standard errors after the last cycle; logarithmic where they differ widely."""
    curves, ends = [], []
    for number, (key, runs, look) in enumerate(looks_of(groups, at)):
        strain = mean_strain(runs)
        last = len(strain) - 1
        counts = dict.fromkeys(len(others) for other, others in groups.items() if other[:2] == key[:2])
        label = look["label"] and f"{look['label']}, n = {' and '.join(map(str, counts))}"
        mean, error = scree.fits.mean_and_error(1e3 * run.strain[last] for run in runs)
        fill = "none" if look["linestyle"] == "--" else "full"
        curves += [Curve(range(last + 1), strain, **look | {"label": label}),
                   Curve([last * (1.02 + 0.012 * number)], [mean], error=error, marker="o",
                         markersize=4, fillstyle=fill, capsize=2, **look | {"label": None})]  # next to one another
        ends.append(numpy.mean([run.strain[-1] for run in runs]))
    scale = "log" if min(ends) > 0 and max(ends) > 20 * min(ends) else "linear"
    return Panel(title, "cycle", "deviatoric strain at the least load / 10⁻³", *curves, yscale=scale, **OUTSIDE)


def loops_panel(title, groups, at, cycles, width=1.2):
    """Stress over strain of the first run of each group; cycles: of a run."""
    curves = []
    for _, runs, look in looks_of(groups, at):
        strain, stress = cycles(runs[0])
        curves.append(Curve(1e3 * strain, stress, **look | {"linewidth": width}))
    return Panel(title, "deviatoric strain / 10⁻³", "deviatoric stress / Pa", *curves, **OUTSIDE)


def draw_groups(panels, path, note=""):
    title = f"Tangential springs: solid lines David et al., dashed lines painted points{note}"
    print(draw(path, panels, (1.4 + 6.2 * len(panels), 5), title=title))


def draw_accumulation(groups, path):
    """Over sizes and frictions, or the one of which there are several."""
    friction, sizes, size, frictions = groups_to_compare(groups)
    panels, several = [], len({key[1] for key in frictions}) > 1
    if len({key[0] for key in sizes}) > 1 or not several:
        panels.append(strain_panel(f"Size, μ = {friction:g}, mean of the seeds", sizes, 0))
    if several:
        panels.append(strain_panel(f"Friction, {size} spheres, mean of the seeds", frictions, 1))
    draw_groups(panels, path, "; n packings of each")


def draw_loops(groups, path):
    """Of runs that have their loops: all cycles, unless they are the first alone and drawn for several frictions, and
    the first. All cycles are of one spring, since two would hide each other."""
    groups = groups_of(run for runs in groups.values() for run in runs if run.cycles)
    if not groups:
        return
    friction, sizes, size, frictions = groups_to_compare(groups)
    largest = max(sizes, key=lambda key: key[0])
    panels, several = [], len({key[1] for key in frictions}) > 1
    if not several or any(len(run.loop_area) > 1 for run in sizes[largest]):
        title = f"All cycles, {largest[2]}, μ = {friction:g}, first seed"
        panels.append(loops_panel(title, {largest: sizes[largest]}, 0, lambda run: run.cycles, 0.4))
    if several:
        title = f"First cycle, {size} spheres, first seed"
        panels.append(loops_panel(title, frictions, 1, lambda run: run.first_cycle))
    draw_groups(panels, path)


def size_panel(groups):
    """Figure 3."""
    colours = dict(zip(dict.fromkeys(size for size, _, _ in groups), COLOURS))
    curves = []
    for (size, _, spring), runs in groups.items():
        strain, solid = mean_strain(runs), spring == DAVID
        curves.append(Curve(range(len(strain)), strain, "-" if solid else "--", color=colours[size], linewidth=1.3,
                            label=f"{size} spheres" if solid else None))
    return Panel("Size (figure 3), μ = 0.1\ndashed: path-independent springs", "cycle",
                 "deviatoric strain at the least load / 10⁻³", *curves, legend={"loc": "lower right"}, ylim=(0, None))


def friction_panel(numbers, title, quantity, unit, curves, legend_height, **settings):
    """A quantity of results.csv over the friction. curves: size, study and label."""
    drawn = []
    for (size, study, label), colour in zip(curves, (COLOURS[0], COLOURS[3])):
        found = [(friction, numbers.value(study, quantity, f"{size} spheres, μ = {friction:g}, {DAVID}"))
                 for friction in FRICTIONS]
        points = [(friction, *value) for friction, value in found if value]
        if points:
            friction, mean, error = zip(*points)
            drawn.append(Curve(friction, mean, error=error, marker="o", markersize=5, capsize=3, linewidth=1.2,
                               color=colour, label=f"{size} spheres, {label}"))
    legend = {"loc": "lower right", "bbox_to_anchor": (1, legend_height)}
    return Panel(title, "friction of the load", quantity + unit, *drawn, legend=legend, xticks=FRICTIONS, **settings)


def draw_claims(groups, numbers, path):
    """Figures 3, 5 and 4. groups: of one friction, by size."""
    own = 1728, "accumulation", "each prepared with its friction"
    panels = [size_panel(groups),
              friction_panel(numbers, "Friction (figure 5)", "strain after 100 cycles", "",
                             [(1000, "same-packings", "the same packings"), own], 0.55, yscale="log"),
              friction_panel(numbers, "Friction (figure 4)", "slope of the first loop", " / kPa",
                             [(1728, "first-cycle", "the same packings"), own], 0.02, ylim=(0, None))]
    print(draw(path, panels, (13, 4.2)))


def evaluate(campaign, out, numbers):
    """Draws and records the runs of a campaign, or those that a table keeps in its folder."""
    study = campaign.study
    if study in ("friction-campaign", "prepared-friction-campaign"):
        return put_frictions(numbers, study, campaign)
    found = runs_at(campaign)
    if len({run.key[4:] for run in found}) > 1:
        return put_runs(numbers, study, found, campaign)
    kept = [] if found else kept_runs(campaign.path / TABLE)
    if kept:
        found, study, campaign = kept, KEPT, None
    elif not found:
        raise scree.scripts.no_runs(campaign, f"scenarios/david2005/{KEPT}.toml")
    elif study == KEPT:
        found = merged(found, campaign, out / TABLE)
    groups = groups_of(found)
    put_groups(numbers, study, groups, campaign)
    if len(found[0].strain) > 2:
        draw_accumulation(groups, out / f"{study}.png")
    return draw_loops(groups, out / ("loops.png" if study == KEPT else f"{study}-loops.png"))


if __name__ == "__main__":
    out, numbers = scree.scripts.record(__doc__, PAPER, evaluate)
    kept = kept_runs(out / TABLE) or kept_runs(PAPER / TABLE)
    draw_claims(groups_to_compare(groups_of(kept))[1], numbers, out / "claims.png")
