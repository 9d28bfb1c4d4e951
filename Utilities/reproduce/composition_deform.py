"""Pictures of deformations by a boundary loop: a bunny on a cylinder, and what the parameters do to a
mushroom."""
import numpy

import composition_common as common
import panels
import scenes  # knows where off.py is

import off
from composition_common import deform, handle, stretch
from composition_rows import Row, redden
from scenes import add_array, array, copy, points

REDNESS = 'the loop (blue) is bent over a cylinder; red: edges 40 % longer or shorter, grey: as they were'
UPWIND, RELATIVE = 'upwind front', 'boundary-relative (eq. 5)'


def revolved(profile, around):
    """The surface of revolution about y of a profile (radius and height) that ends on the axis;
    its first `around` points are the open rim."""
    turns = 2.0 * numpy.pi * numpy.arange(around) / around
    rings = [numpy.column_stack([r * numpy.sin(turns), numpy.full(around, y), r * numpy.cos(turns)])
             for r, y in profile[:-1]]
    places = numpy.concatenate(rings + [[[0.0, profile[-1][1], 0.0]]])
    faces = []
    for row in range(len(rings) - 1):
        for i in range(around):
            a, b = row * around + i, row * around + (i + 1) % around
            faces += [[a, b, b + around], [a, b + around, a + around]]
    last = (len(rings) - 1) * around
    faces += [[last + i, last + (i + 1) % around, len(places) - 1] for i in range(around)]
    return off.surface(places, faces)


def even(profile, spacing):
    """The polyline with points at equal distances."""
    profile = numpy.asarray(profile, float)
    along = numpy.append(0.0, numpy.linalg.norm(numpy.diff(profile, axis=0), axis=1).cumsum())
    wanted = numpy.linspace(0.0, along[-1], int(round(along[-1] / spacing)) + 1)
    return numpy.column_stack([numpy.interp(wanted, along, profile[:, k]) for k in (0, 1)])


def on_cylinder(places, radius, height, about='z'):
    """Places laid on a cylinder along z (or x), whose top is at this height, and the turns there."""
    if about == 'x':
        swap = numpy.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
        moved, turns = on_cylinder(places @ swap.T, radius, height)
        return moved @ swap, swap.T @ turns @ swap
    angles = places[:, 0] / radius
    moved = numpy.array(places)
    out = radius + places[:, 1] - height
    moved[:, 0], moved[:, 1] = out * numpy.sin(angles), height - radius + out * numpy.cos(angles)
    cosines, sines, nothing = numpy.cos(angles), numpy.sin(angles), 0.0 * angles
    turns = numpy.array([[cosines, sines, nothing], [-sines, cosines, nothing],
                         [nothing, nothing, 1.0 + nothing]]).transpose(2, 0, 1)
    return moved, turns


def bent_handle(surface, radius, about='z'):
    """A surface's rim, with its normals, bent over a cylinder."""
    ids, places = common.rim(surface)
    normals = array(common.with_normals(surface), 'Normals').astype(float)[ids]
    moved, turns = on_cylinder(places, radius, places[:, 1].mean(), about)
    return handle(places, moved, normals, numpy.einsum('ijk,ik->ij', turns, normals))


def show_stretch(row, panel, before, after, *view, high=0.4, **options):
    """The surface, red where its edges became longer or shorter."""
    shown = copy(after)
    add_array(shown, stretch(before, after), 'Stretch')
    display = row.show(panel, shown, *view, **options)
    redden(row, display, 'Stretch', high)
    return display


def spread(places):
    """The root mean square distance from their middle."""
    return numpy.sqrt(((places - places.mean(axis=0)) ** 2).sum(axis=1).mean())


def fig4(folder, claims):
    bunny = common.model('bunny00')
    loop = common.section(bunny, [-0.05, -0.44, 0.0], [0.0, 1.0, 0.0])
    feature = common.cut(bunny, loop, Side=1, FillHole=False)[0]
    curve = bent_handle(feature, 0.30)
    base = curve.GetPoints().GetBounds()[3]
    results = {UPWIND: deform(feature, curve, Multiresolution=common.OFF),
               RELATIVE: deform(feature, curve, Method=common.BOUNDARY_RELATIVE)}
    row = Row(3, height=1.0)
    view = ([-0.02, -0.06, 0.0], 1.42, [0.25, 0.12, 1.0], [0.0, 1.0, 0.0])
    row.show(0, feature, *view, panels.STEEL)
    row.tube(0, at_source(curve), *view)
    row.caption(0, 'the loop at its base')
    ear = points(feature)[:, 1].argmax()
    height = points(feature)[ear, 1] - base
    heights, sizes = {}, {}
    far = points(feature)[:, 1] > base + 0.6 * height
    for panel, name in ((1, RELATIVE), (2, UPWIND)):
        shown = results[name]
        show_stretch(row, panel, feature, shown, *view)
        row.tube(panel, curve, *view)
        heights[name] = (points(shown)[ear, 1] - base) / height
        longer = stretch(feature, shown)
        sizes[name] = longer[far].mean()
        row.caption(panel, '%s: height %.0f %%' % (name, 100.0 * heights[name]))
        claims.note(4, '%s: height of the ears, of the original' % name, '%.1f %%' %
                    (100.0 * heights[name]))
        claims.note(4, '%s: edges longer or shorter, all, those of head and ears' % name,
                    '%.1f %%, %.1f %%' % (100.0 * longer.mean(), 100.0 * sizes[name]))
    claims.check(4, 'upwind front keeps the height', '%.1f %%' % (100.0 * heights[UPWIND]),
                 abs(heights[UPWIND] - 1.0) < 0.15, 'within 15 %')
    claims.check(4, 'boundary-relative squashes', '%.1f %%' % (100.0 * heights[RELATIVE]),
                 heights[RELATIVE] < 0.85 * heights[UPWIND], '< 0.85 of upwind front')
    claims.check(4, 'upwind front keeps head and ears', '%.1f %%, not %.1f %%' % (
        100.0 * sizes[UPWIND], 100.0 * sizes[RELATIVE]), sizes[UPWIND] < 0.3 * sizes[RELATIVE],
                 '< 0.3 of boundary-relative')
    row.footnote(REDNESS)
    row.save(folder, 4)


def at_source(curve):
    return common.at(curve, array(curve, 'SourcePosition'))


def mushroom(spacing=0.055, around=72):
    """A stem with a cap, open below."""
    profile = [(0.42, 0.0), (0.40, 0.25), (0.37, 0.5), (0.36, 0.8), (0.38, 1.0), (0.5, 1.06),
               (0.8, 1.06), (1.0, 1.04), (1.10, 1.08), (1.13, 1.15), (1.10, 1.25)]
    turns = numpy.linspace(0.1, 0.5 * numpy.pi, 40)
    profile += [(1.11 * numpy.cos(t), 1.18 + 0.7 * numpy.sin(t)) for t in turns]
    return revolved(even(profile, spacing), around)


def fig7(folder, claims):
    shape = mushroom()
    places = points(shape)
    add_array(shape, numpy.where(places[:, 1] > 0.8, 4.0, 0.8), 'Painted')
    curve = bent_handle(shape, 0.34, 'x')
    variations = [('as it was', None),
                  ('bent, rigidity 1', {}),
                  ('rigidity 3', dict(Rigidity=3.0)),
                  ('rigidity 0.7', dict(Rigidity=0.7)),
                  ('0.7 at the loop, 5.6 far away',
                   dict(Rigidity=0.7, RigidityBy=1, RigidityContrast=8.0)),
                  ('0.7 where flat, 5.6 where curved',
                   dict(Rigidity=0.7, RigidityBy=2, RigidityContrast=0.125)),
                  ('painted: stem 0.8, cap 4', dict(RigidityArray='Painted')),
                  ('scale far away 0.6', dict(InnerScale=0.6)),
                  ('upwind radius 12 edges, not 2.1', dict(UpwindRadius=12.0)),
                  ('frames biased to the right', dict(BiasFrame=(0.0, 0.0, -1.0), BiasWeight=0.2))]
    row = Row(5, 2, height=1.0)
    view = ([0.0, 0.72, 0.0], 2.85, [0.9, 0.25, 0.45], [0.0, 1.0, 0.0])
    cap, sizes = places[:, 1] > 1.0, {}
    for panel, (text, options) in enumerate(variations):
        if options is None:
            row.show(panel, shape, *view, panels.STEEL, smooth=60.0)
            row.tube(panel, at_source(curve), *view)
        else:
            bent = deform_with(shape, curve, options)
            show_stretch(row, panel, shape, bent, *view, smooth=60.0)
            row.tube(panel, curve, *view)
            size = spread(points(bent)[cap]) / spread(places[cap])
            height = numpy.ptp(points(bent)[:, 1]) / numpy.ptp(places[:, 1])
            shear = numpy.median(stretch(shape, bent)[cap])
            sizes[text] = size, height, shear
            claims.note(7, text, 'cap %.0f %%, height %.0f %%, stretch of the cap %.3f' %
                        (100.0 * size, 100.0 * height, shear))
        row.caption(panel, text, 14)
    stiff, usual, soft, distance, curvature, painted, scaled, wide, biased = sizes.values()
    stiff, usual = usual, stiff
    claims.check(7, 'stretch of the cap at rigidity 3, 1, 0.7', '%.4f, %.4f, %.4f' %
                 (stiff[2], usual[2], soft[2]), stiff[2] < usual[2] < soft[2], 'grows')
    claims.check(7, 'height at rigidity 0.7', '%.0f %%' % (100.0 * soft[1]), soft[1] < usual[1],
                 'flatter than at 1')
    for text, values in (('distance', distance), ('curvature', curvature), ('painting', painted)):
        claims.check(7, 'stretch of the cap, rigidity by ' + text, '%.4f' % values[2],
                     values[2] < 0.25 * soft[2], '< a quarter of 0.7 everywhere')
    claims.check(7, 'size of the cap, scale far away 0.6', '%.2f' % scaled[0], scaled[0] < 0.9,
                 '< 0.9')
    claims.check(7, 'height, upwind radius 12', '%.0f %%' % (100.0 * wide[1]), wide[1] < usual[1],
                 'drawn to the loop')
    row.footnote(REDNESS)
    row.save(folder, 7)


def deform_with(shape, boundary, options):
    """Where an option is a direction, of three numbers."""
    algorithm = scenes.shapemap.vtkShapeDeform()
    algorithm.SetInputDataObject(0, shape)
    algorithm.SetInputDataObject(1, boundary)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(*(value if isinstance(value, tuple) else (value,)))
    return copy(scenes.checked(algorithm).GetOutputDataObject(0))
