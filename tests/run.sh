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

# The core suite again, with every edit checked and under the sanitizers.
cmake -S "$root" -B "$root/build/asan" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DRYOSEN_CORE_ONLY=ON \
  -DRYOSEN_CHECKED=ON -DRYOSEN_SANITIZE=address,undefined -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" >&2
build "$root/build/asan" all
# The oracles and the exhaustive comparison are slow there and touch nothing that the walks do not.
ctest --test-dir "$root/build/asan" --output-on-failure -j "$(nproc)" -E "Oracle|local_oracle|agrees_on_all_triangle_sets"
