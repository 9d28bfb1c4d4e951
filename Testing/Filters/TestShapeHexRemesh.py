"""Shape Hex Remesh: the solid inside a closed surface as hexahedra.

As an example: give it a closed surface; colour the hexahedra by ScaledJacobian, and Clip them to see
inside; the second output is their boundary."""
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
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
    return data.GetFieldData().GetAbstractArray(name).GetValue(0)


def made(surface, **settings):
    algorithm = shapemap.vtkShapeHexRemesh()
    algorithm.SetInputDataObject(surface)
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
    quality = vtkMeshQuality()
    quality.SetInputDataObject(solid)
    for name in MEASURES:
        getattr(quality, 'SetHexQualityMeasureTo' + name)()
        quality.Update()
        expected = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray('Quality'))
        own = vtk_to_numpy(solid.GetCellData().GetArray(name))
        assert (own == expected).all(), name
        summary = solid.GetFieldData().GetArray('HexRemesh.' + name)
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
        solid.GetFieldData().GetArray('HexRemesh.ScaledJacobianHistogram'))
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
assert words(solid, 'HexRemesh.Method') in ('Polycube', 'Grid') and words(solid, 'HexRemesh.Reason')
volume = 2.0 * 60.0 * 0.5 * 0.25 * numpy.sin(numpy.pi / 30.0)
sized = simple.IntegrateVariables(Input=simple.CellSize(Input=remesh))
sized.UpdatePipeline()
total = shapetesting.output(sized).GetCellData().GetArray('Volume').GetValue(0)
assert abs(total / volume - 1.0) < 0.01, total
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
    solid, boundary, said = made(torus, Method=method, CellSize=0.05)
    assert not said, said
    check(solid, boundary, 0)
    assert words(solid, 'HexRemesh.Method') == name
    assert words(solid, 'HexRemesh.Reason').startswith('asked for')

# The size of cells as a number of them on the longest side.
sphere = simple.Sphere()
sphere.UpdatePipeline()
ball = shapetesting.output(sphere)
solid, boundary, said = made(ball, Method=2, CellsOnLongestSide=10)
assert not said, said
check(solid, boundary, 2)
longest = numpy.ptp(points(ball), axis=0).max()
assert abs(fact(solid, 'HexRemesh.CellSize') - longest / 10.0) < 1e-9
said = made(ball, CellsOnLongestSide=10, CellSize=0.1)[2]
assert 'CellSize' in said and 'CellsOnLongestSide' in said, said

# What is wrong is named.
for settings, expected in (({'CellSize': -1.0}, 'CellSize'), ({'PaddingLayers': 0}, 'PaddingLayers'),
                           ({'FeatureAngle': 0.0}, 'FeatureAngle')):
    for method in (0, 1, 2):
        said = made(ball, Method=method, **settings)[2]
        assert expected in said, (settings, method, said)
hole = simple.Sphere(EndTheta=300)
hole.UpdatePipeline()
assert 'open' in made(shapetesting.output(hole))[2]
