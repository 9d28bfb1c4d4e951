"""A picture of features that are no manifolds: sheets that cross, as a soup of triangles, bent and
pasted; and a damaged ear of a scan that a copy of the other ear replaces."""
import numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter

import composition_common as common
import panels
import scenes  # knows where off.py is

import off
from composition_common import cut, facing, seed_of
from composition_deform import on_cylinder
from composition_rows import Row
from scenes import fact, points
from shapetesting import triangles

SPOKES, RINGS, SHEETS = 48, 16, 6


def weather_vane():
    """A disk on which half sheets stand that meet in its axis: six triangles at each edge there, and
    three where a sheet stands on the disk. The first points are the disk's, the last ring its rim."""
    turns = 2.0 * numpy.pi * numpy.arange(SPOKES) / SPOKES
    shares = numpy.arange(1, RINGS + 1) / RINGS
    places = [[0.0, 0.0, 0.0]] + [[r * numpy.sin(t), 0.0, r * numpy.cos(t)]
                                  for r in shares for t in turns]
    number = [lambda spoke: 0] + [lambda spoke, r=r: 1 + r * SPOKES + spoke % SPOKES
                                  for r in range(RINGS)]
    faces = [[0, number[1](s), number[1](s + 1)] for s in range(SPOKES)]
    for r in range(1, RINGS):
        for s in range(SPOKES):
            a, b, c, d = number[r](s), number[r + 1](s), number[r + 1](s + 1), number[r](s + 1)
            faces += [[a, b, c], [a, c, d]]
    rows, out = 14, 10
    heights = numpy.array([1.3 * (1.0 - 0.45 * (r / out) ** 2) if r < out else 0.25
                           for r in range(out + 1)])
    axis = {}

    def point(spoke, r, row):
        if row == 0:
            return number[r](spoke)
        key = (None if r == 0 else spoke, r, row)
        if key not in axis:
            radius = r / RINGS * (1.0 - 0.3 * (row / rows) ** 2)
            axis[key] = len(places)
            places.append([radius * numpy.sin(turns[spoke]), heights[r] * row / rows,
                           radius * numpy.cos(turns[spoke])])
        return axis[key]

    for sheet in range(SHEETS):
        spoke = sheet * SPOKES // SHEETS
        for r in range(out):
            for row in range(rows):
                a, b = point(spoke, r, row), point(spoke, r + 1, row)
                c, d = point(spoke, r + 1, row + 1), point(spoke, r, row + 1)
                faces += [[a, b, c], [a, c, d]]
    return off.surface(places, faces)


def soup(surface):
    """The same triangles, each with points of its own."""
    faces = triangles(surface)
    return off.surface(points(surface)[faces.ravel()],
                       numpy.arange(faces.size).reshape(-1, 3).tolist())


def exploded(surface):
    """Each triangle a little smaller, so that it is seen to stand alone."""
    corners = points(surface)[triangles(surface)]
    middles = corners.mean(axis=1, keepdims=True)
    return off.surface((middles + 0.8 * (corners - middles)).reshape(-1, 3),
                       numpy.arange(corners.size // 3).reshape(-1, 3).tolist())


EAR, EAR_RADIUS = numpy.array([10.5, 2.0, 0.4]), 4.4


def around_ear(surface, radius):
    return common.outline(surface, EAR, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], radius)


def damaged(head, random):
    """Noise, holes and fins with three triangles at an edge where the ear is."""
    places, faces = points(head), triangles(head)
    near = (numpy.linalg.norm((places - EAR)[:, 1:], axis=1) < EAR_RADIUS) & (places[:, 0] > 6.0)
    noisy = places + 0.4 * near[:, None] * random.uniform(-1.0, 1.0, places.shape)
    there = near[faces].all(axis=1)
    fins = faces[there & (random.uniform(size=len(faces)) < 0.08)].copy()
    kept = faces[~(there & (random.uniform(size=len(faces)) < 0.1))]
    tips = noisy[fins[:, 0]] + random.uniform(-0.7, 0.7, (len(fins), 3)) + [0.7, 0.0, 0.0]
    fins[:, 0] = len(noisy) + numpy.arange(len(fins))
    return off.surface(numpy.concatenate([noisy, tips]), numpy.concatenate([kept, fins]).tolist())


def largest(surface):
    """Its largest part, without crumbs."""
    algorithm = vtkPolyDataConnectivityFilter()
    algorithm.SetInputData(surface)
    algorithm.SetExtractionModeToLargestRegion()
    algorithm.Update()
    part = algorithm.GetOutput()
    used, corners = numpy.unique(triangles(part), return_inverse=True)
    return off.surface(points(part)[used], corners.reshape(-1, 3).tolist())


def show_vane(row, panel, vane, view, disk, **options):
    """The disk and the sheets on it, which have two sides each."""
    chosen = numpy.arange(vane.GetNumberOfCells()) < disk
    row.show(panel, common.cells_of(vane, chosen), *view, panels.STEEL, **options)
    row.show(panel, common.cells_of(vane, ~chosen), *view, common.FEATURE, **options)


def fig14(folder, claims):
    row = Row(4, 2, height=0.95, foot=0.02)
    soups(row, claims)
    repair(row, claims)
    row.save(folder, 14)


def soups(row, claims):
    vane = weather_vane()
    disk = SPOKES * (2 * RINGS - 1)
    torn = soup(vane)
    view = ([0.0, 0.5, 0.0], 2.7, [0.5, 0.5, 1.0], [0.0, 1.0, 0.0])
    show_vane(row, 0, exploded(vane), view, disk)
    row.caption(0, 'a soup of %d triangles' % torn.GetNumberOfCells(), 14)
    ids = 1 + (RINGS - 1) * SPOKES + numpy.arange(SPOKES)
    places = points(vane)[ids]
    moved, turns = on_cylinder(places, 0.7, 0.0)
    up = numpy.tile([0.0, 1.0, 0.0], (len(ids), 1))
    curve = common.handle(places, moved, up, turns[:, :, 1])
    bent, whole = common.deform(torn, curve), common.deform(vane, curve)
    show_vane(row, 1, bent, view, disk)
    row.tube(1, curve, *view)
    row.caption(1, 'bent by its rim', 14)
    apart = numpy.abs(points(bent) - points(whole)[triangles(vane).ravel()]).max()
    claims.check(14, 'a soup bent, and the same sheets with shared points, apart', '%g' % apart,
                 apart < 1e-9, '0')
    result = common.paste(torn, common.model('bunny00'), [0.2, 0.2, 0.0], Scale=0.3)
    part = scenes.vtk_to_numpy(result.GetCellData().GetArray('Part'))
    feature = numpy.flatnonzero(part == 2)
    for panel, place in ((2, ([0.05, 0.1, 0.0], 1.45, [0.2, 0.3, 1.0], [0.0, 1.0, 0.0])),
                         (3, ([0.25, 0.3, 0.0], 0.85, [0.1, 0.6, 1.0], [0.0, 1.0, 0.0]))):
        sheets = numpy.isin(numpy.arange(len(part)), feature[disk:])
        row.show(panel, common.cells_of(result, ~sheets), *place, panels.STEEL, smooth=60.0)
        row.show(panel, common.cells_of(result, sheets), *place, common.FEATURE)
    row.caption(2, 'the soup pasted on a bunny', 14)
    row.caption(3, 'its rim joined without a gap', 14)
    # Of its own the vane has its sheets' free sides, and edges of more than two triangles.
    free = common.edges(vane, 'Boundary') - SPOKES
    claims.check(14, 'pasted: open edges, edges of three triangles and more', '%d, %d' % (
        common.edges(result, 'Boundary'), common.edges(result, 'NonManifold')),
                 common.edges(result, 'Boundary') == free and
                 common.edges(result, 'NonManifold') == common.edges(vane, 'NonManifold'),
                 "the sheets' own: %d, %d" % (free, common.edges(vane, 'NonManifold')))
    claims.check(14, 'pasted: normals across the join, median', '%.1f degrees' %
                 fact(result, 'PasteFeature.DeviationAfter'),
                 fact(result, 'PasteFeature.DeviationAfter') < 3.0, '< 3 degrees')


def repair(row, claims):
    head = common.model('mannequin-devil')
    scan = damaged(head, numpy.random.RandomState(14))
    view = ([6.0, -2.0, 0.0], 32.0, [1.0, -0.4, 0.15], [0.0, 0.0, 1.0])
    row.show(4, scan, *view, panels.STEEL)
    row.caption(4, 'a damaged scan: %d open edges, %d of three\ntriangles and more' % (
        common.edges(scan, 'Boundary') - common.edges(head, 'Boundary'),
        common.edges(scan, 'NonManifold')), 14)
    hole, rest = cut(scan, around_ear(scan, 5.6))
    rest = largest(rest)
    row.show(5, rest, *view, panels.STEEL, smooth=60.0)
    row.caption(5, 'the ear cut away, and filled', 14)
    other = common.mirrored(head, 0)
    loop = around_ear(other, 6.2)
    ear = cut(other, loop, KeepOriginal=True)[0]
    row.show(6, other, *view, panels.STEEL, smooth=60.0)
    row.tube(6, loop, *view)
    row.caption(6, 'the other ear, mirrored', 14)
    result = facing(ear, rest, seed_of(hole), numpy.array([0.0, 0.0, 1.0]),
                    numpy.array([0.0, 0.0, 1.0]))
    row.show(7, result, *view, panels.STEEL, smooth=60.0)
    row.caption(7, 'repaired by its copy', 14)
    claims.check(14, 'repaired: open edges, edges of three triangles and more', '%d, %d' % (
        common.edges(result, 'Boundary'), common.edges(result, 'NonManifold')),
                 common.edges(result, 'Boundary') == common.edges(head, 'Boundary') and
                 common.edges(result, 'NonManifold') == 0, 'as before: %d, 0' %
                 common.edges(head, 'Boundary'))
    new = common.cells_of(result, scenes.vtk_to_numpy(result.GetCellData().GetArray('Part')) > 0)
    used = numpy.unique(triangles(new))
    miss = numpy.abs(scenes.boundary_distance(result, head, Signed=0))[used]
    size = common.diagonal(head)
    mirror = numpy.abs(scenes.boundary_distance(ear, head, Signed=0))
    claims.check(14, 'repaired: off the undamaged ear, RMS, of the diagonal', '%.2f %%' %
                 (100.0 * numpy.sqrt((miss ** 2).mean()) / size),
                 numpy.sqrt((miss ** 2).mean()) < 0.01 * size, '< 1 %')
    claims.note(14, 'the mirrored ear itself, off the same', '%.2f %%' %
                (100.0 * numpy.sqrt((mirror ** 2).mean()) / size))
    claims.check(14, 'repaired: normals across the join, median', '%.1f degrees' %
                 fact(result, 'PasteFeature.DeviationAfter'),
                 fact(result, 'PasteFeature.DeviationAfter') < 3.0, '< 3 degrees')
