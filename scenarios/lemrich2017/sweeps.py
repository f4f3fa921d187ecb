"""Sweeps of lemrich2017: their maxima, shapes, and how far frequencies under several stresses lie apart."""
import math

import numpy
from scree.documents import text_of
from scree.fits import maximum

MODULUS = 65e9  # Pa, of the beads
COLUMN = "strain.distance"
COLUMNS = ("boundary.bottom.stress", "spectrum.amplitude", "case")  # of a campaign
LEAST_QUALITY = 2  # below it, a maximum is no resonance: the packing is shaken loose
# At these strains, plain and scaled, frequencies are compared.
STRAINS = {"local strain": (3e-5, 5e-5, 7e-5, 1e-4, 1.4e-4), "local strain (σ/Y)^(-2/3)": (0.5, 0.7, 1, 1.4, 2, 2.8)}


def over_hertz(stress, strain, frequency):
    """Local strain and frequency over what Hertz's law makes them depend on the stress (Pa)."""
    return strain * (stress / MODULUS) ** (-2 / 3), frequency * (stress / MODULUS) ** (-1 / 6)


class Sweep:
    """One run of a campaign, of a stress (Pa) and a drive (amplitude, m): its response (1/m), frequency (Hz) and local
    strain at the maximum, and these scaled after Hertz, Q of the nearest peak with its error, nan if there is none, and
    complex displacements of the layers there over the displacement of the drive."""

    def __init__(self, run):
        self.run = run
        self.stress, self.amplitude, self.case = (run.row[name] for name in COLUMNS)
        spectrum, peaks = run.table("spectrum"), run.table("peaks")
        self.frequencies, self.response = spectrum.frequency.to_numpy(), spectrum[f"{COLUMN}.amplitude"].to_numpy()
        self.frequency, top = maximum(self.frequencies, self.response)
        self.strain = top * self.amplitude
        self.scaled = over_hertz(self.stress, self.strain, self.frequency)
        largest = self.response.argmax()
        peaks = peaks[peaks.column == COLUMN]
        nearest = (peaks.frequency - self.frequencies[largest]).abs()
        peak = peaks.loc[nearest.idxmin()] if len(peaks) else {}
        self.quality, self.quality_error = (peak.get(name, math.nan) for name in ("quality", "quality_error"))
        self.resonates = 0 < largest < len(self.response) - 1 and self.quality >= LEAST_QUALITY
        self.layers = []
        if "shapes" in run.tables and len(peaks):
            shapes = run.table("shapes")
            shape = shapes[(shapes.column == COLUMN) & (shapes.frequency == peak["frequency"])]
            self.layers = (shape.amplitude * numpy.exp(1j * shape.phase)).to_numpy()

    def height(self):
        """Height of the packing from which the sweep begins (m)."""
        head = self.run.prepared.bodies().attrs["head"]
        lower, upper = (float(head[end].split()[1]) for end in ("lower", "upper"))
        return upper - lower


def spread(curves, strain):
    """Number of curves of (strain, frequency) that reach a strain, and the range of their frequencies there, which are
    linear in log strain, over the mean."""
    found = [numpy.interp(math.log(strain), numpy.log(strains), frequencies)
             for strains, frequencies in (zip(*curve) for curve in curves) if min(strains) <= strain <= max(strains)]
    return len(found), (max(found) - min(found)) / numpy.mean(found) if found else math.nan


def apart_at_strains(sweeps):
    """How far the frequencies of different stresses lie apart at equal strains, not scaled and scaled: name of
    the strain, strain, number of stresses, range over the mean."""
    curves = {name: {} for name in STRAINS}
    for sweep in (s for s in sweeps if s.resonates):
        for of_stress, point in zip(curves.values(), ((sweep.strain, sweep.frequency), sweep.scaled)):
            of_stress.setdefault(sweep.stress, []).append(point)
    found = [(name, strain, *spread(curves[name].values(), strain)) for name in STRAINS for strain in STRAINS[name]]
    return [row for row in found if row[2] > 1]


def put_maxima(sweeps, study, campaign, numbers):
    """Records the highest maximum of each sweep."""
    for s in sweeps:
        found = [("frequency of the maximum", "kHz", f"{s.frequency / 1e3:.2f}"),
                 ("local strain at the maximum", "1", f"{s.strain:.2g}"),
                 ("Q of the nearest mode", "1", *(text_of(value, ".1f") for value in (s.quality, s.quality_error)))]
        strain, frequency = s.scaled
        note = f"f (σ/Y)^(-1/6) {frequency / 1e3:.1f} kHz, ε (σ/Y)^(-2/3) {strain:.4f}"
        numbers.put(study, f"{s.stress / 1e3:g} kPa, A = {s.amplitude:g} m", found, campaign, note=note)
