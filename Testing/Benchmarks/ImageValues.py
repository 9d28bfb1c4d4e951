"""Shape Image Values on a femur with a CT-like phantom whose density is known at every position.

    Utilities/pvpython.sh Testing/Benchmarks/ImageValues.py [--voxel 0.005] [--cell 0.035] [--noise 0]

The bone is 1 long. The density is a smooth function of the position, from 0.4 to 1.4. The image is turned,
its layers are twice as far apart as its voxels, and its values are integers. The value of a voxel is the
mean over its box of the density inside the bone, by 64 samples: at the surface, a voxel has a part of the
outside, of density 0. The exact modulus and density of a cell are the integrals of the laws over it by 64
Gauss points, from the function and not from the image. Peers: the law of the density at the centre of the
cell, as simple tools do, and Shape Image Values without extrapolation at the boundary. CalculiX then
computes the displacement of the head with the materials of each method, and with the exact modulus of
each cell. The bounds were set before the first run: 2 % for 95 % of the cells, 0.5 % of the mass."""
import argparse
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid
import shapemap

import sweep  # noqa: F401, finds what the tests share
import femur
import shapetesting

LAW = 6850.0, 1.49
TURN = numpy.array([[0.96, -0.28, 0.0], [0.28, 0.96, 0.0], [0.0, 0.0, 1.0]])


def density(places):
    x, y, z = places.T
    return 0.9 + 0.5 * numpy.sin(14.0 * x + 5.0 * z) * numpy.cos(11.0 * y - 9.0 * z)


def modulus(values):
    return LAW[0] * values ** LAW[1]


def distances(surface, places):
    """Signed, negative inside."""
    cloud, held = vtkPolyData(), vtkPoints()
    held.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    cloud.SetPoints(held)
    found = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeBoundaryDistance, cloud, surface))
    return shapetesting.array(found[0], 'BoundaryDistance')


def phantom(surface, voxel, noise):
    """The image: Hounsfield-like integers, a thousandth of the density each."""
    image, steps = vtkImageData(), voxel * numpy.array([1.0, 1.0, 2.0])
    corners = shapetesting.points(surface) @ TURN
    low = corners.min(axis=0) - 3.0 * steps
    size = numpy.ceil((corners.max(axis=0) + 3.0 * steps - low) / steps).astype(int)
    image.SetDimensions(size)
    image.SetSpacing(steps)
    image.SetDirectionMatrix(*TURN.ravel())
    image.SetOrigin(TURN @ low)
    index = numpy.stack(numpy.meshgrid(*map(numpy.arange, size), indexing='ij'), axis=-1)
    index = index.transpose(2, 1, 0, 3).reshape(-1, 3)
    distance = distances(surface, (low + index * steps) @ TURN.T)
    reach = 0.5 * numpy.linalg.norm(steps)
    inside, near = distance < -reach, abs(distance) <= reach
    offsets = (numpy.arange(4) - 1.5) / 4.0
    values = numpy.zeros(len(index))
    for shift in numpy.stack(numpy.meshgrid(offsets, offsets, offsets), axis=-1).reshape(-1, 3):
        places = (low + (index + shift) * steps) @ TURN.T
        values[inside] += density(places[inside]) / 64.0
        values[near] += density(places[near]) * (distances(surface, places[near]) < 0.0) / 64.0
    values += noise * numpy.random.default_rng(1).standard_normal(len(values))
    array = numpy_to_vtk(numpy.round(1000.0 * values).astype(numpy.int16), deep=True)
    array.SetName('HU')
    image.GetPointData().SetScalars(array)
    return image


def corners_of(grid):
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    return shapetesting.points(grid)[corners]


def integrals(grid):
    """The volume of each cell, and the exact means of density and modulus in it."""
    nodes, weights = numpy.polynomial.legendre.leggauss(4)
    nodes, weights = 0.5 + 0.5 * nodes, 0.5 * weights
    upper = numpy.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
    corners, sums = corners_of(grid), numpy.zeros((3, grid.GetNumberOfCells()))
    for a, b, c in numpy.ndindex(4, 4, 4):
        at = numpy.array([nodes[a], nodes[b], nodes[c]])
        factors = numpy.where(upper == 1, at, 1.0 - at)
        slopes = numpy.where(upper == 1, 1.0, -1.0)
        jacobian = numpy.stack([numpy.einsum('k,nkd->nd', slopes[:, axis] * numpy.delete(factors, axis, 1).prod(axis=1),
                                             corners) for axis in range(3)], axis=1)
        local = density(numpy.einsum('k,nkd->nd', factors.prod(axis=1), corners))
        sums += weights[a] * weights[b] * weights[c] * numpy.linalg.det(jacobian) * (
            numpy.array([numpy.ones(len(local)), local, modulus(local)]))
    return sums[0], sums[1] / sums[0], sums[2] / sums[0]


def at_centres(grid, image):
    """The density of the image at the centre of each cell, interpolated."""
    size, steps = image.GetDimensions(), numpy.array(image.GetSpacing())
    values = shapetesting.array(image, 'HU').reshape(size[::-1]).transpose(2, 1, 0)
    place = ((corners_of(grid).mean(axis=1) - image.GetOrigin()) @ TURN) / steps
    base = numpy.floor(place).astype(int)
    found = numpy.zeros(len(place))
    for offset in numpy.ndindex(2, 2, 2):
        weight = numpy.where(numpy.array(offset) == 1, place - base, 1.0 - place + base).prod(axis=1)
        found += weight * values[tuple((base + offset).T)]
    return 0.001 * found


def with_materials(grid, moduli, densities, numbers=None):
    made = vtkUnstructuredGrid()
    made.ShallowCopy(grid)
    numbers = numpy.arange(len(moduli)) if numbers is None else numbers
    for name, values in (('MaterialId', numbers.astype(numpy.int32)), ('MaterialModulus', moduli),
                         ('MaterialDensity', densities)):
        array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        array.SetName(name)
        made.GetCellData().AddArray(array)
    return made


def displacement(grid):
    """Of the loaded head, along the load, as CalculiX finds it with the file's own materials."""
    model = femur.Bone(grid)
    forces = model.load(*femur.HEAD)
    solution = model.bear(forces, None)
    return (forces * solution.Displacements).sum() / numpy.linalg.norm(femur.HEAD[1])


def cell_values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--voxel', type=float, default=0.005)
    parser.add_argument('--cell', type=float, default=0.035)
    parser.add_argument('--noise', type=float, default=0.0, help='standard deviation of the density')
    options = parser.parse_args()
    claims = sweep.Claims()
    surface = femur.bone()
    grid = femur.mesh(surface, options.cell)
    image = phantom(surface, options.voxel, options.noise)
    print('%d hexahedra, %d x %d x %d voxels' % (grid.GetNumberOfCells(), *image.GetDimensions()))
    volumes, densities, moduli = integrals(grid)
    table = sweep.Table('method:<28', 'modulus 95 %:12.2f', 'maximum %:10.2f', 'mean %:8.2f', 'mass %:8.3f',
                        'displacement %:15.2f', 'CPU s:8.2f')
    exact = displacement(with_materials(grid, moduli, densities))

    def measure(method, found, mass, deck, seconds):
        errors = 100.0 * (found / moduli - 1.0)
        row = {'method': method, 'modulus 95 %': numpy.quantile(abs(errors), 0.95), 'maximum %': abs(errors).max(),
               'mean %': errors.mean(), 'mass %': 100.0 * ((mass * volumes).sum() / (densities * volumes).sum() - 1.0),
               'displacement %': 100.0 * (displacement(deck) / exact - 1.0), 'CPU s': seconds}
        table.print(row)
        return row

    for layers, method in ((1, 'Shape Image Values'), (0, 'without Boundary Layers')):
        start = os.times().user
        data = shapetesting.outputs(shapetesting.new(
            shapemap.vtkShapeImageValues, grid, image, Density='max(0.01, 0.001 * HU)', BoundaryLayers=layers))[0]
        row = measure(method, cell_values(data, 'Modulus'), cell_values(data, 'Density'), data, os.times().user - start)
        if layers == 1:
            claims.at_most('femur', 'modulus, 95 % of the cells (%)', row['modulus 95 %'], 2.0)
            claims.at_most('femur', 'mass (%)', abs(row['mass %']), 0.5)
            ours = row
    centres = numpy.maximum(0.01, at_centres(grid, image))
    peer = measure('density at the centre', modulus(centres), centres,
                   with_materials(grid, modulus(centres), centres), float('nan'))
    claims.at_most('femur', 'error / that of the centre', ours['modulus 95 %'] / peer['modulus 95 %'], 1.0)
    claims.finish()


if __name__ == '__main__':
    main()
