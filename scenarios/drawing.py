"""Matplotlib without a display, for the scripts of the papers."""
from tables import refuse

try:
    import matplotlib
except ImportError:
    refuse("there is no matplotlib; install the package python3-matplotlib, or call a python3 that has it")

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402, F401 (the choice of the backend comes first)
