"""Shape Map Difference: where two surfaces differ in area and in angles, by a map between them.

As an example: a sphere and the same with a bump."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, set_points


def column(table, name):
    return vtk_to_numpy(table.GetColumnByName(name))


def operator(table, name):
    return numpy.column_stack([column(table, name + str(k)) for k in range(table.GetNumberOfRows())])


# The example: the bump is 1.5 times as far from the centre; below the equator nothing changes.
sphere = simple.Sphere(Radius=1.0, ThetaResolution=64, PhiResolution=64)
bump = simple.Calculator(Input=sphere, ResultArrayName='TargetPosition',
                         Function='coords*(1+0.5*exp(8*(coordsZ-1)))')
bumped = simple.Calculator(Input=sphere, CoordinateResults=1,
                           Function='coords*(1+0.5*exp(8*(coordsZ-1)))')
difference = simple.ShapeMapDifference(SurfaceA=bump, SurfaceB=bumped)
difference.UpdatePipeline()
found = shapetesting.output(difference)
height = points(found)[:, 2]
areas, angles = array(found, 'AreaDifference'), array(found, 'ConformalDifference')
assert areas.max() > 1.5 and height[areas.argmax()] > 0.9, areas.max()
assert angles.max() > 1.02 and height[angles.argmax()] > 0.6, angles.max()
assert abs(areas[height < -0.3] - 1).max() < 0.03, abs(areas[height < -0.3] - 1).max()
assert abs(angles[height < -0.3] - 1).max() < 0.03
leading = array(found, 'AreaEigenfunctions')[:, 0]
assert height[abs(leading).argmax()] > 0.9
values = found.GetFieldData().GetArray('MapDifference.AreaEigenvalues')
assert values.GetNumberOfTuples() == 10 and values.GetValue(0) > areas.max()

# Twice as large: areas are 4 times as large, angles the same, in every entry of the operators.
surface = read('DentedSphere600.vtp')
larger = copy(surface)
set_points(larger, 2.0 * points(surface))
add_array(surface, 2.0 * points(surface), 'TargetPosition')


def differences(first, second):
    algorithm = shapemap.vtkShapeMapDifference()
    algorithm.SetInputDataObject(0, first)
    algorithm.SetInputDataObject(1, second)
    algorithm.SetNumberOfEigenpairs(20)
    assert not shapetesting.run(algorithm)
    return algorithm


algorithm = differences(surface, larger)
table = algorithm.GetOutputDataObject(1)
assert table.GetNumberOfRows() == 20 and table.GetNumberOfColumns() == 40
identity = numpy.eye(20)
assert abs(operator(table, 'Area') - 4 * identity).max() < 1e-6
identity[0, 0] = 0
assert abs(operator(table, 'Conformal') - identity).max() < 1e-6
output = algorithm.GetOutputDataObject(0)
assert abs(array(output, 'AreaDifference') - 4).max() < 1e-6
assert fact(output, 'MapDifference.UndeterminedFunctions') == 0

# The precise map, where it is there, says where points go, not the positions that are near it.
corners = shapetesting.triangles(surface)
first_cell, first_corner = numpy.zeros(642, int), numpy.zeros((642, 3))
for cell, row in enumerate(corners):
    for corner, point in enumerate(row):
        first_cell[point], first_corner[point] = cell, numpy.eye(3)[corner]
precise = copy(surface)
shift = 0.004 * numpy.random.default_rng(2).normal(size=(642, 3))
add_array(precise, 2.0 * points(surface) + shift, 'TargetPosition')
close = differences(precise, larger).GetOutputDataObject(0)
add_array(precise, first_cell, 'TargetCell')
add_array(precise, first_corner, 'TargetBarycentric')
exact = differences(precise, larger).GetOutputDataObject(0)
assert abs(array(exact, 'AreaDifference') - 4).max() < 1e-6
assert abs(array(close, 'AreaDifference') - 4).max() > 1e-3
assert fact(exact, 'MapDifference.PreciseMap') == 1
assert fact(close, 'MapDifference.PreciseMap') == 0
misfit = copy(precise)
add_array(misfit, first_cell[::-1], 'TargetCell')

# What has no operators is refused with the fact.
bare = copy(surface)
bare.GetPointData().RemoveArray('TargetPosition')
for first, change, words in (
        (bare, lambda a: None, "SurfaceA has no point array 'TargetPosition'"),
        (misfit, lambda a: None, 'SurfaceA has a TargetCell that lies elsewhere on SurfaceB'),
        (surface, lambda a: a.SetNumberOfEigenpairs(1), 'NumberOfEigenpairs is 1'),
        (surface, lambda a: a.SetNumberOfEigenpairs(5000), 'NumberOfEigenpairs is 5000')):
    algorithm = shapemap.vtkShapeMapDifference()
    algorithm.SetInputDataObject(0, first)
    algorithm.SetInputDataObject(1, larger)
    change(algorithm)
    message = ' '.join(shapetesting.run(algorithm))
    assert 'Shape Map Difference: ' in message and words in message, message
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
# A product A' A has no negative eigenvalue, also where the map is far from SurfaceB.
far = shapetesting.copy(larger)
shapetesting.set_points(far, 1e12 * points(larger))
bare_of_cells = shapetesting.copy(surface)
for name in ('TargetCell', 'TargetBarycentric'):
    bare_of_cells.GetPointData().RemoveArray(name)
table = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeMapDifference, bare_of_cells, far))
for name in ('AreaEigenvalues', 'ConformalEigenvalues'):
    assert vtk_to_numpy(table[0].GetFieldData().GetArray('MapDifference.' + name)).min() >= 0.0, name
print('a bump shows where it is, and scale in areas alone')
