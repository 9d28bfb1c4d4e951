"""Shape Certificate: boxes in which a volume map is proven to be regular, and positions where it folds.

As an example: the map of a dented ball onto the unit ball is one to one."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, with_charge


def new(*inputs, **settings):
    return shapetesting.new(shapemap.vtkShapeCertificate, *inputs, **settings)


def certify(*inputs, **settings):
    """The boxes, the witnesses and the facts."""
    algorithm = new(*inputs, **settings)
    boxes, witnesses, table = shapetesting.outputs(algorithm)
    return boxes, witnesses, lambda name: fact(table, 'Certificate.' + name)


def of_cells(boxes, name):
    return vtk_to_numpy(boxes.GetCellData().GetArray(name))


# The example.
stored = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphereCharges.vtp')])
certificate = simple.ShapeCertificate(Map=stored)
certificate.UpdatePipeline()
table = shapetesting.output(certificate, 2)
assert fact(table, 'Certificate.Bijective') == 1 and fact(table, 'Certificate.Certified') == 1.0
assert (of_cells(shapetesting.output(certificate), 'Certified') == 1).all()

# The volumes inside are those of the solid. The lower bounds hold at samples.
charges, surface = read('DentedSphereCharges.vtp'), read('DentedSphere600.vtp')
a, b, c = (points(surface)[shapetesting.triangles(surface)[:, k]] for k in range(3))
volume = abs((numpy.cross(a, b) * c).sum() / 6.0)
boxes, witnesses, facts = certify(charges)
assert abs(of_cells(boxes, 'VolumeInside').sum() / volume - 1.0) < 1e-6  # the surface is in single precision
assert witnesses.GetNumberOfPoints() == 0 and facts('Witnesses') == 0
transform = shapemap.vtkShapeHarmonicTransform()
transform.SetChargeSetData(charges)
transform.Update()
jacobian = numpy.zeros((3, 3))
bound = of_cells(boxes, 'MinimumDeterminant').min()
assert bound > 0.0
for position in 0.99 * points(surface)[::20]:
    place = numpy.zeros(3)
    transform.InternalTransformDerivative(position, place, jacobian)
    assert numpy.linalg.det(jacobian) > bound

# A part of the domain has better bounds, and fewer boxes are needed.
inner = copy(surface)
shapetesting.set_points(inner, 0.5 * points(surface))
part, _, inner_facts = certify(charges, inner)
assert abs(of_cells(part, 'VolumeInside').sum() / (volume / 8.0) - 1.0) < 1e-6
assert of_cells(part, 'MinimumDeterminant').min() >= bound
assert inner_facts('ExaminedBoxes') < facts('ExaminedBoxes')

# One charge near the surface folds the map next to it, and only there.
far = points(surface)[points(surface)[:, 2].argmax()]
outwards = far / numpy.linalg.norm(far)
charge = far + 0.02 * outwards
folded = with_charge(charges, charge, -4.0 * numpy.pi * 0.04 ** 2 * outwards)
boxes, witnesses, facts = certify(folded)
assert facts('Bijective') == 0 and facts('Inverted') > 0.0
assert 0.999 < facts('Certified') < 1.0
assert abs(facts('Certified') + facts('Undecided') + facts('Inverted') - 1.0) < 1e-12
states = of_cells(boxes, 'Certified')
assert set(states) <= {-1, 0, 1} and len(states) == facts('Boxes')
assert witnesses.GetNumberOfPoints() == facts('Witnesses') > 0
assert (array(witnesses, 'Determinant') <= 0.0).all()
assert numpy.linalg.norm(points(witnesses) - charge, axis=1).max() < 0.1
applied = shapetesting.new(shapemap.vtkShapeApplyVolumeMap, witnesses, folded)
assert abs(points(shapetesting.outputs(applied)[0]) - array(witnesses, 'TargetPosition')).max() < 1e-12
# Smaller boxes leave less undecided.
coarse = certify(folded, Tolerance=0.02)[2]
assert coarse('Certified') < facts('Certified')
# The limit is said.
algorithm = new(folded, MaximumBoxes=50)
table = shapetesting.outputs(algorithm)[2]
assert fact(table, 'Certificate.ExaminedBoxes') <= 50
assert 'Maximum Boxes' in table.GetRowData().GetAbstractArray('Certificate.Warning').GetValue(0)

# Errors name the remedy.
shapetesting.check_refused(new(surface), 'Affine', 'charge set')
shapetesting.check_refused(new(charges, read('TwistedBarSmall.vtp')), 'outside the surface of the Map')
shapetesting.check_refused(new(charges, Tolerance=0.0), 'Tolerance', '1e-5')

# Charge Distance is a multiple of the spacing. A ball has room for all charges.
parameterize = shapetesting.new(shapemap.vtkShapeParameterize, surface)
parameterize.SetDomain(1)
boundary = shapetesting.outputs(parameterize)[1]
ends = {}
for distance in (0.9, 1.5):
    algorithm = shapetesting.new(shapemap.vtkShapeHarmonicVolumeMap, boundary, boundary)
    algorithm.SetMapArray('SourcePosition')
    algorithm.SetMaximumLevels(1)
    algorithm.SetChargeDistance(distance)
    algorithm.SetCertify(True)
    moved, charges, _ = shapetesting.outputs(algorithm)[:3]
    ends[distance] = fact(charges, 'HarmonicVolumeMap.OffsetDistance')
    # Certify tells the same as the certificate of the charges.
    shares = [fact(moved, 'HarmonicVolumeMap.%sShare' % state) for state in (
        'Certified', 'Undecided', 'Inverted')]
    assert abs(sum(shares) - 1.0) < 1e-12
    assert abs(shares[0] - certify(charges)[2]('Certified')) < 1e-9
assert abs(ends[1.5] / ends[0.9] - 1.5 / 0.9) < 1e-9, ends
algorithm = shapetesting.new(shapemap.vtkShapeHarmonicVolumeMap, boundary, boundary)
algorithm.SetMapArray('SourcePosition')
algorithm.SetChargeDistance(5.0)
shapetesting.check_refused(algorithm, 'ChargeDistance', '0.3')
algorithm.SetChargeDistance(0.9)
algorithm.SetCertify(True)
algorithm.SetExact(True)
shapetesting.check_refused(algorithm, 'Certify', 'Exact')
