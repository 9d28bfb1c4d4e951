"""Shape Harmonic Volume Map with Exact: surfaces inside a solid are met as well as its boundary is.

As an example: a head with its skull and brain, onto a ball that holds a polycube and a cube."""
import os

import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.util.numpy_support import numpy_to_vtk
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, triangles

# The example: the same with soft features, and with Exact.
head, skull, brain = (
    simple.XMLPolyDataReader(FileName=[shapetesting.data_file('Phantom%sSmall.vtp' % name)])
    for name in ('Head', 'Skull', 'Brain'))
for reader in (head, skull, brain):
    reader.UpdatePipeline()  # so that its arrays are known
inner = simple.AppendGeometry(Input=[skull, brain])
soft = simple.ShapeHarmonicVolumeMap(Domain=inner, Boundary=head, Features=[skull, brain])
exact = simple.ShapeHarmonicVolumeMap(Domain=inner, Boundary=head, Features=[skull, brain], Exact=1)
misses = {}
for name, proxy in (('soft', soft), ('exact', exact)):
    proxy.UpdatePipeline()
    moved = shapetesting.output(proxy)
    away = numpy.linalg.norm(points(moved) - array(moved, 'TargetPosition'), axis=1)
    misses[name] = numpy.sqrt((away ** 2).mean()) / 2.0, away.max() / 2.0
    assert array(moved, 'OutsideDomain').sum() == 0
print('skull and brain are missed by (RMS, maximum):', misses)
assert misses['soft'][0] > 0.02 and misses['exact'][0] < 0.5 * misses['soft'][0]

moved, charges, levels = (shapetesting.output(exact, port) for port in range(3))
field = shapetesting.facts(moved)


def by_region(data, name):
    values = shapetesting.facts(data).GetArray('HarmonicVolumeMap.' + name)
    assert values.GetNumberOfTuples() == 1 and values.GetNumberOfComponents() == 3
    return shapetesting.vtk_to_numpy(values)[0]


rmse = by_region(moved, 'BorderRMSEVertices')
expected = numpy.sqrt((rmse[1] ** 2 * 1926 + rmse[2] ** 2 * 1538) / (1926 + 1538))
assert abs(expected / misses['exact'][0] - 1.0) < 0.01, 'the facts are those of the map'
assert rmse[0] == fact(moved, 'HarmonicVolumeMap.RMSEVertices')
assert abs(by_region(moved, 'BorderMaximum').max() / max(
    misses['exact'][1], fact(moved, 'HarmonicVolumeMap.Maximum')) - 1.0) < 0.5
assert (by_region(charges, 'BorderJumpMaximum')[1:] > 0.0).all()
regions = [levels.GetValueByName(i, 'RegionId').ToInt() for i in range(levels.GetNumberOfRows())]
assert sorted(set(regions)) == [0, 1, 2] and regions == sorted(regions)

# The charge set: charges by region, the surfaces by what they enclose, an affine part for each.
ids, charge = array(charges, 'RegionId'), array(charges, 'Charge')
used = abs(charge).max(axis=1) > 0.0
affine = shapetesting.vtk_to_numpy(charges.GetFieldData().GetArray('Affine'))
skins = shapetesting.vtk_to_numpy(charges.GetFieldData().GetArray('Skin'))
assert affine.shape == (3, 12) and skins.shape == (3,) and skins[0] == 0.0 and skins[1:].min() > 0.0
cells = shapetesting.vtk_to_numpy(charges.GetCellData().GetArray('RegionId'))
counts = [reader.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
          for reader in (head, skull, brain)]
assert [(cells == region).sum() for region in range(3)] == counts
assert all((used & (ids == region)).sum() > 100 for region in range(3))
assert (ids[triangles(charges)] == cells[:, None]).all()


def by_hand(region, places):
    own = used & (ids == region)
    distances = numpy.linalg.norm(places[:, None, :] - points(charges)[None, own, :], axis=2)
    matrix = affine[region].reshape(3, 4)
    return places @ matrix[:, :3].T + matrix[:, 3] + (
        1.0 / (4.0 * numpy.pi * distances)) @ charge[own]


def applied(data, inverse=False):
    return shapetesting.outputs(
        shapetesting.new(shapemap.vtkShapeApplyVolumeMap, data, charges, Inverse=inverse))[0]


def cloud(places):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    return data


# Random places on each border, not its vertices alone, and the middle of each layer.
random = numpy.random.default_rng(3)


size = 2.0
for region, reader in ((1, skull), (2, brain)):
    surface = reader.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    places, normals = shapetesting.places_on(surface, 500, random)
    sides = numpy.split(points(applied(cloud(numpy.concatenate(
        [places + step * normals for step in (1e-9, -1e-9)])))), 2)
    jump = numpy.linalg.norm(sides[0] - sides[1], axis=1) / size
    print('border of region', region, 'jumps by', jump.max(), 'at most; the fitted maps by',
          by_region(moved, 'BorderJumpMaximum')[region])
    assert jump.max() < 1e-7
    fitted = by_hand(region, places) - by_hand(region - 1, places)
    assert numpy.linalg.norm(fitted, axis=1).max() / size <= 2.0 * by_region(
        moved, 'BorderJumpMaximum')[region]
    assert abs(sides[0] - by_hand(region - 1, places)).max() < 1e-7

# Deep inside a region, where no skin reaches, the formula of its map alone.
middle = points(brain.SMProxy.GetClientSideObject().GetOutputDataObject(0)).mean(axis=0)
deep = middle + 0.1 * random.standard_normal((50, 3))
assert abs(points(applied(cloud(deep))) - by_hand(2, deep)).max() < 1e-10

# There and back through all layers, also through the transformation.
inside = numpy.concatenate([middle + share * (points(
    reader.SMProxy.GetClientSideObject().GetOutputDataObject(0))[::126] - middle)
    for reader in (head, skull, brain) for share in (0.3, 0.8, 0.99)])
there = applied(cloud(inside))
back = applied(there, inverse=True)
forth = applied(back)
state = array(back, 'OutsideDomain')
print('of', len(state), 'points', (state != 0).sum(), 'were not taken back')
assert (state != 0).mean() < 0.02
assert abs(points(forth) - points(there))[state == 0].max() < 1e-9 * size
transform = shapemap.vtkShapeHarmonicTransform()
transform.SetChargeSetData(charges)
single = numpy.array([transform.TransformDoublePoint(*place) for place in inside[::4]])
assert abs(single - points(there)[::4]).max() < 1e-10
h = 1e-6
for place in inside[::8]:
    derivative, result = numpy.zeros((3, 3)), [0.0, 0.0, 0.0]
    transform.InternalTransformDerivative(list(place), result, derivative)
    differences = numpy.stack([
        (numpy.array(transform.TransformDoublePoint(*(place + step))) -
         numpy.array(transform.TransformDoublePoint(*(place - step)))) / (2.0 * h)
        for step in h * numpy.eye(3)], axis=1)
    assert abs(derivative - differences).max() < 1e-4, (derivative, differences)


def new(features, targets=()):
    return shapetesting.new(
        shapemap.vtkShapeHarmonicVolumeMap, cloud(numpy.zeros((1, 3))), read('DentedSphere600.vtp'),
        features, targets, Exact=True)


def error_of(*features):
    return shapetesting.refusal(new(features))


def sphere(radius, factor=None, x=0.0):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(16)
    source.SetPhiResolution(12)
    source.SetCenter(x, 0.0, 0.0)
    source.Update()
    surface = source.GetOutput()
    if factor:
        add_array(surface, factor * points(surface), 'TargetPosition')
    return surface


# A border whose images are a target's points, by order; then points are soft by their Weight.
core = sphere(0.4)
image = copy(core)
shapetesting.set_points(image, 0.9 * points(core))
paired = new([core], [image])
assert not shapetesting.run(paired)
own = new([sphere(0.4, 0.9)])
assert not shapetesting.run(own)
assert (points(paired.GetOutputDataObject(1)) == points(own.GetOutputDataObject(1))).all()
needle = cloud(numpy.array([[0.1, 0.0, 0.0]]))
add_array(needle, numpy.array([[0.09, 0.01, 0.0]]), 'TargetPosition')
message = error_of(sphere(0.4, 0.9), needle)
for words in ('feature 1', 'maximum principle', 'Weight', 'Exact'):
    assert words in message, message
add_array(needle, numpy.array([20.0]), 'Weight')
weighed = new([sphere(0.4, 0.9), needle])
assert not shapetesting.run(weighed)
result = weighed.GetOutputDataObject(0)
assert fact(result, 'HarmonicVolumeMap.FeaturePoints') == 1
assert 0.0 < fact(result, 'HarmonicVolumeMap.RMSEFeatures') < 0.01

# Borders that cannot be: the error names the feature, the fact and the remedy.
message = error_of(shapetesting.without_cells(sphere(0.4, 0.9), [3]))
assert 'feature 0' in message and 'open' in message, message
message = error_of(sphere(0.4, 1.0, 0.9))
assert 'feature 0' in message and 'cross' in message, message
message = error_of(sphere(0.4, 1.0, 5.0))
assert 'feature 0' in message and 'outside' in message, message
message = error_of(sphere(0.4, 1.0), sphere(0.4, 1.0, 0.3))
assert 'feature 0' in message and 'feature 1' in message and 'cross' in message, message

# Regions that touch have no map of their own each.
touching = sphere(0.4, 1.0)
regions = numpy_to_vtk(numpy.tile([1, 2], (touching.GetNumberOfCells(), 1)), deep=True)
regions.SetName('Regions')
touching.GetCellData().AddArray(regions)
message = error_of(touching)
assert 'feature 0' in message and 'touch' in message and 'extract' in message, message

# A charge set of layers survives a file; one that is cut short is refused with the reason.
path = os.path.join(shapetesting.BUILD, 'Testing', 'ExactCharges.vtp')
shapetesting.write(charges, path)
before, charges = points(applied(cloud(inside[::2]))), read(path)
assert (points(applied(cloud(inside[::2]))) == before).all()
broken = copy(charges)
broken.GetPointData().RemoveArray('RegionId')
shapetesting.check_refused(
    shapetesting.new(shapemap.vtkShapeApplyVolumeMap, cloud(inside), broken), 'RegionId')
print('layers are met exactly')
