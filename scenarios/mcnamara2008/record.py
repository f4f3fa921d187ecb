"""Numbers of the campaigns of this folder, as rows of results.csv."""
import statistics

from scree.fits import line_through, power
from series import (DROPPED, LAWS, bodies_of, ellipses_of, long_runs, paths_of, phases_of, sine_fit, slope_of,
                    steps_of, strains)


def put_paths(numbers, study, campaign):
    paths = paths_of(campaign)
    if "biaxial" in paths:
        biaxial = paths["biaxial"]
        largest, slope = max(abs(biaxial.gamma[: biaxial.per_cycle])), line_through(biaxial.minima)[0]
        found = [("contacts that slide", "1", f"{len(biaxial.slips)}"),
                 ("largest |γ| of the first cycle", "1", f"{largest:.2g}"), ("Δγ", "per cycle", f"{slope:.3g}")]
        samples = [f"{name} in {count} of {biaxial.per_cycle + 1} samples" for name, count in biaxial.slips.items()]
        numbers.put(study, f"packing {biaxial.seed}", found, campaign, note=", ".join(samples))
    ellipses, widest = ellipses_of(paths)
    for phase, of_phase in ellipses.items():
        area = of_phase.areas[widest]
        found = [("area of the ellipse", "N²", f"{area:.5g}")]
        note = f"{area / ellipses['90'].areas[widest]:.4f} of that at 90°"
        numbers.put(study, f"{bodies_of(widest)}, φ = {phase}°", found, campaign, note=note)


def put_elliptic(numbers, study, campaign):
    for (case, seed), slopes in phases_of(campaign).items():
        amplitude, quality = sine_fit(slopes)
        found = [("A of Δγ = A sin φ", "per cycle", f"{amplitude:.5g}"), ("R² of Δγ = A sin φ", "1", f"{quality:.6f}"),
                 ("largest |Δγ|", "per cycle", f"{max(map(abs, slopes.values())):.2g}")]
        numbers.put(study, f"{case}, packing {seed}", found, campaign, note=f"{len(slopes)} phases")


def put_verdicts(numbers, study, campaign):
    """Packings of each case that ratchet by the criterion of the paper, and their slopes."""
    by_case = {}
    for run in campaign.finished():
        if len(run.series["load"]) > DROPPED + 1:
            by_case.setdefault(run.row.get("case", "all packings"), []).append(slope_of(run))
    for case, lines in by_case.items():
        slopes = sorted((slope for slope, deviation in lines if deviation < abs(slope)), key=abs)
        found = [("packings that ratchet", "1", f"{len(slopes)}"),
                 ("packings that ratchet, γ rises", "1", f"{sum(s > 0 for s in slopes)}")]
        if slopes:
            mean = statistics.geometric_mean(map(abs, slopes))
            found += [("geometric mean of |Δγ|", "per cycle", f"{mean:.2g}"),
                      ("least |Δγ|", "per cycle", f"{abs(slopes[0]):.2g}"),
                      ("largest |Δγ|", "per cycle", f"{abs(slopes[-1]):.2g}")]
        numbers.put(study, case, found, campaign, len(lines))


def put_steps(numbers, study, campaign):
    for (law, seed), slopes in steps_of(campaign).items():
        case = f"{LAWS[law]}, packing {seed}"
        for step in sorted(slopes):
            found = [("Δγ", "per cycle", f"{slopes[step]:.4g}")]
            numbers.put(study, f"{case}, step {step:g} τ", found, campaign)
        least, largest = min(slopes), max(slopes)
        exponent = power((least, largest), (abs(slopes[least]), abs(slopes[largest])))
        numbers.put(study, case, [("exponent of the step", "1", f"{exponent:.3f}")], campaign)


def put_ranges(numbers, study, campaign):
    for run in long_runs(campaign):
        gamma = strains(run)
        case = (f"{run.row['case']}, " if "case" in run.row else "") + f"packing {run.row['seed']}"
        found = [("range of γ", "1", f"{max(gamma) - min(gamma):.2g}")]
        numbers.put(study, case, found, campaign, note=f"over {len(gamma) - 1} cycles")


PUT = {"paths": put_paths, "elliptic": put_elliptic, "laws": put_verdicts, "steps": put_steps, "rattlers": put_ranges,
       "long": put_ranges, "choices": put_verdicts, "fine": put_verdicts, "large": put_verdicts}
