"""Maps a surface whose pieces are on several processes; each process keeps its piece.

    SHAPEMAP_PVPYTHON="mpiexec -n 2 pvbatch" Utilities/pvpython.sh Examples/MapInParallel.py
"""
import os

import shapemap
from paraview.simple import *

data = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'Data', '')

surface = OpenDataFile(data + 'FigureASmall.vtp')
pieces = ExtractSurface(Input=RedistributeDataSet(Input=surface))
sphere = ShapeParameterize(Input=pieces, AreaWeight=3.0)
owners = ProcessIdScalars(Input=sphere)
owners.UpdatePipeline()

flipped = shapemap.facts(sphere)['FlippedTriangles']
processes = 1 + owners.PointData['ProcessId'].GetRange()[1]
triangles = owners.GetDataInformation().GetNumberOfCells()
print('%d triangles on %d process(es), %d flipped' % (triangles, processes, flipped))
assert flipped == 0 and triangles == surface.GetDataInformation().GetNumberOfCells()
for axis in range(3):
    low, high = owners.PointData['TargetPosition'].GetRange(axis)
    print('the image of all pieces: %s from %.3f to %.3f' % ('xyz'[axis], low, high))
    assert -1.0 <= low < -0.9 and 0.9 < high <= 1.0
