"""Draws figure 2 of Lemrich et al. (2017) from a campaign of sweeps.toml, figures 3 and 4 from one of
drives.toml, and what the paper claims (claims.png) from results.csv; prints the numbers of these and of
spectra.toml, and records them in results.csv.

Usage: python3 scenarios/lemrich2017/figures.py DIR... [--out FOLDER, default: the first DIR]
DIR: a campaign, or this folder, for claims.png of what is recorded. Needs python3-matplotlib and python3-pandas."""
import itertools
import math
import os
import sys

PAPER = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(PAPER))
sys.path.insert(0, PAPER)
from claims import draw_claims  # noqa: E402 (of this folder, like the next)
from exponent import exponents_of, packings_of, print_peaks  # noqa: E402
from record import put_collapse, put_drives, put_exponents, put_peaks  # noqa: E402
from drawing import pyplot, ticker  # noqa: E402 (of the folder above, like the next but one)
import numpy  # noqa: E402
from results import Results  # noqa: E402
from tables import folders, made, no_runs, runs_of, scree, study_of  # noqa: E402

MODULUS = 65e9  # Pa, of the beads
COLUMN = "strain.distance"
COLUMNS = ("boundary.bottom.stress", "spectrum.amplitude", "case")  # of a campaign
COLOURS = ["#1b3a6b", "#2a7ab0", "#49a078", "#d98e04", "#c0392b", "#7d3c98"]
LAYERS_APART = 3  # of 14: the 0.214 of the height in figure 4
LEAST_QUALITY = 2  # below it, a maximum is no resonance: the packing is shaken loose


class Sweep:
    """One run of the campaign: a stress, a drive, the response and its highest peak."""

    def __init__(self, run):
        state = run.scenario["particles"]["state"]
        self.prepared = run.path.parent / "prepare" / os.path.basename(os.path.dirname(state))
        self.stress, self.amplitude, self.case = (run.row[name] for name in COLUMNS)
        spectrum, peaks = run.table("spectrum"), run.table("peaks")
        self.frequencies, self.response = spectrum.frequency.to_numpy(), spectrum[f"{COLUMN}.amplitude"].to_numpy()
        self.largest = self.response.argmax()
        peaks = peaks[peaks.column == COLUMN]
        nearest = (peaks.frequency - self.frequencies[self.largest]).abs()
        self.peak = peaks.loc[nearest.idxmin()] if len(peaks) else None
        self.layers = self.layers_of(run.table("shapes")) if "shapes" in run.tables and len(peaks) else []

    def layers_of(self, shapes):
        """Complex displacements of the layers at the peak, over the displacement of the drive."""
        shape = shapes[(shapes.column == COLUMN) & (shapes.frequency == self.peak.frequency)]
        return (shape.amplitude * numpy.exp(1j * shape.phase)).to_numpy()

    def top(self):
        """Frequency (Hz) and response (1/m) of the maximum, by a parabola through the three highest points."""
        k = min(max(self.largest, 1), len(self.response) - 2)
        low, middle, high = self.response[k - 1 : k + 2]
        bend = low - 2 * middle + high
        shift = 0.5 * (low - high) / bend if bend < 0 else 0.0
        step = self.frequencies[k + 1] - self.frequencies[k]
        return self.frequencies[k] + shift * step, middle - 0.25 * (low - high) * shift

    def height(self):
        """Height of the packing from which the sweep begins (m)."""
        head = scree.Result(self.prepared).bodies().attrs["head"]
        lower, upper = (float(head[end].split()[1]) for end in ("lower", "upper"))
        return upper - lower

    def local_strain(self):
        return self.top()[1] * self.amplitude

    def quality(self):
        return math.nan if self.peak is None else self.peak.quality

    def scaled(self):
        """Local strain and frequency (Hz) over what Hertz's law makes them depend on the stress."""
        return self.local_strain() * (self.stress / MODULUS) ** (-2 / 3), self.top()[0] * (self.stress / MODULUS) ** (
            -1 / 6
        )

    def resonates(self):
        return 0 < self.largest < len(self.response) - 1 and self.quality() >= LEAST_QUALITY


def sweeps_of(folder):
    return sorted((Sweep(run) for run in runs_of(folder, *COLUMNS)), key=lambda s: (s.stress, s.amplitude))


def draw_sweeps(sweeps, path):
    figure, axes = pyplot.subplots(figsize=(8, 5))
    height = sweeps[0].height()
    for sweep, colour in zip(sweeps, itertools.cycle(COLOURS)):
        axes.plot(sweep.frequencies / 1e3, sweep.response * height, color=colour, marker="o", markersize=3,
                  linewidth=1.3, label=f"{sweep.amplitude / height:.1e}")
    axes.set(xlabel="frequency (kHz)", ylabel="strain of the layer / strain of the drive", yscale="log")
    axes.set_title(f"Sweeps at rising drives, {sweeps[0].case} (figure 2)", loc="left", fontsize=11)
    axes.legend(title="strain of the drive", fontsize=9, title_fontsize=9, frameon=False, loc="lower left", ncols=2)
    axes.set_ylim(bottom=min(min(s.response) for s in sweeps) * height / 5)
    axes.grid(color="#eeeeee")
    figure.tight_layout()
    figure.savefig(path, dpi=120)


def draw_collapse(sweeps, path):
    figure, (plain, scaled) = pyplot.subplots(1, 2, figsize=(11, 5))
    for case, colour in zip(dict.fromkeys(s.case for s in sweeps), itertools.cycle(COLOURS)):
        chosen = [s for s in sweeps if s.case == case and s.resonates()]
        style = {"color": colour, "marker": "o", "linewidth": 1.2, "label": case}
        plain.plot([s.local_strain() for s in chosen], [s.top()[0] / 1e3 for s in chosen], **style)
        scaled.plot([s.scaled()[0] for s in chosen], [s.scaled()[1] / 1e3 for s in chosen], **style)
    plain.set(xscale="log", xlabel="local strain", ylabel="frequency of 3λ/4 (kHz)")
    scaled.set(
        xscale="log", xlabel=r"local strain · $(\sigma/Y)^{-2/3}$", ylabel=r"frequency · $(\sigma/Y)^{-1/6}$ (kHz)"
    )
    plain.set_title("Peaks 3λ/4 under four stresses (figure 3)", loc="left", fontsize=11)
    scaled.set_title("The same, scaled after Hertz", loc="left", fontsize=11)
    for axes, ticks in ((plain, (2e-5, 5e-5, 1e-4, 2e-4, 5e-4)), (scaled, (0.3, 0.5, 1, 2, 4))):
        axes.set_xticks(ticks, [f"{t:g}" if t > 1e-2 else f"{t:.0e}" for t in ticks])
        axes.xaxis.set_minor_formatter(ticker.NullFormatter())
        axes.grid(color="#eeeeee")
    plain.legend(frameon=False, fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=120)


def strain_profile(layers):
    """Heights, as shares of the packing, and amplitudes of the strain between layers 0.214 of it apart."""
    strains = abs(layers[LAYERS_APART:] - layers[:-LAYERS_APART])
    return (numpy.arange(len(strains)) + 0.5 + LAYERS_APART / 2) / len(layers), strains


def ideal_strain(height):
    """Strain over the same distance of the mode 3λ/4 with a free lower end, cos(3π h/2)."""
    half = LAYERS_APART / 14 / 2
    wave = 1.5 * math.pi
    return abs(numpy.cos(wave * (height + half)) - numpy.cos(wave * (height - half)))


def draw_profile(sweeps, path):
    figure, axes = pyplot.subplots(figsize=(5.5, 6))
    for sweep, colour in zip(sweeps, (COLOURS[0], COLOURS[3], COLOURS[4])):
        heights, strains = strain_profile(sweep.layers)
        axes.plot(strains / max(strains), heights, color=colour, marker="o", markersize=4, linewidth=1.2,
                  label=f"{sweep.amplitude:.0e} m, {sweep.top()[0] / 1e3:.1f} kHz")
    fine = numpy.linspace(LAYERS_APART / 28, 1 - LAYERS_APART / 28, 201)
    axes.plot(ideal_strain(fine) / max(ideal_strain(fine)), fine, color="black", linewidth=1.2, label="3λ/4")
    axes.set(xlabel="local strain / the largest", ylabel="height / height of the packing", ylim=(0, 1))
    axes.set_title(f"Strain over the height at the peak, {sweeps[0].case} (figure 4)", loc="left", fontsize=10)
    axes.legend(frameon=False, fontsize=9)
    axes.grid(color="#eeeeee")
    figure.tight_layout()
    figure.savefig(path, dpi=120)


def print_table(sweeps):
    print("stress [kPa]  drive [m]  peak [Hz]       Q  local strain  f (σ/Y)^(-1/6) [kHz]  ε (σ/Y)^(-2/3)")
    for s in sweeps:
        strain, frequency = s.scaled()
        print(
            f"{s.stress / 1e3:12g} {s.amplitude:10.1e} {s.top()[0]:10.0f} {s.quality():7.1f} {s.local_strain():13.3e}"
            f" {frequency / 1e3:22.1f} {strain:15.4f}"
        )


def at_strain(curve, strain):
    """Frequency of a curve of (strain, frequency) there, linear in log strain; None outside."""
    for (low, f_low), (high, f_high) in zip(curve, curve[1:]):
        if low <= strain <= high:
            return f_low + (f_high - f_low) * math.log(strain / low) / math.log(high / low)
    return None


def spread(curves, strain):
    """Number of curves that reach a strain, and the range of their frequencies over the mean."""
    found = [f for f in (at_strain(curve, strain) for curve in curves) if f is not None]
    return len(found), (max(found) - min(found)) * len(found) / sum(found) if found else math.nan


def apart_at_strains(sweeps):
    """How far the frequencies of different stresses lie apart at equal strains, not scaled and scaled: name of
    the strain, strain, number of stresses, range over the mean."""
    stresses = sorted({s.stress for s in sweeps})
    resonant = [[s for s in sweeps if s.stress == stress and s.resonates()] for stress in stresses]
    plain = [[(s.local_strain(), s.top()[0]) for s in chosen] for chosen in resonant]
    scaled = [[s.scaled() for s in chosen] for chosen in resonant]
    found = []
    for name, curves, strains in (("local strain", plain, (3e-5, 5e-5, 7e-5, 1e-4, 1.4e-4)),
                                  ("local strain (σ/Y)^(-2/3)", scaled, (0.5, 0.7, 1, 1.4, 2, 2.8))):
        found += [(name, strain, *spread(curves, strain)) for strain in strains]
    return [row for row in found if row[2] > 1]


def evaluate_drives(sweeps, campaign, out, results):
    apart = apart_at_strains(sweeps)
    for name, strain, count, share in apart:
        print(f"{name} {strain:g}: the frequencies of {count} stresses lie within {100 * share:.1f} % of their mean")
    put_collapse(results, apart, campaign)
    draw_collapse(sweeps, os.path.join(out, "collapse.png"))
    shaped = [s for s in sweeps if s.stress == sweeps[0].stress and len(s.layers)]
    if shaped:
        draw_profile([shaped[0], shaped[len(shaped) // 2], shaped[-1]], os.path.join(out, "profile.png"))


def evaluate(campaign, out, results):
    """Draws and records a campaign."""
    study = study_of(campaign)
    if study == "spectra":
        packings = packings_of(campaign)
        print_peaks(packings)
        put_peaks(results, packings, campaign)
        return put_exponents(results, exponents_of(packings), campaign)
    sweeps = sweeps_of(campaign)
    if not sweeps:
        no_runs(campaign, "scenarios/lemrich2017/sweeps.toml, drives.toml or spectra.toml")
    print_table(sweeps)
    put_drives(results, study, sweeps, campaign)
    if study == "sweeps":
        return draw_sweeps(sweeps, os.path.join(made(out), "sweeps.png"))
    return evaluate_drives(sweeps, campaign, made(out), results)


def main():
    given, out = folders(__doc__)
    results = Results(PAPER, out)
    for campaign in given:
        if os.path.realpath(campaign) != os.path.realpath(PAPER):
            evaluate(campaign, out, results)
    results.write()
    draw_claims(results, out)


if __name__ == "__main__":
    main()
