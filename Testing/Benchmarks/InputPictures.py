"""Draws what people bring beside what it becomes: one picture for each case, CASE.png.

    Utilities/pvpython.sh Testing/Benchmarks/InputPictures.py OUTPUT [CASE ...] --images FOLDER

The images are those of LabelImages.py. Cases, ten by default, are the functions below; each returns its panels from
left to right. Surfaces of libcgal-demo are read from build/models."""
import os
import subprocess
import tempfile

import sweep

import numpy
from paraview import simple
from vtkmodules.vtkFiltersSources import vtkSphereSource
import shapemap

import decks
import femur
import off
import panels
import pictures
import scenes
import shapetesting
import ImageValues
from LabelImages import read_image, to_vtk
from LabelSurfaces import Phantom, peer
from shapetesting import fact, outputs

SMALLEST_ISLAND = 8
CASES = {}


class Panel:
    """A data set, the array that colours it, and the words below."""

    def __init__(self, data, words, array=None, like=None, edges=True, limits=None, opacity=1.0, dots=None):
        self.Data, self.Words, self.Array, self.Like, self.Edges = data, words, array, like, edges
        self.Limits, self.Opacity, self.Dots = limits, opacity, dots


def case(direction, up):
    """Marks a function as a case that is looked at from this direction."""
    def mark(function):
        CASES[function.__name__] = (function, direction, up)
        return function
    return mark


def new(kind, *inputs, **settings):
    """The outputs of a filter; its refusal is an error."""
    return outputs(shapetesting.new(kind, *inputs, **settings))


def cut(solid, normal):
    return scenes.behind(solid, solid.GetCenter(), normal)


def filled(surface, normal, **settings):
    """Panels of regions that touch: their surface, and their hexahedra, cut."""
    solid = new(shapemap.vtkShapeHexRemesh, surface, **settings)[0]
    half = cut(solid, normal)
    words = '%d hexahedra, regions: %d; cut' % (solid.GetNumberOfCells(), fact(solid, 'HexRemesh.Regions'))
    quality = 'scaled Jacobian at least %.2f' % fact(solid, 'HexRemesh.MinimumScaledJacobian')
    return [Panel(half, words, 'RegionId', solid), Panel(half, quality, 'ScaledJacobian', solid)]


def regions(image, threshold=None):
    surfaces = shapetesting.new(shapemap.vtkShapeLabelSurfaces, image, LabelArray='Label',
                                SmallestIsland=SMALLEST_ISLAND)
    if threshold is not None:
        surfaces.SetThresholds(0, threshold)
    return outputs(surfaces)[0]


@case((0.3, -1.0, 0.4), (0, 0, 1))
def liver(images):
    values, spacing = read_image(os.path.join(images, 'liver.inr.gz'))
    steps = numpy.maximum(1, numpy.round(4.0 * spacing.min() / spacing)).astype(int)
    image = to_vtk(values[::steps[2], ::steps[1], ::steps[0]], spacing * steps)
    surface = regions(image)
    return [Panel(surface, 'surfaces of %d voxels' % image.GetNumberOfPoints(), 'Patch', edges=False)] + filled(
        surface, (0, -1, 0))


@case((0.9, -1.0, 0.4), (0, 0, 1))
def skull(images):
    values, spacing = read_image(os.path.join(images, 'skull_2.9.inr'))
    surface = regions(to_vtk(values, spacing), 2.9)
    return [Panel(surface, 'surfaces between grey values', 'Patch', edges=False)] + filled(surface, (1, 0, 0))


@case((0.5, -1.0, 0.5), (0, 0, 1))
def phantom(images):
    image = Phantom(48, 6, 3).image()
    surface = regions(image)
    return [Panel(peer(image, 6)[1], "VTK's discrete contour and windowed sinc", edges=False),
            Panel(surface, 'Shape Label Surfaces', 'Patch', edges=False)] + filled(surface, (0, -1, 0))[:1]


def solidified(damaged, words, **settings):
    """Panels of a surface with its defects, and of what becomes of it."""
    defects = new(shapemap.vtkShapeSolidify, damaged, Method=1)[1]
    solid = new(shapemap.vtkShapeSolidify, damaged, **settings)[0]
    return [Panel(damaged, words + ': %d defects' % defects.GetNumberOfPoints(), dots=defects),
            Panel(solid, '%s: kept, mended, made' % fact(solid, 'Solidify.Method'), 'Origin', like=damaged,
                  edges=False, limits=(0, 2))]


def moved(surface, shift, scale=1.0):
    result = shapetesting.copy(surface)
    shapetesting.set_points(result, scale * shapetesting.points(surface) + shift)
    return result


@case((0.55, 0.2, 0.81), (0, 1, 0))
def scan(images):
    """A surface with holes, triangles that face inwards, and two with an edge too many."""
    bunny = scenes.model('bunny00')
    faces = shapetesting.triangles(bunny)
    middles = shapetesting.points(bunny)[faces].mean(axis=1)
    random = numpy.random.default_rng(5)
    holes = numpy.zeros(len(faces), bool)
    for centre in middles[random.choice(len(faces), 6)]:
        holes |= numpy.linalg.norm(middles - centre, axis=1) < 0.05
    kept = faces[~holes].copy()
    turned = numpy.linalg.norm(middles[~holes] - middles[random.integers(len(faces))], axis=1) < 0.12
    kept[turned] = kept[turned][:, ::-1]
    damaged = off.surface(shapetesting.points(bunny), kept)
    return solidified(damaged, 'holes and turned triangles')


@case((0.4, -1.0, 0.5), (0, 0, 1))
def crossing(images):
    """Parts that cross each other."""
    figure = shapetesting.read('FigureA.vtp')
    return solidified(scenes.append(figure, moved(figure, (0.18, 0.1, 0.05)), moved(figure, (-0.1, -0.15, 0.3), 0.6)),
                      'three parts that cross')


@case((0.6, -1.0, 0.6), (0, 0, 1))
def sheets(images):
    """Open sheets, which enclose nothing."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(48)
    sphere.SetPhiResolution(24)
    sphere.SetStartPhi(80.0)
    sphere.Update()
    bowl = sphere.GetOutput()
    return solidified(scenes.append(bowl, moved(bowl, (0.0, 0.0, -0.1), 0.6)), 'two bowls without thickness',
                      Method=4)


@case((0.5, -0.8, 0.6), (0, 0, 1))
def cad(images):
    """A STEP file, and hexahedra that know its faces."""
    folder = tempfile.mkdtemp()
    script, step = os.path.join(folder, 'part.geo'), os.path.join(folder, 'part.step')
    with open(script, 'w') as file:
        file.write('SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 6, 3, 1}; Box(2) = {0, 0, 0, 1, 3, 3};'
                   'BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };'
                   'Cylinder(4) = {4, 1.5, -1, 0, 0, 4, 0.8};'
                   'BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };\n')
    subprocess.check_call(['gmsh', script, '-0', '-o', step], stdout=subprocess.DEVNULL)
    surface = new(shapemap.vtkShapeCADReader, FileName=step)[0]
    faces = surface.GetCellData().GetArray('Patch').GetRange()[1]
    solid, boundary = new(shapemap.vtkShapeHexRemesh, surface, PatchArray='Patch', CellSize=0.25)[:2]
    return [Panel(surface, '%d faces of a STEP file' % faces, 'Patch'),
            Panel(boundary, '%d hexahedra, the same patches' % solid.GetNumberOfCells(), 'Patch'),
            Panel(solid, 'scaled Jacobian at least %.2f' % fact(solid, 'HexRemesh.MinimumScaledJacobian'),
                  'ScaledJacobian')]


@case((0.25, -1.0, 0.0), (0, 0, -1))
def materials(images):
    """A femur in a CT-like image, and the moduli of its cells."""
    surface = femur.bone()
    grid = femur.mesh(surface, 0.035)
    image = ImageValues.phantom(surface, 0.01, 0.0)
    data = new(shapemap.vtkShapeImageValues, grid, image, Density='max(0.01, 0.001 * HU)', Materials=12)[0]
    half = cut(data, (0, -1, 0))
    return [Panel(surface, 'a femur', edges=False), Panel(half, 'the modulus of each cell, cut', 'Modulus', data),
            Panel(half, 'the twelve materials of the deck', 'MaterialId', data)]


@case((0.6, -1.0, 0.6), (0, 0, 1))
def deck(images):
    """An Abaqus deck, and the same deck bent."""
    folder = tempfile.mkdtemp()
    given = new(shapemap.vtkShapeDeckReader, FileName=decks.write(folder, (8, 8, 8)))[0]
    x, y, z = shapetesting.points(given).T
    bent = shapetesting.copy(given)
    shapetesting.set_points(bent, numpy.stack([x + 0.3 * z ** 2, y, z - 0.5 * z * x], axis=1))
    return [Panel(given, 'an Abaqus deck'), Panel(bent, 'its nodes, moved by a map')]


@case((0.55, 0.2, 0.81), (0, 1, 0))
def fin(images):
    """A surface with edges of three triangles, and distances on it."""
    bunny = scenes.model('bunny00')
    places, faces = shapetesting.points(bunny), shapetesting.triangles(bunny)
    ring = faces[numpy.linalg.norm(places[faces].mean(axis=1) - places.mean(axis=0), axis=1).argsort()[-40:]]
    tips = places[ring].mean(axis=1) + 0.06 * (places[ring].mean(axis=1) - places.mean(axis=0))
    fins = numpy.column_stack([ring[:, 0], ring[:, 1], len(places) + numpy.arange(len(ring))])
    damaged = off.surface(numpy.vstack([places, tips]), numpy.vstack([faces, fins]))
    defects = new(shapemap.vtkShapeSolidify, damaged, Method=1)[1]
    seeds = scenes.point_set(places[:1])
    distance = new(shapemap.vtkShapeGeodesicDistance, damaged, seeds)[0]
    return [Panel(damaged, 'fins on its edges: %d defects' % defects.GetNumberOfPoints(), dots=defects),
            Panel(distance, 'geodesic distance on it', 'GeodesicDistance', edges=False)]


def draw(path, shown, direction, up):
    sheet = panels.Sheet((600 * len(shown), 620), direction, up, 1.2, [1.1, 1.0], -0.62)
    for column, panel in enumerate(shown):
        display = sheet.fit(column, panel.Data, panel.Like,
                            representation='Surface With Edges' if panel.Edges else 'Surface', width=1.0)
        display.Ambient, display.Opacity = 0.3, panel.Opacity
        if panel.Array == 'ScaledJacobian':
            table = simple.GetColorTransferFunction(panel.Array)
            table.ColorSpace, table.RGBPoints = 'RGB', pictures.QUALITY
            pictures.colour_by(display, 'CELLS', panel.Array, table, sheet.View)
        elif panel.Array:
            association = 'CELLS' if panel.Data.GetCellData().HasArray(panel.Array) else 'POINTS'
            attributes = panel.Data.GetCellData() if association == 'CELLS' else panel.Data.GetPointData()
            low, high = panel.Limits or attributes.GetArray(panel.Array).GetRange()
            preset = 'Cool to Warm' if panel.Array == 'Origin' else 'Turbo'
            sheet.colour(display, association, panel.Array, low, high, preset=preset, steps=64)
        if panel.Dots and panel.Dots.GetNumberOfPoints():
            shift, scale, centre = sheet.where(column, panel.Data)
            sheet.dots(shapetesting.points(panel.Dots), shift, 0.008 / scale, scale, centre)
        sheet.label(column, panel.Words)
    sheet.save(path, [0.6 * (len(shown) - 1), -0.1], 1.24)


def main():
    parser = sweep.parser(__doc__, models=False)
    parser.add_argument('output')
    parser.add_argument('--images', help='the folder of liver.inr.gz and skull_2.9.inr')
    parser.add_argument('cases', nargs='*', metavar='CASE')
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    for name in options.cases or list(CASES):
        function, direction, up = CASES[name]
        draw(os.path.join(options.output, name + '.png'), function(options.images), direction, up)
        print('drew', name, flush=True)


if __name__ == '__main__':
    main()
