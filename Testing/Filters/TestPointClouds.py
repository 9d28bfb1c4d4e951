"""Shape Cut Feature, Shape Fill Holes and Shape Paste Feature on point clouds: a horn moves from
one cloud to another."""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points

ANGLE = 0.7
TURNS = 2 * numpy.pi * numpy.arange(12) / 12
CIRCLE = numpy.column_stack([numpy.sin(ANGLE) * numpy.cos(TURNS), numpy.sin(ANGLE) * numpy.sin(TURNS),
                             numpy.full(12, numpy.cos(ANGLE))])


def spread(count):
    """Points of the unit sphere, as evenly as sunflower seeds, but not quite."""
    i = numpy.arange(count) + 0.5
    z, turn = 1 - 2 * i / count, i * numpy.pi * (3 - numpy.sqrt(5))
    flat = numpy.sqrt(1 - z * z)
    places = numpy.column_stack([flat * numpy.cos(turn), flat * numpy.sin(turn), z])
    places += 0.2 * numpy.sqrt(4 * numpy.pi / count) * numpy.random.default_rng(1).uniform(-1, 1, places.shape)
    return places / numpy.linalg.norm(places, axis=1)[:, None]


def horned(count):
    places = spread(count)
    near = numpy.maximum(0, 1 - ((places - [0, 0, 1]) ** 2).sum(axis=1) / 0.2)
    return places * (1 + 0.4 * near ** 3)[:, None]


def cloud(places, normals=None, **arrays):
    data, held = vtkPolyData(), vtkPoints()
    held.SetDataTypeToDouble()
    for place in places:
        held.InsertNextPoint(place)
    data.SetPoints(held)
    vertices = vtkCellArray()
    for i in range(len(places)):
        vertices.InsertNextCell(1, [i])
    data.SetVerts(vertices)
    if normals is not None:
        add_array(data, normals, 'Normals')
    for name, values in arrays.items():
        add_array(data, values, name)
    return data


def cut(data, **properties):
    algorithm = shapetesting.new(shapemap.vtkShapeCutFeature, data, **properties)
    algorithm.SetNumberOfLoopPoints(len(CIRCLE))
    for i, place in enumerate(CIRCLE):
        algorithm.SetLoopPoints(i, *place)
    return [copy(output) for output in shapetesting.outputs(algorithm)[:2]]


def paste(feature, target, seed, **properties):
    algorithm = shapetesting.new(shapemap.vtkShapePasteFeature, feature, target, Seed=seed, **properties)
    messages = shapetesting.run(algorithm)
    return copy(algorithm.GetOutputDataObject(0)), messages


def apart(one, other):
    """The largest distance of a point of one set from the other."""
    return max(numpy.linalg.norm(other - place, axis=1).min() for place in one)


places = horned(4000)
whole = cloud(places, Height=places[:, 2], Number=numpy.arange(len(places)))
feature, rest = cut(whole)
assert fact(feature, 'CutFeature.PointCloud') == fact(rest, 'CutFeature.EstimatedNormals') == 1
assert fact(feature, 'CutFeature.ReturnsInPlace') == 1 and fact(rest, 'CutFeature.Holes') == 1
assert feature.GetNumberOfLines() == 1 and rest.GetNumberOfLines() == 0
for part in (feature, rest):
    originals = array(part, 'OriginalPointId')
    kept = originals >= 0
    assert (points(part)[kept] == places[originals[kept]]).all() and part.GetNumberOfPolys() == 0
    assert (array(part, 'Number')[kept] == originals[kept]).all()
    assert part.GetNumberOfVerts() == part.GetNumberOfPoints()
filled = vtk_to_numpy(rest.GetCellData().GetArray('Filled'))
new = array(rest, 'OriginalPointId') < 0
assert (filled == new).all() and filled.sum() > 300
# The fill continues the sphere, its normals and a linear field.
assert abs(numpy.linalg.norm(points(rest)[new], axis=1) - 1).max() < 0.01
assert abs(array(rest, 'Normals')[new] - points(rest)[new]).max() < 0.03
assert array(rest, 'Height')[new].min() > array(rest, 'Height')[numpy.isin(array(rest, 'OriginalPointId'), array(feature, 'OriginalPointId'))].min() - 1e-9

# Dropped in place, each point is back.
seed = [shapetesting.facts(feature).GetArray('CutFeature.Seed').GetComponent(0, k) for k in range(3)]
back, messages = paste(feature, rest, seed)
assert not messages and back.GetNumberOfPoints() == len(places)
assert max(apart(points(back), places), apart(places, points(back))) < 1e-12
assert fact(back, 'PasteFeature.PointCloud') == 1 and fact(back, 'PasteFeature.AddedPoints') == 0

# Normals turn with the feature, whatever they are: the rest is turned about an axis perpendicular to that of the
# feature, and the feature pasted on it.
given = places + 0.2 * numpy.random.default_rng(2).uniform(-1, 1, places.shape)
given /= numpy.linalg.norm(given, axis=1)[:, None]
horn, left = cut(cloud(places, given))
base = {name: numpy.array([shapetesting.facts(horn).GetArray('CutFeature.' + name).GetComponent(0, k) for k in range(3)])
        for name in ('Seed', 'SeedNormal')}
axis = numpy.cross(base['SeedNormal'], [0.6, 0.8, 0.1])
a, b, c = axis / numpy.linalg.norm(axis)
across = numpy.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
turn = numpy.eye(3) + numpy.sin(1.1) * across + (1 - numpy.cos(1.1)) * across @ across
turned = cloud(points(left) @ turn.T, array(left, 'Normals') @ turn.T)
moved, messages = paste(horn, turned, turn @ base['Seed'])
pairs = numpy.array([numpy.linalg.norm(places @ turn.T - place, axis=1).argmin() for place in points(moved)])
assert not messages and sorted(pairs) == list(range(len(places)))
assert abs(points(moved) - places[pairs] @ turn.T).max() < 1e-9
assert abs(array(moved, 'Normals') - given[pairs] @ turn.T).max() < 1e-9
assert fact(moved, 'PasteFeature.EstimatedNormals') == 0 and moved.GetPointData().GetNormals() is not None

# On another cloud, and on a surface, of which the points count: no gap is wider than the spacing.
ball = cloud(1.5 * spread(6000))
for target in (ball, shapetesting.torus(1.5, 0.8, 40, 24)):
    result, messages = paste(feature, target, [1.0, 1.0, 1.0], Rotation=30.0, Scale=0.8)
    warning = shapetesting.facts(result).GetAbstractArray('PasteFeature.Warning')
    assert not messages and (warning is None) == (target is ball), messages
    assert target is ball or 'the Target was sampled' in warning.GetValue(0)
    assert 0.0 < fact(result, 'PasteFeature.LargestGap') <= fact(result, 'PasteFeature.Spacing')
    part = vtk_to_numpy(result.GetCellData().GetArray('Part'))
    normals = array(result, 'Normals')
    assert abs(numpy.linalg.norm(normals, axis=1) - 1).max() < 1e-12
    assert fact(result, 'PasteFeature.EstimatedNormals') == (target is ball)
    if target is ball: # those of the sphere, which are estimated, also at added points
        away = points(result)[part < 2]
        assert (normals[part < 2] * away).sum(axis=1).min() > 0.99 * 1.5
    assert (part == 2).sum() == feature.GetNumberOfPoints() and result.GetNumberOfPolys() == 0
    assert (part == 1).sum() == fact(result, 'PasteFeature.AddedPoints')
    assert fact(result, 'PasteFeature.DeviationAfter') < 3.0

# With Fill Hole off, the loop stays as a closed line, and Shape Fill Holes fills it with triangles.
_, open_rest = cut(whole, FillHole=False)
assert open_rest.GetNumberOfLines() == 1
filler = shapetesting.new(shapemap.vtkShapeFillHoles, open_rest)
closed = shapetesting.outputs(filler)[0]
added = points(closed)[open_rest.GetNumberOfPoints():]
assert closed.GetNumberOfPolys() > 600 and abs(numpy.linalg.norm(added, axis=1) - 1).max() < 0.01

# Shape Fill Holes finds the holes of points: caps of a sphere, but nothing where it is closed, and not the outer
# boundary of a sheet.
whole_sphere = spread(5000)
caps = (numpy.array([0.0, 0.6, 0.8]), 0.5), (numpy.array([0.8, -0.6, 0.0]), 0.3)
left = numpy.ones(len(whole_sphere), bool)
for direction, angle in caps:
    left &= whole_sphere @ direction < numpy.cos(angle)
open_sphere = whole_sphere[left]
for normals in (None, open_sphere):
    given = cloud(open_sphere, normals, Height=open_sphere[:, 2], Number=numpy.arange(len(open_sphere)))
    closed = copy(shapetesting.outputs(shapetesting.new(shapemap.vtkShapeFillHoles, given))[0])
    assert fact(closed, 'FillHoles.Loops') == 2 and fact(closed, 'FillHoles.OuterLoops') == 0
    assert fact(closed, 'FillHoles.EstimatedNormals') == (normals is None)
    new = vtk_to_numpy(closed.GetCellData().GetArray('Filled')) > 0
    count = len(open_sphere)
    assert (points(closed)[:count] == open_sphere).all() and (array(closed, 'Number')[:count] == numpy.arange(count)).all()
    assert closed.GetNumberOfVerts() == closed.GetNumberOfPoints() and closed.GetNumberOfPolys() == 0
    assert not new[:count].any() and new[count:].all()
    spacing = numpy.sqrt(4 * numpy.pi / len(whole_sphere))
    added = points(closed)[count:]
    assert abs(numpy.linalg.norm(added, axis=1) - 1).max() < spacing
    for direction, _ in caps:
        assert numpy.linalg.norm(added - direction, axis=1).min() < 1.5 * spacing
    # As dense as the rest, whose points have the area 4 pi / 5000 each: as of a cut, within a quarter.
    area = sum(2 * numpy.pi * (1 - numpy.cos(angle)) for _, angle in caps)
    rims = vtk_to_numpy(shapetesting.facts(closed).GetArray('FillHoles.LoopPoints')).sum()
    assert 0.75 < (len(added) + rims) / (area / spacing ** 2) < 1.25, (len(added), rims, area / spacing ** 2)
    normals = array(closed, 'Normals')
    assert (normals * points(closed)).sum(axis=1).min() > 0.99
    # Fields continue harmonically: between the values at the hole.
    for direction, angle in caps:
        rim = open_sphere[open_sphere @ direction > numpy.cos(angle + 3 * spacing), 2]
        inside = array(closed, 'Height')[count:][added @ direction > numpy.cos(angle)]
        assert rim.min() < inside.min() and inside.max() < rim.max()
    # Now it is closed.
    again = copy(shapetesting.outputs(shapetesting.new(shapemap.vtkShapeFillHoles, closed))[0])
    assert fact(again, 'FillHoles.Loops') == fact(again, 'FillHoles.OuterLoops') == 0
    assert (points(again) == points(closed)).all()
small = copy(shapetesting.outputs(shapetesting.new(shapemap.vtkShapeFillHoles, cloud(open_sphere), MaximumLength=2.5))[0])
assert fact(small, 'FillHoles.Loop') == 1 and abs(points(small)[count:] @ caps[1][0]).min() > numpy.cos(0.4)
across = numpy.random.default_rng(3).uniform(-0.3, 0.3, (40, 40, 2)) + numpy.stack(
    numpy.meshgrid(numpy.arange(40), numpy.arange(40)), axis=2)
sheet = cloud(numpy.concatenate([across, 0.01 * (across ** 2).sum(axis=2, keepdims=True)], axis=2).reshape(-1, 3))
same = copy(shapetesting.outputs(shapetesting.new(shapemap.vtkShapeFillHoles, sheet))[0])
assert fact(same, 'FillHoles.Loops') == 0 and fact(same, 'FillHoles.OuterLoops') == 1
assert (points(same) == points(sheet)).all()

# What cannot be done is refused, with a remedy.
shapetesting.check_refused(shapetesting.new(shapemap.vtkShapePasteFeature, cloud(places), ball, Seed=seed),
                           'point cloud without a loop', 'Shape Cut Feature')
shapetesting.check_refused(shapetesting.new(shapemap.vtkShapePasteFeature, feature, cloud(0.1 * spread(300)), Seed=seed),
                           'would lie beyond the points there', 'lower Scale')
