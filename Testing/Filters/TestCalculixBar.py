"""A bar of hexahedra bends as Timoshenko's theory says: the meshes that Shape Hex Remesh makes
and Shape Abaqus Writer gives to CalculiX are fit for computing with.

A cantilever of square section, ten times as long as high, with a shear force at its end: the tip's
deflection converges from below as the cells become smaller."""
import numpy
from paraview import simple

import calculix
import shapetesting

LENGTH, HEIGHT = 10.0, 1.0
YOUNG, POISSON, FORCE = 1000.0, 0.3, 0.1


def mesh(cell_size):
    """The bar from the origin along x, by Shape Hex Remesh of its surface."""
    box = simple.Box(XLength=LENGTH, YLength=HEIGHT, ZLength=HEIGHT,
                     Center=[0.5 * LENGTH, 0.5 * HEIGHT, 0.5 * HEIGHT])
    remesh = simple.ShapeHexRemesh(Surface=simple.Clean(Input=box), CellSize=cell_size)
    remesh.UpdatePipeline()
    return shapetesting.output(remesh)


def tip_deflection(grid, tolerance=1e-6):
    """The mean over the end's area; the force is spread evenly over it."""
    model = calculix.Model(grid)
    shares = model.shares(model.patch_at(0, LENGTH, tolerance))
    nodes, areas = numpy.array(list(shares)), numpy.array(list(shares.values()))
    forces = FORCE * areas / areas.sum()
    moved = model.solve(
        YOUNG, POISSON, ['Patch%s, 1, 3' % model.patch_at(0, 0.0, tolerance)],
        ['*CLOAD'] + ['%d, 3, %.15g' % (node + 1, force) for node, force in zip(nodes, forces)])
    return areas @ moved[nodes, 2] / areas.sum()


# P L^3 / (3 E I) + P L / (kappa G A), with I = h^4 / 12 and the shear coefficient of a rectangle,
# kappa = 10 (1 + nu) / (12 + 11 nu): Cowper, "The shear coefficient in Timoshenko's beam theory",
# Journal of Applied Mechanics 33 (1966), table 1.
kappa = 10.0 * (1.0 + POISSON) / (12.0 + 11.0 * POISSON)
shear = YOUNG / (2.0 * (1.0 + POISSON))
truth = FORCE * (LENGTH ** 3 / (3.0 * YOUNG * HEIGHT ** 4 / 12.0) + LENGTH / (kappa * shear * HEIGHT ** 2))

ratios = [tip_deflection(mesh(HEIGHT / n)) / truth for n in (2, 4, 8)]
print("deflection over Timoshenko's, by cells across:", *['%.4f' % ratio for ratio in ratios])
errors = abs(numpy.array(ratios) - 1.0)
assert (numpy.diff(ratios) > 0.0).all() and (numpy.diff(errors) < 0.0).all(), ratios
assert errors[-1] < 0.02, ratios
