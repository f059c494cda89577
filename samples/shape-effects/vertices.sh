#!/usr/bin/env bash
# How many vertices a study of form takes: four forms of one finely scanned stone, each simplified
# to 60, 125, 250, 500, 1,000 and 2,000 vertices, 64 orientations x 3 release points each on the
# smooth slope. Writes only to out/shape-effects. docs/shape-effects.md says what comes out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=clast
[ -x build/release/app/clast ] && program=build/release/app/clast
clast() {
  printf '\n$ clast %s\n' "$*"
  command "$program" "$@"
}

mkdir -p out/shape-effects
clast reconstruct samples/shape-effects/B01_fine.ply --vertices 2000 \
  -o out/shape-effects/fine.h5 --replace
clast vary out/shape-effects/fine.h5 --to 0.96,0.92 --to 0.95,0.36 --to 0.65,0.36 --to 0.4,0.36 \
  -o out/shape-effects/fine_forms.h5 --replace
clast simulate samples/shape-effects/vertices.toml -o out/shape-effects/vertices.h5 --replace
clast compare out/shape-effects/vertices.h5 -o out/shape-effects/vertices --replace
printf '\nRuns by form and number of vertices: %s\n' "$PWD/out/shape-effects/vertices/runs.csv"
