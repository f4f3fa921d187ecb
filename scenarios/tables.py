"""What the scripts of the papers share: the Python package of this tree, their arguments, and runs of campaigns."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "tools", "python"))
import scree  # noqa: E402 (of the tree)


def refuse(text):
    """Ends the script with one line."""
    sys.exit(f"{os.path.basename(sys.argv[0])}: {text}")


def one_line(kind, error, trace):
    """Prints an error of the package as refuse does."""
    if issubclass(kind, scree.Error):
        print(f"{os.path.basename(sys.argv[0])}: {error}", file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


sys.excepthook = one_line


def runs_of(folder, *columns):
    """The finished runs of a campaign, whose table must have the columns; none if there is no such campaign."""
    return scree.Campaign(folder).finished(*columns) if os.path.exists(os.path.join(folder, "table.csv")) else []


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
        return os.path.splitext(os.path.basename(scree.Campaign(folder).record["file"]))[0]
    except scree.Error:
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
