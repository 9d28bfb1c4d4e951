"""Domains in pieces of all kinds carried by one volume map: whatever the pieces are, and wherever the
boundary is, every point goes where it goes on one process; an error on one process is one on all.

Run by CTest under pvpython on one process, which writes the truth, and then under pvbatch --sym on two
and on four: TestDistributedVolumeMap.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkDataSetAttributes, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection,
    vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersCore import vtkExtractCells
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageChangeInformation, vtkRTAnalyticSource
import shapemap

import shapetesting
from shapetesting import array, fact, points, read

processes, rank = shapetesting.parallel()


def cells(data, chosen):
    extract = vtkExtractCells()
    extract.SetInputData(data)
    for i in chosen:
        extract.AddCellRange(int(i), int(i))
    extract.Update()
    return extract.GetOutput() if len(chosen) else vtkUnstructuredGrid()


def surface(grid):
    boundary = vtkGeometryFilter()
    boundary.SetInputData(grid)
    boundary.Update()
    return boundary.GetOutput()


def targets(places, time=1.0):
    """A map of the ball, more bent with time; harmonic only in part."""
    x, y, z = places.T
    return numpy.stack([x + 0.2 * time * (x * x - y * y), y + 0.1 * time * x * z,
                        z + 0.2 * time * y * y * y], axis=1)


solid = read('BallSmall.vtu')
centres = numpy.array([numpy.mean([solid.GetPoint(solid.GetCell(i).GetPointId(k)) for k in range(4)],
                                  axis=0) for i in range(solid.GetNumberOfCells())])
# Slabs along x; the first process has none where there are several, nor has the last one of four.
workers = {1: [0], 2: [1], 4: [1, 2]}[processes]
slab = numpy.searchsorted(numpy.quantile(centres[:, 0], numpy.linspace(0.0, 1.0, len(workers) + 1)[
    1:-1]), centres[:, 0])
mine = numpy.flatnonzero(slab == workers.index(rank)) if rank in workers else []
domain = cells(solid, mine)

# The boundary is cut across y, and lies on the first two processes: on the second of two the whole
# domain, on the third of four a domain and no boundary, on the fourth nothing at all.
whole = surface(solid)
shapetesting.add_array(whole, targets(points(whole)), 'TargetPosition')
side = numpy.array([whole.GetPoint(whole.GetCell(i).GetPointId(0))[1] > 0.0
                    for i in range(whole.GetNumberOfCells())])
boundary = whole if processes == 1 else vtkPolyData() if rank > 1 else surface(
    cells(whole, numpy.flatnonzero(side == (rank == 0))))

truth_file = os.path.join(sys.argv[1], 'volumemap.npz')
truth = {} if processes == 1 else dict(numpy.load(truth_file))


def compare(name, sources, values):
    """The values of this process's points are those that the points have on one process."""
    if processes == 1:
        truth[name + 'Places'], truth[name] = sources, values
        return
    expected = {place.tobytes(): value for place, value in zip(truth[name + 'Places'], truth[name])}
    worst = max((abs(expected[place.tobytes()] - value).max()
                 for place, value in zip(sources, values)), default=0.0)
    print('process', rank, name, len(values), 'points, off by at most', worst)
    assert worst < 1e-9, (name, worst)


def number(name, value):
    """A number that is the same on every process and for any number of them."""
    if processes == 1:
        truth[name] = value
    assert abs(truth[name] - value) < 1e-9, (name, truth[name], value)


volume = shapemap.vtkShapeHarmonicVolumeMap()
volume.SetInputDataObject(0, domain)
volume.SetInputDataObject(1, boundary)
assert not shapetesting.run(volume)
moved = volume.GetOutputDataObject(0)
assert moved.GetNumberOfCells() == len(mine) and len(mine) > 0 or rank not in workers
if rank in workers:
    compare('Moved', array(moved, 'SourcePosition'), points(moved))
    places = points(moved)
for port in (0, 1):
    for name in ('RMSEInside', 'Maximum', 'OffsetDistance', 'OutsidePoints'):
        number(name, fact(volume.GetOutputDataObject(port), 'HarmonicVolumeMap.' + name))
    assert fact(volume.GetOutputDataObject(port), 'HarmonicVolumeMap.Stop')
assert fact(moved, 'HarmonicVolumeMap.RMSEInside') < 5e-3, fact(moved, 'HarmonicVolumeMap.RMSEInside')
assert (volume.GetOutputDataObject(1).GetNumberOfPoints() > 0) == (rank == 0), 'charges come once'
assert (volume.GetOutputDataObject(2).GetNumberOfRows() > 0) == (rank == 0), 'levels come once'

charges = shapetesting.copy(volume.GetOutputDataObject(1))
applied = shapemap.vtkShapeApplyVolumeMap()
applied.SetInputDataObject(0, domain)
applied.SetInputConnection(1, volume.GetOutputPort(1))
assert not shapetesting.run(applied)
if rank in workers:
    assert (points(applied.GetOutputDataObject(0)) == points(moved)).all()
back = shapemap.vtkShapeApplyVolumeMap()
back.SetInputConnection(0, applied.GetOutputPort(0))
back.SetInputConnection(1, volume.GetOutputPort(1))
back.InverseOn()
assert not shapetesting.run(back)
if rank in workers:
    assert abs(points(back.GetOutputDataObject(0)) - points(domain)).max() < 1e-9

# The processes share the work on a boundary of many points, and find the same map to the last bit.
ball = vtkSphereSource()
ball.SetRadius(1.0)
ball.SetThetaResolution(205)
ball.SetPhiResolution(102)
ball.Update()
large = shapetesting.copy(ball.GetOutput())
large.GetPointData().Initialize()
assert large.GetNumberOfPoints() > 20000
shapetesting.add_array(large, targets(points(large)), 'TargetPosition')
volume.SetInputDataObject(1, large if rank == 0 else vtkPolyData())
volume.SetInputDataObject(0, solid)
assert not shapetesting.run(volume)
shared = points(volume.GetOutputDataObject(0))
truth.setdefault('Shared', shared)
assert (truth['Shared'] == shared).all(), abs(truth['Shared'] - shared).max()
# It fails on all processes together, too.
broken = shapetesting.copy(large)
shapetesting.add_array(broken, numpy.full((large.GetNumberOfPoints(), 3), numpy.nan), 'TargetPosition')
volume.SetInputDataObject(1, broken if rank == 0 else vtkPolyData())
assert any('map array' in message for message in shapetesting.run(volume))
volume.SetInputDataObject(0, domain)
volume.SetInputDataObject(1, boundary)

# A mesh in pieces is moved as one, on the first process.
motion = shapemap.vtkShapeMeshMotion()
motion.SetInputDataObject(0, domain)
motion.SetInputDataObject(1, boundary)
for method in range(2):
    motion.SetMethod(method)
    assert not shapetesting.run(motion)
    output = motion.GetOutputDataObject(0)
    assert output.GetNumberOfCells() == (solid.GetNumberOfCells() if rank == 0 else 0)
    if rank == 0:
        compare('Motion%d' % method, array(output, 'SourcePosition'), points(output))
    for name in ('MovingPoints', 'InvertedAfter', 'MaximumNonOrthogonalityAfter'):
        number('%s%d' % (name, method), fact(output, 'MeshMotion.' + name))

# Finite elements: the first process makes them, and all have them.
volume.SetMethod(3)
volume.SetTetrahedra(5000)
assert not shapetesting.run(volume)
number('Tetrahedra', fact(volume.GetOutputDataObject(0), 'HarmonicVolumeMap.Tetrahedra'))
assert not shapetesting.run(applied)
for algorithm in (volume, applied):
    if rank in workers:
        output = algorithm.GetOutputDataObject(0)
        compare('Elements', array(output, 'SourcePosition'), points(output))
volume.SetMethod(0)

# A layer of ghost cells around each slab: they are carried along, stay marked and count once. Points
# far outside keep their place and are counted.
share = numpy.searchsorted(numpy.quantile(centres[:, 0], numpy.linspace(0.0, 1.0, processes + 1)[1:-1]),
                           centres[:, 0])
corners = numpy.array([[solid.GetCell(i).GetPointId(k) for k in range(4)]
                       for i in range(solid.GetNumberOfCells())])
owner = numpy.full(solid.GetNumberOfPoints(), processes)
for k in range(4):
    numpy.minimum.at(owner, corners[:, k], share)
near = numpy.zeros(solid.GetNumberOfPoints(), bool)
near[corners[share == rank]] = True
kept = numpy.flatnonzero(near[corners].any(axis=1))
marked = shapetesting.copy(solid)
large = 1.2 * points(marked)
shapetesting.set_points(marked, large)
shapetesting.add_array(marked, numpy.arange(len(large)), 'Id')
ghosts = numpy.where(share == rank, 0, vtkDataSetAttributes.DUPLICATECELL).astype(numpy.uint8)
duplicates = numpy.where(owner == rank, 0, vtkDataSetAttributes.DUPLICATEPOINT).astype(numpy.uint8)
for attributes, values in ((marked.GetCellData(), ghosts), (marked.GetPointData(), duplicates)):
    values = numpy_to_vtk(values, deep=True)
    values.SetName(vtkDataSetAttributes.GhostArrayName())
    attributes.AddArray(values)
with_ghosts = cells(marked, kept)
for algorithm, name in ((volume, 'HarmonicVolumeMap'), (applied, 'ApplyVolumeMap')):
    algorithm.SetInputDataObject(0, with_ghosts)
    assert not shapetesting.run(algorithm)
    output = algorithm.GetOutputDataObject(0)
    assert (shapetesting.vtk_to_numpy(output.GetCellGhostArray()) == ghosts[kept]).all()
    assert (shapetesting.vtk_to_numpy(output.GetPointGhostArray()) == duplicates[
        array(output, 'Id')]).all()
    assert output.GetNumberOfCells() == len(kept) and (
        processes == 1 or len(kept) > (share == rank).sum())
    compare(name + 'Ghosts', array(output, 'SourcePosition'), points(output))
    number('OutsideWithGhosts', fact(output, name + '.OutsidePoints'))
assert truth['OutsideWithGhosts'] > 10

# Blocks: in a multiblock with a hole on some processes, in a partitioned collection with partitions here
# and none there.
blocks = vtkMultiBlockDataSet()
blocks.SetNumberOfBlocks(3)
if rank in workers:
    blocks.SetBlock(2, domain)
collection = vtkPartitionedDataSetCollection()
collection.SetNumberOfPartitionedDataSets(2)
collection.SetNumberOfPartitions(0, 0)
if rank in workers:
    half = len(mine) // 2
    collection.SetPartition(1, 0, cells(solid, mine[:half]))
    collection.SetPartition(1, 1, cells(solid, mine[half:]))
for composite in (blocks, collection):
    for algorithm in (volume, applied):
        algorithm.SetInputDataObject(0, composite)
        assert not shapetesting.run(algorithm)
        output = algorithm.GetOutputDataObject(0)
        assert output.IsA(composite.GetClassName())
        iterator = output.NewIterator()
        count = 0
        while not iterator.IsDoneWithTraversal():
            leaf = iterator.GetCurrentDataObject()
            compare('Moved', array(leaf, 'SourcePosition'), points(leaf))
            count += leaf.GetNumberOfCells()
            iterator.GoToNextItem()
        assert count == len(mine), 'a block is missing'

# The boundary in blocks, too, and not on every process.
parts = vtkMultiBlockDataSet()
parts.SetNumberOfBlocks(2)
if boundary.GetNumberOfCells():
    parts.SetBlock(rank % 2, boundary)
volume.SetInputDataObject(0, domain)
volume.SetInputDataObject(1, parts)
assert not shapetesting.run(volume)
if rank in workers:
    compare('Moved', array(volume.GetOutputDataObject(0), 'SourcePosition'),
            points(volume.GetOutputDataObject(0)))
volume.SetInputDataObject(1, boundary)

# An image in pieces becomes a structured grid in pieces; its corners lie outside.
image = vtkRTAnalyticSource()
image.SetWholeExtent(*[-6, 6] * 3)
scaled = vtkImageChangeInformation()
scaled.SetInputConnection(image.GetOutputPort())
scaled.SetOutputSpacing(0.15, 0.15, 0.15)
gridded = shapemap.vtkShapeHarmonicVolumeMap()
gridded.SetInputDataObject(1, boundary)
carried = shapemap.vtkShapeApplyVolumeMap()
carried.SetInputDataObject(1, charges)
for algorithm in (gridded, carried):
    algorithm.SetInputConnection(0, scaled.GetOutputPort())
    assert algorithm.UpdatePiece(rank, processes, 0)
    grid = algorithm.GetOutputDataObject(0)
    assert grid.IsA('vtkStructuredGrid') and grid.GetNumberOfPoints() > 0
    extent = grid.GetExtent()
    assert processes == 1 or extent != (-6, 6, -6, 6, -6, 6), 'a piece'
    compare('Image', numpy.round(array(grid, 'SourcePosition'), 9), points(grid))
    outside = array(grid, 'OutsideDomain')
    assert (points(grid)[outside == 1] == array(grid, 'SourcePosition')[outside == 1]).all()
    assert outside.any() and not outside.all()
# The charges of a map whose own domain is an image in pieces serve another filter.
onward = shapemap.vtkShapeApplyVolumeMap()
onward.SetInputDataObject(0, domain)
onward.SetInputConnection(1, gridded.GetOutputPort(1))
assert onward.UpdatePiece(rank, processes, 0)
if rank in workers:
    compare('Moved', array(onward.GetOutputDataObject(0), 'SourcePosition'),
            points(onward.GetOutputDataObject(0)))


class Series(VTKPythonAlgorithmBase):
    """This process's piece of the boundary, whose images change with time."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType='vtkPolyData')

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(Pipeline.TIME_STEPS(), (0.0, 0.5, 1.0), 3)
        info.Set(Pipeline.TIME_RANGE(), (0.0, 1.0), 2)
        info.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, request, inputs, outputs):
        time = outputs.GetInformationObject(0).Get(Pipeline.UPDATE_TIME_STEP())
        output = vtkPolyData.GetData(outputs, 0)
        output.ShallowCopy(boundary)
        if output.GetNumberOfPoints():
            shapetesting.add_array(output, targets(points(output), time), 'TargetPosition')
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


# Each step is what it is by itself, forwards and back again.
series = Series()
moving = shapemap.vtkShapeHarmonicVolumeMap()
moving.SetInputDataObject(0, domain)
moving.SetInputConnection(1, series.GetOutputPort())
for time in (1.0, 0.0, 0.5, 1.0):
    assert moving.UpdateTimeStep(time, rank, processes, 0)
    output = moving.GetOutputDataObject(0)
    if rank in workers:
        compare('Moved' if time == 1.0 else 'At%g' % time, array(output, 'SourcePosition'),
                points(output))
    assert time > 0.0 or rank not in workers or abs(
        points(output) - array(output, 'SourcePosition')).max() < 1e-9, 'the identity'

if processes == 1:
    numpy.savez(truth_file, **truth)
    print('one process wrote the truth')

# What is wrong with the boundary is said on every process, and none waits for another: an open one; one
# with an image that is not a number, on a single process; options that no solver takes.
opened = shapetesting.copy(boundary)
if rank == 0:
    opened.BuildLinks()
    opened.DeleteCell(3)
    opened.RemoveDeletedCells()
spoiled = shapetesting.copy(boundary)
if rank == min(1, processes - 1):
    spoiled.GetPointData().GetArray('TargetPosition').SetComponent(2, 1, numpy.nan)
for data, words in ((opened, '1 open loop'), (spoiled, 'not finite')):
    volume.SetInputDataObject(1, data)
    messages = shapetesting.run(volume)
    assert any(words in message and 'Shape Harmonic Volume Map' in message
               for message in messages), messages
    for port in (0, 1):
        assert volume.GetOutputDataObject(port).GetNumberOfPoints() == 0
    assert volume.GetOutputDataObject(2).GetNumberOfRows() == 0
volume.SetInputDataObject(1, boundary)
volume.SetSourceRatio(-1.0)
assert any('SourceRatio is -1' in message for message in shapetesting.run(volume))
volume.SetSourceRatio(0.8)
assert not shapetesting.run(volume)
if rank in workers:
    assert (points(volume.GetOutputDataObject(0)) == places).all(), 'as before'
