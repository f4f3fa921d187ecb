"""Results of a campaign, its tables and the results of each run; and what a directory holds."""
import functools
import pathlib

from .errors import Error
from .results import Result, json_of
from .tables import read_table


class Campaign:
    """A directory that `scree campaign` wrote."""

    FILES = ("campaign.json", "table.csv")

    def __init__(self, path):
        """Reads nothing yet."""
        self.path = pathlib.Path(path)

    def __fspath__(self):
        return str(self.path)

    def __repr__(self):
        return f"scree.Campaign({str(self.path)!r})"

    @functools.cached_property
    def record(self):
        """campaign.json as a dict."""
        return json_of(self.path / "campaign.json")

    @property
    def study(self):
        """The name of the file of the campaign without its ending, or of the directory if it has no campaign.json."""
        known = (self.path / "campaign.json").exists()
        return pathlib.Path(self.record["file"]).stem if known else self.path.resolve().name

    @functools.cached_property
    def table(self):
        """A row a run: parameters, seed, status, what is collected, all numbers of run.json."""
        return read_table(self.path / "table.csv")

    @functools.cached_property
    def means(self):
        """A row a combination of parameters: means and standard errors over the seeds."""
        return read_table(self.path / "means.csv")

    @functools.cached_property
    def runs(self):
        """All runs by name, in the order of the table; row of each Result is its row of the table."""
        rows = self.table.to_dict("records")
        return {row["run"]: Result(self.path / row["run"], row) for row in rows}

    def finished(self, *columns):
        """The runs that have finished, none without a table; an Error if the table lacks one of the columns."""
        if not (self.path / "table.csv").exists():
            return []
        for column in columns:
            if len(self.table) and column not in self.table:
                table = self.path / "table.csv"
                raise Error(f"{table}: there is no column '{column}'; give the folder of a campaign that varies it")
        return [result for result in self.runs.values() if result.row["status"] == "finished"]

    @functools.cached_property
    def preparations(self):
        """The runs from which others began, by the names of their directories."""
        return {path.name: Result(path) for path in sorted((self.path / "prepare").glob("*")) if path.is_dir()}


def campaigns_in(directories):
    """The campaigns among directories and those in them, by study: of several of a name the first."""
    found = {}
    for directory in map(pathlib.Path, directories):
        for path in (directory, *sorted(directory.glob("*"))):
            if (path / "table.csv").exists():
                campaign = Campaign(path)
                found.setdefault(campaign.study, campaign)
    return found


def read(directory):
    """The results in a directory: a Result, or a Campaign."""
    path = pathlib.Path(directory)
    if not path.is_dir():
        raise Error(f"{path}: there is no such directory; give the directory of a run, study or campaign")
    if any((path / name).exists() for name in Campaign.FILES):
        return Campaign(path)
    result = Result(path)
    result.kind  # noqa: B018 (an Error where there is no record)
    return result
