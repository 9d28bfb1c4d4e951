"""A picture of a point cloud repaired: the damaged ear of a scan is cut away, the hole filled, and the
points of the other ear set in its place. No step uses a polygon."""
import numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import composition_common as common
import panels
import scenes  # knows where off.py is

from composition_common import cut, facing, seed_of
from composition_rows import Row
from composition_soups import EAR, EAR_RADIUS, around_ear
from scenes import fact, points

ADDED = [0.05, 0.45, 0.75]


def cloud(surface, places):
    """Points with the normals of a surface's points."""
    held = common.at(surface, places)
    result = vtkPolyData()
    result.SetPoints(held.GetPoints())
    vertices = vtkCellArray()
    for i in range(len(places)):
        vertices.InsertNextCell(1, [i])
    result.SetVerts(vertices)
    return result


def dots(row, panel, view, positions, colour):
    """The points on this side of the head, as small balls, within the panel."""
    centre, size, direction, up = view
    toward = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(up, toward) / numpy.linalg.norm(numpy.cross(up, toward))
    away = positions - centre
    seen = (numpy.abs(away @ right) < 0.48 * size) & (positions[:, 0] > 3.0) & (
        numpy.abs(away @ numpy.cross(toward, right)) < 0.46 * size)
    if seen.any():
        row.show(panel, panels.balls(positions[seen], 0.006 * size, 8), *view, colour)


def fig14points(folder, claims):
    row = Row(4, 1, height=0.95, foot=0.02)
    head = common.model('mannequin-devil')
    random = numpy.random.RandomState(14)
    places = points(head)
    bad = (numpy.linalg.norm((places - EAR)[:, 1:], axis=1) < EAR_RADIUS) & (places[:, 0] > 6.0)
    scan = cloud(head, places + 0.4 * bad[:, None] * random.uniform(-1.0, 1.0, places.shape))
    view = (EAR, 15.0, [1.0, -0.4, 0.15], [0.0, 0.0, 1.0])
    dots(row, 0, view, points(scan), panels.STEEL)
    row.caption(0, 'a scan of %d points, with noise' % len(places), 14)
    loop = around_ear(head, 5.6)
    hole, rest = cut(scan, loop)
    new = scenes.vtk_to_numpy(rest.GetCellData().GetArray('Filled')) > 0
    dots(row, 1, view, points(rest)[~new], panels.STEEL)
    dots(row, 1, view, points(rest)[new], ADDED)
    row.caption(1, 'the ear cut away, the hole filled\nwith %d points' % new.sum(), 14)
    other = common.mirrored(head, 0)
    ear = cut(cloud(other, points(other)), around_ear(other, 6.2), KeepOriginal=True)[0]
    dots(row, 2, view, points(other), panels.STEEL)
    dots(row, 2, view, points(ear), common.FEATURE)
    row.caption(2, 'the other ear, mirrored', 14)
    result = facing(ear, rest, seed_of(hole), numpy.array([0.0, 0.0, 1.0]),
                           numpy.array([0.0, 0.0, 1.0]))
    part = scenes.vtk_to_numpy(result.GetCellData().GetArray('Part'))
    for number, colour in enumerate((panels.STEEL, ADDED, common.FEATURE)):
        dots(row, 3, view, points(result)[part == number], colour)
    row.caption(3, 'set in its place: gaps of %.2f spacings at most' % (
        fact(result, 'PasteFeature.LargestGap') / fact(result, 'PasteFeature.Spacing')), 14)
    row.save(folder, '14points')
    gap, spacing = (fact(result, 'PasteFeature.' + name) for name in ('LargestGap', 'Spacing'))
    claims.check('14 points', 'repaired: largest gap at the join', '%.3f' % gap, gap <= spacing,
                 'at most the mean spacing, %.3f' % spacing)
    miss = numpy.abs(scenes.boundary_distance(result, head, Signed=0))[part == 2]
    rms = numpy.sqrt((miss ** 2).mean()) / common.diagonal(head)
    claims.check('14 points', 'repaired: off the undamaged ear, RMS, of the diagonal',
                 '%.2f %%' % (100.0 * rms), rms < 0.01, '< 1 %')
    whole = cloud(head, places)
    feature, left = cut(whole, loop)
    back = points(common.paste(feature, left, seed_of(feature)))
    apart = max(numpy.linalg.norm(places - place, axis=1).min() for place in back)
    claims.check('14 points', 'an ear dropped in place: points off the given ones, of the diagonal',
                 '%.1e' % (apart / common.diagonal(head)), apart < 1e-12 * common.diagonal(head) and
                 len(back) == len(places), '< 1e-12')
