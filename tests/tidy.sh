#!/bin/sh
# Fails where clang-tidy 14 finds a name or a mistake that .clang-tidy forbids.
#   tests/tidy.sh            in every source
#   tests/tidy.sh --changed  in what is not committed, and in the files that the latest commits changed
# Sources that the build compiles as one are checked as one: parsing their headers is what takes the time.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
most=25        # of the product's files changed by commits: a minute on two cores
most_tests=2   # of the tests: half a minute
build=$root/build/tidy
lists=$(mktemp -d)
trap 'rm -rf "$lists"' EXIT

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DRYOSEN_TESTS=ON >/dev/null
# The loader of OpenGL alone: a build of that file would begin with the libraries.
ninja -C "$build" -t commands render/glad/include/glad/gl.h | grep -- --out-path | sh

cd "$root"
if [ "${1:-}" = --changed ]; then
  {
    git status --porcelain --no-renames | cut -c 4-
    git log --name-only --format= -n 100 | grep '\.\(h\|cpp\)$' |
      awk -v most="$most" -v most_tests="$most_tests" \
        '!seen[$0]++ && ($0 ~ "^tests/" ? tests++ < most_tests : product++ < most)'
  } 2>"$lists/said" | grep '\.\(h\|cpp\)$' | sort -u | while IFS= read -r file; do
    [ ! -f "$file" ] || echo "$file"
  done >"$lists/changed" || true
fi

# Each compiled file becomes one to check, NUMBER.cpp, and its command, NUMBER.sh. Of the sources that it includes, those
# that changed are left, and the changed headers of their folders. Paths with blanks stand in quotes.
ninja -C "$build" -t commands all | grep -E " -c ('[^']*|[^ ]*)\.(cxx|cpp)'?\$" >"$lists/commands"
number=0
while IFS= read -r command; do
  number=$((number + 1))
  compiled=$(echo "${command##* -c }" | tr -d "'")
  checked=$lists/$number.cpp
  own=
  case "$compiled" in
    "$root/tests/"* | "$build/tests/"*) own=--checks=-bugprone-integer-division ;;  # places of grids
  esac
  case "$compiled" in
    *"/Unity/"*) grep '^#include' "$compiled" | grep -v "\"$build" >"$checked" || continue ;;
    *) echo "#include \"$compiled\"" >"$checked" ;;
  esac
  if [ -f "$lists/changed" ]; then
    sed "s|.*\"$root/||; s|\"||" "$checked" | sort >"$lists/sources"
    {
      comm -12 "$lists/changed" "$lists/sources"
      sed 's|/[^/]*$||' "$lists/sources" | sort -u | while IFS= read -r folder; do
        grep "^$folder/[^/]*\.h$" "$lists/changed" || true
      done
    } | sed "s|.*|#include \"$root/&\"|" >"$checked"
  fi
  [ -s "$checked" ] || continue
  arguments=${command#* }
  echo "exec clang-tidy --quiet --config-file=\"$root/.clang-tidy\" $own $checked -- ${arguments%% -MD *}" >"$lists/$number.sh"
done <"$lists/commands"

echo "clang-tidy checks $(cat "$lists"/[0-9]*.cpp | grep -c . || true) files"
find "$lists" -name '[0-9]*.sh' -print0 | xargs -0 -r -n 1 -P "$(nproc)" sh 2>"$lists/said" || {
  cat "$lists/said" >&2
  exit 1
}
