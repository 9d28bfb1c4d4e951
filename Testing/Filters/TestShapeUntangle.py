"""Shape Untangle: a solid whose map folds, without inverted cells.

As an example: give it tetrahedra that a map has moved, and as RestShape the same before the map;
Untangle.InvertedBefore and .InvertedAfter count, and OriginalCellId tells what was split."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkExtractCells
import shapemap

import shapetesting
from shapetesting import array, fact, points, read


def untangled(data, rest=None, **settings):
    """The output and the error messages."""
    algorithm = shapemap.vtkShapeUntangle()
    algorithm.SetInputDataObject(0, data)
    if rest is not None:
        algorithm.SetInputDataObject(1, rest)
    for name, value in settings.items():
        getattr(algorithm, 'Set' + name)(value)
    messages = shapetesting.run(algorithm)
    return algorithm.GetOutputDataObject(0), ' '.join(messages)


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def moved(data, places):
    """A copy with its points elsewhere."""
    result = shapetesting.copy(data)
    shapetesting.set_points(result, places)
    return result


def volumes(solid):
    """Of each tetrahedron, with its sign."""
    corners = points(solid)[vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    a, b, c = (corners[:, k] - corners[:, 0] for k in (1, 2, 3))
    return numpy.einsum('ij,ij->i', numpy.cross(a, b), c) / 6.0


# The example: through ParaView's own proxies, the dented ball's tetrahedra on the sphere, by a map
# that is far too coarse on purpose: the boundary alone goes where it belongs.
surface = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
tetrahedra = simple.ShapeTetrahedralize(Input=surface)
tetrahedra.UpdatePipeline()
rest = shapetesting.output(tetrahedra)
targets = array(rest, 'TargetPosition')
on_boundary = array(rest, 'OriginalPointId') >= 0
spoiled = numpy.where(on_boundary[:, None], targets, 0.4 * points(rest)[:, [1, 2, 0]])
tangled = simple.TrivialProducer()
tangled.GetClientSideObject().SetOutput(moved(rest, spoiled))
mended_filter = simple.ShapeUntangle(Input=tangled, RestShape=tetrahedra)
mended_filter.UpdatePipeline()
mended = shapetesting.output(mended_filter)
assert fact(mended, 'Untangle.InvertedBefore') > 200
assert fact(mended, 'Untangle.InvertedAfter') == 0 and cells(mended, 'Inverted').sum() == 0
assert volumes(mended).min() > 0.0, 'a tetrahedron is inverted'
count = len(spoiled)
assert (points(mended)[:count][on_boundary] == targets[on_boundary]).all(), 'the boundary moved'
assert abs(volumes(mended).sum() / volumes(moved(rest, spoiled)).sum() - 1.0) < 1e-9
ids = array(mended, 'OriginalPointId')
assert (ids[:count] == numpy.arange(count)).all() and (ids[count:] == -1).all()
assert (array(mended, 'SourcePosition')[:count] == points(rest)).all()
whole = numpy.bincount(cells(mended, 'OriginalCellId'), minlength=rest.GetNumberOfCells())
assert whole.min() >= 1 and (whole > 1).sum() == fact(mended, 'Untangle.SplitCells')
at_rest = moved(mended, array(mended, 'SourcePosition'))
assert numpy.allclose(numpy.bincount(cells(mended, 'OriginalCellId'), volumes(at_rest)),
                      volumes(rest), rtol=1e-9), 'the parts do not fill their cells'

# Refined, all cells are nearer to their rest shapes. The measure is that of Shape Map Quality of the map from there.
refined_filter = simple.ShapeUntangle(Input=tangled, RestShape=tetrahedra, Refine='SymmetricDirichlet')
refined_filter.UpdatePipeline()
refined = shapetesting.output(refined_filter)
assert fact(refined, 'Untangle.InvertedAfter') == 0 and volumes(refined).min() > 0.0
assert (points(refined)[:count][on_boundary] == targets[on_boundary]).all(), 'the boundary moved'
before, after = (fact(refined, 'Untangle.Measure' + when) for when in ('Before', 'After'))
assert 6.0 < after < 0.9 * before, (before, after)
at_rest = moved(refined, array(refined, 'SourcePosition'))
shapetesting.add_array(at_rest, points(refined), 'Image')
quality = shapemap.vtkShapeMapQuality()
quality.SetInputDataObject(at_rest)
quality.SetMapArray('Image')
assert not shapetesting.run(quality)
sizes, energies = volumes(at_rest), cells(quality.GetOutputDataObject(0), 'SymmetricDirichlet')
assert abs(numpy.average(energies, weights=sizes) / after - 1.0) < 1e-9, after
assert fact(mended, 'Untangle.MeasureAfter') == 0.0

# Hexahedra: inner points of a ball thrown about. With the rest shape and without.
ball = read('BallSmall.vtu')
shapetesting.add_array(ball, numpy.arange(ball.GetNumberOfPoints()), 'Number')
random = numpy.random.default_rng(5)
inner = numpy.linalg.norm(points(ball), axis=1) < 0.75
shaken = points(ball) + inner[:, None] * random.uniform(-0.25, 0.25, (len(inner), 3))
for shape in (ball, None):
    result, messages = untangled(moved(ball, shaken), shape)
    assert not messages and fact(result, 'Untangle.InvertedBefore') > 100, messages
    assert fact(result, 'Untangle.InvertedAfter') == 0 == fact(result, 'Untangle.SplitCells')
    assert (array(result, 'Number') == numpy.arange(ball.GetNumberOfPoints())).all()
    assert (points(result)[~inner] == shaken[~inner])[
        numpy.linalg.norm(points(ball)[~inner], axis=1) > 0.99].all(), 'the boundary moved'
    quality = shapemap.vtkShapeMapQuality()
    back = shapetesting.copy(moved(result, points(ball)))
    shapetesting.add_array(back, points(result), 'TargetPosition')
    quality.SetInputDataObject(back)
    assert not shapetesting.run(quality)
    assert fact(quality.GetOutputDataObject(0), 'MapQuality.FlippedCells') == 0

# Voxels become hexahedra; in blocks that touch, what they share moves as one.
image = vtkImageData()
image.SetDimensions(5, 5, 5)
result, messages = untangled(image)
assert not messages and (vtk_to_numpy(result.GetCellTypesArray()) == 12).all(), messages
assert fact(result, 'Untangle.InvertedBefore') == 0 == fact(result, 'Untangle.Iterations')
grid = shapetesting.copy(result)
places = points(grid)
places[2 + 5 * 2 + 25 * 2] += [1.4, 0.1, 0.1]
blocks = vtkMultiBlockDataSet()
for number in range(2):
    extract = vtkExtractCells()
    extract.SetInputData(moved(grid, places))
    extract.AddCellRange(32 * number, 32 * number + 31)
    extract.Update()
    blocks.SetBlock(number, extract.GetOutput())
result, messages = untangled(blocks)
assert not messages and fact(result, 'Untangle.InvertedBefore') > 0, messages
assert fact(result, 'Untangle.InvertedAfter') == 0
ends = [p for p in points(result).tolist() if p not in points(grid).tolist()]
assert ends and len({tuple(p) for p in ends}) < len(ends), 'a point that two blocks share'

# A boundary that folds cannot be mended while it stays: that is said, and where.
places = points(grid)
places[0] = [3.5, 3.5, 3.5]
result, messages = untangled(moved(grid, places), MaximumIterations=10)
assert not messages and fact(result, 'Untangle.InvertedAfter') > 0, messages
assert cells(result, 'Inverted').sum() == fact(result, 'Untangle.InvertedAfter')
assert cells(result, 'Inverted')[0] == 1 and (points(result)[0] == 3.5).all()
# A point that was pushed along a face and past the next: it slides back where it may.
places = points(grid)
places[2 + 5 * 2] += [1.5, 0.1, 0.0]
result, messages = untangled(moved(grid, places), FixBoundary=False)
assert not messages and fact(result, 'Untangle.InvertedAfter') == 0, messages
flat = points(grid)[:, 2] == 0.0
assert (abs(points(result)[flat, 2]) < 1e-12).all(), 'it left its face'

# Other cells and another rest shape are refused.
surface_grid = read('DentedSphere600.vtp')
assert 'the Input has a vtkTriangle (cell 0), but only' in untangled(surface_grid)[1]
assert 'the RestShape does not have the cells of the Input' in untangled(ball, image)[1]
assert 'RefineExponent is 0' in untangled(ball, RefineExponent=0.0)[1]
assert 'MaximumIterations is 0' in untangled(ball, MaximumIterations=0)[1]
print('solids are untangled, split where there is no room, and what must fold is told')
