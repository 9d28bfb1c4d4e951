"""Surfaces with defects that change no shape, and with cells of several kinds."""
import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_QUAD, VTK_TRIANGLE, VTK_TRIANGLE_STRIP, vtkCellArray, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import shapetesting


def with_points(data, copied, shift):
    """A copy of the points, and after them more with the values of others, moved by `shift`."""
    places = shapetesting.points(data)
    result = data.NewInstance()
    result.SetPoints(vtkPoints())
    shapetesting.set_points(result, numpy.vstack([places, places[copied] + shift]))
    for i in range(data.GetPointData().GetNumberOfArrays()):
        array = data.GetPointData().GetArray(i)
        values = vtk_to_numpy(array)
        longer = numpy_to_vtk(numpy.concatenate([values, values[copied]]), deep=True,
                              array_type=array.GetDataType())
        longer.SetName(array.GetName())
        result.GetPointData().AddArray(longer)
    return result


def with_defects(surface):
    """All defects around one point of the surface, whose triangles stay first."""
    faces = shapetesting.triangles(surface).copy()
    count = surface.GetNumberOfPoints()
    a, fan = inside(surface, faces)
    # Half of the triangles around a get a copy of it; two triangles without area connect the halves.
    half = fan[:len(fan) // 2]
    b, d = half[0][1], half[-1][2]
    copy, tip = count, count + 1
    for t, _, _ in half:
        faces[t][faces[t] == a] = copy
    normal = shapetesting.points(surface)[fan[0][1]] - shapetesting.points(surface)[fan[1][2]]
    result = with_points(surface, [a, fan[-1][2]], numpy.array([[0.0] * 3, 0.1 * normal]))
    far = faces[-1]
    extra = [[a, b, copy], [copy, d, a], [fan[-1][1], fan[-1][2], tip], far[[1, 2, 0]], far[[0, 0, 1]]]
    result.SetPolys(cells(numpy.vstack([faces, extra])))
    return result


def cells(faces):
    polygons = vtkCellArray()
    for face in faces.tolist():
        polygons.InsertNextCell(3, face)
    return polygons


def inside(surface, faces):
    """A point that triangles surround, and its triangles in their order around it, with the point after it and the
    one before it in each."""
    following = {}
    for t, face in enumerate(faces):
        for k in range(3):
            following.setdefault(face[k], {})[face[(k + 1) % 3]] = (t, face[(k + 1) % 3], face[(k + 2) % 3])
    for a in reversed(sorted(following)):
        start = next(iter(following[a]))
        fan, b = [], start
        while b in following[a] and len(fan) < len(following[a]):
            fan.append(following[a][b])
            b = fan[-1][2]
        if b == start and len(fan) == len(following[a]) >= 4 and fan[-1][1] in following.get(fan[-1][2], {}):
            return a, fan
    raise AssertionError('no point is surrounded')


def mixed(surface):
    """Its triangles as quads, triangles and strips in a grid, and the same triangulated."""
    faces = shapetesting.triangles(surface).tolist()
    pairs = {}
    used, quads, strips = set(), [], []
    for t, face in enumerate(faces):
        for k in range(3):
            pairs[face[k], face[(k + 1) % 3]] = t, face[(k + 2) % 3]
    for t, face in enumerate(faces[:40]):
        twin = pairs.get((face[1], face[0]))
        if t not in used and twin and twin[0] not in used:
            used |= {t, twin[0]}
            if len(quads) <= len(strips):
                quads.append([face[0], twin[1], face[1], face[2]])
            else:
                strips.append([face[2], face[0], face[1], twin[1]])
    grid = vtkUnstructuredGrid()
    polygons = vtkPolyData()
    rest = [face for t, face in enumerate(faces) if t not in used]
    for data in (grid, polygons):
        data.SetPoints(surface.GetPoints())
        data.GetPointData().ShallowCopy(surface.GetPointData())
        data.AllocateExact(len(faces), 4) if data is grid else data.AllocateEstimate(len(faces), 4)
        for kind, members in ((VTK_TRIANGLE_STRIP, strips), (VTK_QUAD, quads), (VTK_TRIANGLE, rest)):
            for member in members:
                data.InsertNextCell(kind, len(member), member)
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(polygons)
    triangulate.Update()
    assert triangulate.GetOutput().GetNumberOfPolys() == len(faces)
    return grid, triangulate.GetOutput()
