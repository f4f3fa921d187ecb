"""CSV tables that scree writes, as data frames."""
import csv
import io
import re

from .errors import Error, package

# Columns of texts that may look like numbers.
TEXTS = r"case|column|material|method|run|spring|status|wall|warnings|.*_unit"


def read_table(path):
    """The table of a file, columns without units; attrs has "units" by column, and "head", the comments."""
    pandas = package("pandas")
    comments, header, rows = parts_of(path)
    if not header:
        return pandas.DataFrame()
    names, units = zip(*(name_and_unit(cell) for cell in header))
    units = {name: unit for name, unit in zip(names, units) if unit is not None}
    texts = {name: str for name in names if name not in units and re.fullmatch(TEXTS, name)}
    gaps = {name: ["", "nan", "-nan"] for name in names if name not in texts}
    try:
        # Without "round_trip" the last bits of numbers would be lost.
        frame = pandas.read_csv(io.StringIO(rows), header=None, names=list(names), converters=texts, na_values=gaps,
                                dtype=dict.fromkeys(units, float), keep_default_na=False, index_col=False,
                                float_precision="round_trip")
    except ValueError as error:
        problem = f"{path}: is not a table of scree ({str(error).splitlines()[0]})"
        raise Error(f"{problem}; give a CSV file that scree wrote") from None
    frame.attrs["units"] = units
    frame.attrs["head"] = dict(head_line(line) for line in comments)
    return frame


def units_of(path):
    """Units of the columns of a file by their names, of which only the header is read."""
    with opened(path) as file:
        header = next((line for line in file if not line.startswith("#")), "")
    pairs = (name_and_unit(cell) for cell in next(csv.reader([header]), []))
    return {name: unit for name, unit in pairs if unit is not None}


def opened(path):
    """The file for reading; an Error if it cannot be opened."""
    try:
        return open(path, encoding="utf-8", errors="replace", newline="")
    except OSError as error:
        raise Error(f"{path}: {error.strerror}; give the directory of results that have this table") from None


def parts_of(path):
    """Comments, cells of the header, and text of the rows."""
    with opened(path) as file:
        lines = file.readlines()
    comments = [line for line in lines if line.startswith("#")]
    lines = [line for line in lines if not line.startswith("#")]
    header = next(csv.reader(lines[:1]), [])
    return comments, header, "".join(lines[1:])


def name_and_unit(cell):
    """The parts of a header such as "x [m]"; a unit of None if there is none."""
    found = re.fullmatch(r"(.*?) \[([^][]*)\]", cell)
    return found.groups() if found else (cell, None)


def head_line(line):
    """Name and text of a comment such as "# time [s]: 0.1"."""
    name, _, text = line.lstrip("#").strip().partition(":")
    return name_and_unit(name)[0], text.strip()
