"""Shape Morph: a shape on its way to its image, as time goes from 0 to 1.

As an example: Input carries the map array; press Play, or ask for a time."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkMultiBlockDataSet
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
