"""A picture of exponential maps: one neighbour's word, the mean of several, and smoothed normals."""
import os

import numpy
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.util.numpy_support import numpy_to_vtk

import composition_common as common
import panels
import scenes

from composition_rows import Row
from scenes import copy, fact, points
from shapetesting import triangles

KINDS = (('one neighbour', dict(UpwindAverage=False, NormalSmoothing=0)),
         ('mean of several', dict(UpwindAverage=True, NormalSmoothing=0)),
         ('and normals smoothed', dict(UpwindAverage=True, NormalSmoothing=4)))


def irregular(surface, amount, random):
    """Its points moved along the surface by up to `amount` of the mean edge."""
    places, faces = points(surface), triangles(surface)
    edge = numpy.linalg.norm(places[faces[:, 0]] - places[faces[:, 1]], axis=1).mean()
    normals = scenes.array(common.with_normals(surface), 'Normals').astype(float)
    moves = random.uniform(-1.0, 1.0, places.shape) * amount * edge
    return common.at(surface, places + moves - (moves * normals).sum(axis=1)[:, None] * normals)


def checkers(path, count=12, pixels=960):
    """A picture of squares, coloured so that every place is another one."""
    rows, columns = numpy.mgrid[0:pixels, 0:pixels] * count // pixels
    dark = (rows + columns) % 2 == 0
    colours = numpy.empty((pixels, pixels, 3), numpy.uint8)
    colours[..., 0] = numpy.where(dark, 70 + 10 * columns, 245)
    colours[..., 1] = numpy.where(dark, 105, 243)
    colours[..., 2] = numpy.where(dark, 190 - 10 * rows, 238)
    image = vtkImageData()
    image.SetDimensions(pixels, pixels, 1)
    values = numpy_to_vtk(colours.reshape(-1, 3), deep=True)
    image.GetPointData().SetScalars(values)
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
    return path


def patch(surface, seed, radius, **options):
    algorithm = scenes.shapemap.vtkShapeExponentialMap()
    algorithm.SetInputDataObject(0, surface)
    algorithm.SetSeed(*seed)
    algorithm.SetRadius(radius)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    return copy(scenes.checked(algorithm).GetOutputDataObject(0))


def rates(surface, seeds, radius, options):
    """The flip rates of patches around many seeds, in percent."""
    algorithm = scenes.shapemap.vtkShapeExponentialMap()
    algorithm.SetInputDataObject(0, surface)
    algorithm.SetRadius(radius)
    for option, value in options.items():
        getattr(algorithm, 'Set' + option)(value)
    found = []
    for seed in seeds:
        algorithm.SetSeed(*seed)
        found.append(100.0 * fact(scenes.checked(algorithm).GetOutputDataObject(0),
                                  'ExponentialMap.FlipRate'))
    return numpy.array(found)


def show_patch(row, panel, surface, laid, texture, view):
    """The patch with its texture, and red where it is flipped, on the surface."""
    row.show(panel, surface, *view, panels.STEEL, smooth=60.0)
    # A little in front of the surface, which it is a part of.
    front = copy(common.with_normals(laid))
    normals = scenes.array(front, 'Normals').astype(float)
    front = common.at(laid, points(laid) + 0.002 * view[1] * normals)
    front.GetPointData().SetActiveTCoords('ExponentialMap')
    row.show(panel, front, *view, [1.0, 1.0, 1.0]).Texture = texture
    flipped = scenes.vtk_to_numpy(laid.GetCellData().GetArray('Flipped'))
    if flipped.any():
        wrong = scenes.off.surface(points(front) + 0.002 * view[1] * normals,
                                   triangles(laid)[flipped == 1].tolist())
        row.Picture.flat(row.show(panel, wrong, *view, panels.RED))


def fig11(folder, claims):
    random = numpy.random.RandomState(11)
    texture = simple.CreateTexture(checkers(os.path.join(folder, 'checkers.png')))
    row = Row(4, 2, height=0.9)
    cases = (('bunny, points off by 0.2 edges', irregular(common.model('bunny00'), 0.2, random),
              [0.1, -0.08, 0.3], ([0.0, 0.02, 0.0], 1.2, [0.25, 0.12, 1.0], [0.0, 1.0, 0.0])),
             ('dragon', common.model('ChineseDragon-10kv'), [-12.0, 20.0, -940.0],
              ([-3.5, 3.5, -966.0], 132.0, [-0.35, 0.15, 1.0], [0.0, 1.0, 0.0])))
    for line, (name, surface, seed, view) in enumerate(cases):
        radius = 0.2 * common.diagonal(surface)
        seeds = points(surface)[::surface.GetNumberOfPoints() // 40]
        every = {kind: rates(surface, seeds, radius, options) for kind, options in KINDS}
        mean = {kind: values.mean() for kind, values in every.items()}
        row.show(4 * line, surface, *view, panels.STEEL)
        row.caption(4 * line, name, 14)
        for panel, (kind, options) in enumerate(KINDS):
            laid = patch(surface, seed, radius, **options)
            show_patch(row, 4 * line + 1 + panel, surface, laid, texture, view)
            here = 100.0 * fact(laid, 'ExponentialMap.FlipRate')
            row.caption(4 * line + 1 + panel, '%s: %.2f %% flipped here,\n%.2f %% in the mean of %d seeds' % (
                kind, here, mean[kind], len(seeds)), 14)
            claims.note(11, '%s, %s: flipped here, mean of %d seeds' % (name, kind, len(seeds)),
                        '%.2f %%, %.2f %%' % (here, mean[kind]))
        one, several, smoothed = mean.values()
        claims.check(11, name + ': mean of several against one', '%.2f times' % (several / one),
                     several < 0.6 * one, '< 0.6')
        claims.check(11, name + ': smoothed against the mean of several',
                     '%.2f times' % (smoothed / several), smoothed < several, '< 1')
    row.footnote('patches of a radius of a fifth of the diagonal; red: flipped triangles')
    row.save(folder, 11)
