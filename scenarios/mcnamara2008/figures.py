"""Draws figures 1 to 6 and 13 to 18 of McNamara et al. (2008) from campaigns of this folder, prints their
numbers and records them in results.csv.

Usage: python3 scenarios/mcnamara2008/figures.py DIR... [--out FOLDER, default: the first DIR]
DIR: a campaign, or a folder of campaigns. cycle.png is of paths, ellipse.png of elliptic and paths, steps.png
of laws and steps, rattlers.png of rattlers and long; of choices, fine and large there are numbers alone. A
picture lacks the panels whose campaigns are missing, and a line says so. Needs python3-matplotlib and
python3-pandas."""
import math
import pathlib
import sys

PAPER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(PAPER.parents[1] / "tools" / "python"))
import scree  # noqa: E402 (of this tree)

scree.scripts.start("matplotlib", "pandas")
import numpy  # noqa: E402
from record import PUT  # noqa: E402 (of this folder, like the next)
from series import (DROPPED, bodies_of, ellipses_of, long_runs, paths_of, phases_of, sine_fit, slope_of,
                    steps_of, strains)  # noqa: E402
from scree.charts import BLUE, GREEN, GREY, ORANGE, RED, Curve, Panel, room_below  # noqa: E402
from scree.packings import frame, packing  # noqa: E402

LOAD, FRICTION = 0.15, 0.2  # Δσ/p, μ
PURPLE, MARKS = "#a569bd", "os^dv<>ph*"
SETTLING = 82  # packing of long.toml that shakes down
FORCES = "$F_n$ / N", "$F_t$ / N"


def loop_panel(biaxial):
    cycles = numpy.arange(3 * biaxial.per_cycle + 1) / biaxial.per_cycle
    load, gamma = LOAD * (1 - numpy.cos(2 * math.pi * cycles)), biaxial.gamma[: len(cycles)]
    curve = Curve(load, 1e3 * gamma, color=BLUE, linewidth=1)
    return Panel(f"{biaxial.name}: three cycles (figure 1)", "$q$ / p", r"$\gamma$ / 10$^{-3}$", curve)


def minima_panel(gamma, title, look="o-"):
    """Strains at the least load from cycle DROPPED on, over the power of ten of the largest."""
    gamma = gamma - gamma[0]
    largest = max(abs(gamma))
    power = math.floor(math.log10(largest)) if largest > 0 else 0
    cycles = range(DROPPED, DROPPED + len(gamma))
    curve = Curve(cycles, gamma / 10.0**power, look, markersize=3.5, linewidth=0.5, color=BLUE)
    return Panel(title, "cycle", rf"$\gamma$ minus $\gamma$ of cycle {DROPPED} / 10$^{{{power}}}$", curve)


def slip_panel(paths):
    name = max(paths.slips, key=paths.slips.get)
    n, t, sliding = paths.contacts[name]
    ends = numpy.array([0, max(n) * 1.02])
    return Panel(f"Sliding contact, {bodies_of(name)} (figure 3)", *FORCES, Curve(n, t, color=GREY, linewidth=1),
                 Curve(n[sliding == 0], t[sliding == 0], ".", markersize=4, color=BLUE, label="sticks"),
                 Curve(n[sliding == 1], t[sliding == 1], ".", markersize=4, color=RED, label="slides"),
                 Curve(ends, FRICTION * ends, ":", color="black", label=r"$\pm\mu F_n$"),
                 Curve(ends, -FRICTION * ends, ":", color="black"), legend={},
                 xlim=(min(n) - 0.4 * (max(n) - min(n)), ends[1]))


def stick_panel(paths):
    """Paths about their middles, of contacts that never slide, with the largest areas."""
    curves = []
    sticking = (name for name in paths.areas if name not in paths.slips)
    for name, colour in zip(sticking, (BLUE, ORANGE, GREEN, RED, GREY)):
        n, t, _ = paths.contacts[name]
        curves.append(Curve(n - n.mean(), t - t.mean(), color=colour, linewidth=1.2, label=bodies_of(name)))
    return Panel("Sticking contacts (figure 4)", "$F_n$ less its mean / N", "$F_t$ less its mean / N", *curves,
                 legend={}, xticks=6)


def cycle(campaigns):
    """Figures 1 to 4."""
    needs = "figures 1 to 4, of paths.toml: case biaxial with 30 cycles or more"
    biaxial = paths_of(campaigns.get("paths")).get("biaxial")
    if not biaxial:
        return [(needs, None)]
    return [(needs, loop_panel(biaxial)),
            (needs, minima_panel(biaxial.minima, "Strain at the least load (figure 2)", "o")),
            ("figure 3, of a contact that slides", biaxial.slips and slip_panel(biaxial)),
            (needs, stick_panel(biaxial))]


def phases_panel(by_packing):
    curves = []
    for (case, seed), slopes in by_packing.items():
        if case == "a third of the load":
            amplitude, phases = sine_fit(slopes)[0], numpy.array(sorted(slopes))
            curves.append(Curve(phases + 90, [slopes[p] / amplitude for p in phases], MARKS[seed % len(MARKS)],
                                markersize=5, fillstyle="none", label=f"{seed}: {amplitude:.1e}"))
    degrees = numpy.arange(361)
    sine = Curve(degrees, numpy.sin(numpy.radians(degrees)), color="black", linewidth=1, label=r"sin $\varphi$")
    return Panel(r"Strain per cycle without slip, $\Delta\sigma$ = 0.05 p (figure 5)", r"$\varphi$ / °",
                 r"$\Delta\gamma$ / A", *curves, sine, legend={"title": "packing: A per cycle"},
                 xticks=range(0, 361, 60))


def ellipses_panel(ellipses, widest):
    curves = [Curve(*paths.contacts[widest][:2], color=colour, linewidth=1.2, label=phase)
              for (phase, paths), colour in zip(ellipses.items(), (BLUE, ORANGE, GREEN, RED))]
    return Panel(f"Packing {ellipses['90'].seed}, {bodies_of(widest)} (figure 6)", *FORCES, *curves,
                 legend={"title": r"$\varphi$ / °"})


def ellipse(campaigns):
    """Figures 5 and 6."""
    phases, (ellipses, widest) = phases_of(campaigns.get("elliptic")), ellipses_of(paths_of(campaigns.get("paths")))
    return [("figure 5, of elliptic.toml: three phases or more, of 30 cycles or more", phases and phases_panel(phases)),
            ("figure 6, of paths.toml: case phase 90 with 30 cycles or more",
             ellipses and ellipses_panel(ellipses, widest))]


def ranks_panel(laws):
    """|Δγ| of the packings that ratchet, in descending order."""
    curves = []
    for case, colour, mark in (("Cundall and Strack", BLUE, "o"), ("corrected", RED, "x")):
        slopes = [slope_of(run) for run in laws if run.row["case"] == case]
        ordered = sorted((abs(slope) for slope, deviation in slopes if deviation < abs(slope)), reverse=True)
        if ordered:
            curves.append(Curve(range(1, len(ordered) + 1), ordered, mark, markersize=4, color=colour, label=case))
    return Panel("Packings that ratchet (figure 13)", "rank", r"$|\Delta\gamma|$ per cycle", *curves, yscale="log",
                 legend={} if curves else None)


def steps_panel(lines):
    seeds = sorted({seed for _, seed in lines})
    colours, curves = dict(zip(seeds, (BLUE, ORANGE, GREEN, RED, GREY, PURPLE))), []
    for (law, seed), slopes in lines.items():
        named = any(curve.options["label"] == f"{seed}" for curve in curves)
        look = "x-" if law == "disc_cundall_strack" else "o--"
        curves.append(Curve(sorted(slopes), [abs(slopes[h]) for h in sorted(slopes)], look, fillstyle="none",
                            linewidth=1, markersize=5, color=colours[seed], label=None if named else f"{seed}"))
    legend = {"title": "crosses: Cundall and Strack, circles: corrected, of packings", "ncols": 3, "loc": "lower left"}
    return Panel("Strain per cycle over the step (figure 14)", r"step / $\tau$", r"$|\Delta\gamma|$ per cycle", *curves,
                 room_below, legend=legend, xscale="log")


def steps(campaigns):
    """Figures 13 and 14."""
    laws = [r for r in long_runs(campaigns.get("laws"), "case") if r.row["case"] in ("Cundall and Strack", "corrected")]
    lines = steps_of(campaigns.get("steps"))
    return [("figure 13, of laws.toml: Cundall and Strack or corrected, 30 cycles or more", laws and ranks_panel(laws)),
            ("figure 14, of steps.toml: both laws, two steps or more of each, of 30 cycles or more",
             lines and steps_panel(lines))]


def packing_panel(run):
    box = run.series["load"].iloc[-1]
    title = f"Packing {run.row['seed']} (figure 16): normal forces blue,\ntangential red across them, velocity green"
    return Panel(title, "$x$ / L", "$y$ / L", frame(box.length_x, box.length_y), packing(run, 8, 3, 0.12), grid=False,
                 xlim=(-0.02, box.length_x + 0.02), ylim=(-0.02, box.length_y + 0.02), aspect="equal")


def settling_panel(run):
    gamma = strains(run)
    curve = Curve(range(DROPPED, DROPPED + len(gamma) - 1), abs(gamma[:-1] - gamma[-1]), color=BLUE, linewidth=1)
    return Panel(f"Shakedown, packing {SETTLING} (figure 18)", "cycle",
                 r"$|\gamma$ minus $\gamma$ of the last cycle$|$", curve, yscale="log")


def rattlers(campaigns):
    """Figures 15 to 18."""
    runs = {run.row["case"]: run for run in long_runs(campaigns.get("rattlers"), "case")}
    outliers, periodic = runs.get("outliers"), runs.get("periodic")
    settling = {run.row["seed"]: run for run in long_runs(campaigns.get("long"))}.get(SETTLING)
    needs = "figures 15 and 16, of rattlers.toml: case outliers with 30 cycles or more"
    alone, repeating = (run and f"packing {run.row['seed']}" for run in (outliers, periodic))
    return [(needs, outliers and minima_panel(strains(outliers), f"A disc without contacts, {alone} (figure 15)")),
            (needs, outliers and packing_panel(outliers)),
            ("figure 17, of rattlers.toml: case periodic with 30 cycles or more",
             periodic and minima_panel(strains(periodic), f"Cycles that repeat, {repeating} (figure 17)")),
            (f"figure 18, of long.toml: packing {SETTLING} with 30 cycles or more",
             settling and settling_panel(settling))]


def main():
    given, out = scree.scripts.folders(__doc__)
    campaigns, numbers = scree.campaigns.campaigns_in(given), scree.documents.Numbers(PAPER, out)
    known = [study for study in PUT if study in campaigns and campaigns[study].finished()]
    if not known:
        first, *others = PUT
        raise scree.scripts.no_runs(given[0], f"scenarios/mcnamara2008/{first}.toml, or {', '.join(others)},")
    for study in known:
        PUT[study](numbers, study, campaigns[study])
        numbers.print()
    for panels in (cycle, ellipse, steps, rattlers):
        scree.scripts.draw_known(pathlib.Path(out, f"{panels.__name__}.png"), panels(campaigns), (5, 4.2))
    print(numbers.write())


if __name__ == "__main__":
    main()
