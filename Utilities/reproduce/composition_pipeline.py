"""A picture of how a hole is filled, step by step: a planar disc, its deformation, a membrane, its map to
the plane, and the deformation of that with the normals as they are, and optimised."""
import numpy

import composition_common as common
import panels
import scenes  # knows where off.py is

import off
from composition_common import cut, deform, handle
from composition_fills import DEFORMATION, MEMBRANE, distance, filled, parts_of, show_reflection
from composition_front import sheet
from composition_poisson import angle_weighted
from composition_rows import Row
from scenes import at, fact, points
from shapetesting import closed_curve, triangles


def on_circle(loop):
    """The circle with the edge lengths of a closed curve, at z = 0, counter-clockwise."""
    lengths = numpy.linalg.norm(numpy.roll(loop, -1, axis=0) - loop, axis=1)
    low, high = 0.5 * lengths.max(), lengths.sum()
    for _ in range(100):  # halves the interval until it has no digits left
        radius = 0.5 * (low + high)
        turned = 2.0 * numpy.arcsin(numpy.minimum(1.0, 0.5 * lengths / radius)).sum()
        low, high = (radius, high) if turned > 2.0 * numpy.pi else (low, radius)
    angles = numpy.append(0.0, 2.0 * numpy.arcsin(numpy.minimum(1.0, 0.5 * lengths / radius)).cumsum()[:-1])
    return radius * numpy.column_stack([numpy.cos(angles), numpy.sin(angles), 0.0 * angles])


def disc(outline):
    """Triangles in a convex outline: its points first, then those of a triangular grid."""
    edge = numpy.linalg.norm(outline - numpy.roll(outline, 1, axis=0), axis=1).mean()
    radius = numpy.linalg.norm(outline, axis=1).min()
    count = int(radius / edge) + 2
    i, j = [numbers.ravel() for numbers in numpy.mgrid[-2 * count:2 * count + 1, -2 * count:2 * count + 1]]
    inner = edge * numpy.column_stack([i + 0.5 * j, numpy.sqrt(0.75) * j, 0.0 * i])
    inner = inner[numpy.linalg.norm(inner, axis=1) < radius - 0.6 * edge]
    surface = sheet(numpy.concatenate([outline, inner]))
    # All counter-clockwise.
    corners = points(surface)[triangles(surface)]
    area = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2]
    faces = numpy.where(area[:, None] > 0.0, triangles(surface), triangles(surface)[:, ::-1])
    return off.surface(points(surface), faces.tolist())


def longest_edges_stretch(before, after):
    """The 99th percentile of how much edges change, as a factor."""
    return numpy.exp(numpy.percentile(common.stretch(before, after), 99))


def angles_between(one, two):
    return numpy.degrees(numpy.arccos(numpy.clip((one * two).sum(axis=1), -1.0, 1.0)))


def rows_of(surface, places):
    """The numbers of the points of a surface at these positions."""
    return numpy.linalg.norm(points(surface)[None] - places[:, None], axis=2).argmin(axis=1)


def needles(places, directions, length):
    """A line at each position."""
    both = numpy.concatenate([places, places + length * directions])
    lines = off.surface(both, [])
    lines.SetLines(off.surface(both, [[i, i + len(places)] for i in range(len(places))]).GetPolys())
    return lines


def fig12(folder, claims):
    bunny = common.model('bunny00')
    turns = 2.0 * numpy.pi * numpy.arange(48) / 48
    loop = common.outline(bunny, numpy.array([0.12, -0.15, 0.0]), [0.0, 0.0, 1.0], [0.0, 1.0, 0.0],
                          0.19 * (1.0 + 0.4 * numpy.cos(2.0 * turns)), 48)
    body = cut(bunny, loop, FillHole=False)[1]
    body = off.surface(points(body), triangles(body).tolist())
    ids = numpy.array(common.longest_loop(triangles(body)))[::-1]  # the fill runs against the body
    hole = points(body)[ids]
    wanted = angle_weighted(points(body), triangles(body))[ids]
    up = numpy.tile([0.0, 0.0, 1.0], (len(ids), 1))
    fills, size = {}, common.diagonal(bunny)
    # (a, b) The disc, and the disc deformed to the hole.
    flat = disc(on_circle(hole))
    fills['disc'] = deform(flat, handle(points(flat)[:len(ids)], hole, up, wanted), Multiresolution=common.OFF)
    # (c, d) The membrane, and its map to the plane.
    membrane = parts_of(filled(body, dict(FillMethod=MEMBRANE)))[1]
    layout = scenes.output_of('Parameterize', membrane, port=1, Domain=2)
    layout = off.surface(points(layout), triangles(membrane).tolist())
    corners = points(layout)[triangles(layout)]
    if numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2].sum() < 0.0:
        layout = at(layout, points(layout) * [-1.0, 1.0, 1.0])
    # (e, f) That map deformed to the hole, with the normals of the hole as they are.
    rim = rows_of(membrane, hole)
    fills['map'] = deform(layout, handle(points(layout)[rim], hole, up, wanted), Multiresolution=common.OFF)
    whole = {name: filled(body, dict(FillMethod=DEFORMATION, OptimizeNormals=on))
             for name, on in (('as they are', False), ('optimised', True))}
    for name, result in whole.items():
        fills[name] = parts_of(result)[1]
    apart = numpy.sqrt((distance(fills['map'], fills['as they are']) ** 2).mean()) / size
    claims.check(12, 'steps by Parameterize and Deform, and Fill Holes, RMS apart, of the diagonal',
                 '%.2f %%' % (100.0 * apart), apart < 0.005, '< 0.5 %')
    normals, angles = {}, {}
    for name in ('disc', 'as they are', 'optimised'):
        rows = rows_of(fills[name], hole)
        normals[name] = angle_weighted(points(fills[name]), triangles(fills[name]))[rows]
        angles[name] = angles_between(normals[name], wanted)
        claims.note(12, {'disc': 'planar disc deformed'}.get(name, 'normals ' + name) +
                    ': normals at the loop off, mean and 95 %', '%.1f, %.1f degrees' % (
                        angles[name].mean(), numpy.percentile(angles[name], 95)))
    stretches = {name: longest_edges_stretch(before, fills[name])
                 for name, before in (('disc', flat), ('map', layout))}
    claims.check(12, 'edges longer or shorter, 99 %: planar disc, conformal map of the membrane',
                 '%.2f, %.2f times' % (stretches['disc'], stretches['map']),
                 stretches['map'] < stretches['disc'], 'the map less')
    claims.check(12, 'optimised normals at the loop, of those as they are', '%.2f times' % (
        angles['optimised'].mean() / angles['as they are'].mean()),
                 angles['optimised'].mean() < 0.5 * angles['as they are'].mean(), '< 0.5')
    deviation = fact(whole['optimised'], 'FillHoles.NormalDeviationAfter')
    claims.check(12, 'normals at the loop after optimisation, mean', '%.1f degrees' % deviation,
                 deviation < 5.0, '< 5 degrees')
    row = Row(4, 2, height=0.95)
    view = (hole.mean(axis=0), 0.85, [0.25, 0.3, 1.0], [0.0, 1.0, 0.0])

    def planar(panel, surface, count, text):
        places = points(surface)
        frame = (0.5 * (places.min(axis=0) + places.max(axis=0)), 1.25 * numpy.ptp(places, axis=0).max(),
                 [0.0, 0.0, 1.0], [0.0, 1.0, 0.0])
        display = row.show(panel, surface, *frame, common.FEATURE, representation='Surface With Edges', width=0.3)
        display.EdgeColor, display.Ambient = [0.45, 0.30, 0.20], 0.4
        row.tube(panel, closed_curve(places[count]), *frame, width=0.004)
        row.caption(panel, text, 14)

    def patched(panel, fill, text):
        row.show(panel, body, *view, panels.STEEL, smooth=60.0)
        row.show(panel, fill, *view, common.FEATURE, smooth=60.0)
        row.caption(panel, text, 14)

    planar(0, flat, numpy.arange(len(ids)), 'the loop as a circle, with its\nedge lengths, and a grid')
    patched(1, fills['disc'], 'this disc deformed: edges\nchange by a factor of %.1f' % stretches['disc'])
    patched(2, membrane, 'a membrane')
    planar(3, layout, rim, 'its conformal map: edges then\nchange by a factor of %.1f' % stretches['map'])
    patched(4, fills['as they are'], 'deformed: far points pull, normals\nat the loop off by %.0f degrees' %
            angles['as they are'].mean())
    show_reflection(row, 5, whole['as they are'], view)
    row.caption(5, 'the same, as polished', 14)
    patched(6, fills['optimised'], 'frames turned at each point:\nnormals off by %.1f degrees' %
            angles['optimised'].mean())
    for name, colour in (('as they are', panels.RED), ('optimised', panels.GREEN)):
        lines = needles(hole[::3], normals[name][::3], 0.07)
        for panel in (4, 6) if name == 'as they are' else (6,):
            row.show(panel, lines, *view, colour, representation='Wireframe', width=2.0)
    show_reflection(row, 7, whole['optimised'], view)
    row.caption(7, 'the same, as polished', 14)
    row.footnote('lines: normals of the fill at the loop, red before and green after their optimisation', 14)
    row.save(folder, 12)
