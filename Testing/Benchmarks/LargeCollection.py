"""A hundred shapes of 5,000 points, each with triangles of its own: maps, atlas and statistics, in the time and
memory that they may take.

    Utilities/pvpython.sh Testing/Benchmarks/LargeCollection.py [COUNT [POINTS]]

The shapes are a figure of Data/ that is stretched, bent and twisted, each in another way, and then decimated.
Those of odd number are also thicker: they are one of the two groups. The bound of the time is for two cores:
set VTK_SMP_MAX_THREADS."""
import os
import resource
import sys
import time
import numpy
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkTable
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkQuadricDecimation
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter
import shapemap

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
import shapetesting  # noqa: E402
from shapetesting import array, fact, points  # noqa: E402

MINUTES, GIBIBYTES = 20.0, 4.0
LARGEST_P = 0.05  # of a difference between the groups


def after(data, algorithm):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def refined():
    """The figure with many points, of size 1, and its normals."""
    figure = shapetesting.read('FigureASmall.vtp')
    figure.GetPointData().Initialize()
    subdivision, normals = vtkLoopSubdivisionFilter(), vtkPolyDataNormals()
    subdivision.SetNumberOfSubdivisions(2)
    normals.SplittingOff()
    fine = after(after(figure, subdivision), normals)
    places = points(fine)
    shapetesting.set_points(fine, (places - places.mean(axis=0)) / numpy.ptp(places, axis=0).max())
    return fine


def deformed(fine, number, count):
    """A copy with another shape, and with about `count` points."""
    random = numpy.random.default_rng(number)
    places = points(fine) + 0.01 * (number % 2) * array(fine, 'Normals')
    places *= random.uniform(0.95, 1.05, 3)
    bend, turn = random.uniform(-0.3, 0.3, (2, 1))
    across, along = places[:, 0] + bend * places[:, 2]**2, places[:, 1]
    cosine, sine = numpy.cos(turn * places[:, 2]), numpy.sin(turn * places[:, 2])
    shape = shapetesting.copy(fine)
    shapetesting.set_points(shape, numpy.column_stack(
        [across * cosine - along * sine, across * sine + along * cosine, places[:, 2]]))
    decimation = vtkQuadricDecimation()
    decimation.SetTargetReduction(1.0 - count / fine.GetNumberOfPoints())
    return after(shape, decimation)


def main():
    count, size = (int(value) for value in (sys.argv[1:] + ['100', '5000'][len(sys.argv) - 1:]))
    fine, blocks, groups = refined(), vtkMultiBlockDataSet(), vtkIntArray()
    groups.SetName('Group')
    for number in range(count):
        blocks.SetBlock(number, deformed(fine, number, size))
        groups.InsertNextValue(number % 2)
    print('%d shapes of %d to %d points' % (count, *(
        choose(blocks.GetBlock(i).GetNumberOfPoints() for i in range(count)) for choose in (min, max))))
    table = vtkTable()
    table.AddColumn(groups)
    start, before = time.time(), time.process_time()
    maps = shapetesting.new(shapemap.vtkShapeCollection, blocks, Correspondence=2)
    collection = shapetesting.outputs(maps)
    print('maps: %.0f s, %.0f CPU s' % (time.time() - start, time.process_time() - before), flush=True)
    print('cycle error %.4f, of pairs %.4f, %d pairs' % tuple(fact(collection[1], 'Collection.' + name) for name in (
        'CycleError', 'PairwiseCycleError', 'Pairs')))
    atlas = shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeAtlas, collection[0], None, table, Groups='Group', NumberOfModes=10))
    seconds, processor = time.time() - start, time.process_time() - before
    gibibytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    claims = (('minutes (%.1f CPU minutes)' % (processor / 60), seconds / 60, MINUTES),
              ('GiB at the peak', gibibytes, GIBIBYTES),
              ('p of the groups, which differ', fact(atlas[0], 'Atlas.GroupPValue'), LARGEST_P))
    for claim, value, bound in claims:
        print('%-6s %-34s %.3g (bound %.3g)' % ('holds' if value <= bound else 'FAILS', claim, value, bound))
    sys.exit(0 if all(value <= bound for _, value, bound in claims) else 1)


if __name__ == '__main__':
    main()
