#!/bin/sh
# The reports of a run, a campaign, a spectrum and an accuracy study, opened in a browser: they have their sections, they are
# not blank, and they cause no error. Status 77 where Chromium is not installed (Debian: chromium).
# Usage: report_page_test.sh PROGRAM SOURCE
set -eu
program=$1 source=$2
command -v chromium > /dev/null || { echo "Chromium is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# browse PAGE OPTION...
browse() {
  page=$1
  shift
  HOME=$folder timeout 120 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$folder/browser" \
    --window-size=1200,3000 --enable-logging=stderr "$@" "file://$folder/$page" 2> browser.log
}

# Whether a page has each of these texts once a browser has read it.
has() {
  page=$1
  shift
  browse "$page" --dump-dom > dom.html || { tail -5 browser.log; echo "$page is not opened"; exit 1; }
  if grep -q ':CONSOLE' browser.log; then grep ':CONSOLE' browser.log; echo "$page has an error"; exit 1; fi
  for text; do
    grep -qF "$text" dom.html || { echo "$page has no '$text'"; exit 1; }
  done
}

# Whether the picture of a page is none of one colour: those are below 20 kB.
is_drawn() {
  browse "$1" --screenshot="$folder/page.png" > log || { tail -5 browser.log; exit 1; }
  test "$(wc -c < page.png)" -gt 60000 || { echo "the picture of $1 is blank"; exit 1; }
}

cat > fall.toml <<'TEXT'
[scene]
title = "Beads that fall <b>"
[time]
step = { fraction = 0.02 }
[particles]
lattice = { kind = "simple_cubic", count = [3, 3, 3], displacement = 0.0005 }
radius = 0.0025
[[material]]
name = "glass"
density = 2500
[[contact]]
plugin = "linear_spring_dashpot"
normal_stiffness = 5000
restitution = 0.7
[[boundary]]
plugin = "box"
gap = 0.001
x = "fixed"
y = "fixed"
z = "fixed"
[[body_force]]
plugin = "gravity"
acceleration = [0, 0, -9.81]
[[stage]]
name = "settle"
duration = 0.05
[[probe]]
plugin = "energy"
every = 0.001
[[chart]]
name = "energies"
probe = "energy"
y = ["kinetic_translation", "elastic_normal"]
[[expect]]
requirement = "the energy balance closes"
quantity = "energy_residual"
at_most = 0.1
TEXT
cat > campaign.toml <<'TEXT'
[campaign]
title = "Restitution of beads"
scenario = "fall.toml"
seeds = [1, 2, 3]
collect = ["energy.kinetic_translation.last"]
[set]
"contact.restitution" = [0.3, 0.6, 0.9]
TEXT
study() {
  "$program" "$@" --quiet > log 2>&1 || { cat log; exit 1; }
}
study run fall.toml --out run
study campaign campaign.toml --out campaign
study spectrum "$source/scenarios/sound/chain.toml" --by pulse --out spectrum
study accuracy "$source/scenarios/verification/restitution-linear.toml" --tolerance 1e-3 --out accuracy

has run/report.html '<h1>Beads that fall &lt;b&gt;</h1>' 'The run finished.' 'Its expectation is met.' '<h2>Stages</h2>' \
  '<h2>Charts</h2>' '<svg' '<h2>Balances</h2>' '<h2>Speed</h2>' '<h2>How to repeat it</h2>' '</footer>'
has campaign/report.html 'All 9 runs finished.' '<svg' 'Means over the seeds, with standard errors' \
  'restitution=0.3,seed=1/report.html' '</footer>'
has spectrum/report.html 'The spectrum finished.' '<svg' '<h2>Peaks</h2>' '<h2>Methods</h2>' '</footer>'
has accuracy/report.html 'The accuracy study finished.' '<svg' '<h2>Orders</h2>' '<h2>References</h2>' '</footer>'
for page in run campaign spectrum accuracy; do is_drawn $page/report.html; done

# The names of the parts of charts are unique on a page, and each that is used is there.
for page in run campaign spectrum accuracy; do
  twice=$(grep -o ' id="[^"]*"' $page/report.html | sort | uniq -d)
  test -z "$twice" || { echo "$page: $twice"; exit 1; }
done
echo "four pages opened by $(chromium --version 2> log)"
