#!/bin/sh
# The Python package on small scenes: python_test.py. Status 77 where pandas or h5py is missing (Debian: python3-pandas,
# python3-h5py). Usage: python_test.sh PROGRAM
set -eu
for package in pandas h5py; do
  /usr/bin/python3 -c "import $package" 2> /dev/null || { echo "$package is not installed"; exit 77; }
done
SCREE_PROGRAM=$1 exec /usr/bin/python3 -B "$(dirname "$0")/python_test.py"
