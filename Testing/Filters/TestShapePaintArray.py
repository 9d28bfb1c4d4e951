"""Shape Paint Array: strokes of a brush change a point array."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
import shapemap

import shapetesting
from shapetesting import add_array, array, points

SET, ADD, SMOOTH = 0, 1, 2

# The example: a stiff band around a quarter of a sphere.
sphere = simple.Clean(Input=simple.Sphere(ThetaResolution=60, PhiResolution=60, Radius=1.0))
path = [[numpy.cos(t), numpy.sin(t), 0.0] for t in numpy.linspace(0.0, 0.5 * numpy.pi, 40)]
painted = simple.ShapePaintArray(Input=sphere, ArrayName='Rigidity', InitialValue=1.0,
                                 Strokes=[SET, 0.3, 1.0, 4.0, len(path)], StrokePoints=numpy.ravel(path).tolist())
painted.UpdatePipeline()
data = shapetesting.output(painted)


def weights(places, positions, radius):
    share = numpy.linalg.norm(places[:, None].astype(float) - numpy.array(positions)[None], axis=2).min(axis=1) / radius
    return numpy.where(share < 1.0, (1.0 - share ** 2) ** 2, 0.0)


weight = weights(points(data), path, 0.3)
assert abs(array(data, 'Rigidity') - (1.0 + 3.0 * weight)).max() < 1e-13 and weight.max() > 0.95
assert data.GetPointData().GetScalars().GetName() == 'Rigidity', 'what was painted is shown'

# Shape Deform reads it.
ring = simple.Slice(Input=sphere)
ring.SliceType.Normal = [0, 0, 1]
ring.SliceType.Origin = [0, 0, -0.5]
old = simple.Calculator(Input=ring, ResultArrayName='SourcePosition', Function='coords')
handle = simple.Calculator(Input=old, CoordinateResults=1, Function='coords+iHat*0.5*coordsX+kHat*0.5*coordsX')
bent = [simple.ShapeDeform(Input=painted, Boundary=handle, RigidityArray=name) for name in ('None', 'Rigidity')]
for result in bent:
    result.UpdatePipeline()
difference = abs(points(shapetesting.output(bent[0])) - points(shapetesting.output(bent[1]))).max()
assert difference > 1e-3, difference


def paint(surface, strokes, **settings):
    """strokes: pairs of (mode, radius, strength, value) and positions."""
    made = shapetesting.new(shapemap.vtkShapePaintArray, surface, **settings)
    k = 0
    for i, (brush, positions) in enumerate(strokes):
        made.SetStrokes(i, *brush, len(positions))
        for position in positions:
            made.SetStrokePoints(k, *position)
            k += 1
    return made


def values(made, name='Painted'):
    return array(shapetesting.outputs(made)[0], name).copy()


# An array of the input is where the strokes begin; the input stays as it is.
surface = shapetesting.read('DentedSphere600.vtp')
height = points(surface)[:, 2].astype(float).copy()
add_array(surface, height, 'Height')
first, second = points(surface)[5].astype(float), points(surface)[200].astype(float)
made = paint(surface, [((ADD, 0.4, 0.5, 2.0), [first, second])], ArrayName='Height', InitialValue=7.0)
assert abs(values(made, 'Height') - height - weights(points(surface), [first, second], 0.4)).max() < 1e-13
assert (array(surface, 'Height') == height).all()

# Smoothing reaches the mean, weighted by the areas of the points.
corners = points(surface)[shapetesting.triangles(surface)].astype(float)
area = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 6.0
areas = numpy.zeros(len(height))
numpy.add.at(areas, shapetesting.triangles(surface), area[:, None])
flat = values(paint(surface, [((SMOOTH, 5.0, 1.0, 0.0), [first] * 100)], ArrayName='Height'), 'Height')
assert abs(flat - areas @ height / areas.sum()).max() < 1e-12

# Strokes cross the seams of blocks. Each block gets its own values.
strokes = [((SET, 0.8, 0.9, 1.0), [first, second]), ((SMOOTH, 0.9, 0.8, 0.0), [second, first, second])]
whole = values(paint(surface, strokes))
middle = points(surface)[shapetesting.triangles(surface)].mean(axis=1) @ (second - first)
cells = [numpy.flatnonzero((middle < 0.0) == side).tolist() for side in (True, False)]
blocks = vtkMultiBlockDataSet()
for i in (0, 1):
    blocks.SetBlock(i, shapetesting.with_cells(surface, cells[i]))
result = shapetesting.outputs(paint(blocks, strokes))[0]
places = {tuple(place): value for place, value in zip(points(surface), whole)}
for i in (0, 1):
    for place, value in zip(points(result.GetBlock(i)), array(result.GetBlock(i), 'Painted')):
        assert abs(places[tuple(place)] - value) < 1e-12

# Without strokes, every point has the initial value.
assert (values(paint(surface, [], InitialValue=2.5)) == 2.5).all()

# A stroke that is undone leaves nothing, and what is kept for speed changes no bits.
made = paint(surface, strokes)
assert (values(made) == whole).all()
made.SetNumberOfStrokes(1)
made.SetNumberOfStrokePoints(2)
assert (values(made) == values(paint(surface, strokes[:1]))).all()
made.SetInitialValue(1.0)
assert (values(made) == values(paint(surface, strokes[:1], InitialValue=1.0))).all()

# Wrong numbers are refused, with the stroke.
for brush, words in (((3, 1.0, 1.0, 1.0), 'Mode of stroke 0'), ((0, -1.0, 1.0, 1.0), 'Radius of stroke 0'),
                     ((0, 1.0, 2.0, 1.0), 'Strength of stroke 0')):
    shapetesting.check_refused(paint(surface, [(brush, [first])]), words)
made = paint(surface, strokes)
made.SetNumberOfStrokePoints(6)
shapetesting.check_refused(made, 'Strokes have 5 points', '6 Stroke Points')
made.SetNumberOfStrokePoints(4)
shapetesting.check_refused(made, 'Number of points of stroke 1')
shapetesting.check_refused(paint(surface, [], ArrayName='TargetPosition'), 'TargetPosition', 'component')
shapetesting.check_refused(paint(surface, [], ArrayName=''), 'Array Name')
