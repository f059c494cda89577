#!/usr/bin/env bash
# From the scans in samples/blocks to an HTML report, in one command. In a checkout it installs what
# is missing (Debian packages), builds clast, and writes only to build/ and out/; in a copy of the
# samples it takes the installed clast, and writes to out/. Can be run again at any time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

program=clast
if [ -x cmake/prepare.sh ]; then
  cmake/prepare.sh program
  program=build/release/app/clast
fi

clast() {
  printf '\n$ clast %s\n' "$*"
  command "$program" "$@"
}

mkdir -p out
clast reconstruct samples/blocks/B*.ply -o out/blocks.h5 --replace
clast show out/blocks.h5 --report out/gallery --replace
clast classify samples/talus.csv --against out/blocks.h5 -o out/classes --replace
# A demo that was interrupted left runs behind, which simulate keeps until it is told what to do.
rm -f out/results.h5.part* out/mass.h5.part*
clast simulate samples/campaign.toml -o out/results.h5 --replace
clast compare out/results.h5 -o out/report --replace
clast simulate samples/mass.toml -o out/mass.h5 --replace
clast compare out/mass.h5 -o out/mass --replace

printf '\nThe reports on single blocks and on a rock mass, and the blocks, to open in a browser:\n%s\n%s\n%s\n' \
  "$PWD/out/report/report.html" "$PWD/out/mass/report.html" "$PWD/out/gallery/gallery.html"
