"""Pictures after the figures of Li, Xu, Wan, Yin and Yu 2010: pvpython figures.py FOLDER [NUMBER...].

fig1, fig2: the phantom, by one harmonic map for each layer and by soft features; fig3: two figures
with skeletons; fig4: a bear and the ball; fig5: a two-torus and its polycube; fig7: the hexahedra of
a cube in the bear. Captions in the pictures carry what was measured.
"""
import os
import sys

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

import panels
import scenes
from scenes import add_array, array, copy, fact, points, say


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


def crinkled(data, origin, normal):
    """The surface of the cells of a solid whose middle is on the plane's far side."""
    from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
    plane = vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    extract = vtkExtractGeometry()
    extract.SetInputData(data)
    extract.SetImplicitFunction(plane)
    extract.ExtractBoundaryCellsOn()
    extract.Update()
    return skin(extract.GetOutput())


def skin(data):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()


def at(data, places):
    """The same cells with other points."""
    result = copy(data)
    scenes.shapetesting.set_points(result, places)
    return result


def with_array(data, values, name):
    result = copy(data)
    add_array(result, values, name)
    return result


def tetrahedra(surface, *inner, volume=0.0):
    algorithm = scenes.shapemap.vtkShapeTetrahedralize()
    algorithm.SetInputDataObject(0, surface)
    for part in inner:
        algorithm.AddInputDataObject(1, part)
    algorithm.SetMaximumVolume(volume)
    return scenes.checked(algorithm).GetOutputDataObject(0)


def moved_by(charges, data):
    """Where a map takes the points of `data`."""
    output = scenes.filter_of('ApplyVolumeMap', data, charges).GetOutputDataObject(0)
    outside = int((array(output, 'OutsideDomain') == 1).sum())
    if outside > 0.001 * data.GetNumberOfPoints():
        raise RuntimeError('%d points lie outside the domain of the map' % outside)
    return points(output)


def depth(solid, surface, name):
    """The solid with its distance from the surface, 1 at the deepest point."""
    output = scenes.filter_of('BoundaryDistance', solid, surface, Signed=1).GetOutputDataObject(0)
    values = numpy.maximum(-array(output, 'BoundaryDistance'), 0.0)
    return with_array(solid, values / values.max(), name)


def transferred(receiver, giver, direction):
    return scenes.filter_of('TransferFields', receiver, giver,
                            Direction=('Pull', 'Push').index(direction)).GetOutputDataObject(0)


class Phantom:
    """The head, skull and brain with their images under both kinds of map."""

    def __init__(self):
        self.Shapes = [scenes.read('Phantom%sSmall.vtp' % name)
                       for name in ('Head', 'Skull', 'Brain')]
        head, skull, brain = self.Shapes
        self.Soft = scenes.volume_map(
            head, head, [skull, brain], FeatureWeight=20.0).GetOutputDataObject(1)
        say('phantom: soft features')
        self.Layers = []
        for parts in ((head, skull), (skull, brain), (brain,)):
            boundary = scenes.append(*parts)
            self.Layers.append(
                scenes.volume_map(boundary, boundary).GetOutputDataObject(1))
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
        """Where the points of a solid go: by the map of the layer they are in, or by the one map."""
        if not layered:
            return moved_by(self.Soft, solid)
        inside = [array(scenes.filter_of('BoundaryDistance', solid, shape).GetOutputDataObject(0),
                        'BoundaryDistance') for shape in self.Shapes[1:]]
        layer = numpy.where(inside[1] < 0.0, 2, numpy.where(inside[0] < 0.0, 1, 0))
        places = points(solid)
        for index, charges in enumerate(self.Layers):
            chosen = layer == index
            places[chosen] = points(scenes.filter_of(
                'ApplyVolumeMap', scenes.point_set(places[chosen]), charges).GetOutputDataObject(0))
        return places


def morphed(shape, image, time):
    algorithm = scenes.shapemap.vtkShapeMorph()
    algorithm.SetInputDataObject(0, with_array(shape, image, 'TargetPosition'))
    algorithm.UpdateInformation()
    algorithm.UpdateTimeStep(time)
    return algorithm.GetOutputDataObject(0)


def fig1(path, phantom):
    picture = panels.Picture((1400, 900), [0.75, 0.62, 0.22], [0.0, 0.0, 1.0])
    for row, layered in enumerate((True, False)):
        images = phantom.images(layered)
        for column, time in enumerate((0.0, 0.3, 0.6, 1.0)):
            for shape, image, colour, opacity in zip(
                    phantom.Shapes, images, (panels.SKIN, panels.BONE, panels.BRAIN),
                    (0.22, 0.45, 1.0)):
                centre = (0.0, 0.0, -0.15 * (1.0 - time))
                picture.show(morphed(shape, image, time), (2.6 * column, -2.75 * row), 1.0, centre,
                             colour, opacity, smooth=45.0)
            if row == 0:
                picture.caption('%d %%' % (100 * time), 0.115 + 0.245 * column, 0.955)
        boundary, features = phantom.errors(layered)
        words = 'one harmonic map for each layer' if layered else 'one map, soft features, weight 20'
        picture.caption('%s: RMSE %.2f %% on the head, %.2f %% on skull and brain' % (
            words, boundary, features), 0.2, 0.49 if row == 0 else 0.015)
    picture.save(path, (3.9, -1.42), 5.75)


def fig2(path, phantom):
    """Sections x = 0."""
    head, skull, brain = phantom.Shapes
    solid = tetrahedra(head, skull, brain, volume=3e-4)
    say('phantom: %d tetrahedra' % solid.GetNumberOfCells())
    targets = scenes.append(*[at(s, array(s, 'TargetPosition')) for s in phantom.Shapes])
    features = scenes.append(skull, brain)
    origin, normal = (0.02, 0.0, 0.0), (1.0, 0.0, 0.0)
    picture = panels.Picture((1600, 1000), [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])

    def near(places):
        slab = numpy.abs(places[:, 0] - origin[0]) < 0.03
        chosen = places[slab].copy()
        chosen[:, 0] = origin[0] + 0.02
        return chosen

    def outline(surfaces, shift):
        display = picture.show(cut(surfaces, origin, normal), shift, 1.0,
                               (-0.03, 0.0, 0.0), [0.0, 0.0, 0.0], width=2.5)
        picture.flat(display)

    for column, layered in enumerate((True, False)):
        places = phantom.solid(solid, layered)
        measured = scenes.filter_of('BoundaryDistance', at(solid, places), targets,
                                    Signed=0).GetOutputDataObject(0)
        field = array(measured, 'BoundaryDistance')
        for row, data in enumerate((solid, measured)):
            shift = (2.75 * (2 * column + row), 0.0)
            section = cut(with_array(data, field, 'Distance'), origin, normal)
            display = picture.show(section, shift)
            picture.flat(display)
            picture.colour(display, 'POINTS', 'Distance', 0.0, 0.5,
                           "distance from the target's three surfaces" if column + row == 0 else None,
                           [0.33, 0.1])
            if row == 0:
                outline(scenes.append(*phantom.Shapes), shift)
                picture.dots(near(points(features)), shift)
            else:
                outline(targets, shift)
                # The same points as in the head.
                chosen = numpy.abs(points(features)[:, 0] - origin[0]) < 0.03
                images = numpy.concatenate(phantom.images(layered)[1:])[chosen]
                images[:, 0] = origin[0] + 0.02
                picture.dots(images, shift)
        boundary, error = phantom.errors(layered)
        picture.caption('%s\nRMSE: boundary %.2f %%, features %.2f %%' % (
            'one harmonic map for each layer' if layered else 'one map, soft features, weight 20',
            boundary, error), 0.13 + 0.5 * column, 0.8)
    picture.caption('head: field pulled back, feature points red             '
                    'target: true surfaces black, images of the feature points red', 0.14, 0.2)
    picture.save(path, (4.12, -0.15), 6.9)


def fig3(path):
    """Section y = 0."""
    figures = [scenes.read('Figure%s.vtp' % name) for name in 'AB']
    lines = [scenes.read('Figure%sSkeleton.vtp' % name) for name in 'AB']
    solids = [tetrahedra(figure, volume=1e-5) for figure in figures]
    say('figures: %d and %d tetrahedra' % tuple(s.GetNumberOfCells() for s in solids))
    harmonic = scenes.volume_map(solids[0], figures[0], lines[:1], lines[1:],
                                 CollocationRatio=0.2, SourceRatio=0.4)
    moved = harmonic.GetOutputDataObject(0)
    boundary, feature = (100.0 * fact(moved, 'HarmonicVolumeMap.' + name)
                         for name in ('RMSEVertices', 'RMSEFeatures'))
    say('figures: RMSE %.2f %% of the boundary, %.2f %% of the skeleton' % (boundary, feature))
    giver = depth(solids[1], figures[1], 'Depth')
    receiver = transferred(with_array(solids[0], points(moved), 'TargetPosition'), giver, 'Pull')
    images = moved_by(harmonic.GetOutputDataObject(1),
                      scenes.point_set(scenes.curves(lines[0], 25).reshape(-1, 3)))
    picture = panels.Picture((1600, 640), [0.0, -1.0, 0.0], [0.0, 0.0, 1.0])
    centre = (0.0, 0.0, 0.5)
    for column, (figure, line, colour) in enumerate(
            zip(figures, lines, (panels.RED, panels.GREEN))):
        shift = (1.1 * 3 * column, 0.0)
        picture.show(figure, shift, 1.0, centre, panels.STEEL, 0.3, smooth=60.0)
        picture.flat(picture.show(line, shift, 1.0, centre, colour, width=4.0))
    picture.dots(images - [0.0, 0.02, 0.0], (3.3, 0.0), 1.0, centre, size=7.0)
    for column, data in enumerate((receiver, giver)):
        display = picture.show(cut(data, (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)), (1.1 + 1.1 * column, 0.0),
                               1.0, centre)
        picture.flat(display)
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                       None if column else "depth in figure B, 1 = deepest", [0.335, 0.13])
    for column, text in enumerate(('A and its skeleton', "B's field pulled to A", "B's own field",
                                   "B's skeleton (green), images of A's (red)")):
        picture.caption(text, (0.085, 0.325, 0.585, 0.74)[column], 0.93)
    picture.caption('RMSE at the skeleton %.2f %%, of the boundary %.2f %% (weight 20)' % (
        feature, boundary), 0.335, 0.03)
    picture.save(path, (1.65, -0.06), 1.75)


class Bear:
    """The model, its image on the sphere, and the ball's hexahedra inside it."""

    def __init__(self):
        import off
        self.Surface = off.read(scenes.model_file('bear.off'))
        self.Sphere = scenes.filter_of(
            'Parameterize', self.Surface, AreaWeight=3.0).GetOutputDataObject(1)
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
    picture = panels.Picture((1600, 700), [0.0, 0.0, 1.0], [0.0, 1.0, 0.0])
    middle = (0.0, 0.1, 0.0)
    for column, (data, name, scale, centre) in enumerate((
            (solid, 'BearDepth', 1.0, middle), (pulled, 'BearDepth', 0.8, (0.0, 0.0, 0.0)),
            (ball, 'BallDepth', 0.8, (0.0, 0.0, 0.0)), (pushed, 'BallDepth', 1.0, middle))):
        values = array(data, name)
        shift = (1.75 * column, 0.0)
        shown = with_array(data, values, 'Depth')
        half = cut(shown, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
        display = picture.show(half, shift, scale, centre)
        picture.flat(display)
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                       None if column else 'depth, 1 = deepest', [0.33, 0.1])
        back = crinkled(data, (0.0, 0.0, -0.03), (0.0, 0.0, 1.0))
        picture.show(back, shift, scale, centre, panels.STEEL)
    for x, text in zip((0.095, 0.305, 0.595, 0.79), (
            "the bear's field", "pulled onto the ball", "the ball's field",
            "pushed onto the bear")):
        picture.caption(text, x, 0.92)
    picture.caption(error_words(moved), 0.335, 0.025)
    picture.save(path, (2.62, -0.1), 3.0)


def fig5(path):
    torus = scenes.read('TwoTorus.vtp')
    slab = at(torus, array(torus, 'TargetPosition'))
    # Beside the points of the slab's flat faces nothing is thin.
    names = ('TorusDepth', 'SlabDepth')
    solids = [depth(tetrahedra(surface, volume=2e-3), surface, name)
              for surface, name in zip((torus, slab), names)]
    moved = scenes.volume_map(solids[0], torus, CollocationRatio=0.3, SourceRatio=0.5
                              ).GetOutputDataObject(0)
    say('two-torus: ' + error_words(moved))
    mapped = with_array(solids[0], points(moved), 'TargetPosition')
    pulled = transferred(mapped, solids[1], 'Pull')
    pushed = transferred(solids[1], mapped, 'Push')
    picture = panels.Picture((1400, 1000), [0.0, -0.55, 0.85], [0.0, 1.0, 0.0])
    for index, (data, name) in enumerate((
            (solids[1], 'SlabDepth'), (pulled, 'SlabDepth'),
            (solids[0], 'TorusDepth'), (pushed, 'TorusDepth'))):
        shift = (7.0 * (index % 2), -4.3 * (index // 2))
        shown = with_array(data, array(data, name), 'Depth')
        display = picture.show(cut(shown, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)), shift)
        picture.flat(display)
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0,
                       None if index else 'depth, 1 = deepest', [0.33, 0.06])
        picture.show(crinkled(data, (0.0, 0.0, -0.06), (0.0, 0.0, 1.0)), shift,
                     colour=panels.STEEL)
    for x, y, text in ((0.17, 0.94, "the polycube's field"), (0.65, 0.94, 'pulled onto the torus'),
                       (0.18, 0.53, "the torus's field"), (0.64, 0.53, 'pushed onto the polycube')):
        picture.caption(text, x, y)
    picture.caption(error_words(moved), 0.3, 0.02)
    picture.save(path, (3.5, -2.3), 9.6)


def fig7(path, bear):
    """The cube's hexahedra: its surface goes to the bear's by way of the sphere."""
    grid = scenes.read('Cube.vtu')
    triangles = vtkTriangleFilter()
    triangles.SetInputData(skin(grid))
    triangles.Update()
    cube = scenes.filter_of('Parameterize', triangles.GetOutput()).GetOutputDataObject(0)
    # The place on the bear whose image on the sphere is that of the cube's point.
    boundary = transferred(cube, bear.Sphere, 'Pull')
    solid = scenes.volume_map(grid, boundary, MapArray='SourcePosition', CollocationRatio=0.3,
                              SourceRatio=0.4).GetOutputDataObject(0)
    say('cube into bear: ' + error_words(solid))
    quality = vtkMeshQuality()
    quality.SetInputData(solid)
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    hexahedra = quality.GetOutput()
    jacobians = scenes.vtk_to_numpy(hexahedra.GetCellData().GetArray('Quality'))
    inverted = int((jacobians <= 0.0).sum())
    flips = scenes.filter_of('MapQuality', with_array(grid, points(solid), 'TargetPosition'))
    flipped = fact(flips.GetOutputDataObject(0), 'MapQuality.FlippedCells')
    words = '%d hexahedra, %d with a scaled Jacobian <= 0 (least %.2f, mean %.2f)' % (
        len(jacobians), inverted, jacobians.min(), jacobians.mean())
    say(words + '; Shape Map Quality: %d flipped' % flipped)
    assert (flipped > 0) == (inverted > 0)
    picture = panels.Picture((1600, 800), [0.3, 0.1, 1.0], [0.0, 1.0, 0.0])
    middle = (0.0, 0.1, 0.0)
    picture.show(bear.Surface, (0.0, 0.0), 1.0, middle, panels.SKIN,
                 representation='Surface With Edges', width=0.5)
    picture.show(skin(grid), (1.75, 0.0), 0.95, (0.0, 0.0, 0.0), panels.STEEL,
                 representation='Surface With Edges', width=1.0)
    for column, data in ((2, skin(hexahedra)),
                         (3, crinkled(hexahedra, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)))):
        display = picture.show(data, (1.75 * column, 0.0), 1.0, middle,
                               representation='Surface With Edges', width=1.0)
        picture.colour(display, 'CELLS', 'Quality', 0.0, 1.0,
                       'scaled Jacobian (red: inverted)' if column == 2 else None, [0.33, 0.1],
                       'Viridis (matplotlib)', 10)
        table = simple.GetColorTransferFunction('Quality')
        table.UseBelowRangeColor, table.BelowRangeColor = 1, panels.RED
    for x, text in zip((0.1, 0.33, 0.565, 0.8), (
            'the bear', "the cube's grid", 'remeshed', 'cross-section')):
        picture.caption(text, x, 0.92)
    picture.caption(words + '; ' + error_words(solid), 0.16, 0.025, 15)
    picture.save(path, (2.62, -0.1), 2.8)


def main(folder, *numbers):
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
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
