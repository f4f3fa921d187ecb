"""Draws figures 1 to 6 and 13 to 18 of McNamara et al. (2008) from the campaigns of this folder, and prints their numbers.

Usage: python3 scenarios/mcnamara2008/figures.py campaigns [FOLDER for the pictures, default: that of the campaigns]
Each picture needs its campaigns: cycle.png paths; ellipse.png elliptic, paths; steps.png steps, laws; rattlers.png rattlers, long.
Needs python3-matplotlib."""
import math
import os

from packing import draw_packing
from series import DROPPED, Paths, line_through, slope_of, strains
from style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, label, pyplot, save
from tables import arguments, no_runs, runs_of  # of the folder above, which series.py adds

LOAD = 0.15  # Δσ/p
FRICTION = 0.2
WALLS = {"wall1": "left wall", "wall2": "right wall", "wall3": "lower wall", "wall4": "upper wall"}
MARKS = "os^dv<>ph*"
SETTLING = "82"  # packing of long.toml that shakes down
PHASE = "stage.cycles.set.box.stress_x_high.phase_deg"


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
    label(axes, "Sticking contacts (figure 4)", "$F_n$ less its mean / N", "$F_t$ less its mean / N")


def draw_cycle(folder, out):
    run = next((r for r in runs_of(os.path.join(folder, "paths")) if r["case"] == "biaxial"), None)
    if run is None:
        return
    paths = Paths(run["path"])
    gamma, per = strains(run["path"], 0), paths.per_cycle
    figure, ((loop, minima), (slip, stick)) = pyplot.subplots(2, 2, figsize=(10, 8))
    loads = [LOAD * (1 - math.cos(2 * math.pi * k / per)) for k in range(3 * per + 1)]
    loop.plot(loads, [g * 1e3 for g in gamma[:len(loads)]], color=BLUE, linewidth=1)
    label(loop, "Three cycles (figure 1)", "$q$ / p", r"$\gamma$ / 10$^{-3}$")
    at_minima = [(g - gamma[DROPPED * per]) * 1e6 for g in gamma[DROPPED * per::per]]
    minima.plot(range(DROPPED, DROPPED + len(at_minima)), at_minima, "o", markersize=4, color=BLUE)
    label(minima, "Strain at the least load (figure 2)", "cycle", rf"$\gamma$ less that of cycle {DROPPED} / 10$^{{-6}}$")
    draw_slip(slip, paths)
    draw_stick(stick, paths)
    print(f"largest |γ| of the first cycle {max(abs(g) for g in gamma[:per]):.4f}, slope {line_through(at_minima)[0] * 1e-6:.3e} per cycle")
    save(figure, out, "cycle.png")


def sine_fit(slopes):
    """A and R² of Δγ = A sin φ. slopes: Δγ by φ in degrees."""
    sines = {p: math.sin(math.radians(p)) for p in slopes}
    amplitude = sum(slopes[p] * sines[p] for p in slopes) / sum(s * s for s in sines.values())
    mean = sum(slopes.values()) / len(slopes)
    rest = sum((slopes[p] - amplitude * sines[p]) ** 2 for p in slopes)
    return amplitude, 1 - rest / sum((s - mean) ** 2 for s in slopes.values())


def draw_phases(axes, folder):
    by_packing = {}
    for run in runs_of(os.path.join(folder, "elliptic")):
        slopes = by_packing.setdefault((run["case"], int(run["seed"])), {})
        slopes[float(run[PHASE]) + 90] = slope_of(run["path"])[0]
    for (case, seed), slopes in by_packing.items():
        amplitude, quality = sine_fit(slopes)
        largest = max(abs(s) for s in slopes.values())
        print(f"{case}, packing {seed}: A = {amplitude:.4e}, R² = {quality:.6f}, largest |Δγ| {largest:.2e}, {len(slopes)} phases")
        if case == "a third of the load":
            phases = sorted(slopes)
            axes.plot(phases, [slopes[p] / amplitude for p in phases], MARKS[seed % len(MARKS)], markersize=5, fillstyle="none", label=f"{seed}: {amplitude:.1e}")
    axes.plot(range(0, 361), [math.sin(math.radians(p)) for p in range(0, 361)], color="black", linewidth=1, label=r"sin $\varphi$")
    axes.legend(title="packing: A per cycle", frameon=False, fontsize=8, title_fontsize=8)
    axes.set_xticks(range(0, 361, 60))
    label(axes, r"Strain per cycle without slip, $\Delta\sigma$ = 0.05 p (figure 5)", r"$\varphi$ / °", r"$\Delta\gamma$ / A")


def draw_ellipses(axes, folder):
    runs = {r["case"]: Paths(r["path"]) for r in runs_of(os.path.join(folder, "paths")) if r["case"].startswith("phase")}
    if not runs:
        return
    widest = max(runs["phase 90"].contacts, key=lambda c: abs(runs["phase 90"].area(c)))
    for (case, paths), colour in zip(runs.items(), (BLUE, ORANGE, GREEN, RED)):
        n, t, _ = paths.contacts[widest]
        axes.plot(n, t, color=colour, linewidth=1.2, label=case.split()[1])
        print(f"contact {widest}, {case}: area {paths.area(widest):.4e} N², over that at 90: {paths.area(widest) / runs['phase 90'].area(widest):.4f}")
    axes.legend(title=r"$\varphi$ / °", frameon=False, fontsize=8, title_fontsize=8)
    label(axes, f"Contact of {bodies_of(widest)} (figure 6)", "$F_n$ / N", "$F_t$ / N")


def draw_loads(folder, out):
    if not runs_of(os.path.join(folder, "elliptic")):
        return
    figure, (phases, ellipses) = pyplot.subplots(1, 2, figsize=(10, 4.2))
    draw_phases(phases, folder)
    draw_ellipses(ellipses, folder)
    save(figure, out, "ellipse.png")


def draw_laws(axes, runs):
    """|Δγ| of the packings that ratchet, in descending order."""
    for case, colour, mark in (("Cundall and Strack", BLUE, "o"), ("corrected", RED, "x")):
        slopes = [slope for slope, rms in (slope_of(r["path"]) for r in runs if r["case"] == case) if rms < abs(slope)]
        if not slopes:
            continue
        ordered = sorted((abs(s) for s in slopes), reverse=True)
        axes.semilogy(range(1, len(ordered) + 1), ordered, mark, markersize=4, color=colour, label=case)
        mean = math.exp(sum(math.log(s) for s in ordered) / len(ordered))
        print(f"{case}: {len(ordered)} of {sum(r['case'] == case for r in runs)} ratchet, {sum(s > 0 for s in slopes)} with slopes above 0,"
              f" {ordered[-1]:.2e} to {ordered[0]:.2e}, geometric mean {mean:.2e}")
    axes.legend(frameon=False, fontsize=8)
    label(axes, "Packings that ratchet (figure 13)", "rank", r"$|\Delta\gamma|$ per cycle")


def draw_steps(folder, out):
    laws, steps = runs_of(os.path.join(folder, "laws")), runs_of(os.path.join(folder, "steps"))
    if not steps:
        return
    figure, panels = pyplot.subplots(1, 2 if laws else 1, figsize=(10 if laws else 5.5, 4.2), squeeze=False)
    over_steps = panels[0][-1]
    if laws:
        draw_laws(panels[0][0], laws)
    lines = {}
    for run in steps:
        key = (run["contact.discs.plugin"].removeprefix("disc_"), int(run["seed"]))
        lines.setdefault(key, {})[float(run["time.step"])] = slope_of(run["path"])[0]
    seeds = sorted({seed for _, seed in lines})
    for (law, seed), slopes in lines.items():
        sizes = sorted(slopes)
        exponent = math.log(slopes[sizes[-1]] / slopes[sizes[0]]) / math.log(sizes[-1] / sizes[0])
        print(f"{law}, packing {seed}: " + ", ".join(f"{slopes[h]:.3e} at {h:g}" for h in sizes) + f"; exponent {exponent:.3f}")
        over_steps.loglog(sizes, [abs(slopes[h]) for h in sizes], ("x-" if law == "cundall_strack" else "o--"), fillstyle="none", linewidth=1, markersize=5,
                          color=(BLUE, ORANGE, GREEN, RED, GREY, PURPLE)[seeds.index(seed) % 6],
                          label=f"{seed}" if law == "cundall_strack" else None)
    over_steps.set_ylim(bottom=over_steps.get_ylim()[0] / 20)
    over_steps.legend(title="crosses: Cundall and Strack, circles: corrected, of packings", frameon=False, fontsize=8, title_fontsize=8, ncols=3, loc="lower left")
    label(over_steps, "Strain per cycle over the step (figure 14)", r"step / $\tau$", r"$|\Delta\gamma|$ per cycle")
    save(figure, out, "steps.png")


def draw_strain(axes, path, title, logarithmic=False):
    gamma = strains(path, DROPPED)[DROPPED:]
    if logarithmic:
        axes.semilogy(range(DROPPED, DROPPED + len(gamma) - 1), [abs(g - gamma[-1]) for g in gamma[:-1]], color=BLUE, linewidth=1)
        return label(axes, title, "cycle", r"$|\gamma$ less that of the last cycle$|$")
    power = math.floor(math.log10(max(abs(g) for g in gamma)))
    axes.plot(range(DROPPED, DROPPED + len(gamma)), [g / 10**power for g in gamma], "o-", markersize=3, linewidth=0.5, color=BLUE)
    return label(axes, title, "cycle", rf"$\gamma$ less that of cycle {DROPPED} / 10$^{{{power}}}$")


def draw_rattlers(folder, out):
    rattlers = runs_of(os.path.join(folder, "rattlers"))
    runs, packings = ({r["case"]: r[key] for r in rattlers} for key in ("path", "seed"))
    longest = {r["seed"]: r["path"] for r in runs_of(os.path.join(folder, "long"))}
    if not runs or SETTLING not in longest:
        return
    figure, ((outliers, packing), (periodic, settling)) = pyplot.subplots(2, 2, figsize=(10, 8.4))
    draw_strain(outliers, runs["outliers"], f"Collisions of a disc without contacts, packing {packings['outliers']} (figure 15)")
    draw_packing(packing, runs["outliers"])
    if "periodic" in runs:
        draw_strain(periodic, runs["periodic"], f"Cycles that repeat, packing {packings['periodic']} (figure 17)")
    for seed, path in longest.items():
        gamma = strains(path, DROPPED)[DROPPED:]
        print(f"packing {seed}: range of {len(gamma) - 1} cycles {max(gamma) - min(gamma):.2e}")
    draw_strain(settling, longest[SETTLING], f"Shakedown, packing {SETTLING} (figure 18)", True)
    save(figure, out, "rattlers.png")


def main():
    folder, *others = arguments(__doc__, 1, 2)
    out = others[0] if others else folder
    if not any(runs_of(os.path.join(folder, name)) for name in ("paths", "elliptic", "steps", "rattlers")):
        no_runs(folder, "scenarios/mcnamara2008/paths.toml")
    for draw in (draw_cycle, draw_loads, draw_steps, draw_rattlers):
        draw(folder, out)


if __name__ == "__main__":
    main()
