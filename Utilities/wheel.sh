#!/usr/bin/env bash
# Makes a wheel of the Python package shapemap: Utilities/wheel.sh [FOLDER], by default build/wheel.
# It holds the functions, the extension and the filters' library, and links to the VTK of this system,
# which its version names: +pv5.11 is that of Debian's python3-paraview, +vtk9.1 that of python3-vtk9.
# SHAPEMAP_PREFIX names another build than build/.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${SHAPEMAP_PREFIX:-$root/build}
folder=${1:-$build/wheel}
[ -f "$build/lib/python3/dist-packages/shapemap/functions.py" ] || "$root/Utilities/setup.sh" plugin
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$build" --prefix "$prefix" --strip >"$prefix/log" || { cat "$prefix/log"; exit 1; }
/usr/bin/python3 -B "$root/Utilities/wheel.py" "$root" "$build" "$prefix" "$folder"
