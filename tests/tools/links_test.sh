#!/bin/sh
# Every relative link of every document of a tree leads to a file: links and pictures of Markdown, and names of documents
# in code spans, which count from the folder of the document or from the top; and every source that a code span names, by
# its name or the end of its path, is there. Usage: links_test.sh TOP
set -eu
top=$1
status=0

# check DOCUMENT TARGET PLACE...: whether the target is in one of the places.
check() {
  document=$1 target=$2
  shift 2
  for place in "$@"; do
    [ ! -e "$place/$target" ] || return 0
  done
  echo "${document#"$top"/}: $target is not there"
  status=1
}

sources=
[ ! -d "$top/framework/src" ] || sources=$(find -L "$top/" -name build -prune -o -name runs -prune -o -name '*.[ch]pp' -print -o -name '*.h' -print)
documents=$(find -L "$top/" -name build -prune -o -name runs -prune -o -name '*.md' -print)
[ -n "$documents" ]
for document in $documents; do
  folder=$(dirname "$document")
  for target in $(grep -o '](\([^)]*\))' "$document" | sed 's/^](//; s/)$//; s/#.*//' | grep -v '^[a-z]*:' || true); do
    check "$document" "$target" "$folder"
  done
  for target in $(grep -o '`[A-Za-z0-9_./-]*\.md`' "$document" | tr -d '`' || true); do
    check "$document" "$target" "$folder" "$top"
  done
  for target in $(grep -o '`[A-Za-z0-9_./-]*[A-Za-z0-9_]\.\([ch]pp\|h\)`' "$document" | tr -d '`' || true); do
    if [ -n "$sources" ] && ! echo "$sources" | grep -q "/$target\$"; then
      echo "${document#"$top"/}: $target is not there"
      status=1
    fi
  done
done
exit $status
