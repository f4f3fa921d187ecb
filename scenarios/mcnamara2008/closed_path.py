"""Draws forces of contacts on a closed path, without slip and rotation, under three laws (figures 8 to 10 of
McNamara et al. 2008), and prints what each keeps of a round.

Usage: python3 scenarios/mcnamara2008/closed_path.py runs/closed-path [FOLDER for the picture, default: that of the run]
Needs a run of closed-path.toml, python3-matplotlib and python3-pandas."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "python"))
import scree  # noqa: E402 (of this tree)

scree.scripts.start("matplotlib", "pandas")
import numpy  # noqa: E402
from scree.charts import BLUE, GREEN, GREY, ORANGE, Curve, Panel, draw  # noqa: E402

LAWS = {2: ("Cundall and Strack", BLUE, "o"), 3: ("corrected", ORANGE, "s"), 4: ("painted points", GREEN, "^")}
SAMPLES = 100  # per round
STIFFNESS = 1.0  # N/m, of the tangential springs
LEGEND = {"loc": "upper left"}


def forces(rows, disc):
    """Normal and tangential force of the moved disc on another (N), t = n turned by +90 degrees."""
    apart = rows.x_1 - rows[f"x_{disc}"] + 1j * (rows.y_1 - rows[f"y_{disc}"])
    force = (rows[f"fx_{disc}"] + 1j * rows[f"fy_{disc}"]) * numpy.conj(apart) / abs(apart)
    return -numpy.real(force), numpy.imag(force)


def growth_of_a_round(rows, disc, points=4096):
    """∮ ρ dθ of the circle that the moved disc follows, ρ and θ as seen from the other (m)."""
    place = rows.x_1[0] * numpy.exp(2j * math.pi * numpy.arange(points) / points)
    apart = place - rows[f"x_{disc}"][0] - 1j * rows[f"y_{disc}"][0]
    return ((place * apart.conj()).real / abs(apart)).mean() * 2 * math.pi


def path_panel(rows):
    """The path of the moved disc, and where the others are."""
    def arrows(axes):
        for disc, (law, colour, _) in LAWS.items():
            x, y = (math.copysign(1, rows[f"{axis}_{disc}"][0]) for axis in "xy")
            axes.annotate("", xy=(11 * x, 11 * y), xytext=(0, 0), arrowprops={"arrowstyle": "->", "color": colour})
            axes.text(15 * x, 13 * y, law, color=colour, ha="center", va="center", fontsize=8)

    path = Curve(1e3 * rows.x_1[: SAMPLES + 1], 1e3 * rows.y_1[: SAMPLES + 1], color=GREY)
    return Panel("Path of the moved disc, directions to the others", "x / mm", "y / mm", path, arrows, xlim=(-25, 25),
                 ylim=(-17, 17), aspect="equal")


def plane_panel(rows, last):
    """Forces in the first and the last round, of the law that drifts and one that does not (figure 9)."""
    curves = []
    for disc, same in ((2, ""), (4, ", on the first")):
        law, colour, _ = LAWS[disc]
        normal, tangential = (1e3 * part for part in forces(rows, disc))
        for number, text, look in ((1, "", {"linewidth": 4, "alpha": 0.35}), (last, same, {"linestyle": "--"})):
            part = slice((number - 1) * SAMPLES, number * SAMPLES + 1)
            label = f"{law}, round {number}{text}"
            curves.append(Curve(normal[part], tangential[part], color=colour, label=label, **look))
    return Panel("Forces of two contacts (figure 9)", "$F_n$ / mN", "$F_t$ / mN", *curves, legend=LEGEND,
                 ylim=(-19, 38))


def rounds_panel(kept, growth):
    """Tangential force after whole rounds (figure 10)."""
    rounds = numpy.arange(len(kept[2]))
    curves = [Curve(rounds, 1e3 * kept[disc], mark, color=colour, markersize=5, fillstyle="none", label=law)
              for disc, (law, colour, mark) in LAWS.items()]
    curves.append(Curve(rounds[[0, -1]], 1e3 * STIFFNESS * growth * rounds[[0, -1]], color="black", linewidth=0.8,
                        label="$k_t$ ∮ ρ dθ per round"))
    return Panel("Tangential force after whole rounds (figure 10)", "rounds", "$F_t$ / mN", *curves, legend=LEGEND)


def main(folder, out=None):
    rows = scree.Result(folder).series.get("particles")
    if rows is None or len(rows) <= SAMPLES or any(f"fx_{disc}" not in rows for disc in LAWS):
        command = f"scree run scenarios/mcnamara2008/closed-path.toml --out {folder}"
        raise scree.Error(f"{folder}: not a round of closed-path.toml; run {command} first")
    kept = {disc: forces(rows, disc)[1][::SAMPLES] for disc in LAWS}
    for disc, (law, _, _) in LAWS.items():
        one, *_, last = kept[disc][1:] / STIFFNESS
        print(f"{law:20} {one:.6e} m after a round, {last:.6e} m after {len(kept[disc]) - 1};"
              f" ∮ρ dθ = {growth_of_a_round(rows, disc):.6e} m")
    panels = [path_panel(rows), plane_panel(rows, len(kept[2]) - 1), rounds_panel(kept, growth_of_a_round(rows, 2))]
    print(draw(pathlib.Path(out or folder, "closed-path.png"), panels, (13, 4.3)))


if __name__ == "__main__":
    main(*scree.scripts.arguments(__doc__, 1, 2))
