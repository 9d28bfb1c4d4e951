"""vtkShapeHarmonicTransform: a volume map as a transformation for VTK's filters and images.

As an example: an image is carried by the map of a charge set."""
import threading

import numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkGeneralTransform
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter, vtkTransformPolyDataFilter
from vtkmodules.vtkImagingCore import vtkImageReslice
from paraview import simple
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, points, read


def lattice(count, half):
    """An image of the cube around the origin, with its points' coordinates."""
    image = vtkImageData()
    image.SetDimensions(count, count, count)
    image.SetOrigin(-half, -half, -half)
    image.SetSpacing(*[2.0 * half / (count - 1)] * 3)
    axis = numpy.linspace(-half, half, count)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing='ij')
    return image, numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)


def intensity(places):
    return places @ [1.0, 2.0, 3.0]


charges = read('DentedSphereCharges.vtp')  # the dented ball onto the unit ball
image, places = lattice(31, 1.6)
add_array(image, intensity(places), 'Intensity')
image.GetPointData().SetActiveScalars('Intensity')

# The example. vtkImageReslice asks where a value comes from: that is the inverse.
transform = shapemap.vtkShapeHarmonicTransform()
transform.SetChargeSetData(charges)
transform.Inverse()
reslice = vtkImageReslice()
reslice.SetInputData(image)
reslice.SetResliceTransform(transform)
reslice.SetInterpolationModeToLinear()
reslice.Update()
carried = array(reslice.GetOutput(), 'Intensity')


def inverse_of(data):
    """What Shape Apply Volume Map has for the way back."""
    algorithm = shapemap.vtkShapeApplyVolumeMap()
    algorithm.SetInputDataObject(0, data)
    algorithm.SetInputDataObject(1, charges)
    algorithm.SetInverse(True)
    assert not shapetesting.run(algorithm)
    return algorithm.GetOutputDataObject(0)


# A linear intensity is interpolated exactly, so the image at y is the intensity at f^-1(y); outside
# the image of the domain everything keeps its place.
back = inverse_of(image)
state, origins = array(back, 'OutsideDomain'), points(back)
assert (state == 0).sum() > 3000 and (state == 1).sum() > 3000 and (state == 2).sum() == 0
within = abs(origins).max(axis=1) < 1.6
# (vtkImageReslice rounds its places to 2^-17 of a voxel.)
assert abs(carried - intensity(origins))[within].max() < 1e-5
assert (abs(carried - intensity(places))[state == 1] < 1e-5).all()
assert abs(carried - intensity(places))[state == 0].max() > 0.2, 'it moves'
assert transform.GetNotInverted() == 0
# Run again, the bits are the same, whatever thread took which voxel.
again = vtkImageReslice()
again.SetInputData(image)
again.SetResliceTransform(transform)
again.SetInterpolationModeToLinear()
again.SetNumberOfThreads(1)
again.Update()
assert (array(again.GetOutput(), 'Intensity') == carried).all()

# Forward: point by point, all at once, and Shape Apply Volume Map.
forward = shapemap.vtkShapeHarmonicTransform()
forward.SetChargeSetData(charges)
assert forward.GetChargeSet() is charges and forward.GetInverseFlag() == 0
ball = read('BallSmall.vtu')
inside = 0.9 * points(ball)
one_by_one = numpy.array([forward.TransformDoublePoint(*place) for place in inside])
several = vtkPoints()
several.SetDataTypeToDouble()
given = vtkPoints()
given.SetData(shapetesting.numpy_to_vtk(inside, deep=True))
forward.TransformPoints(given, several)
assert (shapetesting.vtk_to_numpy(several.GetData()) == one_by_one).all()
applied = shapemap.vtkShapeApplyVolumeMap()
scaled = copy(ball)
shapetesting.set_points(scaled, inside)
applied.SetInputDataObject(0, scaled)
applied.SetInputDataObject(1, charges)
assert not shapetesting.run(applied)
moved = applied.GetOutputDataObject(0)
assert abs(points(moved) - one_by_one).max() < 1e-13
assert (array(moved, 'OutsideDomain') == 0).sum() > 500
# Float points.
assert abs(numpy.array(forward.TransformFloatPoint(*inside[0])) - one_by_one[0]).max() < 1e-6

# There and back: to 1e-9 of the size.
way_back = forward.GetInverse()
way_back.Update()
assert way_back.GetInverseFlag() == 1
returned = numpy.array([way_back.TransformDoublePoint(*place) for place in one_by_one])
domain = array(moved, 'OutsideDomain') == 0
forth = numpy.array([forward.TransformDoublePoint(*place) for place in returned])
assert abs(forth - one_by_one)[domain].max() < 1e-9

# The derivative, against differences: of the map, and of its inverse.
h = 1e-5
for warp, samples in ((forward, inside[domain][::40]), (way_back, one_by_one[domain][::40])):
    for place in samples:
        derivative = numpy.zeros((3, 3))
        result = [0.0, 0.0, 0.0]
        warp.InternalTransformDerivative(list(place), result, derivative)
        differences = numpy.stack([
            (numpy.array(warp.TransformDoublePoint(*(place + step))) -
             numpy.array(warp.TransformDoublePoint(*(place - step)))) / (2.0 * h)
            for step in h * numpy.eye(3)], axis=1)
        assert abs(derivative - differences).max() < 1e-5 * max(1.0, abs(derivative).max()), (
            warp.GetInverseFlag(), derivative - differences)
        assert abs(numpy.array(result) - warp.TransformDoublePoint(*place)).max() < 1e-14

# Normals stay perpendicular to the surface that moves, and vectors turn with it.
sphere = simple.Sphere(Radius=0.6, ThetaResolution=60, PhiResolution=60)
sphere.UpdatePipeline()
surface = shapetesting.output(sphere)
add_array(surface, points(surface)[:, [1, 0, 2]] * [-1.0, 1.0, 0.0], 'Turning')
for kind in (vtkTransformFilter, vtkTransformPolyDataFilter):
    bender = kind()
    bender.SetInputData(surface)
    bender.SetTransform(forward)
    bender.Update()
    bent = bender.GetOutput()
    recomputed = vtkPolyDataNormals()
    recomputed.SetInputData(bent)
    recomputed.SplittingOff()
    recomputed.ConsistencyOff()
    recomputed.Update()
    cosines = (array(recomputed.GetOutput(), 'Normals') * array(bent, 'Normals')).sum(axis=1)
    assert cosines.mean() > 0.999 and cosines.min() > 0.98, (kind, cosines.min())

# In a general transform, with another, and inverted there.
general = vtkGeneralTransform()
general.PostMultiply()
general.Concatenate(forward)
general.Translate(1.0, 2.0, 3.0)
assert abs(numpy.array(general.TransformDoublePoint(*inside[3])) - one_by_one[3] -
           [1.0, 2.0, 3.0]).max() < 1e-14
general.Inverse()
assert abs(numpy.array(general.TransformDoublePoint(*(one_by_one[3] + [1.0, 2.0, 3.0]))) -
           returned[3]).max() < 1e-9

# From a filter's output: what changes there changes here, also in the inverse that was handed out.
boundary = read('DentedSphere600.vtp')
maker = shapemap.vtkShapeHarmonicVolumeMap()
maker.SetInputDataObject(0, ball)
maker.SetInputDataObject(1, boundary)
piped = shapemap.vtkShapeHarmonicTransform()
piped.SetChargeSetConnection(maker.GetOutputPort(1))
undo = piped.GetInverse()
first = numpy.array(piped.TransformDoublePoint(0.1, 0.2, 0.3))
assert abs(numpy.array(undo.TransformDoublePoint(*first)) - [0.1, 0.2, 0.3]).max() < 1e-9
time = piped.GetMTime()
assert piped.GetMTime() == time, 'nothing has changed'
target = array(boundary, 'TargetPosition')
other = copy(boundary)
other.GetPointData().RemoveArray('TargetPosition')
add_array(other, 2.0 * target, 'TargetPosition')
maker.SetInputDataObject(1, other)
assert piped.GetMTime() > time
second = numpy.array(piped.TransformDoublePoint(0.1, 0.2, 0.3))
assert abs(second - 2.0 * first).max() < 1e-3
assert abs(numpy.array(undo.TransformDoublePoint(*second)) - [0.1, 0.2, 0.3]).max() < 1e-9

# Copies are independent of what they were made from.
twin = forward.MakeTransform()
twin.DeepCopy(forward)
assert twin.TransformDoublePoint(0.1, 0.2, 0.3) == forward.TransformDoublePoint(0.1, 0.2, 0.3)
forward.Inverse()
assert twin.GetInverseFlag() == 0 and forward.GetInverseFlag() == 1
forward.Inverse()

# Many threads at once.
results = {}


def work(name):
    results[name] = [forward.TransformDoublePoint(*place) for place in inside[::7]]


threads = [threading.Thread(target=work, args=(name,)) for name in range(4)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert all((numpy.array(result) == one_by_one[::7]).all() for result in results.values())

# Without charges every point keeps its place, and the error says what to do.
for data, words in ((None, 'connect one'), (vtkPolyData(), "'Affine'"), (ball, None)):
    wrong = shapemap.vtkShapeHarmonicTransform()
    messages = []
    if words is None:
        try:
            wrong.SetChargeSetData(data)
        except TypeError:
            continue
        raise AssertionError('a grid is no charge set')
    wrong.SetChargeSetData(data)

    from vtkmodules.util.misc import calldata_type
    from vtkmodules.util.vtkConstants import VTK_STRING

    @calldata_type(VTK_STRING)
    def record(caller, event, message):
        messages.append(message)

    wrong.AddObserver('ErrorEvent', record)
    assert wrong.TransformDoublePoint(1.0, 2.0, 3.0) == (1.0, 2.0, 3.0)
    assert messages and all(part in messages[0] for part in (words, 'Shape Harmonic Transform')), (
        messages)
print('images, grids, normals and points are carried, and brought back')
