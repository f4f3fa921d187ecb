"""Packings of tools/bench as bodies (x, y, z, radius), and their comparison."""
import csv
import itertools
import math
import pathlib

SCENES = pathlib.Path(__file__).resolve().parent / "scenes"


def bead_file(repeat):
    """Bodies of pack4096.txt, repeated in x and z, and the size of the box."""
    lines = (SCENES / "pack4096.txt").read_text().splitlines()
    _, length, height = (float(v) for v in lines[0].split())
    beads = [tuple(map(float, line.split())) for line in lines[1:] if line]
    bodies = [(x + a * length, y, z + b * length, r) for a in range(repeat) for b in range(repeat) for x, y, z, r in beads]
    return bodies, (length * repeat, height, length * repeat)


def csv_file(path):
    """Bodies of a scree packing, sorted by id."""
    with open(path) as lines:
        table = csv.DictReader(line for line in lines if not line.startswith("#"))
        rows = sorted(table, key=lambda row: int(row["id"]))
    column = {name.split(" ")[0]: name for name in rows[0]}
    return [tuple(float(row[column[name]]) for name in ("x", "y", "z", "radius")) for row in rows]


def dump_file(path):
    """Bodies of the last frame of a LAMMPS or LIGGGHTS dump of id, x, y, z and radius, sorted by id."""
    lines = pathlib.Path(path).read_text().splitlines()
    start = max(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS")) + 1
    rows = sorted((line.split() for line in lines[start:]), key=lambda row: int(row[0]))
    return [tuple(map(float, row[1:5])) for row in rows]


def write_data(path, bodies, density, bounds):
    """Writes a data file for LIGGGHTS; bounds: (low, high) of each axis."""
    with open(path, "w") as out:
        out.write(f"packing\n\n{len(bodies)} atoms\n1 atom types\n\n")
        out.writelines(f"{low:.17g} {high:.17g} {axis}lo {axis}hi\n" for axis, (low, high) in zip("xyz", bounds))
        out.write("\nAtoms\n\n")
        out.writelines(f"{k} 1 {2 * r:.17g} {density} {x:.17g} {y:.17g} {z:.17g}\n" for k, (x, y, z, r) in enumerate(bodies, 1))


def nearest(distance, period):
    return distance - period * round(distance / period) if period else distance


def overlaps(bodies, periods):
    """Overlaps of all touching pairs; period 0: not periodic."""
    width = 2 * max(body[3] for body in bodies)
    counts = [max(1, math.floor(period / width)) if period else 0 for period in periods]
    widths = [period / count if count else width for period, count in zip(periods, counts)]

    def wrapped(cell):
        return tuple(c % count if count else c for c, count in zip(cell, counts))

    cells = {}
    for k, body in enumerate(bodies):
        cells.setdefault(wrapped(math.floor(x / w) for x, w in zip(body, widths)), []).append(k)
    found = []
    for cell, members in cells.items():
        around = {wrapped(c + d for c, d in zip(cell, step)) for step in itertools.product((-1, 0, 1), repeat=3)}
        for i in members:
            for j in itertools.chain.from_iterable(cells.get(c, ()) for c in around):
                if j <= i:
                    continue
                square = sum(nearest(a - b, p) ** 2 for a, b, p in zip(bodies[i], bodies[j], periods))
                reach = bodies[i][3] + bodies[j][3]
                if square < reach * reach:
                    found.append(reach - math.sqrt(square))
    return found


def difference(a, b, periods):
    """Root mean square distance between the bodies of two packings."""
    total = sum(nearest(p - q, period) ** 2 for one, other in zip(a, b) for p, q, period in zip(one, other, periods))
    return math.sqrt(total / len(a))
