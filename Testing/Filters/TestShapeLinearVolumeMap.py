"""vtkShapeLinearVolumeMap: gradients of functions of a volume map, as an optimiser needs them.

As an example: of the distance between the images of points inside a shape and where they should be, the
gradient by the images of the boundary's points, beside finite differences."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
import shapemap

import shapetesting
from shapetesting import array, points, read


def vtk_points(places):
    result = vtkPoints()
    result.SetDataTypeToDouble()
    result.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    return result


def tuples(values):
    return numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)


def images_of(charges, places):
    """The images of places, and the Jacobians there."""
    transform = shapemap.vtkShapeHarmonicTransform()
    transform.SetChargeSetData(charges)
    moved, jacobians = [], []
    for place in places:
        jacobian = [[0.0] * 3 for _ in range(3)]
        image = [0.0] * 3
        transform.Update()
        transform.InternalTransformDerivative(place, image, jacobian)
        moved.append(image)
        jacobians.append(numpy.array(jacobian).ravel())
    return numpy.array(moved), numpy.array(jacobians)


random = numpy.random.default_rng(3)
surface = read('DentedSphere600.vtp')
solver = shapemap.vtkShapeLinearVolumeMap()
solver.SetBoundary(surface)
solver.SetTolerance(1e-11)
targets = array(surface, 'TargetPosition').astype(float)
inside = 0.5 * points(surface)[::40]
goal = 0.4 * points(surface)[::40] + 0.05


def fitted(images):
    charges = vtkPolyData()
    assert solver.Fit(tuples(images), charges)
    return charges


def value(charges):
    """The squared distance from the goal, and how much volumes change."""
    moved, jacobians = images_of(charges, inside)
    determinants = numpy.linalg.det(jacobians.reshape(-1, 3, 3))
    return ((moved - goal) ** 2).sum() + 0.1 * (determinants ** 2).sum()


def slopes(charges):
    """The derivatives of value by images and Jacobians."""
    moved, jacobians = images_of(charges, inside)
    matrices = jacobians.reshape(-1, 3, 3)
    determinants = numpy.linalg.det(matrices)
    cofactors = determinants[:, None, None] * numpy.linalg.inv(matrices).transpose(0, 2, 1)
    return 2.0 * (moved - goal), (0.2 * determinants[:, None, None] * cofactors).reshape(-1, 9)


def difference(function):
    """The slope of a function at 0, to fourth order."""
    h = 0.01
    return (8.0 * (function(h) - function(-h)) - (function(2 * h) - function(-2 * h))) / (12.0 * h)


charges = fitted(targets)
by_images, by_jacobians = slopes(charges)
gradient = vtkDoubleArray()
assert solver.ComputeGradient(vtk_points(inside), tuples(by_images), tuples(by_jacobians), gradient)
gradient = vtk_to_numpy(gradient)
assert gradient.shape == targets.shape
for _ in range(2):
    direction = random.normal(size=targets.shape)
    slope = difference(lambda step: value(fitted(targets + step * direction)))
    assert abs((gradient * direction).sum() - slope) < 1e-6 * numpy.linalg.norm(gradient), slope

# The steepest descent lowers the value.
step = 0.1 / numpy.abs(gradient).max()
assert value(fitted(targets - step * gradient)) < value(charges)

# By the charges themselves, and by the affine part.
by_charges, by_affine = vtkDoubleArray(), vtkDoubleArray()
assert solver.ComputeChargeGradient(charges, vtk_points(inside), tuples(by_images), tuples(by_jacobians), by_charges,
                                    by_affine)
direction = random.normal(size=(charges.GetNumberOfPoints(), 3)) * (
    numpy.abs(array(charges, 'Charge')).max(axis=1) > 0.0)[:, None]
turned = random.normal(size=(3, 4))


def stepped(step):
    result = shapetesting.copy(charges)
    shapetesting.add_array(result, array(charges, 'Charge') + step * direction, 'Charge')
    affine = tuples(vtk_to_numpy(charges.GetFieldData().GetArray('Affine')) + step * turned)
    affine.SetName('Affine')
    result.GetFieldData().AddArray(affine)
    return value(result)


product = (vtk_to_numpy(by_charges) * direction).sum() + (vtk_to_numpy(by_affine) * turned).sum()
assert abs(product / difference(stepped) - 1.0) < 1e-6, product

# What is wrong is said, and nothing is computed.
for wrong, words in (((None, tuples(by_images)), 'points'), ((vtk_points(inside), tuples(by_jacobians)), '3 components'),
                     ((vtk_points(inside[1:]), tuples(by_images)), 'rows')):
    messages = shapetesting.errors_of(solver, lambda: solver.ComputeGradient(*wrong, None, vtkDoubleArray()))
    assert messages and words in messages[0], messages
empty = shapemap.vtkShapeLinearVolumeMap()
messages = shapetesting.errors_of(empty, lambda: empty.Fit(tuples(targets), vtkPolyData()))
assert 'SetBoundary' in messages[0], messages
print('gradients agree with finite differences')
