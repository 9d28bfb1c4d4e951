"""Surfaces as they come, for the filters that deform, lay out, cut and paste: with degenerate triangles,
doubled points, polygons, triangles that hang together nowhere or by three at an edge, rims, several loops."""
import re

import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import (add_array, array, closed_curve, closed_curves, copy, edges, edges_of, fact, points,
                          triangles)

AXES = {'x': [1.0, 0.0, 0.0], 'z': [0.0, 0.0, 1.0]}


def surface(places, faces):
    """faces: lists of point numbers. Cells know their number, points a linear function."""
    result, cells = vtkPolyData(), vtkCellArray()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    result.SetPoints(coordinates)
    shapetesting.set_points(result, numpy.asarray(places, float))
    offsets = numpy.cumsum([0] + [len(face) for face in faces])
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.concatenate(faces).astype(numpy.int64), deep=True))
    result.SetPolys(cells)
    add_array(result, points(result) @ [1.0, 2.0, 3.0], 'Linear')
    numbers = numpy_to_vtk(numpy.arange(len(faces)), deep=True)
    numbers.SetName('Number')
    result.GetCellData().AddArray(numbers)
    return result


def sphere(around=48, height=None):
    """A unit sphere of quadrangles and its caps of triangles; with a height, what is above it."""
    rows = around // 2
    angles = numpy.pi * numpy.arange(1, rows) / rows
    turns = 2 * numpy.pi * numpy.arange(around) / around
    ring = numpy.stack([numpy.cos(turns), numpy.sin(turns), numpy.zeros(around)], axis=1)
    places = [AXES['z']] + [point for angle in angles for point in numpy.sin(angle) * ring
                            + [0, 0, numpy.cos(angle)]] + [[0.0, 0.0, -1.0]]
    faces = []
    for k in range(around):
        after = (k + 1) % around
        faces.append([0, 1 + k, 1 + after])
        for row in range(rows - 2):
            first = 1 + row * around
            faces.append([first + k, first + around + k, first + around + after, first + after])
        last = 1 + (rows - 2) * around
        faces.append([last + after, last + k, len(places) - 1])
    if height is None:
        return surface(places, faces)
    faces = [face for face in faces if min(places[point][2] for point in face) > height]
    used = numpy.unique(numpy.concatenate(faces))
    return surface(numpy.array(places)[used], [numpy.searchsorted(used, face) for face in faces])


def cut_up(polygons):
    """Its polygons as triangles."""
    faces = []
    cells = polygons.GetPolys()
    for first, end in zip(*(vtk_to_numpy(cells.GetOffsetsArray())[part] for part in
                            (slice(None, -1), slice(1, None)))):
        face = vtk_to_numpy(cells.GetConnectivityArray())[first:end]
        faces += [[face[0], face[k], face[k + 1]] for k in range(1, len(face) - 1)]
    return surface(points(polygons), faces)


def soup(mesh, noise=0.0):
    """Every triangle with points of its own, each moved by as much."""
    faces = triangles(mesh)
    random = numpy.random.default_rng(5)
    places = points(mesh)[faces].reshape(-1, 3)
    return surface(places + noise * random.uniform(-1, 1, places.shape),
                   numpy.arange(len(places)).reshape(-1, 3).tolist())


def with_degenerate(mesh):
    """The same with triangles of one point, of two, of two places, and between three on a line."""
    places, faces = points(mesh), triangles(mesh).tolist()
    a, b, c = faces[len(faces) // 3]
    d, e = len(places), len(places) + 1
    middle = (places[a] + places[b]) / 2
    places = numpy.vstack([places, places[c], middle])
    # The edge from a to b is replaced by two, with a triangle without area between.
    faces[len(faces) // 3] = [a, e, c]
    faces += [[e, b, c], [a, b, e], [c, c, c], [a, a, b], [c, d, b], [b, d, c]]
    return surface(places, faces)


def with_fin(mesh, at):
    """A triangle more at the edge nearest to a place."""
    places, faces = points(mesh), triangles(mesh).tolist()
    middles = (places[triangles(mesh)[:, 0]] + places[triangles(mesh)[:, 1]]) / 2
    face = faces[numpy.linalg.norm(middles - at, axis=1).argmin()]
    tip = 1.2 * (places[face[0]] + places[face[1]]) / 2
    return surface(numpy.vstack([places, tip]), faces + [[face[0], face[1], len(places)]])


def circle(angle, count=60):
    """On the unit sphere, around the z axis."""
    turns = 2 * numpy.pi * (numpy.arange(count) + 0.5) / count
    return numpy.column_stack([numpy.sin(angle) * numpy.cos(turns),
                               numpy.sin(angle) * numpy.sin(turns),
                               numpy.full(count, numpy.cos(angle))])


def new(kind, inputs, **properties):
    algorithm = getattr(shapemap, 'vtkShape' + kind)()
    for port, data in enumerate(inputs):
        if data is not None:
            algorithm.SetInputDataObject(port, data)
    for name, value in properties.items():
        if name == 'LoopPoints':
            algorithm.SetNumberOfLoopPoints(len(value))
            for i, place in enumerate(value):
                algorithm.SetLoopPoints(i, *place)
        else:
            getattr(algorithm, 'Set' + name)(*(value if isinstance(value, list) else [value]))
    return algorithm


def result(kind, *inputs, **properties):
    """The outputs, of finite numbers alone; the surface alone, if a loop or a handle follows it."""
    algorithm = new(kind, inputs, **properties)
    messages = shapetesting.run(algorithm)
    assert not messages, messages
    outputs = [copy(algorithm.GetOutputDataObject(port))
               for port in range(algorithm.GetNumberOfOutputPorts() - 1)]  # without the facts
    for output in outputs:
        for data in (output.GetPointData(), output.GetCellData()):
            for i in range(data.GetNumberOfArrays()):
                assert numpy.isfinite(vtk_to_numpy(data.GetArray(i))).all(), data.GetArrayName(i)
        assert numpy.isfinite(points(output)).all()
    return outputs[0] if len(outputs) == 1 or kind in ('PasteFeature', 'Deform') else outputs


def refused(words, kind, *inputs, **properties):
    """The message. Nothing comes out, and the inputs are as they were."""
    before = [(data.GetMTime(), points(data).copy(), data.GetNumberOfCells()) for data in inputs]
    algorithm = new(kind, inputs, **properties)
    messages = shapetesting.run(algorithm)
    assert len(messages) >= 1 and words in messages[0], messages
    label = re.sub('([A-Z])', r' \1', 'Shape' + kind)
    assert messages[0].count(label.strip() + ': ') == 1, messages
    for port in range(algorithm.GetNumberOfOutputPorts()):
        output = algorithm.GetOutputDataObject(port)
        assert not any(output.GetNumberOfElements(kind) for kind in (output.POINT, output.CELL, output.ROW))
    for data, (time, places, cells) in zip(inputs, before):
        assert data.GetMTime() == time and (points(data) == places).all()
        assert data.GetNumberOfCells() == cells
    return messages[0]


def area(mesh):
    corners = points(mesh)[triangles(mesh)]
    return 0.5 * numpy.linalg.norm(numpy.cross(
        corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()


def rim_length(mesh):
    rim = edges_of(mesh, 'Boundary')
    ends = points(rim)[vtk_to_numpy(rim.GetLines().GetConnectivityArray()).reshape(-1, 2)]
    return numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()


def handle(places, targets):
    curve = closed_curve(targets)
    add_array(curve, places, 'SourcePosition')
    return curve


def differences(one, other):
    """How far each place of one is from the nearest of the other."""
    return numpy.array([numpy.linalg.norm(other - place, axis=1).min() for place in one])


QUADS = sphere()
BALL = cut_up(QUADS)
DIAGONAL = numpy.sqrt(12.0)
TURN = numpy.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
VARIANTS = {'soup': soup(BALL), 'soup, moved': soup(BALL, 2e-10 * DIAGONAL),
            'degenerate': with_degenerate(BALL), 'fin': with_fin(BALL, AXES['z'])}

# Shape Deform: the same motion of the same places, whatever the triangles; a rigid one is exact. The
# handle may be several loops, and one that touches itself.
cap = cut_up(sphere(height=-0.3))
rim = circle(numpy.arccos(-0.25), 48)
bent = rim * [1.0, 0.7, 1.0] + 0.2 * rim[:, :1] * [[0.0, 0.0, 1.0]]
plain = result('Deform', cap, handle(rim, bent))
for name, make in (('soup', soup), ('soup, moved', lambda mesh: soup(mesh, 2e-10 * DIAGONAL)),
                   ('degenerate', with_degenerate)):
    variant = make(cap)
    found = result('Deform', variant, handle(rim, bent))
    nearest = [numpy.linalg.norm(points(cap) - place, axis=1).argmin() for place in points(variant)]
    same = numpy.linalg.norm(points(cap)[nearest] - points(variant), axis=1) < 1e-6
    assert same.sum() >= len(points(cap))
    off = abs(points(found) - points(plain)[nearest])[same].max()
    # A cut-up triangle changes the graph around it; welded points change nothing.
    assert off < (1e-6 if name != 'degenerate' else 0.05), (name, off)
    assert fact(found, 'Deform.WeldedPoints') == len(points(variant)) - len(points(cap)) - (
        name == 'degenerate') > 0
for name, variant in list(VARIANTS.items()) + [('quadrangles', QUADS)]:
    two = numpy.vstack([circle(0.5), circle(2.2)])
    loops = closed_curves(numpy.split(two @ TURN.T + [1.0, 2.0, 3.0], 2))
    add_array(loops, two, 'SourcePosition')
    eight = numpy.vstack([circle(0.5), circle(1.1)])
    eight[60] = eight[0]
    for curve in (loops, handle(eight, eight @ TURN.T + [1.0, 2.0, 3.0])):
        found = result('Deform', variant, curve)
        off = abs(points(found) - points(variant) @ TURN.T - [1.0, 2.0, 3.0]).max()
        assert off < 1e-11, (name, off)
        assert found.GetNumberOfCells() == variant.GetNumberOfCells()

# Shape Exponential Map: places are where they are on the clean surface. It stops at a rim.
seed, radius = [0.2, 0.1, 0.9], 0.8
patch = result('ExponentialMap', BALL, Seed=seed, Radius=radius, XDirection=AXES['x'])
flat = {tuple(place): image for place, image in zip(
    numpy.round(points(patch), 7), array(patch, 'TargetPosition'))}
for name, variant in VARIANTS.items():
    found = result('ExponentialMap', variant, Seed=seed, Radius=radius, XDirection=AXES['x'])
    images = array(found, 'TargetPosition')
    known = [tuple(place) in flat for place in numpy.round(points(found), 7)]
    assert sum(known) >= len(flat) * (1 if name != 'fin' else 0.98), name
    off = max(abs(images[i] - flat[tuple(place)]).max()
              for i, place in enumerate(numpy.round(points(found), 7)) if known[i])
    assert off < (1e-8 if name.startswith('soup') else 0.005), (name, off)
    assert (points(found) == points(variant)[array(found, 'OriginalPointId')]).all()
    flipped = vtk_to_numpy(found.GetCellData().GetArray('Flipped')) == 1
    numbers = vtk_to_numpy(found.GetCellData().GetArray('Number'))
    # The fin may face either way.
    assert name == 'fin' or not flipped.any(), name
    assert (numbers[flipped] == triangles(BALL).shape[0]).all(), (name, numbers[flipped])
bowl = cut_up(sphere(height=0.55))
near = result('ExponentialMap', bowl, Seed=[0.6, 0.0, 0.8], Radius=0.6)
assert fact(near, 'ExponentialMap.ReachesRim') == 1 and fact(near, 'ExponentialMap.Flipped') == 0
assert fact(near, 'ExponentialMap.Coverage') < 0.9
assert shapetesting.facts(result('ExponentialMap', bowl, Seed=AXES['z'], Radius=0.5)).GetArray(
    'ExponentialMap.ReachesRim').GetValue(0) == 0
refused('has no triangles', 'ExponentialMap', closed_curve(rim))
degenerate = surface(numpy.zeros((3, 3)), [[0, 1, 2]])
result('ExponentialMap', degenerate, Radius=1.0)

# Shape Cut Feature: parts of the same area, the rest whole again, points by their number.
size = {name: area(variant) for name, variant in VARIANTS.items()}
plain = result('CutFeature', BALL, LoopPoints=circle(0.6))
for name, variant in VARIANTS.items():
    feature, rest = result('CutFeature', variant, LoopPoints=circle(0.6))
    filled = vtk_to_numpy(rest.GetCellData().GetArray('Filled')) == 1
    own = shapetesting.without_cells(rest, numpy.flatnonzero(filled).tolist())
    assert abs(area(feature) + area(own) - size[name]) < 1e-6, name
    assert abs(area(feature) - area(plain[0])) < (1e-6 if name != 'fin' else 0.05), name
    for part in (feature, rest):
        original = array(part, 'OriginalPointId')
        off = abs(points(part)[original >= 0] - points(variant)[original[original >= 0]]).max()
        assert off < 1e-9 * DIAGONAL, (name, off)
    assert fact(rest, 'CutFeature.Holes') == 1
    assert (fact(rest, 'CutFeature.WeldedPoints') > 0) == (name != 'fin'), name
    on_loop = numpy.linalg.norm(array(feature, 'LoopNormal'), axis=1) > 0
    assert abs(points(feature)[on_loop][:, 2] - numpy.cos(0.6)).max() < 0.01, name
# Of several loops the one that is meant; of one that touches itself the longest part.
both = closed_curves([circle(0.7), circle(1.4)])
areas = [area(result('CutFeature', BALL, both, LoopIndex=index)[0]) for index in (0, 1, -1)]
assert abs(areas[0] / (2 * numpy.pi * (1 - numpy.cos(0.7))) - 1) < 0.02
assert abs(areas[1] / (2 * numpy.pi * (1 - numpy.cos(1.4))) - 1) < 0.02
assert abs(areas[2] / (areas[1] - areas[0]) - 1) < 0.01
turns = 2 * numpy.pi * (numpy.arange(120) + 0.5) / 120
eight = numpy.column_stack([0.5 * numpy.sin(turns) * numpy.where(numpy.sin(turns) > 0, 1.5, 1.0),
                            0.3 * numpy.sin(2 * turns), numpy.ones(120)])
lobe = result('CutFeature', BALL, LoopPoints=eight)[0]
assert fact(lobe, 'CutFeature.LoopsLeftOut') == 1 and points(lobe)[:, 0].min() > -0.05
# A loop that leaves the surface over its rim cuts along it; there is no hole to fill then.
notch, rest = result('CutFeature', bowl, LoopPoints=circle(0.3) + [0.8, 0.0, -0.4])
assert fact(notch, 'CutFeature.Loops') == fact(rest, 'CutFeature.Holes') == 0
assert abs(area(notch) + area(rest) - area(bowl)) < 1e-9
refused('press Draw Loop', 'CutFeature', BALL)
refused('has no triangles', 'CutFeature', closed_curve(rim), LoopPoints=circle(0.6))
refused('triangle', 'CutFeature', degenerate, LoopPoints=circle(0.6))
refused('not finite', 'CutFeature', BALL, LoopPoints=circle(0.6) * [1.0, numpy.nan, 1.0])

# Shape Paste Feature. What is cut from a soup stands where what is cut from a surface stands, and
# a soup is a target, too.
plain, rest = result('CutFeature', BALL, LoopPoints=circle(0.5))
base = cut_up(sphere(64))
place = dict(Seed=[0.0, 0.6, 0.8], Scale=0.9, Rotation=20.0)
wanted = result('PasteFeature', plain, base, **place)
assert edges(wanted, 'Boundary') == edges(wanted, 'NonManifold') == 0
for name, variant in VARIANTS.items():
    feature = result('CutFeature', variant, LoopPoints=circle(0.5))[0]
    found = result('PasteFeature', feature, base, **place)
    assert fact(found, 'PasteFeature.Base') == 'where it was cut', name
    assert fact(found, 'PasteFeature.EulerNumber') == 2, name
    assert fact(found, 'PasteFeature.NonManifold') == edges(found, 'NonManifold') == (
        1 if name == 'fin' else 0), name
    assert edges(found, 'Boundary') == (2 if name == 'fin' else 0), name
    assert (fact(found, 'PasteFeature.WeldedPoints') > 0) == name.startswith('soup'), name
    off = differences(points(wanted), points(found)).max()
    assert off < (1e-6 if name.startswith('soup') else 0.1), (name, off)
for name, variant in (('soup', soup(base, 1e-10)), ('degenerate', with_degenerate(base))):
    found = result('PasteFeature', plain, variant, **place)
    assert edges(found, 'Boundary') == edges(found, 'NonManifold') == 0, name
    assert fact(found, 'PasteFeature.EulerNumber') == 2, name
    if name == 'soup':
        assert differences(points(wanted), points(found)).max() < 1e-6, name
assert differences(points(wanted), points(result('PasteFeature', plain, with_fin(base, AXES['x']), **place))).max() < 1e-6
# Polygons keep their data on every piece.
found = result('PasteFeature', result('CutFeature', QUADS, LoopPoints=circle(0.5))[0], QUADS, **place)
part = vtk_to_numpy(found.GetCellData().GetArray('Part'))
numbers = vtk_to_numpy(found.GetCellData().GetArray('Number'))[part == 0]
middles = points(found)[triangles(found)[part == 0]].mean(axis=1)
whole = numpy.array([points(QUADS)[vtk_to_numpy(
    QUADS.GetPolys().GetConnectivityArray())[first:end]].mean(axis=0) for first, end in zip(
        *(vtk_to_numpy(QUADS.GetPolys().GetOffsetsArray())[ends] for ends in (
            slice(None, -1), slice(1, None))))])
assert numpy.linalg.norm(whole[numbers] - middles, axis=1).max() < 0.1
# Near a rim it is set down, and the rim stays; over it, it is refused, with a scale at which it fits.
low = cut_up(sphere(64, height=0.05))
found = result('PasteFeature', plain, low, Seed=[0.7, 0.0, 0.714], Scale=0.9)
assert differences(points(low)[points(low)[:, 2] < 0.1], points(found)).max() == 0
assert fact(found, 'PasteFeature.EulerNumber') == 1 and edges(found, 'Boundary') == 64
for seed, scale in (([0.95, 0.0, 0.3], 1.0), ([0.0, 0.0, 1.0], 9.0)):
    message = refused('the feature does not fit', 'PasteFeature', plain, low, Seed=seed, Scale=scale)
    offered = float(re.search(r'lower Scale to ([0-9.e+-]+)', message).group(1))
    assert 0 < offered < scale
    found = result('PasteFeature', plain, low, Seed=seed, Scale=offered)
    assert edges(found, 'Boundary') == 64 and edges(found, 'NonManifold') == 0
    refused('the feature does not fit', 'PasteFeature', plain, low, Seed=seed, Scale=1.1 * offered)
# A closed feature has no loop; of a belt's two loops one is joined, by index, and the other is open.
refused('has no open loop', 'PasteFeature', BALL, base)
belt = result('CutFeature', BALL, both, FillHole=False)[0]
covered = []
for index in (0, 1):
    found = result('PasteFeature', belt, base, Seed=AXES['z'], Scale=0.5, LoopIndex=index)
    assert edges(found, 'NonManifold') == 0 and fact(found, 'PasteFeature.EulerNumber') == 1
    part = vtk_to_numpy(found.GetCellData().GetArray('Part'))
    covered.append(base.GetNumberOfCells() - (part == 0).sum())
    assert abs(rim_length(found) / numpy.pi - numpy.sin((0.7, 1.4)[index])) < 0.3
# The longest is the first.
assert covered[0] > 1.2 * covered[1], covered
refused('Loop Index is 2, but the Feature has 2', 'PasteFeature', belt, base, LoopIndex=2)
# Two bowls that touch at a point of their rims: one of the two loops there is joined, the other is open.
bowl = cut_up(sphere(24, height=0.3))
outer = points(bowl)[numpy.hypot(points(bowl)[:, 0], points(bowl)[:, 1]).argmax()]
mirrored = points(bowl) * [-1.0, -1.0, 0.8] + [2 * outer[0], 2 * outer[1], 0.2 * outer[2]]
numbers = numpy.arange(len(mirrored)) + len(mirrored)
numbers[numpy.linalg.norm(mirrored - outer, axis=1).argmin()] = numpy.linalg.norm(
    points(bowl) - outer, axis=1).argmin()
touching = surface(numpy.vstack([points(bowl), mirrored]), triangles(bowl).tolist()
                   + numbers[triangles(bowl)].tolist())
for index in (0, 1):
    found = result('PasteFeature', touching, base, Seed=AXES['z'], Scale=0.3, LoopIndex=index)
    assert fact(found, 'PasteFeature.NonManifold') == 1
    assert edges(found, 'NonManifold') == 0 and edges(found, 'Boundary') == 24
    assert fact(found, 'PasteFeature.EulerNumber') == 2
# What is made from an input is kept while it stays, and made anew when it changes.
ground, loop = copy(base), circle(0.5)
cutting = new('CutFeature', [ground], LoopPoints=loop)
pasting = new('PasteFeature', [plain, ground], **place)
for factor in (1.0, 2.0, 1.0):
    shapetesting.set_points(ground, factor * points(base))
    for algorithm, fresh in ((cutting, new('CutFeature', [copy(ground)], LoopPoints=loop)),
                             (pasting, new('PasteFeature', [plain, copy(ground)], **place))):
        assert not shapetesting.run(algorithm) and not shapetesting.run(fresh)
        for port in range(algorithm.GetNumberOfOutputPorts() - 1):  # without the facts
            found, wanted = (each.GetOutputDataObject(port) for each in (algorithm, fresh))
            assert (points(found) == points(wanted)).all(), (algorithm.GetClassName(), factor)
            assert (triangles(found) == triangles(wanted)).all()
print('surfaces of every kind are deformed, laid out, cut and pasted')
