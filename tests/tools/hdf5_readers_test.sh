#!/bin/sh
# h5py finds every dataset that `scree describe STATE` lists, and trajectory.h5md as H5MD 1.1 asks for it; MDAnalysis reads the
# trajectory. Status 77 where h5py is not installed (Debian: python3-h5py; python3-mdanalysis).
# Usage: hdf5_readers_test.sh PROGRAM
set -eu
program=$1
/usr/bin/python3 -c 'import h5py' 2> /dev/null || { echo "h5py is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat > box.toml <<'TEXT'
time = { step = { fraction = 0.05 }, duration = 0.03 }
particles = { lattice = { kind = "simple_cubic", count = [11, 10, 10] }, radius = { distribution = "uniform", minimum = 0.002, maximum = 0.003 }, random_velocity = 0.3 }
material = [{ name = "glass", density = 2500 }]
contact = [{ plugin = "linear_spring_dashpot", normal_stiffness = 5000, restitution = 0.7, tangential_stiffness = 1400, static_friction = 0.3 }]
boundary = [{ plugin = "box", gap = 0.002, x = "fixed", y = "fixed", z = "fixed" }]
snapshot = { every = 0.01, h5md = true }
TEXT
sed 's/^boundary.*/boundary = [{ plugin = "periodic", axes = "xyz", lower = [0, 0, 0], upper = [0.066, 0.06, 0.06] }]/' box.toml > periodic.toml
for scene in box periodic; do
  "$program" run $scene.toml --out $scene --quiet > run.log 2>&1 || { cat run.log; exit 1; }
  "$program" describe $scene/final_state.h5 > $scene.arrays
  "$program" export $scene --format csv --out $scene.csv > export.log
done

cat > read.py <<'TEXT'
import csv
import re
import sys
import warnings

import h5py
import numpy as np

warnings.simplefilter("ignore")
try:
    import MDAnalysis
except ImportError:
    MDAnalysis = None


def check_state(name):
    with h5py.File(f"{name}/final_state.h5") as file, open(f"{name}.arrays") as arrays:
        listed = [m for m in (re.match(r"  (\S+) +\w+  (single|[0-9]+(?: x [0-9]+)*) .* bytes", line) for line in arrays) if m]
        assert len(listed) > 100
        for line in listed:
            shape = () if line[2] == "single" else tuple(map(int, line[2].split(" x ")))
            assert file[line[1]].shape == shape, line[1]


def table(name):
    with open(f"{name}.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if key != "material"}


def check_trajectory(name, periodic):
    with h5py.File(f"{name}/trajectory.h5md") as file:
        assert list(file["h5md"].attrs["version"]) == [1, 1]
        assert "name" in file["h5md/author"].attrs
        assert {"name", "version"} <= set(file["h5md/creator"].attrs)
        group = file["particles/all"]
        box = group["box"]
        assert box.attrs["dimension"] == 3
        assert [b.decode() for b in box.attrs["boundary"]] == ["periodic" if periodic else "none"] * 3
        last = table(name)
        position = group["position"]
        frames = position["value"].shape[0]
        assert frames == 4 and position["value"].shape[1:] == (1100, 3)
        assert position["step"].shape == position["time"].shape == (frames,)
        assert position["time"].attrs["unit"] == "s" and group["velocity/value"].attrs["unit"] == "m s-1"
        moving = [group[key] for key in ("velocity", "spin")] + ([box["edges"], group["image"]] if periodic else [])
        for element in moving:  # the same times, once in the file
            assert element["step"] == position["step"] and element["time"] == position["time"]
            assert element["value"].shape[0] == frames
        assert np.all(np.diff(position["time"]) > 0) and abs(position["time"][1] - 0.01) < 1e-5
        for axis, x in enumerate("xyz"):
            assert np.array_equal(position["value"][-1, :, axis], last[f"{x} [m]"])
            assert np.array_equal(group["velocity/value"][-1, :, axis], last[f"v{x} [m/s]"])
        for key, column in (("id", "id"), ("mass", "mass [kg]"), ("radius", "radius [m]")):
            assert np.array_equal(group[key][()], last[column])
        assert set(group["species"][()]) == {0}
        if periodic:
            edges = box["edges/value"][()]
            assert edges.shape == (frames, 3, 3) and np.all(edges[:, [0, 1, 2], [0, 1, 2]] > 0)
            # Unwrapped, no body moves farther in a frame than its speed, below 3 m/s, allows.
            unwrapped = position["value"][()] + group["image/value"][()] * edges[:, None, [0, 1, 2], [0, 1, 2]]
            assert np.abs(np.diff(unwrapped, axis=0)).max() < 0.03
            assert np.abs(group["image/value"][()]).max() > 0
        return position["value"][()], position["time"][()]


def check_mdanalysis(name, positions, times, periodic):
    universe = MDAnalysis.Universe.empty(positions.shape[1], trajectory=False)
    universe.load_new(f"{name}/trajectory.h5md", convert_units=False)
    assert len(universe.trajectory) == len(times)
    for k, frame in enumerate(universe.trajectory):
        assert frame.time == times[k]
        assert np.array_equal(frame.positions, positions[k].astype(np.float32))
        assert (frame.dimensions is not None) == periodic


for name, periodic in (("box", False), ("periodic", True)):
    check_state(name)
    positions, times = check_trajectory(name, periodic)
    if MDAnalysis:
        check_mdanalysis(name, positions, times, periodic)
print("with MDAnalysis" if MDAnalysis else "without MDAnalysis")
TEXT
/usr/bin/python3 read.py
