"""Shape Hex Remesh of regions that touch: Voronoi phantoms whose curves are known, a liver, a skull, and an
image of 256^3 labels.

    Utilities/pvpython.sh Testing/Benchmarks/RegionHexahedra.py [--images FOLDER] [--first 200] [--count 2] [--large]

Phantoms are those of LabelSurfaces.py. Distances of points where three or more regions meet are from the exact
curves, more than three voxels inside the ball; `curve` and `inner` are the facts CurveDistance and InnerDistance;
all in voxels. The images are those of LabelImages.py; --images names their folder, and islands of fewer than
8 voxels are dissolved. --large adds 256^3 labels of five regions, with cells of 3.8 voxels: hexahedra of
this size, which is given, and not of a smaller one. Its limits are those of two cores that do nothing else.

Of each result: no hexahedron is inverted, and each region has the Euler number and the number of components
of its surface. Half a voxel along each axis is how far Shape Label Surfaces may move a point where two regions
meet; where three meet, twice as much."""
import math
import os
import resource
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import sweep
from LabelImages import read_image, to_vtk
from LabelSurfaces import Phantom

SMALLEST_ISLAND = 8
MINIMUM = 0.3  # scaled Jacobian of the liver and the skull
LARGE_SIZE = 3.8  # the size of cells of 256^3 labels, in voxels
HEXAHEDRA = 150000, 250000  # that this size gives at least and at most
SECONDS, GIB = 120.0, 4.0  # of 256^3 labels


def run(image, threshold=None, size=0.0):
    """The labels' surfaces and their hexahedra, each with its facts, and wall and CPU seconds."""
    surfaces = shapemap.vtkShapeLabelSurfaces()
    surfaces.SetInputDataObject(image)
    surfaces.SetLabelArray('Label')
    surfaces.SetSmallestIsland(SMALLEST_ISLAND)
    if threshold is not None:
        surfaces.SetThresholds(0, threshold)
    start, cpu = time.time(), time.process_time()
    surfaces.Update()
    remesh = shapemap.vtkShapeHexRemesh()
    remesh.SetInputDataObject(0, surfaces.GetOutputDataObject(0))
    remesh.SetCellSize(size)
    remesh.Update()
    return surfaces, remesh, time.time() - start, time.process_time() - cpu


def fact(algorithm, name):
    column = algorithm.GetOutputDataObject(2).GetColumnByName(name)
    return vtk_to_numpy(column).ravel() if column else None


def curve_points(solid):
    """The points with three or more regions around them, the outside included."""
    cells = vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    regions = numpy.repeat(vtk_to_numpy(solid.GetCellData().GetArray('RegionId')), 8)
    pairs = numpy.unique(numpy.stack([cells.ravel(), regions], axis=1), axis=0)
    counts = numpy.bincount(pairs[:, 0], minlength=solid.GetNumberOfPoints())
    return vtk_to_numpy(solid.GetPoints().GetData())[counts > 2]


def measure(name, surfaces, remesh, wall, cpu, voxel, claims, table):
    hexahedra = fact(remesh, 'HexRemesh.Hexahedra')
    if hexahedra is None:
        claims.check(name, 'hexahedra', 'refused', False)
        return None
    row = {'image': name, 'hexes': hexahedra[0], 'wall': wall, 'cpu': cpu,
           'GiB': resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** 20}
    for key, column in (('min', 'MinimumScaledJacobian'), ('mean', 'MeanScaledJacobian'), ('curves', 'Curves'),
                        ('kept', 'CurvesKept'), ('released', 'ReleasedPoints')):
        row[key] = fact(remesh, 'HexRemesh.' + column)[0]
    for key, column in (('curve', 'CurveDistance'), ('inner', 'InnerDistance'), ('distance', 'Distance')):
        row[key] = fact(remesh, 'HexRemesh.' + column)[0] / voxel
    table.print(row)
    claims.check(name, 'no inverted hexahedron', row['min'], row['min'] > 0.0)
    for own, wanted in (('RegionEulerNumbers', 'EulerNumbers'), ('RegionComponents', 'Components')):
        found, right = fact(remesh, 'HexRemesh.' + own), fact(surfaces, 'LabelSurfaces.' + wanted)
        claims.check(name, own, str(found), numpy.array_equal(found, right))
    return row


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('--images')
    parser.add_argument('--first', type=int, default=200)
    parser.add_argument('--count', type=int, default=2)
    parser.add_argument('--large', action='store_true')
    options = parser.parse_args()
    claims = sweep.Claims()
    table = sweep.Table('image:<12', 'hexes:8.0f', 'min:6.3f', 'mean:6.3f', 'curves:6.0f', 'kept:5.0f', 'released:8.0f',
                        'curve:6.2f', 'inner:6.2f', 'distance:8.2f', 'wall:7.1f', 'cpu:7.1f', 'GiB:5.2f')
    half_voxel = math.sqrt(0.75)
    for number in range(options.first, options.first + options.count):
        phantom, name = Phantom(64, 5, number), 'phantom %d' % number
        surfaces, remesh, wall, cpu = run(phantom.image())
        if measure(name, surfaces, remesh, wall, cpu, 1.0, claims, table):
            errors = phantom.curve_errors(curve_points(remesh.GetOutputDataObject(0)))
            claims.at_most(name, 'points of curves (voxels)', errors.max(), half_voxel)
    if options.images:
        liver, spacing = read_image(os.path.join(options.images, 'liver.inr.gz'))
        skull, skull_spacing = read_image(os.path.join(options.images, 'skull_2.9.inr'))
        liver, spacing = numpy.ascontiguousarray(liver[::2, ::4, ::4]), spacing * (4, 4, 2)
        for name, values, step, threshold in (('liver', liver, spacing, None), ('skull', skull, skull_spacing, 2.9)):
            surfaces, remesh, wall, cpu = run(to_vtk(values, step), threshold)
            row = measure(name, surfaces, remesh, wall, cpu, step.mean(), claims, table)
            if row:
                claims.at_least(name, 'worst scaled Jacobian', row['min'], MINIMUM)
    if options.large:
        surfaces, remesh, wall, cpu = run(Phantom(256, 5, options.first).image(), size=LARGE_SIZE)
        row = measure('256^3 labels', surfaces, remesh, wall, cpu, 1.0, claims, table)
        if row:
            claims.at_least('256^3 labels', 'hexahedra', row['hexes'], HEXAHEDRA[0])
            claims.at_most('256^3 labels', 'hexahedra', row['hexes'], HEXAHEDRA[1])
            claims.at_most('256^3 labels', 'wall seconds', wall, SECONDS)
            claims.at_most('256^3 labels', 'GiB', row['GiB'], GIB)
    claims.finish()


if __name__ == '__main__':
    main()
