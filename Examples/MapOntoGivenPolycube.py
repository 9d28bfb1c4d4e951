"""Maps a two-holed torus onto a polycube made by hand, and fills it with the polycube's hexahedra."""
import os
import sys

import shapemap
from paraview.simple import *

folder = sys.argv[1] if len(sys.argv) > 1 else '.'

# The polycube: 5 x 3 x 1 cubes without two, each of 4 x 4 x 4 cells.
cells = Calculator(Input=Wavelet(WholeExtent=[-10, 10, -6, 6, -2, 2]), ResultArrayName='Hole',
                   Function='max(abs(abs(coordsX)-4),abs(coordsY))')
walls = Threshold(Input=PointDatatoCellData(Input=cells), Scalars=['CELLS', 'Hole'], LowerThreshold=2.0, UpperThreshold=20)
polycube = ExtractSurface(Input=walls)

# Landmarks at both ends, and in the middles of the walls of both holes.
torus = ShapeExample(Shape='Two-Holed Torus')
torus.UpdatePipeline()
bounds = torus.GetDataInformation().GetBounds()
places = [(-10, 0, 0), (10, 0, 0)]
places += [(x + dx, dy, 0) for x in (-4, 4) for dx, dy in ((-2, 0), (2, 0), (0, -2), (0, 2))]
scales = [(bounds[1] - bounds[0]) / 20, (bounds[3] - bounds[2]) / 12, (bounds[5] - bounds[4]) / 4]
landmarks = ShapeLandmarks(SurfaceA=polycube, SurfaceB=torus, PointsA=[x for place in places for x in place],
                           PointsB=[x * scale for place in places for x, scale in zip(place, scales)])
match = ShapeCorrespondence(SurfaceA=polycube, SurfaceB=torus, Landmarks=landmarks, Method='CommonBase')
match.UpdatePipeline()
facts = shapemap.facts(match)
print('%d landmarks, %d triangles flipped' % (facts['Landmarks'], facts['FlippedTriangles']))
assert facts['GenusOfA'] == 2 and facts['FlippedTriangles'] == 0

# The harmonic volume map of the polycube, whose boundary goes onto the torus, carries its cells.
hexahedra = ShapeHexRemesh(Surface=torus, Polycube=match, CellSize=0.2)
hexahedra.UpdatePipeline()
minimum, maximum = hexahedra.CellData['ScaledJacobian'].GetRange()
print('scaled Jacobian of the hexahedra: %.2f to %.2f' % (minimum, maximum))
assert minimum > 0.0
SaveData(os.path.join(folder, 'PolycubeHexahedra.vtu'), hexahedra, DataMode='Binary')
