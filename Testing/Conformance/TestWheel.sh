#!/usr/bin/env bash
# The wheel in a virtual environment that has the system's VTK and numpy: it installs, runs, is what it
# says, and goes away. TestWheel.sh BUILD
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset PV_PLUGIN_PATH PYTHONPATH LD_LIBRARY_PATH
SHAPEMAP_PREFIX=$1 "$root/Utilities/wheel.sh" "$folder"
/usr/bin/python3 -m venv --system-site-packages "$folder/venv"
cd "$folder"
"$folder/venv/bin/pip" install --quiet --no-index "$folder"/shapemap-*.whl
"$folder/venv/bin/python" - "$folder/venv" <<'PY'
import importlib.metadata
import sys
import shapemap
from vtkmodules.vtkFiltersSources import vtkSphereSource

assert shapemap.__file__.startswith(sys.argv[1]), shapemap.__file__
described = importlib.metadata.metadata('shapemap')
assert described['Version'].split('+')[1].startswith(('pv', 'vtk')) and 'BSD-3-Clause' in described['License']
assert 'shapemap' in open('/proc/self/maps').read().split('libvtkShapeFilters')[0].rsplit('\n', 1)[1]
source = vtkSphereSource()
source.Update()
made = shapemap.hex_remesh(
    shapemap.points(source.GetOutput()), shapemap.cells(source.GetOutput()), method='Grid', cells_on_longest_side=5)
quality = shapemap.cell_array(made.hexahedra, 'ScaledJacobian')
assert len(quality) > 50 and quality.min() > 0.1, quality
print('%s, %s: %d hexahedra' % (described['Version'], described['License'], len(quality)))
PY
"$folder/venv/bin/python" "$root/Testing/optionalreaders.py"
[ "$("$folder/venv/bin/shapemap" --version)" = "$("$folder/venv/bin/python" -m shapemap --version)" ]

# Without the VTK for which it was made, it says what is missing and what to do.
"$folder/venv/bin/python" - "$folder/venv" <<'PY'
import glob
import re
import subprocess
import sys

extension, = glob.glob(sys.argv[1] + '/lib/python*/site-packages/shapemap/vtkShapeFilters*.so')
content = open(extension, 'rb').read()
suffix = re.search(rb'libvtkCommonCore(-[pv\d.]+)\.so', content).group(1)
other = re.sub(rb'\d', b'8', suffix)
open(extension, 'wb').write(content.replace(suffix + b'.so', other + b'.so'))
printed = subprocess.run([sys.executable, '-c', 'import shapemap'], stderr=subprocess.PIPE, text=True).stderr
needs = '%s %s' % ('ParaView' if b'pv' in other else 'version', other.decode().lstrip('-pv'))
assert printed.endswith('wheel for your VTK by Utilities/wheel.sh\n') and needs in printed.splitlines()[-1], printed
open(extension, 'wb').write(content)
PY
if unzip -p "$folder"/shapemap-*.whl | grep -a "$1"; then
  echo "the wheel names the build folder"
  exit 1
fi
"$folder/venv/bin/pip" uninstall --quiet --yes shapemap
if find "$folder/venv" -iname '*shapemap*' -o -iname '*vtkShape*' | grep .; then
  echo "these files are left"
  exit 1
fi
