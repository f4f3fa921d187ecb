"""Prints the peaks of the packings of spectra.toml and the exponent of their frequencies in the stress, with
its error from the seeds.

Usage: python3 scenarios/lemrich2017/exponent.py campaigns/spectra"""
import math
import os
import statistics
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tables import arguments, no_runs, refuse, runs_of  # noqa: E402 (of the folder above)

NAMES = {0.25: "λ/4", 0.75: "3λ/4", 1.25: "5λ/4"}


def largest_peaks(peaks):
    """The peak with the largest amplitude, for each number of wavelengths: frequency, its error, Q."""
    named = peaks[peaks.wavelengths.notna()]
    largest = named.loc[named.groupby("wavelengths").amplitude.idxmax()].set_index("wavelengths")
    return dict(zip(largest.index, largest[["frequency", "frequency_error", "quality"]].to_numpy().tolist()))


def print_peaks(packings):
    print("stress [kPa] seed  " + "  ".join(f"{name + ' [Hz]':>16} {'Q':>5}" for name in NAMES.values()) + "   ratios")
    for (stress, seed), peaks in packings.items():
        first = peaks[0.25][0]
        columns = "  ".join(f"{peaks[w][0]:8.0f} ± {peaks[w][1]:5.1f} {peaks[w][2]:5.1f}" for w in NAMES)
        print(
            f"{stress / 1e3:12g} {seed:>4}  {columns}   1 : {peaks[0.75][0] / first:.3f} : {peaks[1.25][0] / first:.3f}"
        )


def packings_of(folder):
    """Peaks by stress (Pa) and seed. Ends the script with one line if there are none, or a packing lacks one."""
    column = "boundary.bottom.stress"
    runs = runs_of(folder, column)
    packings = {(run.row[column], run.row["seed"]): largest_peaks(run.table("peaks")) for run in runs}
    if not packings:
        no_runs(folder, "scenarios/lemrich2017/spectra.toml")
    lacking = [f"{stress:g} Pa, seed {seed}" for (stress, seed),
               peaks in packings.items() if any(w not in peaks for w in NAMES)]
    if lacking:
        refuse(f"{folder}: no peak of some name: {'; '.join(lacking)}; their spectrum.png shows what was found")
    return packings


def exponents_of(packings):
    """By the name of the mode: exponents n of f ∝ σ^n, one for each seed. Empty if a seed has one stress."""
    seeds = sorted({seed for _, seed in packings})
    if any(sum(s == seed for _, s in packings) < 2 for seed in seeds):
        return {}
    return {name: [exponent_of(packings, seed, wavelengths) for seed in seeds] for wavelengths, name in NAMES.items()}


def exponent_of(packings, seed, wavelengths):
    """Slope of the logarithms of a seed by least squares."""
    points = [(math.log(stress), math.log(peaks[wavelengths][0]))
              for (stress, s), peaks in packings.items() if s == seed]
    return statistics.linear_regression(*zip(*points)).slope


def mean_and_error(slopes):
    """Mean and standard error."""
    return (statistics.fmean(slopes),
            statistics.stdev(slopes) / math.sqrt(len(slopes)) if len(slopes) > 1 else math.nan)


def main():
    (folder,) = arguments(__doc__, 1, 1)
    packings = packings_of(folder)
    print_peaks(packings)
    seeds = sorted({seed for _, seed in packings})
    single = [seed for seed in seeds if sum(s == seed for _, s in packings) < 2]
    if single:
        named = ", ".join(map(str, single))
        refuse(f"{folder}: no exponent from one stress, of seed {named}; let the campaign finish two or more")
    for name, slopes in exponents_of(packings).items():
        mean, error = mean_and_error(slopes)
        print(f"{name:>5}: f ∝ σ^n, n = {mean:.4f} ± {error:.4f} (seeds: {', '.join(f'{n:.4f}' for n in slopes)})")


if __name__ == "__main__":
    main()
