#!/usr/bin/env bash
# A campaign on a real Slurm, disturbed at random: its table and the files of its runs are those of the campaign that runs here.
# Usage: campaign_test.sh PROGRAM [DISTURBANCES [SEED [LIBRARY]]], LIBRARY: the companion library that talks MPI or nothing.
# Skipped (status 77) where there is no slurmctld.
set -euo pipefail
program=$(realpath "$1") disturbances=${2:-20} seed=${3:-1} library=${4:-}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export PATH=$PATH:/usr/sbin:/sbin
for command in munged slurmctld slurmd sbatch; do
  command -v $command > /dev/null || { echo "skipped: $command is not installed"; exit 77; }
done
RANDOM=$seed
folder=$(mktemp -d)
chmod 711 "$folder"  # for munge
export SLURM_CONF=$folder/node/slurm.conf PORT=$((20000 + $$ % 20000 / 2 * 2)) CPUS=4 GRACE=10
stop() {
  "$here/one_node.sh" stop "$folder/node" > "$folder/stop.log" 2>&1 || true
  for k in {1..20}; do rm -rf "$folder" 2> /dev/null && break || sleep 0.2; done  # a daemon may still write its log
}
trap stop EXIT
cp "$here"/*.toml "$folder"
cd "$folder"
scree() { "$program" campaign campaign.toml "$@"; }
# The job that gathers may have the directory at this moment.
submit() {
  local k
  for k in {1..50}; do
    scree --out out --on slurm --partition low > submit.log 2>&1 && return
    grep -q 'another campaign is running there' submit.log || return 1
    sleep 0.2
  done
  return 1
}
fail() {
  echo "FAILED: $*"
  tail -n 20 submit.log out/tasks/*.txt node/slurmctld.log
  exit 1
}

# Numbers and commands of the processes of this campaign whose words match: "run out/", "campaign .*--task".
processes() {
  local process words
  for process in /proc/[0-9]*; do
    [[ $process/cwd -ef $folder && $process/exe -ef $program ]] || continue
    mapfile -d '' -t words < "$process/cmdline" || continue
    [[ " ${words[*]} " =~ $1 ]] && echo "${process#/proc/} ${words[*]}"
  done 2> processes.log
  return 0
}
elements() { squeue --noheader --array --name="$name" --states="$1" --format=%i; }
one_of() { shuf --random-source=<(yes $RANDOM) -n 1; }
# Slurm lets a job that was queued again wait for two minutes.
start_now() {
  local job
  for job in $(elements pending); do scontrol update JobId="$job" StartTime=now > update.log 2>&1 || true; done
}

preempt() {
  local job
  job=$(sbatch --parsable --partition=high --cpus-per-task=$CPUS --output=high.txt --wrap 'true')
  while [[ -n $(squeue --noheader --job="$job") ]]; do sleep 0.1; done
}
cancel() { elements running | grep _ | one_of | xargs -r scancel; }
warn() { elements running | grep _ | one_of | xargs -r scancel --signal=TERM; }  # as before the limit of time
requeue() { elements running | grep _ | one_of | xargs -r scontrol requeue; }
kill_run() { processes ' (run|resume) ' | cut -d ' ' -f 1 | one_of | xargs -r kill -KILL; }
kill_task() { processes ' campaign .*--task' | cut -d ' ' -f 1 | one_of | xargs -r kill -KILL; }
lose_node() {
  scontrol update NodeName="$(hostname -s)" State=DOWN Reason=test
  for k in {1..50}; do [[ -n $(processes ' (run|resume|campaign) ') ]] || break; sleep 0.1; done
  sleep 1
  repair
}
# Slurm holds a job back whose former copy was still there, and drains the node.
repair() {
  local job
  ! sinfo --noheader --format=%t | grep -qE 'down|drain' ||
    scontrol update NodeName="$(hostname -s)" State=RESUME > resume.log 2>&1 || true
  for job in $(squeue --noheader --array --name="$name" --format='%i %r' | sed -n 's/ .*held.*//p'); do scontrol release "$job"; done
}
kinds=(preempt cancel warn kill_run kill_task requeue preempt cancel kill_run lose_node)

# Runs with two processes. One that a run has started for a moment, to look at a plug-in, is that run.
runs_twice() {
  local all process words parent
  all=$(processes ' (run|resume) ')
  while read -r process words; do
    parent=$(sed -n 's/^PPid:[[:space:]]*//p' "/proc/$process/status" 2> gone.log) || continue
    grep -q "^$parent " <<< "$all" || grep -oE ' out/[^ ]*' <<< " $words"
  done <<< "$all" | sort | uniq -d
}

# No run has two processes, and one that has finished is not touched again.
declare -A finished
look() {
  local run hash twice
  twice=$(runs_twice) || true
  [[ -z $twice ]] || { sleep 0.3; twice=$(runs_twice) || true; }
  [[ -z $twice ]] || fail "two processes of $twice"
  for run in out/*seed=* out/prepare/*; do
    grep -qs '"status": "finished"' "$run/run.json" || continue
    hash=$(sha256sum < "$run/run.json")
    [[ ${finished[$run]:=$hash} == "$hash" ]] || fail "$run was run again"
  done
}

start=$(date +%s)
scree --out local --quiet > local.log 2>&1 || { cat local.log; exit 1; }
"$here/one_node.sh" start "$folder/node"
echo "local campaign and start of Slurm: $(($(date +%s) - start)) s"
submit || fail "not submitted"
name=$(sed -n 's/.*"name": "\(.*\)",/\1/p' out/tasks/jobs.json)
for ((done = 0; done < disturbances; ++done)); do
  until [[ -n $(processes ' (run|resume) ') ]]; do
    [[ -n $(elements pending,running,completing) ]] || break 2
    repair
    start_now
    sleep 0.1
  done
  sleep 0.$((RANDOM % 3 + 1))
  "${kinds[done % ${#kinds[@]}]}" > disturb.log 2>&1 || true
  look
  submit || fail "not submitted again"
done
echo "$done disturbances: $(($(date +%s) - start)) s"
((done >= disturbances / 2)) || fail "the campaign ended after $done disturbances"
deadline=$(($(date +%s) + 120))
until scree --out out --gather > gather.log 2>&1; do
  (($(date +%s) < deadline)) || { cat gather.log; squeue; fail "no end"; }
  repair
  start_now
  submit || fail "not submitted again"
  look
  sleep 0.5
done
look
echo "all gathered: $(($(date +%s) - start)) s"

# Without wall times, numbers of states that depend on them, and texts in quotes.
table() {
  awk -F , 'NR == 1 { for (k = 1; k <= NF; ++k) drop[k] = $k ~ /_s$|^states$|_per_second$/ }
    NR > 1 { gsub(/"[^"]*"/, "text") }
    { for (k = 1; k <= NF; ++k) if (!drop[k]) printf "%s,", $k; print "" }' "$1/table.csv"
}
table local > local.table
table out > out.table
diff local.table out.table || fail "another table"
(($(wc -l < out.table) == 13)) || fail "a table of $(wc -l < out.table) lines"
results() { (cd "$1" && find . -name '*.csv' -path '*/series/*' -exec sha256sum {} + | sort -k2); }
diff <(results local) <(results out) || fail "another series"
restarts=$(cat out/*seed=*/log.txt out/prepare/*/log.txt | grep -c 'goes on') || true
echo "same table and series; $restarts times a run went on from a state"

# Over the ranks that srun starts.
if ! srun --mpi=list 2>&1 | grep -q pmix || [[ -z $library ]]; then
  echo "not over ranks: no pmix in this Slurm, or a build without MPI"
  exit 0
fi
cat > ranked.toml <<TEXT
[campaign]
scenario = "fall.toml"
collect = ["energy.kinetic_translation.last"]
[set]
"contact.static_friction" = [0.3, 0.4]
TEXT
"$program" campaign ranked.toml --out ranked-local --quiet > local.log 2>&1 || fail "without ranks: $(< local.log)"
"$program" campaign ranked.toml --out ranked --on slurm --partition low --ranks 2 > submit.log 2>&1 || fail "not submitted over ranks"
deadline=$(($(date +%s) + 60))
until "$program" campaign ranked.toml --out ranked --gather > gather.log 2>&1; do
  (($(date +%s) < deadline)) || { cat gather.log; fail "no end over ranks"; }
  sleep 0.5
done
diff <(results ranked-local) <(results ranked) || fail "another series over ranks"
grep -q '"ranks": 2' ranked/*/run.json || fail "not over ranks"
echo "same series over ranks"
