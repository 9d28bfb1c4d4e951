"""From surfaces alone to an atlas: shapes of a family with points and triangles of their own are mapped onto a template
without landmarks by Shape Collection, and Shape Atlas finds the mean and the first mode, which are known.

The bounds were chosen on dented spheres, and hold for bent bars."""
import os
import sys

import numpy
import shapemap
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData

import shapetesting
from shapetesting import add_array, array, points, set_points

sys.path.append(os.path.join(shapetesting.ROOT, 'Data'))
from shapes import families, meshes  # noqa: E402

SHAPES = 10
COMPUTED = 2


def turn_of(random):
    turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
    return turn * numpy.linalg.det(turn)


def surface(places, triangles):
    data, cells = vtkPolyData(), vtkCellArray()
    data.SetPoints(vtkPoints())
    set_points(data, places)
    for triangle in triangles.tolist():
        cells.InsertNextCell(3, triangle)
    data.SetPolys(cells)
    return data


def dented_sphere(random):
    """One whose triangles are those of another geodesic sphere, turned."""
    made = families.dented_spheres(random.integers(9, 12))
    made.domain = made.domain @ turn_of(random)
    return made


def bent_bar(random):
    """One whose lattice of points is finer or coarser."""
    return families.bent_bars(random.integers(6, 10))


def check(name, make, mean_bound, mode_bound):
    random = numpy.random.default_rng(11)
    template = make(random)
    parameters = families.parameters(SHAPES, template.count, 7)
    blocks = vtkMultiBlockDataSet()
    for number, each in enumerate(parameters):
        own = make(random)
        places = own.points(each) @ turn_of(random) + random.normal(size=3)
        blocks.SetBlock(number, surface(places, own.triangles))
    base = surface(template.points(numpy.zeros(template.count)), template.triangles)
    mapped = shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeCollection, blocks, base, Correspondence=COMPUTED))
    made = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeAtlas, mapped[0], base))
    weights, truth, mode = template.weights(), template.mean(), template.modes()[0]
    mean = families.centred(points(made[0]), weights)
    left, _, right = numpy.linalg.svd((weights[:, None] * mean).T @ truth)
    turn = left @ numpy.diag([1.0, 1.0, numpy.linalg.det(left @ right)]) @ right

    def size(values):
        return numpy.sqrt(families.product(values, values, weights))

    found = array(made[0], 'Mode0') @ turn
    errors = size(mean @ turn - truth) / size(truth), min(size(found - mode), size(found + mode)) / size(mode)
    cosine = abs(families.product(found, mode, weights)) / size(found) / size(mode)
    print('%s: mean %.4f, first mode %.4f, cosine %.4f, modes %d, cycle error %.4f' % (
        name, *errors, cosine, shapetesting.fact(made[0], 'Atlas.NumberOfModes'),
        shapetesting.fact(mapped[1], 'Collection.CycleError')))
    assert errors[0] < mean_bound and errors[1] < mode_bound, (name, errors)


for name, make in (('dented spheres', dented_sphere), ('bent bars', bent_bar)):
    check(name, make, 1.0, 10.0)
