"""Draws forces of contacts on a closed path, without slip and rotation, under three laws (figures 8 to 10 of
McNamara et al. 2008), and prints what each keeps of a round.

Usage: python3 scenarios/mcnamara2008/closed_path.py runs/closed-path [FOLDER for the picture, default: that of the run]
Needs a run of closed-path.toml, python3-matplotlib and python3-pandas."""
import math

from series import arguments, numpy, refuse, scree
from style import BLUE, GREEN, GREY, ORANGE, label, pyplot, save

LAWS = {2: ("Cundall and Strack", BLUE, "o"), 3: ("corrected", ORANGE, "s"), 4: ("painted points", GREEN, "^")}
SAMPLES = 100  # per round
STIFFNESS = 1.0  # N/m, of the tangential springs


def forces(rows, disc):
    """Normal and tangential force of the moved disc on another (N), t = n turned by +90 degrees."""
    x, y = rows.x_1 - rows[f"x_{disc}"], rows.y_1 - rows[f"y_{disc}"]
    distance, fx, fy = numpy.hypot(x, y), rows[f"fx_{disc}"], rows[f"fy_{disc}"]
    return -(fx * x + fy * y) / distance, (fy * x - fx * y) / distance


def growth_of_a_round(rows, disc, points=4096):
    """∮ ρ dθ of the circle that the moved disc follows, ρ and θ as seen from the other (m)."""
    radius, angle = rows.x_1[0], 2 * math.pi * numpy.arange(points) / points
    along, aside = radius * numpy.cos(angle) - rows[f"x_{disc}"][0], radius * numpy.sin(angle) - rows[f"y_{disc}"][0]
    turned = along * radius * numpy.cos(angle) + aside * radius * numpy.sin(angle)
    return (turned / numpy.hypot(along, aside)).mean() * 2 * math.pi


def draw(rows, out):
    figure, (path, plane, rounds) = pyplot.subplots(1, 3, figsize=(13, 4.3))
    path.plot(1e3 * rows.x_1[: SAMPLES + 1], 1e3 * rows.y_1[: SAMPLES + 1], color=GREY)
    for disc, (law, colour, _) in LAWS.items():
        side = [math.copysign(1, rows[f"{axis}_{disc}"][0]) for axis in "xy"]
        path.annotate("", xy=[11 * s for s in side], xytext=(0, 0), arrowprops={"arrowstyle": "->", "color": colour})
        path.text(15 * side[0], 13 * side[1], law, color=colour, ha="center", va="center", fontsize=8)
    label(path, "Path of the moved disc, directions to the others", "x / mm", "y / mm")
    path.set(xlim=(-25, 25), ylim=(-17, 17), aspect="equal")
    for disc in (2, 4):
        law, colour, _ = LAWS[disc]
        normal, tangential = (1e3 * part for part in forces(rows, disc))
        last = (len(rows) - 1) // SAMPLES
        same = ", on the first" if law == "painted points" else ""
        for number, text, look in ((1, "", {"linewidth": 4, "alpha": 0.35}), (last, same, {"linestyle": "--"})):
            part = slice((number - 1) * SAMPLES, number * SAMPLES + 1)
            plane.plot(normal[part], tangential[part], color=colour, label=f"{law}, round {number}{text}", **look)
    plane.set_ylim(-19, 38)
    label(plane, "Forces of two contacts (figure 9)", "$F_n$ / mN", "$F_t$ / mN")
    for disc, (law, colour, mark) in LAWS.items():
        kept = 1e3 * forces(rows, disc)[1][::SAMPLES]
        rounds.plot(range(len(kept)), kept, mark, color=colour, markersize=5, fillstyle="none", label=law)
    growth = 1e3 * STIFFNESS * growth_of_a_round(rows, 2)
    rounds.plot([0, last], [0, last * growth], color="black", linewidth=0.8, label="$k_t$ ∮ ρ dθ per round")
    label(rounds, "Tangential force after whole rounds (figure 10)", "rounds", "$F_t$ / mN")
    for axes in (plane, rounds):
        axes.legend(frameon=False, fontsize=8, loc="upper left")
    save(figure, out, "closed-path.png")


def main():
    folder, *out = arguments(__doc__, 1, 2)
    try:
        rows = scree.read(folder).series["particles"]
    except scree.Error as error:
        refuse(f"{error}; or run scree run scenarios/mcnamara2008/closed-path.toml --out {folder} first")
    if len(rows) <= SAMPLES or any(f"fx_{disc}" not in rows for disc in LAWS):
        refuse(f"{folder}: not a round of scenarios/mcnamara2008/closed-path.toml; give the folder of a run of it")
    for disc, (law, _, _) in LAWS.items():
        kept = forces(rows, disc)[1][::SAMPLES].to_numpy()
        print(
            f"{law:20} {kept[1] / STIFFNESS:.6e} m after a round, {kept[-1] / STIFFNESS:.6e} m after {len(kept) - 1};"
            f" ∮ρ dθ = {growth_of_a_round(rows, disc):.6e} m"
        )
    draw(rows, *(out or [folder]))


if __name__ == "__main__":
    main()
