"""Shapes in pieces have the atlas of whole ones: mean, modes, scores, statistics and tests are those of one process,
with the same points and with maps; a table that the first process has serves all; too few shapes are refused by all.

Run by CTest under pvpython on one process, which writes the truth, and then under pvbatch --sym on two and four:
TestDistributedAtlas.py FOLDER."""
import os
import sys

import numpy
import shapemap
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkTable

import shapetesting
from shapetesting import add_array, array, copy, points, read, set_points, triangles

sys.path.append(os.path.join(shapetesting.ROOT, 'Data'))
from shapes import families  # noqa: E402

SHAPES = 12
processes, rank = shapetesting.parallel()
family = families.dented_spheres(8)
parameters = families.parameters(SHAPES, 2, 3)
base = read('DentedSphere600.vtp')
assert (triangles(base) == family.triangles).all()


def piece(data):
    """Every process keeps a slab of the cells; in one process, all."""
    if processes == 1:
        return data
    centres = family.domain[family.triangles].mean(axis=1)[:, 2]
    inner = numpy.quantile(centres, numpy.arange(1, processes) / processes)
    return shapetesting.with_cells(data, numpy.flatnonzero(numpy.searchsorted(inner, centres) == rank))


def population(shapes, turned=False):
    """Pieces of some shapes, with a thickness, each mapped onto the first one."""
    blocks = vtkMultiBlockDataSet()
    for number in shapes:
        data = copy(base)
        places = family.points(parameters[number])
        set_points(data, places @ numpy.roll(numpy.eye(3), number, axis=0) + number if turned else places)
        add_array(data, 1.0 + parameters[number, 0] * (1.0 + family.domain[:, 2]), 'Thickness')
        add_array(data, family.points(parameters[shapes[0]]), 'TargetPosition')
        blocks.SetBlock(number, piece(data))
    return blocks


def table():
    made = vtkTable()
    if rank == 0:
        for name, values in (('Group', parameters[:, 0] > 0.0), ('Age', parameters[:, 1])):
            column = numpy_to_vtk(numpy.asarray(values, float), deep=True)
            column.SetName(name)
            made.AddColumn(column)
    return made


def atlas(blocks, **settings):
    return shapetesting.new(shapemap.vtkShapeAtlas, blocks, None, table(), Groups='Group', Regression='Age',
                            Permutations=199, **settings)


results = {}
for name, correspondence in (('same', 0), ('maps', 1)):
    made = shapetesting.outputs(atlas(population(range(SHAPES), turned=True), Correspondence=correspondence))
    if rank > 0:
        assert all(data.GetNumberOfElements(kind) == 0 for data in made[:3] for kind in (data.POINT, data.ROW))
        continue
    mean, scores, statistics, aligned, facts = made
    assert aligned.GetNumberOfBlocks() == SHAPES
    # Joined pieces have their points in another order.
    order = numpy.lexsort(numpy.round(array(mean, 'SourcePosition'), 9).T)
    results[name + ' points'] = points(mean)[order]
    for values in ('SourcePosition', 'Mode0', 'Mode1', 'PositionDeviation', 'GroupDifference', 'PValue', 'QValue', 'Slope',
                   'SlopePValue', 'ThicknessMean', 'ThicknessDeviation', 'ThicknessMode0'):
        results['%s %s' % (name, values)] = array(mean, values)[order]
    for rows in (scores, statistics, facts):
        for k in range(rows.GetNumberOfColumns()):
            if rows.GetColumn(k).IsA('vtkDataArray'):
                results['%s %s' % (name, rows.GetColumnName(k))] = vtk_to_numpy(rows.GetColumn(k))

file = os.path.join(sys.argv[1], 'atlas.npz')
if processes == 1:
    numpy.savez(file, **results)
    print('one process wrote the truth:', len(results), 'results')
elif rank == 0:
    expected = numpy.load(file)
    assert set(expected.files) == set(results), set(expected.files) ^ set(results)
    for name, found in results.items():
        off = abs(found - expected[name]).max()
        assert off <= 1e-9, (name, off)
    print(len(results), 'results are those of one process')

messages = shapetesting.run(shapetesting.new(shapemap.vtkShapeAtlas, population(range(2))))
assert any('at least 3 shapes' in message for message in messages), messages
