#!/usr/bin/env bash
# What form alone does: 66 forms of one scan at equal mass, all over the triangle of Sneed and Folk,
# on a smooth slope, a stepped slope and the sample quarry, 64 orientations x 3 release points each.
# Writes only to out/shape-effects. docs/shape-effects.md says what comes out and how long it takes.
#   samples/shape-effects/run.sh [ORIENTATIONS] [VERTICES]
# Fewer orientations, or forms with fewer vertices, are faster.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=clast
[ -x build/release/app/clast ] && program=build/release/app/clast
orientations=${1:-64}
vertices=(${2:+--vertices "$2"})

clast() {
  printf '\n$ clast %s\n' "$*"
  command "$program" "$@"
}

mkdir -p out/shape-effects
clast reconstruct samples/blocks/B01_compact.ply -o out/shape-effects/scan.h5 --replace "${vertices[@]}"
for slope in smooth stepped quarry; do
  campaign=samples/shape-effects/$slope.toml
  if [ "$orientations" != 64 ]; then
    campaign=samples/shape-effects/.$slope.toml  # beside the other, whose paths are relative
    sed "s/random = 64/random = $orientations/" "samples/shape-effects/$slope.toml" > "$campaign"
  fi
  clast simulate "$campaign" -o "out/shape-effects/$slope.h5" --replace
  [ "$orientations" = 64 ] || rm "$campaign"
  clast compare "out/shape-effects/$slope.h5" --effects --margin 2 \
    -o "out/shape-effects/$slope" --replace
done
printf '\nThe reports, to open in a browser:\n'
printf '%s\n' "$PWD"/out/shape-effects/{smooth,stepped,quarry}/report.html
