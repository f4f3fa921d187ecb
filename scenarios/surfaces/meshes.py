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


if __name__ == "__main__":
    write("cube.stl", box(25, 10))
    write("chute.stl", chute(1000, 250, 500))
    write("drum.stl", drum(60, 60, 180))
