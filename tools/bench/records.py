"""Tables of measured rows, one per processor, and the page that shows them all."""
import csv
import os
import pathlib
import re
import subprocess

BENCH = pathlib.Path(__file__).resolve().parent
RESULTS = BENCH / "results"
TOLERATED = 1.05  # of the time in the last record


def machine():
    """Title and file name of the processor: model, widest vectors, cores."""
    info = dict(re.findall(r"^([\w ]+?)\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M))
    model, flags = info.get("model name", "processor"), info.get("flags", "").split()
    model = re.sub(r"\((R|TM)\)", "", model)
    vectors = next((v for v, flag in (("AVX-512", "avx512f"), ("AVX2", "avx2"), ("SSE2", "sse2")) if flag in flags), "")
    kind = f"family {info.get('cpu family', '?')} model {info.get('model', '?')}"
    title = f"{model}, {kind}, {vectors}, {os.cpu_count()} cores"
    return {"title": title, "file": re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")}


def version():
    done = subprocess.run(["git", "-C", BENCH, "rev-parse", "--short", "HEAD"], capture_output=True, text=True)
    return done.stdout.strip()


def table_of(file):
    """Rows by scene and what it is compared with."""
    if not file.exists():
        return {}
    with open(file) as lines:
        return {(row["scene"], row["against"]): row for row in csv.DictReader(lines)}


def of_this_machine():
    return table_of(RESULTS / f"{machine()['file']}.csv")


def slower(scene, against, ms):
    """A note if a row takes longer than in the last record of this processor."""
    before = of_this_machine().get((scene, against))
    if not before or float(ms) <= TOLERATED * float(before["scree_ms"]):
        return []
    share = 100 * (float(ms) / float(before["scree_ms"]) - 1)
    return [f"SLOWER by {share:.0f} % than {before['scree_ms']} ms in the record of {before['date']} ({before['version']})"]


def write(known):
    RESULTS.mkdir(exist_ok=True)
    file = RESULTS / f"{machine()['file']}.csv"
    with open(file, "w", newline="") as out:
        table = csv.DictWriter(out, list(max(known.values(), key=len)), lineterminator="\n")
        table.writeheader()
        table.writerows(known.values())
    write_page()
    return file


def section(rows):
    lines = [f"## {rows[0]['machine']}", "",
             "| scene | against | other, ms/step | scree, ms/step | ratio | lowest to highest | aim | met | date | commit |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    for r in rows:
        spread = f"{r['lowest_ratio']} to {r['highest_ratio']}" if r["lowest_ratio"] else "–"
        lines.append(f"| {r['scene']} | {r['against']} | {r['peer_ms'] or '–'} | {r['scree_ms']} | {r['ratio'] or '–'} | {spread} "
                     f"| {r['wanted']} | {r['met']} | {r['date']} | {r['version']} |")
    notes = [f"- {r['scene']}: {r['notes']}" for r in rows if r["notes"]]
    return lines + ["", *notes, ""]


def write_page():
    """results/README.md: a table for each processor."""
    lines = ["# Measured rows", "",
             "`tools/bench/peers --record` measures the rows on a machine and writes this page; what they compare is on",
             "[the page before](../README.md). ratio: time of the other code over the time of scree, median of the repeats.", ""]
    for file in sorted(RESULTS.glob("*-cores.csv")):
        rows = list(table_of(file).values())
        lines += section(rows)
    (RESULTS / "README.md").write_text("\n".join(lines))
