"""Maps of CommonBase between models and their twisted copies: no triangle is flipped, and landmarks are
exact. For genus 0 the symmetric Dirichlet energy is compared with that of CommonSphere.
Run with Utilities/pvpython.sh Testing/Benchmarks/CommonBase.py MODELS, the folder of the models."""
import os
import sys
import time
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

# Genus, file, landmarks, angle of the twist.
PAIRS = [
    (0, 'dragknob.off', 6, 0.6), (0, 'oblong.off', 5, 0.8), (0, 'larger_sphere.off', 8, 0.8),
    (0, 'itemb.off', 6, 0.6), (0, 'ellipsoid.off', 4, 0.6),
    (1, 'rotor.off', 6, 0.4), (1, 'pinion.off', 6, 0.4), (2, 'joint.off', 8, 0.4),
    (3, 'elephant.off', 12, 0.4)]


def read(path):
    with open(path, encoding='ascii') as file:
        words = ' '.join(line.split('#')[0] for line in file).split()
    count, faces = int(words[1]), int(words[2])
    places = numpy.array(words[4:4 + 3 * count], float).reshape(count, 3)
    return places, numpy.array(words[4 + 3 * count:][:4 * faces], int).reshape(faces, 4)[:, 1:]


def surface(places, triangles):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(places, float), deep=True))
    cells = vtkCellArray()
    offsets = numpy.arange(0, 3 * len(triangles) + 1, 3)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(triangles.astype(numpy.int64).ravel(), deep=True))
    data.SetPolys(cells)
    return data


def energy(places, images, triangles):
    """The symmetric Dirichlet energy, divided by the area; both areas are 1."""
    def edges(points):
        a, b, c = (points[triangles[:, k]] for k in range(3))
        return numpy.stack([b - a, c - a], axis=2)
    forms = []
    for points in (places, images):
        sides = edges(points)
        form = numpy.einsum('tik,til->tkl', sides, sides)
        areas = 0.5 * numpy.sqrt(numpy.maximum(numpy.linalg.det(form), 0))
        forms.append((form / areas.sum(), areas / areas.sum()))
    (one, weights), (other, _) = forms
    return (weights * (numpy.trace(numpy.linalg.solve(one, other), axis1=1, axis2=2) + numpy.trace(
        numpy.linalg.solve(other, one), axis1=1, axis2=2))).sum()


def run(method, a, b, chosen):
    places_a, places_b = a[0][chosen], b[0][chosen]
    landmarks = vtkPolyData()
    landmarks.SetPoints(vtkPoints())
    landmarks.GetPoints().SetData(numpy_to_vtk(places_a, deep=True))
    targets = numpy_to_vtk(places_b, deep=True)
    targets.SetName('TargetPosition')
    landmarks.GetPointData().AddArray(targets)
    algorithm = shapemap.vtkShapeCorrespondence()
    algorithm.SetMethod(method)
    for port, data in enumerate((surface(*a), surface(*b), landmarks)):
        algorithm.SetInputDataObject(port, data)
    start = time.process_time()
    algorithm.Update()
    table = algorithm.GetOutputDataObject(2).GetRowData()
    facts = {table.GetArrayName(i).split('.')[-1]: table.GetAbstractArray(i).GetVariantValue(0).ToDouble()
             for i in range(table.GetNumberOfArrays())}
    maps = [vtk_to_numpy(algorithm.GetOutputDataObject(k).GetPointData().GetArray('TargetPosition'))
            for k in (0, 1)]
    return maps, facts, time.process_time() - start


SPHERE, BASE = 5, 9
for genus, name, count, angle in PAIRS:
    places, triangles = read(os.path.join(sys.argv[1], name))
    places = (places - places.mean(axis=0)) / numpy.ptp(places, axis=0).max()
    turn = 2 * angle * places[:, 2]
    twisted = numpy.column_stack([
        1.2 * (numpy.cos(turn) * places[:, 0] - numpy.sin(turn) * places[:, 1]),
        numpy.sin(turn) * places[:, 0] + numpy.cos(turn) * places[:, 1], places[:, 2]])
    chosen = [int(numpy.linalg.norm(places, axis=1).argmax())]
    while len(chosen) < count:
        distances = [numpy.linalg.norm(places - places[i], axis=1) for i in chosen]
        chosen.append(int(numpy.min(distances, axis=0).argmax()))
    maps, facts, seconds = run(BASE, (places, triangles), (twisted, triangles), chosen)
    assert facts['GenusOfA'] == genus, name
    there = energy(places, maps[0], triangles)
    back = energy(twisted, maps[1], triangles)
    off = max(abs(maps[0][chosen] - twisted[chosen]).max(), abs(maps[1][chosen] - places[chosen]).max())
    peer = numpy.nan
    if genus == 0:
        peer = energy(places, run(SPHERE, (places, triangles), (twisted, triangles), chosen)[0][0], triangles)
    print('%-18s genus %d  %5d points  %2d landmarks  %2d flipped  off %.1e  energy %9.3f back %9.3f  '
          'CommonSphere %9.3f  %5.1f CPU s' % (name, genus, len(places), count,
                                               facts['FlippedTriangles'], off, there, back, peer, seconds),
          flush=True)
    assert facts['FlippedTriangles'] == 0, name
    assert off < 1e-9, name
    assert genus > 0 or there < peer, name
