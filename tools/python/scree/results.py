"""Results of a run or study in its directory."""
import collections.abc
import functools
import json
import os
import pathlib
import tomllib
import urllib.parse

from .errors import Error, named
from .states import State, contacts
from .tables import read_table, units_of


class Tables(collections.abc.Mapping):
    """The CSV tables of a folder by name, each read when it is first asked for."""

    def __init__(self, folder, noun):
        """noun: what a table is, for messages."""
        self.folder, self.noun, self.frames = pathlib.Path(folder), noun, {}

    def __getitem__(self, name):
        if name not in self.frames:
            self.frames[name] = read_table(self.path(name))
        return self.frames[name]

    def __iter__(self):
        return iter(sorted(path.stem for path in self.folder.glob("*.csv")))

    def __len__(self):
        return len(list(iter(self)))

    def path(self, name):
        """The file of a table; an Error that names the tables if there is none."""
        return named({known: self.folder / f"{known}.csv" for known in self}, name, self.folder, self.noun)


class Result:
    """A directory with results. row: its parameters and numbers in the table of a campaign, else empty."""

    RECORDS = {kind: f"{kind}.json" for kind in ("run", "spectrum", "modes", "quasi_static", "accuracy", "cycles")}

    def __init__(self, path, row=None):
        """Reads nothing yet."""
        self.path, self.row = pathlib.Path(path), row or {}
        self.series = Tables(self.path / "series", "series")
        self.tables = Tables(self.path, "table")

    def __repr__(self):
        return f"scree.{type(self).__name__}({str(self.path)!r})"

    @functools.cached_property
    def kind(self):
        """What wrote the results: "run", "spectrum", "modes", "quasi_static", "accuracy" or "cycles"."""
        for kind, name in self.RECORDS.items():
            if (self.path / name).exists():
                return kind
        raise Error(f"{self.path}: has no {', '.join(self.RECORDS.values())}; give the directory of results of scree")

    @functools.cached_property
    def record(self):
        """run.json, spectrum.json, ..., as a dict."""
        return json_of(self.path / self.RECORDS[self.kind])

    @functools.cached_property
    def scenario(self):
        """The scenario as it was run, with its overrides, as a dict."""
        return toml_of(self.path / "scenario.toml")

    @property
    def status(self):
        """Such as "finished", "failed", "interrupted", "running"."""
        return self.record.get("status")

    @property
    def stages(self):
        """Of each stage: name, start, end, steps, and what ended it."""
        return self.record.get("stages", [])

    @property
    def expectations(self):
        """Of each [[expect]]: requirement, value, reference or bounds, and whether it is met."""
        return self.record.get("expect", [])

    @property
    def warnings(self):
        """Warnings of the run."""
        return self.record.get("warnings", [])

    def table(self, name):
        """Another table of the directory, such as "peaks" of a spectrum, as a data frame."""
        return self.tables[name]

    def units(self, name):
        """Units of the columns of a series, or of a table that no series is named as."""
        return units_of((self.series if name in self.series else self.tables).path(name))

    def bodies(self):
        """Bodies at the end as a data frame, from final_packing.csv."""
        return self.table("final_packing")

    def contacts(self, program=None, plugins=None):
        """Contacts of the last state as a data frame."""
        return contacts(self.path, program, plugins)

    @functools.cached_property
    def states(self):
        """Files of states by name: stages ("settle"), checkpoints ("checkpoint/<file>"), "state" of a study, "final"."""
        files = {urllib.parse.unquote(path.stem): path for path in sorted((self.path / "states").glob("*.h5"))}
        files |= {f"checkpoint/{path.stem}": path for path in sorted((self.path / "checkpoint").glob("*.h5"))}
        last = {"state": self.path / "state.h5", "final": self.path / "final_state.h5"}
        return files | {name: path for name, path in last.items() if path.exists()}

    def state(self, name="final"):
        """A state by its name in states, or by the path of its file."""
        if name not in self.states and os.path.isfile(name):
            return State(name)
        return State(named(self.states, name, self.path, "state"))

    @property
    def prepared(self):
        """Of a run of a campaign, the run from whose state it began."""
        state = pathlib.Path(self.scenario["particles"]["state"])
        return Result(self.path.parent / "prepare" / state.parent.name)

    @property
    def walls(self):
        """The walls of the last state as a data frame."""
        return self.state().walls


def share(condition):
    """Of an [[expect]], deviation over tolerance; of a bound, value over it where both are above 0; else None."""
    value = condition["value"]
    if condition.get("tolerance"):
        return abs(value - condition["reference"]) / condition["tolerance"]
    if condition.get("at_most", 0) > 0 and value >= 0:
        return value / condition["at_most"]
    return None


def json_of(path):
    """A file of JSON as a dict; an Error if it cannot be read."""
    record = parsed(path, json.loads, "JSON")
    if not isinstance(record, dict):
        raise Error(f"{path}: is no record of scree; run the scene again, with --overwrite")
    return record


def toml_of(path):
    """A file of TOML as a dict; an Error if it cannot be read."""
    return parsed(path, tomllib.loads, "TOML")


def parsed(path, loads, language):
    """What a function makes of the text of a file."""
    try:
        return loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Error(f"{path}: {error.strerror}; give the directory of results that have this file") from None
    except (ValueError, RecursionError):
        raise Error(f"{path}: is not {language}; run the scene again, with --overwrite") from None
