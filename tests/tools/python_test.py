"""The Python package on small scenes of the program that SCREE_PROGRAM names: called by python_test.sh."""
import csv
import importlib.util
import io
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest
from unittest import mock

SOURCES = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = SOURCES / "tools" / "python"
sys.path.insert(0, str(PACKAGE))
import numpy  # noqa: E402
import scree  # noqa: E402
from scree.values import toml, value_at  # noqa: E402

SCENE = """
scene = { title = "Beads that fall", seed = 3 }
time = { step = { fraction = 0.05 } }
particles = { lattice = { kind = "simple_cubic", count = [4, 4, 4] }, radius = { distribution = "uniform", minimum = 0.002, maximum = 0.003 }, random_velocity = 0.1 }
material = [{ name = "glass", density = 2500 }]
contact = [{ plugin = "linear_spring_dashpot", normal_stiffness = 5000, restitution = 0.7, tangential_stiffness = 1400, static_friction = 0.3 }]
boundary = [{ plugin = "box", gap = 0.0005, x = "fixed", y = "fixed", z = "fixed" }]
body_force = [{ plugin = "gravity", acceleration = [0, 0, -9.81] }]
stage = [{ name = "fall", duration = 0.03 }, { name = "rest/1", duration = 0.03 }]
probe = [{ plugin = "energy", every = 0.001 }, { plugin = "contacts", every = 0.001 }]
"""
UNMET = {"expect": [{"requirement": "few steps", "quantity": "steps", "at_most": 1}]}


class InFolder(unittest.TestCase):
    """Tests in a folder with scene.toml and a run of it."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        pathlib.Path("scene.toml").write_text(SCENE)
        cls.run_of_scene = scree.run("scene.toml", out="run")

    def refused(self, part, call, *arguments, **options):
        """The error of a call: one line with a part."""
        with self.assertRaises(scree.Error) as caught:
            call(*arguments, **options)
        self.assertIn(part, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))
        return caught.exception


class Reading(InFolder):
    def test_series_to_the_bit_with_units(self):
        result = scree.read("run")
        self.assertEqual(list(result.series), ["contacts", "energy"])
        with open("run/series/energy.csv", newline="") as file:
            header, *rows = csv.reader(file)
        for name in ("time", "kinetic_translation", "residual"):
            at = [cell.split(" [")[0] for cell in header].index(name)
            self.assertEqual(result.series["energy"][name].tolist(), [float(row[at]) for row in rows])
        self.assertEqual(result.units("energy")["kinetic_translation"], "J")
        self.assertEqual(result.series["energy"].attrs["units"], result.units("energy"))
        self.assertNotIn("coordination_number", result.units("contacts"))
        self.assertEqual(set(result.series["energy"].stage), {1, 2})

    def test_record_and_scenario(self):
        result = self.run_of_scene
        self.assertEqual((result.kind, result.status, result.warnings, result.expectations), ("run", "finished", [], []))
        self.assertEqual([stage["name"] for stage in result.stages], ["fall", "rest/1"])
        self.assertEqual(result.scenario["scene"]["seed"], 3)

    def test_states_have_the_bits_of_the_packing(self):
        for boundary in ("box", "periodic"):
            change = {"boundary": [{"plugin": "periodic", "axes": "xyz", "lower": [0, 0, 0], "upper": [0.03, 0.03, 0.03]}]}
            result = self.run_of_scene if boundary == "box" else scree.run("scene.toml", change, "periodic")
            state, bodies = result.state(), result.bodies()
            for values, names in ((state.positions, "x y z"), (state.velocities, "vx vy vz"), (state.spins, "spin_x spin_y spin_z")):
                self.assertEqual(values.tobytes(), bodies[names.split()].to_numpy().tobytes())
            for values, name in ((state.radii, "radius"), (state.masses, "mass"), (state.ids, "id")):
                self.assertEqual(values.tolist(), bodies[name].tolist())
            self.assertEqual((set(state.materials), set(bodies.material)), ({"glass"}, {"glass"}))
            self.assertEqual(bodies.attrs["head"]["periodic"], "" if boundary == "box" else "x y z")
            self.assertEqual(state.time, float(bodies.attrs["head"]["time"]))

    def test_states_of_stages(self):
        result = self.run_of_scene
        self.assertEqual(list(result.states), ["fall", "final"])
        self.assertAlmostEqual(result.state("fall").time, 0.03, places=3)
        self.assertEqual(result.state("run/states/fall.h5").scenario, result.scenario)
        self.refused("there is no state 'none'; give one of fall, final", result.state, "none")

    def test_contacts_fit_bodies_and_walls(self):
        contacts, bodies = self.run_of_scene.contacts(), self.run_of_scene.bodies().set_index("id")
        self.assertGreater(len(contacts), 20)
        pairs = contacts[contacts.b.notna()]
        first, second = bodies.loc[pairs.a], bodies.loc[pairs.b]
        apart = numpy.linalg.norm(first[["x", "y", "z"]].to_numpy() - second[["x", "y", "z"]].to_numpy(), axis=1)
        # Round-off of lengths of 1e-2 m.
        numpy.testing.assert_allclose(first.radius.to_numpy() + second.radius.to_numpy() - apart, pairs.overlap, atol=1e-16)
        at_walls, walls = contacts[contacts.b.isna()], self.run_of_scene.walls
        self.assertIn("box.z_low", set(at_walls.wall))
        force = ["force_x", "force_y", "force_z"]
        # Forces are evaluated at the end, loads half a step before: 1 % of the load at 20 steps in a contact.
        floor = at_walls.loc[at_walls.wall == "box.z_low", force].sum()
        numpy.testing.assert_allclose(floor, -walls.loc[5, ["load_x", "load_y", "load_z"]].to_numpy(float), atol=0.01 * floor.force_z)
        self.assertEqual((walls.boundary[5], walls.normal_z[5], walls.attrs["units"]["load_z"]), ("box", 1, "N"))
        self.assertEqual(len(self.run_of_scene.state("fall").contacts().columns), len(contacts.columns))

    def test_tables_of_texts_and_gaps(self):
        pathlib.Path("table.csv").write_text('# time [s]: 0.5\nrun,case,x [m],wall [s],n\n"a,""b""",1,-0,2,\nnan,,0.1,,3\n')
        table = scree.read_table("table.csv")
        self.assertEqual((table.run.tolist(), table.case.tolist()), (['a,"b"', "nan"], ["1", ""]))
        self.assertTrue(numpy.signbit(table.x[0]))
        self.assertEqual((table.x[1], table.n[1], table[["wall", "n"]].isna().to_numpy().tolist()), (0.1, 3, [[False, True], [True, False]]))
        self.assertEqual(table.attrs, {"units": {"x": "m", "wall": "s"}, "head": {"time": "0.5"}})

    def test_what_is_not_there(self):
        self.refused("none: there is no such directory; give the directory", scree.read, "none")
        os.makedirs("empty", exist_ok=True)
        self.refused("empty: has no run.json, spectrum.json,", scree.read, "empty")
        self.refused("run/series: there is no series 'speed'; give one of contacts, energy", lambda: self.run_of_scene.series["speed"])
        self.assertIsNone(self.run_of_scene.series.get("speed"))
        self.refused("there is no table 'peaks'; give one of final_packing", self.run_of_scene.table, "peaks")
        self.refused("scene.toml: is no state file; give", scree.State, "scene.toml")
        self.refused("none.h5: there is no such file; give", scree.State, "none.h5")
        os.makedirs("broken", exist_ok=True)
        pathlib.Path("broken/run.json").write_text("{")
        self.refused("broken/run.json: is not JSON; run the scene again", lambda: scree.read("broken").record)
        pathlib.Path("broken/run.json").write_text("[]")
        self.refused("broken/run.json: is no record of scree", lambda: scree.read("broken").record)

    def test_missing_packages_are_named(self):
        with mock.patch.dict(sys.modules, {"pandas": None, "h5py": None}):
            self.refused("there is no pandas; install the package python3-pandas", lambda: scree.read("run").series["energy"])
            self.refused("there is no h5py; install the package python3-h5py", scree.read("run").state)


class Running(InFolder):
    def test_values_of_set(self):
        values = {"scene.title": 'a "b"\\\n\x7f é', "particles.lattice.count": numpy.array([2, 2, 1]), "time.step": numpy.float64(1e-5),
                  "stage": [{"name": "fall", "duration": 1e-3}], "body_force": [], "scene.seed": numpy.int64(5)}
        result = scree.run("scene.toml", values)
        self.assertEqual(result.path, pathlib.Path("runs/scene"))
        for key, value in values.items():
            self.assertEqual(numpy.array(value_at(result.scenario, key)).tolist(), numpy.array(value).tolist())
        for value in (True, 0.1, 1e300, -3, [1, [2.5, "x"]], {"a b": {"c": [False]}, "d": {}}):
            self.assertEqual(tomllib.loads(f"value = {toml(value)}")["value"], value)
        self.refused("scene.seed: a value of the type NoneType has no form in TOML", scree.run, "scene.toml", {"scene.seed": None})

    def test_failures_have_line_status_and_results(self):
        error = self.refused("unknown key 'static_frction'", scree.run, "scene.toml", {"contact.static_frction": 1}, "refused")
        self.assertEqual((error.status, error.result, os.path.exists("refused")), (2, None, False))
        error = self.refused("scene.toml: not met: few steps", scree.run, "scene.toml", UNMET, "unmet")
        self.assertEqual((error.status, error.result.expectations[0]["met"]), (1, False))
        self.assertGreater(len(error.result.series["energy"]), 50)
        early = {"stage": [{"name": "fall", "until": {"kinetic_over_elastic": 1e-30, "at_most": 0.002}}]}
        error = self.refused("fall", scree.run, "scene.toml", early, "early")
        self.assertEqual((error.status, error.result.status), (4, "failed"))
        self.refused("program: none: there is no such program", scree.run, "scene.toml", out="x", program="none")
        self.refused("true: wrote no results; give the program scree", scree.run, "scene.toml", out="x", program="true")

    def test_directories_that_have_a_run(self):
        self.refused("run: already contains a run; give another --out", scree.run, "scene.toml", out="run")
        before = os.stat("run/run.json").st_mtime_ns
        self.assertEqual(scree.run("scene.toml", {"scene.seed": 3}, "run", resume=True).status, "finished")
        self.assertEqual(os.stat("run/run.json").st_mtime_ns, before)
        self.refused("holds a run with contact.static_friction = 0.3;", scree.run, "scene.toml", {"contact.static_friction": 0.4}, "run", resume=True)
        scree.run("scene.toml", {"contact.static_friction": 0.4}, "other")
        replaced = scree.run("scene.toml", {"contact.static_friction": 0.5}, "other", overwrite=True)
        self.assertEqual(replaced.scenario["contact"][0]["static_friction"], 0.5)

    def test_an_interrupted_run_goes_on_to_the_same_bits(self):
        long = {"stage": [{"name": "fall", "duration": 1}], "particles.lattice.count": [8, 8, 8]}
        whole = scree.run("scene.toml", long, "whole")
        words = [scree.find_program(), "run", "scene.toml", "--out", "cut", "--quiet"]
        words += [word for key, value in long.items() for word in ("--set", f"{key}={toml(value)}")]
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while not os.path.exists("cut/run.json"):
                time.sleep(0.01)
            time.sleep(0.2)
            process.send_signal(signal.SIGINT)
        if scree.read("cut").status == "finished":
            self.skipTest("the run ended before it was interrupted")
        self.assertEqual((process.returncode, scree.read("cut").status), (130, "interrupted"))
        resumed = scree.run("scene.toml", long, "cut", resume=True)
        self.assertEqual(resumed.record["state_hash"], whole.record["state_hash"])

    def test_a_campaign_and_a_spectrum(self):
        head = '[campaign]\nscenario = "scene.toml"\nseeds = [1, 2]\ncollect = ["energy.kinetic_translation.last"]\n'
        pathlib.Path("friction.toml").write_text(head + '[set]\n"contact.static_friction" = [0.1, 0.3]\n')
        campaign = scree.study("campaign", "friction.toml", jobs=1)
        self.assertEqual(repr(campaign), repr(scree.read("campaigns/friction")))
        self.assertEqual(len(campaign.table), 4)
        for run in campaign.finished("contact.static_friction"):
            self.assertEqual(run.row["energy.kinetic_translation.last"], run.series["energy"].kinetic_translation.iloc[-1])
            self.assertEqual(run.row["contact.static_friction"], run.scenario["contact"][0]["static_friction"])
        means = campaign.table.groupby("contact.static_friction")["energy.kinetic_translation.last"].mean()
        numpy.testing.assert_allclose(campaign.means["energy.kinetic_translation.last_mean"], means, rtol=1e-15)
        self.refused("table.csv: there is no column 'case'; give the folder", campaign.finished, "case")
        spectrum = scree.study("spectrum", SOURCES / "scenarios" / "sound" / "chain.toml", out="sound", by="linear")
        self.assertEqual((spectrum.kind, spectrum.status), ("spectrum", "finished"))
        self.assertEqual(set(spectrum.table("peaks").column), {"particles.z_1", "particles.z_8"})
        self.assertEqual(spectrum.units("peaks")["frequency"], "Hz")


class Evaluating(InFolder):
    """What scripts that evaluate campaigns share."""

    def test_fits_of_known_values(self):
        fits = scree.fits
        self.assertEqual(fits.mean_and_error([1, 3]), (2, 1))
        self.assertEqual(fits.mean_and_error([5])[0], 5)
        self.assertTrue(numpy.isnan([fits.mean_and_error([5])[1], *fits.mean_and_error([1, numpy.nan])]).all())
        # About 2 + 3 k, by turns 1 above and below, which is no slope over 1, -1, -1, 1.
        numpy.testing.assert_allclose(fits.line_through([3, 4, 7, 12]), (3, 1), rtol=1e-14)
        numpy.testing.assert_allclose(fits.proportional([1, 2, 3], [2, 4, 6]), (2, 1), rtol=1e-14)
        self.assertTrue(numpy.isnan(fits.proportional([1, 2], [3, 3])[1]))
        self.assertAlmostEqual(fits.power([1, 10, 100], [5, 50, 500]), 1)
        # 7 − 2 (x − 1.2)².
        x = numpy.arange(0, 3, 0.5)
        numpy.testing.assert_allclose(fits.maximum(x, 7 - 2 * (x - 1.2) ** 2), (1.2, 7), rtol=1e-12)
        # Two rounds of a square of side 2, against the sense of ∮ y dx > 0, and the diagonal to its first highest point.
        strain, stress = numpy.array([0, 2, 2, 0, 0, 2, 2, 0, 0]), numpy.array([0, 0, 2, 2, 0, 0, 2, 2, 0])
        loops = list(zip(fits.cycles_of(strain, 4), fits.cycles_of(stress, 4)))
        self.assertEqual([fits.loop_area(*loop) for loop in loops], [-4, -4])
        self.assertEqual([fits.loop_slope(*loop) for loop in loops], [1, 1])

    def test_numbers_with_their_origin(self):
        os.makedirs("paper", exist_ok=True)
        os.makedirs("sweep", exist_ok=True)
        pathlib.Path("sweep/table.csv").write_text("run\n")
        pathlib.Path("paper/results.csv").write_text(",".join(scree.documents.Numbers.COLUMNS) + "\nsweep,angle,beads,rad,0.5,0.4,,1,by hand,,,,recorded\n")
        numbers = scree.documents.Numbers("paper", "out")
        numbers.put("sweep", "beads", [("angle", "deg", 0.45678, 0.0123), ("height", "m", "1.50"), ("gap", "m", numpy.nan)], "sweep", 4, note="two")
        numbers.put("sweep", "discs, 7", [("angle", "1", 0.3, numpy.nan)])
        with mock.patch("sys.stdout", io.StringIO()) as printed:
            numbers.print()
            numbers.print()
        self.assertEqual(printed.getvalue().splitlines(), ["case      packings    angle [deg]  height [m]  angle  note",
                                                           "beads            4  0.457 ± 0.012        1.50          two",
                                                           "discs, 7         1                               0.3"])
        self.assertEqual(numbers.write(), "out/results.csv")
        again = scree.documents.Numbers("paper", "out")
        self.assertEqual(list(again.rows), [("sweep", "angle", "beads"), ("sweep", "height", "beads"), ("sweep", "angle", "discs, 7")])
        row = again.rows["sweep", "angle", "beads"]
        self.assertEqual([row[name] for name in ("unit", "paper", "scree", "error", "packings", "command", "source")],
                         ["rad", "0.5", "0.457", "0.012", "4", "by hand", "runs"])
        self.assertRegex(row["date"], r"^20\d\d-")
        self.assertEqual(again.rows["sweep", "height", "beads"]["command"], "scree campaign scenarios/paper/sweep.toml")
        self.assertEqual((again.value("sweep", "angle", "beads"), again.value("sweep", "angle", "none")), ((0.457, 0.012), None))
        self.assertEqual(again.over("sweep", "angle", r"discs, (\d)"), {("7",): 0.3})

    def test_arguments_of_scripts(self):
        script = f"import sys\nsys.path.insert(0, {str(PACKAGE)!r})\nimport scree\nscree.scripts.start('csv')\nprint(scree.scripts.folders('Usage: x'))\n"
        pathlib.Path("x.py").write_text(script + "raise scree.Error('one: line')\n")
        for words, status, out, error in (("a b --out c", 1, "(['a', 'b'], 'c')\n", "x.py: one: line\n"), ("a", 1, "(['a'], 'a')\n", "x.py: one: line\n"),
                                          ("--help", 0, "Usage: x\n", ""), ("", 2, "", "Usage: x\n"), ("--out c", 2, "", "Usage: x\n"), ("a --out", 2, "", "Usage: x\n")):
            done = subprocess.run([sys.executable, "-B", "x.py", *words.split()], capture_output=True, text=True, check=False)
            with self.subTest(words=words):
                self.assertEqual((done.returncode, done.stdout, done.stderr), (status, out, error))
        self.assertEqual(scree.values.overrides(["a.b=[1, 2]", "c=glass", 'd="2"']), {"a.b": [1, 2], "c": "glass", "d": "2"})
        self.refused("a: not KEY=VALUE", scree.values.overrides, ["a"])
        self.refused("run/run.json: File exists; give a folder", scree.errors.made, "run/run.json")

    def test_campaigns_in_folders(self):
        for folder, study in (("two/b", "first"), ("two/a", "first"), ("two/c", "third")):
            os.makedirs(folder)
            pathlib.Path(folder, "table.csv").write_text("run,status\n")
            pathlib.Path(folder, "campaign.json").write_text(json.dumps({"file": f"x/{study}.toml"}))
        found = scree.campaigns.campaigns_in(["none", "two/a", "two"])
        self.assertEqual({study: str(campaign.path) for study, campaign in found.items()}, {"first": "two/a", "third": "two/c"})
        os.makedirs("two/c/run")
        pathlib.Path("two/c/run/scenario.toml").write_text('[particles]\nstate = "elsewhere/prepare/calm/final_state.h5"\n')
        self.assertEqual(scree.Result("two/c/run").prepared.path, pathlib.Path("two/c/prepare/calm"))
        self.assertEqual((scree.Campaign("two/none").study, scree.Campaign("two/none").finished("x")), ("none", []))

    def test_sections_of_pages(self):
        page = pathlib.Path("page.md")
        page.write_text("# Page\n<!-- Written by x -->\n\nold\n\n<!-- end -->\nafter\n")
        section = scree.documents.Section("page.md", "<!-- Written by x", "<!-- end -->")
        self.assertEqual(section.text.strip(), "old")
        section.write("\n".join(scree.documents.table_row(cells) for cells in (["a", "b|c"], ["1", "2"])))
        self.assertEqual(page.read_text(), "# Page\n<!-- Written by x -->\n\n| a | b\\|c |\n| 1 | 2 |\n\n<!-- end -->\nafter\n")
        self.refused("page.md: the lines '<!-- Written by y' and", scree.documents.Section, "page.md", "<!-- Written by y", "<!-- end -->")
        for condition, share in (({"value": 3, "reference": 1, "tolerance": 4}, 0.5), ({"value": 1, "at_most": 4}, 0.25), ({"value": -1, "at_most": 4}, None)):
            self.assertEqual(scree.results.share(condition), share)


@unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs python3-matplotlib")
class Drawing(InFolder):
    def test_what_panels_have(self):
        from scree.charts import Curve, Panel, blank, labels
        figure, [[axes]] = blank(1, 1, (4, 3))
        Panel("Title", "x / m", "y / N", Curve([1, 10, 100], [3, 1, 2], "o-", label="one", names="abc"),
              Curve([1], [2], error=[0.5], capsize=2, label="two"), lambda axes: axes.margins(0.2), legend={"title": "of"},
              xscale="log", xticks=labels(1e-3, 10), yticks=(1, 2))(axes)
        self.assertEqual((axes.get_title("left"), axes.get_xlabel(), axes.get_ylabel(), axes.get_xscale()), ("Title", "x / m", "y / N", "log"))
        self.assertEqual(axes.lines[0].get_xydata().tolist(), [[1, 3], [10, 1], [100, 2]])
        self.assertEqual([text.get_text() for text in axes.texts], ["a", "b", "c"])
        self.assertEqual([text.xyann[1] for text in axes.texts], [5, -14, 5])
        self.assertEqual([text.get_text() for text in axes.get_xticklabels()], ["1e-03", "10"])
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["one", "two"])
        self.assertEqual(axes.containers[0][2][0].get_segments()[0].tolist(), [[1, 1.5], [1, 2.5]])

    def test_pictures_of_panels_that_are_known(self):
        from scree.charts import Curve, Panel
        painted = []
        panel = Panel("One", "x", "y", Curve([0, 1], [0, 1]), painted.append)
        with mock.patch("sys.stdout", io.StringIO()) as printed:
            scree.scripts.draw_known("pictures/all.png", [("a", panel), ("b", None), ("b", None), ("c", panel), ("d", panel)], (2, 1))
            scree.scripts.draw_known("pictures/none.png", [("a", None)], (2, 1))
        self.assertEqual(printed.getvalue(), "all.png without b\npictures/all.png\nnone.png not drawn: a\n")
        self.assertEqual(len(painted), 3)
        # Two columns and two rows at 80 dots an inch.
        size = struct.unpack(">II", pathlib.Path("pictures/all.png").read_bytes()[16:24])
        self.assertEqual((size, os.listdir("pictures")), ((320, 160), ["all.png"]))

    def test_a_packing_of_discs(self):
        from scree.charts import Panel, blank
        from scree.packings import frame, packing
        discs = """
scene = { title = "Discs", dimension = 2 }
time = { step = { fraction = 0.05 } }
particles = { lattice = { kind = "square", count = [2, 2], spacing = 0.0102, origin = [0, 0] }, radius = 0.005 }
material = [{ name = "glass", density = 2500 }]
contact = [{ plugin = "linear_spring_dashpot", normal_stiffness = 5000, restitution = 0.7, tangential_stiffness = 1400, static_friction = 0.3 }]
boundary = [{ plugin = "box", lower = [0, 0], upper = [0.0204, 0.04], x = "fixed", y = "fixed" }]
body_force = [{ plugin = "gravity", acceleration = [0, -9.81] }]
stage = [{ name = "fall", duration = 0.1 }]
"""
        pathlib.Path("discs.toml").write_text(discs)
        run = scree.run("discs.toml", out="discs")
        figure, [[axes]] = blank(1, 1, (4, 3))
        Panel("Discs", "x", "y", frame(0.02, 0.02), packing(run, 2, 3, 0.01))(axes)
        contacts, places = run.contacts(), run.bodies().set_index("id")[["x", "y"]]
        self.assertEqual(set(contacts.wall), {"", "box.y_low"})
        # A frame and four discs; of each contact a line from centre to centre or wall, and one across it.
        self.assertEqual((len(axes.patches), len(axes.lines)), (5, 2 * len(contacts)))
        for (_, contact), line in zip(contacts.iterrows(), axes.lines[::2]):
            begin, end = line.get_xydata()
            self.assertEqual(begin.tolist(), places.loc[contact.a].tolist())
            # Round-off of lengths of 1e-2 m.
            numpy.testing.assert_allclose(end, (begin[0], 0) if contact.wall else places.loc[contact.b], atol=1e-16)
            self.assertAlmostEqual(line.get_linewidth(), 2 * (contact.force_x * contact.normal_x + contact.force_y * contact.normal_y))


class Documents(InFolder):
    def test_the_example_of_the_page(self):
        pathlib.Path("fall.toml").write_text(re.search("```toml\n(.*?)```", (SOURCES / "README.md").read_text(), re.DOTALL)[1])
        example, chart = re.findall("```python\n(.*?)```", (PACKAGE / "README.md").read_text(), re.DOTALL)
        drawn = importlib.util.find_spec("matplotlib") is not None
        example += chart if drawn else "print('energy.png')\n"
        done = subprocess.run([sys.executable, "-B", "-c", example], capture_output=True, text=True, check=False, env=os.environ | {"PYTHONPATH": str(PACKAGE)})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^[0-9.e-]+ J\nfinished .*\n\(200, 3\) .*\n\d+ beads press on the floor with 0.3[0-9]+ N\n.*'static_frction'.* 2\nenergy.png\n$")
        self.assertEqual(os.path.exists("energy.png"), drawn)


class Installed(InFolder):
    def test_by_pip_without_network(self):
        for module in ("pip", "setuptools", "wheel"):
            if subprocess.run([sys.executable, "-c", f"import {module}"], capture_output=True, check=False).returncode:
                self.skipTest(f"{module} is not installed")
        shutil.copytree(PACKAGE, "package")
        words = [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", "--target", "installed", "./package"]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        code = "import scree; print(scree.__file__); print(scree.read('run').contacts().shape)"
        called = {"env": os.environ | {"PYTHONPATH": os.path.abspath("installed")}, "capture_output": True, "text": True, "check": False}
        done = subprocess.run([sys.executable, "-c", code], **called)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines(), [os.path.abspath("installed/scree/__init__.py"), str(self.run_of_scene.contacts().shape)])


if __name__ == "__main__":
    unittest.main()
