"""Shape Structured Blocks: the grid of hexahedra as structured grids, with a spline over each.

As an example: give it the third output of Shape Hex Remesh, made with the method Polycube; colour by
SplineError, and save it as .vtm."""
import glob
import os
import tempfile

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import array, fact, points


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def blocks_of(data):
    return [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]


for name in ('BentBar.vtp', 'TwistedBar.vtp'):
    surface = simple.TrivialProducer()
    surface.GetClientSideObject().SetOutput(shapetesting.read(name))
    remesh = simple.ShapeHexRemesh(Surface=surface, Method='Polycube', CellsOnLongestSide=20)
    remesh.UpdatePipeline()
    solid, grid = shapetesting.output(remesh, 0), shapetesting.output(remesh, 2)

    # The grid's cells are cubes of the cell size, and its map gives points of the hexahedra.
    corners = points(grid)[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)]
    assert abs(numpy.ptp(corners, axis=1) - fact(solid, 'HexRemesh.CellSize')).max() < 1e-9
    ids = vtk_to_numpy(grid.GetPointData().GetArray('OriginalPointId'))
    assert (array(grid, 'TargetPosition') == points(solid)[ids]).all()
    assert (array(solid, 'SourcePosition')[ids] == points(grid)).all()

    # A field made on the grid, carried to the solid and back, is the same at the nodes.
    waves = simple.Calculator(Input=simple.OutputPort(remesh, 2), ResultArrayName='Wave',
                              Function='sin(7*coordsX)+coordsY*coordsZ')
    on_solid = simple.ShapeTransferFields(Input=remesh, Source=waves, MapArray='SourcePosition')
    back = simple.ShapeTransferFields(Input=simple.OutputPort(remesh, 2), Source=on_solid,
                                      MapArray='TargetPosition')
    back.UpdatePipeline()
    x, y, z = points(grid).T
    made = numpy.sin(7 * x) + y * z
    assert abs(array(shapetesting.output(on_solid), 'Wave')[ids] - made).max() < 1e-9
    assert abs(array(shapetesting.output(back), 'Wave') - made).max() < 1e-9

    # Each cell and node of the grid is in the block that Block says, at BlockIndex.
    structured = simple.ShapeStructuredBlocks(Input=waves)
    structured.UpdatePipeline()
    result, nets = (shapetesting.output(structured, port) for port in (0, 1))
    assert result.GetNumberOfBlocks() == fact(solid, 'HexRemesh.Blocks') == fact(
        result, 'StructuredBlocks.Blocks')
    assert result.GetNumberOfCells() == grid.GetNumberOfCells()
    where = {tuple(place): k for k, place in enumerate(numpy.round(points(grid), 9))}
    splines = {}
    for block, net in zip(blocks_of(result), blocks_of(nets)):
        dimensions, controls = block.GetDimensions(), net.GetDimensions()
        assert block.GetNumberOfCells() == numpy.prod(numpy.array(dimensions) - 1)
        assert controls == tuple(max(2, -(-count // 2)) for count in dimensions)
        own = [where[tuple(place)] for place in numpy.round(array(block, 'SourcePosition'), 9)]
        assert (points(block) == array(grid, 'TargetPosition')[own]).all()
        assert abs(array(block, 'Wave') - made[own]).max() < 1e-12
        # i, j and k follow the axes of the grid.
        lattice = array(block, 'SourcePosition').reshape(dimensions[::-1] + (3,))
        for axis in range(3):
            steps = numpy.diff(lattice[..., axis], axis=2 - axis)
            assert abs(steps - fact(solid, 'HexRemesh.CellSize')).max() < 1e-9
        error = numpy.linalg.norm(array(block, 'SplinePosition') - points(block), axis=1)
        assert abs(error - array(block, 'SplineError')).max() < 1e-12
        # Splines pass through the corners, and agree where blocks meet.
        for k, place in zip(own, array(block, 'SplinePosition')):
            assert numpy.linalg.norm(splines.setdefault(k, place) - place) < 1e-12
        ends = numpy.ix_(*((0, count - 1) for count in dimensions[::-1]))
        assert array(block, 'SplineError').reshape(dimensions[::-1])[ends].max() < 1e-12
        for axis, letter in enumerate('IJK'):
            knots = vtk_to_numpy(net.GetFieldData().GetArray('Knots' + letter))
            degree = len(knots) - controls[axis] - 1
            assert degree == min(3, controls[axis] - 1) and (numpy.diff(knots) >= 0.0).all()
            assert (knots[:degree + 1] == 0.0).all() and (knots[-degree - 1:] == 1.0).all()
    assert len(splines) == grid.GetNumberOfPoints()
    largest = max(array(block, 'SplineError').max() for block in blocks_of(result))
    assert largest == fact(result, 'StructuredBlocks.SplineError')
    diagonal = numpy.linalg.norm(numpy.ptp(array(grid, 'TargetPosition'), axis=0))
    assert abs(fact(result, 'StructuredBlocks.RelativeError') - largest / diagonal) < 1e-12

    # With a control point for each node, the splines interpolate.
    exact = simple.ShapeStructuredBlocks(Input=waves, NodesPerControl=1.0)
    exact.UpdatePipeline()
    assert fact(shapetesting.output(exact), 'StructuredBlocks.RelativeError') < 1e-9

    # Where nodes may slide along the surface, the shape alone has to be followed.
    sliding = simple.ShapeStructuredBlocks(Input=waves, Surface=surface)
    sliding.UpdatePipeline()
    slid = shapetesting.output(sliding)
    given, relative = (fact(data, 'StructuredBlocks.RelativeError') for data in (result, slid))
    print('%s: error %.2g of the diagonal, %.2g with Surface' % (name, given, relative))
    assert relative <= 1e-3 and relative < given
    motion = max(numpy.linalg.norm(points(after) - points(before), axis=1).max()
                 for before, after in zip(blocks_of(result), blocks_of(slid)))
    assert abs(motion - fact(slid, 'StructuredBlocks.LargestMotion')) < 1e-12
    assert fact(result, 'StructuredBlocks.LargestMotion') == 0.0
    shared = {}
    for block in blocks_of(slid):
        places = numpy.round(array(block, 'SourcePosition'), 9)
        for place, node in zip(places, numpy.hstack((points(block), array(block, 'SplinePosition')))):
            assert abs(shared.setdefault(tuple(place), node) - node).max() < 1e-12

    # Files hold the same.
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'blocks.vtm')
        simple.SaveData(path, structured)
        assert len(glob.glob(os.path.join(folder, 'blocks', '*.vts'))) == result.GetNumberOfBlocks()
        read = simple.OpenDataFile(path)
        read.UpdatePipeline()
        for one, other in zip(blocks_of(shapetesting.output(read)), blocks_of(result)):
            assert (points(one) == points(other)).all() and one.GetDimensions() == other.GetDimensions()

# What is wrong is named.
for spoil, expected in (
        (lambda data: data.GetCellData().RemoveArray('Block'), 'Block'),
        (lambda data: data.GetCellData().RemoveArray('BlockIndex'), 'BlockIndex'),
        (lambda data: data.GetPointData().RemoveArray('TargetPosition'), 'TargetPosition'),
        (lambda data: cell_array(data, 'BlockIndex').__setitem__((0, 0), 90), 'do not fill a box')):
    spoiled = shapetesting.copy(grid)
    spoil(spoiled)
    algorithm = shapemap.vtkShapeStructuredBlocks()
    algorithm.SetInputDataObject(spoiled)
    said = ' '.join(shapetesting.run(algorithm))
    assert expected in said, (expected, said)
for setting, value in (('Degree', 0), ('Degree', 10), ('NodesPerControl', 0.5), ('FeatureAngle', 0.0)):
    algorithm = shapemap.vtkShapeStructuredBlocks()
    algorithm.SetInputDataObject(grid)
    algorithm.SetInputDataObject(1, shapetesting.output(surface))
    getattr(algorithm, 'Set' + setting)(value)
    assert setting in ' '.join(shapetesting.run(algorithm))
