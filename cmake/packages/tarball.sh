#!/usr/bin/env bash
# Packs the built program with the shared libraries and data that it needs, for systems without its
# packages: FOLDER/clast-VERSION-linux-MACHINE.tar.xz, which runs wherever it is unpacked (bin/clast).
# The C library is the system's, of the version printed at the end or newer. Needs patchelf.
#
#   tarball.sh BUILD VERSION GDAL_DATA PROJ_DATA THREE PLOTLY
set -euo pipefail
build=$1 version=$2 gdal=$3 proj=$4 three=$5 plotly=$6
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }
command -v patchelf >/dev/null || fail "patchelf is not installed (Debian: apt install patchelf)"
for data in "$gdal/gdalvrt.xsd" "$proj/proj.db" "$three/three.min.js" "$plotly/plotly.js"; do
  [ -e "$data" ] || fail "$data is not there"
done

name=clast-$version-linux-$(uname -m)
root=$build/tarball/$name
rm -rf "$build/tarball"
mkdir -p "$root/bin" "$root/lib" "$root/share"
for part in program reconstruct; do
  cmake --install "$build" --prefix "$root/program" --component $part --strip >/dev/null
done
mv "$root/program/share/"* "$root/share/"
rmdir "$root/program/share"
install -m 755 "$here/clast.sh" "$root/bin/clast"
programs=("$root/program/bin/clast" "$root/program/libexec/clast/"clast-{simulate,reconstruct})

# What every system has of the same C library that it has itself.
of_system='^(ld-linux.*|libc|libm|libdl|librt|libpthread|libresolv|libutil|libnsl|libanl|libmvec)\.so'
missing=$(ldd "${programs[@]}" | grep 'not found' || true)
[ -z "$missing" ] || fail "libraries are missing: $missing"
libraries=$(ldd "${programs[@]}" | awk '/=> \// { print $1, $3 }' | sort -u | grep -vE "$of_system")
while read -r library file; do install -m 644 "$file" "$root/lib/$library"; done <<<"$libraries"
for file in "$root"/lib/*; do patchelf --set-rpath '$ORIGIN' "$file"; done
patchelf --set-rpath '$ORIGIN/../../lib' "${programs[0]}"
patchelf --set-rpath '$ORIGIN/../../../lib' "${programs[@]:1}"

cp -rL "$gdal" "$root/share/gdal"
mkdir -p "$root/share/proj" "$root/share/three/examples/js/controls" "$root/share/plotly"
cp -L "$proj"/proj.db "$root/share/proj/"
cp -L "$three/three.min.js" "$root/share/three/"
cp -L "$three/examples/js/controls/OrbitControls.js" "$root/share/three/examples/js/controls/"
cp -L "$plotly/plotly.js" "$root/share/plotly/"
# Licences of what was copied out of packages.
if command -v dpkg >/dev/null; then
  mkdir "$root/share/licences"
  # The archive of packages may know a library below /lib that is found below /usr/lib.
  files=$(awk '{ print $2 }' <<<"$libraries" | xargs readlink -f | sort -u)
  { printf '%s\n' "$files" "${files//\/usr\/lib\//\/lib\/}" | xargs dpkg -S 2>/dev/null || true; } |
    sed 's/:.*//' | sort -u |
    while read -r package; do
      [ ! -e "/usr/share/doc/$package/copyright" ] ||
        cp -L "/usr/share/doc/$package/copyright" "$root/share/licences/$package"
    done
fi

tar -C "$build/tarball" -c "$name" | xz -T0 -3 >"$build/$name.tar.xz"
newest=$(for file in "${programs[@]}" "$root"/lib/*; do objdump -T "$file" 2>/dev/null; done |
  grep -o 'GLIBC_[0-9.]*' | sort -Vu | tail -1)
printf '%s: %s, runs with %s or newer\n' "$build/$name.tar.xz" \
  "$(du -h "$build/$name.tar.xz" | cut -f1)" "${newest/_/ }"
