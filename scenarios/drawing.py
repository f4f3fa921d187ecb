"""Matplotlib without a display, for the scripts of the papers."""
from tables import scree

scree.errors.package("matplotlib").use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402, F401 (the choice of the backend comes first)
