"""Shape Collection: many surfaces compared by their shape difference operators."""
import numpy
from paraview import simple
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection)

import shapetesting
from shapetesting import add_array, array, check_refused, copy, fact, points, read, set_points


def group(shapes):
    blocks = vtkMultiBlockDataSet()
    for number, data in enumerate(shapes):
        blocks.SetBlock(number, data)
        blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), 'number %d' % number)
    return blocks


def new(shapes, base=None, **settings):
    return shapetesting.new(shapemap.vtkShapeCollection, shapes, base, **settings)


def outputs(*arguments, **settings):
    return shapetesting.outputs(new(*arguments, **settings))


def columns(table, *names):
    """Its columns as an array: those whose names begin with one of `names`."""
    found = [table.GetColumn(k) for k in range(table.GetNumberOfColumns())
             if table.GetColumnName(k).rstrip('0123456789') in names]
    return numpy.column_stack([vtk_to_numpy(each) for each in found])


# The example: spheres with a bump at the top, and one with a bump at the side.
sphere = simple.Clean(Input=simple.Sphere(ThetaResolution=24, PhiResolution=24, Radius=1.0))
bump = 'coords*(1+%g*exp(6*(%s-1)))'
made = [simple.Calculator(Input=sphere, CoordinateResults=1, Function=bump % (0.1 * k, 'coordsZ'))
        for k in (1, 3, 2, 0, 4)]
made.append(simple.Calculator(Input=sphere, CoordinateResults=1, Function=bump % (0.4, 'coordsX')))
compared = simple.ShapeCollection(Shapes=simple.GroupDatasets(Input=made))
compared.UpdatePipeline()
template, table, distances, operators, facts = (shapetesting.output(compared, port) for port in range(5))
assert fact(template, 'Collection.Outlier') == 5 and fact(template, 'Collection.Shapes') == 6
assert vtk_to_numpy(table.GetColumnByName('Rank'))[5] == 0
between = columns(distances, 'Distance')
assert between.shape == (6, 6) and (between == between.T).all() and (numpy.diag(between) == 0).all()
assert (numpy.argsort(between[3, :5]) == [3, 0, 2, 1, 4]).all(), 'by the height of the bump: %s' % between[3]
# Two coordinates show nearly all of the distances: the height of a bump, and which one it is.
embedded = columns(table, 'Embedding')
shares = vtk_to_numpy(facts.GetColumnByName('Collection.EmbeddingShares')).ravel()
print('shares of the coordinates:', shares)
assert shares[:2].sum() > 0.8 and embedded.shape == (6, 3)
away = numpy.linalg.norm(embedded[:, None] - embedded[None], axis=2)
assert (away <= between + 1e-9).all(), 'a projection shortens distances'
# The shapes differ at the bumps: the template is the sphere or one of the shapes.
places = points(shapetesting.output(sphere))
most = places[array(template, 'AreaDeviation').argmax()]
assert max(most[0], most[2]) > 0.8, most
bottom = (places[:, 2] < -0.8) & (places[:, 0] < 0.3)
assert array(template, 'AreaDeviation')[bottom].max() < 0.2 * array(template, 'AreaDeviation').max()
assert array(template, 'AreaVariationFunctions').shape == (template.GetNumberOfPoints(), 10)

# Sets of partitions are the same collection.
data = [copy(shapetesting.output(each)) for each in made]
partitions = vtkPartitionedDataSetCollection()
for number, each in enumerate(data):
    partitions.SetPartition(number, 0, each)
again = outputs(partitions)
assert (columns(again[2], 'Distance') == between).all()
named = outputs(group(data))[1].GetColumnByName('Name')
assert [named.GetValue(k) for k in range(6)] == ['number %d' % k for k in range(6)]

# The operators of one shape, the rows with its number, are those of Shape Map Difference.
rows = vtk_to_numpy(operators.GetColumnByName('Shape')) == 4
start = data[int(fact(template, 'Collection.Template'))]
mapped = copy(start)
add_array(mapped, points(data[4]), 'TargetPosition')
difference = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeMapDifference, mapped, data[4], Products=1))[1]
for kind in ('Area', 'Conformal'):
    assert abs(columns(operators, kind)[rows] - columns(difference, kind)).max() < 1e-9

# Shapes with points of their own, mapped onto the template: here, a shape in another order.
surface = read('DentedSphere600.vtp')
add_array(surface, points(surface), 'TargetPosition')
stretched = copy(surface)
set_points(stretched, 2.0 * points(surface))
mapped = outputs(group([surface, stretched]), surface, Correspondence=1, Measure=0)
assert abs(columns(mapped[2], 'Distance') - [[0, 3], [3, 0]]).max() < 1e-9, 'areas are 4 times as large'
assert outputs(group([surface, stretched]), Measure=1)[4].GetColumnByName(
    'Collection.LargestDistance').GetValue(0) < 1e-9, 'angles are the same'
# By positions: every point is as far from its partner as from the centre.
superimposed = outputs(group([surface, stretched]), surface, Measure=3)
assert array(superimposed[0], 'PositionDeviation').max() > 0.3

# One shape is compared, with a warning. What does not correspond is refused.
alone = outputs(surface)
assert 'only one surface' in fact(alone[0], 'Collection.Warning')
assert array(alone[0], 'AreaDeviation').max() == 0
check_refused(new(group([surface, read('FigureASmall.vtp')]), surface), 'shape 1', 'points', 'Maps')
check_refused(new(group([surface, surface]), Correspondence=1), 'Template', 'connect it')
bare = copy(surface)
bare.GetPointData().Initialize()
check_refused(new(group([bare, surface]), surface, Correspondence=1), "no point array 'TargetPosition'")
check_refused(new(group([surface, surface]), surface, Correspondence=1, Measure=3), 'Procrustes', 'Measure')
for name, value in (('BasisSize', 1), ('BasisSize', 10000), ('EmbeddingDimension', 0)):
    check_refused(new(group([surface, surface]), **{name: value}), name)
