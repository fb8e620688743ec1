#!/bin/sh
# File to picture as a whole process, `ryosen shot` beside f3d, at 1280x720: bunny, dragon, tori of 10 and 30 million
# triangles, where there is room for them. Prints the median wall time of three runs, the processor time and the peak
# memory of the last.
#   tests/bench/pictures.sh PROGRAM WRITE_TORUS [DRAGON.ply.gz]
set -eu
program=$1 write_torus=$2 dragon=${3-}
root=$(cd "$(dirname "$0")/../.." && pwd)
[ -x /usr/bin/time ] || { echo "time is not installed: no pictures are timed (apt-get install time)" >&2; exit 0; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

has_f3d=yes
for needed in f3d xvfb-run; do
  command -v $needed >/dev/null || has_f3d=
done
[ "$has_f3d" ] || echo "f3d or xvfb-run is not installed: ryosen is timed alone (apt-get install f3d xvfb)"

shot_ryosen() { timed "$program" shot "$1" -o "$folder/p.png" --overwrite; }
shot_f3d() { timed xvfb-run -a f3d --resolution=1280,720 --output="$folder/p.png" "$1"; }

# Appends wall time, user and system time in seconds and the peak in KiB of the largest process.
timed() { /usr/bin/time -a -o "$folder/times" -f '%e %U %S %M' "$@" >/dev/null 2>&1; }

# row NAME FILE TRIANGLES
row() {
  for with in ryosen ${has_f3d:+f3d}; do
    : >"$folder/times"
    for _ in 1 2 3; do
      shot_$with "$2" || { echo "$1, $with: failed"; continue 2; }
    done
    wall=$(cut -d' ' -f1 "$folder/times" | sort -n | sed -n 2p)
    tail -n 1 "$folder/times" | while read -r _ user system peak; do
      awk -v name="$1" -v with=$with -v wall="$wall" -v cpu="$user $system" -v peak="$peak" -v triangles="$3" 'BEGIN {
        split(cpu, part, " ")
        printf "%-12s %-7s %7.2f s  (%.2f s of processor)  %6.0f MiB  %6.1f bytes per triangle\n",
               name, with, wall, part[1] + part[2], peak / 1024, peak * 1024 / triangles }'
    done
  done
}

row bunny "$root/assets/stanford_bunny.obj" 69451
if [ "$dragon" ]; then
  gzip -dc "$dragon" >"$folder/dragon.ply"
  row dragon "$folder/dragon.ply" 871414
  rm "$folder/dragon.ply"
fi
# Whether there are memory and disk for so many million triangles: 200 and 25 bytes for each.
has_room() {
  [ "$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo)" -ge $(($1 * 200)) ] &&
    [ "$(df -Pm "$folder" | awk 'NR == 2 { print $4 }')" -ge $(($1 * 25)) ]
}

for millions in 10 30; do
  if ! has_room $millions; then
    echo "torus ${millions} M: left out, it takes $((millions * 200)) MiB of memory and $((millions * 25)) MiB of disk"
    continue
  fi
  "$write_torus" $millions "$folder/torus.ply"
  row "torus ${millions} M" "$folder/torus.ply" ${millions}000000
done
