#!/bin/sh
# Starts clast out of its tarball, wherever that was unpacked, with the data that lie beside it.
self=$0
while [ -L "$self" ]; do
  target=$(readlink "$self")
  case $target in /*) self=$target ;; *) self=$(dirname "$self")/$target ;; esac
done
root=$(cd "$(dirname "$self")/.." && pwd)
export GDAL_DATA="${GDAL_DATA-$root/share/gdal}"
export PROJ_DATA="${PROJ_DATA-$root/share/proj}" PROJ_LIB="${PROJ_LIB-$root/share/proj}"
export CLAST_THREE="${CLAST_THREE-$root/share/three}" CLAST_PLOTLY="${CLAST_PLOTLY-$root/share/plotly}"
exec "$root/program/bin/clast" "$@"
