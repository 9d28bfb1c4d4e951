#!/usr/bin/env bash
# Makes a Debian package of the plugin and the Python package, for the ParaView of this system:
# Utilities/deb.sh [FOLDER], by default build-deb. Checks it by lintian where that is installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(realpath -m "${1:-build-deb}")
mkdir -p "$folder" build-deb
log=build-deb/deb.log
architecture=$(dpkg-architecture -q DEB_HOST_MULTIARCH)
{
  cmake -G Ninja -S . -B build-deb -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DSHAPEMAP_TESTS=OFF \
    -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_LIBDIR="lib/$architecture/shapemap" \
    -DCMAKE_SHARED_LINKER_FLAGS=-Wl,-z,relro,-z,now -DCMAKE_MODULE_LINKER_FLAGS=-Wl,-z,relro,-z,now
  cmake --build build-deb
  (cd build-deb && cpack -G DEB -B "$folder")
} >"$log" 2>&1 || { tail -n 40 "$log"; exit 1; }
for package in "$folder"/shapemap_*.deb; do
  echo "$package: $(stat -c %s "$package") bytes, $(dpkg-deb -f "$package" Installed-Size) KiB installed"
  if command -v lintian >/dev/null; then
    lintian --fail-on error,warning --display-info --tag-display-limit 0 --allow-root "$package"
  fi
done
