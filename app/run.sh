#!/bin/sh
# Builds Ryosen and opens a mesh in the editor; without a display it makes a picture instead.
#   app/run.sh [FILE]        default: assets/stanford_bunny.obj
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/app/setup.sh"
configure_arguments=-DRYOSEN_TESTS=OFF
[ ! -f "$root/build/release/build.ninja" ] || configure_arguments=

# shellcheck disable=SC2086
ensure_packages $build_packages
build "$root/build/release" ryosen
program=$root/build/release/bin/ryosen
file=${1:-$root/assets/stanford_bunny.obj}

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  status=0
  "$program" "$file" || status=$?
  [ "$status" = 7 ] || exit "$status"
fi
picture=$(pwd)/bunny.png
if [ $# != 0 ]; then
  name=$(basename "$file")
  picture=$(pwd)/${name%.*}.png
fi
"$program" shot "$file" --panels -o "$picture"
echo "no display: the picture is in $picture"
