# Sourced by tools/run and tools/test, which set scree_root, assume_yes and levels: installs what is missing, configures
# and builds.
# Everything is a Debian 12 package by name; nothing else is downloaded.

scree_packages=(
  g++ cmake ninja-build
  libcli11-dev libfmt-dev libtomlplusplus-dev
  nlohmann-json3-dev libhdf5-dev libfftw3-dev libeigen3-dev libmetis-dev libsuitesparse-dev
  libcairo2-dev fonts-dejavu-core catch2 libopenmpi-dev openmpi-bin
)
# An oracle of tests, what the Python package reads with, and what makes films; tests do without them where they are missing.
test_packages=(libmumps-seq-dev python3-h5py python3-pandas ffmpeg)
# Not for the preset no-pictures.
picture_packages=(libosmesa6-dev libvtk9-dev)

say() { printf 'scree: %s\n' "$*" >&2; }

is_installed() { [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }

# missing_packages <preset>
missing_packages() {
  local package packages=("${scree_packages[@]}")
  [[ $1 == no-pictures ]] || packages+=("${picture_packages[@]}")
  [[ ${levels:-native} == native ]] || packages+=("${test_packages[@]}")
  for package in "${packages[@]}"; do
    is_installed "$package" || echo "$package"
  done
}

# refuse_conflict <missing packages...>: python3-paraview conflicts with python3-vtk9, which libvtk9-dev needs; apt would
# say so in many lines and name no cure.
refuse_conflict() {
  [[ " $* " == *" libvtk9-dev "* ]] && is_installed python3-paraview || return 0
  say "libvtk9-dev, which draws pictures, cannot be installed beside the package python3-paraview;" \
    "remove that with apt-get remove python3-paraview (ParaView itself stays, without its Python)," \
    "or go on without pictures: tools/run --without-pictures SCENARIO, tools/test --preset no-pictures"
  exit 2
}

# Asks once, unless --yes was given or there is no terminal to ask at.
confirm() {
  [[ $assume_yes == yes || ! -t 0 ]] && return 0
  local answer
  read -r -p "scree: install them now with apt? [Y/n] " answer
  [[ -z $answer || $answer == [Yy]* ]]
}

# install_missing <preset>
install_missing() {
  local missing
  mapfile -t missing < <(missing_packages "$1")
  ((${#missing[@]})) || return 0
  refuse_conflict "${missing[@]}"
  say "these Debian packages are missing: ${missing[*]}"
  local by_hand="apt-get install --no-install-recommends ${missing[*]}"
  local root=()
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null || { [[ ! -t 0 ]] && ! sudo -n true 2>/dev/null; }; then
      say "neither root nor able to use sudo; ask an administrator to run: $by_hand"
      exit 2
    fi
    root=(sudo)
  fi
  if ! command -v apt-get >/dev/null; then
    say "this system has no apt-get; install the equivalents of: ${missing[*]}"
    exit 2
  fi
  confirm || { say "nothing installed; by hand: $by_hand"; exit 2; }
  say "installing them, a few minutes the first time"
  local log
  log=$(mktemp)
  if ! { "${root[@]}" apt-get update &&
         "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 15 "$log" >&2
    say "the installation failed (all of it in $log); by hand: $by_hand"
    exit 2
  fi
  rm -f "$log"
}

# configure_scree <preset>: unless it is configured for the instruction levels that the caller needs. `levels` is native,
# enough for runs on this computer, or all; a build for all serves both.
configure_scree() {
  local preset=$1 build="$scree_root/build/$1"
  if [[ -f $build/build.ninja ]]; then
    # What a newer version needs besides.
    [[ ! $scree_root/tools/setup.sh -nt $build/build.ninja ]] || install_missing "$preset"
    [[ $levels == all ]] && grep -q '^SCREE_LEVELS:STRING=native' "$build/CMakeCache.txt" || return 0
  fi
  install_missing "$preset"
  say "configuring ($preset)"
  (cd "$scree_root" && cmake --preset "$preset" -DSCREE_LEVELS="$levels" >"$scree_root/build-$preset.log" 2>&1) ||
    { tail -n 20 "$scree_root/build-$preset.log" >&2; say "configuring failed"; exit 1; }
  rm -f "$scree_root/build-$preset.log"
}

# build_scree <preset> [targets]: silent when there is nothing to do.
build_scree() {
  local preset=$1 build="$scree_root/build/$1" targets=("${@:2}")
  configure_scree "$preset"
  [[ -x $build/bin/scree ]] || say "building ($preset), some minutes the first time"
  # Silent but for what is really built.
  ninja -C "$build" "${targets[@]}" | { grep -vE 'no work to do|Re-checking globbed|Entering directory|Asking for the commit' >&2 || true; } ||
    { say "the build failed"; exit 1; }
}
