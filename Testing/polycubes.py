"""Polycubes drawn by hand, as Data/ has them: unit cubes, whose TargetPosition is where they lie around a solid."""
import numpy
import shapemap
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkIdFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

import shapetesting
from shapetesting import array, fact, points

CORNERS = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
# Of each polycube: loops along edges of its unit cubes, by their corners, which go onto curves.
LOOPS = {
    'Kitten': [[(1, 2, 2), (2, 2, 2), (2, 2, 3), (1, 2, 3)],  # tail, ears
               [(0, 3, 5), (1, 3, 5), (1, 4, 5), (0, 4, 5)], [(2, 3, 5), (3, 3, 5), (3, 4, 5), (2, 4, 5)]],
    'Horse': [[(0, 4, 2), (3, 4, 2), (3, 4, 4), (0, 4, 4)],  # girth, tail
              [(1, 2, 3), (2, 2, 3), (2, 2, 4), (1, 2, 4)]],
    'Skull': [[(x, 3, 2), (x, 3, 3), (x + 1, 3, 3), (x + 1, 3, 2)] for x in (1, 3)]}  # eye sockets


def ids(cells):
    return vtk_to_numpy(cells.GetConnectivityArray())


def solid(places, hexahedra, drawn):
    """Hexahedra as a vtkUnstructuredGrid with the point array TargetPosition."""
    grid, cells = vtkUnstructuredGrid(), vtkCellArray()
    grid.SetPoints(vtkPoints())
    shapetesting.set_points(grid, places)
    cells.SetData(numpy_to_vtkIdTypeArray(8 * numpy.arange(len(hexahedra) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(hexahedra.astype(numpy.int64).reshape(-1), deep=True))
    grid.SetCells(VTK_HEXAHEDRON, cells)
    shapetesting.add_array(grid, drawn, 'TargetPosition')
    return grid


def divided(unit_cubes, cells):
    """Unit cubes cut in `cells` along each axis, with TargetPosition linear along each edge."""
    corners = ids(unit_cubes.GetCells()).reshape(-1, 8)
    lattice = numpy.stack(numpy.indices([cells + 1] * 3), axis=-1).reshape(-1, 3)
    shares = numpy.where(CORNERS, lattice[:, None] / cells, 1.0 - lattice[:, None] / cells).prod(axis=2)
    low = lattice[(lattice < cells).all(axis=1)]
    inside = numpy.ravel_multi_index((low[:, None] + CORNERS).transpose(2, 0, 1), [cells + 1] * 3)
    places, drawn = (numpy.einsum('ls,csk->clk', shares, values[corners]).reshape(-1, 3)
                     for values in (points(unit_cubes), array(unit_cubes, 'TargetPosition')))
    _, first, inverse = numpy.unique(numpy.rint(cells * places).astype(int), axis=0, return_index=True,
                                     return_inverse=True)
    return solid(places[first], inverse.reshape(len(corners), -1)[:, inside].reshape(-1, 8), drawn[first])


def boundary_quads(grid):
    """The quads of a grid's boundary, facing outwards, by its points."""
    numbered, skin = vtkIdFilter(), vtkDataSetSurfaceFilter()
    numbered.SetInputData(grid)
    numbered.SetPointIdsArrayName('Index')
    numbered.CellIdsOff()
    skin.SetInputConnection(numbered.GetOutputPort())
    skin.Update()
    return array(skin.GetOutput(), 'Index').astype(int)[ids(skin.GetOutput().GetPolys()).reshape(-1, 4)]


def outwards(grid):
    """Of each quad of the boundary its points, and of each point of the grid the least and the largest component of
    the normals of the quads around it."""
    quads = boundary_quads(grid)
    corners = points(grid)[quads]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0])
    normals = numpy.rint(normals / numpy.linalg.norm(normals, axis=1, keepdims=True))
    least, most = numpy.zeros((2, grid.GetNumberOfPoints(), 3))
    for k in range(4):
        numpy.minimum.at(least, quads[:, k], normals)
        numpy.maximum.at(most, quads[:, k], normals)
    return quads, least, most


def corners_of(grid):
    """The indices of a polycube's corners: points of faces across all three axes."""
    _, least, most = outwards(grid)
    return numpy.flatnonzero(((least < 0) | (most > 0)).all(axis=1))


def padded(grid, cells, share=0.3):
    """The grid with a layer of hexahedra along its boundary, of this share of a cell, for which the others make room.
    No hexahedron then has two sides on the boundary, which is smooth where the polycube has an edge."""
    quads, least, most = outwards(grid)
    if (least * most).any():
        raise ValueError('the polycube has faces on both sides of a point')
    places, drawn = points(grid), array(grid, 'TargetPosition')
    on_boundary, outer = numpy.unique(quads, return_inverse=True)
    layer = numpy.concatenate([quads, len(places) + outer.reshape(-1, 4)], axis=1)
    return solid(numpy.concatenate([places - share / cells * (least + most), places[on_boundary]]),
                 numpy.concatenate([ids(grid.GetCells()).reshape(-1, 8), layer]),
                 numpy.concatenate([drawn, drawn[on_boundary]]))


def landmarks(grid, loops):
    """The corners as vertices, and closed curves along the loops, with the places where they are drawn."""
    places = points(grid)
    chosen = list(corners_of(grid))
    vertices, lines = vtkCellArray(), vtkCellArray()
    for i in range(len(chosen)):
        vertices.InsertNextCell(1, [i])
    for loop in loops:
        curve = []
        for a, b in zip(numpy.array(loop), numpy.array(loop[1:] + loop[:1])):
            along = (places - a) @ (b - a) / ((b - a) @ (b - a))
            on_edge = numpy.flatnonzero((numpy.abs(places - a - along[:, None] * (b - a)).max(axis=1) < 1e-9)
                                        & (along > -1e-9) & (along < 1 - 1e-9))
            curve += list(on_edge[numpy.argsort(along[on_edge])])
        chosen += [index for index in curve if index not in chosen]
        lines.InsertNextCell(len(curve) + 1, [chosen.index(index) for index in curve + curve[:1]])
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    shapetesting.set_points(data, places[chosen])
    data.SetVerts(vertices)
    data.SetLines(lines)
    shapetesting.add_array(data, array(grid, 'TargetPosition')[chosen], 'TargetPosition')
    return data


def nearest(places, wanted):
    """The index of the place nearest to each wanted one."""
    return numpy.array([((places - x) ** 2).sum(axis=1).argmin() for x in wanted])


def cell_points(data, cell):
    """The points of a cell."""
    found = data.GetCell(int(cell)).GetPointIds()
    return [found.GetId(k) for k in range(found.GetNumberOfIds())]


def distances(places, curves):
    """Of each place from the nearest of the curves, which are lists of places."""
    a, b = (numpy.concatenate(ends) for ends in zip(*((curve[:-1], curve[1:]) for curve in curves)))
    lengths = numpy.maximum(((b - a) ** 2).sum(axis=1), 1e-300)
    share = numpy.clip(((places[:, None] - a) * (b - a)).sum(axis=2) / lengths, 0.0, 1.0)
    return numpy.linalg.norm(places[:, None] - a - share[..., None] * (b - a), axis=2).min(axis=1)


class Drawn:
    """A polycube drawn around a surface, and the map of its boundary onto the surface, by Shape Correspondence."""

    def __init__(self, surface, unit_cubes, cells, loops=()):
        self.Surface, self.Grid, self.Cells = surface, divided(unit_cubes, cells), cells
        self.Landmarks = landmarks(self.Grid, loops)
        match = shapemap.vtkShapeCorrespondence()
        match.SetMethod(9)  # CommonBase
        for port, data in enumerate((self.Grid, surface, self.Landmarks)):
            match.SetInputDataObject(port, data)
        messages = shapetesting.run(match)
        if messages:
            raise RuntimeError(' '.join(messages))
        self.Boundary, self.Back, self.Paths = (match.GetOutputDataObject(port) for port in (0, 1, 5))

    def corner_images(self):
        corners = points(self.Grid)[corners_of(self.Grid)]
        return array(self.Boundary, 'TargetPosition')[nearest(points(self.Boundary), corners)]

    def beside(self, places):
        """The points of the surface that are next to places."""
        return points(self.Surface)[nearest(points(self.Surface), places)]

    def corner_errors(self):
        """The largest distance of a corner's image from a point of the surface, and from that next to where the corner
        is drawn."""
        images, drawn = self.corner_images(), array(self.Grid, 'TargetPosition')[corners_of(self.Grid)]
        return [numpy.linalg.norm(images - self.beside(places), axis=1).max() for places in (images, drawn)]

    def curve_errors(self):
        """Of each curve, the largest distance of a point's image from the curve's partner, which is what BaseDomain has
        along the curve, and of the partner from a point of the surface next to where the curve is drawn."""
        places, targets = points(self.Paths), array(self.Paths, 'TargetPosition')
        paths = [cell_points(self.Paths, i)
                 for i in numpy.flatnonzero(vtk_to_numpy(self.Paths.GetCellData().GetArray('IsCurve')))]
        errors = []
        for loop in [cell_points(self.Landmarks, i) for i in range(self.Landmarks.GetNumberOfCells())
                     if self.Landmarks.GetCell(i).GetCellDimension() == 1]:
            curve, drawn = points(self.Landmarks)[loop], array(self.Landmarks, 'TargetPosition')[loop]
            partner = [targets[path] for path in paths if distances(places[path], [curve]).max() < 1e-9]
            assert partner, 'the base domain has nothing along a curve'
            images = array(self.Boundary, 'TargetPosition')[nearest(points(self.Boundary), curve)]
            errors.append([distances(each, partner).max() for each in (images, self.beside(drawn))])
        return numpy.transpose(errors)

    def turned(self):
        """Of the triangles of the surface whose images lie in a quarter of one quad, where the map is linear whichever
        diagonal cuts the quad: how many images are turned over, seen from outside, and how many are not. At a corner,
        a triangle may lead around it by the other faces."""
        places = array(self.Back, 'TargetPosition')
        free = numpy.ones(len(places), bool)
        free[nearest(places, points(self.Grid)[corners_of(self.Grid)])] = False
        faces = shapetesting.triangles(self.Back)
        images = places[faces[free[faces].all(axis=1)]]
        counts = numpy.zeros(2, int)
        for quad in points(self.Grid)[boundary_quads(self.Grid)]:
            outward = numpy.cross(quad[1] - quad[0], quad[3] - quad[0])
            near = images[((images > quad.min(axis=0) - 1e-9) & (images < quad.max(axis=0) + 1e-9)).all(axis=(1, 2))]
            areas = numpy.cross(near[:, 1] - near[:, 0], near[:, 2] - near[:, 0]) @ outward
            arms = quad - quad.mean(axis=0)
            for one, other in zip(arms, numpy.roll(arms, -1, axis=0)):
                inside = ((near - quad.mean(axis=0)) @ numpy.stack([one, other], axis=1) > -1e-9).all(axis=(1, 2))
                counts += (areas[inside] < 0.0).sum(), (areas[inside] > 0.0).sum()
        return counts

    def check(self, genus):
        """No triangle is flipped; each corner goes onto a point of its own and each curve onto its partner, which are
        within an edge from the points of the surface next to where they are drawn."""
        about = [fact(self.Boundary, 'Correspondence.' + name) for name in ('FlippedTriangles', 'GenusOfA', 'GenusOfB')]
        assert about == [0, genus, genus], about
        turned, others = self.turned()
        assert turned == 0 < others, (turned, others)
        assert len(numpy.unique(self.corner_images(), axis=0)) == len(corners_of(self.Grid)), 'two corners at one point'
        corners = points(self.Surface)[shapetesting.triangles(self.Surface)]
        edge = numpy.linalg.norm(corners - numpy.roll(corners, 1, axis=1), axis=2).max()
        for off, away in (self.corner_errors(), self.curve_errors()):
            assert numpy.max(off) < 1e-9 and numpy.max(away) < edge, (off, away, edge)
