"""Shape Cut Feature: cuts a feature from a surface and fills the hole that it leaves.

As an example: a cap of a sphere, along a circle above it that is drawn with Poly Line Source."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkSelectionNode)
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import array, closed_curve, copy, edges, euler, fact, points, read, selection_of, triangles


def circle(height, radius, count=60):
    turns = 2 * numpy.pi * (numpy.arange(count) + 0.5) / count
    return numpy.column_stack([radius * numpy.cos(turns), radius * numpy.sin(turns),
                               numpy.full(count, height)])


def new(surface, loop=None, selection=None, **properties):
    return shapetesting.new(shapemap.vtkShapeCutFeature, surface, loop, selection, **properties)


def cut(*args, **properties):
    return shapetesting.outputs(new(*args, **properties))[:2]


def refused(words, *args, **properties):
    shapetesting.check_refused(new(*args, **properties), words)


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def area(surface):
    corners = points(surface)[triangles(surface)]
    return 0.5 * numpy.linalg.norm(numpy.cross(
        corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()


# The example: a cap is as large as 2 pi times its height (Archimedes).
sphere = simple.Sphere(Radius=1.0, ThetaResolution=80, PhiResolution=80)
loop = simple.PolyLineSource(Points=circle(0.9, 0.5).ravel().tolist(), Closed=1)
feature = simple.ShapeCutFeature(Input=sphere, Loop=loop)
feature.UpdatePipeline()
cap, rest = (shapetesting.output(feature, port) for port in (0, 1))
height = 1 - 0.9 / numpy.hypot(0.9, 0.5)
assert abs(fact(cap, 'CutFeature.FeatureArea') - 2 * numpy.pi * height) < 0.02
assert abs(area(cap) - fact(cap, 'CutFeature.FeatureArea')) < 1e-9
assert fact(cap, 'CutFeature.Loops') == 1 and fact(rest, 'CutFeature.Holes') == 1
assert euler(cap) == 1 and euler(rest) == 2
assert abs(numpy.linalg.norm(points(rest), axis=1) - 1).max() < 0.01
# It stood on a sphere: meridians are as long as the angle, and normals point outwards.
on_loop = numpy.linalg.norm(array(cap, 'LoopNormal'), axis=1) > 0
angle = numpy.arctan2(0.5, 0.9)
assert abs(points(cap)[on_loop][:, 2] - numpy.cos(angle)).max() < 0.01
assert abs(numpy.linalg.norm(array(cap, 'LoopCoordinates')[on_loop], axis=1) - angle).max() < 0.03
assert abs(array(cap, 'LoopNormal')[on_loop] - points(cap)[on_loop]).max() < 0.05
seed = vtk_to_numpy(shapetesting.facts(cap).GetArray('CutFeature.Seed'))[0]
assert numpy.linalg.norm(seed - [0, 0, 1]) < 0.02

# The same with a few places in place of a loop: the way between them is straight over the surface.
drawn = simple.ShapeCutFeature(Input=sphere, LoopPoints=circle(0.9, 0.5, 12).ravel().tolist())
drawn.UpdatePipeline()
assert abs(fact(shapetesting.output(drawn), 'CutFeature.FeatureArea') / area(cap) - 1) < 0.1
assert len(drawn.LoopPoints) == 36

# Data of points and cells are passed on; new points have what is between, and the fill goes on.
surface = copy(read('DentedSphere600.vtp'))
shapetesting.add_array(surface, 2.0 * points(surface) + [1, 2, 3], 'Linear')
shapetesting.add_array(surface, numpy.arange(surface.GetNumberOfPoints(), dtype=numpy.int32), 'Whole')
marks = numpy_to_vtkIdTypeArray(numpy.arange(surface.GetNumberOfCells()), deep=True)
marks.SetName('Cell')
surface.GetCellData().AddArray(marks)
curve = closed_curve(circle(0.8, 0.6))
for part in cut(surface, curve):
    original = array(part, 'OriginalPointId')
    kept = original >= 0
    assert (points(part)[kept] == points(surface)[original[kept]]).all()
    assert (array(part, 'Whole')[kept] == original[kept]).all()
    filled = (cells(part, 'Filled') == 1) if part.GetCellData().HasArray('Filled') else numpy.zeros(
        part.GetNumberOfCells(), bool)
    on_fill = numpy.setdiff1d(triangles(part)[filled], triangles(part)[~filled])
    exact = numpy.delete(numpy.arange(part.GetNumberOfPoints()), on_fill)
    wanted = 2.0 * points(part) + [1, 2, 3]
    assert abs(array(part, 'Linear') - wanted)[exact].max() < 1e-12
    # Between the values at the rim, which reach from side to side.
    assert abs(array(part, 'Linear') - wanted)[:, :2].max() < 0.4
    # Every piece lies in the triangle that it says it is a part of.
    whole = points(surface)[triangles(surface)[cells(part, 'Cell')[~filled]]]
    middles = points(part)[triangles(part)[~filled]].mean(axis=1)
    normals = numpy.cross(whole[:, 1] - whole[:, 0], whole[:, 2] - whole[:, 0])
    for i in range(3):
        side = numpy.cross(whole[:, (i + 1) % 3] - whole[:, i], middles - whole[:, i])
        assert (numpy.einsum('ij,ij->i', side, normals) > 0).all()
parts = cut(surface, curve)
assert abs(area(parts[0]) + area(parts[1]) - area(surface) - sum(
    0.5 * numpy.linalg.norm(numpy.cross(c[1] - c[0], c[2] - c[0]))
    for c in points(parts[1])[triangles(parts[1])[cells(parts[1], 'Filled') == 1]])) < 1e-9

# The rest is cut again: its numbers of points come before data that go on over the fill.
first = copy(parts[1])
again = vtkPolyData()
again.SetPoints(first.GetPoints())
again.SetPolys(first.GetPolys())
for name in ('OriginalPointId', 'Linear'):
    again.GetPointData().AddArray(first.GetPointData().GetArray(name))
other = cut(again, closed_curve(-circle(0.8, 0.6)))[1]
assert (array(other, 'OriginalPointId') < again.GetNumberOfPoints()).all() and euler(other) == 2
assert abs(array(other, 'Linear') - 2.0 * points(other) - [1, 2, 3])[:, :2].max() < 0.4

# Ids that are one point's alone are no new point's; a point that no triangle uses changes nothing.
ids = numpy_to_vtkIdTypeArray(numpy.arange(surface.GetNumberOfPoints()), deep=True)
ids.SetName('Ids')
astray = copy(surface)
astray.GetPointData().AddArray(ids)
astray.GetPointData().SetActiveGlobalIds('Ids')
for part in cut(astray, curve):
    assert not part.GetPointData().HasArray('Ids')
astray.GetPointData().Initialize()
astray.GetPoints().InsertNextPoint(1e12, numpy.nan, 0)
for part, wanted in zip(cut(astray, curve), parts):
    assert (triangles(part) == triangles(wanted)).all()

# Polygons are cut into triangles, which keep the polygon's data.
plane = simple.Plane(XResolution=10, YResolution=10)
plane.UpdatePipeline()
quads = copy(shapetesting.output(plane))
marks = numpy_to_vtkIdTypeArray(numpy.arange(100), deep=True)
marks.SetName('Cell')
quads.GetCellData().AddArray(marks)
for part in cut(quads, closed_curve(circle(0, 0.31)), FillHole=False):
    middles = points(part)[triangles(part)].mean(axis=1) + 0.5
    wanted = numpy.floor(10 * middles[:, 0]) + 10 * numpy.floor(10 * middles[:, 1])
    assert (cells(part, 'Cell') == wanted).all()

# Not filled; the other side; a copy.
open_rest = cut(surface, curve, FillHole=False)[1]
assert euler(open_rest) == 1 and cells(open_rest, 'Filled').max() == 0
larger = cut(surface, curve, FillHole=False, Side=1)
assert larger[0].GetNumberOfCells() == open_rest.GetNumberOfCells()
kept = cut(surface, curve, KeepOriginal=True)
assert (points(kept[1]) == points(surface)).all() and array(kept[0], 'LoopNormal').any()
assert kept[1].GetNumberOfCells() == surface.GetNumberOfCells()


# Selections: of cells, of points, and what was extracted.
heights = -points(surface)[triangles(surface)][:, :, 2]
chosen = numpy.flatnonzero((heights > 0.6).all(axis=1))
high = numpy.flatnonzero(points(surface)[:, 2] < -0.6)
by_cells = cut(surface, None, selection_of(chosen, vtkSelectionNode.CELL))
assert by_cells[0].GetNumberOfCells() == len(chosen)
assert (numpy.sort(cells(by_cells[0], 'Cell')) == chosen).all()
assert euler(by_cells[1]) == 2 and (array(by_cells[0], 'OriginalPointId') >= 0).all()
by_points = cut(surface, None, selection_of(high, vtkSelectionNode.POINT))
assert (triangles(by_points[0]) == triangles(by_cells[0])).all()
producer = simple.TrivialProducer()
producer.GetClientSideObject().SetOutput(surface)
queried = simple.IDSelectionSource(
    FieldType='CELL', IDs=[number for cell in chosen for number in (-1, cell)])
extracted = simple.ExtractSelection(Input=producer, Selection=queried)
for source in (queried, extracted):
    selected = simple.ShapeCutFeature(Input=producer, Selection=source)
    selected.UpdatePipeline()
    ids = cells(shapetesting.output(selected), 'Cell')
    assert (numpy.sort(ids) == chosen).all()

# A selection whose outline touches itself at a point has two fans of triangles there, and so have
# the rest and its fills: both parts are manifolds, and data go on.
grid = simple.Plane(XResolution=12, YResolution=12)
grid.UpdatePipeline()
pinched = copy(shapetesting.output(grid))
shapetesting.add_array(pinched, 2.0 * points(pinched) + [1, 2, 3], 'Linear')
block = {(i, j) for i in range(3, 9) for j in range(3, 9)} - {(3, 3), (4, 4)}
for part in cut(pinched, None, selection_of([12 * j + i for i, j in block], vtkSelectionNode.CELL)):
    assert edges(part, 'NonManifold') == 0
    assert abs(array(part, 'Linear') - 2.0 * points(part) - [1, 2, 3])[:, :2].max() < 0.2
    corners = triangles(part)
    for point in numpy.unique(corners):
        around = corners[(corners == point).any(axis=1)]
        rim = around[around != point]
        ends = (numpy.unique(rim, return_counts=True)[1] == 1).sum()
        assert ends <= 2, 'two fans of triangles touch at point %d' % point

# Blocks are one surface, and a selection knows them by their place in the tree.
blocks = vtkMultiBlockDataSet()
for i, half in enumerate((heights.mean(axis=1) > 0, heights.mean(axis=1) <= 0)):
    blocks.SetBlock(2 * i, shapetesting.without_cells(surface, numpy.flatnonzero(~half)))
joined = cut(blocks, curve)
assert abs(area(joined[0]) - area(parts[0])) < 1e-9 and euler(joined[1]) == 2
picked = selection_of(range(20), vtkSelectionNode.CELL)
picked.GetNode(0).GetProperties().Set(vtkSelectionNode.COMPOSITE_INDEX(), 3)
assert cut(blocks, None, picked, FillHole=False)[0].GetNumberOfCells() == 20

# A slice is a loop: lines of two points in any order.
sliced = simple.Slice(Input=producer, SliceType='Plane')
sliced.SliceType.Origin = [0, 0, 0.31]
sliced.SliceType.Normal = [0, 0.1, 1]
halves = simple.ShapeCutFeature(Input=producer, Loop=sliced, SnapShare=0)
halves.UpdatePipeline()
top = points(shapetesting.output(halves))
assert (0.1 * top[:, 1] + top[:, 2] > 0.31 - 1e-6).all(), (0.1 * top[:, 1] + top[:, 2]).min()

# What is wrong is said.
refused('press Draw Loop', surface)
refused('both Loop and Selection', surface, curve, picked)
line = vtkPolyData()
line.DeepCopy(curve)
line.GetLines().Initialize()
refused('the Loop has no lines', surface, line)
open_line = simple.PolyLineSource(Points=circle(0.8, 0.6).ravel().tolist())
open_line.UpdatePipeline()
refused('open curve', surface, shapetesting.output(open_line))
refused('Loop Index is 1, but the number of loops is 1', surface, curve, LoopIndex=1)
refused('SnapShare is 0.7', surface, curve, SnapShare=0.7)
refused('no cell of the surface', surface, None, selection_of([], vtkSelectionNode.CELL))
refused('nothing to cut', surface, None, selection_of(
    range(surface.GetNumberOfCells()), vtkSelectionNode.CELL))
refused("no cell array 'vtkOriginalCellIds'", surface, None, copy(surface))
# Around the bar between two holes: one must be cut, too, to part it.
refused('does not divide the surface', read('TwoTorusSmall.vtp'),
        closed_curve(0.6 * circle(0, 1)[:, [0, 2, 1]]))

# A bar stands on a slab: the loop follows the concave edges around its foot, though its four positions are beside them,
# on the bar or on the slab. The same while it is drawn.
cubes = vtkImageData()
cubes.SetDimensions(13, 13, 13)
z, y, x = numpy.meshgrid(*[numpy.arange(12)] * 3, indexing='ij')
solid = numpy_to_vtk(((z < 4) | ((x // 4 == 1) & (y // 4 == 1))).ravel().astype(float), deep=True)
solid.SetName('Solid')
cubes.GetCellData().SetScalars(solid)
inside = vtkThreshold()
inside.SetLowerThreshold(0.5)
inside.SetInputData(cubes)
bar = vtkDataSetSurfaceFilter()
bar.SetInputConnection(inside.GetOutputPort())
bar.Update()
bar = bar.GetOutput()
beside = closed_curve(numpy.array([[8.5, 5.7, 4], [6.3, 8, 4.4], [4, 6.1, 4.5], [5.9, 3.6, 4]]))
for settings in ({}, {'Dragging': True}):
    foot = cut(bar, beside, CreaseWeight=10.0, **settings)[0]
    assert abs(fact(foot, 'CutFeature.CutLength') - 16) < 1e-12, fact(foot, 'CutFeature.CutLength')
    assert abs(fact(foot, 'CutFeature.FeatureArea') - (4 * 4 * 8 + 16)) < 1e-12
straight = fact(cut(bar, beside)[0], 'CutFeature.CutLength')
assert abs(straight - 16) > 0.1, straight  # from position to position, beside the edges
assert fact(cut(bar, beside, CreaseWeight=10.0, Creases=1)[0], 'CutFeature.CutLength') == straight
# Positions that may not move are visited, and parts of the loop that go there and back are left out.
assert fact(cut(bar, beside, CreaseWeight=10.0, CreaseReach=0.0)[0], 'CutFeature.CutLength') > 16 - 1e-12
refused('CreaseWeight is -1', bar, beside, CreaseWeight=-1.0)
refused('CreaseReach is 0.7', bar, beside, CreaseReach=0.7)

# Set down where it was cut the feature is in its old place.
for curve_ in (closed_curve(circle(0.8, 0.6)), closed_curve(circle(-0.7, 0.7))):
    feature, rest = cut(surface, curve_)
    assert fact(feature, 'CutFeature.ReturnsInPlace') == 1
    paste = shapemap.vtkShapePasteFeature()
    paste.SetInputDataObject(0, feature)
    paste.SetInputDataObject(1, rest)
    paste.SetSeed(*vtk_to_numpy(shapetesting.facts(feature).GetArray('CutFeature.Seed'))[0])
    assert not shapetesting.run(paste)
    back = points(paste.GetOutputDataObject(0))
    assert max(numpy.linalg.norm(back - place, axis=1).min() for place in points(feature)) < 1e-12
    assert euler(paste.GetOutputDataObject(0)) == 2

# While it is drawn a loop that cannot be cut leaves the last outputs.
dragged = new(surface, curve, Dragging=True)
assert not shapetesting.run(dragged)
good = copy(dragged.GetOutputDataObject(0))
assert fact(good, 'CutFeature.Refused') == 0 and not good.GetPointData().HasArray('LoopNormal')
dragged.SetInputDataObject(1, closed_curve(circle(0.8, 0.6)[:2]))
assert not shapetesting.run(dragged)
last = dragged.GetOutputDataObject(0)
assert fact(last, 'CutFeature.Refused') == 1 and (points(last) == points(good)).all()
assert shapetesting.facts(last).GetAbstractArray('CutFeature.Refusal').GetValue(0)
dragged.SetDragging(False)
assert shapetesting.run(dragged)
