#!/bin/sh
# A run goes on with the tangential springs of a run of LAMMPS. Status 77 where it is not installed (Debian: lammps).
# Usage: springs_test.sh PROGRAM
set -eu
program=$1
command -v lmp > /dev/null || { echo "LAMMPS is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# 64 spheres in their impacts, of which LAMMPS takes 150 and again 150 steps.
cat > in.lmp <<'TEXT'
units si
atom_style sphere
boundary f f f
comm_modify vel yes
newton off
region box block -0.01 0.05 -0.01 0.05 -0.01 0.05 units box
create_box 1 box
lattice sc 0.0098
region fill block 0 0.039 0 0.039 0 0.039 units box
create_atoms 1 region fill
set group all diameter 0.01 density 2500
variable vx atom 0.3*sin(700*x+1900*y+311*z)
variable vy atom 0.3*sin(1700*x-900*y+511*z)
variable vz atom 0.3*cos(900*x+400*y-1311*z)
velocity all set v_vx v_vy v_vz
pair_style gran/hooke/history 1e4 2500 0 0 0.5 0
pair_coeff * *
timestep 2e-6
fix 1 all nve/sphere
compute ids all property/local patom1 patom2
compute pairs all pair/local p1 p2 p3
dump pairs all local 150 pairs.dump c_ids[1] c_ids[2] c_pairs[1] c_pairs[2] c_pairs[3]
dump_modify pairs format float %.17g
dump bodies all custom 150 bodies.dump id x y z vx vy vz omegax omegay omegaz radius
dump_modify bodies format float %.17g sort id
run 300
TEXT
lmp -in in.lmp > lammps.log 2>&1 || { tail -5 lammps.log; exit 1; }

# p1, p2, p3 are the tangential force on the first body.
cat > scene.toml <<'TEXT'
time = { step = 2e-6, duration = 3e-4 }
material = [{ name = "glass", density = 2500 }]
contact = [{ plugin = "linear_spring_dashpot", normal_stiffness = 1e4, tangential_stiffness = 2500, static_friction = 0.5, normal_damping = 0 }]
[particles]
file = "bodies.dump"
timestep = 150
[particles.springs]
file = "pairs.dump"
columns = ["a", "b", "spring_x", "spring_y", "spring_z"]
factor = -4e-4
TEXT
"$program" run scene.toml --out with > with.log 2>&1 || { cat with.log; exit 1; }
grep -q 'taken over: springs of ' with.log || { cat with.log; exit 1; }
sed '/particles.springs/,$d' scene.toml > without.toml
"$program" run without.toml --out without > without.log 2>&1 || { cat without.log; exit 1; }

# error DIR: largest difference of a spin from LAMMPS at the end, over the largest spin.
error() {
  awk -F '[ ,]' -v columns="$(grep -v '^#' "$1/final_packing.csv" | head -1)" '
    BEGIN { n = split(columns, names, ","); for (k = 1; k <= n; ++k) { sub(/ .*/, "", names[k]); at[names[k]] = k } }
    FNR == NR { if ($1 == "ITEM:") { atoms = $2 == "ATOMS"; frame += $2 == "TIMESTEP" } else if (atoms && frame == 3) for (k = 1; k <= 3; ++k) spin[$1, k] = $(7 + k); next }
    /^#/ || $1 == "id" { next }
    { for (k = 1; k <= 3; ++k) { mine = $(at["spin_" substr("xyz", k, 1)]); d = mine - spin[$at["id"], k]; if (d < 0) d = -d
        if (d > worst) worst = d; m = mine < 0 ? -mine : mine; if (m > most) most = m } }
    END { printf "%.3g\n", worst / most }' bodies.dump "$1/final_packing.csv"
}
with=$(error with) without=$(error without)
echo "difference from LAMMPS: $with with its springs, $without without"
# Forces act at R in LAMMPS and at R - δ/2 in scree, with overlaps δ up to 2 % of R: 1 %. Without springs all is lost.
awk -v a="$with" -v b="$without" 'BEGIN { exit !(a < 0.02 && b > 10 * a) }'
