"""Every method of Shape Correspondence, and the filters around it, on every kind of surface: the result
is what it must be, or a refusal names the fact and the remedy.

Most surfaces are matched with themselves, their points and triangles in another order: the map is the
identity in space."""
import numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, triangles

METHODS = ['ReversibleHarmonic', 'FunctionalMap', 'GromovWasserstein', 'HeatKernel',
           'BlendedIntrinsic', 'CommonSphere', 'CommonOrbifold', 'WeightedAverages', 'GeneralizedMDS',
           'CommonBase']
ANY_GENUS = METHODS[:4] + METHODS[7:]
WITH_BORDER = METHODS[:5] + METHODS[7:9]
SPHERE_LIKE = METHODS[4:7]
random = numpy.random.default_rng(5)


def surface_of(places, polygons):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, numpy.asarray(places, float))
    data.SetPolys(vtkCellArray())
    for polygon in polygons:
        data.GetPolys().InsertNextCell(len(polygon), [int(i) for i in polygon])
    return data


def lattice(across, up, close_across=False, close_up=False, turn=False):
    """Parameters in [0, 1]^2 and triangles of a sheet, tube, torus or Moebius strip."""
    u_count, v_count = across + (not close_across), up + (not close_up)
    faces = []
    for i in range(across):
        for j in range(up):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            if turn and i == across - 1:
                corners[1], corners[2] = (0, up - j), (0, up - j - 1)
            a, b, c, d = [p % u_count * v_count + q % v_count for p, q in corners]
            faces += [[a, b, c], [a, c, d]]
    u, v = numpy.meshgrid(numpy.arange(u_count) / across, numpy.arange(v_count) / up, indexing='ij')
    return u.ravel(), v.ravel(), numpy.array(faces)


def ball():
    """A sphere of triangles with five bumps of different height; no symmetry."""
    u, v, faces = lattice(16, 11, close_across=True)
    azimuth, height = 2 * numpy.pi * u, numpy.cos(numpy.pi * (v * 0.9 + 0.05))
    radius = numpy.sqrt(1 - height**2)
    places = numpy.column_stack([radius * numpy.cos(azimuth), radius * numpy.sin(azimuth), height])
    rings = 12
    north, south = len(places), len(places) + 1
    caps = [[north, i * rings, (i + 1) % 16 * rings] for i in range(16)] + [
        [south, (i + 1) % 16 * rings + rings - 1, i * rings + rings - 1] for i in range(16)]
    places = numpy.vstack([places, [[0, 0, 1], [0, 0, -1]]])
    faces = numpy.vstack([faces[:, ::-1], caps])
    ends = numpy.array([[1, 0, 0], [-.4, .9, 0], [-.5, -.6, .6], [.1, -.5, -.8], [.2, .3, .9]])
    bumps = numpy.exp(6 * (places @ (ends.T / numpy.linalg.norm(ends, axis=1)) - 1))
    places = places * (1 + bumps @ [1.4, 1.1, 0.9, 1.2, 0.7])[:, None]
    volume = numpy.linalg.det(places[faces]).sum()
    return places, faces if volume > 0 else faces[:, ::-1]


def joined(*parts):
    first = numpy.cumsum([0] + [len(places) for places, _ in parts])
    return (numpy.vstack([places for places, _ in parts]),
            numpy.vstack([numpy.asarray(faces) + first[k] for k, (_, faces) in enumerate(parts)]))


def reordered(data):
    """The same surface, its points and triangles in another order."""
    order = random.permutation(data.GetNumberOfPoints())
    faces = numpy.argsort(order)[triangles(data)]
    return surface_of(points(data)[order], faces[random.permutation(len(faces))])


def spread(data, count):
    """Points far from each other, of those that triangles use."""
    used = numpy.unique(triangles(data))
    places = points(data)[used]
    chosen = [0]
    for _ in range(count - 1):
        apart = numpy.linalg.norm(places[:, None] - places[chosen], axis=2).min(axis=1)
        chosen.append(apart.argmax())
    return points(data)[used[chosen]]


def marks(places, targets):
    data = surface_of(places, [])
    data.SetVerts(vtkCellArray())
    for i in range(len(places)):
        data.GetVerts().InsertNextCell(1, [i])
    add_array(data, numpy.asarray(targets, float), 'TargetPosition')
    return data


def match(method, a, b, landmarks):
    algorithm = shapemap.vtkShapeCorrespondence()
    for port, data in enumerate((a, b, landmarks)):
        if data is not None:
            algorithm.SetInputDataObject(port, data)
    algorithm.SetMethod(METHODS.index(method))
    algorithm.SetSamples(100)
    return algorithm, shapetesting.run(algorithm)


def check_identity(what, method, a, b, landmarks, most):
    algorithm, messages = match(method, a, b, landmarks)
    assert not messages, (what, method, messages)
    corners = points(a)[triangles(a)].astype(float)
    edges = corners[:, 1:] - corners[:, :1]
    size = numpy.sqrt(0.5 * numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1).sum())
    for port, here, there in ((0, a, b), (1, b, a)):
        found = algorithm.GetOutputDataObject(port)
        weights = array(found, 'TargetBarycentric')
        assert (weights >= 0).all() and abs(weights.sum(axis=1) - 1).max() < 1e-9, (what, method)
        used = numpy.unique(triangles(here))
        off = array(found, 'TargetPosition') - points(here)
        assert numpy.isfinite(off).all(), (what, method)
        error = numpy.linalg.norm(off[used], axis=1).mean() / size
        assert error < most, '%s, %s: off by %.3f' % (what, method, error)
    for name in ('DirichletEnergy', 'RoundTrip', 'ReversedArea'):
        assert numpy.isfinite(fact(algorithm.GetOutputDataObject(0), 'Correspondence.' + name))


# What the methods take.
places, faces = ball()
pebble = surface_of(places, faces)
sheet_u, sheet_v, sheet_faces = lattice(12, 9)
sheet = numpy.column_stack([1.5 * sheet_u, sheet_v, 0.3 * sheet_u**2 + 0.2 * numpy.exp(
    -9 * ((sheet_u - 0.7)**2 + (sheet_v - 0.3)**2))])
u, v, tube_faces = lattice(16, 9, close_across=True)
radius = 0.5 + 0.2 * v + 0.15 * numpy.cos(2 * numpy.pi * u) * v
tube = numpy.column_stack([radius * numpy.cos(2 * numpy.pi * u), radius * numpy.sin(
    2 * numpy.pi * u), 2 * v])
u, v, torus_faces = lattice(20, 10, close_across=True, close_up=True)
u, v = 2 * numpy.pi * u, 2 * numpy.pi * v
radius = 0.35 + 0.12 * numpy.cos(u) + 0.05 * numpy.sin(2 * u + 0.5)
torus = numpy.column_stack([(1 + radius * numpy.cos(v)) * numpy.cos(u), (
    1 + radius * numpy.cos(v)) * numpy.sin(u), radius * numpy.sin(v) * (
        1 + 0.4 * numpy.sin(u) * (numpy.sin(v) > 0))])
holed = read('TwoTorusSmall.vtp')
small = 0.5 * places[:, [1, 2, 0]] + [6, 0, 0]
stray = numpy.array([[5, 0, 0], [5.3, 0, 0], [5, 0.2, 0.0]])
middle = places[faces[0, :2]].mean(axis=0)
a0, b0, c0 = faces[0]
split = numpy.vstack([faces[1:], [[a0, len(places), c0], [len(places), b0, c0], [a0, b0, len(
    places)]]])
merged = places.copy()
merged[faces[40, 0]] = merged[faces[40, 1]]
corner_faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
tetrahedron = surface_of([[0, 0, 0], [1, 0, 0], [0, 1.2, 0], [0, 0, 1.5]], corner_faces)
SURFACES = (
    ('a ball', pebble, METHODS),
    ('one that faces inwards', surface_of(places, faces[:, ::-1]), METHODS),
    ('tiny units', surface_of(1e-8 * places, faces), METHODS),
    ('far from the origin', surface_of(places + 1e6, faces), METHODS),
    ('a sheet', surface_of(sheet, sheet_faces), WITH_BORDER),
    ('a tube of two borders', surface_of(tube, tube_faces), WITH_BORDER),
    ('a torus', surface_of(torus, torus_faces), ANY_GENUS),
    ('genus 2', surface_of(points(holed), triangles(holed)), ANY_GENUS),
    ('two balls', surface_of(*joined((places, faces), (small, faces))),
     ['FunctionalMap', 'HeatKernel']),
    ('a stray triangle', surface_of(*joined((places, faces), (stray, [[0, 1, 2]]))),
     ['FunctionalMap', 'HeatKernel']),
    ('loose points', surface_of(numpy.vstack([[[9, 9, 9]], places, [[7, 0, 0]]]), faces + 1),
     METHODS),
    ('a triangle without area', surface_of(numpy.vstack([places, [middle]]), split), METHODS),
    ('points at one place', surface_of(merged, faces), METHODS),
    ('a tetrahedron', tetrahedron, METHODS),
    ('a triangle', surface_of(stray, [[0, 1, 2]]), WITH_BORDER))
for what, data, methods in SURFACES:
    other = reordered(data)
    for method in methods:
        # Four cones are those of a flat orbifold, twelve those of a hyperbolic one.
        for count in (4, 12) if method == 'CommonOrbifold' else (12,):
            chosen = spread(data, min(count, len(numpy.unique(triangles(data)))))
            # These compare samples, which begin at the first point, and so depend on the numbering.
            most = 0.06 if method in ('GromovWasserstein', 'WeightedAverages') else 0.02
            check_identity(what, method, data, other, marks(chosen, chosen), most)
    print(what, 'is matched by', ', '.join(methods))

# Squares are cut into triangles; landmarks that are there twice count once.
far = spread(pebble, 8)
some, twice = marks(far, far), marks(numpy.vstack([far, far]), numpy.vstack([far, far]))
other = reordered(pebble)
for method in METHODS:
    once = match(method, pebble, other, some)[0].GetOutputDataObject(0)
    both = match(method, pebble, other, twice)[0].GetOutputDataObject(0)
    assert fact(both, 'Correspondence.Landmarks') == 8
    assert (array(once, 'TargetPosition') == array(both, 'TargetPosition')).all(), method
squares = surface_of(sheet, [[10 * i + j, 10 * i + 10 + j, 10 * i + 11 + j, 10 * i + j + 1]
                             for i in range(12) for j in range(9)])
far_sheet = marks(spread(surface_of(sheet, sheet_faces), 8), spread(
    surface_of(sheet, sheet_faces), 8))
found = match('FunctionalMap', squares, surface_of(sheet, sheet_faces), far_sheet)[0]
assert abs(array(found.GetOutputDataObject(0), 'TargetPosition') - sheet).max() < 0.05

# What they refuse: what it is, SurfaceA, SurfaceB, landmarks, methods, words of the message.
strip_u, strip_v, strip_faces = lattice(24, 4, close_across=True, turn=True)
angle, width = 2 * numpy.pi * strip_u, 0.6 * (strip_v - 0.5)
strip = numpy.column_stack([(1 + width * numpy.cos(angle / 2)) * numpy.cos(angle), (
    1 + width * numpy.cos(angle / 2)) * numpy.sin(angle), width * numpy.sin(angle / 2)])
turned = faces.copy()
turned[5] = turned[5, ::-1]
broken = places.copy()
broken[17, 1] = numpy.nan
soup = surface_of(places[faces].reshape(-1, 3), numpy.arange(faces.size).reshape(-1, 3))
lines = surface_of(places, [])
lines.SetLines(vtkCellArray())
lines.GetLines().InsertNextCell(2, [0, 1])
two = surface_of(*joined((places, faces), (small, faces)))
inside_out = surface_of(places, faces[:, ::-1])
COVERED = {'a Moebius strip', 'a triangle turned over'}
unsuited = {
    'nothing': (vtkPolyData(), ("the input 'SurfaceA' has no points", 'connect data')),
    'points alone': (surface_of(places, []), ('SurfaceA has no triangles', 'give a surface')),
    'lines': (lines, ('SurfaceA has no triangles', 'give a surface')),
    'a Moebius strip': (surface_of(strip, strip_faces), ('is one-sided', 'cut it open')),
    'a triangle turned over': (surface_of(places, turned),
                               ('3 edges between triangles of opposite', 'Surface Normals')),
    'NaN': (surface_of(broken, faces), ('not finite (first at point 17)', 'remove or repair')),
    'a size near nothing': (surface_of(1e-160 * places, faces), ('longest side', 'Transform')),
    'a size beyond all': (surface_of(1e160 * places, faces), ('longest side', 'Transform')),
    'a line of triangles': (surface_of(places * [1, 0, 0], faces), ('has no area', 'check its coordinates')),
}
refused = [(what, data, pebble, None, METHODS, words) for what, (data, words) in unsuited.items()]
refused += [
    ('a border', surface_of(sheet, sheet_faces), pebble, marks(spread(surface_of(
        sheet, sheet_faces), 4), far[:4]), SPHERE_LIKE[1:] + ['CommonBase'],
     ('SurfaceA has 1 open loop (first at point 0)', 'or take ReversibleHarmonic')),
    ('a handle', pebble, surface_of(torus, torus_faces), marks(far[:4], spread(surface_of(
        torus, torus_faces), 4)), SPHERE_LIKE + ['CommonBase'],
     ('SurfaceB has genus 1', 'ReversibleHarmonic')),
    ('two components', two, two, marks(far[:4], far[:4]),
     [m for m in METHODS if m not in ('FunctionalMap', 'HeatKernel')],
     ('SurfaceA has 2 components (the second begins at point 194)', 'or take FunctionalMap')),
    ('one of two without a landmark', two, two, marks(far[:4], far[:4]), ['HeatKernel'],
     ('2 components', 'give each component a landmark')),
    ('two components without landmarks', two, two, None, METHODS,
     ('2 components', 'Landmarks on each')),
    ('triangles apart', soup, pebble, some, METHODS[:3] + METHODS[4:],
     ('SurfaceA has 384 components', 'merge coincident points with Clean')),
    ('one that is inside out', pebble, inside_out, some, METHODS,
     ('SurfaceB faces inwards and SurfaceA outwards', 'Reverse Sense')),
    ('landmarks far away', pebble, pebble, marks(100 * far, far), METHODS,
     ('8 landmarks are farther from SurfaceA', 'put Landmarks on SurfaceA')),
    ('landmarks at one point', pebble, pebble, marks(far[[0] * 4], far[[0] * 4]), SPHERE_LIKE + ['WeightedAverages', 'CommonBase'],
     ('there is 1 distinct landmark', 'or none to have them found')),
    ('a landmark that is NaN', pebble, pebble, marks(broken[15:20], far[:5]), METHODS,
     ('the set of Landmarks has 1 point with a value that is not finite',)),
    ('no landmark', pebble, pebble, vtkPolyData(), METHODS, ("'Landmarks' has no points",)),
    ('too few landmarks', pebble, pebble, marks(far[:2], far[:2]),
     ['BlendedIntrinsic', 'CommonOrbifold', 'WeightedAverages'],
     ('2 distinct landmarks', 'give three or more'))]
for what, a, b, landmarks, methods, words in refused:
    for method in methods:
        algorithm, messages = match(method, a, b, landmarks)
        for word in ('Shape Correspondence: ',) + words:
            assert messages and word in messages[0], (what, method, messages)
        assert algorithm.GetOutputDataObject(0).GetNumberOfPoints() == 0, (what, method)
    print(what, 'is refused by', ', '.join(methods))

# The filters around it, on the same surfaces: what holds on each of them.
def result(name, *inputs, **options):
    """The first output, or the message."""
    algorithm = getattr(shapemap, 'vtkShape' + name)()
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    messages = shapetesting.run(algorithm)
    return messages[0] if messages else algorithm.GetOutputDataObject(0)


DISK, SPHERE, FREE, ORBIFOLD = range(4)
HEAT, EXACT, DIJKSTRA = range(3)
takes = {'a sheet': {DISK, FREE}, 'a triangle': {DISK, FREE}, 'a tube of two borders': {FREE},
         'a torus': set(), 'genus 2': set(), 'two balls': set(), 'a stray triangle': set(),
         'loose points': set()}
for what, data, _ in SURFACES:
    used = numpy.unique(triangles(data))
    components = 2 if what in ('two balls', 'a stray triangle') else 1
    seed = marks(points(data)[used[:1]], points(data)[used[:1]])
    cones = marks(spread(data, 3), spread(data, 3))
    for domain in (DISK, SPHERE, FREE, ORBIFOLD):
        inputs = (data, cones) if domain == ORBIFOLD else (data,)
        found = result('Parameterize', *inputs, Domain=domain)
        if domain in takes.get(what, {SPHERE, ORBIFOLD}):
            assert fact(found, 'Parameterize.FlippedTriangles') == 0, (what, domain)
            assert 1 - 1e-9 < fact(found, 'Parameterize.ConformalDistortion') < 10, (what, domain)
        else:
            assert 'Shape Parameterize: the surface ' in found and any(
                word in found for word in ('; ', ': cut')), (what, domain, found)
    # The heat method is an estimate; of the others the exact distance is the least.
    near = [array(result('GeodesicDistance', data, seed, Method=method), 'GeodesicDistance')
            for method in (HEAT, EXACT, DIJKSTRA)]
    reached = near[EXACT] >= 0
    assert reached.sum() == (len(used) if components == 1 else (near[DIJKSTRA] >= 0).sum())
    longest = near[DIJKSTRA].max()
    assert numpy.isfinite(near).all() and (near[EXACT] <= near[DIJKSTRA] + 1e-9 * longest).all()
    # The identity differs from nothing and has no error.
    itself = copy(data)
    add_array(itself, points(data), 'TargetPosition')
    few = min(8, len(used))
    difference = result('MapDifference', itself, data, NumberOfEigenpairs=few)
    assert abs(array(difference, 'AreaDifference')[used] - 1).max() < 1e-6, what
    curve = result('MapErrorCurve', itself, data, itself)
    assert fact(curve, 'MapErrorCurve.Maximum') < 1e-9, what
    assert abs(fact(curve, 'MapErrorCurve.Coverage') - 1) < 1e-9, what
    # As many constants as components.
    if len(used) > 8:
        spectrum = result('LaplaceSpectrum', data, NumberOfEigenpairs=8)
        values = spectrum.GetFieldData().GetArray('LaplaceSpectrum.Eigenvalues')
        values = numpy.array([values.GetValue(i) for i in range(8)])
        assert (numpy.diff(values) >= 0).all(), what
        assert (values < 1e-9 * values[-1]).sum() == components, (what, values)
for what, (data, words) in unsuited.items():
    if data.GetNumberOfPoints() == 0 or what == 'a line of triangles':
        continue
    itself = copy(data)
    add_array(itself, points(data), 'TargetPosition')
    for name, inputs in (('Parameterize', (data,)), ('GeodesicDistance', (data, cones)),
                         ('LaplaceSpectrum', (data,)), ('MapDifference', (itself, data)),
                         ('MapErrorCurve', (itself, data, itself))):
        if name in ('GeodesicDistance', 'LaplaceSpectrum') and what in COVERED:
            continue # heat and spectra need neither two triangles at an edge nor an orientation
        found = result(name, *inputs)
        for word in words:
            word = word.replace('SurfaceA ', '')
            assert isinstance(found, str) and word in found, (what, name, found)
print('so are they by the filters around it')
