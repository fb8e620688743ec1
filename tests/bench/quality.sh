#!/bin/sh
# Simplified meshes beside each other: Ryosen, meshoptimizer and CGAL (Garland and Heckbert; Lindstrom and Turk) to 50,
# 10, 2 and 0.5 percent of the faces. Each row: seconds, faces, RMS and largest distance in percent of the input's
# diagonal, non-manifold edges, turned faces, the length of the boundary and that of the largest hole in percent of the
# input's, self-intersections (ryosen check). All but the last are measured by measure_quality, which has nothing of any
# of them. Behind the rows: geometric means of what Ryosen has by what each other has, where both have about as many
# faces; what is below a millionth of the diagonal counts as that. Then the table of quality_of_values.sh.
#   tests/bench/quality.sh PROGRAM_FOLDER [MESH...]
# PROGRAM_FOLDER holds ryosen, simplify_ours, simplify_peers, measure_quality and measure_values. Without meshes: the
# bunny, and where they are there the dragon of ../shared/assets and the 20 largest files below ../shared/meshes. METHODS
# names some of "ryosen ryosen-2 meshoptimizer garland-heckbert lindstrom-turk", of which the second is Ryosen with
# effort 2. PACKAGE is the folder of meshoptimizer's JavaScript package, for colours.
set -eu
programs=$1
shift
root=$(cd "$(dirname "$0")/../.." && pwd)
methods=${METHODS-ryosen ryosen-2 meshoptimizer garland-heckbert lindstrom-turk}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# simplify METHOD FACES: writes out.off and prints the seconds without reading and writing.
simplify() {
  case $1 in
  ryosen) "$programs/simplify_ours" "$folder/in.off" "$folder/out.off" "$2" ;;
  ryosen-2) "$programs/simplify_ours" "$folder/in.off" "$folder/out.off" "$2" 2 ;;
  *) "$programs/simplify_peers" "$1" "$folder/in.off" "$folder/out.off" "$2" ;;
  esac
}

intersections() {
  "$programs/ryosen" check "$1" --self-intersections --fail-on none --json 2>/dev/null |
    grep -o '"kind":"self_intersection","severity":"problem","count":[0-9]*' | grep -o '[0-9]*$' || echo 0
}

row() {
  name=$(basename "$1")
  "$programs/ryosen" convert "$1" -o "$folder/in.off" --triangulate --overwrite -q >/dev/null || return 0
  faces=$("$programs/ryosen" check "$folder/in.off" --json --fail-on none | grep -o '"faces":[0-9]*' | head -1 | cut -d: -f2)
  for percent in 50 10 2 0.5; do
    goal=$(awk "BEGIN { print int($faces * $percent / 100) }")
    [ "$goal" -ge 4 ] || continue
    for method in $methods; do
      rm -f "$folder/out.off"
      seconds=$(simplify "$method" "$goal") || seconds=-
      [ -s "$folder/out.off" ] || { printf '%-28s %3s%%  %-16s failed\n' "$name" $percent "$method"; continue; }
      # shellcheck disable=SC2046
      set -- $(timeout 60 "$programs/measure_quality" "$folder/in.off" "$folder/out.off" || echo - - - - - - -) $(intersections "$folder/out.off")
      printf '%-28s %3s%%  %-16s %9s %8s %9s %9s %5s %5s %7s %7s %5s\n' "$name" $percent "$method" "$seconds" "$@"
    done
  done
}

printf '%-28s %4s  %-16s %9s %8s %9s %9s %5s %5s %7s %7s %5s\n' mesh to by seconds faces 'rms %' 'max %' nm turned 'loops %' 'hole %' cross
if [ $# = 0 ]; then
  meshes=$root/../shared/meshes
  set -- "$root/assets/stanford_bunny.obj"
  dragon=$root/../shared/assets/stanford_dragon.ply.gz
  [ ! -f "$dragon" ] || set -- "$@" "$dragon"
  if [ -d "$meshes" ]; then
    # shellcheck disable=SC2046
    set -- "$@" $(find "$meshes" -type f \( -name '*.off' -o -name '*.obj' -o -name '*.ply' -o -name '*.stl' \) \
      -printf '%s %p\n' | sort -rn | head -20 | cut -d' ' -f2)
  fi
fi
for mesh in "$@"; do row "$mesh"; done | tee "$folder/rows"
awk '
  function held(x) { return x > 1e-4 ? x : 1e-4 }
  function ratio(values, a, b) { return log(values[a] / values[b]) }
  function line(goal, n, with_loops, r, m, t, l) {
    printf "%-10s by %-16s %5s  RMS %.3f  largest %.3f  time %.2f  loops %.3f  (%d, %d)\n", ours[i], others[j], goal,
           exp(r / n), exp(m / n), exp(t / n), with_loops > 0 ? exp(l / with_loops) : 1, n, with_loops
  }
  $4 ~ /^[0-9.]+$/ {
    keys[$1 " " $2] = $2
    key = $1 " " $2 " " $3
    time[key] = $4 + 1e-4; faces[key] = $5; rms[key] = held($6); most[key] = held($7); loops[key] = $10
  }
  END {
    split("ryosen ryosen-2", ours); split("lindstrom-turk garland-heckbert meshoptimizer", others)
    split("50% 10% 2% 0.5%", goals)
    for (i = 1; i in ours; ++i) for (j = 1; j in others; ++j) {
      all = all_with_loops = all_r = all_m = all_t = all_l = 0
      for (g = 1; g in goals; ++g) {
        n = with_loops = r = m = t = l = 0
        for (key in keys) {
          a = key " " ours[i]; b = key " " others[j]
          if (keys[key] != goals[g] || !(a in faces) || !(b in faces)) continue
          if (faces[a] - faces[b] > faces[b] / 20 || faces[b] - faces[a] > faces[b] / 20) continue
          ++n; r += ratio(rms, a, b); m += ratio(most, a, b); t += ratio(time, a, b)
          if (loops[a] > 0 && loops[b] > 0) { ++with_loops; l += ratio(loops, a, b) }
        }
        if (n == 0) continue
        line(goals[g], n, with_loops, r, m, t, l)
        all += n; all_with_loops += with_loops; all_r += r; all_m += m; all_t += t; all_l += l
      }
      if (all > 0) line("all", all, all_with_loops, all_r, all_m, all_t, all_l)
    }
  }' "$folder/rows"
echo
"$root/tests/bench/quality_of_values.sh" "$programs" ${PACKAGE+"$PACKAGE"}
