#!/usr/bin/env python3
"""Writes the meshes of these scenes as binary STL files beside itself: python3 meshes.py

Where a surface is flat, coordinates are whole numbers of half millimetres (scale = 0.001 in the scene): STL
has single precision, and so each face is flat to the last bit.
"""
import math
import pathlib
import struct


def write(name, triangles):
    """A binary STL; normals follow from the order of the corners."""
    path = pathlib.Path(__file__).resolve().parent / name
    with open(path, "wb") as file:
        file.write(b"scree".ljust(80, b"\0") + struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            length = math.sqrt(sum(x * x for x in n)) or 1.0
            file.write(struct.pack("<12fH", *(x / length for x in n), *a, *b, *c, 0))
    print(f"{name}: {len(triangles)} triangles, {path.stat().st_size} bytes")


def quad(a, b, c, d):
    return [(a, b, c), (a, c, d)]


def box(half, n):
    """A cube about the origin with n x n squares on each face, seen from outside."""
    at = [-half + 2 * half * k / n for k in range(n + 1)]
    triangles = []
    for axis in range(3):
        for side in (-half, half):
            def corner(u, v):
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, u, v
                return tuple(point)
            for i in range(n):
                for j in range(n):
                    u, v = (at[i], at[i + 1]), (at[j], at[j + 1])
                    q = [corner(u[0], v[0]), corner(u[1], v[0]), corner(u[1], v[1]), corner(u[0], v[1])]
                    triangles += quad(*(q if side > 0 else q[::-1]))
    return triangles


def chute(length, width, slivers):
    """A slope of 3 in 4, of slivers that run down all of it; length is a multiple of 5."""
    drop, run = 3 * length / 5, 4 * length / 5
    ys = [-width / 2 + width * k / slivers for k in range(slivers + 1)]
    triangles = []
    for low, high in zip(ys, ys[1:]):
        triangles += quad((0, low, 0), (run, low, -drop), (run, high, -drop), (0, high, 0))
    return triangles


def drum(radius, length, sides):
    """The inside of a cylinder about the y axis, with corners on it."""
    turn = 2 * math.pi / sides
    ring = [(radius * math.cos(turn * k), radius * math.sin(turn * k)) for k in range(sides)]
    triangles = []
    for (x0, z0), (x1, z1) in zip(ring, ring[1:] + ring[:1]):
        triangles += quad((x0, -length / 2, z0), (x1, -length / 2, z1),
                          (x1, length / 2, z1), (x0, length / 2, z0))
    return triangles


def turn_of(a, b, c):
    """Above 0 where the way from a over b to c turns to the left: twice the area of the triangle, from above."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def cross(a, b, c, d):
    """Whether the segments ab and cd have a point in common that is no end of both."""
    if {a, b} & {c, d}:
        return False
    return turn_of(a, b, c) * turn_of(a, b, d) <= 0 and turn_of(c, d, a) * turn_of(c, d, b) <= 0


def in_corner(border, i, q):
    """Whether the way from a corner of a polygon to q begins inside; a cut passes its ends twice, once on each side."""
    before, p, after = border[i - 1], border[i], border[(i + 1) % len(border)]
    if turn_of(before, p, after) > 0:
        return turn_of(p, q, before) > 0 > turn_of(p, q, after)
    return turn_of(p, q, before) > 0 or turn_of(p, q, after) < 0


def with_hole(border, hole, others):
    """The border of a polygon with a cut to a hole and round it: the shortest that meets no edge of it or of others."""
    edges = [edge for ring in (border, hole, *others) for edge in zip(ring, ring[1:] + ring[:1])]
    cuts = sorted((math.dist(p, q), i, j) for i, p in enumerate(border) for j, q in enumerate(hole))
    i, j = next((i, j) for _, i, j in cuts if in_corner(border, i, hole[j])
                and not any(cross(border[i], hole[j], *edge) for edge in edges))
    return border[: i + 1] + hole[j:] + hole[: j + 1] + border[i:]


def filled(border):
    """Triangles of a polygon that lies to the left of its border, by cutting off one corner after the other."""
    triangles, ring = [], list(border)
    while len(ring) > 3:
        def is_ear(k):
            a, b, c = corners = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
            return turn_of(a, b, c) > 0 and not any(
                p not in corners and min(turn_of(a, b, p), turn_of(b, c, p), turn_of(c, a, p)) >= 0 for p in ring)
        # The ear with the shortest cut, so that triangles stay compact.
        k = next(filter(is_ear, sorted(range(len(ring)), key=lambda k: math.dist(ring[k - 1], ring[(k + 1) % len(ring)]))))
        triangles.append((ring[k - 1], ring[k], ring[(k + 1) % len(ring)]))
        del ring[k]
    return [*triangles, tuple(ring)]


def plate_with_holes(length, width, holes, sides):
    """A rectangle about the origin in the plane z = 0, seen from above. holes: (x, y, radius) of each, apart from each
    other and from the border; corners of a hole, of which there are `sides`, lie on its circle."""
    for k, (x, y, radius) in enumerate(holes):
        if abs(x) + radius >= length / 2 or abs(y) + radius >= width / 2:
            raise ValueError(f"hole {k + 1} reaches the border of the plate; move it, or make it smaller")
        for other in range(k):
            if math.dist((x, y), holes[other][:2]) <= radius + holes[other][2]:
                raise ValueError(f"holes {other + 1} and {k + 1} overlap; move one of them, or make it smaller")
    rings = [[(x + r * math.cos(-2 * math.pi * k / sides), y + r * math.sin(-2 * math.pi * k / sides))
              for k in range(sides)] for x, y, r in holes]
    border = [(-length / 2, -width / 2), (length / 2, -width / 2), (length / 2, width / 2), (-length / 2, width / 2)]
    rings.sort(key=max, reverse=True)  # from the right: each sees the border, since no later hole is to its right
    for k, ring in enumerate(rings):
        border = with_hole(border, ring, rings[k + 1:])
    return [tuple((x, y, 0.0) for x, y in triangle) for triangle in filled(border)]


if __name__ == "__main__":
    write("cube.stl", box(25, 10))
    write("chute.stl", chute(1000, 250, 500))
    write("drum.stl", drum(60, 60, 180))
    places = (-24, -14.5, -5, 5, 14.5, 24)
    write("sieve.stl", plate_with_holes(60, 60, [(x, y, 3) for x in places for y in places], 24))
