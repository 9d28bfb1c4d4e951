"""Pictures of creatures: parts of several models pasted on another one, and a head swapped on a loop
that is bent far outwards."""
import numpy
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter

import composition_common as common
import panels
import scenes  # knows where off.py is

from composition_common import cut, facing, seed_of, stretch
from composition_rows import Row, redden
from scenes import add_array, array, fact, points
from shapetesting import triangles

COLOURS = ([0.93, 0.80, 0.70], [0.95, 0.62, 0.36], [0.45, 0.66, 0.80], [0.58, 0.74, 0.45])


def origin(surface, number):
    """The surface with the number of its model on its cells."""
    return common.with_cell_value(surface, 'Model', number)


def part(number, name, place, normal, **options):
    """The smaller part of a model beyond a plane, and the rest, filled."""
    surface = origin(common.model(name), number)
    return cut(surface, common.section(surface, place, normal), **options)


def limb(number, name, tip, distance, finer=0):
    """What is nearer than `distance` to a model's point nearest to `tip`, so far that a little of what
    it grows on belongs to it, too; of the model so many times subdivided."""
    surface = common.model(name)
    if finer:
        algorithm = vtkLoopSubdivisionFilter()
        algorithm.SetInputData(surface)
        algorithm.SetNumberOfSubdivisions(finer)
        algorithm.Update()
        surface = algorithm.GetOutput()
    places = points(surface)
    tip = places[numpy.linalg.norm(places - tip, axis=1).argmin()]
    surface = origin(surface, number)
    return cut(surface, common.ring(surface, tip, distance))[0]


class Creature:
    """A body that features are pasted on, one after the other."""

    def __init__(self, body):
        self.Body, self.Pasted = body, []

    def add(self, feature, seed, side, wanted, **options):
        self.Body = facing(feature, self.Body, seed, numpy.array(side), numpy.array(wanted), **options)
        self.Pasted.append([fact(self.Body, 'PasteFeature.' + name) for name in (
            'DeviationBefore', 'DeviationAfter', 'Deviation95After')])
        # What the last feature stood on is no property of the creature.
        for name in ('OriginalPointId', 'LoopCoordinates', 'LoopNormal'):
            self.Body.GetPointData().RemoveArray(name)

    def worst(self):
        """The greatest of its joins' deviations: before, after, 95th percentile."""
        return numpy.max(self.Pasted, axis=0)


HORN = [7.4, 2.69, -0.53]


def horned_bunny():
    creature = Creature(origin(common.model('bunny00'), 0))
    horn = limb(1, 'triceratops', HORN, 2.2, 2)
    tail = limb(2, 'diplodocus', [-0.5, -0.3, 0.0], 0.3)
    creature.add(horn, [-0.36, 0.27, 0.25], [1.0, 0.5, 0.0], [-0.7, 1.0, 0.7], Scale=0.17)
    creature.add(tail, [0.47, -0.33, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], Scale=1.8)
    return creature


def six_legged_camel():
    head, body = part(0, 'camel', [0.0, 0.27, 0.3], [0.0, 0.8, 0.6])
    cow = part(2, 'cow', [0.255, 0.235, 0.0], [1.0, 0.6, 0.0])[0]
    creature = Creature(body)
    creature.add(cow, seed_of(head), [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], Scale=1.0)
    for x in (-0.08, 0.08):
        leg = limb(1, 'camel', [0.6 * x, -0.49, 0.06], 0.57)
        creature.add(leg, [x, -0.05, -0.2], [0.0, -0.2, 1.0], [0.0, 0.0, 1.0], Scale=1.0)
    return creature


def horned_bear():
    head, body = part(0, 'bear', [0.0, 0.3, 0.0], [0.0, 1.0, 0.0])
    camel = part(1, 'camel', [0.0, 0.3, 0.33], [0.0, 1.0, -0.5])[0]
    horn = limb(2, 'triceratops', HORN, 2.35, 2)
    creature = Creature(body)
    creature.add(camel, seed_of(head), [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], Scale=5.0)
    creature.add(horn, [0.0, 1.3, 0.4], [1.0, 0.5, 0.0], [0.0, 0.5, 0.7], Scale=0.25)
    return creature


def three_headed_bunny():
    head = part(1, 'bunny00', [-0.22, 0.1, 0.05], [-1.0, 0.9, 0.0])[0]
    creature = Creature(origin(common.model('bunny00'), 0))
    for z in (1.0, -1.0):
        creature.add(head, [-0.3, -0.12, 0.05 + 0.25 * z], [-1.0, 0.0, 0.0], [-1.0, 0.3, 0.6 * z], Scale=0.7,
                     InnerScale=1.2)
    return creature


def centaur():
    torso = part(1, 'man', [-0.02, 0.0, 0.08], [0.0, 0.0, 1.0], Side=1)[0]
    head, body = part(0, 'cow', *COW)
    creature = Creature(body)
    creature.add(torso, seed_of(head), [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], Scale=0.9)
    return creature


def minotaur():
    creature = Creature(part(0, 'man', *MAN)[1])
    creature.add(part(1, 'cow', *COW)[0], [-0.02, -0.025, 0.385], [1.0, -0.3, 0.0], [0.0, -1.0, 0.0],
                 Scale=0.75, RigidityBy=1)
    return creature


MAN = [-0.02, 0.0, 0.352], [0.0, -0.35, 1.0]
COW = [0.25, 0.235, 0.0], [1.0, 0.75, 0.0]


def coloured(row, panel, surface, view):
    """Its parts in the colours of their models."""
    number = scenes.vtk_to_numpy(surface.GetCellData().GetArray('Model'))
    for index, colour in enumerate(COLOURS):
        if (number == index).any():
            row.show(panel, common.cells_of(surface, number == index), *view, colour, smooth=60.0)


def fig1(folder, claims):
    row = Row(3, 2, height=1.0, foot=0.02)
    for panel, (name, creature, view) in enumerate((
            ('bunny, with a triceratops\'s horn and a diplodocus\'s tail', horned_bunny(),
             ([0.12, 0.03, 0.0], 1.5, [-0.3, 0.2, 1.0], [0.0, 1.0, 0.0])),
            ('camel, with two more legs and a cow\'s head', six_legged_camel(),
             ([0.0, 0.0, 0.0], 1.2, [1.0, 0.15, 0.3], [0.0, 1.0, 0.0])),
            ('bear, with a camel\'s head and a triceratops\'s horn', horned_bear(),
             ([0.0, 0.5, 0.0], 2.5, [0.5, 0.2, 1.0], [0.0, 1.0, 0.0])),
            ('bunny of three heads', three_headed_bunny(),
             ([-0.05, 0.03, 0.0], 1.4, [-0.9, 0.25, 1.0], [0.0, 1.0, 0.0])),
            ('cow, with a man\'s trunk', centaur(),
             ([0.05, 0.15, 0.0], 1.45, [0.6, 0.2, 1.0], [0.0, 1.0, 0.0])),
            ('man, with a cow\'s head', minotaur(),
             ([0.0, 0.0, 0.03], 1.3, [0.5, -1.0, 0.1], [0.0, 0.0, 1.0])))):
        body = creature.Body
        coloured(row, panel, body, view)
        before, after, last = creature.worst()
        row.caption(panel, '%s:\n%d triangles, watertight' % (name, len(triangles(body))), 15)
        claims.check(1, name + ': watertight, Euler number', 'yes, %d' % common.euler(body)
                     if common.watertight(body) else 'no',
                     common.watertight(body) and common.euler(body) == 2, 'yes, 2')
        claims.check(1, name + ': normals across the worst join, median before and after',
                     '%.1f, %.1f degrees' % (before, after), after < 3.0, '< 3 degrees')
        claims.check(1, name + ': the same, 95th percentile', '%.1f degrees' % last, last < 10.0,
                     '< 10 degrees')
    row.save(folder, 1)


def similarity(places, moved):
    """The scale, rotation and shift that carry the places nearest to where they went."""
    middle, there = places.mean(axis=0), moved.mean(axis=0)
    u, values, v = numpy.linalg.svd((moved - there).T @ (places - middle))
    flip = numpy.array([1.0, 1.0, numpy.sign(numpy.linalg.det(u @ v))])
    rotation = u @ numpy.diag(flip) @ v
    scale = (values * flip).sum() / ((places - middle) ** 2).sum()
    return scale, rotation, there - scale * rotation @ middle


def fig15(folder, claims):
    """A neck's frames, which pointed outwards, point upwards on the shoulders."""
    creature, cow = minotaur(), part(1, 'cow', *COW)[0]
    result = creature.Body
    moved = points(result)[common.pasted_points(result)]
    ids, loop = common.rim(cow)
    away = numpy.linalg.norm(points(cow)[:, None] - loop[None], axis=2).min(axis=1)
    inner = away > 0.3 * away.max()
    scale, rotation, shift = similarity(points(cow)[inner], moved[inner])
    size = scale * common.diagonal(cow)
    miss = numpy.linalg.norm(scale * points(cow) @ rotation.T + shift - moved, axis=1) / size
    share = numpy.sqrt((miss[inner] ** 2).mean())
    head = common.at(cow, moved)
    normals = array(common.with_normals(cow), 'Normals').astype(float)[ids] @ rotation.T
    there = array(common.with_normals(head), 'Normals').astype(float)[ids]
    bend = numpy.degrees(numpy.arccos(numpy.clip((normals * there).sum(axis=1), -1.0, 1.0)))
    row = Row(4, 1, height=1.0)
    front = ([-0.02, -0.02, 0.35], 0.36, [0.8, -0.55, 0.1], [0.0, 0.0, 1.0])
    beside = ([0.29, 0.14, 0.0], 0.45, [0.3, 0.1, 1.0], [0.0, 1.0, 0.0])
    for panel, name, place, view in ((0, 'man', MAN, front), (1, 'cow', COW, beside)):
        surface = common.model(name)
        row.show(panel, surface, *view, panels.STEEL, smooth=60.0)
        row.tube(panel, common.section(surface, *place), *view)
        row.caption(panel, 'the ' + name, 15)
    row.show(2, result, *front, panels.STEEL, smooth=60.0)
    row.caption(2, 'the minotaur', 15)
    part_of = scenes.vtk_to_numpy(result.GetCellData().GetArray('Part'))
    row.show(3, common.cells_of(result, part_of < 2), *front, panels.STEEL, smooth=60.0)
    longer = stretch(common.at(cow, scale * points(cow)), head)
    add_array(head, longer, 'Longer')
    display = row.show(3, head, *front, smooth=60.0)
    redden(row, display, 'Longer', 0.4)
    row.caption(3, 'red: edges 40 % longer or shorter', 15)
    claims.check(15, 'watertight, Euler number', 'yes, %d' % common.euler(result),
                 common.watertight(result) and common.euler(result) == 2, 'yes, 2')
    claims.check(15, 'the loop is bent outwards by, median and 95 %', '%.0f, %.0f degrees' %
                 tuple(numpy.percentile(bend, [50, 95])), numpy.percentile(bend, 95) > 60.0,
                 '95 % > 60 degrees')
    claims.check(15, 'the head beyond 0.3 of its depth, off a similarity', '%.2f %%' %
                 (100.0 * share), share < 0.03, '< 3 % of its diagonal')
    claims.check(15, 'its edges longer or shorter there, in the mean', '%.1f %%' %
                 (100.0 * longer[inner].mean()), longer[inner].mean() < 0.05, '< 5 %')
    before, after, last = creature.worst()
    claims.check(15, 'normals across the join, median before and after', '%.1f, %.1f degrees' %
                 (before, after), after < 3.0, '< 3 degrees')
    claims.check(15, 'the same, 95th percentile', '%.1f degrees' % last, last < 10.0,
                 '< 10 degrees')
    row.footnote('the loop is bent outwards by %.0f degrees; in the face edges are %.1f %% longer or '
                 'shorter' % (numpy.percentile(bend, 95), 100.0 * longer[inner].mean()), 15)
    row.save(folder, 15)
