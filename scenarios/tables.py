"""Tables and campaigns that scree writes, for the scripts of the papers."""
import csv
import json
import os
import sys
import tomllib


def refuse(text):
    """Ends the script with one line."""
    sys.exit(f"{os.path.basename(sys.argv[0])}: {text}")


def read(path):
    """Rows of a table by the names of the columns, without units."""
    with open(path, encoding="utf-8") as lines:
        rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    names = [name.split(" [")[0] for name in rows[0]] if rows else []
    return [dict(zip(names, row)) for row in rows[1:]]


def runs_of(folder, *columns):
    """Rows of the finished runs of a campaign, with the path of each; none if there is no such campaign. Ends
    the script with one line if its table lacks one of the columns."""
    table = os.path.join(folder, "table.csv")
    rows = read(table) if os.path.exists(table) else []
    for column in columns:
        if rows and column not in rows[0]:
            refuse(f"{table}: there is no column '{column}'; give the folder of a campaign that varies it")
    for row in rows:
        row["path"] = os.path.join(folder, row["run"])
    return [row for row in rows if row["status"] == "finished"]


def scenario_of(run):
    """The scenario of a run, with all its overrides."""
    with open(os.path.join(run, "scenario.toml"), "rb") as scenario:
        return tomllib.load(scenario)


def arguments(usage, least, most):
    """The arguments of the script. Ends it with its usage for --help, and where there are too few or too many."""
    given = sys.argv[1:]
    if given and given[0] in ("-h", "--help"):
        print(usage)
        sys.exit(0)
    if not least <= len(given) <= most:
        print(usage, file=sys.stderr)
        sys.exit(2)
    return given


def folders(usage):
    """The folders that the script is given, and the folder of --out, by default the first."""
    given = arguments(usage, 1, sys.maxsize)
    if "--out" not in given:
        return given, given[0]
    at = given.index("--out")
    out, given = given[at + 1 : at + 2], given[:at] + given[at + 2 :]
    if not out or not given:
        print(usage, file=sys.stderr)
        sys.exit(2)
    return given, out[0]


def study_of(folder):
    """The name of the file of a campaign without its ending, or the name of a folder that is no campaign."""
    try:
        with open(os.path.join(folder, "campaign.json"), encoding="utf-8") as record:
            return os.path.splitext(os.path.basename(json.load(record)["file"]))[0]
    except OSError:
        return os.path.basename(os.path.abspath(folder))


def no_runs(folder, campaign):
    """Ends the script with one line: which campaign comes first."""
    refuse(f"{folder}: no finished run of a campaign; run scree campaign {campaign} first")


def made(folder):
    """The folder, which is made where there is none. Ends the script with one line if it cannot be."""
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        refuse(f"{folder}: {error.strerror}")
    return folder
