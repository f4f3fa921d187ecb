"""Finds and calls the program scree."""
import os
import pathlib
import shutil
import signal
import subprocess

from .errors import Error

TREE = pathlib.Path(__file__).resolve().parent.parent.parent.parent
PLACES = (TREE / "build" / "release" / "bin" / "scree", TREE.parent.parent.parent / "bin" / "scree")  # built, installed


def find_program(program=None):
    """The path of the program: the argument, else SCREE_PROGRAM, else scree in PATH, else the one of this tree."""
    for place, given in (("program", program), ("SCREE_PROGRAM", os.environ.get("SCREE_PROGRAM"))):
        if given:
            found = shutil.which(given)
            if not found:
                raise Error(f"{place}: {given}: there is no such program; give the path of bin/scree")
            return found
    found = next(filter(None, map(shutil.which, ("scree", *PLACES))), None)
    if not found:
        raise Error("there is no program scree; give its path as program or in SCREE_PROGRAM, or its folder in PATH")
    return found


def call(words, program=None, quiet=True):
    """Calls the program; its exit status and lines, which are printed as they come unless quiet."""
    words = [find_program(program), *(os.fspath(word) for word in words)]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "encoding": "utf-8", "errors": "replace"}
    lines = []
    with subprocess.Popen(words, **pipes) as process:
        try:
            for line in process.stdout:
                lines.append(line.rstrip("\n"))
                if not quiet:
                    print(line, end="", flush=True)
        except KeyboardInterrupt:
            process.send_signal(signal.SIGINT)
            process.stdout.read()  # until it has saved its state
            raise
    return process.returncode, lines


def failure(words, status, lines):
    """The error of a call: one line, with the exit status."""
    return Error(f"{line_of_failure(words, lines)} (exit status {status})", status)


def line_of_failure(words, lines):
    """The line that says what went wrong: an error, else the first condition that is not met, else the last line."""
    errors = [line for line in lines if line.startswith("scree: ") and not line.startswith("scree: warning: ")]
    unmet = [line for line in lines if line.startswith("NOT MET")]
    if errors:
        return errors[-1].removeprefix("scree: ")
    if unmet:
        more = f", and {len(unmet) - 1} more" if len(unmet) > 1 else ""
        return f"{words[1]}: not met: {unmet[0].removeprefix('NOT MET').strip()}{more}"
    return lines[-1] if lines else f"{words[1]}: scree {words[0]} failed and says nothing"


def directory_in(lines):
    """The directory that the program names, or None."""
    for line in reversed(lines):
        if line.startswith("results in "):
            directory = line.removeprefix("results in ")
            # Studies list their files after it.
            return directory if os.path.isdir(directory) else directory.rpartition(": ")[0]
    return None
