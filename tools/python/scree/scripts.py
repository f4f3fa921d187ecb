"""Scripts that evaluate results: their arguments, and errors in one line."""
import os
import pathlib
import sys

from .campaigns import Campaign
from .charts import draw
from .documents import Numbers
from .errors import Error, package


def start(*packages):
    """Errors of scree end the script with one line from here on; so does a package that is missing."""
    sys.excepthook = one_line
    for name in packages:
        package(name)


def one_line(kind, error, trace):
    """Prints an error of scree after the name of the script, and others as Python does."""
    if issubclass(kind, Error):
        print(f"{os.path.basename(sys.argv[0])}: {error}", file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


def arguments(usage, least, most):
    """The arguments of the script. Ends it with its usage for --help, and where there are too few or too many."""
    given = sys.argv[1:]
    if given and given[0] in ("-h", "--help"):
        print(usage)
        sys.exit(0)
    if not least <= len(given) <= most:
        wrong(usage)
    return given


def folders(usage):
    """The folders that the script is given, and the folder of --out, by default the first."""
    given = arguments(usage, 1, sys.maxsize)
    if "--out" not in given:
        return given, given[0]
    at = given.index("--out")
    out, given = given[at + 1 : at + 2], given[:at] + given[at + 2 :]
    if not out or not given:
        wrong(usage)
    return given, out[0]


def wrong(usage):
    """Ends the script with its usage."""
    print(usage, file=sys.stderr)
    sys.exit(2)


def no_runs(folder, campaign):
    """An Error which says that a campaign comes first."""
    return Error(f"{os.fspath(folder)}: no finished run of a campaign; run scree campaign {campaign} first")


def draw_known(path, panels, size, columns=2):
    """Draws those of (needs, panel) that have a panel, row by row, and prints what the others need. size: of one."""
    known = [panel for _, panel in panels if panel]
    for needs in dict.fromkeys(needs for needs, panel in panels if not panel):
        print(f"{os.path.basename(path)} {'without' if known else 'not drawn:'} {needs}")
    if known:
        columns = min(len(known), columns)
        spare = 0.5 * (columns == 1)  # for its title
        print(draw(path, known, (size[0] * columns + spare, size[1] * -(-len(known) // columns)), columns))


def record(usage, paper, evaluate):
    """Records in results.csv what the folders hold that the script is given: evaluate(campaign, out, numbers)
    puts the numbers of one, which are printed. paper: its folder. The folder of --out, and all numbers."""
    given, out = folders(usage)
    numbers, out = Numbers(paper, out), pathlib.Path(out)
    for folder in given:
        evaluate(Campaign(folder), out, numbers)
        numbers.print()
    print(numbers.write())
    return out, numbers
