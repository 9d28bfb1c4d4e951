"""Fills the solid inside a surface with hexahedra, and saves them for Abaqus and for Gmsh."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# Any closed surface that ParaView reads: .stl, .ply, .obj, .vtp.
surface = OpenDataFile(data + 'BentBarSmall.vtp')
hexahedra = ShapeHexRemesh(Surface=surface, CellSize=0.2)
hexahedra.UpdatePipeline()

count = hexahedra.GetDataInformation().GetNumberOfCells()
minimum, maximum = hexahedra.CellData['ScaledJacobian'].GetRange()
distance = shapemap.facts(hexahedra)['Distance']
print('%d hexahedra, scaled Jacobian %.2f to %.2f, boundary within %.3f of the surface' % (
    count, minimum, maximum, distance))
assert minimum > 0.0 and distance < 0.2

# Bar.inp has regions as element sets, and boundary patches as node sets and surfaces. Bar.mesh has
# both as references.
SaveData(os.path.join(folder, 'Bar.inp'), hexahedra)
SaveData(os.path.join(folder, 'Bar.mesh'), hexahedra)
for name in ('Bar.inp', 'Bar.mesh'):
    print(name, os.path.getsize(os.path.join(folder, name)), 'bytes')
    assert os.path.getsize(os.path.join(folder, name)) > 50 * count
