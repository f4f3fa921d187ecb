#!/usr/bin/env bash
# What write_revision.cmake finds out about trees of sources: revision_test.sh <sources>
set -euo pipefail
script=$1/tools/cmake/write_revision.cmake
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir -p tree/tools/cmake
echo '$Format:%H$' > tree/tools/cmake/revision.txt

expect() {
  cmake -DSOURCE="$folder/tree" -DFILE="$folder/commit.cpp" -P "$script"
  grep -q "return \"$1\";" commit.cpp || { echo "$2: not '$1' but: $(grep return commit.cpp)"; exit 1; }
}
run_git() { git -c user.name=a -c user.email=a@b -c init.defaultBranch=m "$@" > log 2>&1; }

expect unknown "a copy of a working tree"
run_git init outer && mv tree outer && ln -s outer/tree tree
run_git -C outer commit --allow-empty -m one
expect unknown "a copy in a repository of something else"
rm tree && mv outer/tree . && rm -rf outer
echo 0123456789abcdef0123456789abcdef01234567 > tree/tools/cmake/revision.txt
expect 0123456789ab "an archive"

run_git init tree
run_git -C tree add . && run_git -C tree commit -m one
commit=$(git -C tree rev-parse --short=12 HEAD)
expect "$commit" "a clone"
touch -d @1 commit.cpp
expect "$commit" "the same clone"
[ "$(stat -c %Y commit.cpp)" = 1 ] || { echo "the file was written again without a change"; exit 1; }
echo >> tree/tools/cmake/revision.txt
expect "$commit-dirty" "a clone with a change"
touch tree/more
run_git -C tree checkout .
expect "$commit" "a clone with a file that git does not know"
