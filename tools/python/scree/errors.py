"""Errors in one line with their place and cure, where packages, names and folders are missing."""
import importlib
import os


class Error(Exception):
    """One line; of a call of the program also its exit status, and the results that it left, else None."""

    def __init__(self, line, status=None, result=None):
        super().__init__(line)
        self.status, self.result = status, result


class NoSuchName(Error, KeyError):
    """A name that a mapping lacks, such as a series."""

    __str__ = Exception.__str__


def package(name):
    """A package such as pandas, or a module of it; an Error that names the Debian package if it is missing."""
    try:
        return importlib.import_module(name)
    except ImportError:
        name = name.partition(".")[0]
        line = f"there is no {name}; install the package python3-{name}, or call a python3 that has it"
        raise Error(line) from None


def named(mapping, name, place, noun):
    """The value of a name; an Error that lists the names if there is none."""
    if name not in mapping:
        names = ", ".join(str(known) for known in mapping)
        cure = f"give one of {names}" if names else "it has none"
        raise NoSuchName(f"{place}: there is no {noun} '{name}'; {cure}")
    return mapping[name]


def made(folder):
    """The folder, which is made where there is none; an Error if it cannot be."""
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise Error(f"{folder}: {error.strerror}; give a folder that can be written") from None
    return folder
