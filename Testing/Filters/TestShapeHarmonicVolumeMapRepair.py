"""Repair of Shape Harmonic Volume Map: the map of a ball onto a horse folds; the repaired one does not.

As an example: the ball is moved by the repaired map, and back again."""
import numpy
from paraview import simple
import shapemap

import shapetesting
from shapetesting import array, fact, points, read

# The example.
horse = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('HorseSmall.vtp')])
sphere = simple.ShapeParameterize(Input=horse, Domain='Sphere')
boundary = simple.OutputPort(sphere, 1)
sphere.UpdatePipeline()
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
mapped = simple.ShapeHarmonicVolumeMap(
    Domain=ball, Boundary=boundary, MapArray='SourcePosition', Repair=True, Tetrahedra=20000)
mapped.UpdatePipeline()
moved, charges = shapetesting.output(mapped), shapetesting.output(mapped, 1)
shares = {name: fact(moved, 'HarmonicVolumeMap.' + name) for name in (
    'CertifiedBefore', 'CertifiedShare', 'InvertedShare', 'UndecidedShare', 'CoreShare', 'RingShare')}
print(shares)
assert shares['CertifiedBefore'] < 1.0
assert shares['CertifiedShare'] > 0.999 and shares['CertifiedShare'] >= shares['CertifiedBefore']
assert abs(shares['CertifiedShare'] + shares['InvertedShare'] + shares['UndecidedShare'] - 1.0) < 1e-12
assert 0.0 < shares['CoreShare'] <= 1.0 and 0.0 <= shares['RingShare'] < 1.0


def of_field(name):
    found = charges.GetFieldData().GetArray(name)
    return numpy.array([found.GetTuple(i) for i in range(found.GetNumberOfTuples())])


# The charge set carries the repair; Shape Apply Volume Map uses it, bit by bit, and inverts it.
solid = read('BallSmall.vtu')
apply = shapetesting.new(shapemap.vtkShapeApplyVolumeMap, solid, charges)
assert (points(shapetesting.outputs(apply)[0]) == points(moved)).all()
back = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeApplyVolumeMap, moved, charges, Inverse=True))[0]
known = (array(moved, 'OutsideDomain') == 0) & (array(back, 'OutsideDomain') == 0)
print('inverted', known.sum(), 'of', len(known), 'points')
assert known.sum() > 0.95 * (array(moved, 'OutsideDomain') == 0).sum()
again = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeApplyVolumeMap, back, charges))[0]
assert abs(points(again) - points(moved))[known].max() < 1e-9
# Points on the sphere may be off the triangles of the boundary; their images are those of the closest positions.
within = known & (numpy.linalg.norm(points(solid), axis=1) < 0.99)
assert within.sum() > 0.5 * len(within)
assert abs(points(back) - points(solid))[within].max() < 1e-6

# At the corners of the core, the map has the images of the tetrahedra, and elsewhere those of the charges.
corners = of_field('RepairPoints')
core = of_field('RepairShare')[:, 0] == 0.0
transform = shapemap.vtkShapeHarmonicTransform()
transform.SetChargeSetData(charges)
images = numpy.array([transform.TransformPoint(list(corner)) for corner in corners[core][::50]])
assert abs(images - of_field('RepairTargetPosition')[core][::50]).max() < 1e-9
plain = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeHarmonicVolumeMap, solid, shapetesting.output(sphere, 1), MapArray='SourcePosition'))
assert not plain[1].GetFieldData().HasArray('RepairTetrahedra')

# Where the derivative is sampled in the repair, its determinant is positive.
random = numpy.random.RandomState(2)
cells = of_field('RepairTetrahedra').astype(int)
chosen = cells[random.randint(len(cells), size=300)]
inside = numpy.einsum('ij,ijk->ik', random.dirichlet(numpy.ones(4), len(chosen)), corners[chosen])
image, derivative, signs = [0.0] * 3, numpy.zeros((3, 3)), []
for position in inside:
    transform.InternalTransformDerivative(list(position), image, derivative)
    signs.append(numpy.linalg.det(derivative))
assert shares['CertifiedShare'] < 1.0 or min(signs) > 0.0, min(signs)

# Errors name the remedy.
shapetesting.check_refused(shapetesting.new(shapemap.vtkShapeCertificate, charges), 'repaired', 'Repair')
for setting in (dict(Exact=True), dict(Method=3)):
    shapetesting.check_refused(shapetesting.new(
        shapemap.vtkShapeHarmonicVolumeMap, solid, shapetesting.output(sphere, 1), MapArray='SourcePosition',
        Repair=True, **setting), 'Repair', 'turn Exact off', 'FiniteElements')
broken = shapetesting.copy(charges)
broken.GetFieldData().RemoveArray('RepairShare')
shapetesting.check_refused(
    shapetesting.new(shapemap.vtkShapeApplyVolumeMap, solid, broken), 'RepairShare', 'Charges')
