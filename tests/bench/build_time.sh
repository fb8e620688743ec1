#!/bin/sh
# Compares the processor time of a clean build of the program with that of an earlier commit, in one run.
#   tests/bench/build_time.sh COMMIT [FOLDER]
# Builds both in a temporary folder, or in FOLDER, one after the other with all cores, and prints the seconds of each and
# their ratio. Nothing else should run meanwhile.
set -eu
base=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${2:-$(mktemp -d)}
mkdir -p "$work"

# seconds_of NAME COMMIT prints the user and system seconds that a build from scratch takes.
seconds_of() {
  rm -rf "${work:?}/$1"
  git clone -q "$root" "$work/$1"
  git -C "$work/$1" checkout -q "$2"
  cmake -S "$work/$1" -B "$work/$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRYOSEN_TESTS=OFF >"$work/$1.log"
  (
    cmake --build "$work/$1/build" --target ryosen >>"$work/$1.log"
    times
  ) | awk -F'[ms ]' 'NR == 2 { printf "%.1f\n", $1 * 60 + $2 + $4 * 60 + $5 }'
}

now=$(seconds_of now HEAD)
before=$(seconds_of before "$base")
echo "$now s now, $before s at $base, ratio $(awk "BEGIN { printf \"%.3f\", $now / $before }")"
[ -n "${2:-}" ] || rm -rf "$work"
