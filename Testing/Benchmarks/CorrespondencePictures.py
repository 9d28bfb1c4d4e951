"""What maps between surfaces are for, on real models: draws it, and prints how good it is.

    Utilities/pvpython.sh Testing/Benchmarks/CorrespondencePictures.py FOLDER [solid] [PAIR ...]

solid     solid.png: a bear's solid in the shape of another bear, in another pose, of libcgal-demo's
          bear.off and bear_bis.off. Shape Correspondence finds the map between their surfaces by
          itself, Shape Harmonic Volume Map continues it inside.
PAIR      one of CorrespondencePairs.py's, which FOLDER/pairs gets: PAIR.png, a texture and a
          segmentation carried from B to A by Shape Transfer Fields, and how much of A has the label
          that it truly has.

Without words: solid, three pairs, and overview.png of solid and the first one, which is the
picture of Shape Correspondence's page in 256 colours. Needs Debian's python3-scipy. With the pairs there, three minutes on one
thread.
"""
import collections
import os
import sys

import sweep

import CorrespondencePairs as made
import PairDeformation as shapes

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

import off
import panels
import scenes
import shapetesting
from scenes import filter_of, output_of, with_array
from shapetesting import add_array, array, copy, fact, points, triangles

HARMONIC, FUNCTIONAL = range(2)
ITERATIONS = 200  # a limb that is turned about itself needs more than the default to turn back
SMALLEST = 4e-5   # tetrahedra are cut until they have at most this share of the volume
SQUARE = 0.09     # of the texture: the side of its cubes, of the longest side of the shape
PAIRS = ('camel-looks', 'cow-giraffe', 'homer-sits')
ALL = 1e9         # a depth that nothing is in front of
SHIFT, WIDEST, LINE = 0.82, [0.78, 1.0], -0.6  # of the four panels
# Towards the viewer of A.
VIEWS = collections.defaultdict(lambda: [0.5, 0.3, 1], {
    'homer-sits': [0.5, 0.2, 1], 'cow-giraffe': [0.35, 0.25, 1], 'camel-looks': [1, 0.25, 0.5]})
COLOURS = numpy.array([[228, 108, 90], [92, 158, 214], [120, 190, 110], [242, 190, 84],
                       [164, 122, 200], [230, 226, 216]])


def maps(a, b, **settings):
    """Both surfaces with their maps onto each other."""
    algorithm = filter_of('Correspondence', a, b, **settings)
    return copy(algorithm.GetOutputDataObject(0)), copy(algorithm.GetOutputDataObject(1))


def checker(places, low, size):
    """Colours from 0 to 255 of places in a box: they change with the place, and cubes alternate."""
    shares = (places - low) / size
    bright = 90.0 + 150.0 * shares / shares.max(axis=0)
    dark = numpy.floor(shares / SQUARE + 1e-9).sum(axis=1) % 2 > 0.5
    return numpy.clip(numpy.where(dark[:, None], 0.45 * bright, bright), 0.0, 255.0)


def fine(surface, rounds=2):
    """Each triangle in four, so many times; point arrays are interpolated."""
    subdivide = vtkLinearSubdivisionFilter()
    subdivide.SetInputData(scenes.triangulated(surface))
    subdivide.SetNumberOfSubdivisions(rounds)
    subdivide.Update()
    return subdivide.GetOutput()


def turn(here, there):
    """The rotation that lays the places there on those here, as nearly as one can."""
    left, _, right = numpy.linalg.svd((here - here.mean(axis=0)).T @ (there - there.mean(axis=0)))
    left[:, 2] *= numpy.sign(numpy.linalg.det(left @ right))
    return left @ right


class Sheet(panels.Sheet):
    """Four panels in a row, with words below."""

    def __init__(self, direction, up):
        super().__init__((1600, 560), direction, up, SHIFT, WIDEST, LINE)

    def paint(self, column, data, colours, like=None):
        """Shows a data set in colours from 0 to 255, as large and where `like` would be."""
        painted = with_array(data, numpy.clip(colours, 0, 255).astype(numpy.uint8), 'Paint')
        display = self.fit(column, painted, like or data, smooth=50)
        display.ColorArrayName, display.MapScalars = ['POINTS', 'Paint'], 0
        display.Ambient, display.Diffuse, display.Specular = 0.42, 0.68, 0.0

    def finish(self, path):
        self.save(path, [1.5 * SHIFT, -0.05], 1.18)


# The solid.

def describe(name, surface):
    places, corners = points(surface), triangles(surface)
    found = shapes.facts(places, corners)
    volume = numpy.einsum('ij,ij->', places[corners[:, 0]], numpy.cross(
        places[corners[:, 1]], places[corners[:, 2]])) / 6.0
    print('%s: %d points, %d triangles, %d border and %d nonmanifold edges, %d component, Euler '
          'number %d, faces %s, volume %.4f' % (
              name, len(places), len(corners), found['border'], found['nonmanifold'],
              found['components'], found['euler'], 'outwards' if volume > 0 else 'inwards', volume))
    return volume


def turned_over(a, b):
    """How many triangles of A the map turns over, against B's normals where their corners go, and
    how many of no area it makes."""
    vectors = shapes.area_vectors(points(b), triangles(b))
    images = shapes.area_vectors(array(a, 'TargetPosition'), triangles(a))
    there = vectors[array(a, 'TargetCell')][triangles(a)]
    there = (there / numpy.linalg.norm(there, axis=2, keepdims=True)).sum(axis=1)
    flat = numpy.linalg.norm(images, axis=1) < 1e-9 * numpy.linalg.norm(vectors, axis=1).mean()
    return (~flat & (numpy.einsum('ij,ij->i', images, there) < 0)).sum(), flat.sum()


def tetrahedron_volumes(solid):
    corners = vtk_to_numpy(solid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    a, b, c, d = (points(solid)[corners[:, k]] for k in range(4))
    return numpy.einsum('ij,ij->i', numpy.cross(b - a, c - a), d - a) / 6.0


def rest_of(moved):
    """The moved solid at the place it came from, with the map."""
    rest = with_array(moved, points(moved), 'TargetPosition')
    shapetesting.set_points(rest, array(moved, 'SourcePosition'))
    return rest


def behind(solid, places, depth):
    """The surface of what lies behind a depth in the rest shape, and these places on it."""
    clip, skin = vtkClipDataSet(), vtkGeometryFilter()
    data = with_array(with_array(solid, places, 'Rest'), places[:, 2], 'Depth')
    data.GetPointData().SetActiveScalars('Depth')
    clip.SetInputData(data)
    clip.SetValue(depth)
    clip.InsideOutOn()
    skin.SetInputConnection(clip.GetOutputPort())
    skin.Update()
    surface = copy(skin.GetOutput())
    surface.GetCellData().Initialize()
    return fine(surface, 2 if depth == ALL else 3)


def solid(folder):
    bear, other = (scenes.model(name) for name in ('bear', 'bear_bis'))
    volume, wanted = describe('bear', bear), describe('bear_bis', other)
    a, b = maps(bear, other, MaximumIterations=ITERATIONS)
    print('surfaces: %d landmarks found, confidence %.3f, mirrored %d, %d iterations, Dirichlet energy'
          ' %.3f, round trip %.5f' % tuple(fact(a, 'Correspondence.' + name) for name in (
              'Landmarks', 'Confidence', 'Mirrored', 'Iterations', 'DirichletEnergy', 'RoundTrip')))
    for name, (one, two) in {'bear': (a, b), 'bear_bis': (b, a)}.items():
        single = scenes.point_set(points(one)[:1])
        add_array(single, array(one, 'TargetPosition')[:1], 'TargetPosition')
        curve = output_of('MapErrorCurve', one, two, single)
        print('  of %s: %d triangles turned over, %d without area; the image is %.2f %% of the other'
              % (name, *turned_over(one, two), 100.0 * fact(curve, 'MapErrorCurve.Coverage')))
    tetrahedra = output_of('Tetrahedralize', a, MaximumVolume=SMALLEST * volume)
    harmonic = output_of('HarmonicVolumeMap', tetrahedra, a, None, None, b)
    print('volume map: RMSE %.2e at points, %.2e inside triangles, at most %.2e of the longest side'
          % tuple(fact(harmonic, 'HarmonicVolumeMap.' + name) for name in (
              'RMSEVertices', 'RMSEInside', 'Maximum')))
    moved = output_of('Untangle', harmonic, tetrahedra)
    rest = rest_of(moved)
    print('untangled: %d of %d tetrahedra inverted before, %d of %d after; %d points moved, %d split' % (
        fact(moved, 'Untangle.InvertedBefore'), tetrahedra.GetNumberOfCells(),
        fact(moved, 'Untangle.InvertedAfter'), moved.GetNumberOfCells(),
        *(fact(moved, 'Untangle.' + name) for name in ('MovedPoints', 'SplitCells'))))
    for name, data in (('bear', rest), ('moved', moved)):
        values = vtk_to_numpy(scenes.scaled_jacobians(data).GetCellData().GetArray('Quality'))
        print('  %s: scaled Jacobian at least %.5f, 1 %% below %.3f, mean %.3f' % (
            name, values.min(), numpy.percentile(values, 1), values.mean()))
    quality = output_of('MapQuality', rest).GetCellData()
    for name in ('JacobianDeterminant', 'SymmetricDirichlet', 'ConformalDistortion'):
        print('  %s: least %.4g, 1 %% below %.4g, median %.4g, 1 %% above %.4g, greatest %.4g' % (
            name, *numpy.percentile(vtk_to_numpy(quality.GetArray(name)), (0, 1, 50, 99, 100))))
    covered(rest, moved, other, wanted)
    draw_solids(os.path.join(folder, 'solid.png'), rest, moved)


def covered(rest, moved, other, wanted):
    """Prints how much of the other solid and of its surface the moved one takes up."""
    inner = output_of('Tetrahedralize', other, MaximumVolume=SMALLEST * wanted)
    back = output_of('TransferFields', inner, rest, Direction=1, Tolerance=0.0)
    inside = array(inner, 'OriginalPointId') < 0
    volumes = tetrahedron_volumes(moved)
    print('  %.2f %% of %d points inside bear_bis are in the moved solid; its volume is %.2f %% of '
          "bear_bis's" % (100.0 * (array(back, 'OutsideDomain')[inside] == 0).mean(), inside.sum(),
                          100.0 * volumes.sum() / wanted))
    skin = scenes.skin(moved)
    for name, one, two in (('its surface from bear_bis', skin, other),
                           ('bear_bis from it', other, skin)):
        far = abs(scenes.boundary_distance(one, two))
        far /= numpy.ptp(points(other), axis=0).max()
        print('  points of %s: mean %.5f, at most %.4f of the longest side' % (
            name, far.mean(), far.max()))


def draw_solids(path, rest, moved):
    places = points(rest)
    low, size = places.min(axis=0), numpy.ptp(places, axis=0).max()
    sheet = Sheet([0.22, 0.1, 1], [0, 1, 0])
    alike = copy(moved)
    shapetesting.set_points(alike, points(moved) @ turn(places, points(moved)).T)
    for column, data, depth in ((0, rest, ALL), (1, rest, 0.0), (2, alike, 0.0), (3, alike, ALL)):
        surface = behind(data, places, depth)
        sheet.paint(column, surface, checker(array(surface, 'Rest'), low, size), data)
    for column, words in ((0.5, 'a bear, whole and without its front'),
                          (2.5, 'its solid in the shape of another bear, without the same part')):
        sheet.label(column, words)
    sheet.finish(path)


# Textures and labels.

def seed_distances(b):
    """How far each point is from five that are far from each other, and from one that is as near
    to them all as can be."""
    ends = shapes.farthest_points(points(b), triangles(b), 5)
    far = [distances(b, end) for end in ends]
    middle = numpy.argmin(numpy.max(far, axis=0))
    return numpy.column_stack(far + [distances(b, middle)])


def distances(surface, seed):
    return array(output_of('GeodesicDistance', surface, scenes.point_set(points(surface)[[seed]])),
                 'GeodesicDistance')


def labels(data):
    return array(data, 'Distances').argmin(axis=1)


def carried(receiver, giver):
    return output_of('TransferFields', receiver, giver)


def pair(folder, name, program):
    facts = next(iter(made.pairs(os.path.join(folder, 'pairs'), [name], program=program)))
    given_a, given_b = (off.read(os.path.join(facts['folder'], side + '.off')) for side in 'AB')
    truth = numpy.loadtxt(os.path.join(facts['folder'], 'truth.txt'))[:, 4:]
    bent = facts['group'] == 'isometric'
    a, b = maps(given_a, given_b, Method=FUNCTIONAL if bent else HARMONIC,
                MaximumIterations=ITERATIONS)
    print('%s: mirrored %d, Dirichlet energy %.3f, round trip %.5f; %d triangles turned over, %d '
          'without area' % (name, *(fact(a, 'Correspondence.' + word) for word in (
              'Mirrored', 'DirichletEnergy', 'RoundTrip')), *turned_over(a, b)))
    curve = output_of('MapErrorCurve', a, given_b, with_array(given_a, truth, 'TargetPosition'))
    print('  error, of the root of the area: mean %.4f, 95 %% below %.4f; the image is %.2f %% of B'
          % (*(fact(curve, 'MapErrorCurve.' + word) for word in ('Mean', 'Percentile95')),
             100.0 * fact(curve, 'MapErrorCurve.Coverage')))
    # The giver is painted in its own pose, turned as A's is.
    upright = turn(points(a), array(a, 'TargetPosition')).T
    places = points(given_b) @ upright
    giver = fine(with_array(with_array(given_b, places, 'Place'), seed_distances(given_b), 'Distances'))
    low, size = places.min(axis=0), numpy.ptp(places, axis=0).max()
    add_array(giver, checker(array(giver, 'Place'), low, size), 'Texture')
    found = carried(a, giver)
    right = labels(found) == labels(carried(with_array(given_a, truth, 'TargetPosition'), giver))
    areas = numpy.zeros(len(truth))
    for corner in triangles(a).T:
        numpy.add.at(areas, corner, numpy.linalg.norm(shapes.area_vectors(
            points(a), triangles(a)), axis=1))
    print('  %.2f %% of the area of A has the label that it truly has, of %d; %.0f %% the most common '
          'one' % (100.0 * areas[right].sum() / areas.sum(), len(COLOURS),
                   100.0 * numpy.bincount(labels(found), areas).max() / areas.sum()))
    receiver = carried(fine(a), giver)
    # Not carried to the points put in, whose targets, off B, are as near to another limb there.
    segmented = fine(with_array(a, array(found, 'Distances'), 'Distances'))
    shapetesting.set_points(giver, points(giver) @ upright)
    draw_pair(os.path.join(folder, name + '.png'), giver, VIEWS[name], receiver, segmented)


def draw_pair(path, giver, view, receiver, segmented):
    sheet = Sheet(view, [0, 1, 0])
    for column, data, words in ((0, giver, 'a texture'), (1, receiver, 'carried over'),
                                (2, giver, 'a segmentation'), (3, segmented, 'carried over')):
        sheet.paint(column, data, array(data, 'Texture') if column < 2 else COLOURS[labels(data)])
        sheet.label(column, words)
    sheet.finish(path)


def stacked(path, *pictures):
    """One picture of several, the first one at the top."""
    rows = []
    for picture in reversed(pictures):  # VTK counts rows from below
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        rows.append(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(
            height, width, -1))
    colours, image, writer = numpy.vstack(rows), vtkImageData(), vtkPNGWriter()
    image.SetDimensions(colours.shape[1], colours.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(
        colours.reshape(-1, colours.shape[2]), deep=True))
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('folder')
    parser.add_argument('words', nargs='*', metavar='solid | PAIR')
    options = parser.parse_args()
    folder, words = options.folder, options.words
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    for word in words or ('solid',) + PAIRS:
        if word == 'solid':
            solid(folder)
        else:
            pair(folder, word, sweep.Program(options))
        sys.stdout.flush()
    if not words:
        stacked(*(os.path.join(folder, name + '.png') for name in ('overview', 'solid', PAIRS[0])))


if __name__ == '__main__':
    main()
