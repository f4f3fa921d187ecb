"""Peaks of the packings of cell.toml, and what a continuum in a cylinder has in their place."""
import math
import pathlib

import numpy
from scree.charts import COLOURS, Curve, Panel, draw
from scree.scripts import no_runs
from spectra import NAMES  # of this folder

COLUMN = "strain.distance"
RADIUS = 5.6419e-3  # m, of the cell
HEIGHT = 12.3e-3    # m, and waves of compression and shear (m/s) from M = 1.47e8 and G = 4.39e7 Pa of looser packings
SPEEDS = math.sqrt(1.47e8 / 1498), math.sqrt(4.39e7 / 1498)  # (NOTES.md: 55 kPa, and Hertz's power 1/3 of the stress)
CASES = ("periodic", "smooth cell", "cell with friction")


def modes_in_cylinder(speeds, radius, height, clamped, rings=16, layers=48):
    """Frequencies (Hz, ascending) of axial waves that are symmetric about the axis, and for each whether the mean over
    the section moves (its share in the motion that a driven top gives, from 0 to 1). speeds (m/s): of compression and
    of shear. The top is at rest, the bottom a rigid plate without mass; the side is held or free. Radial motion is left
    out. Finite volumes: the error is of second order in the sizes of the rings and layers."""
    c_squared, s_squared = (speed**2 for speed in speeds)
    dr, dz = radius / rings, height / layers
    middle = (numpy.arange(rings) + 0.5) * dr
    areas = 2 * math.pi * middle * dr
    place = numpy.concatenate([numpy.zeros(rings, int), 1 + numpy.arange((layers - 1) * rings)]).reshape(layers, rings)
    size = place.max() + 1
    stiffness, mass = numpy.zeros((size, size)), numpy.zeros(size)

    def spring(a, b, k):
        stiffness[a, a] += k
        if b is not None:
            stiffness[b, b] += k
            stiffness[a, b] -= k
            stiffness[b, a] -= k

    for j in range(layers):
        thick = dz / 2 if j == 0 else dz
        for i in range(rings):
            here = place[j, i]
            mass[here] += areas[i] * thick
            spring(here, place[j + 1, i] if j + 1 < layers else None, c_squared * areas[i] / dz)
            if j == 0:
                continue  # of the plate
            around = 2 * math.pi * (i + 1) * dr * thick
            if i + 1 < rings:
                spring(here, place[j, i + 1], s_squared * around / dr)
            elif clamped:
                spring(here, None, s_squared * around / (dr / 2))
    root = numpy.sqrt(mass)
    squares, shapes = numpy.linalg.eigh(stiffness / root[:, None] / root)
    return numpy.sqrt(abs(squares)) / (2 * math.pi), (root @ shapes) ** 2 / mass.sum()


class Packing:
    """A finished run of the campaign: its case and seed, height (m), load of the top over that of the bottom, contacts of a
    bead that bears load, and peaks of the strain: (name or "", frequency in Hz, its error, Q, amplitude in 1/m), ascending."""

    def __init__(self, run, campaign):
        self.case, self.seed, self.run = run.row["case"], run.row["seed"], run
        prepared = campaign.preparations[pathlib.PurePath(run.scenario["particles"]["state"]).parent.name]
        walls, contacts = (prepared.series[name].iloc[-1] for name in ("walls", "contacts"))
        self.height = abs(walls.position_1 + walls.position_2)
        self.top_load = walls.normal_force_2 / walls.normal_force_1
        self.contacts = contacts.coordination_without_rattlers
        peaks = run.table("peaks")
        self.peaks = [(NAMES.get(peak.wavelengths, ""), peak.frequency, peak.frequency_error, peak.quality, peak.amplitude)
                      for peak in peaks[peaks.column == COLUMN].itertuples()]

    def rows(self):
        """For results.csv; peaks without a name are numbered."""
        rows = [("height", "mm", f"{1e3 * self.height:.3f}"), ("load of the top over that of the bottom", "1", f"{self.top_load:.4f}"),
                ("contacts of a bead that bears load", "1", f"{self.contacts:.3f}")]
        for k, (name, frequency, error, quality, _) in enumerate(self.peaks):
            name = name or f"peak {k + 1}"
            rows += [(f"frequency of {name}", "kHz", f"{frequency / 1e3:.4g}", f"{error / 1e3:.1g}"), (f"Q of {name}", "1", f"{quality:.3g}")]
        return rows


def put_cells(campaign, numbers, path):
    """Records the packings, prints what is expected of a continuum, and draws the responses."""
    packings = [Packing(run, campaign) for run in campaign.finished("case")]
    if not packings:
        raise no_runs(campaign, "scenarios/lemrich2017/cell.toml")
    packings.sort(key=lambda packing: (CASES.index(packing.case), packing.seed))
    for packing in packings:
        numbers.put("cell", f"{packing.case}, seed {packing.seed}", packing.rows(), campaign)
    numbers.print()
    for clamped, name in ((False, "free side"), (True, "held side")):
        frequencies, shares = modes_in_cylinder(SPEEDS, RADIUS, HEIGHT, clamped)
        found = ", ".join(f"{f / 1e3:.1f} ({share:.3f})" for f, share in zip(frequencies[:8], shares))
        print(f"{name}: expected at {found} kHz (share of the mean motion)")
    draw_cells(packings, path)


def draw_cells(packings, path):
    curves = []
    for packing in packings:
        spectrum = packing.run.table("spectrum")
        label = packing.case if packing is next(p for p in packings if p.case == packing.case) else None
        curves.append(Curve(spectrum.frequency / 1e3, spectrum[f"{COLUMN}.amplitude"] * packing.height, color=COLOURS[CASES.index(packing.case)],
                            linewidth=1.2, label=label))
    panel = Panel("Response of the beads in a cell and in a period, 10 kPa", "frequency / kHz", "strain of the layer / strain of the drive",
                  *curves, yscale="log", legend={"fontsize": 9})
    print(draw(path, [panel], (8, 5), dpi=120))
