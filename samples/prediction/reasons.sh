#!/usr/bin/env bash
# What else could move the stops that predict.sh predicted, one thing at a time, with the ground that P2 told.
#
#   samples/prediction/reasons.sh OUT [CASE...]
#
# OUT is the folder of a finished predict.sh; without CASE all are run. Prints mean stops (x, m) of compact
# and elongated blocks on both profiles. CLAST is the program.
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: $0 OUT [CASE...]" >&2; exit 2; }
cd "$1"
shift
clast=${CLAST:-clast}
: "${CLAST_DATA:?set it to the folder that holds authume}"

# The campaign of profile $1 with eight draws of P2's posterior and two corners of the square as starts.
base() {
  sed -n '1p; 25p' "starts-p$1.xyz" > "two-p$1.xyz"
  sed -e '/^\[release\]/i [ensemble]\nmembers   = 8\nposterior = "fit-p2.h5"\n' \
      -e "s/starts-p$1.xyz/two-p$1.xyz/; s/random = 4/random = 1/" "campaign-p$1.toml"
}

# A surface of 0.5 m cells instead of the TIN, raised and lowered by $2 m at random, a height for each metre.
raster() {
  awk -v amplitude="$2" 'BEGIN { srand(1) }
    NR <= 6 { print; next }
    { for (i = 1; i <= NF; i++) {
        key = int(NR / 2) "," int(i / 2)
        if (!(key in bump)) bump[key] = amplitude * (2 * rand() - 1)
        printf "%s%s", $i == -9999 ? $i : sprintf("%.3f", $i + bump[key]), i < NF ? " " : "\n" } }' \
    "$CLAST_DATA/authume/gis/dem_0p5m.asc" > "ground-$2.asc"
  awk '{ print $1, -$3, $2 }' "two-p$1.xyz" > "two-up-p$1.xyz"
  awk -v file="ground-$2.asc" -v p="$1" '
    /^surface = \[/ { print "surface = \"" file "\""; skip = 1; next }
    skip { skip = !/^\]/; next }
    /^zones/ { print "zones = \"" ENVIRON["CLAST_DATA"] "/authume/gis/zones_0p5m.asc:1=blue,2=gray,3=red\""; next }
    /^up / { print "up = \"z\""; next }
    { sub("two-p" p, "two-up-p" p); print }'
}

campaign() {
  case $1 in
    as-predicted) base "$2" ;;
    pushed-1) base "$2" | sed '/^height_m/a velocity_m_s = [1.0, 0.0, 0.0]' ;;
    pushed-2) base "$2" | sed '/^height_m/a velocity_m_s = [2.0, 0.0, 0.0]' ;;
    spun) base "$2" | sed '/^height_m/a angular_velocity_rad_s = [0.0, 3.0, 0.0]' ;;
    higher) base "$2" | sed 's/^height_m .*/height_m = 2.0/' ;;
    elastoplastic) base "$2" | sed 's/"energy-restitution"/"elastoplastic"/' ;;
    slip) base "$2" | sed '/^\[ground/a slip_growth_per_m = 3.0\nfriction_min = 0.3\nslip_memory_s = 0.0054' ;;
    scar-drag) base "$2" | sed "/^\[ground/a scar_drag = 1.5\nsoil_density_kg_m3 = 1800.0" ;;
    raster) base "$2" | raster "$2" 0.0 ;;
    bumps) base "$2" | raster "$2" 0.15 ;;
    stay) base "$2" | sed -e "/^height_m/a sequence = \"stay\"\nrealisations = 2" \
        -e '/^\[contact\]/i [contact.blocks]\nenergy_restitution = 0.01\nfriction = 0.7\nrolling_friction = 0.2\n' ;;
    *) echo "$0: no case $1" >&2; exit 2 ;;
  esac
}

[ $# -gt 0 ] || set -- as-predicted pushed-1 pushed-2 spun higher elastoplastic slip scar-drag raster bumps stay
printf '%-14s %10s %10s %10s %10s\n' case "P1 compact" "elongated" "P2 compact" "elongated"
for name in "$@"; do
  means=()
  for profile in 1 2; do
    campaign "$name" "$profile" > "$name-p$profile.toml"
    "$clast" simulate "$name-p$profile.toml" -o "$name-p$profile.h5" --resume > "$name-p$profile.log" 2>&1
    "$clast" compare "$name-p$profile.h5" -o "$name-p$profile" --replace > /dev/null 2>&1
    means+=($(awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
      { n[$at["shape"]]++; x[$at["shape"]] += $at["stop_x_m"] }
      END { printf "%.1f %.1f\n", x["compact"] / n["compact"], x["elongated"] / n["elongated"] }' \
      "$name-p$profile/runs.csv"))
  done
  printf '%-14s %10s %10s %10s %10s\n' "$name" "${means[@]}"
done
