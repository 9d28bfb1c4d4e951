"""Shape Harmonic Volume Map with the method FiniteElements: linear in tetrahedra, exact on the boundary.

As an example: the map of the dented ball onto the ball by charges, and by finite elements."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read

ELEMENTS = 3

# The example.
dented = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
dented.UpdatePipeline()  # so that its arrays are known
by_charges = simple.ShapeHarmonicVolumeMap(Domain=ball, Boundary=dented)
by_elements = simple.ShapeHarmonicVolumeMap(
    Domain=ball, Boundary=dented, Method='FiniteElements', Tetrahedra=50000)
results = []
for proxy in (by_charges, by_elements):
    proxy.UpdatePipeline()
    results.append(shapetesting.output(proxy))
charges, elements = results
assert (array(charges, 'SourcePosition') == array(elements, 'SourcePosition')).all()
both = (array(charges, 'OutsideDomain') == 0) & (array(elements, 'OutsideDomain') == 0)
assert both.sum() > 700
difference = numpy.linalg.norm(points(charges) - points(elements), axis=1)[both] / 2.0
# By the maximum principle, two harmonic maps differ inside by no more than on the boundary, where only the charges
# miss; the rest is the error of the elements.
missed = fact(charges, 'HarmonicVolumeMap.Maximum')
print('charges and finite elements differ by at most', difference.max(), 'and the charges miss by', missed)
assert difference.max() < 1.2 * missed, (difference.max(), missed)
assert fact(elements, 'HarmonicVolumeMap.Method') == 'FiniteElements'
assert fact(elements, 'HarmonicVolumeMap.Maximum') < 1e-8 < fact(charges, 'HarmonicVolumeMap.Maximum')
assert 25000 < fact(elements, 'HarmonicVolumeMap.Tetrahedra') < 100000
assert fact(charges, 'HarmonicVolumeMap.Tetrahedra') == 0
levels = shapetesting.output(by_elements, 2)
assert levels.GetNumberOfRows() == 1 and levels.GetValueByName(0, 'Sources').ToInt() > 2000

# The boundary goes exactly where it is sent.
surface = read('DentedSphere600.vtp')
on_it = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeHarmonicVolumeMap, surface, surface, Method=ELEMENTS, Tetrahedra=5000))[0]
assert abs(points(on_it) - array(surface, 'TargetPosition')).max() < 1e-10
assert not array(on_it, 'OutsideDomain').any()

# The stored map moves the same points to the same places, bit by bit, and back again.
stored = shapetesting.output(by_elements, 1)
assert stored.GetFieldData().GetArray('Tetrahedra').GetNumberOfTuples() == fact(
    elements, 'HarmonicVolumeMap.Tetrahedra')


def applied(data, charge_set, inverse=False):
    return shapetesting.outputs(
        shapetesting.new(shapemap.vtkShapeApplyVolumeMap, data, charge_set, Inverse=inverse))[0]


solid = read('BallSmall.vtu')
there = applied(solid, stored)
assert (points(there) == points(elements)).all()
assert (array(there, 'OutsideDomain') == array(elements, 'OutsideDomain')).all()
back = applied(there, stored, inverse=True)
moved = (array(there, 'OutsideDomain') == 0) & (array(back, 'OutsideDomain') == 0)
assert moved.sum() >= (array(there, 'OutsideDomain') == 0).sum() > 700
assert abs(points(back) - points(solid))[moved].max() < 1e-9
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, solid)
blocks.SetBlock(2, surface)
tree = applied(blocks, stored)
assert (points(tree.GetBlock(0)) == points(there)).all() and tree.GetBlock(1) is None
assert abs(points(tree.GetBlock(2)) - array(surface, 'TargetPosition')).max() < 1e-10

# FoldFree works on the moved solid, which here has cells outside the dents: on a solid inside.
inside = copy(solid)
shapetesting.set_points(inside, 0.5 * points(solid))
free = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeHarmonicVolumeMap, inside, surface, Method=ELEMENTS, Tetrahedra=5000, FoldFree=True))[0]
assert fact(free, 'HarmonicVolumeMap.InvertedAfter') == 0


# What it cannot do is refused; a reader of charges alone says what else to do.
def check_refused(words, features=None, **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeHarmonicVolumeMap, inside, surface, Method=ELEMENTS, **settings)
    if features:
        algorithm.AddInputDataObject(2, features)
    shapetesting.check_refused(algorithm, 'FiniteElements', words, 'Accelerated')


check_refused('Exact', Exact=True)
line = shapetesting.with_cells(surface, [0])
shapetesting.set_points(line, 0.2 * points(line))
check_refused('Features', features=line)
transform = shapemap.vtkShapeHarmonicTransform()
said = []
transform.AddObserver('ErrorEvent', lambda *given: said.append(True))
transform.SetChargeSetData(stored)
assert transform.TransformPoint(0.1, 0.2, 0.3) == (0.1, 0.2, 0.3) and said, 'there are no charges'
spoiled = copy(stored)
spoiled.GetPointData().RemoveArray('TargetPosition')
shapetesting.check_refused(
    shapetesting.new(shapemap.vtkShapeApplyVolumeMap, solid, spoiled), "no point array 'TargetPosition'")
print('finite elements map the dented ball')
