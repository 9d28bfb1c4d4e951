"""Makes structured grids and B-splines of the hexahedra of a bent bar, and carries a field to them and back."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'
data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

surface = XMLPolyDataReader(FileName=data + 'BentBarSmall.vtp')
hexahedra = ShapeHexRemesh(Surface=surface, Method='Polycube', CellsOnLongestSide=16)

# The third output is the grid of the polycube, with TargetPosition on the solid; the hexahedra have
# SourcePosition in the grid.
grid = OutputPort(hexahedra, 2)
field = Calculator(Input=grid, ResultArrayName='Wave', Function='sin(4*coordsX)')
on_solid = ShapeTransferFields(Input=hexahedra, Source=field, MapArray='SourcePosition')
on_solid.UpdatePipeline()
print('the field on the hexahedra: %.3f to %.3f' % on_solid.PointData['Wave'].GetRange())

blocks = ShapeStructuredBlocks(Input=field, NodesPerControl=1.5)
blocks.UpdatePipeline()
facts = shapemap.facts(blocks)
print('%d blocks, %d nodes, %d control points, largest error %.2g of the diagonal' % (
    facts['Blocks'], facts['Nodes'], facts['ControlPoints'], facts['RelativeError']))
assert facts['Blocks'] == 3 and facts['ControlPoints'] < facts['Nodes']
SaveData(os.path.join(folder, 'blocks.vtm'), blocks, DataMode='Binary')
