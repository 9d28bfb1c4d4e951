"""The inverse of vtkShapeHarmonicTransform over the sphere maps of every closed surface of genus 0 in a
folder of OFF files: a table of how many places of the solid are found again from their images.

Each model is mapped onto the ball, and the ball onto it. Places are drawn evenly in the solid; y is
the image of one, f^-1(y) the place that is found, and the error |f(f^-1(y)) - y| / the longest side
of the image. A failure is a place with a positive Jacobian determinant for which none is found, or
with an error above 1e-9. Where the determinant is not positive the map folds there; those are
counted by themselves. Raises where there is a failure.

    Utilities/pvpython.sh Testing/Benchmarks/InvertSphereMaps.py [FOLDER [PLACES [PROPERTY=VALUE ...]]]
"""
import glob
import os
import sys
import time

import numpy
import shapemap
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path += [os.path.join(ROOT, 'Utilities'), os.path.join(ROOT, 'Testing')]

import off
import shapetesting

folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, 'build', 'models')
count = int(sys.argv[2]) if len(sys.argv) > 2 else 2000
settings = [setting.split('=') for setting in sys.argv[3:]]
LIMIT = 1e-9


def cloud(places):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    return data


def inside(surface, random):
    """Even random places in a closed surface."""
    corners = shapetesting.points(surface)
    low, high = corners.min(axis=0), corners.max(axis=0)
    found = numpy.zeros((0, 3))
    for _ in range(200):
        candidates = low + (high - low) * random.random((4 * count, 3))
        distance = shapemap.vtkShapeBoundaryDistance()
        distance.SetInputDataObject(0, cloud(candidates))
        distance.SetInputDataObject(1, surface)
        assert not shapetesting.run(distance)
        signed = shapetesting.array(distance.GetOutputDataObject(0), 'BoundaryDistance')
        found = numpy.concatenate([found, candidates[signed < 0.0]])
        if len(found) >= count:
            break
    return found[:count]


def row(name, surface, map_array):
    """Maps the solid in a surface, and inverts; returns the number of failures."""
    random = numpy.random.default_rng(1)
    places = inside(surface, random)
    maker = shapemap.vtkShapeHarmonicVolumeMap()
    maker.SetInputDataObject(0, cloud(places))
    maker.SetInputDataObject(1, surface)
    maker.SetMapArray(map_array)
    for key, value in settings:
        getattr(maker, 'Set' + key)(float(value) if '.' in value else int(value))
    start = time.process_time()
    messages = shapetesting.run(maker)
    seconds = time.process_time() - start
    if messages:
        print('%-34s %s' % (name, messages[0].strip().splitlines()[-1]), flush=True)
        return 0
    charges = maker.GetOutputDataObject(1)
    forward = shapemap.vtkShapeHarmonicTransform()
    forward.SetChargeSetData(charges)
    forward.Update()
    images, determinants = numpy.zeros_like(places), numpy.zeros(len(places))
    derivative, image = numpy.zeros((3, 3)), [0.0, 0.0, 0.0]
    for i, place in enumerate(places):
        forward.InternalTransformDerivative(list(place), image, derivative)
        images[i], determinants[i] = image, numpy.linalg.det(derivative)
    size = numpy.ptp(shapetesting.array(surface, map_array), axis=0).max()
    backward = shapemap.vtkShapeHarmonicTransform()
    backward.SetChargeSetData(charges)
    backward.Inverse()
    backward.Update()
    given, back, forth = vtkPoints(), vtkPoints(), vtkPoints()
    for points in (given, back, forth):
        points.SetDataTypeToDouble()
    given.SetData(shapetesting.numpy_to_vtk(images, deep=True))
    start = time.process_time()
    backward.TransformPoints(given, back)
    inverting = time.process_time() - start
    forward.TransformPoints(back, forth)
    again = shapetesting.vtk_to_numpy(forth.GetData())
    errors = numpy.linalg.norm(again - images, axis=1) / size
    positive = determinants > 0.0
    failed = errors > LIMIT
    print('%-34s %7d %7d %6d %6d %8d %9.1e %8d %8.1f %8.0f' % (
        name, surface.GetNumberOfPoints(),
        (abs(shapetesting.array(charges, 'Charge')).max(axis=1) > 0.0).sum(), len(places),
        positive.sum(), (failed & positive).sum(),
        errors[positive & ~failed].max() if (positive & ~failed).any() else 0.0,
        (failed & ~positive).sum(), seconds, 1e6 * inverting / len(places)), flush=True)
    return int((failed & positive).sum())


print('%-34s %7s %7s %6s %6s %8s %9s %8s %8s %8s' % (
    'map', 'points', 'charges', 'places', 'det>0', 'failures', 'error', 'of folds', 'map CPU s',
    'us/point'))
failures = maps = 0
paths = [folder] if folder.endswith('.off') else sorted(glob.glob(os.path.join(folder, '*.off')))
for path in paths:
    name = os.path.basename(path)[:-4]
    parameterize = shapemap.vtkShapeParameterize()
    parameterize.SetInputDataObject(off.read(path))
    parameterize.SetDomain(1)
    if shapetesting.run(parameterize):
        continue  # not closed, or not of genus 0
    for label, port, array in ((name + ' to ball', 0, 'TargetPosition'),
                               ('ball to ' + name, 1, 'SourcePosition')):
        failures += row(label, parameterize.GetOutputDataObject(port), array)
        maps += 1
print('%d maps, %d failures' % (maps, failures))
if failures:
    raise AssertionError('%d places with a positive Jacobian were not found again' % failures)
