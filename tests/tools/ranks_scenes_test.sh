#!/usr/bin/env bash
# Shortened scenes of papers, examples, benchmarks and hard cases over 2 and 3 ranks: the files of one process. Skipped
# (status 77) where there is no mpirun.
# Usage: ranks_scenes_test.sh PROGRAM LIBRARY SOURCE, the companion library that talks MPI or nothing, and the source tree.
set -u

# shellcheck source=tests/tools/ranks/mpirun.sh
source "$(dirname "$0")/ranks/mpirun.sh"
scenarios=$3/scenarios
benchmarks=$3/tools/bench/scenes

# NAME SCENE KEY=VALUE...: runs the scene in one process, on 2 ranks, and on 3 ranks of 2 threads.
compare() {
  local name=$1 call=(run "$2" --quiet --set expect=[]) value
  for value in "${@:3}"; do call+=(--set "$value"); done
  "$program" "${call[@]}" --out "$folder/$name" > "$folder/log" 2>&1 ||
    fail "$name, one process: status $?, $(< "$folder/log")"
  for ranks in 2 3; do
    over $ranks "${call[@]}" --threads $((ranks - 1)) --out "$folder/$name-$ranks" > "$folder/log" 2>&1 ||
      fail "$name, $ranks ranks: status $?, $(< "$folder/log")"
    same_results "$name" "$name-$ranks" || fail "$name: $ranks ranks and one process have other results"
  done
}

# The golden scene with most bodies: beads with friction between walls at rest.
compare beads "$benchmarks/beads-4096.toml" time.duration=2e-4
# David et al. (2005): walls that stress moves close a box, and press on its packing.
compare closing "$benchmarks/triaxial-3375-closing.toml" time.duration=4e-3 probe.walls.every=1e-3 probe.contacts.every=1e-3
compare triaxial "$benchmarks/triaxial-3375.toml" time.duration=3e-3 time.energy_audit=true
# Lemrich et al. (2017): periodic, with a wall under stress, by servo and at rest, and probes of contacts.
compare beads-4032 "$scenarios/lemrich2017/prepare.toml" snapshot={} probe.contacts.every=1e-5 probe.walls.every=1e-5 \
  stage.{close,calm,shake,rest}.duration=3e-5
# Two groups that are held along some axes, massless walls and stages that end by what probes find.
compare platens "$scenarios/examples/triaxial.toml" snapshot={} stage.compact.until.at_most=2e-4 \
  stage.compact.until.otherwise=\"go_on\" stage.consolidate.until.at_least=0 stage.consolidate.until.at_most=2e-4 \
  stage.shear.until.at_most=2e-4 stage.shear.until.otherwise=\"go_on\"
# A gas with a search every few steps.
compare gas "$benchmarks/gas.toml" time.duration=4e-4
# Hard cases have one tile of bodies, and other ranks none.
compare size-ratio "$scenarios/hard-cases/size-ratio-100.toml"
compare rattlers "$scenarios/hard-cases/rattlers.toml" time.duration=1e-3
exit $failures
