"""Maps between shapes, without ParaView.

Each filter is a function: ``shapemap.hex_remesh(surface, cell_size=0.1)``. It takes VTK data sets or
numpy arrays, and returns its outputs by name, such as ``.hexahedra``, and ``.facts``. `points`, `cells`,
`point_array`, `cell_array` and `column` copy from them to numpy. The VTK classes are here, too, for
pipelines: ``shapemap.vtkShapeHexRemesh()``.
"""
import re as _re

try:
    from .vtkShapeFilters import *
except ImportError as error:
    # libvtkCommonCore-pv5.11.so.1 is ParaView's, libvtkCommonCore-9.1.so.1 plain VTK's.
    missing = _re.search(r'libvtk\w+?(?:\d+\.\d+)?-(pv)?([\d.]+)\.so', str(error))
    if not missing:
        raise
    raise ImportError('this build of shapemap needs the VTK of %s %s, which is missing: install %s, or make a '
                      'wheel for your VTK by Utilities/wheel.sh' % (
                          ('ParaView', missing.group(2), 'python3-paraview') if missing.group(1) else
                          ('version', missing.group(2), 'python3-vtk9'))) from error
from .data import *
from .functions import *
from .run import *
