"""Shape Coupling: shapes of different kinds, matched by the distances along them.

As an example: the surface of a figure and its skeleton."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, check_refused, fact, points, read, set_points


def new(a, b, landmarks=None, targets=None, **settings):
    return shapetesting.new(shapemap.vtkShapeCoupling, a, b, landmarks, targets, **settings)


def outputs(*arguments, **settings):
    return shapetesting.outputs(new(*arguments, **settings))


def cloud(places):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    set_points(data, places)
    return data


# The example: each point of the figure goes to the skeleton that Shape Skeleton extracts.
figure = simple.XMLPolyDataReader(FileName=shapetesting.data_file('FigureASmall.vtp'))
skeleton = simple.ShapeSkeleton(Input=figure)
coupled = simple.ShapeCoupling(ShapeA=figure, ShapeB=skeleton)
coupled.UpdatePipeline()
surface, curves = shapetesting.output(coupled), shapetesting.output(coupled, 1)
# Exchanging the legs alone, or the arms alone, keeps all distances along the skeleton.
found, wanted = (numpy.abs(values) * [1, 0, 1] for values in (array(surface, 'TargetPosition'), points(surface)))
away = numpy.linalg.norm(found - wanted, axis=1).mean()
assert away < 0.1 * numpy.ptp(points(surface)[:, 2]), 'limbs go to their own centrelines: %s' % away
ids = array(surface, 'TargetPointId').ravel()
assert (points(curves)[ids] == array(surface, 'TargetPosition')).all()

# A solid's points, moved and renumbered, as a cloud: landmarks decide what symmetry leaves open.
bar = read('BentBarSmall.vtu')
places = points(bar)
order = numpy.random.default_rng(3).permutation(len(places))
moved = cloud(2.0 * places[order][:, [1, 2, 0]] + 5.0)
chosen = [0, 300, 800, 1100]
landmarks, targets = cloud(places[chosen]), cloud(2.0 * places[chosen][:, [1, 2, 0]] + 5.0)
first, second, facts, table = outputs(bar, moved, landmarks, targets)
errors = numpy.linalg.norm(
    array(first, 'TargetPosition') - (2.0 * places[:, [1, 2, 0]] + 5.0), axis=1)
spacing = 2.0 * (1.0 / 6)
print('mean error of a cloud: %.2f of the spacing' % (errors.mean() / spacing))
assert errors.mean() < spacing and first.GetNumberOfCells() == bar.GetNumberOfCells()
assert fact(first, 'Coupling.Landmarks') == 4

# The table is a coupling: its rows and columns sum to the weights of the samples.
columns = {table.GetColumnName(k): vtk_to_numpy(table.GetColumn(k)) for k in range(3)}
for data, name in ((first, 'SampleOfA'), (second, 'SampleOfB')):
    sums = numpy.bincount(columns[name], columns['Mass'], minlength=data.GetNumberOfPoints())
    weights = array(data, 'SampleWeight').ravel()
    assert abs(weights.sum() - 1.0) < 1e-9 and (weights > 0).sum() == 204
    assert abs(sums - weights).sum() < fact(first, 'Coupling.Error') + fact(first, 'Coupling.Omitted') + 1e-9

# The same from an array of the landmarks, and with the shape in two blocks.
add_array(landmarks, points(targets), 'TargetPosition')
again = outputs(bar, moved, landmarks)[0]
assert (array(again, 'TargetPointId') == array(first, 'TargetPointId')).all()
tree = vtkMultiBlockDataSet()
tree.SetBlock(1, moved)
blocks = outputs(bar, tree, landmarks)
assert (array(blocks[0], 'TargetPointId') == array(first, 'TargetPointId')).all()
assert (array(blocks[1].GetBlock(1), 'TargetPosition') == array(second, 'TargetPosition')).all()

# What is refused.
check_refused(new(bar, moved, None, targets), 'TargetLandmarks without Landmarks')
check_refused(new(bar, moved, landmarks, cloud(places[:3])), '4', '3', 'equally many')
check_refused(new(bar, cloud(places[:3])), 'ShapeB has 3 different points')
check_refused(new(bar, moved, SmallestMass=2.0), 'SmallestMass')
for name, value in (('Samples', 3), ('Starts', 0), ('Entropy', 0.0), ('EntropyFactor', 1.0)):
    check_refused(new(bar, moved, **{name: value}), name)
