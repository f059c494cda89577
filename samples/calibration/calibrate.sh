#!/usr/bin/env bash
# Makes stops with known ground, then finds the ground from the stops of one lane of the sample quarry and
# predicts those of the other.
#
#   samples/calibration/calibrate.sh BLOCKS OUT
#
# BLOCKS is the library that demo.sh makes, out/blocks.h5; results go to OUT. CLAST is the program.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
[ $# -eq 2 ] || { echo "usage: $0 BLOCKS OUT" >&2; exit 2; }
mkdir -p "$2"
cp "$1" "$2/blocks.h5"
cd "$2"
clast=${CLAST:-clast}

# The ground that the made stops know, and the study does not.
friction=0.55
rolling_length=0.10

cp -r "$here/../terrain" "$here"/campaign-p?.toml "$here/study.toml" .
for lane in 1 2; do
  sed -e "/^\[ground.blue\]/,/^$/ { s/^friction .*/friction = $friction/
                                   s/^rolling_length_m .*/rolling_length_m = $rolling_length/ }" \
      -e 's/seed = 1/seed = 2/' "campaign-p$lane.toml" > "truth-p$lane.toml"
  "$clast" simulate "truth-p$lane.toml" -o "truth-p$lane.h5" --replace
  "$clast" compare "truth-p$lane.h5" -o "truth-p$lane" --replace
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; print "x,y"; next }
           { print $column["stop_x_m"] "," $column["stop_y_m"] }' \
    "truth-p$lane/runs.csv" > "stops-p$lane.csv"
done
"$clast" calibrate study.toml -o posterior.h5 --replace
