"""Shape Parameterize: a closed surface of genus 0 to the unit sphere or an orbifold, an open one to the
disk or, its border free, to the plane.

As an example: give it a surface, take TargetPosition from the first output, or the image from the
second."""
import numpy
from paraview import simple
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
import shapemap

import shapetesting
from shapetesting import array, fact, points, read, triangles


def flipped(corners, sphere):
    """How many triangles of a spherical image do not face outwards."""
    a, b, c = (sphere[corners[:, i]] for i in range(3))
    return int((numpy.einsum('ij,ij->i', a, numpy.cross(b, c)) <= 0.0).sum())


def cloud(places):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    return data


def signed_areas(image):
    """Twice the areas of the triangles of a planar image, positive where counter-clockwise."""
    a, b, c = (points(image)[triangles(image)[:, i], :2] for i in range(3))
    return numpy.cross(b - a, c - a)


def error_of(data, landmarks=None, **properties):
    algorithm = shapetesting.new(
        shapemap.vtkShapeParameterize, data, None if landmarks is None else cloud(landmarks), **properties)
    said = shapetesting.refusal(algorithm)
    assert said or algorithm.GetOutputDataObject(0).GetNumberOfPoints() > 0
    return said


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
assert 'Shape Parameterize: the surface is closed; choose the Domain Sphere or Orbifold' in closed
assert 'Shape Parameterize: the surface has 2 open loops' in error_of(
    shapetesting.without_cells(mapped, (11, 400)), Domain=0)
assert 'the Domain needs one; choose FreeBoundary' in error_of(
    shapetesting.without_cells(mapped, (11, 400)), Domain=0)
assert 'the Domain needs a closed surface; choose FreeBoundary' in error_of(
    shapetesting.without_cells(mapped, (11, 400)), Domain=1)
assert not error_of(shapetesting.without_cells(mapped, (11,)), Domain=0)

# FreeBoundary, through ParaView's proxies: conformal, with the surface's area and a free border.
free_map = simple.ShapeParameterize(Input=cap, Domain='FreeBoundary')
assert free_map.Refine == 'None'
measured = {}
for refine, method in (('None', 'BoundaryFirst'), ('SymmetricDirichlet', 'SymmetricDirichlet')):
    free_map.Refine = refine
    free_map.UpdatePipeline()
    free = shapetesting.output(free_map, 1)
    assert fact(free, 'Parameterize.Method') == method
    assert (signed_areas(free) > 0.0).all() and (points(free)[:, 2] == 0.0).all()
    p = array(free, 'SourcePosition')[triangles(free)]
    area = numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum()
    assert refine != 'None' or abs(signed_areas(free).sum() / area - 1.0) < 1e-6, 'another area'
    measured[refine] = (fact(free, 'Parameterize.ConformalDistortion'),
                        fact(free, 'Parameterize.Energy'))
assert measured['None'][0] < 1.01, 'the free map is conformal: %s' % measured
assert 4.0 < measured['SymmetricDirichlet'][1] < measured['None'][1], measured
assert fact(free, 'Parameterize.LoopLength') > 4.0
disk_map.Outline = 'Circle'
disk_map.UpdatePipeline()
before = fact(shapetesting.output(disk_map), 'Parameterize.Energy')
disk_map.Refine = 'SymmetricDirichlet'
disk_map.UpdatePipeline()
refined = shapetesting.output(disk_map, 1)
assert fact(refined, 'Parameterize.Energy') < before and (signed_areas(refined) > 0.0).all()
assert abs(numpy.linalg.norm(points(refined), axis=1).max() - 1.0) < 1e-15, 'the outline moved'
assert not error_of(shapetesting.without_cells(mapped, (11, 400)), Domain=2, Refine=1)
assert 'the surface is closed; choose the Domain Sphere or Orbifold' in error_of(mapped, Domain=2)

# The Orbifold: cut open along a path through the landmarks, laid out on a tile.
ends = [[2.0, 0.0, 0.0], [-1.0, 2.0, 0.0], [-1.0, -2.0, 1.0], [0.0, 0.0, -2.0]]
places = simple.TrivialProducer()
places.GetClientSideObject().SetOutput(cloud(ends[:3]))
orbifold_map = simple.ShapeParameterize(Input=surface, Landmarks=places, Domain='Orbifold')
assert orbifold_map.Tile == 'Rhombus'
count = mapped.GetNumberOfPoints()
for tile, area in (('Square', 1.0), ('Rhombus', 0.75 ** 0.5), ('Triangle', 0.1875 ** 0.5)):
    orbifold_map.Tile = tile
    orbifold_map.UpdatePipeline()
    laid = shapetesting.output(orbifold_map, 1)
    assert (signed_areas(laid) > 0.0).all() and abs(signed_areas(laid).sum() - 2.0 * area) < 1e-12
    originals = array(laid, 'OriginalPointId')
    assert laid.GetNumberOfPoints() > count and (originals[:count] == numpy.arange(count)).all()
    whole = shapetesting.output(orbifold_map, 0)
    assert (array(laid, 'SourcePosition') == points(whole)[originals]).all()
    assert (array(whole, 'TargetPosition') == points(laid)[:count]).all()
    assert (originals[triangles(laid)] == triangles(whole)).all(), 'the triangles are the same'
    assert fact(laid, 'Parameterize.Method') == tile
four = shapemap.vtkShapeParameterize()
four.SetDomain(3)
blocks = vtkMultiBlockDataSet()  # the block and its arrays keep their places
blocks.SetBlock(1, mapped)
four.SetInputDataObject(0, blocks)
four.SetInputDataObject(1, cloud(ends))
assert not shapetesting.run(four)
laid = four.GetOutputDataObject(1).GetBlock(1)
assert (signed_areas(laid) > 0.0).all() and abs(signed_areas(laid).sum() - 2.0) < 1e-12
assert (array(laid, 'TargetPosition') == positions[array(laid, 'OriginalPointId')]).all()
assert fact(four.GetOutputDataObject(1), 'Parameterize.Method') == 'Parallelogram'
assert not error_of(clean.GetOutput(), [[1, 1, 1], [-1, -1, 1], [1, -1, -1]], Domain=3)

# Six cones: a polygon of the hyperbolic plane, inside the unit circle.
six = shapemap.vtkShapeParameterize()
six.SetInputDataObject(0, mapped)
six.SetInputDataObject(1, cloud(ends + [[0.0, 2.0, 2.0], [0.0, -2.0, 2.0]]))
six.SetDomain(3)
assert not shapetesting.run(six)
laid = six.GetOutputDataObject(1)
assert (signed_areas(laid) > 0.0).all() and numpy.linalg.norm(points(laid), axis=1).max() < 1.0
assert fact(laid, 'Parameterize.Method') == 'Hyperbolic' and fact(laid, 'Parameterize.Iterations') < 12

assert 'has 3 or more cones, but there are 0 Landmarks' in error_of(mapped, Domain=3)
assert 'but there are 2 Landmarks' in error_of(mapped, ends[:2], Domain=3)
assert 'are the same point' in error_of(mapped, ends[:2] + ends[:1], Domain=3)
assert 'Landmarks are the cones of the Orbifold' in error_of(mapped, ends, Domain=1)
assert '(genus 2)' in error_of(read('TwoTorusSmall.vtp'), ends, Domain=3)
assert 'open loop' in error_of(opened, ends, Domain=3)
print('a surface of genus 0 goes to the sphere or a tile, an open one to the plane, without a flip')
