#!/bin/sh
# Builds and runs the benchmarks, then times the whole program from start to picture.
#   tests/bench/run.sh [DRAGON.ply.gz]
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/app/setup.sh"
# shellcheck disable=SC2086
ensure_packages $build_packages $test_packages $peer_packages libbenchmark-dev libmeshoptimizer-dev libeigen3-dev
[ $# = 0 ] || export RYOSEN_DRAGON=$1
cmake -S "$root" -B "$root/build/release" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRYOSEN_BENCH=ON >&2
targets="bench_core bench_forms bench_editor bench_large bench_peers bench_surfaces bench_files bench_check bench_growth bench_hull bench_simplify write_torus measure_quality measure_values simplify_ours simplify_peers ryosen"
# shellcheck disable=SC2086
cmake --build "$root/build/release" --target $targets >&2
"$root/build/release/bin/bench_peers"
"$root/build/release/bin/bench_surfaces"
"$root/build/release/bin/bench_files"
"$root/build/release/bin/bench_check"
"$root/build/release/bin/bench_growth"
"$root/build/release/bin/bench_simplify"
"$root/build/release/bin/bench_hull"
"$root/build/release/bin/bench_hull" growth
"$root/build/release/bin/bench_core"
"$root/build/release/bin/bench_forms" --benchmark_min_time=0.05
"$root/build/release/bin/bench_editor"
[ $# = 0 ] || "$root/build/release/bin/bench_large"

# median_of_11 COMMAND... prints the median wall time of 11 runs after one that is not counted, in milliseconds.
median_of_11() {
  "$@" >/dev/null
  for _ in 1 2 3 4 5 6 7 8 9 10 11; do
    begin=$(date +%s%N)
    "$@" >/dev/null
    end=$(date +%s%N)
    echo $(((end - begin) / 1000000))
  done | sort -n | sed -n 6p
}
picture=$(mktemp --suffix=.png)
trap 'rm -f "$picture"' EXIT
program=$root/build/release/bin/ryosen
bunny=$root/assets/stanford_bunny.obj
echo "bunny to picture, ms: $(median_of_11 "$program" shot "$bunny" -o "$picture" --overwrite)"
echo "bunny to picture with panels, ms: $(median_of_11 "$program" shot "$bunny" --panels -o "$picture" --overwrite)"
"$root/tests/bench/pictures.sh" "$program" "$root/build/release/bin/write_torus" ${1+"$1"}
"$root/tests/bench/quality.sh" "$root/build/release/bin"
