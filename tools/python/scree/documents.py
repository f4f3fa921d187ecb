"""Numbers in documents: a record of numbers with their origin, and tables of pages that commands write."""
import csv
import functools
import os
import re
import subprocess
import time

from .errors import Error, made


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


class Numbers:
    """The numbers of a study such as a paper: the rows of results.csv in a folder, or else in the folder of the paper.

    Each has study, quantity and case, by which it is replaced; unit; the value of the paper and of scree, with its
    error and the number of packings; command, machine, commit and date; source, "runs" if it is of runs that were read."""

    COLUMNS = ("study", "quantity", "case", "unit", "paper", "scree", "error", "packings", "command", "machine",
               "commit", "date", "source")
    KEY = COLUMNS[:3]

    def __init__(self, paper, folder):
        """Reads the rows, if there are any."""
        self.paper, self.folder, self.rows, self.new = os.path.abspath(paper), folder, {}, []
        tables = [os.path.join(place, "results.csv") for place in (folder, self.paper)]
        table = next((table for table in tables if os.path.exists(table)), None)
        if table:
            with open(table, encoding="utf-8", newline="") as file:
                self.rows = {tuple(row[column] for column in self.KEY): row for row in csv.DictReader(file)}

    def put(self, study, case, numbers, campaign=None, packings=1, source="runs", note=""):
        """Replaces or adds rows, (quantity, unit, value) or (quantity, unit, value, error), of texts or of numbers,
        which get three and two digits; what is nan is left out. Unit, paper and command stay as they were. campaign:
        the folder of the runs, whose date is taken; note: for the table that is printed."""
        cells = {"packings": packings}
        for quantity, unit, *given in numbers:
            value, error = (text_of(number, form) for number, form in zip((*given, ""), (".3g", ".2g")))
            if not value:
                continue
            key = study, quantity, case
            row = self.rows.get(key, dict.fromkeys(self.COLUMNS, "") | dict(zip(self.KEY, key)))
            row["unit"] = row["unit"] or unit
            row["command"] = row["command"] or f"scree campaign scenarios/{os.path.basename(self.paper)}/{study}.toml"
            if campaign:
                seconds = os.path.getmtime(os.path.join(campaign, "table.csv"))
                date = time.strftime("%Y-%m-%d", time.gmtime(seconds))
                row |= {"machine": machine(), "commit": commit(self.paper), "date": date}
            self.rows[key] = row | {"scree": value, "error": error, "packings": packings, "source": source}
            cells[f"{quantity} [{unit}]" if unit != "1" else quantity] = f"{value} ± {error}" if error else value
        self.new.append({"case": case} | cells | ({"note": note} if note else {}))

    def print(self):
        """Prints the numbers that were put since the last call, if any: a row a case, a column a quantity."""
        heads = sorted(dict.fromkeys(head for cells in self.new for head in cells), key=lambda head: head == "note")
        rows = [[cells.get(head, "") for head in heads] for cells in self.new]
        self.new = []
        if rows:
            print(aligned(heads, rows))

    def value(self, *key):
        """What scree found, and its error (nan if there is none); None if there is no such row or it is no number."""
        try:
            row = self.rows[key]
            return float(row["scree"]), float(row["error"] or "nan")
        except (KeyError, ValueError):
            return None

    def over(self, study, quantity, pattern):
        """What scree found, by the groups of a pattern of the case, of all cases that it matches as a whole."""
        found = {key: re.fullmatch(pattern, key[2]) for key in self.rows if key[:2] == (study, quantity)}
        values = {match.groups(): self.value(*key) for key, match in found.items() if match}
        return {groups: value[0] for groups, value in values.items() if value}

    def write(self):
        """Writes results.csv into the folder; its path."""
        path = os.path.join(made(self.folder), "results.csv")
        with open(path, "w", encoding="utf-8", newline="") as file:
            rows = csv.DictWriter(file, self.COLUMNS, lineterminator="\n")
            rows.writeheader()
            rows.writerows(self.rows.values())
        return path


class Section:
    """The part of a page between a line that begins with a text and another text, which a command writes."""

    def __init__(self, page, begin, end):
        """Reads the page; an Error if it does not have both, begin once."""
        self.page = page
        try:
            with open(page, encoding="utf-8") as file:
                text = file.read()
        except OSError as error:
            raise Error(f"{page}: {error.strerror}; give a folder that has this page") from None
        if text.count(begin) != 1 or end not in text.split(begin)[1]:
            raise Error(f"{page}: the lines '{begin}' and '{end}' are not there; give a folder whose page has them")
        at = text.index("\n", text.index(begin))
        self.before, self.text = text[:at], text[at : text.index(end, at)]
        self.after = text[at + len(self.text) :]

    def write(self, text):
        """Replaces the part."""
        with open(self.page, "w", encoding="utf-8") as file:
            file.write(f"{self.before}\n\n{text}\n\n{self.after}")


def table_row(cells):
    """A row of a table in Markdown."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def text_of(value, form):
    """A text as it is, and a number in a format, empty where it is nan."""
    if isinstance(value, str):
        return value
    return "" if value != value else format(value, form)


def aligned(heads, rows):
    """A table of texts as lines; its columns are aligned on the right, but for the first."""
    table = [list(map(str, row)) for row in (heads, *rows)]
    first, *widths = [max(map(len, column)) for column in zip(*table)]
    return "\n".join("  ".join([row[0].ljust(first), *map(str.rjust, row[1:], widths)]).rstrip() for row in table)
