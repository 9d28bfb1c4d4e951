"""A collection whose maps are computed: the pairs and the maps are shared out over the processes, which have
pieces of the shapes, and the first one gets what one process gets.

Run by CTest under pvpython on one process, which writes the truth, and then under pvbatch --sym on
four: TestDistributedCollection.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read

processes, rank = shapetesting.parallel()


def group(shapes):
    """Each shape as a whole, on one process; the others have an empty block."""
    blocks = vtkMultiBlockDataSet()
    for number, shape in enumerate(shapes):
        blocks.SetBlock(number, shape if number % processes == rank else vtkPolyData())
    return blocks


def stretched(factors):
    shape = read('FigureASmall.vtp')
    shape.GetPointData().Initialize()
    shapetesting.set_points(shape, points(shape) * factors)
    return shape


shapes = [stretched(factors) for factors in ((1, 1, 1), (1.03, 1, 1), (1, 1.05, 1), (1, 1, 1.08), (1.05, 1.05, 1))]
opened = shapetesting.without_cells(copy(shapes[0]), [7])
opened.GetPolys().InsertNextCell(3, [0, 500, 900])  # joins parts that are far from each other
results = {}
for consistency, method in ((1, 0), (1, 1), (0, 0)):
    algorithm = shapetesting.new(shapemap.vtkShapeCollection, group(shapes + [opened]), Correspondence=2,
                                 Consistency=consistency, Method=method, Neighbours=2)
    outputs = shapetesting.outputs(algorithm)
    assert fact(outputs[1], 'Collection.LeftOut') == 1
    assert 'shape 5' in fact(outputs[1], 'Collection.Warning')
    assert outputs[1].GetNumberOfPoints() > 0 or rank > 0
    if rank > 0:
        assert outputs[0].GetNumberOfBlocks() == outputs[2].GetNumberOfRows() == 0, 'one process has all'
        continue
    kind = '%d %d ' % (consistency, method)
    results[kind + 'template'] = fact(outputs[1], 'Collection.Template')
    for number in range(len(shapes)):
        results[kind + str(number)] = array(outputs[0].GetBlock(number), 'TargetPosition')
        results[kind + 'on %d' % number] = points(outputs[6].GetBlock(number))
    results[kind + 'distances'] = numpy.array([
        vtk_to_numpy(outputs[2].GetColumn(k)) for k in range(len(shapes))])
    if consistency:
        results[kind + 'cycles'] = [fact(outputs[1], 'Collection.' + name) for name in (
            'Pairs', 'ExchangedPairs', 'DroppedPairs', 'CycleError', 'PairwiseCycleError', 'Triples')]

file = os.path.join(sys.argv[1], 'collection.npz')
if processes == 1:
    numpy.savez(file, **results)
    print('one process wrote the truth')
elif rank == 0:
    expected = numpy.load(file)
    assert sorted(expected) == sorted(results)
    for name, values in results.items():
        assert (expected[name] == values).all(), (name, abs(expected[name] - values).max())
    print(len(results), 'results are the same bits')

# What fails on one process, stops all.
if processes > 1:
    messages = shapetesting.run(shapetesting.new(
        shapemap.vtkShapeCollection, group(shapes[:1]), Correspondence=2))
    assert any('two or more' in message for message in messages), messages
