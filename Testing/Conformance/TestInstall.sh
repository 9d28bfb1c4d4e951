#!/usr/bin/env bash
# What `cmake --install` gives works on its own: the plugin in a stock ParaView, the Python package in
# the system's Python, the CMake package in somebody else's project. TestInstall.sh BUILD
set -euo pipefail
build=$1
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
unset PV_PLUGIN_PATH PYTHONPATH LD_LIBRARY_PATH
cmake --install "$build" --prefix "$prefix" >"$prefix/log" || { cat "$prefix/log"; exit 1; }

echo "the plugin:"
PV_PLUGIN_PATH=$(dirname "$(find "$prefix" -name ShapeMap.so)") pvpython - <<'PY'
from paraview.simple import *
sphere = ShapeParameterize(Input=Sphere(ThetaResolution=16))
sphere.UpdatePipeline()
low, high = OutputPort(sphere, 1).GetDataInformation().GetBounds()[:2]
assert 1.9 < high - low <= 2.0, (low, high)
print('ShapeParameterize found and run')
PY

echo "the Python package:"
export PYTHONPATH=$prefix/lib/python3/dist-packages
/usr/bin/python3 - <<'PY'
import shapemap
from vtkmodules.vtkFiltersSources import vtkSphereSource
source = vtkSphereSource()
sphere = shapemap.vtkShapeParameterize()
sphere.SetInputConnection(source.GetOutputPort())
sphere.Update()
assert sphere.GetOutputDataObject(1).GetNumberOfPoints() == 50
print(shapemap.__file__.split('/')[-2], 'imported and run')
PY
/usr/bin/python3 "$root/Testing/optionalreaders.py"
unset PYTHONPATH

echo "the command:"
mkdir "$prefix/in"
cp "$root/Data/DentedSphere600.vtp" "$prefix/in"
"$prefix/bin/shapemap" solidify "$prefix/in" "$prefix/out"
test -s "$prefix/out/DentedSphere600.vtp"

echo "the CMake package, for the examples in C++:"
cmake -G Ninja -S "$root/Examples/CPlusPlus" -B "$prefix/examples" -DCMAKE_PREFIX_PATH="$prefix" \
  >"$prefix/log" 2>&1 || { cat "$prefix/log"; exit 1; }
cmake --build "$prefix/examples" >"$prefix/log" 2>&1 || { cat "$prefix/log"; exit 1; }
"$prefix/examples/FillWithHexahedra" "$root/Data/BentBarSmall.vtp" "$prefix/examples/Bar.mesh"
"$prefix/examples/MapPointIntoBall" "$root/Data/DentedSphere600.vtp"

if grep -rl --exclude-dir=examples --exclude=log "$build" "$prefix"; then
  echo "these installed files name the build folder"
  exit 1
fi
