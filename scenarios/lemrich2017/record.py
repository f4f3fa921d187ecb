"""Numbers of spectra, sweeps and drives as rows of results.csv."""
import math

from exponent import NAMES, mean_and_error


def put_peaks(results, packings, campaign):
    for (stress, seed), peaks in packings.items():
        for wavelengths, name in NAMES.items():
            frequency, error, _ = peaks[wavelengths]
            key = "spectra", f"frequency of {name}", f"{stress / 1e3:g} kPa, seed {seed}"
            results.put(key, "kHz", f"{frequency / 1e3:.4f}", f"{error / 1e3:.1g}", 1, campaign)


def put_exponents(results, exponents, campaign):
    for name, slopes in exponents.items():
        mean, error = mean_and_error(slopes)
        results.put(("spectra", f"exponent of {name} in the stress", "prepare.toml"), "1", f"{mean:.4f}",
                    "" if math.isnan(error) else f"{error:.4f}", len(slopes), campaign)


def put_drives(results, study, sweeps, campaign):
    """The highest maximum of each sweep."""
    for sweep in sweeps:
        case = f"{sweep.stress / 1e3:g} kPa, A = {sweep.amplitude:g} m"
        numbers = (("frequency of the maximum", "kHz", f"{sweep.top()[0] / 1e3:.2f}"),
                   ("local strain at the maximum", "1", f"{sweep.local_strain():.2g}"))
        results.put_numbers(study, case, numbers, campaign)
        if sweep.peak is not None:
            error = sweep.peak.get("quality_error", math.nan)
            results.put((study, "Q of the nearest mode", case), "1", f"{sweep.quality():.1f}",
                        "" if math.isnan(error) else f"{error:.1f}", 1, campaign)


def put_collapse(results, apart, campaign):
    for name, strain, count, share in apart:
        number = "range of the frequencies over their mean", "%", f"{100 * share:.1f}"
        results.put_numbers("drives", f"{name} = {strain:g}", [number], campaign, count)
