"""Shape Correspondence: functional maps as data. The matrix and the eigenfunctions that come out agree with
their definitions, matrices, descriptors and regions that go in decide the map, and arrays are transferred."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkTable
import shapemap

import shapetesting
from shapetesting import add_array, array, copy, fact, points, read, triangles

HARMONIC, FUNCTIONAL, WASSERSTEIN = range(3)
BUILT_IN, GIVEN, BOTH = range(3)
MATRIX = 3  # the output


def surface_of(places, corners):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places)
    cells = vtkCellArray()
    for corner in corners:
        cells.InsertNextCell(3, [int(i) for i in corner])
    data.SetPolys(cells)
    return data


def table_of(matrix):
    table = vtkTable()
    for k, values in enumerate(numpy.asarray(matrix).T):
        column = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        column.SetName(str(k))
        table.AddColumn(column)
    return table


def matrix_of(table):
    return numpy.stack([vtk_to_numpy(table.GetColumn(k)) for k in range(table.GetNumberOfColumns())], axis=1)


def field(data, name):
    return vtk_to_numpy(data.GetFieldData().GetArray(name))


def new(a, b, landmarks=None, descriptors=(), transfer=(), matrix=None, **settings):
    algorithm = shapetesting.new(shapemap.vtkShapeCorrespondence, a, b, landmarks,
                                 **dict({'Method': FUNCTIONAL}, **settings))
    for k, name in enumerate(descriptors):
        algorithm.SetDescriptorArrays(k, name)
    for k, name in enumerate(transfer):
        algorithm.SetTransferArrays(k, name)
    if matrix is not None:
        algorithm.SetInputDataObject(4, matrix)
    return algorithm


def outputs(*arguments, **settings):
    return shapetesting.outputs(new(*arguments, **settings))


def refusal(*arguments, **settings):
    messages = shapetesting.run(new(*arguments, **settings))
    assert messages, 'nothing was refused'
    return messages[0]


# A figure and a copy: turned, twice as large, its points in another order.
given = read('FigureASmall.vtp')
random = numpy.random.default_rng(1)
order = random.permutation(given.GetNumberOfPoints())
turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
turn *= numpy.sign(numpy.linalg.det(turn))
new_of = numpy.argsort(order)
a = surface_of(points(given), triangles(given))
b = surface_of(2.0 * points(given)[order] @ turn.T, new_of[triangles(given)])
wanted = 2.0 * points(a) @ turn.T
size = numpy.ptp(points(b), axis=0).max()


def errors(found):
    return numpy.linalg.norm(array(found, 'TargetPosition') - wanted, axis=1) / size


# Without the switch there is no matrix, and a fact says so.
plain = outputs(a, b)
assert plain[MATRIX].GetNumberOfRows() == 0 and fact(plain[0], 'Correspondence.FunctionalMapSize') == 0
assert not plain[0].GetPointData().HasArray('Eigenfunctions')

# With it, the matrix is that of the map, whatever the method, and the map is what it was.
for method in (FUNCTIONAL, HARMONIC, WASSERSTEIN):
    coarse = {'CoarsePoints': 400} if method == FUNCTIONAL else {}
    off = outputs(a, b, Method=method, NumberOfEigenpairs=40, **coarse)
    on = outputs(a, b, Method=method, NumberOfEigenpairs=40, OutputEigenfunctions=True, **coarse)
    for port in (0, 1):
        assert (array(on[port], 'TargetPosition') == array(off[port], 'TargetPosition')).all(), method
    phi_a, phi_b = array(on[0], 'Eigenfunctions'), array(on[1], 'Eigenfunctions')
    masses_a, masses_b = array(on[0], 'Masses'), array(on[1], 'Masses')
    for phi, masses in ((phi_a, masses_a), (phi_b, masses_b)):
        assert abs(phi.T @ (masses[:, None] * phi) - numpy.eye(40)).max() < 1e-9
    pulled = numpy.einsum('ik,ikc->ic', array(on[1], 'TargetBarycentric'),
                          phi_a[triangles(a)[array(on[1], 'TargetCell')]])
    c = matrix_of(on[MATRIX])
    assert c.shape == (40, 40) and fact(on[0], 'Correspondence.FunctionalMapSize') == 40
    assert abs(c - phi_b.T @ (masses_b[:, None] * pulled)).max() < 1e-9, method
    assert (field(on[MATRIX], 'EigenvaluesOfA') == field(on[0], 'Eigenvalues')).all()
    assert (field(on[MATRIX], 'EigenvaluesOfB') == field(on[1], 'Eigenvalues')).all()
    scale = field(on[MATRIX], 'ScaleOfB')[0] / field(on[MATRIX], 'ScaleOfA')[0]
    assert abs(scale - 2.0) < 1e-9 and abs(field(on[MATRIX], 'ScaleOfA')[0]**2 - masses_a.sum()) < 1e-9
    print('method %d: C = Phi_B^T M_B P Phi_A to %.1e' % (
        method, abs(c - phi_b.T @ (masses_b[:, None] * pulled)).max()))

# They are the eigenfunctions of Shape Laplace Spectrum.
spectrum = shapetesting.new(shapemap.vtkShapeLaplaceSpectrum, a, NumberOfEigenpairs=40)
assert abs(array(shapetesting.outputs(spectrum)[0], 'Eigenfunctions') - phi_a).max() < 1e-9 * abs(phi_a).max()

# A known map as a matrix: the image of an eigenfunction of A is what it is at the same point of B.
exact = phi_b.T @ (masses_b[:, None] * phi_a[order])
scaled = exact / 2.0
assert abs(scaled.T @ scaled - numpy.eye(40)).max() < 1e-6
for step in (0, 6):
    for method in (FUNCTIONAL, HARMONIC):
        found = outputs(a, b, matrix=table_of(exact), ZoomOutStep=step, Method=method)
        assert errors(found[0]).mean() < (1e-6 if method == FUNCTIONAL else 0.01), (step, errors(found[0]).mean())
        assert fact(found[0], 'Correspondence.LandmarksFound') == 0
        assert fact(found[0], 'Correspondence.Landmarks') == 0
# What comes out can go in. In one column, too.
made = outputs(a, b, matrix=table_of(exact), OutputEigenfunctions=True, NumberOfEigenpairs=60)[MATRIX]
assert errors(outputs(a, b, matrix=made, ZoomOutStep=0)[0]).max() < 1e-6
single = vtkTable()
column = numpy_to_vtk(numpy.ascontiguousarray(exact), deep=True)
column.SetName('C')
single.AddColumn(column)
assert errors(outputs(a, b, matrix=single, ZoomOutStep=0)[0]).max() < 1e-6

# Functions through the matrix: a band-limited one arrives as it is, a vector of them, too; noise is smoothed.
smooth = phi_a[:, :30] @ random.normal(size=(30, 3))
sender = copy(a)
add_array(sender, smooth, 'Smooth')
add_array(sender, random.normal(size=len(smooth)), 'Noise')
arrived = outputs(sender, b, matrix=table_of(exact), transfer=['Smooth', 'Noise'], ZoomOutStep=0)
error = abs(array(arrived[1], 'SmoothFromA') - smooth[order]).max() / abs(smooth).max()
print('band-limited functions arrive to %.1e' % error)
assert error < 1e-6, error
noise = array(arrived[1], 'NoiseFromA')
assert abs(noise - array(sender, 'Noise')[order]).max() > 0.1 and noise.std() < array(sender, 'Noise').std()
assert arrived[MATRIX].GetNumberOfRows() == 120
assert not arrived[0].GetPointData().HasArray('SmoothFromA')
assert "no point array 'Nothing'" in refusal(sender, b, transfer=['Nothing'])

# Descriptors: the coordinates of a known map recover it, alone and with the built-in ones.
with_places_a, with_places_b = copy(a), copy(b)
add_array(with_places_a, points(a), 'Where')
add_array(with_places_b, points(a)[order], 'Where')
for use in (GIVEN, BOTH):
    found = outputs(with_places_a, with_places_b, descriptors=['Where'], Descriptors=use)
    assert errors(found[0]).max() < 1e-6, (use, errors(found[0]).max())
    assert fact(found[0], 'Correspondence.LandmarksFound') == 0
assert fact(outputs(with_places_a, with_places_b, descriptors=['Where'], Descriptors=BUILT_IN)[0],
            'Correspondence.LandmarksFound') == 1
assert 'SurfaceB has no point array' in refusal(with_places_a, b, descriptors=['Where'])
add_array(with_places_b, points(a)[order, :2], 'Where')
assert '3 components on SurfaceA and 2 on SurfaceB' in refusal(with_places_a, with_places_b, descriptors=['Where'])
assert 'Descriptors is Given' in refusal(a, b, Descriptors=GIVEN)


# Regions: an ellipsoid is mapped onto itself by turns about its axes, and two caps decide which one is right.
def ellipsoid():
    """An icosahedron divided four times; three turns by 180 degrees map its triangles onto each other."""
    g = (1 + 5**0.5) / 2
    corners = numpy.array([p for s in (-1, 1) for t in (-g, g) for p in ((0, s, t), (s, t, 0), (t, 0, s))])
    apart = numpy.linalg.norm(corners[:, None] - corners, axis=2)
    faces = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
             if max(apart[i, j], apart[j, k], apart[i, k]) < 2.1]
    places = [tuple(p / numpy.linalg.norm(p)) for p in corners]
    for _ in range(3):
        middles, divided = {}, []
        for face in faces:
            halves = []
            for i, j in ((0, 1), (1, 2), (2, 0)):
                key = tuple(sorted((face[i], face[j])))
                if key not in middles:
                    middle = numpy.add(places[key[0]], places[key[1]])
                    middles[key] = len(places)
                    places.append(tuple(middle / numpy.linalg.norm(middle)))
                halves.append(middles[key])
            divided += [(face[0], halves[0], halves[2]), (face[1], halves[1], halves[0]),
                        (face[2], halves[2], halves[1]), tuple(halves)]
        faces = divided
    places, faces = numpy.array(places), numpy.array(faces)
    inwards = numpy.einsum('ij,ij->i', numpy.cross(places[faces[:, 0]], places[faces[:, 1]]), places[faces[:, 2]]) < 0
    faces[inwards] = faces[inwards][:, ::-1]
    return places * [2.0, 1.5, 1.0], faces


places, faces = ellipsoid()
centres = places[faces].mean(axis=1)
ids = {'point': numpy.where(places[:, 0] > 1.2, 7, numpy.where(places[:, 1] > 1.0, 4, 0)),
       'cell': numpy.where(centres[:, 0] > 1.2, 7, numpy.where(centres[:, 1] > 1.0, 4, 0))}


def labelled(data, values, kind):
    held = numpy_to_vtk(values.astype(numpy.int32), deep=True)
    held.SetName('Part')
    (data.GetPointData() if kind == 'point' else data.GetCellData()).AddArray(held)
    return data


without = []
for trial in range(4):
    mixed = numpy.random.default_rng(trial).permutation(len(places))
    for kind in ('point', 'cell'):
        first = labelled(surface_of(places, faces), ids[kind], kind)
        second = labelled(surface_of(places[mixed], numpy.argsort(mixed)[faces]),
                          ids[kind][mixed] if kind == 'point' else ids[kind], kind)
        found = array(outputs(first, second, RegionArray='Part', NumberOfEigenpairs=60)[0], 'TargetPosition')
        right = numpy.linalg.norm(found - places, axis=1).mean()
        turned = min(numpy.linalg.norm(found - places * sign, axis=1).mean()
                     for sign in ([1, -1, -1], [-1, 1, -1], [-1, -1, 1]))
        assert right < 0.05 < 0.5 < turned, (trial, kind, right, turned)
    found = array(outputs(first, second, RegionArray='Part', NumberOfEigenpairs=60, Descriptors=BUILT_IN)[0],
                  'TargetPosition')
    without.append(numpy.linalg.norm(found - places, axis=1).mean())
assert max(without) > 0.5, 'the built-in descriptors decide, too'
print('regions: mean error %.3f, from the nearest turn %.3f' % (right, turned))
assert 'no region has the same id' in refusal(
    labelled(surface_of(places, faces), ids['cell'] * 0 + 1, 'cell'),
    labelled(surface_of(places, faces), ids['cell'] * 0 + 2, 'cell'), RegionArray='Part')
assert "no point array 'Nowhere'" in refusal(a, b, RegionArray='Nowhere')

# Displacements given by vectors: the unit normals are the default, and others give another fit. Both surfaces
# need vectors.
def displaced(data, vectors, name='Motion'):
    held = copy(data)
    add_array(held, vectors, name)
    return held


term = dict(DisplacementWeight=1.0, ZoomOutStep=0)
moved = displaced(a, numpy.sin(4.0 * points(a))), displaced(b, 2.0 * numpy.sin(2.0 * points(b) @ turn) @ turn.T)
along = array(outputs(a, b, **term)[0], 'TargetPosition')
assert (array(outputs(*moved, DisplacementArray='None', **term)[0], 'TargetPosition') == along).all()
assert (array(outputs(*moved, DisplacementArray='Motion', **term)[0], 'TargetPosition') != along).any()
assert "no point array 'Motion'" in refusal(moved[0], b, DisplacementArray='Motion', **term)
assert 'has 1 components, but displacements are vectors of 3' in refusal(
    displaced(a, points(a)[:, 0]), displaced(b, points(b)[:, 0]), DisplacementArray='Motion', **term)

# Lines of landmarks as a whole: alone, they recover the map. Each counts as a descriptor.
line = surface_of(points(a)[numpy.argsort(points(a)[:, 2])[::60]], [])
cells = vtkCellArray()
cells.InsertNextCell(line.GetNumberOfPoints(), range(line.GetNumberOfPoints()))
line.SetLines(cells)
add_array(line, 2.0 * points(line) @ turn.T, 'TargetPosition')
found = outputs(a, b, line, CurveDescriptors=True, Descriptors=GIVEN)
assert errors(found[0]).mean() < 0.01, errors(found[0]).mean()
# The fits differ; refined, they find the same map.
fits = [array(outputs(a, b, line, ZoomOutStep=0, **more)[0], 'TargetPosition')
        for more in ({}, {'CurveDescriptors': True}, {'CurveDescriptors': True, 'CurveWeight': 10})]
assert (fits[0] != fits[1]).any()
assert (fits[1] != fits[2]).any()  # their operators count, too
assert 'CurveWeight is -1' in refusal(a, b, line, CurveWeight=-1)

# Coupled bases are orthonormal, and the map of a copy is diagonal in them.
coupled = outputs(a, b, line, CoupledBasisSize=15, OutputEigenfunctions=True)
for side in coupled[:2]:
    own, masses = array(side, 'CoupledEigenfunctions'), array(side, 'Masses')
    assert abs(own.T @ (masses[:, None] * own) - numpy.eye(15)).max() < 1e-9
assert fact(coupled[0], 'Correspondence.CoupledDiagonal') > 0.999
assert fact(outputs(a, b, line)[0], 'Correspondence.CoupledDiagonal') == -1
assert 'from 1 to NumberOfEigenpairs' in refusal(a, b, line, CoupledBasisSize=200)
assert 'no functions of the surfaces' in refusal(a, b, matrix=table_of(exact), CoupledBasisSize=5)

# Blocks keep the arrays.
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, b)
there = outputs(sender, blocks, matrix=table_of(exact), transfer=['Smooth'], OutputEigenfunctions=True)
assert (array(there[1].GetBlock(0), 'SmoothFromA').shape == (len(order), 3))
assert field(there[1], 'Eigenvalues').size == 120

# What is refused, and what to do then.
# Rows and columns may differ in number, and ZoomOut completes the map. The bases are those of as many pairs: the
# sign of an antisymmetric eigenfunction is open.
few_a, few_b = (array(shapetesting.outputs(shapetesting.new(
    shapemap.vtkShapeLaplaceSpectrum, side, NumberOfEigenpairs=31))[0], 'Eigenfunctions') for side in (a, b))
for part in (phi_b.T @ (masses_b[:, None] * few_a[order]), few_b.T @ (masses_b[:, None] * phi_a[order])):
    assert errors(outputs(a, b, matrix=table_of(part))[0]).max() < 1e-6, part.shape
assert '0 rows' in refusal(a, b, matrix=vtkTable())
assert 'remove the last columns' in refusal(read('FigureASmall.vtp'), read('FigureBSmall.vtp'),
                                         matrix=table_of(numpy.eye(given.GetNumberOfPoints() + 1)))
SURFACE_A = 2
assert 'landmarks' in refusal(a, b, matrix=table_of(exact), Part=SURFACE_A)
