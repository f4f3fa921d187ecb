"""Errors in one line with their place and cure, and packages that are imported where they are needed."""
import importlib


class Error(Exception):
    """One line; of a call of the program also its exit status, and the results that it left, else None."""

    def __init__(self, line, status=None, result=None):
        super().__init__(line)
        self.status, self.result = status, result


class NoSuchName(Error, KeyError):
    """A name that a mapping lacks, such as a series."""

    __str__ = Exception.__str__


def package(name):
    """A package such as pandas; an Error that names the Debian package if it is missing."""
    try:
        return importlib.import_module(name)
    except ImportError:
        line = f"there is no {name}; install the package python3-{name}, or call a python3 that has it"
        raise Error(line) from None


def named(mapping, name, place, noun):
    """The value of a name; an Error that lists the names if there is none."""
    if name not in mapping:
        names = ", ".join(str(known) for known in mapping)
        cure = f"give one of {names}" if names else "it has none"
        raise NoSuchName(f"{place}: there is no {noun} '{name}'; {cure}")
    return mapping[name]
