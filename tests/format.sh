#!/bin/sh
# Fails where a source is not as clang-format 14 makes it by .clang-format; with --fix formats every source.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
mode="--dry-run -Werror"
[ "${1:-}" != --fix ] || mode=-i
# shellcheck disable=SC2086
find "$root/app" "$root/core" "$root/render" "$root/tests" \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -P "$(nproc)" -n 100 clang-format --style="file:$root/.clang-format" $mode
