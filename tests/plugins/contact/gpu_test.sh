#!/bin/sh
# Compiles every contact law for a GPU, one pair per thread (pair_per_thread.cpp). Its kernels have no call, no branch but the
# bound of the index, and fma instructions for `fused`. Status 77 where there is no clang++ for nvptx64.
# Usage: gpu_test.sh SOURCE
set -eu
source=$1
clang++ --print-targets 2> /dev/null | grep -q nvptx64 ||
  { echo "no clang++ that compiles for nvptx64 is installed (Debian: clang)"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# compile LAW: its PTX. The preprocessor runs for the host, because there are no C++ headers for nvptx64. The threshold makes
# clang inline all that the kernel calls, as GCC does for `flatten`, which in clang ends one call deep.
compile() {
  clang++ -E -std=c++20 -I "$source/framework/include" -DSCREE_LAW="\"$1\"" \
    "$source/tests/plugins/contact/pair_per_thread.cpp" |
    clang++ -x c++-cpp-output -std=c++20 --target=nvptx64-nvidia-cuda -march=sm_70 -O3 \
      -ffp-contract=off -fno-math-errno -mllvm -inline-threshold=100000 -S -o - -
}

# judge LAW: reads PTX and prints the kernels that are wrong. PTX names a called function in the line after `call`.
judge() {
  awk -v law="$1" '
    /\.func.*evaluate_pair/ { sub(/\(.*/, "", $NF); kernel = $NF; kernels[kernel] }
    after_call { sub(/,/, "", $1); calls[kernel] = calls[kernel] " " $1 }
    { instruction = $1 ~ /^@/ ? $2 : $1; after_call = instruction ~ /^call/ }
    instruction ~ /^brx?[.a]/ { ++branches[kernel] }
    instruction ~ /^fma/ { ++fused[kernel] }
    END {
      for (k in kernels) {
        ++number
        if (branches[k] == 1 && fused[k] && !(k in calls)) continue
        ++wrong
        print law ": branches besides the bound: " branches[k] - 1 "; calls:" calls[k] "; fma: " fused[k] + 0 "; in " k
      }
      print law ": kernels: " number + 0 ", wrong: " wrong + 0
      exit !number || wrong
    }'
}

failed=0
for law in "$source"/plugins/contact/*.cpp; do
  name=$(basename "$law" .cpp)
  compile "$law" > "$folder/ptx" 2> "$folder/errors" ||
    { echo "$name: does not compile for a GPU:"; head -3 "$folder/errors"; failed=1; continue; }
  judge "$name" < "$folder/ptx" > "$folder/verdict" || failed=1
  c++filt -p < "$folder/verdict"
done
exit $failed
