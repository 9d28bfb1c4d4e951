"""In parallel, strokes cross the pieces of the processes: every point gets the value that it has in the whole.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
three: TestDistributedPaint.py FOLDER."""
import os
import sys

import numpy
import shapemap

import shapetesting
from shapetesting import array, points

processes, rank = shapetesting.parallel()
truth = os.path.join(sys.argv[1], 'DistributedPaint.npy')
surface = shapetesting.read('DentedSphere600.vtp')
every = points(surface).copy()
path = every[numpy.argsort(every[:, 0])[::40]]
piece = surface
if processes > 1:
    middles = every[shapetesting.triangles(surface)].mean(axis=1)[:, 0]
    order = numpy.argsort(numpy.argsort(middles)) * processes // len(middles)
    piece = shapetesting.with_cells(surface, numpy.flatnonzero(order == rank).tolist())

made = shapetesting.new(shapemap.vtkShapePaintArray, piece)
for stroke, brush in enumerate(((0, 0.5, 1.0, 3.0), (1, 0.7, 0.5, -1.0), (2, 0.8, 0.7, 0.0))):
    made.SetStrokes(stroke, *brush, len(path))
    for i, place in enumerate(path):
        made.SetStrokePoints(stroke * len(path) + i, *place)
data = shapetesting.outputs(made)[0]
if processes == 1:
    numpy.save(truth, array(data, 'Painted'))
else:
    wanted = {tuple(place): value for place, value in zip(every, numpy.load(truth))}
    found = array(data, 'Painted')
    assert len(found) > 100 and numpy.ptp(found) > 0.5
    for place, value in zip(points(data), found):
        assert abs(wanted[tuple(place)] - value) < 1e-12, (rank, place)
