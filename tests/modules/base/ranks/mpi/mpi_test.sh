#!/usr/bin/env bash
# What processes that mpirun starts send to one another, and how they end.
# Usage: mpi_test.sh PROGRAM RANKS [SEED]. Skipped (status 77) where there is no mpirun.
set -u

program=$1 ranks=$2 seed=${3:-1}
[[ -n $program ]] || { echo "skipped: built without MPI; install libopenmpi-dev and configure again"; exit 77; }
command -v mpirun > /dev/null || { echo "skipped: mpirun is not installed (openmpi-bin)"; exit 77; }

options=()
if mpirun --version | grep -q 'Open MPI'; then
  # More ranks than processors, which ranks that wait leave to the others.
  options=(--oversubscribe --bind-to none --mca mpi_yield_when_idle 1 --allow-run-as-root)
fi
failures=0

# start <seconds> <what>: output and exit status of the ranks.
start() {
  what=$2
  output=$(timeout --kill-after 10 "$1" mpirun "${options[@]}" -n "$ranks" "$program" "$2" "$ranks" "$seed" 2>&1)
  status=$?
}
# expect <exit status> <pattern of a line of the output>
expect() {
  ((status == $1)) && grep -qE "$2" <<< "$output" && return
  printf '%s\n%s: status %s, not %s, or no line with "%s"\n' "$output" "$what" "$status" "$1" "$2"
  failures=1
}

for what in messages long-messages pieces partition; do
  start 200 "$what"
  expect 0 ' 0 failures'
done
start 60 nothing
expect 0 ''

# A failure of all ranks, of which mpirun may end some before they say so.
start 60 failure-of-all
expect 3 '^rank [0-9]+ fails$'
start 60 joined-twice
expect 1 '^MPI: is joined a second time; join it once$'
# A message under way when a rank fails: the process ends all the same.
start 60 failure-between
expect 3 '^rank [0-9]+ fails$'
# A failure of one rank ends the others, which wait for it.
start 60 failure-of-one
expect 3 "^rank $((ranks - 1)) fails$"
# Errors of MPI are one line. A message of a rank to itself is cut off without an error.
if ((ranks > 1)); then
  start 60 too-much
  expect 1 '^MPI: cannot send or receive a message \(MPI_ERR_TRUNCATE.*\); see what mpirun has written about it$'
fi
exit $failures
