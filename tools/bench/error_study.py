"""Steps and time that scree, LIGGGHTS and LAMMPS need for an error of 1e-2, 1e-3 and 1e-4.

Each code runs the same bodies with 4 and more steps per contact. Its error is the difference from its own converged
result, with steps at least 16 times finer than the finest of the ladder, so that differences between contact laws do
not count. Impacts: velocities and spins, relative to the change of velocity, root mean square over 8 phases of the
start of contact within a step. Packings: positions, relative to the mean overlap (assembly) or the radius (gas). Steps:
smallest number from which on the error stays below the target. Time: steps times the time per step, timed alternately
on one core; per contact, or per run of a packing. All cases take about ten minutes. Requires a release build (tools/run
once) and liggghts and lammps of Debian; --record draws a chart if python3-matplotlib is installed."""
import argparse
import dataclasses
import math
import os
import pathlib
import shutil
import sys
import tempfile

import error_cases
import error_codes
import error_record

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TARGETS = (1e-2, 1e-3, 1e-4)
RESOLVED = 3  # minimum error in units of the difference between the two finest runs
LAWS = """Differences of the contact laws (all with tensile dashpot forces at the end of a contact):
  scree     its own slip rule with the limit mu max(f_n, 0); default Hertz-Mindlin history
  LIGGGHTS  hooke/stiffness or hertz, tangential history: the spring without its dashpot is compared with
            mu |f_n|; the dashpot acts without limit while the contact sticks, and not while it slides; the
            displacement is kept when the stiffness changes
  LAMMPS    granular, hooke or hertz/material: spring and dashpot together are limited by mu |f_n|;
            mindlin_rescale/force; the fit behind its tsuji damping gives a slightly different restitution;
            arms of the slip velocity are R, those of the others R - overlap/2
steps: of an elastic contact of that length (assembly: half the period of a pair under load);
"<": the longest steps of the ladder already suffice; ">": more steps than the finest resolved run;
"?": no error could be determined. ratio: LIGGGHTS/scree, then LAMMPS/scree, of steps and of times"""


def three_digits(number):
    return f"{number:.3g}" if number < 1000 else f"{number:.0f}"


@dataclasses.dataclass
class Needed:
    """Steps for an error; sign: lower bound (>), upper bound (<) or unknown (?)."""
    steps: float
    sign: str = ""

    def cell(self, factor=1.0):
        return self.sign if self.sign == "?" else self.sign + three_digits(self.steps * factor)


@dataclasses.dataclass
class Curve:
    """Errors of a code in a case."""
    code: str
    points: list  # (steps, error)
    floor: float  # difference between its two finest runs
    known: str
    # Per step, for each contact or the whole packing; minimum over repeats, as other load only slows codes down.
    seconds: list = dataclasses.field(default_factory=list)

    def time(self, case):
        """Time of a run with one step per contact, in the unit of the case."""
        return min(self.seconds) * case.duration * 1e6 / case.unit[2]

    def resolves(self, error):
        """Whether the error exceeds the uncertainty of the reference."""
        return error > RESOLVED * self.floor

    def needed(self, target):
        points = self.points if self.resolves(target) else [p for p in self.points if self.resolves(p[1])]
        above = [k for k, (_, error) in enumerate(points) if not error <= target]
        if not above:
            return Needed(self.points[0][0], "<" if points else "?")
        if above[-1] + 1 == len(points):
            return Needed(points[-1][0], ">")
        (coarse, high), (fine, low) = points[above[-1]:above[-1] + 2]
        if not math.isfinite(high):
            return Needed(fine)
        share = math.log(high / target) / math.log(high / max(low, 1e-16))
        return Needed(coarse * (fine / coarse) ** share)


def ratio(theirs, ours, factor=1.0):
    """Ratio of another code to scree; "" if undetermined because of bounds."""
    signs = {theirs.sign, {">": "<", "<": ">"}.get(ours.sign, ours.sign)} - {""}
    if len(signs) > 1 or "?" in signs:
        return ""
    return "".join(signs) + three_digits(theirs.steps / ours.steps * factor)


# --- measuring --------------------------------------------------------------------------------------------------------


def converge(case, code):
    """Error curve of a code, without times."""
    reference = code.run(case.scene(case, case.reference, 1))
    floor = case.error(case, code.run(case.scene(case, case.reference // 2, 1)), reference)
    points = []
    for steps in case.ladder:
        try:
            points.append((steps, case.error(case, code.run(case.scene(case, steps, 1)), reference)))
        except SystemExit:  # the reference ran, so the step is too long for the code
            points.append((steps, math.inf))
    return Curve(code.name, points, floor, case.known(case, reference))


def measure(case, codes, kinds, repeats):
    programs = [kind(codes) for kind in kinds]
    curves = [converge(case, program) for program in programs]
    steps, copies = case.timed
    scene = case.scene(case, steps, copies)
    contacts = copies * error_cases.PHASES if copies > 1 else 1
    for _ in range(repeats):
        codes.wait_for_quiet(2)
        for curve, program in zip(curves, programs):
            curve.seconds.append(program.time(scene) / contacts)
    return curves


# --- printing and recording -------------------------------------------------------------------------------------------


HEAD = ["case", "error", "steps scree", "LIGGGHTS", "LAMMPS", "ratio", "ratio",
        "time scree", "LIGGGHTS", "LAMMPS", "ratio", "ratio"]
LINE = "| {:<14} | {:>5} | {:>11} | {:>8} | {:>7} | {:>6} | {:>6} | {:>10} {:<2} | {:>8} | {:>7} | {:>6} | {:>6} |"


def rows(case, curves):
    """One row of strings per target."""
    times = [curve.time(case) for curve in curves]
    table = []
    for target in TARGETS:
        needed = [curve.needed(target) for curve in curves]
        steps = [each.cell() for each in needed] + [ratio(each, needed[0]) for each in needed[1:]]
        spent = [each.cell(time) for each, time in zip(needed, times)]
        spent += [ratio(each, needed[0], time / times[0]) for each, time in zip(needed[1:], times[1:])]
        table.append([case.name, f"{target:.0e}".replace("e-0", "e-"), *steps, spent[0], case.unit[1], *spent[1:]])
    return table


def print_head():
    print(LINE.format(*HEAD[:8], "", *HEAD[8:]))
    print("|" + "|".join("-" * width for width in (16, 7, 13, 10, 9, 8, 8, 15, 10, 9, 8, 8)) + "|", flush=True)


def print_case(case, curves):
    for row in rows(case, curves):
        print(LINE.format(*row), flush=True)


def notes(case, curves):
    """Converged result of each code, and the limit below which its errors are not resolved."""
    for curve in curves:
        known = f"converges to {curve.known}; " if curve.known else ""
        seconds = min(curve.seconds)
        single = case.unit[0] == "contact"
        each = f"{seconds * 1e9:.3g} ns a step and contact" if single else f"{seconds * 1e6:.3g} µs a step"
        yield f"{case.name:<14} {curve.code:<8} {known}reference good to {curve.floor:.1e}; {each}"


def kept(case, curves):
    """All points of the ladder, for the chart."""
    for curve in curves:
        time = curve.time(case)
        for steps, error in curve.points:
            yield [case.name, case.title, *case.unit[:2], curve.code, f"{steps:.6g}", f"{steps * time:.4g}",
                   f"{error:.4g}", "yes" if curve.resolves(error) else "no", f"{curve.floor:.2g}", curve.known]


# --- the command ------------------------------------------------------------------------------------------------------


def arguments(words, cases):
    parser = argparse.ArgumentParser(prog="peers --error", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: tools/bench/peers --error hertz-0.9 gas --repeats 9")
    parser.add_argument("cases", nargs="*", metavar="CASE", help="cases, see --list (default all)")
    parser.add_argument("--list", action="store_true", help="list the cases")
    parser.add_argument("--repeats", type=int, default=5, help="number of timings; the fastest is used (default 5)")
    parser.add_argument("--core", type=int, default=0, help="core to run on (default 0)")
    parser.add_argument("--scree", type=pathlib.Path, default=ROOT / "build/release/bin/scree",
                        help="program to measure")
    parser.add_argument("--record", action="store_true", help="write table, errors and chart to tools/bench/results")
    chosen = parser.parse_args(words)
    unknown = [name for name in chosen.cases if name not in cases]
    if unknown:
        parser.error(f"no case {', '.join(unknown)}; choose from {', '.join(cases)}")
    if chosen.repeats < 1:
        parser.error("--repeats must be at least 1")
    if chosen.core not in os.sched_getaffinity(0):
        parser.error(f"there is no core {chosen.core}")
    chosen.cases = chosen.cases or list(cases)
    return chosen


def refuse_missing(chosen):
    needed = ("taskset", "liggghts", "lmp", str(chosen.scree))
    missing = sorted(program for program in needed if not shutil.which(program))
    if missing:
        sys.exit(f"peers: {', '.join(missing)} missing; apt install --no-install-recommends liggghts lammps, and build with tools/run")


def main(words, make_codes, machine, version):
    """make_codes: (program, cores, folder) -> Codes of peers, which runs programs on the cores."""
    cases = error_cases.all_cases()
    chosen = arguments(words, cases)
    if chosen.list:
        print("\n".join(f"{name:<16}{case.title}" for name, case in cases.items()))
        return
    refuse_missing(chosen)
    print(f"{machine['title']}; fastest of {chosen.repeats}; ratios: LIGGGHTS/scree, LAMMPS/scree\n")
    print_head()
    measured, disturbed = [], []
    with tempfile.TemporaryDirectory() as work:
        codes = make_codes(chosen.scree.resolve(), [chosen.core], pathlib.Path(work))
        for name in chosen.cases:
            codes.disturbed = False
            measured.append((cases[name], measure(cases[name], codes, error_codes.ALL, chosen.repeats)))
            print_case(*measured[-1])
            disturbed += [name] if codes.disturbed else []
    print(f"\n{LAWS}\n")
    print("\n".join(line for case, curves in measured for line in notes(case, curves)))
    if disturbed:
        print(f"other programs ran on this core during the timing of: {', '.join(disturbed)}")
    if chosen.record:
        summary = [row for case, curves in measured for row in rows(case, curves)]
        ladder = [row for case, curves in measured for row in kept(case, curves)]
        for file in error_record.record(summary, ladder, machine, version, list(cases)):
            print(f"written to {file}")
