"""Shape Correspondence: which point of one surface corresponds to which point of another one.

As an example: two figures in different poses, without a landmark; then a segmentation of one of them
carried over to the other, and one made half of the other by Shape Morph."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read, triangles

HARMONIC, FUNCTIONAL, WASSERSTEIN, HEAT, BLENDED, SPHERE, ORBIFOLD, AVERAGES, SCALING = range(9)


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

# Another map: it fits worse, and goes elsewhere. There are so many, and no more.
assert fact(found, 'Correspondence.Congruence') == 0, 'the poses differ'
assert fact(found, 'Correspondence.Certain') == (fact(found, 'Correspondence.Confidence') >= 0.1)
ranked = shapetesting.new(shapemap.vtkShapeCorrespondence, a, b, None, Method=FUNCTIONAL, Rank=1)
second = shapetesting.outputs(ranked)[0]
assert fact(second, 'Correspondence.IsometryError') > fact(found, 'Correspondence.IsometryError')
assert fact(second, 'Correspondence.Confidence') == 0 and fact(second, 'Correspondence.Certain') == 0
assert errors(second).mean() > 0.05, errors(second).mean()
ranked.SetRank(int(fact(found, 'Correspondence.Alternatives')))
assert 'different maps were found' in shapetesting.run(ranked)[0]
# The figure itself, and its mirror image: it has a mirror symmetry nearly, but its pose has not.
for factor, relation in ((1.0, 1), (-1.0, 2)):
    image = surface_of(points(a)[order] @ turn.T * factor, place_of[triangles(a)][:, ::int(factor)])
    assert int(fact(maps(a, image)[0], 'Correspondence.Congruence')) & relation

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

# Landmarks found by votes, on a copy of a pebble without symmetry: the votes are a coupling, whose sums are the
# weights of the samples.
round_surface = read('DentedSphere600.vtp')
x, y, z = (points(round_surface) / numpy.linalg.norm(points(round_surface), axis=1)[:, None]).T
pebble = (1 + 0.2 * numpy.sin(3 * x + y) - 0.15 * numpy.cos(2 * z - x))[:, None] * numpy.stack([1.4 * x, y, z], 1)
stones = numpy.random.default_rng(2).permutation(len(pebble))
there = 3.0 * pebble @ turn.T
voting = shapetesting.new(
    shapemap.vtkShapeCorrespondence, surface_of(pebble, triangles(round_surface)),
    surface_of(there[stones], numpy.argsort(stones)[triangles(round_surface)]), None, Method=FUNCTIONAL,
    FindLandmarksBy=1)
voted = shapetesting.outputs(voting)
assert abs(array(voted[0], 'TargetPosition') - there).max() < 1e-3 * abs(there).max()
assert fact(voted[0], 'Correspondence.LandmarksFound') == 1
assert fact(voted[0], 'Correspondence.VotingMaps') >= 1 and fact(voted[0], 'Correspondence.Landmarks') == 12
assert 0 < fact(voted[0], 'Correspondence.VotingConfidence') <= 1
assert fact(voted[0], 'Correspondence.Distortion') == -1
for side, name in ((0, 'SampleOfA'), (1, 'SampleOfB')):
    weights = array(voted[side], 'SampleWeight')
    sums = numpy.bincount(vtk_to_numpy(voted[4].GetColumnByName(name)),
                          vtk_to_numpy(voted[4].GetColumnByName('Mass')), minlength=len(weights))
    assert abs(weights.sum() - 1) < 1e-12 and abs(sums - weights).max() < 1e-6, name
voting.SetPart(2)
assert 'set FindLandmarksBy to Distances' in shapetesting.run(voting)[0]

# Conformal maps of triples of its points, without landmarks: most candidates agree on the right map.
blending = shapetesting.new(
    shapemap.vtkShapeCorrespondence, surface_of(pebble, triangles(round_surface)),
    surface_of(there[stones], numpy.argsort(stones)[triangles(round_surface)]), None, Method=BLENDED,
    CandidatesFrom=1)
blended = shapetesting.outputs(blending)
assert numpy.linalg.norm(array(blended[0], 'TargetPosition') - there, axis=1).mean() < 0.01 * abs(there).max()
assert fact(blended[0], 'Correspondence.Landmarks') == 0 and fact(blended[0], 'Correspondence.LandmarksFound') == 0
for side in (0, 1):
    confidence = array(blended[side], 'MapConfidence')
    assert confidence.min() >= 0 and confidence.max() <= 1 + 1e-12
    assert 0.8 < fact(blended[side], 'Correspondence.MeanConfidence') <= 1 + 1e-12
candidates = blended[6]
count = candidates.GetNumberOfRows()
assert count == fact(blended[0], 'Correspondence.CandidateMaps') and candidates.GetNumberOfColumns() == 7 + count
weight = vtk_to_numpy(candidates.GetColumnByName('Weight'))
assert (weight > 0).sum() == fact(blended[0], 'Correspondence.GroupMaps') and abs((weight ** 2).sum() - 1) < 1e-9
matrix = numpy.stack([vtk_to_numpy(candidates.GetColumnByName(str(i))) for i in range(count)], 1)
assert (matrix == matrix.T).all() and matrix.min() >= 0 and matrix.max() <= 1 + 1e-12
corners = [[vtk_to_numpy(candidates.GetColumnByName(place + side)) for place in ('First', 'Second', 'Third')]
           for side in ('OfA', 'OfB')]
known = (numpy.argsort(stones)[corners[0]] == corners[1]).all(axis=0)  # triples of the true map
assert known.sum() > 10 and weight[known].mean() > weight[~known].mean()
blending.SetGroupShare(0)
assert 'GroupShare' in shapetesting.run(blending)[0]

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

# The coupling as data: its rows and columns sum to the weights of the samples, within its error.
coupled = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeCorrespondence, a, b, some, Method=WASSERSTEIN, Samples=150, ImageOfPoint=int(chosen[3])))
table = coupled[4]
entries = {name: vtk_to_numpy(table.GetColumnByName(name)) for name in ('SampleOfA', 'SampleOfB', 'Mass')}
error, omitted = (fact(coupled[0], 'Correspondence.Coupling' + name) for name in ('Error', 'Omitted'))
slack = error + omitted + 1e-12
assert 0 <= omitted < 1e-4 and error < 1e-3
for side, name in ((0, 'SampleOfA'), (1, 'SampleOfB')):
    weights = array(coupled[side], 'SampleWeight')
    assert abs(weights.sum() - 1) < 1e-12 and (weights > 0).sum() >= 150
    sums = numpy.bincount(entries[name], entries['Mass'], minlength=len(weights))
    assert abs(sums - weights).sum() <= slack, (name, abs(sums - weights).sum(), slack)
# A landmark's mass goes to its partner alone, and so does the distribution of its image.
partner = numpy.linalg.norm(points(b) - wanted[chosen[3]], axis=1).argmin()
assert set(entries['SampleOfB'][entries['SampleOfA'] == chosen[3]]) == {partner}
corners = points(b)[triangles(b)]
areas = numpy.zeros(len(points(b)))
numpy.add.at(areas, triangles(b), numpy.linalg.norm(numpy.cross(
    corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)[:, None] / 6)
density = array(coupled[1], 'ImageDistribution')
assert density.min() >= 0 and abs(density @ areas - 1) < 1e-9
spread_of = numpy.linalg.norm(points(b)[density > 1e-9 * density.max()] - points(b)[partner], axis=1).max()
assert 0 < spread_of < 0.15 * size, spread_of

# A feature that both surfaces have: with its whole weight, coupled points have the same height.
along = truth[:, 2] - truth[:, 2].min()
with_a, with_b = copy(a), copy(b)
shapetesting.add_array(with_a, along, 'Height')
shapetesting.add_array(with_b, along[order], 'Height')


def fused(weight, *arrays):
    algorithm = shapetesting.new(shapemap.vtkShapeCorrespondence, with_a, with_b, some, Method=WASSERSTEIN,
                                 Samples=100, FeatureWeight=weight)
    algorithm.SetNumberOfFeatureArrays(len(arrays))
    for index, name in enumerate(arrays):
        algorithm.SetFeatureArrays(index, name)
    return algorithm


costs = [fact(shapetesting.outputs(fused(weight, 'Height'))[0], 'Correspondence.FeatureCost')
         for weight in (0.0, 0.5, 1.0)]
assert 0 < costs[2] < costs[1] < costs[0], costs
assert fact(shapetesting.outputs(fused(0.5))[0], 'Correspondence.FeatureCost') == 0
assert 'Nowhere' in shapetesting.refusal(fused(0.5, 'Nowhere'))

# Distances along the surface: a strip rolled up has those of the flat one; those of a larger one are larger.
u, v = (grid.ravel() for grid in numpy.meshgrid(numpy.linspace(0, 5, 26), numpy.linspace(0, 1, 6), indexing='ij'))
quads = numpy.array([[6 * i + j, 6 * i + 6 + j, 6 * i + 7 + j, 6 * i + j + 1] for i in range(25) for j in range(5)])
strip = numpy.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
flat = surface_of(numpy.column_stack([u, v, 0 * u]), strip)
rolled = surface_of(numpy.column_stack([numpy.sin(u), v, 1 - numpy.cos(u)]), strip)
larger = surface_of(numpy.column_stack([1.2 * u, 1.2 * v, 0 * u]), strip)
diameter = numpy.hypot(5, 1)


def bounds(*surfaces, **options):
    found = shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeCorrespondence, *surfaces, None, DistanceSamples=30, **options))[0]
    return [fact(found, 'Correspondence.' + name)
            for name in ('GromovHausdorffLower', 'GromovHausdorffUpper', 'MaximumDistortion', 'SamplingError')]


lower, upper, most, apart = bounds(flat, rolled, Method=SCALING, ScalingSamples=30)
assert 0 <= lower <= upper < 0.01 * diameter and most == 2 * upper and 0 < apart < diameter
lower, upper, most, apart = bounds(flat, larger, Method=SCALING, ScalingSamples=30)
assert abs(lower - 0.1 * diameter) < 0.001 * diameter > abs(upper - 0.1 * diameter), (lower, upper)
ends = marks([[0, 0, 0], [5, 0, 0], [5, 1, 0]], 1.2 * numpy.array([[0, 0, 0], [5, 0, 0], [5, 1, 0]]))
for compare in (False, True):
    found = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeCorrespondence, flat, larger, ends,
                                                  Method=FUNCTIONAL, CompareDistances=compare))[0]
    upper = fact(found, 'Correspondence.GromovHausdorffUpper')
    assert upper >= 0.099 * diameter if compare else upper == -1, upper
