"""The comparison at the end of a lecture on correspondence (Solomon, "Shape analysis", 2021, after Ezuz, Solomon
and Ben-Chen, "Reversible harmonic maps between discrete surfaces", 2019): pvpython lecture.py FOLDER [PAIR...].

A row of pictures for each pair: the target with a field on it, and the field carried to the source by the maps
of three methods from the same landmarks. It writes lecture.png, and lecture.md: what is printed under the
pictures, and what is claimed. It fails where a claim does not hold.
"""
import os
import sys

import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger

import claims
import scenes  # knows where shapetesting.py is

from composition_rows import Row
from scenes import array, copy, fact, points
from shapetesting import triangles
from volume_models import plain

LANDMARKS = 12
# Method of Shape Correspondence.
METHODS = (('hyperbolic orbifold', 6), ('weighted averages', 7), ('reversible harmonic', 0))
FRONT = [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]  # from where figures are seen, and up
BEAR = [0.3, 0.2, 1.0], [0.0, 1.0, 0.0]


def figures():
    """Two figures, of different build and in different poses, whose true map is known."""
    first, second = scenes.read('FigureA.vtp'), scenes.read('FigureB.vtp')
    return plain(first), plain(second), array(first, 'TargetPosition').astype(float), FRONT


def bears():
    """Two models of bears. Nobody knows the true map; landmarks are partners in a map found without any."""
    first, second = scenes.model('bear'), scenes.model('bear_bis')
    found = scenes.output_of('Correspondence', first, second)
    return first, second, array(found, 'TargetPosition').astype(float), BEAR


PAIRS = {'figures': (figures, True), 'bears': (bears, False)}


def spread(surface, count):
    """Indices of points far from each other along the surface."""
    areas = numpy.zeros(surface.GetNumberOfPoints())
    chosen = [int(points(surface)[:, 2].argmax())]
    nearest = numpy.full(len(areas), numpy.inf)
    while len(chosen) < count:
        distances = array(scenes.output_of(
            'GeodesicDistance', surface, scenes.point_set(points(surface)[chosen[-1:]])), 'GeodesicDistance')
        nearest = numpy.minimum(nearest, distances)
        chosen.append(int(nearest.argmax()))
    return chosen


def measured(source, target, truth, chosen, number, known):
    """The map of a method: the source with it, and what is said of it; its error if the truth is known."""
    landmarks = scenes.with_array(
        scenes.point_set(points(source)[chosen]), truth[chosen], 'TargetPosition')
    algorithm = scenes.filter_of('Correspondence', source, target, landmarks, Method=number)
    there, back = (copy(algorithm.GetOutputDataObject(port)) for port in (0, 1))
    quality = scenes.filter_of('MapQuality', there).GetOutputDataObject(0)
    error = 1000.0 * fact(scenes.output_of('MapErrorCurve', there, back, scenes.with_array(
        source, truth, 'TargetPosition')), 'MapErrorCurve.Mean') if known else None
    distortion = scenes.vtk_to_numpy(quality.GetCellData().GetArray('ConformalDistortion'))
    sides = points(source)[triangles(source)]
    areas = 0.5 * numpy.linalg.norm(numpy.cross(
        sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1)
    # A median by area: the mean would be that of the few triangles whose image has no area.
    order = distortion.argsort()
    middle = order[numpy.searchsorted(areas[order].cumsum(), 0.5 * areas.sum())]
    misses = numpy.linalg.norm(array(there, 'TargetPosition')[chosen] - truth[chosen], axis=1)
    return there, dict(
        error=error, distortion=distortion[middle],
        trip=1000.0 * fact(there, 'Correspondence.RoundTrip'), reversed=fact(there, 'Correspondence.ReversedArea'),
        landmark=misses.max() / scenes.longest_side(points(target)))


def field_on(surface, place):
    """The distance from a place along the surface, as a share of its largest."""
    values = array(scenes.output_of(
        'GeodesicDistance', surface, scenes.point_set([place])), 'GeodesicDistance')
    return scenes.with_array(surface, values / values.max(), 'Field')


def draw(row, line, name, pair, view, results):
    source, target, truth, chosen = pair
    field = field_on(target, truth[chosen[0]])
    shapes = [('target', field, truth[chosen], None)]
    for (method, _), (there, figure) in zip(METHODS, results):
        shapes.append((method, scenes.output_of('TransferFields', there, field, Direction=0),
                       points(source)[chosen], figure))
    for column, (title, data, marks, figure) in enumerate(shapes):
        panel = line * row.Columns + column
        low, high = (numpy.array(data.GetBounds())[k::2] for k in (0, 1))
        seen = 0.5 * (low + high), 1.1 * (high - low).max(), *view
        display = row.show(panel, data, *seen, smooth=60.0)
        row.Picture.colour(display, 'POINTS', 'Field', 0.0, 1.0, steps=24)
        row.dots(panel, marks, seen, 0.012, [0.0, 0.0, 0.0])
        words = name if figure is None else 'conformal distortion %.2f, round trip %.1f' % (
            figure['distortion'], figure['trip'])
        if figure and PAIRS[name][1]:
            words = 'error %.1f, ' % figure['error'] + words
        row.caption(panel, title + '\n' + words, 14)


def check(collected, name, results, seconds):
    known = PAIRS[name][1]
    of = {method: figure for (method, _), (_, figure) in zip(METHODS, results)}
    for method, figure in of.items():
        if known:
            collected.note(name + ', ' + method, 'mean error, 1/1000 of the root of the area', '%.1f' % figure['error'])
        collected.note(name + ', ' + method, 'conformal distortion, median', '%.3f' % figure['distortion'])
        collected.note(name + ', ' + method, 'round trip, 1/1000 of the root of the area', '%.2f' % figure['trip'])
        collected.note(name + ', ' + method, 'share of the area that is turned over', '%.4f' % figure['reversed'])
        collected.note(name + ', ' + method, 'seconds', '%.1f' % seconds[method])
        collected.at_most(name + ', ' + method, "landmarks' largest error, parts of the longest side", figure['landmark'], 1e-6)
    ours = of['reversible harmonic']
    for method, figure in of.items():
        if figure is not ours and known:
            collected.check(name + ', reversible harmonic', 'mean error, of that of ' + method,
                            '%.2f' % (ours['error'] / figure['error']), ours['error'] < figure['error'], 'less than 1')
    orbifold = of['hyperbolic orbifold']
    collected.check(name + ', hyperbolic orbifold', 'round trip, of that of weighted averages',
                    '%.2f' % (orbifold['trip'] / of['weighted averages']['trip']),
                    orbifold['trip'] < of['weighted averages']['trip'], 'less than 1')


def main(folder, *names):
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)
    collected = claims.Claims()
    names = names or tuple(PAIRS)
    row = Row(len(METHODS) + 1, len(names), height=1.05, foot=0.16, pixels=1800)
    for line, name in enumerate(names):
        source, target, truth, view = PAIRS[name][0]()
        chosen = spread(source, LANDMARKS)
        # A landmark is a point of each surface.
        truth[chosen] = points(target)[[
            numpy.linalg.norm(points(target) - place, axis=1).argmin() for place in truth[chosen]]]
        results, seconds = [], {}
        for method, number in METHODS:
            begin = sum(os.times()[:4])
            results.append(measured(source, target, truth, chosen, number, PAIRS[name][1]))
            seconds[method] = sum(os.times()[:4]) - begin
            scenes.say('%s: %s' % (name, method))
        check(collected, name, results, seconds)
        draw(row, line, name, (source, target, truth, chosen), view, results)
    row.footnote('The same %d landmarks (black) for each method. Errors and round trips are means, in 1/1000 of the '
                 'root of the area; conformal distortion is a median, and 1 at best.' % LANDMARKS, 15)
    row.Picture.save(os.path.join(folder, 'lecture.png'),
                     (0.5 * (row.Columns - 1), 0.5 * (row.Height - row.High)), row.High)
    collected.write(os.path.join(folder, 'lecture.md'))
    collected.finish()


if __name__ == '__main__':
    main(*sys.argv[1:])
