"""The boundary maps of the paper's seven solids (its Table 2), on models at hand: each is made by our own
filters from surfaces alone, and kept as a file in a folder.

Shape Polycube finds a polycube of the two-torus. Of the other three solids that the paper maps from polycubes it
finds none (its message names the charts), so theirs is the grid of Shape Hex Remesh, whose faces are those of
cubes, too: a polycube with more steps, with the map onto the boundary of the hexahedra.
"""
import os

import numpy

import scenes
from scenes import array, off, points, read, say, write
from shapetesting import triangles

POLYCUBE, GRID = 1, 2  # of Shape Hex Remesh's Method
# Of each counterpart: the paper's solid; what it is here; CR, SR.
COUNTERPARTS = {
    'DentedSphere': ('Omotondo/Sphere, 3k', 'the dented sphere onto the sphere', 0.4, 0.8),
    'TwoTorusCube': ('PCube/2-Torus, 6.6k', "the two-torus's polycube", 0.4, 0.8),
    'Figures': ('Male/Female, 6.3k', 'two figures, with their skeletons', 0.2, 2.0),
    'SkullCube': ('PCube/Skull, 29k', "the phantom's skull, genus 2", 0.03, 0.03),
    'Bunny': ('Vaselion/Sphere, 40k', 'the bunny onto the sphere', 0.1, 0.2),
    'ElkCube': ('PCube/Kitten, 80k', 'the elk, genus 1', 0.05, 0.05),
    'BullCube': ('PCube/Horse, 100k', 'the bull', 0.01, 0.02)}
# Of those from polycubes: the surface, the cells of the grid on the longest side, and how often the edges of the
# polycube's surface are halved, for about the paper's number of points.
CUBES = {'TwoTorusCube': ('TwoTorus', 31, 0), 'SkullCube': ('PhantomSkull', 24, 2), 'ElkCube': ('elk', 24, 2),
         'BullCube': ('bull', 32, 3)}


def plain(surface):
    """Without its arrays, so that no known map is used."""
    return off.surface(points(surface), triangles(surface).tolist())


def mapped(surface, positions):
    """The surface with nothing but a map."""
    return scenes.with_array(plain(surface), positions, 'TargetPosition')


def refined(surface, times):
    """The surface and its map with all edges halved, so often: the same shape, and the same map, linear in the
    old triangles."""
    for _ in range(times):
        corners = triangles(surface)
        ends, inverse = numpy.unique(numpy.sort(numpy.concatenate(
            [corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1), axis=0, return_inverse=True)
        a, b, c = inverse.reshape(3, -1) + surface.GetNumberOfPoints()
        x, y, z = corners.T
        cells = numpy.concatenate([numpy.stack(part, axis=1) for part in (
            (x, a, c), (a, y, b), (c, b, z), (a, b, c))])
        position, image = (numpy.concatenate([values, 0.5 * (values[ends[:, 0]] + values[ends[:, 1]])])
                           for values in (points(surface), array(surface, 'TargetPosition')))
        surface = mapped(off.surface(position, cells.tolist()), image)
    return surface


def solid_of(name):
    """The surface of the solid that a polycube is of."""
    model = CUBES[name][0]
    if os.path.exists(scenes.model_file(model + '.off')):
        return scenes.model(model)
    return plain(read(model + '.vtp'))


def make_cube(name):
    """The surface of a solid's polycube with the map onto the solid, as the paper maps them, and the hexahedra of
    the polycube with those that they become: the outputs of Shape Hex Remesh."""
    surface, cells = solid_of(name), CUBES[name][1]
    if name != 'TwoTorusCube':
        remesh = scenes.filter_of('HexRemesh', surface, Method=GRID, CellsOnLongestSide=cells)
        grid = remesh.GetOutputDataObject(2)
        skin = scenes.triangulated(scenes.skin(grid))
        return mapped(skin, array(skin, 'TargetPosition')), grid, remesh.GetOutputDataObject(0)
    polycube = scenes.filter_of('Polycube', surface)
    cube = polycube.GetOutputDataObject(1)
    remesh = scenes.filter_of('HexRemesh', surface, cube, Method=POLYCUBE, CellsOnLongestSide=cells)
    return (mapped(cube, array(cube, 'SourcePosition')), remesh.GetOutputDataObject(2),
            remesh.GetOutputDataObject(0))


def cube_files(name, folder):
    """The files of make_cube's results, made once."""
    paths = [os.path.join(folder, name + part) for part in ('Skin.vtp', 'Grid.vtu', 'Hexahedra.vtu')]
    if not all(map(os.path.exists, paths)):
        for data, path in zip(make_cube(name), paths):
            write(data, path)
        say('%s: polycube' % name)
    return paths


def figures():
    """Two figures, mapped onto each other from their surfaces alone: the ends of their matched skeletons are the
    landmarks. Returns figure A with the map, and its skeleton with the map onto B's."""
    first, second = (plain(read('Figure%s.vtp' % name)) for name in 'AB')
    # A figure is symmetric, so its matching is named as ambiguous: the best one is taken.
    bones = scenes.output_of('Skeleton', first, second, Ambiguous=1)
    ends = array(bones, 'Degree') == 1
    landmarks = scenes.with_array(
        scenes.point_set(points(bones)[ends]), array(bones, 'TargetPosition')[ends], 'TargetPosition')
    return scenes.output_of('Correspondence', first, second, landmarks), bones


def counterpart(name, folder):
    """The file of a counterpart's boundary with its map, and that of features or None; made once."""
    path, features = os.path.join(folder, name + '.vtp'), os.path.join(folder, name + 'Skeleton.vtp')
    if not os.path.exists(path):
        if name == 'DentedSphere':
            boundary = scenes.output_of('Parameterize', plain(read('DentedSphere3k.vtp')))
        elif name == 'Bunny':
            boundary = scenes.sphere_map(scenes.model('bunny00')).GetOutputDataObject(0)
        elif name == 'Figures':
            boundary, bones = figures()
            write(bones, features)
        else:
            boundary = refined(read(cube_files(name, folder)[0]), CUBES[name][2])
        write(boundary, path)
        say('%s: %d points' % (name, boundary.GetNumberOfPoints()))
    return path, features if name == 'Figures' else None
