"""Shape Cage Deform with its three coordinates beside Shape Harmonic Volume Map, on motions that are known.

    Utilities/pvpython.sh Testing/Benchmarks/CageDeform.py [--points 14] [--tetrahedra 200000]

The cage is the dented sphere with 642 or 2,892 points; the shape is a lattice inside it, at least 0.05 from the
cage. Motions of the cage: shear; harmonic (x^2 - y^2 and products, whose motion inside is known); bent (not
harmonic, the known motion is only one of many). The error is the largest distance from the known motion, divided by
the size of the cage. Rough is the largest second difference of the motion over 0.02, divided by that of the known
motion: 1 is as smooth. What a user moves is the points of the cage. CPU is the filter's, with all threads.

A second table bends a ball in a box of 26 points, as a user does: how far the maps differ from the mean value
coordinates, the smallest determinant of the gradient, and the mean conformal distortion of the cells."""
import argparse
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
import shapemap

import sweep  # finds what the tests share
import shapetesting
from shapetesting import array, new, outputs, points

STEP = 0.02
COORDINATES = ('MeanValue', 'Harmonic', 'Green')
MOTIONS = {
    'shear': lambda x, y, z: (x + 0.4 * y, y - 0.2 * z, z + 0.1 * x),
    'harmonic': lambda x, y, z: (x + 0.2 * (y * y - z * z), y + 0.2 * x * z, z + 0.1 * (x ** 3 - 3.0 * x * y * y)),
    'bent': lambda x, y, z: (x + 0.25 * z * z, y, z - 0.25 * x * z),
}


def motion(name, places):
    return numpy.stack(MOTIONS[name](*places.T), axis=1)


def cloud(places):
    data, own = vtkPolyData(), vtkPoints()
    own.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    data.SetPoints(own)
    return data


def with_points(data, places):
    moved = shapetesting.copy(data)
    shapetesting.set_points(moved, places)
    return moved


def lattice(cage, count):
    """Positions inside the cage, not near it."""
    steps = numpy.linspace(-1.0, 1.0, count)
    places = numpy.stack(numpy.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3)
    distance = outputs(new(shapemap.vtkShapeBoundaryDistance, cloud(places), cage))[0]
    return places[array(distance, 'BoundaryDistance') < -0.05]


def stencil(places):
    """Each position, and those one step before and behind it along each axis."""
    around = [step * numpy.eye(3)[axis] for axis in range(3) for step in (-STEP, STEP)]
    return numpy.concatenate([places] + [places + offset for offset in around])


def roughness(images):
    middle, *around = numpy.split(images, 7)
    seconds = [a + b - 2.0 * middle for a, b in zip(around[::2], around[1::2])]
    return max(numpy.linalg.norm(each, axis=1).max() for each in seconds)


def by_cage(data, cage, moved, coordinates, tetrahedra, **settings):
    return new(shapemap.vtkShapeCageDeform, data, cage, moved, Coordinates=COORDINATES.index(coordinates),
               Tetrahedra=tetrahedra, **settings)


def by_volume_map(data, cage, moved):
    boundary = shapetesting.copy(cage)
    shapetesting.add_array(boundary, points(moved), 'TargetPosition')
    return new(shapemap.vtkShapeHarmonicVolumeMap, data, boundary)


def timed(algorithm):
    start = os.times()
    made = outputs(algorithm)[0]
    end = os.times()
    return made, sum(end[:4]) - sum(start[:4])


def known_motions(options, claims):
    table = sweep.Table('moves:>7', 'motion:<9', 'method:<20', 'error:10.1e', 'rough:8.2f', 'CPU s:8.2f')
    errors = {}
    for name in ('DentedSphere600.vtp', 'DentedSphere3k.vtp'):
        cage = shapetesting.read(name)
        size = numpy.ptp(points(cage), axis=0).max()
        places = stencil(lattice(cage, options.points))
        for kind in MOTIONS:
            moved, exact = with_points(cage, motion(kind, points(cage))), motion(kind, places)
            methods = {each: by_cage(cloud(places), cage, moved, each, options.tetrahedra) for each in COORDINATES}
            methods['Green, affine'] = by_cage(
                cloud(places), cage, moved, 'Green', options.tetrahedra, ReproduceAffine=True)
            methods['HarmonicVolumeMap'] = by_volume_map(cloud(places), cage, moved)
            for method, algorithm in methods.items():
                made, seconds = timed(algorithm)
                images = points(made)
                error = numpy.linalg.norm(images - exact, axis=1).max() / size
                errors[name, kind, method] = error
                expected = roughness(exact)
                table.print({'moves': str(cage.GetNumberOfPoints()), 'motion': kind, 'method': method, 'error': error,
                             'rough': roughness(images) / expected if expected > 1e-9 else None, 'CPU s': seconds})
    for name in ('DentedSphere600.vtp', 'DentedSphere3k.vtp'):
        for method in ('MeanValue', 'Harmonic', 'Green, affine'):
            claims.at_most(name, 'shear, %s: error' % method, errors[name, 'shear', method], 1e-10)
    fine = 'DentedSphere3k.vtp', 'harmonic'
    claims.at_most(fine[0], 'harmonic motion, Harmonic: error', errors[(*fine, 'Harmonic')], 1e-3)
    claims.at_most(fine[0], 'harmonic motion, volume map / Harmonic',
                   errors[(*fine, 'HarmonicVolumeMap')] / errors[(*fine, 'Harmonic')], 1.0)


def box(size):
    cube = vtkCubeSource()
    for axis in 'XYZ':
        getattr(cube, 'Set%sLength' % axis)(size)
    clean, flat, fine = vtkCleanPolyData(), vtkTriangleFilter(), vtkLinearSubdivisionFilter()
    clean.SetInputConnection(cube.GetOutputPort())
    flat.SetInputConnection(clean.GetOutputPort())
    fine.SetInputConnection(flat.GetOutputPort())
    fine.Update()
    return fine.GetOutput()


def conformal_distortion(gradients):
    """|J|^2 / (3 det(J)^(2/3)): 1 where angles are kept."""
    determinants = numpy.linalg.det(gradients)
    square = (gradients ** 2).sum(axis=(1, 2))
    return determinants, square / (3.0 * numpy.maximum(determinants, 1e-12) ** (2.0 / 3.0))


def bent_ball(options):
    ball, cage = shapetesting.read('Ball.vtu'), box(2.6)
    moved = with_points(cage, motion('bent', points(cage)))
    table = sweep.Table('moves:>7', 'method:<20', 'from MeanValue:15.3f', 'min det:8.3f', 'conformal:10.4f', 'CPU s:8.2f')
    first = None
    for method in COORDINATES + ('Green, affine',):
        coordinates, _, affine = method.partition(', ')
        made, seconds = timed(by_cage(ball, cage, moved, coordinates, options.tetrahedra, DeformationGradient=True,
                                      ReproduceAffine=bool(affine)))
        first = points(made) if first is None else first
        determinants, distortion = conformal_distortion(array(made, 'DeformationGradient').reshape(-1, 3, 3))
        table.print({'moves': str(cage.GetNumberOfPoints()), 'method': method,
                     'from MeanValue': numpy.linalg.norm(points(made) - first, axis=1).max() / 2.6,
                     'min det': determinants.min(), 'conformal': distortion.mean(), 'CPU s': seconds})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--points', type=int, default=14, help='of the lattice along each axis')
    parser.add_argument('--tetrahedra', type=int, default=200000)
    options = parser.parse_args()
    claims = sweep.Claims()
    known_motions(options, claims)
    bent_ball(options)
    claims.finish()


if __name__ == '__main__':
    main()
