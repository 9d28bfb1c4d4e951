"""In parallel a shape and its boundary may come in any pieces: each process gets its own back,
deformed as the whole is, at the resolution of the whole.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
two and three: TestDistributedDeform.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, fact, points, set_points

processes, rank = shapetesting.parallel()


def piece(data, axis=0):
    """Every process keeps the cells whose middle lies in its slab along an axis."""
    if processes == 1:
        return data
    low, high = data.GetBounds()[2 * axis:2 * axis + 2]
    own = []
    for i in range(data.GetNumberOfCells()):
        bounds = data.GetCell(i).GetBounds()
        middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1])
        if min(int(processes * (middle - low) / (high - low)), processes - 1) == rank:
            own.append(i)
    return shapetesting.with_cells(data, own)


def grid_of(cells):
    """A square of quads, and its border moved, made without the pipeline, which cuts in parallel."""
    axis = numpy.linspace(-1.0, 1.0, cells + 1)
    x, y = numpy.meshgrid(axis, axis)
    places = numpy.stack([x.ravel(), y.ravel(), 0.2 * numpy.sin(5.0 * x.ravel())], axis=1)
    square, border = vtkPolyData(), vtkPolyData()
    quads, lines = vtkCellArray(), vtkCellArray()
    number = numpy.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    for i in range(cells):
        for j in range(cells):
            quads.InsertNextCell(4)
            for k in (number[i, j], number[i, j + 1], number[i + 1, j + 1], number[i + 1, j]):
                quads.InsertCellPoint(k)
    loop = numpy.concatenate([number[0, :-1], number[:-1, -1], number[-1, :0:-1], number[:0:-1, 0]])
    for a in range(len(loop)):
        lines.InsertNextCell(2)
        lines.InsertCellPoint(a)
        lines.InsertCellPoint((a + 1) % len(loop))
    for data, rows in ((square, places), (border, places[loop])):
        coordinates = vtkPoints()
        coordinates.SetDataTypeToDouble()
        data.SetPoints(coordinates)
        set_points(data, rows)
    square.SetPolys(quads)
    border.SetLines(lines)
    before = points(border)
    add_array(border, before, 'SourcePosition')
    set_points(border, before + numpy.outer(before[:, 0] ** 2 - 0.5 * before[:, 1], [0, 0, 0.5]))
    return square, border


square, border = grid_of(60)
results = {}
for name, shape, handle in (('Across', piece(square), piece(border, 1)),
                            ('Along', piece(square), piece(border, 0))):
    algorithm = shapemap.vtkShapeDeform()
    algorithm.SetInputDataObject(0, shape)
    algorithm.SetInputDataObject(1, handle)
    assert not shapetesting.run(algorithm), name
    output = algorithm.GetOutputDataObject(0)
    assert output.GetNumberOfPoints() == shape.GetNumberOfPoints(), name
    assert output.GetNumberOfCells() == shape.GetNumberOfCells(), name
    assert fact(output, 'Deform.BasePoints') > 1000, name
    results[name] = numpy.concatenate([array(output, 'SourcePosition'), points(output)], axis=1)

folder = os.path.join(sys.argv[1], 'DistributedDeform')
for name, rows in results.items():
    path = os.path.join(folder, name + '.npy')
    if processes == 1:
        os.makedirs(folder, exist_ok=True)
        numpy.save(path, rows)
        continue
    truth = {row[:3].tobytes(): row[3:] for row in numpy.load(path)}
    assert len(rows) > 500 and len(rows) < len(truth), 'each process has a part'
    worst = max(abs(row[3:] - truth[row[:3].tobytes()]).max() for row in rows)
    assert worst < 1e-9, (name, worst)

# A failure on one process is one on all.
algorithm.SetRigidityArray('Painted')
if rank == 0:
    add_array(shape, -numpy.ones(shape.GetNumberOfPoints()), 'Painted')
messages = ' '.join(shapetesting.run(algorithm))
assert 'Shape Deform: ' in messages, messages
print('process', rank, 'of', processes, 'has its piece of what is deformed as a whole')
