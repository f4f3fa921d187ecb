#!/usr/bin/env bash
# scree bench --ranks computes the same state with any number of processes. Skipped (status 77) where there is no mpirun.
# Usage: ranks_test.sh PROGRAM LIBRARY, the companion library that talks MPI or nothing.
set -u

program=$1 library=${2:-}
[[ -n $library ]] || { echo "skipped: built without MPI; install libopenmpi-dev and configure again"; exit 77; }
command -v mpirun > /dev/null || { echo "skipped: mpirun is not installed (openmpi-bin)"; exit 77; }
options=()
if mpirun --version | grep -q 'Open MPI'; then
  # More ranks than processors, which ranks that wait leave to the others.
  options=(--oversubscribe --bind-to none --mca mpi_yield_when_idle 1 --allow-run-as-root)
fi
failures=0
fail() { printf '%s\n' "$*"; failures=1; }

hash_of() { sed -n 's/^state hash \([0-9a-f]*\) .*/\1/p' <<< "$1"; }

# Beads with friction between walls at rest, and a box whose walls move under stress.
for scene in beads-4096 triaxial-3375; do
  call=(bench "$scene" --steps 150 --repeats 1)
  alone=$(hash_of "$("$program" "${call[@]}")")
  [[ $alone =~ ^[0-9a-f]{16}$ ]] || fail "$scene: no state hash in the output of one process"
  for ranks in 1 2 3; do
    output=$(timeout 200 mpirun "${options[@]}" -n "$ranks" "$program" "${call[@]}" --ranks --threads $((ranks % 2 + 1)) 2>&1)
    [[ $(hash_of "$output") == "$alone" ]] || fail "$scene, $ranks ranks: $output"
  done
done

output=$(timeout 60 mpirun "${options[@]}" -n 2 "$program" bench discs-16 --steps 10 2>&1)
status=$?
((status == 2)) && grep -q 'started several times by mpirun or srun; give --ranks' <<< "$output" ||
  fail "two processes without --ranks: status $status, $output"
output=$("$program" bench discs-16 --ranks 2>&1)
status=$?
((status == 2)) && grep -q '\-\-ranks needs --steps' <<< "$output" || fail "without --steps: status $status, $output"
exit $failures
