#!/bin/sh
# Runs fuzz targets from their corpora, as many at once as there are cores. Where one fails, prints the steps that lead
# there and keeps the input.
#   tests/fuzz/run.sh BUILD SECONDS [TARGET]     TARGET is the name of a corpus, else all of them; in 0 seconds each kept
#                                                input is run once, which needs no build that is guided by coverage
#   tests/fuzz/run.sh BUILD renew                makes the corpora anew from themselves and what the last runs found
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
build=$1
seconds=$2
targets=$(for corpus in "$folder"/corpus/*.tar.gz; do basename "$corpus" .tar.gz; done)

unpack() {  # TARGET: its corpus lies in $build/found/TARGET/corpus then, what runs find in found beside it
  found=$build/found/$1
  rm -rf "$found/corpus"
  mkdir -p "$found/found" "$found/corpus"
  tar -C "$found/corpus" -xzf "$folder/corpus/$1.tar.gz"
}

if [ "$seconds" = renew ]; then
  for name in $targets; do
    unpack "$name"
    rm -rf "$found/merged"
    mkdir "$found/merged"
    RYOSEN_FUZZ_TARGET=$name "$build/bin/fuzz" -merge=1 -use_counters=0 -max_len=600 -artifact_prefix="$found/" \
      "$found/merged" "$found/corpus" "$found/found"
    tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -C "$found/merged" -cf - . |
      gzip -9n >"$folder/corpus/$name.tar.gz"
  done
  exit
fi
if [ -z "${3:-}" ]; then
  echo "$targets" | xargs -P "$(nproc)" -I NAME sh "$0" "$build" "$seconds" NAME
  exit
fi

name=$3
export RYOSEN_FUZZ_TARGET="$name"
unpack "$name"
# A short run begins the same way each time, so that what fails it is most likely what has changed; a long one looks for
# more, and goes on from what earlier ones found.
seed=0
if [ "$seconds" -le 60 ]; then
  seed=1
  rm -rf "$found/found"
  mkdir "$found/found"
fi
# One allocation beyond what a file of this size may cost is a failure too: 64 MiB, and 64 times the longest input.
run() {
  "$build/bin/fuzz" -timeout=60 -malloc_limit_mb=65 -artifact_prefix="$found/" "$@" >"$found/log" 2>&1
}
if [ "$seconds" -eq 0 ]; then
  if run "$found/corpus"/*; then
    echo "$name: $(grep -a -c "^Executed " "$found/log") kept inputs run"
    exit
  fi
elif run "$found/found" "$found/corpus" -max_total_time="$seconds" -seed="$seed" -max_len=4096 -print_final_stats=1; then
  grep -a -E "^stat::(number_of_executed_units|average_exec_per_sec)" "$found/log" | sed "s/^/$name /"
  exit
fi
tail -n 40 "$found/log" >&2
for input in "$found"/crash-* "$found"/leak-* "$found"/timeout-* "$found"/oom-*; do
  [ -f "$input" ] || continue
  echo "the steps of $input:" >&2
  RYOSEN_FUZZ_TELL=1 "$build/bin/fuzz" "$input" 2>&1 | grep -a -v -E "^(INFO|Running|[^ ]*: Running)" | head -n 60 >&2
done
exit 1
