"""Shape Correspondence, CommonBase: the base domain, curves, and the measure that is lowered; and the
sphere of CommonSphere."""
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
import shapemap

import shapetesting
from shapetesting import array, fact, points, triangles

SPHERE, BASE = 5, 9
MEASURES = range(6)


def torus(minor, around, across):
    u, v = numpy.meshgrid(2 * numpy.pi * numpy.arange(around) / around,
                          2 * numpy.pi * numpy.arange(across) / across, indexing='ij')
    radius = 1 + minor * numpy.cos(v)
    places = numpy.column_stack([(radius * numpy.cos(u)).ravel(), (radius * numpy.sin(u)).ravel(),
                                 (minor * numpy.sin(v)).ravel()])
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    cells = vtkCellArray()
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            cells.InsertNextCell(3, [a, b, c])
            cells.InsertNextCell(3, [a, c, d])
    data.SetPolys(cells)
    return data


def given(places, targets, lines=()):
    """Landmarks; lines are lists of their indices."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    cells = vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line), line)
    data.SetLines(cells)
    shapetesting.add_array(data, numpy.asarray(targets, float), 'TargetPosition')
    return data


def distance(positions, curve):
    a, edge = curve[:-1], numpy.diff(curve, axis=0)
    apart = positions[:, None] - a
    share = numpy.clip((apart * edge).sum(axis=2) / (edge ** 2).sum(axis=1), 0, 1)
    return numpy.linalg.norm(apart - share[..., None] * edge, axis=2).min(axis=1).max()


def circle(minor, count):
    """Around the hole of a torus, outside."""
    angles = 2 * numpy.pi * numpy.arange(count + 1) / count
    angles[-1] = 0
    return (1 + minor) * numpy.column_stack([numpy.cos(angles), numpy.sin(angles), 0 * angles])


# The circles around the hole are curves of two tori with different meshes.
a, b = torus(0.4, 16, 8), torus(0.3, 20, 12)
top_a, top_b = [[0, 1, 0.4], [0, -1, -0.4]], [[0, 1, 0.3], [0, -1, -0.3]]
landmarks = given(numpy.concatenate([circle(0.4, 60), top_a]), numpy.concatenate([circle(0.3, 60), top_b]),
                  [list(range(60)) + [0]])
outputs = shapetesting.outputs(
    shapetesting.new(shapemap.vtkShapeCorrespondence, a, b, landmarks, Method=BASE))
first, second, base = outputs[0], outputs[1], outputs[5]
assert fact(first, 'Correspondence.FlippedTriangles') == 0
# Its start and both landmarks at the top: the other 59 points of the circle only say where it runs.
assert fact(first, 'Correspondence.Landmarks') == 3
for here, radius, other, count in ((first, 1.4, 1.3, 20), (second, 1.3, 1.4, 16)):
    outside = numpy.abs(numpy.linalg.norm(points(here), axis=1) - radius) < 1e-9
    assert outside.sum() in (16, 20)
    assert distance(array(here, 'TargetPosition')[outside], circle(other - 1, count)) < 1e-9
    assert set(array(here, 'Patch')) <= set(range(int(fact(first, 'Correspondence.Patches'))))
print('a curve of %d points and one of %d, kept' % (16, 20))

# A path of the base domain has a patch on each side, and its images run along the other surface.
left, right, is_curve = (vtk_to_numpy(base.GetCellData().GetArray(name))
                         for name in ('LeftPatch', 'RightPatch', 'IsCurve'))
patches = int(fact(first, 'Correspondence.Patches'))
assert 2 * base.GetNumberOfLines() == 3 * patches
assert sorted(numpy.concatenate([left, right])) == sorted(list(range(patches)) * 3)
assert is_curve.sum() == 3, is_curve  # a closed curve is divided into three
images = array(base, 'TargetPosition')
assert (numpy.abs(numpy.hypot(numpy.linalg.norm(images[:, :2], axis=1) - 1, images[:, 2]) - 0.3) < 0.03).all()

# Points of B have the patch of their images on A.
nearest = numpy.linalg.norm(points(first)[None] - array(second, 'TargetPosition')[:, None], axis=2).argmin(axis=1)
agree = (array(first, 'Patch')[nearest] == array(second, 'Patch')).mean()
print('%d patches; %.0f %% of the points are in the patch of the nearest image' % (patches, 100 * agree))
assert agree > 0.7

# Each measure is lowered from what the symmetric Dirichlet energy leaves, and nothing flips.
marks = given(numpy.concatenate([circle(0.4, 4)[:4], top_a]), numpy.concatenate([circle(0.3, 4)[:4], top_b]))
for measure in MEASURES:
    mapped = shapetesting.outputs(shapetesting.new(
        shapemap.vtkShapeCorrespondence, a, b, marks, Method=BASE, BaseMeasure=measure))[0]
    before, after = fact(mapped, 'Correspondence.MeasureBefore'), fact(mapped, 'Correspondence.MeasureAfter')
    print('measure %d: %.6f, then %.6f' % (measure, before, after))
    assert 0 <= after < before, measure
    assert fact(mapped, 'Correspondence.FlippedTriangles') == 0

# Without landmarks, some are found on the shortest loops around the tube and through the hole, and the map
# carries the solid.
thick, thin = torus(0.4, 20, 10), torus(0.3, 24, 12)
outputs = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeCorrespondence, thick, thin, Method=BASE))
first, base = outputs[0], outputs[5]
assert fact(first, 'Correspondence.LandmarksFound') == 1 and fact(first, 'Correspondence.FlippedTriangles') == 0
kinds = vtk_to_numpy(base.GetCellData().GetArray('HandleLoop'))
assert sorted(kinds[kinds > 0]) == [1, 2]
for cell in numpy.flatnonzero(kinds):
    line = base.GetCell(int(cell)).GetPointIds()
    line = [line.GetId(k) for k in range(line.GetNumberOfIds())]
    for places in (points(base), array(base, 'TargetPosition')):
        assert (places[line[0]] == places[line[-1]]).all()
        turns = numpy.unwrap(numpy.arctan2(*places[line, :2].T))
        assert abs(round((turns[-1] - turns[0]) / (2 * numpy.pi))) == kinds[cell] - 1
for name, data, count, minor in (('A', thick, 10, 0.4), ('B', thin, 12, 0.3)):
    corners = points(data)[triangles(data)]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = 0.5 * numpy.linalg.norm(normals, axis=1).sum()
    polygon = 2 * count * minor * numpy.sin(numpy.pi / count)  # around the tube
    assert abs(fact(first, 'Correspondence.ShortestLoopOf' + name) - polygon / numpy.sqrt(area)) < 1e-9
solid = shapetesting.outputs(shapetesting.new(shapemap.vtkShapeTetrahedralize, thick))[0]
moved = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeHarmonicVolumeMap, solid, first, FoldFree=True))[0]
assert fact(moved, 'HarmonicVolumeMap.InvertedAfter') == 0
print('%d tetrahedra carried, %d untangled' % (
    moved.GetNumberOfCells(), fact(moved, 'HarmonicVolumeMap.InvertedBefore')))

# Curves that meet at no landmark.
crossing = given(numpy.concatenate([circle(0.4, 60)[:20], [[1, 0.3, 0.4], [1.4, 0.3, 0], [1, 0.3, -0.4]], top_a]),
                 numpy.concatenate([circle(0.3, 60)[:20], [[1, 0.3, 0.3], [1.3, 0.3, 0], [1, 0.3, -0.3]], top_b]),
                 [list(range(20)), [20, 21, 22]])
messages = shapetesting.run(
    shapetesting.new(shapemap.vtkShapeCorrespondence, a, b, crossing, Method=BASE))
assert 'curve 0 and curve 1 meet at point' in messages[0], messages

# The sphere through which a map of CommonSphere goes.
pebble = shapetesting.read('DentedSphere600.vtp')
far = points(pebble)[[0, 100, 200, 300]]
sphere = shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeCorrespondence, pebble, pebble, given(far, far), Method=SPHERE))
for here in sphere[:2]:
    assert numpy.abs(numpy.linalg.norm(array(here, 'SpherePosition'), axis=1) - 1).max() < 1e-12
gap = [numpy.abs(array(sphere[0], 'SpherePosition')[i] - array(sphere[1], 'SpherePosition')[i]).max()
       for i in (0, 100, 200, 300)]
assert max(gap) < 1e-12, gap
assert sphere[0].GetPointData().GetArray('Patch') is None
