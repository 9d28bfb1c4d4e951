"""Shape Collection: many surfaces compared by their shape difference operators."""
import numpy
from paraview import simple
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkPolyData)
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

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


def renumbered(data, order, places):
    """A copy with its points in another order, at other places; order[k] is the old number of point k."""
    result = vtkPolyData()
    located = vtkPoints()
    located.SetDataTypeToDouble()
    for k in order:
        located.InsertNextPoint(places[k])
    result.SetPoints(located)
    new_number = numpy.argsort(order)
    cells = vtkCellArray()
    for k in range(data.GetNumberOfCells()):
        corners = data.GetCell(k).GetPointIds()
        cells.InsertNextCell(3, [int(new_number[corners.GetId(c)]) for c in range(3)])
    result.SetPolys(cells)
    add_array(result, array(data, 'Number')[order], 'Number')
    return result


def root_of_area(surface):
    corners = points(surface)[shapetesting.triangles(surface)]
    return numpy.sqrt(numpy.linalg.norm(numpy.cross(
        corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2)


# The example: spheres with a bump at the top, and one with a bump at the side.
sphere = simple.Clean(Input=simple.Sphere(ThetaResolution=24, PhiResolution=24, Radius=1.0))
bump = 'coords*(1+%g*exp(6*(%s-1)))'
made = [simple.Calculator(Input=sphere, CoordinateResults=1, Function=bump % (0.1 * k, 'coordsZ'))
        for k in (1, 3, 2, 0, 4)]
made.append(simple.Calculator(Input=sphere, CoordinateResults=1, Function=bump % (0.4, 'coordsX')))
compared = simple.ShapeCollection(Shapes=simple.GroupDatasets(Input=made))
compared.UpdatePipeline()
shapes, template, distances, table, operators, facts, resampled = (
    shapetesting.output(compared, port) for port in range(7))
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

# The shapes have their positions on the template, and are resampled by themselves.
start = int(fact(template, 'Collection.Template'))
for blocks in (shapes, resampled):
    assert blocks.GetNumberOfBlocks() == 6
    for number, each in enumerate(made):
        assert (points(blocks.GetBlock(number)) == points(shapetesting.output(each))).all()
        assert (array(blocks.GetBlock(number), 'TargetPosition') == points(template)).all()
# Of the dendrogram, the two shapes that are most alike are neighbours, and all shapes are leaves.
leaves = vtk_to_numpy(table.GetColumnByName('Leaf'))
assert sorted(leaves) == list(range(6))
nearest = numpy.unravel_index((between + 1e9 * numpy.eye(6)).argmin(), between.shape)
assert abs(leaves[nearest[0]] - leaves[nearest[1]]) == 1

# Sets of partitions are the same collection.
data = [copy(shapetesting.output(each)) for each in made]
partitions = vtkPartitionedDataSetCollection()
for number, each in enumerate(data):
    partitions.SetPartition(number, 0, each)
again = outputs(partitions)
assert (columns(again[2], 'Distance') == between).all()
named = outputs(group(data))[3].GetColumnByName('Name')
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
assert outputs(group([surface, stretched]), Measure=1)[5].GetColumnByName(
    'Collection.LargestDistance').GetValue(0) < 1e-9, 'angles are the same'
for measure in (0, 2, 3):
    same = outputs(group([surface, stretched]), surface, Correspondence=1, Measure=measure, Scale=True)
    assert columns(same[2], 'Distance').max() < 1e-6, 'only their sizes differ'
# By positions: every point is as far from its partner as from the centre.
superimposed = outputs(group([surface, stretched]), surface, Measure=3)
assert array(superimposed[1], 'PositionDeviation').max() > 0.3

# Procrustes with maps: the shapes in the order of the template's points have the same distances.
turned = outputs(group([surface, stretched]), surface, Correspondence=1, Measure=3)
assert abs(columns(turned[2], 'Distance') - columns(superimposed[2], 'Distance')).max() < 1e-6
for blocks, places in ((turned[6], points(surface)), (turned[0], points(surface))):
    assert abs(array(blocks.GetBlock(1), 'TargetPosition') - places).max() < 1e-6
assert abs(points(turned[6].GetBlock(1)) - 2.0 * points(surface)).max() < 1e-6

# Computed: copies of a figure with points in other orders, sizes and places are mapped from the surfaces alone.
figure = read('FigureASmall.vtp')
figure.GetPointData().Initialize()
numbers = numpy.arange(figure.GetNumberOfPoints(), dtype=float)
add_array(figure, numbers, 'Number')
copies = [copy(figure)]
for seed in (1, 2):
    order = numpy.random.default_rng(seed).permutation(figure.GetNumberOfPoints())
    copies.append(renumbered(figure, order, (1.0 + seed) * points(figure) + seed))
found = outputs(group(copies), Correspondence=2)
size = numpy.ptp(points(figure), axis=0).max()
assert fact(found[1], 'Collection.Pairs') == 3 and fact(found[1], 'Collection.Triples') == 1
assert fact(found[1], 'Collection.CycleError') <= fact(found[1], 'Collection.PairwiseCycleError') + 1e-9
base = int(fact(found[1], 'Collection.Template'))
for number, each in enumerate(copies):
    mapped = found[0].GetBlock(number)
    truth = points(copies[base])[numpy.argsort(array(copies[base], 'Number'))][array(mapped, 'Number').astype(int)]
    error = numpy.linalg.norm(array(mapped, 'TargetPosition') - truth, axis=1).mean() / numpy.ptp(truth, axis=0).max()
    print('copy %d: mean error %.1e of the size' % (number, error))
    assert error < 1e-3
    # Resampled: arrays are carried, and points have the cells of the template.
    block = found[6].GetBlock(number)
    assert block.GetNumberOfCells() == found[1].GetNumberOfCells()
    assert numpy.median(abs(array(block, 'Number') - array(found[1], 'Number'))) < 1e-6
    assert (array(block, 'TargetPosition') == points(found[1])).all()

# Landmarks of the copies, numbered and in another order in each, have their partners as images.
chosen = numpy.arange(0, figure.GetNumberOfPoints(), figure.GetNumberOfPoints() // 7)


def numbered(data, seed=None):
    """Some of its points as landmarks, in the order of their numbers, or in another one with numbers."""
    at = numpy.argsort(array(data, 'Number'))[chosen]
    order = numpy.arange(len(at)) if seed is None else numpy.random.default_rng(seed).permutation(len(at))
    result = vtkPolyData()
    located = vtkPoints()
    located.SetDataTypeToDouble()
    for point in at[order]:
        located.InsertNextPoint(points(data)[point])
    result.SetPoints(located)
    if seed is not None:
        add_array(result, order + 1.0, 'Number')
    return result


marks = [numbered(data, None if number == 0 else number) for number, data in enumerate(copies)]
for base in (None, copies[2]):
    guided = shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeCollection, group(copies), base, group(marks if base is None else marks + marks[2:]),
        Correspondence=2))
    size = root_of_area(guided[1])
    for number, each in enumerate(copies):
        images = array(guided[0].GetBlock(number), 'TargetPosition')[numpy.argsort(array(each, 'Number'))[chosen]]
        truth = points(guided[1])[numpy.argsort(array(guided[1], 'Number'))[chosen]]
        assert numpy.linalg.norm(images - truth, axis=1).max() < 1e-6 * size, (number, images - truth)
many = shapetesting.new(shapemap.vtkShapeCollection, group(copies), None, group(marks + marks), Correspondence=2)
check_refused(many, 'Landmarks', 'block 3', 'block k')
add_array(marks[1], numpy.ones(len(chosen)), 'Number')
check_refused(shapetesting.new(shapemap.vtkShapeCollection, group(copies), None, group(marks), Correspondence=2),
              'number 1 twice', 'shape 1')
unused = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeCollection, group([copies[0], copies[0]]), None, group(marks)))
assert 'ignored' in fact(unused[1], 'Collection.Warning')

# Surfaces of other sizes and triangles, one of a few hundred points, by each method, and with one of them as the
# template that is given: each point goes to its own place. The bound is that of automatic maps.
def decimated(surface, share, size):
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(surface)
    decimation.SetTargetReduction(1.0 - share)
    decimation.Update()
    set_points(decimation.GetOutput(), size * points(decimation.GetOutput()))
    return decimation.GetOutput()


LARGEST = 0.03  # mean error over the root of the area
bare = copy(figure)
bare.GetPointData().Initialize()
sizes = (1.0, 1.0, 5.0, 0.2)
remeshed = [bare] + [decimated(bare, share, size) for share, size in zip((0.7, 0.5, 0.25), sizes[1:])]
assert remeshed[3].GetNumberOfPoints() < 300
for settings in ({}, {'Method': 1}, {'Consistency': 0}, {'Consistency': 0, 'Method': 1}, {'CoarsePoints': 400}):
    for base in (None, remeshed[1]):
        found = outputs(group(remeshed), base, Correspondence=2, **settings)
        number = int(fact(found[1], 'Collection.Template'))
        assert (number == -1) == (base is not None)
        assert found[1].GetNumberOfPoints() == (base or remeshed[number]).GetNumberOfPoints()
        size = 1.0 if base else sizes[number]
        errors = [numpy.linalg.norm(array(found[0].GetBlock(k), 'TargetPosition') / size - points(
            remeshed[k]) / sizes[k], axis=1).mean() / root_of_area(bare) for k in range(4)]
        back = [numpy.linalg.norm(points(found[6].GetBlock(k)) / sizes[k] - points(found[1]) / size, axis=1).mean()
                / root_of_area(bare) for k in range(4)]
        print(settings, 'template', number, 'errors', numpy.round(errors, 4), 'back', numpy.round(back, 4))
        assert max(errors) <= LARGEST and max(back) <= LARGEST, (settings, number, errors, back)
        disagreements = vtk_to_numpy(found[3].GetColumnByName('Disagreement'))
        assert (disagreements.max() == 0) == ('Consistency' in settings)
        assert (found[5].GetColumnByName('Collection.Pairs') is None) == ('Consistency' in settings)

# Shapes that cannot be mapped are left out and named; the numbers of the others stay.
torn, loose = copy(bare), copy(bare)
torn.GetPolys().InsertNextCell(3, [0, 500, 900])
loose.GetPoints().InsertNextPoint(0, 0, 0)
found = outputs(group([torn, bare, vtkPolyData(), remeshed[1], loose, remeshed[2]]), Correspondence=2)
assert fact(found[1], 'Collection.LeftOut') == 3 and fact(found[1], 'Collection.Shapes') == 3
said = fact(found[1], 'Collection.Warning')
for words in ('shape 0 (number 0)', 'two sheets touch', 'shape 2 (number 2) is empty', 'shape 4 (number 4)',
              'points that no triangle uses'):
    assert words in said, said
for blocks in (found[0], found[6]):
    assert [blocks.GetBlock(k) is not None for k in range(6)] == [False, True, False, True, False, True]
assert list(vtk_to_numpy(found[3].GetColumnByName('Shape'))) == [1, 3, 5]
assert fact(found[1], 'Collection.Outlier') in (1, 3, 5) and fact(found[1], 'Collection.Template') in (1, 3, 5)
only = outputs(group([bare, remeshed[1], remeshed[2]]), Correspondence=2)
for one, other in zip((1, 3, 5), range(3)):
    assert (array(found[0].GetBlock(one), 'TargetPosition') == array(
        only[0].GetBlock(other), 'TargetPosition')).all(), 'the others have the same maps'
check_refused(new(group([torn, bare]), Correspondence=2), 'two or more')
check_refused(new(group([torn, loose]), Correspondence=2), 'no shape can be mapped', 'shape 0')

# One shape is compared, with a warning. What does not correspond is refused.
alone = outputs(surface)
assert 'only one surface' in fact(alone[1], 'Collection.Warning')
assert array(alone[1], 'AreaDeviation').max() == 0
check_refused(new(group([surface, read('FigureASmall.vtp')]), surface), 'shape 1', 'points', 'Maps')
check_refused(new(group([surface, surface]), Correspondence=1), 'Template', 'connect it')
bare = copy(surface)
bare.GetPointData().Initialize()
check_refused(new(group([bare, surface]), surface, Correspondence=1), "no point array 'TargetPosition'")
check_refused(new(group([surface, surface, surface]), Correspondence=2, Neighbours=1), 'Neighbours')
check_refused(new(group([surface]), Correspondence=2), 'two or more')
for name, value in (('BasisSize', 1), ('BasisSize', 10000), ('EmbeddingDimension', 0)):
    check_refused(new(group([surface, surface]), **{name: value}), name)
