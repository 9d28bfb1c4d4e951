"""Shape Cut Feature and Shape Paste Feature with features of several loops.

As an example: the handle of a cup, cut off along two loops and pasted on a planet."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkSelectionNode
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
import shapemap

import shapetesting
from shapetesting import add_array, array, closed_curves, copy, edges, euler, fact, points, triangles


def cup():
    """A ball with a handle: a torus, joined smoothly."""
    image = vtkImageData()
    image.SetDimensions(62, 46, 46)
    image.SetOrigin(-1.27, -1.36, -1.36)
    image.SetSpacing(0.0601, 0.0603, 0.0603)
    where = numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    x, y, z = where.T
    ball = numpy.sqrt(x ** 2 + y ** 2 + z ** 2) - 1.0
    ring = numpy.hypot(numpy.hypot(x - 1.0, z) - 0.6, y) - 0.17
    share = numpy.clip(0.5 + 0.5 * (ring - ball) / 0.12, 0.0, 1.0)
    # Positive inside: the triangles then face outwards.
    values = numpy_to_vtk(0.12 * share * (1.0 - share) - ring - share * (ball - ring), deep=True)
    values.SetName('Distance')
    image.GetPointData().SetScalars(values)
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    contour.Update()
    return copy(contour.GetOutput())


def circle(direction, radius):
    """A circle on the unit sphere around a direction in the plane y = 0."""
    axis = numpy.array(direction) / numpy.linalg.norm(direction)
    across = numpy.array([axis[2], 0.0, -axis[0]])
    turns = 2 * numpy.pi * numpy.arange(50)[:, None] / 50
    return numpy.cos(radius) * axis + numpy.sin(radius) * (
        numpy.cos(turns) * across + numpy.sin(turns) * numpy.array([0.0, 1.0, 0.0]))


def planet(radius=2.0, resolution=90):
    ball = simple.Sphere(Radius=radius, ThetaResolution=resolution, PhiResolution=resolution)
    ball.UpdatePipeline()
    return copy(shapetesting.output(ball))


def cut(surface, loops=None, selection=None, **settings):
    return shapetesting.outputs(shapetesting.new(shapemap.vtkShapeCutFeature, surface, loops, selection, **settings))[:2]


def new(feature, target, seed, **settings):
    return shapetesting.new(shapemap.vtkShapePasteFeature, feature, target, Seed=seed, **settings)


def paste(*args, **settings):
    return shapetesting.outputs(new(*args, **settings))[0]


def seed_of(feature, loop=0):
    return feature.GetFieldData().GetArray('CutFeature.Seed').GetTuple3(loop)


def check_closed(surface, number):
    assert edges(surface, 'Boundary') == edges(surface, 'NonManifold') == 0
    assert euler(surface) == number, euler(surface)


def distance(one, other):
    """The largest distance of a point from the nearest point of the other surface."""
    return max(numpy.linalg.norm(other - place, axis=1).min() for place in one)


# The example.
whole = cup()
check_closed(whole, 0)
FEET = closed_curves([circle([0.82, 0.0, 0.572], 0.36), circle([0.82, 0.0, -0.572], 0.36)])
handle, rest = cut(whole, FEET)
assert fact(handle, 'CutFeature.Loops') == fact(rest, 'CutFeature.Holes') == 2
assert fact(handle, 'CutFeature.ReturnsInPlace') == 1 and euler(handle) == 0
check_closed(rest, 2)
numbers = set(array(handle, 'LoopCoordinates')[numpy.linalg.norm(array(handle, 'LoopNormal'), axis=1) > 0, 2])
assert numbers == {0.0, 1.0}, numbers
target = planet()
result = paste(handle, target, [0.3, 1.9, 0.4], Rotation=40.0, Loops=1)
check_closed(result, 0)                                                             # genus 1
assert fact(result, 'PasteFeature.EulerNumber') == 0 and fact(result, 'PasteFeature.Loops') == 2
assert fact(result, 'PasteFeature.DeviationAfter') < 3.0
assert fact(result, 'PasteFeature.FlippedTriangles') == 0
lengths = numpy.linalg.norm(points(result), axis=1)
assert 2.5 < lengths.max() < 2.9, lengths.max()                                     # 2 and a handle of 0.77

# With one loop, the other stays open, wherever it is.
for index in (0, 1):
    single = paste(handle, target, [0.3, 1.9, 0.4], LoopIndex=index)
    assert fact(single, 'PasteFeature.Loops') == 1
    assert edges(single, 'Boundary') > 10 and euler(single) == 1

# In place, the cup is there again: drawn loops, or the border of a selection.
back = paste(handle, rest, seed_of(handle), Loops=1)
check_closed(back, 0)
assert fact(back, 'PasteFeature.BandTriangles') == 0
assert distance(points(whole), points(back)) < 1e-6                                 # points are floats

# The half of a torus is a tube with two loops, given by a selection: in place, the torus is closed again.
ring = shapetesting.torus(3.0, 1.0, 60, 24)
check_closed(ring, 0)
half = numpy.flatnonzero(points(ring)[triangles(ring)].mean(axis=1)[:, 0] > 0.0)
tube, rest = cut(ring, None, shapetesting.selection_of(half, vtkSelectionNode.CELL))
assert fact(tube, 'CutFeature.Loops') == fact(rest, 'CutFeature.Holes') == 2
check_closed(rest, 2)
back = paste(tube, rest, seed_of(tube), Loops=1)
check_closed(back, 0)
assert back.GetNumberOfPoints() == ring.GetNumberOfPoints()
assert back.GetNumberOfCells() == ring.GetNumberOfCells()
size = numpy.linalg.norm(numpy.ptp(points(ring), axis=0))
assert distance(points(ring), points(back)) < 1e-12 * size, distance(points(ring), points(back))
# The loop at the seed is the chosen one: the other one follows.
other = paste(tube, rest, seed_of(tube, 1), Loops=1, LoopIndex=1)
assert distance(points(ring), points(other)) < 1e-12 * size

# Features of which nothing is known stand on fills of their own, one at each loop.
bare = copy(handle)
for name in ('LoopCoordinates', 'LoopNormal'):
    bare.GetPointData().RemoveArray(name)
result = paste(bare, target, [0.3, 1.9, 0.4], Loops=1)
assert fact(result, 'PasteFeature.Base') == 'own fill'
check_closed(result, 0)

# Data blend at each seam.
add_array(handle, numpy.full(handle.GetNumberOfPoints(), 3.0), 'Height')
add_array(target, points(target)[:, 0], 'Height')
result = paste(handle, target, [0.3, 1.9, 0.4], Loops=1)
part = numpy.array([result.GetCellData().GetArray('Part').GetValue(i) for i in range(result.GetNumberOfCells())])
band = numpy.intersect1d(triangles(result)[part == 1], triangles(result)[part == 2])
assert abs(array(result, 'Height')[band] - points(result)[band, 0]).max() < 1e-6
assert array(result, 'Height').max() == 3.0

# The loop is an output with both curves; Shape Deform moves the handle by it.
surface, loop = shapetesting.outputs(new(handle, target, [0.3, 1.9, 0.4], Loops=1, OptimizeNormals=False))[:2]
deformed = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeDeform, handle, loop))[0]
first = triangles(surface)[[surface.GetCellData().GetArray('Part').GetValue(i) == 2
                            for i in range(surface.GetNumberOfCells())]].min()
moved = points(surface)[first:first + handle.GetNumberOfPoints()]
assert abs(points(deformed) - moved).max() < 1e-11

# What does not fit.
shapetesting.check_refused(new(handle, target, [0.3, 1.9, 0.4], Loops=1, Scale=6.0), 'lower Scale to')
patch = simple.Plane(XResolution=40, YResolution=40)
patch.UpdatePipeline()
small = copy(shapetesting.output(patch))
shapetesting.check_refused(new(handle, small, [0.0, 0.0, 0.0], Loops=1), 'at the loop with index', 'of 2',
                           'beyond the boundary', 'lower Scale to')
assert edges(paste(handle, small, [0.0, 0.0, 0.0]), 'NonManifold') == 0              # one loop alone fits
shapetesting.check_refused(new(handle, target, [0.3, 1.9, 0.4], Loops=1, BridgeGaps=True),
                           'set Loops to One', 'Shape Solidify')
