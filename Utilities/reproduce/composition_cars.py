"""A picture of cars: parts of a scanned body dragged along it, the cut-outs of headlights set into the
panels of another car, and body moulding. All cars are made here."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk

import composition_common as common
import scenes  # knows where off.py is

import off
from composition_common import cut, facing
from composition_creatures import HORN, limb
from composition_rows import Row
from scenes import fact

PAINT, GLASS, RUBBER, LAMP, MOULDING = range(5)
FRONT, SILL = -1.0, 0.3  # the direction of x to the nose, and the height of the sill
LOW_CAR = dict(roof=1.22, hood=0.86, width=0.92)


class Body:
    """The outside of a car, 4.2 long: a position for x from nose to tail, and t from the right sill
    (0) over the centre line (0.5) to the left one (1)."""

    def __init__(self, roof=1.42, hood=0.92, width=0.86):
        rough = numpy.array([(0.0, 0.62), (0.12, 0.72), (0.25, hood - 0.12), (1.15, hood),
                             (1.85, roof - 0.03), (2.3, roof), (2.9, roof - 0.04), (3.5, hood + 0.06),
                             (4.0, hood + 0.02), (4.12, hood - 0.15), (4.2, 0.6)])
        self.X = numpy.linspace(0.0, 4.2, 400)
        heights = numpy.interp(self.X, rough[:, 0], rough[:, 1])
        kernel = numpy.hanning(31) / numpy.hanning(31).sum()
        self.Heights = numpy.convolve(numpy.pad(heights, 15, mode='edge'), kernel, mode='valid')
        self.Widths = width * (1.0 - 0.2 * numpy.abs(self.X / 2.1 - 1.0) ** 3)
        self.Belt = hood + 0.02

    def at(self, x, t):
        x, angle = numpy.broadcast_arrays(numpy.asarray(x, float), numpy.pi * numpy.asarray(t, float))
        height, width = (numpy.interp(x, self.X, values) for values in (self.Heights, self.Widths))
        cosine, sine = numpy.cos(angle), numpy.clip(numpy.sin(angle), 0.0, 1.0)
        z = SILL + (height - SILL) * sine ** 0.6
        # Windows lean inwards.
        narrow = 1.0 - 0.5 * numpy.clip(z - self.Belt, 0.0, None)
        return numpy.stack([x, width * narrow * numpy.sign(cosine) * numpy.abs(cosine) ** 0.6, z], axis=-1)

    def normal(self, x, t, step=1e-4):
        across = numpy.cross(self.at(x, t + step) - self.at(x, t - step),
                             self.at(x + step, t) - self.at(x - step, t))
        return across / numpy.linalg.norm(across, axis=-1, keepdims=True)


def grid_triangles(rows, columns):
    a = (numpy.arange(rows - 1)[:, None] * columns + numpy.arange(columns - 1)).ravel()
    return numpy.concatenate([numpy.column_stack([a, a + 1, a + columns + 1]),
                              numpy.column_stack([a, a + columns + 1, a + columns])])


def kinds(surface, kind):
    """The surface with what its cells are made of."""
    return common.with_cell_value(surface, 'Kind', kind)


def panel(body, x, t, kind, arch=None, lamps=()):
    """A sheet of the body with its own points, its edges bent inwards. `arch` is a wheel that is left
    out; in each of `lamps`, a centre and a radius, lies a bucket below a lens: there its edge has
    three triangles."""
    spacing = 0.03 if lamps else 0.045
    wide = numpy.linalg.norm(numpy.diff(body.at(numpy.mean(x), numpy.linspace(*t, 60)), axis=0), axis=1).sum()
    rows, columns = (max(3, int(round(length / spacing)) + 1) for length in (x[1] - x[0], wide))
    u, v = numpy.meshgrid(numpy.linspace(*x, rows), numpy.linspace(*t, columns), indexing='ij')
    u, v = u.ravel(), v.ravel()
    places, normals = body.at(u, v), body.normal(u, v)
    faces = grid_triangles(rows, columns)
    if arch is not None:
        offsets = (places - arch[0]) * [1.0, 0.0, 1.0]
        away = numpy.linalg.norm(offsets, axis=1)
        near = numpy.abs(away - arch[1]) < 0.5 * spacing
        places[near] += offsets[near] * (arch[1] / away[near] - 1.0)[:, None]
        faces = faces[(numpy.where(near, arch[1], away)[faces] >= arch[1]).all(axis=1)]
    row, column = numpy.divmod(numpy.arange(rows * columns), columns)
    edge = (row == 0) | (row == rows - 1) | (column == 0) | (column == columns - 1)
    places = places - 0.012 * edge[:, None] * normals
    parts, covered = [], numpy.zeros(len(faces), bool)
    for centre, radius in lamps:
        offsets = places - centre
        away = numpy.linalg.norm(offsets, axis=1)
        near = numpy.abs(away - radius) < 0.5 * spacing
        places[near] = centre + offsets[near] * (radius / away[near])[:, None]
        away[near] = radius
        inside = (away[faces] <= radius).all(axis=1)
        covered |= inside
        depth = numpy.sqrt(numpy.clip(1.0 - (away / radius) ** 2, 0.0, None))
        parts += [(faces[inside], factor * radius * depth, lamp)
                  for factor, lamp in ((-0.7, GLASS), (0.4, LAMP))]
    points_of, cells, materials = [places], [faces[~covered]], [numpy.full((~covered).sum(), kind)]
    for inner, heights, lamp in parts:
        used = numpy.unique(inner)
        number = numpy.arange(len(places))
        moved = used[heights[used] != 0.0]
        number[moved] = sum(map(len, points_of)) + numpy.arange(len(moved))
        points_of.append(places[moved] + heights[moved, None] * normals[moved])
        cells.append(number[inner])
        materials.append(numpy.full(len(inner), lamp))
    surface = off.surface(numpy.concatenate(points_of), numpy.concatenate(cells).tolist())
    values = numpy_to_vtk(numpy.concatenate(materials).astype(numpy.int32), deep=True)
    values.SetName('Kind')
    surface.GetCellData().AddArray(values)
    return surface


def wheel(x, y, radius=0.3):
    """A tyre, and the disk in it."""
    turns, around = numpy.linspace(0.0, 2.0 * numpy.pi, 41), numpy.linspace(0.0, 2.0 * numpy.pi, 13)
    a, b = [values.ravel() for values in numpy.meshgrid(turns, around, indexing='ij')]
    out = radius - 0.09 + 0.09 * numpy.cos(b)
    tyre = numpy.column_stack([x + out * numpy.cos(a), y + 0.09 * numpy.sin(b), 0.31 + out * numpy.sin(a)])
    rim = numpy.column_stack([x + 0.2 * numpy.cos(turns[:-1]), numpy.full(40, y), 0.31 + 0.2 * numpy.sin(turns[:-1])])
    disk = [[40, i, (i + 1) % 40] for i in range(40)]
    return [kinds(off.surface(tyre, grid_triangles(41, 13).tolist()), RUBBER),
            kinds(off.surface(numpy.concatenate([rim, [[x, y, 0.31]]]), disk), PAINT)]


GAP = 0.005


def grille(body, x):
    """What closes the nose or the tail."""
    section = body.at(x, numpy.linspace(0.02, 0.98, 41))
    centre = numpy.array([[x, 0.0, section[:, 2].mean()]])
    return kinds(off.surface(numpy.concatenate([section, centre]),
                             [[i, i + 1, 41] for i in range(40)] + [[40, 0, 41]]), GLASS)



def panels_of(body, lamps=()):
    """The car as a soup: panels that share no point, with gaps of GAP between them."""
    sheets = []

    def add(x0, x1, t0, t1, kind=PAINT, **options):
        gap = 0.5 * GAP
        sheets.append(panel(body, (x0 + gap, x1 - gap), (t0, t1), kind, **options))

    for mirror in (False, True):
        def side(x0, x1, t0, t1, *rest, **options):
            # The gap along the body, as a share of the section's length.
            t0, t1 = t0 + (0.0008 if t0 > 0.0 else 0.0), t1 - 0.0008
            add(x0, x1, *((1.0 - t1, 1.0 - t0) if mirror else (t0, t1)), *rest, **options)

        y = numpy.sign(0.5 - mirror) * 0.8
        side(0.2, 1.15, 0.0, 0.26, arch=(numpy.array([0.75, y, 0.31]), 0.33))
        side(1.15, 2.05, 0.0, 0.12)
        side(2.05, 2.95, 0.0, 0.12)
        side(1.15, 2.05, 0.12, 0.28, GLASS)
        side(2.05, 2.95, 0.12, 0.28, GLASS)
        side(2.95, 4.0, 0.0, 0.26, arch=(numpy.array([3.35, y, 0.31]), 0.33))
        sheets.extend(wheel(0.75, y) + wheel(3.35, y))
    for x0, x1, t0, t1, kind in ((0.0, 0.2, 0.0, 1.0, PAINT), (0.2, 1.15, 0.26, 0.74, PAINT),
                                 (1.15, 1.83, 0.28, 0.72, GLASS), (1.83, 2.9, 0.28, 0.72, PAINT),
                                 (2.9, 3.5, 0.28, 0.72, GLASS), (3.5, 4.0, 0.26, 0.74, PAINT),
                                 (4.0, 4.2, 0.0, 1.0, PAINT)):
        add(x0, x1, t0 + 0.0008, t1 - 0.0008, kind, lamps=lamps if (x0, kind) == (0.2, PAINT) else ())
    sheets += [grille(body, x) for x in (0.0, 4.2)]
    return scenes.append(*sheets)


def bump(body, x, t, radius, height, flat=2.0):
    """How high a round bump lifts positions."""
    centre = body.at(x, t)
    return lambda places: height * numpy.clip(
        1.0 - (numpy.linalg.norm(places - centre, axis=-1) / radius) ** flat, 0.0, None) ** 2


SCOOP, POD = (0.7, 0.5), (0.42, 0.36)


def scanned(body, random, rows=170, columns=120):
    """A closed body of one sheet, with the noise of a scan: an air scoop on the hood, and a round
    headlight on each side of it."""
    u, v = numpy.meshgrid(numpy.linspace(0.0, 4.2, rows), numpy.linspace(0.0, 1.0, columns), indexing='ij')
    places, normals = body.at(u, v), body.normal(numpy.clip(u, 0.01, 4.19), numpy.clip(v, 0.01, 0.99))
    lift = bump(body, *SCOOP, 0.24, 0.13, 4.0)(places)
    for t in (POD[1], 1.0 - POD[1]):
        lift += bump(body, POD[0], t, 0.13, 0.07)(places)
    places = places + (lift + 0.001 * random.normal(size=u.shape))[..., None] * normals
    # The underside closes each section, and a centre each end.
    below = places[:, ::-1] * [1.0, 1.0, 0.0] + [0.0, 0.0, SILL - 0.08]
    ring = numpy.concatenate([places, below[:, 1:-1]], axis=1)
    across = ring.shape[1]
    number = numpy.arange(rows * across).reshape(rows, across)
    a, b = number[:-1], numpy.roll(number, -1, axis=1)[:-1]
    c, d = b + across, a + across
    faces = numpy.concatenate([numpy.stack(corners, axis=-1).reshape(-1, 3) for corners in ((a, b, c), (a, c, d))])
    ends = ring[[0, -1]].mean(axis=1)
    caps = [[rows * across, j, i] for i, j in zip(number[0], numpy.roll(number[0], -1))]
    caps += [[rows * across + 1, i, j] for i, j in zip(number[-1], numpy.roll(number[-1], -1))]
    return off.surface(numpy.concatenate([ring.reshape(-1, 3), ends]), faces.tolist() + caps)


COLOURS = {GLASS: [0.35, 0.45, 0.55], RUBBER: [0.20, 0.20, 0.22], LAMP: [0.93, 0.93, 0.80],
           MOULDING: [0.93, 0.80, 0.70]}


def show_car(row, panel_index, surface, view, paint):
    kind = scenes.vtk_to_numpy(surface.GetCellData().GetArray('Kind'))
    for each in numpy.unique(kind):
        row.show(panel_index, common.cells_of(surface, kind == each), *view,
                 paint if each == PAINT else COLOURS[each], smooth=35.0)


def seam_claims(claims, name, result, edge):
    gap, share = (fact(result, 'PasteFeature.' + name) for name in ('LargestGap', 'JoinedShare'))
    claims.check(17, name + ': largest gap of the seam, over the mean edge of the loop', '%.2f' % (gap / edge),
                 gap <= edge, '<= 1')
    claims.note(17, name + ': share of the seam joined edge by edge', '%.0f %%' % (100.0 * share))
    claims.note(17, name + ': normals across the seam, median before and after', '%.1f, %.1f degrees' % tuple(
        fact(result, 'PasteFeature.Deviation' + when) for when in ('Before', 'After')))


def mean_edge(feature):
    _, loop = common.rim(feature)
    return numpy.linalg.norm(loop - numpy.roll(loop, -1, axis=0), axis=1).mean()


def variation(row, claims, view):
    """The scoop dragged to the roof, and the headlights copied to the tail."""
    body = Body()
    scan = kinds(scanned(body, numpy.random.RandomState(17)), PAINT)
    show_car(row, 0, scan, view, [0.72, 0.78, 0.84])
    row.caption(0, 'a scanned body', 14)

    def loop(x, t, radius):
        normal = body.normal(x, t)
        side = numpy.array([1.0, 0.0, 0.0]) - normal[0] * normal
        return common.outline(scan, body.at(x, t), normal, side / numpy.linalg.norm(side), radius)

    scoop, rest = cut(scan, loop(*SCOOP, 0.3))
    forward = numpy.array([FRONT, 0.0, 0.0])
    result = facing(scoop, rest, body.at(2.35, 0.5), forward, forward)
    pasted = [fact(result, 'PasteFeature.DeviationAfter')]
    for t in (POD[1], 1.0 - POD[1]):
        pod = cut(scan, loop(POD[0], t, 0.17))[0]
        result = facing(pod, without_traces(result), body.at(3.75, t), forward, -forward)
        pasted.append(fact(result, 'PasteFeature.DeviationAfter'))
    show_car(row, 1, result, view, [0.72, 0.78, 0.84])
    row.caption(1, 'its scoop dragged to the roof,\nits headlights copied to the tail', 14)
    claims.check(17, 'scanned body changed: watertight, Euler number', 'yes, %d' % common.euler(result)
                 if common.watertight(result) else 'no',
                 common.watertight(result) and common.euler(result) == 2, 'yes, 2')
    claims.check(17, 'scanned body changed: normals across the worst join, median', '%.1f degrees' %
                 max(pasted), max(pasted) < 3.0, '< 3 degrees')


def without_traces(surface):
    """Without what only the last feature stood on."""
    for name in ('OriginalPointId', 'LoopCoordinates', 'LoopNormal'):
        surface.GetPointData().RemoveArray(name)
    return surface


def fig17(folder, claims):
    row = Row(3, 2, height=0.62, foot=0.02)
    view = ([2.1, 0.0, 0.55], 4.7, [-0.75, -1.0, 0.6], [0.0, 0.0, 1.0])
    near = ([0.75, -0.35, 0.68], 1.9, [-0.9, -1.0, 1.0], [0.0, 0.0, 1.0])
    variation(row, claims, view)
    donor, other = Body(), Body(**LOW_CAR)
    centres = [donor.at(0.5, t) for t in (0.36, 0.64)]
    giver = panels_of(donor, lamps=[(centre, 0.1) for centre in centres])
    show_car(row, 2, giver, near, [0.55, 0.70, 0.50])
    soup = panels_of(other)
    lights = []
    for t, centre in zip((0.36, 0.64), centres):
        normal = donor.normal(0.5, t)
        side = numpy.array([1.0, 0.0, 0.0]) - normal[0] * normal
        loop = common.outline(giver, centre, normal, side / numpy.linalg.norm(side), 0.15)
        row.tube(2, loop, *near)
        lights.append(cut(giver, loop, FillHole=False)[0])
    row.caption(2, 'headlight cut-outs of a car\nof unconnected panels', 14)
    show_car(row, 3, soup, view, [0.80, 0.45, 0.40])
    row.caption(3, 'another car, of unconnected panels', 14)
    result, forward = soup, numpy.array([FRONT, 0.0, 0.0])
    for name, light, t in (('right', lights[0], 0.3), ('left', lights[1], 0.7)):
        result = facing(light, result, other.at(0.45, t), forward, forward, BridgeGaps=True)
        seam_claims(claims, 'headlight set in, ' + name, result, mean_edge(light))
        result = without_traces(result)
    show_car(row, 4, result, near, [0.80, 0.45, 0.40])
    row.caption(4, 'the cut-outs set in\nacross the gaps of its hood', 14)
    horn = kinds(limb(0, 'triceratops', HORN, 2.2, 2), MOULDING)
    for name, t in (('right', 0.42), ('left', 0.58)):
        result = facing(horn, result, other.at(0.9, t), numpy.array([1.0, 0.5, 0.0]),
                        numpy.array([-1.0, 0.0, 0.6]), Scale=0.25, BridgeGaps=True)
        seam_claims(claims, 'moulding, ' + name, result, 0.25 * mean_edge(horn))
        result = without_traces(result)
    show_car(row, 5, result, view, [0.80, 0.45, 0.40])
    row.caption(5, 'some non-traditional body moulding', 14)
    row.save(folder, 17)
