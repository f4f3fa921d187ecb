"""Draws figures 1 to 6 and 13 to 18 of McNamara et al. (2008) from the campaigns of this folder, and prints their numbers.

Usage: python3 scenarios/mcnamara2008/figures.py campaigns [FOLDER for the pictures, default: that of the campaigns]
cycle.png is of paths, ellipse.png of elliptic and paths, steps.png of laws and steps, rattlers.png of rattlers and long. A picture lacks the
panels whose campaigns are missing, and a line says so. Needs python3-matplotlib."""
import math
import os

from packing import draw_packing
from series import DROPPED, Paths, cycles_of, line_through, slope_of, strains
from style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, label, pyplot, save
from tables import arguments, no_runs, runs_of, scenario_of  # of the folder above, which series.py adds

LOAD = 0.15  # Δσ/p
FRICTION = 0.2
WALLS = {"wall1": "left wall", "wall2": "right wall", "wall3": "lower wall", "wall4": "upper wall"}
MARKS = "os^dv<>ph*"
SETTLING = "82"  # packing of long.toml that shakes down
CAMPAIGNS = ("paths", "elliptic", "laws", "steps", "rattlers", "long")
PHASE = "stage.cycles.set.box.stress_x_high.phase_deg"
LAWS = {"disc_cundall_strack": "Cundall and Strack", "disc_corrected": "corrected", "disc_angular": "painted points"}


def long_runs(folder, name, *columns):
    """Runs of a campaign of at least 30 cycles; none if its table lacks one of the columns."""
    return [run for run in runs_of(os.path.join(folder, name)) if all(c in run for c in columns) and cycles_of(run["path"]) > DROPPED]


def compose(name, panels, out):
    """Draws the panels that have data, two in a row, and prints what the others need. panels: (what it is and needs, data, how to draw it)."""
    ready = [(data, draw) for _, data, draw in panels if data]
    for needs in dict.fromkeys(needs for needs, data, _ in panels if not data):
        print(f"{name} {'without' if ready else 'not drawn:'} {needs}")
    if not ready:
        return
    wide, high = min(len(ready), 2), (len(ready) + 1) // 2
    figure, axes = pyplot.subplots(high, wide, figsize=(5 * wide + 0.5 * (wide == 1), 4.2 * high), squeeze=False)
    for panel in axes.flat[len(ready):]:
        panel.remove()
    for panel, (data, draw) in zip(axes.flat, ready):
        draw(panel, data)
    save(figure, out, name)


def power_of(values):
    """Of ten, of the largest magnitude."""
    largest = max(abs(v) for v in values)
    return math.floor(math.log10(largest)) if largest > 0 else 0


def bodies_of(contact):
    """A contact "3_7" or "3_wall1" in words."""
    return " and ".join(WALLS.get(part, f"disc {part}") for part in contact.split("_"))


def draw_slip(axes, paths):
    name, (n, t, sliding) = max(paths.contacts.items(), key=lambda c: sum(c[1][2]))
    axes.plot(n, t, color=GREY, linewidth=1)
    for slips, colour, text in ((0, BLUE, "sticks"), (1, RED, "slides")):
        chosen = [k for k, s in enumerate(sliding) if s == slips]
        axes.plot([n[k] for k in chosen], [t[k] for k in chosen], ".", markersize=4, color=colour, label=text)
    ends = [0, max(n) * 1.02]
    for sign in (1, -1):
        axes.plot(ends, [sign * FRICTION * e for e in ends], color="black", linestyle=":", label=r"$\pm\mu F_n$" if sign > 0 else None)
    axes.set_xlim(min(n) - 0.4 * (max(n) - min(n)), ends[1])
    axes.legend(frameon=False, fontsize=8)
    label(axes, f"Sliding contact, {bodies_of(name)} (figure 3)", "$F_n$ / N", "$F_t$ / N")
    slides = {c: int(sum(v[2])) for c, v in paths.contacts.items() if sum(v[2])}
    print(f"contacts that slide in the last cycle: {', '.join(f'{c} in {k} of {len(n)} samples' for c, k in slides.items())}")


def draw_stick(axes, paths):
    """Paths about their middles, those of the largest area that never slide."""
    sticking = sorted((c for c, v in paths.contacts.items() if not sum(v[2])), key=lambda c: -abs(paths.area(c)))[:5]
    for name, colour in zip(sticking, (BLUE, ORANGE, GREEN, RED, GREY)):
        n, t, _ = paths.contacts[name]
        about_means = [[v - sum(force) / len(force) for v in force] for force in (n, t)]
        axes.plot(*about_means, color=colour, linewidth=1.2, label=bodies_of(name))
    axes.legend(frameon=False, fontsize=8)
    axes.locator_params(axis="x", nbins=6)
    label(axes, "Sticking contacts (figure 4)", "$F_n$ less its mean / N", "$F_t$ less its mean / N")


class Biaxial:
    """The run of paths.toml under a load on one pair of walls."""

    def __init__(self, run):
        self.paths = Paths(run["path"])
        self.name = f"{LAWS[scenario_of(run['path'])['contact'][0]['plugin']]}, packing {run['seed']}"
        self.gamma, self.per = strains(run["path"], 0), self.paths.per_cycle

    def slides(self):
        return any(sum(sliding) for _, _, sliding in self.paths.contacts.values())


def draw_loop(axes, biaxial):
    loads = [LOAD * (1 - math.cos(2 * math.pi * k / biaxial.per)) for k in range(3 * biaxial.per + 1)]
    axes.plot(loads, [g * 1e3 for g in biaxial.gamma[:len(loads)]], color=BLUE, linewidth=1)
    label(axes, f"{biaxial.name}: three cycles (figure 1)", "$q$ / p", r"$\gamma$ / 10$^{-3}$")
    print(f"largest |γ| of the first cycle {max(abs(g) for g in biaxial.gamma[:biaxial.per]):.4f}")


def draw_minima(axes, gamma, title, look):
    """Strains at the least load from cycle DROPPED on."""
    about_first = [g - gamma[0] for g in gamma]
    power = power_of(about_first)
    axes.plot(range(DROPPED, DROPPED + len(gamma)), [g / 10**power for g in about_first], look, markersize=3.5, linewidth=0.5, color=BLUE)
    label(axes, title, "cycle", rf"$\gamma$ less that of cycle {DROPPED} / 10$^{{{power}}}$")


def draw_ratcheting(axes, biaxial):
    gamma = biaxial.gamma[DROPPED * biaxial.per::biaxial.per]
    draw_minima(axes, gamma, "Strain at the least load (figure 2)", "o")
    print(f"slope {line_through(gamma)[0]:.3e} per cycle")


def draw_cycle(folder, out):
    run = next((r for r in long_runs(folder, "paths", "case") if r["case"] == "biaxial"), None)
    biaxial = Biaxial(run) if run else None
    needs = "figures 1 to 4, of paths.toml: case biaxial with 30 cycles or more"
    sliding = biaxial.paths if biaxial and biaxial.slides() else None
    compose("cycle.png", [(needs, biaxial, draw_loop), (needs, biaxial, draw_ratcheting),
                          ("figure 3, of a contact that slides" if biaxial else needs, sliding, draw_slip),
                          (needs, biaxial and biaxial.paths, draw_stick)], out)


def sine_fit(slopes):
    """A and R² of Δγ = A sin φ. slopes: Δγ by φ in degrees."""
    sines = {p: math.sin(math.radians(p)) for p in slopes}
    amplitude = sum(slopes[p] * sines[p] for p in slopes) / sum(s * s for s in sines.values())
    mean = sum(slopes.values()) / len(slopes)
    rest, spread = (sum((slopes[p] - fit(p)) ** 2 for p in slopes) for fit in (lambda p: amplitude * sines[p], lambda p: mean))
    return amplitude, 1 - rest / spread if spread > 0 else math.nan


def phases_of(folder):
    """Δγ by φ in degrees, of each case and packing that has three phases or more."""
    by_packing = {}
    for run in long_runs(folder, "elliptic", "case", PHASE):
        by_packing.setdefault((run["case"], int(run["seed"])), {})[float(run[PHASE]) + 90] = slope_of(run["path"])[0]
    return {key: slopes for key, slopes in by_packing.items() if len(slopes) > 2}


def draw_phases(axes, by_packing):
    for (case, seed), slopes in by_packing.items():
        amplitude, quality = sine_fit(slopes)
        largest = max(abs(s) for s in slopes.values())
        print(f"{case}, packing {seed}: A = {amplitude:.4e}, R² = {quality:.6f}, largest |Δγ| {largest:.2e}, {len(slopes)} phases")
        if case == "a third of the load":
            phases = sorted(slopes)
            axes.plot(phases, [slopes[p] / amplitude for p in phases], MARKS[seed % len(MARKS)], markersize=5, fillstyle="none",
                      label=f"{seed}: {amplitude:.1e}")
    axes.plot(range(0, 361), [math.sin(math.radians(p)) for p in range(0, 361)], color="black", linewidth=1, label=r"sin $\varphi$")
    axes.legend(title="packing: A per cycle", frameon=False, fontsize=8, title_fontsize=8)
    axes.set_xticks(range(0, 361, 60))
    label(axes, r"Strain per cycle without slip, $\Delta\sigma$ = 0.05 p (figure 5)", r"$\varphi$ / °", r"$\Delta\gamma$ / A")


def draw_ellipses(axes, runs):
    paths = {run["case"].split()[1]: Paths(run["path"]) for run in runs}
    widest = max(paths["90"].contacts, key=lambda c: abs(paths["90"].area(c)))
    for (phase, of_phase), colour in zip(paths.items(), (BLUE, ORANGE, GREEN, RED)):
        n, t, _ = of_phase.contacts[widest]
        area = of_phase.area(widest)
        axes.plot(n, t, color=colour, linewidth=1.2, label=phase)
        print(f"contact {widest}, phase {phase}: area {area:.4e} N², over that at 90: {area / paths['90'].area(widest):.4f}")
    axes.legend(title=r"$\varphi$ / °", frameon=False, fontsize=8, title_fontsize=8)
    label(axes, f"Packing {runs[0]['seed']}, {bodies_of(widest)} (figure 6)", "$F_n$ / N", "$F_t$ / N")


def draw_loads(folder, out):
    runs = [run for run in long_runs(folder, "paths", "case") if run["case"].startswith("phase ")]
    runs = runs if any(run["case"] == "phase 90" for run in runs) else []
    compose("ellipse.png", [("figure 5, of elliptic.toml: three phases or more, of 30 cycles or more", phases_of(folder), draw_phases),
                            ("figure 6, of paths.toml: case phase 90 with 30 cycles or more", runs, draw_ellipses)], out)


def draw_laws(axes, runs):
    """|Δγ| of the packings that ratchet, in descending order."""
    for case, colour, mark in (("Cundall and Strack", BLUE, "o"), ("corrected", RED, "x")):
        slopes = [slope for slope, rms in (slope_of(r["path"]) for r in runs if r["case"] == case) if rms < abs(slope)]
        count = sum(r["case"] == case for r in runs)
        if not slopes:
            print(f"{case}: 0 of {count} ratchet")
            continue
        ordered = sorted((abs(s) for s in slopes), reverse=True)
        axes.semilogy(range(1, len(ordered) + 1), ordered, mark, markersize=4, color=colour, label=case)
        mean = math.exp(sum(math.log(s) for s in ordered) / len(ordered))
        print(f"{case}: {len(ordered)} of {count} ratchet, {sum(s > 0 for s in slopes)} with slopes above 0,"
              f" {ordered[-1]:.2e} to {ordered[0]:.2e}, geometric mean {mean:.2e}")
    if axes.lines:
        axes.legend(frameon=False, fontsize=8)
    label(axes, "Packings that ratchet (figure 13)", "rank", r"$|\Delta\gamma|$ per cycle")


def lines_of(folder):
    """Δγ by step, of each law and packing that has two steps or more."""
    lines = {}
    for run in long_runs(folder, "steps", "contact.discs.plugin", "time.step"):
        lines.setdefault((run["contact.discs.plugin"], int(run["seed"])), {})[float(run["time.step"])] = slope_of(run["path"])[0]
    return {key: slopes for key, slopes in lines.items() if len(slopes) > 1}


def draw_over_steps(axes, lines):
    seeds = sorted({seed for _, seed in lines})
    named = set()
    for (law, seed), slopes in lines.items():
        sizes = sorted(slopes)
        exponent = math.log(abs(slopes[sizes[-1]] / slopes[sizes[0]])) / math.log(sizes[-1] / sizes[0])
        print(f"{LAWS[law]}, packing {seed}: " + ", ".join(f"{slopes[h]:.3e} at {h:g}" for h in sizes) + f"; exponent {exponent:.3f}")
        axes.loglog(sizes, [abs(slopes[h]) for h in sizes], "x-" if law == "disc_cundall_strack" else "o--", fillstyle="none", linewidth=1,
                    markersize=5, color=(BLUE, ORANGE, GREEN, RED, GREY, PURPLE)[seeds.index(seed) % 6],
                    label=None if seed in named else f"{seed}")
        named.add(seed)
    axes.set_ylim(bottom=axes.get_ylim()[0] / 20)
    axes.legend(title="crosses: Cundall and Strack, circles: corrected, of packings", frameon=False, fontsize=8, title_fontsize=8, ncols=3,
                loc="lower left")
    label(axes, "Strain per cycle over the step (figure 14)", r"step / $\tau$", r"$|\Delta\gamma|$ per cycle")


def draw_steps(folder, out):
    laws = [run for run in long_runs(folder, "laws", "case") if run["case"] in ("Cundall and Strack", "corrected")]
    both = "both laws, two steps or more of each, of 30 cycles or more"
    compose("steps.png", [("figure 13, of laws.toml: Cundall and Strack or corrected, 30 cycles or more", laws, draw_laws),
                          (f"figure 14, of steps.toml: {both}", lines_of(folder), draw_over_steps)], out)


def draw_strain(axes, run, title):
    draw_minima(axes, strains(run["path"], DROPPED)[DROPPED:], title.format(run["seed"]), "o-")


def draw_settling(axes, run):
    gamma = strains(run["path"], DROPPED)[DROPPED:]
    axes.semilogy(range(DROPPED, DROPPED + len(gamma) - 1), [abs(g - gamma[-1]) for g in gamma[:-1]], color=BLUE, linewidth=1)
    label(axes, f"Shakedown, packing {run['seed']} (figure 18)", "cycle", r"$|\gamma$ less that of the last cycle$|$")


def draw_rattlers(folder, out):
    runs = {run["case"]: run for run in long_runs(folder, "rattlers", "case")}
    outliers, periodic = runs.get("outliers"), runs.get("periodic")
    longest = {run["seed"]: run for run in long_runs(folder, "long")}
    for seed, run in longest.items():
        gamma = strains(run["path"], DROPPED)[DROPPED:]
        print(f"packing {seed}: range of {len(gamma) - 1} cycles {max(gamma) - min(gamma):.2e}")
    needs = "figures 15 and 16, of rattlers.toml: case outliers with 30 cycles or more"
    compose("rattlers.png", [
        (needs, outliers, lambda axes, run: draw_strain(axes, run, "A disc without contacts, packing {} (figure 15)")),
        (needs, outliers, draw_packing),
        ("figure 17, of rattlers.toml: case periodic with 30 cycles or more", periodic,
         lambda axes, run: draw_strain(axes, run, "Cycles that repeat, packing {} (figure 17)")),
        (f"figure 18, of long.toml: packing {SETTLING} with 30 cycles or more", longest.get(SETTLING), draw_settling)], out)


def main():
    folder, *others = arguments(__doc__, 1, 2)
    if not any(runs_of(os.path.join(folder, name)) for name in CAMPAIGNS):
        no_runs(folder, f"scenarios/mcnamara2008/{CAMPAIGNS[0]}.toml, or {', '.join(CAMPAIGNS[1:])},")
    for draw in (draw_cycle, draw_loads, draw_steps, draw_rattlers):
        draw(folder, others[0] if others else folder)


if __name__ == "__main__":
    main()
