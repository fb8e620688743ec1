#!/bin/sh
# Runs every fuzz target from its corpus. Where one fails, prints the steps that lead there and keeps the input.
#   tests/fuzz/run.sh BUILD SECONDS
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
build=$1
seconds=$2
for target in "$folder"/*_fuzz.cpp; do
  name=$(basename "$target" .cpp)
  found=$build/$name
  mkdir -p "$found/found"
  if "$build/bin/$name" "$found/found" "$folder/corpus/${name%_fuzz}" -max_total_time="$seconds" -timeout=10 \
    -artifact_prefix="$found/" -print_final_stats=1 >"$found/log" 2>&1; then
    grep -E "^stat::(number_of_executed_units|average_exec_per_sec)" "$found/log" | sed "s/^/$name /"
    continue
  fi
  tail -n 40 "$found/log" >&2
  for input in "$found"/crash-* "$found"/leak-* "$found"/timeout-* "$found"/oom-*; do
    [ -f "$input" ] || continue
    echo "the steps of $input:" >&2
    RYOSEN_FUZZ_TELL=1 "$build/bin/$name" "$input" 2>&1 | grep -v -E "^(INFO|Running|[^ ]*: Running)" | head -n 60 >&2
  done
  exit 1
done
