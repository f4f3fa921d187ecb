#!/bin/sh
# YADE reads what scree exports, to the bit, and scree reads what YADE exports, which has six digits. Status 77 where YADE is
# not installed (Debian: yade).
# Usage: yade_test.sh PROGRAM
set -eu
program=$1
command -v yade > /dev/null || { echo "YADE is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# scene FILE: that begins with the bodies of a file and moves them by less than 1e-12 m.
scene() {
  cat <<TEXT
time = { step = 1e-9, duration = 1e-9 }
particles = { $1 }
material = [{ name = "glass", density = 2500 }]
contact = [{ plugin = "linear_spring_dashpot", normal_stiffness = 5000, normal_damping = 0 }]
TEXT
}
scene 'lattice = { kind = "simple_cubic", count = [3, 3, 3], displacement = 0.0005 }, radius = { distribution = "uniform", minimum = 0.002, maximum = 0.003 }' > first.toml
"$program" run first.toml --out first --quiet > log 2>&1 || { cat log; exit 1; }
"$program" export first --format yade --out first.txt > log

cat > read.py <<'TEXT'
import os
from yade import export, ymport
O.bodies.append(ymport.text("first.txt"))
with open("read", "w") as table:
    for b in O.bodies:
        table.write("%.17g %.17g %.17g %.17g\n" % (*b.state.pos, b.shape.radius))
export.text("text.txt")
export.textExt("textExt.txt", format="x_y_z_r_matId")
os._exit(0)
TEXT
HOME=$folder yade -n -x read.py > yade.log 2>&1 < /dev/null || { tail -5 yade.log; exit 1; }

# x, y, z and radius of a run by id, in as many digits as a double has.
bodies() {
  "$program" export "$1" --format csv --out "$1.csv" > log
  awk -F, '!/^#/ && $1 != "id" { printf "%d %.17g %.17g %.17g %.17g\n", $1, $3, $4, $5, $6 }' "$1.csv" | sort -n | cut -d' ' -f2-
}
bodies first > expected
cmp read expected || { echo "what YADE reads of first.txt differs"; exit 1; }

for table in text textExt; do
  scene "file = \"$table.txt\"" > $table.toml
  "$program" run $table.toml --out $table --quiet > log 2>&1 || { cat log; exit 1; }
  bodies $table > back
  # Six digits of lengths below 0.1 m, half a unit of the last one.
  paste -d' ' expected back | awk '{ for (k = 1; k <= 4; ++k) if (($k - $(k + 4)) ^ 2 > 5.1e-8 ^ 2) bad = 1 } END { exit bad || NR != 27 }' ||
    { echo "what scree reads of $table.txt differs"; exit 1; }
done
