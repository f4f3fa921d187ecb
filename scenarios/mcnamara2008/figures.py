"""Draws figures 1 to 6 and 13 to 18 of McNamara et al. (2008) from campaigns of this folder, prints their
numbers and records them in results.csv.

Usage: python3 scenarios/mcnamara2008/figures.py DIR... [--out FOLDER, default: the first DIR]
DIR: a campaign, or a folder of campaigns. cycle.png is of paths, ellipse.png of elliptic and paths, steps.png
of laws and steps, rattlers.png of rattlers and long; of choices, fine and large there are numbers alone. A
picture lacks the panels whose campaigns are missing, and a line says so. Needs python3-matplotlib and
python3-pandas."""
import math
import os

from packing import draw_packing
from record import (FRICTION, LOAD, Biaxial, bodies_of, contact_that_slides, ellipses_of, lines_of, long_runs,
                    phases_of, put_all, sine_fit, widest_of)
from series import DROPPED, numpy, slope_of, strains
from style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, label, pyplot, save
from results import Results  # of the folder above, which series.py adds, like the next
from tables import folders, no_runs, study_of

PAPER = os.path.dirname(os.path.abspath(__file__))
MARKS = "os^dv<>ph*"
SETTLING = 82  # packing of long.toml that shakes down
CAMPAIGNS = ("paths", "elliptic", "laws", "steps", "rattlers", "long", "choices", "fine", "large")


def compose(name, panels, out):
    """Draws the panels that have data, two in a row, and prints what the others need. panels: (what it is and
    needs, data, how to draw it)."""
    ready = [(data, draw) for _, data, draw in panels if data]
    for needs in dict.fromkeys(needs for needs, data, _ in panels if not data):
        print(f"{name} {'without' if ready else 'not drawn:'} {needs}")
    if not ready:
        return
    wide, high = min(len(ready), 2), (len(ready) + 1) // 2
    figure, axes = pyplot.subplots(high, wide, figsize=(5 * wide + 0.5 * (wide == 1), 4.2 * high), squeeze=False)
    for panel in axes.flat[len(ready) :]:
        panel.remove()
    for panel, (data, draw) in zip(axes.flat, ready):
        draw(panel, data)
    save(figure, out, name)


def power_of(values):
    """Power of ten of the largest magnitude."""
    largest = max(abs(values))
    return math.floor(math.log10(largest)) if largest > 0 else 0


def draw_slip(axes, paths):
    name, (n, t, sliding) = contact_that_slides(paths)
    axes.plot(n, t, color=GREY, linewidth=1)
    for slips, colour, text in ((0, BLUE, "sticks"), (1, RED, "slides")):
        axes.plot(n[sliding == slips], t[sliding == slips], ".", markersize=4, color=colour, label=text)
    ends = numpy.array([0, max(n) * 1.02])
    for sign, text in ((1, r"$\pm\mu F_n$"), (-1, None)):
        axes.plot(ends, sign * FRICTION * ends, color="black", linestyle=":", label=text)
    axes.set_xlim(min(n) - 0.4 * (max(n) - min(n)), ends[1])
    axes.legend(frameon=False, fontsize=8)
    label(axes, f"Sliding contact, {bodies_of(name)} (figure 3)", "$F_n$ / N", "$F_t$ / N")


def draw_stick(axes, paths):
    """Paths about their middles, of contacts that never slide, with the largest areas."""
    sticking = sorted((c for c, v in paths.contacts.items() if not sum(v[2])), key=lambda c: -abs(paths.area(c)))[:5]
    for name, colour in zip(sticking, (BLUE, ORANGE, GREEN, RED, GREY)):
        n, t, _ = paths.contacts[name]
        axes.plot(n - n.mean(), t - t.mean(), color=colour, linewidth=1.2, label=bodies_of(name))
    axes.legend(frameon=False, fontsize=8)
    axes.locator_params(axis="x", nbins=6)
    label(axes, "Sticking contacts (figure 4)", "$F_n$ less its mean / N", "$F_t$ less its mean / N")


def draw_loop(axes, biaxial):
    cycles = numpy.arange(3 * biaxial.per + 1) / biaxial.per
    axes.plot(LOAD * (1 - numpy.cos(2 * math.pi * cycles)), biaxial.gamma[: len(cycles)] * 1e3, color=BLUE, linewidth=1)
    label(axes, f"{biaxial.name}: three cycles (figure 1)", "$q$ / p", r"$\gamma$ / 10$^{-3}$")


def draw_minima(axes, gamma, title, look):
    """Strains at the least load from cycle DROPPED on."""
    about_first = gamma - gamma[0]
    power = power_of(about_first)
    cycles = range(DROPPED, DROPPED + len(gamma))
    axes.plot(cycles, about_first / 10.0**power, look, markersize=3.5, linewidth=0.5, color=BLUE)
    label(axes, title, "cycle", rf"$\gamma$ minus $\gamma$ of cycle {DROPPED} / 10$^{{{power}}}$")


def draw_ratcheting(axes, biaxial):
    gamma = biaxial.gamma[DROPPED * biaxial.per :: biaxial.per]
    draw_minima(axes, gamma, "Strain at the least load (figure 2)", "o")


def draw_cycle(campaigns, out):
    run = next((r for r in long_runs(campaigns.get("paths"), "case") if r.row["case"] == "biaxial"), None)
    biaxial = Biaxial(run) if run else None
    needs = "figures 1 to 4, of paths.toml: case biaxial with 30 cycles or more"
    sliding = biaxial.paths if biaxial and biaxial.slides() else None
    slip = "figure 3, of a contact that slides" if biaxial else needs
    compose("cycle.png", [(needs, biaxial, draw_loop), (needs, biaxial, draw_ratcheting), (slip, sliding, draw_slip),
                          (needs, biaxial and biaxial.paths, draw_stick)], out)


def draw_phases(axes, by_packing):
    for (case, seed), slopes in by_packing.items():
        amplitude = sine_fit(slopes)[0]
        if case == "a third of the load":
            phases = sorted(slopes)
            axes.plot(phases, [slopes[p] / amplitude for p in phases], MARKS[seed % len(MARKS)], markersize=5,
                      fillstyle="none", label=f"{seed}: {amplitude:.1e}")
    degrees = numpy.arange(361)
    axes.plot(degrees, numpy.sin(numpy.radians(degrees)), color="black", linewidth=1, label=r"sin $\varphi$")
    axes.legend(title="packing: A per cycle", frameon=False, fontsize=8, title_fontsize=8)
    axes.set_xticks(range(0, 361, 60))
    label(axes, r"Strain per cycle without slip, $\Delta\sigma$ = 0.05 p (figure 5)", r"$\varphi$ / °",
          r"$\Delta\gamma$ / A")


def draw_ellipses(axes, runs):
    paths = ellipses_of(runs)
    widest = widest_of(paths)
    for (phase, of_phase), colour in zip(paths.items(), (BLUE, ORANGE, GREEN, RED)):
        n, t, _ = of_phase.contacts[widest]
        axes.plot(n, t, color=colour, linewidth=1.2, label=phase)
    axes.legend(title=r"$\varphi$ / °", frameon=False, fontsize=8, title_fontsize=8)
    label(axes, f"Packing {runs[0].row['seed']}, {bodies_of(widest)} (figure 6)", "$F_n$ / N", "$F_t$ / N")


def draw_loads(campaigns, out):
    runs = [run for run in long_runs(campaigns.get("paths"), "case") if run.row["case"].startswith("phase ")]
    runs = runs if any(run.row["case"] == "phase 90" for run in runs) else []
    phases = phases_of(campaigns.get("elliptic"))
    needs = "figure 5, of elliptic.toml: three phases or more, of 30 cycles or more"
    other = "figure 6, of paths.toml: case phase 90 with 30 cycles or more"
    compose("ellipse.png", [(needs, phases, draw_phases), (other, runs, draw_ellipses)], out)


def draw_laws(axes, runs):
    """|Δγ| of the packings that ratchet, in descending order."""
    for case, colour, mark in (("Cundall and Strack", BLUE, "o"), ("corrected", RED, "x")):
        slopes = [slope for slope, rms in (slope_of(r) for r in runs if r.row["case"] == case) if rms < abs(slope)]
        if not slopes:
            continue
        ordered = sorted((abs(s) for s in slopes), reverse=True)
        axes.semilogy(range(1, len(ordered) + 1), ordered, mark, markersize=4, color=colour, label=case)
    if axes.lines:
        axes.legend(frameon=False, fontsize=8)
    label(axes, "Packings that ratchet (figure 13)", "rank", r"$|\Delta\gamma|$ per cycle")


def draw_over_steps(axes, lines):
    seeds = sorted({seed for _, seed in lines})
    named = set()
    for (law, seed), slopes in lines.items():
        sizes = sorted(slopes)
        axes.loglog(sizes, [abs(slopes[h]) for h in sizes], "x-" if law == "disc_cundall_strack" else "o--",
                    fillstyle="none", linewidth=1, markersize=5,
                    color=(BLUE, ORANGE, GREEN, RED, GREY, PURPLE)[seeds.index(seed) % 6],
                    label=None if seed in named else f"{seed}")
        named.add(seed)
    axes.set_ylim(bottom=axes.get_ylim()[0] / 20)
    axes.legend(title="crosses: Cundall and Strack, circles: corrected, of packings", frameon=False, fontsize=8,
                title_fontsize=8, ncols=3, loc="lower left")
    label(axes, "Strain per cycle over the step (figure 14)", r"step / $\tau$", r"$|\Delta\gamma|$ per cycle")


def draw_steps(campaigns, out):
    runs = long_runs(campaigns.get("laws"), "case")
    laws = [run for run in runs if run.row["case"] in ("Cundall and Strack", "corrected")]
    needs = "figure 13, of laws.toml: Cundall and Strack or corrected, 30 cycles or more"
    both = "figure 14, of steps.toml: both laws, two steps or more of each, of 30 cycles or more"
    lines = lines_of(campaigns.get("steps"))
    compose("steps.png", [(needs, laws, draw_laws), (both, lines, draw_over_steps)], out)


def draw_outlier(axes, run):
    title = f"A disc without contacts, packing {run.row['seed']} (figure 15)"
    draw_minima(axes, strains(run, DROPPED)[DROPPED:], title, "o-")


def draw_repeating(axes, run):
    title = f"Cycles that repeat, packing {run.row['seed']} (figure 17)"
    draw_minima(axes, strains(run, DROPPED)[DROPPED:], title, "o-")


def draw_settling(axes, run):
    gamma = strains(run, DROPPED)[DROPPED:]
    cycles = range(DROPPED, DROPPED + len(gamma) - 1)
    axes.semilogy(cycles, abs(gamma[:-1] - gamma[-1]), color=BLUE, linewidth=1)
    label(axes, f"Shakedown, packing {run.row['seed']} (figure 18)", "cycle",
          r"$|\gamma$ minus $\gamma$ of the last cycle$|$")


def draw_rattlers(campaigns, out):
    runs = {run.row["case"]: run for run in long_runs(campaigns.get("rattlers"), "case")}
    outliers, periodic = runs.get("outliers"), runs.get("periodic")
    longest = {run.row["seed"]: run for run in long_runs(campaigns.get("long"))}
    needs = "figures 15 and 16, of rattlers.toml: case outliers with 30 cycles or more"
    repeating = "figure 17, of rattlers.toml: case periodic with 30 cycles or more"
    settling = f"figure 18, of long.toml: packing {SETTLING} with 30 cycles or more"
    compose("rattlers.png", [(needs, outliers, draw_outlier), (needs, outliers, draw_packing),
                             (repeating, periodic, draw_repeating), (settling, longest.get(SETTLING), draw_settling)], out)


def campaigns_in(given):
    """Folders of campaigns by the names of their files."""
    found = {}
    for folder in given:
        for place in (folder, *(os.path.join(folder, name) for name in CAMPAIGNS)):
            if os.path.exists(os.path.join(place, "table.csv")):
                found.setdefault(study_of(place), place)
    return found


def main():
    given, out = folders(__doc__)
    campaigns, results = campaigns_in(given), Results(PAPER, out)
    if not any([put_all(results, name, campaigns.get(name)) for name in CAMPAIGNS]):
        no_runs(given[0], f"scenarios/mcnamara2008/{CAMPAIGNS[0]}.toml, or {', '.join(CAMPAIGNS[1:])},")
    for draw in (draw_cycle, draw_loads, draw_steps, draw_rattlers):
        draw(campaigns, out)
    results.write()


if __name__ == "__main__":
    main()
