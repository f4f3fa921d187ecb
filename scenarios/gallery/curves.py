"""Pictures of the gallery that are charts: bouncing ball, gas that cools, piston, wave in a chain."""
import math

import numpy
import scree
from matplotlib import colormaps
from matplotlib.collections import EllipseCollection
from matplotlib.patches import Rectangle
from scree.charts import BLUE, ORANGE, RED

GREEN, GREY = "#2e8b6f", "#777777"
BLUES = colormaps["Blues"]


def chart(rows=1, columns=1, height=4.2, **options):
    """Figure and axes, without the lines above and on the right."""
    figure, axes = scree.charts.blank(rows, columns, (6.4, height), **options)
    for each in figure.axes:
        each.spines[["top", "right"]].set_visible(False)
    return figure, axes.flat if axes.size > 1 else axes[0, 0]


def save(figure, path):
    print("  " + scree.charts.save(figure, path, dpi=100))


def draw_discs(axes, x, y, radius, colours, edge="#5f7186"):
    """Discs in the units of the axes."""
    places = {"offsets": numpy.column_stack([x, y]), "units": "xy", "transOffset": axes.transData}
    axes.add_collection(EllipseCollection(2 * radius, 2 * radius, 0 * radius, facecolors=colours,
                                          edgecolors=edge, linewidths=0.4, **places))
    axes.set_aspect("equal")


def wall(axes, *points, width=3):
    axes.plot(*zip(*points), color="#333333", linewidth=width, solid_capstyle="projecting", clip_on=False, zorder=3)


def bouncing_ball(run, _, path):
    """Heights over time, with the heights h e^(2n) and the times of rest."""
    figure, axes = chart()
    balls, radius, fall = run.series["path"], 0.02, math.sqrt(2 / 9.81)
    for body, e, colour, label in ((1, 0.8, BLUE, 0.15), (2, 0.65, GREEN, 0.36), (3, 0.5, ORANGE, 0.55)):
        axes.plot(balls.time, balls[f"z_{body}"] - radius, color=colour, linewidth=1.6, label=f"e = {e}")
        apex = [fall * (1 + 2 * sum(e**k for k in range(1, n)) + e**n) for n in range(1, 9)]
        axes.plot(apex, [e ** (2 * n) for n in range(1, 9)], "o", color=colour, markersize=7, fillstyle="none")
        rest = fall * (1 + e) / (1 - e)
        axes.plot([rest], [0], marker="^", color=colour, markersize=10, clip_on=False, zorder=3)
        axes.plot([rest, rest], [0, label], ":", color=colour, linewidth=1.2)
        axes.annotate(f"$t_\\infty$ = {rest:.2f} s", (rest, label), (0, 3), textcoords="offset points",
                      ha="center", color=colour)
    axes.plot([], [], "o", color=GREY, fillstyle="none", markersize=7, label="$h\\,e^{2n}$")
    axes.plot([], [], "^", color=GREY, markersize=9, label="$t_\\infty = \\sqrt{2h/g}\\,(1+e)/(1-e)$")
    axes.set(xlabel="time (s)", ylabel="height above the floor (m)", ylim=(0, 1.02), xlim=(0, 4.4))
    axes.legend(frameon=False, loc="upper right")
    save(figure, path)


def haff(energy, drift, bodies=512, side=0.033, radius=0.001, density=2500, e=0.9):
    """1/t_H (1/s) of the gas with the energy (J) of the motion about the drift: head of gas-that-cools.toml."""
    mass = bodies * density * 4 / 3 * math.pi * radius**3
    share = mass / density / side**3
    contact = (1 - share / 2) / (1 - share) ** 3
    speed = math.sqrt(2 * (energy - drift) / 3 / mass)
    rate = 4 * math.sqrt(math.pi) * bodies / side**3 * 4 * radius**2 * contact * speed
    sonine = 16 * (1 - e) * (1 - 2 * e**2) / (81 - 17 * e + 30 * e**2 * (1 - e))
    return rate * (1 - e**2) / 6 * (1 + 3 * sonine / 16)


def drift_energy(momentum, bodies=512, radius=0.001, density=2500):
    """Kinetic energy (J) of the mean motion, which collisions keep."""
    mass = bodies * density * 4 / 3 * math.pi * radius**3
    return (momentum.loc[0, ["momentum_x", "momentum_y", "momentum_z"]] ** 2).sum() / 2 / mass


def gas_that_cools(run, _, path):
    """Energy over time, both over their scales, on logarithmic axes."""
    figure, axes = chart()
    gas, drift = run.series["energy"], drift_energy(run.series["momentum"])
    start = gas.kinetic_translation[0]
    gas = gas[gas.time > 0.05]
    line = numpy.geomspace(0.01, 10, 151)
    axes.plot(line, (1 + line) ** -2, color=ORANGE, linewidth=3.5, alpha=0.75, label="Haff: $(1+t/t_H)^{-2}$")
    axes.plot(line, line**-2, "--", color=GREY, linewidth=1, label="$(t/t_H)^{-2}$")
    chosen = gas.iloc[[min(int(1.35**k), len(gas)) - 1 for k in range(20)]]
    axes.plot((chosen.time - 0.05) * haff(start, drift), (chosen.kinetic_translation - drift) / (start - drift), "o",
              color=BLUE, markersize=6, label="512 beads, e = 0.9")
    axes.set(xscale="log", yscale="log", xlim=(0.012, 8), ylim=(0.015, 1.5))
    axes.set(xlabel="time / $t_H$", ylabel="energy / energy at the start")
    axes.legend(frameon=False, loc="lower left")
    save(figure, path)


def hard_sphere_factor(share):
    """p V/(N T) of hard spheres, after Carnahan and Starling, over the volume fraction."""
    return (1 + share + share**2 - share**3) / (1 - share) ** 3


def adiabat(share, start):
    """Temperature over that at the start: head of piston.toml."""
    excess = [x * (4 - 3 * x) / (1 - x) ** 2 for x in (share, start)]
    return (share / start) ** (2 / 3) * numpy.exp(2 / 3 * (excess[0] - excess[1]))


def piston(run, _, path):
    """The gas below its piston, and pressure over volume with the adiabats of the ideal gas and of hard spheres."""
    figure, (gas, axes) = chart(1, 2, gridspec_kw={"width_ratios": [1, 2.2]})
    beads = run.bodies().sort_values("y", ascending=False, kind="stable")
    draw_discs(gas, beads.x % 0.05 * 1e3, beads.z * 1e3, 1 + 0 * beads.x,
               BLUES(0.75 - 0.5 * (beads.y % 0.05) / 0.05))
    wall(gas, (0, 58), (0, 0), (50, 0), (50, 58))
    gas.add_patch(Rectangle((0, 27), 50, 4, color="#333333"))
    gas.plot([0, 50], [52, 52], "--", color=GREY, linewidth=1.2)
    gas.annotate("", (25, 34), (25, 50), arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 1.5})
    gas.set(xlim=(-2, 52), ylim=(-2, 60))
    gas.axis("off")
    height = numpy.linspace(0.05, 0.025, 101)
    share, start = (512 * math.pi / 6 * 0.002**3 / (0.05**2 * z) for z in (height, 0.05))
    pressure = 2 / 3 * run.series["before"].kinetic_translation.mean() / (0.05**2 * height)
    axes.plot(height / 0.05, pressure * adiabat(share, start) * hard_sphere_factor(share), color=ORANGE, linewidth=3.5,
              alpha=0.75, label="adiabat of hard spheres")
    axes.plot(height / 0.05, pressure * (0.05 / height) ** (2 / 3), "--", color=GREEN,
              label="adiabat of the ideal gas, $p \\propto V^{-5/3}$")
    axes.plot(height / 0.05, pressure, ":", color=GREY, label="isotherm, $p \\propto V^{-1}$")
    walls = run.series["walls"].query("stage == 2").reset_index(drop=True)
    means = walls.groupby(walls.index // 830).mean()[: len(walls) // 830]
    force = (means.normal_force_1 + means.normal_force_2) / 2
    axes.plot((0.05 - means.displacement_z_2.abs()) / 0.05, force / 0.05**2, "o", color=BLUE, markersize=6, label="512 beads")
    axes.set(xlabel="volume / volume at the start", ylabel="pressure (Pa)", xlim=(1.02, 0.48))
    axes.legend(frameon=False, loc="upper left")
    save(figure, path)


def bessel(order, x, points=2000):
    """J of an even order: the mean of cos(order s − x sin s) over half a turn, by the trapezoidal rule."""
    turns = math.pi * (numpy.arange(points) + 0.5) / points
    return numpy.cos(order * turns - x * numpy.sin(turns)).mean()


def wave_in_a_chain(run, _, path):
    """Speeds of all balls at the end against the Bessel functions, and the front."""
    figure, axes = chart()
    packing = run.bodies()
    frequency = 80 / run.scenario["stage"][0]["duration"]
    balls = range(-50, 51)
    axes.axhline(0, color="#cccccc", linewidth=0.8)
    law = [bessel(2 * abs(n), 80) for n in balls]
    axes.vlines(balls, 0, law, color=ORANGE, linewidth=4, alpha=0.8, label="$v_0\\,J_{2n}(\\omega_m t)$")
    axes.plot(packing.id - 51, packing.vx / 1e-4, "o", color=BLUE, markersize=4, label="steel balls")
    for side in (-1, 1):
        axes.axvline(side * 40, color=GREEN, linewidth=1.2, linestyle="--")
    axes.annotate("$c\\,t = 40$ balls", (40, 0.17), (-4, 0), textcoords="offset points", ha="right", color=GREEN)
    axes.set(xlabel="ball", ylabel="speed / speed of the hit", xlim=(-50.5, 50.5), ylim=(-0.15, 0.24),
             title=f"$\\omega_m t = 80$, $c = {0.009995 * frequency / 2:.0f}$ m/s")
    axes.legend(frameon=False, loc="upper center", ncols=2)
    save(figure, path)
