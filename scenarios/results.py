"""results.csv of a paper's folder: one number a row, from the paper and from scree, with the command, machine,
commit and date of its runs."""
import csv
import functools
import os
import subprocess
import time

from tables import made

COLUMNS = ("study", "quantity", "case", "unit", "paper", "scree", "error", "packings", "command", "machine", "commit",
           "date", "source")
KEY = COLUMNS[:3]


@functools.cache
def machine():
    """Processor and cores of this computer."""
    with open("/proc/cpuinfo", encoding="utf-8") as lines:
        names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return f"{names[0] if names else 'unknown processor'}, {os.cpu_count()} cores"


@functools.cache
def commit(folder):
    """Commit of the tree of a folder; empty if there is none."""
    words = ["git", "-C", folder, "describe", "--always", "--dirty", "--exclude", "*"]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else ""


def date_of(path):
    return time.strftime("%Y-%m-%d", time.gmtime(os.path.getmtime(path)))


class Results:
    """The rows of results.csv in a folder, or else in the folder of the paper. A row that `put`
    measures again keeps its unit, paper and command; its source becomes `runs`. Rows of numbers that were
    written down when the command was run have the source `recorded`."""

    def __init__(self, paper, folder):
        self.paper, self.folder, self.rows = os.path.abspath(paper), folder, {}
        tables = [os.path.join(place, "results.csv") for place in (folder, self.paper)]
        table = next((table for table in tables if os.path.exists(table)), None)
        if table:
            with open(table, encoding="utf-8", newline="") as file:
                self.rows = {tuple(row[column] for column in KEY): row for row in csv.DictReader(file)}

    def put(self, key, unit, scree, error="", packings="", campaign=None, source="runs"):
        """Replaces or adds a row. key: study, quantity, case; campaign: the folder of its runs."""
        kept = self.rows.get(key, dict.fromkeys(COLUMNS, "") | dict(zip(KEY, key)))
        kept["unit"] = kept["unit"] or unit
        kept["command"] = kept["command"] or f"scree campaign scenarios/{os.path.basename(self.paper)}/{key[0]}.toml"
        if campaign:
            kept |= {
                "machine": machine(),
                "commit": commit(self.paper),
                "date": date_of(os.path.join(campaign, "table.csv")),
            }
        self.rows[key] = kept | {"scree": scree, "error": error, "packings": packings, "source": source}

    def put_numbers(self, study, case, numbers, campaign, packings=1):
        """Puts numbers without errors, (quantity, unit, text), of one case."""
        for quantity, unit, text in numbers:
            self.put((study, quantity, case), unit, text, "", packings, campaign)

    def value(self, *key):
        """What scree found, and its error (nan if there is none); None if there is no such row or it is no number."""
        try:
            row = self.rows[key]
            return float(row["scree"]), float(row["error"] or "nan")
        except (KeyError, ValueError):
            return None

    def write(self):
        path = os.path.join(made(self.folder), "results.csv")
        with open(path, "w", encoding="utf-8", newline="") as file:
            rows = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            rows.writeheader()
            rows.writerows(self.rows.values())
        print(path)
