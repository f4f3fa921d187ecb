"""Writes the table of scenes in the README.md of a folder: what each requires, and how near it comes to its bound.

Usage: python3 -m scree.page FOLDER PROGRAM    # scenarios/verification build/release/bin/scree
       python3 -m scree.page FOLDER            # only compares the page with the scenes; status 1 if they differ

The page has a line that begins with "<!-- Written by scree.page", and a line "<!-- end -->"; the table is between."""
import pathlib
import re
import tempfile
import tomllib

from .documents import Section, table_row
from .errors import Error
from .results import share
from .runs import run
from .scripts import arguments, start

BEGIN, END = "<!-- Written by scree.page", "<!-- end -->"
HEAD = "| scene | title | required | conditions | share | of the condition |\n|---|---|---|---|---|---|\n"
COMPONENTS = {**dict.fromkeys(("vx", "vy", "vz"), "velocity after"),
              **dict.fromkeys(("spin_x", "spin_y", "spin_z"), "spin after")}
NUMBERED = r"\b([Ss]phere|[Bb]ody|[Dd]isc|[Rr]attler) \d+"
LISTED = 3  # requirements named for each scene, before "and others"


def scene_of(path):
    """The tables of a scene and, of one that must be refused, the first sentence of its head, else None."""
    text = path.read_text(encoding="utf-8")
    head, refused, _ = text.partition("\n# refused: ")
    sentence = re.split(r"(?<=[a-z])\. ", " ".join(line.lstrip("# ") for line in head.splitlines()))[0]
    return tomllib.loads(text), sentence.rstrip(".") if refused else None


def requirements(scene):
    """What is required, without bodies, cases and components: first what most conditions require."""
    counts = {}
    for condition in scene.get("expect", []):
        stem = condition["requirement"].rsplit(": ", 1)[-1]
        stem = re.sub(r"^body \d+, [a-z]$", "orientation", stem)
        stem = re.sub(r", (x|y|z|first|second)$", "", stem)
        if len(re.findall(NUMBERED, stem)) == 1:
            stem = re.sub(NUMBERED, lambda found: "each " + found[1].lower(), stem)
        stem = COMPONENTS.get(stem, stem[0].lower() + stem[1:] if stem[1:2].islower() else stem)
        counts[stem] = counts.get(stem, 0) + 1
    named = sorted(counts, key=lambda stem: -counts[stem])[:LISTED]
    return "; ".join(named + ["and others"] * (len(counts) > LISTED))


def described(name, scene, refusal):
    """The columns that the file alone decides."""
    conditions = len(scene.get("expect", []))
    return [f"[{name}]({name}.toml)", scene["scene"]["title"], refusal or requirements(scene), str(conditions or "")]


def nearest(conditions):
    """The largest share and the requirement of its condition: among references, else among bounds."""
    references = [c for c in conditions if "reference" in c]
    shares = [(s, c["requirement"]) for c in references or conditions if (s := share(c)) is not None]
    if not shares:
        return ["exact" if references else "", ""]
    largest, requirement = max(shares)
    return [f"{largest:.1g}" if largest < 0.01 else f"{largest:.2f}", requirement]


def measured(path, program):
    """Runs a scene; the columns that its record decides. Ends the script if it fails or misses one."""
    with tempfile.TemporaryDirectory() as folder:
        return nearest(run(path, out=f"{folder}/run", program=program).expectations)


def row_of(path, program):
    """The row of a scene, without the measured columns if there is no program."""
    scene, refusal = scene_of(path)
    cells = described(path.stem, scene, refusal)
    if program:
        cells += ["", ""] if refusal else measured(path, program)
    return table_row(cells)


def main(folder, program=None):
    folder = pathlib.Path(folder)
    section = Section(folder / "README.md", BEGIN, END)
    rows = [row_of(path, program) for path in sorted(folder.glob("*.toml"), key=lambda path: path.stem)]
    if program:
        return section.write(HEAD + "\n".join(rows))
    lines = [line for line in section.text.splitlines() if line.startswith("| [")]
    stale = [row for row in rows if not any(line.startswith(row) for line in lines)]
    if stale or len(lines) != len(rows):
        scene = re.match(r"\| \[([^]]*)", (stale or lines)[0])[1]
        raise Error(f"{section.page} does not say what the scenes require (scene {scene}); renew it: see the line"
                    " above its table")
    return None


if __name__ == "__main__":
    start()
    main(*arguments(__doc__, 1, 2))
