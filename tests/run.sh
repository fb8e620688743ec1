#!/bin/sh
# Builds everything and runs the whole suite without display or GPU.
#   tests/run.sh [PART...]        the suite
#   tests/run.sh --long [PART...] also the long random walks and fuzzing, what other libraries answer, and each header and
#                                 source file compiled alone; it takes hours, so parts can be named: tests single tidy
#                                 walks windows compared fuzz
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/app/setup.sh"
parts="tests tidy walks compared fuzz"
configure_arguments=
has_tests=
has_checked=
peers=OFF
long_packages=
seconds=1500  # for one test
# A short run optimises the program less: that compiles a quarter faster and runs a tenth slower.
flags="-O1 -DNDEBUG"
# A short run does not optimise what the sanitizers check, which builds in half the time, tries one seed of 16, and
# leaves out of undefined behaviour what shows in ASan or costs most to compile.
checked_flags="-DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0"
sanitizers=address,bool,bounds,builtin,enum,float-cast-overflow,integer-divide-by-zero,nonnull-attribute,return,shift
sanitizers=$sanitizers,signed-integer-overflow,unreachable
walked=property
guided=OFF
fuzz_seconds=0
compared=hashes
if [ "${1:-}" = --long ]; then
  shift
  parts=${*:-tests single tidy walks windows compared fuzz}
  export RYOSEN_LONG=1
  peers=ON
  long_packages=$peer_packages
  seconds=7200
  flags="-O3 -DNDEBUG"
  checked_flags="-DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1"
  sanitizers=address,undefined
  walked="property core"
  guided=ON
  fuzz_seconds=240
  compared="hashes reports"
elif [ -n "$*" ]; then
  parts=$*
fi
for part in $parts; do
  case "$part" in
    tests | single | tidy | walks | windows | compared | fuzz) ;;
    *) sed -n "2,6s/^# //p" "$0" >&2; exit 2 ;;
  esac
done

is_long() { [ -n "${RYOSEN_LONG:-}" ]; }

configure_tests() {
  [ -z "$has_tests" ] || return 0
  has_tests=yes
  cmake -S "$root" -B "$root/build/tests" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=$flags" \
    -DRYOSEN_TESTS=ON -DRYOSEN_PROVENANCE=ON -DRYOSEN_PEERS=$peers >&2
}

# By another compiler, under the sanitizers, with the mesh checked after every edit.
configure_checked() {
  [ -z "$has_checked" ] || return 0
  has_checked=yes
  # shellcheck disable=SC2086
  cmake -S "$root" -B "$root/build/fuzz" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ $checked_flags \
    -DRYOSEN_FUZZ=ON -DRYOSEN_FUZZ_GUIDED=$guided -DRYOSEN_CHECKED=ON -DRYOSEN_SANITIZE=$sanitizers >&2
}

run_tests() {
  configure_tests
  build "$root/build/tests" all
  # A short run writes into memory where there is a gibibyte: every save waits for a disk.
  folder=${TMPDIR:-/tmp}
  free_kib=$(df -k --output=avail /dev/shm 2>/dev/null | tail -n 1)
  if ! is_long && [ -z "${TMPDIR:-}" ] && [ "${free_kib:-0}" -gt 1048576 ]; then
    folder=/dev/shm
  fi
  # Some tests wait for windows and processes, so one more runs than there are cores.
  TMPDIR=$folder ctest --test-dir "$root/build/tests" --output-on-failure -j "$(($(nproc) + 1))" --timeout "$seconds"
}

# Each header and each source file is complete in itself.
run_single() {
  configure_tests
  build "$root/build/tests" all_verify_interface_header_sets
  configure_arguments="-DCMAKE_UNITY_BUILD=OFF -DCMAKE_CXX_FLAGS_RELEASE=-O0"
  build "$root/build/single" all
}

# Names, and mistakes that a reader overlooks: a short run looks at what changed.
run_tidy() {
  if is_long; then
    "$root/tests/tidy.sh"
  else
    "$root/tests/tidy.sh" --changed
  fi
}

# The walks again, in a long run also the tests of each class, with as many tries as in a short run: all would take
# hours. The oracles and what goes over whole tables or real meshes are slow here and touch nothing that the walks do
# not.
run_walks() {
  configure_checked
  for kind in $walked; do
    build "$root/build/fuzz" "test_$kind" hashes fuzz
    tries=RYOSEN_ONE_OF=16
    [ "$kind" = property ] || tries="-u RYOSEN_LONG"
    # shellcheck disable=SC2086
    env $tries ctest --test-dir "$root/build/fuzz" --output-on-failure -j "$(nproc)" --timeout "$seconds" \
      -L "$kind" -E "^oracle_|oracle\.|agrees_on_all_triangle_sets|reasons_table|laws|pinch|real_meshes|shared_meshes|plain_check|[Ff]orms|all_pairs_are_welded|whole_numbers_on_grids"
  done
}

# What happens in windows, too: events, panels, pictures, and the walk of a monkey over ten meshes.
run_windows() {
  configure_checked
  build "$root/build/fuzz" test_app
  LSAN_OPTIONS="suppressions='$root/tests/support/osmesa_leaks.txt':print_suppressions=0" \
    ctest --test-dir "$root/build/fuzz" --output-on-failure -j "$(nproc)" --timeout "$seconds" -L app -R "Monkey|gui|Viewport|random_scripts"
  # The driver of a display keeps what it has, and has been unloaded when leaks are looked for.
  ASAN_OPTIONS=detect_leaks=0 \
    ctest --test-dir "$root/build/fuzz" --output-on-failure -j "$(nproc)" --timeout "$seconds" -L app -R "Window"
}

# Both builds compute the same to the last bit and, in a long run, say the same about every file.
run_compared() {
  programs=hashes
  [ "$compared" = hashes ] || programs="hashes ryosen"
  configure_tests
  configure_checked
  for kind in tests fuzz; do
    # shellcheck disable=SC2086
    build "$root/build/$kind" $programs
    "$root/build/$kind/bin/hashes" >"$root/build/$kind/hashes.txt"
    [ "$compared" = hashes ] ||
      "$root/tests/fuzz/reports.sh" "$root/build/$kind/bin/ryosen" >"$root/build/$kind/reports.txt"
  done
  for lines in $compared; do
    diff "$root/build/tests/$lines.txt" "$root/build/fuzz/$lines.txt"
    echo "$(wc -l <"$root/build/fuzz/$lines.txt") $lines are the same with both compilers"
  done
}

# What a fuzzer does to it, from the inputs that are kept; in a short run these alone.
run_fuzz() {
  configure_checked
  build "$root/build/fuzz" fuzz
  "$root/tests/fuzz/run.sh" "$root/build/fuzz" "$fuzz_seconds"
}

# shellcheck disable=SC2086
ensure_packages $build_packages $test_packages $long_packages
for part in $parts; do
  "run_$part"
done
