"""Triangles, bodies and walls of tools/bench/surfaces in the forms that scree and LIGGGHTS read."""
import csv
import math
import random
import re
import struct

import packings

DRUM, LENGTH, RADIUS, STEP = 0.25, 0.3, 0.005, 2e-5  # of scenes/drum-*.toml
QUANTITIES = ("x", "y", "z", "vx", "vy", "vz", "spin_x", "spin_y", "spin_z")
GRAN = "fix w all wall/gran model hertz tangential history"

# --- triangles --------------------------------------------------------------------------------------------------------


def mantle(around, along):
    def point(i, j):
        angle = 2 * math.pi * (i % around) / around
        return DRUM * math.cos(angle), DRUM * math.sin(angle), LENGTH * j / along

    return two_for_each([[point(i, j) for j in range(along + 1)] for i in range(around + 1)])


def caps():
    """Hexagons around the ends of the drum, for LIGGGHTS, whose flat walls cannot turn."""
    corners = [(1.17 * DRUM * math.cos(k * math.pi / 3), 1.17 * DRUM * math.sin(k * math.pi / 3)) for k in range(7)]
    return {name: [((0, 0, z), (*a, z), (*b, z)) for a, b in zip(corners, corners[1:])]
            for name, z in (("low", 0), ("high", LENGTH))}


def on_floor(x, y, turned=0.3):
    """A point of floors, which are turned (rad) so that their vertices are no round numbers."""
    return x * math.cos(turned) - y * math.sin(turned), x * math.sin(turned) + y * math.cos(turned), 0.0


def floor(nx, ny, side=0.46, displaced=0.0):
    """A square at z = 0; displaced: of inner vertices, at most, over the distance of two."""
    chance = random.Random(1)

    def point(i, j):
        apart = displaced if 0 < i < nx and 0 < j < ny else 0
        return on_floor(*(side * ((k + apart * chance.uniform(-1, 1)) / n - 0.5) for k, n in ((i, nx), (j, ny))))

    return two_for_each([[point(i, j) for j in range(ny + 1)] for i in range(nx + 1)])


def two_for_each(rows):
    for left, right in zip(rows, rows[1:]):
        for a, b, c, d in zip(left, right, right[1:], left[1:]):
            yield from ((a, b, c), (a, c, d))


def write_stl(path, triangles, text=True):
    """Binary for scree; text with the same float vertices for LIGGGHTS, which stops at small binary files."""
    facets = [struct.pack("<12fH", 0, 0, 0, *(c for point in facet for c in point), 0) for facet in triangles]
    path.write_bytes(bytes(80) + struct.pack("<I", len(facets)) + b"".join(facets))
    if not text:
        return
    with open(path.with_suffix(".txt.stl"), "w") as out:
        out.write("solid mesh\n")
        for facet in facets:
            v = struct.unpack("<12fH", facet)[3:12]
            lines = "".join("vertex %.9g %.9g %.9g\n" % v[k:k + 3] for k in (0, 3, 6))
            out.write(f"facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
        out.write("endsolid mesh\n")


# --- bodies -----------------------------------------------------------------------------------------------------------


def write_bodies(work, name, bodies):
    """CSV for scree and data file for LIGGGHTS of bodies with position, velocity and spin."""
    lines = [f"id,radius,{','.join(QUANTITIES)}"]
    lines += [f"{k},{RADIUS},{','.join(map(repr, b))}" for k, b in enumerate(bodies, 1)]
    (work / f"{name}.csv").write_text("\n".join(lines) + "\n")
    reach = ((-0.3, 0.3), (-0.3, 0.3), (-0.01, LENGTH + 0.01))
    packings.write_data(work / f"{name}.data", [(*b[:3], RADIUS) for b in bodies], 2500, reach)
    with open(work / f"{name}.data", "a") as out:
        out.write("\nVelocities\n\n")
        out.writelines(f"{k} {' '.join(map(repr, b[3:]))}\n" for k, b in enumerate(bodies, 1))


def table(path):
    """Rows of a table of scree, without units."""
    with open(path) as lines:
        return [{key.split(" ")[0]: value for key, value in row.items()}
                for row in csv.DictReader(line for line in lines if not line.startswith("#"))]


def from_file(scene, name):
    """Text of a scene of scenes/, whose bodies come from a CSV instead."""
    text = (packings.SCENES / f"{scene}.toml").read_text()
    return re.sub(r"^random = .*\nregion = .*\nradius = .*$", f'file = "{name}.csv"', text, flags=re.M)


# --- walls of LIGGGHTS ------------------------------------------------------------------------------------------------


def meshes(work, names, curvature, motion="", turns=""):
    """Fixes for meshes; curvature: degrees by which a surface may bend; turns: a fix for each mesh, {0}."""
    lines = [f"fix {name} all mesh/surface file {work / name}.txt.stl type 1 curvature {curvature} {motion}\n"
             f"{turns.format(name)}" for name in names]
    return "".join(lines) + f"{GRAN} mesh n_meshes {len(names)} meshes {' '.join(names)}\n"


def run_liggghts(codes, name, walls, steps, down, **variables):
    """Log of a run of bodies of a file; down: gravity."""
    (codes.work / "walls").write_text(walls)
    direction = " ".join(map(str, down)) if any(down) else "0 0 -1"
    variables = {"warm": 0, "every": 10**9, "series": codes.work / "series", **variables}
    return codes.liggghts("surfaces.liggghts", steps, data=codes.work / f"{name}.data", walls=codes.work / "walls",
                          g=math.hypot(*down), down=direction, **variables)
