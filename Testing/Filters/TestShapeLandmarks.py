"""Shape Landmarks: pairs of landmarks on two surfaces, for the filters that need some.

As an example: four landmarks on two figures, which Shape Correspondence uses."""
import numpy
from paraview import simple
import shapemap

import shapetesting
from shapetesting import array, fact, points

a = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('FigureASmall.vtp')])
b = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('FigureBSmall.vtp')])
for surface in (a, b):
    surface.UpdatePipeline()
places_a, places_b = points(shapetesting.output(a)), points(shapetesting.output(b))
chosen = [int(places_a[:, axis].argmax()) for axis in range(3)] + [int(places_a[:, 1].argmin())]
assert len(set(chosen)) == 4 and len(places_a) == len(places_b), 'the figures have the same points'


def flat(places):
    return numpy.asarray(places).reshape(-1).tolist()


# The example: the pairs are given as numbers, as in a script.
landmarks = simple.ShapeLandmarks(SurfaceA=a, SurfaceB=b, PointsA=flat(places_a[chosen]),
                                  PointsB=flat(places_b[chosen]), Names=['', 'head'])
landmarks.UpdatePipeline()
on_a, on_b, lines = (shapetesting.output(landmarks, port) for port in range(3))
assert (points(on_a) == places_a[chosen]).all() and (points(on_b) == places_b[chosen]).all()
assert (array(on_a, 'TargetPosition') == points(on_b)).all()
assert (array(on_b, 'TargetPosition') == points(on_a)).all()
assert on_a.GetNumberOfVerts() == on_b.GetNumberOfVerts() == lines.GetNumberOfLines() == 4
assert (points(lines) == numpy.stack([points(on_a), points(on_b)], axis=1).reshape(-1, 3)).all()
for attributes in (on_a.GetPointData(), on_b.GetPointData(), lines.GetCellData()):
    names = attributes.GetAbstractArray('Name')
    assert [names.GetValue(i) for i in range(4)] == ['1', 'head', '3', '4']
    assert [attributes.GetArray('Number').GetValue(i) for i in range(4)] == [1, 2, 3, 4]

# Shape Correspondence sends each landmark to its partner.
both = simple.ShapeCorrespondence(SurfaceA=a, SurfaceB=b, Landmarks=landmarks)
both.UpdatePipeline()
mapped = shapetesting.output(both)
assert fact(mapped, 'Correspondence.Landmarks') == 4
assert fact(mapped, 'Correspondence.LandmarkTargets') == 'TargetPosition'
assert numpy.linalg.norm(array(mapped, 'TargetPosition')[chosen] - places_b[chosen], axis=1).max() < 1e-12

# Target Landmarks are paired with Landmarks by order, and win over their TargetPosition.
swapped = [chosen[1], chosen[0]] + chosen[2:]
both.TargetLandmarks = simple.ShapeLandmarks(SurfaceA=b, PointsA=flat(places_b[swapped]))
both.UpdatePipeline()
assert fact(shapetesting.output(both), 'Correspondence.LandmarkTargets') == 'TargetLandmarks'
mapped = array(shapetesting.output(both), 'TargetPosition')[chosen]
assert numpy.linalg.norm(mapped - places_b[swapped], axis=1).max() < 1e-12
unequal = shapemap.vtkShapeCorrespondence()
for port, data in enumerate((shapetesting.output(a), shapetesting.output(b), on_a, shapetesting.output(b))):
    unequal.SetInputDataObject(port, data)
assert ('Landmarks has 4 points, and TargetLandmarks has %d; connect equally many, because they are paired by '
        'order' % len(places_b)) in ' '.join(shapetesting.run(unequal))

# Those of the orbifold are the corners of the tile.
tile = simple.ShapeParameterize(Input=a, Landmarks=landmarks, Domain='Orbifold')
tile.UpdatePipeline()
assert shapetesting.output(tile, 1).GetNumberOfPoints() > len(places_a), 'the figure was not cut'

# As features of a volume map, they go to their partners more closely than without.
sphere = simple.XMLPolyDataReader(FileName=[shapetesting.data_file('DentedSphere600.vtp')])
sphere.UpdatePipeline()
inner = 0.5 * points(shapetesting.output(sphere))[[3, 200]]
core = simple.Sphere(Radius=0.5)
pair = simple.ShapeLandmarks(SurfaceA=core, SurfaceB=core, PointsA=flat(inner), MaximumDistance=1.0,
                             PointsB=flat(numpy.roll(inner, 1, axis=0)))
ball = simple.XMLUnstructuredGridReader(FileName=[shapetesting.data_file('BallSmall.vtu')])
volume_map = simple.ShapeHarmonicVolumeMap(Domain=ball, Boundary=sphere, Features=[pair])
volume_map.UpdatePipeline()
assert shapetesting.output(volume_map).GetNumberOfPoints() > 0, 'the features were refused'

# Landmarks on one surface; positions near it are moved to it, and the fact says how far.
single = simple.ShapeLandmarks(SurfaceA=simple.Sphere(Radius=1.0), PointsA=[0, 0, 1.25])
single.UpdatePipeline()
alone = shapetesting.output(single)
assert abs(points(alone) - [[0, 0, 1]]).max() < 1e-6, points(alone)
assert abs(fact(alone, 'Landmarks.LargestDistanceFromA') - 0.25) < 1e-6
assert not alone.GetPointData().HasArray('TargetPosition')
assert shapetesting.output(single, 1).GetNumberOfPoints() == 0


def message(target=True, **properties):
    """The error of a filter on the dented sphere, on one line."""
    filter = shapemap.vtkShapeLandmarks()
    surface = shapetesting.read('DentedSphere600.vtp')
    for port in range(1 + target):
        filter.SetInputDataObject(port, surface)
    for name, values in properties.items():
        getattr(filter, 'Set' + name)(values)
    messages = shapetesting.run(filter)
    assert all(filter.GetOutputDataObject(i).GetNumberOfPoints() == 0 for i in range(3)) or not messages
    found = [line for line in messages if 'Shape Landmarks: ' in line]
    return found[0].split('Shape Landmarks: ')[1].strip() if found else ''


top, right = [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]
assert message(PointsA=top + right, PointsB=top) == (
    'Points A has 2 positions, and Points B has 1; give equally many, because they are paired by order')
assert message(target=False, PointsA=top, PointsB=top) == (
    'Points B has 1 positions, and there is no Surface B; connect it, or remove them')
assert message(PointsA=top + right + top, PointsB=top + right + top).startswith(
    'landmarks 1 and 3 have the same position on Surface A')
found = message(PointsA=top + right, PointsB=top + [5.0, 0.0, 0.0])
assert found.startswith('landmark 2 is ') and found.endswith(
    ' away from Surface B; move it there, or increase Maximum Distance'), found
assert message(PointsA=top + right, PointsB=right + top) == ''
assert message() == '', 'no landmarks are valid'
print('landmarks are on their surfaces, and feed the filters that need them')
