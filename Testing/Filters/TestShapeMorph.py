"""Shape Morph: a shape on its way to its image, as time goes from 0 to 1.

As an example: Input carries the map array; press Play, or ask for a time."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, points, read


def at(algorithm, time):
    """The output at a time."""
    algorithm.UpdateTimeStep(time)
    return algorithm.GetOutputDataObject(0)


def new(data):
    return shapetesting.new(shapemap.vtkShapeMorph, data)


# The example: a dented sphere becomes round.
model = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
morph = simple.ShapeMorph(Input=model)
surface = read('DentedSphere600.vtp')
start, end = points(surface), array(surface, 'TargetPosition')
for time in (0.3, 0.0, 0.31, 1.0):
    morph.UpdatePipeline(time=time)
    shown = shapetesting.output(morph)
    assert abs(points(shown) - ((1 - time) * start + time * end)).max() < 1e-15, time
    assert shown.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == time
assert (points(shown) == end).all() and (array(shown, 'SourcePosition') == start).all()

# Play, as ParaView is set up by default, shows it move in many small steps.
view = simple.CreateRenderView()
simple.Show(morph, view)
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
assert (scene.StartTime, scene.EndTime) == (0.0, 1.0)


def played():
    """How far the shape has come, at each picture from the first to the last."""
    scene.GoToFirst()
    shares = []
    while not shares or shares[-1] < 1.0 - 1e-12:
        moved = points(shapetesting.output(morph)) - start
        shares.append(float((moved * (end - start)).sum() / ((end - start)**2).sum()))
        assert len(shares) < 100, shares
        scene.GoToNext()
    return shares


shares = played()
assert abs(numpy.array(shares) - numpy.linspace(0, 1, 41)).max() < 1e-12, shares
scene.PlayMode, scene.NumberOfFrames = 'Sequence', 8
shares = played()
assert abs(numpy.array(shares) - numpy.linspace(0, 1, 8)).max() < 1e-12, shares

# Without a time it is where it was; before 0 and after 1 it rests.
algorithm = new(surface)
assert not shapetesting.run(algorithm)
assert (points(algorithm.GetOutputDataObject(0)) == start).all()
assert (points(at(algorithm, -5.0)) == start).all() and (points(at(algorithm, 7.0)) == end).all()

# Image data become a structured grid, blocks stay blocks, and normals, which no longer fit, go.
image = vtkImageData()
image.SetExtent(-2, 2, 0, 3, 0, 1)
places = numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
add_array(image, places[:, [1, 2, 0]].astype(numpy.float32), 'Turned')
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(1, image)
shaded = copy(surface)
add_array(shaded, start, 'Normals')
add_array(shaded, 2 * start, 'Turned')
blocks.SetBlock(2, shaded)
algorithm = new(blocks)
algorithm.SetMapArray('Turned')
tree = at(algorithm, 0.25)
assert tree.GetNumberOfBlocks() == 3 and tree.GetBlock(0) is None
grid = tree.GetBlock(1)
assert grid.GetClassName() == 'vtkStructuredGrid' and grid.GetExtent() == (-2, 2, 0, 3, 0, 1)
assert abs(points(grid) - (0.75 * places + 0.25 * places[:, [1, 2, 0]])).max() < 1e-15
assert abs(points(tree.GetBlock(2)) - 1.25 * start).max() < 1e-15
assert not tree.GetBlock(2).GetPointData().HasArray('Normals')

# An input that changes with time is taken at its first time step.
source = simple.TimeSource(XAmplitude=1.0, YAmplitude=1.0, Growing=0)
source.UpdatePipelineInformation()
simple.Calculator(Input=source, ResultArrayName='TargetPosition', Function='coords + iHat')
calculator = simple.GetActiveSource()
late = simple.ShapeMorph(Input=calculator)
first = list(source.TimestepValues)[0]
calculator.UpdatePipeline(time=first)
resting = points(shapetesting.output(calculator))
late.UpdatePipeline(time=0.5)
assert abs(points(shapetesting.output(late)) - resting - [0.5, 0, 0]).max() < 1e-6
assert list(late.TimestepValues)[-1] == 1.0, 'the time steps of the input came through'

# Targets are blended with their weights. An arm, whose forearm bends in the first and whose shoulder in the second.
def tube(bend=0.0, shoulder=0.0):
    """A tube along x from 0 to 6, bent about z near x = 4 and turned about y near x = 2."""
    around, along = 12, 60
    angles, x = numpy.meshgrid(numpy.arange(around) * 2 * numpy.pi / around, numpy.linspace(0, 6, along + 1))
    places = numpy.stack([x, 0.2 * numpy.cos(angles), 0.2 * numpy.sin(angles)], 2).reshape(-1, 3)
    for angle, at_x, across in ((bend, 4.0, 1), (shoulder, 2.0, 2)):
        if angle:
            turned = angle * numpy.clip(places[:, 0] - at_x + 0.5, 0, 1)
            beyond = numpy.maximum(0, places[:, 0] - at_x - 0.5)
            radius, moving = 1 / angle, places[:, 0] > at_x - 0.5
            y = places[:, across].copy()
            places[moving, 0] = (at_x - 0.5 + (radius - y) * numpy.sin(turned) + beyond * numpy.cos(angle))[moving]
            places[moving, across] = (radius - (radius - y) * numpy.cos(turned) + beyond * numpy.sin(angle))[moving]
    rows = numpy.arange(around * along).reshape(along, around)
    right = numpy.roll(rows, -1, 1)
    quads = numpy.stack([rows, right, right + around, rows + around], 2).reshape(-1, 4)
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    cells = vtkCellArray()
    for quad in quads:
        cells.InsertNextCell(4, quad.tolist())
    data.SetPolys(cells)
    return data


def forearm(data):
    """The length of the part from x = 5 to 6."""
    ends = points(data).reshape(-1, 12, 3)[[50, 60]].mean(1)
    return numpy.linalg.norm(ends[1] - ends[0])


resting, targets = tube(), [tube(bend=2.0), tube(shoulder=1.0)]
assert abs(forearm(targets[0]) - 1) < 1e-12


def blend(path, weights=(), time=1.0, animate=True, shape=resting, poses=targets):
    algorithm = new(shape)
    for pose in poses:
        algorithm.AddInputDataObject(1, pose)
    algorithm.SetPath(path)
    algorithm.SetNumberOfWeights(len(weights))
    for i, weight in enumerate(weights):
        algorithm.SetWeights(i, weight)
    algorithm.SetAnimate(animate)
    return at(algorithm, time)


first, second = (points(target) - points(resting) for target in targets)
for weights, time in (((0.5, 0.25), 1.0), ((1.0, 0.0), 0.3), ((-0.5, 1.5), 0.6), ((1.0,), 0.5)):
    given = list(weights) + [0.0] * (2 - len(weights))
    expected = points(resting) + time * (given[0] * first + given[1] * second)
    assert abs(points(blend(0, weights, time)) - expected).max() < 1e-14, weights
assert abs(points(blend(0)) - points(resting) - (first + second) / 2).max() < 1e-14, 'without weights: the mean'
assert (points(blend(0, (1, 0), 0.2, animate=False)) == points(blend(0, (1, 0), 1.0))).all()

# Rigid: targets are reached, and a forearm keeps its length, which shrinks by a fifth in straight lines.
for path in (0, 1):
    assert abs(points(blend(path, (1, 0))) - points(targets[0])).max() < 1e-11
    assert abs(points(blend(path, (0, 1), 0.0)) - points(resting)).max() < 1e-11
assert abs(forearm(blend(1, (1, 0), 0.5)) - 1) < 0.005 and forearm(blend(0, (1, 0), 0.5)) < 0.8
assert abs(forearm(blend(1, (0.6, 0.7))) - 1) < 0.01
# Another weight in the same filter gives what a new filter gives.
algorithm = new(resting)
algorithm.AddInputDataObject(1, targets[0])
algorithm.SetPath(1)
algorithm.SetNumberOfWeights(1)
for weight in (0.3, 0.8):
    algorithm.SetWeights(0, weight)
    assert (points(at(algorithm, 1.0)) == points(blend(1, (weight,), poses=targets[:1]))).all()

# Two blocks of one surface move as the whole, and solids as their hexahedra.
def in_halves(data):
    count = data.GetNumberOfCells()
    both = vtkMultiBlockDataSet()
    for i, cells in enumerate((range(count // 2), range(count // 2, count))):
        both.SetBlock(i, shapetesting.with_cells(data, list(cells)))
    return both


halves, pose_halves = (in_halves(data) for data in (resting, targets[0]))
whole = blend(1, (1.0,), 0.5, poses=targets[:1])
parts = blend(1, (1.0,), 0.5, shape=halves, poses=[pose_halves])
for part in range(2):
    own, source = (points(data.GetBlock(part)) for data in (parts, halves))
    rows = [numpy.argmin(abs(points(resting) - place).sum(1)) for place in source]
    assert abs(own - points(whole)[rows]).max() < 1e-9
bar = read('BentBarSmall.vtu')
half = new(bar)
half.SetPath(1)
assert abs(points(at(half, 1.0)) - array(bar, 'TargetPosition')).max() < 1e-10

# Targets with other points, and too many weights.
algorithm = new(resting)
algorithm.AddInputDataObject(1, surface)
message = ' '.join(shapetesting.run(algorithm))
assert 'target 0 of Targets has %d points, and the Input has 732' % len(start) in message, message
algorithm = new(resting)
algorithm.AddInputDataObject(1, targets[0])
algorithm.SetNumberOfWeights(3)
warned = []
algorithm.AddObserver('WarningEvent', lambda caller, event: warned.append(event))
assert not shapetesting.run(algorithm) and warned == ['WarningEvent']
algorithm.SetNumberOfWeights(1)
assert not shapetesting.run(algorithm) and len(warned) == 1

# Wrong maps: the error names the filter, the fact and what is there instead.
algorithm = new(surface)
algorithm.SetMapArray('Elsewhere')
message = ' '.join(shapetesting.run(algorithm))
assert "Shape Morph: the Input has no point array 'Elsewhere'" in message, message
assert 'TargetPosition' in message
spoiled = copy(surface)
targets = end.copy()
targets[5] = numpy.nan
add_array(spoiled, targets, 'TargetPosition')
message = ' '.join(shapetesting.run(new(spoiled)))
assert 'the map array of the Input' in message and 'first at point 5' in message, message
print('shapes move to their images')
