"""A femur bears a load on its head: the hexahedra that Shape Hex Remesh makes of a bone and Shape
Abaqus Writer gives to CalculiX are fit for computing with.

The scanned surface has pits and tiny handles. So the solid is the one where Shape Boundary Distance
is negative on a grid, cut across the shaft, where it is held. Two loads, on the head and on the
greater trochanter, are spread smoothly over the surface around a place, so that they are the same on
every mesh. What holds for every solution of linear elasticity: forces and moments are in
equilibrium, twice the load moves twice as far, the strain energy is half the work of the load, and
each load does the same work along the other's displacements (Betti's theorem). And the deflection
hardly changes with smaller cells."""
import numpy

import femur
from femur import HEAD
from shapetesting import fact

TROCHANTER = numpy.array([-0.19, 0.05, -0.31]), numpy.array([0.5, 0.0, -0.6])


def deflection(surface, cell_size):
    """Of the head along its own load, and the mesh with both loads' solutions."""
    grid = femur.mesh(surface, cell_size)
    model = femur.Bone(grid)
    forces = model.load(*HEAD)
    solution = model.bear(forces)
    deflected = (forces * solution.Displacements).sum() / numpy.linalg.norm(HEAD[1])
    print('cell size %g: %d hexahedra, scaled Jacobian at least %.3f, deflection %.6g' % (
        cell_size, grid.GetNumberOfCells(), fact(grid, 'HexRemesh.MinimumScaledJacobian'), deflected))
    return deflected, model, forces, solution


surface = femur.bone()
coarse, model, forces, solution = deflection(surface, 0.035)
twice = model.bear(2.0 * forces)
size = abs(solution.Displacements).max()
assert abs(twice.Displacements - 2.0 * solution.Displacements).max() < 1e-6 * size
others = model.load(*TROCHANTER)
other = model.bear(others)
works = [(forces * other.Displacements).sum(), (others * solution.Displacements).sum()]
print('work of each load along the other: %.9g, %.9g' % tuple(works))
assert abs(works[0] - works[1]) < 2e-6 * numpy.abs(others * solution.Displacements).sum(), works
fine = deflection(surface, 0.025)[0]
print('the deflection changes by %.2f %%' % (100.0 * (fine / coarse - 1.0)))
assert abs(fine / coarse - 1.0) < 0.07
