#!/bin/sh
# In a build tree without the library of the studies, a study builds it first and says so; if the build fails, one line says
# that. Help, and options that are refused, need no library. Usage: studies_on_demand_test.sh BUILD_DIRECTORY
set -eu
build=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree/bin" "$tree/lib"
cp "$build/bin/scree" "$tree/bin"

cat > "$tree/build.ninja" <<NINJA
rule copy
  command = cp \$in \$out
build lib/libscree_studies.so: copy $build/lib/libscree_studies.so
build scree_studies: phony lib/libscree_studies.so
NINJA

fail() { echo "$1"; cat "$tree/out" "$tree/err"; exit 1; }
for verb in accuracy spectrum cycles fields modes quasi-static; do
  "$tree/bin/scree" $verb --help > "$tree/out" 2> "$tree/err" || fail "scree $verb --help failed"
  grep -q -- "--out [DF]I" "$tree/out" || fail "the help of $verb is not printed"
  [ ! -s "$tree/err" ] || fail "the help of $verb builds the library"
done
status=0
"$tree/bin/scree" cycles --no-option > "$tree/out" 2> "$tree/err" || status=$?
[ $status -eq 2 ] && grep -q "no-option; see scree cycles --help$" "$tree/err" || fail "an unknown option is taken"
[ ! -e "$tree/lib/libscree_studies.so" ] || fail "an unknown option builds the library"

# What the library itself says.
study() { ! "$tree/bin/scree" cycles > "$tree/out" 2> "$tree/err" && tail -n 1 "$tree/err" | grep -q "^scree: neither a run directory nor --csv; "; }
study || fail "no line of the library"
grep -q "^scree: building scree_studies, " "$tree/err" || fail "no line says that the library is built"
study || fail "the second call failed"
[ "$(wc -l < "$tree/err")" -eq 1 ] || fail "the second call builds again"

# Of several at once one builds, and the others say that they wait. A call that is ended leaves the compilers that run
# to their end, and the next builds after them.
rm "$tree/lib/libscree_studies.so"
sed -i "s|command = .*|command = mkdir $tree/builds \|\| touch $tree/two; sleep 1; cp \$in \$out; rmdir $tree/builds|" "$tree/build.ninja"
"$tree/bin/scree" cycles > /dev/null 2> "$tree/err1" & first=$!
until [ -d "$tree/builds" ]; do sleep 0.05; done
kill -TERM $first
for call in 2 3; do "$tree/bin/scree" cycles > /dev/null 2> "$tree/err$call" & done
wait
[ ! -e "$tree/two" ] || fail "two builds at once"
cat "$tree/err2" "$tree/err3" > "$tree/err"
[ "$(grep -c "^scree: building" "$tree/err")" -le 1 ] || fail "not one of two built"
[ "$(grep -c "^scree: waiting for scree_studies" "$tree/err")" -eq 2 ] || fail "not both said that they wait"
[ -e "$tree/lib/libscree_studies.so" ] || fail "nothing was built"

rm "$tree/lib/libscree_studies.so"
sed -i 's/command = .*/command = false/' "$tree/build.ninja"
status=0
"$tree/bin/scree" cycles > "$tree/out" 2> "$tree/err" || status=$?
[ $status -eq 1 ] || fail "status $status in place of 1"
tail -n 1 "$tree/err" | grep -q "^scree: .*: the build of scree_studies failed; see its output above$" || fail "the last line does not say that the build failed"

# Without ninja, and with what is no library, one line says so.
refused() {  # refused NAME PATTERN
  status=0
  PATH=${path:-$PATH} "$tree/bin/scree" cycles > "$tree/out" 2> "$tree/err" || status=$?
  [ $status -eq 2 ] || fail "$1: status $status in place of 2"
  [ "$(wc -l < "$tree/err")" -eq "${lines:-1}" ] || fail "$1: not one line"
  grep -q "$2" "$tree/err" || fail "$1: another line"
}
path=$tree lines=2 refused "no ninja" "^scree: ninja: cannot be started (.*; install ninja-build$"
library=$tree/lib/libscree_studies.so
for bytes in 0 100 100000 $(($(stat -c %s "$build/lib/libscree_studies.so") - 1)); do
  head -c "$bytes" "$build/lib/libscree_studies.so" > "$library"
  refused "$bytes bytes" "^scree: .*libscree_studies.so: is no whole library; remove it and build"
done
rm "$library"; ln -s libscree_studies.so "$library"
refused "a link to itself" "is no whole library"
rm "$library"; mkfifo "$library"
refused "a pipe" "is no whole library"
echo passed
