"""Shape Register Volume beside nearest positions: models in poses with a known truth, and a bear onto another one.

A model is bent, twisted and swollen smoothly, so that the true image of each point is known. The baseline aligns the
model by iterative closest points (vtkIterativeClosestPointTransform) and takes the nearest positions on the target.
Both boundary maps then move the same tetrahedra (Shape Mesh Motion), whose inverted cells are counted. Distances and
errors are divided by the longest side of the target. --models FOLDER: where the models lie."""
import argparse
import os
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkIterativeClosestPointTransform, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkImplicitPolyDataDistance
import shapemap

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument('--models', default=os.path.join(os.path.dirname(__file__), '..', '..', 'build', 'models'))
folder = parser.parse_args().models


def read(name):
    reader, clean = shapemap.vtkShapeOFFReader(), vtkCleanPolyData()
    reader.SetFileName(os.path.join(folder, name))
    clean.SetInputConnection(reader.GetOutputPort())
    clean.Update()
    return clean.GetOutput()


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def with_points(surface, places, name=None):
    """The surface at other places, or with them as an array."""
    moved, values = vtkPolyData(), numpy_to_vtk(numpy.ascontiguousarray(places), deep=True)
    moved.DeepCopy(surface)
    if name:
        values.SetName(name)
        moved.GetPointData().AddArray(values)
    else:
        moved.GetPoints().SetData(values)
    return moved


def posed(surface, angle):
    """The surface twisted by this angle over its length, bent and swollen."""
    places = points(surface)
    low, high = places.min(axis=0), places.max(axis=0)
    axis, size = (high - low).argmax(), (high - low).max()
    u, v = (axis + 1) % 3, (axis + 2) % 3
    rest = places - (low + high) / 2.0
    z = rest[:, axis] / size
    c, s = numpy.cos(angle * z), numpy.sin(angle * z)
    places[:, u] += (c * rest[:, u] - s * rest[:, v]) * (1.0 + 0.2 * numpy.sin(4.0 * z)) - rest[:, u] \
        + 0.3 * angle * size * z * z
    places[:, v] += (s * rest[:, u] + c * rest[:, v]) * (1.0 + 0.15 * numpy.cos(3.0 * z)) - rest[:, v]
    return with_points(surface, places)


def nearest(places, surface):
    distance, found = vtkImplicitPolyDataDistance(), numpy.empty_like(places)
    distance.SetInput(surface)
    for i, place in enumerate(places):
        distance.EvaluateFunctionAndGetClosestPoint(place, found[i])
    return found


def aligned(surface, target):
    """The points of the surface after iterative closest points."""
    transform = vtkIterativeClosestPointTransform()
    transform.SetSource(surface)
    transform.SetTarget(target)
    transform.GetLandmarkTransform().SetModeToSimilarity()
    transform.SetMaximumNumberOfIterations(100)
    transform.SetMaximumNumberOfLandmarks(2000)
    transform.Update()
    return numpy.array([transform.TransformPoint(place) for place in points(surface)])


def hausdorff(image, target, size):
    return max(numpy.linalg.norm(nearest(points(a), b) - points(a), axis=1).max()
               for a, b in ((image, target), (target, image))) / size


def inverted(solid, surface, images):
    """How many tetrahedra the motion of their boundary inverts."""
    motion = shapemap.vtkShapeMeshMotion()
    motion.SetInputDataObject(0, solid)
    motion.SetInputDataObject(1, with_points(surface, images, 'TargetPosition'))
    motion.Update()
    return facts(motion, 1)['MeshMotion.InvertedAfter']


def facts(algorithm, port):
    row = algorithm.GetOutputDataObject(port).GetRowData()
    return {row.GetArrayName(i): row.GetAbstractArray(i).GetValue(0) for i in range(row.GetNumberOfArrays())}


bear, other, man = read('bear.off'), read('bear_bis.off'), read('homer.off')
print('%-18s %-10s %7s %9s %9s %9s %9s %9s' % (
    'pair', 'map', 'CPU s', 'error', 'largest', 'Hausdorff', 'distortion', 'inverted'))
failed = []
for name, source, target, align in (
        ('bear_bis, pose 0.5', other, posed(other, 0.5), 0), ('bear_bis, pose 1', other, posed(other, 1.0), 0),
        ('homer, pose 1', man, posed(man, 1.0), 0), ('bear, bear_bis', bear, other, 1)):
    size = numpy.ptp(points(target), axis=0).max()
    start = time.process_time()
    register = shapemap.vtkShapeRegisterVolume()
    register.SetInputDataObject(0, source)
    register.SetInputDataObject(1, target)
    register.SetAlign(align)
    register.Update()
    seconds = time.process_time() - start
    images = vtk_to_numpy(register.GetOutputDataObject(0).GetPointData().GetArray('TargetPosition'))
    solid = register.GetOutputDataObject(1).NewInstance()
    solid.DeepCopy(register.GetOutputDataObject(1))
    solid.GetPoints().SetData(solid.GetPointData().GetArray('SourcePosition'))
    start = time.process_time()
    near = nearest(aligned(source, target), target)
    rows = [('registered', seconds, images, facts(register, 2)['RegisterVolume.DistortionAfter'], 0),
            ('nearest', time.process_time() - start, near, numpy.nan, inverted(solid, source, near))]
    errors = []
    for kind, seconds, found, distortion, count in rows:
        error = numpy.linalg.norm(found - points(target), axis=1) / size if len(found) == len(points(target)) \
            else numpy.full(1, numpy.nan)
        errors.append(error.mean())
        print('%-18s %-10s %7.1f %9.5f %9.5f %9.5f %9.4f %9d' % (
            name, kind, seconds, error.mean(), error.max(), hausdorff(with_points(source, found), target, size),
            distortion, count), flush=True)
    if errors[0] > errors[1]:
        failed.append('%s: the error is not below that of nearest positions' % name)
if failed:
    raise SystemExit('; '.join(failed))
