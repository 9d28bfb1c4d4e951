"""Pictures after the figures of "Feature-aligned harmonic volumetric mapping using MFS" (Li, Xu,
Wan, Yin and Yu 2010): pvpython figures.py FOLDER [NUMBER...], all of them or some.

1, 2: the phantom, by Exact and by soft features; 3: two figures with skeletons, from their surfaces
alone; 4: a bear and the ball; 5: a two-torus and an elk with their polycubes; 7: the hexahedra of a cube in
the bear; 8: those of polycubes in a two-torus, an elk and a bull. It writes fig1.png and so on; captions in
them carry what was measured.
"""
import os
import sys

import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet

import panels
import scenes  # knows where off.py is
import volume_models

import off
from scenes import (
    array, at, boundary_distance, fact, moved_by, points, say, skin, with_array)


def cut(data, origin, normal):
    """The section of a solid, or of a surface (then lines), with a plane."""
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cutter = vtkCutter()
    cutter.SetInputData(data)
    cutter.SetCutFunction(plane)
    cutter.Update()
    return cutter.GetOutput()


def half(data, origin, normal):
    """The surface of what a plane leaves of a solid behind it."""
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    clip = vtkTableBasedClipDataSet()
    clip.SetInputData(data)
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    clip.Update()
    return skin(clip.GetOutput())


def tetrahedra(surface, *inner, volume=0.0):
    algorithm = scenes.shapemap.vtkShapeTetrahedralize()
    algorithm.SetInputDataObject(0, surface)
    for part in inner:
        algorithm.AddInputDataObject(1, part)
    algorithm.SetMaximumVolume(volume)
    return scenes.checked(algorithm).GetOutputDataObject(0)


def depth(solid, surface, name):
    """The solid with its distance from the surface, 1 at the deepest point."""
    values = numpy.maximum(-boundary_distance(solid, surface, Signed=1), 0.0)
    return with_array(solid, values / values.max(), name)


def transferred(receiver, giver, direction):
    return scenes.output_of('TransferFields', receiver, giver,
                            Direction=('Pull', 'Push').index(direction))


class Phantom:
    """The head, skull and brain with their images under both kinds of map: Exact, which is harmonic in each layer
    and meets the inner surfaces as it meets the head's, and one harmonic map that the features guide."""

    def __init__(self):
        self.Shapes = scenes.phantom()
        head, *inner = self.Shapes
        self.Maps = {exact: scenes.volume_map(
            head, head, inner, Method=scenes.ACCELERATED if exact else scenes.MULTI_LEVEL, Exact=exact,
            FeatureWeight=20.0).GetOutputDataObject(1) for exact in (True, False)}
        say('phantom: both maps')

    def images(self, exact):
        return [moved_by(self.Maps[exact], shape) for shape in self.Shapes]

    def errors(self, exact):
        """RMSE of the boundary and of the features in percent of the target's longest side, 2."""
        misses = [numpy.linalg.norm(image - array(shape, 'TargetPosition'), axis=1) / 2.0
                  for image, shape in zip(self.images(exact), self.Shapes)]
        return [100.0 * numpy.sqrt((part ** 2).mean())
                for part in (misses[0], numpy.concatenate(misses[1:]))]

    def words(self, exact):
        return '%s: RMSE %.2f %% on the head, %.2f %% on skull and brain' % (
            'Exact' if exact else 'one map, soft features, weight 20', *self.errors(exact))


def morphed(shape, image, time):
    algorithm = scenes.shapemap.vtkShapeMorph()
    algorithm.SetInputDataObject(0, with_array(shape, image, 'TargetPosition'))
    algorithm.UpdateInformation()
    algorithm.UpdateTimeStep(time)
    return algorithm.GetOutputDataObject(0)


def fig1(path, phantom):
    picture = panels.Picture((1500, 900), [0.75, 0.62, 0.22], [0.0, 0.0, 1.0])
    for row, exact in enumerate((True, False)):
        images = phantom.images(exact)
        for column, time in enumerate((0.0, 0.3, 0.6, 1.0)):
            for shape, image, colour, opacity in zip(
                    phantom.Shapes, images, (panels.SKIN, panels.BONE, panels.BRAIN),
                    (0.25, 0.4, 1.0)):
                centre = (0.0, 0.0, -0.15 * (1.0 - time))
                picture.show(morphed(shape, image, time), (2.5 * column, -2.95 * row), 1.0, centre,
                             colour, opacity, smooth=45.0)
            if row == 0:
                picture.caption('%d %%' % (100 * time), 2.5 * column, 1.35)
        picture.caption(phantom.words(exact), 3.75, -1.6 - 2.95 * row)
    picture.save(path, (3.75, -1.52), 6.2)


def fig2(path, phantom):
    """The section x = 0: a fine grid in the head, and its image seen along x."""
    head, skull, brain = phantom.Shapes
    targets = scenes.append(*[at(s, array(s, 'TargetPosition')) for s in phantom.Shapes])
    features = points(scenes.append(skull, brain))
    chosen = numpy.abs(features[:, 0]) < 0.03
    origin, normal = (1e-4, 0.0, 0.0), (1.0, 0.0, 0.0)
    section = grid(head, 320)
    say('phantom: %d points in the section' % section.GetNumberOfPoints())
    picture = panels.Picture((1600, 700), [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])

    def outline(surfaces, shift):
        picture.flat(picture.show(cut(surfaces, origin, normal), shift, 1.0, (-0.1, 0.0, 0.0),
                                  [0.0, 0.0, 0.0], width=2.5))

    def draw(data, surfaces, dots, shift, legend):
        display = picture.show(data, shift)
        picture.flat(display)
        picture.colour(display, 'POINTS', 'Distance', 0.0, 0.5, legend, [0.33, 0.07], form='%.2f')
        outline(surfaces, shift)
        dots = dots * [0.0, 1.0, 1.0] + [0.2, 0.0, 0.0]
        picture.dots(dots, shift, 0.014)

    for column, exact in enumerate((True, False)):
        places = moved_by(phantom.Maps[exact], section)
        measured = scenes.output_of('BoundaryDistance', at(section, places * [0.0, 1.0, 1.0]), targets,
                                    Signed=0)
        field = array(measured, 'BoundaryDistance')
        left = 5.5 * column
        draw(with_array(section, field, 'Distance'), scenes.append(*phantom.Shapes),
             features[chosen], (left, 0.0),
             None if column else "distance from the target's three surfaces")
        draw(with_array(measured, field, 'Distance'), targets,
             numpy.concatenate(phantom.images(exact)[1:])[chosen], (left + 2.55, 0.0), None)
        picture.caption(phantom.words(exact), left + 1.25, 1.45, 16)
        picture.caption('the head, points on skull and brain', left, -1.75, 14)
        picture.caption('the target (black), images of the points', left + 2.55, -1.75, 14)
    picture.save(path, (4.02, -0.42), 4.75)


def grid(surface, count):
    """A square grid in the plane x = 0, without the squares that reach out of the surface."""
    low, high = surface.GetBounds()[2::2], surface.GetBounds()[3::2]
    y, z = (numpy.linspace(a, b, count) for a, b in zip(low, high))
    places = numpy.stack([0.0 * z[:, None] + 0.0 * y, 0.0 * z[:, None] + y, z[:, None] + 0.0 * y],
                         axis=2).reshape(-1, 3)
    inside = (boundary_distance(places, surface) <= 0.0).reshape(count, count)
    first = (numpy.arange(count - 1)[:, None] * count + numpy.arange(count - 1))[
        inside[:-1, :-1] & inside[:-1, 1:] & inside[1:, :-1] & inside[1:, 1:]]
    corners = numpy.stack([first, first + 1, first + count + 1, first + count], axis=1)
    used, renumbered = numpy.unique(corners, return_inverse=True)
    return off.surface(places[used], renumbered.reshape(-1, 4).tolist())


def fig3(path):
    """The section y = 0 of two figures. Nothing but their surfaces is given: the filters find the skeletons, match
    them, and map the surfaces."""
    folder = models_beside(path)
    boundary, bones = (scenes.read(file) for file in volume_models.counterpart('Figures', folder))
    figures = [volume_models.plain(scenes.read('Figure%s.vtp' % name)) for name in 'AB']
    lines = [bones, scenes.output_of('Skeleton', figures[1])]
    solids = [tetrahedra(figure, volume=3e-6) for figure in figures]
    say('figures: %d and %d tetrahedra' % tuple(s.GetNumberOfCells() for s in solids))
    harmonic = scenes.volume_map(solids[0], boundary, [bones], CollocationRatio=0.2, SourceRatio=0.4)
    moved = harmonic.GetOutputDataObject(0)
    size = scenes.longest_side(array(boundary, 'TargetPosition'))
    outer, feature = (100.0 * fact(moved, 'HarmonicVolumeMap.' + name)
                      for name in ('RMSEVertices', 'RMSEFeatures'))
    # What the surfaces' map itself is off, where the figures' known deformation is the truth.
    misses = numpy.linalg.norm(array(boundary, 'TargetPosition') - array(
        scenes.read('FigureA.vtp'), 'TargetPosition'), axis=1) / size
    say('figures: RMSE %.2f %% of the boundary, %.2f %% of the skeleton; surface map: median distance from the '
        'known one %.2f %%' % (outer, feature, 100.0 * numpy.median(misses)))
    giver = depth(solids[1], figures[1], 'Depth')
    receiver = transferred(with_array(solids[0], points(moved), 'TargetPosition'), giver, 'Pull')
    # Beside the skeleton itself, the images by the map that knows the boundary alone.
    chosen = numpy.arange(0, bones.GetNumberOfPoints(), max(1, bones.GetNumberOfPoints() // 75))
    samples = scenes.point_set(points(bones)[chosen])
    alone = scenes.volume_map(samples, boundary, CollocationRatio=0.2, SourceRatio=0.4)
    images = [moved_by(harmonic.GetOutputDataObject(1), samples),
              points(alone.GetOutputDataObject(0))]
    picture = panels.Picture((1600, 640), [0.0, -1.0, 0.0], [0.0, 0.0, 1.0])
    centre = (0.0, 0.0, 0.5)
    for index, colour in enumerate((panels.RED, panels.GREEN)):
        shift = (3.3 * index, 0.0)
        picture.show(figures[index], shift, 1.0, centre, panels.STEEL, 0.3, smooth=60.0)
        picture.flat(picture.show(lines[index], shift, 1.0, centre, colour, width=3.5))
    picture.dots(images[0] - [0.0, 0.2, 0.0], (3.3, 0.0), 0.008, 1.0, centre)
    # What the map misses lies between front and back: seen from the side.
    for column, places in enumerate(reversed(images)):
        shift = (4.1 + 0.45 * column, 0.0)
        picture.show(from_the_side(figures[1]), shift, 1.0, centre, panels.STEEL, 0.3, smooth=60.0)
        picture.flat(picture.show(from_the_side(lines[1]), shift, 1.0, centre, panels.GREEN,
                                  width=3.5))
        picture.dots(places[:, [1, 0, 2]] * [1.0, -0.01, 1.0] - [0.0, 0.6, 0.0], shift, 0.008, 1.0,
                     centre)
        picture.caption(('without', 'with it')[column], shift[0], 0.6)
    for column, data in enumerate((receiver, giver)):
        section = cut(data, (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))
        display = picture.show(section, (1.1 + 1.1 * column, 0.0), 1.0, centre)
        picture.flat(display)
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                       None if column else 'depth in figure B, 1 = deepest', [0.33, 0.13])
    for column, text in enumerate(('A and its skeleton', "B's field pulled to A", "B's own field",
                                   'B, weight 20')):
        picture.caption(text, 1.1 * column, 0.6)
    picture.caption("B's skeleton green, images of A's red;", 4.05, -0.56, 14)
    picture.caption('from the side: without and with it as a soft feature', 4.05, -0.64, 14)
    misses = numpy.linalg.norm(images[1] - array(bones, 'TargetPosition')[chosen], axis=1) / size
    picture.caption('RMSE on the skeleton %.2f %% (%.2f %% without it), on the boundary %.2f %%' % (
        feature, 100.0 * numpy.sqrt((misses ** 2).mean()), outer), 2.1, -1.2)
    picture.save(path, (2.1, -0.27), 2.14)


def models_beside(path):
    """The folder of the models that tables.py measures, too."""
    folder = os.path.join(os.path.dirname(os.path.abspath(path)), 'models')
    os.makedirs(folder, exist_ok=True)
    return folder


def from_the_side(surface):
    return at(surface, points(surface)[:, [1, 0, 2]] * [1.0, -1.0, 1.0])


class Bear:
    """The model, its image on the sphere, and the ball's hexahedra inside it."""

    def __init__(self):
        self.Surface = scenes.model('bear')
        self.Sphere = scenes.sphere_map(self.Surface).GetOutputDataObject(1)
        self.Ball = scenes.read('Ball.vtu')
        say('bear: sphere map')


def error_words(solid):
    return 'boundary RMSE %.2f %% at points, %.2f %% inside triangles' % tuple(
        100.0 * fact(solid, 'HarmonicVolumeMap.' + name) for name in ('RMSEVertices', 'RMSEInside'))


def fig4(path, bear):
    ball = depth(bear.Ball, bear.Sphere, 'BallDepth')
    solid = depth(tetrahedra(bear.Surface, volume=3e-5), bear.Surface, 'BearDepth')
    moved = scenes.volume_map(ball, bear.Sphere, MapArray='SourcePosition', CollocationRatio=0.12,
                              SourceRatio=0.2).GetOutputDataObject(0)
    say('ball into bear: ' + error_words(moved))
    mapped = with_array(ball, points(moved), 'TargetPosition')
    pulled = transferred(mapped, solid, 'Pull')
    pushed = transferred(solid, mapped, 'Push')
    picture = panels.Picture((1600, 640), [0.25, 0.15, 1.0], [0.0, 1.0, 0.0])
    middle, nothing = (0.0, 0.1, 0.0), (0.0, 0.0, 0.0)
    for column, (data, name, scale, centre, text) in enumerate((
            (solid, 'BearDepth', 1.0, middle, "the bear's field"),
            (pulled, 'BearDepth', 0.75, nothing, 'pulled onto the ball'),
            (ball, 'BallDepth', 0.75, nothing, "the ball's field"),
            (pushed, 'BallDepth', 1.0, middle, 'pushed onto the bear'))):
        shift = (1.75 * column, 0.0)
        shown = half(with_array(data, array(data, name), 'Depth'), nothing, (0.0, 0.0, 1.0))
        display = picture.show(shown, shift, scale, centre)
        display.Ambient, display.Diffuse = 0.5, 0.55
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                       None if column else 'depth, 1 = deepest', [0.33, 0.13])
        picture.caption(text, shift[0], 1.0)
    picture.caption(error_words(moved), 2.62, -1.6)
    picture.save(path, (2.62, -0.25), 3.0)


def fig5(path):
    """Fields carried between polycubes and their solids: a row for each solid."""
    picture = panels.Picture((1600, 900), [0.0, -0.45, 1.0], [0.0, 1.0, 0.0])
    names = ('SolidDepth', 'CubeDepth')
    for row, name in enumerate(('TwoTorusCube', 'ElkCube')):
        skin_of_cube, grid, hexahedra = (scenes.read(file) for file in volume_models.cube_files(
            name, models_beside(path)))
        solid = depth(hexahedra, volume_models.solid_of(name), names[0])
        cube = depth(grid, skin_of_cube, names[1])
        moved = scenes.volume_map(cube, skin_of_cube, CollocationRatio=0.4, SourceRatio=0.6).GetOutputDataObject(0)
        say('%s: %s' % (name, error_words(moved)))
        mapped = with_array(cube, points(moved), 'TargetPosition')
        pulled, pushed = transferred(mapped, solid, 'Pull'), transferred(solid, mapped, 'Push')
        for column, (data, field, text) in enumerate((
                (cube, names[1], "the polycube's field"), (pushed, names[1], 'pushed onto the solid'),
                (solid, names[0], "the solid's field"), (pulled, names[0], 'pulled onto the polycube'))):
            shift = (1.3 * column, -1.35 * row)
            scale, centre, normal = framed(data)
            display = picture.show(
                half(with_array(data, array(data, field), 'Depth'), centre, normal), shift, scale, centre)
            display.Ambient, display.Diffuse = 0.5, 0.55
            picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                           None if row or column else 'depth, 1 = deepest', [0.33, 0.04])
            if row == 0:
                picture.caption(text, shift[0], 0.62)
        picture.caption('%s; %s' % (CUBE_WORDS[name], error_words(moved)), 1.95, -0.68 - 1.35 * row)
    picture.save(path, (1.95, -0.87), 3.2)


CUBE_WORDS = {'TwoTorusCube': 'two-torus, polycube of Shape Polycube',
              'ElkCube': 'elk (genus 1), polycube of the grid of Shape Hex Remesh',
              'BullCube': 'bull, polycube of the grid of Shape Hex Remesh'}


def framed(data):
    """The scale that makes the longest side of a box 1, its centre, and the axis of the camera."""
    low, high = numpy.array(data.GetBounds()).reshape(3, 2).T
    return 1.0 / (high - low).max(), tuple(0.5 * (low + high)), (0.0, 0.0, 1.0)


def fig7(path, bear):
    """The cube's hexahedra: its surface goes to the bear's by way of the sphere."""
    grid = scenes.read('Cube.vtu')
    cube = scenes.output_of('Parameterize', scenes.triangulated(skin(grid)))
    # The place on the bear whose image on the sphere is that of the cube's point.
    boundary = transferred(cube, bear.Sphere, 'Pull')
    solid = scenes.volume_map(grid, boundary, MapArray='SourcePosition', CollocationRatio=0.3,
                              SourceRatio=0.4).GetOutputDataObject(0)
    say('cube into bear: ' + error_words(solid))
    hexahedra = scenes.scaled_jacobians(solid)
    jacobians = scenes.vtk_to_numpy(hexahedra.GetCellData().GetArray('Quality'))
    inverted = int((jacobians <= 0.0).sum())
    flips = scenes.output_of('MapQuality', with_array(grid, points(solid), 'TargetPosition'))
    flipped = fact(flips, 'MapQuality.FlippedCells')
    caption = '%d hexahedra, %d with a scaled Jacobian <= 0 (minimum %.2f, mean %.2f)' % (
        len(jacobians), inverted, jacobians.min(), jacobians.mean())
    say(caption + '; Shape Map Quality: %d flipped' % flipped)
    assert (flipped > 0) == (inverted > 0)
    picture = panels.Picture((1600, 640), [0.3, 0.1, 1.0], [0.0, 1.0, 0.0])
    middle = (0.0, 0.1, 0.0)
    edges = 'Surface With Edges'
    picture.show(bear.Surface, (0.0, 0.0), 1.0, middle, panels.SKIN, representation=edges,
                 width=0.3).EdgeColor = [0.55, 0.45, 0.40]
    picture.show(skin(grid), (1.75, 0.0), 0.95, (0.0, 0.0, 0.0), panels.STEEL,
                 representation=edges, width=1.0)
    for column, data in ((2, skin(hexahedra)),
                         (3, skin(scenes.behind(hexahedra, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))))):
        display = picture.show(data, (1.75 * column, 0.0), 1.0, middle, representation=edges,
                               width=1.0)
        picture.colour(display, 'CELLS', 'Quality', 0.0, 1.0,
                       'scaled Jacobian (red: inverted)' if column == 2 else None, [0.33, 0.13],
                       'Viridis (matplotlib)', 10)
        display.Ambient = 0.3
        mark_inverted()
    for column, text in enumerate(('the bear', "the cube's grid", 'remeshed', 'cross-section')):
        picture.caption(text, 1.75 * column, 1.0)
    picture.caption(caption + '; ' + error_words(solid), 2.62, -1.6, 15)
    picture.save(path, (2.62, -0.25), 3.0)


def fig8(path):
    """Hexahedra of polycubes in their solids by the harmonic map, whole and cut. Where an edge of the polycube goes
    to a flat part of the solid, cells are inverted; Shape Hex Remesh has layers there, and untangles."""
    picture = panels.Picture((1600, 1250), [0.35, 0.2, 1.0], [0.0, 1.0, 0.0])
    for row, name in enumerate(('TwoTorusCube', 'ElkCube', 'BullCube')):
        skin_of_cube, grid, best = (scenes.read(file) for file in volume_models.cube_files(
            name, models_beside(path)))
        solid = scenes.volume_map(grid, skin_of_cube, CollocationRatio=0.4, SourceRatio=0.6
                                  ).GetOutputDataObject(0)
        hexahedra, filled = scenes.scaled_jacobians(solid), scenes.scaled_jacobians(best)
        jacobians, others = (scenes.vtk_to_numpy(data.GetCellData().GetArray('Quality'))
                             for data in (hexahedra, filled))
        captions = (
            '%s: %d hexahedra; %s' % (CUBE_WORDS[name], len(jacobians), error_words(solid)),
            '%d with a scaled Jacobian <= 0, mean %.2f; of Shape Hex Remesh itself: %d hexahedra, minimum %.2f, '
            'mean %.2f' % ((jacobians <= 0.0).sum(), jacobians.mean(), len(others), others.min(), others.mean()))
        say('; '.join(captions))
        assert others.min() > 0.0, 'Shape Hex Remesh leaves inverted hexahedra'
        scale, centre, normal = framed(grid)
        show_hexahedra(picture, skin(grid), (0.0, -1.45 * row), scale, centre)
        scale, centre, normal = framed(hexahedra)
        for column, data in enumerate((hexahedra, scenes.behind(hexahedra, centre, normal), scenes.behind(
                filled, centre, normal)), 1):
            display = show_hexahedra(picture, skin(data), (1.3 * column, -1.45 * row), scale, centre)
            picture.colour(display, 'CELLS', 'Quality', 0.0, 1.0,
                           None if row or column > 1 else 'scaled Jacobian (red: inverted)', [0.33, 0.03],
                           'Viridis (matplotlib)', 10)
            mark_inverted()
        for line, words in enumerate(captions):
            picture.caption(words, 1.95, -0.62 - 0.09 * line - 1.45 * row, 14)
    for column, text in enumerate(('the polycube', 'remeshed by the harmonic map', 'cross-section',
                                   'of Shape Hex Remesh itself')):
        picture.caption(text, 1.3 * column, 0.6)
    picture.save(path, (1.95, -1.65), 4.9)


def mark_inverted():
    table = simple.GetColorTransferFunction('Quality')
    table.UseBelowRangeColor, table.BelowRangeColor = 1, panels.RED


def show_hexahedra(picture, surface, shift, scale, centre):
    display = picture.show(surface, shift, scale, centre, panels.STEEL, representation='Surface With Edges',
                           width=0.6)
    display.Ambient = 0.3
    return display


def main(folder, *numbers):
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)  # a cut surface says that it is cut
    numbers = numbers or '1234578'
    shared = {}
    for kind, users in ((Phantom, '12'), (Bear, '47')):
        if any(number in users for number in numbers):
            shared.update(dict.fromkeys(users, kind()))
    for number in numbers:
        arguments = [shared[number]] if number in shared else []
        globals()['fig' + number](os.path.join(folder, 'fig%s.png' % number), *arguments)
        say('drew fig%s.png' % number)


if __name__ == '__main__':
    main(*sys.argv[1:])
