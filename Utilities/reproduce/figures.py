"""Pictures after the figures of "Feature-aligned harmonic volumetric mapping using MFS" (Li, Xu,
Wan, Yin and Yu 2010): pvpython figures.py FOLDER [NUMBER...], all of them or some.

1, 2: the phantom, by one harmonic map for each layer and by soft features; 3: two figures with
skeletons; 4: a bear and the ball; 5: a two-torus and its polycube; 7: the hexahedra of a cube in
the bear. It writes fig1.png and so on; captions in them carry what was measured.
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
    """The head, skull and brain with their images under both kinds of map."""

    def __init__(self):
        self.Shapes = scenes.phantom()
        head, skull, brain = self.Shapes
        self.Soft = scenes.volume_map(
            head, head, [skull, brain], FeatureWeight=20.0).GetOutputDataObject(1)
        say('phantom: soft features')
        self.Layers = []
        for parts in ((head, skull), (skull, brain), (brain,)):
            boundary = scenes.append(*parts)
            self.Layers.append(scenes.volume_map(
                boundary, boundary, CollocationRatio=0.8, SourceRatio=1.2,
                MaximumLevels=16).GetOutputDataObject(1))
        say('phantom: layers')

    def images(self, layered):
        charges = (self.Layers[0], self.Layers[0], self.Layers[1]) if layered else [self.Soft] * 3
        return [moved_by(*pair) for pair in zip(charges, self.Shapes)]

    def errors(self, layered):
        """RMSE of the boundary and of the features in percent of the target's longest side, 2."""
        misses = [numpy.linalg.norm(image - array(shape, 'TargetPosition'), axis=1) / 2.0
                  for image, shape in zip(self.images(layered), self.Shapes)]
        return [100.0 * numpy.sqrt((part ** 2).mean())
                for part in (misses[0], numpy.concatenate(misses[1:]))]

    def solid(self, solid, layered):
        """Where the points of a solid go: by the map of their layer, or by the one map."""
        if not layered:
            return moved_by(self.Soft, solid)
        inside = [boundary_distance(solid, shape) for shape in self.Shapes[1:]]
        layer = numpy.where(inside[1] < 0.0, 2, numpy.where(inside[0] < 0.0, 1, 0))
        places = points(solid)
        for index, charges in enumerate(self.Layers):
            chosen = layer == index
            places[chosen] = points(scenes.output_of(
                'ApplyVolumeMap', scenes.point_set(places[chosen]), charges))
        return places


def morphed(shape, image, time):
    algorithm = scenes.shapemap.vtkShapeMorph()
    algorithm.SetInputDataObject(0, with_array(shape, image, 'TargetPosition'))
    algorithm.UpdateInformation()
    algorithm.UpdateTimeStep(time)
    return algorithm.GetOutputDataObject(0)


def fig1(path, phantom):
    picture = panels.Picture((1500, 900), [0.75, 0.62, 0.22], [0.0, 0.0, 1.0])
    for row, layered in enumerate((True, False)):
        images = phantom.images(layered)
        for column, time in enumerate((0.0, 0.3, 0.6, 1.0)):
            for shape, image, colour, opacity in zip(
                    phantom.Shapes, images, (panels.SKIN, panels.BONE, panels.BRAIN),
                    (0.25, 0.4, 1.0)):
                centre = (0.0, 0.0, -0.15 * (1.0 - time))
                picture.show(morphed(shape, image, time), (2.5 * column, -2.95 * row), 1.0, centre,
                             colour, opacity, smooth=45.0)
            if row == 0:
                picture.caption('%d %%' % (100 * time), 2.5 * column, 1.35)
        boundary, features = phantom.errors(layered)
        picture.caption('%s: RMSE %.2f %% on the head, %.2f %% on skull and brain' % (
            words(layered), boundary, features), 3.75, -1.6 - 2.95 * row)
    picture.save(path, (3.75, -1.52), 6.2)


def words(layered):
    return 'one harmonic map for each layer' if layered else 'one map, soft features, weight 20'


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

    for column, layered in enumerate((True, False)):
        places = phantom.solid(section, layered)
        measured = scenes.output_of('BoundaryDistance', at(section, places * [0.0, 1.0, 1.0]), targets,
                                    Signed=0)
        field = array(measured, 'BoundaryDistance')
        left = 5.5 * column
        draw(with_array(section, field, 'Distance'), scenes.append(*phantom.Shapes),
             features[chosen], (left, 0.0),
             None if column else "distance from the target's three surfaces")
        draw(with_array(measured, field, 'Distance'), targets,
             numpy.concatenate(phantom.images(layered)[1:])[chosen], (left + 2.55, 0.0), None)
        boundary, error = phantom.errors(layered)
        picture.caption('%s: RMSE %.2f %% on the head, %.2f %% on skull and brain' % (
            words(layered), boundary, error), left + 1.25, 1.45, 16)
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
    """The section y = 0."""
    figures = [scenes.read('Figure%s.vtp' % name) for name in 'AB']
    lines = [scenes.read('Figure%sSkeleton.vtp' % name) for name in 'AB']
    solids = [tetrahedra(figure, volume=3e-6) for figure in figures]
    say('figures: %d and %d tetrahedra' % tuple(s.GetNumberOfCells() for s in solids))
    harmonic = scenes.volume_map(solids[0], figures[0], lines[:1], lines[1:],
                                 CollocationRatio=0.2, SourceRatio=0.4)
    moved = harmonic.GetOutputDataObject(0)
    boundary, feature = (100.0 * fact(moved, 'HarmonicVolumeMap.' + name)
                         for name in ('RMSEVertices', 'RMSEFeatures'))
    say('figures: RMSE %.2f %% of the boundary, %.2f %% of the skeleton' % (boundary, feature))
    giver = depth(solids[1], figures[1], 'Depth')
    receiver = transferred(with_array(solids[0], points(moved), 'TargetPosition'), giver, 'Pull')
    # Beside the skeleton itself, the images by the map that knows the boundary alone.
    samples = scenes.point_set(scenes.curves(lines[0], 15).reshape(-1, 3))
    alone = scenes.volume_map(samples, figures[0], CollocationRatio=0.2, SourceRatio=0.4)
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
    misses = numpy.linalg.norm(images[1] - scenes.curves(lines[1], 15).reshape(-1, 3), axis=1)
    alone = numpy.sqrt((misses ** 2).mean()) / scenes.longest_side(
        array(figures[0], 'TargetPosition'))
    picture.caption('RMSE on the skeleton %.2f %% (%.2f %% without it), on the boundary %.2f %%' % (
        feature, 100.0 * alone, boundary), 2.1, -1.2)
    picture.save(path, (2.1, -0.27), 2.14)


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
    torus = scenes.read('TwoTorus.vtp')
    slab = at(torus, array(torus, 'TargetPosition'))
    names = ('TorusDepth', 'SlabDepth')
    solids = [depth(tetrahedra(surface, volume=4e-4), surface, name)
              for surface, name in zip((torus, slab), names)]
    moved = scenes.volume_map(solids[0], torus, CollocationRatio=0.3, SourceRatio=0.5
                              ).GetOutputDataObject(0)
    say('two-torus: ' + error_words(moved))
    mapped = with_array(solids[0], points(moved), 'TargetPosition')
    pulled = transferred(mapped, solids[1], 'Pull')
    pushed = transferred(solids[1], mapped, 'Push')
    picture = panels.Picture((1400, 1000), [0.0, -0.5, 0.85], [0.0, 1.0, 0.0])
    for index, (data, name, text) in enumerate((
            (solids[1], 'SlabDepth', "the polycube's field"),
            (pulled, 'SlabDepth', 'pulled onto the two-torus'),
            (solids[0], 'TorusDepth', "the two-torus's field"),
            (pushed, 'TorusDepth', 'pushed onto the polycube'))):
        shift = (7.0 * (index % 2), -4.4 * (index // 2))
        shown = half(with_array(data, array(data, name), 'Depth'), (0.0, 0.0, 0.0),
                     (0.0, 0.0, 1.0))
        display = picture.show(shown, shift)
        display.Ambient, display.Diffuse = 0.5, 0.55
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                       None if index else 'depth, 1 = deepest', [0.33, 0.07])
        picture.caption(text, shift[0], shift[1] + 1.75)
    picture.caption(error_words(moved), 3.5, -8.2)
    picture.save(path, (3.5, -3.0), 10.8)


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
    caption = '%d hexahedra, %d with a scaled Jacobian <= 0 (least %.2f, mean %.2f)' % (
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
        table = simple.GetColorTransferFunction('Quality')
        table.UseBelowRangeColor, table.BelowRangeColor = 1, panels.RED
    for column, text in enumerate(('the bear', "the cube's grid", 'remeshed', 'cross-section')):
        picture.caption(text, 1.75 * column, 1.0)
    picture.caption(caption + '; ' + error_words(solid), 2.62, -1.6, 15)
    picture.save(path, (2.62, -0.25), 3.0)


def main(folder, *numbers):
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)  # a cut surface says that it is cut
    numbers = numbers or '123457'
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
