"""Shape Register Volume: a solid mapped onto the solid inside another surface, without landmarks.

As an example: a head and a wider, longer one. No pairs of points are given; the known deformation
tells how far the images are from the true ones, beside the nearest positions on the other head."""
import numpy
from paraview import simple
import shapemap

import shapetesting
from shapetesting import array, check_refused, fact, nearest_positions, points

# The example.
head = simple.PassArrays(Input=simple.OpenDataFile(shapetesting.data_file('PhantomHeadSmall.vtp')))
other = simple.Calculator(Input=head, CoordinateResults=1, Function=(
    'iHat*1.2*coordsX + jHat*(coordsY+0.15*coordsX*coordsX) + kHat*coordsZ*(1+0.1*coordsX)'))
registered = simple.ShapeRegisterVolume(Input=head, Target=other, Align=0, MaximumIterations=20)
registered.UpdatePipeline()
source, target = shapetesting.output(head), shapetesting.output(other)
surface, solid = shapetesting.output(registered), shapetesting.output(registered, 1)
size = numpy.ptp(points(target), axis=0).max()
truth, images = points(target), array(surface, 'TargetPosition')
error = numpy.linalg.norm(images - truth, axis=1).mean() / size
plain = numpy.linalg.norm(nearest_positions(points(source), target) - truth, axis=1).mean() / size
print('mean error: %.4f of the size; nearest positions: %.4f' % (error, plain))
assert error < plain
assert (points(surface) == points(source)).all(), 'the input moved'
assert fact(surface, 'RegisterVolume.MeanDistanceAfter') < 0.1 * fact(surface, 'RegisterVolume.MeanDistanceBefore')
assert fact(surface, 'RegisterVolume.MaximumDistanceAfter') < 0.01
assert abs(fact(surface, 'RegisterVolume.DistortionBefore') - 6.0) < 1e-9 < fact(
    surface, 'RegisterVolume.DistortionAfter') - 6.0

# The solid has the points of the surface, and none of its cells is inverted.
assert fact(surface, 'RegisterVolume.Tetrahedra') == solid.GetNumberOfCells() > 10000
ids = array(solid, 'OriginalPointId').astype(int)
assert (ids >= 0).sum() == source.GetNumberOfPoints()
assert (points(solid)[ids >= 0] == images[ids[ids >= 0]]).all()
assert abs(array(solid, 'SourcePosition')[ids >= 0] - points(source)[ids[ids >= 0]]).max() < 1e-6
corners = shapetesting.points(solid)[numpy.array([[solid.GetCell(i).GetPointId(k) for k in range(4)]
                                                  for i in range(solid.GetNumberOfCells())])]
assert numpy.linalg.det(corners[:, 1:] - corners[:, :1]).min() > 0.0, 'inverted'

# The surface is the boundary of a harmonic volume map.
moved = simple.ShapeHarmonicVolumeMap(Domain=head, Boundary=registered)
moved.UpdatePipeline()
assert numpy.linalg.norm(points(shapetesting.output(moved)) - images, axis=1).max() < 0.02 * size

# A solid that is moved, turned and scaled is aligned first.
ball = shapetesting.read('DentedSphere600.vtp')
turned = shapetesting.copy(ball)
turn = numpy.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
shapetesting.set_points(turned, 3.0 * points(ball) @ turn.T + [5.0, 6.0, 7.0])
algorithm = shapetesting.new(shapemap.vtkShapeRegisterVolume, ball, turned)
aligned = shapetesting.outputs(algorithm)[0]
assert fact(aligned, 'RegisterVolume.MaximumDistanceAfter') < 1e-3
assert abs(fact(aligned, 'RegisterVolume.DistortionAfter') - 6.0) < 1e-3

# What cannot be reached is said.
stiff = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeRegisterVolume, ball, turned, Align=0, DistortionWeight=100.0, MaximumIterations=2))[0]
assert 'lower Distortion Weight' in fact(stiff, 'RegisterVolume.Warning')

check_refused(shapetesting.new(shapemap.vtkShapeRegisterVolume, ball, ball, DistortionWeight=0.0), 'DistortionWeight')
check_refused(shapetesting.new(shapemap.vtkShapeRegisterVolume, ball, ball, MaximumIterations=0), 'MaximumIterations')
