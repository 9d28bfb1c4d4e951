"""Shape Cage Deform in parallel: a shape, its cage and the moved cage come in any pieces. Each process gets its
own piece back, deformed as the whole is, and points outside count once.

Run by CTest under pvpython on one process, which writes the truth, and then under pvbatch --sym on two and three:
TestDistributedCage.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkMultiBlockDataSet, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkExtractCells
import shapemap

import shapetesting
from shapetesting import array, fact, points, read

processes, rank = shapetesting.parallel()
COORDINATES = {'MeanValue': 0, 'Harmonic': 1, 'Green': 2}


def slab(data, axis):
    """The process of each cell: the cells along an axis in parts of equal number."""
    places = points(data)
    middles = numpy.array([numpy.mean([places[cell.GetPointId(k)] for k in range(cell.GetNumberOfPoints())], axis=0)
                           for cell in map(data.GetCell, range(data.GetNumberOfCells()))])[:, axis]
    cuts = numpy.quantile(middles, numpy.linspace(0.0, 1.0, processes + 1)[1:-1])
    return numpy.searchsorted(cuts, middles)


def cells(data, chosen):
    extract = vtkExtractCells()
    extract.SetInputData(data)
    for i in chosen:
        extract.AddCellRange(int(i), int(i))
    extract.Update()
    return extract.GetOutput() if len(chosen) else vtkUnstructuredGrid()


def motion(places):
    """Bends and shears; positions are found by it, and not by their order."""
    x, y, z = places.T
    return numpy.stack([x + 0.2 * z * z + 0.3 * y, y - 0.1 * x * z, z + 0.1 * x * y], axis=1)


def moved_cage(piece):
    moved = shapetesting.copy(piece)
    shapetesting.set_points(moved, motion(points(piece)))
    return moved


# The solid in slabs along x with a layer of ghost cells, scaled so that some of its points are outside; the cage
# in slabs along y, so that no process has the cage around its own part.
solid, around = read('BallSmall.vtu'), read('DentedSphere600.vtp')
shapetesting.set_points(solid, 1.02 * points(solid))
share = slab(solid, 0)
corners = [[solid.GetCell(i).GetPointId(k) for k in range(solid.GetCell(i).GetNumberOfPoints())]
           for i in range(solid.GetNumberOfCells())]
corners = numpy.array(corners)
owner = numpy.full(solid.GetNumberOfPoints(), processes)
near = numpy.zeros(solid.GetNumberOfPoints(), bool)
for k in range(corners.shape[1]):
    numpy.minimum.at(owner, corners[:, k], share)
near[corners[share == rank]] = True
for attributes, ghost in (
        (solid.GetCellData(), numpy.where(share == rank, 0, vtkDataSetAttributes.DUPLICATECELL)),
        (solid.GetPointData(), numpy.where(owner == rank, 0, vtkDataSetAttributes.DUPLICATEPOINT))):
    flags = numpy_to_vtk(ghost.astype(numpy.uint8), deep=True)
    flags.SetName(vtkDataSetAttributes.GhostArrayName())
    attributes.AddArray(flags)
piece = cells(solid, numpy.flatnonzero(near[corners].any(axis=1)))
cage = shapetesting.with_cells(around, numpy.flatnonzero(slab(around, 1) == rank)) if processes > 1 else around
assert processes == 1 or 0 < cage.GetNumberOfCells() < around.GetNumberOfCells()

truth_file = os.path.join(sys.argv[1], 'cage.npz')
truth = {} if processes == 1 else dict(numpy.load(truth_file))


def deform(data, name, **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeCageDeform, data, cage, moved_cage(cage),
                                 Coordinates=COORDINATES[name], Tetrahedra=5000, DeformationGradient=True, **settings)
    messages = shapetesting.run(algorithm)
    assert not messages, messages
    return algorithm.GetOutputDataObject(0)


def rows(output):
    return numpy.concatenate([array(output, name).reshape(output.GetNumberOfPoints(), -1) for name in (
        'SourcePosition', 'OutsideDomain', 'DeformationGradient')] + [points(output)], axis=1)


def compare(name, output, outside):
    """Positions, gradients and counts are those of one process."""
    found = rows(output)
    if processes == 1:
        truth[name], truth[name + 'Outside'] = found, outside
        assert 10 < outside == found[:, 3].sum() < len(found) / 2
    expected = {row[:3].tobytes(): row for row in truth[name]}
    worst = max(abs(expected[row[:3].tobytes()] - row).max() for row in found)
    print('process', rank, name, len(found), 'points, off by at most', worst)
    assert worst < 1e-9, (name, worst)
    assert outside == truth[name + 'Outside'], (name, outside, truth[name + 'Outside'])


for name in COORDINATES:
    output = deform(piece, name)
    assert output.GetNumberOfPoints() == piece.GetNumberOfPoints() < (
        solid.GetNumberOfPoints() + (processes == 1))
    if name == 'MeanValue':
        assert fact(output, 'CageDeform.OutsidePoints') == 0, 'mean value coordinates are defined everywhere'
        if processes == 1:
            truth[name] = rows(output)
        expected = {row[:3].tobytes(): row for row in truth[name]}
        assert max(abs(expected[row[:3].tobytes()] - row).max() for row in rows(output)) < 1e-9
    else:
        compare(name, output, fact(output, 'CageDeform.OutsidePoints'))

# Blocks that only some of the processes have.
blocks = vtkMultiBlockDataSet()
blocks.SetNumberOfBlocks(2)
if rank == processes - 1:
    blocks.SetBlock(1, piece)
output = deform(blocks, 'Green')
if rank == processes - 1:
    expected = {row[:3].tobytes(): row for row in truth['Green']}
    assert max(abs(expected[row[:3].tobytes()] - row).max() for row in rows(output.GetBlock(1))) < 1e-9

if processes == 1:
    numpy.savez(truth_file, **truth)

# An error on one process is one on all, and none waits for another: a position that is not finite, a cage that is
# not closed.
spoiled = shapetesting.copy(piece)
if rank == 0:
    places = points(spoiled).copy()
    places[3, 1] = numpy.nan
    shapetesting.set_points(spoiled, places)
opened = shapetesting.without_cells(cage, [0]) if rank == processes - 1 else cage
for data, surface, words in ((spoiled, cage, 'not finite'), (piece, opened, 'Shape Fill Holes')):
    algorithm = shapetesting.new(shapemap.vtkShapeCageDeform, data, surface, moved_cage(surface))
    messages = ' '.join(shapetesting.run(algorithm))
    assert 'Shape Cage Deform: ' in messages, messages
    assert words in messages or rank > 0 and data is spoiled, messages
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
print('process', rank, 'of', processes, 'has its piece of what the cage moves')
