"""Shape Geodesic Distance: how far it is along a surface from the nearest seed to each of its points.

As an example: Seeds is any dataset, here two points near the poles of a sphere."""
import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
import shapemap

import shapetesting
from shapetesting import array, copy, fact, points, read

HEAT, EXACT, DIJKSTRA = range(3)


def new(surface, seeds, method=EXACT):
    return shapetesting.new(shapemap.vtkShapeGeodesicDistance, surface, seeds, Method=method)


def distances(surface, seeds, method=EXACT):
    return array(shapetesting.outputs(new(surface, seeds, method))[0], 'GeodesicDistance')


# The example: the distance to the nearer pole of the unit sphere, and its level set.
sphere = simple.Sphere(Radius=1.0, ThetaResolution=64, PhiResolution=64)
line = simple.Line(Point1=[0, 0, -1.2], Point2=[0, 0, 1.2], Resolution=1)
from_poles = simple.ShapeGeodesicDistance(Input=sphere, Seeds=line)
from_poles.Method = 'Exact'
level = simple.Contour(Input=from_poles, ContourBy=['POINTS', 'GeodesicDistance'],
                       Isosurfaces=[numpy.pi / 3])
level.UpdatePipeline()
rings = points(shapetesting.output(level))
assert len(rings) >= 128
assert abs(abs(rings[:, 2]) - 0.5).max() < 2e-3, 'not on the circles of 60 degrees'
surface = shapetesting.output(from_poles)
angles = numpy.arccos(numpy.clip(abs(points(surface)[:, 2]), 0, 1))
for method, most in (('Exact', 1e-3), ('Dijkstra', 0.3), ('Heat', 0.05)):
    from_poles.Method = method
    from_poles.UpdatePipeline()
    found = array(shapetesting.output(from_poles), 'GeodesicDistance')
    assert abs(found - angles).max() < most, (method, abs(found - angles).max())

surface_of_sphere = surface

# Seeds of several blocks count, and those of a selection, which ParaView extracts as a grid.
surface = read('DentedSphere600.vtp')
seeds = vtkMultiBlockDataSet()
model = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
query = simple.SelectionQuerySource(QueryString='id == 50', ElementType='Point Data')
selected = simple.ExtractSelection(Input=model, Selection=query)
selected.UpdatePipeline()
seeds.SetBlock(0, copy(shapetesting.output(selected)))
assert seeds.GetBlock(0).GetClassName() == 'vtkUnstructuredGrid'
source = simple.PointSource(Center=points(surface)[400], NumberOfPoints=1)
source.UpdatePipeline()
seeds.SetBlock(1, copy(shapetesting.output(source)))
assert distances(surface, seeds.GetBlock(0))[50] == 0.0
nearest = numpy.minimum(distances(surface, seeds.GetBlock(0)), distances(surface, seeds.GetBlock(1)))
assert abs(distances(surface, seeds) - nearest).max() < 1e-12
assert distances(surface, surface).max() == 0.0

# Seeds may also be positions, which are projected; they add to the data set.
picked = simple.ShapeGeodesicDistance(Input=sphere, SeedPoints=[0, 0, 1.2], Method='Exact')
picked.UpdatePipeline()
one = array(shapetesting.output(picked), 'GeodesicDistance')
assert abs(one - numpy.arccos(numpy.clip(points(surface_of_sphere)[:, 2], -1, 1))).max() < 3e-3
picked.Seeds = simple.PointSource(Center=[0, 0, -1], NumberOfPoints=1)
picked.UpdatePipeline()
two = array(shapetesting.output(picked), 'GeodesicDistance')
assert abs(two - angles).max() < 1e-3
for seeds_of_one in ([0, 1.2, 0], [0, 0, 1.2]):  # what is kept of the surface gives the same
    picked.Seeds, picked.SeedPoints, picked.Method = None, seeds_of_one, 'Heat'
    picked.UpdatePipeline()
    again = simple.ShapeGeodesicDistance(Input=sphere, SeedPoints=seeds_of_one)
    again.UpdatePipeline()
    assert (array(shapetesting.output(picked), 'GeodesicDistance') ==
            array(shapetesting.output(again), 'GeodesicDistance')).all()
none = shapemap.vtkShapeGeodesicDistance()
none.SetInputDataObject(0, surface)
assert 'Shape Geodesic Distance: no seed; press Pick and click on the surface, or connect points to Seeds' in \
    ' '.join(shapetesting.run(none))

# A component without a seed is told from one with.
apart = vtkMultiBlockDataSet()
apart.SetBlock(0, surface)
far = copy(surface)
shapetesting.set_points(far, points(far) + [10, 0, 0])
apart.SetBlock(2, far)
for method in (HEAT, EXACT, DIJKSTRA):
    algorithm = new(apart, seeds.GetBlock(0), method)
    assert not shapetesting.run(algorithm)
    tree = algorithm.GetOutputDataObject(0)
    alone = distances(surface, seeds.GetBlock(0), method)
    assert abs(array(tree.GetBlock(0), 'GeodesicDistance') - alone).max() < 1e-2 * alone.max()
    assert (array(tree.GetBlock(2), 'GeodesicDistance') == -1).all()
    assert fact(tree, 'GeodesicDistance.UnreachedPoints') == far.GetNumberOfPoints()

# What is no surface is refused with the fact.
turned = copy(surface)
turned.BuildCells()
turned.ReverseCell(7)
algorithm = new(turned, surface)
message = ' '.join(shapetesting.run(algorithm))
assert 'Shape Geodesic Distance: the surface' in message, message
assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0
print('distances are those of great circles, to the nearest seed')
