#!/bin/sh
# Prints what the program reports about every mesh there is, one line of JSON each. Self-intersections too, where
# finding them is quick.
#   tests/fuzz/reports.sh PROGRAM
set -eu
program=$1
cd "$(dirname "$0")/../.."
folders="assets tests/data"
[ ! -d ../shared/meshes ] || folders="$folders ../shared/meshes"
[ ! -d ../shared/malformed ] || folders="$folders ../shared/malformed"
# Problems in the meshes end with 1, files that cannot be read with 9; any other end is a failure of its own.
check() {
  code=0
  "$program" check --json --jobs 2 "$@" || code=$?
  case $code in 0 | 1 | 9) ;; *) exit "$code" ;; esac
}
# shellcheck disable=SC2086
check $folders
check --self-intersections tests/data assets
