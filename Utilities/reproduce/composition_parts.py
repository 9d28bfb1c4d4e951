"""Pictures of deformations in parts: over a coarse base beside the full solution, on a bunny and a
tube, and bumps that follow one after the other."""
import time

import numpy

import composition_common as common
import panels
import scenes  # knows where off.py is

import off
from composition_common import deform, handle, stretch
from composition_deform import at_source, bent_handle, on_cylinder
from composition_rows import Row
from scenes import add_array, copy, fact, points


class Timed:
    """Shape Deform of a shape whose boundary moves: its result, and the CPU seconds of the first run and
    the least of those with the boundary elsewhere."""

    def __init__(self, shape, curve, **options):
        algorithm = scenes.shapemap.vtkShapeDeform()
        algorithm.SetInputDataObject(0, shape)
        for option, value in options.items():
            getattr(algorithm, 'Set' + option)(value)
        seconds = []
        moved = common.at(curve, points(curve) + [0.0, 0.01 * common.diagonal(shape), 0.0])
        for boundary in 5 * (moved, curve):
            algorithm.SetInputDataObject(1, boundary)
            begin = time.process_time()
            scenes.checked(algorithm)
            seconds.append(time.process_time() - begin)
        self.Result = copy(algorithm.GetOutputDataObject(0))
        self.First, self.Again = seconds[0], min(seconds[1:])


def tube(around=60, along=180):
    """A tube along y, open at both ends."""
    turns = 2.0 * numpy.pi * numpy.arange(around) / around
    places = numpy.concatenate([numpy.column_stack([
        numpy.cos(turns), numpy.full(around, 2.0 * numpy.pi / around * row), numpy.sin(turns)])
        for row in range(along)])
    faces = []
    for row in range(along - 1):
        for i in range(around):
            a, b = row * around + i, row * around + (i + 1) % around
            faces += [[a, b + around, b], [a, a + around, b + around]]
    return off.surface(0.25 * places, faces)


def fig8(folder, claims):
    """Once by the coarse base and once in full."""
    bunny = common.coarser(common.model('bunny00'), 13300)
    loop = common.section(bunny, [-0.05, -0.44, 0.0], [0.0, 1.0, 0.0])
    bunny = common.cut(bunny, loop, Side=1, FillHole=False)[0]
    bar = tube()
    lower = points(bar)[:60]
    normals = lower / numpy.linalg.norm(lower, axis=1)[:, None]
    bent, turns = on_cylinder(lower, 0.2, 0.0)
    turned = common.turn([1.0, 0.0, 0.0], -25.0)
    row = Row(3, 2, height=0.75, foot=0.02)
    for first, name, shape, curve, view in (
            (0, 'bunny', bunny, bent_handle(bunny, 0.30),
             ([-0.02, -0.06, 0.0], 1.75, [0.25, 0.12, 1.0], [0.0, 1.0, 0.0])),
            (3, 'tube', bar, handle(lower, bent @ turned.T, normals,
                                    numpy.einsum('ijk,ik->ij', turns, normals) @ turned.T),
             ([0.0, 2.25, -0.25], 5.3, [1.0, -0.35, 0.4], [0.0, 0.0, 1.0]))):
        size = common.diagonal(shape)
        coarse = Timed(shape, curve, Multiresolution=common.ON)
        full = Timed(shape, curve, Multiresolution=common.OFF)
        miss = numpy.linalg.norm(points(coarse.Result) - points(full.Result), axis=1) / size
        base = int(fact(coarse.Result, 'Deform.BasePoints'))
        count = shape.GetNumberOfPoints()
        row.show(first, shape, *view, panels.STEEL, smooth=60.0)
        row.tube(first, at_source(curve), *view)
        for panel, each in ((first + 1, coarse), (first + 2, full)):
            row.show(panel, each.Result, *view, panels.STEEL, smooth=60.0)
            row.tube(panel, curve, *view)
        row.caption(first, '%s of %d points' % (name, count), 15)
        row.caption(first + 1, 'over %d points: %.0f ms' % (base, 1000.0 * coarse.Again), 15)
        row.caption(first + 2, 'in full: %.0f ms' % (1000.0 * full.Again), 15)
        rms = numpy.sqrt((miss ** 2).mean())
        claims.note(8, '%s: points, of the base' % name, '%d, %d' % (count, base))
        claims.note(8, '%s: ms for the first time and again, over the base' % name, '%.0f, %.1f' %
                    (1000.0 * coarse.First, 1000.0 * coarse.Again))
        claims.note(8, '%s: ms for the first time and again, in full' % name, '%.0f, %.1f' %
                    (1000.0 * full.First, 1000.0 * full.Again))
        claims.check(8, '%s: distance of both, RMS and largest, of the diagonal' % name,
                     '%.2f %%, %.2f %%' % (100.0 * rms, 100.0 * miss.max()), rms < 0.03,
                     'RMS < 3 %')
        claims.check(8, '%s: seconds again, over the base, of those in full' % name, '%.2f' % (
            coarse.Again / full.Again), coarse.Again < 1.2 * full.Again, '< 1.2')
    row.save(folder, 8)


def fig9(folder, claims):
    """Two bumps, close to each other, on a sheet whose border is bent."""
    count, deep = 141, 85
    u, v = [a.ravel() for a in numpy.meshgrid(numpy.linspace(-1.0, 1.0, count),
                                              numpy.linspace(-0.6, 0.6, deep))]
    number = numpy.zeros(len(u), numpy.int32)
    height = numpy.zeros(len(u))
    for index, x in enumerate((-0.27, 0.27)):
        share = ((u - x) ** 2 + v ** 2) / 0.25 ** 2
        height += numpy.maximum(0.0, 1.0 - share ** 1.5) ** 2
        number[share < 0.95] = index + 1
    a = (numpy.arange(deep - 1)[:, None] * count + numpy.arange(count - 1)).ravel()
    faces = numpy.concatenate([numpy.column_stack([a, a + 1, a + count + 1]),
                               numpy.column_stack([a, a + count + 1, a + count])])
    sheet = off.surface(numpy.column_stack([u, height, -v]), faces.tolist())
    add_array(sheet, number, 'Segment')
    places = points(sheet)
    ids, loop = common.rim(sheet)
    moved, turns = on_cylinder(loop, 0.75, 0.0)
    up = numpy.tile([0.0, 1.0, 0.0], (len(ids), 1))
    curve = handle(loop, moved, up, turns[:, :, 1])
    row = Row(3, height=0.75, foot=0.02)
    view = ([0.0, 0.3, 0.0], 2.9, [0.1, 0.45, 1.0], [0.0, 1.0, 0.0])
    tops = [numpy.where(number == n, places[:, 1], -1.0).argmax() for n in (1, 2)]
    opening, widths = {}, {}
    options = dict(Multiresolution=common.OFF)
    for panel, (text, result) in enumerate((
            ('bumps on a sheet', sheet), ('bent at once', deform(sheet, curve, **options)),
            ('one segment after the other', deform(sheet, curve, SegmentArray='Segment', **options)))):
        row.show(panel, result, *view, panels.STEEL, smooth=60.0)
        row.tube(panel, curve if panel else at_source(curve), *view, width=0.004)
        now = points(result)
        axes = [now[top] - now[number == n].mean(axis=0) for n, top in ((1, tops[0]), (2, tops[1]))]
        cosine = axes[0] @ axes[1] / numpy.linalg.norm(axes[0]) / numpy.linalg.norm(axes[1])
        opening[text] = numpy.degrees(numpy.arccos(min(1.0, cosine)))
        widths[text] = numpy.median(stretch(sheet, result)[number > 0])
        row.caption(panel, text if panel == 0 else '%s: tops %.0f degrees apart' %
                    (text, opening[text]), 15)
        claims.note(9, text, 'axes of the bumps %.1f degrees apart, stretch of bumps %.3f' %
                    (opening[text], widths[text]))
    claims.check(9, 'bumps open as their feet do, one after the other', '%.1f degrees, not %.1f' %
                 (opening['one segment after the other'], opening['bent at once']),
                 opening['one segment after the other'] > 1.2 * opening['bent at once'],
                 '> 1.2 times')
    row.save(folder, 9)
