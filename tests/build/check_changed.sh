#!/usr/bin/env bash
# Checks that each source which recent commits changed compiles alone and without a warning: the build
# compiles several files as one, where a file may get by with the includes of another. Recent are the
# commits of the day before the newest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
alone=build/alone

command -v ninja >/dev/null || { echo "== Sources are not checked alone: ninja is not installed"; exit 0; }
newest=$(git log -1 --format=%ct 2>/dev/null) ||
  { echo "== Sources are not checked alone: this is no git checkout"; exit 0; }
mkdir -p $alone
cmake -S . -B $alone -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DCLAST_TESTS=ON \
  -DCLAST_COMPILE_TOGETHER=OFF -DCLAST_WERROR=ON -DCMAKE_CXX_FLAGS=-fsyntax-only >$alone/configure.log 2>&1 ||
  { cat $alone/configure.log >&2; exit 1; }
sources=()
while read -r source; do
  if grep -qF " $PWD/$source" $alone/build.ninja; then sources+=("$PWD/$source^"); fi
done < <(git log --since=$((newest - 86400)) --name-only --diff-filter=d --format= -- '*.cpp' | sort -u)
echo "== Checking ${#sources[@]} changed sources alone"
[ ${#sources[@]} -eq 0 ] || ninja -C $alone -k 0 --quiet "${sources[@]}"
