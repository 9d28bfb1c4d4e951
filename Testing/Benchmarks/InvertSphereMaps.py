"""The inverse of vtkShapeHarmonicTransform over the sphere maps of every closed surface of genus 0 in a
folder of OFF files: a table of how many positions in the solid are found again from their images.

Each model is mapped onto the ball, and the ball onto it. Positions are drawn evenly in the solid; y is
the image of one, f^-1(y) the position that is found, and the error |f(f^-1(y)) - y| / the longest side
of the image. A failure is a position with a positive Jacobian determinant for which none is found, or
with an error above 1e-9. Where the determinant is not positive the map folds there; those are
counted by themselves. There is no failure.

    Utilities/pvpython.sh Testing/Benchmarks/InvertSphereMaps.py [--points 2000] [MODEL ...] [Property=value ...]
"""
import time

import sweep

import numpy
import off
import shapemap
import shapetesting
from scenes import longest_side, point_set, points_inside
from vtkmodules.vtkCommonCore import vtkPoints

LIMIT = 1e-9


def transformed(transform, places):
    """Where a transform takes positions, and its CPU seconds."""
    given, there = vtkPoints(), vtkPoints()
    for points in (given, there):
        points.SetDataTypeToDouble()
    given.SetData(shapetesting.numpy_to_vtk(places, deep=True))
    start = time.process_time()
    transform.TransformPoints(given, there)
    return shapetesting.vtk_to_numpy(there.GetData()), time.process_time() - start


def measure(surface, map_array, count, settings):
    """Maps the solid in a surface, and inverts: (row, what the filter says against it)."""
    places = points_inside(surface, count, numpy.random.default_rng(1))
    maker = shapemap.vtkShapeHarmonicVolumeMap()
    maker.SetInputDataObject(0, point_set(places))
    maker.SetInputDataObject(1, surface)
    maker.SetMapArray(map_array)
    sweep.set_properties(maker, settings)
    start = time.process_time()
    messages = shapetesting.run(maker)
    seconds = time.process_time() - start
    if messages:
        return {}, messages[0].strip().splitlines()[-1]
    charges = maker.GetOutputDataObject(1)
    forward, backward = (shapemap.vtkShapeHarmonicTransform() for _ in range(2))
    for transform in (forward, backward):
        transform.SetChargeSetData(charges)
    backward.Inverse()
    forward.Update()
    backward.Update()
    images, determinants = numpy.zeros_like(places), numpy.zeros(len(places))
    derivative, image = numpy.zeros((3, 3)), [0.0, 0.0, 0.0]
    for i, place in enumerate(places):
        forward.InternalTransformDerivative(list(place), image, derivative)
        images[i], determinants[i] = image, numpy.linalg.det(derivative)
    back, inverting = transformed(backward, images)
    errors = numpy.linalg.norm(transformed(forward, back)[0] - images, axis=1) / longest_side(
        shapetesting.array(surface, map_array))
    positive, failed = determinants > 0.0, errors > LIMIT
    found = errors[positive & ~failed]
    return dict(points=surface.GetNumberOfPoints(),
                charges=int((abs(shapetesting.array(charges, 'Charge')).max(axis=1) > 0.0).sum()),
                places=len(places), positive=int(positive.sum()),
                failures=int((failed & positive).sum()), error=found.max() if len(found) else 0.0,
                folds=int((failed & ~positive).sum()), cpu=seconds,
                microseconds=1e6 * inverting / len(places)), ''


def main():
    parser = sweep.parser(__doc__)
    parser.add_argument('--points', type=int, default=2000, help='positions in each solid')
    options = parser.parse_args()
    claims, failures, maps = sweep.Claims(), [], 0
    table = sweep.Table('map:<34', 'points:7d', 'charges:7d', 'places:6d', 'positive:8d', 'failures:8d',
                        'error:9.1e', 'folds:8d', 'cpu:8.1f', 'microseconds:12.0f')
    for name, path in sweep.models(options):
        parameterize = shapemap.vtkShapeParameterize()
        parameterize.SetInputDataObject(off.read(path))
        parameterize.SetDomain(1)
        if shapetesting.run(parameterize):
            continue  # not closed, or not of genus 0
        for label, port, array in ((name + ' to ball', 0, 'TargetPosition'),
                                   ('ball to ' + name, 1, 'SourcePosition')):
            row, reason = measure(parameterize.GetOutputDataObject(port), array, options.points,
                                  sweep.properties(options))
            table.print(dict(row, map=label), reason)
            maps += 1
            if row.get('failures'):
                failures.append('%s: %d' % (label, row['failures']))
    claims.none('%d maps' % maps, 'with a positive Jacobian, but not found again', failures)
    claims.finish()


if __name__ == '__main__':
    main()
