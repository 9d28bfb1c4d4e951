"""Shape From Operators: a surface from its difference operators to another one."""
import numpy
from paraview import simple
import shapemap
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, set_points, triangles


def of_cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def recovered(first, table, **options):
    return shapetesting.outputs(shapetesting.new(shapemap.vtkShapeFromOperators, first, table, **options))


def operators(first, second, **options):
    surface = copy(first)
    add_array(surface, points(second), 'TargetPosition')
    return shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeMapDifference, surface, second, Products=1, **options))[1]


# The example: a plate, and the same rolled to a part of a cylinder of radius 2.
plate = simple.Plane(XResolution=24, YResolution=24)
roll = '2*sin(coordsX/2)*iHat+coordsY*jHat+2*cos(coordsX/2)*kHat'
rolled = simple.Calculator(Input=plate, CoordinateResults=1, Function=roll)
mapped = simple.Calculator(Input=plate, ResultArrayName='TargetPosition', Function=roll)
difference = simple.ShapeMapDifference(
    SurfaceA=mapped, SurfaceB=rolled, Products='Triangles', OffsetDistance=0.1,
    NumberOfEigenpairs=100)
back = simple.ShapeFromOperators(Input=plate, Operators=simple.OutputPort(difference, 1))
back.UpdatePipeline()
truth, found = points(shapetesting.output(rolled)), points(shapetesting.output(back))
# The height of the arc; a plate that only keeps its lengths stays flat.
rise = numpy.ptp(truth[:, 2])
moments = numpy.linalg.svd(found - found.mean(axis=0), compute_uv=False)
wanted = numpy.linalg.svd(truth - truth.mean(axis=0), compute_uv=False)
assert rise > 0.05 and abs(moments / wanted - 1).max() < 0.03, (moments, wanted)
metric = shapetesting.output(back, 1)
corners = triangles(metric)
flat = points(shapetesting.output(plate))
sides = numpy.stack([flat[corners[:, (k + 2) % 3]] - flat[corners[:, (k + 1) % 3]] for k in range(3)], axis=1)
cosines = abs(sides[:, :, 0]) / numpy.linalg.norm(sides, axis=2)
curvatures = of_cells(metric, 'NormalCurvatures')
inside = abs(flat[corners]).max(axis=(1, 2)) < 0.4
# Euler: the normal curvature is that of the circle times the squared cosine of the direction.
errors = (curvatures - 0.5 * cosines ** 2)[inside]
assert numpy.sqrt((errors ** 2).mean()) < 0.03, errors
assert abs(of_cells(metric, 'Angles').sum(axis=1) - 180).max() < 1e-6

# A closed surface twice as large: areas are 4 times as large, and lengths twice.
sphere = read('DentedSphere600.vtp')
other = copy(sphere)
set_points(other, 2 * points(sphere))
table = operators(sphere, other, NumberOfEigenpairs=30)
assert table.GetNumberOfColumns() == 2 * 30
output, metric = recovered(sphere, table)[:2]
goal, corners = points(other), triangles(other)
lengths = numpy.stack([numpy.linalg.norm(
    goal[corners[:, (k + 2) % 3]] - goal[corners[:, (k + 1) % 3]], axis=1) for k in range(3)], axis=1)
assert abs(of_cells(metric, 'SideLengths') / lengths - 1).max() < 1e-6
assert fact(output, 'FromOperators.BrokenTriangles') == 0
assert fact(output, 'FromOperators.LengthError') < 0.01
assert (array(output, 'SourcePosition') == points(sphere)).all()

# Without the offset surface there are no curvatures.
assert not metric.GetCellData().HasArray('NormalCurvatures')

# What is no table of operators is refused with the fact.
for first, given, words in (
        (sphere, vtkTable(), 'have no columns Area0 and Conformal0'),):
    algorithm = shapemap.vtkShapeFromOperators()
    algorithm.SetInputDataObject(0, first)
    algorithm.SetInputDataObject(1, given)
    message = ' '.join(shapetesting.run(algorithm))
    assert 'Shape From Operators: ' in message and words in message, message
algorithm = shapemap.vtkShapeMapDifference()
algorithm.SetInputDataObject(0, sphere)
algorithm.SetInputDataObject(1, other)
algorithm.SetOffsetDistance(-2.0)
assert 'OffsetDistance is -2' in ' '.join(shapetesting.run(algorithm))
print('a plate rolls up again, by lengths on it and on its offset surface')
