"""Colours and labels of the pictures of this folder, drawn without a display."""
import os

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402, F401 (the choice of the backend comes first)

BLUE, ORANGE, GREEN, RED, GREY, PURPLE = "#1b3a6b", "#d98e04", "#49a078", "#c0392b", "#888888", "#a569bd"


def label(axes, title, x, y):
    axes.set_title(title, loc="left", fontsize=10)
    axes.set(xlabel=x, ylabel=y)
    axes.grid(color="#eeeeee")


def save(figure, out, name):
    figure.tight_layout()
    figure.savefig(os.path.join(out, name), dpi=80)
    print(os.path.join(out, name))
