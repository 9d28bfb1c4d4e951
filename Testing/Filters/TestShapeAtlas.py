"""Shape Atlas: the mean of a population, its modes, and what depends on groups and numbers."""
import numpy
from paraview import simple
import shapemap
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkPolyData,
    vtkTable)

import shapetesting
from shapetesting import add_array, array, check_refused, copy, points, read, set_points


def group(shapes, names=None):
    blocks = vtkMultiBlockDataSet()
    for number, data in enumerate(shapes):
        blocks.SetBlock(number, data)
        if names:
            blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), names[number])
    return blocks


def words(name, values):
    column = vtkStringArray()
    column.SetName(name)
    for value in values:
        column.InsertNextValue(value)
    return column


def table(*columns):
    made = vtkTable()
    for column in columns:
        made.AddColumn(column)
    return made


def numbers(name, values):
    column = numpy_to_vtk(numpy.asarray(values, float), deep=True)
    column.SetName(name)
    return column


def new(shapes, base=None, rows=None, **settings):
    return shapetesting.new(shapemap.vtkShapeAtlas, shapes, base, rows, **settings)


def outputs(*arguments, **settings):
    return shapetesting.outputs(new(*arguments, **settings))


def column(data, name):
    return vtk_to_numpy(data.GetColumnByName(name))


def value(made, name):
    return made[4].GetColumnByName('Atlas.' + name).GetValue(0)


# The example: ellipsoids whose length and height vary, independently of each other.
sphere = simple.Clean(Input=simple.Sphere(ThetaResolution=24, PhiResolution=24, Radius=1.0))
stretch = '%g*coordsX*iHat + 1.5*coordsY*jHat + %g*coordsZ*kHat'
sizes = [(3.0 + 0.3 * a, 1.0 + 0.1 * b) for a in (-1, 1) for b in (-1, 1)] * 2
made = [simple.Calculator(Input=sphere, CoordinateResults=1, Function=stretch % each) for each in sizes]
atlas = simple.ShapeAtlas(Shapes=simple.GroupDatasets(Input=made))
atlas.UpdatePipeline()
mean, scores, statistics, aligned, facts = (shapetesting.output(atlas, port) for port in range(5))
places = points(shapetesting.output(sphere))
assert facts.GetColumnByName('Atlas.NumberOfModes').GetValue(0) == 2
assert abs(points(mean) - places * [3.0, 1.5, 1.0]).max() < 1e-5, 'the mean of the half axes'
deviation = numpy.sqrt(8.0 / 7.0)
for mode, truth in (('Mode0', [0.3, 0, 0]), ('Mode1', [0, 0, 0.1])):
    given, truth = array(mean, mode), deviation * places * truth
    assert min(abs(given - truth).max(), abs(given + truth).max()) < 1e-5, mode
assert abs(array(mean, 'SourcePosition') - places * [2.7, 1.5, 0.9]).max() < 1e-5, 'the first shape'
# Every shape is the mean and its scores times the modes.
for shape in range(8):
    whole = points(mean) + sum(column(scores, 'Score%d' % k)[shape] * array(mean, 'Mode%d' % k) for k in range(2))
    assert abs(whole - points(aligned.GetBlock(shape))).max() < 1e-5
assert abs(column(statistics, 'Explained')[1] - 1.0) < 1e-9 and column(statistics, 'Modes')[0] == 1
assert abs(column(scores, 'ReconstructionError')).max() < 1e-5

# Sets of partitions are the same population, in any pose.
data = [copy(shapetesting.output(each)) for each in made]
turn = numpy.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
partitions = vtkPartitionedDataSetCollection()
for number, each in enumerate(data):
    partitions.SetPartition(number, 0, copy(each))
    if number in (2, 5):
        set_points(partitions.GetPartition(number, 0), points(each) @ turn + [5.0, 0.0, 1.0])
again = outputs(partitions)
assert abs(points(again[0]) - points(mean)).max() < 1e-5

# A table with the names of the blocks in a column, in another order, and one row more.
names = ['subject %d' % k for k in range(8)]
order = [3, 1, 0, 2, 7, 6, 5, 4]
rows = table(words('Subject', [names[k] for k in order] + ['other']),
             words('Kind', ['long' if sizes[k][0] > 3 else 'short' for k in order] + ['?']),
             numbers('Height', [100.0 * sizes[k][1] for k in order] + [0.0]))
tested = outputs(group(data, names), None, rows, Groups='Kind', Regression='Height')
assert value(tested, 'TableRows') == 'Subject'
assert [value(tested, name) for name in ('FirstGroup', 'SecondGroup')] == ['long', 'short']
assert value(tested, 'GroupPermutations') == 70 and abs(value(tested, 'GroupPValue') - 2.0 / 70.0) < 1e-12, 'exact'
assert abs(array(tested[0], 'GroupDifference') + places * [0.6, 0, 0]).max() < 1e-5
assert abs(array(tested[0], 'Slope') - places * [0, 0, 0.01]).max() < 1e-7
assert abs(value(tested, 'RegressionMean') - 100.0) < 1e-9
assert (array(tested[0], 'QValue') >= array(tested[0], 'PValue')).all()
assert [tested[1].GetColumnByName('Subject').GetValue(k) for k in range(8)] == names
# Without the height, length is the only mode.
rest = outputs(group(data, names), None, rows, Regression='Height', RemoveRegression=True)
assert value(rest, 'NumberOfModes') == 1

# The same shapes with points of their own, mapped onto the first one, are the same population.
base = read('DentedSphere600.vtp')
shapes = [copy(base) for k in range(4)]
for k, each in enumerate(shapes):
    set_points(each, points(base) * [1.0 + 0.1 * k, 1.0, 1.0 + 0.05 * k * k])
    add_array(each, points(base), 'TargetPosition')
    add_array(each, 2.0 + k * points(base)[:, 2], 'Thickness')
same = outputs(group(shapes))
shuffled = []
for k, each in enumerate(shapes):
    cells = shapetesting.triangles(each)
    swapped = numpy.random.default_rng(k).permutation(len(points(each))) if k else numpy.arange(len(points(each)))
    other = vtkPolyData()
    other.SetPoints(vtkPoints())
    other.GetPoints().SetData(numpy_to_vtk(points(each)[swapped], deep=True))
    polygons = vtkCellArray()
    for triangle in numpy.argsort(swapped)[cells].tolist():
        polygons.InsertNextCell(3, triangle)
    other.SetPolys(polygons)
    add_array(other, points(base)[swapped], 'TargetPosition')
    add_array(other, array(each, 'Thickness')[swapped], 'Thickness')
    shuffled.append(other)
mapped = outputs(group(shuffled), Correspondence=1)
assert abs(array(same[0], 'ThicknessMean') - 2 - 1.5 * points(base)[:, 2]).max() < 1e-6
assert abs(array(same[0], 'ThicknessDeviation') - (5 / 3)**0.5 * abs(points(base)[:, 2])).max() < 1e-6
for name in ('ThicknessMean', 'ThicknessDeviation', 'ThicknessMode0'):
    assert abs(array(mapped[0], name) - array(same[0], name)).max() < 1e-5, name
# A sample at the scores of a shape has its thickness.
made = shapetesting.new(shapemap.vtkShapeSynthesize, same[0])
scores = [[same[1].GetColumnByName('Score%d' % mode).GetValue(k) for mode in range(int(value(same, 'NumberOfModes')))]
          for k in range(4)]
for k, weights in enumerate(scores):
    made.SetNumberOfWeights(len(weights))
    for mode, weight in enumerate(weights):
        made.SetWeights(mode, weight)
    made.Update()
    sample = made.GetOutputDataObject(0)
    assert abs(array(sample, 'Thickness') - array(shapes[k], 'Thickness')).max() < 0.05, k
assert value(mapped, 'Template') == 0 and value(mapped, 'LargestGap') < 1e-6
assert abs(points(mapped[0]) - points(same[0])).max() < 1e-6
assert (points(outputs(group(shuffled))[0]) == points(mapped[0])).all(), 'maps are noticed'

# What cannot be used is refused.
check_refused(new(group(data[:2])), 'at least 3 shapes', 'there are 2', 'Group Datasets')
check_refused(new(group(data[:2] + [read('FigureASmall.vtp')])), 'shape 2', 'points', 'Maps')
check_refused(new(group(shapes[1:]), Correspondence=1), 'mapped to itself', 'Template')
check_refused(new(group(data), Groups='Kind'), 'no Table')
check_refused(new(group(data, names), None, rows, Groups='Sex'), "no column 'Sex'", 'Subject, Kind, Height')
check_refused(new(group(data, names), None, rows, Groups='Subject'), '8 different values')
check_refused(new(group(data, names), None, rows, Regression='Kind'), 'no number')
check_refused(new(group(data), None, rows, Groups='Kind'), '9 rows', '8 shapes')
constant = table(numbers('Age', [5.0] * 8))
check_refused(new(group(data), None, constant, Regression='Age'), 'same value')
check_refused(new(group(data), None, table(numbers('Age', [5.0] * 7 + [numpy.nan])), Regression='Age'), 'not finite')
for name, wrong in (('NumberOfModes', -1), ('SpecificitySamples', 0), ('Seed', -1)):
    check_refused(new(group(data), **{name: wrong}), name)
few = outputs(group(data), NumberOfModes=5)
assert value(few, 'NumberOfModes') == 2 and 'only 2 modes' in value(few, 'Warning')
