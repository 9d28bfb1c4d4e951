"""In parallel a feature is cut from the pieces joined, by a loop or by what each process selects of
its piece; the first process has it.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
two: TestDistributedCut.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkSelection, vtkSelectionNode
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
import shapemap

import shapetesting
from shapetesting import closed_curve, fact, points, read, triangles

processes, rank = shapetesting.parallel()

# Every process has the cells on its side of x = 0.
whole = read('DentedSphere600.vtp')
sides = points(whole)[triangles(whole)].mean(axis=1)[:, 0] < 0.0
surface = whole
if processes > 1:
    surface = shapetesting.without_cells(whole, numpy.flatnonzero(sides == (rank == 1)))


def cut(port, data):
    algorithm = shapemap.vtkShapeCutFeature()
    algorithm.SetInputDataObject(0, surface)
    algorithm.SetInputDataObject(port, data)
    messages = shapetesting.run(algorithm)
    return messages, algorithm.GetOutputDataObject(0), algorithm.GetOutputDataObject(1)


turns = 2 * numpy.pi * numpy.arange(40) / 40
circle = numpy.column_stack([0.6 * numpy.cos(turns), 0.6 * numpy.sin(turns), 0.8 + 0 * turns])
low = (points(surface)[triangles(surface)][:, :, 2] < -0.6).all(axis=1)
node = vtkSelectionNode()
node.SetContentType(vtkSelectionNode.INDICES)
node.SetFieldType(vtkSelectionNode.CELL)
node.SetSelectionList(numpy_to_vtkIdTypeArray(numpy.flatnonzero(low), deep=True))
selection = vtkSelection()
selection.AddNode(node)

found = []
for port, data in ((1, closed_curve(circle) if rank == 0 else vtkPolyData()), (2, selection)):
    messages, feature, rest = cut(port, data)
    assert not messages, messages
    assert (feature.GetNumberOfPoints() > 0) == (rank == 0), 'the first process has the feature'
    if rank == 0:
        assert fact(feature, 'CutFeature.Loops') == fact(rest, 'CutFeature.Holes') == 1
        found += [fact(feature, 'CutFeature.FeatureArea'), fact(feature, 'CutFeature.CutLength'),
                  feature.GetNumberOfCells()]

# One process's failure stops all of them.
assert cut(1, closed_curve(circle[:2]))[0]
assert cut(2, whole)[0], 'not extracted from the surface'

# While a loop is dragged what was last cut stays where it cannot be cut.
drawn = shapemap.vtkShapeCutFeature()
drawn.SetInputDataObject(0, surface)
drawn.SetDragging(True)


def draw(places):
    drawn.SetNumberOfLoopPoints(len(places))
    for i, place in enumerate(places):
        drawn.SetLoopPoints(i, *place)
    assert not shapetesting.run(drawn)
    return drawn.GetOutputDataObject(0)


count = draw(circle).GetNumberOfCells()
refused = draw(circle[[0, 0, 0]])
if rank == 0:
    assert fact(refused, 'CutFeature.Refused') == 1.0
    assert refused.GetNumberOfCells() == count == found[2] > 0

truth = os.path.join(sys.argv[1], 'cut.npy')
if processes == 1:
    numpy.save(truth, found)
elif rank == 0:
    assert numpy.allclose(found, numpy.load(truth), rtol=1e-6), (found, numpy.load(truth))
