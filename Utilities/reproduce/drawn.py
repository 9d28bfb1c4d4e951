"""Maps onto polycubes drawn by hand, after Figs. 5 and 8 of "Feature-aligned harmonic volumetric mapping using MFS"
(Li, Xu, Wan, Yin and Yu 2010): pvpython drawn.py FOLDER [NAME...], of Kitten and Horse; Skull, whose boundary is
mapped as well, is left out, because Shape Hex Remesh leaves 2 of its hexahedra inverted and says so.

The solids are made by a script, as are their polycubes: a few boxes of unit cubes, and where they are drawn around
the solid. The corners are the landmarks, and some loops of edges the curves, of the map of the boundary. That map
determines the map of the inside. It writes drawn.png and drawn.md, and claims what must hold.
"""
import os
import sys

import numpy
from paraview import simple

import panels
import scenes  # knows where polycubes.py is
from claims import Claims
from figures import depth, framed, half, mark_inverted, show_hexahedra, transferred
from scenes import array, fact, points, say, skin, with_array

import polycubes

SURFACES = {'Kitten': 'KittenSmall.vtp', 'Horse': 'HorseSmall.vtp', 'Skull': 'PhantomSkullSmall.vtp'}
CELLS = 4  # of a unit cube, along each axis
FINITE_ELEMENTS, POLYCUBE = 3, 1  # of the filters' Method
STEP = 1.08  # from column to column of the picture


class Mapped:
    """A solid, its polycube, and the maps between them."""

    def __init__(self, name):
        self.Name = name
        surface = scenes.read(SURFACES[name])
        surface.GetPointData().Initialize()  # no known map is used
        self.Drawn = polycubes.Drawn(surface, scenes.read(name + 'Polycube.vtu'), CELLS, polycubes.LOOPS[name])
        say('%s: boundary mapped' % name)
        remesh = scenes.filter_of('HexRemesh', surface, self.Drawn.Boundary, Method=POLYCUBE)
        self.Hexahedra, self.Cube = (remesh.GetOutputDataObject(port) for port in (0, 2))
        say('%s: %d hexahedra' % (name, self.Hexahedra.GetNumberOfCells()))

    def moved(self, grid):
        """The hexahedra of a grid in the polycube where the map of the inside takes them."""
        grid.GetPointData().RemoveArray('TargetPosition')
        return scenes.volume_map(grid, self.Drawn.Boundary, Method=FINITE_ELEMENTS).GetOutputDataObject(0)

    def claim(self, claims):
        boundary, name = self.Drawn.Boundary, self.Name
        flipped, energy, back = (fact(boundary, 'Correspondence.' + key) for key in (
            'FlippedTriangles', 'SymmetricDirichlet', 'SymmetricDirichletBack'))
        claims.at_most(name, 'flipped triangles, both ways', flipped, 0)
        claims.at_most(name, "largest distance of a corner's image from a point of the solid's surface",
                       self.Drawn.corner_error(), 1e-9)
        claims.at_most(name, 'largest distance of a curve from its partner', self.Drawn.curve_error(), 1e-9)
        claims.note(name, 'symmetric Dirichlet energy, there and back; 4 is an isometry', '%.2f, %.2f' % (energy, back))
        for what, grid in (('the grid', self.Drawn.Grid), ('the grid with a layer', polycubes.padded(
                self.Drawn.Grid, CELLS))):
            quality = jacobians(self.moved(scenes.copy(grid)))
            claims.want(name, 'hexahedra of %s, by the harmonic map, with a scaled Jacobian of 0 or less' % what,
                        '%d of %d' % ((quality <= 0.0).sum(), len(quality)), (quality > 0.0).all(), 'none')
        quality = jacobians(self.Hexahedra)
        claims.check(name, 'least and mean scaled Jacobian of %d hexahedra of Shape Hex Remesh' % len(quality),
                     '%.3f, %.3f' % (quality.min(), quality.mean()), quality.min() > 0.0, 'above 0')
        claims.note(name, 'distance of their boundary from the surface',
                    '%.2f %%' % (100.0 * fact(self.Hexahedra, 'HexRemesh.Distance') / scenes.longest_side(
                        points(self.Drawn.Surface))))

    def fields(self):
        """The solid's depth pulled onto the polycube, and the polycube's pushed onto the solid; sets what the latter,
        pulled back, is off at the nodes of the polycube's grid."""
        solid = depth(self.Hexahedra, self.Drawn.Surface, 'SolidDepth')
        cube = depth(self.Cube, scenes.triangulated(skin(self.Cube)), 'CubeDepth')
        moved = scenes.output_of('TransferFields', self.Hexahedra, cube, MapArray='SourcePosition')
        back = transferred(self.Cube, moved, 'Pull')
        self.RoundTrip = numpy.abs(array(back, 'CubeDepth') - array(cube, 'CubeDepth')).max()
        return transferred(self.Cube, solid, 'Pull'), moved


def jacobians(solid):
    return scenes.vtk_to_numpy(scenes.scaled_jacobians(solid).GetCellData().GetArray('Quality'))


def draw(picture, row, mapped):
    """A row: polycube and solid, hexahedra whole and cut, and fields carried both ways."""
    pulled, pushed = mapped.fields()
    quality = scenes.scaled_jacobians(mapped.Hexahedra)
    whole, middle, _ = framed(mapped.Hexahedra)
    scale, centre, _ = framed(mapped.Drawn.Grid)
    side = (1.0, 0.0, 0.0)
    down = -1.25 * row
    show_hexahedra(picture, skin(mapped.Drawn.Grid), (0.0, down), scale, centre)
    picture.show(mapped.Drawn.Surface, (STEP, down), whole, middle, panels.SKIN, smooth=60.0)
    for column, data in ((2, quality), (3, scenes.behind(quality, middle, side))):
        display = show_hexahedra(picture, skin(data), (STEP * column, down), whole, middle)
        picture.colour(display, 'CELLS', 'Quality', 0.0, 1.0, None if row or column > 2 else
                       'scaled Jacobian (red: inverted)', [0.12, 0.01], 'Viridis (matplotlib)', 10)
        mark_inverted()
    for column, data, name, size, place in ((4, pulled, 'SolidDepth', None, None),
                                            (5, pushed, 'CubeDepth', whole, middle)):
        size, place = (size, place) if size else framed(mapped.Cube)[:2]
        shown = half(with_array(data, array(data, name), 'Depth'), place, side)
        display = picture.show(shown, (STEP * column, down), size, place)
        display.Ambient, display.Diffuse = 0.5, 0.55
        picture.colour(display, 'POINTS', 'Depth', 0.0, 1.0, None if row or column > 4 else 'depth, 1 = deepest',
                       [0.6, 0.01])
    scaled = jacobians(mapped.Hexahedra)
    values = len(scaled), scaled.min(), scaled.mean()
    corners = len(polycubes.corners_of(mapped.Drawn.Grid))
    picture.caption('%s: %d corners, %d curves, 0 flipped; %d hexahedra, least scaled Jacobian %.2f, mean %.2f' % (
        mapped.Name.lower(), corners, len(polycubes.LOOPS[mapped.Name]), *values), 2.5 * STEP, down - 0.66)


def main(folder, *names):
    os.makedirs(folder, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    names = names or ('Kitten', 'Horse')
    claims = Claims()
    picture = panels.Picture((1900, 170 + 340 * len(names)), [0.9, 0.55, 0.35], [0.0, 0.0, 1.0])
    for row, name in enumerate(names):
        mapped = Mapped(name)
        mapped.claim(claims)
        draw(picture, row, mapped)
        claims.at_most(name, "the polycube's depth, pushed onto the solid and pulled back, off at the nodes",
                       mapped.RoundTrip, 1e-9)
    for column, text in enumerate(('the polycube', 'the solid', 'remeshed', 'cross-section', "the solid's field",
                                   "the polycube's field")):
        picture.caption(text, STEP * column, 0.6)
    picture.save(os.path.join(folder, 'drawn.png'), (2.5 * STEP, -0.625 * (len(names) - 1) - 0.2),
                 0.6 + 1.25 * len(names))
    claims.write(os.path.join(folder, 'drawn.md'))
    claims.finish()


if __name__ == '__main__':
    main(*sys.argv[1:])
