"""Shape Exponential Map: the part of a surface around a seed, laid out in the plane.

As an example: a checkered texture around a place of a sphere; the patch is a disk."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, triangles


def new(surface, seed, radius, **options):
    return shapetesting.new(shapemap.vtkShapeExponentialMap, surface, Seed=seed, Radius=radius, **options)


def patch_of(*arguments, **options):
    algorithm = new(*arguments, **options)
    assert not shapetesting.run(algorithm)
    return algorithm.GetOutputDataObject(0)


def vector(data, name):
    return numpy.array(shapetesting.facts(data).GetArray('ExponentialMap.' + name).GetTuple(0))


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


# The example. Directions and distances from the seed are kept: the way from (0, 0, 1) to a point of
# the unit sphere is as long as their angle, and begins in the direction of its x and y.
sphere = simple.Sphere(Radius=1.0, ThetaResolution=96, PhiResolution=96)
mapped = simple.ShapeExponentialMap(Input=sphere, Seed=[0.0, 0.0, 3.0], Radius=1.0)
mapped.UpdatePipeline()
patch = shapetesting.output(mapped)
places = points(patch)
angle = numpy.arccos(numpy.clip(places[:, 2], -1, 1))
flat = array(patch, 'TargetPosition')
assert (flat[:, 2] == 0).all()
assert abs(numpy.linalg.norm(flat, axis=1) - angle).max() < 3e-3
assert abs(array(patch, 'GeodesicDistance') - angle).max() < 3e-3
away = angle > 0.1
directions = places[away, :2] / numpy.linalg.norm(places[away, :2], axis=1)[:, None]
assert abs(flat[away, :2] / numpy.linalg.norm(flat[away], axis=1)[:, None] - directions).max() < 0.02
assert abs(fact(patch, 'ExponentialMap.SeedDistance') - 2.0) < 1e-3
assert fact(patch, 'ExponentialMap.Flipped') == fact(patch, 'ExponentialMap.Torn') == 0
assert fact(patch, 'ExponentialMap.Overlaps') == fact(patch, 'ExponentialMap.ReachesRim') == 0
assert 0.93 < fact(patch, 'ExponentialMap.Coverage') < 1.0
# The texture coordinates that ParaView takes: the disk of the radius fills the square.
texture = patch.GetPointData().GetTCoords()
assert texture.GetName() == 'ExponentialMap' and texture.GetNumberOfComponents() == 2
assert abs(vtk_to_numpy(texture) - (0.5 + flat[:, :2] / 2.0)).max() < 1e-12
# An isometry has 4; the circle around a pole is angle / sin(angle) times as long in the plane.
stretch = numpy.array([1e-9, 1.0]) / numpy.sin([1e-9, 1.0])
least, most = stretch ** 2 + stretch ** -2 + 2.0
median, tail = (shapetesting.facts(patch).GetArray('ExponentialMap.SymmetricDirichlet').GetTuple(0))
assert least < median < tail < most * 1.02

# Points, cells and their data are the surface's; polygons count by their parts.
surface = copy(read('DentedSphere600.vtp'))
random = numpy.random.default_rng(1)
add_array(surface, random.random(surface.GetNumberOfPoints()), 'Heat')
material = numpy.arange(surface.GetNumberOfCells())
numbers = numpy_to_vtk(material, deep=True)
numbers.SetName('Material')
surface.GetCellData().AddArray(numbers)
seed = points(surface)[100]
small = patch_of(surface, seed, 0.5)
ids = array(small, 'OriginalPointId')
assert (points(small) == points(surface)[ids]).all()
assert (array(small, 'Heat') == array(surface, 'Heat')[ids]).all()
assert (ids[triangles(small)] == triangles(surface)[cells(small, 'Material')]).all()
assert small.GetPointData().GetArray('TargetPosition') and not surface.GetPointData().GetTCoords()

box = simple.Box(XLength=2.0, YLength=3.0, ZLength=4.0)
box.UpdatePipeline()
quads = copy(shapetesting.output(box))  # 24 points: the faces hang together by places alone
wrapped = patch_of(quads, [0.1, 0.2, 5.0], 7.0)
assert wrapped.GetNumberOfCells() == 12
assert sorted(array(wrapped, 'OriginalPointId')) == list(range(24))

# A larger radius adds to the patch and changes nothing in it, to the last bit.
large = patch_of(surface, seed, 0.9)
count = small.GetNumberOfPoints()
assert large.GetNumberOfPoints() > count
for name in ('OriginalPointId', 'TargetPosition', 'GeodesicDistance'):
    assert (array(large, name)[:count] == array(small, name)).all(), name
assert (triangles(large)[:small.GetNumberOfCells()] == triangles(small)).all()

# The automatic radius is a tenth of the diagonal.
corners = points(surface).max(axis=0) - points(surface).min(axis=0)
automatic = patch_of(surface, seed, 0.0)
assert abs(fact(automatic, 'ExponentialMap.Radius') - 0.1 * numpy.linalg.norm(corners)) < 1e-12

# X Direction turns the image.
normal = vector(small, 'SeedNormal')
direction = numpy.cross(normal, vector(small, 'XAxis'))
turned = patch_of(surface, seed, 0.5, XDirection=direction + 3.0 * normal)
assert abs(vector(turned, 'XAxis') - direction).max() < 1e-12
flat = array(small, 'TargetPosition')
expected = numpy.stack([flat[:, 1], -flat[:, 0]], axis=1)
assert abs(array(turned, 'TargetPosition')[:, :2] - expected).max() < 1e-9

# Around a limb the front meets itself: the map is cut open there, and what is torn is marked.
tube = simple.Cylinder(Height=10.0, Radius=0.5, Resolution=40, Capping=0)
tube = simple.Subdivide(Input=simple.Triangulate(Input=tube), NumberofSubdivisions=3)
tube.UpdatePipeline()
around = patch_of(copy(shapetesting.output(tube)), [0.5, 0.0, 0.0], 2.5)
assert fact(around, 'ExponentialMap.Torn') == cells(around, 'Torn').sum() > 0
widths = numpy.ptp(array(around, 'TargetPosition')[triangles(around)], axis=1).max(axis=1)
assert widths[cells(around, 'Torn') == 0].max() < widths[cells(around, 'Torn') == 1].min()
assert not (cells(around, 'Flipped') & (1 - cells(around, 'Torn'))).any()
assert shapetesting.fact(patch_of(copy(shapetesting.output(tube)), [0.5, 4.9, 0.0], 1.0),
                         'ExponentialMap.ReachesRim') == 1

# A rough surface flips triangles; averages flip fewer, and most of these can be mended.
rough = copy(shapetesting.output(sphere))
rough_points = points(rough)
shapetesting.set_points(rough, rough_points + random.uniform(-0.025, 0.025, rough_points.shape))
rates = {}
for name, options in (('single', dict(UpwindAverage=False, NormalSmoothing=0)), ('mean', {}),
                      ('mended', dict(MendFlips=True))):
    result = patch_of(rough, [1.0, 0.0, 0.0], 0.8, **options)
    rates[name] = fact(result, 'ExponentialMap.FlipRate')
    flipped = fact(result, 'ExponentialMap.Flipped')
    assert abs(rates[name] - flipped / result.GetNumberOfCells()) < 1e-12
    assert cells(result, 'Flipped').sum() == flipped
    assert (fact(result, 'ExponentialMap.Mended') > 0) == (name == 'mended')
assert rates['mended'] < 0.5 * rates['mean'] < 0.5 * rates['single'], rates

# Blocks are one surface; a patch crosses from one to the other.
blocks = vtkMultiBlockDataSet()
x = points(surface)[triangles(surface)].mean(axis=1)[:, 0]
for block, left in enumerate((x < 0.0, x >= 0.0)):
    blocks.SetBlock(block, shapetesting.without_cells(surface, numpy.nonzero(left)[0]))
both = patch_of(blocks, [0.0, 0.0, 9.0], 0.6)
whole = patch_of(surface, [0.0, 0.0, 9.0], 0.6)
assert both.GetNumberOfCells() == whole.GetNumberOfCells()
assert abs(numpy.sort(array(both, 'GeodesicDistance'))
           - numpy.sort(array(whole, 'GeodesicDistance'))).max() < 1e-9

# What depends on the surface alone is kept, and made anew when it changes.
live = new(surface, seed, 0.3)
assert not shapetesting.run(live)
before = array(live.GetOutputDataObject(0), 'TargetPosition').copy()
live.SetSeed(points(surface)[300])
assert not shapetesting.run(live)
assert (array(live.GetOutputDataObject(0), 'TargetPosition')
        == array(patch_of(surface, points(surface)[300], 0.3), 'TargetPosition')).all()
live.SetSeed(seed)
assert not shapetesting.run(live)
assert (array(live.GetOutputDataObject(0), 'TargetPosition') == before).all()
shapetesting.set_points(surface, 2.0 * points(surface))
surface.Modified()
live.SetSeed(2.0 * seed)
live.SetRadius(0.6)
assert not shapetesting.run(live)
assert abs(array(live.GetOutputDataObject(0), 'TargetPosition') - 2.0 * before).max() < 1e-9

# What cannot be is said.
for options, words in ((dict(Radius=-1.0), 'Radius is -1'),
                       (dict(Radius=1e-7), 'no point of the surface lies within Radius'),
                       (dict(NormalSmoothing=-1), 'NormalSmoothing is -1'),
                       (dict(Seed=[0.0, float('nan'), 0.0]), 'the Seed has'),
                       (dict(XDirection=[0.0, float('inf'), 0.0]), 'the XDirection has')):
    algorithm = new(surface, seed, 0.5)
    for name, value in options.items():
        getattr(algorithm, 'Set' + name)(value)
    messages = shapetesting.run(algorithm)
    assert any('Shape Exponential Map: ' in message and words in message for message in messages), (
        options, messages)
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
print('directions and distances are kept, whatever the radius')
# Radii whose circle has no area, and smoothing without an end, are refused.
ball = read('DentedSphere600.vtp')
seed = points(ball)[3]
shapetesting.check_refused(new(ball, seed, 1e-300), 'Radius is 1e-300; it must be 0, or at least 1e-09 of the diagonal')
shapetesting.check_refused(new(ball, seed, 0.3, NormalSmoothing=2147483647), 'NormalSmoothing is 2.14748e+09',
                           'at most 1000')

# Points alone: the samples of a surface, connected by triangles in their tangent planes.


def cloud_of(places, normals=None, vertices=True):
    cloud = vtkPolyData()
    positions = vtkPoints()
    positions.SetDataTypeToDouble()
    cells = vtkCellArray()
    for number, place in enumerate(places):
        positions.InsertNextPoint(place)
        cells.InsertNextCell(1, [number])
    cloud.SetPoints(positions)
    if vertices:
        cloud.SetVerts(cells)
    if normals is not None:
        add_array(cloud, normals, 'Normals')
    return cloud


golden = numpy.pi * (1.0 + 5.0 ** 0.5)


def ball_of(count):
    number = numpy.arange(count) + 0.5
    height = 1.0 - 2.0 * number / count
    flat = numpy.sqrt(1.0 - height ** 2)
    return numpy.stack([flat * numpy.cos(golden * number), flat * numpy.sin(golden * number), height], axis=1)


def error_of(cloud):
    result = patch_of(cloud, [0.0, 0.0, 1.0], 1.0, XDirection=[1.0, 0.0, 0.0])
    place = points(result)
    away = numpy.maximum(numpy.linalg.norm(place[:, :2], axis=1), 1e-300)
    exact = place[:, :2] * (numpy.arctan2(away, place[:, 2]) / away)[:, None]
    return result, numpy.linalg.norm(array(result, 'TargetPosition')[:, :2] - exact, axis=1).max()


errors = []
for count in (500, 2000, 8000):
    result, error = error_of(cloud_of(ball_of(count)))
    errors.append(error)
    assert fact(result, 'ExponentialMap.EstimatedNormals') == 1 and fact(result, 'ExponentialMap.LocalTriangles') > 0
    assert fact(result, 'ExponentialMap.Flipped') == fact(result, 'ExponentialMap.ReachesRim') == 0
    assert result.GetNumberOfCells() == result.GetNumberOfVerts() == result.GetNumberOfPoints()
    # All points within the distance, up to its error, and outward normals.
    angles = numpy.arccos(ball_of(count)[:, 2])
    assert (angles < 0.97).sum() <= result.GetNumberOfPoints() <= (angles < 1.03).sum()
    assert ((array(result, 'Normals') * points(result)).sum(axis=1) > 0.99).all()
assert errors[2] < 0.3 * errors[0] and errors[2] < 5e-3, errors
print('points of a ball: largest errors', errors)

# Normals that are there are used: turned inside out, the image is a mirror image. Data are carried.
places = ball_of(2000)
given = cloud_of(places, places)
add_array(given, numpy.arange(2000.0), 'Number')
outward, inward = (patch_of(data, [0.0, 0.0, 1.0], 1.0, XDirection=[1.0, 0.0, 0.0])
                   for data in (given, cloud_of(places, -places, vertices=False)))
assert fact(outward, 'ExponentialMap.EstimatedNormals') == 0
assert (array(outward, 'Number') == array(outward, 'OriginalPointId')).all()
order = numpy.argsort(array(outward, 'OriginalPointId'))
mirror = numpy.argsort(array(inward, 'OriginalPointId'))
assert abs(array(outward, 'TargetPosition')[order] * [1, -1, 1] - array(inward, 'TargetPosition')[mirror]).max() < 1e-9

# A tilted plane of random points stays as it is.
flat = numpy.column_stack([random.uniform(-1, 1, (3000, 2)), numpy.zeros(3000)])
x, y = numpy.array([2.0, 1.0, 2.0]) / 3.0, numpy.array([-2.0, 2.0, 1.0]) / 3.0
plane = patch_of(cloud_of(flat[:, :1] * x + flat[:, 1:2] * y), [0.0, 0.0, 0.0], 0.5, XDirection=x)
up = 1.0 if vector(plane, 'SeedNormal').dot(numpy.cross(x, y)) > 0 else -1.0
assert abs(array(plane, 'TargetPosition')[:, :2] - flat[array(plane, 'OriginalPointId'), :2] * [1, up]).max() < 1e-12

for data, words in ((cloud_of([[0, 0, 0], [1, 1, 1], [2, 2, 2]]), 'span no surface'),
                    (cloud_of(places, places * 0.0), 'remove the array Normals')):
    shapetesting.check_refused(new(data, [0, 0, 0], 0.5), words)
shapetesting.check_refused(new(given, [0, 0, 1], 0.5, MendFlips=True), 'MendFlips needs a surface of triangles')
