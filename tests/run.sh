#!/usr/bin/env bash
# Installs what is missing (Debian packages), builds clast and its tests, and runs them.
#
#   tests/run.sh         unit, physics, cli and validation-quick: about four minutes after the build
#   tests/run.sh --ci    long and validation too: about 30 minutes
#   tests/run.sh --all   slow tests too
#
# The validation tests read real data from the folder that CLAST_DATA names (default
# ../shared/data). Without that folder they are left out, except with --ci or CI=true, where they
# run and fail.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

labels="unit physics cli validation-quick"
ci=${CI:-false}
for option in "$@"; do
  case "$option" in
    --ci) labels+=" long validation"; ci=true ;;
    --all) labels+=" long validation slow" ;;
    *) sed -n '2,/^set/s/^# \{0,1\}//p' tests/run.sh >&2; exit 2 ;;
  esac
done

cmake/prepare.sh tests

data=${CLAST_DATA:-../shared/data}
if [ -d "$data" ]; then
  # Tests run in other folders, so the path must not depend on this one.
  CLAST_DATA=$(cd "$data" && pwd)
  export CLAST_DATA
elif [ "$ci" != true ]; then
  labels=$(printf '%s\n' $labels | grep -v '^validation' | xargs)
  left_out="Validation tests were left out: no data folder at $data (set CLAST_DATA to it; see samples/authume/README.md)"
  printf '== %s\n' "$left_out"
fi

printf '== Running the tests labelled %s\n' "${labels// /, }"
status=0
ctest --test-dir build/release -j2 --output-on-failure --no-tests=error \
  -L "^(${labels// /|})\$" || status=$?
if [ -n "${left_out-}" ]; then printf '== %s\n' "$left_out"; fi
exit $status
