"""Shape Deform: a shape follows its boundary, with its detail kept.

As an example: a square with a bump whose border is bent into a saddle. And a solid, moved by one of
its faces."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import (vtkCellArray, vtkDataSetAttributes, vtkMultiBlockDataSet,
                                           vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, set_points


def new(shape, boundary):
    return shapetesting.new(shapemap.vtkShapeDeform, shape, boundary)


def deformed(algorithm):
    return shapetesting.outputs(algorithm)[0]


def curve(places, targets, closed=True):
    """A polyline at its targets, which were at the places."""
    ids = list(range(len(places))) + ([0] if closed else [])
    lines = vtkCellArray()
    lines.InsertNextCell(len(ids))
    for i in ids:
        lines.InsertCellPoint(i)
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    data.SetPoints(coordinates)
    set_points(data, numpy.asarray(targets, float))
    data.SetLines(lines)
    add_array(data, numpy.asarray(places, float), 'SourcePosition')
    return data


def saddle(places):
    return places + numpy.outer(places[:, 0] ** 2 - places[:, 1] ** 2, [0, 0, 0.4])


def rotation(axis, angle):
    axis = numpy.asarray(axis, float) / numpy.linalg.norm(axis)
    cross = numpy.cross(numpy.eye(3), -axis)
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


# The example: in ParaView the border is extracted, its old place kept, and then moved.
plane = simple.Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0], XResolution=40,
                     YResolution=40)
bump = simple.Calculator(Input=plane, Function='coords+0.5*exp(-12*(coordsX^2+coordsY^2))*kHat',
                         CoordinateResults=1)
border = simple.FeatureEdges(Input=bump, BoundaryEdges=1, FeatureEdges=0, NonManifoldEdges=0,
                             ManifoldEdges=0)
before = simple.Calculator(Input=border, Function='coords', ResultArrayName='SourcePosition')
after = simple.Calculator(Input=before, Function='coords+0.4*(coordsX^2-coordsY^2)*kHat',
                          CoordinateResults=1)
deform = simple.ShapeDeform(Input=bump, Boundary=after)
deform.UpdatePipeline()
result = shapetesting.output(deform)
places = array(result, 'SourcePosition')
moved = points(result)
onBorder = abs(places[:, :2]).max(axis=1) > 1 - 1e-6
assert abs(moved[onBorder] - saddle(places[onBorder])).max() < 1e-6
# The bump is as high above what is around it as it was.
radius = numpy.linalg.norm(places[:, :2], axis=1)
height = moved[radius.argmin(), 2] - moved[(radius > 0.55) & (radius < 0.65), 2].mean()
assert abs(height - 0.5) < 0.05, height

# The same again is quick: the weights are kept, until a parameter changes.
assert fact(result, 'Deform.Prepared') == 1
after.Function = 'coords+0.2*(coordsX^2-coordsY^2)*kHat'
deform.UpdatePipeline()
assert fact(shapetesting.output(deform), 'Deform.Prepared') == 0
deform.Rigidity = 2.0
deform.UpdatePipeline()
assert fact(shapetesting.output(deform), 'Deform.Prepared') == 1

# A solid by one of its faces: a rigid motion of the face is that of the solid, to the last digits.
bar = read('CubeSmall.vtu')
rest = points(bar)
end = rest[:, 2] < rest[:, 2].min() + 1e-6
assert 3 < end.sum() < len(rest) / 2
turn, shift = rotation([1, 2, 3], 0.9), numpy.array([3.0, -2.0, 1.0])
handle = vtkPolyData()
coordinates = vtkPoints()
coordinates.SetDataTypeToDouble()
handle.SetPoints(coordinates)
set_points(handle, rest[end] @ turn.T + shift)
add_array(handle, rest[end], 'SourcePosition')
for method in (0, 1):
    for resolution in (0, 1):
        algorithm = new(bar, handle)
        algorithm.SetMethod(method)
        algorithm.SetMultiresolution(resolution)
        solid = deformed(algorithm)
        assert solid.IsA('vtkUnstructuredGrid')
        error = abs(points(solid) - rest @ turn.T - shift).max()
        assert error < 1e-11, (error, method, resolution, end.sum())
        assert abs(array(solid, 'SourcePosition') - rest).max() == 0

# Integrals along a line of the handle are the same for two and for many points on it.
ends, there = numpy.array([[-1.0, -0.5, 0.4], [1.0, -0.5, 0.4]]), numpy.array([[-1.2, 0.1, 0.5], [1.4, 0.4, 0.5]])


def by_line(count, **options):
    share = numpy.linspace(0.0, 1.0, count)[:, None]
    line = curve(ends[0] + share * (ends[1] - ends[0]), there[0] + share * (there[1] - there[0]), closed=False)
    for name in ('SourceNormal', 'TargetNormal'):
        add_array(line, numpy.tile([0.0, 0.0, 1.0], (count, 1)), name)
    return shapetesting.new(shapemap.vtkShapeDeform, read('DentedSphere600.vtp'), line, Method=1, Multiresolution=2,
                            **options)


coarse, fine = (points(deformed(by_line(count, IntegrateCurves=True))) for count in (2, 38))
assert abs(coarse - fine).max() < 1e-12, abs(coarse - fine).max()
assert abs(coarse - points(deformed(by_line(2)))).max() > 1e-6, 'the property has no effect'
shapetesting.check_refused(by_line(2, IntegrateCurves=True, Rigidity=2.0), 'rigidity 1 only', 'IntegrateCurves')

# A surface with a cap cut off, its rim as the handle; normals turn with the points.
sphere = read('DentedSphere600.vtp')
corners = points(sphere)[shapetesting.triangles(sphere)]
cut = shapetesting.without_cells(sphere, numpy.flatnonzero(corners[:, :, 2].min(axis=1) < -0.5))
add_array(cut, points(cut) / numpy.linalg.norm(points(cut), axis=1, keepdims=True), 'Normals')
cut.GetPointData().SetActiveNormals('Normals')
edges = {}
for triangle in shapetesting.triangles(cut):
    for a, b in zip(triangle, numpy.roll(triangle, -1)):
        edges[a, b] = True
rim = {a: b for a, b in edges if (b, a) not in edges}
loop = [min(rim)]
while rim[loop[-1]] != loop[0]:
    loop.append(rim[loop[-1]])
assert len(loop) == len(rim), 'one border'
base = points(cut)[loop]
solid = deformed(new(cut, curve(base, base @ turn.T)))
used = numpy.unique(shapetesting.triangles(cut))
assert abs(points(solid)[used] - points(cut)[used] @ turn.T).max() < 1e-12
assert abs(array(solid, 'Normals')[used] - array(cut, 'Normals')[used] @ turn.T).max() < 1e-12
assert solid.GetPointData().GetNormals() is not None
assert abs(points(deformed(new(cut, curve(base, base)))) - points(cut)).max() == 0

# Arrays that do not move are the same objects while only the handle moves. What changes on the input, in any
# block, changes the output as a new filter's.
halves = vtkMultiBlockDataSet()
for number, z in enumerate((0.0, 3.0)):
    halves.SetBlock(number, copy(cut))
    set_points(halves.GetBlock(number), points(cut) + [0.0, 0.0, z])
algorithm = new(halves, curve(base, base))
algorithm.SetNumberOfHandleMotions(1)
kept = []
for along in (0.1, 0.2):
    algorithm.SetHandleMotions(0, 0, along, 0, 0, 0, 0, 0, 1)
    algorithm.Update()
    kept.append([algorithm.GetOutputDataObject(0).GetBlock(1).GetPointData().GetArray(name)
                 for name in ('SourcePosition', 'ArrivalTime')])
assert all(a is b for a, b in zip(*kept))
set_points(halves.GetBlock(1), points(halves.GetBlock(1)) * [1.0, 1.1, 1.0])
halves.GetBlock(1).Modified()
halves.Modified()
again = new(halves, curve(base, base))
again.SetNumberOfHandleMotions(1)
again.SetHandleMotions(0, 0, 0.2, 0, 0, 0, 0, 0, 1)
for number in (0, 1):
    ours, fresh = (deformed(filter).GetBlock(number) for filter in (algorithm, again))
    assert (points(ours) == points(fresh)).all()
    for name in ('SourcePosition', 'ArrivalTime'):
        assert (array(ours, name) == array(fresh, name)).all()
    assert (array(ours, 'SourcePosition') == points(halves.GetBlock(number))).all()

# Parameters, each with the effect that it is for.
squeezed = base * [1.0, 0.6, 1.0]


def height_of(change):
    algorithm = new(cut, curve(base, squeezed))
    change(algorithm)
    return points(deformed(algorithm))[used, 2].max()


painted = copy(cut)
add_array(painted, numpy.full(cut.GetNumberOfPoints(), 1.3), 'Painted')
heights = [height_of(lambda a: a.SetScale(scale)) for scale in (0.7, 1.0, 1.3)]
assert heights[0] < heights[1] < heights[2], heights
algorithm = new(painted, curve(base, squeezed))
algorithm.SetScaleArray('Painted')
assert abs(points(deformed(algorithm))[used, 2].max() - heights[2]) < 1e-12
algorithm.SetScaleArray('None')
algorithm.SetRigidityArray('Painted')
assert abs(points(deformed(algorithm))[used, 2].max() -
           height_of(lambda a: a.SetRigidity(1.3))) < 1e-12
assert height_of(lambda a: a.SetInnerScale(1.5)) > heights[1]
biased = []
for weight in (0.0, 0.4, 0.8):
    algorithm = new(cut, curve(base, base))
    algorithm.SetBiasFrame(1, 0, 0)
    algorithm.SetBiasWeight(weight)
    biased.append(points(deformed(algorithm))[used, 0].mean())
assert biased[0] != biased[1] and biased[1] != biased[2]

# A turn that is set at one point turns the curve; normals are for both ends or neither.
turned = curve(base, base)
vector, is_set = numpy.zeros_like(base), numpy.zeros(len(base), numpy.int32)
vector[3], is_set[3] = [0, 0, 0.5], 1
add_array(turned, vector, 'FrameRotation')
add_array(turned, is_set, 'FrameSet')
twisted = points(deformed(new(cut, turned)))
assert abs(twisted[loop] - base).max() < 1e-12
assert abs(twisted - points(cut)).max() > 0.1

# Segments by a point array and by a cell array.
algorithm = new(cut, curve(base, squeezed))
labels = (corners[:, :, 2].min(axis=1) > 0.3).astype(numpy.int32)
kept = labels[corners[:, :, 2].min(axis=1) >= -0.5]
values = numpy_to_vtk(kept, deep=True)
values.SetName('Part')
cut.GetCellData().AddArray(values)
algorithm.SetSegmentArray('Part')
assert fact(deformed(algorithm), 'Deform.Segments') == 2

# Segments that the filter finds: two bumps on a strip, which is bent. They are labels for Segment Array, too.
strip = simple.Plane(Origin=[-1, -0.4, 0], Point1=[1, -0.4, 0], Point2=[-1, 0.4, 0], XResolution=60, YResolution=30)
bumps = simple.Calculator(Input=strip, CoordinateResults=1, Function='coords + kHat*0.8*(exp(-30*((coordsX-0.3)^2 + '
                          'coordsY^2)) + exp(-30*((coordsX+0.3)^2 + coordsY^2)))')
bumps.UpdatePipeline()
bumps = copy(shapetesting.output(bumps))
at = points(bumps)
rim = numpy.flatnonzero((abs(at[:, 0]) > 0.999) | (abs(at[:, 1]) > 0.399))
rim = rim[numpy.argsort(numpy.arctan2(at[rim, 1], at[rim, 0]))]
bent = numpy.column_stack([0.8 * numpy.sin(at[rim, 0] / 0.8), at[rim, 1],
                           0.8 * numpy.cos(at[rim, 0] / 0.8) - 0.8 + at[rim, 2]])
tops = [numpy.where(sign * at[:, 0] > 0, at[:, 2], 0).argmax() for sign in (1, -1)]
gaps, labels = [], []
for by in (0, 1):
    algorithm = new(bumps, curve(at[rim], bent))
    algorithm.SetSegmentBy(by)
    shape = deformed(algorithm)
    gaps.append(numpy.linalg.norm(points(shape)[tops[0]] - points(shape)[tops[1]]))
    labels = array(shape, 'Protrusion') if by else None
assert fact(shape, 'Deform.Segments') == 3 and set(labels) == {0, 1, 2}
assert labels[tops[0]] * labels[tops[1]] == 2 and not labels[rim].any()
assert gaps[1] > 1.2 * gaps[0], gaps
add_array(bumps, labels, 'Label')
algorithm = new(bumps, curve(at[rim], bent))
algorithm.SetSegmentArray('Label')
assert abs(points(deformed(algorithm)) - points(shape)).max() < 1e-12
assert not deformed(algorithm).GetPointData().HasArray('Protrusion')
algorithm.SetSegmentBy(1)
algorithm.SetMinimumProtrusion(0.9)
assert fact(deformed(algorithm), 'Deform.Segments') == 1

# Blocks are one shape: half of the sphere in each, the handle on one of them alone.
halves = vtkMultiBlockDataSet()
x = points(cut)[shapetesting.triangles(cut)].mean(axis=1)[:, 0]
whole = deformed(new(cut, curve(base, squeezed)))
for k, cells in enumerate((x < 0, x >= 0)):
    halves.SetBlock(2 * k, shapetesting.without_cells(cut, numpy.flatnonzero(cells)))
blocks = deformed(new(halves, curve(base, squeezed)))
assert blocks.GetNumberOfBlocks() == 3 and blocks.GetBlock(1) is None
for k in (0, 2):
    assert abs(points(blocks.GetBlock(k))[used] - points(whole)[used]).max() < 1e-12

# A soup: each triangle by itself, one of them nowhere near.
soup = vtkPolyData()
coordinates = vtkPoints()
coordinates.SetDataTypeToDouble()
soup.SetPoints(coordinates)
loose = points(cut)[shapetesting.triangles(cut)].reshape(-1, 3)
loose[:3] += [0, 0, 5]
set_points(soup, loose)
cells = vtkCellArray()
for t in range(len(loose) // 3):
    cells.InsertNextCell(3)
    for k in range(3):
        cells.InsertCellPoint(3 * t + k)
soup.SetPolys(cells)
result = deformed(new(soup, curve(base, base @ turn.T)))
assert fact(result, 'Deform.Islands') == 1
assert fact(result, 'Deform.WeldedPoints') > 1000
assert abs(points(result) - loose @ turn.T).max() < 1e-11

# Without a Boundary, the handle is the boundary of the Input, and properties move it: its only part by a
# similarity about its centre. Rotations are in degrees.
def moved_by(motions, frames=(), scale=1.0, boundary=None):
    algorithm = new(cut, boundary) if boundary else shapetesting.new(shapemap.vtkShapeDeform, cut)
    for index, row in enumerate(motions):
        algorithm.SetHandleMotions(index, *row)
    for index, row in enumerate(frames):
        algorithm.SetFrameRotations(index, *row)
    algorithm.SetScale(scale)
    return shapetesting.outputs(algorithm)


lengths = numpy.linalg.norm(base - numpy.roll(base, -1, axis=0), axis=1)
middle = lengths @ (base + numpy.roll(base, -1, axis=0)) / 2 / lengths.sum()
degrees = -numpy.degrees(0.9) * numpy.array([1, 2, 3]) / numpy.sqrt(14)
assert abs(points(moved_by([])[0]) - points(cut)).max() == 0
for scale in (1.0, 1.6):
    solid, handle, facts = moved_by([(0, *shift, *degrees, scale)], scale=scale)
    expected = scale * (points(cut) - middle) @ turn.T + middle + shift
    assert abs(points(solid)[used] - expected[used]).max() < 1e-11
    assert abs(array(handle, 'SourcePosition')[:, None] - base).sum(axis=2).min(axis=1).max() == 0
    assert abs(scale * (array(handle, 'SourcePosition') - middle) @ turn.T + middle + shift -
               points(handle)).max() < 1e-12
    assert abs(array(handle, 'TargetNormal') - array(handle, 'SourceNormal') @ turn.T).max() < 1e-12
    assert handle.GetNumberOfLines() == len(base) and set(array(handle, 'Part')) == {0}
    assert fact(solid, 'Deform.Parts') == 1
# A curve on the Input that has no SourcePosition is at rest, too.
still = curve(base, base)
still.GetPointData().RemoveArray('SourcePosition')
row = (0, *shift, *degrees, 1)
assert abs(points(moved_by([row], boundary=still)[0])[used] - points(moved_by([row])[0])[used]).max() < 1e-11
# A frame is that of the array FrameRotation, in degrees.
frames = [(*base[3], 0, 0, numpy.degrees(0.5))]
assert abs(points(moved_by([], frames)[0])[used] - twisted[used]).max() < 1e-11
# Two frames: the rotation between them is linear in the length of the curve.
frames.append((*base[20], 0, 0, 0))
handle = moved_by([], frames)[1]
angles = numpy.empty(len(base))
for place, angle in zip(array(handle, 'SourcePosition'), array(handle, 'FrameTurn')):
    angles[abs(base - place).sum(axis=1).argmin()] = angle[2]
way = numpy.cumsum(numpy.append(0, lengths[3:20]))
assert abs(angles[3:21] - numpy.degrees(0.5) * (1 - way / way[-1])).max() < 1e-9, angles

# What cannot be answered is refused with the fact.
normals = curve(base, base)
add_array(normals, base, 'SourceNormal')
flags = curve(base, base)
add_array(flags, is_set, 'FrameSet')
nowhere = curve(base, base + [0, 0, 3])
nowhere.GetPointData().RemoveArray('SourcePosition')
infinite = curve(base, base)
array(infinite, 'SourcePosition')[2, 1] = numpy.inf
for handle, change, words in (
        (normals, None, 'both SourceNormal and TargetNormal'),
        (flags, None, 'FrameRotation'),
        (nowhere, None, "no point array 'SourcePosition', and point 0 of the handle is off the shape"),
        (curve(base, base), lambda a: a.SetHandleMotions(0, 1, *shift, *degrees, 1), 'use a part from 0 to 0'),
        (curve(base, base), lambda a: a.SetHandleMotions(0, 0.5, *shift, *degrees, 1), 'whole number'),
        (curve(base, base), lambda a: a.SetHandleMotions(0, 1e30, *shift, *degrees, 1), 'whole number'),
        (curve(base, base), lambda a: a.SetHandleMotions(0, 0, *shift, *degrees, 0), 'positive scale'),
        (curve(base, base), lambda a: a.SetFrameRotations(0, *base[3], 0, numpy.nan, 0), 'not finite'),
        (infinite, None, 'not finite'),
        (curve(base, base), lambda a: a.SetRigidity(0.0), 'Rigidity is 0; it must be positive'),
        (curve(base, base), lambda a: a.SetRigidityArray('Nothing'), "no point array 'Nothing'"),
        (curve(base, base), lambda a: a.SetBiasWeight(2.0), 'BiasWeight is 2')):
    algorithm = new(cut, handle)
    if change:
        change(algorithm)
    message = ' '.join(shapetesting.run(algorithm))
    assert 'Shape Deform: ' in message and words in message, message
    assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
closed = shapetesting.new(shapemap.vtkShapeDeform, sphere)
assert 'no boundary curve; connect a curve' in ' '.join(shapetesting.run(closed))
print('shapes of every kind follow their boundary')

# When the front reached a point: its distance along edges, 0 on the handle.
line = simple.Line(Point1=[0, 0, 0], Point2=[2, 0, 0], Resolution=20)
end = simple.Calculator(Input=simple.Line(Point1=[0, 0, 0], Point2=[0.1, 0, 0], Resolution=1),
                        ResultArrayName='SourcePosition', Function='coords')
waved = simple.ShapeDeform(Input=line, Boundary=end)
waved.UpdatePipeline()
arrivals = array(shapetesting.output(waved), 'ArrivalTime')
expected = numpy.maximum(0.0, array(shapetesting.output(waved), 'SourcePosition')[:, 0] - 0.1)
assert abs(arrivals - expected).max() < 1e-6, (arrivals, expected)
