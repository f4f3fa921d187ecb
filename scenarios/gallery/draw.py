"""Runs the scenes of this folder and writes the picture of each beside it.

Usage: python3 scenarios/gallery/draw.py PROGRAM [FOLDER for the runs, default: one that is removed] [SCENE...]
       python3 scenarios/gallery/draw.py build/release/bin/scree runs/gallery silo
Needs python3-matplotlib. A run that is already in the folder is not repeated."""
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
sys.path.insert(0, HERE)
import curves  # noqa: E402 (beside this file, like the next)
import grains  # noqa: E402
from tables import arguments, made, refuse  # noqa: E402 (of the folder above)

# The picture of each scene, and further runs of it with other numbers of bodies, which the picture compares.
SCENES = {
    "angle-of-repose": (grains.angle_of_repose, {}),
    "piston": (curves.piston, {}),
    "bouncing-ball": (curves.bouncing_ball, {}),
    "gas-that-cools": (curves.gas_that_cools, {}),
    "brazil-nut": (grains.brazil_nut, {}),
    "silo": (grains.silo, {f"rows {n}": f"particles.lattice.count=[11,{n}]" for n in (5, 10, 20, 40)}),
    "column-collapse": (grains.column_collapse,
                        {f"rows {n}": f"particles.lattice.count=[16,{n}]" for n in (9, 18, 54)}),
    "wave-in-a-chain": (curves.wave_in_a_chain, {}),
}


def run(program, scene, out, *words):
    """Runs a scene unless it has been run; ends the script with one line if it fails, or misses a condition."""
    if os.path.exists(os.path.join(out, "final_packing.csv")):
        return
    path = os.path.join(HERE, scene + ".toml")
    called = [program, "run", path, "--out", out, "--quiet", *words]
    done = subprocess.run(called, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        refuse(f"{path}: exit status {done.returncode}: {done.stderr.strip()}")


def report(scene, out):
    """Prints each condition of a run with its value."""
    with open(os.path.join(out, "run.json"), encoding="utf-8") as file:
        record = json.load(file)
    print(f"{scene}: {record['wall_s']:.0f} s")
    for c in record["expect"]:
        wanted = f"{c['reference']:.5g} ± {c['tolerance']:.2g}" if "reference" in c else ", ".join(
            f"{sign} {c[key]:.5g}" for key, sign in (("at_least", "≥"), ("at_most", "≤")) if key in c)
        print(f"  {c['requirement']}: {c['value']:.5g}, expected {wanted}")


def draw(program, folder, scenes):
    for scene in scenes:
        picture, others = SCENES[scene]
        out = os.path.join(folder, scene)
        run(program, scene, out)
        for name, change in others.items():
            # The conditions of the file hold for its own number of bodies.
            run(program, scene, os.path.join(folder, f"{scene}, {name}"), "--set", change, "--set", "expect=[]")
        report(scene, out)
        picture(out, [os.path.join(folder, f"{scene}, {name}") for name in others], os.path.join(HERE, scene + ".png"))


def main():
    given = arguments(__doc__, 1, 2 + len(SCENES))
    program, scenes = given[0], given[2:] or list(SCENES)
    unknown = [scene for scene in scenes if scene not in SCENES]
    if unknown:
        refuse(f"{unknown[0]}: no scene of the gallery; give one of {', '.join(SCENES)}")
    if len(given) > 1:
        draw(program, made(given[1]), scenes)
        return
    with tempfile.TemporaryDirectory() as folder:
        draw(program, folder, scenes)


if __name__ == "__main__":
    main()
