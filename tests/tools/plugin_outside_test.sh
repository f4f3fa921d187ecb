#!/bin/sh
# In an empty directory, with an installed tree: `scree new-plugin` writes a project of each kind, which builds and
# passes its tests with two commands; and the links of its documents lead somewhere.
# Usage: plugin_outside_test.sh BUILD_DIRECTORY
set -eu
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

tests=$(cd "$(dirname "$0")" && pwd)
cmake --install "$build" --prefix "$folder/installed" > "$folder/install.log"
sh "$tests/links_test.sh" "$folder/installed/share/doc/scree"
cd "$folder"
for kind in contact boundary body_force probe; do
  installed/bin/scree new-plugin "$kind" "my_$kind" > new.log
  { cmake -B "my_$kind/build" "my_$kind" && cmake --build "my_$kind/build" --target check; } > build.log 2>&1 || {
    cat build.log
    echo "my_$kind does not build or fails its tests"
    exit 1
  }
  grep -q "100% tests passed, 0 tests failed out of 2" build.log
  lines=$(wc -l < "my_$kind/my_$kind.cpp")
  [ "$lines" -lt 80 ] || { echo "my_$kind has $lines lines"; exit 1; }
done

# Columns are described as those of the probes of scree.
installed/bin/scree describe probe/my_probe --plugins my_probe/build/plugins > describe.log
grep -q "mean_squared_displacement \[m^2\]  over all bodies and windows" describe.log || { cat describe.log; exit 1; }

# The lock-in is in the installed headers: a probe with it builds and loads.
installed/bin/scree new-plugin probe height_amplitude > new.log
cp "$tests/outside/lock_in_probe.cpp" height_amplitude/height_amplitude.cpp
{ cmake -B height_amplitude/build height_amplitude && cmake --build height_amplitude/build; } > build.log 2>&1 || {
  cat build.log
  exit 1
}
installed/bin/scree describe probe/height_amplitude --plugins height_amplitude/build/plugins > describe.log
grep -q "height_amplitude \[m\]  at 1 Hz" describe.log || { cat describe.log; exit 1; }

# The code of the tutorial builds as it stands there: each block that begins with its file's name.
blocks=
tutorial=installed/share/doc/scree/plugins/README.md
for block in $(sed -n 's,^// \([a-z_]*\)\.cpp$,\1,p' "$tutorial"); do
  code=$(sed -n "\,^// $block\.cpp$,,/^\`\`\`/{/^\`\`\`/d;p}" "$tutorial")
  case $code in
  *SCREE_CONTACT_LAW_PLUGIN*) kind=contact ;;
  *SCREE_BOUNDARY_PLUGIN*) kind=boundary ;;
  *) kind=probe ;;
  esac
  installed/bin/scree new-plugin "$kind" "$block" > new.log
  printf '%s\n' "$code" > "$block/$block.cpp"
  { cmake -B "$block/build" "$block" && cmake --build "$block/build"; } > build.log 2>&1 || {
    cat build.log
    echo "$block of the tutorial does not build"
    exit 1
  }
  installed/bin/scree describe "$kind/$block" --plugins "$block/build/plugins" > describe.log || {
    cat describe.log
    exit 1
  }
  blocks="$blocks$block "
done
[ "$blocks" = "sticky sprung_lid polygon_drum wandering " ] || { echo "the tutorial has $blocks"; exit 1; }

# Its drum of flat faces turns, of surfaces with a spin: the balance of energy closes, which it did not when faces were
# planes that jump (1.6 %).
lines=$(wc -l < polygon_drum/polygon_drum.cpp)
[ "$lines" -lt 80 ] || { echo "polygon_drum has $lines lines"; exit 1; }
installed/bin/scree run "$tests/outside/polygon_drum.toml" --plugins polygon_drum/build/plugins --out drum > run.log 2>&1 || {
  cat run.log
  exit 1
}

# A law that makes energy does not pass.
sed -i 's/const T dashpot = /const T dashpot = -/' my_contact/my_contact.cpp
if cmake --build my_contact/build --target check > build.log 2>&1; then
  echo "a law that creates energy passed its tests"
  exit 1
fi
grep -q "FAILED  no energy is created" build.log || { cat build.log; exit 1; }
echo passed
