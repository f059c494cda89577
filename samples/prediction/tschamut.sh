#!/usr/bin/env bash
# Another site with the ground that the quarry told: stops of the three blocks of Tschamut 2014.
#
#   samples/prediction/tschamut.sh DATA OUT
#
# DATA holds tschamut2014/ with terrain.asc, release_points.csv and observed_deposition.csv; OUT is the folder
# of a finished predict.sh. CLAST is the program.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
[ $# -eq 2 ] || { echo "usage: $0 DATA OUT" >&2; exit 2; }
export CLAST_DATA="$(cd "$1" && pwd)"
cd "$2"
clast=${CLAST:-clast}
site="$CLAST_DATA/tschamut2014"

# id, scanned block, I/L and S/L, L, mass: the sizes of block_metadata.csv.
rm -rf stretched-t blocks-tschamut.h5
while read -r id parent ratios length mass; do
  "$clast" vary forms.h5 "${parent}_vertices150" --to "$ratios" -o "stretched-t/$id.h5"
  "$clast" export "stretched-t/$id.h5" -o "stretched-t/$id"
  mv "stretched-t/$id/"*.shp "stretched-t/$id.shp"
  sed -i "s/^name .*/name $id/" "stretched-t/$id.shp"
  factor=$("$clast" show "stretched-t/$id.h5" | awk -v l="$length" 'NR == 2 { print l / $3 }')
  "$clast" reconstruct "stretched-t/$id.shp" -o blocks-tschamut.h5 --scale-factor "$factor" --mass "$mass"
done <<< "T1 SP1A 1.0000,0.8649 0.37 69
T2 SP2A 0.7800,0.6000 0.50 79
T4 SP3A 0.6522,0.4348 0.46 40"
rm -rf stretched-t

awk -F, 'NR > 1 && NR % 8 == 2 { print $3, $4, $5 }' "$site/release_points.csv" > starts-tschamut.xyz
awk -F, 'NR == 1 { print "x,y,start_x,start_y,block" } NR > 1 { print $3 "," $4 "," $7 "," $8 ",T" $11 }' \
  "$site/observed_deposition.csv" > field-tschamut.csv
cp "$here/campaign-tschamut.toml" .
"$clast" simulate campaign-tschamut.toml -o tschamut.h5 --replace
"$clast" compare tschamut.h5 -o tschamut --measured field-tschamut.csv --replace
