"""Draws error against time from the files of `tools/bench/peers --error --record`.

Arguments: table, ladder, chart to write, name of the machine."""
import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402 (the choice of the backend comes first)

CODES = {  # name, colour, marker
    "scree": ("scree", "#0b5fa5", "o"),
    "liggghts": ("LIGGGHTS 3.8", "#d1495b", "s"),
    "lammps": ("LAMMPS (29 September 2021)", "#c27c0e", "^"),
}
GREY = "#555555"


def read(path):
    with open(path) as lines:
        return list(csv.DictReader(lines))


def verdict(axes, table, case):
    """Ratios of times at one error, in a corner without curves."""
    row = next((r for r in table if r["case"] == case and r["error"] == "1e-3"), None)
    if not row:
        return
    lines = [(f"{CODES[code][0].split(' ')[0]} {row[f'{code}_time_ratio']} ×", CODES[code][1])
             for code in ("liggghts", "lammps") if row[f"{code}_time_ratio"]]
    if row["scree_steps"][0] in ">?":
        lines = [("scree: 1e-3 not shown", CODES["scree"][1])]
    for k, (text, colour) in enumerate(lines):
        axes.text(0.98, 0.97 - 0.1 * k, text, transform=axes.transAxes, fontsize=10, color=colour, ha="right", va="top")


def curve(axes, rows, code):
    """Points, hollow if not resolved by the reference, and a line through all."""
    _, colour, marker = CODES[code]
    points = [(float(r["time"]), float(r["value"]), r["resolved"] == "yes") for r in rows if r["code"] == code]
    points = [point for point in points if math.isfinite(point[1])]
    for resolved, fill in ((True, colour), (False, "white")):
        times, errors = ([p[k] for p in points if p[2] == resolved] for k in (0, 1))
        axes.plot(times, errors, color=colour, marker=marker, markersize=4, markerfacecolor=fill, linewidth=0, zorder=3)
    axes.plot([p[0] for p in points], [p[1] for p in points], color=colour, linewidth=1.3, alpha=0.8)


def panel(axes, rows, limits):
    for code in CODES:
        curve(axes, rows, code)
    axes.set(xscale="log", yscale="log", xlim=limits, ylim=(1e-5, 1))
    for target in (1e-2, 1e-3, 1e-4):
        axes.axhline(target, color="#999999", linewidth=0.8, linestyle=(0, (4, 3)), zorder=0)
    axes.set_title(rows[0]["title"], fontsize=11, loc="left")
    axes.set_xlabel(f"time of a {rows[0]['of']}, {rows[0]['unit']}", fontsize=9)
    axes.tick_params(labelsize=8.5)
    axes.xaxis.set_minor_formatter(ticker.NullFormatter())
    axes.grid(True, which="major", axis="x", color="#eeeeee", linewidth=0.6)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def limits(ladder, of):
    """Equal axes for all panels of a kind, for comparison; points below the panels are ignored."""
    times = [float(row["time"]) for row in ladder if row["of"] == of and 1e-5 <= float(row["value"]) <= 1]
    return min(times) / 1.5, max(times) * 1.5


def head(figure, machine):
    height = figure.get_figheight()
    handles = [pyplot.Line2D([], [], color=colour, marker=marker, markersize=6, linewidth=1.6, label=name)
               for name, colour, marker in CODES.values()]
    figure.suptitle("Error against time on one core: lower left is better", x=0.012, y=1 - 0.1 / height, ha="left",
                    va="top", fontsize=16)
    caption = ("Error of each code relative to its own converged result; each point is a time step, hollow points are not "
               f"resolved by the reference.\nNumbers: time for an error of 1e-3 over the time of scree. {machine}")
    figure.text(0.012, 1 - 0.48 / height, caption, fontsize=10, color=GREY, va="top")
    figure.legend(handles=handles, loc="upper right", ncol=3, frameon=False, fontsize=12, bbox_to_anchor=(0.995, 1))
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.75 / height), w_pad=1.5, h_pad=1.5)


def main(table, ladder, chart, machine):
    table, ladder = read(table), read(ladder)
    cases = list(dict.fromkeys(row["case"] for row in ladder))
    columns = min(4, len(cases))
    lines = math.ceil(len(cases) / columns)
    size = (max(11, 3.9 * columns), 3 * lines + 0.9)
    figure, grid = pyplot.subplots(lines, columns, figsize=size, squeeze=False)
    for axes in grid.flat[len(cases):]:
        axes.set_visible(False)
    for axes, case in zip(grid.flat, cases):
        rows = [row for row in ladder if row["case"] == case]
        panel(axes, rows, limits(ladder, rows[0]["of"]))
        verdict(axes, table, case)
    for axes in grid[:, 0]:
        axes.set_ylabel("error", fontsize=9)
    head(figure, machine)
    figure.savefig(chart, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
