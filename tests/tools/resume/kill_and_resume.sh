#!/usr/bin/env bash
# Kills runs with SIGKILL at random moments, resumes them, and compares every file with that of a run that was never
# stopped. Usage: kill_and_resume.sh PROGRAM [KILLS [SEED]]
set -euo pipefail
program=$(realpath "$1") kills=${2:-100} seed=${3:-1}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
RANDOM=$seed

# Scenes, with options of the run: every integrator, two threads, periodic axes.
cases=(
  "box --threads 2"
  "box --set time.integrator=position_verlet"
  "periodic --set time.integrator=position_verlet"
  "box --set time.integrator=predictor_corrector --set time.step=1e-5"
  "box --set time.integrator=fourth_order"
  "periodic --threads 2"
)

# The results of a run: all its files but states, the list of files, and what run.json and report.html say of times and
# threads.
results() {
  (cd "$1" && find . -type f ! -path './checkpoint/*' ! -name '*.h5' ! -name 'written.txt' ! -name '.lock' ! -name run.json ! -name report.html \
    -exec sha256sum {} + | sort -k2
   grep -v '"threads"\|_s"\|"states"\|per_second' run.json)
}

fail() {
  echo "FAILED: $*"
  exit 1
}

for k in "${!cases[@]}"; do
  read -ra words <<< "${cases[k]}"
  start=$(date +%s%N)
  "$program" run "$here/${words[0]}.toml" --out "whole-$k" --quiet "${words[@]:1}" > "whole-$k.log" || { cat "whole-$k.log"; exit 1; }
  milliseconds[k]=$((($(date +%s%N) - start) / 1000000))
  results "whole-$k" > "whole-$k.results"
done

same=0 again=0 writing=0
for ((n = 0; n < kills; ++n)); do
  k=$((n % ${#cases[@]}))
  read -ra words <<< "${cases[k]}"
  rm -rf killed
  "$program" run "$here/${words[0]}.toml" --out killed --quiet "${words[@]:1}" > killed.log 2>&1 &
  process=$!
  until [[ -e killed/run.json ]] || ! kill -0 $process 2> kill.log; do sleep 0.002; done
  sleep "$(awk -v ms="${milliseconds[k]}" -v r="$RANDOM" 'BEGIN { printf "%.4f", 1e-3 * ms * r / 32768 }')"
  kill -KILL $process 2> kill.log || true
  wait $process 2> wait.log || true
  if compgen -G 'killed/checkpoint/*.part' > partial.log; then writing=$((writing + 1)); fi
  # Killed once more while it goes on, at every third time.
  if ((n % 3 == 0)); then
    "$program" resume killed --overwrite --quiet > resume.log 2>&1 &
    process=$!
    sleep 0.3
    kill -KILL $process 2> kill.log || true
    wait $process 2> wait.log || true
  fi
  # On with other threads and, where the processor has several, another instruction level.
  status=0
  level=()
  ((n % 4)) || level=(SCREE_LEVEL=baseline)
  env "${level[@]}" "$program" resume killed --overwrite --quiet --threads $((1 + n % 2)) > resume.log 2>&1 || status=$?
  if ((status == 2)) && grep -q 'contains no run' resume.log; then
    # Killed before it wrote anything.
    again=$((again + 1))
    continue
  elif ((status == 2)) && grep -q 'has finished' resume.log; then
    :
  elif ((status != 0)); then
    cat resume.log
    fail "resume ended with status $status (kill $n, ${cases[k]})"
  fi
  results killed > killed.results
  cmp -s "whole-$k.results" killed.results || {
    diff "whole-$k.results" killed.results | head -20 || true
    fail "the results differ (kill $n, ${cases[k]})"
  }
  same=$((same + 1))
done
echo "$kills kills: $same runs went on to the same bytes, $again had not begun; $writing were killed while a state was written"
((same + again == kills && same > kills / 2))
