"""Runs scenes and studies."""
import os

from .campaigns import read
from .errors import Error
from .program import call, directory_in, failure, find_program
from .results import Result
from .values import assignments, toml, value_at

WITH_RESULTS = (1, 3, 4, 130)  # exit statuses: not met or failed, blown up, a stage that was not reached, Ctrl-C


def run(scene, set=None, out=None, program=None, overwrite=False, resume=False, quiet=True, **options):
    """Runs a scene and reads its results. resume: a finished run in out is kept, and an interrupted one goes on."""
    if resume and out is None:
        raise Error("resume: needs out, the directory of the run")
    if resume and not overwrite and os.path.exists(os.path.join(out, Result.RECORDS["run"])):
        return gone_on(Result(out), set or {}, program, quiet, options)
    return study("run", scene, set, out, program, overwrite, quiet, **options)


def study(verb, file, set=None, out=None, program=None, overwrite=False, quiet=True, **options):
    """Calls a verb such as "campaign" or "quasi-static" and reads its results; increments=40 is --increments 40."""
    words = [verb, file, *assignments(set), *flags(options)]
    if out is not None:
        words += ["--out", out]
    if overwrite:
        words.append("--overwrite")
    return results_of(words, out, program, quiet)


def gone_on(result, values, program, quiet, options):
    """The results of a directory that has a run, which must have the values; continued if it has not finished."""
    for key, value in values.items():
        try:
            kept = value_at(result.scenario, key)
        except (KeyError, TypeError, AttributeError):
            continue  # only the program knows all forms of keys
        if toml(kept) != toml(value) and kept != value:
            problem = f"{result.path}: holds a run with {key} = {toml(kept)}"
            raise Error(f"{problem}; give another out, or overwrite=True to replace it")
    if result.status == "finished":
        return result
    return results_of(["resume", result.path, *flags(options)], result.path, program, quiet)


def results_of(words, out, program, quiet):
    """Calls the program and reads what it wrote; an Error has it too, where there is any."""
    status, lines = call([*words, *["--quiet"] * quiet], program, quiet)
    directory = out or directory_in(lines)
    if status == 0:
        if not directory or not os.path.isdir(directory):
            raise Error(f"{find_program(program)}: wrote no results; give the program scree")
        return read(directory)
    error = failure(words, status, lines)
    if status in WITH_RESULTS and directory and os.path.isdir(directory):
        error.result = read(directory)
    raise error


def flags(options):
    """Words of options: threads=2 is --threads 2, a list repeats its option, and True is the option alone."""
    words = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        for part in value if isinstance(value, (list, tuple)) else [value]:
            if part is True:
                words.append(option)
            elif part is not None and part is not False:
                words += [option, str(part)]
    return words
