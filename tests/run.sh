#!/bin/sh
# Builds everything and runs the whole suite without display or GPU.
#   tests/run.sh           the suite
#   tests/run.sh --long    also the long random walks and fuzzing, and each header and source file compiled alone
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/app/setup.sh"
configure_arguments=
[ "${1:-}" != --long ] || export RYOSEN_LONG=1

# shellcheck disable=SC2086
ensure_packages $build_packages $test_packages
cmake -S "$root" -B "$root/build/release" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRYOSEN_TESTS=ON >&2
build "$root/build/release" all
if [ -n "${RYOSEN_LONG:-}" ]; then  # each header and each source file is complete in itself
  build "$root/build/release" ryosen_core_verify_interface_header_sets
  configure_arguments="-DCMAKE_UNITY_BUILD=OFF -DCMAKE_CXX_FLAGS_RELEASE=-O0"
  build "$root/build/single" all
fi
ctest --test-dir "$root/build/release" --output-on-failure -j "$(nproc)"

# All of it again, built by another compiler and under the sanitizers, with the mesh checked after every edit. The oracles
# and what goes over whole tables are slow there and touch nothing that the walks do not.
cmake -S "$root" -B "$root/build/fuzz" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DRYOSEN_FUZZ=ON -DRYOSEN_CHECKED=ON \
  -DRYOSEN_SANITIZE=address,undefined >&2
build "$root/build/fuzz" test_core hashes fuzz_targets
ctest --test-dir "$root/build/fuzz" --output-on-failure -j "$(nproc)" -L core \
  -E "^oracle_|oracle\.|agrees_on_all_triangle_sets|reasons_table|laws|plain_check|[Ff]orms|all_pairs_are_welded|whole_numbers_on_grids"

# Both builds compute the same to the last bit and, in a long run, say the same about every file.
compared=hashes
if [ -n "${RYOSEN_LONG:-}" ]; then
  build "$root/build/fuzz" ryosen
  compared="hashes reports"
fi
for kind in release fuzz; do
  "$root/build/$kind/bin/hashes" >"$root/build/$kind/hashes.txt"
  [ "$compared" = hashes ] ||
    "$root/tests/fuzz/reports.sh" "$root/build/$kind/bin/ryosen" >"$root/build/$kind/reports.txt"
done
for lines in $compared; do
  diff "$root/build/release/$lines.txt" "$root/build/fuzz/$lines.txt"
  echo "$(wc -l <"$root/build/fuzz/$lines.txt") $lines are the same with both compilers"
done

# What a fuzzer does to it, from the inputs that are kept.
fuzz_seconds=6
[ -z "${RYOSEN_LONG:-}" ] || fuzz_seconds=240
"$root/tests/fuzz/run.sh" "$root/build/fuzz" "$fuzz_seconds"
