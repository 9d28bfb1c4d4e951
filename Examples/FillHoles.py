"""Fills the holes of a surface smoothly, so that it is closed."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

# A dented sphere with a cylinder cut out of it: two holes.
surface = OpenDataFile(data + 'DentedSphere600.vtp')
cut = Clip(Input=surface, ClipType='Cylinder', Invert=0)
cut.ClipType.Axis = [0.0, 0.0, 1.0]
cut.ClipType.Radius = 0.4
holes = Triangulate(Input=ExtractSurface(Input=cut))
closed = ShapeFillHoles(Input=holes)
closed.UpdatePipeline()

facts = shapemap.facts(closed)
for hole in zip(facts['LoopPoints'], facts['Triangles'], facts['Method']):
    print('hole of %d points: %d new triangles, %s' % hole)
assert len(facts['Loop']) == 2

# There are no open edges, and the new triangles are marked.
border = FeatureEdges(Input=closed, FeatureEdges=0, ManifoldEdges=0)
border.UpdatePipeline()
assert border.GetDataInformation().GetNumberOfCells() == 0
assert closed.CellData['Filled'].GetRange() == (0, 1)
