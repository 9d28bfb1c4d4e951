"""A picture of the layers of a front: how it slices a bunny, its arrival times, and the weights of one
point."""
import numpy
from paraview import simple

import composition_common as common
import scenes  # noqa: F401  # knows where shapetesting.py is

from composition_common import deform, handle
from composition_front import arrivals
from composition_rows import Row
from scenes import add_array, array, copy, points
from shapetesting import closed_curve, triangles

GREEN, RED = [0.10, 0.62, 0.25], [0.85, 0.12, 0.10]


def fall(x, radius):
    """f of equation 7."""
    return numpy.maximum(1.0 - (x / radius) ** 2, 0.0) ** 3


def links_of(faces):
    return numpy.unique(numpy.sort(numpy.concatenate(
        [faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)


def upwind_weights(surface, times, point):
    """Equations 4 and 6 to 9 for one point, k = 2, r_u = 2.1 mean edges: the inverse distance alone, and
    the product of all. The largest weight is 1."""
    places, faces = points(surface), triangles(surface)
    links = links_of(faces)
    lengths = numpy.linalg.norm(places[links[:, 0]] - places[links[:, 1]], axis=1)
    nearest = lengths[(links == point).any(axis=1)].min()
    corners = places[faces]
    area = numpy.zeros(len(places))
    numpy.add.at(area, faces, 0.5 * numpy.linalg.norm(numpy.cross(
        corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)[:, None])
    # As in Shape Deform, the mean over the surface, not over the edges.
    edge = numpy.average(lengths, weights=area[links].sum(axis=1))
    inverse = 1.0 / (((places - places[point]) ** 2).sum(axis=1) / edge ** 2 + 1e-6)
    late = times[point] - times
    weights = numpy.where(late > 0.0, fall(late, 2.1 * edge) * (1.0 - fall(late, nearest)) * area * inverse, 0.0)
    inverse[point] = 0.0
    return inverse / inverse.max(), weights / weights.max(), edge


def coloured(row, panel, surface, values, name, view, colours, steps=256):
    shown = copy(surface)
    add_array(shown, values, name)
    display = row.show(panel, shown, *view, smooth=60.0)
    row.Picture.colour(display, 'POINTS', name, 0.0, 1.0, steps=steps)
    table = simple.GetColorTransferFunction(name)
    table.ColorSpace = 'Lab'
    table.RGBPoints = [value for share, colour in colours for value in (share, *colour)]


def decades(weights, count=4.0):
    """From 0 to 1: the last decades below the largest weight, which is 1."""
    return numpy.clip(1.0 + numpy.log10(numpy.maximum(weights, 1e-300)) / count, 0.0, 1.0)


PALE = [0.88, 0.89, 0.90]


def fig5(folder, claims):
    """The bunny above its base."""
    bunny = common.model('bunny00')
    loop = common.section(bunny, [-0.05, -0.44, 0.0], [0.0, 1.0, 0.0])
    feature = common.cut(bunny, loop, Side=1, FillHole=False)[0]
    ids, places = common.rim(feature)
    front = deform(feature, handle(places, places))
    times = array(front, 'ArrivalTime').astype(float)
    mine, _ = arrivals(points(feature), triangles(feature), ids)
    # Written out, the front starts at the points of the loop; the filter's, between them, too.
    off = numpy.abs(mine - times).max()
    longest = numpy.linalg.norm(places - numpy.roll(places, 1, axis=0), axis=1).max()
    claims.check(5, 'arrival times, and those of Dijkstra written out, apart, of the longest edge of the loop',
                 '%.2f' % (off / longest), off <= longest, '<= 1')
    # A point high on the side, and the layer before it.
    wanted = 0.45 * times.max()
    at_time = numpy.abs(times - wanted) < 0.02 * times.max()
    point = numpy.flatnonzero(at_time)[points(feature)[at_time][:, 2].argmax()]
    inverse, weights, edge = upwind_weights(feature, times, point)
    late = times[point] - times
    layer = (late > 0.0) & (late < 2.1 * edge)
    links = links_of(triangles(feature))
    ends = numpy.sort(late[links], axis=1)
    claims.note(5, 'edges that leap over the layer, of those that end behind it', '%d of %d' % (
        ((ends[:, 0] <= 0.0) & (ends[:, 1] >= 2.1 * edge)).sum(), ((ends[:, 0] <= 0.0) & (ends[:, 1] > 0.0)).sum()))
    inside = weights[layer].sum() / weights.sum()
    claims.check(5, 'share of the weights in the layer', '%.4f' % inside, inside > 0.9999, '1')
    claims.note(5, 'points in the layer; weights above a hundredth of the largest', '%d; %d' % (
        layer.sum(), (weights > 0.01).sum()))
    row = Row(4, height=1.0)
    view = ([-0.02, -0.02, 0.0], 1.3, [0.25, 0.12, 1.0], [0.0, 1.0, 0.0])
    # (a) Layers of one radius; red is the layer before that of the point.
    number = numpy.floor(times / (2.1 * edge)).astype(int)
    own = number[point]
    bands = numpy.where(number == own, 0.7, numpy.where(number == own - 1, 1.0, numpy.where(number % 2 == 0, 0.0, 0.3)))
    coloured(row, 0, feature, bands, 'Layer', view, ((0.0, PALE), (0.2, PALE), (0.25, [0.62, 0.68, 0.74]),
                                                     (0.4, [0.62, 0.68, 0.74]), (0.6, GREEN), (0.8, GREEN),
                                                     (0.9, RED), (1.0, RED)))
    row.caption(0, 'layers of the front', 15)
    coloured(row, 1, feature, times / times.max(), 'Arrival', view,
             [(k / 8.0, [0.15 + 0.8 * k / 8.0, 0.35 + 0.45 * k / 8.0, 0.75 - 0.55 * k / 8.0]) for k in range(9)], 24)
    row.caption(1, 'arrival times', 15)
    warm = ((0.0, PALE), (0.3, [0.98, 0.80, 0.45]), (1.0, RED))
    coloured(row, 2, feature, decades(inverse), 'Inverse', view, warm)
    row.caption(2, 'weights of the inverse distance (eq. 4)', 15)
    near = (points(feature)[point], 0.35, *view[2:])
    coloured(row, 3, feature, decades(weights), 'Upwind', near, warm)
    row.caption(3, 'upwind weights of the point (eq. 9), near it', 15)
    for panel in range(4):
        row.dots(panel, points(feature)[point], near if panel == 3 else view, 0.012, GREEN)
    row.tube(0, closed_curve(places), *view)
    row.footnote('green ball: the point; weights over four decades. The times are those of Shape Deform.')
    row.save(folder, 5)
