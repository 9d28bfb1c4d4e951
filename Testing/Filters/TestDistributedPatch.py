"""In parallel the first process has the patch of Shape Exponential Map, the same as of the whole
surface; what another process has is looked at anew each time; and an error stops all.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
two: TestDistributedPatch.py FOLDER."""
import os
import sys

import numpy
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read

processes, rank = shapetesting.parallel()


def piece(surface):
    """Every process keeps the cells on its side of x = 0; in one process, all."""
    corners = points(surface)[shapetesting.triangles(surface)]
    others = (corners.mean(axis=1)[:, 0] < 0.0) != (rank == 0)
    return shapetesting.without_cells(surface, numpy.nonzero(others)[0] if processes > 1 else ())


surface = piece(read('DentedSphere600.vtp'))
algorithm = shapemap.vtkShapeExponentialMap()
algorithm.SetInputDataObject(surface)
algorithm.SetSeed(0.0, 0.3, 2.0)
algorithm.SetRadius(0.7)
found = []
for stretch in (0.0, 0.5):
    if stretch > 0.0 and rank == processes - 1:
        # With two processes the first one's piece stays as it is.
        stretched = points(surface)
        stretched[:, 0] += stretch * numpy.maximum(0.0, stretched[:, 0] - 0.3)
        shapetesting.set_points(surface, stretched)
        surface.Modified()
    algorithm.Modified()
    assert not shapetesting.run(algorithm)
    patch = copy(algorithm.GetOutputDataObject(0))
    if rank > 0:
        assert patch.GetNumberOfPoints() == 0
        continue
    places = points(patch)
    order = numpy.lexsort(numpy.round(places, 9).T)
    found += [places[order], array(patch, 'TargetPosition')[order],
              fact(patch, 'ExponentialMap.SymmetricDirichlet')]
    assert places[:, 0].min() < -0.2 and places[:, 0].max() > 0.2, 'the patch ends where pieces meet'

file = os.path.join(sys.argv[1], 'patch.npz')
if processes == 1:
    numpy.savez(file, *found)
elif rank == 0:
    truth = numpy.load(file)
    for value, name in zip(found, truth.files):
        assert numpy.shape(value) == truth[name].shape, name
        assert abs(value - truth[name]).max() < 1e-9, name

# An error on one process is an error on all.
broken = copy(surface)
if rank == processes - 1:
    spoiled = points(broken)
    spoiled[5] = numpy.nan
    shapetesting.set_points(broken, spoiled)
algorithm.SetInputDataObject(broken)
assert any('Shape Exponential Map: ' in message for message in shapetesting.run(algorithm))
algorithm.SetInputDataObject(surface)
assert not shapetesting.run(algorithm)
print('process', rank, 'of', processes, 'is done')
