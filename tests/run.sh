#!/bin/sh
# Builds everything and runs the whole suite without display or GPU.
#   tests/run.sh           the suite
#   tests/run.sh --long    also the long random walks, and each header and source file compiled alone
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
  configure_arguments=-DCMAKE_UNITY_BUILD=OFF
  build "$root/build/single" all
fi
ctest --test-dir "$root/build/release" --output-on-failure -j "$(nproc)"

# The library built by another compiler computes the same to the last bit, and stands what a fuzzer does to it: each
# target for a while, from the inputs that are kept.
fuzz_seconds=10
[ -z "${RYOSEN_LONG:-}" ] || fuzz_seconds=600
cmake -S "$root" -B "$root/build/fuzz" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=Release -DRYOSEN_FUZZ=ON -DRYOSEN_SANITIZE=address,undefined -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g1" >&2
build "$root/build/fuzz" all
for kind in release fuzz; do "$root/build/$kind/bin/hashes" >"$root/build/$kind/hashes.txt"; done
diff "$root/build/release/hashes.txt" "$root/build/fuzz/hashes.txt"
echo "$(wc -l <"$root/build/fuzz/hashes.txt") hashes are the same with both compilers"
"$root/tests/fuzz/run.sh" "$root/build/fuzz" "$fuzz_seconds"

# The core suite again, with every edit checked and under the sanitizers.
cmake -S "$root" -B "$root/build/asan" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DRYOSEN_CORE_ONLY=ON \
  -DRYOSEN_CHECKED=ON -DRYOSEN_SANITIZE=address,undefined -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" >&2
build "$root/build/asan" test_core
# The oracles and the exhaustive comparison are slow there and touch nothing that the walks do not.
ctest --test-dir "$root/build/asan" --output-on-failure -j "$(nproc)" \
  -E "Oracle|local_oracle|agrees_on_all_triangle_sets|Consumer"
