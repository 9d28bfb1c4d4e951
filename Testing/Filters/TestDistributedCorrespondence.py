"""Surfaces in pieces are matched as wholes: each process gets its own points back, and the map, its
errors, the fields that it carries and the differences that it shows are those of one process.

Run by CTest under pvpython on one process, which writes the truth, and then under pvbatch --sym on
three: TestDistributedCorrespondence.py FOLDER."""
import os
import sys

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.util.numpy_support import vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, triangles

processes, rank = shapetesting.parallel()
METHODS = ['ReversibleHarmonic', 'FunctionalMap', 'GromovWasserstein', 'HeatKernel',
           'BlendedIntrinsic', 'CommonSphere', 'CommonOrbifold', 'WeightedAverages', 'GeneralizedMDS',
           'CommonBase']


def piece(data, axis):
    """Every process keeps a slab of the cells; in one process, all."""
    if processes == 1:
        return data
    centres = points(data)[triangles(data)].mean(axis=1)[:, axis]
    inner = numpy.quantile(centres, numpy.arange(1, processes) / processes)
    return shapetesting.with_cells(
        data, numpy.flatnonzero(numpy.searchsorted(inner, centres) == rank))


def marks(places, targets):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    data.SetVerts(vtkCellArray())
    for i in range(len(places)):
        data.GetVerts().InsertNextCell(1, [i])
    add_array(data, targets, 'TargetPosition')
    return data


def run(algorithm, *inputs, **options):
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    for name, value in options.items():
        getattr(algorithm, 'Set' + name)(value)
    messages = shapetesting.run(algorithm)
    assert not messages, messages
    return algorithm.GetOutputDataObject(0)


def by_place(places, values):
    return {place.tobytes(): value for place, value in zip(places, values)}


results, checks = {}, []


def keep(name, data, values, tolerance):
    """Values at points, to compare with those of one process."""
    results[name + ' places'], results[name] = points(data), values
    checks.append((name, tolerance))


# The two figures: cut across, one along another axis; landmarks on all processes, then on the last.
figure_a, figure_b = read('FigureASmall.vtp'), read('FigureBSmall.vtp')
truth = array(figure_a, 'TargetPosition').copy()
places = points(figure_a)
add_array(figure_b, (truth[:, 0] > 0.0).astype(int), 'Side')
add_array(figure_b, truth, 'Place')
a, b = piece(figure_a, 2), piece(figure_b, 0)
chosen = numpy.linspace(0, len(truth) - 1, 12).astype(int)
shared = marks(places[chosen[rank::processes]], truth[chosen[rank::processes]])
alone = chosen[:4] if rank == processes - 1 else chosen[:0]
size = numpy.ptp(truth, axis=0).max()
for k, method in enumerate(METHODS):
    algorithm = shapemap.vtkShapeCorrespondence()
    landmarks = marks(places[alone], truth[alone]) if method == 'CommonOrbifold' else shared
    there = run(algorithm, a, b, landmarks, Method=k, Samples=200)
    here = algorithm.GetOutputDataObject(1)
    for mine, found in ((a, there), (b, here)):
        assert (points(found) == points(mine)).all(), 'a process keeps its own piece'
    assert fact(there, 'Correspondence.Landmarks') == (4 if method == 'CommonOrbifold' else 12)
    own = by_place(places, truth)
    wanted = numpy.array([own[place.tobytes()] for place in points(there)])
    off = numpy.linalg.norm(array(there, 'TargetPosition') - wanted, axis=1).mean() / size
    assert processes > 1 or off < (0.1 if method in ('CommonOrbifold', 'WeightedAverages') else 0.06), (method, off)
    # Samples are taken from the first point on, which is another one where pieces were joined.
    exact = method in ('HeatKernel', 'CommonOrbifold')
    keep(method, there, array(there, 'TargetPosition'), 1e-9 if exact else 0.02)

    # The precise map numbers the cells of all pieces: fields come exactly from where it leads.
    carried = run(shapemap.vtkShapeTransferFields(), there, b)
    precise = fact(carried, 'TransferFields.PrecisePoints')
    assert precise == len(truth), 'of all processes, with points on seams once'
    assert abs(array(carried, 'Place') - array(there, 'TargetPosition')).max() < 1e-12, method

# Without landmarks: found on the whole.
found = run(shapemap.vtkShapeCorrespondence(), a, b, Method=1)
assert fact(found, 'Correspondence.LandmarksFound') == 1
keep('found', found, array(found, 'TargetPosition'), 0.02)

# Functional maps: the first process has the matrix, which all take, and each gets its own rows.
algorithm = shapemap.vtkShapeCorrespondence()
algorithm.SetTransferArrays(0, 'Place')
algorithm.SetRegionArray('Side')
sender = copy(a)
add_array(sender, points(a), 'Place')
add_array(sender, (array(a, 'TargetPosition')[:, 0] > 0.0).astype(int), 'Side')
there = run(algorithm, sender, b, Method=1, OutputEigenfunctions=True)
here, matrix = algorithm.GetOutputDataObject(1), algorithm.GetOutputDataObject(3)
assert (matrix.GetNumberOfRows() == 120) == (rank == 0) and matrix.GetNumberOfRows() in (0, 120)
assert fact(there, 'Correspondence.FunctionalMapSize') == 120
keep('transferred', here, array(here, 'PlaceFromA'), 0.05)
again = shapemap.vtkShapeCorrespondence()
again.SetInputDataObject(4, matrix)
keep('guided', run(again, a, b, Method=1), array(again.GetOutputDataObject(0), 'TargetPosition'), 0.02)

# A known map: its curve and the differences that it shows.
mapped = copy(a)
target = copy(b)
curve = run(shapemap.vtkShapeMapErrorCurve(), mapped, target, shared)
rows = curve.GetNumberOfRows()
assert (rows == 12) == (rank == 0) and rows in (0, 12), 'one process has the table'
facts = [fact(curve, 'MapErrorCurve.' + name) for name in (
    'Mean', 'Median', 'Percentile95', 'Maximum', 'AreaUnderCurve', 'Unit', 'Coverage')]
if rank == 0:
    errors = vtk_to_numpy(curve.GetColumnByName('Error'))
    assert abs(errors.max() - facts[3]) < 1e-15 and (numpy.diff(errors) >= 0).all()
bent = copy(mapped)
shapetesting.set_points(bent, points(mapped))
add_array(bent, 0.9 * array(mapped, 'TargetPosition'), 'TargetPosition')
curve = run(shapemap.vtkShapeMapErrorCurve(), bent, target, shared)
facts += [fact(curve, 'MapErrorCurve.Mean'), fact(curve, 'MapErrorCurve.Maximum')]
assert facts[-2] > 0.001
difference = shapemap.vtkShapeMapDifference()
differences = run(difference, mapped, target, NumberOfEigenpairs=30)
keep('areas', differences, array(differences, 'AreaDifference'), 1e-6)
keep('angles', differences, array(differences, 'ConformalDifference'), 1e-6)
assert difference.GetOutputDataObject(1).GetNumberOfRows() == (30 if rank == 0 else 0)
values = differences.GetFieldData().GetArray('MapDifference.AreaEigenvalues')
facts += [values.GetValue(i) for i in range(values.GetNumberOfTuples())]

# Domains that other tests do not cut into pieces: a tile, and the plane with a free border.
tile = shapemap.vtkShapeParameterize()
cones = piece(figure_a, 1)
image = run(tile, cones, marks(places[alone], truth[alone]), Domain=3)
facts.append(fact(image, 'Parameterize.ConformalDistortion'))
opened = piece(shapetesting.without_cells(figure_a, range(40)), 0)
free = run(shapemap.vtkShapeParameterize(), opened, Domain=2)
facts += [fact(free, 'Parameterize.' + name) for name in ('ConformalDistortion', 'LoopLength')]

file = os.path.join(sys.argv[1], 'correspondence.npz')
if processes == 1:
    numpy.savez(file, facts=facts, **results)
    print('one process wrote the truth')
else:
    expected = numpy.load(file)
    for name, tolerance in checks:
        wanted = by_place(expected[name + ' places'], expected[name])
        off = [abs(wanted[place.tobytes()] - value).max()
               for place, value in zip(results[name + ' places'], results[name])]
        print('process', rank, name, 'has', len(off), 'points, off by', numpy.mean(off))
        assert numpy.mean(off) < tolerance, (name, numpy.mean(off))
    assert numpy.allclose(facts, expected['facts'], rtol=1e-6, atol=1e-12), (
        facts, expected['facts'])

    # One that is no map on one process is refused on all, and nothing hangs.
    spoiled = copy(there)
    weights = array(there, 'TargetBarycentric').copy()
    if rank == 1:
        weights[3] = 2.0
    add_array(spoiled, weights, 'TargetBarycentric')
    transfer = shapemap.vtkShapeTransferFields()
    transfer.SetInputDataObject(0, spoiled)
    transfer.SetInputDataObject(1, b)
    messages = shapetesting.run(transfer)
    assert any('does not sum to 1' in m and 'first at point 3' in m for m in messages), messages
    assert transfer.GetOutputDataObject(0).GetNumberOfPoints() == 0
