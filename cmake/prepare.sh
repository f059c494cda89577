#!/usr/bin/env bash
# Installs the Debian packages that are missing (and packages of npm in build/npm, for the tests),
# configures, and builds in build/release.
#
#   cmake/prepare.sh program   the clast program alone
#   cmake/prepare.sh tests     the program and its tests
#
# CLAST_JOBS sets the number of compilations at a time; the default is 2 at most, because one
# file that uses CGAL takes up to 2.2 GB of memory.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/release

say() { printf '== %s\n' "$*"; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

packages=(g++ cmake ninja-build libeigen3-dev libboost-dev libcgal-dev libassimp-dev libhdf5-dev
          libgdal-dev libpcl-dev libopencv-dev libpugixml-dev libssl-dev libpng-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
          libjs-three python3-plotly libopenmpi-dev openmpi-bin)
case "${1-}" in
  program) ;;
  tests) packages+=(libgtest-dev chromium colmap nodejs groff-base help2man
                    pybind11-dev python3-dev python3-numpy python3-pytest python3-jsonschema mkdocs mkdocs-material python3-pymdownx libjs-mathjax
                    python3-matplotlib python3-pandas liggghts liburdfdom-tools) ;;
  *) printf 'usage: %s program|tests\n' "$0" >&2; exit 2 ;;
esac

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "Not a Debian system: using the libraries that are here (${packages[*]})"
    return
  fi
  local package missing=() as_root=()
  for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "Every package needed is installed"
    return
  fi
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "these packages are missing, and installing them needs root or sudo." \
      "Ask whoever looks after this machine for: apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120)
  "${as_root[@]}" update || say "The package lists could not all be refreshed; going on with what is known"
  "${as_root[@]}" install -y --no-install-recommends "${missing[@]}" ||
    fail "apt-get could not install ${missing[*]} (its message is above)"
}

# Two at most, one for each 2.25 GB of free memory.
default_jobs() {
  local cores memory
  cores=$(nproc 2>/dev/null || echo 1)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 2359296) }' /proc/meminfo 2>/dev/null || true)
  local jobs=$((cores < 2 ? cores : 2))
  if [ -n "$memory" ] && [ "$memory" -lt "$jobs" ]; then jobs=$memory; fi
  echo $((jobs < 1 ? 1 : jobs))
}

# Tests run them with Node; without a package, its tests are left out. npm removes packages that a call
# does not name.
install_npm_packages() {
  local folder=build/npm
  if [ -d $folder/node_modules/laz-perf ] && [ -d $folder/node_modules/mujoco-js ]; then return; fi
  say "Installing laz-perf and mujoco-js in $folder"
  if ! command -v npm >/dev/null; then
    say "npm is not installed: tests of LAZ files through Node, and of MuJoCo, are left out"
  elif ! npm install --prefix $folder --no-save --no-audit --no-fund --loglevel=error \
    laz-perf@0.0.7 mujoco-js@0.0.7; then
    say "npm could not install laz-perf and mujoco-js: tests that use them are left out"
  fi
}

install_packages
if [ "$1" = tests ]; then install_npm_packages; fi

options=(-DCMAKE_BUILD_TYPE=Release)
targets=(all)
# A build folder keeps the generator it was made with, and the tests it already has.
if [ ! -f $build/CMakeCache.txt ]; then
  if command -v ninja >/dev/null; then options+=(-G Ninja); fi
  options+=(-DCLAST_TESTS=OFF)
fi
if [ "$1" = program ]; then targets=(clast help_files); else options+=(-DCLAST_TESTS=ON); fi

mkdir -p build
log=build/configure.log
say "Configuring in $build"
cmake -S . -B $build "${options[@]}" --log-level=WARNING >"$log" 2>&1 ||
  { cat "$log" >&2; fail "CMake could not configure clast (its message is above)"; }

jobs=${CLAST_JOBS:-$(default_jobs)}
say "Building with $jobs at a time; the first build takes some minutes"
# CPU seconds of what this shell has waited for, in `cpu`: of the build, for tests/run.sh.
read_cpu() {
  times >build/times.txt
  cpu=$(awk 'NR == 2 { split($1, user, /[ms]/); split($2, kernel, /[ms]/)
                       print 60 * (user[1] + kernel[1]) + user[2] + kernel[2] }' build/times.txt)
}
read_cpu
before=$cpu
cmake --build $build --target "${targets[@]}" -j "$jobs"
read_cpu
awk -v before="$before" -v after="$cpu" 'BEGIN { print after - before }' >build/cpu_seconds.txt
rm build/times.txt
