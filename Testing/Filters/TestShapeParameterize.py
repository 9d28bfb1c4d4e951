"""Shape Parameterize: a closed surface of genus 0 to the unit sphere, an open one to the disk.

As an example: give it a surface, take TargetPosition from the first output, or the image from the
second."""
import numpy
from paraview import simple
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkCommonTransforms import vtkTransform
import shapemap

import shapetesting
from shapetesting import array, fact, points, read, triangles


def flipped(corners, sphere):
    """How many triangles of a spherical image do not face outwards."""
    a, b, c = (sphere[corners[:, i]] for i in range(3))
    return int((numpy.einsum('ij,ij->i', a, numpy.cross(b, c)) <= 0.0).sum())


def error_of(data, **properties):
    algorithm = shapemap.vtkShapeParameterize()
    for name, value in properties.items():
        getattr(algorithm, 'Set' + name)(value)
    algorithm.SetInputDataObject(data)
    messages = shapetesting.run(algorithm)
    assert bool(messages) == (algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0)
    return ' '.join(messages)


# The example: through ParaView's own proxies.
surface = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
sphere_map = simple.ShapeParameterize(Input=surface, Domain='Sphere')
sphere_map.UpdatePipeline()
mapped = shapetesting.output(sphere_map, 0)
image = shapetesting.output(sphere_map, 1)

positions = array(mapped, 'TargetPosition')
assert abs(numpy.linalg.norm(positions, axis=1) - 1.0).max() < 1e-12, 'not on the sphere'
assert flipped(triangles(mapped), positions) == 0, 'triangles are flipped'
assert fact(mapped, 'Parameterize.Method') == 'ConformalFlow'
assert 1.0 <= fact(mapped, 'Parameterize.ConformalDistortion') < 1.02

# The image is the same map, seen from the other side.
assert (points(image) == positions).all()
assert (array(image, 'SourcePosition') == points(mapped)).all()
assert (triangles(image) == triangles(mapped)).all()

# Centred: the mean of the image, weighted by the surface's area, is the origin.
p = points(mapped)[triangles(mapped)]
areas = numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
weights = numpy.bincount(triangles(mapped).ravel(), numpy.repeat(areas, 3))
assert numpy.linalg.norm(weights @ positions / weights.sum()) < 1e-8, 'the map is not centred'

# Quadrilaterals are cut into triangles inside; the output keeps them, in single precision points.
cube = vtkCubeSource()
clean = vtkCleanPolyData()
clean.SetInputConnection(cube.GetOutputPort())
quads = shapemap.vtkShapeParameterize()
quads.SetInputConnection(clean.GetOutputPort())
assert not shapetesting.run(quads)
assert quads.GetOutputDataObject(0).GetNumberOfPolys() == 6
assert quads.GetOutputDataObject(0).GetPoints().GetDataType() == 10
corners = array(quads.GetOutputDataObject(0), 'TargetPosition')
assert numpy.allclose(abs(corners), 1.0 / numpy.sqrt(3.0), atol=0.05), 'a cube stays nearly a cube'

# What a sphere map cannot be made of is refused with the fact and the remedy.
torus = error_of(read('TwoTorusSmall.vtp'))
assert 'Shape Parameterize: the surface has Euler number -2 (genus 2)' in torus, torus
shifted = vtkTransformPolyDataFilter()
shifted.SetInputData(mapped)
transform = vtkTransform()
transform.Translate(5.0, 0.0, 0.0)
shifted.SetTransform(transform)
both = vtkAppendPolyData()
both.AddInputData(mapped)
both.AddInputConnection(shifted.GetOutputPort())
both.Update()
assert 'has 2 components' in error_of(both.GetOutput())
opened = shapetesting.without_cells(mapped, (11,))
assert '1 open loop' in error_of(opened), error_of(opened)

# The Disk, through ParaView's proxies: the upper half of an ellipsoid.
half = simple.Clip(Input=surface, ClipType='Plane', Invert=0)
half.ClipType.Origin = [0.0, 0.0, 0.013]  # through no point
half.ClipType.Normal = [0.0, 0.0, 1.0]
cap = simple.Triangulate(Input=simple.ExtractSurface(Input=half))
disk_map = simple.ShapeParameterize(Input=cap, Domain='Disk')
assert disk_map.Weights == 'MeanValue' and disk_map.Outline == 'Circle'
for weights in ('Uniform', 'MeanValue'):
    for outline in ('Circle', 'Square'):
        disk_map.Weights = weights
        disk_map.Outline = outline
        disk_map.UpdatePipeline()
        disk = shapetesting.output(disk_map, 0)
        plane = array(disk, 'TargetPosition')
        assert (plane[:, 2] == 0.0).all(), 'the disk lies in z = 0'
        a, b, c = (plane[triangles(disk)[:, i], :2] for i in range(3))
        cross = numpy.cross(b - a, c - a)
        assert (cross > 0.0).all(), 'triangles run counter-clockwise, as they do seen from outside'
        covered = 0.5 * cross.sum()
        if outline == 'Circle':
            assert 0.98 * numpy.pi < covered < numpy.pi, covered
            assert abs(numpy.linalg.norm(plane, axis=1).max() - 1.0) < 1e-15
        else:
            assert abs(covered - 4.0) < 1e-12 and abs(plane).max() == 1.0, covered
        assert fact(disk, 'Parameterize.Method') == weights
        assert fact(disk, 'Parameterize.FlippedTriangles') == 0
        assert fact(disk, 'Parameterize.LoopLength') > 4.0
        if weights == 'MeanValue' and outline == 'Circle':
            assert fact(disk, 'Parameterize.ConformalDistortion') < 1.2
            assert (points(shapetesting.output(disk_map, 1)) == plane).all()

# What a disk map cannot be made of is refused with the fact and the remedy.
closed = error_of(mapped, Domain=0)
assert 'Shape Parameterize: the surface is closed; cut it first with Shape Cut Feature' in closed
assert 'Shape Parameterize: the surface has 2 open loops' in error_of(
    shapetesting.without_cells(mapped, (11, 400)), Domain=0)
assert 'fill all but the outer one with Shape Fill Holes' in error_of(
    shapetesting.without_cells(mapped, (11, 400)), Domain=0)
assert not error_of(shapetesting.without_cells(mapped, (11,)), Domain=0)
print('a surface of genus 0 goes to the sphere, an open one to the disk, without a flip')
