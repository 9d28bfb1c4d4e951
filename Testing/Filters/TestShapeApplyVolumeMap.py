"""Shape Apply Volume Map: any dataset moved by a map that is kept as a charge set, and back.

As an example: the charges of Shape Harmonic Volume Map move another solid than the one it moved."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read


def new(data, charges, inverse=False):
    return shapetesting.new(shapemap.vtkShapeApplyVolumeMap, data, charges, Inverse=inverse)


def applied(data, charges, inverse=False):
    return shapetesting.outputs(new(data, charges, inverse))[0]


def error_of(data, charges):
    return shapetesting.refusal(new(data, charges))


def scaled(data, factor):
    result = copy(data)
    shapetesting.set_points(result, factor * points(data))
    return result


# The example: from the dented ball to the ball, and back again.
dented = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
dented.UpdatePipeline()  # so that its arrays are known
maker = simple.ShapeHarmonicVolumeMap(Domain=ball, Boundary=dented, MapArray='TargetPosition')
charges = simple.OutputPort(maker, 1)
there = simple.ShapeApplyVolumeMap(Input=ball, Map=charges)
back = simple.ShapeApplyVolumeMap(Input=there, Map=charges, Inverse=1)
back.UpdatePipeline()

# Bit for bit what Shape Harmonic Volume Map itself gives, inside and outside.
truth, moved = shapetesting.output(maker), shapetesting.output(there)
assert (points(moved) == points(truth)).all()
outside = array(moved, 'OutsideDomain')
assert (outside == array(truth, 'OutsideDomain')).all()
assert 0 < outside.sum() < len(outside) / 2 and outside.max() == 1, 'the dents cut into the ball'
assert outside.sum() == fact(moved, 'ApplyVolumeMap.OutsidePoints')
assert (points(moved) == array(moved, 'SourcePosition'))[outside == 1].all()
assert moved.GetNumberOfCells() == 864 and moved.GetCellType(0) == 12, 'hexahedra stay hexahedra'

# Back: every point that was moved comes from where it was. Just outside the surface a map need not be
# one-to-one, but the place that is found has the same image.
returned = shapetesting.output(back)
assert (array(returned, 'OutsideDomain')[outside == 0] == 0).all()
forth = simple.ShapeApplyVolumeMap(Input=back, Map=charges)
forth.UpdatePipeline()
assert abs(points(shapetesting.output(forth)) - points(moved))[outside == 0].max() < 1e-10
distance = vtkImplicitPolyDataDistance()
distance.SetInput(read('DentedSphere600.vtp'))
origins = array(truth, 'SourcePosition')
inside = numpy.array([distance.EvaluateFunction(place) < 0.0 for place in origins])
assert inside.sum() > 700 and abs(points(returned) - origins)[inside].max() < 1e-9
assert fact(returned, 'ApplyVolumeMap.NotInverted') == 0
assert (array(returned, 'SourcePosition') == points(moved)).all()

# A charge set from a file: moved as its formula says, evaluated here by numpy.
charge_set = read('DentedSphereCharges.vtp')
small = scaled(read('BallSmall.vtu'), 0.5)
charge, affine = array(charge_set, 'Charge'), shapetesting.vtk_to_numpy(
    charge_set.GetFieldData().GetArray('Affine'))


def by_hand(places):
    used = abs(charge).max(axis=1) > 0.0
    distances = numpy.linalg.norm(places[:, None, :] - points(charge_set)[None, used, :], axis=2)
    return places @ affine[:, :3].T + affine[:, 3] + (
        1.0 / (4.0 * numpy.pi * distances)) @ charge[used]


forward = applied(small, charge_set)
assert fact(forward, 'ApplyVolumeMap.OutsidePoints') == 0
assert abs(points(forward) - by_hand(points(small))).max() < 1e-14
again = applied(forward, charge_set, inverse=True)
assert abs(points(again) - points(small)).max() < 1e-10
assert fact(again, 'ApplyVolumeMap.OutsidePoints') == fact(again, 'ApplyVolumeMap.NotInverted') == 0

# On an OpenCL device, here pocl's, the same up to rounding. The default leaves small sums to the processor.
by_kind = [points(shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeApplyVolumeMap, small, charge_set, Device=kind))[0]) for kind in (0, 1, 2)]
assert (by_kind[0] == points(forward)).all() and (by_kind[1] == points(forward)).all()
assert 0.0 < abs(by_kind[2] - points(forward)).max() < 1e-13

# Its own surface belongs to the domain, and the surface's image to the image.
surface = read('DentedSphere600.vtp')
image = applied(surface, charge_set)
assert fact(image, 'ApplyVolumeMap.OutsidePoints') == 0
assert abs(points(applied(image, charge_set, inverse=True)) - points(surface)).max() < 1e-9

# Image data become a structured grid. With Inverse, every point that moves is the preimage of its
# place, and those beyond the image stay.
grid = vtkImageData()
grid.SetDimensions(12, 12, 12)
grid.SetOrigin(-1.2, -1.7, -1.4)
grid.SetSpacing(0.27, 0.27, 0.27)
add_array(grid, numpy.arange(1728.0), 'PassedPoint')
lattice = applied(grid, charge_set, inverse=True)
assert lattice.GetClassName() == 'vtkStructuredGrid' and lattice.GetExtent() == (0, 11) * 3
state, places = array(lattice, 'OutsideDomain'), array(lattice, 'SourcePosition')
assert (array(lattice, 'PassedPoint') == numpy.arange(1728.0)).all()
assert (state == 0).sum() > 100 and (state == 1).sum() > 500 and (state == 2).sum() == 0
assert abs(by_hand(points(lattice)[state == 0]) - places[state == 0]).max() < 1e-10
assert (points(lattice)[state == 1] == places[state == 1]).all()
assert fact(lattice, 'ApplyVolumeMap.OutsidePoints') == (state == 1).sum()

# Composite inputs keep their blocks; each is moved by the one map.
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, small)
blocks.SetBlock(2, grid)
tree = applied(blocks, charge_set)
assert tree.GetNumberOfBlocks() == 3 and tree.GetBlock(1) is None
assert (points(tree.GetBlock(0)) == points(forward)).all()
assert tree.GetBlock(2).GetClassName() == 'vtkStructuredGrid'

# A flat image has no preimages but in its plane: nothing moves, and nothing is not finite.
flat = copy(charge_set)
flat.GetPointData().RemoveArray('Charge')
add_array(flat, numpy.zeros((flat.GetNumberOfPoints(), 3)), 'Charge')
flat.GetFieldData().RemoveArray('Affine')
plane = shapetesting.numpy_to_vtk(numpy.diag([1.0, 1.0, 0.0, 0.0])[:3].copy(), deep=True)
plane.SetName('Affine')
flat.GetFieldData().AddArray(plane)
kept = applied(small, flat, inverse=True)
above = abs(points(small)[:, 2]) > 1e-9
assert (array(kept, 'OutsideDomain') > 0)[above].all()
assert (points(kept) == points(small))[above].all() and numpy.isfinite(points(kept)).all()

# Ghosts are another process's to count.
ghosts = copy(grid)
flags = numpy.zeros(1728, dtype=numpy.uint8)
flags[:500] = 1  # duplicates
add_array(ghosts, flags, 'vtkGhostType')
counted = applied(ghosts, charge_set)
assert fact(counted, 'ApplyVolumeMap.OutsidePoints') == array(counted, 'OutsideDomain')[500:].sum()

# Wrong maps: the error names the filter, the fact and the remedy.
message = error_of(small, surface)
assert "Shape Apply Volume Map: the Map has no field data array 'Affine'" in message, message
bare = copy(charge_set)
bare.GetPointData().RemoveArray('Charge')
assert "the Map has no point array 'Charge'" in error_of(small, bare)
boundless = copy(charge_set)
boundless.GetPolys().Initialize()
assert 'the Map has no triangles' in error_of(small, boundless)
touching = copy(charge_set)
array(touching, 'Charge')[20] = 1.0  # the 12 charges come first
assert 'has a charge on the surface that bounds its domain (at point 20)' in error_of(
    small, touching)
torn = copy(charge_set)
torn.BuildLinks()
torn.DeleteCell(3)
torn.RemoveDeletedCells()
assert '1 open loop' in error_of(small, torn)
two = vtkMultiBlockDataSet()
two.SetBlock(0, charge_set)
two.SetBlock(1, charge_set)
assert 'the Map has 2 blocks' in error_of(small, two)
dipoles = copy(charge_set)
add_array(dipoles, numpy.zeros((dipoles.GetNumberOfPoints(), 9)), 'Dipole')
assert 'the Map has dipoles' in error_of(small, dipoles)
print('charge sets move data there and back')
