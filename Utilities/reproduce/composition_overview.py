"""A picture of a whole drag: a face cut from a mannequin, its hole filled, and set down on a bunny; and
one of what smoothing by the Laplacian does afterwards."""
import os

import numpy
from paraview import simple

import composition_common as common
import panels
import scenes  # knows where off.py is

from composition_common import cut, deform, seed_of, stretch
from composition_deform import bent_handle, mushroom, show_stretch
from composition_fills import show_fill
from composition_maps import checkers, patch, show_patch
from composition_rows import Row
from scenes import array, fact, points
from shapetesting import closed_curve, triangles


def border(surface, first, second):
    """The closed curve where two parts (of the array Part) of a surface meet."""
    parts = scenes.vtk_to_numpy(surface.GetCellData().GetArray('Part'))
    faces = triangles(surface)
    owners = {}
    for face, part in zip(faces[parts == second], parts[parts == second]):
        for a, b in zip(face, numpy.roll(face, -1)):
            owners[(b, a)] = part
    following = {a: b for face in faces[parts == first] for a, b in zip(face, numpy.roll(face, -1))
                 if (a, b) in owners}
    loop = [next(iter(following))]
    while following[loop[-1]] != loop[0]:
        loop.append(following[loop[-1]])
    return closed_curve(points(surface)[loop])


def fig2(folder, claims):
    head, bunny = common.model('mannequin-devil'), common.model('bunny00')
    loop = common.outline(head, numpy.array([0.0, 0.0, -0.8]), [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], 8.7)
    face, rest = cut(head, loop)
    seed, scale = [0.2, -0.05, 0.4], 0.026
    result = common.facing(face, bunny, seed, numpy.array([0.0, 0.0, 1.0]),
                           numpy.array([0.0, 1.0, 0.0]), Scale=scale)
    row = Row(4, height=1.0, foot=0.02)
    front = ([0.0, 0.0, 0.5], 42.0, [0.35, -1.0, 0.1], [0.0, 0.0, 1.0])
    side = ([0.05, 0.0, 0.0], 1.2, [0.3, 0.2, 1.0], [0.0, 1.0, 0.0])
    row.show(0, head, *front, panels.STEEL, smooth=60.0)
    row.tube(0, loop, *front)
    row.caption(0, 'a loop around the face', 15)
    show_fill(row, 1, rest, front)
    row.caption(1, 'its hole filled', 15)
    radius = 1.3 * scale * numpy.linalg.norm(array(face, 'LoopCoordinates'), axis=1).max()
    laid = patch(bunny, seed, radius)
    texture = simple.CreateTexture(checkers(os.path.join(folder, 'checkers.png')))
    show_patch(row, 2, bunny, laid, texture, side)
    row.tube(2, border(result, 2, 1), *side)
    row.caption(2, 'the loop laid on the target', 15)
    row.show(3, result, *side, panels.STEEL, smooth=60.0)
    row.caption(3, 'the face bent after it, and joined', 15)
    claims.check(2, 'watertight, Euler number', 'yes, %d' % common.euler(result),
                 common.watertight(result) and common.euler(result) == 2, 'yes, 2')
    claims.check(2, 'normals across the join, median and 95 %', '%.1f, %.1f degrees' % (
        fact(result, 'PasteFeature.DeviationAfter'), fact(result, 'PasteFeature.Deviation95After')),
                 fact(result, 'PasteFeature.DeviationAfter') < 3.0 and
                 fact(result, 'PasteFeature.Deviation95After') < 10.0, '< 3, < 10 degrees')
    claims.check(2, 'flipped triangles of the map of the target', '%d' % fact(
        laid, 'ExponentialMap.Flipped'), fact(laid, 'ExponentialMap.Flipped') == 0, '0')
    back = common.paste(face, rest, seed_of(face))
    off_place = numpy.abs(scenes.boundary_distance(back, head, Signed=0)).max()
    claims.check(2, 'dropped in place: off the original, at most, of the diagonal', '%.1e' % (
        off_place / common.diagonal(head)), off_place < 1e-6 * common.diagonal(head), '< 1e-6')
    row.save(folder, 2)


def fig16(folder, claims):
    shape = mushroom()
    curve = bent_handle(shape, 0.34, 'x')
    row = Row(3, height=1.0)
    view = ([0.0, 0.72, 0.0], 2.85, [0.9, 0.25, 0.45], [0.0, 1.0, 0.0])
    row.show(0, shape, *view, panels.STEEL, smooth=60.0)
    row.tube(0, common.at(curve, array(curve, 'SourcePosition')), *view)
    row.caption(0, 'as it was')
    worst = []
    for panel, text, smooth in ((1, 'upwind front, rigidity 3', False),
                                (2, 'and smoothed by the Laplacian', True)):
        bent = deform(shape, curve, Rigidity=3.0, LaplacianSmoothing=smooth)
        show_stretch(row, panel, shape, bent, *view, smooth=60.0)
        row.tube(panel, curve, *view)
        longer = stretch(shape, bent)
        worst.append(numpy.percentile(longer, 99))
        row.caption(panel, '%s: up to %.0f %%' % (text, 100.0 * worst[-1]))
        claims.note(16, text + ': edges longer or shorter, mean, 99 %', '%.1f %%, %.1f %%' % (
            100.0 * longer.mean(), 100.0 * worst[-1]))
    claims.check(16, 'the Laplacian spreads the distortion: 99 % against', '%.2f times' % (
        worst[1] / worst[0]), worst[1] < worst[0], '< 1')
    row.footnote('red: edges 40 % longer or shorter')
    row.save(folder, 16)
