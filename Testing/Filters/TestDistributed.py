"""In parallel the pieces of a surface are joined before it is mapped, so the result does not depend on
how the data were cut; and an error on one process stops them all.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
two: TestDistributed.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkExtractCells
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkParallelCore import vtkMultiProcessController
import shapemap

import shapetesting
from shapetesting import array, points, read

controller = vtkMultiProcessController.GetGlobalController()
processes = controller.GetNumberOfProcesses() if controller else 1
rank = controller.GetLocalProcessId() if controller else 0


def piece(data):
    """Every process keeps the cells whose centre is on its side of x = 0; in one process, all."""
    if processes == 1:
        return data
    cells = range(data.GetNumberOfCells())
    centre = [numpy.mean([data.GetPoint(data.GetCell(i).GetPointId(k))[0]
                          for k in range(data.GetCell(i).GetNumberOfPoints())]) for i in cells]
    extract = vtkExtractCells()
    extract.SetInputData(data)
    for i in cells:
        if (centre[i] < 0.0) == (rank == 0):
            extract.AddCellRange(i, i)
    extract.Update()
    if data.IsA('vtkUnstructuredGrid'):
        return extract.GetOutput()
    surface = vtkGeometryFilter()
    surface.SetInputConnection(extract.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def by_place(places, values):
    """Rows of `values` in the order of their places, so that pieces can be compared."""
    return {place.tobytes(): value for place, value in zip(places, values)}


folder = sys.argv[1]
surface = piece(read('DentedSphere600.vtp'))
assert surface.GetNumberOfPoints() > 0

sphere = shapemap.vtkShapeParameterize()
sphere.SetInputDataObject(surface)
assert not shapetesting.run(sphere)
mapped = sphere.GetOutputDataObject(0)
assert mapped.GetNumberOfCells() == surface.GetNumberOfCells(), 'a process keeps its own piece'

ball = piece(read('BallSmall.vtu'))
volume = shapemap.vtkShapeHarmonicVolumeMap()
volume.SetInputDataObject(0, ball)
volume.SetInputConnection(1, sphere.GetOutputPort(1))
volume.SetMapArray('SourcePosition')
assert not shapetesting.run(volume)
carried = volume.GetOutputDataObject(0)
assert volume.GetOutputDataObject(1).GetNumberOfPoints() > 0 or rank > 0
assert volume.GetOutputDataObject(1).GetNumberOfPoints() == 0 or rank == 0, 'charges come once'

# The solid inside the pieces is whole, on one process.
solid = shapemap.vtkShapeTetrahedralize()
solid.SetInputDataObject(surface)
assert not shapetesting.run(solid)
tetrahedra = solid.GetOutputDataObject(0)
assert (tetrahedra.GetNumberOfCells() > 642) == (rank == 0), 'the tetrahedra come once'
assert rank > 0 or shapetesting.fact(tetrahedra, 'Tetrahedralize.Points') > 642

if processes == 1:
    numpy.savez(os.path.join(folder, 'truth.npz'),
                places=points(mapped), targets=array(mapped, 'TargetPosition'),
                sources=array(carried, 'SourcePosition'), moved=points(carried))
    print('one process wrote the truth')
else:
    truth = numpy.load(os.path.join(folder, 'truth.npz'))
    # The order of the points differs, and with it the rounding of the sphere map's sums.
    for places, values, expected in (
            (points(mapped), array(mapped, 'TargetPosition'),
             by_place(truth['places'], truth['targets'])),
            (array(carried, 'SourcePosition'), points(carried),
             by_place(truth['sources'], truth['moved']))):
        found = by_place(places, values)
        assert found.keys() <= expected.keys()
        worst = max(abs(found[key] - expected[key]).max() for key in found)
        print('process', rank, 'has', len(found), 'points, off by at most', worst)
        assert worst < 1e-9, worst

    # An empty piece on one process is no empty input.
    alone = shapemap.vtkShapeParameterize()
    alone.SetInputDataObject(read('DentedSphere600.vtp') if rank == 1 else vtkPolyData())
    assert not shapetesting.run(alone)
    assert alone.GetOutputDataObject(0).GetNumberOfPoints() == (642 if rank == 1 else 0)

    # A surface that is open is refused on both, although one alone looks at it.
    opened = shapetesting.copy(surface)
    if rank == 1:
        opened.BuildLinks()
        opened.DeleteCell(11)
        opened.RemoveDeletedCells()
    solid.SetInputDataObject(opened)
    assert any('the Input has 1 open loop' in m for m in shapetesting.run(solid))
    assert tetrahedra.GetNumberOfCells() == 0

    # Blocks are joined, too, and need not be on every process.
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(2)
    if rank == 0:
        blocks.SetBlock(1, read('DentedSphere600.vtp'))
    joined = shapemap.vtkShapeParameterize()
    joined.SetInputDataObject(blocks)
    assert not shapetesting.run(joined)
    block = joined.GetOutputDataObject(0).GetBlock(1)
    assert (block is not None and block.GetNumberOfPoints() == 642) == (rank == 0)

    # A fault that only one process can see is an error on both, and nothing hangs.
    spoiled = shapetesting.copy(ball)
    if rank == 1:
        coordinates = points(spoiled)
        coordinates[3] = numpy.nan
        shapetesting.set_points(spoiled, coordinates)
    volume.SetInputDataObject(0, spoiled)
    messages = shapetesting.run(volume)
    assert any('Shape Harmonic Volume Map: the Domain has 1 point' in m for m in messages), messages
    assert volume.GetOutputDataObject(0).GetNumberOfPoints() == 0
