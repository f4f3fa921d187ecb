#!/bin/sh
# LAMMPS and ASE read what scree exports, to the bit. Status 77 where neither is installed (Debian: lammps, python3-ase).
# Usage: exports_test.sh PROGRAM
set -eu
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
tried=no

cat > scene.toml <<'TEXT'
time = { step = { fraction = 0.05 }, duration = 0.03 }
particles = { lattice = { kind = "simple_cubic", count = [4, 4, 4] }, radius = { distribution = "uniform", minimum = 0.002, maximum = 0.003 } }
material = [{ name = "glass", density = 2500 }]
contact = [{ plugin = "linear_spring_dashpot", normal_stiffness = 5000, restitution = 0.7 }]
boundary = [{ plugin = "box", gap = 0.002, x = "fixed", y = "fixed", z = "fixed" }]
body_force = [{ plugin = "gravity", acceleration = [0, 0, -9.81] }]
snapshot = { every = 0.01 }
TEXT
"$program" run scene.toml --out run --quiet > run.log 2>&1 || { cat run.log; exit 1; }
"$program" export run --format csv --out run.csv > export.log
for format in lammps-data lammps-dump xyz; do "$program" export run --format $format --out run.$format >> export.log; done
# x, y, z of the bodies by id, in as many digits as a double has.
awk -F, '!/^#/ && $1 != "id" { printf "%d %.17g %.17g %.17g %.17g\n", $1, $3, $4, $5, $6 }' run.csv | sort -n > expected

# compare FILE WHAT: positions and radii equal those of the table.
compare() {
  sort -n "$1" | cmp - expected || { echo "$2 differs"; exit 1; }
}

if command -v lmp > /dev/null; then
  tried=yes
  cat > in.lmp <<'TEXT'
units si
atom_style sphere
boundary f f f
read_data run.lammps-data
dump d all custom 1 back.dump id x y z radius
dump_modify d format float %.17g sort id
run 0
TEXT
  lmp -in in.lmp > lammps.log 2>&1 || { tail -5 lammps.log; exit 1; }
  sed '1,/ITEM: ATOMS/d' back.dump | awk '{ printf "%d %.17g %.17g %.17g %.17g\n", $1, $2, $3, $4, $5 }' > data
  compare data "what LAMMPS reads of run.lammps-data"
  step=$(awk 'last == "ITEM: TIMESTEP" { step = $0 } { last = $0 } END { print step }' run.lammps-dump)
  sed -e 's/^dump d.*/read_dump run.lammps-dump '"$step"' x y z vx vy vz box yes replace yes\n&/' in.lmp > in2.lmp
  lmp -in in2.lmp > lammps.log 2>&1 || { tail -5 lammps.log; exit 1; }
  sed '1,/ITEM: ATOMS/d' back.dump | awk '{ printf "%d %.17g %.17g %.17g %.17g\n", $1, $2, $3, $4, $5 }' > dump
  compare dump "what LAMMPS reads of run.lammps-dump"
fi

if /usr/bin/python3 -c 'import ase' 2> /dev/null; then
  tried=yes
  /usr/bin/python3 - > ase <<'TEXT'
from ase.io import read
frames = read("run.xyz", index=":", format="extxyz")
assert len(frames) > 2
last = frames[-1]
for i, x, r in zip(last.arrays["id"], last.positions, last.arrays["radius"]):
    print("%d %.17g %.17g %.17g %.17g" % (i, *x, r))
TEXT
  compare ase "what ASE reads of run.xyz"
fi
[ $tried = yes ] || { echo "neither LAMMPS nor ASE is installed"; exit 77; }
