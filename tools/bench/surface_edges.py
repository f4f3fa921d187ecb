"""What scree and LIGGGHTS do wrong where triangles meet: the second table of tools/bench/surfaces."""
import math
import re

import surface_files as files

FLOOR_STEPS, FACET_STEPS, EVERY = 10_000, 60_000, 10
FLOOR_SPEED, DRUM_SPEED = 0.5, 1.0
FACETS = 120
BENDS = (5, 0.25)  # degrees, `curvature` of LIGGGHTS: facets bend by 3; its default
DRUM_INSIDE = files.DRUM * math.cos(math.pi / FACETS)  # m, from the axis to the middle of a facet
LINE = "| {:<76} | {:<22} | {:<36} |"

# --- motion of spheres: {(step, id): position, velocity and spin} ------------------------------------------------------


def of_scree(codes, name, wall, steps, friction, restitution, down):
    head = files.from_file("drum-cylinder", name).split("[[boundary]]")[0]
    head = re.sub("(friction =) .*", rf"\1 {friction}", re.sub("(restitution =) .*", rf"\1 {restitution}", head))
    ids = list(range(1, len(files.table(codes.work / f"{name}.csv")) + 1))
    scene = codes.work / "edges.toml"
    scene.write_text(f'{head}[[boundary]]\n{wall}\n[[body_force]]\nplugin = "gravity"\nacceleration = {down}\n'
                     f'[[probe]]\nplugin = "particles"\nids = {ids}\nevery = {EVERY * files.STEP}\n')
    codes.scree_run(scene, steps * files.STEP)
    return {(round(float(row["time"]) / files.STEP), k): [float(row[f"{q}_{k}"]) for q in files.QUANTITIES]
            for row in files.table(codes.work / "run/series/particles.csv") for k in ids}


def of_liggghts(codes, name, walls, steps, friction, restitution, down):
    files.run_liggghts(codes, name, walls, steps, down, skin=0.002, friction=friction, restitution=restitution,
                       every=EVERY)
    motion = {}
    for frame in (codes.work / "series").read_text().split("ITEM: TIMESTEP\n")[1:]:
        step, bodies = int(frame.split("\n", 1)[0]), frame.split("ITEM: ATOMS", 1)[1].splitlines()[1:]
        motion.update({(step, int(line.split()[0])): list(map(float, line.split()[1:])) for line in bodies})
    return motion


# --- the cases --------------------------------------------------------------------------------------------------------


def largest_difference(motion, exact):
    """Of positions over the radius, velocities over the first speed, spins over speed / radius."""
    if motion.keys() != exact.keys():
        return "a sphere is lost"
    scales = (files.RADIUS, FLOOR_SPEED, FLOOR_SPEED / files.RADIUS)
    parts = [slice(3 * q, 3 * q + 3) for q in range(3)]
    return ", ".join(f"{max(math.dist(motion[k][part], exact[k][part]) for k in exact) / scale:.0e}"
                     for part, scale in zip(parts, scales))


def energy_change(motion):
    """Largest relative change of the kinetic energy of spheres that touch no facet."""
    first, largest, width = {}, 0.0, 2 * math.pi / FACETS
    for (_, k), (x, y, _, *v) in sorted(motion.items()):
        angle = math.atan2(y, x) % width - width / 2
        if math.hypot(x, y) * math.cos(angle) + files.RADIUS < DRUM_INSIDE - 1e-9:
            energy = math.hypot(*v[:3]) ** 2 + 0.4 * (files.RADIUS * math.hypot(*v[3:])) ** 2
            largest = max(largest, abs(energy / first.setdefault(k, energy) - 1))
    return f"{largest:.0e}"


def spheres_on_floor():
    """On a diagonal: half begin on the floor without spin, half fall on vertices and edges of the grid of 10 mm."""
    heading = 0.3 - math.pi / 4 + 0.2
    v = [FLOOR_SPEED * math.cos(heading), FLOOR_SPEED * math.sin(heading)]
    fall = (math.sqrt(0.5**2 + 2 * 9.81 * files.RADIUS) - 0.5) / 9.81  # s to fall by a radius
    for k in range(16):
        d = 0.015 * (k - 8)
        x, y, _ = files.on_floor(d, d)
        if k % 4 > 1:
            yield (x, y, files.RADIUS, *v, 0.0, 0.0, 0.0, 0.0)
        else:
            yield (x - v[0] * fall, y - v[1] * fall, 2 * files.RADIUS, *v, -0.5, 4.0, -2.0, 6.0)


def floors(codes):
    files.write_bodies(codes.work, "floor", list(spheres_on_floor()))
    common = (FLOOR_STEPS, 0.5, 0.6, [0, 0, -9.81])
    ours = lambda wall: of_scree(codes, "floor", wall, *common)
    theirs = lambda walls: of_liggghts(codes, "floor", walls, *common)
    plane = ours('plugin = "plane"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]')
    their_plane = theirs(f"{files.GRAN} primitive type 1 zplane 0\n")
    cases = {"2 triangles": files.floor(1, 1), "grid of 10 mm": files.floor(46, 46),
             "grid of 2.5 mm, vertices displaced": files.floor(184, 184, displaced=0.2),
             "slivers of 460 mm × 5 mm": files.floor(92, 1)}
    for case, triangles in cases.items():
        files.write_stl(codes.work / "floor.stl", triangles)
        found = largest_difference(ours('plugin = "mesh"\nfile = "floor.stl"'), plane)
        their_found = largest_difference(theirs(files.meshes(codes.work, ["floor"], BENDS[1])), their_plane)
        print(LINE.format(f"floor, {case}: position, velocity, spin", found, their_found), flush=True)


def facets(codes):
    bodies = []
    for k in range(6):
        angle, along = 0.3 * k, 0.02 * k
        around = math.sqrt(DRUM_SPEED**2 - along**2)
        c, s = math.cos(angle), math.sin(angle)
        bodies.append((0.24 * c, 0.24 * s, 0.02 + 0.012 * k, -around * s, around * c, along, 0.0, 0.0, 0.0))
    files.write_bodies(codes.work, "facets", bodies)
    files.write_stl(codes.work / "facets.stl", files.mantle(FACETS, 24))
    common = (FACET_STEPS, 0, 1, [0, 0, 0])
    ours = energy_change(of_scree(codes, "facets", 'plugin = "mesh"\nfile = "facets.stl"', *common))
    walls = {bend: files.meshes(codes.work, ["facets"], bend) for bend in BENDS}
    theirs = [f"{energy_change(of_liggghts(codes, 'facets', walls[bend], *common))} ({bend}°)" for bend in BENDS]
    print(LINE.format(f"drum of {FACETS} facets: kinetic energy", ours, ", ".join(theirs)), flush=True)


def print_table(codes):
    print(LINE.format("error at edges", "scree", "LIGGGHTS (curvature)"))
    print(LINE.format("-" * 76, "-" * 22, "-" * 36), flush=True)
    floors(codes)
    facets(codes)
