"""Maps between shapes, without ParaView.

Each filter is a function: ``shapemap.hex_remesh(surface, cell_size=0.1)``. It takes VTK data sets or
numpy arrays, and returns its outputs by name, such as ``.hexahedra``, and ``.facts``. `points`, `cells`,
`point_array`, `cell_array` and `column` copy from them to numpy. The VTK classes are here, too, for
pipelines: ``shapemap.vtkShapeHexRemesh()``.
"""
from .vtkShapeFilters import *
from .data import *
from .functions import *
from .run import *
