"""State files, as arrays of numpy, and their contacts."""
import functools
import os
import pathlib
import tempfile
import tomllib

from .errors import Error, package
from .program import call, failure
from .tables import read_table


class State:
    """Bodies in the order of the file, in SI units: ids, materials (names), positions, velocities, spins, radii, masses,
    inertias, forces, torques; time (s), dimension, scenario, and the walls."""

    ARRAYS = {"ids": "id", "positions": "position/value", "velocities": "velocity/value", "spins": "spin/value",
              "radii": "radius", "masses": "mass", "inertias": "inertia", "forces": "force/value", "torques": "torque/value"}
    WALLS = {"normal_": "planes/normal", "": "planes/point", "v": "planes/velocity", "load_": "load"}  # columns

    def __init__(self, path):
        """Reads a file."""
        self.path = pathlib.Path(path)
        with self.opened() as file:
            bodies = file["particles/bodies"]
            for name, place in self.ARRAYS.items():
                values = bodies[place][()] if place in bodies else None
                setattr(self, name, values[0] if values is not None and place.endswith("/value") else values)
            names = package("numpy").array(texts(file["scree/scene/materials"]))
            self.materials = names[bodies["species"][()]]
            self.time = float(file["scree/clock/time"][()])
            self.dimension = int(file["scree/scene/dimension"][()])

    def opened(self):
        """The file as h5py has it, for what this class does not name."""
        h5py = package("h5py")
        try:
            file = h5py.File(self.path)
        except OSError:
            known = "is no state file" if self.path.is_file() else "there is no such file"
            raise Error(f"{self.path}: {known}; give final_state.h5 or another state of a run") from None
        if "particles/bodies" not in file or "scree/clock" not in file:
            raise Error(f"{self.path}: is no state of bodies; give final_state.h5 or another state of a run")
        return file

    @functools.cached_property
    def scenario(self):
        """The scenario with its overrides, as a dict; empty if the state has none."""
        with self.opened() as file:
            return tomllib.loads(file["scree/run/scenario"][()].decode()) if "scree/run/scenario" in file else {}

    @functools.cached_property
    def walls(self):
        """The walls, numbered from 1: boundary, normal, point, velocity, and load, the force of the bodies."""
        pandas = package("pandas")
        with self.opened() as file:
            boundaries = texts(file["scree/scene/boundary_names"]) if "scree/scene/boundary_names" in file else []
            counts = [int(file[f"scree/walls/{k}/plane_count"][()]) for k in range(len(boundaries))]
            columns = {"boundary": [name for name, count in zip(boundaries, counts) for _ in range(count)]}
            units = {}
            for column, place in self.WALLS.items():
                data = file["scree/walls"][place]
                for k, axis in enumerate("xyz"[: data.shape[1]]):
                    columns[column + axis] = data[:, k]
                    units[column + axis] = texts([data.attrs["unit"]])[0]
        frame = pandas.DataFrame(columns)
        frame.index = pandas.RangeIndex(1, len(frame) + 1, name="wall")
        frame.attrs["units"] = units
        return frame

    def contacts(self, program=None, plugins=None):
        """The contacts as a data frame, with forces and the names of walls."""
        return contacts(self.path, program, plugins)


def contacts(source, program=None, plugins=None):
    """Contacts of a run (its last state), a state or particles_*.vtp; at a wall b is missing, and wall is its name."""
    with tempfile.TemporaryDirectory() as folder:
        table = os.path.join(folder, "contacts.csv")
        words = ["export", source, "--format", "contacts-csv", "--out", table]
        status, lines = call(words + (["--plugins", plugins] if plugins else []), program)
        if status != 0:
            raise failure(words, status, lines)
        return read_table(table).astype({"b": "Int64"})


def texts(values):
    """Texts of HDF5 as str."""
    return [value.decode() if isinstance(value, bytes) else str(value) for value in values]
