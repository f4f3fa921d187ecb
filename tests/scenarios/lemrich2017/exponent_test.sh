#!/bin/sh
# exponent_test.sh PYTHON SOURCE: numbers and refusals of scenarios/lemrich2017/exponent.py, from tables as a campaign writes them.
set -eu
python=$1 script=$2/scenarios/lemrich2017/exponent.py
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"

# peaks RUN FACTOR: λ/4, 3λ/4 and 5λ/4 of a run at FACTOR times 100, 300 and 500 Hz.
peaks() {
  mkdir -p "$1"
  echo 'road,column,frequency [Hz],frequency_error [Hz],quality,amplitude,wavelengths' > "$1/peaks.csv"
  for wavelengths in 0.25 0.75 1.25; do
    echo "linear,strain,$(awk "BEGIN { print $2 * 400 * $wavelengths }"),1,10,5,$wavelengths"
  done >> "$1/peaks.csv"
}
# expect STATUS TEXT: of the script, which prints TEXT in one of its lines and no traceback.
expect() {
  status=0
  "$python" "$script" . > out.txt 2>&1 || status=$?
  if [ $status -ne "$1" ] || ! grep -qF "$2" out.txt || grep -q Traceback out.txt; then
    echo "expected status $1 and '$2', found status $status and:" && cat out.txt && exit 1
  fi
}

expect 1 "no finished run of a campaign; run scree campaign"
printf 'run,seed,status\na,1,finished\n' > table.csv
expect 1 "there is no column 'boundary.bottom.stress'; give the folder of a campaign that varies it"
: > table.csv
expect 1 "no finished run of a campaign"
peaks a 1 && peaks b 2 && peaks c 1
printf 'run,boundary.bottom.stress [Pa],seed,status\na,1e4,1,finished\nb,16e4,1,failed\nc,1e4,2,finished\n' > table.csv
expect 1 "no exponent from one stress, of seed 1, 2; let the campaign finish two or more"
# Twice the frequency at 16 times the stress: the exponent is 1/4.
printf 'run,boundary.bottom.stress [Pa],seed,status\na,1e4,1,finished\nb,16e4,1,finished\n' > table.csv
expect 0 "3λ/4: f ∝ σ^n, n = 0.2500 ± nan (seeds: 0.2500)"
