#!/usr/bin/env bash
# setup_test.sh <root of the source>: output of tools/setup.sh if python3-paraview conflicts with libvtk9-dev.
set -u
source "$1/tools/setup.sh"

# Replaces the query of dpkg: the installed packages.
installed=""
is_installed() { [[ " $installed " == *" $1 "* ]]; }

failures=0
# check <what> <expected exit status> <pattern of the output> <call...>
check() {
  local output status
  output=$("${@:4}" 2>&1)
  status=$?
  # shellcheck disable=SC2053  # a pattern
  [[ $status == "$2" && $output == $3 ]] && return
  printf '%s: status %s, output: %s\n' "$1" "$status" "$output"
  failures=1
}

installed="${scree_packages[*]} python3-paraview"
check "python3-paraview conflicts with VTK" 2 \
  "scree: *python3-paraview;*apt-get remove python3-paraview*--without-pictures*" install_missing release
check "nothing is missing without pictures" 0 "" install_missing no-pictures
installed+=" libosmesa6-dev libvtk9-dev"
check "nothing is missing if VTK is installed" 0 "" install_missing release
installed=${scree_packages[*]}
check "VTK is missing and nothing conflicts with it" 0 "" refuse_conflict libosmesa6-dev libvtk9-dev
check "the packages for pictures are listed as missing" 0 $'libosmesa6-dev\nlibvtk9-dev' missing_packages release
exit $failures
