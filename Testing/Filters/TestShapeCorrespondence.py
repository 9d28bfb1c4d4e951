"""Shape Correspondence: which point of one surface corresponds to which point of another one.

As an example: two figures in different poses, without a landmark; then a segmentation of one of them
carried over to the other, and one made half of the other by Shape Morph."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read, triangles

HARMONIC, FUNCTIONAL, WASSERSTEIN, HEAT, BLENDED, SPHERE, ORBIFOLD, AVERAGES = range(8)


def new(a, b, landmarks=None, method=FUNCTIONAL):
    return shapetesting.new(shapemap.vtkShapeCorrespondence, a, b, landmarks, Method=method)


def maps(*arguments, **options):
    return shapetesting.outputs(new(*arguments, **options))[:2]


def refusal(*arguments, **options):
    messages = shapetesting.run(new(*arguments, **options))
    assert messages, 'nothing was refused'
    return messages[0]


def surface_of(places, corners):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    cells = vtkCellArray()
    for corner in corners:
        cells.InsertNextCell(3, corner)
    data.SetPolys(cells)
    return data


def marks(places, targets, line=False):
    """Landmarks, one behind the other on a line or apart."""
    data = surface_of(places, [])
    cells = vtkCellArray()
    if line:
        cells.InsertNextCell(len(places), range(len(places)))
        data.SetLines(cells)
    else:
        for i in range(len(places)):
            cells.InsertNextCell(1, [i])
        data.SetVerts(cells)
    shapetesting.add_array(data, numpy.asarray(targets, float), 'TargetPosition')
    return data


# The figures. B's points are in another order, it is turned and twice as large; it is known where
# each point of A belongs, and where its mirror image does.
given = read('FigureASmall.vtp')
truth = array(given, 'TargetPosition').copy()
random = numpy.random.default_rng(1)
order = random.permutation(len(truth))
turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
turn *= numpy.sign(numpy.linalg.det(turn))
place_of = numpy.argsort(order)
a = surface_of(points(given), triangles(given))
b = surface_of(2.0 * truth[order] @ turn.T, place_of[triangles(read('FigureBSmall.vtp'))])
wanted, mirrored = 2.0 * truth @ turn.T, 2.0 * (truth * [-1, 1, 1]) @ turn.T
size = numpy.ptp(points(b), axis=0).max()


def errors(found, there=wanted):
    return numpy.linalg.norm(array(found, 'TargetPosition') - there, axis=1) / size


# The example.
producer_a, producer_b = simple.TrivialProducer(), simple.TrivialProducer()
producer_a.GetClientSideObject().SetOutput(a)
producer_b.GetClientSideObject().SetOutput(b)
matched = simple.ShapeCorrespondence(SurfaceA=producer_a, SurfaceB=producer_b)
matched.Method = 'FunctionalMap'
matched.UpdatePipeline()
found, back = shapetesting.output(matched), shapetesting.output(matched, 1)
assert errors(found).mean() < 0.02, errors(found).mean()
assert errors(found, mirrored).mean() > 0.1, 'the sides are exchanged'
assert fact(found, 'Correspondence.LandmarksFound') == 1
assert fact(found, 'Correspondence.Mirrored') == 0
assert fact(found, 'Correspondence.Landmarks') >= 3
assert abs(fact(found, 'Correspondence.DirichletEnergy') - 1.0) < 0.3

# The three arrays say the same place, also where the other surface has vertices before its cells.
for result, other in ((found, b), (back, a)):
    cells, weights = array(result, 'TargetCell'), array(result, 'TargetBarycentric')
    assert weights.min() >= 0 and abs(weights.sum(axis=1) - 1).max() < 1e-12
    corners = points(other)[triangles(other)[cells]]
    places = numpy.einsum('ik,ikc->ic', weights, corners)
    assert abs(places - array(result, 'TargetPosition')).max() < 1e-12
dotted = copy(b)
dots = vtkCellArray()
dots.InsertNextCell(1, [0])
dotted.SetVerts(dots)
assert (array(maps(a, dotted)[0], 'TargetCell') == array(maps(a, b)[0], 'TargetCell') + 1).all()

# The same input gives the same bits.
again = maps(a, b)[0]
assert (array(again, 'TargetPosition') == array(maps(a, b)[0], 'TargetPosition')).all()

# A segmentation of B, carried over: the limbs beyond the middle, by the side that they are on.
labels = copy(b)
side = numpy.sign(truth[order][:, 0]) * (abs(truth[order][:, 0]) > 0.25)
shapetesting.add_array(labels, side, 'Limb')
carried = shapemap.vtkShapeTransferFields()
carried.SetInputDataObject(0, found)
carried.SetInputDataObject(1, labels)
assert not shapetesting.run(carried)
limbs = array(carried.GetOutputDataObject(0), 'Limb')
expected = numpy.sign(truth[:, 0]) * (abs(truth[:, 0]) > 0.25)
clear = abs(abs(truth[:, 0]) - 0.25) > 0.03
assert clear.mean() > 0.9 and (abs(limbs - expected)[clear] < 0.5).mean() > 0.99

# From landmarks: every method is near, averages of few landmarks less than others; they and reversible
# harmonic maps keep the landmarks.
chosen = numpy.linspace(0, len(truth) - 1, 12).astype(int)
some = marks(points(a)[chosen], wanted[chosen])
for method, most in ((HARMONIC, 0.02), (FUNCTIONAL, 0.02), (WASSERSTEIN, 0.05), (HEAT, 0.05),
                     (BLENDED, 0.06), (SPHERE, 0.06), (AVERAGES, 0.1)):
    there, here = maps(a, b, some, method=method)
    assert errors(there).mean() < most, (method, errors(there).mean())
    assert fact(there, 'Correspondence.LandmarksFound') == 0
    assert fact(here, 'Correspondence.Landmarks') == 12
    if method in (HARMONIC, AVERAGES):
        assert errors(there)[chosen].max() < 1e-6
    if method == HARMONIC:
        assert fact(there, 'Correspondence.RoundTrip') < 0.01

# Four of them through an orbifold in the plane, twelve through a hyperbolic one; two are too few.
for count in (4, 12):
    few = marks(points(a)[chosen[:count]], wanted[chosen[:count]])
    there, here = maps(a, b, few, method=ORBIFOLD)
    assert errors(there)[chosen[:count]].max() < 1e-6 and errors(there).mean() < 0.1, count
    assert fact(there, 'Correspondence.ReversedArea') < 0.01
assert 'give three or more' in refusal(
    a, b, marks(points(a)[chosen[:2]], wanted[chosen[:2]]), method=ORBIFOLD)

# Landmarks on a line count between its points, too.
down = numpy.argsort(points(a)[:, 2])[::40]
assert fact(maps(a, b, marks(points(a)[down], wanted[down], line=True))[0],
            'Correspondence.Landmarks') > len(down)

# Without landmarks, the numbers of the points do not change which of two similar matchings is found.
figures = read('FigureASmall.vtp'), read('FigureBSmall.vtp')
height = numpy.ptp(points(figures[1]), axis=0).max()
for trial in range(5):
    new_order = numpy.random.default_rng(trial).permutation(len(truth)) if trial > 0 else numpy.arange(len(truth))
    renumbered = surface_of(points(figures[0])[new_order], numpy.argsort(new_order)[triangles(figures[0])])
    found = array(maps(renumbered, figures[1], method=HARMONIC)[0], 'TargetPosition')
    error = numpy.median(numpy.linalg.norm(found - truth[new_order], axis=1)) / height
    print('order %d: median error %.4f' % (trial, error))
    assert error < 0.03, (trial, error)

# Blocks: each output is like its input.
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, b)
there, here = maps(a, blocks, some)
assert here.GetClassName() == 'vtkMultiBlockDataSet' and there.GetClassName() == 'vtkPolyData'
assert (array(here.GetBlock(0), 'TargetPosition') == array(maps(a, b, some)[1], 'TargetPosition')).all()

# A point that no triangle uses goes where the nearest one goes.
loose = surface_of(numpy.vstack([points(a), points(a)[7] * 1.0001]), triangles(a))
there = array(maps(loose, b, some)[0], 'TargetPosition')
assert (there[-1] == there[7]).all()

# What is refused, and what to do then.
two = surface_of(numpy.vstack([points(a), points(a) + 5]),
                 numpy.vstack([triangles(a), triangles(a) + len(points(a))]))
assert 'component' in refusal(two, b)
assert 'component' in refusal(two, b, some, method=HARMONIC)
assert 'TargetPosition' in refusal(a, b, surface_of(points(a)[:3], []))
holed = read('TwoTorusSmall.vtp')
assert 'genus' in refusal(holed, b, some, method=BLENDED)
broken = copy(a)
bad = points(a)
bad[3, 1] = numpy.nan
shapetesting.set_points(broken, bad)
assert 'finite' in refusal(broken, b)
