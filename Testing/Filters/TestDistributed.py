"""In parallel the pieces of a surface are joined before it is mapped, so the result does not depend on
how the data were cut; and an error on one process stops them all.

Run twice by CTest: under pvpython on one process, which writes the truth, and under pvbatch --sym on
two: TestDistributed.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkArrayCalculator
from vtkmodules.vtkImagingCore import vtkImageChangeInformation, vtkRTAnalyticSource
import shapemap

import shapetesting
from shapetesting import array, points, read

processes, rank = shapetesting.parallel()


def piece(data):
    """Every process keeps the cells whose centre is on its side of x = 0; in one process, all."""
    if processes == 1:
        return data
    cells = range(data.GetNumberOfCells())
    centre = [numpy.mean([data.GetPoint(data.GetCell(i).GetPointId(k))[0]
                          for k in range(data.GetCell(i).GetNumberOfPoints())]) for i in cells]
    return shapetesting.with_cells(data, [i for i in cells if (centre[i] < 0.0) == (rank == 0)])


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

# The same surface with a hole, to the disk: the loop's first point is found by its place.
whole = read('DentedSphere600.vtp')
disk = shapemap.vtkShapeParameterize()
disk.SetDomain(0)
disk.SetInputDataObject(piece(shapetesting.without_cells(whole, (17,))))
assert not shapetesting.run(disk)
flat = disk.GetOutputDataObject(0)

# The sphere that one process finds, in pieces: those of several differ from it by rounding, which the
# volume map magnifies.
sphere_file = os.path.join(folder, 'sphere.vtp')
if processes == 1:
    shapetesting.write(sphere.GetOutputDataObject(1), sphere_file)
ball = piece(read('BallSmall.vtu'))
volume = shapemap.vtkShapeHarmonicVolumeMap()
volume.SetInputDataObject(0, ball)
volume.SetInputDataObject(1, piece(read(sphere_file)))
volume.SetMapArray('SourcePosition')
assert not shapetesting.run(volume)
carried = volume.GetOutputDataObject(0)
assert volume.GetOutputDataObject(1).GetNumberOfPoints() > 0 or rank > 0
assert volume.GetOutputDataObject(1).GetNumberOfPoints() == 0 or rank == 0, 'charges come once'

# The distance of the pieces of a solid to the whole surface.
distance = shapemap.vtkShapeBoundaryDistance()
distance.SetInputDataObject(0, ball)
distance.SetInputDataObject(1, surface)
assert not shapetesting.run(distance)
measured = distance.GetOutputDataObject(0)

# Each process has a part of the giver; the receiver's points may lie in another's.
giver = shapetesting.copy(ball)
shapetesting.add_array(giver, points(ball) @ [2.0, -3.0, 0.5], 'Temperature')
receiver = shapetesting.copy(ball)
shapetesting.add_array(receiver, -1.05 * points(ball), 'TargetPosition')
transfer = shapemap.vtkShapeTransferFields()
transfer.SetInputDataObject(0, receiver)
transfer.SetInputDataObject(1, giver)
assert not shapetesting.run(transfer)
received = transfer.GetOutputDataObject(0)
outside = array(received, 'OutsideDomain')
assert outside.sum() <= shapetesting.fact(received, 'TransferFields.OutsidePoints')
inner = numpy.linalg.norm(points(received), axis=1) < 0.8
assert not outside[inner].any() and abs(array(received, 'Temperature') + 1.05 * points(
    received) @ [2.0, -3.0, 0.5])[inner].max() < 1e-12

# A grid on the second port is cut into the processes' parts, whatever the first port's extent.
def with_places(extent, name):
    """An image whose array `name` is where its points are."""
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(*extent)
    calculator = vtkArrayCalculator()
    calculator.SetInputConnection(image.GetOutputPort())
    calculator.SetAttributeTypeToPointData()
    calculator.AddCoordinateVectorVariable('coords', 0, 1, 2)
    calculator.SetFunction('coords')
    calculator.SetResultArrayName(name)
    return calculator


both = shapemap.vtkShapeTransferFields()
small, large = with_places([0, 4] * 3, 'TargetPosition'), with_places([-9, 9] * 3, 'Place')
both.SetInputConnection(0, small.GetOutputPort())
both.SetInputConnection(1, large.GetOutputPort())
both.UpdatePiece(rank, processes, 0)
carried_image = both.GetOutputDataObject(0)
assert 50 <= carried_image.GetNumberOfPoints() <= (125 if processes == 1 else 75)
assert abs(array(carried_image, 'Place') - array(carried_image, 'TargetPosition')).max() < 1e-12

# Half way to where the map goes.
morph = shapemap.vtkShapeMorph()
morph.SetInputConnection(sphere.GetOutputPort(0))
morph.UpdateTimeStep(0.5)
halfway = morph.GetOutputDataObject(0)
assert abs(points(halfway) - 0.5 * points(mapped) - 0.5 * array(
    mapped, 'TargetPosition')).max() < 1e-15

# The rigid path of a piece is that of the whole, which one process finds alone.
rigid = {}
for name, data, controller in (('piece', surface, morph.GetController()), ('whole', whole, None)):
    morph = shapetesting.new(shapemap.vtkShapeMorph, data, Path=1, Controller=controller)
    morph.UpdateTimeStep(0.5)
    rigid[name] = by_place(points(data), points(morph.GetOutputDataObject(0)))
assert max(abs(rigid['whole'][place] - moved).max() for place, moved in rigid['piece'].items()) < 1e-9
assert max(abs(moved - numpy.frombuffer(place)).max() for place, moved in rigid['piece'].items()) > 0.01

# Only one process holds the charge set; all move their pieces by it, and back.
applied = shapemap.vtkShapeApplyVolumeMap()
applied.SetInputDataObject(0, ball)
applied.SetInputConnection(1, volume.GetOutputPort(1))
assert not shapetesting.run(applied)
moved = applied.GetOutputDataObject(0)
assert (points(moved) == points(carried)).all(), 'not what the map itself moved'
assert (array(moved, 'OutsideDomain') == array(carried, 'OutsideDomain')).all()
back = shapemap.vtkShapeApplyVolumeMap()
back.SetInputDataObject(0, shapetesting.copy(moved))
back.SetInputConnection(1, volume.GetOutputPort(1))
back.InverseOn()
assert not shapetesting.run(back)
assert (array(back.GetOutputDataObject(0), 'OutsideDomain') == 0).all()
# This map folds in places: what was found has the same image.
applied.SetInputDataObject(0, shapetesting.copy(back.GetOutputDataObject(0)))
assert not shapetesting.run(applied)
assert abs(points(applied.GetOutputDataObject(0)) - points(carried)).max() < 1e-10

# A charge set in pieces, which share points, is the same map.
charges_file = os.path.join(folder, 'charges.vtp')
if processes == 1:
    shapetesting.write(volume.GetOutputDataObject(1), charges_file)
charges = shapetesting.read(charges_file)
mine = [cell for cell in range(charges.GetNumberOfCells()) if cell % processes == rank]
others = [cell for cell in range(charges.GetNumberOfCells()) if cell % processes != rank]
applied.SetInputDataObject(0, ball)
applied.SetInputDataObject(1, shapetesting.without_cells(charges, others) if rank == 0 else
                           shapetesting.with_cells(charges, mine))
assert not shapetesting.run(applied)
assert abs(points(applied.GetOutputDataObject(0)) - points(carried)).max() < 1e-12
applied.SetInputConnection(1, volume.GetOutputPort(1))

# The quality of maps of pieces is that of the whole.
facts = []
for data in (mapped, flat, piece(read('TwistedBarSmall.vtu'))):
    quality = shapemap.vtkShapeMapQuality()
    quality.SetInputDataObject(data)
    assert not shapetesting.run(quality)
    assert (quality.GetOutputDataObject(1).GetNumberOfRows() == 12) == (rank == 0), 'one table'
    facts += [shapetesting.fact(quality.GetOutputDataObject(0), 'MapQuality.' + name) for name in (
        'Cells', 'FlippedCells', 'DegenerateCells', 'MinimumJacobianDeterminant', 'MeanARAP',
        'MeanSymmetricDirichlet', 'MaximumConformalDistortion')]

# The materials of pieces are those of the whole, and each process has a part of the image.
scan, finer = vtkRTAnalyticSource(), vtkImageChangeInformation()
scan.SetWholeExtent(*[-8, 8] * 3)
finer.SetInputConnection(scan.GetOutputPort())
finer.SetOutputSpacing(0.2, 0.2, 0.2)
bone = shapemap.vtkShapeImageValues()
bone.SetInputDataObject(0, ball)
bone.SetInputConnection(1, finer.GetOutputPort())
bone.SetDensity('0.01 * RTData')
bone.UpdatePiece(rank, processes, 0)
marked = shapetesting.outputs_of(bone)[0]
cells = marked.GetCellData()
assert cells.GetArray('MaterialId').GetRange()[1] > 20 and cells.GetArray('Coverage').GetRange()[0] == 1.0
assert (bone.GetOutputDataObject(1).GetNumberOfRows() > 20) == (rank == 0), 'one table'
facts += [shapetesting.fact(marked, 'ImageValues.' + name) for name in (
    'Cells', 'Materials', 'BoundaryVoxels', 'RaisedVoxels', 'Mass', 'Stiffness')]

# Facts are those of the whole: each process has its side of a cloud that lies partly outside.
def cloud(places, mine):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places if processes == 1 else places[mine])
    return data


lattice = numpy.stack(numpy.meshgrid(*[numpy.linspace(-1.3, 1.3, 12)] * 3), axis=-1).reshape(-1, 3)
scattered = cloud(lattice, (lattice[:, 0] < 0.0) == (rank == 0))
volume.SetInputDataObject(0, scattered)
assert not shapetesting.run(volume)
outside = array(volume.GetOutputDataObject(0), 'OutsideDomain').sum()
counts = [shapetesting.fact(volume.GetOutputDataObject(port), 'HarmonicVolumeMap.OutsidePoints')
          for port in (0, 1)]
assert processes > 1 or counts == [outside, outside]
assert 0 < outside < counts[0] == counts[1] or processes == 1, (outside, counts)
volume.SetInputDataObject(0, ball)
applied.SetInputDataObject(0, scattered)
back.SetInputDataObject(0, scattered)
add_map = shapetesting.copy(scattered)
shapetesting.add_array(add_map, points(scattered), 'TargetPosition')
transfer.SetInputDataObject(0, add_map)
for algorithm, names in ((applied, ['ApplyVolumeMap.OutsidePoints']), (back, [
        'ApplyVolumeMap.OutsidePoints', 'ApplyVolumeMap.NotInverted']), (transfer, [
        'TransferFields.OutsidePoints'])):
    assert not shapetesting.run(algorithm)
    counts += [shapetesting.fact(algorithm.GetOutputDataObject(0), name) for name in names]

# Points that two processes share count once.
transfer.SetInputDataObject(0, receiver)
assert not shapetesting.run(transfer)
counts.append(shapetesting.fact(transfer.GetOutputDataObject(0), 'TransferFields.OutsidePoints'))

# Curves stay curves when they are gathered: some of them on each process, their targets on one.
def curves(mine):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.SetLines(vtkCellArray())
    for curve in mine:
        data.GetLines().InsertNextCell(3)
        for x in (-0.4, 0.1, 0.4):
            data.GetLines().InsertCellPoint(
                data.GetPoints().InsertNextPoint(x, 0.2 * curve - 0.3, 0.1 * curve))
    return data


volume.AddInputDataObject(2, curves(range(4) if processes == 1 else ((0, 1), (2, 3))[rank]))
bent = curves(range(4) if rank == processes - 1 else ())
volume.AddInputDataObject(3, bent)
volume.SetFeatureWeight(5.0)
assert not shapetesting.run(volume)
counts.append(shapetesting.fact(volume.GetOutputDataObject(0), 'HarmonicVolumeMap.FeaturePoints'))
fit = shapetesting.fact(volume.GetOutputDataObject(0), 'HarmonicVolumeMap.RMSEFeatures')
volume.RemoveAllFeatures()
volume.RemoveAllTargetFeatures()

# The solid inside the pieces is whole, on one process.
solid = shapemap.vtkShapeTetrahedralize()
solid.SetInputDataObject(surface)
assert not shapetesting.run(solid)
tetrahedra = solid.GetOutputDataObject(0)
assert (tetrahedra.GetNumberOfCells() > 642) == (rank == 0), 'the tetrahedra come once'
assert rank > 0 or shapetesting.fact(tetrahedra, 'Tetrahedralize.Points') > 642

# The pieces of a solid are untangled as one, across where they touch, on the first process.
tangled = read('BallSmall.vtu')
inner = numpy.linalg.norm(points(tangled), axis=1) < 0.3
shapetesting.set_points(tangled, numpy.where(
    inner[:, None], points(tangled) @ numpy.diag([-1.0, 1.0, 1.0]), points(tangled)))
untangle = shapemap.vtkShapeUntangle()
untangle.SetInputDataObject(0, piece(tangled))
assert not shapetesting.run(untangle)
untangled = untangle.GetOutputDataObject(0)
assert untangled.GetNumberOfCells() == (tangled.GetNumberOfCells() if rank == 0 else 0)
if rank == 0:
    counts += [shapetesting.fact(untangled, 'Untangle.Inverted' + when)
               for when in ('Before', 'After')]
    assert counts[-2] > 0 == counts[-1], counts[-2:]
    # Where pieces touch, their points are one: the cells are connected.
    assert untangled.GetNumberOfPoints() == tangled.GetNumberOfPoints()
else:
    counts += [numpy.load(os.path.join(folder, 'truth.npz'))['counts'][k] for k in (-2, -1)]

if processes == 1:
    numpy.savez(os.path.join(folder, 'truth.npz'),
                places=points(mapped), targets=array(mapped, 'TargetPosition'),
                sources=array(carried, 'SourcePosition'), moved=points(carried),
                received=points(received), temperatures=array(received, 'Temperature'),
                measured=points(measured), distances=array(measured, 'BoundaryDistance'),
                facts=facts, counts=counts, fit=fit, openplaces=points(flat), disk=array(flat, 'TargetPosition'))
    print('one process wrote the truth')
else:
    truth = numpy.load(os.path.join(folder, 'truth.npz'))
    # The order of the points differs, and with it the rounding of the sphere map's sums.
    for places, values, expected in (
            (points(mapped), array(mapped, 'TargetPosition'),
             by_place(truth['places'], truth['targets'])),
            (points(flat), array(flat, 'TargetPosition'),
             by_place(truth['openplaces'], truth['disk'])),
            (array(carried, 'SourcePosition'), points(carried),
             by_place(truth['sources'], truth['moved'])),
            (points(received), array(received, 'Temperature'),
             by_place(truth['received'], truth['temperatures'])),
            (points(measured), array(measured, 'BoundaryDistance'),
             by_place(truth['measured'], truth['distances']))):
        found = by_place(places, values)
        assert found.keys() <= expected.keys()
        worst = max(abs(found[key] - expected[key]).max() for key in found)
        print('process', rank, 'has', len(found), 'points, off by at most', worst)
        assert worst < 1e-9, worst

    assert (counts == truth['counts']).all(), (counts, truth['counts'])
    assert abs(fit - truth['fit']) < 1e-9, (fit, truth['fit'])
    assert numpy.allclose(facts, truth['facts'], rtol=1e-6), (facts, truth['facts'])
    assert facts[0] == 1280 and facts[7] == 1279, facts

    # An empty piece on one process is no empty input.
    alone = shapemap.vtkShapeParameterize()
    alone.SetInputDataObject(read('DentedSphere600.vtp') if rank == 1 else vtkPolyData())
    assert not shapetesting.run(alone)
    assert alone.GetOutputDataObject(0).GetNumberOfPoints() == (642 if rank == 1 else 0)

    # A process without a connection stops all of them.
    alone = shapemap.vtkShapeParameterize()
    if rank == 1:
        alone.SetInputDataObject(read('DentedSphere600.vtp'))
    messages = shapetesting.run(alone)
    assert any('Input has 0 connections on one process and 1 on another' in m for m in messages), messages

    # An empty piece may lack the arrays that the others have.
    for algorithm in (shapemap.vtkShapeMorph(), shapemap.vtkShapeTransferFields()):
        algorithm.SetInputDataObject(0, read('DentedSphere600.vtp') if rank == 1 else vtkPolyData())
        if algorithm.GetNumberOfInputPorts() > 1 and algorithm.IsInputRequired(1):
            algorithm.SetInputDataObject(1, giver)
        assert not shapetesting.run(algorithm), algorithm.GetClassName()
        assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == (642 if rank == 1 else 0)

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

    alone = shapemap.vtkShapeMapQuality()
    alone.SetInputDataObject(read('DentedSphere600.vtp') if rank == 1 else vtkPolyData())
    assert not shapetesting.run(alone)
    assert shapetesting.fact(alone.GetOutputDataObject(0), 'MapQuality.Cells') == 1280

    # A fault that only one process can see is an error on both, and nothing hangs.
    faulty = shapetesting.copy(mapped)
    if rank == 1:
        faulty.GetPointData().GetArray('TargetPosition').SetComponent(3, 0, numpy.nan)
    quality.SetInputDataObject(faulty)
    messages = shapetesting.run(quality)
    assert any('has 1 point with a value that is not finite' in m for m in messages), messages
    assert quality.GetOutputDataObject(0).GetNumberOfPoints() == 0
    spoiled = shapetesting.copy(ball)
    if rank == 1:
        coordinates = points(spoiled)
        coordinates[3] = numpy.nan
        shapetesting.set_points(spoiled, coordinates)
    volume.SetInputDataObject(0, spoiled)
    messages = shapetesting.run(volume)
    assert any('Shape Harmonic Volume Map: the Domain has 1 point' in m for m in messages), messages
    assert volume.GetOutputDataObject(0).GetNumberOfPoints() == 0
