"""Pictures of the gallery that show grains: angle of repose, Brazil nut, silo, column collapse."""
import math
import os

from curves import BLUE, GREEN, GREY, ORANGE, RED, chart, column, draw_discs, save, wall
from drawing import pyplot
from matplotlib.collections import LineCollection
from tables import read

GRAIN = "#cfd8e3"


def bodies_of(run):
    """(id, x, y, z, radius) of each body at the end of a run."""
    rows = read(os.path.join(run, "final_packing.csv"))
    return [(int(r["id"]), float(r["x"]), float(r["y"]), float(r.get("z") or 0), float(r["radius"])) for r in rows]


def in_mm(bodies):
    """(x, y, radius) of discs."""
    return [(x * 1e3, y * 1e3, radius * 1e3) for _, x, y, _, radius in bodies]


def fitted_line(points):
    """Slope and height at 0 of the straight line through points, by least squares."""
    count, x_mean, y_mean = len(points), *(sum(p[i] for p in points) / len(points) for i in (0, 1))
    slope = sum((x - x_mean) * (y - y_mean) for x, y in points) / sum((x - x_mean) ** 2 for x, _ in points)
    return slope, y_mean - slope * x_mean


def surface_of(bodies, length, bins):
    """(x, z) of the surface: mean top of the highest four beads of each bin, without the outer two on each side."""
    points = []
    for k in range(2, bins - 2):
        tops = sorted(z + radius for _, x, _, z, radius in bodies if k <= x / length * bins < k + 1)[-4:]
        points.append(((k + 0.5) * length / bins, sum(tops) / len(tops)))
    return points


def angle_of_repose(run, _, path):
    """The tilted box, turned so that gravity points downwards."""
    tilt, length = math.radians(35), 0.156
    bodies = bodies_of(run)
    slope, offset = fitted_line(surface_of(bodies, length, 20))
    angle = 35 - math.degrees(math.atan(slope))
    print(f"  surface at {angle:.1f} degrees")

    def turned(x, z):
        return (x * math.cos(tilt) + z * math.sin(tilt)) * 1e3, (z * math.cos(tilt) - x * math.sin(tilt)) * 1e3

    figure, axes = chart(height=4.8)
    ordered = sorted(bodies, key=lambda body: -body[2])
    shades = [pyplot.cm.Blues(0.25 + 0.35 * (1 - body[2] / 0.0208)) for body in ordered]
    draw_discs(axes, [(*turned(x, z), radius * 1e3) for _, x, _, z, radius in ordered], shades)
    wall(axes, turned(0, 0.055), turned(0, 0), turned(length, 0), turned(length, 0.055))
    ends = [turned(x, slope * x + offset) for x in (0.1 * length, length)]
    axes.plot(*zip(*ends), color=RED, linewidth=2.5)
    (x_low, y_low) = ends[1]
    axes.plot([x_low - 125, x_low], [y_low, y_low], "--", color=GREY, linewidth=1.2)
    arc = [math.pi - math.radians(angle) * k / 30 for k in range(31)]
    axes.plot(*zip(*((x_low + 90 * math.cos(a), y_low + 90 * math.sin(a)) for a in arc)), color=RED, linewidth=1.5)
    axes.annotate(f"{angle:.0f}°", (x_low - 101, y_low + 12), color=RED, fontsize=15, ha="center",
                  bbox={"boxstyle": "round", "facecolor": "white", "edgecolor": "none", "alpha": 0.85})
    axes.annotate("", (30, -62), (30, -42), arrowprops={"arrowstyle": "-|>", "color": GREY})
    axes.annotate("$g$", (33, -58), color=GREY, fontsize=13)
    axes.axis("off")
    save(figure, path)


def brazil_nut(run, _, path):
    """The box at the end, with the place where the nut began, and the height of the nut over time."""
    figure, (box, rise) = chart(1, 2, gridspec_kw={"width_ratios": [1, 1.15]})
    bodies, width = bodies_of(run), 0.1026
    draw_discs(box, in_mm(bodies), [ORANGE if body[0] == 1000 else GRAIN for body in bodies])
    times, heights = column(run, "nut", "time"), column(run, "nut", "y_1000")
    settled = min(range(len(times)), key=lambda k: abs(times[k] - 0.5))
    place = column(run, "nut", "x_1000")[settled] * 1e3, heights[settled] * 1e3
    box.add_patch(pyplot.Circle(place, 10, fill=False, color=RED, linewidth=1.8, linestyle="--"))
    wall(box, (0, 100), (0, 0), (width * 1e3, 0), (width * 1e3, 100))
    box.set(xlim=(-3, width * 1e3 + 3), ylim=(-3, 104))
    box.axis("off")
    rise.plot([t - 0.5 for t in times], [h * 1e3 for h in heights], color=ORANGE, linewidth=1.6)
    rise.axvspan(0, 1.0, color="#e8eef5")
    rise.annotate("$\\Gamma = 0.8$", (0.5, 0.97), xycoords=("data", "axes fraction"), ha="center", va="top", color=BLUE)
    rise.annotate("$\\Gamma = 3.2$", (4, 0.97), xycoords=("data", "axes fraction"), ha="center", va="top", color=BLUE)
    rise.set(xlabel="time (s)", ylabel="height of the nut (mm)", ylim=(0, 122))
    save(figure, path)


def contacts_of(bodies, width, stiffness):
    """Normal forces (N) of a packing of discs between two walls: ((x, y) of both ends, force)."""
    cell = max(body[4] for body in bodies) * 2
    cells, found = {}, []
    for body in bodies:
        cells.setdefault((int(body[1] // cell), int(body[2] // cell)), []).append(body)
    for body in bodies:
        _, x, y, _, radius = body
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                for other in cells.get((int(x // cell) + i, int(y // cell) + j), []):
                    overlap = radius + other[4] - math.hypot(other[1] - x, other[2] - y)
                    if other[0] > body[0] and overlap > 0:
                        found.append((((x, y), (other[1], other[2])), overlap * stiffness))
        for at in (0, width):
            if radius > abs(x - at):
                found.append((((x, y), (at, y)), (radius - abs(x - at)) * stiffness))
    return found


def janssen(weight, deep):
    """Load (N) of the floor under a weight (N); deep: the load of a deep silo (N)."""
    return deep * (1 - math.exp(-weight / deep))


def silo_load(run):
    """Weight of the grains and mean load of the floor (N)."""
    rows = read(os.path.join(run, "final_packing.csv"))
    force = column(run, "measured", "normal_force_1")
    return 9.81 * sum(float(row["mass"]) for row in rows), sum(force) / len(force)


def fitted_saturation(loads):
    """Load S of a deep silo, by least squares of Q = S (1 − exp(−G/S)) to weights G and loads Q."""
    largest = max(weight for weight, _ in loads)
    tried = [largest * k / 2000 for k in range(20, 4000)]
    return min(tried, key=lambda s: sum((q - janssen(g, s)) ** 2 for g, q in loads))


def silo(run, others, path):
    """The silo with its forces, and the load of its floor over the weight of the filling."""
    figure, (column_axes, law) = chart(1, 2, 5.2, gridspec_kw={"width_ratios": [1, 3.6]})
    bodies, width = bodies_of(run), 0.0605
    draw_discs(column_axes, in_mm(bodies), [GRAIN] * len(bodies), "#aab6c4")
    forces = contacts_of(bodies, width, 2e5)
    mean = sum(force for _, force in forces) / len(forces)
    column_axes.add_collection(LineCollection([[(x * 1e3, y * 1e3) for x, y in ends] for ends, _ in forces], colors=RED,
                                              linewidths=[0.9 * force / mean for _, force in forces]))
    low, high = min(y - radius for _, _, y, _, radius in bodies) * 1e3, max(y for _, _, y, _, _ in bodies) * 1e3
    wall(column_axes, (0, high + 10), (0, low), (width * 1e3, low), (width * 1e3, high + 10), width=2)
    column_axes.set(xlim=(-3, width * 1e3 + 3), ylim=(low - 3, high + 12))
    column_axes.axis("off")
    loads = sorted(silo_load(each) for each in [*others, run])
    deep = fitted_saturation(loads)
    factor = silo_factor(deep, bodies, width)
    print(f"  load of a deep silo {deep:.1f} N, K = {factor:.2f}")
    law.plot(*zip(*loads), "o", color=BLUE, markersize=8, label="floor, five fillings", zorder=3)
    grid = [loads[-1][0] * k / 100 for k in range(101)]
    fitted = [janssen(g, deep) for g in grid]
    law.plot(grid, fitted, color=ORANGE, linewidth=2.5, label=f"Janssen, K = {factor:.2f}")
    law.plot(grid, grid, "--", color=GREY, linewidth=1.2, label="the whole weight, as of a fluid")
    law.set(xlabel="weight of the filling (N)", ylabel="load of the floor (N)")
    law.set(xlim=(0, loads[-1][0] * 1.04), ylim=(0, deep * 1.9))
    law.legend(frameon=False, loc="upper left")
    save(figure, path)


def silo_factor(deep, bodies, width, friction=0.25, density=1000):
    """K from the load S = ρ φ g W²/(2 μ K) (N) of a deep silo; φ: that of the lower four fifths of the filling."""
    low, high = min(b[2] - b[4] for b in bodies), max(b[2] for b in bodies)
    upper = low + 0.8 * (high - low)
    area = sum(math.pi * b[4] ** 2 for b in bodies if b[2] < upper)
    bulk = density * area / (width * (upper - low))
    return bulk * 9.81 * width**2 / (2 * friction * deep)


def connected_front(bodies, gap):
    """Largest x (m) of the discs that are joined to the wall at x = 0 by discs no further apart than the gap (m)."""
    reached, front = [], 0.0
    for _, x, y, _, radius in sorted(bodies, key=lambda body: body[1]):
        joined = any(math.hypot(r[0] - x, r[1] - y) < r[2] + radius + gap for r in reversed(reached))
        if x - radius < gap or joined:
            reached.append((x, y, radius))
            front = max(front, x + radius)
    return front


def column_collapse(run, others, path):
    """The heap, coloured by layers of the column, and the runout of columns of other heights."""
    figure, (heap, law) = chart(2, 1, 5.6, gridspec_kw={"height_ratios": [1.25, 1]})
    bodies, width = bodies_of(run), 0.088
    count = len(bodies)
    height = column_height(run)
    bands = [BLUE, "#e8b04a"]
    draw_discs(heap, in_mm(bodies), [bands[(body[0] - 1) * 6 // count % 2] for body in bodies], "none")
    front = connected_front(bodies, 1e-4)
    heap.plot([0, width * 1e3, width * 1e3], [height * 1e3] * 2 + [0], "--", color=GREY, linewidth=1.4)
    wall(heap, (0, height * 1e3), (0, 0), (1.06 * front * 1e3, 0))
    heap.plot([front * 1e3] * 2, [-3, 14], color=RED, linewidth=1.8)
    heap.annotate("front", (front * 1e3, 16), color=RED, ha="center")
    heap.set(xlim=(-4, 1.06 * front * 1e3), ylim=(-4, height * 1e3 + 4))
    heap.axis("off")
    points = sorted((column_height(each) / width, connected_front(bodies_of(each), 1e-4) / width - 1)
                    for each in [*others, run])
    print("  " + ", ".join(f"a = {a:.2f}: runout {r:.2f}" for a, r in points))
    law.plot(*zip(*points), "o", color=BLUE, markersize=8, label="this column and three others", zorder=3)
    law.plot([0, 2], [0, 5], color=ORANGE, linewidth=2.5, label="discs: 2.5 a, 3.25 a$^{0.7}$ above 2")
    above = [2 + k / 60 for k in range(61)]
    law.plot(above, [3.25 * a**0.7 for a in above], color=ORANGE, linewidth=2.5)
    law.plot([0, 3], [0, 3.6], color=GREEN, linewidth=2.5, label="sand in a channel: 1.2 a")
    law.set(xlabel="height / width a of the column", ylabel="runout / width", xlim=(0, 3), ylim=(0, 7.5))
    law.legend(frameon=False, loc="upper left")
    save(figure, path)


def column_height(run):
    """Height (m) of the column before it collapses: twice the height of its centre of mass."""
    rows = [row for row in read(os.path.join(run, "series", "height.csv")) if row["stage"] == "1"]
    return 2 * float(rows[-1]["position_1"])
