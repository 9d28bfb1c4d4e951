#!/usr/bin/env bash
# The Debian package in a clean Debian 12: install, use in the window, pvpython, pvserver and Python, remove;
# nothing is left. Needs root, debootstrap and the network, so it is not in the suite.
# TestDeb.sh PACKAGE.deb [FOLDER]: FOLDER keeps the Debian base and downloads for the next run (1 GB).
set -euo pipefail
package=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# Mounts are this process's own, and end with it.
if [ -z "${SHAPEMAP_UNSHARED:-}" ]; then
  SHAPEMAP_UNSHARED=1 exec unshare --mount --pid --fork "$0" "$@"
fi
folder=${2:-$(mktemp -d)}
base=$folder/base
if [ ! -f "$base/etc/debian_version" ]; then
  mkdir -p "$base"
  debootstrap --variant=minbase bookworm "$base" http://deb.debian.org/debian >"$folder/debootstrap.log"
fi
run=$(mktemp -d "$folder/run.XXXX")
mkdir "$run/upper" "$run/work" "$run/chroot"
trap 'umount -R -l "$run/chroot"; rm -rf "$run"' EXIT
mount -t overlay overlay -o "lowerdir=$base,upperdir=$run/upper,workdir=$run/work" "$run/chroot"
chroot=$run/chroot
mount -t proc proc "$chroot/proc"
mount --rbind /dev "$chroot/dev"
cp /etc/resolv.conf "$chroot/etc/"
echo "127.0.0.1 localhost" >"$chroot/etc/hosts"
in_chroot() { chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
as_user() { in_chroot setpriv --reuid=1000 --regid=1000 --clear-groups env HOME=/home/tester "$@"; }
files() { find "$chroot" -xdev \( -path "$chroot/proc" -o -path "$chroot/dev" \) -prune -o -iname '*shapemap*' -print -o -path '*paraview.conf' -print -o -iname '*vtkShape*' -print; }
quiet() { "$@" >"$run/log" 2>&1 || { tail -n 40 "$run/log"; exit 1; }; }

quiet in_chroot apt-get update
mkdir -p "$chroot/tmp/test" "$chroot/home/tester"
cp "$package" "$chroot/tmp/test/package.deb"
cp -r "$root/Testing/Packages/use" "$root/Data/DentedSphere600.vtp" "$chroot/tmp/test/"
in_chroot useradd --uid 1000 tester
chown -R 1000:1000 "$chroot/tmp/test" "$chroot/home/tester"
quiet in_chroot apt-get install -y --no-install-recommends xvfb xauth
before=$(du -sk --one-file-system "$chroot" | cut -f1)
quiet in_chroot apt-get install -y --no-install-recommends /tmp/test/package.deb
echo "installed, with all that it depends on: $((($(du -sk --one-file-system "$chroot" | cut -f1) - before) / 1024)) MiB"

screen=(xvfb-run -a -s "-screen 0 1600x1000x24 -noreset")
cd /
# As root, who could leave compiled files.
echo "Python:" && in_chroot /usr/bin/python3 /tmp/test/use/python.py
echo "pvpython:" && as_user "${screen[@]}" pvpython /tmp/test/use/pvpython.py
echo "pvserver:" && as_user "${screen[@]}" pvpython /tmp/test/use/pvpython.py server
echo "the window:" && as_user "${screen[@]}" paraview --dr --test-script=/tmp/test/use/window.xml --exit >"$run/log" 2>&1 ||
  { tail -n 40 "$run/log"; exit 1; }
cat "$chroot/tmp/test/window.txt"
[ "$(cat "$chroot/tmp/test/window.txt")" = "the filter of the menu ran" ]
[ -z "${SHAPEMAP_PICTURE:-}" ] || cp "$chroot/tmp/test/window.png" "$SHAPEMAP_PICTURE"

rm -rf "$chroot/tmp/test" "$chroot/home/tester"
quiet in_chroot apt-get purge -y shapemap
if files | grep .; then
  echo "these files are left"
  exit 1
fi
in_chroot dpkg -s paraview >/dev/null
echo "removed, and nothing is left"
