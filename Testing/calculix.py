"""Finite elements for the tests: a mesh goes through Shape Abaqus Writer into CalculiX (ccx), and its
displacements come back."""
import os
import re
import subprocess
import tempfile

import numpy
import shapemap

import shapetesting

# The corners of the faces S1 to S6 of elements with eight nodes.
FACES = numpy.array([[0, 1, 2, 3], [4, 7, 6, 5], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3],
                     [3, 7, 4, 0]])


def bent_bar():
    """Points (n x 3) of a bar with curved sides, its hexahedra (m x 8), and the materials 0 and 1 of its halves (m)."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    bar = block((6, 3, 2), (3.0, 1.5, 1.0))
    corners = vtk_to_numpy(bar.GetCells().GetConnectivityArray()).reshape(-1, 8)
    straight = shapetesting.points(bar)
    materials = (straight[corners].mean(axis=1)[:, 0] > 1.5).astype(int)
    return straight + 0.05 * numpy.sin(7.0 * straight[:, [1, 2, 0]]), corners, materials


def hexahedra(places, cells, regions=None):
    """A grid of hexahedra: points (n x 3) and corners (m x 8)."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkUnstructuredGrid
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    shapetesting.set_points(grid, numpy.asarray(places, float))
    array = vtkCellArray()
    array.SetData(8, numpy_to_vtkIdTypeArray(
        numpy.ascontiguousarray(cells, numpy.int64).ravel(), deep=True))
    grid.SetCells(VTK_HEXAHEDRON, array)
    if regions is not None:
        values = numpy_to_vtk(numpy.ascontiguousarray(regions, numpy.int32), deep=True)
        values.SetName('RegionId')
        grid.GetCellData().AddArray(values)
    return grid


def block(counts, lengths):
    """A block of counts cells with its low corner at the origin."""
    n = numpy.array(counts) + 1
    axes = [numpy.linspace(0.0, length, k) for length, k in zip(lengths, n)]
    places = numpy.stack(numpy.meshgrid(*axes, indexing='ij'), axis=-1).reshape(-1, 3)
    index = numpy.arange(n.prod()).reshape(n)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = [index[tuple(slice(a, a + m) for a, m in zip(corner, counts))].ravel()
             for corner in corners]
    return hexahedra(places, numpy.stack(cells, axis=1))


class Model:
    """A grid as Shape Abaqus Writer writes it, in a folder of its own: what is in the file's blocks,
    and what CalculiX makes of it. Ids count from 0."""

    def __init__(self, grid, **properties):
        self.folder = tempfile.TemporaryDirectory(prefix='shapemap-calculix-')
        writer = shapemap.vtkShapeAbaqusWriter()
        writer.SetInputData(grid)
        writer.SetFileName(os.path.join(self.folder.name, 'mesh.inp'))
        for name, value in properties.items():
            getattr(writer, 'Set' + name)(value)
        assert writer.Write(), 'the mesh was not written'
        self.blocks = {}
        with open(writer.GetFileName()) as file:
            for line in file:
                if line.startswith('*'):
                    lines = self.blocks.setdefault(line.strip(), [])
                else:
                    lines.append(line.strip().split(', '))
        self.points = numpy.array([line[1:] for line in self.blocks['*NODE']], float)

    def node_set(self, name):
        return numpy.concatenate(self.blocks['*NSET, NSET=' + name]).astype(int) - 1

    def elements(self):
        """{element: nodes} of the hexahedra."""
        return {int(line[0]) - 1: numpy.array(line[1:], int) - 1
                for key, lines in self.blocks.items() if 'ELSET=Hexahedra' in key for line in lines}

    def patch_at(self, axis, place, tolerance=1e-9):
        """The number of the boundary's patch that lies in a plane across an axis."""
        patches = [key.rpartition('=Patch')[2] for key in self.blocks if '*NSET, NSET=Patch' in key]
        found = [patch for patch in patches if (abs(
            self.points[self.node_set('Patch' + patch), axis] - place) <= tolerance).all()]
        assert len(found) == 1, 'patches %s lie at %g of axis %d' % (found, place, axis)
        return found[0]

    def shares(self, patch):
        """{node: area}: what of a patch of quadrilaterals each node carries, for even loads."""
        elements, areas = self.elements(), {}
        for element, face in self.blocks['*SURFACE, NAME=PatchSurface%s, TYPE=ELEMENT' % patch]:
            nodes = elements[int(element) - 1][FACES[int(face[1:]) - 1]]
            corners = self.points[nodes]
            for s in (-1.0, 1.0):
                for t in (-1.0, 1.0):
                    u, v = s / 3.0 ** 0.5, t / 3.0 ** 0.5
                    shape = 0.25 * numpy.array([(1 - u) * (1 - v), (1 + u) * (1 - v),
                                                (1 + u) * (1 + v), (1 - u) * (1 + v)])
                    along = 0.25 * numpy.array([v - 1, 1 - v, 1 + v, -1 - v]) @ corners
                    across = 0.25 * numpy.array([u - 1, -1 - u, 1 + u, 1 - u]) @ corners
                    area = numpy.linalg.norm(numpy.cross(along, across))
                    for node, share in zip(nodes, shape * area):
                        areas[node] = areas.get(node, 0.0) + share
        return areas

    def solve(self, young, poisson, boundary, loads=()):
        """Displacements (n x 3), to CalculiX's seven digits. young: one for all regions, {region:
        young}, or None if the mesh has materials. boundary: data lines of *BOUNDARY; loads: lines of the step."""
        return self.analyse(young, poisson, boundary, loads).Displacements

    def analyse(self, young, poisson, boundary, loads=()):
        """solve(), with all that CalculiX says: a Solution."""
        regions = [key.rpartition('=Region')[2] for key in self.blocks if '=Region' in key]
        deck = ['*INCLUDE, INPUT=mesh.inp', '*NSET, NSET=All, GENERATE', '1, %d' % len(self.points)]
        for region in regions if young is not None else []:
            stiffness = young[int(region)] if isinstance(young, dict) else young
            deck += ['*MATERIAL, NAME=Material' + region, '*ELASTIC', '%r, %r' % (stiffness, poisson),
                     '*SOLID SECTION, ELSET=Region%s, MATERIAL=Material%s' % (region, region)]
        deck += ['*BOUNDARY', *boundary, '*STEP', '*STATIC', *loads, '*NODE PRINT, NSET=All', 'U, RF']
        for region in regions:
            deck += ['*EL PRINT, ELSET=Region%s, TOTALS=ONLY' % region, 'ELSE']
        deck += ['*END STEP', '']
        with open(os.path.join(self.folder.name, 'deck.inp'), 'w') as file:
            file.write('\n'.join(deck))
        run = subprocess.run(['ccx', 'deck'], cwd=self.folder.name, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
        assert run.returncode == 0 and 'ERROR' not in run.stdout, run.stdout[-3000:]
        return Solution(os.path.join(self.folder.name, 'deck.dat'), run.stdout, len(self.points))


class Solution:
    """What CalculiX found, each number to seven digits: Displacements (n x 3), Forces (n x 3: of the
    elements on the nodes' supports and loads), Energy (of strain, of all regions), and the Words that
    it wrote on the way."""

    def __init__(self, path, words, count):
        self.Words, self.Energy = words, 0.0
        self.Displacements, self.Forces = (numpy.full((count, 3), numpy.nan) for _ in range(2))
        with open(path) as file:
            for line in file:
                values = line.split()
                if re.match(r'\s*[a-z]', line):
                    heading = line
                elif values and 'displacements' in heading:
                    self.Displacements[int(values[0]) - 1] = values[1:]
                elif values and 'forces' in heading:
                    self.Forces[int(values[0]) - 1] = values[1:]
                elif values and 'internal energy' in heading:
                    self.Energy += float(values[0])
