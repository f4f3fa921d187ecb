"""Peaks of the packings of spectra.toml, and the exponents of their frequencies in the stress."""
from scree import Error
from scree.documents import text_of
from scree.fits import mean_and_error, power
from scree.scripts import no_runs

NAMES = {0.25: "λ/4", 0.75: "3λ/4", 1.25: "5λ/4"}  # of modes, by the wavelengths in the height
STRESS = "boundary.bottom.stress"


def packings_of(campaign):
    """By stress (Pa) and seed, of each mode by its wavelengths: frequency (Hz), its error and Q of the peak with the
    largest amplitude. An error if there are none, or a packing lacks one."""
    packings = {}
    for run in campaign.finished(STRESS):
        peaks = run.table("peaks")
        peaks = peaks.loc[peaks.groupby("wavelengths").amplitude.idxmax()].set_index("wavelengths")
        if not NAMES.keys() <= set(peaks.index):
            raise Error(f"{run.path}: no peak of some mode; its spectrum.png shows what was found")
        named = peaks.loc[list(NAMES), ["frequency", "frequency_error", "quality"]].to_numpy().tolist()
        packings[run.row[STRESS], run.row["seed"]] = dict(zip(NAMES, named))
    if not packings:
        raise no_runs(campaign, "scenarios/lemrich2017/spectra.toml")
    return packings


def exponents_of(packings):
    """By the name of the mode: exponents n of f ∝ σ^n by least squares, one for each seed. None, and a line that says
    so, where a seed has one stress."""
    by_seed, exponents = {}, {name: [] for name in NAMES.values()}
    for (stress, seed), peaks in packings.items():
        by_seed.setdefault(seed, {})[stress] = peaks
    single = ", ".join(str(seed) for seed in sorted(by_seed) if len(by_seed[seed]) < 2)
    if single:
        print(f"no exponent from one stress, of seed {single}; let the campaign finish two or more")
        return {}
    for _, of_seed in sorted(by_seed.items()):
        for wavelengths, name in NAMES.items():
            exponents[name].append(power(of_seed, (peaks[wavelengths][0] for peaks in of_seed.values())))
    return exponents


def put_spectra(campaign, numbers):
    """Records the frequencies, and their exponents unless a seed has one stress alone."""
    packings = packings_of(campaign)
    for (stress, seed), peaks in packings.items():
        found = [(f"frequency of {name}", "kHz", f"{peaks[w][0] / 1e3:.4f}", f"{peaks[w][1] / 1e3:.1g}")
                 for w, name in NAMES.items()]
        qualities = ", ".join(f"{peaks[w][2]:.1f}" for w in NAMES)
        ratios = " : ".join(f"{peaks[w][0] / peaks[0.25][0]:.3f}" for w in (0.75, 1.25))
        note = f"Q {qualities}, ratios 1 : {ratios}"
        numbers.put("spectra", f"{stress / 1e3:g} kPa, seed {seed}", found, campaign, note=note)
    numbers.print()
    for name, slopes in exponents_of(packings).items():
        mean, error = mean_and_error(slopes)
        row = f"exponent of {name} in the stress", "1", f"{mean:.4f}", text_of(error, ".4f")
        numbers.put("spectra", "prepare.toml", [row], campaign, len(slopes))
        print(f"{name:>5}: f ∝ σ^n, n = {mean:.4f} ± {error:.4f} (seeds: {', '.join(f'{n:.4f}' for n in slopes)})")
