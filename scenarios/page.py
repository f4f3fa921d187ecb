"""Writes the table of scenes in the README.md of a folder of tests: what each requires, and how near it comes to its bound.

Usage: python3 scenarios/page.py FOLDER PROGRAM    # scenarios/verification build/release/bin/scree
       python3 scenarios/page.py FOLDER            # only compares the page with the scenes; status 1 if they differ
"""
import os
import re
import sys
import tempfile
import tomllib

from tables import arguments, refuse, scree

BEGIN = "<!-- Written by scenarios/page.py; to renew it: python3 scenarios/page.py {} build/release/bin/scree -->"
END = "<!-- end -->"
HEAD = "| scene | title | required | conditions | share | of the condition |\n|---|---|---|---|---|---|\n"
COMPONENTS = {**dict.fromkeys(("vx", "vy", "vz"), "velocity after"),
              **dict.fromkeys(("spin_x", "spin_y", "spin_z"), "spin after")}
NUMBERED = r"\b([Ss]phere|[Bb]ody|[Dd]isc|[Rr]attler) \d+"
LISTED = 3  # requirements named for each scene, before "and others"


def scene_of(path):
    """The tables of a scene and, of one that must be refused, the first sentence of its head, else None."""
    with open(path, "rb") as file:
        scene = tomllib.load(file)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if not re.search("^# refused: ", text, re.MULTILINE):
        return scene, None
    head = " ".join(line.lstrip("# ") for line in text.split("\n# refused: ")[0].splitlines())
    return scene, re.split(r"(?<=[a-z])\. ", head)[0].rstrip(".")


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


def share(condition):
    """Deviation over tolerance; of a bound, the value over it where both are above 0; else None."""
    value = condition["value"]
    if condition.get("tolerance"):
        return abs(value - condition["reference"]) / condition["tolerance"]
    if condition.get("at_most", 0) > 0 and value >= 0:
        return value / condition["at_most"]
    return None


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
        return nearest(scree.run(path, out=os.path.join(folder, "run"), program=program).expectations)


def main():
    given = arguments(__doc__, 1, 2)
    folder, program = given[0].rstrip("/"), given[1] if len(given) > 1 else None
    page = os.path.join(folder, "README.md")
    with open(page, encoding="utf-8") as file:
        text = file.read()
    begin = BEGIN.format("scenarios/" + os.path.basename(os.path.abspath(folder)))
    if text.count(begin) != 1 or END not in text.split(begin)[1]:
        refuse(f"{page}: the lines '{begin}' and '{END}' are not there; give a folder whose page has them")
    before, rest = text.split(begin)
    written, after = rest.split(END)

    rows = []
    for name in sorted(n[:-5] for n in os.listdir(folder) if n.endswith(".toml")):
        path = os.path.join(folder, name + ".toml")
        scene, refusal = scene_of(path)
        row = described(name, scene, refusal)
        if program:
            row += ["", ""] if refusal else measured(path, program)
        rows.append("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |")
    if program:
        with open(page, "w", encoding="utf-8") as file:
            file.write(before + begin + "\n\n" + HEAD + "\n".join(rows) + "\n\n" + END + after)
        return
    lines = [line for line in written.splitlines() if line.startswith("| [")]
    stale = [row for row in rows if not any(line.startswith(row) for line in lines)]
    if stale or len(lines) != len(rows):
        scene = re.match(r"\| \[([^]]*)", (stale or lines)[0])[1]
        refuse(f"{page} does not say what the scenes require (scene {scene}); renew it: see the line above its table")


if __name__ == "__main__":
    main()
