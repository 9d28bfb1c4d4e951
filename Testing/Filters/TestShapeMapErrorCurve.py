"""Shape Map Error Curve: how far a map between surfaces is from the true one, as a cumulative curve.

As an example: a sphere that is turned by a map that should leave it where it is."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import add_array, copy, fact, points, read

ANGLE = 0.3


def column(table, name):
    return vtk_to_numpy(table.GetColumnByName(name))


def errors_of(surface, target, truth, **properties):
    algorithm = shapemap.vtkShapeMapErrorCurve()
    for port, data in enumerate((surface, target, truth)):
        algorithm.SetInputDataObject(port, data)
    for name, value in properties.items():
        getattr(algorithm, 'Set' + name)(value)
    assert not shapetesting.run(algorithm)
    return algorithm.GetOutputDataObject(0)


# The example: each point goes too far by an arc; the chart is the curve of the literature.
sphere = simple.Sphere(Radius=1.0, ThetaResolution=48, PhiResolution=48)
turn = 'iHat*(coordsX*cos({0})-coordsY*sin({0}))+jHat*(coordsX*sin({0})+coordsY*cos({0}))+kHat*coordsZ'
turned = simple.Calculator(Input=sphere, ResultArrayName='TargetPosition',
                           Function=turn.format(ANGLE))
there = simple.Calculator(Input=sphere, ResultArrayName='TargetPosition', Function='coords')
curve = simple.ShapeMapErrorCurve(Input=turned, Target=sphere, Truth=there, Normalisation='None')
view = simple.CreateView('XYChartView')
shown = simple.Show(curve, view)
shown.UseIndexForXAxis = 0
shown.XArrayName = 'Error'
shown.SeriesVisibility = ['Share']
simple.Render(view)
found = shapetesting.output(curve)
errors, shares = column(found, 'Error'), column(found, 'Share')
assert (numpy.diff(errors) >= 0).all() and (numpy.diff(shares) > 0).all() and shares[-1] == 1
sphere.UpdatePipeline()
across = numpy.linalg.norm(points(shapetesting.output(sphere))[:, :2], axis=1)
wanted = numpy.sort(2 * numpy.arcsin(across * numpy.sin(ANGLE / 2)))
assert abs(errors - wanted).max() < 2e-3 * ANGLE, abs(errors - wanted).max()
assert abs(fact(found, 'MapErrorCurve.Mean') - wanted.mean()) < 2e-3 * ANGLE
assert abs(fact(found, 'MapErrorCurve.Maximum') - ANGLE) < 2e-3 * ANGLE
assert fact(found, 'MapErrorCurve.Coverage') > 0.9999
on_points = vtk_to_numpy(shapetesting.output(curve, 1).GetPointData().GetArray('Error'))
assert (numpy.sort(on_points) == errors).all()
assert abs(on_points - 2 * numpy.arcsin(across * numpy.sin(ANGLE / 2))).max() < 2e-3 * ANGLE
assert shapetesting.facts(found).GetArray('MapErrorCurve.RoundTripMean') is None

# Divided by the root of the area, and by pi; a truth of a few places, in blocks.
surface = shapetesting.output(turned)
target = shapetesting.output(sphere)
few = vtkMultiBlockDataSet()
few.SetBlock(1, shapetesting.output(there))
for normalisation, unit in ((1, numpy.sqrt(4 * numpy.pi)), (2, numpy.pi)):
    found = errors_of(surface, target, few, Normalisation=normalisation)
    assert abs(fact(found, 'MapErrorCurve.Unit') / unit - 1) < 2e-3
    assert abs(fact(found, 'MapErrorCurve.Maximum') * unit - ANGLE) < 3e-3 * ANGLE

# A mirrored map is as good as the truth where Truth says so; a map back that is its inverse comes
# back to the start.
truth = copy(shapetesting.output(there))
add_array(truth, points(target) * [-1, 1, 1], 'SymmetricTargetPosition')
mirrored = copy(surface)
add_array(mirrored, points(target) * [-1, 1, 1], 'TargetPosition')
found = errors_of(mirrored, mirrored, truth)
assert fact(found, 'MapErrorCurve.Mirrored') == 1 and fact(found, 'MapErrorCurve.Maximum') < 1e-6
assert fact(found, 'MapErrorCurve.RoundTripMaximum') < 1e-6
found = errors_of(mirrored, mirrored, truth, SymmetryArray='no such array')
assert fact(found, 'MapErrorCurve.Mirrored') == 0 and fact(found, 'MapErrorCurve.Mean') > 0.2

# What has no error is refused with the fact.
plain = read('DentedSphere600.vtp')
for inputs, words in (((target, target, truth), "the Input has no point array 'TargetPosition'"),
                      ((surface, target, target), "the Truth has no point array 'TargetPosition'")):
    algorithm = shapemap.vtkShapeMapErrorCurve()
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    message = ' '.join(shapetesting.run(algorithm))
    assert 'Shape Map Error Curve: ' in message and words in message, message
    assert algorithm.GetOutputDataObject(0).GetNumberOfRows() == 0
print('a turned sphere is off by its arcs, and a mirrored one is not')
