"""Draws cyclic loading of packings of several sizes and frictions, and records its numbers (David et al. 2005):
claims.png, of figures 3 to 5; of each campaign its strain over the cycles (accumulation.png for
accumulation.toml) and its loops (loops.png); results.csv, means over the seeds and standard errors. Of
accumulation.toml also runs.csv, one row a cycle of each run; runs of an earlier runs.csv there that the
campaign lacks are kept and count too, but for their loops. Of rates.toml and of the campaigns of
quickstart.toml it records numbers alone.

Usage: python3 scenarios/david2005/figures.py DIR... [--out FOLDER, default: the first DIR]
DIR: a campaign of this folder, or this folder, for the runs that its runs.csv keeps. Needs python3-matplotlib
and python3-pandas."""
import math
import os
import statistics
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from claims import draw_claims  # noqa: E402 (of this folder, like the next)
from record import mean_of, put_frictions, put_groups, put_runs, quantities_of  # noqa: E402
from runs import SPRINGS, kept_runs, merged, runs_at  # noqa: E402
from drawing import pyplot  # noqa: E402 (of the folder above, like the next)
from results import Results  # noqa: E402
from tables import folders, made, no_runs, study_of  # noqa: E402

PAPER = os.path.dirname(os.path.abspath(__file__))
TABLE, KEPT = "runs.csv", "accumulation"  # the campaign whose runs the table keeps


def with_error(mean, error, count):
    """A mean and its standard error as text, in brackets where it is of two values, without where it is of one."""
    if count < 2 or math.isnan(mean):
        return f"{mean:.3g}"
    return f"{mean:.3g} ± {error:.1g}" if count > 2 else f"{mean:.3g} (± {error:.1g})"


def groups_of(runs):
    """Runs by size, friction and spring."""
    groups = {}
    for run in runs:
        groups.setdefault((run.size, run.friction, run.spring), []).append(run)
    return dict(sorted(groups.items()))


def print_numbers(groups):
    heads = ("strain after the last cycle", "per cycle, late", "first loop [Pa]", "slope [kPa]")
    print(f"spheres     μ {'spring':14} seeds  {heads[0]:>28}  {heads[1]:>24}  {heads[2]:>20}  {heads[3]:>16}")
    for (size, friction, spring), runs in groups.items():
        texts = [with_error(mean, error, len(runs)) for _, _, mean, error in quantities_of(runs)[:4]]
        print(
            f"{size:7} {friction:5g} {spring:14} {len(runs):5}  {texts[0]:>28}  {texts[1]:>24}"
            f"  {texts[2]:>20}  {texts[3]:>16}"
        )


def print_runs(runs):
    print(
        f"spheres     μ {'spring':14} seed period [s] step [s] cycles strain after the last"
        " first loop [Pa] slope [kPa]"
    )
    for run in sorted(runs, key=lambda run: run.key):
        print(
            f"{run.size:7} {run.friction:5g} {run.spring:14} {run.seed:4} {run.period:10g} {run.step:8g}"
            f" {len(run.loop_area):6} {run.strain[-1]:21.3g} {run.loop_area[0]:15.3g} {run.slope[0] / 1e3:11.3g}"
        )
    print("several periods or steps: no means")


def plot_accumulation(axes, groups, title, name_of):
    """Means of the seeds, with standard errors after the last cycle; logarithmic where they differ widely."""
    ends = [mean_of([run.strain[-1] for run in runs])[0] for runs in groups.values()]
    if min(ends) > 0 and max(ends) > 20 * min(ends):
        axes.set_yscale("log")
    for at, (label, runs, look) in enumerate(
        with_looks(groups, lambda key: f"{name_of(key)}, n = {packings_of(groups, key)}")
    ):
        last = min(len(r.strain) for r in runs) - 1
        axes.plot(range(last + 1), [1e3 * statistics.fmean(r.strain[c] for r in runs) for c in range(last + 1)],
                  label=label, **look)
        mean, error = mean_of([1e3 * r.strain[last] for r in runs])
        error = None if math.isnan(error) else error
        # Next to one another.
        fill = "none" if look["linestyle"] == "--" else "full"
        axes.errorbar(
            last * (1.02 + 0.012 * at), mean, yerr=error, marker="o", markersize=4, fillstyle=fill, capsize=2, **look
        )
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


def packings_of(groups, key):
    """Packings with each spring, one number where they are as many."""
    counts = [len(runs) for other, runs in groups.items() if other[:2] == key[:2]]
    return " and ".join(str(count) for count in (counts if len(set(counts)) > 1 else counts[:1]))


def save(figure, panels, file, note):
    figure.suptitle(f"Tangential springs: solid lines David et al., dashed lines painted points{note}", fontsize=10)
    for axes in panels:
        axes.grid(color="#eeeeee")
        axes.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.tight_layout()
    figure.savefig(file, dpi=80)
    print(file)


def size_of(key):
    return f"{key[0]} spheres"


def friction_of(key):
    return f"μ = {key[1]:g}"


def by_size(groups):
    """Groups with the weakest friction, and that friction."""
    weakest = min(friction for _, friction, _ in groups)
    return {key: runs for key, runs in groups.items() if key[1] == weakest}, weakest


def by_friction(groups):
    """Groups of the size that has most of them, and that size."""
    size = max(groups, key=lambda key: sum(other[0] == key[0] for other in groups))[0]
    return {key: runs for key, runs in groups.items() if key[0] == size}, size


def values_of(groups, at):
    """How many sizes (0) or frictions (1) there are."""
    return len({key[at] for key in groups})


def draw_panels(panels, file, note=""):
    """A function for each of them."""
    figure, [axes] = pyplot.subplots(1, len(panels), figsize=(1.4 + 6.2 * len(panels), 5), squeeze=False)
    for part, draw in zip(axes, panels):
        draw(part)
    save(figure, axes, file, note)


def draw_accumulation(groups, file):
    """Over sizes and frictions, or the one of which there are several."""
    (sizes, weakest), (frictions, compared) = by_size(groups), by_friction(groups)
    panels = []
    if values_of(sizes, 0) > 1 or values_of(frictions, 1) < 2:
        title = f"Size, μ = {weakest:g}, mean of the seeds"
        panels.append(lambda axes: plot_accumulation(axes, sizes, title, size_of))
    if values_of(frictions, 1) > 1:
        panels.append(
            lambda axes: plot_accumulation(
                axes, frictions, f"Friction, {compared} spheres, mean of the seeds", friction_of
            )
        )
    draw_panels(panels, file, "; n packings of each")


def draw_loops(groups, file):
    """Of runs that have their loops: all cycles, unless they are the first alone and drawn for several
    frictions, and the first."""
    looped = {key: [run for run in runs if run.loops] for key, runs in groups.items()}
    looped = {key: runs for key, runs in looped.items() if runs}
    if not looped:
        return
    (sizes, weakest), (frictions, compared) = by_size(looped), by_friction(looped)
    largest = {key: runs for key, runs in sizes.items() if key[0] == max(size for size, _, _ in sizes)}
    # Loops of two springs would hide each other.
    spring = min((key[2] for key in largest), key=list(SPRINGS.values()).index)
    largest = {key: runs for key, runs in largest.items() if key[2] == spring}
    panels, compares = [], values_of(frictions, 1) > 1
    if not compares or any(len(run.loop_area) > 1 for runs in largest.values() for run in runs):
        title = f"All cycles, {spring}, μ = {weakest:g}, first seed"
        panels.append(lambda axes: plot_loops(axes, largest, title, size_of, lambda run: run.loops, 0.4))
    if compares:
        title_of_first = f"First cycle, {compared} spheres, first seed"
        panels.append(
            lambda axes: plot_loops(axes, frictions, title_of_first, friction_of, lambda run: run.first_loop())
        )
    draw_panels(panels, file)


def evaluate(folder, out, results):
    """Draws and records the runs of a folder."""
    study, campaign = study_of(folder), folder
    if study in ("friction-campaign", "prepared-friction-campaign"):
        return put_frictions(results, study, folder)
    found = runs_at(folder)
    if len({(run.period, run.step) for run in found}) > 1:
        print_runs(found)
        return put_runs(results, study, found, folder)
    if not found:
        found, study, campaign = kept_runs(os.path.join(folder, TABLE)), KEPT, None
    elif study == KEPT:
        found = merged(found, folder, os.path.join(made(out), TABLE))
    if not found:
        no_runs(folder, f"scenarios/david2005/{KEPT}.toml")
    groups = groups_of(found)
    made(out)
    print_numbers(groups)
    put_groups(results, study, groups, campaign)
    if len(found[0].strain) > 2:
        draw_accumulation(groups, os.path.join(out, f"{study}.png"))
    return draw_loops(groups, os.path.join(out, "loops.png" if study == KEPT else f"{study}-loops.png"))


def main():
    given, out = folders(__doc__)
    results = Results(PAPER, out)
    for folder in given:
        evaluate(folder, out, results)
    results.write()
    kept = kept_runs(os.path.join(out, TABLE)) or kept_runs(os.path.join(PAPER, TABLE))
    draw_claims(by_size(groups_of(kept))[0], results, out)


if __name__ == "__main__":
    main()
