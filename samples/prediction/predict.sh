#!/usr/bin/env bash
# The blind prediction of docs/prediction.md: makes the field's blocks, calibrates on one profile of the
# quarry, predicts the other, and the other way round.
#
#   samples/prediction/predict.sh DATA OUT
#
# DATA holds authume/ (samples/authume/README.md says where it comes from); results go to OUT. What was
# interrupted goes on when the command is given again. Variables for a try in a short time: MEMBERS and
# RELEASES instead of those of study.toml, PREDICTED members of the predictions, EVERY n-th block of the
# field alone. CLAST is the program.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
[ $# -eq 2 ] || { echo "usage: $0 DATA OUT" >&2; exit 2; }
export CLAST_DATA="$(cd "$1" && pwd)"
mkdir -p "$2"
cd "$2"
clast=${CLAST:-clast}
field="$CLAST_DATA/authume"

# The four scanned blocks: radii and masses of samples/authume/README.md; and with 150 vertices each, of
# the same volume, which are simulated in less time.
make_scans() {
  local id radius mass
  while read -r id radius mass; do
    "$clast" reconstruct "$field/blocks/$id.stl" -o scans.h5 --core --radius "$radius" --mass "$mass"
  done <<< "SP1A 0.027 343.5
SP2A 0.049 1472.5
SP2B 0.006 1767.5
SP3A 0.005 514.0"
  "$clast" vary scans.h5 --vertices 150 -o forms.h5
}

# A block for each surveyed stop: a scanned block of its class (in turn, where there are several),
# stretched to its I/L and S/L, and scaled until it has its mass at 2,500 kg/m3, the density of the
# scanned blocks. The taped L, I, S are rounded to 5 cm, so that the mass decides the size.
make_blocks() {
  local profile=$1 id parent ratios mass factor
  rm -rf "stretched-$profile"
  awk -v every="${EVERY:-1}" 'NR % every == 0 { elongated = $5 / $6 - 1 > 0.3
         split("SP1A SP2A SP2B", scans, " "); split("0.1370 0.5889 0.7079", volumes, " ")
         if (elongated) { parent = "SP3A"; volume = 0.2056 }
         else { k = compact++ % 3 + 1; parent = scans[k]; volume = volumes[k] }
         printf "F%02d %s %.4f,%.4f %s %.6f\n", NR, parent, $6 / $5, $7 / $5, $4,
                ($4 / 2500 / volume) ^ (1 / 3) }' "$field/field/Endpoints_P$profile.txt" |
  while read -r id parent ratios mass factor; do
    "$clast" vary forms.h5 "${parent}_vertices150" --to "$ratios" -o "stretched-$profile/$id.h5"
    "$clast" export "stretched-$profile/$id.h5" -o "stretched-$profile/$id"
    mv "stretched-$profile/$id/"*.shp "stretched-$profile/$id.shp"
    sed -i "s/^name .*/name $id/" "stretched-$profile/$id.shp"
    "$clast" reconstruct "stretched-$profile/$id.shp" -o "blocks-p$profile.h5" \
      --scale-factor "$factor" --mass "$mass"
  done
  rm -rf "stretched-$profile"
}

# 25 starts between the paper's four, which are the corners of a square of 4 m; and the stops as a table.
make_tables() {
  local profile=$1
  awk '{ x[NR] = $1; y[NR] = $2; z[NR] = $3 }
       END { for (i = 0; i < 5; i++) for (k = 0; k < 5; k++) { u = i / 4; v = k / 4
         a = (1 - u) * (1 - v); b = (1 - u) * v; c = u * v; d = u * (1 - v)
         printf "%.4f %.4f %.4f\n", a * x[1] + b * x[2] + c * x[3] + d * x[4], y[1],
                a * z[1] + b * z[2] + c * z[3] + d * z[4] } }' \
    "$field/drop/positions_P$profile.xyz" > "starts-p$profile.xyz"
  awk 'BEGIN { print "x,y,shape" }
       { print $1 "," (-$3) "," ($5 / $6 - 1 <= 0.3 ? "compact" : "elongated") }' \
    "$field/field/Endpoints_P$profile.txt" > "field-p$profile.csv"
}

# study.toml fits P2 and keeps P1; fit-p1 exchanges them, and takes over the simulations.
calibrate() {
  sed -e "${MEMBERS:+s/^members .*/members = $MEMBERS/}" \
      -e "${RELEASES:+s/^releases .*/releases = $RELEASES/}" "$here/study.toml" > fit-p2.toml
  sed -e 's/"fit"/"other"/; s/"keep"/"fit"/; s/"other"/"keep"/' fit-p2.toml > fit-p1.toml
  [ -e fit-p2.h5 ] || "$clast" calibrate fit-p2.toml -o fit-p2.h5 --resume
  [ -e fit-p1.h5 ] || { cp fit-p2.h5 begun.h5 && mv begun.h5 fit-p1.h5 &&
    "$clast" calibrate fit-p1.toml -o fit-p1.h5 --resume; }
}

# Every block of profile $1 with ground drawn from what the other profile, $2, told; $3 are the edges of its
# deposit zones.
predict() {
  sed -e "/^\[release\]/i [ensemble]\nmembers   = ${PREDICTED:-12}\nposterior = \"fit-p$2.h5\"\n" \
      -e "s/starts-p$1.xyz/corners-p$1.xyz/; s/random = 4/random = 1/" \
      "campaign-p$1.toml" > "predict-p$1.toml"
  sed -n '1p; 5p; 13p; 21p; 25p' "starts-p$1.xyz" > "corners-p$1.xyz"
  "$clast" simulate "predict-p$1.toml" -o "predict-p$1.h5" --resume
  "$clast" compare "predict-p$1.h5" -o "predict-p$1" --measured "field-p$1.csv" --replace
  echo "P$1, predicted, and measured:"
  awk -v edges="$3" -f "$here/stops.awk" "predict-p$1/runs.csv"
  awk -v edges="$3" -f "$here/stops.awk" "field-p$1.csv"
}

[ -e forms.h5 ] || make_scans
for profile in 1 2; do
  [ -e "blocks-p$profile.h5" ] || make_blocks "$profile"
  make_tables "$profile"
  cp "$here/campaign-p$profile.toml" .
done
calibrate
predict 1 2 "22 30 40"
predict 2 1 "25 45 57"
