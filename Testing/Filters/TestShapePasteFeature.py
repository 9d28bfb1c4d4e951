"""Shape Paste Feature: sets a feature down on a surface.

As an example: a horn, cut from a ball, grows on a larger one."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, edges, euler, fact, output, points, triangles

TURNS = 2 * numpy.pi * numpy.arange(40) / 40
CIRCLE = 0.5 * numpy.column_stack([numpy.full(40, numpy.cos(0.6)), numpy.sin(0.6) * numpy.cos(TURNS),
                                   numpy.sin(0.6) * numpy.sin(TURNS)])

# The example.
ball = simple.Sphere(ThetaResolution=80, PhiResolution=80)
horned = simple.Calculator(Input=ball, CoordinateResults=1, Function=(
    'coords*(1+1.2*max(0,1-((coordsX-0.5)^2+coordsY^2+coordsZ^2)/0.05)^3)'))
cut = simple.ShapeCutFeature(Input=horned, LoopPoints=CIRCLE.ravel().tolist())
planet = simple.Sphere(ThetaResolution=90, PhiResolution=90, Radius=1.2)
pasted = simple.ShapePasteFeature(Feature=cut, Target=planet, Seed=[0.0, 1.0, 0.3], Rotation=30.0)
pasted.UpdatePipeline()
grown = output(pasted)
assert fact(grown, 'PasteFeature.EulerNumber') == 2
assert fact(grown, 'PasteFeature.DeviationAfter') < 3.0
top = points(grown)[numpy.linalg.norm(points(grown), axis=1).argmax()]
assert numpy.linalg.norm(top) > 1.6, top                                  # 1.2 and a horn of 0.6
assert top.dot([0.0, 1.0, 0.3]) / numpy.linalg.norm(top) / numpy.sqrt(1.09) > 0.98


def clean(source):
    """Triangles, points at the same place joined."""
    cut_up, joined = vtkTriangleFilter(), vtkCleanPolyData()
    cut_up.SetInputConnection(source.GetOutputPort())
    joined.SetInputConnection(cut_up.GetOutputPort())
    joined.Update()
    return copy(joined.GetOutput())


def sphere(resolution=80, radius=0.5):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(radius)
    return clean(source)


def horn():
    """A sphere with a horn along +x, and a colour and a height at its points."""
    surface = sphere()
    places = points(surface)
    share = ((places - [0.5, 0.0, 0.0]) ** 2).sum(axis=1) / 0.05
    shapetesting.set_points(surface, places * (1 + 1.2 * numpy.maximum(0, 1 - share) ** 3)[:, None])
    add_array(surface, numpy.tile(numpy.array([200, 40, 0], numpy.uint8), (len(places), 1)), 'Colour')
    add_array(surface, numpy.full(len(places), 3.0), 'Height')
    add_array(surface, numpy.arange(len(places)), 'Number')
    return surface


def parts(surface, **properties):
    """The feature and the rest, filled."""
    algorithm = shapemap.vtkShapeCutFeature()
    algorithm.SetInputDataObject(0, surface)
    algorithm.SetNumberOfLoopPoints(len(CIRCLE))
    for i, place in enumerate(CIRCLE):
        algorithm.SetLoopPoints(i, *place)
    for name, value in properties.items():
        getattr(algorithm, 'Set' + name)(value)
    messages = shapetesting.run(algorithm)
    assert not messages, messages
    return copy(algorithm.GetOutputDataObject(0)), copy(algorithm.GetOutputDataObject(1))


def new(feature, target, seed, **properties):
    return shapetesting.new(shapemap.vtkShapePasteFeature, feature, target, Seed=seed, **properties)


def paste(*args, **properties):
    return shapetesting.outputs(new(*args, **properties))[0]


def refused(words, *args, **properties):
    shapetesting.check_refused(new(*args, **properties), words)


whole = horn()
feature, rest = parts(whole)
seed = [shapetesting.facts(feature).GetArray('CutFeature.Seed').GetComponent(0, k) for k in range(3)]

# Dropped in place, the original is back: every point of it, and no other surface.
back = paste(feature, rest, seed)
assert edges(back, 'Boundary') == edges(back, 'NonManifold') == 0 and euler(back) == 2
placed = {tuple(numpy.round(place, 6)) for place in points(back)}
lost = [place for place in points(feature) if tuple(numpy.round(place, 6)) not in placed]
assert not lost, '%d points of the feature are elsewhere, the first at %s' % (len(lost), lost[0])
assert fact(back, 'PasteFeature.BandTriangles') == 0
assert fact(back, 'PasteFeature.Base') == 'where it was cut'

numbers = numpy_to_vtk(numpy.arange(feature.GetNumberOfCells()), deep=True)
numbers.SetName('OfCell')
feature.GetCellData().AddArray(numbers)

# Elsewhere: one closed manifold, of the target's Euler number, smoothly joined.
for target, number, place in ((shapetesting.torus(2.0, 0.8, 100, 60), 0, [1.5, 1.5, 1.0]), (sphere(90, 1.2), 2, [0.2, -1.0, 0.5])):
    result = paste(feature, target, place, Rotation=-70.0, Scale=0.8)
    assert edges(result, 'Boundary') == edges(result, 'NonManifold') == 0
    assert euler(result) == number == fact(result, 'PasteFeature.EulerNumber')
    assert fact(result, 'PasteFeature.DeviationAfter') < 3.0
    assert fact(result, 'PasteFeature.Deviation95After') < 10.0
    assert numpy.isfinite(points(result)).all()
    part = vtk_to_numpy(result.GetCellData().GetArray('Part'))
    # All cells of the feature are there; some are cut where they join two points of its loop.
    assert set(vtk_to_numpy(result.GetCellData().GetArray('OfCell'))[part == 2]) == set(range(feature.GetNumberOfCells()))
    assert (part == 2).sum() <= 1.1 * feature.GetNumberOfCells()
    assert (part == 1).sum() == fact(result, 'PasteFeature.BandTriangles') > 0

# The field data say where it stands: an orthonormal frame on the target.
frame = [numpy.array([shapetesting.facts(result).GetArray('PasteFeature.' + name).GetComponent(0, k)
                      for k in range(3)]) for name in ('Seed', 'Normal', 'Direction')]
assert abs(numpy.linalg.norm(frame[0]) - 1.2) < 1e-3 and abs(frame[1].dot(frame[0]) - 1.2) < 1e-2
assert abs(frame[1].dot(frame[2])) < 1e-12 and abs(numpy.linalg.norm(frame[2]) - 1.0) < 1e-12

# Data meet at the join: the target's there, the feature's own in its middle; numbers do not blend.
target = sphere(90, 1.2)
count = target.GetNumberOfPoints()
add_array(target, numpy.tile(numpy.array([0, 80, 250], numpy.uint8), (count, 1)), 'Colour')
add_array(target, numpy.full(count, -1.0), 'Height')
add_array(target, numpy.arange(count) + 100000, 'Number')
add_array(target, numpy.full(count, 7.0), 'OnlyHere')
target.GetPointData().SetActiveScalars('Colour')
result = paste(feature, target, [0.0, 0.0, 1.2], BlendWidth=0.5)
assert result.GetPointData().GetScalars().GetName() == 'Colour'
joint = numpy.unique(triangles(result)[vtk_to_numpy(result.GetCellData().GetArray('Part')) == 1])
assert abs(array(result, 'Height')[joint] + 1.0).max() < 1e-9
assert abs(array(result, 'Colour')[joint].astype(float) - [0, 80, 250]).max() <= 1
tip = numpy.linalg.norm(points(result), axis=1).argmax()
assert array(result, 'Height')[tip] == 3.0 and (array(result, 'Colour')[tip] == [200, 40, 0]).all()
assert set(array(result, 'Number')[array(result, 'OnlyHere') == 0.0]) <= set(array(feature, 'Number'))

# A feature of which nothing is known stands on its own fill.
bare = copy(feature)
for name in ('LoopCoordinates', 'LoopNormal'):
    bare.GetPointData().RemoveArray(name)
result = paste(bare, sphere(90, 1.2), [0.0, 0.0, 1.2])
assert fact(result, 'PasteFeature.Base') == 'own fill' and euler(result) == 2
assert edges(result, 'Boundary') == edges(result, 'NonManifold') == 0

# While it is dragged over a place where it does not fit, the last result stays, and says so.
half = shapetesting.without_cells(target, numpy.flatnonzero(
    points(target)[triangles(target)].mean(axis=1)[:, 2] < 0.0).tolist())
moving = new(feature, half, [0.0, 0.0, 1.2], Dragging=True)
assert not shapetesting.run(moving)
good = copy(moving.GetOutputDataObject(0))
assert fact(good, 'PasteFeature.Refused') == 0.0
moving.SetSeed(1.2, 0.0, 0.0)
assert not shapetesting.run(moving)
assert fact(moving.GetOutputDataObject(0), 'PasteFeature.Refused') == 1.0
assert (points(moving.GetOutputDataObject(0)) == points(good)).all()
moving.SetDragging(False)
messages = shapetesting.run(moving)
assert any('Shape Paste Feature' in message and 'boundary of the target' in message for message in messages), messages
moving.SetSeed(0.0, 0.0, 1.2)
assert not shapetesting.run(moving)
assert edges(moving.GetOutputDataObject(0), 'NonManifold') == 0

# What cannot be pasted.
refused('has no open loop', whole, target, [0.0, 0.0, 1.2])
refused('Loop Index is 3', feature, target, [0.0, 0.0, 1.2], LoopIndex=3)
refused('positive', feature, target, [0.0, 0.0, 1.2], Scale=-1.0)
refused('lower Scale to', feature, target, [0.0, 0.0, 1.2], Scale=20.0)
refused('InnerScale is 1e+300', feature, target, [0.0, 0.0, 1.2], InnerScale=1e300)
refused('BlendWidth is nan', feature, target, [0.0, 0.0, 1.2], BlendWidth=float('nan'))

# Arrays of the feature, the bias and the flattening are properties; wrong ones are named.
painted = simple.Calculator(Input=cut, ResultArrayName='Painted', Function='1+4*coordsX')
lean = dict(Feature=painted, Target=planet, Seed=[0.0, 1.0, 0.3], Rotation=30.0)
plain = simple.ShapePasteFeature(**lean)
plain.UpdatePipeline()
for settings in ({'RigidityArray': 'Painted'}, {'ScaleArray': 'Painted'}, {'BiasFrame': [1, 0, 0], 'BiasWeight': 0.3},
                 {'LaplacianSmoothing': 1}, {'NormalSmoothing': 60}, {'UpwindAverage': 0}):
    changed = simple.ShapePasteFeature(**lean, **settings)
    changed.UpdatePipeline()
    one, other = output(plain), output(changed)
    assert fact(other, 'PasteFeature.EulerNumber') == 2
    assert one.GetNumberOfPoints() != other.GetNumberOfPoints() or abs(points(one) - points(other)).max() > 1e-4, settings
algorithm = shapemap.vtkShapePasteFeature()
algorithm.SetInputDataObject(0, output(painted))
algorithm.SetInputDataObject(1, output(planet))
algorithm.SetSeed(0.0, 1.0, 0.3)
algorithm.SetScaleArray('Paint')
said = ' '.join(shapetesting.run(algorithm))
assert "the Feature has no point array 'Paint'" in said, said

# Whatever fills the hole, the feature returns to its place, and the original surface is there again.
horned.UpdatePipeline()
whole = points(output(horned))
for settings in ({'FillMethod': 'Fair'}, {'FillMethod': 'Membrane', 'EdgeGrowth': 0.3},
                 {'FillMethod': 'Deformation', 'Scale': 1.5},
                 {'FillMethod': 'Deformation', 'BiasFrame': [0, 1, 0], 'BiasWeight': 0.1}):
    part = simple.ShapeCutFeature(Input=horned, LoopPoints=CIRCLE.ravel().tolist(), **settings)
    part.UpdatePipeline()
    rest = simple.OutputPort(part, 1)
    seed = vtk_to_numpy(shapetesting.facts(output(part)).GetArray('CutFeature.Seed'))[0]
    back = simple.ShapePasteFeature(Feature=part, Target=rest, Seed=seed.tolist())
    back.UpdatePipeline()
    assert fact(output(back), 'PasteFeature.EulerNumber') == 2
    distances = numpy.array([numpy.linalg.norm(points(output(back)) - place, axis=1).min() for place in whole])
    assert distances.max() < 1e-6, (settings, distances.max())
    if 'Scale' in settings:
        bulging = output(part, 1)
    elif settings['FillMethod'] == 'Fair':
        fair = output(part, 1)
assert bulging.GetNumberOfPoints() != fair.GetNumberOfPoints() or abs(points(bulging) - points(fair)).max() > 1e-3

# A target that is no manifold stays a soup, and the filter says how the seam is joined.


def of_faces(places, faces):
    surface, cells = vtkPolyData(), vtkCellArray()
    surface.SetPoints(vtkPoints())
    shapetesting.set_points(surface, places)
    cells.SetData(numpy_to_vtkIdTypeArray(3 * numpy.arange(len(faces) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(faces).ravel(), deep=True))
    surface.SetPolys(cells)
    return surface


def loop_edge(data):
    """The mean edge of a feature's loop, before the soup's edges split it."""
    loop = shapetesting.edges_of(data, 'Boundary')
    ends = [[loop.GetPoint(loop.GetCell(i).GetPointId(k)) for k in (0, 1)] for i in range(loop.GetNumberOfCells())]
    return numpy.linalg.norm(numpy.subtract(*numpy.swapaxes(ends, 0, 1)), axis=1).mean()


random = numpy.random.default_rng(2)
target = sphere(60, 1.2)
turned = triangles(target).copy()
over = random.random(len(turned)) < 0.3
turned[over] = turned[over][:, [1, 0, 2]]
soup = of_faces(points(target), turned)
add_array(soup, points(soup)[:, 2], 'Height')
joined = paste(feature, soup, [0.2, -1.0, 0.5], Rotation=40.0)
assert fact(joined, 'PasteFeature.Soup') == 1 and fact(joined, 'PasteFeature.LargestGap') < 1e-9
# Where the map of the soup folds, the seam goes to and fro with it.
assert abs(fact(joined, 'PasteFeature.JoinedShare') - 1.0) < 1e-12 and edges(joined, 'NonManifold') == 0
said = shapetesting.facts(joined).GetAbstractArray('PasteFeature.Warning').GetValue(0)
assert 'edges between triangles of opposite orientation' in said and 'Shape Solidify' in said, said
part = vtk_to_numpy(joined.GetCellData().GetArray('Part'))
assert set(part) == {0, 2}
mine = numpy.unique(triangles(joined)[part == 0])
assert abs(array(joined, 'Height')[mine] - points(joined)[mine, 2]).max() < 1e-6
assert fact(paste(feature, target, [0.2, -1.0, 0.5]), 'PasteFeature.Soup') == 0

# Panels with slots between them, as of a car: the feature lies across the slots.
slot = 0.01
sheet = []
for i in range(3):
    for j in range(2):
        corner = numpy.array([(1.0 + slot) * (i - 1.5), (1.0 + slot) * (j - 1.0)])
        u, v = numpy.meshgrid(numpy.arange(11) / 10.0, numpy.arange(11) / 10.0, indexing='ij')
        flat = numpy.column_stack([u.ravel(), v.ravel()]) + corner
        row, column = numpy.divmod(numpy.arange(100), 10)
        first = 11 * row + column
        quads = numpy.concatenate([numpy.column_stack([first, first + 11, first + 12]),
                                   numpy.column_stack([first, first + 12, first + 1])])
        sheet.append((flat, quads[:, [0, 2, 1]] if (i + j) % 2 else quads))
flat = numpy.concatenate([places for places, _ in sheet])
faces = numpy.concatenate([121 * number + quads for number, (_, quads) in enumerate(sheet)])
hood = of_faces(numpy.column_stack([flat, 0.5 - 0.1 * flat[:, 0] ** 2 - 0.2 * flat[:, 1] ** 2]), faces)
refused('beyond the boundary', feature, hood, [0.5, 0.0, 0.4])
result = paste(feature, hood, [0.5, 0.0, 0.4], BridgeGaps=True)
assert fact(result, 'PasteFeature.LargestGap') <= loop_edge(feature), (
    fact(result, 'PasteFeature.LargestGap'), loop_edge(feature))
assert 0.8 < fact(result, 'PasteFeature.JoinedShare') < 1.0
print('panels: largest gap %.4f, mean edge %.4f, joined %.3f' % (
    fact(result, 'PasteFeature.LargestGap'), loop_edge(feature), fact(result, 'PasteFeature.JoinedShare')))
assert 'BridgeGaps is on' in shapetesting.facts(result).GetAbstractArray('PasteFeature.Warning').GetValue(0)
refused('beyond the polygons', feature, hood, [1.45, 0.0, 0.4], BridgeGaps=True)

# Points alone have no boundary (TestPointClouds.py has features and targets of points).
cloud = vtkPolyData()
cloud.SetPoints(target.GetPoints())
refused('the Feature is a point cloud without a loop', cloud, target, [0.0, 0.0, 1.2])
refused('cut it with Shape Cut Feature', cloud, target, [0.0, 0.0, 1.2])
