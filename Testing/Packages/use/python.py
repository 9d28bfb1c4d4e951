"""The Python package, in a Python that knows nothing of ParaView's plugins."""
import shapemap
from vtkmodules.vtkFiltersSources import vtkSphereSource

source = vtkSphereSource()
source.Update()
made = shapemap.hex_remesh(source.GetOutput(), method='Grid', cells_on_longest_side=5)
quality = shapemap.cell_array(made.hexahedra, 'ScaledJacobian')
assert len(quality) > 50 and quality.min() > 0.1, quality
print(len(quality), 'hexahedra')
