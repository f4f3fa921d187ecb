# For scripts that run scenes over the processes of mpirun, and source this: PROGRAM LIBRARY, the companion library that
# talks MPI or nothing. Ends the script with status 77, which CTest takes as skipped, where there is no mpirun.
# shellcheck shell=bash

program=$1 library=${2:-}
[[ -n $library ]] || { echo "skipped: built without MPI; install libopenmpi-dev and configure again"; exit 77; }
command -v mpirun > /dev/null || { echo "skipped: mpirun is not installed (openmpi-bin)"; exit 77; }
options=()
if mpirun --version | grep -q 'Open MPI'; then
  # More ranks than processors, which ranks that wait leave to the others.
  options=(--oversubscribe --bind-to none --mca mpi_yield_when_idle 1 --allow-run-as-root)
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
# shellcheck disable=SC2034  # the exit status of the script
fail() { printf '%s\n' "$*"; failures=1; }

over() { timeout 200 mpirun "${options[@]}" -n "$1" "$program" "${@:2}" --ranks; }
# Whether two runs have written the same files, but for those with times and paths of the machine.
same_results() { diff -rq -x run.json -x report.html -x written.txt -x checkpoint "$folder/$1" "$folder/$2"; }
