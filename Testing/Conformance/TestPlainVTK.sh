#!/usr/bin/env bash
# ShapeMap without ParaView: the filters and their Python package against plain VTK.
# TestPlainVTK.sh BUILD VTK_DIR
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
plain=${1%/}-plain-vtk # beside the other build: the compiler cache knows most of it
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -G Ninja -S "$root" -B "$plain" -DCMAKE_BUILD_TYPE=Release -DSHAPEMAP_PARAVIEW=OFF \
  -DSHAPEMAP_TESTS=OFF -DSHAPEMAP_TETGEN=OFF -DSHAPEMAP_OCCT=OFF -DSHAPEMAP_OPENCV=OFF \
  -DSHAPEMAP_OPENCL=OFF -DSHAPEMAP_ITK=OFF -DSHAPEMAP_CHOLMOD=OFF -DVTK_DIR="$2" \
  -DCMAKE_UNITY_BUILD="$(sed -n 's/^CMAKE_UNITY_BUILD:[A-Z]*=//p' "$1/CMakeCache.txt")" >"$log" 2>&1 || { cat "$log"; exit 1; }
cmake --build "$plain" >"$log" 2>&1 || { cat "$log"; exit 1; }
if find "$plain" -name 'ShapeMap.so' | grep .; then
  echo "there is a plugin in a build without ParaView"
  exit 1
fi
PYTHONPATH=$plain/lib/python3/dist-packages /usr/bin/python3 - <<'PY'
import shapemap
from vtkmodules.vtkFiltersSources import vtkSphereSource
source = vtkSphereSource()
sphere = shapemap.vtkShapeParameterize()
sphere.SetInputConnection(source.GetOutputPort())
volume = shapemap.vtkShapeHarmonicVolumeMap()
volume.SetInputConnection(0, source.GetOutputPort())
volume.SetInputConnection(1, sphere.GetOutputPort(0))
volume.Update()
assert volume.GetOutputDataObject(0).GetNumberOfPoints() == 50
tetrahedra = shapemap.vtkShapeTetrahedralize()
tetrahedra.SetInputConnection(source.GetOutputPort())
refusals = []
tetrahedra.AddObserver('ErrorEvent', lambda *_: refusals.append('error'))
tetrahedra.Update()
assert refusals and tetrahedra.GetOutputDataObject(0).GetNumberOfCells() == 0
print('the filters run without ParaView, TetGen, OpenCASCADE, OpenCV, OpenCL, ITK and CHOLMOD')
PY
