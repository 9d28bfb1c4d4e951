"""Maps a surface that consists of blocks: the filter joins them, and its output has the blocks."""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')
surface = OpenDataFile(data + 'DentedSphere600.vtp')

# Each of the two blocks is open, but together they are closed.
numbered = GenerateIds(Input=surface, CellIdsArrayName='Triangle')
halves = [ExtractSurface(Input=Threshold(Input=numbered, Scalars=['CELLS', 'Triangle'],
                                         LowerThreshold=first, UpperThreshold=first + 639))
          for first in (0, 640)]
sphere = ShapeParameterize(Input=GroupDatasets(Input=halves))
sphere.UpdatePipeline()

flipped = shapemap.facts(sphere)['FlippedTriangles']
low, high = sphere.PointData['TargetPosition'].GetRange(0)
print('flipped triangles: %d, sphere from x = %.3f to %.3f' % (flipped, low, high))
assert flipped == 0 and -1.0 <= low < -0.99 and 0.99 < high <= 1.0

blocks = servermanager.Fetch(sphere)
for number in range(2):
    print('block %d: %d triangles' % (number, blocks.GetBlock(number).GetNumberOfCells()))
    assert blocks.GetBlock(number).GetNumberOfCells() > 400
