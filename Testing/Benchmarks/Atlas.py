"""An atlas of 100 shapes of 5,000 points, and its permutation test, beside numpy's alignment, singular value decomposition
and permutations on the same shapes, one thread each, in turn. Both find the same variances and p-values.

    Utilities/pvpython.sh Testing/Benchmarks/Atlas.py [--runs 3]
"""
import argparse
import os
import resource
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import sweep  # noqa: E402

sweep.use_one_thread()  # before numpy is loaded

import numpy  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkTable  # noqa: E402
import shapemap  # noqa: E402
import shapetesting  # noqa: E402

sys.path.append(os.path.join(sweep.ROOT, 'Data'))
from shapes import families  # noqa: E402

SHAPES, FREQUENCY, PERMUTATIONS = 100, 22, 1000
# Of numpy's seconds, and of its greatest memory above that of the shapes.
ATLAS, TEST, MEMORY = 1.5, 0.5, 1.0


def population(family):
    """Noisy shapes in random positions, as arrays and as blocks."""
    random = numpy.random.default_rng(1)
    cells, blocks, shapes = vtkCellArray(), vtkMultiBlockDataSet(), []
    for triangle in family.triangles.tolist():
        cells.InsertNextCell(3, triangle)
    for number, each in enumerate(families.parameters(SHAPES, family.count, 1)):
        turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
        places = family.points(each) + 0.005 * random.normal(size=family.domain.shape)
        shapes.append(places @ (turn * numpy.linalg.det(turn)) + random.normal(size=3))
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        shapetesting.set_points(data, shapes[-1])
        data.SetPolys(cells)
        blocks.SetBlock(number, data)
    return shapes, blocks


def weights_of(shapes, triangles):
    """The mean shares of the area."""
    total = 0.0
    for places in shapes:
        corners = places[triangles]
        areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        own = numpy.bincount(triangles.ravel(), numpy.repeat(areas, 3))
        total = total + own / own.sum() / len(shapes)
    return total


def align(shapes, weights):
    """Generalised Procrustes analysis, to 1e-12 of the size as the filter's."""
    shapes = [places - weights @ places for places in shapes]
    mean = shapes[0]
    for _ in range(100):
        for i, places in enumerate(shapes):
            left, _, right = numpy.linalg.svd((weights[:, None] * places).T @ mean)
            shapes[i] = places @ left @ numpy.diag([1.0, 1.0, numpy.linalg.det(left @ right)]) @ right
        before, mean = mean, numpy.mean(shapes, axis=0)
        if abs(mean - before).max() <= 1e-12 * abs(mean).max():
            break
    return numpy.array(shapes) - mean


def by_numpy(shapes, triangles):
    """The variances by the decomposition of the weighted deviations, and the deviations."""
    weights = weights_of(shapes, triangles)
    deviations = align(shapes, weights)
    rows = (deviations * numpy.sqrt(weights)[:, None]).reshape(len(shapes), -1)
    values = numpy.linalg.svd(rows, full_matrices=False)[1]
    return values[:-1]**2 / (len(shapes) - 1), deviations


def test_by_numpy(deviations, groups):
    """Hotelling's statistic of each point in an isotropic frame, for each permutation."""
    random = numpy.random.default_rng(1)
    centred = groups - groups.mean()
    columns = numpy.array([centred] + [random.permutation(centred) for _ in range(PERMUTATIONS)]).T
    moves = deviations.transpose(1, 2, 0)
    factors = numpy.linalg.inv(numpy.linalg.cholesky(moves @ moves.transpose(0, 2, 1)))
    statistics = ((factors @ moves @ columns)**2).sum(axis=1)
    return (statistics[:, 1:] >= statistics[:, :1] - 1e-9).sum(axis=1)


def seconds_of(work):
    start = time.process_time()
    return work(), time.process_time() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--runs', type=int, default=3)
    options = parser.parse_args()
    family = families.dented_spheres(FREQUENCY)
    shapes, blocks = population(family)
    groups = (numpy.arange(SHAPES) % 2).astype(float)
    rows, column = vtkTable(), numpy_to_vtk(groups, deep=True)
    column.SetName('Group')
    rows.AddColumn(column)
    claims = sweep.Claims()
    print('%d shapes of %d points' % (SHAPES, len(family.domain)))

    def run(**settings):
        algorithm = shapetesting.new(shapemap.vtkShapeAtlas, blocks, None, rows, **settings)
        return shapetesting.outputs(algorithm)

    def peak():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0

    # The filter goes first: what numpy needs above the filter's peak is less than what it needs alone.
    before = peak()
    run(Groups='Group')
    ours = peak() - before
    deviations = by_numpy(shapes, family.triangles)[1]
    test_by_numpy(deviations, groups)
    theirs = peak() - before
    times = {'atlas': [], 'numpy': [], 'test': [], 'numpy test': []}
    for _ in range(options.runs):
        made, seconds = seconds_of(run)
        times['atlas'].append(seconds)
        tested, both = seconds_of(lambda: run(Groups='Group'))
        times['test'].append(both - seconds)
        (variances, deviations), seconds = seconds_of(lambda: by_numpy(shapes, family.triangles))
        times['numpy'].append(seconds)
        larger, seconds = seconds_of(lambda: test_by_numpy(deviations, groups))
        times['numpy test'].append(seconds)
    median = {name: numpy.median(values) for name, values in times.items()}
    for name, seconds in median.items():
        print('%-12s%8.2f CPU seconds' % (name, seconds))
    print('memory above the shapes: %.0f MiB; with numpy %.0f MiB' % (ours, theirs))
    found = vtk_to_numpy(made[2].GetColumnByName('Variance'))
    claims.at_most('atlas', "difference from numpy's variances", abs(found / variances - 1.0).max(), 1e-6)
    p = vtk_to_numpy(tested[0].GetPointData().GetArray('PValue'))
    # Each is a mean of 1,000 random outcomes: six standard errors of the difference.
    claims.at_most('test', "difference from numpy's p-values", abs(p - (larger + 1) / (PERMUTATIONS + 1)).max(),
                   6.0 * (0.5 / PERMUTATIONS)**0.5)
    claims.at_most('atlas', "CPU seconds, of numpy's", median['atlas'] / median['numpy'], ATLAS)
    claims.at_most('test', "CPU seconds, of numpy's", median['test'] / median['numpy test'], TEST)
    claims.at_most('memory', "of numpy's", ours / theirs, MEMORY)
    claims.finish()


if __name__ == '__main__':
    main()
