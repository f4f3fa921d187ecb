"""Pictures of the gallery that show grains: angle of repose, Brazil nut, silo, column collapse."""
import math

import numpy
from curves import BLUE, BLUES, GREEN, GREY, ORANGE, RED, chart, draw_discs, save, wall
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle

GRAIN = "#cfd8e3"


def surface_of(bodies, length, bins):
    """x and z of the surface: mean top of the highest four beads of each bin, without the outer two on each side."""
    bin_of = (bodies.x / length * bins // 1).astype(int)
    tops = (bodies.z + bodies.radius).groupby(bin_of).apply(lambda top: top.nlargest(4).mean())
    inner = numpy.arange(2, bins - 2)
    return (inner + 0.5) * length / bins, tops[inner]


def angle_of_repose(run, _, path):
    """The tilted box, turned so that gravity points downwards."""
    tilt, length = math.radians(35), 0.156
    bodies = run.bodies().sort_values("y", ascending=False, kind="stable")
    slope, offset = numpy.polyfit(*surface_of(bodies, length, 20), 1)
    angle = 35 - math.degrees(math.atan(slope))
    print(f"  surface at {angle:.1f} degrees")

    def turned(x, z):
        return (x * math.cos(tilt) + z * math.sin(tilt)) * 1e3, (z * math.cos(tilt) - x * math.sin(tilt)) * 1e3

    figure, axes = chart(height=4.8)
    draw_discs(axes, *turned(bodies.x, bodies.z), bodies.radius * 1e3,
               BLUES(0.25 + 0.35 * (1 - bodies.y / 0.0208)))
    wall(axes, turned(0, 0.055), turned(0, 0), turned(length, 0), turned(length, 0.055))
    ends = [turned(x, slope * x + offset) for x in (0.1 * length, length)]
    axes.plot(*zip(*ends), color=RED, linewidth=2.5)
    (x_low, y_low) = ends[1]
    axes.plot([x_low - 125, x_low], [y_low, y_low], "--", color=GREY, linewidth=1.2)
    arc = numpy.linspace(math.pi, math.pi - math.radians(angle), 31)
    axes.plot(x_low + 90 * numpy.cos(arc), y_low + 90 * numpy.sin(arc), color=RED, linewidth=1.5)
    axes.annotate(f"{angle:.0f}°", (x_low - 101, y_low + 12), color=RED, fontsize=15, ha="center",
                  bbox={"boxstyle": "round", "facecolor": "white", "edgecolor": "none", "alpha": 0.85})
    axes.annotate("", (30, -62), (30, -42), arrowprops={"arrowstyle": "-|>", "color": GREY})
    axes.annotate("$g$", (33, -58), color=GREY, fontsize=13)
    axes.axis("off")
    save(figure, path)


def draw_grains(axes, bodies, colours, edge="#5f7186"):
    """Bodies as discs, in mm."""
    draw_discs(axes, bodies.x * 1e3, bodies.y * 1e3, bodies.radius * 1e3, colours, edge)


def brazil_nut(run, _, path):
    """The box at the end, with the place where the nut began, and the height of the nut over time."""
    figure, (box, rise) = chart(1, 2, gridspec_kw={"width_ratios": [1, 1.15]})
    bodies, nut, width = run.bodies(), run.series["nut"], 0.1026
    draw_grains(box, bodies, numpy.where(bodies.id == 1000, ORANGE, GRAIN))
    settled = nut.loc[(nut.time - 0.5).abs().idxmin()]
    box.add_patch(Circle((settled.x_1000 * 1e3, settled.y_1000 * 1e3), 10, fill=False, color=RED, linewidth=1.8,
                                linestyle="--"))
    wall(box, (0, 100), (0, 0), (width * 1e3, 0), (width * 1e3, 100))
    box.set(xlim=(-3, width * 1e3 + 3), ylim=(-3, 104))
    box.axis("off")
    rise.plot(nut.time - 0.5, nut.y_1000 * 1e3, color=ORANGE, linewidth=1.6)
    rise.axvspan(0, 1.0, color="#e8eef5")
    rise.annotate("$\\Gamma = 0.8$", (0.5, 0.97), xycoords=("data", "axes fraction"), ha="center", va="top", color=BLUE)
    rise.annotate("$\\Gamma = 3.2$", (4, 0.97), xycoords=("data", "axes fraction"), ha="center", va="top", color=BLUE)
    rise.set(xlabel="time (s)", ylabel="height of the nut (mm)", ylim=(0, 122))
    save(figure, path)


def draw_forces(axes, run, bodies):
    """A line for each contact, from centre to centre or to a wall, as wide as its normal force over the mean."""
    contacts, places = run.contacts(), bodies.set_index("id")[["x", "y"]]
    begin, end = places.loc[contacts.a].to_numpy(), contacts[["x", "y"]].to_numpy()
    between = contacts.b.notna().to_numpy()
    end[between] = places.loc[contacts.b.dropna()]
    force = (contacts.force_x * contacts.normal_x + contacts.force_y * contacts.normal_y).to_numpy()
    axes.add_collection(LineCollection(1e3 * numpy.stack([begin, end], 1), colors=RED,
                                       linewidths=0.9 * force / force.mean()))


def janssen(weight, deep):
    """Load (N) of the floor under a weight (N); deep: the load of a deep silo (N)."""
    return deep * (1 - numpy.exp(-weight / deep))


def silo_load(run):
    """Weight of the grains and mean load of the floor (N)."""
    return 9.81 * run.bodies().mass.sum(), run.series["measured"].normal_force_1.mean()


def fitted_saturation(weights, loads):
    """Load S of a deep silo, by least squares of Q = S (1 − exp(−G/S)) to weights G and loads Q."""
    tried = weights.max() * numpy.arange(20, 4000) / 2000
    return tried[((loads - janssen(weights, tried[:, None])) ** 2).sum(1).argmin()]


def silo(run, others, path):
    """The silo with its forces, and the load of its floor over the weight of the filling."""
    figure, (column_axes, law) = chart(1, 2, 5.2, gridspec_kw={"width_ratios": [1, 3.6]})
    bodies, width = run.bodies(), 0.0605
    draw_grains(column_axes, bodies, GRAIN, "#aab6c4")
    draw_forces(column_axes, run, bodies)
    low, high = (bodies.y - bodies.radius).min() * 1e3, bodies.y.max() * 1e3
    wall(column_axes, (0, high + 10), (0, low), (width * 1e3, low), (width * 1e3, high + 10), width=2)
    column_axes.set(xlim=(-3, width * 1e3 + 3), ylim=(low - 3, high + 12))
    column_axes.axis("off")
    weights, loads = numpy.array(sorted(silo_load(each) for each in [*others, run])).T
    deep = fitted_saturation(weights, loads)
    factor = silo_factor(deep, bodies, width)
    print(f"  load of a deep silo {deep:.1f} N, K = {factor:.2f}")
    law.plot(weights, loads, "o", color=BLUE, markersize=8, label="floor, five fillings", zorder=3)
    grid = numpy.linspace(0, weights[-1], 101)
    law.plot(grid, janssen(grid, deep), color=ORANGE, linewidth=2.5, label=f"Janssen, K = {factor:.2f}")
    law.plot(grid, grid, "--", color=GREY, linewidth=1.2, label="the whole weight, as of a fluid")
    law.set(xlabel="weight of the filling (N)", ylabel="load of the floor (N)")
    law.set(xlim=(0, weights[-1] * 1.04), ylim=(0, deep * 1.9))
    law.legend(frameon=False, loc="upper left")
    save(figure, path)


def silo_factor(deep, bodies, width, friction=0.25, density=1000):
    """K from the load S = ρ φ g W²/(2 μ K) (N) of a deep silo; φ: that of the lower four fifths of the filling."""
    low, high = (bodies.y - bodies.radius).min(), bodies.y.max()
    upper = low + 0.8 * (high - low)
    area = (math.pi * bodies.radius[bodies.y < upper] ** 2).sum()
    bulk = density * area / (width * (upper - low))
    return bulk * 9.81 * width**2 / (2 * friction * deep)


def connected_front(bodies, gap):
    """Largest x (m) of the discs that are joined to the wall at x = 0 by discs no further apart than the gap (m)."""
    reached, front = [], 0.0
    for x, y, radius in bodies.sort_values("x", kind="stable")[["x", "y", "radius"]].to_numpy():
        joined = any(math.hypot(r[0] - x, r[1] - y) < r[2] + radius + gap for r in reversed(reached))
        if x - radius < gap or joined:
            reached.append((x, y, radius))
            front = max(front, x + radius)
    return front


def column_collapse(run, others, path):
    """The heap, coloured by layers of the column, and the runout of columns of other heights."""
    figure, (heap, law) = chart(2, 1, 5.6, gridspec_kw={"height_ratios": [1.25, 1]})
    bodies, width, height = run.bodies(), 0.088, column_height(run)
    draw_grains(heap, bodies, numpy.where((bodies.id - 1) * 6 // len(bodies) % 2, "#e8b04a", BLUE), "none")
    front = connected_front(bodies, 1e-4)
    heap.plot([0, width * 1e3, width * 1e3], [height * 1e3] * 2 + [0], "--", color=GREY, linewidth=1.4)
    wall(heap, (0, height * 1e3), (0, 0), (1.06 * front * 1e3, 0))
    heap.plot([front * 1e3] * 2, [-3, 14], color=RED, linewidth=1.8)
    heap.annotate("front", (front * 1e3, 16), color=RED, ha="center")
    heap.set(xlim=(-4, 1.06 * front * 1e3), ylim=(-4, height * 1e3 + 4))
    heap.axis("off")
    points = sorted((column_height(each) / width, connected_front(each.bodies(), 1e-4) / width - 1)
                    for each in [*others, run])
    print("  " + ", ".join(f"a = {a:.2f}: runout {r:.2f}" for a, r in points))
    law.plot(*zip(*points), "o", color=BLUE, markersize=8, label="this column and three others", zorder=3)
    law.plot([0, 2], [0, 5], color=ORANGE, linewidth=2.5, label="discs: 2.5 a, 3.25 a$^{0.7}$ above 2")
    above = numpy.linspace(2, 3, 61)
    law.plot(above, 3.25 * above**0.7, color=ORANGE, linewidth=2.5)
    law.plot([0, 3], [0, 3.6], color=GREEN, linewidth=2.5, label="sand in a channel: 1.2 a")
    law.set(xlabel="height / width a of the column", ylabel="runout / width", xlim=(0, 3), ylim=(0, 7.5))
    law.legend(frameon=False, loc="upper left")
    save(figure, path)


def column_height(run):
    """Height (m) of the column before it collapses: twice the height of its centre of mass."""
    height = run.series["height"]
    return 2 * height[height.stage == 1].position_1.iloc[-1]
