# Of runs.csv of `clast compare`, by shape: mean stop, and its range over members of the ensemble; shares of
# runs by deposit zone, whose edges are in `edges`. Runs that left the survey count where they left it.
# Of a table of measured stops (x, y, shape) the same, without members.
BEGIN { FS = ","; split(edges, edge, " ") }
FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
{ shape = $column["shape"]
  x = $(("stop_x_m" in column) ? column["stop_x_m"] : column["x"])
  runs[shape]++; sum[shape] += x
  zone = 1
  for (i = 1; i in edge; i++) if (x > edge[i]) zone = i + 1
  zones[shape, zone]++
  if ("ground_set" in column) { key = shape SUBSEP $column["ground_set"]; n[key]++; s[key] += x } }
END {
  for (k = 1; k <= 2; k++) {
    shape = k == 1 ? "compact" : "elongated"
    if (!runs[shape]) continue
    low = 1e9; high = -1e9
    for (key in n) {
      split(key, part, SUBSEP)
      if (part[1] != shape) continue
      mean = s[key] / n[key]
      if (mean < low) low = mean
      if (mean > high) high = mean
    }
    printf "%-10s %5d stops, mean x %.1f m", shape, runs[shape], sum[shape] / runs[shape]
    if (low <= high) printf " (members %.1f to %.1f)", low, high
    printf ", zones"
    for (zone = 1; zone <= 4; zone++) printf " %.1f", 100 * zones[shape, zone] / runs[shape]
    print " %"
  } }
