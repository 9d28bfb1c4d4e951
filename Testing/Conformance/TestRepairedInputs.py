"""A few defects change no result at the other points, and every filter says what it repaired: a fin (a triangle on an
edge that has two already), a repeated triangle, triangles with two equal corners, and an edge without length. A surface
may come as an unstructured grid with quads and strips."""
import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_QUAD, VTK_TRIANGLE, VTK_TRIANGLE_STRIP, vtkCellArray, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import filters
import shapetesting

# Of these inputs, a filter uses the points alone, or leaves polygons as they are.
NOT_REPAIRED = {('ShapeFillHoles', 'Input'), ('ShapeApplyVolumeMap', 'Map'), ('ShapeCutFeature', 'Loop')}


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
        if b == start and len(fan) == len(following[a]) >= 4:
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


def compare(what, clean, other):
    """Cells at the same positions with the same values; or, if there are more cells, points with the same values."""
    if not clean.IsA('vtkPointSet') or clean.GetNumberOfPoints() == 0:
        return
    rows = other_rows = numpy.arange(clean.GetNumberOfPoints())
    if clean.GetNumberOfCells() == other.GetNumberOfCells() > 0 and not what.startswith('mixed'):
        ids = [[data.GetCell(cell).GetPointId(k) for cell in range(data.GetNumberOfCells())
                for k in range(data.GetCell(cell).GetNumberOfPoints())] for data in (clean, other)]
        rows, other_rows = map(numpy.array, ids)
        assert len(rows) == len(other_rows), what
    places, others = shapetesting.points(clean)[rows], shapetesting.points(other)[other_rows]
    size = numpy.ptp(places, axis=0).max()
    assert abs(places - others).max() <= 1e-6 * size, '%s: moved by %g' % (what, abs(places - others).max())
    for i in range(clean.GetPointData().GetNumberOfArrays()):
        array = clean.GetPointData().GetArray(i)
        if array is None or array.GetName() in ('OriginalPointId', 'TargetCell', 'TargetBarycentric'):
            continue
        one = vtk_to_numpy(array)[rows]
        two = shapetesting.array(other, array.GetName())[other_rows]
        assert abs(one - two).max() <= 1e-6 * max(1.0, abs(one).max()), '%s: %s differs by %g' % (
            what, array.GetName(), abs(one - two).max())


def result(name, port, data):
    algorithm = filters.with_good_inputs(name)
    algorithm.SetInputDataObject(port, data)
    messages = shapetesting.run(algorithm)
    outputs = [shapetesting.copy(output) for output in shapetesting.outputs_of(algorithm)]
    return messages, outputs


def warning(name, outputs):
    facts = shapetesting.facts(outputs[0])
    words = facts.GetAbstractArray('%s.Warning' % name[len('Shape'):])
    return words.GetValue(0) if words else ''


for name in filters.names():
    for port in filters.required_ports(filters.new(name)):
        key = name, filters.new(name).GetInputName(port)
        good = filters.good_input(name, port)
        types = vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
        info = filters.new(name).GetInputPortInformation(port)
        takes_all = 'vtkDataSet' in [info.Get(types, i) for i in range(info.Length(types))]
        if key in NOT_REPAIRED or not good.IsA('vtkPolyData') or good.GetNumberOfPolys() == 0 or \
                takes_all and key != ('ShapeHarmonicVolumeMap', 'Boundary'):
            continue
        messages, clean = result(name, port, good)
        assert not messages, (key, messages)
        messages, repaired = result(name, port, with_defects(good))
        assert not messages, (key, messages)
        for number, output in enumerate(clean):
            compare('%s, %s, output %d' % (*key, number), output, repaired[number])
        said = warning(name, repaired)
        assert 'was repaired' in said and '1 edge with three or more triangles' in said, (key, said)
        grid, triangulated = mixed(good)
        messages, clean = result(name, port, triangulated)
        assert not messages, (key, messages)
        messages, others = result(name, port, grid)
        assert not messages and 'was repaired' not in warning(name, others), (key, messages)
        for number, output in enumerate(clean):
            compare('mixed, %s, %s, output %d' % (*key, number), output, others[number])
        print(*key, 'is repaired, and may have any cells')
