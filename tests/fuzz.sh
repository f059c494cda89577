#!/usr/bin/env bash
# Coverage-guided fuzzing of the readers under sanitizers (Debian packages clang and
# libclang-rt-14-dev): every file that libFuzzer makes must be read or refused with a message.
#
#   tests/fuzz.sh SECONDS [READER ...]   so long for each reader, as many at a time as there are cores
#
# build/fuzz/tests/app/fuzz/guided_fuzz lists the readers. Files that reach new code are kept in
# build/fuzz/corpus for the next time, files at fault in build/fuzz/found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if ! [[ ${1-} =~ ^[1-9][0-9]*$ ]]; then
  sed -n '2,/^set/s/^# \{0,1\}//p' tests/fuzz.sh >&2
  exit 2
fi
seconds=$1
shift

cmake --preset fuzz --log-level=WARNING
cmake --build --preset fuzz
program=$PWD/build/fuzz/tests/app/fuzz/guided_fuzz

fuzz() {
  local corpus=$PWD/build/fuzz/corpus/$1 found=$PWD/build/fuzz/found/$1
  local log=$PWD/build/fuzz/found/$1.log
  mkdir -p "$corpus" "$found"
  # 2 GB for one allocation: a count in a header must not be believed. 120 s for one file: repairs
  # take up to fifty times as long here. Leaks are those of libraries after files that they refuse.
  local status=0
  ASAN_OPTIONS=detect_leaks=0 "$program" "$1" -max_total_time="$seconds" -timeout=120 \
    -malloc_limit_mb=2048 -rss_limit_mb=4096 -verbosity=1 -print_final_stats=1 \
    -artifact_prefix="$found/" "$corpus" >"$log" 2>&1 || status=$?
  local files
  files=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  printf '%s: %s files, %s\n' "$1" "${files:-some}" \
    "$([ $status = 0 ] && echo 'none at fault' || echo "at fault: see $log")"
  return $status
}
export -f fuzz
export program seconds

if [ $# = 0 ]; then mapfile -t readers < <("$program"); else readers=("$@"); fi
printf '%s\0' "${readers[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'fuzz "$0"'
