"""Shape Cut Feature across the gaps between panels that have no point in common, and back again by Shape Paste
Feature."""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, triangles


def soup(panels):
    """panels: positions of a grid, rows x columns x 3, counter-clockwise seen from outside."""
    data, places, faces = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    for panel in panels:
        rows, columns, _ = panel.shape
        first = places.GetNumberOfPoints()
        for place in panel.reshape(-1, 3):
            places.InsertNextPoint(place)
        for i in range(rows - 1):
            for j in range(columns - 1):
                a = first + i * columns + j
                for corners in ((a, a + 1, a + columns + 1), (a, a + columns + 1, a + columns)):
                    faces.InsertNextCell(3, corners)
    data.SetPoints(places)
    data.SetPolys(faces)
    return data


def sphere(sectors, slot, shift, spans, bump=0.0):
    """Sectors of the unit sphere, `slot` apart, shifted alternately by `shift` along the axis. Around the poles a
    cap is left out. spans: the numbers of spans along the meridians, in turn."""
    panels = []
    for k in range(sectors):
        count = spans[k % len(spans)]
        down = numpy.linspace(0.12, numpy.pi - 0.12, 2 * count + 1)[:, None]
        turn = numpy.linspace(0.0, 1.0, count + 1)[None, :]
        # A slot is as wide everywhere: its angle is larger near the poles.
        side = 0.5 * slot / numpy.sin(down)
        turn = 2 * numpy.pi * k / sectors + side + turn * (2 * numpy.pi / sectors - 2 * side)
        radius = 1.0 + bump * numpy.maximum(0.0, 1.0 - down ** 2 / 0.3) ** 2
        panels.append(numpy.stack([radius * numpy.sin(down) * numpy.cos(turn), radius * numpy.sin(down) * numpy.sin(turn),
                                   radius * numpy.cos(down) + shift * (k % 2) + 0.0 * turn], axis=2))
    return soup(panels)


def circle(down, count=40):
    turns = 2 * numpy.pi * (numpy.arange(count) + 0.5) / count
    return numpy.column_stack([numpy.sin(down) * numpy.cos(turns), numpy.sin(down) * numpy.sin(turns),
                               numpy.full(count, numpy.cos(down))])


def cutter(surface, loop, **properties):
    algorithm = shapetesting.new(shapemap.vtkShapeCutFeature, surface, **properties)
    algorithm.SetNumberOfLoopPoints(len(loop))
    for i, place in enumerate(loop):
        algorithm.SetLoopPoints(i, *place)
    return algorithm


def cut(surface, loop, **properties):
    return [copy(output) for output in shapetesting.outputs(cutter(surface, loop, **properties))[:2]]


def area(surface, chosen=slice(None)):
    corners = points(surface)[triangles(surface)[chosen]]
    return 0.5 * numpy.linalg.norm(numpy.cross(
        corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()


def mean_edge(surface):
    corners = points(surface)[triangles(surface)]
    return numpy.linalg.norm(corners - numpy.roll(corners, 1, axis=1), axis=2).mean()


def apart(one, other):
    """The largest distance of a point of one set from the other."""
    return max(numpy.linalg.norm(other - place, axis=1).min() for place in one)


def check(surface, loop, gaps, widest):
    """Cuts, and drops the feature in place. Returns both parts."""
    feature, rest = cut(surface, loop)
    assert fact(feature, 'CutFeature.GapsCrossed') == gaps, fact(feature, 'CutFeature.GapsCrossed')
    assert 0.0 < fact(feature, 'CutFeature.WidestGap') <= widest, fact(feature, 'CutFeature.WidestGap')
    filled = vtk_to_numpy(rest.GetCellData().GetArray('Filled')) > 0
    # Nothing is lost or added but the fill.
    assert abs(area(feature) + area(rest, ~filled) - area(surface)) < 1e-9 * area(surface)
    assert fact(rest, 'CutFeature.Holes') == 1 and filled.any()
    for part in (feature, rest):
        originals = array(part, 'OriginalPointId')
        assert (points(part)[originals >= 0] == points(surface)[originals[originals >= 0]]).all()
    order = array(feature, 'LoopOrder')
    assert sorted(order[order > 0]) == list(range(1, (order > 0).sum() + 1))
    assert fact(feature, 'CutFeature.ReturnsInPlace') == 1
    seed = [shapetesting.facts(feature).GetArray('CutFeature.Seed').GetComponent(0, k) for k in range(3)]
    paste = shapetesting.new(shapemap.vtkShapePasteFeature, feature, rest, Seed=seed)
    messages = shapetesting.run(paste)
    back = copy(paste.GetOutputDataObject(0))
    assert not messages, messages
    given = numpy.concatenate([points(feature), points(rest)[numpy.unique(triangles(rest)[~filled])]])
    size = numpy.ptp(points(surface), axis=0).max()
    assert apart(points(back), given) < 1e-9 * size and apart(points(surface), points(back)) < 1e-9 * size
    assert abs(area(back) - area(surface)) < 1e-9 * area(surface)
    assert shapetesting.edges(back, 'NonManifold') == 0
    return feature, rest, filled


# Sectors of a sphere, as fine as each other or not, in line or shifted: a cap.
for spans, shift in (((12,), 0.0), ((12, 7), 0.0), ((12,), 0.03), ((7, 12), 0.03)):
    ball = sphere(6, 0.04, shift, spans)
    assert 0.05 < mean_edge(ball)
    feature, rest, filled = check(ball, circle(0.8), 6, 0.04 + shift + 0.03)
    away = points(feature)
    angles = numpy.arctan2(numpy.hypot(away[:, 0], away[:, 1]), away[:, 2])
    # Chords of the circle, and the shift, are closer to it than this.
    assert angles.max() < 0.8 + 0.08
    height = 1 - numpy.cos(0.8)
    assert abs(area(feature) / (2 * numpy.pi * height) - 1) < 0.25, area(feature)
    # The fill continues the sectors.
    new = numpy.unique(triangles(rest)[filled])
    assert abs(numpy.linalg.norm(points(rest)[new], axis=1) - 1).max() < shift + 0.5 * mean_edge(ball)

# A bump moves to another place, where it gets a seam band.
bumpy = sphere(4, 0.05, 0.0, (16,), bump=0.4)
feature, rest, filled = check(bumpy, circle(0.8), 4, 0.08)
planet = shapetesting.torus(3.0, 1.5, 90, 60)
paste = shapetesting.new(shapemap.vtkShapePasteFeature, feature, planet, Seed=[4.4, 0.3, 0.2])
assert not shapetesting.run(paste)
moved = copy(paste.GetOutputDataObject(0))
part = vtk_to_numpy(moved.GetCellData().GetArray('Part'))
assert (part == 2).sum() >= feature.GetNumberOfCells() and (part == 1).any()
assert shapetesting.edges(moved, 'NonManifold') == 0 and abs(fact(moved, 'PasteFeature.DeviationAfter')) < 3.0

# Panels of a plate: a loop around the corner at which four of them meet. The loop is straight there.
x = numpy.linspace(0.0, 1.0, 9)
plate = soup([numpy.stack(numpy.broadcast_arrays(
    (1.04 * i - 1.02 + x)[None, :], (1.04 * j - 1.02 + x)[:, None], 0.0), axis=2) for i in range(2) for j in range(2)])
square = numpy.array([[0.5, 0.5, 0], [-0.5, 0.5, 0], [-0.5, -0.5, 0], [0.5, -0.5, 0]])
feature, rest, filled = check(plate, square, 4, 0.04 + 1e-9)
assert abs(area(feature) - 4 * 0.48 ** 2) < 1e-9 and abs(area(rest, filled) - 1.0) < 1e-9
# On the soup itself, turned, it has its own area, and the panels lose theirs below the loop.
paste = shapetesting.new(shapemap.vtkShapePasteFeature, feature, plate, Seed=[0.0, 0.0, 0.0], Rotation=45.0, Scale=0.8,
                         BridgeGaps=True)
assert not shapetesting.run(paste)
turned = copy(paste.GetOutputDataObject(0))
part = vtk_to_numpy(turned.GetCellData().GetArray('Part'))
assert abs(area(turned, part == 2) - 0.64 * area(feature)) < 1e-3 * area(feature)
# The square of side 0.8 and the slots in it, which begin at its diagonals: the seed is the corner of a panel.
slots = 2 * 0.04 * 0.8 * numpy.sqrt(2.0) - 3 * 0.04 ** 2
assert abs(area(plate) - area(turned, part == 0) - (0.64 - slots)) < 1e-5
# A loop on one panel crosses no gap.
feature, rest = cut(plate, 0.5 * square + [0.6, 0.6, 0])
assert fact(feature, 'CutFeature.GapsCrossed') == fact(feature, 'CutFeature.WidestGap') == 0
assert feature.GetPointData().GetArray('LoopOrder') is None

# Gaps that are too wide, and panels of opposite orientation, are refused, with the remedy.
wide = sphere(4, 0.15, 0.0, (16,))
assert mean_edge(wide) < 0.15
shapetesting.check_refused(cutter(wide, circle(0.8)), 'wider than the mean edge, 0.', 'Shape Solidify')
one = numpy.stack(numpy.broadcast_arrays(x[None, :] - 1.02, x[:, None], 0.0), axis=2)
turned = soup([one, one[:, ::-1] + [1.04, 0.0, 0.0]])
around = [[-0.5, 0.2, 0], [0.5, 0.2, 0], [0.5, 0.8, 0], [-0.5, 0.8, 0]]
shapetesting.check_refused(cutter(turned, around), 'Generate Surface Normals (Consistency)')
