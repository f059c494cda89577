#!/usr/bin/env bash
# Installs the packages of a build folder (cpack -G DEB) in a bare Debian 12 and runs the demo there, as
# a user who is not root. Needs root, mmdebstrap and the package archive; takes some minutes.
#
#   tests/packages/bare_root.sh build/release
set -euo pipefail
build=$(cd "$1" && pwd)
root=$(mktemp -d)
clean() { ! mountpoint -q "$root/proc" || umount "$root/proc" && rm -rf "$root"; }
trap clean EXIT

mmdebstrap --quiet --variant=apt bookworm "$root"
mount -t proc proc "$root/proc"
mkdir "$root/packages"
cp "$build"/clast_*.deb "$build"/clast-reconstruct_*.deb "$build"/python3-clast_*.deb "$root/packages/"
in_root() { chroot "$root" /usr/bin/env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin "$@"; }
in_root DEBIAN_FRONTEND=noninteractive sh -c 'apt-get -q update'

# The program alone does what needs no scan, and says what is missing for the rest.
in_root DEBIAN_FRONTEND=noninteractive \
  sh -c 'apt-get -q -o Dpkg::Use-Pty=0 install -y --no-install-recommends /packages/clast_*.deb' >"$root/packages/apt.log"
in_root useradd --create-home guest
in_root clast --version
if message=$(in_root clast reconstruct x.ply 2>&1); then
  echo "clast reconstruct works without its package" >&2
  exit 1
fi
case "$message" in
  *clast-reconstruct*) ;;
  *) printf 'the package that is missing is not named: %s\n' "$message" >&2; exit 1 ;;
esac

in_root DEBIAN_FRONTEND=noninteractive \
  sh -c 'apt-get -q -o Dpkg::Use-Pty=0 install -y --no-install-recommends /packages/clast-reconstruct_*.deb' >>"$root/packages/apt.log"
chroot "$root" su - guest -c 'cp -r /usr/share/doc/clast/examples/samples . && samples/demo.sh'
test -s "$root/home/guest/out/report/report.html"

# The module, on the blocks and the results of the demo.
in_root DEBIAN_FRONTEND=noninteractive \
  sh -c 'apt-get -q -o Dpkg::Use-Pty=0 install -y --no-install-recommends /packages/python3-clast_*.deb' >>"$root/packages/apt.log"
cat >"$root/home/guest/module.py" <<'PYTHON'
import clast

blocks = clast.Library("out/blocks.h5")
assert blocks.ids and blocks[blocks.ids[0]].mass > 0
assert clast.Results("out/results.h5").runs.rows > 0
again = clast.reconstruct("samples/blocks/B01_compact.ply", vertices=30, density=2650.0)
assert again.volume > 0
print(f"The module {clast.__version__} works.")
PYTHON
chroot "$root" su - guest -c 'python3 -W error module.py'
echo "The demo ran from the installed packages."
