"""Shape Boundary Distance: how far points are from a surface, negative inside the solid it bounds.

As an example: Input is whose points get the array BoundaryDistance, Surface what it is measured to."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
import shapemap

import shapetesting
from shapetesting import array, copy, points, read


def new(data, surface):
    return shapetesting.new(shapemap.vtkShapeBoundaryDistance, data, surface)


def distances(data, surface, signed=True):
    algorithm = new(data, surface)
    algorithm.SetSigned(signed)
    assert not shapetesting.run(algorithm)
    return array(algorithm.GetOutputDataObject(0), 'BoundaryDistance')


def error_of(data, surface):
    return shapetesting.refusal(new(data, surface))


def cube(side, turned=False):
    """A closed cube of six quadrilaterals, in single precision."""
    source = vtkCubeSource()
    source.SetXLength(side)
    source.SetYLength(side)
    source.SetZLength(side)
    clean = vtkCleanPolyData()
    clean.SetInputConnection(source.GetOutputPort())
    clean.Update()
    surface = clean.GetOutput()
    if turned:
        surface.BuildCells()
        for cell in range(surface.GetNumberOfCells()):
            surface.ReverseCell(cell)
    return surface


def cube_distance(places, side):
    """The signed distance to a cube, in closed form."""
    beyond = abs(places) - side / 2
    return numpy.linalg.norm(numpy.maximum(beyond, 0), axis=1) + numpy.minimum(
        beyond.max(axis=1), 0)


# The example: the field of a grid around a model, and its level set.
model = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
grid = simple.Wavelet(WholeExtent=[-15, 15, -15, 15, -15, 15])
small = simple.Transform(Input=grid)
small.Transform.Scale = [0.1, 0.1, 0.1]
distance = simple.ShapeBoundaryDistance(Input=small, Surface=model)
level = simple.Contour(Input=distance, ContourBy=['POINTS', 'BoundaryDistance'], Isosurfaces=[0.1])
level.UpdatePipeline()
apart = shapetesting.output(level, 0)
assert apart.GetNumberOfPoints() > 1000
off = abs(distances(apart, read('DentedSphere600.vtp')) - 0.1)
# The field has creases in the dents, between which the level set is a chord.
assert off.mean() < 1e-3 and off.max() < 0.02, 'the level set of 0.1 is not 0.1 away'

# Image data stay image data; the distance to a cube is the closed form's.
image = vtkImageData()
image.SetDimensions(13, 13, 13)
image.SetOrigin(-1.5, -1.5, -1.5)
image.SetSpacing(0.25, 0.25, 0.25)
places = numpy.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
algorithm = new(image, cube(1.5))
assert not shapetesting.run(algorithm)
output = algorithm.GetOutputDataObject(0)
assert output.GetClassName() == 'vtkImageData' and output.GetDimensions() == (13, 13, 13)
exact = cube_distance(places, 1.5)
assert abs(array(output, 'BoundaryDistance') - exact).max() < 1e-14
assert abs(distances(image, cube(1.5, turned=True)) - exact).max() < 1e-14
assert abs(distances(image, cube(1.5), signed=False) - abs(exact)).max() < 1e-14

# A surface within bounds a void, whichever way either faces, also as two blocks.
shell = numpy.maximum(exact, -cube_distance(places, 0.875))
for turned in range(4):
    parts = cube(1.5, turned & 1), cube(0.875, turned & 2)
    joined = vtkAppendPolyData()
    blocks = vtkMultiBlockDataSet()
    for i, part in enumerate(parts):
        joined.AddInputData(part)
        blocks.SetBlock(i, part)
    joined.Update()
    assert abs(distances(image, joined.GetOutput()) - shell).max() < 1e-14, turned
    assert abs(distances(image, blocks) - shell).max() < 1e-14, turned

# Blocks get the values that they get alone; a solid keeps its cells.
ball = read('BallSmall.vtu')
surface = read('DentedSphere600.vtp')
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, image)
blocks.SetBlock(2, ball)
algorithm = new(blocks, surface)
assert not shapetesting.run(algorithm)
tree = algorithm.GetOutputDataObject(0)
assert tree.GetNumberOfBlocks() == 3 and tree.GetBlock(1) is None
assert (array(tree.GetBlock(0), 'BoundaryDistance') == distances(image, surface)).all()
assert (array(tree.GetBlock(2), 'BoundaryDistance') == distances(ball, surface)).all()
assert tree.GetBlock(2).GetNumberOfCells() == 864
assert (points(tree.GetBlock(2)) == points(ball)).all()

# What has no inside is refused with the fact and the remedy, and measured without a sign.
opened = copy(surface)
opened.BuildLinks()
opened.DeleteCell(3)
opened.RemoveDeletedCells()
message = error_of(image, opened)
assert 'Shape Boundary Distance: the Surface has 1 open loop' in message, message
assert 'turn Signed off' in message, message
assert distances(image, opened, signed=False).min() >= 0
crossing = vtkMultiBlockDataSet()
crossing.SetBlock(0, cube(1.0))
moved = cube(1.0)
shapetesting.set_points(moved, points(moved) + 0.5)
crossing.SetBlock(1, moved)
assert 'touch or cross' in error_of(image, crossing)
crossing.SetBlock(1, ball)
message = error_of(image, crossing)
assert "the input 'Surface' has 864 cells that are no triangle" in message, message
assert 'a vtkHexahedron' in message and 'Extract Surface' in message, message
print('distances are exact, and negative in the solid alone')
