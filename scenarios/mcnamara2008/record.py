"""Numbers of the campaigns of this folder, printed and as rows of results.csv."""
import math

from series import DROPPED, Paths, cycles_of, line_through, numpy, slope_of, strains
from tables import runs_of  # of the folder above, which series.py adds

LOAD = 0.15  # Δσ/p
FRICTION = 0.2
PHASE = "stage.cycles.set.box.stress_x_high.phase_deg"
LAWS = {"disc_cundall_strack": "Cundall and Strack", "disc_corrected": "corrected", "disc_angular": "painted points"}
WALLS = {"wall1": "left wall", "wall2": "right wall", "wall3": "lower wall", "wall4": "upper wall"}


def long_runs(campaign, *columns):
    """Runs of a campaign of at least 30 cycles of 10 τ; none if there is no campaign or its table lacks one of
    the columns."""
    runs = runs_of(campaign) if campaign else []
    return [run for run in runs if all(c in run.row for c in columns) and cycles_of(run) > DROPPED]


def bodies_of(contact):
    """A contact "3_7" or "3_wall1" in words."""
    return " and ".join(WALLS.get(part, f"disc {part}") for part in contact.split("_"))


class Biaxial:
    """The run of paths.toml under a load on one pair of walls."""

    def __init__(self, run):
        self.paths = Paths(run)
        self.name = f"{LAWS[run.scenario['contact'][0]['plugin']]}, packing {run.row['seed']}"
        self.gamma, self.per = strains(run, 0), self.paths.per_cycle

    def slides(self):
        return any(sum(sliding) for _, _, sliding in self.paths.contacts.values())


def contact_that_slides(paths):
    """Name, and F_n, F_t and slip over the last cycle."""
    return max(paths.contacts.items(), key=lambda contact: sum(contact[1][2]))


def ellipses_of(runs):
    """Paths of contacts by the phase of the load, in degrees."""
    return {run.row["case"].split()[1]: Paths(run) for run in runs}


def widest_of(ellipses):
    """The contact with the largest area at a phase of 90 degrees."""
    return max(ellipses["90"].contacts, key=lambda contact: abs(ellipses["90"].area(contact)))


def put_paths(results, campaign):
    runs = long_runs(campaign, "case")
    for run in (run for run in runs if run.row["case"] == "biaxial"):
        biaxial = Biaxial(run)
        largest = max(abs(biaxial.gamma[: biaxial.per]))
        slope = line_through(biaxial.gamma[DROPPED * biaxial.per :: biaxial.per])[0]
        slides = {c: int(sum(v[2])) for c, v in biaxial.paths.contacts.items() if sum(v[2])}
        samples = ", ".join(f"{contact} in {count} of {biaxial.per + 1} samples" for contact, count in slides.items())
        print(f"contacts that slide in the last cycle: {samples}")
        print(f"largest |γ| of the first cycle {largest:.4f}, slope {slope:.3e} per cycle")
        numbers = (("contacts that slide", "1", f"{len(slides)}"),
                   ("largest |γ| of the first cycle", "1", f"{largest:.2g}"), ("Δγ", "per cycle", f"{slope:.3g}"))
        results.put_numbers("paths", f"packing {run.row['seed']}", numbers, campaign)
    ellipses = ellipses_of([run for run in runs if run.row["case"].startswith("phase ")])
    if "90" not in ellipses:
        return
    widest = widest_of(ellipses)
    for phase, paths in ellipses.items():
        area = paths.area(widest)
        print(f"contact {widest}, phase {phase}: area {area:.4e} N², over that at 90: "
              f"{area / ellipses['90'].area(widest):.4f}")
        case = f"{bodies_of(widest)}, φ = {phase}°"
        results.put_numbers("paths", case, [("area of the ellipse", "N²", f"{area:.5g}")], campaign)


def sine_fit(slopes):
    """A and R² of Δγ = A sin φ. slopes: Δγ by φ in degrees."""
    sines, values = numpy.sin(numpy.radians(list(slopes))), numpy.array(list(slopes.values()))
    amplitude = (values @ sines) / (sines @ sines)
    spread = ((values - values.mean()) ** 2).sum()
    return amplitude, 1 - ((values - amplitude * sines) ** 2).sum() / spread if spread > 0 else math.nan


def phases_of(campaign):
    """Δγ by φ in degrees, of each case and packing that has three phases or more."""
    by_packing = {}
    for run in long_runs(campaign, "case", PHASE):
        by_packing.setdefault((run.row["case"], run.row["seed"]), {})[run.row[PHASE] + 90] = slope_of(run)[0]
    return {key: slopes for key, slopes in by_packing.items() if len(slopes) > 2}


def put_elliptic(results, campaign):
    for (case, seed), slopes in phases_of(campaign).items():
        amplitude, quality = sine_fit(slopes)
        largest = max(abs(s) for s in slopes.values())
        print(f"{case}, packing {seed}: A = {amplitude:.4e}, R² = {quality:.6f}, largest |Δγ| {largest:.2e},"
              f" {len(slopes)} phases")
        numbers = (("A of Δγ = A sin φ", "per cycle", f"{amplitude:.5g}"),
                   ("R² of Δγ = A sin φ", "1", f"{quality:.6f}"),
                   ("largest |Δγ|", "per cycle", f"{largest:.2g}"))
        results.put_numbers("elliptic", f"{case}, packing {seed}", numbers, campaign)


def put_verdicts(results, study, campaign):
    """Packings of each case that ratchet by the criterion of the paper, and their slopes."""
    by_case = {}
    for run in runs_of(campaign):
        if len(run.series["load"]) > DROPPED + 1:
            by_case.setdefault(run.row.get("case", "all packings"), []).append(slope_of(run))
    for case, lines in by_case.items():
        slopes = sorted((slope for slope, deviation in lines if deviation < abs(slope)), key=abs)
        numbers = [("packings that ratchet", "1", f"{len(slopes)}"),
                   ("packings that ratchet, γ rises", "1", f"{sum(s > 0 for s in slopes)}")]
        if slopes:
            mean = math.exp(sum(math.log(abs(s)) for s in slopes) / len(slopes))
            numbers += [("geometric mean of |Δγ|", "per cycle", f"{mean:.2g}"),
                        ("least |Δγ|", "per cycle", f"{abs(slopes[0]):.2g}"),
                        ("largest |Δγ|", "per cycle", f"{abs(slopes[-1]):.2g}")]
        print(f"{case}, {len(lines)} packings: {', '.join(f'{name} {value}' for name, _, value in numbers)}")
        results.put_numbers(study, case, numbers, campaign, len(lines))


def lines_of(campaign):
    """Δγ by step, of each law and packing that has two steps or more."""
    lines = {}
    for run in long_runs(campaign, "contact.discs.plugin", "time.step"):
        law, seed, step = (run.row[column] for column in ("contact.discs.plugin", "seed", "time.step"))
        lines.setdefault((law, seed), {})[step] = slope_of(run)[0]
    return {key: slopes for key, slopes in lines.items() if len(slopes) > 1}


def put_steps(results, campaign):
    for (law, seed), slopes in lines_of(campaign).items():
        sizes = sorted(slopes)
        exponent = math.log(abs(slopes[sizes[-1]] / slopes[sizes[0]])) / math.log(sizes[-1] / sizes[0])
        listed = ", ".join(f"{slopes[h]:.3e} at {h:g}" for h in sizes)
        case = f"{LAWS[law]}, packing {seed}"
        print(f"{case}: {listed}; exponent {exponent:.3f}")
        for h in sizes:
            results.put_numbers("steps", f"{case}, step {h:g} τ", [("Δγ", "per cycle", f"{slopes[h]:.4g}")], campaign)
        results.put_numbers("steps", case, [("exponent of the step", "1", f"{exponent:.3f}")], campaign)


def put_ranges(results, study, campaign):
    for run in long_runs(campaign):
        gamma = strains(run, DROPPED)[DROPPED:]
        case = ", ".join(([run.row["case"]] if "case" in run.row else []) + [f"packing {run.row['seed']}"])
        print(f"{case}: range of γ over {len(gamma) - 1} cycles {max(gamma) - min(gamma):.2e}")
        results.put_numbers(study, case, [("range of γ", "1", f"{max(gamma) - min(gamma):.2g}")], campaign)


def put_all(results, study, campaign):
    """Records a campaign; false if there is none with finished runs."""
    if not (campaign and runs_of(campaign)):
        return False
    if study in ("laws", "choices", "fine", "large"):
        put_verdicts(results, study, campaign)
    elif study in ("rattlers", "long"):
        put_ranges(results, study, campaign)
    else:
        {"paths": put_paths, "elliptic": put_elliptic, "steps": put_steps}[study](results, campaign)
    return True
