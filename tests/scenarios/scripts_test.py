"""Scripts of the scenarios on small campaigns whose numbers are known; skipped without pandas or matplotlib."""
import csv
import importlib.util
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

SOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCENARIOS, PACKAGE = os.path.join(SOURCES, "scenarios"), os.path.join(SOURCES, "tools", "python")
DRAWS = unittest.skipUnless(importlib.util.find_spec("matplotlib") and importlib.util.find_spec("pandas"), "needs python3-matplotlib and python3-pandas")


def call(script, *arguments):
    words = [sys.executable, "-B", os.path.join(SCENARIOS, script), *arguments]
    return subprocess.run(words, capture_output=True, text=True, check=False)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def rows_of(table):
    """Rows of a results.csv by study, quantity and case."""
    with open(table, encoding="utf-8", newline="") as file:
        return {(row["study"], row["quantity"], row["case"]): row for row in csv.DictReader(file)}


@DRAWS
class Exponent(unittest.TestCase):
    @staticmethod
    def spectra(folder):
        """Four packings whose frequencies grow by the powers 0.15 and 0.19 of the stress."""
        rows = ["run,boundary.bottom.stress,seed,status"]
        for seed, power in ((1, 0.15), (2, 0.19)):
            for stress in (1e4, 1e5):
                name = f"s{seed}_{stress:g}"
                rows.append(f"{name},{stress},{seed},finished")
                first = 7000 * (stress / 1e4) ** power
                peaks = [f"{first * (4 * w)},1,10,{2 - w},{w}" for w in (0.25, 0.75, 1.25)]
                head = "frequency [Hz],frequency_error [Hz],quality,amplitude,wavelengths"
                # A smaller peak of the same name is left out.
                write(os.path.join(folder, name, "peaks.csv"), "\n".join([head, *peaks, "1234,1,10,0.01,0.25"]) + "\n")
        write(os.path.join(folder, "table.csv"), "\n".join(rows) + "\n")
        write(os.path.join(folder, "campaign.json"), '{"file": "spectra.toml"}')

    def test_of_frequencies_that_grow_by_a_power(self):
        with tempfile.TemporaryDirectory() as folder:
            self.spectra(folder)
            done = call("lemrich2017/figures.py", folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        # Mean of the powers, and half their difference.
        self.assertEqual(len(re.findall(r"n = 0\.1700 ± 0\.0200 \(seeds: 0\.1500, 0\.1900\)", done.stdout)), 3, done.stdout)
        self.assertIn("1 : 3.000 : 5.000", done.stdout)

    def test_that_rows_of_the_record_are_replaced(self):
        with tempfile.TemporaryDirectory() as folder:
            self.spectra(folder)
            done = call("lemrich2017/figures.py", folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(os.path.exists(os.path.join(folder, "claims.png")))
            rows = rows_of(os.path.join(folder, "results.csv"))
        found = rows["spectra", "exponent of 3λ/4 in the stress", "prepare.toml"]
        self.assertEqual([found[name] for name in ("paper", "scree", "error", "packings", "source")], ["1/6", "0.1700", "0.0200", "2", "runs"])
        self.assertEqual(rows["spectra", "frequency of 5λ/4", "10 kPa, seed 1"]["scree"], "35.0000")
        self.assertEqual(rows["spectra", "frequency of 5λ/4", "10 kPa, seed 3"]["source"], "recorded")

    def called(self, table, status, line):
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, "campaign.json"), '{"file": "spectra.toml"}')
            if table is not None:
                write(os.path.join(folder, "table.csv"), table)
            for run in "ab":
                peaks = [f"{100 * w},1,10,5,{w}" for w in (0.25, 0.75, 1.25)]
                write(os.path.join(folder, run, "peaks.csv"), "\n".join(["frequency [Hz],frequency_error [Hz],quality,amplitude,wavelengths", *peaks]))
            done = call("lemrich2017/figures.py", folder)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (status, status), done.stderr)
        self.assertIn(line, done.stderr if status else done.stdout)

    def test_of_tables_that_have_no_exponent(self):
        self.called(None, 1, "run scree campaign scenarios/lemrich2017/spectra.toml first")
        self.called("", 1, "run scree campaign scenarios/lemrich2017/spectra.toml first")
        self.called("run,seed,status\na,1,finished\n", 1, "there is no column 'boundary.bottom.stress'; give the folder of a campaign that varies it")
        self.called("run,boundary.bottom.stress [Pa],seed,status\na,1e4,1,finished\nb,16e4,1,failed\n", 0,
                    "no exponent from one stress, of seed 1; let the campaign finish two or more")


@DRAWS
class Cells(unittest.TestCase):
    """The cylindrical cell of lemrich2017/cell.toml."""

    @classmethod
    def setUpClass(cls):
        with mock.patch.object(sys, "path", [os.path.join(SCENARIOS, "lemrich2017"), PACKAGE, *sys.path]):
            cls.cells = importlib.import_module("cells")

    def test_that_waves_beside_a_free_side_are_plane(self):
        frequencies, shares = self.cells.modes_in_cylinder((300.0, 150.0), 5e-3, 12e-3, False)
        plane = [(f, share) for f, share in zip(frequencies, shares) if share > 1e-6]
        for n, (frequency, share) in zip((1, 3, 5), plane):
            # The strain is taken over layers: a part (π n/(4·48))²/6 is missing, and half of it of the share.
            self.assertAlmostEqual(frequency / (n * 300 / (4 * 12e-3)), 1, delta=(math.pi * n / 192) ** 2)
            self.assertAlmostEqual(share * (math.pi * n) ** 2 / 8, 1, delta=8 * (math.pi * n / 192) ** 2 + 0.011)

    def test_that_a_held_side_has_the_cut_off_of_shear(self):
        # High and narrow: nothing goes through it below 2.405 c/(2π R), and the plate is an end between a free and a held one.
        frequencies, _ = self.cells.modes_in_cylinder((300.0, 150.0), 1e-3, 12e-3, True)
        cut_off = 2.404826 * 150 / (2 * math.pi * 1e-3)
        error = (2.404826 / 16) ** 2 / 6  # of rings of R/16
        self.assertGreater(frequencies[0], math.hypot(cut_off, 300 / (4 * 12e-3)) * (1 - error))
        self.assertLess(frequencies[0], math.hypot(cut_off, 300 / (2 * 12e-3)) * (1 + error))
        # Flat and wide: the side does not count.
        frequencies, _ = self.cells.modes_in_cylinder((300.0, 150.0), 1.0, 12e-3, True)
        self.assertAlmostEqual(frequencies[0] / (300 / (4 * 12e-3)), 1, delta=0.003)

    def test_that_packings_are_recorded(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = ["run,case,seed,status"]
            for case, first in (("periodic", 6400), ("cell with friction", 15000)):
                run = os.path.join(folder, case)
                rows.append(f"{case},{case},1,finished")
                write(os.path.join(run, "spectrum.json"), "{}")
                write(os.path.join(run, "scenario.toml"), f'[particles]\nstate = "/elsewhere/{first}/final_state.h5"\n')
                head = "column,frequency [Hz],frequency_error [Hz],quality,amplitude,wavelengths\n"
                write(os.path.join(run, "peaks.csv"), f"{head}strain.distance,{first},2,30,1,0.25\nother,1,1,1,1,0.75\nstrain.distance,20100,90,9,1,\n")
                write(os.path.join(run, "spectrum.csv"), "frequency [Hz],strain.distance.amplitude [1/m]\n5000,100\n10000,200\n")
                series = os.path.join(folder, "prepare", str(first), "series")
                write(os.path.join(series, "walls.csv"), "position_1 [m],position_2 [m],normal_force_1 [N],normal_force_2 [N]\n0,0,1,1\n-0.0125,0,1,0.9\n")
                write(os.path.join(series, "contacts.csv"), "coordination_without_rattlers\n4.9\n")
            write(os.path.join(folder, "table.csv"), "\n".join(rows) + "\n")
            write(os.path.join(folder, "campaign.json"), '{"file": "cell.toml"}')
            done = call("lemrich2017/figures.py", folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(os.path.exists(os.path.join(folder, "cell.png")))
            found = rows_of(os.path.join(folder, "results.csv"))
        for quantity, value in (("height", "12.500"), ("load of the top over that of the bottom", "0.9000"), ("contacts of a bead that bears load", "4.900"),
                                ("frequency of λ/4", "15"), ("Q of λ/4", "30"), ("frequency of peak 2", "20.1")):
            self.assertEqual(found["cell", quantity, "cell with friction, seed 1"]["scree"], value)
        self.assertEqual(found["cell", "frequency of λ/4", "periodic, seed 1"]["scree"], "6.4")
        self.assertNotIn(("cell", "frequency of 3λ/4", "periodic, seed 1"), found)


class Accumulation(unittest.TestCase):
    SCENARIO = """[scene]
seed = SEED
[time]
step = 1e-3
[particles]
lattice = { count = [2, 2, 2] }
[[contact]]
plugin = "PLUGIN"
static_friction = 0.1
[[stage]]
period = 1
"""

    @DRAWS
    def test_strain_area_and_slope_of_known_loops(self):
        with tempfile.TemporaryDirectory() as folder:
            self.campaign(folder, (1, 2))
            done = call("david2005/figures.py", folder)
            pictures = [os.path.exists(os.path.join(folder, name)) for name in ("accumulation.png", "loops.png", "claims.png")]
            rows = rows_of(os.path.join(folder, "results.csv"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(pictures, [True, True, True])
        row = rows["accumulation", "area of the first loop", "8 spheres, μ = 0.1, David et al."]
        self.assertEqual([row[name] for name in ("unit", "scree", "packings", "source")], ["Pa", "0.0375", "2", "runs"])
        # Rows of the record that the campaign lacks stay.
        self.assertEqual(rows["rates", "strain after 20 cycles", "seed 1, period 1 s, step 2e-05 s"]["source"], "recorded")
        # Ten cycles of 1e-4 and 2e-4; in the first, ∮σ dε = 100/2 1e-3 − 50/2 5e-4 Pa, and 100 Pa at a strain of 1e-3.
        self.assertRegex(done.stdout, r"8 spheres, μ = 0\.1, David et al\. +2 +0\.0015 ± 0\.0005 +0\.00015 ± 5e-05 +0\.0375 ± [^ ]+ +100 ± 0")
        self.assertRegex(done.stdout, r"8 spheres, μ = 0\.1, painted points +2 +0\.003 ± 0\.001")

    @DRAWS
    def test_that_a_table_keeps_runs_of_earlier_campaigns(self):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "kept")
            os.mkdir(out)
            first, second, other = (os.path.join(folder, name) for name in ("first", "second", "other"))
            self.campaign(first, (1,))
            self.campaign(second, (2,))
            self.campaign(other, (3,), "period = 2")
            call("david2005/figures.py", first, "--out", out)
            merged = call("david2005/figures.py", second, "--out", out)
            refused = call("david2005/figures.py", other, "--out", out)
        self.assertEqual(merged.returncode, 0, merged.stderr)
        self.assertRegex(merged.stdout, r"8 spheres, μ = 0\.1, David et al\. +2 +0\.0015 ± 0\.0005 +0\.00015 ± 5e-05 +0\.0375 ± [^ ]+ +100 ± 0")
        self.assertEqual((refused.returncode, refused.stderr.count("\n")), (1, 1), refused.stderr)
        self.assertIn("its runs have another period than the runs of", refused.stderr)

    @DRAWS
    def test_that_several_periods_give_the_numbers_of_each_run(self):
        with tempfile.TemporaryDirectory() as folder:
            self.campaign(folder, (1,))
            other = os.path.join(folder, "linear_spring_dashpot_1", "scenario.toml")
            # Loops of two rows a time unit: half as many.
            write(other, self.SCENARIO.replace("PLUGIN", "linear_spring_dashpot").replace("SEED", "1").replace("period = 1", "period = 2"))
            done = call("david2005/figures.py", folder)
            written = sorted(name for name in os.listdir(folder) if name.endswith((".png", "runs.csv", "results.csv")))
            rows = rows_of(os.path.join(folder, "results.csv"))
        self.assertEqual((done.returncode, written), (0, ["claims.png", "results.csv"]), done.stderr)
        self.assertEqual(rows["accumulation", "strain after 5 cycles", "seed 1, period 2 s, step 0.001 s"]["scree"], "0.001")
        self.assertIn("strain after 5 cycles", done.stdout.splitlines()[0])
        self.assertRegex(done.stdout, r"seed 1, period 2 s, step 0\.001 s +1 +0\.001 .* 8 spheres, μ = 0\.1, David et al\.")
        self.assertRegex(done.stdout, r"seed 1, period 1 s, step 0\.001 s +1 .* +0\.002 +8 spheres, μ = 0\.1, painted points")

    @DRAWS
    def test_that_a_campaign_of_another_kind_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            self.campaign(folder, (1,), "until = {}")
            done = call("david2005/figures.py", folder)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("not a campaign of cyclic loading", done.stderr)

    @DRAWS
    def test_that_one_cycle_has_loops_and_no_accumulation(self):
        with tempfile.TemporaryDirectory() as folder:
            self.campaign(folder, (1, 2), cycles=1)
            write(os.path.join(folder, "campaign.json"), '{"file": "first-cycle.toml"}')
            done = call("david2005/figures.py", folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            written = sorted(name for name in os.listdir(folder) if name.endswith((".png", ".csv")))
            rows = rows_of(os.path.join(folder, "results.csv"))
        self.assertEqual(written, ["claims.png", "first-cycle-loops.png", "results.csv", "table.csv"])
        self.assertEqual(rows["first-cycle", "area of the first loop", "8 spheres, μ = 0.1, David et al."]["scree"], "0.0375")

    def campaign(self, folder, seeds, period="period = 1", cycles=10):
        rows = ["run,status"]
        for plugin, factor in (("linear_spring_dashpot", 1), ("sphere_path_independent", 2)):
            for seed in seeds:
                name = f"{plugin}_{seed}"
                rows.append(f"{name},finished")
                scenario = self.SCENARIO.replace("PLUGIN", plugin).replace("SEED", str(seed)).replace("period = 1", period)
                write(os.path.join(folder, name, "scenario.toml"), scenario)
                write(os.path.join(folder, name, "series", "box.csv"), self.loops(factor, seed, cycles))
        write(os.path.join(folder, "table.csv"), "\n".join(rows) + "\n")
        write(os.path.join(folder, "campaign.json"), '{"file": "accumulation.toml"}')

    @staticmethod
    def loops(factor, seed, cycles):
        lines, strain = ["time [s],deviatoric_strain,deviatoric_stress [Pa]"], 0.0
        for cycle in range(cycles):
            for quarter, (left, stress) in enumerate(((0, 0), (1e-3, 100), (1e-3, 50), (5e-4, 0))):
                lines.append(f"{cycle + quarter / 4},{strain + left},{stress}")
            strain += 1e-4 * factor * seed
        lines.append(f"{cycles},{strain},0")
        return "\n".join(lines) + "\n"


class Collapse(unittest.TestCase):
    @DRAWS
    def test_of_curves_that_fall_with_the_logarithm_of_the_strain(self):
        spec = importlib.util.spec_from_file_location("sweeps", os.path.join(SCENARIOS, "lemrich2017", "sweeps.py"))
        sweeps = importlib.util.module_from_spec(spec)
        with mock.patch.object(sys, "path", [PACKAGE, *sys.path]):
            spec.loader.exec_module(sweeps)
        # 100 − 10 log10(ε) from 1 to 100, the same less 2, and one that begins behind.
        curves = [[(1, 100), (100, 80)], [(1, 98), (100, 78)], [(50, 1), (60, 1)]]
        count, apart = sweeps.spread(curves, 10)
        self.assertEqual(count, 2)
        self.assertAlmostEqual(apart, 2 / 89)
        self.assertEqual(sweeps.spread(curves, 101)[0], 0)


class Ratcheting(unittest.TestCase):
    @staticmethod
    def run_of(cycles, slope):
        rows = [f"{10 * c},1,{1 + c * slope}" for c in range(cycles + 1)]
        return "\n".join(["time [s],length_x [m],length_y [m]", *rows]) + "\n"

    def steps(self, folder, steps, cycles):
        rows = ["run,contact.discs.plugin,time.step,seed,status"]
        for step in steps:
            rows.append(f"s{step},disc_corrected,{step},1,finished")
            write(os.path.join(folder, "steps", f"s{step}", "series", "load.csv"), self.run_of(cycles, 1e-6 * step))
        write(os.path.join(folder, "steps", "table.csv"), "\n".join(rows) + "\n")
        done = call("mcnamara2008/figures.py", folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        drawn = os.path.exists(os.path.join(folder, "steps.png"))
        row = rows_of(os.path.join(folder, "results.csv"))["steps", "exponent of the step", "corrected, packing 1"]
        self.assertEqual((row["scree"], row["source"]), ("1.000", "runs" if drawn else "recorded"))
        return done.stdout, drawn

    @DRAWS
    def test_that_panels_with_data_are_drawn_and_others_named(self):
        with tempfile.TemporaryDirectory() as folder:
            printed, drawn = self.steps(folder, (1e-3, 1e-4), 40)
        self.assertTrue(drawn)
        for row in (r"step 0\.0001 τ +1 +1e-10\n", r"step 0\.001 τ +1 +1e-09\n"):
            self.assertRegex(printed, "corrected, packing 1, " + row)
        self.assertRegex(printed, r"corrected, packing 1 +1 +1\.000\n")
        self.assertIn("steps.png without figure 13, of laws.toml", printed)
        self.assertIn("cycle.png not drawn: figures 1 to 4, of paths.toml", printed)

    @DRAWS
    def test_that_one_step_and_short_runs_draw_nothing(self):
        for steps, cycles in (((1e-3,), 40), ((1e-3, 1e-4), 29)):
            with self.subTest(steps=steps), tempfile.TemporaryDirectory() as folder:
                printed, drawn = self.steps(folder, steps, cycles)
                self.assertFalse(drawn)
                self.assertIn("steps.png not drawn: figure 14", printed)

    @DRAWS
    def test_that_wrong_arguments_are_refused_with_one_line(self):
        for words, line in ((("true", "x", "5", "cycles"), "cycles: not KEY=VALUE"), (("no-such-program", "x"), "no-such-program: there is no such program"),
                            (("false", "x"), "biaxial.toml: scree run failed and says nothing"), (("true", "no-such-folder"), "true: wrote no results; give the program scree")):
            done = call("mcnamara2008/quasi_static.py", *words)
            with self.subTest(words=words):
                self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
                self.assertIn(line, done.stderr)


class Page(unittest.TestCase):
    @staticmethod
    def page(folder):
        words = [sys.executable, "-B", "-m", "scree.page", folder]
        return subprocess.run(words, capture_output=True, text=True, check=False, env=os.environ | {"PYTHONPATH": PACKAGE})

    def test_that_pages_of_scenes_say_what_the_scenes_require(self):
        for folder in ("verification", "hard-cases"):
            done = self.page(os.path.join(SCENARIOS, folder))
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_that_a_page_with_another_title_is_refused(self):
        with tempfile.TemporaryDirectory() as parent:
            folder = os.path.join(parent, "scenes")
            condition = '[[expect]]\nrequirement = "Body 1: speed"\nquantity = "steps"\nat_most = 1\n'
            write(os.path.join(folder, "one.toml"), '[scene]\ntitle = "One"\n' + condition)
            head = "<!-- Written by scree.page; to renew it: python3 -m scree.page scenes scree -->\n"
            for row, status in (("| [one](one.toml) | One | speed | 1 | 0.10 | Body 1: speed |", 0),
                                ("| [one](one.toml) | Two | speed | 1 | 0.10 | Body 1: speed |", 1), ("", 1)):
                write(os.path.join(folder, "README.md"), head + row + "\n<!-- end -->\n")
                done = self.page(folder)
                with self.subTest(row=row):
                    self.assertEqual((done.returncode, done.stderr.count("\n")), (status, status), done.stderr)


class Meshes(unittest.TestCase):
    """Plates with holes of scenarios/surfaces/meshes.py."""

    @classmethod
    def setUpClass(cls):
        place = importlib.util.spec_from_file_location("meshes", os.path.join(SCENARIOS, "surfaces", "meshes.py"))
        cls.meshes = importlib.util.module_from_spec(place)
        place.loader.exec_module(cls.meshes)

    @staticmethod
    def holes(chance):
        """Some that neither overlap nor reach the border of a plate of 60 by 40."""
        found = []
        for _ in range(30):
            radius = chance.uniform(0.5, 8)
            x, y = chance.uniform(radius - 29, 29 - radius), chance.uniform(radius - 19, 19 - radius)
            if all(math.dist((x, y), hole[:2]) > radius + hole[2] for hole in found):
                found.append((x, y, radius))
        return found

    def test_that_plates_have_their_holes_and_nothing_twice(self):
        chance = random.Random(1)
        for sides in (3, 4, 11, 24) * 15:  # among them holes that others hide from the border, and cuts from corners of cuts
            holes = self.holes(chance)
            triangles = self.meshes.plate_with_holes(60, 40, holes, sides)
            areas = [self.meshes.turn_of(*triangle) / 2 for triangle in triangles]
            with self.subTest(sides=sides, holes=len(holes)):
                self.assertGreater(len(holes), 3)
                self.assertGreaterEqual(min(areas), 0)  # all are seen from above, so that areas add up only if none lie over others
                polygons = sum(radius**2 * sides / 2 * math.sin(2 * math.pi / sides) for _, _, radius in holes)
                self.assertAlmostEqual(sum(areas), 60 * 40 - polygons, delta=1e-9)
                self.assertEqual(len(triangles), 2 + len(holes) * (sides + 2))
                for x, y, radius in holes:
                    middle = [triangle for triangle in triangles if self.holds(triangle, (x, y))]
                    self.assertEqual(middle, [], f"hole at {x}, {y}")

    def holds(self, triangle, point):
        a, b, c = triangle
        return min(self.meshes.turn_of(a, b, point), self.meshes.turn_of(b, c, point), self.meshes.turn_of(c, a, point)) > 0

    def test_that_holes_which_meet_are_refused(self):
        for holes, line in (([(0, 0, 2), (3, 0, 1)], "holes 1 and 2 overlap"), ([(28, 0, 2)], "hole 1 reaches the border"),
                            ([(0, -18.5, 1.5)], "hole 1 reaches the border")):
            with self.subTest(holes=holes), self.assertRaisesRegex(ValueError, line):
                self.meshes.plate_with_holes(60, 40, holes, 12)


class Gallery(unittest.TestCase):
    FOLDER = os.path.join(SCENARIOS, "gallery")

    def test_that_the_page_shows_every_scene_with_its_picture(self):
        with open(os.path.join(self.FOLDER, "README.md"), encoding="utf-8") as file:
            page = file.read()
        scenes = [name[:-5] for name in os.listdir(self.FOLDER) if name.endswith(".toml")]
        self.assertEqual(len(scenes), 8)
        for scene in scenes:
            picture = os.path.join(self.FOLDER, scene + ".png")
            with self.subTest(scene=scene):
                self.assertIn(f"]({scene}.toml)", page)
                self.assertIn(f"]({scene}.png)", page)
                self.assertLess(os.path.getsize(picture), 150e3)

    @DRAWS
    def test_that_every_scene_is_drawn_and_others_are_refused(self):
        for scene, line in (("none", "none: no scene of the gallery; give one of"), ("silo", "silo.toml: scree run failed and says nothing (exit status 1)")):
            with self.subTest(scene=scene), tempfile.TemporaryDirectory() as folder:
                done = call("gallery/draw.py", "false", folder, scene)
                self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
                self.assertIn(line, done.stderr)
        with open(os.path.join(self.FOLDER, "draw.py"), encoding="utf-8") as file:
            drawn = re.findall(r'^    "([a-z-]+)": \(', file.read(), re.MULTILINE)
        self.assertEqual(sorted(drawn), sorted(name[:-5] for name in os.listdir(self.FOLDER) if name.endswith(".toml")))

    @DRAWS
    def test_the_closed_forms_of_the_charts(self):
        words = ["import sys", f"sys.path[:0] = [{PACKAGE!r}, {self.FOLDER!r}]", "import curves, grains",
                 "print(curves.bessel(0, 80), curves.bessel(80, 80), curves.adiabat(0.02, 0.01), curves.hard_sphere_factor(0.1))",
                 "print(grains.janssen(2, 1))"]
        done = subprocess.run([sys.executable, "-B", "-c", "\n".join(words)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        numbers = [float(n) for n in re.findall(r"-?\d+\.\d+", done.stdout)]
        # Tables of Bessel functions: J_0(80), J_80(80); 2^(2/3) exp((2/3)(a − a_0)); 1.109/0.729; 1 − e⁻².
        for found, known in zip(numbers, (-0.06974216551, 0.10380680911, 1.631979, 1.521262, 0.864665)):
            self.assertAlmostEqual(found, known, places=4)


class WithoutPackages(unittest.TestCase):
    def named(self, package, scripts):
        """Scripts end with one line that names the Debian package of a module which cannot be imported."""
        with tempfile.TemporaryDirectory() as folder:
            write(os.path.join(folder, package + ".py"), "raise ImportError\n")
            write(os.path.join(folder, "table.csv"), "run,status\na,finished\n")
            environment = os.environ | {"PYTHONPATH": folder}
            for script in scripts:
                words = [sys.executable, "-B", os.path.join(SCENARIOS, script), folder]
                done = subprocess.run(words, capture_output=True, text=True, check=False, env=environment)
                with self.subTest(script=script):
                    self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
                    self.assertIn("python3-" + package, done.stderr)

    @DRAWS
    def test_that_scripts_that_draw_name_matplotlib(self):
        self.named("matplotlib", ("david2005/figures.py", "lemrich2017/figures.py", "mcnamara2008/figures.py", "mcnamara2008/closed_path.py", "gallery/draw.py"))

    @DRAWS
    def test_that_scripts_that_read_name_pandas(self):
        self.named("pandas", ("lemrich2017/figures.py", "mcnamara2008/closed_path.py"))


class Help(unittest.TestCase):
    @DRAWS
    def test_of_every_script(self):
        for script in ("david2005/figures.py", "lemrich2017/figures.py", "mcnamara2008/figures.py", "mcnamara2008/closed_path.py",
                       "mcnamara2008/quasi_static.py", "gallery/draw.py"):
            for arguments, status in ((["--help"], 0), ([], 2)):
                done = call(script, *arguments)
                with self.subTest(script=script, arguments=arguments):
                    self.assertEqual(done.returncode, status)
                    self.assertIn(f"Usage: python3 scenarios/{script}", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
