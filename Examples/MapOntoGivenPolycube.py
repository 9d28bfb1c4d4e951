"""Maps a two-holed torus onto a polycube made by hand, and fills it with the polycube's hexahedra."""
import os
import sys

import numpy
import shapemap
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# The polycube: 5 x 3 x 1 cubes without two, each of 4 x 4 x 4 cells.
solid = numpy.ones((4, 12, 20), int)
solid[:, 4:8, 4:8] = solid[:, 4:8, 12:16] = 0
image, values = vtkImageData(), numpy_to_vtk(solid.ravel(), deep=True)
image.SetDimensions(21, 13, 5)
image.SetOrigin(-10, -6, -2)
values.SetName('Solid')
image.GetCellData().AddArray(values)
cells = TrivialProducer()
cells.GetClientSideObject().SetOutput(image)
cells = Threshold(Input=cells, Scalars=['CELLS', 'Solid'], LowerThreshold=1, UpperThreshold=1)
polycube = Triangulate(Input=ExtractSurface(Input=cells))

# Landmarks at both ends, and in the middles of the walls of both holes.
torus = ShapeExample(Shape='Two-Holed Torus')
torus.UpdatePipeline()
bounds = torus.GetDataInformation().GetBounds()
places = [(-10, 0, 0), (10, 0, 0)]
places += [(x + dx, dy, 0) for x in (-4, 4) for dx, dy in ((-2, 0), (2, 0), (0, -2), (0, 2))]
scales = [(bounds[1] - bounds[0]) / 20, (bounds[3] - bounds[2]) / 12, (bounds[5] - bounds[4]) / 4]
landmarks = ShapeLandmarks(SurfaceA=torus, SurfaceB=polycube,
                           PointsA=[x * scale for place in places for x, scale in zip(place, scales)],
                           PointsB=[x for place in places for x in place])
match = ShapeCorrespondence(SurfaceA=torus, SurfaceB=polycube, Landmarks=landmarks, Method='CommonBase')
match.UpdatePipeline()
facts = shapemap.facts(match)
print('%d landmarks, %d triangles flipped' % (facts['Landmarks'], facts['FlippedTriangles']))
assert facts['GenusOfA'] == 2 and facts['FlippedTriangles'] == 0

# The harmonic volume map of the polycube, whose boundary goes onto the torus, carries its cells.
source = Calculator(Input=OutputPort(match, 1), ResultArrayName='SourcePosition', Function='TargetPosition')
hexahedra = ShapeHexRemesh(Surface=torus, Polycube=source, CellSize=0.2)
hexahedra.UpdatePipeline()
minimum, maximum = hexahedra.CellData['ScaledJacobian'].GetRange()
print('%d hexahedra, scaled Jacobian %.2f to %.2f' % (
    hexahedra.GetDataInformation().GetNumberOfCells(), minimum, maximum))
assert minimum > 0.0
SaveData(os.path.join(folder, 'PolycubeHexahedra.vtu'), hexahedra, DataMode='Binary')
