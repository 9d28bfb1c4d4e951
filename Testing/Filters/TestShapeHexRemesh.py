"""Shape Hex Remesh: the solid inside a closed surface as hexahedra.

As an example: give it a closed surface; colour the hexahedra by ScaledJacobian, and Clip them to see
inside; the second output is their boundary."""
import os
import tempfile

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkRectilinearGrid
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
import shapemap

import shapetesting
from shapetesting import fact, points


def hexahedra(solid):
    assert (vtk_to_numpy(solid.GetCellTypesArray()) == 12).all(), 'there are other cells'
    return vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 8)


def quads(boundary):
    return vtk_to_numpy(boundary.GetPolys().GetConnectivityArray()).reshape(-1, 4)


def words(data, name):
    return shapetesting.facts(data).GetAbstractArray(name).GetValue(0)


def made(surface, polycube=None, inner=(), **settings):
    algorithm = shapemap.vtkShapeHexRemesh()
    algorithm.SetInputDataObject(surface)
    if polycube:
        algorithm.SetInputDataObject(1, polycube)
    for data in inner:
        producer = vtkTrivialProducer()
        producer.SetOutput(data)
        algorithm.AddInnerSurfaces(producer.GetOutputPort())
    for name, value in settings.items():
        getattr(algorithm, 'Set' + name)(value)
    messages = shapetesting.run(algorithm)
    solid, boundary = algorithm.GetOutputDataObject(0), algorithm.GetOutputDataObject(1)
    assert not messages or solid.GetNumberOfPoints() == 0, 'an error left a part of an output'
    return solid, boundary, ' '.join(messages)


MEASURES = ('Jacobian', 'Volume', 'EdgeRatio', 'MaxAspectFrobenius', 'EquiangleSkew', 'Skew', 'Taper',
            'Shape')


def check_measures(solid):
    """They are those of the Mesh Quality filter, and the field data sum them up."""
    assert solid.GetNumberOfCells() > 0, 'there are no hexahedra'
    quality = vtkMeshQuality()
    quality.SetInputDataObject(solid)
    for name in MEASURES:
        getattr(quality, 'SetHexQualityMeasureTo' + name)()
        quality.Update()
        expected = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray('Quality'))
        own = vtk_to_numpy(solid.GetCellData().GetArray(name))
        assert (own == expected).all(), name
        summary = shapetesting.facts(solid).GetArray('HexRemesh.' + name)
        assert [summary.GetComponentName(k) for k in range(3)] == ['Minimum', 'Mean', 'Maximum']
        assert numpy.allclose(summary.GetTuple3(0), (own.min(), own.mean(), own.max()),
                              rtol=1e-12), name
    # What bounds a hexahedron that is not inverted.
    own = {name: vtk_to_numpy(solid.GetCellData().GetArray(name)) for name in MEASURES}
    assert own['Jacobian'].min() > 0.0 and own['Volume'].min() > 0.0
    assert own['EdgeRatio'].min() >= 1.0 and own['MaxAspectFrobenius'].min() >= 1.0 - 1e-9
    for name in ('EquiangleSkew', 'Skew', 'Shape'):
        assert own[name].min() >= 0.0 and own[name].max() <= 1.0 + 1e-9, name


def check(solid, boundary, euler):
    """What holds for every result."""
    assert solid.GetNumberOfCells() > 0, 'there are no hexahedra'
    quality = vtkMeshQuality()
    quality.SetInputDataObject(solid)
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    scaled = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray('Quality'))
    own = vtk_to_numpy(solid.GetCellData().GetArray('ScaledJacobian'))
    assert numpy.abs(own - scaled).max() < 1e-12
    assert scaled.min() > 0.0, 'a hexahedron is inverted'
    check_measures(solid)
    assert fact(solid, 'HexRemesh.MinimumScaledJacobian') == own.min()
    assert abs(fact(solid, 'HexRemesh.MeanScaledJacobian') - own.mean()) < 1e-12
    histogram = vtk_to_numpy(
        shapetesting.facts(solid).GetArray('HexRemesh.ScaledJacobianHistogram'))[0]
    assert (histogram == numpy.histogram(own, numpy.linspace(0.0, 1.0, 21))[0]).sum() >= 19
    assert histogram.sum() == len(own) == fact(solid, 'HexRemesh.Hexahedra')
    # The quads are the faces that one hexahedron has alone.
    faces = hexahedra(solid)[:, [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2],
                                 [0, 3, 2, 1], [4, 5, 6, 7]]].reshape(-1, 4)
    alone, counts = numpy.unique(numpy.sort(faces, axis=1), axis=0, return_counts=True)
    ids = vtk_to_numpy(boundary.GetPointData().GetArray('OriginalPointId'))
    own_quads = numpy.sort(ids[quads(boundary)], axis=1)
    assert counts.max() == 2
    assert (numpy.unique(own_quads, axis=0) == alone[counts == 1]).all()
    assert (points(solid)[ids] == points(boundary)).all()
    edges = numpy.sort(numpy.concatenate([quads(boundary)[:, [k, (k + 1) % 4]] for k in range(4)]),
                       axis=1)
    edges, counts = numpy.unique(edges, axis=0, return_counts=True)
    assert (counts == 2).all(), 'the boundary is no manifold'
    assert boundary.GetNumberOfPoints() - len(edges) + boundary.GetNumberOfPolys() == euler
    assert fact(solid, 'HexRemesh.EulerNumber') == euler
    distances = vtk_to_numpy(boundary.GetCellData().GetArray('Distance'))
    assert distances.max() <= fact(solid, 'HexRemesh.Distance') * (1.0 + 1e-9) + 1e-12
    return own


# The example: a cylinder, through ParaView's own proxies. Its rims are creases.
cylinder = simple.Cylinder(Resolution=60, Height=2.0)
closed = simple.Clean(Input=simple.Triangulate(Input=cylinder))
remesh = simple.ShapeHexRemesh(Surface=closed, CellSize=0.08)
remesh.UpdatePipeline()
solid, boundary = shapetesting.output(remesh, 0), shapetesting.output(remesh, 1)
own = check(solid, boundary, 2)
assert own.min() > 0.3, own.min()
assert fact(solid, 'HexRemesh.CreasesKept') == 1 and fact(solid, 'HexRemesh.Patches') == 3
assert fact(solid, 'HexRemesh.LostCreases') == 0
assert words(solid, 'HexRemesh.Method') in ('Polycube', 'Grid') and words(solid, 'HexRemesh.Reason')
volume = 2.0 * 60.0 * 0.5 * 0.25 * numpy.sin(numpy.pi / 30.0)
sized = simple.IntegrateVariables(Input=simple.CellSize(Input=remesh))
sized.UpdatePipeline()
total = shapetesting.output(sized).GetCellData().GetArray('Volume').GetValue(0)
assert abs(total / volume - 1.0) < 0.01, total
# From these measures of the surface, the panel estimates the number of hexahedra.
remesh.UpdatePropertyInformation()
size = list(remesh.GetProperty('SurfaceSize'))
side = 60.0 * numpy.sin(numpy.pi / 60.0) * 2.0
assert numpy.allclose(size, [volume, side + volume, 2.0], rtol=1e-5), size
# Its rims lie on the planes of its ends.
ends = numpy.abs(numpy.abs(points(boundary)[:, 1]) - 1.0) < 1e-9
radii = numpy.linalg.norm(points(boundary)[ends][:, [0, 2]], axis=1)
assert radii.max() > 0.5 * numpy.cos(numpy.pi / 60.0) - 1e-9

# Both methods, on a torus.
source = simple.Superquadric()
source.Toroidal = 1
source.PhiRoundness = 1.0
source.ThetaRoundness = 1.0
source.ThetaResolution = 48
source.PhiResolution = 48
ring = simple.Clean(Input=simple.Triangulate(Input=source), PointMerging=1)
ring.UpdatePipeline()
torus = shapetesting.output(ring)
for method, name in ((1, 'Polycube'), (2, 'Grid')):
    solid, boundary, said = made(torus, Method=method, CellSize=0.06)
    assert not said, said
    check(solid, boundary, 0)
    assert words(solid, 'HexRemesh.Method') == name
    assert words(solid, 'HexRemesh.Reason').startswith('chosen as Method')

# The size of cells as a number of them on the longest side.
sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
sphere.UpdatePipeline()
ball = shapetesting.output(sphere)
solid, boundary, said = made(ball, Method=2, CellsOnLongestSide=10)
assert not said, said
check(solid, boundary, 2)
longest = numpy.ptp(points(ball), axis=0).max()
assert abs(fact(solid, 'HexRemesh.CellSize') - longest / 10.0) < 1e-9
said = made(ball, CellsOnLongestSide=10, CellSize=0.1)[2]
assert 'CellSize' in said and 'CellsOnLongestSide' in said, said

# Sizes along the surface: twice as large at the top as at the bottom.
globe = simple.Sphere(Radius=1.0, ThetaResolution=40, PhiResolution=40)
sized = simple.Calculator(Input=globe, ResultArrayName='Size', Function='0.12 + 0.06 * coordsZ + 0.06')
remesh = simple.ShapeHexRemesh(Surface=sized)
assert remesh.SizeArray == 'None', 'a size array is chosen by itself'
remesh.SizeArray = 'Size'
remesh.UpdatePipeline()
solid, boundary = shapetesting.output(remesh, 0), shapetesting.output(remesh, 1)
check(solid, boundary, 2)
assert words(solid, 'HexRemesh.Method') == 'Grid'
assert 'SizeArray' in words(solid, 'HexRemesh.Reason')
corners = points(boundary)[quads(boundary)]
areas = 0.5 * numpy.linalg.norm(numpy.cross(corners[:, 2] - corners[:, 0],
                                            corners[:, 3] - corners[:, 1]), axis=1)
ratios = numpy.sqrt(areas) / (0.18 + 0.06 * corners[:, :, 2].mean(axis=1))
assert abs(numpy.median(ratios) - 1.0) < 0.1, numpy.median(ratios)
assert numpy.quantile(ratios, 0.85) < 1.2, numpy.quantile(ratios, 0.85)
assert abs(fact(solid, 'HexRemesh.MedianSizeRatio') - numpy.median(ratios)) < 0.01
assert fact(solid, 'HexRemesh.ShareOfSizesMet') > 0.85
surface = shapetesting.output(sized)
good = shapetesting.array(surface, 'Size').copy()
for settings, expected in (({'SizeArray': 'Sise'}, "no point array 'Sise'"),
                           ({'SizeArray': 'Normals'}, 'Normals'),
                           ({'SizeArray': 'Size', 'CellSize': 0.2}, 'CellSize'),
                           ({'SizeArray': 'Size', 'Method': 1}, 'grid')):
    assert expected in made(surface, **settings)[2], (settings, made(surface, **settings)[2])
for bad in (0.0, -1.0, numpy.nan, numpy.inf):
    spoiled = shapetesting.copy(surface)
    values = good.copy()
    values[5] = bad
    shapetesting.add_array(spoiled, values, 'Size')
    assert 'first at point 5' in made(spoiled, SizeArray='Size')[2], bad

# Inner surfaces: two balls side by side and one in one of them are regions of their own, and
# hexahedra share the points between them.


def sphere_of(radius, centre):
    source = simple.Sphere(Radius=radius, Center=centre, ThetaResolution=40, PhiResolution=40)
    source.UpdatePipeline()
    return shapetesting.output(source)


centres, radii = numpy.array([[0, 0.45, 0], [0, -0.4, 0], [0, -0.4, 0]]), (0.3, 0.4, 0.2)
inner = [sphere_of(radius, list(centre)) for radius, centre in zip(radii, centres)]
outer = sphere_of(1.0, [0, 0, 0])
solid, boundary, said = made(outer, inner=inner, CellSize=0.14)
assert not said, said
check_measures(solid)
assert vtk_to_numpy(solid.GetCellData().GetArray('ScaledJacobian')).min() > 0.2
assert 'InnerSurfaces' in words(solid, 'HexRemesh.Reason') and fact(solid, 'HexRemesh.Regions') == 4
assert fact(solid, 'HexRemesh.InnerCreasesKept') == 1
region = vtk_to_numpy(solid.GetCellData().GetArray('RegionId'))
volumes = numpy.bincount(region, vtk_to_numpy(solid.GetCellData().GetArray('Volume')))
balls = 4.0 / 3.0 * numpy.pi * numpy.array(radii) ** 3
exact = numpy.array([4.0 / 3.0 * numpy.pi - balls[0] - balls[1], balls[0], balls[1] - balls[2],
                     balls[2]])
assert (abs(volumes - exact) < numpy.array([0.03, 0.09, 0.09, 0.2]) * exact).all(), volumes / exact
interface = vtk_to_numpy(boundary.GetCellData().GetArray('Interface'))
distances = vtk_to_numpy(boundary.GetCellData().GetArray('Distance'))
ids = vtk_to_numpy(boundary.GetPointData().GetArray('OriginalPointId'))
locator = vtkImplicitPolyDataDistance()
for i, data in enumerate(inner):
    own = quads(boundary)[interface == i + 1]
    locator.SetInput(data)
    assert max(abs(locator.EvaluateFunction(place))
               for place in points(boundary)[numpy.unique(own)]) < 1e-6
    # The middle of a quad that is not flat lies off its two triangles, between which and the surface
    # InnerDistance is, as seen at places that are so far apart.
    corners = points(boundary)[own]
    bend = numpy.linalg.norm(corners[:, 1] + corners[:, 3] - corners[:, 0] - corners[:, 2], axis=1) / 4.0
    spacing = numpy.sqrt(4.0 * numpy.pi * radii[i] ** 2 / 50000.0)
    excess = distances[interface == i + 1] - fact(solid, 'HexRemesh.InnerDistance') - bend - spacing
    assert excess.max() <= 0.0, excess.max()
    # Each of the quads is a face of two hexahedra, of the two regions.
    around = (0, 0, 2)[i]
    faces = {}
    for hexahedron, number in zip(hexahedra(solid), region):
        for face in ([0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1],
                     [4, 5, 6, 7]):
            faces.setdefault(tuple(sorted(hexahedron[face])), []).append(number)
    assert all(sorted(faces[tuple(sorted(ids[quad]))]) == [around, i + 1] for quad in own)
# Abaqus gets the nodes between regions as sets.
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, 'balls.inp')
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(solid)
    simple.SaveData(path, producer)
    text = open(path).read()
    for name in ('Region0', 'Region1', 'Region2', 'Region3', 'Interface0_1', 'Interface0_2',
                 'Interface2_3'):
        assert 'SET=' + name in text, name
for data, expected in (([sphere_of(0.5, [0.8, 0, 0])], 'cross'), ([sphere_of(0.3, [3, 0, 0])], 'outside'),
                       ([inner[0], sphere_of(0.3, [0.1, 0.5, 0.1])], 'cross'),
                       ([shapetesting.without_cells(inner[0], [3])], 'open')):
    assert expected in made(outer, inner=data, CellSize=0.14)[2], (expected, made(
        outer, inner=data, CellSize=0.14)[2])
assert 'grid' in made(outer, inner=inner, Method=1)[2]

# A polycube: what Shape Polycube makes is taken as it is. A box, an ellipsoid and a ring of tubes.
around, across = 40, 20
angles = numpy.stack(numpy.meshgrid(numpy.arange(around) * 2.0 * numpy.pi / around,
                                    numpy.arange(across) * 2.0 * numpy.pi / across,
                                    indexing='ij'), axis=-1).reshape(-1, 2)
reach = 1.0 + 0.45 * numpy.cos(angles[:, 1])
index = numpy.arange(around * across).reshape(around, across)
faces = [numpy.roll(index, shift, axis=(0, 1)).ravel()
         for shift in ((0, 0), (-1, 0), (-1, -1), (0, -1))]
torus = vtkPolyData()
torus.SetPoints(vtkPoints())
shapetesting.set_points(torus, numpy.stack(
    [reach * numpy.cos(angles[:, 0]), reach * numpy.sin(angles[:, 0]),
     0.45 * numpy.sin(angles[:, 1])], axis=1))
cells = vtkCellArray()
cells.SetData(4, numpy_to_vtkIdTypeArray(numpy.stack(faces, axis=1).astype(numpy.int64).ravel(),
                                         deep=True))
torus.SetPolys(cells)
tube = simple.TrivialProducer()
tube.GetClientSideObject().SetOutput(torus)
box = simple.Clean(Input=simple.Triangulate(Input=simple.Box(XLength=2.0)))
ellipsoid = simple.Transform(Input=simple.Sphere(ThetaResolution=40, PhiResolution=40))
ellipsoid.Transform.Scale = [2.0, 1.0, 1.0]
for surface, size, euler in ((box, 0.25, 2), (ellipsoid, 0.15, 2), (tube, 0.2, 0)):
    polycube = simple.ShapePolycube(Input=surface, TargetEdgeLength=size)
    polycube.UpdatePipeline()
    remesh = simple.ShapeHexRemesh(Surface=surface, CellSize=size)
    remesh.Polycube = simple.OutputPort(polycube, 1)
    remesh.UpdatePipeline()
    solid, boundary = shapetesting.output(remesh, 0), shapetesting.output(remesh, 1)
    own = check(solid, boundary, euler)
    assert own.min() > 0.3, own.min()
    assert words(solid, 'HexRemesh.Method') == 'Polycube'
    assert words(solid, 'HexRemesh.Reason').startswith('the Polycube is given')
    if surface is box:
        assert own.min() > 0.999 and fact(solid, 'HexRemesh.CreasesKept') == 1

# A cube with a small cube on its top, whose creases are lost: the facts say where they are.
steps = vtkRectilinearGrid()
steps.SetDimensions(4, 4, 3)
for put, values in ((steps.SetXCoordinates, (0.0, 1.5, 1.6, 3.0)),
                    (steps.SetYCoordinates, (0.0, 1.5, 1.6, 3.0)),
                    (steps.SetZCoordinates, (0.0, 3.0, 3.1))):
    put(numpy_to_vtk(numpy.array(values), deep=True))
filled = numpy_to_vtk(numpy.array([1] * 9 + [0] * 4 + [1] + [0] * 4), deep=True)
filled.SetName('Filled')
steps.GetCellData().AddArray(filled)
boxes = simple.TrivialProducer()
boxes.GetClientSideObject().SetOutput(steps)
solids = simple.Threshold(Input=boxes, Scalars=['CELLS', 'Filled'], LowerThreshold=1, UpperThreshold=1)
boss = simple.Clean(Input=simple.Triangulate(Input=simple.ExtractSurface(Input=solids)))
remesh = simple.ShapeHexRemesh(Surface=boss, CellSize=0.6, Method='Grid')
remesh.UpdatePipeline()
solid = shapetesting.output(remesh, 0)
check(solid, shapetesting.output(remesh, 1), 2)
assert fact(solid, 'HexRemesh.LostCreases') == 12 and fact(solid, 'HexRemesh.CreasesKept') == 0
assert '12 creases are lost' in words(solid, 'HexRemesh.Reason')
facts = shapetesting.facts(solid)
middles = vtk_to_numpy(facts.GetArray('HexRemesh.LostCreasePositions')).reshape(-1, 3)
assert middles.shape == (12, 3) and abs(middles - (1.55, 1.55, 3.05)).max() < 0.05 + 1e-6
lengths = vtk_to_numpy(facts.GetArray('HexRemesh.LostCreaseLengths'))
assert abs(lengths - 0.1).max() < 1e-6

given = shapetesting.output(polycube, 1)
without = shapetesting.copy(given)
without.GetPointData().RemoveArray('SourcePosition')
turned = shapetesting.copy(given)
shapetesting.set_points(turned, points(given) @ numpy.array([[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]]))
for data, expected in ((without, "no point array 'SourcePosition'"), (turned, 'perpendicular to an axis'),
                       (shapetesting.without_cells(given, [3]), 'open')):
    assert expected in made(torus, polycube=data)[2], (expected, made(torus, polycube=data)[2])
assert 'away from the Surface' in made(ball, polycube=given)[2]
assert 'Polycube' in made(torus, polycube=given, Method=2)[2]

# A point that no cell uses does not change the size of the cells.
loose = shapetesting.copy(ball)
loose.GetPointData().Initialize()
shapetesting.set_points(loose, numpy.vstack([points(ball), [9.0, 9.0, 9.0]]))
solids = [made(surface, Method=2, CellsOnLongestSide=7)[0] for surface in (ball, loose)]
assert (hexahedra(solids[0]) == hexahedra(solids[1])).all() and (points(solids[0]) == points(solids[1])).all()

# Neither does the unit of length change the measures: they are not cut off.
large = shapetesting.copy(ball)
shapetesting.set_points(large, 2.0 ** 40 * points(ball))
scaled = made(large, Method=2, CellsOnLongestSide=7)[0]
for name, power in (('Volume', 120), ('Jacobian', 120), ('Shape', 0), ('Skew', 0)):
    one, other = (vtk_to_numpy(solid.GetCellData().GetArray(name)) for solid in (solids[0], scaled))
    assert abs(other / 2.0 ** power - one).max() <= 1e-9 * abs(one).max(), name

# A draft is valid, and has the creases; it needs a grid.
drafted, skin, _ = made(shapetesting.output(closed), CellSize=0.08, Draft=True)
check(drafted, skin, 2)
assert fact(drafted, 'HexRemesh.CreasesKept') == 1 and 'draft' in words(drafted, 'HexRemesh.Reason')
assert 'Draft' in made(ball, Method=1, Draft=True)[2]

# What is wrong is named.
for settings, expected in (({'CellSize': -1.0}, 'CellSize'), ({'PaddingLayers': 0}, 'PaddingLayers'),
                           ({'FeatureAngle': 0.0}, 'FeatureAngle')):
    for method in (0, 1, 2):
        said = made(ball, Method=method, **settings)[2]
        assert expected in said, (settings, method, said)
hole = simple.Sphere(EndTheta=300)
hole.UpdatePipeline()
assert 'open' in made(shapetesting.output(hole))[2]
