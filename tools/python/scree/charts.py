"""Charts by declaration: panels of curves, drawn by matplotlib into a file, without a display."""
import os

from .errors import made, package

COLOURS = ("#1b3a6b", "#2a7ab0", "#49a078", "#d98e04", "#c0392b", "#7d3c98")  # for curves in an order
BLUE, _, GREEN, ORANGE, RED, _ = COLOURS
GREY = "#888888"
HEADING = {"loc": "left", "fontsize": 10}
LEGEND = {"frameon": False, "fontsize": 8, "title_fontsize": 8}


class Curve:
    """Points (x, y), or with ± error of y, nan for none, in a look such as "o-"; options: of matplotlib's plot or
    errorbar, such as label, color, linewidth; names: texts beside the points."""

    def __init__(self, x, y, look="", error=None, names=(), **options):
        self.x, self.y, self.look, self.error, self.options = x, y, look, error, options
        self.names = names

    def __call__(self, axes):
        """Draws the curve."""
        if self.error is None:
            axes.plot(self.x, self.y, *[self.look] * (self.look != ""), **self.options)
        else:
            known = not package("numpy").isnan(self.error).all()
            axes.errorbar(self.x, self.y, yerr=self.error if known else None, fmt=self.look, **self.options)
        for k, name in enumerate(self.names):
            # Below where lines go up on both sides.
            lowest = 0 < k < len(self.y) - 1 and self.y[k] < min(self.y[k - 1], self.y[k + 1])
            place = (-3, -14) if lowest else (8, 5)
            axes.annotate(name, (self.x[k], self.y[k]), place, textcoords="offset points", fontsize=8)


class Panel:
    """A title, labels of the axes with units, and contents: curves, or functions that draw on axes of matplotlib.

    grid: whether there are lines; legend: None for none, or options of matplotlib's, {} for the usual place; xticks,
    yticks: places, texts by place, a number of ticks, or "1 2 5" of each power of ten on a logarithmic axis; heading:
    options of the title; settings: of the axes, such as xscale="log", ylim=(0, None)."""

    def __init__(self, title, x, y, *contents, grid=True, legend=None, xticks=(), yticks=(), heading=HEADING,
                 **settings):
        self.contents, self.legend, self.ticks = contents, legend, {"x": xticks, "y": yticks}
        self.title, self.heading, self.grid = title, heading, grid
        self.settings = {"xlabel": x, "ylabel": y} | settings

    def __call__(self, axes):
        """Draws the panel."""
        for content in self.contents:
            content(axes)
        axes.set_title(self.title, **self.heading)
        axes.set(**self.settings)
        for name, ticks in self.ticks.items():
            self.mark(getattr(axes, name + "axis"), ticks)
        if self.grid:
            axes.grid(color="#eeeeee")
        if self.legend is not None:
            axes.legend(**LEGEND | self.legend)

    @staticmethod
    def mark(axis, ticks):
        """Ticks of an axis; with texts, the minor ones have none."""
        if isinstance(ticks, dict):
            axis.set_ticks(list(ticks), list(ticks.values()))
        if isinstance(ticks, str):
            axis.set_major_locator(package("matplotlib.ticker").LogLocator(subs=tuple(map(int, ticks.split()))))
            axis.set_major_formatter("{x:g}")
        if isinstance(ticks, (dict, str)):
            axis.set_minor_formatter(package("matplotlib.ticker").NullFormatter())
        elif isinstance(ticks, int):
            axis.get_major_locator().set_params(nbins=ticks)
        elif len(ticks):
            axis.set_ticks(ticks)


def labels(*ticks):
    """Texts of ticks by their places, for axes that are not linear."""
    return {tick: f"{tick:g}" if tick > 1e-2 else f"{tick:.0e}" for tick in ticks}


def room_below(axes):
    """A content of panels: a logarithmic axis with room for a legend below the curves."""
    axes.set_yscale("log")
    axes.set_ylim(bottom=axes.get_ylim()[0] / 20)


def shades(count):
    """Colours from dark to light, for curves over a number that rises."""
    colours = package("matplotlib").colormaps["viridis"]
    return [colours(0.9 * k / max(count - 1, 1)) for k in range(count)]


def blank(rows, columns, size, **options):
    """A figure and its grid of axes; size in inches, options of matplotlib's subplots."""
    figure = package("matplotlib.figure").Figure(figsize=size)
    return figure, figure.subplots(rows, columns, squeeze=False, **options)


def save(figure, path, dpi):
    """Writes a figure with tight margins into a folder, which is made; its path."""
    made(os.path.dirname(path) or ".")
    figure.tight_layout()
    figure.savefig(path, dpi=dpi)
    return path


def draw(path, panels, size, columns=None, title=None, dpi=80):
    """Draws panels row by row, by default in one, with a title above them all; size in inches. The path."""
    columns = columns or len(panels)
    figure, grid = blank(-(-len(panels) // columns), columns, size)
    for panel, axes in zip(panels, grid.flat):
        panel(axes)
    for axes in grid.flat[len(panels):]:
        axes.remove()
    if title:
        figure.suptitle(title, fontsize=10)
    return save(figure, path, dpi)
