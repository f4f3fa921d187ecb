#!/usr/bin/env bash
# One scene over the processes that mpirun starts: bytes of results, runs that are killed or stopped, errors. Skipped (status
# 77) where there is no mpirun.
# Usage: ranks_test.sh PROGRAM LIBRARY, the companion library that talks MPI or nothing.
set -u

# shellcheck source=tests/tools/ranks/mpirun.sh
source "$(dirname "$0")/ranks/mpirun.sh"
box=$(dirname "$0")/ranks/box.toml
hash_of() { sed -n 's/^state hash \([0-9a-f]*\) .*/\1/p' <<< "$1"; }
# Numbers of the ranks of a run, the last one last.
ranks_of() {
  local process words
  for process in /proc/[0-9]*; do
    [[ $process/exe -ef $program ]] || continue
    mapfile -d '' -t words < "$process/cmdline" && [[ " ${words[*]} " == *" --out $folder/$1 "* ]] && echo "${process#/proc/}"
  done 2> /dev/null | sort -n
}
# Waits until a run has so many lines of energy.
wait_for_lines() {
  for ((k = 0; k < 2400; ++k)); do
    [[ -e $folder/$1/series/energy.csv ]] && (($(wc -l < "$folder/$1/series/energy.csv") >= $2)) && break
    sleep 0.1
  done
}
# Sends a signal to the last of two ranks of a run that has so many lines.
signal_last_rank() {
  wait_for_lines "$1" "$2"
  kill "-$3" "$(ranks_of "$1" | tail -1)"
}
# mpirun may end before the ranks that it kills, and these keep their lock for a moment.
wait_for_ranks() {
  wait "$1"
  for ((k = 0; k < 300; ++k)); do
    [[ -n $(ranks_of "$2") ]] || { sleep 1; return 0; }
    sleep 0.1
  done
}

# Beads with friction between walls at rest.
call=(bench beads-4096 --steps 150 --repeats 1)
alone=$(hash_of "$("$program" "${call[@]}")")
[[ $alone =~ ^[0-9a-f]{16}$ ]] || fail "no state hash in the output of one process"
for ranks in 1 3; do
  output=$(over "$ranks" "${call[@]}" --threads $((ranks % 2 + 1)) 2>&1)
  [[ $(hash_of "$output") == "$alone" ]] || fail "$ranks ranks: $output"
done

# Of many tiles, which METIS deals where the library is linked to it.
call=(bench beads-102400 --steps 2 --repeats 1)
alone=$(hash_of "$("$program" "${call[@]}")")
output=$(over 3 "${call[@]}" 2>&1)
[[ $(hash_of "$output") == "$alone" ]] || fail "3 ranks, not $alone: $output"
dealt='tiles dealt in ranges'
ldd "$library" | grep -q libmetis && dealt='tiles dealt by METIS'
grep -q "$dealt" <<< "$output" || fail "not $dealt: $output"

# A box whose walls move under stress, in stages, with probes and pictures.
short=(--quiet --set stage.prepare.until.at_least=0.01 --set stage.prepare.until.at_most=0.03)
"$program" run "$box" --out "$folder/alone" "${short[@]}" || fail "one process: status $?"
over 3 run "$box" --out "$folder/three" "${short[@]}" > "$folder/log" 2>&1 || fail "3 ranks: $(< "$folder/log")"
same_results alone three || fail "three ranks and one process have other results"

# Stopped by a signal to one rank, or killed, they go on with another number of ranks.
over 2 run "$box" --out "$folder/stopped" "${short[@]}" > "$folder/log" 2>&1 &
signal_last_rank stopped 3 USR1
wait_for_ranks $! stopped
grep -q '"status": "interrupted"' "$folder/stopped/run.json" || fail "not interrupted by SIGUSR1: $(< "$folder/log")"
over 3 resume "$folder/stopped" --quiet > "$folder/log" 2>&1 || fail "stopped, on 3 ranks: $(< "$folder/log")"
same_results alone stopped || fail "a run that was stopped and went on has other results"
over 2 run "$box" --out "$folder/killed" "${short[@]}" > "$folder/log" 2>&1 &
signal_last_rank killed 4 KILL
wait_for_ranks $! killed
"$program" resume "$folder/killed" --overwrite --quiet || fail "killed, in one process: status $?"
same_results alone killed || fail "a run that was killed and went on has other results"

# A campaign that is stopped saves its runs within seconds, and goes on with another number of ranks.
cat > "$folder/campaign.toml" <<TEXT
[campaign]
scenario = "$(realpath "$box")"
collect = ["energy.kinetic_translation.last"]
[set]
"stage.prepare.until.at_least" = [0.01]
"stage.prepare.until.at_most" = [0.03]
TEXT
campaign=("$program" campaign "$folder/campaign.toml" --out "$folder/sweep" --quiet)
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1
point=at_least=0.01,at_most=0.03
"${campaign[@]}" --ranks 2 > "$folder/log" 2>&1 &
wait_for_lines "sweep/$point" 3
SECONDS=0
kill -TERM $!
wait $!
((SECONDS < 60)) || fail "a campaign took $SECONDS s to stop"
grep -q '"status": "interrupted"' "$folder/sweep/$point/run.json" || fail "not interrupted: $(< "$folder/log")"
"${campaign[@]}" --ranks 3 > "$folder/log" 2>&1 || fail "a campaign that goes on: $(< "$folder/log")"
same_results "sweep/$point/series" alone/series || fail "a campaign over ranks has other results"

# Errors: one line, and the status of one process.
output=$(over 2 run "$box" --out "$folder/unstable" --quiet --set limits.overlap_ratio=0.001 2>&1)
status=$?
((status == 3)) && (($(grep -c '^scree: ' <<< "$output") == 1)) && grep -q 'above the limit' <<< "$output" ||
  fail "a limit that is exceeded: status $status, $output"
output=$(over 2 run "$box" --out "$folder/bad" --set time.stp=1 2>&1)
status=$?
((status == 2)) && (($(grep -c '^scree: ' <<< "$output") == 1)) && [[ ! -e $folder/bad ]] ||
  fail "an unknown key: status $status, $output"
for wrong in "--threads 0" "--plugins $folder/nowhere"; do
  # shellcheck disable=SC2086  # two words
  output=$(over 3 run "$box" --out "$folder/bad" $wrong 2>&1)
  status=$?
  ((status == 2)) && (($(grep -c '^scree: ' <<< "$output") == 1)) || fail "$wrong: status $status, $output"
done
output=$(timeout 60 mpirun "${options[@]}" -n 2 "$program" bench discs-16 --steps 10 2>&1)
status=$?
((status == 2)) && (($(grep -c 'give --ranks' <<< "$output") == 1)) ||
  fail "two processes without --ranks: status $status, $output"
# As started by mpirun of another MPI.
output=$(PMI_SIZE=2 PMI_RANK=0 "$program" run "$box" --out "$folder/other" --ranks 2>&1)
status=$?
((status == 2)) && grep -q 'do not find each other' <<< "$output" && [[ ! -e $folder/other ]] ||
  fail "mpirun of another MPI: status $status, $output"
exit $failures
