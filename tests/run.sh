#!/usr/bin/env bash
# Installs what is missing (Debian packages), builds clast and its tests, and runs them.
#
#   tests/run.sh         unit, physics, cli and validation-quick: about four minutes after the build
#   tests/run.sh --ci    long, validation and engines too: about 30 minutes
#   tests/run.sh --all   slow tests too
#
# The label engines loads exported particles in LIGGGHTS, MuJoCo and check_urdf, and in LAMMPS and
# YADE if they are installed.
#
# The validation tests read real data from the folder that CLAST_DATA names (default
# ../shared/data). Without that folder they are left out, except with --ci or CI=true, where they
# run and fail.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

labels="unit physics cli validation-quick"
ci=${CI:-false}
slow=false
for option in "$@"; do
  case "$option" in
    --ci) labels+=" long validation engines"; ci=true ;;
    --all) labels+=" long validation engines slow"; slow=true ;;
    *) sed -n '2,/^set/s/^# \{0,1\}//p' tests/run.sh >&2; exit 2 ;;
  esac
done

# With --ci the build may take so many compilations of tests/build/reference.cpp, a fifth more than
# it does.
most_compilations=73

# CPU seconds of the reference, two at a time.
reference_seconds() {
  local flags="-std=c++20 -O3 -I/usr/include/eigen3"
  for half in 1 2; do
    ( TIMEFORMAT="%U %S"; { time ${CXX:-g++} $flags -c tests/build/reference.cpp -o /dev/null; } 2>&1 | tail -1 ) &
  done | awk '{ sum += $1 + $2 } END { print sum / 2 }'
  wait
}

# Share of the compilations that the compiler's cache answered, in percent.
cache_hits() {
  [ -s build/ccache.log ] || { echo 0; return; }
  awk '/^(direct|preprocessed)_cache_hit$/ { hits++ } /^cache_miss$/ { misses++ }
       END { print hits + misses ? 100 * hits / (hits + misses) : 0 }' build/ccache.log
}

if [ "$ci" = true ]; then
  mkdir -p build
  rm -f build/ccache.log
  export CCACHE_STATSLOG=$PWD/build/ccache.log
fi
cmake/prepare.sh tests
if [ "$ci" = true ]; then
  reference=$(reference_seconds)
  hits=$(cache_hits)
  awk -v build="$(cat build/cpu_seconds.txt)" -v reference="$reference" -v hits="$hits" -v most=$most_compilations '
    BEGIN {
      printf "== The build took %.0f CPU s, %.1f times the reference (%.1f s); the cache answered %.0f %% of it\n",
             build, build / reference, reference, hits
      if (hits < 5 && build > most * reference) {
        printf "error: it may take %.0f times the reference\n", most >"/dev/stderr"
        exit 1
      }
    }'
fi

status=0
if [ "$ci" = true ]; then
  printf '== Compiling the changed files alone\n'
  tests/build/compile_alone.py || status=1
fi

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

if [ $slow = true ]; then cmake --build build/release --target slow_tests -j 2; fi

printf '== Running the tests labelled %s\n' "${labels// /, }"
ctest --test-dir build/release -j2 --output-on-failure --no-tests=error \
  -L "^(${labels// /|})\$" || status=1
if [ -n "${left_out-}" ]; then printf '== %s\n' "$left_out"; fi
if [ -s build/release/left_out.txt ]; then sed 's/^/== Left out: /' build/release/left_out.txt; fi
exit $status
