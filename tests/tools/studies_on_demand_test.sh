#!/bin/sh
# In a build tree without the library of the studies, a study builds it first and says so; if the build fails, one line says
# that. Usage: studies_on_demand_test.sh BUILD_DIRECTORY
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
"$tree/bin/scree" cycles --help > "$tree/out" 2> "$tree/err" || fail "scree cycles --help failed"
grep -q "^scree: building scree_studies, " "$tree/err" || fail "no line says that the library is built"
grep -q -- "--csv" "$tree/out" || fail "the help is not printed"
"$tree/bin/scree" cycles --help > "$tree/out" 2> "$tree/err" || fail "the second call failed"
[ ! -s "$tree/err" ] || fail "the second call builds again"

# Of several at once one builds.
rm "$tree/lib/libscree_studies.so"
for call in 1 2 3; do "$tree/bin/scree" cycles --help > /dev/null 2> "$tree/err$call" & done
wait
[ "$(cat "$tree"/err? | grep -c "^scree: building")" -eq 1 ] || { cat "$tree"/err?; echo "not one of three built"; exit 1; }

rm "$tree/lib/libscree_studies.so"
sed -i 's/command = cp .*/command = false/' "$tree/build.ninja"
status=0
"$tree/bin/scree" cycles --help > "$tree/out" 2> "$tree/err" || status=$?
[ $status -eq 1 ] || fail "status $status in place of 1"
tail -n 1 "$tree/err" | grep -q "^scree: .*: the build of scree_studies failed; see its output above$" || fail "the last line does not say that the build failed"
echo passed
