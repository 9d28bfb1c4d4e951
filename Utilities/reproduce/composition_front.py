"""A picture of what the weights of the upwind front are for: equal arrival times that differ a
little, and points that lie closer on one side, with Shape Deform and with the equations written out
again, where each weight can be left out."""
import heapq

import numpy
from vtkmodules.vtkFiltersCore import vtkDelaunay2D

import composition_common as common
import scenes

from composition_common import deform, handle
from composition_rows import Row
from scenes import points
from shapetesting import triangles

WIDTH, LENGTH, STEP = 1.0, 1.4, 1.0 / 16.0


def sheet(places):
    """Delaunay triangles of points in the plane."""
    algorithm = vtkDelaunay2D()
    algorithm.SetInputData(scenes.point_set(places))
    algorithm.Update()
    return algorithm.GetOutput()


def grid():
    """Rows of points that the front meets at the same time."""
    across = int(round(WIDTH / STEP)) + 1
    along = int(round(LENGTH / STEP)) + 1
    row, column = numpy.divmod(numpy.arange(across * along), across)
    places = numpy.column_stack([STEP * column - 0.5 * WIDTH, STEP * row, 0.0 * row])
    a = numpy.array([r * across + c for r in range(along - 1) for c in range(across - 1)])
    faces = numpy.concatenate([numpy.column_stack([a, a + 1, a + across + 1]),
                               numpy.column_stack([a, a + across + 1, a + across])])
    return scenes.off.surface(places, faces.tolist())


def dense(random):
    """The grid, and three times as close points in a quarter of it, on one side."""
    places = points(grid())
    fine = STEP / 3.0
    x, y = numpy.meshgrid(numpy.arange(-0.5 * WIDTH, -0.1, fine), numpy.arange(0.25, 1.0, fine))
    more = numpy.column_stack([x.ravel(), y.ravel(), 0.0 * x.ravel()])
    apart = numpy.linalg.norm(more[:, None] - places[None], axis=2).min(axis=1) > 0.3 * fine
    return sheet(numpy.concatenate([places, more[apart]]))


def arch(places):
    """The lower edge bent to an arch that leans forward, and how each frame turns."""
    lower = numpy.flatnonzero(places[:, 1] < 1e-9)
    lower = lower[numpy.argsort(places[lower, 0])]
    angles = 2.2 * places[lower, 0]
    radius = WIDTH / 2.2
    target = numpy.column_stack([radius * numpy.sin(angles), 0.0 * angles,
                                 radius * (numpy.cos(angles) - 1.0)])
    turns = numpy.array([common.turn([0.0, 1.0, 0.0], numpy.degrees(a)) for a in angles])
    return lower, target, turns


def arrivals(places, faces, sources):
    """Dijkstra's distances along edges."""
    links = {}
    for face in faces:
        for a, b in zip(face, numpy.roll(face, 1)):
            length = numpy.linalg.norm(places[a] - places[b])
            links.setdefault(a, {})[b] = links.setdefault(b, {})[a] = length
    times = numpy.full(len(places), numpy.inf)
    times[sources] = 0.0
    queue = [(0.0, int(source)) for source in sources]
    while queue:
        time, node = heapq.heappop(queue)
        if time <= times[node]:
            for other, length in links[node].items():
                if time + length < times[other]:
                    times[other] = time + length
                    heapq.heappush(queue, (times[other], other))
    nearest = numpy.array([min(links[i].values()) for i in range(len(places))])
    return times, nearest


def by_the_equations(surface, ramp=True, areas=True, jitter=None):
    """Equations 4 to 9 for the arch, k = 2, r_u = 2.1 steps, as they stand: `ramp` is the second
    factor of equation 7, `areas` equation 8, and `jitter` is added to the arrival times."""
    places, faces = points(surface), triangles(surface)
    lower, target, turns = arch(places)
    times, nearest = arrivals(places, faces, lower)
    if jitter is not None:
        times = numpy.where(times > 0.0, times + jitter, 0.0)
    corners = places[faces]
    area = numpy.zeros(len(places))
    numpy.add.at(area, faces, 0.5 * numpy.linalg.norm(numpy.cross(
        corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)[:, None])
    moved, frames = numpy.array(places), numpy.tile(numpy.eye(3), (len(places), 1, 1))
    moved[lower], frames[lower] = target, turns
    reach = 2.1 * STEP

    def fall(x, radius):
        return numpy.maximum(1.0 - (x / radius) ** 2, 0.0) ** 3

    for i in numpy.argsort(times, kind='stable'):
        if times[i] == 0.0:
            continue
        late = times[i] - times
        band = numpy.flatnonzero((late > 0.0) & (late < reach))
        weights = fall(late[band], reach) / (
            ((places[band] - places[i]) ** 2).sum(axis=1) / STEP ** 2 + 1e-6)
        if ramp:
            weights = weights * (1.0 - fall(late[band], nearest[i]))
        if areas:
            weights = weights * area[band]
        weights = weights / weights.sum()
        there = moved[band] + numpy.einsum('jkl,jl->jk', frames[band], places[i] - places[band])
        moved[i] = weights @ there
        u, _, v = numpy.linalg.svd(numpy.einsum('j,jkl->kl', weights, frames[band]))
        frames[i] = u @ numpy.diag([1.0, 1.0, numpy.linalg.det(u @ v)]) @ v
    return moved


def by_the_filter(surface):
    lower, target, turns = arch(points(surface))
    curve = handle(points(surface)[lower], target, numpy.tile([0.0, 0.0, 1.0], (len(lower), 1)),
                   turns[:, :, 2], closed=False)
    return points(deform(surface, curve, Multiresolution=common.OFF))


def fig6(folder, claims):
    random = numpy.random.RandomState(6)
    regular, closer = grid(), dense(random)
    count = regular.GetNumberOfPoints()
    size = common.diagonal(regular)
    noise = random.uniform(-1.0, 1.0, count)
    # Points that are a little off their places are met a little off the times of their row.
    off_row = points(regular) + 0.02 * STEP * numpy.column_stack(
        [0.0 * noise, numpy.where(points(regular)[:, 1] > 0.0, noise, 0.0), 0.0 * noise])
    shaken = common.at(regular, off_row)
    exact, equations = by_the_filter(regular), by_the_equations(regular)
    agree = numpy.linalg.norm(exact - equations, axis=1).max() / size
    results = {'noramp': by_the_equations(regular, ramp=False, jitter=0.02 * STEP * noise),
               'ramp': by_the_equations(regular, jitter=0.02 * STEP * noise),
               'shaken': by_the_filter(shaken),
               'noarea': by_the_equations(closer, areas=False),
               'closer': by_the_filter(closer)}
    miss = {name: numpy.linalg.norm(moved[:count] - exact, axis=1).max() / size
            for name, moved in results.items()}
    claims.check(6, 'filter and equations 4-9 written out in numpy, regular grid',
                 '%.2f %%' % (100.0 * agree), agree < 0.02, 'largest distance < 2 % of the diagonal')
    claims.check(6, 'arrival times off by 2 % of a step: equations without the ramp',
                 '%.2f %%' % (100.0 * miss['noramp']), miss['noramp'] > 5.0 * miss['ramp'],
                 '> 5 times those with it')
    claims.note(6, 'the same with the ramp', '%.2f %%' % (100.0 * miss['ramp']))
    claims.check(6, 'points off their rows by 2 % of a step: filter',
                 '%.2f %%' % (100.0 * miss['shaken']), miss['shaken'] < 0.005, '< 0.5 %')
    claims.check(6, 'nine times as many points in a quarter: equations without areas',
                 '%.2f %%' % (100.0 * miss['noarea']), miss['noarea'] > 2.0 * miss['closer'],
                 '> twice the filter')
    claims.check(6, 'nine times as many points in a quarter: filter',
                 '%.2f %%' % (100.0 * miss['closer']), miss['closer'] < 0.03, '< 3 %')
    row = Row(4, 2, height=0.85)
    for panel, surface, moved, text in (
            (0, regular, points(regular), 'the sheet and its edge'),
            (1, regular, exact, 'edge bent'),
            (2, shaken, results['noramp'], 'arrival times off by 2 %%, without the\nramp of eq. 7: '
             'off by %.1f %%' % (100.0 * miss['noramp'])),
            (3, shaken, results['shaken'], 'points off their rows by 2 %%,\nShape Deform: off by '
             '%.2f %%' % (100.0 * miss['shaken'])),
            (4, closer, points(closer), 'locally denser'),
            (5, regular, exact, 'edge bent, the even sheet'),
            (6, closer, results['noarea'], 'denser, without the areas\nof eq. 8: off by %.1f %%' %
             (100.0 * miss['noarea'])),
            (7, closer, results['closer'], 'denser, Shape Deform:\noff by %.1f %%' %
             (100.0 * miss['closer']))):
        show(row, panel, surface, moved)
        row.caption(panel, text, 14)
    row.footnote('off by: the largest distance from the result of the even sheet, of its diagonal', 14)
    row.save(folder, 6)


def show(row, panel, surface, moved):
    view = ([0.0, 0.66, -0.1], 1.8, [0.45, 0.35, 1.0], [0.0, 1.0, 0.0])
    display = row.show(panel, common.at(surface, moved), *view, [0.86, 0.88, 0.90],
                       representation='Surface With Edges', width=0.5)
    display.EdgeColor, display.Ambient = [0.35, 0.40, 0.48], 0.25
    lower = moved[arch(points(surface))[0]]
    line = handle(lower, lower, closed=False)
    row.tube(panel, line, *view)
