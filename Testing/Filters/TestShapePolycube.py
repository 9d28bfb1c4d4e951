"""Shape Polycube: a closed surface on a shape whose faces lie across the axes.

As an example: give it a closed surface; colour the second output by Label to see the charts, and
the first one to see where they come from."""
import os
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
import shapemap

import shapetesting
from shapetesting import array, fact, points, triangles

sys.path.append(os.path.join(shapetesting.ROOT, 'Utilities'))
import off

AXES = numpy.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])


def labels(surface):
    return vtk_to_numpy(surface.GetCellData().GetArray('Label'))


def result(source):
    source.UpdatePipeline()
    return shapetesting.output(source)


def made(surface, **settings):
    algorithm = shapetesting.new(shapemap.vtkShapePolycube, surface, **settings)
    said = shapetesting.refusal(algorithm)
    return algorithm.GetOutputDataObject(0), algorithm.GetOutputDataObject(1), said


def check_faces(image):
    """Each triangle lies in the plane of its label, at a whole multiple of the unit, the right way
    up."""
    corners = points(image)[triangles(image)]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (numpy.einsum('ij,ij->i', normals, AXES[labels(image)]) > 0.0).all(), 'one is turned over'
    heights = numpy.take_along_axis(corners, (labels(image) // 2)[:, None, None], axis=2)[:, :, 0]
    assert (heights == heights[:, :1]).all(), 'a triangle is not flat across its axis'
    units = heights / fact(image, 'Polycube.EdgeLength')
    assert numpy.allclose(units, numpy.round(units), atol=1e-9)


# The example: an ellipsoid becomes a box.
ellipsoid = simple.Transform(Input=simple.Sphere(ThetaResolution=40, PhiResolution=40))
ellipsoid.Transform.Scale = [2.0, 1.0, 1.0]
polycube = simple.ShapePolycube(Input=ellipsoid)
polycube.UpdatePipeline()
surface, image = shapetesting.output(polycube, 0), shapetesting.output(polycube, 1)
assert numpy.array_equal(array(surface, 'TargetPosition'), points(image))
assert numpy.array_equal(array(image, 'SourcePosition'), points(surface))
assert numpy.array_equal(labels(surface), labels(image))
assert set(labels(image)) == set(range(6)), 'a side of the box is missing'
assert fact(image, 'Polycube.Charts') == 6 and fact(image, 'Polycube.Corners') == 8

check_faces(image)
assert 1.0 <= fact(image, 'Polycube.Distortion') < 1.5

# A cube is its own polycube, and the unit can be chosen.
box = result(simple.Clean(Input=simple.Triangulate(Input=simple.Box())))
same, cube, said = made(box, TargetEdgeLength=0.25)
assert not said, said
assert fact(cube, 'Polycube.EdgeLength') == 0.25
assert numpy.allclose(numpy.ptp(points(cube), axis=0), 1.0, atol=0.25 + 1e-9)
assert len(set(labels(cube))) == 6

# What cannot be is said.
sheet = result(simple.Triangulate(Input=simple.Plane()))
assert 'open loop' in made(sheet)[2]
assert 'Compactness' in made(box, Compactness=0.0)[2]

# A real part: the side of its thin hole has a chart to each side, and none that folds over itself. Where
# its triangles are too coarse for that, the charts at fault are named.
coarse = off.read(os.path.join(shapetesting.MODELS, 'joint.off'))
shapetesting.check_refused(
    shapetesting.new(shapemap.vtkShapePolycube, coarse, TargetEdgeLength=0.08), 'inverts', ' of chart ')
finer = vtkLinearSubdivisionFilter()
finer.SetNumberOfSubdivisions(1)
finer.SetInputData(coarse)
finer.Update()
same, cube, said = made(finer.GetOutput(), TargetEdgeLength=0.08)
assert not said, said
check_faces(cube)
