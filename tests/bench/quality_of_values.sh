#!/bin/sh
# Colours and texture of simplified meshes: the bunny coloured by its normals, by a checker of 20 cells, and with a
# texture in six charts, to 50, 10 and 2 percent of the faces. Rows of colours: seconds, faces, RMS of colours, RMS of
# distances in percent of the diagonal, by Ryosen with weights 0, 0.005 and 1, and by meshoptimizer with weight 1, both
# where it keeps the places of vertices (attributes) and where it updates them (update). Rows of texture: faces, median
# and 99th percentile of how much the texture is stretched. Everything is measured by measure_values.
#   tests/bench/quality_of_values.sh PROGRAM_FOLDER [PACKAGE_FOLDER [MESH]]
# PROGRAM_FOLDER holds ryosen, simplify_ours and measure_values; PACKAGE_FOLDER is that of meshoptimizer's JavaScript
# package, without which Ryosen is measured alone.
set -eu
programs=$1
package=${2-}
root=$(cd "$(dirname "$0")/../.." && pwd)
mesh=${3-$root/assets/stanford_bunny.obj}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$programs/ryosen" convert "$mesh" -o "$folder/in.off" --triangulate --overwrite -q >/dev/null
faces=$("$programs/ryosen" check "$folder/in.off" --json --fail-on none | grep -o '"faces":[0-9]*' | head -1 | cut -d: -f2)

# row PAINT PERCENT NAME COMMAND...: the command prints the seconds.
row() {
  paint=$1 percent=$2 name=$3
  shift 3
  # shellcheck disable=SC2046
  printf '%-8s %3s%%  %-24s %9s %8s %9s %9s\n' "$paint" "$percent" "$name" "$("$@")" \
    $("$programs/measure_values" colours "$folder/$paint.off" "$folder/out.off")
}

printf '%-8s %4s  %-24s %9s %8s %9s %9s\n' colours to by seconds faces 'colour' 'rms %'
for paint in normals checker; do
  "$programs/measure_values" $paint "$folder/in.off" "$folder/$paint.off"
  for percent in 50 10 2; do
    goal=$(awk "BEGIN { print int($faces * $percent / 100) }")
    for weight in 0 0.005 1; do
      row $paint $percent "ryosen $weight" "$programs/simplify_ours" "$folder/$paint.off" "$folder/out.off" "$goal" 1 $weight
    done
    [ -n "$package" ] || continue
    for method in attributes update; do
      row $paint $percent "meshoptimizer $method 1" node "$root/tests/bench/simplify_peer.mjs" "$package" $method \
        "$folder/$paint.off" "$folder/out.off" "$goal" 1
    done
  done
done

printf '\n%-8s %4s  %-24s %8s %9s %9s\n' texture to by faces median p99
"$programs/measure_values" atlas "$folder/in.off" "$folder/atlas.obj"
for percent in 50 10 2; do
  for weight in 0 0.005 1; do
    "$programs/ryosen" simplify "$folder/atlas.obj" --ratio "$(awk "BEGIN { print $percent / 100 }")" \
      --colour-weight $weight -o "$folder/out.obj" --overwrite -q >/dev/null
    # shellcheck disable=SC2046
    printf '%-8s %3s%%  %-24s %8s %9s %9s\n' atlas $percent "ryosen $weight" \
      $("$programs/measure_values" texture "$folder/atlas.obj" "$folder/out.obj")
  done
done
