"""A picture of holes filled: by deformations with other parameters, and by other methods."""
import numpy
from paraview import simple

import composition_common as common
import panels
import scenes  # knows where off.py is

import off
from composition_rows import Row
from scenes import add_array, array, copy, fact, points
from shapetesting import triangles

DEFORMATION, FAIR, MEMBRANE = 1, 2, 3  # of FillMethod


def filled(surface, options):
    """Where an option is a direction, of three numbers."""
    algorithm = scenes.shapemap.vtkShapeFillHoles()
    algorithm.SetInputDataObject(0, surface)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(*(value if isinstance(value, tuple) else (value,)))
    return copy(scenes.checked(algorithm).GetOutputDataObject(0))


def parts_of(surface):
    """What was there, and the fill."""
    fill = scenes.vtk_to_numpy(surface.GetCellData().GetArray('Filled')) == 1
    parts = []
    for chosen in (~fill, fill):
        used, corners = numpy.unique(triangles(surface)[chosen], return_inverse=True)
        parts.append(off.surface(points(surface)[used], corners.reshape(-1, 3).tolist()))
    return parts


def show_fill(row, panel, surface, view):
    for part, colour in zip(parts_of(surface), (panels.STEEL, common.FEATURE)):
        row.show(panel, part, *view, colour, smooth=60.0)


def show_reflection(row, panel, surface, view, count=9):
    """Stripes as a polished surface would reflect them."""
    toward = numpy.asarray(view[2], float) / numpy.linalg.norm(view[2])
    normals = array(common.with_normals(surface), 'Normals').astype(float)
    mirrored = 2.0 * (normals @ toward)[:, None] * normals - toward
    shown = copy(surface)
    add_array(shown, mirrored @ numpy.asarray(view[3], float), 'Reflection')
    display = row.show(panel, shown, *view, smooth=60.0)
    row.Picture.colour(display, 'POINTS', 'Reflection', -1.0, 1.0)
    table = simple.GetColorTransferFunction('Reflection')
    table.ColorSpace = 'RGB'
    table.RGBPoints = [value for k in range(count)
                       for share, tone in ((0.0, 0.93), (0.47, 0.93), (0.53, 0.3), (0.97, 0.3))
                       for value in ((k + share) / (0.5 * count) - 1.0, tone, tone, tone + 0.03)]
    table.NumberOfTableValues = 2048


def distance(data, surface):
    """Of its points from the surface."""
    return numpy.abs(scenes.boundary_distance(data, surface, Signed=0))


def fig13(folder, claims):
    bear = common.model('bear')
    body = common.cut(bear, common.section(bear, [0.0, 0.42, 0.0], [0.0, 1.0, 0.0]),
                      FillHole=False)[1]
    count, size = body.GetNumberOfPoints(), common.diagonal(bear)
    row = Row(4, 2, height=0.9)
    view = ([0.0, 0.34, 0.0], 1.35, [0.3, 0.25, 1.0], [0.0, 1.0, 0.0])
    variations = (('membrane', dict(FillMethod=MEMBRANE)),
                  ('deformed disk', dict(FillMethod=DEFORMATION)),
                  ('rigidity 0.5', dict(FillMethod=DEFORMATION, Rigidity=0.5)),
                  ('scale 0.6', dict(FillMethod=DEFORMATION, Scale=0.6)),
                  ('scale far away 1.8', dict(FillMethod=DEFORMATION, InnerScale=1.8)),
                  ('frames biased upwards', dict(FillMethod=DEFORMATION, BiasFrame=(0.0, 1.0, 0.0),
                                                 BiasWeight=0.4)),
                  ('upwind radius 8, scale far away 0.4',
                   dict(FillMethod=DEFORMATION, UpwindRadius=8.0, InnerScale=0.4)),
                  ('fair surface', dict(FillMethod=FAIR)))
    fills, heights, sound = {}, {}, 0
    for panel, (text, options) in enumerate(variations):
        result = fills[text] = filled(body, options)
        heights[text] = points(parts_of(result)[1])[:, 1].max() - 0.42
        if panel < 6:
            show_fill(row, panel, result, view)
            row.caption(panel, '%s: %.2f high' % (text, heights[text]), 14)
        claims.note(13, text, '%.2f high, normals at the loop off by %.1f degrees, %d crossings' % (
            heights[text], fact(result, 'FillHoles.NormalDeviationAfter'),
            fact(result, 'FillHoles.SelfIntersections')))
        if common.watertight(result) and (points(result)[:count] == points(body)).all():
            sound += 1
    disk, fair = fills['deformed disk'], fills['fair surface']
    apart = numpy.sqrt((distance(parts_of(disk)[1], parts_of(fair)[1]) ** 2).mean()) / size
    show_reflection(row, 6, disk, view)
    row.caption(6, 'deformed disk, as polished', 14)
    show_reflection(row, 7, fair, view)
    row.caption(7, 'fair surface, as polished', 14)
    row.footnote('both are %.1f %% of the diagonal apart (root mean square)' % (100.0 * apart))
    claims.check(13, 'fills that are watertight and leave the surface as it was', '%d of %d' %
                 (sound, len(variations)), sound == len(variations), 'all')
    claims.check(13, 'deformed disk and fair surface apart, RMS, of the diagonal',
                 '%.2f %%' % (100.0 * apart), apart < 0.01, '< 1 %')
    for text, most in (('deformed disk', 5.0), ('fair surface', 3.0)):
        angle = fact(fills[text], 'FillHoles.NormalDeviationAfter')
        claims.check(13, text + ': normals at the loop', '%.1f degrees' % angle, angle < most,
                     '< %g degrees' % most)
    claims.check(13, 'fair surface: crossings', '%d' % fact(fair, 'FillHoles.SelfIntersections'),
                 fact(fair, 'FillHoles.SelfIntersections') == 0, '0')
    claims.check(13, 'height at scale 0.6, 1 and 1.8 far away', '%.2f, %.2f, %.2f' % tuple(
        heights[text] for text in ('scale 0.6', 'deformed disk', 'scale far away 1.8')),
                 heights['scale 0.6'] < heights['deformed disk'] < heights['scale far away 1.8'],
                 'grows')
    row.save(folder, 13)
