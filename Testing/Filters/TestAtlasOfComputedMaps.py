"""From surfaces alone to an atlas: shapes of a family with points and triangles of their own are mapped onto a template
without landmarks by Shape Collection, and Shape Atlas has nearly the mean and the first mode of the same shapes with
the template's points.

The bounds were chosen on the ellipsoids, and are asserted on the bars. Maps follow lengths and angles along the
surfaces, not the parameters of a family: a mode has errors along the surface, which are the larger part. A rotation that
is a symmetry of the shapes may be a part of a map, because the alignment undoes it."""
import os
import sys

import numpy
import shapemap
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData

import shapetesting
from shapetesting import array, points, set_points

sys.path.append(os.path.join(shapetesting.ROOT, 'Data'))
from shapes import families  # noqa: E402

SHAPES, COMPUTED = 10, 2
MEAN, MODE = 0.03, 0.4  # root mean square errors, of the size of the mean and of the mode


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


def ellipsoid(random):
    """With the triangles of a sphere that is turned, and finer or coarser."""
    made = families.ellipsoids(int(random.integers(9, 12)))
    made.domain = made.domain @ turn_of(random)
    return made


def bent_bar(random):
    """With a lattice of points that is finer or coarser."""
    return families.bent_bars(int(random.integers(6, 10)))


def atlas(shapes, base):
    return shapetesting.outputs(shapetesting.new(shapemap.vtkShapeAtlas, shapes, base))[0]


def check(name, make, larger):
    random = numpy.random.default_rng(11)
    template = make(random)
    shapes, exact = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    for number, each in enumerate(larger * families.parameters(SHAPES, template.count, 7)):
        own = make(random)
        shapes.SetBlock(number, surface(own.points(each) @ turn_of(random) + random.normal(size=3), own.triangles))
        exact.SetBlock(number, surface(template.points(each), template.triangles))
    base = surface(template.points(numpy.zeros(template.count)), template.triangles)
    mapped = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeCollection, shapes, base, Correspondence=COMPUTED))
    found, true, weights = atlas(mapped[0], base), atlas(exact, base), template.weights()
    mean, truth = (families.centred(points(each), weights) for each in (found, true))
    left, _, right = numpy.linalg.svd((weights[:, None] * mean).T @ truth)
    turn = left @ numpy.diag([1.0, 1.0, numpy.linalg.det(left @ right)]) @ right

    def size(values):
        return numpy.sqrt(families.product(values, values, weights))

    mode, wanted = array(found, 'Mode0') @ turn, array(true, 'Mode0')
    errors = size(mean @ turn - truth) / size(truth), min(size(mode - wanted), size(mode + wanted)) / size(wanted)
    print('%s: mean %.4f, first mode %.3f' % (name, *errors))
    assert errors[0] < MEAN and errors[1] < MODE, (name, errors)


check('ellipsoids', ellipsoid, 1.0)
check('bars', bent_bar, 4.0)  # 11 degrees
