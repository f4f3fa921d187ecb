"""Write pack4096.txt, repeated REP x REP in x and z, as a LAMMPS/LIGGGHTS data file: make_data.py REP STYLE OUT"""
import pathlib, sys
rep, style, out = int(sys.argv[1]), sys.argv[2], sys.argv[3]
lines = (pathlib.Path(__file__).parent / "scenes" / "pack4096.txt").read_text().splitlines()
_, L, H = (float(v) for v in lines[0].split())
rows = [tuple(map(float, l.split())) for l in lines[1:] if l]
beads = [(x + a * L, y, z + b * L, r) for a in range(rep) for b in range(rep) for x, y, z, r in rows]
with open(out, "w") as f:
    f.write(f"packing\n\n{len(beads)} atoms\n1 atom types\n\n0 {L*rep:.17g} xlo xhi\n-0.001 {H+0.001:.17g} ylo yhi\n0 {L*rep:.17g} zlo zhi\n\n{style}\n\n")
    f.writelines(f"{i} 1 {2*r:.17g} 2500 {x:.17g} {y:.17g} {z:.17g}\n" for i, (x, y, z, r) in enumerate(beads, 1))
