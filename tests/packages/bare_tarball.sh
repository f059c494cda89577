#!/usr/bin/env bash
# Unpacks the tarball of a build folder (target tarball) in a bare Debian 12, without any package that
# clast needs, and runs the demo there, as a user who is not root. Needs root, mmdebstrap and the
# package archive; takes some minutes.
#
#   tests/packages/bare_tarball.sh build/release
set -euo pipefail
build=$(cd "$1" && pwd)
root=$(mktemp -d)
clean() { ! mountpoint -q "$root/proc" || umount "$root/proc" && rm -rf "$root"; }
trap clean EXIT

mmdebstrap --quiet --variant=minbase bookworm "$root"
mount -t proc proc "$root/proc"
chroot "$root" useradd --create-home guest
tar -xJf "$build"/clast-*-linux-*.tar.xz -C "$root/home/guest"
chroot "$root" sh -c 'chown -R guest ~guest'
chroot "$root" su - guest -c 'cp -r clast-*/share/doc/clast/examples/samples . &&
  PATH=$(echo $HOME/clast-*/bin):$PATH samples/demo.sh'
test -s "$root/home/guest/out/report/report.html"
if grep -q "was left out" "$root/home/guest/out/report/report.html"; then
  echo "the report lacks a part, for want of data that the tarball should have" >&2
  exit 1
fi
echo "The demo ran out of the tarball."
