"""Shape Atlas finds the mean, the modes and the regressions of generated families, which are known, and its permutation
test is uniform where groups do not differ. What the true modes of bars that bend are: Data/shapes/families.py."""
import os
import sys

import numpy
import shapemap
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkTable

import shapetesting
from shapetesting import array, points

sys.path.append(os.path.join(shapetesting.ROOT, 'Data'))
from shapes import families  # noqa: E402

SHAPES, NOISE = 40, 0.002  # at each point, of the mean shape's size
TRIALS, GROUP, BOTH, PERMUTATIONS = 1000, 7, 16, 199
# Kolmogorov and Smirnov: uniform numbers are farther from the uniform distribution in one case of 1,000.
UNIFORM = 1.95 / TRIALS**0.5 + 1.0 / (PERMUTATIONS + 1)


def polygons(triangles):
    cells = vtkCellArray()
    for triangle in triangles.tolist():
        cells.InsertNextCell(3, triangle)
    return cells


def group(shapes, cells):
    blocks = vtkMultiBlockDataSet()
    for number, places in enumerate(shapes):
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        data.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
        data.SetPolys(cells)
        blocks.SetBlock(number, data)
    return blocks


def table(**columns):
    made = vtkTable()
    for name, values in columns.items():
        values = numpy_to_vtk(numpy.asarray(values, float), deep=True)
        values.SetName(name)
        made.AddColumn(values)
    return made


def posed(places, random):
    """Turned and moved at random."""
    turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
    return places @ (turn * numpy.linalg.det(turn)) + random.normal(size=3)


def turn_to(places, truth, weights):
    """The rotation that takes centred places nearest to the truth."""
    left, _, right = numpy.linalg.svd((weights[:, None] * places).T @ truth)
    return left @ numpy.diag([1.0, 1.0, numpy.linalg.det(left @ right)]) @ right


def distance_from_uniform(values):
    """The greatest one of the distribution functions."""
    values, ranks = numpy.sort(values), numpy.arange(len(values))
    return max(abs(values - ranks / len(values)).max(), abs(values - (ranks + 1) / len(values)).max())


def outputs(*inputs, **settings):
    return shapetesting.outputs(
        shapetesting.new(shapemap.vtkShapeAtlas, *inputs, SpecificitySamples=1, **settings))


def check_modes(name, family):
    random = numpy.random.default_rng(5)
    weights, truth = family.weights(), family.mean()
    length = numpy.sqrt(families.product(truth, truth, weights))

    def error(found, wanted):
        rest = found - wanted
        return numpy.sqrt(families.product(rest, rest, weights) / families.product(wanted, wanted, weights))

    parameters = families.parameters(SHAPES, family.count, 1)
    cells = polygons(family.triangles)
    shapes = [posed(family.points(each), random) for each in parameters]
    columns = {'Parameter%d' % k: 50.0 + 4.0 * parameters[:, k] for k in range(family.count)}
    slopes = []
    for k in range(family.count):
        made = outputs(group(shapes, cells), None, table(**columns), Regression='Parameter%d' % k)
        mean = families.centred(points(made[0]), weights)
        turn = turn_to(mean, truth, weights)
        slopes.append(error(array(made[0], 'Slope') @ turn, family.without_motion(family.tangents()[k]) / 4.0))
    noisy = outputs(group([each + NOISE * length * random.normal(size=truth.shape) for each in shapes], cells))
    modes = [each[4].GetColumnByName('Atlas.NumberOfModes').GetValue(0) for each in (made, noisy)]
    errors = [error(mean @ turn, truth)]
    for k, mode in enumerate(family.modes()):
        found = array(made[0], 'Mode%d' % k) @ turn
        errors.append(min(error(found, mode), error(-found, mode)))
    print(name, 'modes', modes, 'mean', errors[0], 'of modes', errors[1:], 'slopes', slopes)
    assert modes == [family.count, family.count], (name, modes)
    assert max(errors) < 0.01, (name, errors)
    assert max(slopes) < 0.02, (name, slopes)


def check_permutations(name, family):
    """Shapes of both groups are drawn alike, anew for each trial."""
    random = numpy.random.default_rng(2024)
    cells = polygons(family.triangles)
    size = numpy.ptp(family.mean(), axis=0).max()
    rows = table(Group=numpy.arange(BOTH) < GROUP)
    algorithm = shapetesting.new(shapemap.vtkShapeAtlas, None, None, rows, Groups='Group', Permutations=PERMUTATIONS,
                                 NumberOfModes=1, SpecificitySamples=1)
    whole, first = [], []
    for trial in range(TRIALS):
        shapes = [posed(family.points(each) + NOISE * size * random.normal(size=family.domain.shape), random)
                  for each in random.normal(size=(BOTH, family.count))]
        algorithm.SetInputDataObject(0, group(shapes, cells))
        algorithm.SetSeed(trial)
        made = shapetesting.outputs(algorithm)
        whole.append(made[4].GetColumnByName('Atlas.GroupPValue').GetValue(0))
        first.append(vtk_to_numpy(made[0].GetPointData().GetArray('PValue'))[0])
    distances = distance_from_uniform(whole), distance_from_uniform(first)
    print(name, 'distances from uniform', distances)
    assert max(distances) < UNIFORM, (name, distances)


for name, make, fine, coarse in (
        ('ellipsoids', families.ellipsoids, 8, 1), ('dented spheres', families.dented_spheres, 8, 2),
        ('bent bars', families.bent_bars, 6, 1), ('two-region bones', families.two_region_bones, 6, 1)):
    check_modes(name, make(fine))
    check_permutations(name, make(coarse))
