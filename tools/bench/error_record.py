"""Writes the results of `tools/bench/peers --error` to tools/bench/results: two tables of this machine and a chart."""
import csv
import datetime
import pathlib
import subprocess
import sys

BENCH = pathlib.Path(__file__).resolve().parent
FIELDS = {
    "error": ["case", "error", "scree_steps", "liggghts_steps", "lammps_steps", "liggghts_step_ratio",
              "lammps_step_ratio", "scree_time", "unit", "liggghts_time", "lammps_time", "liggghts_time_ratio",
              "lammps_time_ratio", "date", "version"],
    "error-ladder": ["case", "title", "of", "unit", "code", "steps", "time", "value", "resolved", "reference_good_to",
                     "converges_to", "date", "version"],
}


def keep(kind, machine, lines, order):
    """Replaces the lines of the measured cases in the table of this machine."""
    file = BENCH / "results" / f"{machine['file']}-{kind}.csv"
    file.parent.mkdir(exist_ok=True)
    known = []
    if file.exists():
        with open(file) as old:
            known = [row for row in csv.DictReader(old) if row["case"] not in {line[0] for line in lines}]
    known += [dict(zip(FIELDS[kind], line)) for line in lines]
    known.sort(key=lambda row: order.index(row["case"]) if row["case"] in order else len(order))
    with open(file, "w", newline="") as out:
        table = csv.DictWriter(out, FIELDS[kind], lineterminator="\n", extrasaction="ignore")
        table.writeheader()
        table.writerows(known)
    return file


def record(summary, ladder, machine, version, order):
    """Writes all files and returns their names; order: names of all cases."""
    stamp = [datetime.date.today().isoformat(), version]
    files = [keep(kind, machine, [line + stamp for line in lines], order)
             for kind, lines in (("error", summary), ("error-ladder", ladder))]
    return files + draw(files, machine)


def draw(files, machine):
    """Draws the chart with a Python that has matplotlib: the Debian package is for the Python of Debian."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import matplotlib"], capture_output=True).returncode == 0:
            chart = BENCH / "results" / "error-against-time.png"
            subprocess.run([python, "-B", BENCH / "error_chart.py", *files, chart, machine["title"]], check=True)
            return [chart]
    print("peers: no chart without matplotlib; apt install python3-matplotlib")
    return []
