"""The codes of `tools/bench/peers --error`: each runs and times a scene of error_cases from the same data file."""
import csv
import re

import error_cases
import packings

COLUMNS = "id x y z radius vx vy vz omegax omegay omegaz"


def write_data(path, scene):
    """Data file of atom style sphere with 17 digits, read by all three codes."""
    bodies = [(*body.position, body.radius) for body in scene.bodies]
    packings.write_data(path, bodies, error_cases.DENSITY, scene.bounds)
    with open(path, "a") as out:
        out.write("\nVelocities\n\n")
        for k, body in enumerate(scene.bodies, 1):
            out.write(" ".join([str(k), *(f"{v:.17g}" for v in (*body.velocity, *body.spin))]) + "\n")


def read_dump(path):
    lines = path.read_text().splitlines()
    start = max(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS")) + 1
    rows = sorted(([float(word) for word in line.split()] for line in lines[start:]), key=lambda row: row[0])
    return [error_cases.Body(row[1:4], row[5:8], row[8:11], row[4]) for row in rows]


class Scree:
    name = "scree"

    def __init__(self, codes):
        self.codes = codes

    def contact(self, law):
        if law.kind == "linear":
            normal, tangential = law.dashpots()
            lines = ['plugin = "linear_spring_dashpot"', f"normal_stiffness = {law.stiffness!r}",
                     f"normal_damping = {normal!r}"]
            if law.friction:
                lines += [f"tangential_stiffness = {law.tangential_stiffness()!r}",
                          f"tangential_damping = {tangential!r}", f"static_friction = {law.friction!r}"]
            return lines
        lines = ['plugin = "hertz_mindlin"', f"youngs_modulus = {law.young!r}",
                 f"poissons_ratio = {error_cases.POISSON!r}", f"restitution = {law.restitution!r}",
                 f"friction = {law.friction!r}"]
        return lines + ([f'history = "{law.history}"'] if law.history else [])

    def write(self, scene):
        write_data(self.codes.work / "error.data", scene)
        lines = ["[time]", f"step = {scene.step!r}", f"duration = {scene.step * scene.steps!r}", "energy_audit = false",
                 "step_guard = false", "[particles]", 'file = "error.data"', "[[material]]", 'name = "bead"',
                 f"density = {error_cases.DENSITY!r}", "[[contact]]", *self.contact(scene.law)]
        if scene.periodic:
            low, high = ([bound[k] for bound in scene.bounds] for k in (0, 1))
            lines += ["[[boundary]]", 'plugin = "periodic"', 'axes = "xyz"', f"lower = {low!r}", f"upper = {high!r}"]
        file = self.codes.work / "error.toml"
        file.write_text("\n".join(lines) + "\n")
        return file

    def run(self, scene):
        """Final bodies."""
        file, out = self.write(scene), self.codes.work / "error-run"
        self.codes.run([self.codes.scree_program, "run", file, "--out", out, "--overwrite", "--quiet"], 1)
        with open(out / "final_packing.csv") as lines:
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
        column = {name.split(" ")[0]: name for name in rows[0]}
        rows.sort(key=lambda row: int(row["id"]))
        number = lambda row, names: [float(row[column[name]]) for name in names.split()]
        return [error_cases.Body(number(row, "x y z"), number(row, "vx vy vz"), number(row, "spin_x spin_y spin_z"),
                                 *number(row, "radius")) for row in rows]

    def time(self, scene):
        """Seconds per step, without output."""
        file, table = self.write(scene), self.codes.work / "error-bench.csv"
        table.unlink(missing_ok=True)
        # --start must be at least one step.
        options = ["--start", scene.step, "--steps", scene.steps - 2, "--repeats", 1]
        self.codes.run([self.codes.scree_program, "bench", file, *options, "--csv", table], 1)
        with open(table) as lines:
            return float(list(csv.DictReader(lines))[-1]["s_per_step"])


class Peer:
    """Common part of LIGGGHTS and LAMMPS scripts."""

    def __init__(self, codes):
        self.codes = codes

    def script(self, scene, dump):
        lines = [*self.head, f"boundary {' '.join(('p' if scene.periodic else 'f') * 3)}", "newton off", "units si",
                 "read_data error.data", f"neighbor {scene.skin!r} bin", "neigh_modify delay 0 every 1 check yes",
                 *self.contact(scene.law), f"timestep {scene.step!r}", "fix i all nve/sphere", "thermo 1000000000",
                 f"run {scene.steps}"]
        return lines + ([f"write_dump all custom error.dump {COLUMNS} modify format {self.form}"] if dump else [])

    def log(self, scene, dump):
        write_data(self.codes.work / "error.data", scene)
        file = self.codes.work / f"error.{self.name}"
        file.write_text("\n".join(self.script(scene, dump)) + "\n")
        return self.codes.run([*self.command, "-log", "none", "-in", file], 1).stdout

    def run(self, scene):
        self.log(scene, True)
        return read_dump(self.codes.work / "error.dump")

    def time(self, scene):
        loops = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps", self.log(scene, False), re.M)
        seconds, steps = loops[-1]
        return float(seconds) / int(steps)


class Liggghts(Peer):
    name, command = "liggghts", ["liggghts"]
    head = ["atom_style granular", "atom_modify map array", "communicate single vel yes"]
    form = '"%d' + " %.17g" * 10 + '"'

    def contact(self, law):
        pair, single, words = {"coefficientFriction": law.friction}, {}, "hertz"
        if law.kind == "linear":
            normal, tangential = law.dashpots()
            pair |= {"kn": law.stiffness, "kt": law.tangential_stiffness()}
            pair |= {"gamman_abs": normal, "gammat_abs": tangential}
            words = "hooke/stiffness"
        else:
            pair["coefficientRestitution"] = law.restitution
            single = {"youngsModulus": law.young, "poissonsRatio": error_cases.POISSON}
        # Also without friction: "tangential off" is not a precompiled model combination and is slower.
        words += " tangential history" + (" absolute_damping on" if law.kind == "linear" else "")
        lines = [f"fix {name} all property/global {name} peratomtypepair 1 {value!r}" for name, value in pair.items()]
        lines += [f"fix {name} all property/global {name} peratomtype {value!r}" for name, value in single.items()]
        return [*lines, f"pair_style gran model {words}", "pair_coeff * *"]


class Lammps(Peer):
    name, command = "lammps", ["lmp"]
    head = ["atom_style sphere", "comm_modify vel yes"]
    form = "float %.17g"

    def contact(self, law):
        sliding, damping = "linear_nohistory 0.0 0.0", "velocity"
        if law.kind == "linear":
            normal, tangential = law.dashpots()
            pushing = f"hooke {law.stiffness!r} {normal!r}"
            if law.friction:
                ratio = tangential / normal if normal else 0.0
                sliding = f"linear_history {law.tangential_stiffness()!r} {ratio!r} {law.friction!r}"
        else:
            elastic = law.restitution == 1  # the fit of tsuji has slight damping for 1
            pushing = f"hertz/material {law.young!r} {0.0 if elastic else law.restitution!r} {error_cases.POISSON!r}"
            damping = "velocity" if elastic else "tsuji"
            if law.friction:
                sliding = f"{law.lammps_history} NULL {law.tangential_over_normal()!r} {law.friction!r}"
        return ["pair_style granular", f"pair_coeff * * {pushing} tangential {sliding} damping {damping}"]


ALL = [Scree, Liggghts, Lammps]
