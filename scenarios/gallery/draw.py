"""Runs the scenes of this folder and writes the picture of each beside it.

Usage: python3 scenarios/gallery/draw.py PROGRAM [FOLDER for the runs, default: one that is removed] [SCENE...]
       python3 scenarios/gallery/draw.py build/release/bin/scree runs/gallery silo
Needs python3-matplotlib and python3-pandas. A run that is already in the folder is not repeated."""
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "tools", "python"))
import scree  # noqa: E402 (of this tree)

scree.scripts.start("matplotlib", "pandas")
import curves  # noqa: E402 (of this folder, like the next)
import grains  # noqa: E402

# The picture of each scene, and the numbers of bodies of further runs, which the picture compares.
SCENES = {
    "angle-of-repose": (grains.angle_of_repose, {}),
    "piston": (curves.piston, {}),
    "bouncing-ball": (curves.bouncing_ball, {}),
    "gas-that-cools": (curves.gas_that_cools, {}),
    "brazil-nut": (grains.brazil_nut, {}),
    "silo": (grains.silo, {f"rows {n}": [11, n] for n in (5, 10, 20, 40)}),
    "column-collapse": (grains.column_collapse, {f"rows {n}": [16, n] for n in (9, 18, 54)}),
    "wave-in-a-chain": (curves.wave_in_a_chain, {}),
}


def report(scene, run):
    """Prints each condition of a run with its value."""
    print(f"{scene}: {run.record['wall_s']:.0f} s")
    for c in run.expectations:
        wanted = f"{c['reference']:.5g} ± {c['tolerance']:.2g}" if "reference" in c else ", ".join(
            f"{sign} {c[key]:.5g}" for key, sign in (("at_least", "≥"), ("at_most", "≤")) if key in c)
        print(f"  {c['requirement']}: {c['value']:.5g}, expected {wanted}")


def draw(folder, scenes):
    """Draws each scene from its run and from those with other numbers of bodies, for which no condition holds."""
    for scene in scenes:
        path = os.path.join(HERE, scene + ".toml")
        picture, others = SCENES[scene]
        run = scree.run(path, out=os.path.join(folder, scene), resume=True)
        compared = [scree.run(path, {"particles.lattice.count": count, "expect": []},
                              os.path.join(folder, f"{scene}, {name}"), resume=True) for name, count in others.items()]
        report(scene, run)
        picture(run, compared, os.path.join(HERE, scene + ".png"))


def main():
    given = scree.scripts.arguments(__doc__, 1, 2 + len(SCENES))
    scenes = given[2:] or list(SCENES)
    unknown = [scene for scene in scenes if scene not in SCENES]
    if unknown:
        raise scree.Error(f"{unknown[0]}: no scene of the gallery; give one of {', '.join(SCENES)}")
    os.environ["SCREE_PROGRAM"] = given[0]
    if len(given) > 1:
        draw(given[1], scenes)
        return
    with tempfile.TemporaryDirectory() as folder:
        draw(folder, scenes)


if __name__ == "__main__":
    main()
