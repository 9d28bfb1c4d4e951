"""Shape Register Volume beside nearest positions: models in poses with a known truth, and a bear onto another one.

A model is bent, twisted and swollen smoothly, so that the true image of each point is known. The baseline aligns the
model by iterative closest points (vtkIterativeClosestPointTransform) and takes the nearest positions on the target.
Both boundary maps then move the same tetrahedra (Shape Mesh Motion), whose inverted cells are counted. Distances and
errors are divided by the longest side of the target.

    Utilities/pvpython.sh Testing/Benchmarks/RegisterVolume.py
"""
import os
import time

import sweep

import numpy
import shapemap
import shapetesting
from shapetesting import array, fact, nearest_positions, points
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkIterativeClosestPointTransform
from vtkmodules.vtkFiltersCore import vtkCleanPolyData


def read(name):
    reader, clean = shapemap.vtkShapeOFFReader(), vtkCleanPolyData()
    reader.SetFileName(os.path.join(sweep.BUILD, 'models', name))
    clean.SetInputConnection(reader.GetOutputPort())
    clean.Update()
    return clean.GetOutput()


def moved(data, positions):
    """The data set at other positions."""
    result = shapetesting.copy(data)
    shapetesting.set_points(result, positions)
    return result


def posed(surface, angle):
    """The surface twisted by this angle over its length, bent and swollen."""
    positions = points(surface)
    low, high = positions.min(axis=0), positions.max(axis=0)
    axis, size = (high - low).argmax(), (high - low).max()
    u, v = (axis + 1) % 3, (axis + 2) % 3
    rest = positions - (low + high) / 2.0
    z = rest[:, axis] / size
    c, s = numpy.cos(angle * z), numpy.sin(angle * z)
    positions[:, u] += (c * rest[:, u] - s * rest[:, v]) * (1.0 + 0.2 * numpy.sin(4.0 * z)) - rest[:, u] \
        + 0.3 * angle * size * z * z
    positions[:, v] += (s * rest[:, u] + c * rest[:, v]) * (1.0 + 0.15 * numpy.cos(3.0 * z)) - rest[:, v]
    return moved(surface, positions)


def aligned(surface, target):
    """The points of the surface after iterative closest points."""
    transform = vtkIterativeClosestPointTransform()
    transform.SetSource(surface)
    transform.SetTarget(target)
    transform.GetLandmarkTransform().SetModeToSimilarity()
    transform.SetMaximumNumberOfIterations(100)
    transform.SetMaximumNumberOfLandmarks(2000)
    transform.Update()
    return numpy.array([transform.TransformPoint(position) for position in points(surface)])


def hausdorff(a, b):
    return max(numpy.linalg.norm(nearest_positions(points(one), other) - points(one), axis=1).max()
               for one, other in ((a, b), (b, a)))


def count_inverted_by_motion(solid, surface, images):
    """The tetrahedra that the motion of their boundary inverts."""
    boundary = shapetesting.copy(surface)
    shapetesting.add_array(boundary, images, 'TargetPosition')
    motion = shapetesting.new(shapemap.vtkShapeMeshMotion, solid, boundary)
    return int(fact(shapetesting.outputs(motion)[0], 'MeshMotion.InvertedAfter'))


def count_inverted(solid):
    """The tetrahedra without a positive volume."""
    corners = points(solid)[vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)]
    return int((numpy.linalg.det(corners[:, 1:] - corners[:, :1]) <= 0.0).sum())


def rows(source, target, align):
    """The measures of the registration and of nearest positions, and the images of each."""
    start = time.process_time()
    surface, solid = shapetesting.outputs(
        shapetesting.new(shapemap.vtkShapeRegisterVolume, source, target, Align=align))[:2]
    yield dict(map='registered', cpu=time.process_time() - start, inverted=count_inverted(solid),
               distortion=fact(surface, 'RegisterVolume.DistortionAfter')), array(surface, 'TargetPosition')
    start = time.process_time()
    images = nearest_positions(aligned(source, target), target)
    seconds = time.process_time() - start
    rest = moved(solid, array(solid, 'SourcePosition'))
    yield dict(map='nearest', cpu=seconds, inverted=count_inverted_by_motion(rest, source, images)), images


def main():
    sweep.parser(__doc__, models=False).parse_args()
    bear, other, man = read('bear.off'), read('bear_bis.off'), read('homer.off')
    claims = sweep.Claims()
    table = sweep.Table('pair:<18', 'map:<10', 'cpu:7.1f', 'error:9.5f', 'largest:9.5f', 'hausdorff:9.5f',
                        'distortion:10.4f', 'inverted:9d')
    for pair, source, target, align in (
            ('bear_bis, pose 0.5', other, posed(other, 0.5), 0), ('bear_bis, pose 1', other, posed(other, 1.0), 0),
            ('homer, pose 1', man, posed(man, 1.0), 0), ('bear, bear_bis', bear, other, 1)):
        size, errors = numpy.ptp(points(target), axis=0).max(), []
        for row, images in rows(source, target, align):
            if source.GetNumberOfPoints() == target.GetNumberOfPoints():
                error = numpy.linalg.norm(images - points(target), axis=1) / size
                row.update(error=error.mean(), largest=error.max())
                errors.append(error.mean())
            table.print(dict(row, pair=pair, hausdorff=hausdorff(moved(source, images), target) / size))
        if errors:
            claims.at_most(pair, 'mean error beside that of nearest positions', errors[0], errors[1])
    claims.finish()


if __name__ == '__main__':
    main()
