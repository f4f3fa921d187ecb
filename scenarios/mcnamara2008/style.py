"""Colours and labels of the pictures of this folder."""
import os

from drawing import pyplot, ticker  # noqa: F401 (of the folder above, which series.py adds; for the scripts too)
from tables import made

BLUE, ORANGE, GREEN, RED, GREY, PURPLE = "#1b3a6b", "#d98e04", "#49a078", "#c0392b", "#888888", "#a569bd"


def label(axes, title, x, y):
    axes.set_title(title, loc="left", fontsize=10)
    axes.set(xlabel=x, ylabel=y)
    axes.grid(color="#eeeeee")


def save(figure, out, name):
    figure.tight_layout()
    figure.savefig(os.path.join(made(out), name), dpi=80)
    print(os.path.join(out, name))
