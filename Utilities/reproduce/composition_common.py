"""What the pictures of drag-and-drop share: features cut, pasted and deformed by the filters, what is
measured of the results."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkCellLocator, vtkPlane
from vtkmodules.vtkFiltersCore import (vtkContourFilter, vtkCutter, vtkDecimatePro,
                                       vtkPolyDataNormals, vtkStripper)

import scenes  # knows where off.py and shapetesting.py are

import off
import shapetesting
from scenes import add_array, at, copy, model, points  # noqa: F401
from shapetesting import closed_curve, edges, euler, triangles

FEATURE = [0.95, 0.62, 0.36]
BOUNDARY_RELATIVE = 1  # of Method
ON, OFF = 1, 2         # of Multiresolution


def middle(data):
    low, high = points(data).min(axis=0), points(data).max(axis=0)
    return 0.5 * (low + high)


def diagonal(data):
    return numpy.linalg.norm(numpy.ptp(points(data), axis=0))


def mirrored(data, axis):
    """Its mirror image about the middle of its box, with its outside outside."""
    places = points(data)
    places[:, axis] = 2.0 * middle(data)[axis] - places[:, axis]
    return off.surface(places, triangles(data)[:, ::-1].tolist())


def coarser(data, count):
    """About so many points, without care for detail."""
    algorithm = vtkDecimatePro()
    algorithm.SetInputData(data)
    algorithm.SetTargetReduction(1.0 - count / data.GetNumberOfPoints())
    algorithm.PreserveTopologyOn()
    algorithm.Update()
    return algorithm.GetOutput()


def with_normals(data):
    algorithm = vtkPolyDataNormals()
    algorithm.SetInputData(data)
    algorithm.SplittingOff()
    algorithm.ConsistencyOff()
    algorithm.Update()
    return algorithm.GetOutput()


def with_cell_value(surface, name, value):
    """The surface with an array of its cells that is `value` everywhere."""
    marked = copy(surface)
    values = numpy_to_vtk(numpy.full(surface.GetNumberOfCells(), value, numpy.int32), deep=True)
    values.SetName(name)
    marked.GetCellData().AddArray(values)
    return marked


def cells_of(data, chosen):
    """Some cells of a surface of triangles, with the data of its points."""
    result = copy(data)
    result.SetPolys(off.surface(points(data), triangles(data)[chosen].tolist()).GetPolys())
    result.GetCellData().Initialize()
    return result


def closed_lines(lines):
    """The places of each closed curve that pieces of lines make."""
    stripper = vtkStripper()
    stripper.SetInputData(lines)
    stripper.SetMaximumLength(10 ** 6)
    stripper.JoinContiguousSegmentsOn()
    stripper.Update()
    lines, curves = stripper.GetOutput(), []
    for index in range(lines.GetNumberOfCells()):
        ids = lines.GetCell(index).GetPointIds()
        ids = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        if ids[0] == ids[-1]:
            curves.append(points(lines)[ids[:-1]])
    if not curves:
        raise RuntimeError('there is no closed curve')
    return curves


def section(surface, origin, normal):
    """The closed curve, of those in which a plane cuts the surface, that passes the origin nearest."""
    plane, cutter = vtkPlane(), vtkCutter()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cutter.SetInputData(surface)
    cutter.SetCutFunction(plane)
    cutter.Update()
    return closed_curve(min(closed_lines(cutter.GetOutput()), key=lambda places: numpy.linalg.norm(
        places.mean(axis=0) - origin)))


def ring(surface, tip, distance):
    """The longest closed curve at this distance along the surface from a place on it."""
    contour = vtkContourFilter()
    contour.SetInputData(scenes.output_of('GeodesicDistance', surface, scenes.point_set([tip])))
    contour.SetInputArrayToProcess(0, 0, 0, 0, 'GeodesicDistance')
    contour.SetValue(0, distance)
    contour.Update()
    return closed_curve(max(closed_lines(contour.GetOutput()), key=len))


def outline(surface, centre, direction, up, radius, count=40):
    """A circle of this radius around a place as seen from `direction`, laid on the surface; or a curve
    with `count` radii."""
    locator = vtkCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    direction, up = numpy.array(direction), numpy.array(up)
    right, far = numpy.cross(up, direction), diagonal(surface) * direction
    places = []
    turns = 2.0 * numpy.pi * numpy.arange(count) / count
    for turn, away in zip(turns, numpy.broadcast_to(radius, count)):
        there = centre + away * (numpy.cos(turn) * right + numpy.sin(turn) * up)
        share, place, local, side = mutable(0.0), [0.0] * 3, [0.0] * 3, mutable(0)
        if not locator.IntersectWithLine(there + far, there - far, 1e-9, share, place, local, side):
            raise RuntimeError('the circle leaves the surface')
        places.append(place)
    return closed_curve(places)


def cut(surface, loop, **options):
    """The feature and the rest, filled."""
    algorithm = scenes.filter_of('CutFeature', surface, loop, **options)
    return copy(algorithm.GetOutputDataObject(0)), copy(algorithm.GetOutputDataObject(1))


def seed_of(feature):
    return facts_of(feature, 'CutFeature.Seed')


def paste(feature, target, seed, **options):
    algorithm = scenes.shapemap.vtkShapePasteFeature()
    algorithm.SetInputDataObject(0, feature)
    algorithm.SetInputDataObject(1, target)
    algorithm.SetSeed(*seed)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    return copy(scenes.checked(algorithm).GetOutputDataObject(0))


def facts_of(data, name):
    return scenes.vtk_to_numpy(shapetesting.facts(data).GetArray(name))[0]


def pasted_points(result):
    """The numbers of a feature's points in what it was pasted into, a surface or points."""
    part = scenes.vtk_to_numpy(result.GetCellData().GetArray('Part'))
    faces = triangles(result)
    return numpy.unique(faces[part == 2]) if len(faces) else numpy.flatnonzero(part == 2)


def facing(feature, target, seed, side, wanted, **options):
    """Pasted so that the `side` of the feature, a direction in its own space, looks into the wanted
    direction as nearly as a rotation about the target's normal can do."""
    first = points(feature)[numpy.argmax(points(feature) @ side)]
    result = paste(feature, target, seed, Rotation=0.0, **options)
    normal, place = (facts_of(result, 'PasteFeature.' + name) for name in ('Normal', 'Seed'))
    row = numpy.argmin(numpy.linalg.norm(points(feature) - first, axis=1))
    now = points(result)[pasted_points(result)[row]] - place
    angle = numpy.degrees(numpy.arctan2(normal @ numpy.cross(now, wanted),
                                        now @ wanted - (now @ normal) * (wanted @ normal)))
    return paste(feature, target, seed, Rotation=angle, **options)


def handle(places, targets, source_normals=None, target_normals=None, closed=True):
    """A curve at its new place, that knows the old one."""
    curve = closed_curve(targets)
    if not closed:
        curve = off.surface(targets, [])
        curve.SetLines(off.surface(targets, [list(range(len(targets)))]).GetPolys())
    add_array(curve, numpy.asarray(places, float), 'SourcePosition')
    if source_normals is not None:
        add_array(curve, numpy.asarray(source_normals, float), 'SourceNormal')
        add_array(curve, numpy.asarray(target_normals, float), 'TargetNormal')
    return curve


def deform(shape, boundary, **options):
    return copy(scenes.output_of('Deform', shape, boundary, **options))


def rim(surface):
    """The points of a surface's longest open loop, in order."""
    ids = longest_loop(triangles(surface))
    return ids, points(surface)[ids]


def longest_loop(faces):
    sides = numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    there = set(map(tuple, sides))
    following = {a: b for a, b in sides if (b, a) not in there}
    best = []
    while following:
        loop = [next(iter(following))]
        while loop[-1] in following:
            loop.append(following.pop(loop[-1]))
        best = max(best, loop[:-1], key=len)
    return best


def watertight(surface):
    return edges(surface, 'Boundary') == edges(surface, 'NonManifold') == 0


def stretch(before, after):
    """Of each point: the mean of |log| of how much longer its edges became."""
    faces = triangles(before)
    sides = numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    lengths = [numpy.linalg.norm(p[sides[:, 0]] - p[sides[:, 1]], axis=1)
               for p in (points(before), points(after))]
    known = lengths[0] > 0
    amounts = numpy.abs(numpy.log(numpy.maximum(lengths[1][known], 1e-300) / lengths[0][known]))
    total, count = numpy.zeros(before.GetNumberOfPoints()), numpy.zeros(before.GetNumberOfPoints())
    for end in (0, 1):
        numpy.add.at(total, sides[known, end], amounts)
        numpy.add.at(count, sides[known, end], 1.0)
    return total / numpy.maximum(count, 1.0)


def turn(axis, degrees):
    """The rotation about an axis."""
    x, y, z = numpy.asarray(axis, float) / numpy.linalg.norm(axis)
    cross = numpy.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = numpy.radians(degrees)
    return numpy.eye(3) + numpy.sin(angle) * cross + (1.0 - numpy.cos(angle)) * cross @ cross
